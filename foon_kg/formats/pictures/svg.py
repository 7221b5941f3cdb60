"""SVG elements in the colours of the project: objects plain, states green, motions red, what is unseen blue.

Colours are written at every element, so that any program shows them; a style sheet says only what they are in the dark.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from xml.etree import ElementTree as ET

FONT = "Helvetica, Arial, 'Liberation Sans', sans-serif"
_LEADING, _DESCENT = 1.25, 0.32
"""From one line to the next, and from the foot of its letters to where the next begins, as shares of their size."""

_NAMESPACE = "http://www.w3.org/2000/svg"
_UNWRITABLE = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_NARROW = frozenset("ijltfrI.,:;'|!()[]{} -")
_WIDE = frozenset("mwMWGOQCDNHU@%&")

_Paint = Mapping[str, tuple[str, str]]
_HANDS: _Paint = {
    "hands-1": ("#0969da", "#79b8ff"),
    "hands-2": ("#9a6700", "#e3b341"),
    "hands-3": ("#8250df", "#c297ff"),
    "hands-4": ("#1a7f37", "#57c275"),
    "by-itself": ("#8c959f", "#727b85"),
}
_FILL: _Paint = {  # in the light and in the dark
    "paper": ("#ffffff", "#16181d"),
    "name": ("#1f2328", "#e6e8eb"),
    "state": ("#1a7f37", "#57c275"),
    "aside": ("#656d76", "#9aa3ad"),
    "unseen": ("#0550ae", "#79b8ff"),
    "verb": ("#b3261e", "#ff8f85"),
    "way-end": ("#8c959f", "#727b85"),
    "object": ("#ffffff", "#20242b"),
    "kitchen": ("#f6f8fa", "#1b1f25"),
    "goal": ("#dafbe1", "#12351f"),
    "motion": ("#ffebe9", "#3a1c1b"),
    "band": ("#f6f8fa", "#1c2027"),
    **_HANDS,
}
_STROKE: _Paint = {
    "object": ("#afb8c1", "#4b535d"),
    "kitchen": ("#d0d7de", "#39414a"),
    "goal": ("#1a7f37", "#57c275"),
    "motion": ("#cf5b53", "#b5554d"),
    "unseen-box": ("#0969da", "#79b8ff"),
    "way": ("#8c959f", "#727b85"),
    "rule": ("#d0d7de", "#39414a"),
    **_HANDS,
}


@dataclass(frozen=True)
class Line:
    """A line of text: of one ``kind`` (name, state, aside, unseen, verb), at a size in pixels."""

    text: str
    kind: str
    size: float = 12.0
    bold: bool = False

    @property
    def width(self) -> float:
        """About how wide the line is, in pixels; there is no font to measure at hand."""
        return text_width(self.text, self.size) * (1.08 if self.bold else 1.0)


def text_width(text: str, size: float = 12.0) -> float:
    """Return about how wide ``text`` is in a common sans serif font of this ``size``, in pixels."""
    return size * sum(0.34 if c in _NARROW else 0.84 if c in _WIDE else 0.59 if c < "\u2e80" else 1.0 for c in text)


def picture(width: float, height: float, title: str) -> ET.Element:
    """Return an empty picture of ``width`` by ``height`` pixels: its paper, its ``title``, its colours in the dark."""
    box = f"0 0 {number(width)} {number(height)}"
    root = ET.Element("svg", xmlns=_NAMESPACE, viewBox=box, width=number(width), height=number(height), role="img")
    root.set("font-family", FONT)
    ET.SubElement(root, "title").text = writable(title)
    ET.SubElement(root, "style").text = dark_colours()
    element(root, "rect", {"width": width, "height": height}, "paper")
    return root


def dark_colours() -> str:
    """Return the style sheet that turns every colour to its dark one where the reader prefers the dark."""
    rules = [f".{kind}{{fill:{dark}}}" for kind, (_, dark) in _FILL.items()]
    rules += [f".{kind}{{stroke:{dark}}}" for kind, (_, dark) in _STROKE.items()]
    return f"@media (prefers-color-scheme: dark){{{''.join(rules)}}}"


def element(parent: ET.Element, name: str, attributes: Mapping[str, object], *kinds: str) -> ET.Element:
    """Return an element called ``name``, added to ``parent`` with ``attributes`` and the colours of its ``kinds``."""
    written = {key: number(value) if isinstance(value, float) else str(value) for key, value in attributes.items()}
    for kind in kinds:
        if kind in _FILL:
            written.setdefault("fill", _FILL[kind][0])
        if kind in _STROKE:
            written["stroke"] = _STROKE[kind][0]
    written.setdefault("fill", "none")
    if kinds:
        written["class"] = " ".join(kinds)
    return ET.SubElement(parent, name, written)


def write_line(parent: ET.Element, line: Line, x: float, y: float, *, anchor: str = "middle") -> None:
    """Write ``line`` into ``parent`` with its foot at ``y`` and its ``anchor`` at ``x``, both in pixels.

    ``anchor`` is start, middle or end.
    """
    attributes: dict[str, object] = {"x": x, "y": y, "font-size": line.size, "text-anchor": anchor}
    if line.bold:
        attributes["font-weight"] = "bold"
    element(parent, "text", attributes, line.kind).text = writable(line.text)


def wrapped(text: str, width: float, size: float, most: int = 3) -> list[str]:
    """Return ``text``, broken at spaces into at most ``most`` lines of about ``width`` pixels in letters of ``size``.

    What is left out shows as ….
    """
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if not lines[-1] or text_width(longer, size) <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    if len(lines) > most:
        lines = [*lines[: most - 1], lines[most - 1].rstrip(",;") + " …"]
    return lines


def height_of(lines: Sequence[Line]) -> float:
    """Return how high lines are, one under the other."""
    return sum(line.size * _LEADING for line in lines)


def write_lines(parent: ET.Element, lines: Iterable[Line], x: float, top: float, *, anchor: str = "middle") -> float:
    """Write ``lines`` into ``parent`` one under the other from ``top`` down, and return where the last one ends.

    ``x`` is where the ``anchor`` (start, middle or end) of each is; all in pixels.
    """
    for line in lines:
        top += line.size * _LEADING
        write_line(parent, line, x, top - line.size * _DESCENT, anchor=anchor)
    return top


def number(value: float) -> str:
    """Return ``value`` as SVG has it, to a tenth of a pixel."""
    return f"{value:.1f}".removesuffix(".0")


def writable(text: str) -> str:
    """Return ``text`` with what XML cannot hold (control characters) replaced by a sign for it."""
    return _UNWRITABLE.sub("\ufffd", text)


def as_text(root: ET.Element) -> str:
    """Return the picture whose element is ``root`` as the text of an SVG file."""
    return ET.tostring(root, encoding="unicode") + "\n"
