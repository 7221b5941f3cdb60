"""A plan is one document, whoever asks: the command, the API and an agent; what need not be there is left out."""

from __future__ import annotations

import json

import pytest
from contract.test_drafts import COOKIE
from fastapi.testclient import TestClient
from pictures.demo_plans import demo_foon
from typer.testing import CliRunner
from web.serving import SALAD, app
from web.test_agents import asked, value

from foon_kg.cli import app as commands
from foon_kg.cli.console import json_line
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders.lessons import lessons_of
from foon_kg.web import telling, telling_plans
from foon_kg.web.agents import agent_server
from foon_kg.web.foon import FixedFoon
from foon_kg.web.service import FoonService
from foon_kg.web.telling import Told

COOKIES = {"dish_type": "cookie", "ingredients": ["flour", "butter", "sugar"], "with_drafts": True}
SOUP = {"dish_type": "soup", "title": "Cream of parsnip soup", "ingredients": ["chopped parsnip", "2 cups water"]}
MAYBE = {"draft_confidence", "technique", "measures", "amount", "part", "phase", "grounding", "thing", "missing"}
"""Members that are there only where they say something."""


@pytest.fixture(scope="module")
def foon():
    return FixedFoon(demo_foon(), lessons_of([COOKIE]))


@pytest.fixture(scope="module")
def client(foon):
    with TestClient(app(foon=foon), base_url="http://localhost") as made:
        yield made


def printed(question, drafts):
    """Return what ``foon plan --json`` prints."""
    files = ["--files", str(demo_folder()), *(["--files", str(drafts)] if question.get("with_drafts") else [])]
    title = ["--title", question["title"]] if "title" in question else []
    drafted = ["--with-drafts"] if question.get("with_drafts") else []
    dish = ["--dish", question["dish_type"]]
    ran = CliRunner().invoke(commands, ["plan", *dish, *title, *question["ingredients"], *drafted, *files, "--json"])
    assert ran.exit_code == 0, ran.output
    return json.loads(ran.stdout)


def members(told):
    """Yield each member of a document, with its name, at whatever depth."""
    if isinstance(told, dict):
        yield from told.items()
        told = list(told.values())
    if isinstance(told, list):
        for one in told:
            yield from members(one)


@pytest.mark.parametrize("question", [SALAD, SOUP, COOKIES], ids=["salad", "soup", "draft"])
def test_command_service_and_agent_tell_the_same(foon, client, question, tmp_path):
    drafts = tmp_path / "drafts.jsonl"
    drafts.write_text(json_line(COOKIE.to_json()), encoding="utf-8")
    command = printed(question, drafts)
    api = client.post("/api/plan", json=question).json()
    with FoonService(foon) as service:
        (answer,) = asked(agent_server(service), ("plan", question))
    agent = value(answer)
    assert api == agent
    assert {name: api[name] for name in command} == command
    said = dict.fromkeys(name for name, told in members(api) if name in MAYBE and told in (None, "", [], {}))
    assert list(said) == []
    assert ("draft_confidence" in api["reference"]) is ("with_drafts" in question)


def test_what_is_around_an_object_leaves_out_what_nobody_measured(client):
    told = client.get("/api/object", params={"label": "onion"}).json()
    seen = [one for part in ("made_by", "taken_by") for unit in told[part]["units"] for one in unit["seen_in"]]
    assert seen
    assert [one for one in seen if one.get("measures", 1) is None] == []
    assert all("source" in one for one in seen)  # what a place has or has not is told either way


def test_the_document_of_the_api_says_that_what_need_not_be_there_is_left_out(client):
    schemas = client.get("/api/openapi.json").json()["components"]["schemas"]
    told = {
        name: one for module in (telling, telling_plans) for name, one in vars(module).items() if isinstance(one, type)
    }
    optional = {
        (name, member): row
        for name, schema in schemas.items()
        if issubclass(told.get(name, object), Told)
        for member, row in schema.get("properties", {}).items()
        if member not in schema.get("required", ())
    }
    assert {("Reference", "technique"), ("Reference", "draft_confidence"), ("Wanted", "part")} <= set(optional)
    wrong = [name for name, row in optional.items() if "default" in row or {"type": "null"} in row.get("anyOf", ())]
    assert wrong == []
