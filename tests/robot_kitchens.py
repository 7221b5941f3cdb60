"""Small FOONs for robots, with every tree of them: what a retrieval must answer, found by trying all sets of units."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable
from fractions import Fraction

from hypothesis import strategies as st
from kitchen_stories import node

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Subgraph
from foon_kg.model.levels import Level
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.stock import StockedKitchen
from foon_kg.search.classic import Criterion, GoalSought

NODES = (
    *map(node, ("onion(whole)", "onion(chopped)", "onion(chopped)@bowl", "bowl(empty)", "egg(whole)", "egg(beaten)")),
    ObjectNode("knife"),
    ObjectNode("bowl", (), ("onion",)),
    ObjectNode("bowl", (), ("egg", "onion")),
    ObjectNode("salad", ("mixed",), ("onion",)),
    ObjectNode("salad", ("mixed",), ("egg", "onion")),
    ObjectNode("salad", ("mixed", "chilled"), ("onion",), "in", "bowl"),
)
LADDER = (
    *map(node, ("onion(whole)", "onion(chopped)", "onion(chopped)@bowl", "egg(beaten)")),
    ObjectNode("bowl", ("full",), ("onion",)),
    ObjectNode("bowl", ("full",), ("egg", "onion")),
    ObjectNode("salad", ("mixed", "chilled"), ("onion",), "in", "bowl"),
)
MOTIONS = ("chop", "mix", "pour", "shake")

_sides = st.lists(st.sampled_from(NODES), min_size=1, max_size=3, unique=True)
units = st.builds(
    lambda inputs, motion, outputs: FunctionalUnit(
        tuple(map(Participant, inputs)), motion, tuple(map(Participant, outputs))
    ),
    _sides,
    st.sampled_from(MOTIONS),
    _sides,
)
goals = st.sampled_from(
    (("salad", ()), ("salad", ("mixed",)), ("salad", ("chilled",)), ("onion", ("chopped",)), ("bowl", ()), ("egg", ()))
)
costs = st.dictionaries(
    st.sampled_from(MOTIONS), st.sampled_from((0, 0.0, 0.1, 0.7, 0.91, 0.5, 0.25, 1)), min_size=1
).map(MotionCosts)
kitchens = st.sampled_from(
    (
        Kitchen.default(),
        StockedKitchen.of(Kitchen.default(), [node("onion(whole)")]),
        StockedKitchen.of(Kitchen.default(), [node("egg(beaten)"), node("knife")]),
    )
)


@st.composite
def foons(draw: st.DrawFn) -> list[Subgraph]:
    """Up to seven units in two videos; a unit may be in both."""
    chosen = draw(st.lists(units, min_size=1, max_size=7))
    again = draw(st.lists(st.sampled_from(chosen), max_size=2))
    return [Subgraph(name, tuple(map(Annotation, some))) for name, some in (("a", chosen), ("b", again))]


@st.composite
def deep_foons(draw: st.DrawFn) -> list[Subgraph]:
    """FOONs whose trees are long: each node is made of the ones before it, with ways round and units that go back."""
    ladder = draw(st.permutations(LADDER[1:-1]).map(lambda nodes: (LADDER[0], *nodes, LADDER[-1])))
    made = []
    places = range(1, len(ladder))
    for place in (*places, *draw(st.lists(st.sampled_from(places), max_size=4))):
        before = draw(st.lists(st.sampled_from(ladder[:place]), max_size=1))
        back = draw(st.lists(st.sampled_from(ladder[1:]), max_size=draw(st.integers(0, 1))))
        beside = draw(st.lists(st.sampled_from(ladder[1:]), max_size=1))
        inputs = dict.fromkeys([draw(st.sampled_from(ladder[max(0, place - 2) : place])), *before, *back])
        sides = (tuple(map(Participant, side)) for side in (inputs, dict.fromkeys([ladder[place], *beside])))
        made.append(FunctionalUnit(next(sides), draw(st.sampled_from(MOTIONS)), next(sides)))
    return [Subgraph("a", tuple(map(Annotation, made)))]


def sought(goal: tuple[str, tuple[str, ...]], level: Level, by: Criterion) -> GoalSought:
    """Ask for a goal; at level 1 for its label alone."""
    label, states = goal
    return GoalSought(label, () if level is Level.OBJECTS else states, level=level, by=by)


def stripped(thing: ObjectNode, level: Level) -> ObjectNode:
    """What level 1, 2 and 3 see of an object node, in words of its own."""
    if level == 3:
        return thing
    return ObjectNode(thing.label, thing.states if level == 2 else (), (), *(_place(thing) if level == 2 else ()))


def _place(thing: ObjectNode) -> tuple[str | None, str | None]:
    return thing.relation, thing.container


def best_of_all(
    subgraphs: Iterable[Subgraph], asked: GoalSought, kitchen: Kitchen, costs: MotionCosts
) -> tuple[ObjectNode, list[str]] | None:
    """The goal and the sorted keys of the units of the best tree, or None: every set of units is tried."""
    level = asked.level
    foon = [annotation.unit for subgraph in subgraphs for annotation in subgraph.annotations]
    nodes = {n for u in foon for n in (*u.input_nodes, *u.output_nodes)}
    at_hand = {stripped(n, level) for n in nodes if kitchen.has(n)}
    distinct = {u.key: u for u in (_stripped_unit(u, level) for u in foon)}
    usable = [u for u in distinct.values() if asked.by is Criterion.UNITS or costs.success(u.motion)]
    found = []
    for goal in {stripped(n, level) for n in nodes if asked.fits(n)}:
        for some in _subsets(usable):
            if _makes(some, at_hand - {goal}, goal):
                keys = sorted(u.key for u in some)
                product = math.prod((costs.success(u.motion) for u in some), start=Fraction(1))
                worth = (-product if asked.by is Criterion.SUCCESS else 0, len(some), keys, goal.sort_key)
                found.append((worth, goal, keys))
    return min(found)[1:] if found else None


def _stripped_unit(unit: FunctionalUnit, level: Level) -> FunctionalUnit:
    inputs, outputs = (
        tuple(Participant(stripped(n, level)) for n in side) for side in (unit.input_nodes, unit.output_nodes)
    )
    return FunctionalUnit(inputs, unit.motion, outputs)


def _subsets(items: list[FunctionalUnit]) -> Iterable[tuple[FunctionalUnit, ...]]:
    items = [u for u in items if not set(u.output_nodes) <= set(u.input_nodes)]  # C3: each makes something
    return itertools.chain.from_iterable(itertools.combinations(items, n) for n in range(1, len(items) + 1))


def _makes(some: tuple[FunctionalUnit, ...], there: set[ObjectNode], goal: ObjectNode) -> bool:
    """Whether all of ``some`` can be run from ``there``, one after another, and the goal is made."""
    if not any(goal in u.output_nodes for u in some):
        return False
    have, waiting = set(there), list(some)
    while waiting:
        still = []
        for u in waiting:
            if have.issuperset(u.input_nodes):
                have.update(u.output_nodes)
            else:
                still.append(u)
        if len(still) == len(waiting):
            return False
        waiting = still
    return True
