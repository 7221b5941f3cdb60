"""What describes containers and Neo4j Browser holds together: no Docker engine is needed here."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.store.graph import Connection, load
from foon_kg.store.graph.free_cypher import ask_freely
from foon_kg.store.server.configuration import neo4j_conf

yaml = pytest.importorskip("yaml", reason="PyYAML is not installed")

ROOT = Path(__file__).parents[2]
SERVICES = yaml.safe_load((ROOT / "docker-compose.yml").read_text())["services"]
STYLE = (ROOT / "docs" / "foon.grass").read_text()
GUIDE = (ROOT / "docs" / "how-to" / "browser.md").read_text()
RULES = re.findall(r"^node\.(\w+) \{[^}]*caption: \"\{(\w+)\}\"; \}$", STYLE, re.MULTILINE)
EDGES = re.findall(r"^relationship\.(\w+) \{", STYLE, re.MULTILINE)
LOADED_LATER = {"Recipe"}  # by foon load recipes
QUESTIONS = re.findall(r"```cypher\n(.*?)```", GUIDE, re.DOTALL)


@pytest.fixture(scope="module")
def connection(emptied_server):
    with Connection(emptied_server) as connection:
        load(connection, [one.subgraph for one in read_paths([demo_folder()]) if one.subgraph is not None])
        yield connection


@pytest.mark.parametrize("name", sorted(SERVICES))
def test_only_this_machine_reaches_a_container(name):
    assert SERVICES[name]["ports"]
    assert all(port.startswith("127.0.0.1:") for port in SERVICES[name]["ports"])


def test_the_neo4j_of_the_container_is_closed_like_our_own():
    """Each setting of ours that is about questions of strangers is there, too."""
    told = SERVICES["neo4j"]["environment"]
    ours = dict(line.split("=", 1) for line in neo4j_conf(7687).splitlines() if "=" in line)
    names = [name for name in ours if re.search(r"csv_import|ip_blocklist|usage_report", name)]
    assert len(names) == 3
    for name in names:
        assert told["NEO4J_" + name.replace("_", "__").replace(".", "_")] == ours[name]
    assert told["NEO4J_server_http__enabled__modules"] == "BROWSER"


def test_the_service_waits_for_neo4j_and_has_no_rights():
    service = SERVICES["foon"]
    assert service["profiles"] == ["service"]
    assert service["depends_on"]["neo4j"]["condition"] == "service_healthy"
    assert service["read_only"]
    assert service["cap_drop"] == ["ALL"]


def test_the_image_has_the_locked_versions_and_all_that_the_wheel_is_made_of():
    dockerfile = (ROOT / "Dockerfile").read_text()
    assert re.search(r"^USER foon$", dockerfile, re.MULTILINE)
    pattern = re.search(r"s/(.*?)/\\1/p", dockerfile).group(1).replace(r"\(", "(").replace(r"\)", ")")
    locked = re.findall(pattern.removesuffix(".*"), (ROOT / "requirements-dev.txt").read_text(), re.MULTILINE)
    assert {"fastapi", "neo4j", "uvicorn", "vl-convert-python"} <= {line.partition("==")[0] for line in locked}
    copied = {line[1:].split("/")[0] for line in (ROOT / ".dockerignore").read_text().splitlines() if line[0] == "!"}
    assert {"cypher", "docs", "foon_kg", "loaders", "pyproject.toml", "README.md", "requirements-dev.txt"} <= copied
    assert all((ROOT / name).exists() for name in copied)


def test_the_style_has_no_comments():
    """Neo4j Browser takes one for a part of the next rule's name."""
    assert "/*" not in STYLE
    assert "//" not in STYLE
    assert len(RULES) == STYLE.count("node.")


@pytest.mark.neo4j
@pytest.mark.parametrize(("label", "caption"), RULES)
def test_what_the_style_names_is_in_the_graph(connection, label, caption):
    text = "MATCH (n) WHERE $label IN labels(n) RETURN count(n) AS nodes, count(n[$caption]) AS named"
    ((nodes, named),) = ask_freely(connection, text, {"label": label, "caption": caption}).rows
    assert nodes == named
    assert bool(nodes) == (label not in LOADED_LATER)


@pytest.mark.neo4j
def test_the_edges_that_the_style_names_are_in_the_graph(connection):
    there = {name for (name,) in ask_freely(connection, "CALL db.relationshipTypes()", {}).rows}
    assert EDGES
    assert there >= set(EDGES)


@pytest.mark.neo4j
@pytest.mark.parametrize("text", QUESTIONS, ids=lambda text: text.split("\n")[0][:50])
def test_a_question_of_the_guide_has_an_answer(connection, text):
    assert ask_freely(connection, text, {}).rows
