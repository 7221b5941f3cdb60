"""The page's opening: what this FOON knows, dishes of its own to click, and what was planned in this browser lately."""

from __future__ import annotations

import httpx
from pictures.demo_plans import demo_foon
from web.driving import ENTER, PLANNED, TAB, focused, open_page, plan, text_of, until
from web.serving import app, served

from foon_kg.store.snapshot import Snapshot
from foon_kg.web.foon import FixedFoon

EXAMPLES = "return document.querySelectorAll('#examples .dish').length"
NAMES = "return [...document.querySelectorAll(arguments[0] + ' .dish strong')].map(one => one.innerText.toLowerCase())"


def test_the_opening_says_what_the_foon_knows(page, address):
    told = httpx.get(f"{address}/api/summary").json()
    types = len(told["dish_types"])
    said = (
        f"This FOON knows {told['foods']} foods and {types} types of dishes, from {told['units']} steps of 23 videos."
    )
    assert text_of(page, "#knows") == said


def test_its_dishes_are_those_of_the_foon_and_a_click_plans_one(page, address):
    until(page, EXAMPLES)
    told = httpx.get(f"{address}/api/examples").json()["examples"]
    assert page.execute_script(NAMES, "#examples") == [one["name"] for one in told]
    dish = page.find_element("css selector", "#examples .dish")
    steps = dish.find_element("css selector", ".aside").text
    dish.send_keys(ENTER)
    until(page, PLANNED)
    assert text_of(page, "#result h1") == f"{told[0]['name']}: {steps}"
    assert not page.find_element("id", "opening").is_displayed()


def test_a_foon_in_which_nothing_is_yet_says_so(page):
    empty = Snapshot.of([], demo_foon().kitchen)
    with served(app(foon=FixedFoon(empty))) as other:
        page.get(f"{other}/")
        until(page, "return document.querySelector('#examples').innerText.includes('This FOON is empty.')")
        assert not page.find_element("id", "lead").is_displayed()
        page.get(f"{other}/explore")
        until(page, "return document.querySelector('#about').innerText.includes('This FOON is empty.')")
        assert not page.find_element("id", "picture").is_displayed()


def test_another_foon_has_other_dishes(page):
    only = Snapshot.of((one for one in demo_foon().subgraphs if one.name == "lemonade"), demo_foon().kitchen)
    with served(app(foon=FixedFoon(only))) as other:
        open_page(page, other)
        until(page, EXAMPLES)
        assert page.execute_script(NAMES, "#examples") == ["lemonade"]


def test_what_was_planned_is_offered_again_until_it_is_forgotten(page, address):
    assert text_of(page, "#recent") == ""
    plan(page, "chopped onion", "diced tomato")
    planned = page.current_url
    open_page(page, address)
    until(page, EXAMPLES)  # what is drawn before the examples are there is drawn anew
    dish = page.find_element("css selector", "#recent .dish")
    assert "chopped onion, diced tomato" in dish.text
    dish.send_keys(ENTER)
    until(page, PLANNED)
    assert page.current_url == planned
    page.find_element("xpath", "//a[text()='Plan a dish']").send_keys(ENTER)
    until(page, "return !document.querySelector('#opening').hidden")  # as it is shown, its cards are drawn anew
    page.find_element("xpath", "//button[text()='Forget them']").send_keys(ENTER)
    assert text_of(page, "#recent") == ""
    open_page(page, address)
    assert text_of(page, "#recent") == ""


def test_a_dish_is_reached_by_the_skip_link_and_the_tabulator(page):
    from selenium.webdriver import ActionChains

    until(page, EXAMPLES)
    ActionChains(page).send_keys(TAB, ENTER, TAB).perform()
    assert focused(page).get_attribute("class") == "card dish"
