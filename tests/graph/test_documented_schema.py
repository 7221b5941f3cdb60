"""docs/reference/graph.md names every label, relationship and property that a load writes."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.store.graph import load
from foon_kg.store.graph.free_cypher import ask_freely

pytestmark = pytest.mark.neo4j

PAGE = (Path(__file__).parents[2] / "docs" / "reference" / "graph.md").read_text(encoding="utf-8")
NAMED = set(re.findall(r"`([A-Za-z_]+)`", PAGE)) | set(re.findall(r":([A-Za-z_]+)[)\]]", PAGE))


QUESTIONS = (
    "MATCH (n) UNWIND labels(n) AS name RETURN DISTINCT name",
    "MATCH (n) UNWIND keys(n) AS name RETURN DISTINCT name",
    "MATCH ()-[r]->() RETURN DISTINCT type(r) AS name",
    "MATCH ()-[r]->() UNWIND keys(r) AS name RETURN DISTINCT name",
)


def test_the_page_of_the_graph_names_all_that_is_there(connection):
    load(connection, [result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None])
    for question in QUESTIONS:
        there = {row[0] for row in ask_freely(connection, question, {}, limit=1_000).rows}
        assert len(there) > 10
        assert there - NAMED == set()
