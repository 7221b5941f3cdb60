"""The reference tree and the final tree side by side: what was kept, changed, left out and added."""

from __future__ import annotations

from collections.abc import Sequence
from xml.etree import ElementTree as ET

from foon_kg.formats.exports.phrases import motion_said
from foon_kg.formats.pictures.layout import Point
from foon_kg.formats.pictures.svg import Line, as_text, element, picture, wrapped, write_line
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.formats.views.step_changes import names, totals
from foon_kg.formats.views.words import handled
from foon_kg.plans.step_changes import Change, StepChange

_EDGE = 24.0
_COLUMN = 400.0
_GAP = 56.0
_HEAD = 86.0
_ROW = 30.0
_NOTE = 15.0
_PAINT: dict[Change, tuple[str, str]] = {  # of the reference's box, of the final tree's box
    "kept": ("object", "object"),
    "changed": ("object", "unseen-box"),
    "left out": ("kitchen", "kitchen"),
    "added": ("goal", "goal"),
}
_DASHED = "5 3"


def step_changes_svg(tree: ShownTree, changes: Sequence[StepChange]) -> str:
    """Return the text of an SVG file with the steps of both trees in two columns, joined by ``changes``.

    ``changes`` joins those that are the same.
    """
    heights = [_ROW + (_NOTE if names(one) else 0) + 6 for one in changes]
    width = 2 * _EDGE + 2 * _COLUMN + _GAP
    root = picture(width, _HEAD + sum(heights) + _EDGE, f"Reference and final tree: {tree.title}")
    write_line(root, Line(tree.title, "name", 18, bold=True), _EDGE, 32, anchor="start")
    write_line(root, Line(totals(changes), "aside", 12), _EDGE, 52, anchor="start")
    write_line(root, Line("reference tree", "aside", 12, bold=True), _EDGE, 76, anchor="start")
    write_line(root, Line("this tree", "aside", 12, bold=True), _EDGE + _COLUMN + _GAP, 76, anchor="start")
    top = _HEAD
    for one, height in zip(changes, heights, strict=True):
        _draw(root, one, top)
        top += height
    return as_text(root)


def _draw(root: ET.Element, one: StepChange, top: float) -> None:
    right = _EDGE + _COLUMN + _GAP
    if one.before is not None:
        number, known = one.before
        words = (f"{number} {motion_said(known.unit.motion)}", handled(known.unit.input_nodes))
        _draw_step(root, one, _PAINT[one.change][0], (_EDGE, top), words)
    if one.after is not None:
        number, unit = one.after
        words = (f"{number} {motion_said(unit.motion)}", handled(unit.input_nodes))
        _draw_step(root, one, _PAINT[one.change][1], (right, top), words)
    if one.before is not None and one.after is not None:
        line = {"d": f"M{_EDGE + _COLUMN:.0f} {top + _ROW / 2:.1f}H{right:.0f}", "stroke-width": 1.3}
        element(root, "path", line | ({"stroke-dasharray": _DASHED} if one.change == "changed" else {}), "way")
    if names(one):
        note = wrapped(names(one), _COLUMN - 12, 11, most=1)[0]
        write_line(root, Line(note, "unseen", 11), right + 10, top + _ROW + 12, anchor="start")


def _draw_step(root: ET.Element, one: StepChange, paint: str, place: Point, words: tuple[str, str]) -> None:
    (x, top), (motion, foods) = place, words
    box: dict[str, object] = {"x": x, "y": top, "width": _COLUMN, "height": _ROW - 2, "rx": 6, "stroke-width": 1.3}
    out = one.change == "left out"
    dashed = {"stroke-dasharray": _DASHED} if paint == "unseen-box" or out else {}
    element(root, "rect", box | dashed, "object" if paint == "unseen-box" else paint, paint)
    verb = Line(motion, "aside" if out else "verb", 13, bold=True)
    write_line(root, verb, x + 10, top + 19, anchor="start")
    room = _COLUMN - verb.width - 34
    told = wrapped(foods, room, 12, most=1)[0]
    write_line(root, Line(told, "aside" if out else "name", 12), x + 18 + verb.width, top + 19, anchor="start")
