"""The page of a plan in a real Chromium: it draws, moves by keyboard and mouse, and is dark in the dark."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
from chromium import PAPERS, as_usual, as_wide_as_the_screen, fingers, on_screen, papers
from pictures.demo_plans import demo_plan

pytest.importorskip("fast_sugiyama", reason="the extra “pictures” is not installed")
from foon_kg.foon.demo import demo_folder
from foon_kg.formats.pictures.page import page_of, steps_list
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.loaders import read_paths
from foon_kg.plans.kitchen import Kitchen

KITCHEN = Kitchen.default()


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    path = tmp_path_factory.mktemp("page") / "plan.html"
    path.write_text(page_of(ShownTree.of_result(demo_plan("kohlrabi_salad")), KITCHEN), encoding="utf-8")
    return path


@pytest.mark.parametrize(("source", "linked"), [("http://[oops", False), ("http://x.org/a.mp4", True)])
def test_what_is_no_address_is_no_link(source, linked):
    (salad,) = (one.subgraph for one in read_paths([demo_folder() / "greek_salad.txt"]))
    steps = steps_list(ShownTree.of_subgraph(replace(salad, sources=(source,))))
    assert (f'href="{source}' in steps) is linked


@pytest.fixture
def opened(browser, page):
    as_usual(browser)
    browser.get_log("browser")
    browser.get(page.as_uri())
    drawn(browser)
    return browser


def drawn(browser):
    """Wait until the picture has its first view."""
    browser.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")


def view(browser):
    return [float(n) for n in browser.execute_script("return stage.firstElementChild.getAttribute('viewBox')").split()]


def press(browser, *keys):
    browser.find_element("id", "stage").send_keys(*keys)
    return view(browser)


@pytest.mark.slow
def test_nothing_is_refused_or_fetched(opened):
    assert opened.get_log("browser") == []
    assert opened.execute_script("return performance.getEntriesByType('resource').length") == 0


@pytest.mark.slow
def test_every_box_holds_its_words(opened):
    beyond = opened.execute_script("""
        return [...document.querySelectorAll('#stage g')].filter(g => g.querySelector(':scope > rect')).filter(g => {
            const box = g.querySelector(':scope > rect').getBBox();
            return [...g.querySelectorAll(':scope > text')].some(t => t.getBBox().width > box.width);
        }).map(g => g.textContent)""")
    assert beyond == []


@pytest.mark.slow
def test_arrow_keys_move_and_zoom_keys_zoom(opened):
    start = view(opened)
    right = press(opened, "\ue014")
    assert right[0] > start[0]
    assert right[1:] == start[1:]
    down = press(opened, "\ue015")
    assert down[1] > right[1]
    assert press(opened, "+")[2] < down[2]
    x, y, width, height = press(opened, "0")
    whole = opened.execute_script("const box = stage.querySelector('.paper').getBBox(); return [box.width, box.height]")
    assert y == 0
    assert [x + width, height] >= whole
    assert press(opened, *["\ue012"] * 30)[0] == pytest.approx(-width / 2, abs=0.01)  # it does not get lost


def test_the_stage_is_reached_by_tab_and_says_what_it_is(opened):
    stage = opened.find_element("id", "stage")
    assert stage.get_attribute("tabindex") == "0"
    assert "Arrow keys" in stage.get_attribute("aria-label")


def test_buttons_do_what_the_keys_do(opened):
    before = view(opened)
    opened.find_element("css selector", "[data-do=larger]").click()
    assert view(opened)[2] < before[2]
    opened.find_element("css selector", "[data-do=all]").click()
    assert view(opened) == press(opened, "0")
    opened.find_element("css selector", "[data-do=own]").click()
    assert view(opened)[2] == opened.execute_script("return stage.clientWidth")


def test_a_stage_without_room_shows_the_picture_again_when_it_has_some(opened):
    for width in ("0", ""):
        opened.execute_async_script(
            """
            const [width, done] = arguments;
            stage.style.width = width;
            requestAnimationFrame(() => requestAnimationFrame(done));""",
            width,
        )
    _, _, width, height = view(opened)
    assert 0 < height < 10_000
    ratio = opened.execute_script("return stage.clientHeight / stage.clientWidth")
    assert height / width == pytest.approx(ratio, abs=0.01)
    assert [entry for entry in opened.get_log("browser") if entry["level"] == "SEVERE"] == []


def test_a_mouse_drags_the_picture(opened):
    from selenium.webdriver import ActionChains

    before = view(opened)
    stage = opened.find_element("id", "stage")
    ActionChains(opened).drag_and_drop_by_offset(stage, -80, -60).perform()
    after = view(opened)
    assert after[0] > before[0]
    assert after[1] > before[1]


def test_the_wheel_scrolls_the_page_unless_it_is_asked_for_the_picture(opened):
    from selenium.webdriver import ActionChains
    from selenium.webdriver.common.action_chains import ScrollOrigin

    stage = opened.find_element("id", "stage")
    on_it = ScrollOrigin.from_element(stage)
    before = view(opened)
    ActionChains(opened).scroll_from_origin(on_it, 0, 40).perform()
    assert view(opened) == before
    ActionChains(opened).key_down("\ue009").scroll_from_origin(on_it, 0, -200).key_up("\ue009").perform()
    larger = view(opened)
    assert larger[2] < before[2]
    stage.click()
    ActionChains(opened).scroll_from_origin(on_it, 0, 40).perform()
    after = view(opened)
    assert after[1] > larger[1]
    assert after[2:] == larger[2:]


def test_two_fingers_zoom_and_move_and_one_scrolls_the_page(opened):
    on_screen(opened, 375, touch=True)
    opened.refresh()
    drawn(opened)
    opened.execute_script("stage.scrollIntoView({block: 'center'})")
    before, scrolled = view(opened), opened.execute_script("return scrollY")
    spread = [[(150, 350), (220, 350)], [(140, 350), (230, 350)], [(100, 350), (270, 350)]]
    fingers(opened, ("touchStart", spread[0][:1]), ("touchStart", spread[0]), *[("touchMove", at) for at in spread[1:]])
    fingers(opened, ("touchEnd", []))
    zoomed = view(opened)
    assert zoomed[2] == pytest.approx(before[2] * 70 / 170, rel=0.02)
    together = [[(150, 350), (220, 350)], [(150, 330), (220, 330)], [(150, 300), (220, 300)]]
    fingers(opened, ("touchStart", together[0]), *[("touchMove", at) for at in together[1:]], ("touchEnd", []))
    moved = view(opened)
    assert moved[1] > zoomed[1]
    assert moved[2:] == zoomed[2:]
    assert opened.execute_script("return scrollY") == scrolled
    fingers(opened, ("touchStart", [(150, 350)]), *[("touchMove", [(150, y)]) for y in (320, 280, 240)])
    fingers(opened, ("touchEnd", []))
    assert view(opened) == moved


@pytest.mark.parametrize("scheme", PAPERS)
def test_the_picture_and_the_page_follow_light_and_dark(opened, scheme):
    assert papers(opened, scheme, "#stage") == [PAPERS[scheme]] * 2


@pytest.mark.parametrize("width", [360, 1200])
def test_the_page_is_no_wider_than_the_screen(opened, width):
    on_screen(opened, width)
    assert as_wide_as_the_screen(opened, width)


def test_hostile_words_stay_words():
    plan = demo_plan("kohlrabi_salad").to_json()
    hostile = json.loads(json.dumps(plan).replace("kohlrabi", "<img src=x onerror=alert(1)>"))
    from foon_kg.plans.result import PlanResult

    html = page_of(ShownTree.of_result(PlanResult.from_json(hostile)), KITCHEN)
    assert "<img" not in html
    assert "&lt;img src=x onerror=alert(1)&gt;" in html


def test_a_step_links_to_the_second_of_its_video_only_by_web_addresses(page):
    import dataclasses

    from foon_kg.model import Sighting

    result = demo_plan("kohlrabi_salad")
    seen = (Sighting("soup", 3, "https://example.org/watch?v=1", 65.0, 70.0),)
    odd = (Sighting("soup", 3, "javascript:alert(1)", 65.0, 70.0),)
    for sightings, linked in ((seen, True), (odd, False)):
        units = tuple(dataclasses.replace(unit, seen_in=sightings) for unit in result.units)
        html = page_of(ShownTree.of_result(dataclasses.replace(result, units=units)), KITCHEN)
        assert ('href="https://example.org/watch?v=1#t=65"' in html) is linked
        assert "javascript:" not in html
        assert "soup at 1:05" in html
