"""The page /teach in a real Chromium: a draft decided on beside what was said, kept, undone, downloaded."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from chromium import SCREENS, as_usual, as_wide_as_the_screen, on_screen
from web.driving import complaints
from web.serving import app, served

from foon_kg.language.reviewing import Review
from foon_kg.loaders.text_reader import read_text

AXE = Path(__file__).parents[1] / "vendor" / "axe.min.js"
FOUND = """
    axe.run(document, {resultTypes: ['violations']}).then(told => arguments[0](told.violations.map(
        one => `${one.id}: ${one.nodes.map(node => node.html).join(' ')}`)))"""
TOKEN = "a-token-of-enough-letters"
ENTER, TAB, ESCAPE = "\ue007", "\ue004", "\ue00c"
DRAFT = """start,end,motion,inputs,outputs,dish,confidence,doubt,said,source
0:01,0:04,peel,onion on cutting board; knife,onion (peeled) on cutting board,,0.90,,“peel the onion”,https://videos.example/1
0:05,0:31,chop,onion (peeled) on cutting board; knife,onion (chopped) on cutting board,,0.03,no <b>unit</b> chops onions,“chop it”,https://videos.example/1
0:40,0:44,pick-and-place,onion (chopped) on cutting board; xyzzy (empty),onion (chopped) in xyzzy; xyzzy {onion},,0.80,,“into the xyzzy”,
0:45,,,,,,0.00,“wow” is no motion of the FOON: left out,“wow”,
"""  # noqa: E501


@pytest.fixture(scope="module")
def address():
    with served(app()) as found:
        yield found


@pytest.fixture
def page(browser, address, tmp_path):
    """The page, begun anew, with downloads in ``got`` below ``tmp_path``."""
    as_usual(browser)
    where = {"behavior": "allow", "downloadPath": str(tmp_path / "got")}
    browser.execute_cdp_cmd("Browser.setDownloadBehavior", where)
    begin(browser, address)
    yield browser
    browser.execute_script("localStorage.clear(); sessionStorage.clear()")
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
    as_usual(browser)


def begin(browser, address):
    browser.get_log("browser")
    browser.get(f"{address}/teach")


def until(browser, script, *arguments):
    from selenium.webdriver.support.ui import WebDriverWait

    return WebDriverWait(browser, 60, poll_frequency=0.05).until(lambda it: it.execute_script(script, *arguments))


def open_draft(page, tmp_path, text=DRAFT, name="kitchen.csv"):
    (tmp_path / name).write_text(text)
    page.find_element("id", "file").send_keys(str(tmp_path / name))
    until(page, "return draft.checkVisibility() || trouble.innerText")


def rows(page):
    return page.execute_script("return [...document.querySelectorAll('#rows > li')].map(li => li.innerText)")


def pressed(page, *keys):
    """Type where the focus is."""
    page.switch_to.active_element.send_keys(*keys)


def left(page, count):
    until(page, "return document.querySelectorAll('#rows > li[data-open]').length === arguments[0]", count)


def downloaded(tmp_path, name, page):
    from selenium.webdriver.support.ui import WebDriverWait

    got = tmp_path / "got" / name  # Chromium makes it empty first
    WebDriverWait(page, 60, poll_frequency=0.05).until(lambda _: got.exists() and got.stat().st_size)
    return got.read_text()


def test_each_row_stands_beside_what_was_said_and_enter_accepts(page, tmp_path):
    open_draft(page, tmp_path)
    left(page, 3)
    first, second, third = rows(page)
    assert "“chop it”" in first
    assert "video at 0:05 to 0:31" in first
    assert "Chop the onion on the cutting board with the knife." in first
    assert "Doubt: no <b>unit</b> chops onions" in first
    assert "“xyzzy” is not in the table of utensils" in second
    assert "No unit." in third
    link = page.find_element("css selector", "#rows a")
    assert link.get_attribute("href") == "https://videos.example/1#t=5"
    assert not page.find_element("id", "done").is_enabled()
    for count in (2, 1, 0):
        pressed(page, ENTER)
        left(page, count)
    until(page, "return document.activeElement === done")
    assert "All is decided: 3 units." in page.find_element("id", "told").text
    pressed(page, ENTER)
    text = downloaded(tmp_path, "kitchen.txt", page)
    units = [one.unit.motion for one in read_text(text, "kitchen").subgraph.annotations]
    assert units == ["peel", "chop", "pick-and-place"]
    assert complaints(page) == []


def test_a_row_is_edited_in_place_and_what_is_no_unit_is_told(page, tmp_path):
    open_draft(page, tmp_path)
    left(page, 3)
    page.find_element("css selector", "[aria-label='Edit row 2']").send_keys(ENTER)
    assert page.switch_to.active_element.get_attribute("value") == "chop"
    inputs = page.find_element("id", "edit-1-inputs")
    inputs.clear()
    inputs.send_keys("((", ENTER)
    until(page, "return trouble.innerText.length > 0")
    assert len(rows(page)) == 3
    inputs = page.find_element("id", "edit-1-inputs")
    inputs.clear()
    inputs.send_keys("onion (peeled) on cutting board; cleaver", ENTER)
    left(page, 2)
    kept = json.loads(page.execute_script("return localStorage.getItem('foon-teach')"))
    row = Review.of(kept["table"], "kitchen").rows[1]
    assert row["inputs"] == "onion (peeled) on cutting board; cleaver"
    assert (row["doubt"], row["reviewed"]) == ("", "yes")
    page.find_element("css selector", "[aria-label='Edit row 3']").send_keys(ENTER)
    pressed(page, ESCAPE)
    assert page.switch_to.active_element.get_attribute("aria-label") == "Edit row 3"
    assert all("422" in line for line in complaints(page))


def test_who_leaves_goes_on_where_they_were_and_undoes(page, address, tmp_path):
    open_draft(page, tmp_path)
    left(page, 3)
    pressed(page, ENTER)
    left(page, 2)
    begin(page, address)
    left(page, 2)
    assert "“into the xyzzy”" in rows(page)[0]
    page.find_element("css selector", "[aria-label='Leave out row 3']").send_keys(ENTER)
    left(page, 1)
    page.find_element("id", "undo").click()
    left(page, 2)
    page.find_element("id", "all").click()
    assert len(rows(page)) == 4
    assert "decided" in rows(page)[1]
    page.find_element("id", "keep").click()
    table = downloaded(tmp_path, "kitchen.csv", page)
    assert Review.of(table, "kitchen").accepted(2).accepted(3).decisions == ()
    page.find_element("id", "close").click()
    begin(page, address)
    assert page.find_element("id", "open").is_displayed()


def test_what_is_no_draft_and_what_is_too_long_is_told(page, tmp_path):
    open_draft(page, tmp_path, "a,b\n1,2\n", "other.csv")
    assert "no table of units" in page.find_element("id", "trouble").text
    open_draft(page, tmp_path, DRAFT + "," * 600_000, "long.csv")
    until(page, "return !trouble.innerText.includes('no table of units')")
    assert page.find_element("id", "trouble").text


def test_a_token_is_asked_for(browser, tmp_path):
    with served(app(token=TOKEN)) as address:
        begin(browser, address)
        open_draft(browser, tmp_path)
        until(browser, "return document.activeElement.id === 'token-text'")
        pressed(browser, TOKEN, ENTER)
        until(browser, "return token.hidden")
        open_draft(browser, tmp_path)
        left(browser, 3)
        browser.execute_script("localStorage.clear(); sessionStorage.clear()")


@pytest.mark.parametrize(("width", "scheme"), SCREENS)
def test_axe_finds_nothing_and_nothing_is_beyond_the_side(page, tmp_path, width, scheme):
    page.execute_cdp_cmd(
        "Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
    )
    on_screen(page, width, 720, touch=width < 500)
    page.execute_script(AXE.read_text(encoding="utf-8"))
    found = {"empty": page.execute_async_script(FOUND)}
    open_draft(page, tmp_path)
    left(page, 3)
    page.find_element("id", "all").click()
    found["draft"] = page.execute_async_script(FOUND)
    page.find_element("css selector", "[aria-label='Edit row 2']").send_keys(ENTER)
    found["editing"] = page.execute_async_script(FOUND)
    assert as_wide_as_the_screen(page, width)
    assert found == {"empty": [], "draft": [], "editing": []}
