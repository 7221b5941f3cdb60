"""What the API refuses because there is too much of it, and what it says of an error of its own."""

from __future__ import annotations

import asyncio
from dataclasses import replace

import httpx
from fastapi.testclient import TestClient
from web.serving import PLENTY, SALAD, app, error_of

from foon_kg.web.limits import Limits


def test_who_asks_too_often_has_to_wait():
    with TestClient(app(limits=Limits(per_second=0.001, burst=3)), base_url="http://localhost") as client:
        statuses = [client.get("/api/summary").status_code for _ in range(5)]
        assert statuses == [200, 200, 200, 429, 429]
        answer = client.get("/api/summary")
        assert int(answer.headers["retry-after"]) > 0
        assert error_of(answer)["code"] == "rate"


def test_an_error_of_its_own_tells_nothing_and_has_the_strict_policy():
    class Broken:
        def current(self):
            raise ZeroDivisionError("secret")

        def close(self):
            """Nothing is open."""

    with TestClient(app(foon=Broken()), base_url="http://localhost", raise_server_exceptions=False) as client:
        answer = client.get("/api/summary")
    assert answer.status_code == 500
    assert error_of(answer)["code"] == "internal"
    assert "secret" not in answer.text
    assert answer.headers["content-security-policy"].startswith("default-src 'none'")


def test_an_answer_that_takes_too_long_is_given_up():
    limits = Limits(seconds=0.0, per_second=PLENTY.per_second, burst=PLENTY.burst)
    with TestClient(app(limits=limits), base_url="http://localhost") as client:
        answer = client.post("/api/suggest", json={"foods": ["egg", "onion", "milk"], "most": 20})
    assert answer.status_code in {504, 408}
    assert error_of(answer)["code"] in {"timeout", "slow"}


def test_a_crowd_is_refused_in_the_form_of_every_error():
    async def crowd(requests):
        application = app(limits=replace(PLENTY, requests=requests))
        transport = httpx.ASGITransport(application)
        async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
            answers = await asyncio.gather(*(client.get("/api/summary") for _ in range(5)))
            return answers, await client.get("/api/summary")

    answers, later = asyncio.run(crowd(2))
    refused = [answer for answer in answers if answer.status_code == 503]
    assert len(refused) == 3
    assert {error_of(answer)["code"] for answer in refused} == {"busy"}
    assert all(
        answer.headers["retry-after"] == "1" and "content-security-policy" in answer.headers for answer in refused
    )
    assert later.status_code == 200


def test_more_than_there_are_places_for_is_refused():
    application = app(most=1)
    service = application.state.service
    with TestClient(application, base_url="http://localhost") as client:
        places = service.current().workers._places
        with places:  # the only one
            answer = client.post("/api/plan", json=SALAD)
        assert answer.status_code == 503
        assert answer.headers["retry-after"] == "1"
        assert error_of(answer)["code"] == "busy"
        assert client.post("/api/plan", json=SALAD).status_code == 200
