"""A schedule as a chart: one row a step, one colour a pair of hands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from xml.etree import ElementTree as ET

from foon_kg.formats.exports.sentences import sentence
from foon_kg.formats.pictures.svg import (
    Line,
    as_text,
    element,
    height_of,
    picture,
    text_width,
    wrapped,
    writable,
    write_line,
)
from foon_kg.formats.views.schedule import CAUTION, clock, seen_words, summary
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.schedule import Schedule, ScheduledStep

WIDTH = 1180.0
ITSELF = "by itself"
NEVER = "unknown"
_NARROW = 640.0  # below this what is done stands above its bar, not beside it
_EDGE = 24.0
_NAMES = 400.0
_NOTE = 70.0  # beside the last bar: that nothing tells how long it takes
_BAR = 12.0
_ROW = 22.0
_LINE = 15.0
_MOST_LINES = 6
_GAP = 8.0
_COLOURS = 4
_TICKS = (1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 28800)


def schedule_svg(tree: ShownTree, plan: Schedule, width: float = WIDTH) -> str:
    """Return the schedule ``plan`` of a ``tree`` as a Gantt chart: an SVG file that is ``width`` pixels wide.

    Bars of untimed steps are hollow.
    """
    sheet = _Sheet(tree, plan, width)
    head = [*_lines_of(tree.title, width, "name", 18), *_lines_of(summary(plan), width, "aside", 12)]
    axis = 34 + height_of(head) + 48
    rows = axis + 8
    foot = _lines_of(CAUTION, width, "aside", 11)
    bottom = rows + sheet.tops[-1]
    root = picture(width, bottom + 12 + height_of(foot) + _EDGE, f"Schedule: {tree.title}. {summary(plan)}")
    _write(root, head, 34)
    sheet.draw_legend(root, axis - 34)
    sheet.draw_bands(root, rows)
    sheet.draw_axis(root, axis, bottom)
    for number, step in enumerate(plan.steps):
        sheet.draw_step(root, step, number, rows)
    _write(root, foot, bottom + 24)
    return as_text(root)


@dataclass(frozen=True)
class _Sheet:
    """A sheet of paper of a ``width``, on which a schedule is drawn."""

    tree: ShownTree
    plan: Schedule
    width: float

    @cached_property
    def tops(self) -> Sequence[float]:
        """How far below the first row each begins, and behind them where the last one ends."""
        return tuple(accumulate(map(self._height, self._names), initial=0.0))

    def _height(self, lines: Sequence[str]) -> float:
        return _ROW + _LINE * (len(lines) - 1) if self._aside else _ROW - 1 + _LINE * len(lines)

    @cached_property
    def _names(self) -> Sequence[Sequence[str]]:
        """What is done in each row, in lines that fit beside or above its bar."""
        room = (_NAMES if self._aside else self.width - 2 * _EDGE) - _GAP - text_width("00 ", 13)
        return [wrapped(self._said(step), room, 12, most=_MOST_LINES) for step in self.plan.steps]

    def _said(self, step: ScheduledStep) -> str:
        return sentence(self.tree.units[step.place].as_unit(), Kitchen.default())

    @property
    def _aside(self) -> bool:
        return self.width >= _NARROW

    @property
    def _left(self) -> float:
        return _EDGE + (_NAMES if self._aside else 0.0)

    def _x(self, seconds: float) -> float:
        room = self.width - _EDGE - _NOTE - self._left
        return self._left + room * seconds / max(self.plan.length, 1.0)

    def draw_legend(self, root: ET.Element, top: float) -> None:
        """Say whose colour is which."""
        x = _EDGE
        for name, kind in self._colours():
            element(root, "rect", {"x": x, "y": top - 9, "width": 14, "height": 10, "rx": 2}, kind)
            write_line(root, Line(name, "aside", 11), x + 20, top, anchor="start")
            x += 20 + text_width(name, 11) + 16

    def _colours(self) -> Iterator[tuple[str, str]]:
        for number in range(min(self.plan.hands, _COLOURS)):
            yield f"pair of hands {number + 1}", f"hands-{number + 1}"
        if any(step.hands is None for step in self.plan.steps):
            yield ITSELF, "by-itself"

    def draw_bands(self, root: ET.Element, top: float) -> None:
        """Shade every second row, from ``top`` down."""
        for number in range(0, len(self.plan.steps), 2):
            place: dict[str, object] = {"x": _EDGE - 10, "y": top + self.tops[number], "rx": 5}
            height = self.tops[number + 1] - self.tops[number]
            element(root, "rect", place | {"width": self.width - 2 * _EDGE + 20, "height": height}, "band")

    def draw_axis(self, root: ET.Element, top: float, bottom: float) -> None:
        """Draw the minutes above the rows, and their lines through them."""
        most = 8 if self._aside else 4
        between = next((tick for tick in _TICKS if self.plan.length / tick <= most), _TICKS[-1])
        for tick in range(int(self.plan.length // between) + 1):
            x = self._x(tick * between)
            element(root, "line", {"x1": x, "x2": x, "y1": top, "y2": bottom}, "rule")
            if tick * between <= self.plan.known_until and self.plan.known_until:
                write_line(root, Line(clock(tick * between), "aside", 11), x, top - 5)

    def draw_step(self, root: ET.Element, step: ScheduledStep, number: int, rows: float) -> None:
        """Draw the row of a step; a program that points at it is told all that is known of it."""
        row, top = element(root, "g", {}), rows + self.tops[number]
        ET.SubElement(row, "title").text = writable(self._words(step))
        self._write_name(row, f"{step.place + 1} ", self._names[number], top + 15)
        foot = top + (_ROW if self._aside else self._height(self._names[number])) - (_ROW - _BAR) / 2
        start, end = self._x(step.start), self._x(step.end)
        bar: dict[str, object] = {"x": start, "y": foot - _BAR, "width": max(end - start, 2.0), "height": _BAR, "rx": 2}
        if step.duration is None:
            bar |= {"fill-opacity": 0.2, "stroke-dasharray": "3 2"}
            write_line(row, Line(NEVER, "aside", 10), end + 6, foot - 2.5, anchor="start")
        element(row, "rect", bar, "by-itself" if step.hands is None else f"hands-{step.hands % _COLOURS + 1}")

    def _write_name(self, row: ET.Element, number: str, lines: Sequence[str], foot: float) -> None:
        indent = text_width(number, 13)
        for line, words in enumerate(lines):
            x = _EDGE + (indent if line else 0.0)
            text = element(row, "text", {"x": x, "y": foot + _LINE * line, "font-size": 12})
            for part, kind in ((number if line == 0 else "", "aside"), (words, "name")):
                if part:
                    element(text, "tspan", {}, kind).text = writable(part)

    def _words(self, step: ScheduledStep) -> str:
        who = ITSELF if step.hands is None else f"pair of hands {step.hands + 1}"
        seen = f"seen {seen_words(step.duration)}" if step.duration else NEVER
        what = f"step {step.place + 1}, {self._said(step).rstrip('.')}"
        when = f"{clock(step.start)} to {clock(step.end)}" if step.end <= self.plan.known_until else "nobody knows when"
        return f"{when}: {what}; {who}; {seen}"


def _lines_of(text: str, width: float, kind: str, size: float) -> list[Line]:
    return [Line(line, kind, size, bold=kind == "name") for line in wrapped(text, width - 2 * _EDGE, size)]


def _write(root: ET.Element, lines: Sequence[Line], foot: float) -> None:
    for line in lines:
        write_line(root, line, _EDGE, foot, anchor="start")
        foot += line.size * 1.4
