"""Small FOONs with a question each, for the property tests of the search."""

from hypothesis import strategies as st

from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode, Participant
from foon_kg.search import SearchProblem, UnitIndex

NODES = [ObjectNode(name) for name in "abcdefghij"]


def unit(inputs, outputs, motion="do"):
    sides = (tuple(Participant(node) for node in side) for side in (inputs, outputs))
    return KnownUnit(FunctionalUnit(next(sides), motion, next(sides)), ())


@st.composite
def problems(draw, max_units=9, max_nodes=8) -> SearchProblem:
    """Small FOONs with cycles, sharing, several outputs, unreachable objects, and kitchen nodes that are also made."""
    nodes = NODES[: draw(st.integers(3, max_nodes))]
    side = st.lists(st.sampled_from(nodes), min_size=1, max_size=3, unique=True)
    units = draw(st.lists(st.builds(unit, side, side, st.sampled_from(["cut", "mix"])), min_size=1, max_size=max_units))
    there = draw(st.sets(st.sampled_from(nodes), max_size=3))
    costs = draw(st.dictionaries(st.sampled_from(nodes), st.sampled_from([1, 1, 2, 5]), max_size=4))
    index = UnitIndex.of(units, at_hand=there.__contains__, gap_cost=costs.get)
    return SearchProblem(
        index=index,
        targets=tuple(draw(st.lists(st.sampled_from(nodes), min_size=1, max_size=2))),
        wanted=draw(st.dictionaries(st.sampled_from([n.label for n in nodes]), st.integers(0, 3), max_size=5)),
        available=frozenset(draw(st.sets(st.sampled_from(nodes), max_size=1))),
    )


@st.composite
def deep_problems(draw) -> SearchProblem:
    """FOONs whose trees are long: each node is made of earlier ones, with a few units that go back."""
    count = draw(st.integers(5, 9))
    units = []
    for made in range(1, count):
        for _ in range(draw(st.integers(1, 2))):
            inputs = draw(st.lists(st.sampled_from(NODES[:made]), min_size=1, max_size=2, unique=True))
            beside = draw(st.lists(st.sampled_from(NODES[1:count]), max_size=1))
            back = draw(st.lists(st.sampled_from(NODES[1:count]), max_size=draw(st.integers(0, 1))))
            units.append(unit([*inputs, *back], [NODES[made], *beside], draw(st.sampled_from(["cut", "mix", "fry"]))))
    index = UnitIndex.of(
        units,
        at_hand={NODES[0]}.__contains__,
        gap_cost=draw(st.dictionaries(st.sampled_from(NODES[1:count]), st.sampled_from([1, 3, 9]), max_size=3)).get,
    )
    wanted = draw(st.dictionaries(st.sampled_from("bcdefghi"), st.integers(0, 5), max_size=4))
    return SearchProblem(index, (NODES[count - 1],), wanted)
