"""The page that describes the API: all of it, without a program, within the policy, for everybody's eyes."""

from __future__ import annotations

import re
import shlex
from html.parser import HTMLParser
from pathlib import Path

import pytest
from chromium import SCREENS, as_usual, as_wide_as_the_screen, on_screen
from fastapi.testclient import TestClient
from web.driving import complaints, until
from web.serving import app

from foon_kg.web.api_page import api_page

AXE = Path(__file__).parents[1] / "vendor" / "axe.min.js"
FOUND = (
    "axe.run(document, {resultTypes: ['violations']}).then(told => arguments[0](told.violations.map(one => one.id)))"
)


class Page(HTMLParser):
    """The texts of code and headings, links and ids."""

    def __init__(self, text):
        super().__init__()
        self.ids, self.links, self.names, self.examples, self._inside = set(), set(), set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        told = dict(attrs)
        self.names.add(tag)
        self._inside.append(tag)
        if "id" in told:
            assert told["id"] not in self.ids
            self.ids.add(told["id"])
        if tag == "a":
            self.links.add(told["href"])
        if tag == "pre":
            self.examples.append("")

    def handle_endtag(self, tag):
        while self._inside and self._inside.pop() != tag:
            pass

    def handle_data(self, data):
        if "pre" in self._inside:
            self.examples[-1] += data


@pytest.fixture(scope="module")
def client():
    with TestClient(app(), base_url="http://localhost") as made:
        yield made


@pytest.fixture(scope="module")
def page_of(client):
    return Page(client.get("/api/docs").text)


def test_every_operation_and_every_schema_is_described_and_every_link_leads_somewhere(client, page_of):
    document = client.get("/api/openapi.json").json()
    operations = {f"{m}{path.replace('/', '-')}" for path, methods in document["paths"].items() for m in methods}
    schemas = set(document["components"]["schemas"]) - {"HTTPValidationError", "ValidationError"}
    assert operations | schemas == page_of.ids
    assert {link[1:] for link in page_of.links if link.startswith("#")} <= page_of.ids
    for link in page_of.links:
        if not link.startswith("#"):
            assert client.get(f"/api/{link}" if not link.startswith("..") else link[2:] or "/").status_code == 200
    assert not [name for name in schemas if not name.isalnum()], "two types of one name are told by their modules"
    assert not re.search(r">>>|:\w+:`", client.get("/api/docs").text)
    assert "script" not in page_of.names
    assert "style" not in page_of.names


def test_the_examples_are_answered(client, page_of):
    """Save the one in Cypher: this service takes none."""
    assert len(page_of.examples) == len([one for one in page_of.ids if re.match("get|post", one)])
    for example in page_of.examples:
        words = shlex.split(example.replace("\\\n", " "))
        address = next(word for word in words if word.startswith("http"))
        given = [words[place + 1].split("=", 1) for place, word in enumerate(words) if word == "--data-urlencode"]
        path = address.removeprefix("http://localhost:8000")
        if "--json" in words:
            body = words[words.index("--json") + 1]
            answer = client.post(path, content=body, headers={"content-type": "application/json"})
        else:
            answer = client.get(path, params=given)
        assert answer.status_code == (404 if path.endswith("cypher") else 200), (example, answer.text)


def test_who_has_no_token_may_read_what_there_is_to_ask():
    with TestClient(app(token="a-token-of-enough-letters"), base_url="http://localhost") as guarded:
        assert guarded.get("/api/docs").status_code == 200
        assert guarded.get("/api/docs/summary").status_code == 401
        assert guarded.get("/api/openapi.json").status_code == 401


def test_words_of_a_document_stay_words():
    hostile = "<script>alert(1)</script>"
    field = {"type": "string", "description": hostile, "default": hostile}
    operation = {
        "description": hostile,
        "parameters": [{"name": hostile, "schema": field, "description": hostile, "examples": [hostile]}],
        "responses": {"200": {"description": hostile}},
    }
    document = {"paths": {"/x": {"get": operation}}, "components": {"schemas": {"X": {"properties": {hostile: field}}}}}
    assert "<script>" not in api_page(document)


@pytest.mark.parametrize(("width", "scheme"), SCREENS)
def test_axe_finds_nothing_and_nothing_is_beyond_the_side(browser, address, width, scheme):
    as_usual(browser)
    browser.execute_cdp_cmd(
        "Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
    )
    on_screen(browser, width, 720, touch=width < 500)
    browser.get_log("browser")
    browser.get(f"{address}/api/docs")
    until(browser, "return document.readyState === 'complete'")
    assert complaints(browser) == []
    assert as_wide_as_the_screen(browser, width)
    browser.execute_script(AXE.read_text(encoding="utf-8"))
    assert browser.execute_async_script(FOUND) == []
