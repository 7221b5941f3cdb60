"""FOONs of any size with the shape of a real one, and how close their shape is.

    python benchmarks/big_foon.py [--units N ...] [--folder FOLDER]

A large FOON is made of *cuisines*. Each is the real FOON (by default the subgraphs beside the checkout) with other
foods: a video, its order, motions, utensils and states stay. What nobody makes keeps its name and is shared by all
cuisines; every other food gets a new name in each, the same wherever it occurs, and utensils in use tell their cuisine.
So producers an object, depth, sharing, dish types and what is at hand are nearly the real ones; the shape that results
is printed beside that of the real FOON.

That is the kindest way to grow. Where any food or used spoon may be shared, all cuisines soon lie behind each other,
half of 20,000 units behind every goal (and so real FOONs may grow: at 55 videos 83 units lie behind a goal in the
middle, at 111 videos 434). Words grow faster here than among real videos, whose labels grow by Heaps' law.
"""

from __future__ import annotations

import argparse
import math
import random
import statistics
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from foon_kg.food import singular
from foon_kg.loaders import read_paths
from foon_kg.model import FunctionalUnit, ObjectNode, Participant, Subgraph
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot

SHARED = Path(__file__).parents[1].parent / "shared" / "data" / "foon-111" / "TXT"
KITCHEN = Kitchen.default()
SAMPLE = 200
"""How many goals' closures are measured."""
KEY_DIGITS = 15
"""So much of a key tells units apart, and is a small number."""


def real_subgraphs(folder: Path = SHARED) -> list[Subgraph]:
    return [result.subgraph for result in read_paths([folder]) if result.subgraph is not None]


def big_foon(real: Sequence[Subgraph], units: int) -> list[Subgraph]:
    """Return subgraphs with about ``units`` distinct units, the same for the same arguments."""
    return list(cuisines(real, units))


def cuisines(real: Sequence[Subgraph], units: int) -> Iterator[Subgraph]:
    """Yield what :func:`big_foon` returns, one after another: a million units need not be in memory."""
    foods, shared = foods_of(real), shared_foods(real)
    own = [food for food in foods if food not in shared]
    keys: set[int] = set()
    for number in range(math.ceil(units * 2 / sum(len(s.annotations) for s in real)) + 1):
        renamed = {food: made_up(number * len(own) + place) for place, food in enumerate(own)}
        for subgraph in real:
            made = other_cuisine(subgraph, number, renamed)
            yield made
            keys.update(int(annotation.unit.key[:KEY_DIGITS], 16) for annotation in made.annotations)
            if len(keys) >= units:
                return


def shared_foods(real: Sequence[Subgraph]) -> set[str]:
    """Return the foods that nobody makes, by their singular names: every kitchen buys them as they are."""
    outputs = {p.node for s in real for a in s.annotations for p in a.unit.outputs}
    made = {singular(name) for node in outputs if not KITCHEN.has(node) for name in (node.label, *node.ingredients)}
    return set(foods_of(real)) - made


def made_up(number: int) -> str:
    """Return a word that no language has, another one for every number."""
    word = ""
    while number or not word:
        number, rest = divmod(number, 70)
        word += "bdfgklmnprstvz"[rest // 5] + "aeiou"[rest % 5]
    return f"{word}n"


def foods_of(real: Sequence[Subgraph]) -> list[str]:
    """Return the foods by their singular names: of labels and of what is contained."""
    nodes = {p.node for s in real for a in s.annotations for p in (*a.unit.inputs, *a.unit.outputs)}
    names = {name for node in nodes for name in (node.label, node.container or node.label, *node.ingredients)}
    return sorted({singular(name) for name in names if not KITCHEN.is_utensil(name) and singular(name)})


def other_cuisine(subgraph: Subgraph, number: int, names: dict[str, str]) -> Subgraph:
    if number == 0:
        return subgraph

    @cache
    def renamed(name: str) -> str:
        return name if KITCHEN.is_utensil(name) else names.get(singular(name), name)

    @cache
    def node_in(node: ObjectNode) -> ObjectNode:
        container = renamed(node.container) if node.container else node.container
        used = KITCHEN.is_utensil(node.label) and not KITCHEN.foods_in(node) and not KITCHEN.has(node)
        states = (*node.states, f"used in {made_up(number)}") if used else node.states
        return ObjectNode(renamed(node.label), states, tuple(map(renamed, node.ingredients)), node.relation, container)

    def side(participants: Sequence[Participant]) -> tuple[Participant, ...]:
        return tuple(replace(p, node=node_in(p.node)) for p in participants)

    annotations = tuple(
        replace(a, unit=replace(a.unit, inputs=side(a.unit.inputs), outputs=side(a.unit.outputs)))
        for a in subgraph.annotations
    )
    return Subgraph(f"{subgraph.name} {number}", annotations, tuple(f"{s}?{number}" for s in subgraph.sources))


def heaps_exponent(real: Sequence[Subgraph]) -> float:
    """Return b of labels ~ videos**b, from all of the real videos and from random halves of them."""
    rng = random.Random(1)
    halves = [len(foods_of(rng.sample(real, len(real) // 2))) for _ in range(5)]
    return math.log(len(foods_of(real)) / statistics.mean(halves)) / math.log(len(real) / (len(real) // 2))


@dataclass(frozen=True)
class Shape:
    """What decides how much work a plan is: see the names of the fields in ``table``."""

    units: int
    objects: int
    labels: int
    food_states: int
    goals: int
    most_goals: int
    makers: float
    many_makers: float
    most_makers: int
    sightings: float
    at_hand: float
    depth: float
    behind_half: float
    behind_nine_in_ten: int
    behind_most: int


def shape_of(snapshot: Snapshot, seed: int = 1) -> Shape:
    nodes = {node for known in snapshot.units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
    makers: dict[ObjectNode, int] = {}
    for known in snapshot.units:
        for node in known.unit.output_nodes:
            makers[node] = makers.get(node, 0) + 1
    made = [count for node, count in makers.items() if not KITCHEN.has(node)]
    goals = sorted({goal.node for goal in snapshot.goals()}, key=lambda node: node.sort_key)
    sample = random.Random(seed).sample(goals, min(SAMPLE, len(goals)))
    behind = [snapshot.behind([goal]) for goal in sample]
    types = [goal.dish_type for goal in snapshot.goals()]
    return Shape(
        units=len(snapshot.units),
        objects=len(nodes),
        labels=len(snapshot.vocabulary().labels),
        food_states=len(snapshot.vocabulary().foods),
        goals=len(goals),
        most_goals=max(map(types.count, set(types))),
        makers=statistics.mean(made),
        many_makers=sum(count > 2 for count in made) / len(made),
        most_makers=max(made),
        sightings=statistics.mean(len(known.seen_in) for known in snapshot.units),
        at_hand=sum(map(KITCHEN.has, nodes)) / len(nodes),
        depth=statistics.median(depth_of(goal, units) for goal, units in zip(sample, behind, strict=True)),
        behind_half=statistics.median(map(len, behind)),
        behind_nine_in_ten=sorted(map(len, behind))[len(behind) * 9 // 10],
        behind_most=max(map(len, behind)),
    )


def depth_of(goal: ObjectNode, units) -> int:
    """Return how many units lie, one behind the other, between ``goal`` and the farthest node behind it."""
    makers: dict[ObjectNode, list[FunctionalUnit]] = {}
    for known in units:
        for node in known.unit.output_nodes:
            makers.setdefault(node, []).append(known.unit)
    depth, reached, layer = 0, {goal}, [goal]
    while layer:
        inputs = {n for node in layer for unit in makers.get(node, ()) for n in unit.input_nodes}
        layer = [node for node in inputs - reached if not KITCHEN.has(node)]
        reached.update(layer)
        depth += bool(layer)
    return depth


def table(shapes: Sequence[Shape]) -> Iterator[str]:
    for name in Shape.__dataclass_fields__:
        yield f"{name.replace('_', ' '):20}" + "".join(f"{getattr(shape, name):>12.5g}" for shape in shapes)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--folder", type=Path, default=SHARED)
    parser.add_argument("--units", type=int, nargs="*", default=[2_000, 20_000])
    options = parser.parse_args()
    real = real_subgraphs(options.folder)
    foons = [real, *(big_foon(real, units) for units in options.units)]
    print(f"labels grow as videos to the power of {heaps_exponent(real):.2f}; the first column is the real FOON")
    print("\n".join(table([shape_of(Snapshot.of(foon, KITCHEN)) for foon in foons])))


if __name__ == "__main__":
    main()
