"""Cooking by the page: one step at a time, by buttons, keys and fingers; ticks, timers and the place are kept."""

from __future__ import annotations

import pytest
from chromium import as_wide_as_the_screen, fingers, on_screen
from web.driving import ENTER, LEFT, PLANNED, RIGHT, complaints, text_of, until, view

SOUP = "dish=soup&with=cube+bouillon&with=200+g+sliced+mushroom&with=chopped+onion&with=boiling+water"
WAKE = """
    window.locks = [];
    Object.defineProperty(navigator, 'wakeLock', {value: {request: async kind => {
        const lock = {kind, released: false, release: async () => { lock.released = true; }};
        locks.push(lock);
        return lock;
    }}})"""


@pytest.fixture
def kitchen(page, address):
    """The plan of a soup, about to be cooked."""
    page.get(f"{address}/#{SOUP}&view=cook")
    until(page, PLANNED)
    return page


def press(browser, *keys):
    from selenium.webdriver import ActionChains

    ActionChains(browser).send_keys(*keys).perform()


def said(browser):
    return text_of(browser, ".cook .count").split(" · ")[0]


def button(browser, name):
    return browser.find_element("xpath", f"//*[@id='view-cook']//button[text()='{name}' or @aria-label='{name}']")


def steps(browser):
    return browser.execute_script("return document.querySelectorAll('.steps li').length")


def simmering(browser):
    """Go to the step that goes on by itself."""
    place = 1 + browser.execute_script(
        "return [...document.querySelectorAll('.steps li')].findIndex(li => li.textContent.startsWith('Simmer'))"
    )
    press(browser, *[RIGHT] * place)
    assert said(browser).startswith(f"Step {place} ")
    return place


def test_first_comes_what_to_have_ready_and_what_is_ticked_stays_so(kitchen):
    assert text_of(kitchen, ".cook .big") == "Have this ready."
    assert "200 g mushroom" in text_of(kitchen, ".cook .card")
    box = kitchen.find_element("xpath", "//label[contains(., 'mushroom')]/input")
    box.click()
    kitchen.refresh()
    until(kitchen, PLANNED)
    assert kitchen.find_element("xpath", "//label[contains(., 'mushroom')]/input").is_selected()
    assert not kitchen.find_element("xpath", "//label[contains(., 'onion')]/input").is_selected()


def test_a_step_is_a_sentence_with_what_it_takes_and_what_comes_next(kitchen):
    button(kitchen, "Begin").send_keys(ENTER)
    assert said(kitchen) == f"Step 1 of {steps(kitchen)}"
    assert text_of(kitchen, ".cook .big") == "Slice the mushroom on the cutting board with the knife (200 g mushroom)."
    assert "Take\nmushroom whole\ncutting board\nknife" in text_of(kitchen, ".cook .card")
    following = text_of(kitchen, ".cook .next").removeprefix("Next: ")
    press(kitchen, RIGHT)
    assert text_of(kitchen, ".cook .big") == following
    assert "At hand\nknife" in text_of(kitchen, ".cook .card"), "the knife is out already"


def test_a_food_is_taken_and_not_its_packet_a_vessel_and_not_all_that_is_in_it(kitchen):
    def things():
        return kitchen.execute_script("return [...document.querySelectorAll('.things li')].map(li => li.innerText)")

    while "packet" not in text_of(kitchen, ".cook .big"):
        press(kitchen, RIGHT)
    assert things() == ["bouillon cube; in packet", "pot with mushroom, onion, water; on stove"]


def test_keys_and_buttons_go_from_step_to_step_and_not_beyond_the_ends(kitchen):
    press(kitchen, LEFT)
    assert said(kitchen) == "Before you begin"
    press(kitchen, RIGHT, RIGHT, LEFT)
    assert said(kitchen).startswith("Step 1 ")
    button(kitchen, "Next step").send_keys(ENTER)
    assert said(kitchen).startswith("Step 2 ")
    button(kitchen, "Step before").send_keys(ENTER)
    assert said(kitchen).startswith("Step 1 ")
    press(kitchen, *[RIGHT] * (steps(kitchen) + 3))
    assert said(kitchen) == "The end"
    assert complaints(kitchen) == []


def test_a_finger_that_wipes_goes_on_and_one_that_scrolls_does_not(kitchen):
    on_screen(kitchen, 375, 720, touch=True)
    left, right, down = ((300, 300), (100, 310)), ((100, 300), (300, 310)), ((100, 300), (90, 500))
    for (start, end), there in [(left, "Step 1 "), (down, "Step 1 "), (left, "Step 2 "), (right, "Step 1 ")]:
        fingers(kitchen, ("touchStart", [start]), ("touchMove", [end]), ("touchEnd", []))
        until(kitchen, f"return document.querySelector('.cook .count').innerText.startsWith('{there}')")
    assert as_wide_as_the_screen(kitchen, 375)


def test_what_is_done_is_ticked_off_and_the_place_is_kept_over_a_reload_and_in_the_opening(kitchen, address):
    for _ in range(3):
        kitchen.find_element("css selector", ".cook .controls .main").send_keys(ENTER)
    assert said(kitchen).startswith("Step 3 ")
    assert kitchen.execute_script("return document.querySelector('.cook progress').value") == 2
    kitchen.get("about:blank")
    kitchen.get(f"{address}/")
    until(kitchen, "return !!document.querySelector('#recent .dish')")
    dish = kitchen.find_element("css selector", "#recent .dish")
    assert "go on at step 3" in dish.text
    dish.send_keys(ENTER)
    until(kitchen, PLANNED)
    assert said(kitchen).startswith("Step 3 ")
    press(kitchen, LEFT)
    assert "✓ done" in text_of(kitchen, ".cook .count")
    button(kitchen, "Not done after all").send_keys(ENTER)
    assert "✓ done" not in text_of(kitchen, ".cook .count")
    assert said(kitchen).startswith("Step 2 "), "what is taken back is looked at"


def test_going_through_steps_fills_no_history(kitchen):
    before = kitchen.execute_script("return history.length")
    press(kitchen, RIGHT, RIGHT, RIGHT)
    assert kitchen.execute_script("return history.length") == before
    assert kitchen.execute_script("return location.hash").endswith("&view=cook&step=3")


def test_at_the_end_what_is_not_done_is_named_and_all_can_begin_anew(kitchen):
    count = steps(kitchen)
    press(kitchen, RIGHT, RIGHT)
    for _ in range(count - 1):
        kitchen.find_element("css selector", ".cook .controls .main").send_keys(ENTER)
    assert said(kitchen) == "The end"
    assert text_of(kitchen, ".cook .big") == "Not all steps are ticked off."
    kitchen.find_element("css selector", ".cook .card li a").send_keys(ENTER)
    until(kitchen, "return document.querySelector('.cook .count').innerText.startsWith('Step 1 ')")
    kitchen.find_element("css selector", ".cook .controls .main").send_keys(ENTER)
    press(kitchen, *[RIGHT] * count)
    assert text_of(kitchen, ".cook .big") == "The mushroom soup is ready. Enjoy it!"
    button(kitchen, "Cook it again").send_keys(ENTER)
    assert said(kitchen) == "Before you begin"
    assert kitchen.execute_script("return document.querySelector('.cook progress').value") == 0


def test_what_goes_on_by_itself_has_a_timer_that_outlives_a_reload_and_says_when_time_is_up(kitchen):
    assert not kitchen.find_elements("css selector", ".cook [aria-label=Timer]")
    place = simmering(kitchen)
    assert "It goes on by itself" in text_of(kitchen, ".cook .card")
    assert "Videos cut this short: set the time that you know." in text_of(kitchen, ".cook .card")
    assert not button(kitchen, "Start 0:00").is_enabled()
    button(kitchen, "+5 min").send_keys(ENTER)
    button(kitchen, "+1 min").send_keys(ENTER)
    button(kitchen, "Start 6:00").send_keys(ENTER)
    press(kitchen, LEFT)
    kitchen.refresh()
    until(kitchen, PLANNED)
    assert text_of(kitchen, ".cook .timers button").startswith(f"{place}. simmer: ")
    kitchen.execute_script("""
        const kept = JSON.parse(localStorage.getItem('foon-cook'));
        for (const plan of Object.values(kept)) plan.timers.forEach(one => { one.until = Date.now() - 1; });
        localStorage.setItem('foon-cook', JSON.stringify(kept))""")
    kitchen.refresh()
    until(kitchen, "return !!document.querySelector('.cook .timers [role=alert]')")
    assert text_of(kitchen, ".cook .timers button") == f"{place}. simmer: time is up"
    kitchen.find_element("css selector", ".cook .timers button").send_keys(ENTER)
    assert said(kitchen).startswith(f"Step {place} ")
    button(kitchen, f"Stop the timer of step {place}").send_keys(ENTER)
    assert not kitchen.find_elements("css selector", ".cook .timers button")
    assert complaints(kitchen) == []


def test_meanwhile_is_what_has_nothing_to_do_with_what_goes_on(kitchen):
    """The egg (1) boils in the pot (2) on the stove (8): what takes these waits, the onion (4) does not."""
    found = kitchen.execute_async_script("""
        const done = arguments[0];
        const nodes = things => things.map(thing => ({ thing }));
        const unit = (taken, made) => ({ input_nodes: nodes(taken), output_nodes: nodes(made) });
        const [boil, off, drain] = [unit([1, 2, 8], [1, 2]), unit([8], [8]), unit([1, 2, 3], [1, 3])];
        const [peel, chop, mix] = [unit([4, 5], [4]), unit([4, 6], [4]), unit([3, 4], [7])];
        import('/cook_needs.js').then(({ meanwhile }) => done(meanwhile([boil, off, drain, peel, chop, mix], 0)))""")
    assert found == [3, 4]


def test_the_screen_stays_on_while_it_is_cooked_by_and_no_longer(page, address):
    script = page.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": WAKE})["identifier"]
    try:
        page.get("about:blank")
        page.get(f"{address}/#{SOUP}")
        until(page, PLANNED)
        assert page.execute_script("return locks.length") == 0
        view(page, "cook")
        until(page, "return document.querySelector('.cook').innerText.includes('The screen stays on')")
        assert page.execute_script("return locks.map(one => [one.kind, one.released])") == [["screen", False]]
        page.execute_script("document.dispatchEvent(new Event('visibilitychange'))")  # it was locked, and is back
        until(page, "return locks.length === 2")
        view(page, "steps")
        until(page, "return locks.at(-1).released")
    finally:
        page.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", {"identifier": script})


@pytest.mark.parametrize("height", [560, 720])
def test_the_buttons_are_in_sight_on_a_phone(kitchen, height):
    on_screen(kitchen, 375, height, touch=True)
    press(kitchen, RIGHT, RIGHT)
    inside = "return document.querySelector('.cook .controls').getBoundingClientRect().bottom <= innerHeight"
    assert kitchen.execute_script(inside)
    assert kitchen.execute_script("return document.documentElement.scrollHeight") <= height, "and nothing is to scroll"
    assert as_wide_as_the_screen(kitchen, 375)
