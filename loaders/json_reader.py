"""Read a FOON subgraph from JSON: the one that its authors publish, and foon-kg's own.

The authors' JSON is a list of units ``{"input_nodes", "motion_node", "output_nodes"}`` with nodes ``{"label", "states",
"ingredients", "container"}``. foon-kg writes ``{"sources": […], "units": […]}`` and adds what the other leaves out: a
node's ``relation``, ``moving`` and ``dish_type``, a unit's ``accepts_any`` and ``timing``, and where a task
tree's unit was ``seen_in``.
"""

from __future__ import annotations

import math
import re
from dataclasses import replace

from foon_kg.loaders.json_document import parse_document
from foon_kg.loaders.notices import Journal, NoticeKind, Problem, ReadResult, Remark, UnreadableFile
from foon_kg.loaders.text_lines import fold
from foon_kg.loaders.times import is_time
from foon_kg.model import (
    DISH_TYPES,
    UNMEASURED,
    Annotation,
    FunctionalUnit,
    Measures,
    ObjectNode,
    Participant,
    Sighting,
    Timing,
)
from foon_kg.model.errors import ReadError
from foon_kg.model.json_fields import Fields
from foon_kg.model.node_json import measures_from_json, sighting_from_json

_FILE_FIELDS = frozenset({"sources", "units"})
_UNIT_FIELDS = frozenset({"accepts_any", "input_nodes", "measures", "motion_node", "output_nodes", "seen_in", "timing"})
_NODE_FIELDS = frozenset({"container", "dish_type", "ingredients", "label", "moving", "relation", "states"})
_TIMING_FIELDS = frozenset({"assumed", "spans"})
_MEASURES = frozenset({"amounts", "seconds", "celsius"})
_UNPRINTABLE = re.compile("[\x00-\x1f\x7f-\x9f\ud800-\udfff]")


def read_json(text: str, name: str, file: str = "") -> ReadResult:
    """Return the subgraph ``name`` that a JSON ``text`` says; notices call it ``file``, or by its name.

    A unit that cannot be read is left out and reported; every other unit is kept, in its order. What is no JSON,
    or no list of units, is rejected as a whole. Never raises.
    """
    journal = Journal(file or name)
    try:
        document = parse_document(text)
        fields = Fields(document.fields, "the file")
        sources = [_name(text, "sources") for text in fields.texts("sources")] if "sources" in fields else []
    except UnreadableFile as unreadable:
        return journal.reject_file(unreadable.line, unreadable.problem)
    except ReadError as error:
        return journal.reject_file(None, _bad_field(error))
    _remark_unknown(fields, _FILE_FIELDS, None, journal)
    read = [_UnitReading(line, journal).annotation(value, place) for place, (line, value) in enumerate(document.units)]
    return journal.result(name, [annotation for annotation in read if annotation is not None], sources)


def _bad_field(error: ReadError) -> Problem:
    """Return the problem, in words that can be printed whatever the file holds."""
    message = error.message.encode("utf-8", "backslashreplace").decode()
    return Problem(NoticeKind.BAD_FIELD, message)


def _name(text: str, where: str) -> str:
    folded = fold(text)
    if not folded:
        raise ReadError(f"{where}: an empty name", hint="Give it a name, or leave the field out.")
    return _printable(folded, where)


def _printable(text: str, where: str) -> str:
    if _UNPRINTABLE.search(text):
        raise ReadError(f"{where}: {text!a} is no text that can be kept", hint="Remove its control characters.")
    return text


def _remark_unknown(fields: Fields, known: frozenset[str], line: int | None, journal: Journal) -> None:
    if unknown := [name for name in fields.names if name not in known]:
        names = ", ".join(ascii(name) for name in unknown)
        journal.remark(line, Remark(NoticeKind.UNKNOWN_FIELD, f"fields that a FOON does not have: {names}", "left out"))


class _UnitReading:
    """The reading of one unit that begins at ``line``."""

    def __init__(self, line: int, journal: Journal) -> None:
        self._line = line
        self._journal = journal

    def annotation(self, value: object, place: int) -> Annotation | None:
        where = f"units[{place}]"
        try:
            return self._annotation(value, where)
        except ReadError as error:
            self._journal.reject(self._line, _bad_field(error))
        except RecursionError:  # a value that was just shallow enough to be decoded is too deep to be shown
            self._journal.reject(self._line, Problem(NoticeKind.BAD_FIELD, f"{where}: nested too deeply"))
        return None

    def _annotation(self, value: object, where: str) -> Annotation | None:
        fields = Fields(value, where)
        _remark_unknown(fields, _UNIT_FIELDS, self._line, self._journal)
        motion = _name(fields.text("motion_node"), f"{fields.where}: motion_node")
        if "accepts_any" in fields:
            accepts_any = fields.truth("accepts_any")
        else:
            accepts_any = motion.endswith("*")
            motion = motion.removesuffix("*").rstrip()
        inputs = self._participants(fields, "input_nodes")
        outputs = self._participants(fields, "output_nodes")
        timing = self._timing(fields.nested("timing")) if "timing" in fields else Timing()
        problem = _missing(inputs, motion, outputs, fields.where)
        if problem is not None:
            self._journal.reject(self._line, problem)
            return None
        for one in inputs:
            if one.dish_type is not None:
                message = f"{fields.where}: an input with the dish type {one.dish_type!r}"
                self._remark(NoticeKind.CLASS_ON_INPUT, message, "kept there, makes no goal")
        unit = FunctionalUnit(inputs, motion, outputs, accepts_any)
        return Annotation(unit, timing, self._measures(fields), self._seen_in(fields))

    def _participants(self, fields: Fields, side: str) -> tuple[Participant, ...]:
        return tuple(self._participant(node) for node in fields.nested_list(side))

    def _participant(self, fields: Fields) -> Participant:
        _remark_unknown(fields, _NODE_FIELDS, self._line, self._journal)
        node = ObjectNode(
            _name(fields.text("label"), f"{fields.where}: label"),
            self._names(fields, "states"),
            self._names(fields, "ingredients"),
            self._optional_name(fields, "relation"),
            self._optional_name(fields, "container"),
        )
        moving = fields.truth("moving") if "moving" in fields else False
        has_dish_type = fields.optional_text("dish_type") is not None
        return Participant(node, moving, fields.one_of("dish_type", DISH_TYPES) if has_dish_type else None)

    def _names(self, fields: Fields, name: str) -> tuple[str, ...]:
        where = f"{fields.where}: {name}"
        folded = [fold(text) for text in fields.texts(name)]
        names = [_printable(text, where) for text in folded if text]
        if len(names) < len(folded):
            self._remark(NoticeKind.EMPTY_NAME, f"{where}: an empty name", "left out")
        if len(set(names)) < len(names):
            self._remark(NoticeKind.NAME_TWICE, f"{where}: a name more than once", "read once")
        return tuple(names)

    def _optional_name(self, fields: Fields, name: str) -> str | None:
        text = fields.optional_text(name)
        if text is None:
            return None
        folded = _printable(fold(text), f"{fields.where}: {name}")
        if not folded:
            self._remark(NoticeKind.EMPTY_PLACE, f"{fields.where}: an empty {name}", "read as none")
        return folded or None

    def _measures(self, fields: Fields) -> Measures:
        if "measures" not in fields:
            return UNMEASURED
        _remark_unknown(fields.nested("measures"), _MEASURES, self._line, self._journal)
        measures = measures_from_json(fields)
        amounts = tuple(_printable(fold(amount), f"{fields.where}: amounts") for amount in measures.amounts)
        odd = [name for name in ("seconds", "celsius") if not math.isfinite(getattr(measures, name) or 0)]
        if odd or not all(amounts) or (measures.seconds or 0) < 0:
            raise ReadError(f"{fields.where}: measures that are none", hint='Write {"seconds": 3600, "celsius": 165}.')
        return replace(measures, amounts=amounts)

    def _seen_in(self, fields: Fields) -> tuple[Sighting, ...] | None:
        if "seen_in" not in fields:
            return None
        seen_in = tuple(map(sighting_from_json, fields.nested_list("seen_in")))
        for seen in seen_in:
            _printable(seen.video + (seen.source or ""), f"{fields.where}: seen_in")
        return seen_in

    def _timing(self, fields: Fields) -> Timing:
        _remark_unknown(fields, _TIMING_FIELDS, self._line, self._journal)
        spans = tuple(self._span(span, fields.where) for span in fields.items("spans"))
        return Timing(spans, fields.truth("assumed"))

    def _span(self, span: object, where: str) -> tuple[float, float]:
        start, end = span if isinstance(span, list) and len(span) == 2 else (None, None)  # noqa: PLR2004  # both ends
        if not (is_time(start) and is_time(end)):
            raise ReadError(f"{where}: a span is no pair of seconds", hint="Write [70.0, 71.5].")
        if end < start:
            self._remark(NoticeKind.ODD_TIME, f"{where}: {start}-{end} ends before it starts", "kept as written")
        return float(start), float(end)

    def _remark(self, kind: NoticeKind, message: str, action: str) -> None:
        self._journal.remark(self._line, Remark(kind, message, action))


def _missing(
    inputs: tuple[Participant, ...], motion: str, outputs: tuple[Participant, ...], where: str
) -> Problem | None:
    if not motion:
        return Problem(NoticeKind.UNIT_WITHOUT_MOTION, f"{where}: a unit without a motion")
    if not inputs:
        return Problem(NoticeKind.UNIT_WITHOUT_INPUTS, f"{where}: a unit without inputs")
    return None if outputs else Problem(NoticeKind.UNIT_WITHOUT_OUTPUTS, f"{where}: a unit without outputs")
