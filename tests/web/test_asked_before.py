"""What was asked before is answered at once, as it was; an answer has a mark by which to ask whether it still holds."""

from __future__ import annotations

import pytest
from fastapi.testclient import TestClient
from web.serving import SALAD, app
from web.test_service import GrowingFoon

from foon_kg.web.limits import Limits
from foon_kg.web.service import FoonService

ASKED = {"dish_type": SALAD["dish_type"], "ingredient": SALAD["ingredients"]}


@pytest.fixture
def served():
    with TestClient(app(), base_url="http://localhost") as client:
        yield client


def post(client, **more):
    return client.post("/api/plan", json=SALAD | more)


def get(client, mark=None, **more):
    return client.get("/api/plan", params=ASKED | more, headers={"If-None-Match": mark} if mark else {})


def test_to_get_a_plan_answers_what_to_post_it_does(served):
    assert get(served).content == post(served).content
    assert get(served, explain=True).content == post(served, explain=True).content
    assert get(served, avoid=["onion"]).content == post(served, avoid=["onion"]).content
    assert get(served, kitchen=["bowl"]).content == post(served, kitchen=["bowl"]).content


@pytest.mark.parametrize("ask", [get, post], ids=["GET", "POST"])
def test_what_was_asked_before_is_told_again_without_being_understood(served, ask, monkeypatch):
    first = ask(served)
    monkeypatch.setattr(FoonService, "asked", lambda *_: pytest.fail("it was asked again"))
    again = ask(served)
    assert (again.status_code, again.content) == (200, first.content)
    assert again.headers == first.headers


@pytest.mark.parametrize("times", [1, 2], ids=["understood", "asked before"])
def test_who_has_the_answer_is_told_that_it_holds(served, times):
    mark = get(served).headers["etag"]
    for _ in range(times):
        same = get(served, f'W/"other", {mark}')
    assert (same.status_code, same.content, same.headers["etag"]) == (304, b"", mark)
    assert get(served, '"other"').status_code == 200
    assert post(served).headers["cache-control"] == "no-store"


def test_a_refusal_is_no_answer_to_keep(served):
    asked = {"dish_type": "soup", "ingredient": ["chopped qwxyz"]}
    answers = [served.get("/api/plan", params=asked) for _ in range(2)]
    assert {answer.status_code for answer in answers} <= {404, 422}
    assert answers[0].content == answers[1].content
    assert "etag" not in answers[1].headers
    assert answers[1].headers["cache-control"] == "no-store"


def test_of_another_edition_it_is_asked_anew():
    foon = GrowingFoon(12)
    with TestClient(app(foon=foon), base_url="http://localhost") as client:
        before = get(client)
        foon.grow(23)
        after = get(client, before.headers["etag"])
    assert after.status_code == 200
    assert after.content != before.content


def test_while_nobody_knows_the_edition_it_is_asked_anew(monkeypatch):
    foon = GrowingFoon(23)
    asked = []
    ask = FoonService.asked
    monkeypatch.setattr(
        FoonService, "asked", lambda service, question: (asked.append(question), ask(service, question))[1]
    )
    with TestClient(app(foon=foon), base_url="http://localhost") as client:
        get(client)
        monkeypatch.setattr(foon, "fresh", lambda: None)
        get(client)
    assert len(asked) == 2


def test_it_is_refused_to_whom_it_would_be_if_it_were_new():
    limits = Limits(per_second=0.001, burst=2)
    with TestClient(app(limits=limits), base_url="http://localhost") as client:
        assert [get(client).status_code for _ in range(3)] == [200, 200, 429]
    with TestClient(app(token="a token of letters"), base_url="http://localhost") as client:
        known = {"Authorization": "Bearer a token of letters"}
        assert client.get("/api/plan", params=ASKED, headers=known).status_code == 200
        assert client.get("/api/plan", params=ASKED).status_code == 401
