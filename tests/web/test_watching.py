"""For who keeps the service running: health, and what was counted, read as Prometheus does."""

from __future__ import annotations

import re

import httpx
import pytest
from fastapi.testclient import TestClient
from hypothesis import given
from hypothesis import strategies as st
from pictures.demo_plans import demo_foon
from web.serving import SALAD, app, served

from foon_kg import __version__
from foon_kg.model.errors import GraphError
from foon_kg.store.snapshot import Snapshot
from foon_kg.web.foon import FixedFoon
from foon_kg.web.metrics import Metrics

TOKEN = "a-token-of-enough-letters"
SAMPLE = re.compile(r'([a-z_]+)(?:\{((?:[a-z]+="(?:[^"\\\n]|\\[\\"n])*",?)*)\})? (\S+)')
LABEL = re.compile(r'([a-z]+)="((?:[^"\\]|\\.)*)"')


def read(text):
    """The samples of a text, as its format says: every name is described, with a type, before its first sample."""
    described, samples = {}, {}
    for line in text.removesuffix("\n").split("\n"):
        if line.startswith("# TYPE "):
            _, _, name, kind = line.split(" ", 3)
            assert name not in described
            described[name] = kind
        elif not line.startswith("# HELP "):
            name, labels, value = SAMPLE.fullmatch(line).groups()
            family = re.sub(r"_(bucket|sum|count)$", "", name)
            assert described[name if name in described else family]
            found = {
                key: re.sub(r"\\(.)", lambda m: {"n": "\n"}.get(m[1], m[1]), v)
                for key, v in LABEL.findall(labels or "")
            }
            key = name, *sorted(found.items())
            assert key not in samples, "each once"
            samples[key] = float(value)
    assert text.endswith("\n")
    return samples


def sample(samples, name, **labels):
    return samples.get((name, *sorted(labels.items())), 0.0)


@pytest.fixture
def client():
    with TestClient(app(), base_url="http://localhost", raise_server_exceptions=False) as made:
        yield made


def test_who_can_plan_is_healthy(client):
    answer = client.get("/health")
    assert (answer.status_code, answer.json()) == (200, {"status": "ok"})


def test_a_foon_in_which_nothing_is_yet_is_healthy():
    empty = Snapshot.of([], demo_foon().kitchen)
    with TestClient(app(foon=FixedFoon(empty)), base_url="http://localhost") as client:
        assert client.get("/health").status_code == 200
        assert sample(read(client.get("/metrics").text), "foon_units") == 0


def test_who_has_no_foon_says_so_as_any_other_question_does():
    class Gone:
        def edition(self):
            raise GraphError("nothing answers", hint="Start it.", code="unreachable")

        def fresh(self):
            return None

        def close(self):
            pass

    with TestClient(app(foon=Gone()), base_url="http://localhost") as client:
        told = client.get("/health")
        assert told.status_code == 503
        assert told.json() == client.get("/api/summary").json()
        assert sample(read(client.get("/metrics").text), "foon_ready") == 0


def test_every_request_is_counted_by_what_became_of_it(client):
    client.get("/api/summary")
    client.post("/api/plan", json=SALAD)
    client.post("/api/plan", json=SALAD)
    client.post("/api/plan", json={})
    client.get("/api/complete")
    client.post("/api/teach/subgraph", json={})
    client.get("/teach")
    client.get("/nothing/of/this?name=x")
    client.request("BREW", "/api/summary")
    answer = client.get("/metrics")
    assert answer.headers["content-type"] == "text/plain; version=0.0.4; charset=utf-8"
    samples = read(answer.text)

    def requests(path, method, status):
        return sample(samples, "foon_requests_total", path=path, method=method, status=str(status))

    assert requests("/api/summary", "GET", 200) == 1
    assert requests("/api/plan", "POST", 200) == 2, "what was asked before as well"
    assert requests("/api/plan", "POST", 422) == 1
    assert requests("/api/complete", "GET", 422) == 1
    assert requests("/api/teach/subgraph", "POST", 422) == 1
    assert requests("/teach", "GET", 200) == 1
    assert requests("other", "GET", 404) == 1
    assert requests("/api/summary", "other", 415) + requests("/api/summary", "other", 405) == 1
    assert sample(samples, "foon_request_seconds_count", path="/api/plan") == 3
    assert sample(samples, "foon_answers_kept") == 1
    assert sample(samples, "foon_ready") == 1
    assert sample(samples, "foon_videos") == 23
    assert sample(samples, "foon_requests_under_way") == 1, "this one"
    (info,) = [dict(key[1:]) for key in samples if key[0] == "foon_info"]
    assert info["version"] == __version__


def test_what_was_refused_is_counted_and_what_was_counted_asks_for_the_token():
    with TestClient(app(token=TOKEN), base_url="http://localhost") as guarded:
        assert guarded.get("/health").status_code == 200
        assert guarded.get("/metrics").status_code == 401
        told = guarded.get("/metrics", headers={"authorization": f"Bearer {TOKEN}"})
        assert sample(read(told.text), "foon_requests_total", path="/metrics", method="GET", status="401") == 1


@given(st.lists(st.tuples(st.sampled_from(["/a", "/b", "/c"]), st.floats(0, 40)), max_size=30))
def test_buckets_count_what_took_no_longer(requests):
    metrics = Metrics(["/a", "/b"])
    for path, seconds in requests:
        metrics.count(path, "GET", 200, seconds)
    samples = read(metrics.text({}, {}))
    for path in ("/a", "/b", "other"):
        took = [seconds for asked, seconds in requests if (asked if asked != "/c" else "other") == path]
        for key, value in samples.items():
            labels = dict(key[1:])
            if key[0] == "foon_request_seconds_bucket" and labels["path"] == path:
                end = float(labels["le"].replace("+Inf", "inf"))
                assert value == sum(seconds <= end for seconds in took)
        assert sample(samples, "foon_request_seconds_sum", path=path) == pytest.approx(sum(took), abs=1e-5)
        assert sample(samples, "foon_request_seconds_count", path=path) == len(took)


@given(st.text(max_size=8))
def test_any_label_is_read_back(text):
    assert ("foon_info", ("edition", text)) in read(Metrics(()).text({}, {"edition": text}))


def test_an_error_of_its_own_is_counted_too(client, monkeypatch):
    monkeypatch.setattr("foon_kg.web.words.FoonWords.summary", lambda _: 1 / 0)
    assert client.get("/api/summary").status_code == 500
    samples = read(client.get("/metrics").text)
    assert sample(samples, "foon_requests_total", path="/api/summary", method="GET", status="500") == 1
    assert sample(samples, "foon_requests_under_way") == 1


def test_what_is_no_http_is_refused_as_everything_else_is():
    import socket

    with served(app()) as address:
        host, port = address.removeprefix("http://").split(":")
        with socket.create_connection((host, int(port))) as line:
            line.sendall(b"\x01\x02 nothing\r\n\r\n")
            with line.makefile("rb") as file:
                head, _, body = file.read().partition(b"\r\n\r\n")
    told = httpx.Response(400, content=body).json()
    assert head.startswith(b"HTTP/1.1 400 ")
    assert b"content-security-policy" in head.lower()
    assert told == {"error": {"code": "request", "message": "invalid http request received", "hint": "Send HTTP/1.1."}}
