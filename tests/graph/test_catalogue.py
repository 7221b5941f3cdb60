"""Every query of the catalogue: it compiles, says the truth in its header, is used, and comes with the package."""

from __future__ import annotations

import re
from pathlib import Path

import neo4j
import pytest

from foon_kg.cypher import catalogue, explore_queries, read_query, schema_steps
from foon_kg.store.graph import statements
from foon_kg.store.graph.statements import Statement

REPO = Path(__file__).parents[2]
STATEMENTS = {value.name: value for value in vars(statements).values() if isinstance(value, Statement)}
CONSTANTS = {value.name: name for name, value in vars(statements).items() if isinstance(value, Statement)}
EXAMPLE_VALUES = {"LIST<STRING>": ["x"], "LIST<MAP>": [], "INTEGER": 1, "STRING": "x"}

ALL = [*catalogue(), *schema_steps()]

every_query = pytest.mark.parametrize("query", ALL, ids=lambda query: query.name)
every_named_query = pytest.mark.parametrize("query", catalogue(), ids=lambda query: query.name)


@pytest.fixture(scope="module")
def session(bare_server):
    login = (bare_server.user, bare_server.password)
    with (
        neo4j.GraphDatabase.driver(bare_server.uri, auth=login, warn_notification_severity="OFF") as driver,
        driver.session(database=bare_server.database) as session,
    ):
        for step in schema_steps():
            session.run(step.text).consume()
        session.run("CALL db.awaitIndexes()").consume()
        yield session


def explained(session, query, language=""):
    parameters = {name: EXAMPLE_VALUES[kind] for name, kind in query.parameters.items()}
    result = session.run(f"EXPLAIN {language}{query.text}", parameters)
    return tuple(result.keys()), result.consume()


def operators(plan):
    yield plan["operatorType"].partition("@")[0]
    for child in plan.get("children", ()):
        yield from operators(child)


def code_of(query):
    return "\n".join(line for line in query.text.splitlines() if not line.startswith("//"))


@pytest.mark.neo4j
@pytest.mark.parametrize("language", ["CYPHER 5 ", "CYPHER 25 "])
@every_query
def test_it_compiles_on_neo4j(session, query, language):
    assert explained(session, query, language)[1].query_type in {"r", "w", "rw", "s"}


@pytest.mark.neo4j
def test_named_questions_that_say_why_they_scan_do(session):
    told = [query for query in explore_queries() if query.scans]
    plans = {query.name: set(operators(explained(session, query)[1].plan)) for query in told}
    assert [name for name, plan in plans.items() if not any("Scan" in operator for operator in plan)] == []


@pytest.mark.neo4j
@every_named_query
def test_its_columns_and_its_mode_are_those_that_it_declares_and_it_scans_where_it_says_why(session, query):
    columns, summary = explained(session, query)
    assert columns == query.columns
    assert summary.query_type in {"read": ("r",), "write": ("w", "rw")}[query.mode]
    scans = [name for name in operators(summary.plan) if "Scan" in name]
    assert query.mode != "read" or bool(scans) == bool(query.scans), scans


@pytest.mark.neo4j
@pytest.mark.parametrize("name", ["behind", "behind_one"])
def test_what_is_behind_or_before_a_node_is_found_by_a_search_that_visits_each_node_once(session, name):
    query = next(query for query in catalogue() if query.name == name)
    assert "VarLengthExpand(Pruning,BFS,All)" in set(operators(explained(session, query)[1].plan))


@pytest.mark.neo4j
@pytest.mark.parametrize(
    "name",
    [
        "attested", "count_joins", "count_operators", "evidence", "first_sightings", "forget_frames", "goals",
        "known_units", "load_evidence", "load_frames", "load_matters", "load_operators", "remember",
        "remembered",
    ],
)  # fmt: skip
def test_nodes_are_sought_by_their_keys_and_names(session, name):
    query = next(query for query in catalogue() if query.name == name)
    found = set(operators(explained(session, query)[1].plan))
    assert any(operator.startswith("NodeUniqueIndexSeek") for operator in found)


def test_the_declared_parameters_are_the_used_ones():
    used = {query.name: set(re.findall(r"\$(\w+)", code_of(query))) for query in ALL}
    assert used == {query.name: set(query.parameters) for query in ALL}


def test_the_header_says_what_it_answers():
    assert [query.name for query in ALL if not query.answers.endswith(".")] == []
    kinds = [(query.name, kind) for query in ALL for kind in query.parameters.values()]
    assert [one for one in kinds if one[1] not in EXAMPLE_VALUES] == []


def test_it_is_one_statement():
    assert [query.name for query in ALL if ";" in code_of(query)] == []


def test_its_columns_are_the_fields_of_the_type_that_receives_them():
    assert {query.name: STATEMENTS[query.name].row.columns for query in catalogue()} == {
        query.name: query.columns for query in catalogue()
    }


def test_code_uses_it():
    programs = [
        path.read_text()
        for room in ("graph", "offline")
        for path in (REPO / "foon_kg" / "store" / room).glob("*.py")
        if path.stem != "statements"
    ]
    used = {word for program in programs for word in re.findall(r"\w+", program)}
    assert [query.name for query in catalogue() if CONSTANTS[query.name] not in used] == []


def test_no_statement_names_a_query_that_is_not_there():
    assert STATEMENTS.keys() == {query.name for query in catalogue()}


def test_the_steps_of_the_schema_are_numbered_without_a_gap():
    assert [int(step.name[:4]) for step in schema_steps()] == list(range(1, len(schema_steps()) + 1))


@pytest.mark.parametrize("header", ["// nothing about it", "// mode: both", "// mode: read\n// mode: write"])
def test_a_header_that_does_not_say_the_mode_is_refused(header):
    with pytest.raises(ValueError, match=r"lost\.cypher: the header must say"):
        read_query("lost", f"{header}\nRETURN 1")


def test_only_three_places_hand_text_to_the_driver():
    """The catalogue's queries, the steps of the schema, and what a person typed."""
    sends = re.compile(r"\b(?:session|transaction|driver)\.(?:run|execute_query)\(")
    programs = (REPO / "foon_kg" / "store" / "graph").glob("*.py")
    assert {path.stem for path in programs if sends.search(path.read_text())} == {"statements", "schema", "free_cypher"}
