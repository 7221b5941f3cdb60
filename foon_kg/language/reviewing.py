"""A draft as a person reviews it: the few decisions that matter, and what becomes of the table with each of them.

The table itself is all there is to keep: a decision is written into its rows (column ``reviewed``), so that a review
that was left is gone on with from the file. The terminal and the page ask the same questions from here.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, Self

from foon_kg.food.unknown import unknown_words
from foon_kg.language.drafting.review import missing
from foon_kg.loaders.csv_table import columns_of, table_rows
from foon_kg.loaders.draft_tables import BETWEEN_DOUBTS, UNIT_COLUMNS
from foon_kg.loaders.notices import Notice, ReadResult, Severity, UnreadableFile
from foon_kg.loaders.video_tables import is_video_table, read_video_text
from foon_kg.model import Annotation, FunctionalUnit, Subgraph
from foon_kg.model.drafts import SURE, DraftFile, DraftRow
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.plans.kitchen import Kitchen

REVIEWED = "reviewed"
YES = "yes"
MOST_ROWS = 5_000
_PLAYERS = ("youtube.com/watch", "youtu.be/")
"""Pages of videos that take the second as a parameter; others take it as a fragment, as HTML has it."""

Kind = Literal["doubt", "no unit", "from nowhere", "unknown"]
Cells = Mapping[str, str]


@dataclass(frozen=True)
class Reason:
    """Why a row is asked about, in words."""

    kind: Kind
    text: str


@dataclass(frozen=True)
class Decision:
    """One row that a person should look at: where it stands, what was said, the unit made of it, and why it is asked.

    ``place`` counts the rows from 0. ``unit`` is ``None`` where the row is none (yet). ``start`` is the second of the
    video.
    """

    place: int
    cells: Cells
    unit: FunctionalUnit | None
    confidence: float
    reasons: tuple[Reason, ...]
    start: float | None = None

    @property
    def said(self) -> str:
        """What the narration says here, ``""`` where it is not known."""
        return self.cells.get("said", "")

    @property
    def is_reviewed(self) -> bool:
        """Whether a person has decided on it."""
        return self.cells.get(REVIEWED) == YES

    @property
    def at(self) -> str:
        """The address of the video at that second; ``""`` where the source is none, or nobody wrote a time down."""
        source = self.cells.get("source", "")
        if self.start is None or not source.startswith(("https://", "http://")):
            return ""
        if any(name in source for name in _PLAYERS):
            return f"{source}{'&' if '?' in source else '?'}t={int(self.start)}"
        return f"{source}#t={self.start:g}"

    @property
    def moment(self) -> str:
        """When it happens in the video, as in "0:12 to 0:31"; ``""`` where nobody wrote a time down."""
        start, end = (self.cells.get(name, "") for name in ("start", "end"))
        return f"{start} to {end}" if start and end else start if start != "Assumed" else ""


@dataclass(frozen=True)
class Review:
    """A table of units under review: its ``columns`` and ``rows``. Every decision gives another one."""

    name: str
    columns: tuple[str, ...]
    rows: tuple[Cells, ...]

    @classmethod
    def of(cls, text: str, name: str, where: str = "") -> Self:
        """Return the review of a draft, or of the plain table of the video ``name``.

        Raises ReadError, which says that it is ``where``, if ``text`` is neither.
        """
        where = where or name
        if not is_video_table(text):
            hint = "foon draft videos, foon draft text and foon draft recipes make drafts."
            raise ReadError(f"{where}:1: no table of units: it lacks columns", hint=f"It has motion, inputs, …: {hint}")
        rows = _rows_of_one_video(text, where)
        columns = tuple(dict.fromkeys((*filter(None, columns_of(text)), *UNIT_COLUMNS, REVIEWED)))
        return cls(name, columns, tuple({one: " ".join(row.get(one, "").split()) for one in columns} for row in rows))

    @property
    def decisions(self) -> tuple[Decision, ...]:
        """What a person should decide, in the order of the rows."""
        return tuple(one for one in self.all_rows if one.reasons)

    @cached_property
    def all_rows(self) -> tuple[Decision, ...]:
        """Every row in its order; one that nobody needs to look at, or that somebody did, has no reasons."""
        return tuple(self._looked_at())

    @property
    def units(self) -> int:
        """How many rows are units."""
        return sum(unit is not None for unit in self._units)

    def accepted(self, place: int) -> Review:
        """Return the review with the row at ``place`` (from 0) accepted as it stands.

        What is no unit is left out for good.

        Raises :class:`~foon_kg.model.errors.UsageError` where there is no such row.
        """
        self._check(place)
        if self._units[place] is None:
            return self.dropped(place)
        return self._with(place, {**self.rows[place], "doubt": "", REVIEWED: YES})

    def edited(self, place: int, cells: Mapping[str, str]) -> Review:
        """Return the review with other ``cells`` in the row at ``place`` (from 0): a person wrote it, and is sure.

        Raises :class:`~foon_kg.model.errors.UsageError` where that is no unit, with what is wrong with it.
        """
        self._check(place)
        if unknown := sorted(set(cells) - set(UNIT_COLUMNS)):
            raise UsageError(f"a unit has no {', '.join(unknown)}", hint=f"It has {', '.join(UNIT_COLUMNS)}.")
        plain = {name: " ".join(text.split()) for name, text in cells.items()}
        changed = self._with(place, {**self.rows[place], **plain, "doubt": "", "confidence": "", REVIEWED: YES})
        faults = [notice for notice in changed.read.notices if notice.line == place + 2]
        if faults:
            raise UsageError(faults[0].message, hint="A thing: onion (chopped; peeled) {salt} on cutting board")
        return changed

    def dropped(self, place: int) -> Review:
        """Return the review without the row at ``place`` (from 0)."""
        self._check(place)
        return type(self)(self.name, self.columns, (*self.rows[:place], *self.rows[place + 1 :]))

    def text(self) -> str:
        """Return the table."""
        stream = io.StringIO()
        writer = csv.DictWriter(stream, self.columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(self.rows)
        return stream.getvalue()

    def subgraph(self) -> Subgraph:
        """Return the units as a subgraph; raises :class:`~foon_kg.model.errors.UsageError` where there is none."""
        annotations = tuple(one for one in self._units if one is not None)
        if not annotations:
            raise UsageError(f"{self.name} has no unit", hint="Fill in a row: a motion, inputs and outputs.")
        source = next((row["source"] for row in self.rows if row.get("source")), "")
        return Subgraph(self.name, annotations, (source,) if source else ())

    def _check(self, place: int) -> None:
        if not 0 <= place < len(self.rows):
            raise UsageError(f"there is no row {place}", hint=f"The draft has {len(self.rows)}, counted from 0.")

    def _with(self, place: int, cells: Cells) -> Review:
        kept = {name: cells.get(name, "") for name in self.columns}  # the plain table of a video has no doubts to empty
        rows = (*self.rows[:place], kept, *self.rows[place + 1 :])
        return type(self)(self.name, self.columns, rows)

    @cached_property
    def read(self) -> ReadResult:
        """The table as it is read: rows are lines from 2 on, whatever stands in their cells."""
        return read_video_text(self.text(), self.name)[0]

    @cached_property
    def _units(self) -> tuple[Annotation | None, ...]:
        rejected = {one.line for one in self.read.notices if one.severity is Severity.REJECTED}
        annotations = iter(self.read.subgraph.annotations if self.read.subgraph else ())
        return tuple(None if place + 2 in rejected else next(annotations, None) for place in range(len(self.rows)))

    def _looked_at(self) -> Iterator[Decision]:
        drafted = tuple(self._drafted())
        gaps = missing(DraftFile(self.name, drafted, None, ()), Kitchen.default())
        told: set[tuple[str, str]] = set()
        for place, row in enumerate(drafted):
            reasons = [
                *_own(row, self.read.notices),
                *(Reason("from nowhere", f"{one.node}: {one.why}") for one in gaps if one.line == row.line),
                *_unknown(row, told),
            ]
            open_still = reasons if self.rows[place].get(REVIEWED) != YES else ()
            unit, start = (row.annotation.unit, row.annotation.timing.start) if row.annotation else (None, None)
            yield Decision(place, self.rows[place], unit, row.confidence, tuple(open_still), start)

    def _drafted(self) -> Iterator[DraftRow]:
        for place, (cells, annotation) in enumerate(zip(self.rows, self._units, strict=True)):
            doubts = tuple(filter(None, map(str.strip, cells.get("doubt", "").split(BETWEEN_DOUBTS.strip()))))
            yield DraftRow(place + 2, annotation, _sure(cells.get("confidence", "")), doubts, cells.get("said", ""))


def _sure(text: str) -> float:
    """Return a confidence; an empty or odd one is that of a row which a person wrote."""
    try:
        return min(max(float(text), 0.0), 1.0)
    except ValueError:
        return 1.0


def _rows_of_one_video(text: str, where: str) -> tuple[Cells, ...]:
    """Return the cells of a table, row by row; raises ReadError where they are too many, or of several videos."""
    try:
        rows = tuple(row.cells for row in table_rows(text))
    except UnreadableFile as broken:
        raise ReadError(f"{where}:{broken.line or 1}: {broken.problem.message}", hint="Mend the table.") from None
    if len(rows) > MOST_ROWS:
        raise ReadError(f"{where}: it has {len(rows)} rows", hint=f"{MOST_ROWS} are the most: split the table.")
    if len({row["video"] for row in rows if row.get("video")}) > 1:
        raise ReadError(f"{where}: it has several videos", hint="Review one at a time: split the table.")
    return rows


def _own(row: DraftRow, notices: Sequence[Notice]) -> Iterable[Reason]:
    """Return why a row is doubtful by itself; one that surely is no unit changes nothing, or a later unit has it."""
    if row.annotation is None and not row.doubts:
        told = [notice.message for notice in notices if notice.line == row.line]
        return [Reason("no unit", text) for text in told or ["it is no unit"]]
    kind: Kind = "no unit" if row.annotation is None else "doubt"
    return [Reason(kind, text) for text in row.doubts] if row.confidence < SURE else []


def _unknown(row: DraftRow, told: set[tuple[str, str]]) -> Iterator[Reason]:
    """Yield the words that no table has, each where it comes first."""
    if row.annotation is None:
        return
    unit = row.annotation.unit
    for word in unknown_words((*unit.input_nodes, *unit.output_nodes), [unit.motion]):
        if not word.nearly and (word.kind, word.word) not in told:
            told.add((word.kind, word.word))
            yield Reason("unknown", str(word))
