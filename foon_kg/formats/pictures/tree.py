"""The task tree as a picture: object nodes and motions in layers, from the kitchen down to the goal."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from xml.etree import ElementTree as ET

from foon_kg.formats.exports.phrases import motion_said
from foon_kg.formats.pictures.layout import LAYER_GAP, Layout, Point, banded, layered
from foon_kg.formats.pictures.scene import MotionBox, ObjectBox, Scene, foods_of, phases_of, scene_of
from foon_kg.formats.pictures.svg import (
    Line,
    as_text,
    element,
    height_of,
    number,
    picture,
    text_width,
    wrapped,
    writable,
    write_line,
    write_lines,
)
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.formats.views.words import UNSEEN_SIGN
from foon_kg.model import ObjectNode
from foon_kg.model.claims import Substitution
from foon_kg.plans.kitchen import Kitchen

_TEXT_WIDTH = 150.0
_EDGE = 24.0
_HEAD = 74.0
_ROUND = {"kitchen": 6.0, "made": 12.0, "goal": 12.0}
_PAINT = {"kitchen": "kitchen", "made": "object", "goal": "goal"}
_BANDS = ("making ready", "cooking", "serving")
_DASHED = "5 3"
_NOTHING = 0.5  # pixels
_LEGEND = (
    ("kitchen", "from the kitchen"),
    ("object", "made on the way"),
    ("motion", "as the FOON has it"),
    ("changed", "as it does to a like food"),
    ("unseen-box", "~ never seen so, with its equivalent"),
)


def tree_svg(tree: ShownTree, kitchen: Kitchen, *, folded: bool = True, headed: bool = True) -> str:
    """Return the text of an SVG file that shows ``tree`` in its ``kitchen``; see :func:`scene_of` for ``folded``.

    Its title and legend are left out where it is not ``headed``: a page that moves the picture tells them beside it.
    """
    return as_text(_Picture.of(tree, kitchen, folded=folded, head=_HEAD if headed else _EDGE).drawn())


@dataclass(frozen=True)
class _Picture:
    tree: ShownTree
    scene: Scene
    texts: Sequence[Sequence[Line]]
    sizes: Sequence[tuple[float, float]]
    layout: Layout
    phases: Sequence[int]
    foods: Sequence[frozenset[str]]
    head: float

    @classmethod
    def of(cls, tree: ShownTree, kitchen: Kitchen, *, folded: bool, head: float) -> _Picture:
        scene = scene_of(tree.units, tree.goal, kitchen, folded=folded)
        words = _Words(tree, set())
        texts = [words.of_motion(box) if isinstance(box, MotionBox) else words.of_object(box) for box in scene.boxes]
        sizes = [_size(box, lines) for box, lines in zip(scene.boxes, texts, strict=True)]
        phases = phases_of(scene)
        layout = banded(sizes, scene.arrows, phases) if len(set(phases)) > 1 else None
        foods = foods_of(scene, kitchen)
        placed = layout or layered(sizes, scene.arrows)
        return cls(tree, scene, texts, sizes, placed, phases if layout else (), foods, head)

    def drawn(self) -> ET.Element:
        width, height = self.layout.size
        headed = self.head == _HEAD
        told = max(_legend_width(self.tree), text_width(self.tree.title, 18)) if headed else 0.0
        wide = max(width, told) + 2 * _EDGE
        root = picture(wide, height + self.head + _EDGE, f"Task tree: {self.tree.title}")
        _arrow_head(root)
        if headed:
            write_line(root, Line(self.tree.title, "name", 18, bold=True), _EDGE, 32, anchor="start")
            _draw_legend(root, self.tree)
        self._draw_bands(root, wide)
        stage = ET.SubElement(root, "g", transform=f"translate({(wide - width) / 2:.1f} {self.head:g})")
        for arrow in self.scene.arrows:
            self._draw_arrow(stage, arrow)
        for place in range(len(self.scene.boxes)):
            self._draw_box(stage, place)
        return root

    def _draw_bands(self, root: ET.Element, wide: float) -> None:
        """Draw what is made ready, cooked and served as bands from side to side, each with its name."""
        ends = [
            (phase, y + self.head - height / 2, y + self.head + height / 2)
            for phase, (_, y), (_, height) in zip(
                self.phases, self.layout.middles, self.sizes, strict=bool(self.phases)
            )
        ]
        for phase in sorted(set(self.phases)):
            top = min(top for own, top, _ in ends if own == phase) - LAYER_GAP / 2
            height = max(bottom for own, _, bottom in ends if own == phase) + LAYER_GAP / 2 - top
            if phase % 2 == 0:
                element(root, "rect", {"x": 0, "y": top, "width": wide, "height": height}, "band")
            turned = ET.SubElement(root, "g", transform=f"translate(15 {number(top + height / 2)}) rotate(-90)")
            write_line(turned, Line(_BANDS[phase], "aside", 11), 0, 0)

    def _draw_arrow(self, stage: ET.Element, arrow: tuple[int, int]) -> None:
        (x, y), (to_x, to_y) = (self.layout.middles[place] for place in arrow)
        start, end = (x, y + self.sizes[arrow[0]][1] / 2), (to_x, to_y - self.sizes[arrow[1]][1] / 2)
        path = _curve([start, *self.layout.ways[arrow], end])
        way = element(stage, "path", {"d": path, "stroke-width": 1.3, "marker-end": "url(#way-end)"}, "way")
        _name_foods(way, self.foods[arrow[0]] & self.foods[arrow[1]])

    def _draw_box(self, stage: ET.Element, place: int) -> None:
        box, (x, y), (width, height) = self.scene.boxes[place], self.layout.middles[place], self.sizes[place]
        group = ET.SubElement(stage, "g")
        if isinstance(box, MotionBox):
            group.set("data-step", str(box.number))
        _name_foods(group, self.foods[place])
        ET.SubElement(group, "title").text = writable(self._told(box))
        attributes: dict[str, object] = {"x": x - width / 2, "y": y - height / 2, "width": width, "height": height}
        element(group, "rect", attributes | _manner(box, self.tree.unseen), *_paint(box, self.tree.unseen))
        write_lines(group, self.texts[place], x, y - height_of(self.texts[place]) / 2)

    def _told(self, box: ObjectBox | MotionBox) -> str:
        if isinstance(box, ObjectBox):
            return str(box.node)
        seen = ", ".join(dict.fromkeys(one.video for one in box.unit.sightings))
        return f"{box.number}. {box.unit.motion}" + (f" (seen in {seen})" if seen else "")


@dataclass(frozen=True)
class _Words:
    """The text of each box; what a mixture holds is told where it is first made (``told``), as in the terminal."""

    tree: ShownTree
    told: set[tuple[str, tuple[str, ...]]]

    def of_object(self, box: ObjectBox) -> list[Line]:
        node = box.node
        lines = self._name(node)
        lines += [Line(line, "state", 12) for line in wrapped(", ".join(node.states), _TEXT_WIDTH, 12) if line]
        for one in self.tree.substitutions:
            if one.kind == "state" and one.object == node.label and one.required in node.states:
                lines += self._once(one)
        lines += self._contents(node)
        if node.container:
            lines.append(Line(f"{node.relation or 'at'} {node.container}", "aside", 11))
        return lines

    def _name(self, node: ObjectNode) -> list[Line]:
        """Return what a node is called; where the FOON has never seen it, what it is like as well."""
        like = self.tree.unseen.get(node.label)
        if like is None:
            return [Line(line, "name", 13, bold=True) for line in wrapped(node.label, _TEXT_WIDTH, 13)]
        return [Line(UNSEEN_SIGN + node.label, "unseen", 13, bold=True), *self._once(like)]

    def _once(self, one: Substitution) -> list[Line]:
        """Tell an equivalent where it is first met."""
        if (one.kind, (one.object, one.required)) in self.told:
            return []
        self.told.add((one.kind, (one.object, one.required)))
        what = f"{one.required} " if one.kind == "state" else ""
        return [Line(f"{what}like {one.equivalent} {one.confidence:.2f}", "unseen", 11)]

    def _contents(self, node: ObjectNode) -> list[Line]:
        contents = (node.label, node.ingredients)
        if not node.ingredients or node.ingredients == (node.label,) or contents in self.told:
            return []
        self.told.add(contents)
        names = ", ".join(UNSEEN_SIGN * (name in self.tree.unseen) + name for name in node.ingredients)
        return [Line(line, "aside", 11) for line in wrapped(f"with {names}", _TEXT_WIDTH, 11)]

    def of_motion(self, box: MotionBox) -> list[Line]:
        lines = [Line(f"{box.number} {motion_said(box.unit.motion)}", "verb", 13, bold=True)]
        if box.tools:
            tools = wrapped(", ".join(box.tools), _TEXT_WIDTH, 10.5, most=2)
            lines += [Line(line, "aside", 10.5) for line in tools]
        labels = {node.label for node in box.unit.input_nodes}
        for one in self.tree.substitutions:
            if (one.kind, one.required) == ("motion", box.unit.motion) and one.object in labels:
                lines += self._once(one)
        return lines


def _size(box: ObjectBox | MotionBox, lines: Sequence[Line]) -> tuple[float, float]:
    width = max(line.width for line in lines) + (20 if isinstance(box, ObjectBox) else 24)
    return max(width, 56.0), height_of(lines) + (10 if isinstance(box, ObjectBox) else 8)


def _paint(box: ObjectBox | MotionBox, unseen: Mapping[str, Substitution]) -> tuple[str, ...]:
    if isinstance(box, MotionBox):
        return ("motion",)
    kind = _PAINT[box.part]
    return (kind, "unseen-box") if box.node.label in unseen else (kind,)


def _manner(box: ObjectBox | MotionBox, unseen: Mapping[str, Substitution]) -> dict[str, object]:
    if isinstance(box, MotionBox):
        changed = box.unit.origin == "adapted"
        return {"rx": 2, "stroke-width": 1.4} | ({"stroke-dasharray": _DASHED} if changed else {})
    strange = not unseen.keys().isdisjoint((box.node.label, *box.node.ingredients))
    return {"rx": _ROUND[box.part], "stroke-width": 1.3} | ({"stroke-dasharray": _DASHED} if strange else {})


def _name_foods(drawn: ET.Element, foods: Collection[str]) -> None:
    """Write the names of foods to what is drawn of them, for a page that follows one."""
    if foods:
        drawn.set("data-foods", writable("\n".join(sorted(foods))))


def _curve(points: Sequence[Point]) -> str:
    """Return a path that leaves and enters every point straight down."""
    path, (x, y) = [f"M{number(points[0][0])} {number(points[0][1])}"], points[0]
    for to_x, to_y in points[1:]:
        if to_y - y < _NOTHING:
            continue  # an arrow head would point nowhere
        if abs(to_x - x) < _NOTHING:
            path.append(f"V{number(to_y)}")
        else:
            middle, end = number((y + to_y) / 2), number(to_x)
            path.append(f"C{number(x)} {middle} {end} {middle} {end} {number(to_y)}")
        x, y = to_x, to_y
    return "".join(path)


def _arrow_head(root: ET.Element) -> None:
    size = {"id": "way-end", "viewBox": "0 0 8 8", "refX": "8", "refY": "4"}
    marker = ET.SubElement(
        ET.SubElement(root, "defs"), "marker", size, markerWidth="7", markerHeight="7", orient="auto"
    )
    element(marker, "path", {"d": "M0 0.5L8 4L0 7.5Z"}, "way-end")


def _legend(tree: ShownTree) -> Sequence[tuple[str, str]]:
    """Return what a reader of this tree meets; FOON text is as it is."""
    origins = {unit.origin for unit in tree.units}
    there = {
        "kitchen": True,
        "object": True,
        "motion": tree.result is not None,
        "changed": "adapted" in origins,
        "unseen-box": bool(tree.unseen),
    }
    return [(kind, text) for kind, text in _LEGEND if there[kind]]


def _legend_width(tree: ShownTree) -> float:
    return sum(text_width(text, 11) + 40 for _, text in _legend(tree))


def _draw_legend(root: ET.Element, tree: ShownTree) -> None:
    x = _EDGE
    for kind, text in _legend(tree):
        shape: dict[str, object] = {"x": x, "y": 46, "width": 16, "height": 11, "rx": 3}
        if kind in {"unseen-box", "changed"}:
            shape["stroke-dasharray"] = "3 2"
        element(root, "rect", shape, "motion" if kind == "changed" else kind)
        write_line(root, Line(text, "aside", 11), x + 22, 55.5, anchor="start")
        x += text_width(text, 11) + 40
