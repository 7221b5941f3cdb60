"""docs/reference/graph.md has every label, relationship and property with its type; Cypher in documents answers."""

from __future__ import annotations

import re
from collections import defaultdict
from dataclasses import asdict, replace
from pathlib import Path

import pytest
from kitchen_stories import unit

from foon_kg import Foon
from foon_kg.food.motion_costs import MotionCosts
from foon_kg.foon.demo import demo_folder
from foon_kg.language.collection import CollectionReader
from foon_kg.loaders import read_paths
from foon_kg.model import Annotation, FunctionalUnit, Measures, Subgraph, Timing
from foon_kg.model.collected import CollectedLine, CollectedRecipe
from foon_kg.model.drafted import DraftedRecipe
from foon_kg.store.graph import load, load_weights
from foon_kg.store.graph.drafts import load_drafts
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.graph.recipes import load_recipes

pytestmark = pytest.mark.neo4j

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "reference" / "graph.md").read_text(encoding="utf-8")
EXAMPLES = [
    pytest.param(text, id=f"{page.stem}-{number}")
    for page in sorted(DOCS.rglob("*.md"))
    for number, text in enumerate(re.findall(r"```cypher\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL), 1)
]
TYPES = {
    "STRING",
    "INTEGER",
    "FLOAT",
    "BOOLEAN",
    *(f"LIST<{one}>" for one in ("STRING", "INTEGER", "FLOAT", "BOOLEAN")),
}
PROPERTIES = (
    "MATCH (n) UNWIND keys(n) AS key RETURN DISTINCT labels(n), key, valueType(n[key])",
    "MATCH ()-[r]->() UNWIND keys(r) AS key RETURN DISTINCT [type(r)], key, valueType(r[key])",
)
NAMES = ("MATCH (n) UNWIND labels(n) AS x RETURN DISTINCT x", "MATCH ()-[r]->() RETURN DISTINCT type(r)")
OR_MISSING = ", or missing"
DRAFT = (
    "start,end,motion,inputs,outputs,dish,confidence,doubt,said,source\n"
    ",,mix,onion (chopped) in bowl; salt in bowl,onion salad (mixed) {onion} in bowl,salad,0.3,,,\n"
)


def documented():
    """Return the type of every property on the page, by its label or relationship and its name."""
    told, owner = {}, ""
    for row in re.findall(r"^\| (.*?) \| `(\w+)` \| (.*?) \| .* \|$", PAGE, re.MULTILINE):
        owner = row[0].strip("` ") or owner
        assert (owner, row[1]) not in told
        told[owner, row[1]] = row[2].replace("`", "")
    return told


def timed():
    """A video with what the demo has not: times, a food in no state, what moves as it comes out, measures."""
    stirred = unit("onion; bowl > mix > soup(mixed){onion}@bowl")
    moved = FunctionalUnit(stirred.inputs, "mix", tuple(replace(p, moving=True) for p in stirred.outputs))
    measures = Measures(("200 g onion",), 60.0, 90.0)
    return Subgraph("timed", (Annotation(moved, Timing(((2.0, 5.5),)), measures),), ("http://videos.org/timed",))


@pytest.fixture
def whole(connection, empty_graph):
    """A graph that has all that foon-kg ever writes."""
    demo = [result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None]
    load(connection, [*demo, timed()])
    lines = (CollectedLine("1 cup onion, chopped", "onion", "", "1", "cup"),)
    recipes = [
        CollectedRecipe("r1", "Green Salad", lines, "layer1.json: element 1", partition="train", url="http://r.org")
    ]
    load_recipes(connection, recipes, CollectionReader({}).understand)
    load_drafts(connection, [DraftedRecipe("d1", "Onion Salad", "salad", DRAFT, 1, 0, 0.3)])
    load_weights(connection, MotionCosts({"chop": 0.25}))
    settings = asdict(empty_graph) | {"password": empty_graph.password}
    with Foon.connect(**settings) as foon:
        foon.plan("salad", ["chopped onion", "olive oil"])
    return connection


def rows(connection, question):
    return ask_freely(connection, question, {}, limit=10_000).rows


def plain(kind):
    return kind.replace(" NOT NULL", "")


def test_the_page_has_all_that_is_in_a_graph_with_its_type_and_nothing_else(whole):
    told, there = documented(), defaultdict(set)
    assert {kind.removesuffix(OR_MISSING) for kind in told.values()} <= TYPES
    for question in PROPERTIES:
        for owners, key, kind in rows(whole, question):
            on_page = [(owner, key) for owner in owners if (owner, key) in told]
            assert on_page, f"{owners} {key} ({kind}) is not on the page"
            there[on_page[0]].add(kind.replace(" NOT NULL", ""))
    assert told.keys() - there.keys() == set(), "no graph has it"
    for name, kinds in there.items():
        assert kinds - {"LIST<NOTHING>"} <= {told[name].removesuffix(OR_MISSING)}, name
    for (owner, key), kind in told.items():
        pattern = f"()-[n:{owner}]->()" if owner.isupper() else f"(n:{owner})"
        missing = rows(whole, f"MATCH {pattern} WHERE n.{key} IS NULL RETURN count(n)")[0][0]
        assert not missing or kind.endswith(OR_MISSING), f"{owner}.{key} is missing {missing} times"
    named = set(re.findall(r":([A-Za-z_]+)[)\]]", PAGE)) | {owner for owner, _ in told} | {"Kind", "Form", "Appliance"}
    for question in NAMES:
        names = {name for (name,) in rows(whole, question)}
        assert len(names) > 10
        assert names - named == set()


@pytest.fixture
def demo(connection):
    load(connection, [result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None])
    return connection


def test_every_cypher_of_the_documents_answers_about_the_demo(demo):
    assert len(EXAMPLES) > 5
    for example in EXAMPLES:
        (text,) = example.values
        assert rows(demo, text), f"nothing answers {text}"
