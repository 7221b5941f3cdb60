"""A FOON that is too large for memory is served by parts: the same answers as from the whole, or a plain refusal."""

from __future__ import annotations

import pytest
from pictures.demo_plans import demo_foon
from starlette.testclient import TestClient
from web.serving import SALAD, app

from foon_kg import Foon
from foon_kg.cli.demo import demo_subgraphs
from foon_kg.store.graph import Connection, load, remove
from foon_kg.web.foon import FixedFoon, LiveFoon

pytestmark = pytest.mark.neo4j

OMELETTE = {"dish_type": "omelette", "ingredients": ["egg", "butter", "salt"]}
COMPLETED = [
    ("ingredient", "chopped "),
    ("food", "on"), ("food", "oil"), ("food", ""), ("ingredient", "chop"), ("ingredient", "chopped on"),
    ("ingredient", "diced"), ("object", "bow"), ("object", "onions"), ("goal", "sal"), ("goal", "greek"),
    ("state", "cho"), ("dish", "o"), ("avoidable", "nu"), ("thing", "pan"),
]  # fmt: skip


@pytest.fixture(scope="module")
def whole():
    with TestClient(app(foon=FixedFoon(demo_foon())), base_url="http://localhost") as client:
        yield client


@pytest.fixture(scope="module")
def in_parts(emptied_server):
    with Connection(emptied_server) as connection:
        load(connection, demo_subgraphs())
    foon = LiveFoon(lambda: Foon(server=emptied_server), every=0.0, whole=0)
    with TestClient(app(foon=foon), base_url="http://localhost") as client:
        yield client


def both(whole, in_parts, method, path, **asked):
    answers = [getattr(client, method)(path, **asked) for client in (whole, in_parts)]
    assert answers[0].status_code == answers[1].status_code
    return [answer.json() for answer in answers]


@pytest.mark.parametrize("asked", [SALAD, OMELETTE, {"dish_type": "", "ingredients": ["egg", "chopped onion"]}])
def test_a_plan_is_the_same_with_all_that_is_told_of_it(whole, in_parts, asked):
    more = {"explain": True, "hands": [1, 2], "kitchen": []}
    expected, told = both(whole, in_parts, "post", "/api/plan", json=asked | more)
    assert told == expected


def test_what_has_no_tree_is_told_in_the_same_words(whole, in_parts):
    expected, told = both(whole, in_parts, "post", "/api/plan", json={"dish_type": "bread", "ingredients": ["flour"]})
    assert told["error"] == expected["error"]


def test_dishes_to_begin_with_and_suggestions_are_the_same(whole, in_parts):
    expected, told = both(whole, in_parts, "get", "/api/examples")
    assert told == expected
    expected, told = both(whole, in_parts, "post", "/api/suggest", json={"foods": ["egg", "butter", "salt"], "most": 3})
    assert told == expected


@pytest.mark.parametrize(("kind", "text"), COMPLETED)
def test_words_are_completed_alike(whole, in_parts, kind, text):
    expected, told = both(whole, in_parts, "get", "/api/complete", params={"kind": kind, "text": text})
    assert told == expected


def test_the_size_is_the_same(whole, in_parts):
    expected, told = both(whole, in_parts, "get", "/api/summary")
    assert told == expected


def test_likeness_and_what_is_around_an_object_are_the_same(whole, in_parts):
    expected, told = both(whole, in_parts, "get", "/api/similar", params={"name": ["caper", "kohlrabi"]})
    assert told == expected
    for label in ("onion", "knife"):
        expected, told = both(whole, in_parts, "get", "/api/object", params={"label": label})
        assert told["nodes"] == expected["nodes"]
        assert [told[side]["count"] for side in ("made_by", "taken_by")] == [
            expected[side]["count"] for side in ("made_by", "taken_by")
        ]
    expected, told = both(whole, in_parts, "get", "/api/object", params={"label": "onoin"})
    assert told["error"]["message"] == expected["error"]["message"]


def test_what_needs_the_whole_says_so(in_parts):
    refused = in_parts.get("/api/explore/begin")
    assert refused.status_code == 422
    assert "too large" in refused.json()["error"]["message"]
    refused = in_parts.post("/api/plan", json=SALAD | {"with_drafts": True})
    assert refused.status_code == 422
    assert "too large" in refused.json()["error"]["message"]


def test_a_new_edition_is_answered_from_by_the_same_workers(in_parts, emptied_server):
    service = in_parts.app.state.service
    workers, videos = service.current().workers, service.summary()["videos"]
    with Connection(emptied_server) as connection:
        gone = demo_subgraphs()[0]
        remove(connection, [gone.name])
        assert service.current().name
        service.reading.result(60)
        assert service.summary()["videos"] == videos - 1
        assert service.current().workers is workers
        load(connection, [gone])
