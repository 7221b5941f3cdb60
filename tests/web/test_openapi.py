"""The API keeps to its own OpenAPI document, whatever is sent: checked by schemathesis over a real socket."""

from __future__ import annotations

import jsonschema_rs
import pytest
from examples import examples
from fastapi.testclient import TestClient
from hypothesis import given
from web.serving import SALAD, app, served

CONFIG = {
    "checks": {
        # 422: a food nobody knows; 413: a text that is short enough by its letters, and too long by their bytes
        "positive_data_acceptance": {"expected-statuses": ["2xx", 404, 413, 422]},
        "negative_data_rejection": {
            "expected-statuses": [400, 401, 403, 404, 405, 406, 409, 413, 415, 422, 428, 429, "5xx"]
        },
    }
}
OPERATIONS = (
    ("/api/summary", "GET"),
    ("/api/examples", "GET"),
    ("/api/complete", "GET"),
    ("/api/similar", "GET"),
    ("/api/object", "GET"),
    ("/api/plan", "GET"),
    ("/api/plan", "POST"),
    ("/api/suggest", "POST"),
    ("/api/explore/search", "GET"),
    ("/api/explore/begin", "GET"),
    ("/api/explore/around", "POST"),
    ("/api/explore/way", "POST"),
    ("/api/explore/questions", "GET"),
    ("/api/explore/cypher", "POST"),
    ("/api/teach/review", "POST"),
    ("/api/teach/subgraph", "POST"),
)


@pytest.fixture(scope="module")
def document():
    schemathesis = pytest.importorskip("schemathesis", reason="schemathesis is not installed")
    with served(app()) as address:
        config = schemathesis.Config.from_dict(CONFIG)
        yield schemathesis.openapi.from_url(f"{address}/api/openapi.json", config=config)


@pytest.mark.slow
def test_every_operation_is_tried_here(document):
    found = {(result.ok().path, result.ok().method.upper()) for result in document.get_all_operations()}
    assert found == set(OPERATIONS)


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["positive", "negative"])
@pytest.mark.parametrize(("path", "method"), OPERATIONS)
def test_answers_are_as_the_document_says(document, path, method, mode):
    operation = document[path][method]
    exact = {"/api/summary", "/api/examples", "/api/explore/begin", "/api/explore/questions"}
    if mode == "negative" and path in exact:
        return  # it takes nothing that could be wrong

    from schemathesis import GenerationMode  # it takes a second, of each process that collects the tests

    answers = []

    @examples(4)
    @given(case=operation.as_strategy(generation_mode=GenerationMode(mode)))
    def ask(case):
        answer = case.call()
        case.validate_response(answer)  # the status, the headers and the body are as the document says
        answers.append(answer)

    ask()
    assert answers
    assert all(("error" in answer.json()) == (answer.status_code >= 400) for answer in answers)


ASKED_FULLY = SALAD | {
    "ingredients": ["2 cups kohlrabi, sliced", "chopped onion", "3 tablespoons olive oil"],
    "explain": True,
    "hands": [1, 2],
    "pictures": True,
    "export": "pddl",
}


@pytest.mark.parametrize(
    ("method", "path", "asked"),
    [
        ("post", "/api/plan", SALAD),
        ("post", "/api/plan", ASKED_FULLY),
        ("post", "/api/suggest", {"foods": ["egg", "onion"]}),
        ("get", "/api/similar", {"name": "kohlrabi"}),
        ("get", "/api/summary", {}),
        ("get", "/api/examples", {}),
        ("get", "/api/object", {"label": "onion"}),
        ("get", "/api/explore/begin", {}),
        ("post", "/api/explore/around", {"id": "food:onion"}),
    ],
)
def test_an_answer_has_no_field_that_is_not_described(method, path, asked):
    with TestClient(app(), base_url="http://localhost") as client:
        document = client.get("/api/openapi.json").json()
        answer = client.post(path, json=asked) if method == "post" else client.get(path, params=asked)
    assert answer.status_code == 200, answer.text
    for schema in document["components"]["schemas"].values():
        schema.setdefault("additionalProperties", "properties" not in schema)
    told = document["paths"][path][method]["responses"]["200"]["content"]["application/json"]["schema"]
    jsonschema_rs.validator_for(told | {"components": document["components"]}).validate(answer.json())
