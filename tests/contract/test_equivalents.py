"""The known foods that may stand for others: Neo4j's vector index answers as a comparison with all of them does."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from kitchen_stories import node, unit

from foon_kg.cypher import schema_steps
from foon_kg.loaders import read_paths
from foon_kg.model import Annotation, FunctionalUnit, Participant, Subgraph
from foon_kg.model.errors import SchemaError
from foon_kg.model.names import ALIASES_VARIABLE
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import food_similarity
from foon_kg.similarity.groups import food_groups
from foon_kg.store.graph import Connection, load, remove
from foon_kg.store.graph.equivalents import FIRST
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.snapshot import Snapshot

TESTS = Path(__file__).parents[1]
SHARED = TESTS.parents[1] / "shared" / "data"
JUDGED = json.loads((TESTS / "language" / "data" / "accepted.json").read_text(encoding="utf-8"))
UNKNOWN = sorted({food for name, foods in JUDGED.items() if name != "about" for food in foods})
STRANGE = ["qwxyz", "", "Onions!", "rocket fuel", "crème fraîche", "red paprika powder", "ΩΩ"]
KITCHEN = Kitchen.default()

MIX = unit("green olive(whole); onion(chopped); bowl > mix > salad{green olive,tomatoes}", "salad")
TOSS = Subgraph("toss", (Annotation(MIX),))


@pytest.fixture
def empty_graph(bare_server, empty_graph):
    """An empty graph whose vector index was new when the module began.

    Points that are deleted stay in it for a while, and take the place of neighbours: few foods are asked first here.
    """
    del bare_server
    return empty_graph


@pytest.fixture
def new_index(empty_graph):
    """The vector index made anew: what tests before this one have deleted is in it no longer."""
    (made,) = (step.text for step in schema_steps() if "INDEX ingredient_vector" in step.text)
    with Connection(empty_graph) as connection:
        for change in ("DROP INDEX ingredient_vector", made, "CALL db.awaitIndexes()"):
            ask_freely(connection, change, write=True)


@pytest.fixture(params=["snapshot", pytest.param("neo4j", marks=pytest.mark.neo4j)])
def keep(request):
    """Keep subgraphs in memory or in Neo4j, and answer what opens a view on them."""

    def in_memory(subgraphs):
        return Snapshot.of(subgraphs, KITCHEN)

    def in_neo4j(subgraphs):
        load(request.getfixturevalue("connection"), subgraphs)
        return request.getfixturevalue("graph")

    return in_memory if request.param == "snapshot" else in_neo4j


def garden(foods):
    """Return a subgraph that knows these foods."""
    parts = (foods[start : start + 50] for start in range(0, len(foods), 50))
    harvests = (tuple(Participant(node(food)) for food in part) for part in parts)
    seed = (Participant(node("bowl")),)
    return Subgraph("garden", tuple(Annotation(FunctionalUnit(seed, "grow", harvest)) for harvest in harvests))


def by_comparing_all(names, snapshot, limit):
    known = sorted({row.label for row in snapshot.vocabulary().foods})
    return tuple(food_similarity().nearest(name, known, limit=limit) for name in names)


def test_foods_are_answered_best_first_and_utensils_and_mere_ingredients_not_at_all(keep):
    with keep([TOSS]).reading() as view:
        caper, shallot, onions = view.equivalents(["caper", "shallot", "Onions"], limit=9)
    assert [other.name for other in caper] == ["green olive"]
    assert shallot[0].name == "onion"
    assert (onions[0].name, onions[0].confidence) == ("onion", 1.0)


def test_the_limit_is_kept_and_a_name_may_be_asked_twice(keep):
    with keep([TOSS]).reading() as view:
        first, second = view.equivalents(["caper", "caper"], limit=1)
        assert first == second
        assert len(first) == 1
        assert view.equivalents([]) == ()


def test_a_foon_without_foods_has_no_equivalents(keep):
    with keep([]).reading() as view:
        assert view.equivalents(["caper"]) == ((),)


@pytest.mark.neo4j
def test_one_round_trip_finds_them_where_the_nearest_points_settle_it(connection, graph):
    load(connection, [garden(food_groups().foods[::9])])
    with graph.reading() as view:
        before = view.round_trips
        view.equivalents(["caper", "leek", "prawn"])
        assert view.round_trips == before + 1
        assert view.equivalents(["qwxyz"]) == ((),)
        assert view.round_trips == before + 2


@pytest.mark.neo4j
def test_a_graph_from_before_the_index_gets_its_points_at_the_next_load(connection, graph):
    load(connection, [TOSS])
    for change in (
        "DROP INDEX ingredient_vector",
        "DROP INDEX ingredient_canonical",
        "MATCH (i:Ingredient) REMOVE i.vector, i.canonical",
        "MATCH (f:Foon) REMOVE f.words SET f.version = 11",
    ):
        ask_freely(connection, change, write=True)
    with pytest.raises(SchemaError, match="schema 11") as refused, graph.reading():
        pass
    assert "foon load" in refused.value.hint
    assert load(connection, [TOSS]).unchanged == ("toss",)
    with graph.reading() as view:
        assert view.equivalents(["caper"]) == Snapshot.of([TOSS], KITCHEN).equivalents(["caper"])
        assert has_points(connection) == (4, 4)


@pytest.mark.neo4j
def test_other_word_lists_are_answered_rightly_and_worked_in_by_loading(connection, graph, tmp_path, monkeypatch):
    load(connection, [TOSS])
    own = tmp_path / "aliases.txt"
    own.write_text("onion = blorb\n", encoding="utf-8")
    monkeypatch.setenv(ALIASES_VARIABLE, str(own))
    expected = Snapshot.of([TOSS], KITCHEN).equivalents(["blorb", "caper"])
    assert expected[0][0].name == "onion"
    with graph.reading() as view:
        assert view.equivalents(["blorb", "caper"]) == expected
    load(connection, [TOSS])
    with graph.reading() as view:
        before = view.round_trips
        assert view.equivalents(["blorb", "caper"]) == expected
        assert view.round_trips == before + 1


@pytest.mark.neo4j
def test_points_come_and_go_with_their_foods(connection):
    load(connection, [TOSS, garden(["leek", "kale"])])
    assert has_points(connection) == (6, 6)
    remove(connection, ["garden"])
    assert has_points(connection) == (4, 4)


def test_many_foods_are_answered_as_by_comparing_all_of_them(keep):
    foods = [*food_groups().foods[::5], "Zucchinis", "courgette"]
    assert len(foods) > 4 * FIRST
    subgraphs = [garden(foods)]
    names = [*foods[::3], *UNKNOWN[::2], *STRANGE]
    expected = by_comparing_all(names, Snapshot.of(subgraphs, KITCHEN), 5)
    with keep(subgraphs).reading() as view:
        assert view.equivalents(names, limit=5) == expected


@pytest.mark.neo4j
@pytest.mark.shared_data
@pytest.mark.skipif(not SHARED.exists(), reason="the public FOON is not beside the checkout (../shared/data)")
def test_the_public_foon_answers_as_by_comparing_all_of_its_foods(connection, graph, new_index):
    read = list(read_paths([SHARED / "foon-111" / "TXT"]))
    subgraphs = [result.subgraph for result in read if result.subgraph is not None]
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    names = [*snapshot.vocabulary().labels, *UNKNOWN, *STRANGE]
    load(connection, subgraphs)
    with graph.reading() as view:
        assert view.equivalents(names, limit=5) == by_comparing_all(names, snapshot, 5)


def has_points(connection):
    """Return how many foods there are, and how many of them have a point."""
    return ask_freely(connection, "MATCH (i:Ingredient) RETURN count(i), count(i.vector)").rows[0]
