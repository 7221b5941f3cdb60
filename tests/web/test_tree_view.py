"""The tree of a plan: its bands, the small picture of the whole, foods in colour, and the evidence of a step."""

from __future__ import annotations

import httpx
import pytest
from chromium import on_screen
from web.driving import ENTER, PLANNED, complaints, text_of, until

SOUP = {"dish_type": "soup", "ingredients": ["cube bouillon", "sliced mushroom", "chopped leek", "boiling water"]}
ASKED = "dish=soup&with=cube+bouillon&with=sliced+mushroom&with=chopped+leek&with=boiling+water"
FRAME = """
    const {x, y, width, height} = document.querySelector('.minimap .frame').attributes;
    return [x, y, width, height].map(one => +one.value)"""
VIEW = "return document.querySelector('.stage > svg').getAttribute('viewBox').split(' ').map(Number)"


@pytest.fixture
def tree(page, address):
    """The tree of a soup, on a screen that cannot show all of it."""
    page.get(f"{address}/#{ASKED}&view=tree")
    until(page, PLANNED)
    until(page, "return !!document.querySelector('.minimap:not(.whole)')")
    return page


@pytest.fixture(scope="module")
def told(address):
    return httpx.post(f"{address}/api/plan", json=SOUP, timeout=60).json()


def follow(browser, food):
    browser.find_element("xpath", f"//*[@aria-label='Follow a food']/button[text()='{food}']").send_keys(ENTER)


def followed(browser):
    return browser.execute_script("""
        return [...document.querySelectorAll('.stage g.followed')].map(one => one.dataset.foods.split('\\n'))""")


def test_the_frame_of_the_small_picture_is_what_is_seen_of_the_large_one(tree):
    def inside():
        x, y, width, height = tree.execute_script(VIEW)
        left, top, wide, high = tree.execute_script(FRAME)
        assert (left, top) == pytest.approx((max(x, 0), max(y, 0)))
        assert left + wide <= x + width + 0.01
        assert top + high <= y + height + 0.01
        return left, top, wide, high

    before = inside()
    tree.find_element("css selector", ".stage").send_keys("\ue015")
    until(tree, f"{FRAME.strip().replace('return', 'const now =')}; return now[1] !== {before[1]}")
    after = inside()
    assert after[1] > before[1]
    assert after[2:] == pytest.approx(before[2:])
    assert complaints(tree) == []


def test_a_pointer_on_the_small_picture_moves_the_large_one_there(tree):
    from selenium.webdriver import ActionChains

    small = tree.find_element("css selector", ".minimap")
    tree.execute_script("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", small)
    width, height = small.size["width"], small.size["height"]
    ActionChains(tree).move_to_element_with_offset(small, 0, height // 2 - 6).click().perform()
    whole = tree.execute_script("""
        const { width, height } = document.querySelector('.stage .paper').getBBox();
        return [width, height]""")
    x, y, wide, high = tree.execute_script(VIEW)
    assert x + wide / 2 == pytest.approx(whole[0] / 2, abs=whole[0] / width * 2)
    assert y + high / 2 == pytest.approx(whole[1] * (1 - 6 / height), abs=whole[1] / height * 3)


def test_the_small_picture_goes_where_all_is_seen_and_is_hidden_from_readers(tree):
    tree.find_element("css selector", "[aria-label='Show all of it']").send_keys(ENTER)
    until(tree, "return !document.querySelector('.minimap').checkVisibility()")
    assert tree.find_element("css selector", ".minimap").get_attribute("aria-hidden") == "true"
    assert tree.execute_script("return document.querySelectorAll('[data-step=\"1\"]').length") == 2, "a list, a picture"


def test_the_bands_have_the_steps_of_their_phases(tree, told):
    spans = tree.execute_script("""
        const at = one => one.getBoundingClientRect();
        const bands = [...document.querySelectorAll('.stage .band')].map(one => [at(one).top, at(one).bottom]);
        return [bands, [...document.querySelectorAll('.stage [data-step]')].map(
            one => [+one.dataset.step, at(one).top, at(one).bottom])]""")
    (top, bottom), *_ = spans[0]
    for step, upper, lower in spans[1]:
        assert (top <= upper and lower <= bottom) == (told["units"][step - 1]["phase"] == "prepare"), step
    names = tree.execute_script("return document.querySelector('.stage > svg').textContent")
    assert "making ready" in names
    assert "cooking" in names


def test_a_food_is_followed_from_the_kitchen_into_the_dish(tree):
    follow(tree, "~leek")
    assert all("leek" in foods for foods in followed(tree))
    of_leek = "return [...document.querySelectorAll('.stage g[data-foods]')].filter(g => g.dataset.foods.split('\\n')"
    assert len(followed(tree)) == tree.execute_script(f"{of_leek}.includes('leek')).length")
    ways = tree.execute_script("""
        const [leek, other] = ['.followed', ':not(.followed)'].map(
            one => document.querySelector(`.stage path.way${one}`));
        return [getComputedStyle(leek).stroke, getComputedStyle(other).opacity]""")
    assert ways == ["rgb(137, 87, 229)", "0.3"]
    follow(tree, "~leek")
    assert followed(tree) == []


def test_two_foods_have_two_colours(tree):
    follow(tree, "~leek")
    follow(tree, "mushroom")
    colours = tree.execute_script("""
        return [...document.querySelectorAll('.stage g.followed > rect')].map(one => getComputedStyle(one).stroke)""")
    assert len(set(colours)) == 2


def test_a_click_on_a_food_follows_it_and_another_click_ends_that(tree):
    click = """
        const boxes = [...document.querySelectorAll('.stage g[data-foods]:not([data-step])')];
        boxes.find(one => one.dataset.foods === 'mushroom').dispatchEvent(new MouseEvent('click', {bubbles: true}))"""
    tree.execute_script(click)
    pressed = "return [...document.querySelectorAll('[class*=follow-][aria-pressed=true]')].map(one => one.innerText)"
    assert tree.execute_script(pressed) == ["mushroom"]
    tree.execute_script(click)
    assert tree.execute_script(pressed) == []


def test_a_step_says_what_it_goes_back_to(tree, told):
    step = next(i for i, unit in enumerate(told["units"]) if unit["motion_node"] == "chop") + 1
    tree.find_element("css selector", f".tree .list li:nth-child({step}) > a").send_keys(ENTER)
    until(tree, f"return document.querySelector('.stage .now')?.dataset.step === '{step}'")
    seen = told["units"][step - 1]["seen_in"][0]["video"]
    (stands,) = told["stands"][step - 1]
    said = f"Like video {seen}, onion for leek, {stands['confidence']:.2f}"
    assert text_of(tree, ".tree [aria-current] + .where") == said
    other = next(i for i, unit in enumerate(told["units"]) if unit["origin"] == "foon") + 1
    tree.find_element("css selector", f".tree .list li:nth-child({other}) > a").send_keys(ENTER)
    until(tree, f"return document.querySelector('.stage .now')?.dataset.step === '{other}'")
    assert text_of(tree, ".tree [aria-current] + .where").startswith("As in video ")


def test_on_a_phone_the_small_picture_is_small(page, address):
    on_screen(page, 375, 720, touch=True)
    page.get(f"{address}/#{ASKED}&view=tree")
    until(page, PLANNED)
    assert page.execute_script("return document.querySelector('.minimap').getBoundingClientRect().width") <= 80
