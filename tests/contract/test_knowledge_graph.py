"""One suite for everything that keeps a FOON: what the planner is answered is the same in memory and from Neo4j.

The stories run against both. The properties compare the snapshot with slow and simple oracles, and Neo4j with the
snapshot: an example in a real database costs a hundred times more.
"""

from __future__ import annotations

from collections import Counter

import pytest
from examples import examples
from foons import DISHES, LABELS, STATES, foons, nodes
from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import node, unit

from foon_kg.model import Annotation, FunctionalUnit, Participant, Subgraph
from foon_kg.model.knowledge import Gathering, MadeBy, SeenAs
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, Neo4jGraph, load, remove
from foon_kg.store.snapshot import Snapshot

KITCHEN = Kitchen.default()

foods_asked = st.lists(st.tuples(st.sampled_from(LABELS), st.sampled_from((*STATES, ""))), max_size=3)
nodes_asked = st.lists(nodes, max_size=2)


class InMemory:
    def keep(self, subgraphs):
        return Snapshot.of(subgraphs, KITCHEN)


class InNeo4j:
    def __init__(self, connection, graph):
        self.connection, self.graph, self.names = connection, graph, []

    def keep(self, subgraphs):
        if self.names:
            remove(self.connection, self.names)
        self.names = [subgraph.name for subgraph in subgraphs]
        load(self.connection, subgraphs)
        return self.graph


@pytest.fixture
def in_neo4j(empty_graph):
    with Connection(empty_graph) as connection, Neo4jGraph(empty_graph) as graph:
        yield InNeo4j(connection, graph)


@pytest.fixture(params=["snapshot", pytest.param("neo4j", marks=pytest.mark.neo4j)])
def keeper(request):
    return InMemory() if request.param == "snapshot" else request.getfixturevalue("in_neo4j")


for_every_foon = examples(30)
for_some_foons = examples(8)


def distinct_units(subgraphs):
    return {a.unit.key: a.unit for s in subgraphs for a in s.annotations}


def food(thing):
    return not KITCHEN.is_utensil(thing.label)


@pytest.mark.slow
@for_every_foon
@given(foons(), nodes_asked, foods_asked)
def test_behind_answers_the_units_that_a_search_through_everything_finds(subgraphs, asked, foods):
    outputs = sorted({o for u in distinct_units(subgraphs).values() for o in u.output_nodes}, key=lambda n: n.sort_key)
    asked = [*asked, *outputs[:1]]
    with Snapshot.of(subgraphs, KITCHEN).reading() as view:
        answered = view.behind(asked, foods)
    assert [known.unit.key for known in answered] == sorted(units_behind(subgraphs, asked, foods))


def units_behind(subgraphs, asked, foods):
    """Go over every unit again and again until nothing is added: slow, and as the protocol says it."""
    units = distinct_units(subgraphs)
    wanted = set(asked)
    for made in (n for u in units.values() for n in u.output_nodes):
        if any(
            made.label == label and (state in made.states or (not state and not made.states)) for label, state in foods
        ):
            wanted.add(made)
    found: set[str] = set()
    while more := {key for key, u in units.items() if wanted & set(u.output_nodes)} - found:
        found |= more
        wanted |= {n for key in more for n in units[key].input_nodes if not KITCHEN.has(n)}
    return found


@pytest.mark.slow
@for_every_foon
@given(foons())
def test_every_unit_comes_with_every_place_where_it_was_seen(subgraphs):
    outputs = {o for u in distinct_units(subgraphs).values() for o in u.output_nodes}
    with Snapshot.of(subgraphs, KITCHEN).reading() as view:
        answered = view.behind(outputs)
    places = {
        known.unit.key: [(s.video, s.position, s.source, s.start, s.end, s.measures) for s in known.seen_in]
        for known in answered
    }
    expected: dict[str, list[object]] = {}
    for subgraph in sorted(subgraphs, key=lambda s: s.name):
        for position, annotation in enumerate(subgraph.annotations):
            time, source = annotation.timing, next(iter(subgraph.sources), None)
            place = (subgraph.name, position, source, time.start, time.end, annotation.measures)
            expected.setdefault(annotation.unit.key, []).append(place)
    assert places == expected


@pytest.mark.slow
@for_every_foon
@given(foons())
def test_a_unit_is_written_as_its_first_sighting_has_it(subgraphs):
    outputs = {o for u in distinct_units(subgraphs).values() for o in u.output_nodes}
    with Snapshot.of(subgraphs, KITCHEN).reading() as view:
        answered = view.behind(outputs)
    first: dict[str, FunctionalUnit] = {}
    for subgraph in sorted(subgraphs, key=lambda s: s.name):
        for annotation in subgraph.annotations:
            first.setdefault(annotation.unit.key, annotation.unit)
    assert {known.unit.key: known.unit for known in answered} == first


@pytest.mark.slow
@for_every_foon
@given(foons())
def test_goals_are_the_foods_that_a_video_marks_with_a_dish(subgraphs):
    with Snapshot.of(subgraphs, KITCHEN).reading() as view:
        answered = {dish: view.goals(dish) for dish in (*DISHES, None)}
    marked = {
        (p.node, p.dish_type, s.name)
        for s in subgraphs
        for a in s.annotations
        for p in a.unit.outputs
        if p.dish_type and food(p.node)
    }
    for dish, goals in answered.items():
        assert {(g.node, g.dish_type, v) for g in goals for v in g.videos} == {
            m for m in marked if dish in (m[1], None)
        }
        assert [g.node.sort_key for g in goals] == sorted(g.node.sort_key for g in goals)
        assert all(g.ingredients == g.node.ingredients for g in goals)


@pytest.mark.slow
@for_every_foon
@given(foons())
def test_the_vocabulary_counts_each_distinct_unit_once(subgraphs):
    with Snapshot.of(subgraphs, KITCHEN).reading() as view:
        words = view.vocabulary()
    made, used, motions = Counter(), Counter(), Counter()
    for u in distinct_units(subgraphs).values():
        before = {(n.label, s) for n in u.input_nodes if food(n) for s in n.states or ("",)}
        after = {(n.label, s) for n in u.output_nodes if food(n) for s in n.states or ("",)}
        made.update(after)
        used.update(before)
        motions.update({(s, u.motion) for _, s in after - before if s})
    assert words.foods == tuple(SeenAs(*pair, made[pair], used[pair]) for pair in sorted({*made, *used}))
    assert words.motions == tuple(MadeBy(*pair, motions[pair]) for pair in sorted(motions))


@pytest.mark.slow
@for_every_foon
@given(foons())
def test_the_vocabulary_says_how_often_the_units_of_a_motion_take_several_foods(subgraphs):
    with Snapshot.of(subgraphs, KITCHEN).reading() as view:
        words = view.vocabulary()
    units, several = Counter(), Counter()
    for u in distinct_units(subgraphs).values():
        taken = {n.label for n in u.input_nodes if food(n)}
        taken |= {name for n in u.input_nodes for name in n.ingredients if not KITCHEN.is_utensil(name)}
        units[u.motion] += 1
        several[u.motion] += len(taken) >= 2
    assert words.gatherings == tuple(Gathering(m, units[m], several[m]) for m in sorted(units))
    for motion in units:
        assert words.gathers(motion) == (several[motion] + 1) / (units[motion] + 2)
    assert words.gathers("levitate") == 0.5


def test_verbs_are_counted_also_where_they_make_no_state_and_are_forgotten_with_their_last_unit(keeper):
    both = story(
        "a", unit("salt; bowl{onion} > pour > bowl{onion,salt}"), unit("bowl{onion,salt} > lift > bowl{onion}")
    )
    one = story("b", unit("tap(off) > turn on > tap(on)"))
    with keeper.keep([both, one]).reading() as view:
        assert view.vocabulary().gatherings == (
            Gathering("lift", 1, 1), Gathering("pour", 1, 1), Gathering("turn on", 1, 0)
        )  # fmt: skip
    with keeper.keep([one]).reading() as view:
        assert view.vocabulary().gatherings == (Gathering("turn on", 1, 0),)


@pytest.mark.neo4j
@for_some_foons
@given(foons(), nodes_asked, foods_asked)
def test_neo4j_answers_every_question_as_the_snapshot_does(in_neo4j, subgraphs, asked, foods):
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    asked = [*asked, *(o for known in snapshot.units[:2] for o in known.unit.output_nodes)]
    graph = in_neo4j.keep(subgraphs)
    with graph.reading() as view:
        assert view.vocabulary() == snapshot.vocabulary()
        assert view.goals() == snapshot.goals()
        assert [view.goals(dish) for dish in DISHES] == [snapshot.goals(dish) for dish in DISHES]
        assert view.behind(asked, foods) == snapshot.behind(asked, foods)
    whole = graph.snapshot()
    assert (whole.subgraphs, whole.units) == (snapshot.subgraphs, snapshot.units)


def story(name, *units):
    return Subgraph(name, tuple(map(Annotation, units)))


def test_a_node_that_is_at_hand_is_expanded_only_where_it_was_asked_for(keeper):
    grow = unit("seed > grow > onion(whole)")
    chop = unit("onion(whole); knife > chop > onion(chopped)")
    assert KITCHEN.has(node("onion(whole)"))
    with keeper.keep([story("a", grow, chop)]).reading() as view:
        assert [k.unit.motion for k in view.behind([node("onion(chopped)")])] == ["chop"]
        assert {k.unit.motion for k in view.behind([node("onion(chopped)"), node("onion(whole)")])} == {"grow", "chop"}
        assert {k.unit.motion for k in view.behind([], [("onion", "whole")])} == {"grow"}


def test_cycles_end(keeper):
    there = unit("soup(hot)@pot > pour > soup(hot)@bowl")
    back = unit("soup(hot)@bowl > pour > soup(hot)@pot")
    with keeper.keep([story("a", there, back)]).reading() as view:
        assert len(view.behind([node("soup(hot)@pot")])) == 2


def test_what_nobody_makes_has_nothing_behind_it(keeper):
    with keeper.keep([story("a", unit("onion(whole) > chop > onion(chopped)"))]).reading() as view:
        assert view.behind([node("unicorn")], [("unicorn", "chopped")]) == ()
        assert view.behind([]) == ()


def test_the_vessel_beside_the_dish_is_no_goal(keeper):
    outputs = (Participant(node("orange juice"), False, "drinks"), Participant(node("drinking glass"), False, "drinks"))
    pour = FunctionalUnit((Participant(node("orange")),), "pour", outputs)
    with keeper.keep([story("a", pour)]).reading() as view:
        assert [goal.node.label for goal in view.goals()] == ["orange juice"]
        assert view.vocabulary().dish_types == ("drinks",)
