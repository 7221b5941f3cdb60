"""Loading, replacing and taking out: nothing of a video is lost, and nothing of it stays."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import pytest
from examples import examples
from foons import foons, subgraphs_named
from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import SALAD, subgraph, unit

from foon_kg.model import Annotation, Subgraph, Timing
from foon_kg.model.errors import GraphError, ReadError, SchemaError, UsageError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, LoadReport, Neo4jGraph, load, remove
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.graph.schema import schema_version
from foon_kg.store.snapshot import Snapshot

pytestmark = pytest.mark.neo4j

KITCHEN = Kitchen.default()
VARYING = {"writes", "edition"}
in_a_database = examples(8)


def ask(connection, text, **parameters):
    return list(ask_freely(connection, text, parameters, limit=100_000, timeout=60).rows)


def whole_graph(connection):
    """Every node and edge with all its properties, the count and the name of writes apart."""
    nodes = ask(connection, "MATCH (n) RETURN labels(n), properties(n)")
    edges = ask(connection, "MATCH (a)-[r]->(b) RETURN properties(a), type(r), properties(r), properties(b)")
    return sorted(repr(row_of(row)) for row in nodes), sorted(repr(row_of(row)) for row in edges)


def row_of(row):
    """The row with its properties by name: their order is the database's own affair."""
    return [sorted((k, part[k]) for k in part.keys() - VARYING) if isinstance(part, dict) else part for part in row]


def empty(connection):
    """Leave nothing but the record of the schema."""
    names = [name for (name,) in ask(connection, "MATCH (v:Video) RETURN v.name")]
    if names:
        remove(connection, names)


salad = subgraph("salad", "salad", *SALAD)
shorter = subgraph("salad", "salad", *SALAD[:3])
other = subgraph("other", "omelette", *SALAD[2:])


def test_what_was_loaded_is_read_back_as_the_same_model(connection, graph):
    wild = Subgraph(
        "wild 'name\" ü",
        (
            Annotation(
                unit("b; a; a > mix* > c(x,y){salt}@on plate", "soup"), Timing(((1.5, 3.0), (0.25, 1.0)), assumed=True)
            ),
            Annotation(unit("b; a; a > mix* > c(x,y){salt}@on plate"), Timing()),
        ),
        ("https://example.org/1", "second source"),
    )
    load(connection, [salad, wild])
    with graph.reading() as view:
        assert view.subgraphs([salad.name, wild.name]) == (salad, wild)


@in_a_database
@given(foons())
def test_any_foon_is_read_back_as_the_same_model(connection, graph, subgraphs):
    load(connection, subgraphs)
    assert graph.snapshot().subgraphs == tuple(sorted(subgraphs, key=lambda s: s.name))
    empty(connection)


@in_a_database
@given(foons(), st.data())
def test_a_replaced_video_leaves_the_graph_as_if_it_had_always_been_so(connection, subgraphs, data):
    later = [data.draw(subgraphs_named(subgraph.name)) for subgraph in subgraphs[:2]]
    load(connection, subgraphs)
    load(connection, later)
    changed = whole_graph(connection)
    empty(connection)
    load(connection, [*subgraphs[2:], *later])
    assert changed == whole_graph(connection)
    empty(connection)


@in_a_database
@given(foons(("a", "b", "c")), foons(("d", "e")))
def test_a_removed_video_leaves_no_trace(connection, kept, removed):
    load(connection, kept)
    before = whole_graph(connection)
    load(connection, removed)
    remove(connection, [subgraph.name for subgraph in removed])
    assert whole_graph(connection) == before
    empty(connection)


def test_removing_everything_leaves_only_the_record_of_the_schema(connection):
    load(connection, [salad, other])
    remove(connection, ["salad", "other"])
    assert ask(connection, "MATCH (n) RETURN labels(n)") == [(["Foon"],)]


def test_loading_again_changes_nothing(connection):
    load(connection, [salad, other])
    before = whole_graph(connection)
    assert load(connection, [other, salad]) == LoadReport(unchanged=("other", "salad"))
    assert whole_graph(connection) == before


def test_the_report_tells_new_changed_and_unchanged_videos_apart(connection):
    assert load(connection, [salad]) == LoadReport(inserted=("salad",))
    report = load(connection, [shorter, other])
    assert (report.inserted, report.replaced, report.unchanged) == (("other",), ("salad",), ())


def test_stored_is_told_only_what_another_program_can_see(connection, graph):
    videos = [subgraph(f"video {n}", "salad", *SALAD) for n in range(4)]
    seen = []

    def look(report):
        with graph.reading() as view:
            seen.append(set(report.inserted) <= set(view.video_names()))

    load(connection, videos, stored=look, units_per_transaction=len(SALAD) + 1)
    assert seen == [True] * 3  # what was there already, then two videos at a time


def test_the_batches_make_no_difference(connection):
    videos = [salad, other, subgraph("third", "salad", *SALAD[:5])]
    load(connection, videos)
    at_once = whole_graph(connection)
    empty(connection)
    load(connection, videos, units_per_transaction=1)
    assert whole_graph(connection) == at_once


def test_an_iterator_is_loaded_part_by_part_to_the_same_graph(connection):
    videos = [other, salad, subgraph("third", "salad", *SALAD[:5])]
    load(connection, videos)
    at_once = whole_graph(connection)
    empty(connection)
    told, taken = [], []

    def source():
        for video in [*videos, *videos]:
            taken.append(video.name)
            yield video

    load(connection, [salad])
    report = load(connection, source(), stored=lambda part: told.append((part, len(taken))), units_per_transaction=1)
    assert (set(report.inserted), report.unchanged) == ({"other", "third"}, ("salad",))
    assert next(count for part, count in told if part.inserted) < len(videos) * 2, "all was in memory"
    assert whole_graph(connection) == at_once


def test_two_subgraphs_of_one_name_are_refused_in_an_iterator_and_those_before_stay(connection):
    with pytest.raises(ReadError, match="two different subgraphs are called “salad”"):
        load(connection, iter([other, salad, other, shorter]), units_per_transaction=1)
    assert {name for (name,) in ask(connection, "MATCH (v:Video) RETURN v.name")} <= {"other", "salad"}


def test_two_subgraphs_of_one_name_are_refused_and_nothing_is_loaded(connection):
    load(connection, [other])
    with pytest.raises(ReadError, match="two different subgraphs are called “salad”"):
        load(connection, [salad, shorter])
    assert ask(connection, "MATCH (v:Video) RETURN v.name") == [("other",)]


def test_removing_an_unknown_video_removes_none(connection):
    load(connection, [salad])
    with pytest.raises(UsageError, match="no video “lost”"):
        remove(connection, ["salad", "lost"])
    assert ask(connection, "MATCH (v:Video) RETURN v.name") == [("salad",)]


def test_programs_that_load_at_once_take_turns(empty_graph, connection):
    videos = [subgraph(f"video {n}", "salad", *SALAD[n:]) for n in range(6)]

    def one_program(place):
        with Connection(empty_graph) as own:
            load(own, videos[place:] + videos[:place], units_per_transaction=1)

    with ThreadPoolExecutor(4) as programs:
        list(programs.map(one_program, range(4)))
    together = whole_graph(connection)
    empty(connection)
    load(connection, videos)
    assert whole_graph(connection) == together


def test_the_tables_of_the_graph_are_what_counting_anew_gives(connection, graph):
    load(connection, [salad, other])
    load(connection, [shorter])
    with graph.reading() as view:
        assert view.vocabulary() == Snapshot.of([shorter, other], KITCHEN).vocabulary()


def test_another_kitchen_is_refused_in_reading_and_worked_in_by_loading(empty_graph, connection):
    load(connection, [salad, other])
    bare = Kitchen(*[frozenset()] * 3, {}, *[frozenset()] * 4)
    with Neo4jGraph(empty_graph, bare) as graph:
        with pytest.raises(SchemaError, match="another kitchen") as refused, graph.reading():
            pass
        assert "foon load foon" in refused.value.hint
        load(connection, [salad], bare)
        with graph.reading() as view:
            assert view.vocabulary() == Snapshot.of([salad, other], bare).vocabulary()
    anew = whole_graph(connection)
    empty(connection)
    load(connection, [salad, other], bare)
    assert whole_graph(connection) == anew


def test_a_database_without_a_foon_is_told_apart_from_an_empty_foon(connection, graph):
    with pytest.raises(GraphError, match="holds no FOON yet"), graph.reading():
        pass
    load(connection, [])
    with graph.reading() as view:
        assert view.goals() == ()


@pytest.mark.parametrize(
    ("version", "advice"), [(schema_version() + 1, "upgrade"), (schema_version() - 1, "foon load")]
)
def test_another_schema_is_refused_with_advice(connection, graph, version, advice):
    load(connection, [salad])
    ask_freely(connection, "MATCH (f:Foon) SET f.version = $version", {"version": version}, write=True)
    with pytest.raises(SchemaError) as refused, graph.reading():
        pass
    assert advice in refused.value.hint


def test_a_graph_of_a_newer_program_is_never_written(connection):
    load(connection, [salad])
    ask_freely(connection, "MATCH (f:Foon) SET f.version = 99", write=True)
    with pytest.raises(SchemaError, match="schema 99"):
        load(connection, [other])
    assert ask(connection, "MATCH (v:Video) RETURN v.name") == [("salad",)]


def test_an_older_schema_is_brought_up_to_date_by_loading(connection, graph):
    load(connection, [salad])
    ask_freely(connection, "DROP INDEX ingredient_vector", write=True)
    ask_freely(connection, "MATCH (f:Foon) SET f.version = $version", {"version": schema_version() - 1}, write=True)
    load(connection, [salad])
    with graph.reading() as view:
        assert view.video_names() == ("salad",)


def test_types_of_stages_that_an_older_schema_called_posts_are_named_anew(connection):
    load(connection, [salad])
    joins = "MATCH (k)-[r:JOINS_AT]->(t) RETURN labels(t), k.name, r.dish_type, r.count, t.name ORDER BY k.name, t.name"
    now = ask(connection, joins)
    for text in (
        "MATCH (t:StageType) SET t:Post REMOVE t:StageType",
        "DROP CONSTRAINT stage_type_name",
        "CREATE CONSTRAINT post_name FOR (p:Post) REQUIRE p.name IS UNIQUE",
        "MATCH (f:Foon) SET f.version = 29, f.methods = 'those of then'",
    ):
        ask_freely(connection, text, write=True)
    load(connection, [salad])
    assert now
    assert ask(connection, joins) == now
    assert ask(connection, "MATCH (p:Post) RETURN count(p)") == [(0,)]
    named = "SHOW CONSTRAINTS YIELD name WHERE name IN ['post_name', 'stage_type_name'] RETURN name"
    assert ask(connection, named) == [("stage_type_name",)]
