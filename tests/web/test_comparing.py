"""Two plans side by side: what both have, what one alone has, and what is changed; from an address and by hand."""

from __future__ import annotations

from urllib.parse import quote

import httpx
import pytest
from chromium import as_wide_as_the_screen, on_screen
from hypothesis import given, settings
from hypothesis import strategies as st
from web.driving import ENTER, PLANNED, complaints, plan, text_of, until, view
from web.serving import SALAD

ASKED = "dish=salad&with=sliced+kohlrabi&with=chopped+onion&with=olive+oil"
COMPARED = "return !!document.querySelector('.compared') && !document.querySelector('#view-compare[aria-busy=true]')"


@pytest.fixture
def compared(page, address):
    """A salad beside the same one without onion."""
    page.get(f"{address}/#{ASKED}&view=compare&other={quote(ASKED + '&without=onion')}")
    until(page, COMPARED)
    return page


def sentences(address, **wishes):
    return httpx.post(f"{address}/api/plan", json=SALAD | wishes, timeout=60).json()["sentences"]


def test_an_address_shows_every_step_of_both_plans_in_its_order(compared, address):
    rows = compared.execute_script("""
        return [...[...document.querySelectorAll('.compared')].at(-1).children].map(li => [li.className,
            ...[...li.children].map(cell => [...cell.childNodes]
                .filter(one => !['number', 'sign'].includes(one.className))
                .map(one => one.textContent).join('').trim())])""")
    plans = sentences(address), sentences(address, avoid=["onion"])
    for side, told in enumerate(plans, 1):
        assert [row[side] for row in rows if row[side]] == told
    assert {row[0] for row in rows if row[1] == row[2]} == {"both"}
    assert {row[0] for row in rows if not row[2]} == {"one"}
    assert any("onion" in row[1] for row in rows if row[0] == "one")


def test_what_one_plan_alone_has_is_said_in_words(compared):
    heads = compared.execute_script("return [...document.querySelectorAll('.sides h2')].map(one => one.innerText)")
    assert heads == ["A as asked", "B without onion"]
    onion = compared.find_element("xpath", "//ul[@class='compared'][1]/li[contains(., 'onion')]")
    assert onion.text.endswith("only A")
    assert text_of(compared, "#view-compare [role=status]").startswith("What differs: 1 ingredient, ")
    assert complaints(compared) == []


def test_the_words_that_differ_in_a_step_are_marked(compared):
    marks = compared.execute_script("""
        const row = [...document.querySelectorAll('.compared > .changed')].at(-1);
        return [...row.children].map(cell => [...cell.querySelectorAll('mark')].map(one => one.innerText))""")
    assert marks == [["Toss", "and", "onion"], ["Mix", "and"]]


def test_what_is_the_same_can_be_hidden(compared):
    button = compared.find_element("xpath", "//button[text()='Only what differs']")
    button.send_keys(ENTER)
    shown = "return [...document.querySelectorAll('.compared > li')].filter(li => li.checkVisibility())"
    assert {row.get_attribute("class") for row in compared.execute_script(shown)} == {"one", "other", "changed"}
    button.send_keys(ENTER)
    assert "both" in {row.get_attribute("class") for row in compared.execute_script(shown)}


def test_a_plan_is_compared_by_hand_and_each_side_can_be_opened(page):
    plan(page, "sliced kohlrabi", "chopped onion", "olive oil")
    view(page, "compare")
    page.find_element("id", "compare-avoid").send_keys("onion")
    page.find_element("css selector", "[aria-label='Compare without it']").send_keys(ENTER)
    until(page, COMPARED)
    assert "other=" in page.current_url
    page.find_elements("css selector", ".sides .card a")[1].send_keys(ENTER)
    until(page, f"if (!document.querySelector('#view-steps')?.checkVisibility()) return false; {PLANNED}")
    assert "onion" not in text_of(page, ".steps")
    page.back()
    until(page, COMPARED)


def test_two_kitchens_are_compared_and_what_one_lacks_is_told_in_its_column(page):
    plan(page, "sliced kohlrabi", "chopped onion", "olive oil")
    view(page, "compare")
    page.find_element("id", "compare-have").send_keys("spoon", ENTER, "bowl")
    page.find_element("css selector", "[aria-label='Compare with that kitchen']").send_keys(ENTER)
    until(page, "return !!document.querySelector('.sides [role=alert]')")
    first, second = page.find_elements("css selector", ".sides .card")
    assert "with everything at hand" in first.text
    assert "with spoon, bowl at hand" in second.text
    assert "The kitchen lacks" in second.text
    assert "knife" in second.text


def test_a_type_of_dish_is_compared_with_another(page):
    plan(page, "sliced kohlrabi", "chopped onion", "egg")
    view(page, "compare")
    page.execute_script("document.getElementById('compare-dish').value = 'omelette'")
    page.find_element("css selector", "[aria-label='Compare with that dish']").send_keys(ENTER)
    until(page, COMPARED)
    heads = page.execute_script("return [...document.querySelectorAll('.sides h2')].map(one => one.innerText)")
    assert heads == ["A as salad", "B as omelette"]


def test_a_plan_of_this_browser_is_offered_and_going_back_is_another_choice(page):
    plan(page, "chopped onion", "diced tomato")
    page.find_element("xpath", "//a[text()='Plan a dish']").send_keys(ENTER)
    until(page, "return document.body.dataset.page === 'home'")  # until then what is asked is folded away
    page.find_element("id", "clear").send_keys(ENTER)
    plan(page, "sliced kohlrabi")
    view(page, "compare")
    page.find_element("xpath", "//section[@id='view-compare']//a[contains(., 'diced tomato')]").send_keys(ENTER)
    until(page, COMPARED)
    page.find_element("xpath", "//a[text()='Compare with something else']").send_keys(ENTER)
    until(page, "return !!document.getElementById('compare-avoid')")
    assert not page.find_elements("css selector", ".sides h2")


def test_on_a_phone_there_is_one_column_and_the_same_is_told_once(compared):
    on_screen(compared, 375, 720, touch=True)
    tops = compared.execute_script("""
        return [...document.querySelector('.compared > .changed').children]
            .map(cell => cell.getBoundingClientRect().left)""")
    assert len(set(tops)) == 1
    second = "return document.querySelector('.compared > .both').lastChild.checkVisibility()"
    assert not compared.execute_script(second)
    assert as_wide_as_the_screen(compared, 375)


@pytest.fixture
def laid(page):
    def told(first, second):
        return page.execute_async_script(
            """
            const [a, b, done] = arguments;
            import('/differences.js').then(({ beside, common }) => done([
                common([...a], [...b], (x, y) => x === y),
                beside([...a], [...b], (x, y) => x === y, (x, y) => x.toLowerCase() === y.toLowerCase())]))""",
            first,
            second,
        )

    return told


def longest(first, second):
    """How long the longest common subsequence is: tried out, and not computed."""
    if not first or not second:
        return 0
    if first[0] == second[0]:
        return 1 + longest(first[1:], second[1:])
    return max(longest(first[1:], second), longest(first, second[1:]))


def test_rows_have_each_place_once_and_as_much_as_can_be_side_by_side(laid):
    @settings(max_examples=60, deadline=None)
    @given(st.text("abAB", max_size=8), st.text("abAB", max_size=8))
    def holds(first, second):
        pairs, rows = laid(first, second)
        assert len(pairs) == longest(first, second)
        assert all(first[i] == second[j] for i, j in pairs)
        assert [i for i, _ in rows if i is not None] == list(range(len(first)))
        assert [j for _, j in rows if j is not None] == list(range(len(second)))
        assert all(first[i].lower() == second[j].lower() for i, j in rows if None not in (i, j))
        assert [row for row in rows if None not in row and first[row[0]] == second[row[1]]] == pairs

    holds()


def test_a_candidate_dish_is_laid_beside_the_one_that_was_taken(page, address):
    page.get(f"{address}/#{ASKED}&view=compare")
    until(page, "return !!document.getElementById('compare-avoid')")
    page.find_element("xpath", "//a[text()='made after the winter salad of video winter_salad']").send_keys(ENTER)
    until(page, COMPARED)
    first, second = page.find_elements("css selector", ".sides .card")
    assert "Made like the greek salad" in first.text
    assert "Made like the winter salad" in second.text
    moved = page.find_element("xpath", "//ul[@class='compared'][last()]/li[contains(., 'Peel the onion')]")
    assert moved.text.endswith("in B as step 3")
    signs = page.execute_script("""
        return [...document.querySelectorAll(".compared:last-of-type .cell")]
            .filter(one => one.innerText.includes("Scrape the onion"))
            .map(one => one.querySelector('.sign').innerText)""")
    assert signs == ["in B as step 6", "in A as step 6"], "it is not laid beside another step"


def test_what_is_no_question_is_told_in_its_column_and_another_choice_is_offered_at_once(page, address):
    page.get(f"{address}/#{ASKED}&view=compare&other=nothing")
    until(page, "return !!document.querySelector('.sides [role=alert]')")
    assert not page.find_element("xpath", "//button[text()='Only what differs']").is_displayed()
    page.find_element("xpath", "//a[text()='Compare with something else']").send_keys(ENTER)
    until(page, "return !!document.getElementById('compare-avoid')")
    assert page.execute_script("return document.getElementById('view-compare').getAttribute('aria-busy')") == "false"
    assert not page.find_elements("css selector", ".sides")


def test_a_choice_that_comes_before_the_answer_is_not_overwritten_by_it(page, address):
    page.get(f"{address}/#{ASKED}&view=compare")
    until(page, "return !!document.getElementById('compare-avoid')")
    told = page.execute_async_script(
        """
        const [other, done] = arguments;
        const plain = window.fetch;
        const begun = location.hash;
        window.fetch = async (...asked) => {
            const answer = await plain(...asked);
            const told = await answer.json();
            history.back();
            await new Promise(go => addEventListener('hashchange', go, {once: true}));
            const read = () => {
                setTimeout(() => done(document.getElementById('view-compare').innerText)); // after who reads it
                return told;
            };
            window.fetch = plain;
            return {ok: true, json: async () => read()};
        };
        location.hash = `${begun}&other=${other}`;""",
        quote(ASKED + "&without=onion"),
    )
    assert told.startswith("Compare this plan with")
