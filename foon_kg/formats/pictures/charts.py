"""The charts of a report: curves, histograms and means with their intervals, as SVG in the page's own colours.

Colours are classes of the page's style sheet (``report.css``), so that a chart follows light and dark; every series has
a dash of its own too, and every mark says its figures when it is pointed at.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from xml.etree import ElementTree as ET

from foon_kg.evaluation.resampling import Interval
from foon_kg.formats.pictures.svg import element, number, text_width, writable

_WIDTH, _HEIGHT = 560.0, 300.0
_LEFT, _TOP, _RIGHT, _BOTTOM = 46.0, 28.0, 24.0, 40.0
_DASHES = ("none", "7 4", "2 4", "9 3 2 3", "4 2")
_ROW = 26.0
_LEAST_RANGE = 0.05
_STEPS = (0.01, 0.02, 0.05, 0.1, 0.2)
_MOST_MARKS = 6
_EXACTLY = 1e-9


def curve_chart(curves: Mapping[str, Mapping[int, float]], title: str, across: str, up: str) -> str:
    """Return a chart called ``title`` with a curve for each name: shares (0 to 1) by threshold (per cent).

    ``across`` and ``up`` are the words at its axes.
    """
    root = _picture(_WIDTH, _HEIGHT + 22, title)
    _axes(root, across, up)
    for place, (name, curve) in enumerate(curves.items()):
        points = " ".join(f"{number(_x(at / 100))},{number(_y(share))}" for at, share in curve.items())
        line = element(
            root, "polyline", {"points": points, "stroke-dasharray": _dash(place), "stroke-width": 2}, _series(place)
        )
        ET.SubElement(line, "title").text = writable(name)
        for at, share in curve.items():
            dot = element(root, "circle", {"cx": _x(at / 100), "cy": _y(share), "r": 3}, _series(place), "dot")
            ET.SubElement(dot, "title").text = writable(f"{name}: {100 * share:.0f} % at {at} %")
    _legend(root, list(curves))
    return _text_of(root)


def histogram_chart(counts: Sequence[int], title: str, across: str) -> str:
    """Return a chart called ``title`` of ``counts`` in bins of equal width from 0 to 1, each number above its bar.

    ``across`` are the words below it.
    """
    root = _picture(_WIDTH, _HEIGHT, title)
    most, width = max([*counts, 1]), (_WIDTH - _LEFT - _RIGHT) / len(counts)
    for place, count in enumerate(counts):
        left, top = _LEFT + place * width, _y(count / most * 0.92)
        bar = element(root, "rect", {"x": left + 2, "y": top, "width": width - 4, "height": _y(0.0) - top}, "bar")
        ET.SubElement(bar, "title").text = f"{place / len(counts):.1f} to {(place + 1) / len(counts):.1f}: {count}"
        _write(root, left + width / 2, top - 4, str(count))
    for place in range(len(counts) + 1):
        _write(root, _LEFT + place * width, _y(0.0) + 16, f"{place / len(counts):.1f}")
    element(root, "path", {"d": f"M{number(_LEFT)} {number(_y(0.0))}H{number(_WIDTH - _RIGHT)}"}, "axis")
    _write(root, (_LEFT + _WIDTH - _RIGHT) / 2, _HEIGHT - 6, across)
    return _text_of(root)


def interval_chart(rows: Sequence[tuple[str, Interval]], title: str) -> str:
    """Return a chart called ``title`` of means with their intervals, one row a name.

    It begins at 0, or where all of them are in its upper half just below the least.
    """
    names = max((text_width(name, 12) for name, _ in rows), default=0.0) + 20
    root = _picture(_WIDTH, _ROW * len(rows) + 30, title)
    most = max([_LEAST_RANGE, *(interval.high for _, interval in rows)])
    lowest = min((interval.low for _, interval in rows), default=0.0)
    least = 0.0 if lowest < most / 2 else max(0.0, math.floor((lowest - _LEAST_RANGE) / _LEAST_RANGE) * _LEAST_RANGE)
    room = _WIDTH - names - 60

    def x(share: float) -> float:
        return names + room * (share - least) / (most - least)

    for mark in _marks(least, most):
        element(root, "path", {"d": f"M{number(x(mark))} 4V{number(_ROW * len(rows) + 8)}"}, "grid")
        _write(root, x(mark), _ROW * len(rows) + 24, f"{100 * mark:.0f} %")
    for place, (name, interval) in enumerate(rows):
        y = _ROW * place + 18
        _write(root, names - 10, y + 4, name, anchor="end", kind="name")
        span = f"M{number(x(interval.low))} {number(y)}H{number(x(interval.high))}"
        line = element(root, "path", {"d": span, "stroke-width": 5}, "span")
        words = f"{name}: {100 * interval.mean:.1f} % [{100 * interval.low:.1f}, {100 * interval.high:.1f}]"
        ET.SubElement(line, "title").text = writable(words)
        element(root, "circle", {"cx": x(interval.mean), "cy": y, "r": 5}, "mean")
        _write(root, x(interval.high) + 10, y + 4, f"{100 * interval.mean:.1f}", anchor="start", kind="name")
    return _text_of(root)


def _picture(width: float, height: float, title: str) -> ET.Element:
    box = f"0 0 {number(width)} {number(height)}"
    root = ET.Element("svg", viewBox=box, role="img")
    root.set("class", "chart")
    root.set("aria-label", writable(title))
    return root


def _axes(root: ET.Element, across: str, up: str) -> None:
    for place in range(0, 101, 20):
        share = place / 100
        element(root, "path", {"d": f"M{number(_LEFT)} {number(_y(share))}H{number(_WIDTH - _RIGHT)}"}, "grid")
        _write(root, _LEFT - 6, _y(share) + 4, f"{place} %", anchor="end")
        _write(root, _x(share), _y(0.0) + 16, f"{place} %")
    _write(root, (_LEFT + _WIDTH - _RIGHT) / 2, _HEIGHT - 6, across)
    _write(root, 4, 12, up, anchor="start")


def _legend(root: ET.Element, names: Sequence[str]) -> None:
    left = _LEFT
    for place, name in enumerate(names):
        way = f"M{number(left)} {number(_HEIGHT + 10)}h26"
        element(root, "path", {"d": way, "stroke-dasharray": _dash(place), "stroke-width": 2}, _series(place))
        _write(root, left + 32, _HEIGHT + 14, name, anchor="start", kind="name")
        left += 52 + text_width(name, 12)


def _write(root: ET.Element, x: float, y: float, text: str, *, anchor: str = "middle", kind: str = "label") -> None:
    element(root, "text", {"x": x, "y": y, "font-size": 12, "text-anchor": anchor}, kind).text = writable(text)


def _marks(least: float, most: float) -> Iterator[float]:
    """Return round shares from ``least``, itself round, to ``most``: not more than fit beside one another."""
    step = next(step for step in _STEPS if most - least <= _MOST_MARKS * step)
    return (least + place * step for place in range(int((most - least) / step + _EXACTLY) + 1))


def _x(share: float) -> float:
    return _LEFT + (_WIDTH - _LEFT - _RIGHT) * share


def _y(share: float) -> float:
    return _HEIGHT - _BOTTOM - (_HEIGHT - _TOP - _BOTTOM) * share


def _series(place: int) -> str:
    return f"series-{place % len(_DASHES)}"


def _dash(place: int) -> str:
    return _DASHES[place % len(_DASHES)]


def _text_of(root: ET.Element) -> str:
    return ET.tostring(root, encoding="unicode")
