"""Frames as the graph keeps them: nodes to ask for in Cypher, a text that gives back the very frame, and counts."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import fields
from typing import Any

from foon_kg.food import tables
from foon_kg.integration.joining.layouts import Layout
from foon_kg.integration.joining.outlines import Outline
from foon_kg.integration.joining.spots import StageType, spots_of
from foon_kg.integration.teaching.frames import Frame, Line, Slot, Stage
from foon_kg.model import ObjectNode
from foon_kg.model.json_text import compact_json
from foon_kg.store.graph.lifting import KIND

_KEPT: dict[str, type] = {kind.__name__: kind for kind in (Frame, Line, ObjectNode, Slot, Stage)}
_FIELDS = {kind: [field.name for field in fields(kind)] for kind in (Frame, Line, ObjectNode, Slot, Stage)}
_SET = "set"


def text_of(frame: Frame) -> str:
    """Return a text from which :func:`frame_of` makes the same frame."""
    return compact_json(_plain(frame))


def frame_of(text: str) -> Frame:
    """Return the frame of the ``text`` that :func:`text_of` wrote; raises TypeError for that of anything else."""
    frame = _value(json.loads(text))
    if not isinstance(frame, Frame):
        raise TypeError("the text is not that of a frame")
    return frame


def _plain(value: object) -> object:
    """Return a value as JSON has it: of a dataclass its name and fields, of a set its sorted members."""
    if isinstance(value, tuple):
        return [_plain(member) for member in value]
    if isinstance(value, frozenset):
        return {_SET: sorted(value)}
    kind = type(value)
    return {kind.__name__: [_plain(getattr(value, name)) for name in _FIELDS[kind]]} if kind in _FIELDS else value


def _value(plain: Any) -> Any:  # noqa: ANN401 - any value that JSON has, and any that a frame has
    if isinstance(plain, list):
        return tuple(map(_value, plain))
    if isinstance(plain, dict):
        ((name, values),) = plain.items()
        return frozenset(values) if name == _SET else _KEPT[name](*map(_value, values))
    return plain


def outline_text(outline: Outline) -> str:
    """Return a text from which :func:`outline_of` makes the same outline.

    It is no JSON: a FOON has as many outlines as ways to its dishes, and texts are split in half the time. Names have
    neither bars nor commas.
    """
    names = (sorted(outline.foods), sorted(outline.kinds), outline.ends)
    return "|".join((outline.key, outline.dish_type, outline.label, *map(",".join, names)))


def outline_of(text: str) -> Outline:
    """Return the outline of the ``text`` that :func:`outline_text` wrote; raises ValueError for any other."""
    key, dish_type, label, foods, kinds, ends = text.split("|")
    done, group = ends.split(",")
    return Outline(key, dish_type, label, _names(foods), _names(kinds), (done, group))


def _names(text: str) -> frozenset[str]:
    return frozenset(text.split(",")) if text else frozenset()


def frame_row(frame: Frame) -> dict[str, Any]:
    """Return a frame as ``cypher/load_frames.cypher`` takes it: stages by number, and what hangs on which."""
    outline = Outline.of(Layout.of(frame, tables()), tables())
    flat = _Flat()
    main = flat.add(frame.line)
    return {
        "key": frame.key,
        "goal": frame.goal.key,
        "video": frame.video,
        "properties": {
            "dish_type": frame.dish_type,
            "label": frame.goal.label,
            "foods": sorted(outline.foods),
            "kinds": sorted(outline.kinds),
            "weak": list(frame.weak),
            "outline": outline_text(outline),
            "text": text_of(frame),
        },
        "stages": flat.stages,
        "main": main,
        "lines": flat.lines,
        "slots": flat.slots,
    }


class _Flat:
    """The stages, slots and joining lines of a frame in lists."""

    def __init__(self) -> None:
        self.stages: list[dict[str, Any]] = []
        self.lines: list[dict[str, Any]] = []
        self.slots: list[dict[str, Any]] = []

    def add(self, line: Line) -> list[int]:
        """Add a line, and return the numbers of its stages."""
        return [self._add_stage(stage) for stage in line.stages]

    def _add_stage(self, stage: Stage) -> int:
        number = len(self.stages)
        self.stages.append(_properties(stage, but="adds"))
        for place, add in enumerate(stage.adds):
            if isinstance(add, Line):
                self.lines.append({"stage": number, "place": place, "stages": self.add(add)})
            else:
                self.slots.append({"stage": number, "place": place, "properties": _properties(add)})
        return number


def _properties(part: Stage | Slot, but: str = "") -> dict[str, Any]:
    values = {name: getattr(part, name) for name in _FIELDS[type(part)] if name != but}
    return {name: sorted(value) if isinstance(value, frozenset) else value for name, value in values.items()}


def slot_foods(frames: Iterable[Frame]) -> set[str]:
    """Return the foods that join somewhere in ``frames``."""
    return {slot.food for frame in frames for slot in frame.line.all_slots()}


class Joins:
    """How often foods of a kind join at each type of stage, beside which others, and by what they are cooked before."""

    def __init__(self) -> None:
        self.stages: Counter[tuple[str, str, StageType]] = Counter()
        self.beside: Counter[tuple[str, str]] = Counter()
        self.cooked: Counter[tuple[str, str]] = Counter()

    def count(self, frames: Iterable[Frame], weight: int = 1) -> None:
        """Add what ``frames`` show, each ``weight`` times; -1 takes back what was counted of them before."""
        for frame in frames:
            for spot in spots_of(frame.line):
                slots = list(spot.stage.slots)
                for slot in slots:
                    self.stages[slot.kind, frame.dish_type, spot.stage_type] += weight
                    for motion in slot.cooked[:1]:
                        self.cooked[slot.kind, motion] += weight
                    for other in slots:
                        if other is not slot:
                            self.beside[slot.kind, other.kind] += weight

    def rows(self) -> dict[str, list[dict[str, Any]]]:
        """Return the parameters of ``cypher/count_joins.cypher``: what changed, and not what was taken back again."""
        return {
            "stage_types": [
                {"kind": KIND + kind, "dish_type": dish_type, **_named(stage_type), "count": count}
                for (kind, dish_type, stage_type), count in sorted(self.stages.items())
                if count
            ],
            "beside": [
                {"kind": KIND + kind, "other": KIND + other, "count": count}
                for (kind, other), count in sorted(self.beside.items())
                if count
            ],
            "cooked": [
                {"kind": KIND + kind, "motion": motion, "count": count}
                for (kind, motion), count in sorted(self.cooked.items())
                if count
            ],
        }

    def matters(self) -> set[str]:
        """Return the kinds that are counted, as matters."""
        return {KIND + kind for kind, _, _ in self.stages}


def _named(stage_type: StageType) -> Mapping[str, Any]:
    """Return the ``StageType`` node of ``stage_type``: its name, which no other has, and its parts."""
    work, heated, joins = stage_type
    return {"stage_type": f"{work}, heated {heated}, {'joins' if joins else 'own'}"} | {
        "properties": {"work": work, "heated": heated, "joins": joins}
    }
