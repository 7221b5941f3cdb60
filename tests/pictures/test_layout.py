"""Boxes of a picture do not lie on each other, arrows run downwards, and the same tree is drawn the same twice."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

pytest.importorskip("fast_sugiyama", reason="the extra “pictures” is not installed")
from foon_kg.formats.pictures.layout import GAP, _settle, banded, layered

NEARLY = 1e-6


@st.composite
def graphs(draw):
    """Boxes of many sizes with arrows from earlier to later ones; every box has an arrow."""
    count = draw(st.integers(2, 14))
    sizes = draw(st.lists(st.tuples(st.integers(10, 200), st.integers(10, 60)), min_size=count, max_size=count))
    pairs = st.tuples(st.integers(0, count - 1), st.integers(0, count - 1)).filter(lambda p: p[0] < p[1])
    arrows = set(draw(st.lists(pairs, max_size=20)))
    for box in range(count):
        if not any(box in arrow for arrow in arrows):
            arrows.add((0, box) if box else (0, 1))
    return [(float(w), float(h)) for w, h in sizes], sorted(arrows)


def sides(middle, size):
    (x, y), (width, height) = middle, size
    return x - width / 2, x + width / 2, y - height / 2, y + height / 2


@settings(max_examples=40)
@given(graphs(), st.sampled_from([100.0, 300.0, 2400.0]))
def test_boxes_stand_apart_and_inside_the_picture(graph, row):
    sizes, arrows = graph
    layout = layered(sizes, arrows, row)
    boxes = [sides(middle, size) for middle, size in zip(layout.middles, sizes, strict=True)]
    for left, right, top, bottom in boxes:
        assert -NEARLY <= left < right <= layout.size[0] + NEARLY
        assert -NEARLY <= top < bottom <= layout.size[1] + NEARLY
    for one, other in itertools.combinations(boxes, 2):
        beside = one[1] + GAP <= other[0] + NEARLY or other[1] + GAP <= one[0] + NEARLY
        assert beside or one[3] <= other[2] or other[3] <= one[2]


@settings(max_examples=40)
@given(graphs())
def test_every_arrow_runs_down_from_its_box_to_the_other(graph):
    sizes, arrows = graph
    layout = layered(sizes, arrows)
    assert set(layout.ways) == set(arrows)
    for (one, other), points in layout.ways.items():
        start = layout.middles[one][1] + sizes[one][1] / 2
        end = layout.middles[other][1] - sizes[other][1] / 2
        heights = [start, *(y for _, y in points), end]
        assert all(a <= b + NEARLY for a, b in itertools.pairwise(heights))
        assert points[0][0] == layout.middles[one][0]
        assert points[-1][0] == layout.middles[other][0]


def test_parts_without_connection_stand_in_rows():
    sizes, arrows = [(100.0, 20.0)] * 6, [(0, 1), (2, 3), (4, 5)]
    beside, two_rows, three_rows = (layered(sizes, arrows, row) for row in (2400.0, 300.0, 100.0))
    width, height = beside.size
    assert two_rows.size[0] < width
    assert height < two_rows.size[1] < three_rows.size[1]
    assert three_rows.size[0] == 100.0


@settings(max_examples=40)
@given(graphs())
def test_the_same_graph_is_laid_out_the_same(graph):
    assert layered(*graph) == layered(*graph)


wishes = st.lists(st.tuples(st.integers(-50, 50), st.integers(1, 9), st.integers(0, 30)), min_size=1, max_size=9)


@given(wishes)
def test_places_are_the_closest_to_what_was_wished(rows):
    desired, weights, gaps = ([float(row[i]) for row in rows] for i in range(3))
    gaps = gaps[1:]
    offsets = [0.0, *itertools.accumulate(gaps)]
    free = [wish - offset for wish, offset in zip(desired, offsets, strict=True)]

    def mean(first, last):
        heavy = weights[first : last + 1]
        return sum(f * w for f, w in zip(free[first : last + 1], heavy, strict=True)) / sum(heavy)

    def exact(i):  # the minimax formula of isotonic regression
        return max(min(mean(j, k) for k in range(i, len(free))) for j in range(i + 1))

    expected = [exact(i) + offset for i, offset in enumerate(offsets)]
    assert _settle(desired, weights, gaps) == pytest.approx(expected)


@st.composite
def in_bands(draw):
    """Boxes with arrows as above, each in a band that is not above that of any box before it."""
    sizes, arrows = draw(graphs())
    steps = draw(st.lists(st.integers(0, 1), min_size=len(sizes), max_size=len(sizes)))
    return sizes, arrows, list(itertools.accumulate(steps))


LINKS = "0-1 2-3 3-4 4-5 1-6 6-7 7-8 5-9 8-10 9-10 7-11 10-12 11-13 12-13 13-14"
ONE_SALAD = (
    [(60.0, 30.0)] * 15,
    [tuple(map(int, one.split("-"))) for one in LINKS.split()],
    [0] * 7 + [1, 1, 0] + [1] * 5,
)
"""The lower band has a long arrow and numbers that are not the first ones."""


@settings(max_examples=100)
@example(ONE_SALAD)
@given(in_bands())
def test_all_of_a_band_stands_above_all_of_the_next(graph):
    sizes, arrows, bands = graph
    layout = banded(sizes, arrows, bands)
    boxes = [sides(middle, size) for middle, size in zip(layout.middles, sizes, strict=True)]
    for one, other in itertools.permutations(range(len(sizes)), 2):
        if bands[one] < bands[other]:
            assert boxes[one][3] < boxes[other][2]
    for left, right, top, bottom in boxes:
        assert -NEARLY <= left < right <= layout.size[0] + NEARLY
        assert -NEARLY <= top < bottom <= layout.size[1] + NEARLY
    for one, other in itertools.combinations(boxes, 2):
        beside = one[1] + GAP <= other[0] + NEARLY or other[1] + GAP <= one[0] + NEARLY
        assert beside or one[3] <= other[2] or other[3] <= one[2]
    assert set(layout.ways) == set(arrows)
    for (one, other), points in layout.ways.items():
        heights = [boxes[one][3], *(y for _, y in points), boxes[other][2]]
        assert all(a <= b + NEARLY for a, b in itertools.pairwise(heights))
        assert (points[0][0], points[-1][0]) == (layout.middles[one][0], layout.middles[other][0])


def test_bands_in_which_an_arrow_leads_back_are_none():
    assert banded([(10.0, 10.0), (10.0, 10.0)], [(0, 1)], [1, 0]) is None
