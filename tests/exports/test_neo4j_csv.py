"""What neo4j-admin imports from our CSV files is the FOON that a load would have written."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import neo4j
import pytest
from foons import foons
from hypothesis import given, settings

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.foon.demo import demo_folder
from foon_kg.formats.exports.neo4j_csv import AFTER, ARGUMENTS, write_neo4j_csv
from foon_kg.loaders import read_paths
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import Connection, Neo4jGraph, load
from foon_kg.store.offline.tables import LIST_DELIMITER
from foon_kg.store.snapshot import Snapshot

KITCHEN = Kitchen.default()
READ = {"long": int, "double": float, "boolean": lambda text: text == "true", "string": str}


def cells(text):
    """Split CSV as the import does: an empty field is nothing, an empty quoted one is an empty text."""
    marked = text.replace(',""', ',"\x00"')
    for row in csv.reader(io.StringIO(marked)):
        yield [None if cell == "" else cell.replace("\x00", "") for cell in row]


def value_of(cell, kind):
    """Return a cell as the import reads it: of lists, those that are empty or hold one empty text are left out."""
    name, many = kind.removesuffix("[]"), kind.endswith("[]")
    if cell is None or (many and cell == ""):
        return None
    return [READ[name](one) for one in cell.split(LIST_DELIMITER)] if many else READ[name](cell)


def table(text):
    """Yield the rows of a file as (ids, properties)."""
    header, *rows = cells(text)
    columns = [column.partition(":") for column in header]
    for row in rows:
        pairs = list(zip(columns, row, strict=True))
        ids = [cell for (name, _, kind), cell in pairs if not name]
        yield ids, {name: value_of(cell, kind or "string") for (name, _, kind), cell in pairs if name}


def imported(files, session):
    """Do with Cypher what neo4j-admin does offline, which a test has no time for."""
    texts = {file.name: file.text for file in files}
    options = [line.partition("=")[2].partition("=") for line in texts[ARGUMENTS].splitlines() if "./" in line]
    is_node = [line.startswith("--nodes") for line in texts[ARGUMENTS].splitlines() if "./" in line]
    for (name, _, path), node in zip(options, is_node, strict=True):
        text = texts[Path(path).name]
        rows = [{"ids": ids, "properties": values} for ids, values in table(text)]
        if node:
            session.run(f"UNWIND $rows AS row CREATE (n:{name}) SET n = row.properties, n.id = row.ids[0]", rows=rows)
            continue
        start, end = (column.partition("(")[2].rstrip(")") for column in text.split("\n")[0].split(",")[:2])
        session.run(
            f"UNWIND $rows AS row MATCH (a:{start} {{id: row.ids[0]}}), (b:{end} {{id: row.ids[1]}}) "
            f"CREATE (a)-[r:{name}]->(b) SET r = row.properties",
            rows=rows,
        )
    session.run("MATCH (n) REMOVE n.id")
    session.run(texts[AFTER])


@pytest.mark.neo4j
def test_what_is_imported_answers_as_what_was_loaded(empty_graph):
    subgraphs = [result.subgraph for result in read_paths([demo_folder()])][:4]
    foon = Snapshot.of(subgraphs, KITCHEN)
    costs = MotionCosts({"chop": 0.9, "pour": 0.1, "bird's \\ nest": 0.25})
    driver = neo4j.GraphDatabase.driver(empty_graph.uri, auth=(empty_graph.user, empty_graph.password))
    with driver, driver.session(database=empty_graph.database) as session:
        imported(write_neo4j_csv(foon, costs), session)
        stored = session.run("MATCH (m:Motion) RETURN DISTINCT m.verb, m.cost").values()
    assert {verb: cost for verb, cost in stored if cost is not None} == {"chop": 0.9, "pour": 0.1}
    with Connection(empty_graph) as connection:
        report = load(connection, subgraphs[:1])
    assert report.unchanged == (subgraphs[0].name,)
    with Neo4jGraph(empty_graph) as graph, graph.reading() as view:
        goals = foon.goals()
        assert view.subgraphs(view.video_names()) == foon.subgraphs
        assert view.vocabulary() == foon.vocabulary()
        assert view.goals() == goals
        assert view.motion_costs() == costs
        assert view.behind([goals[0].node], [("onion", "chopped")]) == foon.behind(
            [goals[0].node], [("onion", "chopped")]
        )
        assert view.equivalents(["caper", "leek"]) == foon.equivalents(["caper", "leek"])


@settings(max_examples=30, deadline=None)
@given(foons())
def test_edges_lead_to_rows_that_are_there_and_equal_foons_are_equal_files(subgraphs):
    files = write_neo4j_csv(Snapshot.of(subgraphs, KITCHEN))
    assert files == write_neo4j_csv(Snapshot.of(reversed(subgraphs), KITCHEN))
    texts = {file.name: file.text for file in files}
    ids = {
        name.removesuffix(".csv"): {row[0][0] for row in table(text)} for name, text in texts.items() if ":ID(" in text
    }
    for name, text in texts.items():
        if ":START_ID(" in text.split("\n")[0]:
            start, end = (column.partition("(")[2].rstrip(")") for column in text.split("\n")[0].split(",")[:2])
            assert all(a in ids[start] and b in ids[end] for (a, b), _ in table(text)), name


def test_the_arguments_name_every_file_and_the_statement_afterwards_is_one():
    files = write_neo4j_csv(Snapshot.of([r.subgraph for r in read_paths([demo_folder()])], KITCHEN))
    arguments = next(file.text for file in files if file.name == ARGUMENTS)
    assert {line.rpartition("./")[2] for line in arguments.splitlines() if "./" in line} == {
        file.name for file in files if file.name.endswith(".csv")
    }
    assert f"--array-delimiter=U+{ord(LIST_DELIMITER):04X}" in arguments
