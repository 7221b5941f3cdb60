"""Drafts of recipes on the page: offered where there are any, taken only where they are asked, and told as drafts."""

from __future__ import annotations

import pytest
from chromium import as_usual
from contract.test_drafts import COOKIE
from pictures.demo_plans import demo_foon
from starlette.testclient import TestClient
from web.driving import asked, open_page, text_of
from web.serving import app, served

from foon_kg.cli.console import json_line
from foon_kg.cli.serve import served_foon
from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import lessons
from foon_kg.loaders.lessons import lessons_of
from foon_kg.web.foon import FixedFoon

BISCUITS = {"dish_type": "cookie", "ingredients": ["flour", "butter", "sugar"]}


@pytest.fixture
def drafted():
    return app(foon=FixedFoon(demo_foon(), lessons_of([COOKIE])))


def test_drafts_count_only_where_they_are_asked(drafted):
    client = TestClient(drafted, base_url="http://localhost")
    summary = client.get("/api/summary").json()
    assert (summary["drafts"], summary["drafted_types"]) == (1, ["cookie"])
    assert client.post("/api/plan", json=BISCUITS).status_code == 404
    told = client.post("/api/plan", json=BISCUITS | {"with_drafts": True, "explain": True}).json()
    assert told["reference"]["draft_confidence"] == pytest.approx(0.52)
    again = client.get(
        "/api/plan", params={"dish_type": "cookie", "ingredient": BISCUITS["ingredients"], "with_drafts": True}
    ).json()
    assert again["units"] == told["units"]


def test_files_of_drafts_are_read_once(tmp_path, monkeypatch):
    file, opened, opening = tmp_path / "drafts.jsonl", [], lessons._open
    file.write_text(json_line(COOKIE.to_json()), encoding="utf-8")
    monkeypatch.setattr(lessons, "_open", lambda path: opened.append(path) or opening(path))
    (lesson,) = served_foon([demo_folder(), file], str).read().lessons
    assert lesson.title == COOKIE.title
    assert opened == [file]


def test_a_service_without_drafts_tells_of_none():
    summary = TestClient(app(), base_url="http://localhost").get("/api/summary").json()
    assert (summary["drafts"], summary["drafted_types"]) == (0, [])


def test_a_dish_that_drafts_alone_have_is_asked_with_them_and_told_as_one(browser, drafted):
    as_usual(browser)
    with served(drafted) as address:
        open_page(browser, address)
        browser.execute_script("dish.value = 'cookie'; dish.dispatchEvent(new Event('change'))")
        assert browser.find_element("id", "with-drafts").is_selected()
        for food in BISCUITS["ingredients"]:
            browser.find_element("id", "ingredient").send_keys(food, "\ue007")
        browser.find_element("id", "go").click()
        asked(browser)
        assert "drafts=yes" in browser.current_url
        told = text_of(browser, "#view-steps")
        assert "nobody has reviewed (0.52 sure)" in told
        assert "Made like the cookie of draft c1" in told
        browser.refresh()
        asked(browser)
        assert browser.find_element("id", "with-drafts").is_selected()


def test_where_there_are_no_drafts_the_page_does_not_offer_them(page):
    assert page.execute_script("return drafts.hidden && !document.querySelector('[data-drafted]')")
