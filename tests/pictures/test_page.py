"""The page of a plan in a real Chromium: it draws, moves by keyboard and mouse, and is dark in the dark."""

from __future__ import annotations

import json

import pytest
from chromium import chromium
from pictures.demo_plans import demo_plan

pytest.importorskip("fast_sugiyama", reason="the extra “pictures” is not installed")
from foon_kg.kitchen import Kitchen
from foon_kg.pictures.page import page_of
from foon_kg.views.shown_tree import ShownTree

KITCHEN = Kitchen.default()


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    path = tmp_path_factory.mktemp("page") / "plan.html"
    path.write_text(page_of(ShownTree.of_result(demo_plan("parsnip_soup")), KITCHEN), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    with chromium(tmp_path_factory.mktemp("profile")) as driver:
        yield driver


@pytest.fixture
def opened(browser, page):
    browser.get(page.as_uri())
    return browser


def view(browser):
    return [float(n) for n in browser.execute_script("return stage.firstElementChild.getAttribute('viewBox')").split()]


def press(browser, *keys):
    browser.find_element("id", "stage").send_keys(*keys)
    return view(browser)


def test_nothing_is_refused_or_fetched(opened):
    assert opened.get_log("browser") == []
    assert opened.execute_script("return performance.getEntriesByType('resource').length") == 0


def test_every_box_holds_its_words(opened):
    beyond = opened.execute_script("""
        return [...document.querySelectorAll('#stage g')].filter(g => g.querySelector(':scope > rect')).filter(g => {
            const box = g.querySelector(':scope > rect').getBBox();
            return [...g.querySelectorAll(':scope > text')].some(t => t.getBBox().width > box.width);
        }).map(g => g.textContent)""")
    assert beyond == []


def test_arrow_keys_move_and_zoom_keys_zoom(opened):
    start = view(opened)
    right = press(opened, "\ue014")
    assert right[0] > start[0]
    assert right[1:] == start[1:]
    down = press(opened, "\ue015")
    assert down[1] > right[1]
    assert press(opened, "+")[2] < down[2]
    assert press(opened, "0")[:2] == [0, 0]


def test_the_stage_is_reached_by_tab_and_says_what_it_is(opened):
    stage = opened.find_element("id", "stage")
    assert stage.get_attribute("tabindex") == "0"
    assert "Arrow keys" in stage.get_attribute("aria-label")


def test_buttons_do_what_the_keys_do(opened):
    before = view(opened)
    opened.find_element("css selector", "[data-do=in]").click()
    assert view(opened)[2] < before[2]


def test_a_mouse_drags_the_picture(opened):
    from selenium.webdriver import ActionChains

    before = view(opened)
    stage = opened.find_element("id", "stage")
    ActionChains(opened).drag_and_drop_by_offset(stage, -80, -60).perform()
    after = view(opened)
    assert after[0] > before[0]
    assert after[1] > before[1]


@pytest.mark.parametrize(("scheme", "paper"), [("light", "rgb(255, 255, 255)"), ("dark", "rgb(22, 24, 29)")])
def test_the_picture_and_the_page_follow_light_and_dark(opened, scheme, paper):
    opened.execute_cdp_cmd(
        "Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
    )
    colours = opened.execute_script("""
        return [getComputedStyle(document.body).backgroundColor,
                getComputedStyle(document.querySelector('#stage .paper')).fill]""")
    assert colours == [paper, paper]


@pytest.mark.parametrize("width", [360, 1200])
def test_the_page_is_no_wider_than_the_screen(opened, width):
    screen = {"width": width, "height": 700, "deviceScaleFactor": 1, "mobile": False}
    opened.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
    assert opened.execute_script("return document.documentElement.scrollWidth") <= width
    opened.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def test_hostile_words_stay_words():
    plan = demo_plan("parsnip_soup").to_json()
    hostile = json.loads(json.dumps(plan).replace("parsnip", "<img src=x onerror=alert(1)>"))
    from foon_kg.result import PlanResult

    html = page_of(ShownTree.of_result(PlanResult.from_json(hostile)), KITCHEN)
    assert "<img" not in html
    assert "&lt;img src=x onerror=alert(1)&gt;" in html


def test_a_step_links_to_the_second_of_its_video_only_by_web_addresses(page):
    import dataclasses

    from foon_kg.model import Sighting

    result = demo_plan("parsnip_soup")
    seen = (Sighting("soup", 3, "https://example.org/watch?v=1", 65.0, 70.0),)
    odd = (Sighting("soup", 3, "javascript:alert(1)", 65.0, 70.0),)
    for sightings, linked in ((seen, True), (odd, False)):
        units = tuple(dataclasses.replace(unit, seen_in=sightings) for unit in result.units)
        html = page_of(ShownTree.of_result(dataclasses.replace(result, units=units)), KITCHEN)
        assert ('href="https://example.org/watch?v=1&amp;t=65"' in html) is linked
        assert "javascript:" not in html
        assert "soup at 1:05" in html
