"""The progress lines as a picture: one row an ingredient, its stages in boxes, the motions between them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from xml.etree import ElementTree as ET

from foon_kg.pictures.svg import Line, as_text, element, height_of, picture, write_line
from foon_kg.progress import ProgressLine, ProgressStep
from foon_kg.views.shown_tree import ShownTree
from foon_kg.views.words import UNSEEN_SIGN

_WIDTH = 1180.0
_EDGE = 24.0
_NAMES = 170.0
_GAP = 8.0
_ROW_GAP = 10.0
_BAND_EDGE = 10.0
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


def progress_svg(tree: ShownTree) -> str:
    """Answer the text of an SVG file that shows the progress line of every ingredient of ``tree``."""
    bands = [_rows(list(_pieces(line))) for line in tree.lines]
    heights = [sum(map(_height, rows)) + _ROW_GAP * (len(rows) - 1) + 2 * _BAND_EDGE for rows in bands]
    title = f"Progress of each ingredient: {tree.title}"
    root = picture(_WIDTH, sum(heights) + len(heights) * 6 + 56 + _EDGE, title)
    write_line(root, Line(title, "name", 18, bold=True), _EDGE, 34, anchor="start")
    top = 56.0
    for line, rows, height in zip(tree.lines, bands, heights, strict=True):
        _draw_band(root, line, tree, top, height)
        _draw_rows(root, rows, top + _BAND_EDGE)
        top += height + 6
    return as_text(root)


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


def _rows(pieces: Sequence[_Piece]) -> list[list[_Piece]]:
    rows: list[list[_Piece]] = [[]]
    x = 0.0
    for piece in pieces:
        if rows[-1] and x + piece.width > _WIDTH - _NAMES - 2 * _EDGE:
            rows.append([])
            x = 0.0
        rows[-1].append(piece)
        x += piece.width + _GAP
    return rows


def _height(row: Sequence[_Piece]) -> float:
    return max((piece.height for piece in row), default=0.0)


def _draw_band(root: ET.Element, line: ProgressLine, tree: ShownTree, top: float, height: float) -> None:
    band: dict[str, object] = {"x": _EDGE - 10, "y": top, "width": _WIDTH - 2 * _EDGE + 20, "height": height, "rx": 8}
    like = tree.unseen.get(line.ingredient)
    if like is None:
        element(root, "rect", band, "band")
        write_line(root, Line(line.ingredient, "name", 13, bold=True), _EDGE, top + height / 2 + 5, anchor="start")
        return
    element(root, "rect", band | {"stroke-dasharray": _DASHED}, "band", "unseen-box")
    name = Line(UNSEEN_SIGN + line.ingredient, "unseen", 13, bold=True)
    write_line(root, name, _EDGE, top + height / 2 - 2, anchor="start")
    known = Line(f"like {like.equivalent} {like.confidence:.2f}", "unseen", 11)
    write_line(root, known, _EDGE, top + height / 2 + 13, anchor="start")


def _draw_rows(root: ET.Element, rows: Sequence[Sequence[_Piece]], top: float) -> None:
    for row in rows:
        x, middle = _EDGE + _NAMES, top + _height(row) / 2
        for piece in row:
            _draw_piece(root, piece, x, middle)
            x += piece.width + _GAP
        top += _height(row) + _ROW_GAP


def _draw_piece(root: ET.Element, piece: _Piece, x: float, middle: float) -> None:
    top = middle - piece.height / 2
    if piece.kind:
        box: dict[str, object] = {"x": x, "y": top, "width": piece.width, "height": piece.height, "rx": 8}
        element(root, "rect", box, piece.kind)
    foot = middle - height_of(piece.lines) / 2
    for line in piece.lines:
        foot += line.size * 1.25
        write_line(root, line, x + piece.width / 2, foot - line.size * 0.32)
