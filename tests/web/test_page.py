"""The page in a real Chromium: asked by keyboard alone, asked again, narrow, dark, and when things go wrong."""

from __future__ import annotations

import base64
import itertools

import pytest
from chromium import PAPERS, as_wide_as_the_screen, on_screen, papers
from web.driving import (
    CONTROL,
    DOWN,
    ENTER,
    PLANNED,
    TAB,
    VIEWS,
    asked,
    chips,
    complaints,
    focused,
    plan,
    text_of,
    until,
    view,
)
from web.serving import app, served

TOKEN = "a-token-of-enough-letters"


def test_a_dish_is_planned_by_keyboard_alone(page):
    from selenium.webdriver import ActionChains

    def press(*keys):
        ActionChains(page).send_keys(*keys).perform()

    press(TAB)
    assert focused(page).text == "Skip to the answer"
    press(*[TAB] * len(page.find_elements("css selector", "header nav a")), TAB)
    assert focused(page).get_attribute("id") == "dish"
    press("salad", TAB)
    assert focused(page).get_attribute("id") == "ingredient"
    press("chopped on")
    until(page, "return ingredient.getAttribute('aria-expanded') === 'true'")
    press(DOWN)
    active = page.execute_script("return ingredient.getAttribute('aria-activedescendant')")
    assert page.find_element("id", active).text == "chopped onion"
    press(ENTER)
    assert page.execute_script("return [...wanted.children].map(li => li.firstChild.data)") == ["chopped onion"]
    press("sliced kohlrabi", ENTER, *[TAB] * 5)
    assert focused(page).get_attribute("id") == "go"
    press(ENTER)
    asked(page)
    assert page.execute_script("return document.getElementById('status').textContent") == "Done."
    steps = page.execute_script("return document.querySelectorAll('.steps li').length")
    assert text_of(page, "#result h1").endswith(f"{steps} steps")
    press(TAB, TAB, TAB, ENTER)
    until(page, "return document.body.dataset.view === 'tree'")
    assert page.execute_script("return document.querySelectorAll('.stage svg rect').length") > 10
    assert complaints(page) == []


def test_every_control_shows_that_it_has_the_focus(page):
    from selenium.webdriver import ActionChains

    plan(page, "sliced kohlrabi")
    page.execute_script("document.activeElement.blur()")
    for _ in range(30):
        ActionChains(page).send_keys(TAB).perform()
        shown = page.execute_script("""
            const now = document.activeElement;
            return now === document.body || getComputedStyle(now).outlineStyle !== 'none'""")
        assert shown, focused(page).get_attribute("outerHTML")


def test_another_equivalent_is_chosen_and_taken_back(page):
    plan(page, "chopped zucchini", "chopped onion")
    view(page, "why")
    first = text_of(page, "#result .plain strong")
    other = page.find_element("css selector", "[data-like]")
    name = other.get_attribute("data-like")
    assert "zucchini" in other.get_attribute("aria-label")
    other.send_keys(ENTER)
    until(page, "return result.innerText.includes('your choice')")
    assert text_of(page, "#result .plain strong") == name != first
    page.find_element("xpath", "//button[text()='undo my choice']").send_keys(ENTER)
    until(page, "return !result.innerText.includes('your choice')")
    assert text_of(page, "#result .plain strong") == first


def test_what_is_at_hand_left_out_and_chosen_goes_into_the_plan_and_its_address(page):
    page.find_element("css selector", "#wishes > summary").send_keys(ENTER)
    for thing in ("kohlrabi", "onion", "chopped onion"):
        page.find_element("id", "thing").send_keys(thing, ENTER)
    page.find_element("id", "avoid").send_keys("nuts", ENTER)
    page.find_element("id", "food").send_keys("kohlrabi")
    page.find_element("id", "like").send_keys("onion", ENTER)
    assert text_of(page, "#wishes-told") == "3 at hand · without nuts · kohlrabi like onion"
    plan(page, "sliced kohlrabi", "chopped onion", "walnut")
    assert "“walnut” is left out" in text_of(page, "#result")
    assert "handled like onion" in text_of(page, "#result")
    told = text_of(page, "#result")
    page.refresh()
    until(page, PLANNED)
    assert text_of(page, "#result") == told
    assert chips(page, "at-hand") == ["kohlrabi", "onion", "chopped onion"]


def test_what_a_dish_is_called_is_read_and_kept_in_the_address(page):
    page.execute_script("dish.value = 'soup'; wishes.open = true")
    page.find_element("id", "called").send_keys("Cream of parsnip soup")
    for food in ("chopped parsnip", "chopped onion", "water"):
        page.find_element("id", "ingredient").send_keys(food, ENTER)
    page.find_element("id", "go").click()
    asked(page)
    assert "title=Cream+of+parsnip+soup" in page.current_url
    assert "Blend" in text_of(page, "#view-steps")
    assert "called Cream of parsnip soup" in page.execute_script("return window['wishes-told'].textContent")
    page.refresh()
    asked(page)
    assert page.find_element("id", "called").get_attribute("value") == "Cream of parsnip soup"


def test_the_kitchen_is_kept_and_what_is_odd_about_it_is_told_even_without_a_tree(page):
    page.find_element("css selector", "#wishes > summary").send_keys(ENTER)
    page.execute_script("""
        const told = new DataTransfer();
        told.setData('text/plain', '- egg\\n# mine\\nspoon\\nonionn');
        thing.dispatchEvent(new ClipboardEvent('paste', {clipboardData: told, cancelable: true}))""")
    assert chips(page, "at-hand") == ["egg", "spoon", "onionn"]
    page.execute_script("dish.append(new Option('pizza')); dish.value = 'pizza'")  # of which this FOON has none
    page.find_element("id", "ingredient").send_keys("chopped onion", ENTER, CONTROL + ENTER)
    until(page, "return !!document.querySelector('#result [role=alert]')")
    told = text_of(page, "#result [role=alert]")
    assert "This FOON has no pizza" in told
    assert "no food “onionn”" in told
    page.get(page.current_url.split("#")[0])
    assert chips(page, "at-hand") == ["egg", "spoon", "onionn"]


def test_what_the_kitchen_lacks_can_be_said_to_be_there(page):
    page.find_element("css selector", "#wishes > summary").send_keys(ENTER)
    for thing in ("kohlrabi", "olive oil"):
        page.find_element("id", "thing").send_keys(thing, ENTER)
    plan(page, "sliced kohlrabi", "chopped onion")
    assert "The kitchen lacks onion" in text_of(page, "#result [role=alert]")
    page.find_element("xpath", "//button[text()='I have onion']").send_keys(ENTER)
    until(page, PLANNED)
    assert chips(page, "at-hand") == ["kohlrabi", "olive oil", "onion"]


def test_the_schedule_is_for_one_pair_of_hands_or_two_and_can_be_read_as_a_table(page):
    plan(page, "sliced kohlrabi", "chopped onion", "diced tomato")
    view(page, "when")
    one, two = page.find_elements("css selector", "[aria-label='How many cook'] button")
    assert (one.get_attribute("aria-pressed"), two.get_attribute("aria-pressed")) == ("true", "false")
    assert one.text == "one pair of hands", "nothing in the demo was ever timed"
    two.send_keys(ENTER)
    assert (one.get_attribute("aria-pressed"), two.get_attribute("aria-pressed")) == ("false", "true")
    charts = page.find_elements("css selector", "#result [aria-label^='Schedule for']")
    assert [chart.is_displayed() for chart in charts] == [False, True]
    shown = page.find_element("css selector", "#result [aria-label='Schedule for 2 pairs of hands'] ~ details")
    shown.find_element("css selector", "summary").send_keys(ENTER)
    steps = page.find_elements("css selector", ".steps li")
    assert len(shown.find_elements("css selector", "tbody tr")) == len(steps)
    assert complaints(page) == []


def test_going_back_from_an_object_leads_to_the_plan_again(page):
    plan(page, "chopped onion")
    page.find_element("css selector", "#view-steps ul a.link").send_keys(ENTER)
    until(page, "return location.pathname === '/explore' && !!document.querySelector('#about h2')")
    page.back()
    until(page, PLANNED)
    assert page.find_element("id", "view-steps").is_displayed()


def test_an_ingredient_is_removed_and_the_focus_stays_near(page):
    page.find_element("id", "ingredient").send_keys("egg", ENTER, "onion", ENTER)
    page.find_element("css selector", "[aria-label='Remove egg']").send_keys(ENTER)
    assert page.execute_script("return [...wanted.children].map(li => li.firstChild.data)") == ["onion"]
    assert focused(page).get_attribute("aria-label") == "Remove onion"
    assert text_of(page, "#status") == "egg is removed."


def test_what_could_be_made_leads_to_a_plan(page):
    page.find_element("id", "ingredient").send_keys("egg", ENTER, "chopped onion", ENTER)
    page.find_element("id", "suggest").send_keys(ENTER)
    asked(page)
    assert text_of(page, "#result h2") == "What these foods could make"
    page.find_element("css selector", "#result li button").send_keys(ENTER)
    until(page, PLANNED)
    assert page.execute_script("return dish.value") == "omelette"


def test_a_food_of_the_plan_leads_to_what_the_explorer_has_around_it(page):
    plan(page, "chopped onion")
    page.find_element("xpath", '//button[text()="In the FOON\'s own words"]').send_keys(ENTER)
    page.find_element("css selector", ".formula a.link").send_keys(ENTER)
    until(page, "return !!document.querySelector('#about h2') && about.innerText.includes('onion')")
    assert page.execute_script("return location.pathname + location.hash") == "/explore#at=onion"
    assert complaints(page) == []


def test_an_error_says_what_to_do_and_the_page_goes_on(page):
    page.execute_cdp_cmd("Network.enable", {})
    page.execute_cdp_cmd("Network.setBlockedURLs", {"urls": ["*api/plan*"]})
    plan(page, "chopped onion")
    assert text_of(page, "#result [role=alert]") == "The service does not answer.\n\nIs foon serve still running?"
    page.execute_cdp_cmd("Network.setBlockedURLs", {"urls": []})
    page.find_element("id", "go").send_keys(ENTER)
    until(page, PLANNED)


def test_nothing_asked_is_told(page):
    page.find_element("id", "go").send_keys(ENTER)
    assert "Name an ingredient first" in text_of(page, "#result [role=alert]")
    assert focused(page).get_attribute("id") == "ingredient"


def test_hostile_words_stay_words(page):
    hostile = "<img src=x onerror=alert(1)>"
    plan(page, hostile, "chopped onion")
    assert hostile in text_of(page, "#result")
    assert page.execute_script("return document.querySelectorAll('img').length") == 0
    assert complaints(page) == []


def test_the_picture_moves_by_keys_and_buttons(page):
    plan(page, "chopped onion", "sliced kohlrabi")
    view(page, "tree")

    def seen_part():
        return page.execute_script("return document.querySelector('.stage svg').getAttribute('viewBox')")

    stage = page.find_element("css selector", ".stage")
    seen = {seen_part()}
    for act in (lambda: stage.send_keys(DOWN), lambda: stage.send_keys("+"), lambda: stage.send_keys("0")):
        act()
        assert seen_part() not in seen
        seen.add(seen_part())
    before = seen_part()
    page.find_element("css selector", "[aria-label=Larger]").send_keys(ENTER)
    assert seen_part() != before


@pytest.mark.parametrize("width", [320, 800])
def test_the_page_is_no_wider_than_the_screen(page, width):
    on_screen(page, width, touch=width < 500)
    page.execute_script("wishes.open = true")
    assert as_wide_as_the_screen(page, width)
    plan(page, "sliced kohlrabi", "chopped onion", "a-food-with-a-name-that-is-long-and-has-no-space-anywhere-in-it")
    for name in VIEWS:
        view(page, name)
        assert as_wide_as_the_screen(page, width), name


@pytest.mark.parametrize("scheme", PAPERS)
def test_page_and_picture_follow_light_and_dark(page, scheme):
    plan(page, "chopped onion")
    view(page, "tree")
    assert papers(page, scheme, ".stage") == [PAPERS[scheme]] * 2


def test_on_paper_there_is_the_whole_plan_and_no_form(page):
    plan(page, "chopped onion", "sliced kohlrabi", "diced tomato")
    view(page, "tree")
    shown = "document.querySelector('.stage svg').getAttribute('viewBox')"
    whole = page.execute_script("""
        const { width, height } = document.querySelector('.stage .paper').getBBox();
        return [0, 0, width, height].map(v => v.toFixed(2)).join(' ')""")
    until(page, f"return {shown} !== '{whole}'")
    moved = page.execute_script(f"return {shown}")
    page.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        until(page, f"return {shown} === '{whole}'")
        forms = "return [...document.querySelectorAll('form, nav, .cook')].map(e => e.checkVisibility())"
        assert not any(page.execute_script(forms))
        assert page.find_element("css selector", ".steps").is_displayed(), "whatever view was on the screen"
        views = "return [...document.querySelectorAll('.view')].filter(e => e.checkVisibility()).map(e => e.id)"
        assert page.execute_script(views) == ["view-steps", "view-tree"]
        paper = base64.b64decode(page.execute_cdp_cmd("Page.printToPDF", {})["data"])
        assert paper.count(b"/Type /Page\n") == 2, "a page of steps, a page of the tree"
        uncut = """
            const { bottom } = document.querySelector('.stage svg').getBoundingClientRect();
            return document.querySelector('.stage').getBoundingClientRect().bottom >= bottom"""
        assert page.execute_script(uncut), "the whole tree"
    finally:
        page.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    until(page, f"return {shown} === '{moved}'")


def test_nothing_comes_from_elsewhere(page, address):
    plan(page, "chopped onion")
    names = page.execute_script("return performance.getEntriesByType('resource').map(entry => entry.name)")
    assert names
    assert all(name.startswith(address) for name in names)


def test_every_field_has_a_label_and_every_button_a_name(page):
    plan(page, "sliced kohlrabi")
    nameless = page.execute_script("""
        return [...document.querySelectorAll('input, select, button, a, [role=group], [role=listbox]')]
            .filter(e => !(e.labels?.length || e.getAttribute('aria-label') || e.textContent.trim()))
            .map(e => e.outerHTML)""")
    assert nameless == []
    levels = page.execute_script("""
        return [...document.querySelectorAll('main :is(h1, h2, h3)')]
            .filter(h => h.checkVisibility()).map(h => +h.tagName[1])""")
    assert levels[:1] == [1]
    assert all(after <= before + 1 for before, after in itertools.pairwise(levels))


def test_the_page_asks_for_the_token_or_takes_it_from_the_address(browser):
    with served(app(token=TOKEN)) as guarded:
        browser.get(f"{guarded}/")
        until(browser, "return !document.getElementById('token').hidden")
        assert not browser.find_element("id", "plan").is_displayed()
        browser.find_element("id", "token-text").send_keys("wrong-token", ENTER)
        until(browser, "return document.getElementById('token-wrong').innerText === 'That is not its token.'")
        browser.find_element("id", "token-text").send_keys(TOKEN, ENTER)
        until(browser, "return document.querySelectorAll('#dish option').length > 1")
        browser.execute_script("sessionStorage.clear()")
        browser.get("about:blank")
        browser.get(f"{guarded}/#token={TOKEN}")
        until(browser, "return document.querySelectorAll('#dish option').length > 1")
        assert TOKEN not in browser.current_url
