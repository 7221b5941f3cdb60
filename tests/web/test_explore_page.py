"""The page /explore in a real Chromium: searched, grown, filtered, followed by keyboard alone, narrow and dark."""

from __future__ import annotations

import hashlib
import re
from importlib import resources
from pathlib import Path

import pytest
from chromium import as_usual, as_wide_as_the_screen, on_screen
from web.serving import app, served

TOKEN = "a-token-of-enough-letters"
ENTER, TAB, DOWN, RIGHT, DELETE = "\ue007", "\ue004", "\ue015", "\ue014", "\ue017"
CY = "const cy = picture._cyreg.cy; "
VENDOR = Path(str(resources.files("foon_kg.web.explore").joinpath("page", "vendor")))


@pytest.fixture(scope="module")
def address():
    with served(app()) as found:
        yield found


@pytest.fixture
def page(browser, address):
    """The page, begun anew and without motion."""
    as_usual(browser)
    calm(browser)
    begin(browser, address)
    yield browser
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
    as_usual(browser)


def calm(browser, scheme="light"):
    features = {"prefers-reduced-motion": "reduce", "prefers-color-scheme": scheme}
    told = [{"name": name, "value": value} for name, value in features.items()]
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": told})


def begin(browser, address, asked=""):
    if asked:
        browser.get("about:blank")  # else what is the same up to “#” would not be loaded anew
    browser.get_log("browser")
    browser.get(f"{address}/explore{asked}")
    settled(browser)


def until(browser, script, *arguments):
    from selenium.webdriver.support.ui import WebDriverWait

    return WebDriverWait(browser, 60, poll_frequency=0.05).until(lambda it: it.execute_script(script, *arguments))


def settled(browser):
    """Wait for the answer to what was asked."""
    until(browser, "return !!about.firstChild && !picture.hasAttribute('aria-busy')")


def title(browser, text):
    until(browser, "return document.querySelector('#about h2')?.innerText === arguments[0]", text)
    settled(browser)


def shown(browser):
    return browser.execute_script(CY + "return cy.nodes().map(node => node.id())")


def edges(browser):
    return browser.execute_script(
        CY + "return cy.edges().map(e => [e.data('source'), e.data('kind'), e.data('target')])"
    )


def click_on(browser, name):
    """Click on a thing in the picture, where it is drawn."""
    from selenium.webdriver import ActionChains

    script = CY + "const at = cy.getElementById(arguments[0]).renderedPosition(); return [at.x, at.y]"
    x, y = browser.execute_script(script, name)
    box = browser.find_element("id", "picture")
    browser.execute_script("picture.scrollIntoView({block: 'center'})")
    middle = (box.size["width"] / 2, box.size["height"] / 2)
    ActionChains(browser).move_to_element_with_offset(box, round(x - middle[0]), round(y - middle[1])).click().perform()


def press(browser, *keys):
    from selenium.webdriver import ActionChains

    ActionChains(browser).send_keys(*keys).perform()


def complaints(browser):
    return [entry["message"] for entry in browser.get_log("browser") if entry["level"] in {"SEVERE", "WARNING"}]


def search(browser, text, *keys):
    browser.find_element("id", "text").send_keys(text, *(keys or (ENTER,)))


def test_what_is_searched_is_drawn_with_what_is_around_it(page):
    search(page, "oni")
    title(page, "onion")
    assert "food:onion" in shown(page)
    assert any(name.startswith("step:") for name in shown(page))
    assert 10 < len(shown(page)) <= 23
    assert page.execute_script("return location.hash") == "#at=food%3Aonion"
    assert "takes part in 30 steps" in page.find_element("id", "about").text
    assert page.find_element("id", "count").text == f"{len(shown(page))} things in the picture"
    assert complaints(page) == []


def test_the_names_of_all_kinds_come_as_one_types(page):
    search(page, "chop", DOWN)
    until(page, "return text.getAttribute('aria-activedescendant')")
    found = page.find_elements("css selector", "[role=option]")
    assert found[0].text.split() == ["chop", "motion"]
    assert {"food in a state"} <= {option.find_elements("css selector", "small")[-1].text for option in found}
    press(page, ENTER)
    title(page, "chop")


def test_a_name_that_nobody_has_is_said_to_be_unknown(page):
    search(page, "zzz", DOWN)
    until(page, "return document.querySelector('#text-found').innerText")
    assert "Nothing in this FOON" in page.find_element("id", "text-found").text


def test_the_picture_grows_by_a_click(page):
    search(page, "onion")
    title(page, "onion")
    before = shown(page)
    name = page.execute_script(
        CY
        + """
        const inside = ({x, y}) => x > 30 && y > 30 && x < cy.width() - 30 && y < cy.height() - 30;
        return cy.nodes('[mark="object"][more > 0]').filter(node => inside(node.renderedPosition()))[0].id()"""
    )
    click_on(page, name)
    until(page, CY + "return cy.$('node.chosen').id() === arguments[0]", name)
    settled(page)
    assert set(before) < set(shown(page))
    assert any(name in (source, target) for source, kind, target in edges(page) if kind in {"takes", "makes"})
    assert "new thing" in page.find_element("id", "status").text
    assert complaints(page) == []


def test_every_edge_joins_what_is_shown_and_grown_parts_are_joined_with_the_older(page):
    search(page, "onion")
    title(page, "onion")
    for _ in range(3):
        page.execute_script(CY + "cy.nodes('[mark=\"object\"][more > 0]')[0].emit('tap')")
        settled(page)
    known = set(shown(page))
    joined = {end for source, _, target in edges(page) for end in (source, target)}
    assert known == joined


def test_the_side_panel_says_what_a_step_is_and_leads_on(page):
    search(page, "greek_salad")
    title(page, "greek_salad")
    page.find_element("css selector", "#about .thing[data-id^='step:']").send_keys(ENTER)
    until(page, "return about.querySelector('.kind').innerText.trim() === 'step'")
    settled(page)
    inside = "const box = cy.$('node.chosen').renderedBoundingBox(); return box.x1 >= 0 && box.x2 <= cy.width()"
    until(page, CY + inside)
    told = page.find_element("id", "about").text
    assert "Where it is seen" in told
    assert "greek_salad" in told
    motion = page.find_element("css selector", "#about .thing[data-id^='motion:']")
    name = motion.get_attribute("data-id")
    motion.send_keys(ENTER)
    title(page, name.partition(":")[2])
    assert name in shown(page)


def test_filters_hold_for_the_picture_and_are_in_its_address(page, address):
    search(page, "onion")
    title(page, "onion")
    page.find_element("css selector", "#filters summary").click()
    whole = set(shown(page))
    page.execute_script("motion.value = 'chop'; motion.dispatchEvent(new Event('change', {bubbles: true}))")
    until(page, "return location.hash.includes('motion=chop')")
    script = CY + "return cy.nodes('[mark=\"step\"]').map(node => node.data('thing').name)"
    until(page, f"const steps = (() => {{ {script} }})(); return steps.length && steps.every(one => one === 'chop')")
    settled(page)
    assert set(shown(page)) != whole
    assert page.find_element("id", "filters-told").text == "chop"
    asked = page.execute_script("return location.hash")
    begin(page, address, asked)
    assert page.execute_script("return motion.value") == "chop"
    assert set(page.execute_script(script)) == {"chop"}


def test_the_shortest_way_is_drawn_and_told_step_by_step(page):
    page.find_element("id", "start").send_keys("whole potato")
    page.find_element("id", "end").send_keys("boiled potato", ENTER)
    until(page, "return about.querySelector('h2').innerText.startsWith('6 steps from whole potato to')")
    told = [one.text for one in page.find_elements("css selector", "#about .steps .thing")]
    assert told[0].startswith("Peel the potato")
    assert told[-1].startswith("Boil the potato")
    assert len(shown(page)) == 13
    kinds = page.execute_script(CY + "return cy.nodes().map(node => node.data('thing').name)")
    assert "knife" not in kinds
    assert page.execute_script("return location.hash") == "#from=whole+potato&to=boiled+potato"
    assert complaints(page) == []


def test_a_way_goes_from_one_thing_to_another_that_were_chosen(page):
    search(page, "whole cucumber")
    title(page, "cucumber")
    page.find_element("xpath", "//button[text()='Way from here']").send_keys(ENTER)
    assert page.switch_to.active_element.get_attribute("id") == "end"
    press(page, "greek salad", ENTER)
    until(page, "return about.querySelector('h2').innerText.includes('greek salad')")
    assert "Toss" in page.find_element("id", "about").text


def test_no_way_says_why(page):
    page.find_element("id", "start").send_keys("mashed potato")
    page.find_element("id", "end").send_keys("soup", ENTER)
    until(page, "return !!about.querySelector('[role=alert]')")
    assert "It is seen boiled" in page.find_element("css selector", "[role=alert]").text


def test_the_picture_is_walked_grown_and_pruned_by_keyboard_alone(page):
    search(page, "whole cucumber")
    title(page, "cucumber")
    page.execute_script("picture.focus()")
    first = page.execute_script(CY + "return cy.$('node.chosen').id()")
    press(page, RIGHT)
    until(page, CY + "return cy.$('node.chosen').id() !== arguments[0]", first)
    settled(page)
    name = page.execute_script(CY + "return cy.$('node.chosen').id()")
    assert page.execute_script(CY + "return cy.getElementById(arguments[0]).position('x')", name) > page.execute_script(
        CY + "return cy.getElementById(arguments[0]).position('x')", first
    )
    before = shown(page)
    press(page, ENTER)
    until(page, CY + "return cy.nodes().length > arguments[0]", len(before))
    settled(page)
    press(page, DELETE)
    until(page, CY + "return cy.getElementById(arguments[0]).empty()", name)
    assert "is taken out" in page.execute_script(
        "return document.querySelector('#status').innerText"
    ) or name not in shown(page)


def test_every_control_is_reached_by_tab_and_shows_that_it_has_the_focus(page):
    search(page, "onion")
    title(page, "onion")
    page.execute_script("document.querySelector('.skip').focus()")
    reached = []
    for _ in range(25):
        press(page, TAB)
        assert page.execute_script("""
            const now = document.activeElement;
            return now === document.body || getComputedStyle(now).outlineStyle !== 'none'""")
        reached.append(page.switch_to.active_element.get_attribute("id"))
    assert {"text", "start", "end", "larger", "smaller", "all", "tidy", "picture"} <= set(reached)


def test_going_back_leads_to_the_picture_before(page):
    search(page, "onion")
    title(page, "onion")
    search(page, "knife")
    title(page, "knife")
    assert page.execute_script("return location.hash") == "#at=utensil%3Aknife"
    page.back()
    title(page, "onion")
    assert page.execute_script("return location.hash") == "#at=food%3Aonion"
    assert page.execute_script(CY + "return cy.$('node.chosen').id()") == "food:onion"


@pytest.mark.parametrize("asked", ["", "#at=food:onion", "#from=whole+potato&to=boiled+potato"])
def test_a_narrow_screen_shows_all_within_its_width(page, address, asked):
    on_screen(page, 375, 800, touch=True)
    begin(page, address, asked)
    assert as_wide_as_the_screen(page, 375)
    small = page.execute_script("""
        return [...document.querySelectorAll('button, select, input:not([type=checkbox])')]
            .filter(one => one.offsetParent && one.getBoundingClientRect().height < 32).map(one => one.outerHTML)""")
    assert small == []
    words = page.execute_script(CY + "return cy.zoom() * 14")
    assert words >= 10


def test_the_picture_has_the_colours_of_the_scheme_also_when_that_changes(page):
    search(page, "onion")
    title(page, "onion")
    light = page.execute_script(CY + "return cy.nodes()[0].style('color')")
    calm(page, "dark")
    until(page, CY + "return cy.nodes()[0].style('color') !== arguments[0]", light)
    ink = page.execute_script(CY + "return cy.nodes()[0].style('color')")
    assert sum(map(int, re.findall(r"\d+", ink)[:3])) > 600 > sum(map(int, re.findall(r"\d+", light)[:3]))


def test_the_token_is_asked_for(browser):
    as_usual(browser)
    with served(app(token=TOKEN)) as address:
        browser.get("about:blank")
        browser.get(f"{address}/explore")
        until(browser, "return !document.querySelector('#token').hidden")
        browser.find_element("id", "token-text").send_keys(TOKEN, ENTER)
        title(browser, "Where to begin")
        assert not browser.find_element("id", "token").is_displayed()


def test_the_planning_page_leads_here(browser, address):
    as_usual(browser)
    browser.get(f"{address}/")
    browser.find_element("css selector", "a[href=explore]").click()
    title(browser, "Where to begin")
    assert browser.current_url == f"{address}/explore"
    browser.get("about:blank")


def test_programs_of_others_are_the_named_versions_with_their_licences():
    rows = re.findall(
        r"^\| (\S+\.\w+) \| \S+ \| [\d.]+ \| (\w{64}) \|$", (VENDOR / "VERSIONS.md").read_text(), re.MULTILINE
    )
    files = {path.name for path in VENDOR.iterdir() if path.suffix in {".js", ".mjs"}}
    assert {name for name, _ in rows} == files
    for name, digest in rows:
        assert hashlib.sha256((VENDOR / name).read_bytes()).hexdigest() == digest
        assert (VENDOR / f"{name.partition('.')[0]}.LICENSE").read_text().startswith("Copyright")
