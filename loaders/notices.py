"""What a reader says about a file that is not quite a FOON: where, what is wrong, and what was done about it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

from foon_kg.model import Annotation, Subgraph


class Severity(StrEnum):
    """Whether a unit is missing from what was read.

    ``REJECTED``: a unit or the whole file was left out; there is exactly one such notice for each.
    ``ASSUMED``: the unit was read; the notice says what an unclear place was taken to mean.
    """

    REJECTED = "rejected"
    ASSUMED = "assumed"


class NoticeKind(StrEnum):
    """The stable words by which programs tell notices apart. The comment says what the file has."""

    UNREADABLE_FILE = "unreadable-file"  # no text, no UTF-8, no JSON, not to be opened
    NO_UNITS = "no-units"  # not one unit could be read
    SAME_VIDEO = "same-video"  # a second file of the same video
    BYTE_ORDER_MARK = "byte-order-mark"  # an invisible mark before the first character

    UNIT_WITHOUT_INPUTS = "unit-without-inputs"
    UNIT_WITHOUT_MOTION = "unit-without-motion"
    UNIT_WITHOUT_OUTPUTS = "unit-without-outputs"
    TWO_MOTIONS = "two-motions"  # the separator between two units is missing
    EMPTY_UNIT = "empty-unit"  # two separators with nothing between them
    STRAY_STATE = "stray-state"  # a state before the first object
    UNKNOWN_LINE = "unknown-line"  # neither O, S, M, comment nor separator
    MISSING_NAME = "missing-name"  # an object or a motion without its name

    MISSING_TAB = "missing-tab"  # under [cooking pan]
    EMPTY_STATE_COLUMN = "empty-state-column"  # a state with an empty third column
    EXTRA_COLUMN = "extra-column"  # more columns than the line may have
    BAD_BRACKETS = "bad-brackets"  # the third column is neither [place] nor {names}

    ODD_FLAG = "odd-flag"  # neither 0 nor 1
    ODD_CLASS = "odd-class"  # no number from 0 to 29
    CLASS_ON_INPUT = "class-on-input"  # only what a unit makes can be the goal

    NAME_TWICE = "name-twice"  # {salt,pepper,salt}
    EMPTY_NAME = "empty-name"  # {salt,,pepper}
    EMPTY_PLACE = "empty-place"  # on []
    EMPTY_STATE = "empty-state"  # a state line that says nothing
    SEVERAL_PLACES = "several-places"  # two different [places] on one object
    CONTAINS_PLACE = "contains-place"  # contains [bowl]
    CONTAIN = "contain"  # contain {butter}
    RELATION_WITH_BRACES = "relation-with-braces"  # in {packet}
    STATE_WITH_BRACES = "state-with-braces"  # greased {butter}
    ODD_TIME = "odd-time"  # a time in none of the known forms, or one that cannot be true

    UNKNOWN_FIELD = "unknown-field"  # JSON: a field that no node or unit has
    BAD_FIELD = "bad-field"  # JSON: a field that is missing or of the wrong type

    ODD_NAME = "odd-name"  # a video whose name no file can have
    NO_NARRATION = "no-narration"  # nobody says what is done
    LONG_CELL = "long-cell"  # a table: more in one cell than anybody says

    SAME_RECIPE = "same-recipe"  # a second recipe with the id of another
    TOO_MANY_INGREDIENTS = "too-many-ingredients"  # more than any cook uses
    NO_INGREDIENTS = "no-ingredients"  # a recipe that asks for nothing
    TITLE_WITHOUT_WORDS = "title-without-words"  # nothing in it tells what the dish is
    UNKNOWN_FOOD = "unknown-food"  # a name that the table of foods does not have
    UNKNOWN_UTENSIL = "unknown-utensil"  # a name that looks like a utensil and is in no table
    UNKNOWN_STATE = "unknown-state"  # a state that the tables of states do not have
    UNKNOWN_MOTION = "unknown-motion"  # a motion that the table of motions does not have

    NOT_PLAYED = "not-played"  # what nobody could do so in a kitchen, or would not serve
    LISTS_DIFFER = "lists-differ"  # two files of one collection list another number of ingredients


@dataclass(frozen=True)
class Notice:
    """One thing that is wrong with a file. ``line`` counts from 1; it is ``None`` where the whole file is meant."""

    file: str
    line: int | None
    kind: NoticeKind
    message: str
    action: str
    severity: Severity = Severity.ASSUMED

    def to_json(self) -> dict[str, object]:
        """Return the notice as one object of a JSON Lines report."""
        return {
            "file": self.file,
            "line": self.line,
            "severity": str(self.severity),
            "kind": str(self.kind),
            "message": self.message,
            "action": self.action,
        }

    def __str__(self) -> str:
        place = self.file if self.line is None else f"{self.file}:{self.line}"
        return f"{place}: {self.message}: {self.action}"


@dataclass(frozen=True)
class ReadResult:
    """What one file gave: its subgraph, or ``None`` where nothing of it could be used, and everything odd about it.

    ``lines`` says for each unit of the subgraph on which line its motion stands; empty where the format has no lines.
    """

    path: str
    subgraph: Subgraph | None
    notices: tuple[Notice, ...] = ()
    lines: tuple[int, ...] = ()

    @property
    def rejected(self) -> int:
        """How many units were left out; an unusable file counts as one."""
        return sum(notice.severity is Severity.REJECTED for notice in self.notices)


class UnreadableFile(Exception):  # noqa: N818  # a signal between the readers; who reads a path never sees it
    """A file cannot be used at all; ``line`` is where that shows, if anywhere."""

    def __init__(self, message: str, line: int | None = None) -> None:
        super().__init__(message)
        self.problem = Problem(NoticeKind.UNREADABLE_FILE, message)
        self.line = line


@dataclass(frozen=True)
class Remark:
    """Something odd about a line or a field, and what it was taken to mean."""

    kind: NoticeKind
    message: str
    action: str


@dataclass(frozen=True)
class Problem:
    """Why a line or a field cannot be understood, and with it its unit."""

    kind: NoticeKind
    message: str


class Journal:
    """The notices of one file while it is read."""

    def __init__(self, file: str) -> None:
        self._file = file
        self._notices: list[Notice] = []

    def remark(self, line: int | None, remark: Remark) -> None:
        """Note a ``remark`` on what is odd in a ``line`` (from 1; ``None``: the whole file); it was read."""
        self._notices.append(Notice(self._file, line, remark.kind, remark.message, remark.action))

    def reject(self, line: int | None, problem: Problem) -> None:
        """Note that a unit is left out for a ``problem`` in a ``line`` (from 1; ``None`` for the whole file)."""
        self._add_rejected(line, problem, "unit rejected")

    def reject_file(self, line: int | None, problem: Problem) -> ReadResult:
        """Return the result of a file that cannot be used at all, for a ``problem`` in a ``line`` (from 1)."""
        self._add_rejected(line, problem, "file rejected")
        return self._ended(None)

    def reject_unread(self, error: UnreadableFile | OSError) -> ReadResult:
        """Return the result of a file that raised ``error``: it cannot be opened, or has not what it should have."""
        if isinstance(error, UnreadableFile):
            return self.reject_file(error.line, error.problem)
        return self.reject_file(None, Problem(NoticeKind.UNREADABLE_FILE, f"cannot be opened: {error.strerror}"))

    def result(
        self, name: str, annotations: Sequence[Annotation], sources: Sequence[str], lines: Sequence[int] = ()
    ) -> ReadResult:
        """Return what was read of the video ``name``. A file without any unit is rejected: it is hardly a FOON.

        ``annotations`` are in the file's order, ``lines`` where each begins; ``sources`` are addresses of the video.
        """
        if annotations:
            return self._ended(Subgraph(name, tuple(annotations), tuple(sources)), lines)
        if any(notice.severity is Severity.REJECTED for notice in self._notices):
            return self._ended(None)
        return self.reject_file(None, Problem(NoticeKind.NO_UNITS, "no functional unit in it"))

    def notices(self) -> tuple[Notice, ...]:
        """Return everything noted so far, by line."""
        return tuple(sorted(self._notices, key=lambda notice: notice.line or 0))

    def _ended(self, subgraph: Subgraph | None, lines: Sequence[int] = ()) -> ReadResult:
        return ReadResult(self._file, subgraph, self.notices(), tuple(lines))

    def _add_rejected(self, line: int | None, problem: Problem, action: str) -> None:
        self._notices.append(Notice(self._file, line, problem.kind, problem.message, action, Severity.REJECTED))
