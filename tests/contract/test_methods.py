"""What a FOON teaches is the same in memory and from Neo4j, whatever was loaded, replaced and taken out before."""

from __future__ import annotations

import itertools
import json

import pytest
from demo_foon import demo_subgraphs
from examples import examples
from foons import foons, subgraphs_named
from hypothesis import given
from hypothesis import strategies as st
from methods_told import told

from foon_kg.foon.demo import demo_folder
from foon_kg.model.errors import NoTreeError, SchemaError
from foon_kg.planning.likes import FoodLikes
from foon_kg.planning.planner import Planner
from foon_kg.planning.recipes import IngredientWords, read_recipe, recipe_files
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import food_similarity
from foon_kg.store.graph import load, loading, methods, reading, remove
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.graph.learnt_by import methods_key
from foon_kg.store.graph.writing import Writer
from foon_kg.store.snapshot import Snapshot

pytestmark = pytest.mark.neo4j

in_a_database = examples(8)


def videos_of_the_demo():
    return list(demo_subgraphs())


def assert_equal_methods(graph, subgraphs):
    with graph.reading() as view:
        found = told(view.methods())
    expected = told(Snapshot.of(subgraphs, Kitchen.default()).methods())
    for table, rows in expected.items():
        assert found[table] == rows, table


def planned(view, recipe):
    """The bytes of the plan, or what is said in its place."""
    try:
        return json.dumps(Planner(view, PlanSettings()).plan(recipe).to_json())
    except NoTreeError as error:
        return json.dumps([error.code, error.message, error.hint])


def empty(connection):
    names = [name for (name,) in ask_freely(connection, "MATCH (v:Video) RETURN v.name").rows]
    if names:
        remove(connection, names)


def test_the_demo_teaches_the_same(connection, graph):
    videos = videos_of_the_demo()
    load(connection, videos)
    assert_equal_methods(graph, videos)


def test_the_demo_teaches_the_same_when_it_came_one_by_one_and_some_went(connection, graph):
    videos = videos_of_the_demo()[::3]
    load(connection, reversed(videos), units_per_transaction=1)
    assert_equal_methods(graph, videos)
    remove(connection, [video.name for video in videos[::3]])
    assert_equal_methods(graph, [video for video in videos if video not in videos[::3]])


def alike(likes):
    """How well a known food stands for another one where no recipe says more of it."""
    return likes.of_recipe([]).alike


def test_what_is_asked_for_some_foods_answers_as_the_whole_does(connection, graph):
    videos = videos_of_the_demo()
    load(connection, videos)
    whole = Snapshot.of(videos, Kitchen.default()).methods().operators
    likes = FoodLikes(food_similarity(), whole.foods)
    for foods in (["onion", "leek"], ["egg", "feta", "chickpea"], ["xyzzy"], []):
        with graph.reading() as view:
            part = view.methods_for(foods, "soup").operators
        fewer = FoodLikes(food_similarity(), part.foods)
        for food, way, act in itertools.product([*foods, "water"], whole.evidence, (False, True)):
            for one, other in (
                (whole.attested(way, [food], likes.likes, act=act), part.attested(way, [food], fewer.likes, act=act)),
                (whole.farthest(way, [food], alike(likes), act=act), part.farthest(way, [food], alike(fewer), act=act)),
            ):
                assert repr(other) == repr(one)
        for table in ("giving", "onto", "ways"):
            assert getattr(part, table) == getattr(whole, table)


@pytest.mark.parametrize("written", ["f.words = 'others'", "f.methods = 'others'"])
def test_where_points_tell_nothing_the_whole_is_answered(connection, graph, written):
    videos = videos_of_the_demo()[:4]
    load(connection, videos)
    ask_freely(connection, f"MATCH (f:Foon) SET {written}", write=True)
    with graph.reading() as view:
        assert told(view.methods_for(["onion"], "soup")) == told(Snapshot.of(videos, Kitchen.default()).methods())


def test_what_another_program_learnt_of_a_large_foon_is_told_and_not_learnt_anew_to_read_it(
    connection, graph, monkeypatch
):
    load(connection, videos_of_the_demo()[:3])
    monkeypatch.setattr(reading, "MOST_LEARNT_ANEW", 2)
    ask_freely(connection, "MATCH (f:Foon) SET f.methods = 'others'", write=True)
    with graph.reading() as view, pytest.raises(SchemaError, match="learnt by another foon-kg") as told_so:
        view.methods_for(["onion"], "soup")
    assert "foon load foon" in told_so.value.hint


def test_how_many_frames_are_kept_changes_none(connection, graph, monkeypatch):
    videos = videos_of_the_demo()
    load(connection, videos)
    monkeypatch.setattr(methods, "MOST_LAYOUTS", 1)
    whole = Snapshot.of(videos, Kitchen.default()).methods()
    keys = [frame.key for frame in whole.frames]
    with graph.reading() as view:
        part = view.methods_for(["onion"], "soup")
        for _ in range(2):
            assert [layout.frame for layout in part.layouts_of(keys)] == list(whole.frames)
        assert list(map(part.goal_of, whole.frames)) == list(map(whole.goal_of, whole.frames))


def test_the_graph_has_the_outlines_of_the_memory(connection, graph):
    videos = videos_of_the_demo()
    load(connection, videos)
    learnt = Snapshot.of(videos, Kitchen.default()).methods().outlines.all
    with graph.reading() as view:
        assert view.methods_for(["onion"], "soup").outlines.all == tuple(sorted(learnt, key=lambda one: one.key))


def test_only_frames_that_are_looked_at_are_read(connection, graph):
    load(connection, videos_of_the_demo())
    with graph.reading() as view:
        part = view.methods_for(["onion"], "soup")
        first, second, *_ = [outline.key for outline in part.outlines.all]
        before = view.round_trips
        assert [layout.frame.key for layout in part.layouts_of([second, first])] == [second, first]
        assert [layout.frame.key for layout in part.layouts_of([first])] == [first]
        assert view.round_trips == before + 1


def test_a_frame_that_went_meanwhile_is_left_out(connection, graph):
    load(connection, videos_of_the_demo())
    with graph.reading() as view:
        part = view.methods_for(["onion"], "soup")
        gone, stays, *_ = [outline.key for outline in part.outlines.all]
        ask_freely(connection, f"MATCH (f:Frame {{key: '{gone}'}}) DETACH DELETE f", write=True)
        assert [layout.frame.key for layout in part.layouts_of([gone, stays])] == [stays]


def test_what_is_known_of_a_food_is_not_asked_twice(connection, graph):
    load(connection, videos_of_the_demo())
    with graph.reading() as view:
        first = view.methods_for(["onion", "leek"], "soup")
    with graph.reading() as view:
        again = view.methods_for(["leek"], "salad")
        assert view.round_trips == 1  # which edition it is
        assert again.operators.foods <= first.operators.foods


@pytest.mark.parametrize("by", ["'another program'", "null"])
def test_what_another_program_learnt_is_never_used_and_is_learnt_anew_by_the_next_load(connection, graph, by):
    videos = videos_of_the_demo()[:5]
    load(connection, videos)
    write = "MATCH (f:Foon), (o:Operator) SET f.methods = " + by + ", o.tools = ['wand'] WITH o DETACH DELETE o"
    ask_freely(connection, write, write=True)
    ask_freely(connection, "MATCH (f:Foon) SET f.edition = randomUUID()", write=True)
    assert_equal_methods(graph, videos)
    assert ask_freely(connection, "MATCH (o:Operator) RETURN o").rows == ()
    load(connection, videos[:1])
    assert ask_freely(connection, "MATCH (o:Operator) RETURN o").rows != ()
    assert_equal_methods(graph, videos)


def test_a_program_that_learns_otherwise_does_not_add_to_what_was_learnt(connection, graph, monkeypatch):
    videos = videos_of_the_demo()[:3]
    load(connection, videos[:1])
    monkeypatch.setattr(loading, "methods_key", lambda: "another program's")
    monkeypatch.setattr(loading, "_learn_anew", lambda *_: None)  # as if it had done so just before the other loaded
    with pytest.raises(SchemaError, match="meanwhile"):
        load(connection, videos)


def test_learning_anew_that_was_interrupted_is_told_apart_and_begun_again(connection, graph, monkeypatch):
    videos = videos_of_the_demo()[:6]
    load(connection, videos)
    ask_freely(connection, "MATCH (f:Foon) SET f.methods = 'others'", write=True)
    monkeypatch.setattr(loading, "VIDEOS_LEARNT_AT_ONCE", 2)
    monkeypatch.setattr(loading, "FORGOTTEN_AT_ONCE", 500)
    learn = Writer.learn

    def interrupted(writer, names):
        if videos[3].name in names:
            raise KeyboardInterrupt
        learn(writer, names)

    with monkeypatch.context() as patch:
        patch.setattr(Writer, "learn", interrupted)
        with pytest.raises(KeyboardInterrupt):
            load(connection, [])
    assert_equal_methods(graph, videos)
    ((mark,),) = ask_freely(connection, "MATCH (f:Foon) RETURN f.methods").rows
    assert mark.startswith("being learnt")
    load(connection, [])
    assert ask_freely(connection, "MATCH (f:Foon) RETURN f.methods").rows == ((methods_key(),),)
    assert_equal_methods(graph, videos)


def test_plans_from_neo4j_are_those_from_memory_byte_by_byte(connection, graph):
    videos = videos_of_the_demo()
    load(connection, videos)
    snapshot = Snapshot.of(videos, Kitchen.default())
    words = IngredientWords(snapshot.vocabulary(), snapshot.kitchen)
    recipes = [read_recipe(path, words).recipe for path in recipe_files([demo_folder().parent / "recipes"])]
    answers = [planned(snapshot, recipe) for recipe in recipes]
    assert sum("units" in answer for answer in answers) >= 3
    for recipe, answer in zip(recipes, answers, strict=True):
        with graph.reading() as view:
            assert planned(view, recipe) == answer


@in_a_database
@given(foons(), st.data())
def test_any_foon_teaches_the_same_after_replacing_and_removing(connection, graph, subgraphs, data):
    load(connection, subgraphs)
    assert_equal_methods(graph, subgraphs)
    later = [data.draw(subgraphs_named(subgraph.name)) for subgraph in subgraphs[:2]]
    load(connection, later)
    assert_equal_methods(graph, [*subgraphs[2:], *later])
    remove(connection, [subgraphs[0].name])
    assert_equal_methods(graph, [*subgraphs[2:], *later[1:]])
    empty(connection)
    assert_equal_methods(graph, [])
