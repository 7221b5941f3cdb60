"""A plan in its views: each has an address and a title, and what is looked at in one is found in the others."""

from __future__ import annotations

import httpx
import pytest
from chromium import as_wide_as_the_screen, on_screen
from web.driving import ENTER, PLANNED, VIEWS, complaints, plan, text_of, until, view

from foon_kg.validation import Finding, Report

SALAD = "dish=salad&with=sliced+kohlrabi&with=chopped+onion&with=olive+oil"


def go(browser, address, question):
    """Open the page at a question, as a bookmark does."""
    browser.get("about:blank")
    browser.get(f"{address}/#{question}")
    until(browser, PLANNED)


def shown(browser):
    return browser.execute_script(
        "return [...document.querySelectorAll('.view')].filter(v => !v.hidden).map(v => v.id)"
    )


def now(browser, where):
    """What is marked as the step that is looked at."""
    return browser.execute_script(
        "return [...document.querySelectorAll(arguments[0])].map(one => one.innerText ?? one.textContent)", where
    )


def test_every_view_has_an_address_and_a_title_and_history_leads_through_them(page):
    plan(page, "sliced kohlrabi", "chopped onion")
    first = page.current_url
    titles = ["Steps: salad · foon"]
    for name in VIEWS[1:]:
        view(page, name)
        assert shown(page) == [f"view-{name}"]
        titles.append(page.title)
    assert titles == [f"{name.title()}: salad · foon" for name in VIEWS]
    asked = "return performance.getEntriesByType('resource').filter(one => one.name.endsWith('/api/plan')).length"
    assert page.execute_script(asked) == 1, "another view is no other question"
    for name in reversed(VIEWS[:-1]):
        page.back()
        until(page, f"return document.body.dataset.view === '{name}'")
        assert page.title == f"{name.title()}: salad · foon"
    assert page.current_url == first
    page.forward()
    until(page, "return document.body.dataset.view === 'cook'")
    page.refresh()
    until(page, PLANNED)
    assert shown(page) == ["view-cook"]


def test_steps_are_sentences_and_their_formulas_a_detail(page):
    plan(page, "sliced kohlrabi", "chopped onion")
    assert "Chop the onion on the cutting board with the knife." in text_of(page, ".steps")
    assert "Slice the ~kohlrabi" in text_of(page, ".steps")
    assert "→" not in text_of(page, ".steps")
    own = page.find_element("xpath", '//button[text()="In the FOON\'s own words"]')
    own.send_keys(ENTER)
    assert own.get_attribute("aria-pressed") == "true"
    assert "→" in text_of(page, ".steps")


def test_what_is_bought_has_the_amount_that_was_asked(page, address):
    go(page, address, "dish=salad&with=200+g+sliced+kohlrabi&with=chopped+onion")
    assert "200 g ~kohlrabi" in text_of(page, "#view-steps")


@pytest.mark.parametrize("width", [375, 1200])
def test_the_tree_fits_its_window_and_opens_at_its_beginning(page, address, width):
    on_screen(page, width, 720, touch=width < 500)
    go(page, address, f"{SALAD}&view=tree")
    until(page, "return document.querySelector('.stage').getBoundingClientRect().height > 200")
    inside = """
        const one = document.querySelector('.stage [data-step="1"]').getBoundingClientRect();
        const stage = document.querySelector('.stage').getBoundingClientRect();
        return one.height > 20 && one.left >= stage.left && one.right <= stage.right && one.top >= stage.top
            && one.bottom <= Math.min(stage.bottom, innerHeight) && stage.height <= innerHeight"""
    until(page, inside)
    assert as_wide_as_the_screen(page, width)


def test_a_click_on_a_step_of_the_list_shows_it_in_the_tree_and_the_other_way_round(page, address):
    from selenium.webdriver import ActionChains

    go(page, address, f"{SALAD}&view=tree")
    page.find_element("xpath", "//*[contains(@class, 'tree')]//ol/li[3]/a").send_keys(ENTER)
    until(page, "return !!document.querySelector('.stage .now')")
    assert page.execute_script("return document.querySelector('.stage .now').dataset.step") == "3"
    assert now(page, ".tree [aria-current=step]")[0].startswith("3. ")
    evidence = [one for one in page.find_elements("css selector", ".tree .where") if one.is_displayed()]
    assert len(evidence) == 1, "of the step that is looked at"
    assert evidence[0].text == text_of(page, ".tree li:nth-child(3) .where")
    ActionChains(page).move_to_element(
        page.find_element("css selector", ".stage [data-step='2'] rect")
    ).click().perform()
    until(page, "return document.querySelector('.stage .now').dataset.step === '2'")
    assert [text[:2] for text in now(page, ".tree [aria-current=step]")] == ["2."]
    page.back()
    until(page, "return document.querySelector('.stage .now').dataset.step === '3'")
    assert complaints(page) == []


def test_dragging_the_tree_chooses_no_step(page, address):
    from selenium.webdriver import ActionChains

    go(page, address, f"{SALAD}&view=tree")
    box = page.find_element("css selector", ".stage [data-step='1'] rect")
    before = page.current_url
    ActionChains(page).move_to_element(box).click_and_hold().move_by_offset(60, 60).release().perform()
    assert page.current_url == before


def test_a_step_of_an_address_is_marked_in_the_steps(page, address):
    go(page, address, f"{SALAD}&view=steps&step=2")
    assert len(now(page, ".steps .now")) == 1
    assert page.execute_script("return document.querySelector('.steps .now').dataset.step") == "2"
    page.find_element("css selector", ".steps .now a[href*='view=tree']").send_keys(ENTER)
    until(page, "return document.querySelector('.stage .now')?.dataset.step === '2'")


def test_why_tells_the_dish_the_likenesses_and_the_judge(page, address):
    go(page, address, f"{SALAD}&view=why")
    told = text_of(page, "#view-why")
    assert "made like the greek salad" in told
    assert "~kohlrabi handled like" in told
    assert "A robot could carry it out, a cook would serve it; it found nothing to object to." in told


def test_why_names_nearer_dishes_that_were_passed_over(page, address):
    asked = {
        "dish_type": "drinks",
        "ingredients": ["syrup", "sugar", "raisin", "potato", "mayonnaise"],
        "explain": True,
    }
    nearer = httpx.post(f"{address}/api/plan", json=asked).json()["passed_over"]
    assert nearer, "this question has some"
    go(page, address, "dish=drinks&" + "&".join(f"with={one}" for one in asked["ingredients"]) + "&view=why")
    told = text_of(page, "#view-why")
    for one in nearer:
        assert f"{one['goal']['label']} of video " in told
        assert f" {one['similarity']:.2f}: {one['why']}" in told


def test_another_dish_is_followed_from_why_and_the_wish_stands_in_the_form(page, address):
    go(page, address, f"{SALAD}&view=why")
    page.find_element("css selector", "[aria-label='make it so, after the winter salad of winter_salad']").send_keys(
        ENTER
    )
    until(page, "return document.querySelector('#view-why')?.innerText.includes('made like the winter salad')")
    assert page.execute_script("return document.getElementById('after').value") == "winter_salad"
    assert "after winter_salad" in page.execute_script("return document.getElementById('wishes-told').textContent")
    assert "greek salad of video greek_salad" in text_of(page, "#view-why")


def test_what_the_judge_finds_leads_to_its_step(page, address, monkeypatch):
    found = Finding("W5", "the knife waits", 1, minor=True), Finding("K7", "nothing sour is in it", minor=True)
    monkeypatch.setattr("foon_kg.web.plan_answer.check", lambda *_, **__: Report("salad", found))
    go(page, address, f"{SALAD}&with=diced+tomato&view=why")
    told = text_of(page, "#view-why")
    assert "in all: nothing sour is in it (odd, yet it can be done; rule K7)" in told
    page.find_element("xpath", "//li[contains(., 'the knife waits')]/a").send_keys(ENTER)
    until(page, "return document.querySelector('.steps .now')?.dataset.step === '2'")
