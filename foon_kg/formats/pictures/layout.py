"""Where the boxes of a picture stand: layers from top to bottom, few crossings, straight ways.

Layers and the order within them are found by ``fast_sugiyama`` (network simplex; Gansner et al., 1993): over 30 plans
of the public recipes it left 9 crossings where ``pyelk`` 0.3, which does not order long arrows, left 129. Places
within a layer are then found here, as that library knows of one width only: each layer is put as close to its
neighbours as the order and the widths allow, which is isotonic regression (pool adjacent violators).
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import cast

import fast_sugiyama

Point = tuple[float, float]
Size = tuple[float, float]
_Drawn = tuple[Sequence[tuple[int, Point]], float, float, Sequence[tuple[int, int]] | None]
"""A part as the library answers it: where each box and each bend of an arrow stands, and all links between those."""

GAP = 18.0
"""Between two boxes of a layer."""
LAYER_GAP = 30.0
ROW = 2400.0
"""How wide a row of parts is at most, as a rule."""
_WAY_GAP = 10.0
_SWEEPS = 60  # half of them from one side alone, which brings boxes near; then from both, which lets them rest
_STRAIGHT = 6.0  # a long arrow is pulled straight more strongly than a box is pulled under another


@dataclass(frozen=True)
class Layout:
    """The middle of every box, the points through which each arrow goes between its boxes, and the whole size.

    An arrow is to run straight down to its first point, and turn only between one pair of points and the next.
    """

    middles: tuple[Point, ...]
    ways: Mapping[tuple[int, int], tuple[Point, ...]]
    size: Size


def layered(
    sizes: Sequence[Size],
    arrows: Sequence[tuple[int, int]],
    row: float = ROW,
) -> Layout:
    """Place boxes of these ``sizes``; ``arrows`` lead from a box to one that stands in a lower layer.

    Every box must be at an end of some arrow. Parts without connection stand side by side, in rows of ``row``
    (a part that is wider has a row of its own).
    """
    parts = cast("list[_Drawn]", fast_sugiyama.from_edges(list(arrows), dummy_vertices=True, vertex_spacing=1))
    middles: dict[int, Point] = {}
    ways: dict[tuple[int, int], tuple[Point, ...]] = {}
    left, top, width, depth = 0.0, 0.0, 0.0, 0.0
    for positions, _, _, drawn in sorted(parts, key=lambda part: min(number for number, _ in part[0])):
        part = _Part.of(positions, drawn or (), sizes)
        across = part.across()
        if left and left + part.width(across) > row:
            left, top = 0.0, depth + 3 * GAP
        places, reach, size = part.placed(across, left, top, part.heights())
        middles.update({number: place for number, place in places.items() if number < len(sizes)})
        ways.update(part.ways(places, reach))
        width, depth = max(width, left + size[0]), max(depth, top + size[1])
        left += size[0] + 3 * GAP
    return Layout(tuple(middles[i] for i in range(len(sizes))), ways, (width, depth))


def banded(sizes: Sequence[Size], arrows: Sequence[tuple[int, int]], bands: Sequence[int]) -> Layout | None:
    """Return where boxes of these ``sizes`` stand so that all of one band are above all of the next.

    ``arrows`` lead from box to box, by their places; ``bands`` has a number for each box. Within its band a box stands
    as low as what follows it allows. ``None`` where an arrow leads back.
    """
    if any(bands[one] > bands[other] for one, other in arrows):
        return None
    layers, top = [0] * len(sizes), 0
    for band in sorted(set(bands)):
        heights = _heights([place for place, own in enumerate(bands) if own == band], arrows)
        top += max(heights.values()) + 1
        for place, height in heights.items():
            layers[place] = top - 1 - height
    return _in_layers(sizes, arrows, layers)


def _in_layers(sizes: Sequence[Size], arrows: Sequence[tuple[int, int]], layers: Sequence[int]) -> Layout:
    """Place boxes in these ``layers`` (from 0 down), which all parts share; the parts stand side by side."""
    parts = list(_parts_in_layers(sizes, arrows, layers))
    heights = [0.0] * (max(layers) + 1)
    for first, part in parts:
        for row, height in enumerate(part.heights()):
            heights[first + row] = max(heights[first + row], height)
    tops = [0.0, *itertools.accumulate(height + LAYER_GAP for height in heights)]
    middles: dict[int, Point] = {}
    ways: dict[tuple[int, int], tuple[Point, ...]] = {}
    left = 0.0
    for first, part in parts:
        across = part.across()
        places, reach, size = part.placed(across, left, tops[first], heights[first : first + len(part.layers)])
        middles.update({number: place for number, place in places.items() if number < len(sizes)})
        ways.update(part.ways(places, reach))
        left += size[0] + 3 * GAP
    return Layout(tuple(middles[i] for i in range(len(sizes))), ways, (left - 3 * GAP, tops[-1] - LAYER_GAP))


def _parts_in_layers(
    sizes: Sequence[Size], arrows: Sequence[tuple[int, int]], layers: Sequence[int]
) -> Iterator[tuple[int, _Part]]:
    """Yield the connected parts from the one with the first box on, each with the layer in which it begins."""
    links = list(_divided(arrows, layers, len(sizes)))
    drawn = cast("list[_Drawn]", fast_sugiyama.from_edges(links, dummy_vertices=True, vertex_spacing=1))
    for positions, _, _, own in sorted(drawn, key=lambda part: min(number for number, _ in part[0])):
        part = _Part.of(positions, own or (), sizes)
        yield min(layers[n] - row for row, layer in enumerate(part.layers) for n in layer if n < len(sizes)), part


def _heights(boxes: Sequence[int], arrows: Sequence[tuple[int, int]]) -> dict[int, int]:
    """Return how many layers above the lowest of its band each box stands, by network simplex within the band."""
    heights = dict.fromkeys(boxes, 0)
    inside = [arrow for arrow in arrows if heights.keys() >= set(arrow)]
    if not inside:
        return heights
    names = list(dict.fromkeys(itertools.chain.from_iterable(inside)))  # the library adds numbers after these
    numbers = {box: number for number, box in enumerate(names)}
    links = [(numbers[one], numbers[other]) for one, other in inside]
    for positions, _, _, _ in cast("list[_Drawn]", fast_sugiyama.from_edges(links, dummy_vertices=True)):
        rows = sorted({y for _, (_, y) in positions})
        heights.update({names[number]: rows.index(y) for number, (_, y) in positions if number < len(names)})
    return heights


def _divided(arrows: Sequence[tuple[int, int]], layers: Sequence[int], free: int) -> Iterator[tuple[int, int]]:
    """Yield links of one layer each: what is between the ends of a long arrow is numbered from ``free`` on."""
    numbers = itertools.count(free)
    for one, other in arrows:
        between = list(itertools.islice(numbers, layers[other] - layers[one] - 1))
        yield from itertools.pairwise((one, *between, other))


@dataclass(frozen=True)
class _Part:
    """One connected part: its layers from the top, each from left to right, with places on long arrows between."""

    layers: tuple[tuple[int, ...], ...]
    links: tuple[tuple[int, int], ...]
    sizes: Mapping[int, Size]
    boxes: int

    @classmethod
    def of(
        cls, positions: Sequence[tuple[int, Point]], links: Sequence[tuple[int, int]], sizes: Sequence[Size]
    ) -> _Part:
        rows: dict[float, list[tuple[float, int]]] = {}
        for number, (x, y) in positions:
            rows.setdefault(y, []).append((x, number))
        layers = tuple(tuple(number for _, number in sorted(rows[y])) for y in sorted(rows, reverse=True))
        known = {n: sizes[n] if n < len(sizes) else (0.0, 0.0) for layer in layers for n in layer}
        return cls(layers, tuple(sorted(links)), known, len(sizes))

    def width(self, across: Mapping[int, float]) -> float:
        """Return how wide the part is when its boxes stand so far to the right."""
        return max(across[n] + self.sizes[n][0] / 2 for n in across) - self._start(across)

    def _start(self, across: Mapping[int, float]) -> float:
        return min(across[n] - self.sizes[n][0] / 2 for n in across)

    def placed(
        self, across: Mapping[int, float], left: float, top: float, heights: Sequence[float]
    ) -> tuple[dict[int, Point], dict[int, Point], Size]:
        """Return the middle of each box, from where to where down its layer reaches, and the size of the part.

        ``heights`` has the height of each of its layers.
        """
        start, first = self._start(across), top
        places, reach = {}, {}
        for layer, height in zip(self.layers, heights, strict=True):
            places.update({n: (across[n] - start + left, top + height / 2) for n in layer})
            reach.update(dict.fromkeys(layer, (top, top + height)))
            top += height + LAYER_GAP
        return places, reach, (self.width(across), top - LAYER_GAP - first)

    def heights(self) -> list[float]:
        """Return the height of the highest box of each layer."""
        return [max(self.sizes[n][1] for n in layer) for layer in self.layers]

    def across(self) -> dict[int, float]:
        """Return how far to the right every box stands: sweep down and up until the layers lie well."""
        above, below = self._pulls()
        both = {n: above[n] + below[n] for n in self.sizes}
        across: dict[int, float] = {}
        for layer in self.layers:
            across.update(zip(layer, _settle([0.0] * len(layer), [1.0] * len(layer), self._gaps(layer)), strict=True))
        for sweep in range(_SWEEPS):
            down = sweep % 2 == 0
            near = both if sweep >= _SWEEPS // 2 else above if down else below
            for layer in self.layers if down else reversed(self.layers):
                self._pull(layer, near, across)
        return across

    def _pulls(self) -> tuple[dict[int, list[tuple[int, float]]], dict[int, list[tuple[int, float]]]]:
        """Return for each box what pulls at it from above and from below, and how strongly."""
        above: dict[int, list[tuple[int, float]]] = {n: [] for n in self.sizes}
        below: dict[int, list[tuple[int, float]]] = {n: [] for n in self.sizes}
        for upper, lower in self.links:
            pull = _STRAIGHT ** ((upper >= self.boxes) + (lower >= self.boxes))
            below[upper].append((lower, pull))
            above[lower].append((upper, pull))
        return above, below

    def _pull(
        self, layer: Sequence[int], near: Mapping[int, list[tuple[int, float]]], across: dict[int, float]
    ) -> None:
        weights = [sum(pull for _, pull in near[n]) or 0.01 for n in layer]
        wishes = [
            sum(across[other] * pull for other, pull in near[n]) / weight if near[n] else across[n]
            for n, weight in zip(layer, weights, strict=True)
        ]
        across.update(zip(layer, _settle(wishes, weights, self._gaps(layer)), strict=True))

    def _gaps(self, layer: Sequence[int]) -> list[float]:
        def gap(one: int, other: int) -> float:
            free = GAP if one < self.boxes and other < self.boxes else _WAY_GAP
            return (self.sizes[one][0] + self.sizes[other][0]) / 2 + free

        return [gap(one, other) for one, other in itertools.pairwise(layer)]

    def ways(self, places: Mapping[int, Point], reach: Mapping[int, Point]) -> dict[tuple[int, int], tuple[Point, ...]]:
        """Return the points of every arrow: where it leaves its layer, enters and leaves each other, and arrives."""
        following = {upper: lower for upper, lower in self.links if upper >= self.boxes}
        ways = {}
        for upper, lower in self.links:
            if upper >= self.boxes:
                continue
            points, end = [(places[upper][0], reach[upper][1])], lower
            while end >= self.boxes:
                points += [(places[end][0], edge) for edge in reach[end]]
                end = following[end]
            ways[upper, end] = (*points, (places[end][0], reach[end][0]))
        return ways


def _settle(wishes: Sequence[float], weights: Sequence[float], gaps: Sequence[float]) -> list[float]:
    """Return the places closest to ``wishes`` (weighted squares) that keep the order and at least these ``gaps``."""
    offsets = [0.0, *itertools.accumulate(gaps)]
    blocks: list[list[float]] = []  # mean, weight, length
    for wish, weight, offset in zip(wishes, weights, offsets, strict=True):
        blocks.append([wish - offset, weight, 1])
        while len(blocks) > 1 and blocks[-2][0] >= blocks[-1][0]:
            mean, more, length = blocks.pop()
            total = blocks[-1][1] + more
            blocks[-1] = [(blocks[-1][0] * blocks[-1][1] + mean * more) / total, total, blocks[-1][2] + length]
    means = itertools.chain.from_iterable(itertools.repeat(mean, int(length)) for mean, _, length in blocks)
    return [mean + offset for mean, offset in zip(means, offsets, strict=True)]
