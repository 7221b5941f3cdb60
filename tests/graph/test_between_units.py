"""What the graph tells beside the units: utensils, what moves, what follows; true after every load and removal."""

from __future__ import annotations

from collections import Counter, deque
from itertools import pairwise

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from kitchen_stories import ADD_SALT, CHOP_ONION, SALAD, subgraph, unit

from foon_kg.cli.named_queries import explore_query
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.model import Annotation, FunctionalUnit, Participant, Subgraph
from foon_kg.model.errors import SchemaError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Neo4jGraph, load, remove
from foon_kg.store.graph.free_cypher import ask_freely

pytestmark = pytest.mark.neo4j
KITCHEN = Kitchen.default()
UNITS = [unit(line) for line in (*CHOP_ONION, ADD_SALT)]
"""Few, so that videos share them."""


def moved(one: FunctionalUnit, which: int) -> FunctionalUnit:
    """The same unit with the first, the last, both or none of the things of each side moving."""
    sides = [
        tuple(Participant(p.node, which & (1 if place == 0 else 2) != 0, p.dish_type) for place, p in enumerate(side))
        for side in (one.inputs, one.outputs)
    ]
    return FunctionalUnit(sides[0], one.motion, sides[1], one.accepts_any)


def video(name: str, *steps: tuple[int, int]) -> Subgraph:
    return Subgraph(name, tuple(Annotation(moved(UNITS[place], which)) for place, which in steps))


def rows(connection, text: str) -> Counter:
    return Counter(tuple(row) for row in ask_freely(connection, text, limit=1_000_000, timeout=60).rows)


def as_written(connection):
    """What the graph tells, read plainly."""
    return (
        rows(connection, "MATCH (a)-[n:NEXT]->(b) RETURN n.video, n.position, a.key, b.key"),
        rows(connection, "MATCH (o)-[r:INPUT_OF]->(m) WHERE r.moving IS NOT NULL RETURN m.key, 'in', o.key, r.moving"),
        rows(connection, "MATCH (m)-[r:OUTPUTS]->(o) WHERE r.moving IS NOT NULL RETURN m.key, 'out', o.key, r.moving"),
        rows(connection, "MATCH (o:Object) WHERE o.utensil RETURN DISTINCT o.label"),
    )


def as_annotated(subgraphs):
    """The same, told by the videos themselves."""
    following, moving = Counter(), {"in": Counter(), "out": Counter()}
    utensils = set()
    for one in subgraphs:
        for place, (first, then) in enumerate(pairwise(a.unit for a in one.annotations)):
            following[one.name, place, first.key, then.key] += 1
        for annotation in one.annotations:
            for side, things in (("in", annotation.unit.inputs), ("out", annotation.unit.outputs)):
                for key in {p.node.key for p in things if p.moving}:
                    moving[side][annotation.unit.key, side, key] += 1
                utensils |= {p.node.label for p in things if KITCHEN.is_utensil(p.node.label)}
    counted = [Counter({(*edge, count): 1 for edge, count in side.items()}) for side in moving.values()]
    return (following, *counted, Counter({(label,): 1 for label in utensils}))


STEPS = st.lists(st.tuples(st.integers(0, len(UNITS) - 1), st.integers(0, 3)), min_size=2, max_size=5)
WRITES = st.lists(st.tuples(st.sampled_from("abc"), st.one_of(st.none(), STEPS)), min_size=2, max_size=6)


@given(WRITES)
@settings(max_examples=10, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_after_any_loads_replacements_and_removals_it_says_what_the_videos_say(connection, writes):
    there: dict[str, Subgraph] = {}
    for name, steps in [*((name, None) for name in "abc"), *writes]:
        if steps is not None:
            there[name] = video(name, *steps)
            load(connection, [there[name]])
        elif rows(connection, f"MATCH (v:Video {{name: '{name}'}}) RETURN v.name"):
            remove(connection, [name])
            there.pop(name, None)
    assert as_written(connection) == as_annotated(there.values())


@pytest.mark.parametrize("there", [0, 1, 2])
def test_videos_that_come_and_go_together_count_what_moves_in_each_of_them(connection, there):
    videos = [video("a", (0, 1), (1, 3), (0, 3)), video("b", (0, 3), (1, 0)), video("c", (0, 2), (1, 2))]
    load(connection, videos[:there])
    load(connection, videos)
    assert as_written(connection) == as_annotated(videos)
    remove(connection, ["a", "c"])
    assert as_written(connection) == as_annotated([videos[1]])


def test_a_whole_foon_at_once_and_video_by_video_are_told_alike(connection):
    foon = [result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None]
    load(connection, foon)
    at_once = as_written(connection)
    assert at_once == as_annotated(foon)
    assert all(sum(part.values()) > 10 for part in (at_once[0], at_once[3]))
    remove(connection, [one.name for one in foon[:3]])
    for one in foon[:3]:
        load(connection, [one], units_per_transaction=3)
    assert as_written(connection) == at_once


def test_a_graph_that_tells_less_is_brought_up_to_date_by_the_next_load(connection, empty_graph):
    videos = [video("a", (0, 1), (1, 2)), subgraph("salad", "salad", *SALAD)]
    load(connection, videos)
    for text in (
        "MATCH ()-[n:NEXT]->() DELETE n",
        "MATCH ()-[r:INPUT_OF|OUTPUTS]->() REMOVE r.moving",
        "MATCH (o:Object) REMOVE o.utensil",
        "MATCH (f:Foon) SET f.kitchen = 'as an earlier foon-kg wrote it'",
    ):
        ask_freely(connection, text, write=True)
    with Neo4jGraph(empty_graph) as graph, pytest.raises(SchemaError) as refused, graph.reading():
        pass
    assert "foon load foon" in refused.value.hint
    assert load(connection, videos).unchanged == ("a", "salad")
    assert as_written(connection) == as_annotated(videos)


def test_the_shortest_way_of_food_goes_round_knives(connection):
    foon = [result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None]
    load(connection, foon)
    query = explore_query("food_way")
    found = ask_freely(connection, query.text, {"before": "potato", "after": "potato salad"})
    assert found.columns == query.columns
    [(motions, things)] = found.rows
    assert (things[0], things[-1], len(motions)) == ("potato", "potato salad", len(things) - 1)
    assert len(motions) == food_steps(foon, "potato", "potato salad")

    assert "knife" not in things


def food_steps(foon, before: str, after: str) -> int | None:
    """How many steps lie between, by a walk over the units that passes no empty utensil."""
    units = [a.unit for one in foon for a in one.annotations]
    edible = {n for u in units for n in (*u.input_nodes, *u.output_nodes) if _carries_food(n)}
    waiting = deque((node, 0) for node in edible if node.label == before and KITCHEN.has(node))
    seen = {node for node, _ in waiting}
    while waiting:
        node, steps = waiting.popleft()
        if node.label == after:
            return steps
        for made in (n for u in units if node in u.input_nodes for n in u.output_nodes):
            if made in edible and made not in seen:
                seen.add(made)
                waiting.append((made, steps + 1))
    return None


def _carries_food(node) -> bool:
    return not KITCHEN.is_utensil(node.label) or bool(node.ingredients)
