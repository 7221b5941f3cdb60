"""Read a FOON subgraph from text, in both dialects."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import chain, islice, takewhile

from foon_kg.loaders.notices import Journal, NoticeKind, Problem, ReadResult, Remark
from foon_kg.loaders.text_lines import (
    Line,
    MotionLine,
    ObjectLine,
    Place,
    SeenLine,
    Separator,
    SourceLine,
    StateLine,
    read_line,
)
from foon_kg.loaders.times import counts_hours, read_timing
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Sighting

_LINE_END = re.compile(r"\r\n|\r|\n")


def read_text(text: str, name: str, file: str = "") -> ReadResult:
    """Return the subgraph ``name`` that ``text`` says; notices call it ``file``, or by its name.

    A unit that cannot be read is left out and reported; every other unit is kept, in its order. Never raises.
    """
    return TextReader().read(text, name, file)


def lines_of(text: str) -> list[str]:
    """Return the lines of a ``text`` as all numbers of lines count them, from 1 on."""
    return _LINE_END.split(text)


def line_with(lines: Sequence[str], motion_at: int, word: str) -> int:
    """Return on which of the ``lines`` of the unit whose motion stands on line ``motion_at`` there is ``word``.

    It is that of the motion where none of them has the word as it is written, or the lines are of another format.
    """
    if not lines[motion_at - 1 : motion_at] or not lines[motion_at - 1].startswith("M"):
        return motion_at
    begin = next((at for at in range(motion_at - 1, -1, -1) if lines[at].startswith("//")), -1) + 1
    unit = takewhile(lambda line: not line.startswith("//"), islice(lines, begin, None))
    there = re.compile(rf"\b{re.escape(word)}\b", re.IGNORECASE)
    return next((number for number, line in enumerate(unit, begin + 1) if there.search(line)), motion_at)


class TextReader:
    """Reads one text after another. Equal nodes of all of them are one object, which saves room and time."""

    def __init__(self) -> None:
        self._lines: dict[str, Line] = {}
        self._nodes: dict[tuple[object, ...], tuple[ObjectNode, Remark | None]] = {}
        self._one_of_equals: dict[ObjectNode, ObjectNode] = {}

    def read(self, text: str, name: str, file: str = "") -> ReadResult:
        """Return the video ``name`` in a ``text``, as :func:`read_text` does; messages name the ``file``."""
        journal = Journal(file or name)
        known = self._lines
        lines = [known[line] if line in known else self._line(line) for line in lines_of(text)]
        hours = counts_hours(column for line in lines if isinstance(line, MotionLine) for column in line.time_columns)
        annotations: list[Annotation] = []
        at: list[int] = []
        for draft in _drafts(lines, journal):
            annotation = self._annotation(draft, journal, hours=hours)
            if annotation is not None:
                annotations.append(annotation)
                at.append(draft.motion_at)
        return journal.result(name, annotations, _sources(lines), at)

    def _line(self, text: str) -> Line:
        line = self._lines[text] = read_line(text)
        return line

    def _annotation(self, draft: _UnitDraft, journal: Journal, *, hours: bool) -> Annotation | None:
        """Return the unit that a draft makes, ``None`` (and a word in the journal) where it makes none."""
        for number, remark in draft.remarks:
            journal.remark(number, remark)
        problem = draft.problem or draft.missing()
        if problem is not None:
            journal.reject(*problem)
            return None
        timing, odd = read_timing(draft.motion.time_columns, hours=hours)
        for remark in odd:
            journal.remark(draft.motion_at, remark)
        unit = FunctionalUnit(
            tuple(self._participant(one, journal) for one in draft.inputs),
            draft.motion.motion,
            tuple(self._participant(one, journal) for one in draft.outputs),
            draft.motion.accepts_any,
        )
        return Annotation(unit, timing, seen_in=draft.seen_in)

    def _participant(self, draft: _ObjectDraft, journal: Journal) -> Participant:
        key = (draft.head.label, *draft.states)
        known = self._nodes.get(key)
        if known is None:
            node, remark = _node(draft.head.label, draft.states)
            known = self._nodes[key] = self._one_of_equals.setdefault(node, node), remark
        node, remark = known
        if remark:
            journal.remark(draft.last_line, remark)
        return Participant(node, draft.head.moving, draft.head.dish_type)


_NO_MOTION = Problem(NoticeKind.UNIT_WITHOUT_MOTION, "a unit without a motion")
_NO_INPUTS = Problem(NoticeKind.UNIT_WITHOUT_INPUTS, "a unit without inputs")
_NO_OUTPUTS = Problem(NoticeKind.UNIT_WITHOUT_OUTPUTS, "a unit without outputs")
_TWO_MOTIONS = Problem(NoticeKind.TWO_MOTIONS, "a second motion in one unit; is a // missing before it?")
_STRAY_STATE = Problem(NoticeKind.STRAY_STATE, "a state that follows no object")
_NONE_YET = MotionLine("", accepts_any=False, time_columns=())
_EMPTY_UNIT = Remark(NoticeKind.EMPTY_UNIT, "nothing between two separators", "left out")


@dataclass
class _ObjectDraft:
    """An object line with the state lines below it; ``last_line`` is the number of the last of them."""

    head: ObjectLine
    states: list[StateLine]
    last_line: int


@dataclass
class _UnitDraft:
    """The lines between two separators.

    ``motion_at`` is the line of the motion, 0 before there is one; ``problem`` is the first line that spoils the unit,
    and why; ``seen_in`` is where a step of a task tree was seen, ``None`` where nothing is said of that.
    """

    inputs: list[_ObjectDraft] = field(default_factory=list)
    motion: MotionLine = _NONE_YET
    motion_at: int = 0
    outputs: list[_ObjectDraft] = field(default_factory=list)
    remarks: list[tuple[int, Remark]] = field(default_factory=list)
    problem: tuple[int, Problem] | None = None
    last_line: int = 0
    seen_in: tuple[Sighting, ...] | None = None

    def take(self, number: int, line: ObjectLine | StateLine | MotionLine | Problem) -> None:
        objects = self.outputs if self.motion_at else self.inputs
        if isinstance(line, ObjectLine):
            self._begin(objects, number, line)
        elif isinstance(line, StateLine) and objects:
            objects[-1].states.append(line)
            objects[-1].last_line = number
            self.remarks += [(number, remark) for remark in line.remarks]
        elif isinstance(line, MotionLine) and not self.motion_at:
            self.motion, self.motion_at = line, number
        elif self.problem is None:
            self.problem = (number, _why_spoiled(line))

    def _begin(self, objects: list[_ObjectDraft], number: int, line: ObjectLine) -> None:
        """Begin another object of one side."""
        objects.append(_ObjectDraft(line, [], number))
        self.remarks += [(number, remark) for remark in line.remarks]
        if line.dish_type is not None and not self.motion_at:
            self.remarks.append((number, _class_on_input(line.dish_type)))

    def missing(self) -> tuple[int, Problem] | None:
        """Return what the unit lacks, at the line where it ends."""
        if not self.motion_at:
            return self.last_line, _NO_MOTION
        if not self.inputs:
            return self.last_line, _NO_INPUTS
        return None if self.outputs else (self.last_line, _NO_OUTPUTS)


def _class_on_input(dish_type: str) -> Remark:
    message = f"an input with the dish class {dish_type!r}"
    return Remark(NoticeKind.CLASS_ON_INPUT, message, "kept there, makes no goal")


def _why_spoiled(line: Line) -> Problem:
    """Return why a line does not fit where it stands, or what is wrong with itself."""
    if isinstance(line, Problem):
        return line
    return _STRAY_STATE if isinstance(line, StateLine) else _TWO_MOTIONS


def _sources(lines: list[Line]) -> list[str]:
    return [line.address for line in lines if isinstance(line, SourceLine) and line.address]


def _drafts(lines: list[Line], journal: Journal) -> list[_UnitDraft]:
    """Return the units of a file; what is odd about its separators goes into the journal."""
    drafts: list[_UnitDraft] = []
    draft: _UnitDraft | None = None
    seen_in: tuple[Sighting, ...] | None = None
    after_separator = False
    for number, line in enumerate(lines, 1):
        if isinstance(line, Separator):
            _end(draft, number, line, journal, after_separator=after_separator)
            draft, seen_in, after_separator = None, None, True
        elif isinstance(line, SeenLine):
            seen_in = (seen_in or ()) + line.seen_in
        elif line is not None and not isinstance(line, SourceLine):
            if draft is None:
                draft = _UnitDraft()
                drafts.append(draft)
            draft.take(number, line)
            draft.last_line, draft.seen_in = number, seen_in
    return drafts


def _end(draft: _UnitDraft | None, number: int, line: Separator, journal: Journal, *, after_separator: bool) -> None:
    """End a unit, if there is a ``draft`` of one, at the separator in the line with this ``number``."""
    for remark in line.remarks:
        journal.remark(number, remark)
    if draft is not None:
        draft.last_line = number
    elif after_separator:
        journal.remark(number, _EMPTY_UNIT)


def _node(label: str, lines: list[StateLine]) -> tuple[ObjectNode, Remark | None]:
    """Return the object node that an object's lines make, and what is odd about its places.

    Of several different places the last counts, as in the JSON that the FOON's authors made of these files;
    the others are kept as states.
    """
    places = [line.place for line in lines if line.place is not None]
    place = places[-1] if places else (None, None)
    others = [other for other in dict.fromkeys(places) if other != place]
    states = [line.state for line in lines if line.state is not None]
    ingredients = tuple(chain.from_iterable(line.ingredients for line in lines))
    remark = _several_places(label, [*others, place]) if others else None
    return ObjectNode(label, (*states, *map(place_as_state, others)), ingredients, *place), remark


def _several_places(label: str, places: list[Place]) -> Remark:
    message = f"{label!r} has several places: {', '.join(map(place_as_state, places))}"
    return Remark(NoticeKind.SEVERAL_PLACES, message, "the last is its place, the others are kept as states")


def place_as_state(place: Place) -> str:
    """Return the state that keeps a place beside another one: ``with [rind]``."""
    relation, container = place
    return f"{relation or ''} [{container or ''}]".lstrip()
