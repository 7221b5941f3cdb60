"""Read a FOON subgraph from text, in both dialects: plain lines, and lines with ids (``O278``, ``S41``, ``M92``)."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from foon_kg.loaders.notices import Notice, NoticeKind, ReadResult, Severity
from foon_kg.loaders.text_lines import BadLine, ObjectLine, Remark, StateLine, fold, read_object_line, read_state_line
from foon_kg.loaders.times import counts_hours, read_timing
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Subgraph

_LINE_END = re.compile(r"\r\n|\r|\n")
_LINE = re.compile(r"([OSM])[0-9]*\t(.*)", re.DOTALL)
_SOURCE = re.compile(r"#\s*source:\s*(.*)", re.IGNORECASE)


@dataclass
class _ObjectDraft:
    line: int
    head: ObjectLine
    states: list[tuple[int, StateLine]] = field(default_factory=list)


@dataclass
class _UnitDraft:
    """The lines of one unit while they are read; ``fatal`` is the first reason why it cannot be one."""

    inputs: list[_ObjectDraft] = field(default_factory=list)
    outputs: list[_ObjectDraft] = field(default_factory=list)
    motion: list[str] | None = None
    motion_line: int = 0
    fatal: tuple[int, BadLine] | None = None

    @property
    def is_empty(self) -> bool:
        return not (self.inputs or self.outputs or self.motion is not None or self.fatal)


class TextReader:
    """Reads one text after another; equal nodes of all of them are one object, which saves room and time."""

    def __init__(self) -> None:
        self._nodes: dict[ObjectNode, ObjectNode] = {}
        self._state_lines: dict[str, StateLine] = {}

    def read(self, text: str, name: str, file: str) -> ReadResult:
        """Answer the subgraph ``name`` that ``text`` says; ``file`` is how notices call it.

        A unit that cannot be read is left out and reported; every other unit is kept, in order.
        """
        return _TextReading(name, file, self._nodes, self._state_lines).result(text)


class _TextReading:
    def __init__(
        self, name: str, file: str, nodes: dict[ObjectNode, ObjectNode], state_lines: dict[str, StateLine]
    ) -> None:
        self._name = name
        self._file = file
        self._nodes = nodes
        self._state_lines = state_lines
        self._notices: list[Notice] = []
        self._sources: list[str] = []
        self._annotations: list[Annotation] = []
        self._hours = False

    def result(self, text: str) -> ReadResult:
        lines = _LINE_END.split(text)
        self._hours = counts_hours(line.partition("\t")[2] for line in lines if line.startswith("M"))
        draft = _UnitDraft()
        separators = 0
        for number, line in enumerate(lines, 1):
            if line.startswith("//"):
                self._separator(line, number)
                self._close(draft, number, after_separator=separators > 0)
                separators += 1
                draft = _UnitDraft()
            else:
                self._take(draft, line, number)
        if not draft.is_empty:
            self._close(draft, len(lines) - (lines[-1] == ""), after_separator=True)
        return self._answer()

    def _answer(self) -> ReadResult:
        notices = tuple(sorted(self._notices, key=lambda notice: notice.line or 0))
        if not self._annotations:
            if not any(notice.severity is Severity.REJECTED for notice in notices):
                nothing = Notice(
                    self._file,
                    None,
                    NoticeKind.NO_UNITS,
                    "no functional unit in it",
                    "file rejected",
                    Severity.REJECTED,
                )
                notices = (nothing, *notices)
            return ReadResult(self._file, None, notices)
        subgraph = Subgraph(self._name, tuple(self._annotations), tuple(self._sources))
        return ReadResult(self._file, subgraph, notices)

    def _separator(self, line: str, number: int) -> None:
        if line.rstrip() != "//":
            self._say(number, Remark(NoticeKind.EXTRA_COLUMN, f"text beside a separator: {fold(line)!r}", "left out"))

    def _take(self, draft: _UnitDraft, line: str, number: int) -> None:
        match = _LINE.fullmatch(line)
        if match is None:
            self._take_other(draft, line, number)
            return
        columns = match[2].split("\t")
        try:
            if match[1] == "S":
                self._take_state(draft, match[2], columns, number)
            elif match[1] == "O":
                head = read_object_line(columns)
                (draft.inputs if draft.motion is None else draft.outputs).append(_ObjectDraft(number, head))
            elif draft.motion is not None:
                raise BadLine(NoticeKind.TWO_MOTIONS, "a second motion in one unit (is a // missing?)")  # noqa: TRY301  # one place turns a bad line into a rejected unit
            else:
                draft.motion, draft.motion_line = columns, number
        except BadLine as problem:
            draft.fatal = draft.fatal or (number, problem)

    def _take_other(self, draft: _UnitDraft, line: str, number: int) -> None:
        if source := _SOURCE.fullmatch(line):
            self._sources += [fold(source[1])] if source[1].strip() else []
        elif line.strip() and not line.startswith("#") and draft.fatal is None:
            shown = line if len(line) < 60 else line[:57] + "..."  # noqa: PLR2004  # enough to find it by
            message = f"{shown!r} is no line of a FOON (columns are separated by tabs)"
            draft.fatal = (number, BadLine(NoticeKind.UNKNOWN_LINE, message))

    def _take_state(self, draft: _UnitDraft, text: str, columns: list[str], number: int) -> None:
        objects = draft.inputs if draft.motion is None else draft.outputs
        if not objects:
            raise BadLine(NoticeKind.STRAY_STATE, "a state before the first object")
        known = self._state_lines.get(text)
        if known is None:
            known = self._state_lines[text] = read_state_line(columns)
        objects[-1].states.append((number, known))

    def _close(self, draft: _UnitDraft, number: int, *, after_separator: bool) -> None:
        """End a unit at line ``number``: keep it, or say why not."""
        if draft.is_empty:
            if after_separator:
                self._say(number, Remark(NoticeKind.EMPTY_UNIT, "nothing between two separators", "left out"))
            return
        inputs = tuple(self._participant(one) for one in draft.inputs)
        outputs = tuple(self._participant(one) for one in draft.outputs)
        for one, participant in zip(draft.inputs, inputs, strict=True):
            if participant.dish_type is not None:
                message = f"an input with the dish class {participant.dish_type}"
                self._say(one.line, Remark(NoticeKind.CLASS_ON_INPUT, message, "kept there, makes no goal"))
        motion = fold(draft.motion[0]) if draft.motion else ""
        line, problem = draft.fatal or (number, _missing(draft, motion))
        if problem is not None:
            line = line if draft.fatal or problem.kind is not NoticeKind.MISSING_NAME else draft.motion_line
            self._notices.append(
                Notice(self._file, line, problem.kind, problem.message, "unit rejected", Severity.REJECTED)
            )
            return
        timing, odd = read_timing((draft.motion or [])[1:], hours=self._hours)
        for words in odd:
            self._say(
                draft.motion_line, Remark(NoticeKind.ODD_TIME, f"odd time: {words}", "kept as far as it is clear")
            )
        unit = FunctionalUnit(inputs, motion.removesuffix("*").rstrip(), outputs, accepts_any=motion.endswith("*"))
        self._annotations.append(Annotation(unit, timing))

    def _participant(self, draft: _ObjectDraft) -> Participant:
        head = draft.head
        for remark in head.remarks:
            self._say(draft.line, remark)
        for number, line in draft.states:
            for remark in line.remarks:
                self._say(number, remark)
        node = self._node(draft)
        return Participant(self._nodes.setdefault(node, node), head.moving, head.dish_type)

    def _node(self, draft: _ObjectDraft) -> ObjectNode:
        lines = [line for _, line in draft.states]
        places = [(number, line.place) for number, line in draft.states if line.place is not None]
        relation, container = places[-1][1] if places else (None, None)
        earlier = [(number, place) for number, place in places if place != (relation, container)]
        states = [line.state for line in lines if line.state is not None]
        for _, place in earlier:
            states.append(place_as_state(*place))
        if earlier:
            words = " and ".join(place_as_state(*place) for _, place in [*earlier, places[-1]])
            action = "the last is the place, the others are kept as states"
            self._say(places[-1][0], Remark(NoticeKind.SEVERAL_PLACES, f"{draft.head.label} is {words}", action))
        ingredients = (name for line in lines for name in line.ingredients)
        return ObjectNode(draft.head.label, tuple(states), tuple(ingredients), relation, container)

    def _say(self, line: int, remark: Remark) -> None:
        self._notices.append(Notice(self._file, line, remark.kind, remark.message, remark.action))


def place_as_state(relation: str | None, container: str | None) -> str:
    """Answer the state that keeps a place beside another one: ``with [rind]``."""
    return f"{relation or ''} [{container or ''}]".lstrip()


def _missing(draft: _UnitDraft, motion: str) -> BadLine | None:
    if draft.motion is None:
        return BadLine(NoticeKind.UNIT_WITHOUT_MOTION, "a unit without a motion")
    if not motion.removesuffix("*").strip():
        return BadLine(NoticeKind.MISSING_NAME, "a motion without a name")
    if not draft.inputs:
        return BadLine(NoticeKind.UNIT_WITHOUT_INPUTS, "a unit without inputs")
    if not draft.outputs:
        return BadLine(NoticeKind.UNIT_WITHOUT_OUTPUTS, "a unit without outputs")
    return None
