"""A plan is taken along: its address is copied, and it is downloaded in the form of every export."""

from __future__ import annotations

import json

import pytest
from pictures.demo_plans import demo_foon
from starlette.testclient import TestClient
from web.driving import plan, text_of, until
from web.serving import SALAD, app

from foon_kg import Foon
from foon_kg.formats.exports.formats import ENDINGS

OF_TREES = [form for form in ENDINGS if form not in {"csv", "weights"}]


@pytest.fixture(scope="module")
def client():
    with TestClient(app(), base_url="http://localhost") as made:
        yield made


@pytest.mark.parametrize("form", OF_TREES)
def test_a_plan_is_answered_in_the_form_of_every_export(client, form):
    files = client.post("/api/plan", json=SALAD | {"export": form}).json()["files"]
    exported = Foon(snapshot=demo_foon()).plan(SALAD["dish_type"], SALAD["ingredients"]).export(form)
    assert all(file["text"] in exported for file in files)
    assert sum(len(file["text"]) for file in files) > 100
    assert len(files) == (3 if form == "pddl" else 1)


def test_a_form_that_is_none_or_for_whole_foons_is_refused(client):
    for form in ("csv", "no-such-form"):
        told = client.post("/api/plan", json=SALAD | {"export": form})
        assert (told.status_code, told.json()["error"]["code"]) == (422, "usage")


def test_the_page_downloads_every_form(page, tmp_path):
    from selenium.webdriver.support.ui import WebDriverWait

    got = tmp_path / "got"
    page.execute_cdp_cmd("Browser.setDownloadBehavior", {"behavior": "allow", "downloadPath": str(got)})
    plan(page, "chopped onion", "diced tomato")
    offered = page.execute_script("return [...document.querySelectorAll('.take option')].map(one => one.value)")
    assert sorted(offered) == sorted(OF_TREES)
    for form in ("markdown", "json"):
        page.execute_script("document.querySelector('.take select').value = arguments[0]", form)
        page.find_element("xpath", "//button[text()='Download']").click()
        until(page, "return document.querySelector('.take [role=status]').textContent.endsWith('in your downloads.')")
        name = text_of(page, ".take [role=status]").split(" ")[0]
        file = got / name
        WebDriverWait(page, 60, 0.05).until(lambda _, file=file: file.exists())
        text = file.read_text(encoding="utf-8")
        assert text.startswith("# ") if form == "markdown" else json.loads(text)
