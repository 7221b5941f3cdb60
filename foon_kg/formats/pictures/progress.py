"""The progress lines as a picture: one row an ingredient, its stages in boxes, the motions between them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from xml.etree import ElementTree as ET

from foon_kg.formats.pictures.svg import Line, as_text, element, height_of, picture, wrapped, write_line, write_lines
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.formats.views.words import UNSEEN_SIGN
from foon_kg.plans.progress import ProgressLine, ProgressStep

WIDTH = 1180.0
_NARROW = 640.0  # below this the name of an ingredient stands above its stages, not beside them
_EDGE = 24.0
_NAMES = 170.0
_NAME_SIZE = 13
_GAP = 8.0
_ROW_GAP = 10.0
_BAND_EDGE = 10.0
_BAND_GAP = 6.0
_DASHED = "5 3"


@dataclass(frozen=True)
class _Piece:
    """A stage in its box, or the motion between two stages, which has none (``kind`` is empty)."""

    lines: tuple[Line, ...]
    kind: str

    @property
    def width(self) -> float:
        return max(line.width for line in self.lines) + (18 if self.kind else 4)

    @property
    def height(self) -> float:
        return height_of(self.lines) + (10 if self.kind else 0)


def progress_svg(tree: ShownTree, width: float = WIDTH) -> str:
    """Return the text of an SVG file, ``width`` pixels wide, with the progress line of every ingredient of ``tree``."""
    sheet = _Sheet(tree, width)
    bands = [sheet.band(line) for line in tree.lines]
    title = f"Progress of each ingredient: {tree.title}"
    head = [Line(line, "name", 18, bold=True) for line in wrapped(title, width - 2 * _EDGE, 18)]
    top = 34.0 + height_of(head)
    root = picture(width, top + sum(band.height + _BAND_GAP for band in bands) + _EDGE, title)
    for number, line in enumerate(head):
        write_line(root, line, _EDGE, 34 + 22.5 * number, anchor="start")
    for band in bands:
        sheet.draw(root, band, top)
        top += band.height + _BAND_GAP
    return as_text(root)


@dataclass(frozen=True)
class _Band:
    """The line of one ingredient: what stands for its name, and its pieces in rows."""

    names: tuple[Line, ...]
    rows: list[list[_Piece]]
    height: float
    unseen: bool


@dataclass(frozen=True)
class _Sheet:
    """A sheet of paper of a ``width``, on which a tree's lines are drawn."""

    tree: ShownTree
    width: float

    @property
    def aside(self) -> bool:
        """Whether names stand beside the stages."""
        return self.width >= _NARROW

    @property
    def left(self) -> float:
        """Where the stages begin."""
        return _EDGE + (_NAMES if self.aside else 0.0)

    def band(self, line: ProgressLine) -> _Band:
        names, rows = tuple(self._names(line)), self._rows(list(_pieces(line)))
        inside = sum(map(_height, rows)) + _ROW_GAP * (len(rows) - 1)
        beside = height_of(names)
        inside = max(inside, beside) if self.aside else inside + beside + _GAP
        return _Band(names, rows, inside + 2 * _BAND_EDGE, line.ingredient in self.tree.unseen)

    def _names(self, line: ProgressLine) -> Iterator[Line]:
        like = self.tree.unseen.get(line.ingredient)
        room = (_NAMES if self.aside else self.width - 2 * _EDGE) - _GAP
        kind, sign = ("name", "") if like is None else ("unseen", UNSEEN_SIGN)
        for text in wrapped(sign + line.ingredient, room, _NAME_SIZE):
            yield Line(text, kind, _NAME_SIZE, bold=True)
        if like is not None:
            for text in wrapped(f"like {like.equivalent} {like.confidence:.2f}", room, 11):
                yield Line(text, "unseen", 11)

    def _rows(self, pieces: Sequence[_Piece]) -> list[list[_Piece]]:
        rows: list[list[_Piece]] = [[]]
        x = self.left
        for piece in pieces:
            if rows[-1] and x + piece.width > self.width - _EDGE:
                rows.append([])
                x = self.left
            rows[-1].append(piece)
            x += piece.width + _GAP
        return rows

    def draw(self, root: ET.Element, band: _Band, top: float) -> None:
        """Draw ``band`` from ``top`` down."""
        frame: dict[str, object] = {
            "x": _EDGE - 10,
            "y": top,
            "width": self.width - 2 * _EDGE + 20,
            "height": band.height,
        }
        frame |= {"rx": 8} | ({"stroke-dasharray": _DASHED} if band.unseen else {})
        element(root, "rect", frame, "band", *(["unseen-box"] if band.unseen else []))
        head = top + ((band.height - height_of(band.names)) / 2 if self.aside else _BAND_EDGE)
        foot = write_lines(root, band.names, _EDGE, head, anchor="start")
        self._draw_rows(root, band.rows, top + _BAND_EDGE if self.aside else foot + _GAP)

    def _draw_rows(self, root: ET.Element, rows: Sequence[Sequence[_Piece]], top: float) -> None:
        for row in rows:
            x, middle = self.left, top + _height(row) / 2
            for piece in row:
                _draw_piece(root, piece, x, middle)
                x += piece.width + _GAP
            top += _height(row) + _ROW_GAP


def _pieces(line: ProgressLine) -> Iterator[_Piece]:
    name = line.ingredient
    if not line.steps:
        yield _Piece((Line("does not reach the dish", "aside"),), "")
    for step in line.steps:
        yield _Piece(_stage(step, step.object if step.object != name else ""), "object")
        yield _Piece((Line(f"{step.motion} →", "verb", 12, bold=True),), "")
        name = step.object or name
    if line.end_product:
        yield _Piece((Line(line.end_product, "name", 12.5, bold=True),), "goal")


def _stage(step: ProgressStep, become: str) -> tuple[Line, ...]:
    place = f"{step.relation or 'at'} {step.container}" if step.container else ""
    told = (Line(become, "name", 12), Line(", ".join(step.states), "state", 12), Line(place, "aside", 11))
    return tuple(line for line in told if line.text) or (Line("as it is", "aside", 11),)


def _height(row: Sequence[_Piece]) -> float:
    return max((piece.height for piece in row), default=0.0)


def _draw_piece(root: ET.Element, piece: _Piece, x: float, middle: float) -> None:
    top = middle - piece.height / 2
    if piece.kind:
        box: dict[str, object] = {"x": x, "y": top, "width": piece.width, "height": piece.height, "rx": 8}
        element(root, "rect", box, piece.kind)
    write_lines(root, piece.lines, x + piece.width / 2, middle - height_of(piece.lines) / 2)
