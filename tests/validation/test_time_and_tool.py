"""K3 and K4 (docs/contract.md): each clause kept and broken by a small tree."""

from __future__ import annotations

import pytest
from validation.dishes import boiled, lines
from validation.judging import found, report

# --- K3 time ---


SOUP = """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
tomato (canned; in can) + pot (empty; on stove) → POUR → tomato (canned; in pot) + pot ({tomato}; on stove)
stove (off; under pot) → TURN ON → stove (on; under pot)
tomato (canned; in pot) + pot ({tomato}; on stove) + stove (on; under pot) → BOIL
  → tomato (cooked; in pot) + pot ({tomato})
"""


def then(food, state="liquid", dish="soup"):
    """The soup of tomatoes with something that comes after it was cooked."""
    add = f"{food} ({state}; in bottle) + tomato (cooked; in pot) → POUR → soup ({{{food}, tomato}}; in pot)"
    return f"dish: {dish}\nasked: tomato (canned); {food} ({state})\n{SOUP}{add}"


@pytest.mark.parametrize("food", ["water", "milk", "broth", "wine", "chicken broth"])
def test_k3_liquid_after_the_last_cooking_is_minor(food):
    assert found("K3", then(food)) == [f"K3 (minor) step 5: {food} comes after the last cooking"]


@pytest.mark.parametrize(
    "food", ["olive oil", "cream", "honey", "crushed tomato", "soy sauce", "basil", "salt", "hot sauce"]
)
def test_k3_what_is_added_for_its_taste_may_come_late(food):
    assert found("K3", then(food)) == []


def test_k3_liquid_that_was_cooked_with_the_rest_came_in_time():
    early = SOUP.replace("tomato (canned; in can)", "milk (liquid; in carton) + tomato (canned; in can)").replace(
        "tomato (canned; in pot) + pot ({tomato}; on stove)",
        "milk (liquid; in pot) + tomato (canned; in pot) + pot ({milk, tomato}; on stove)",
    )
    assert found("K3", f"dish: soup\nasked: tomato (canned); milk (liquid)\n{early}") == []


def test_k3_in_a_dish_that_is_eaten_cold_liquid_may_come_at_any_time():
    assert found("K3", then("milk", dish="salad")) == []
    assert found("K3", then("milk").split("\n", 2)[2]) == []


def test_k3_nothing_is_late_where_nothing_was_cooked():
    step = "milk (liquid; in carton) + tomato (canned; in can) + pot (empty) → POUR → soup ({milk, tomato}; in pot)"
    assert found("K3", f"dish: soup\nasked: tomato (canned); milk (liquid)\n{step}") == []


def test_k3_leaves_that_are_cooked_together_with_what_must_be_cooked():
    text = """
beef (raw) + grill (off) → PUT → beef (raw; on grill) + grill (off)
spinach (leaves; in bag) + grill (off) → PUT → spinach (leaves; on grill) + grill (off)
grill (off) → TURN ON → grill (on)
beef (raw; on grill) + spinach (leaves; on grill) + grill (on) → GRILL → beef (grilled; on grill) + grill (on)
"""
    assert found("K3", text) == ["K3 (minor) step 4: spinach is cooked together with beef"]
    assert found("K3", text.replace("→ GRILL →", "→ HEAT →")) == []
    assert found("K3", text.replace("beef", "tomato")) == []
    assert found("K3", text.replace("spinach", "onion")) == []
    assert found("K3", text.replace("beef", "leek")) == []


EGGS = boiled("egg").strip()


def peeled_egg(motion="peel", between="", ends="peeled"):
    last = f"egg (cooked) + bowl (empty) + hand → {motion.upper()} → egg ({ends}; in bowl) + bowl ({{egg}})"
    last = last.replace("egg (cooked)", "egg (cooked; in pot)") if not between else last
    return found("K3", lines(EGGS, between, last))


@pytest.mark.parametrize("motion", ["peel", "shell"])
def test_k3_eggs_are_peeled_before_they_have_cooled(motion):
    assert peeled_egg(motion) == ["K3 (minor) step 6: eggs are peeled boiling hot"]


@pytest.mark.parametrize("motion", ["wash", "rinse", "soak", "cool", "wait"])
def test_k3_eggs_that_have_cooled_are_peeled(motion):
    cooled = f"egg (cooked; in pot) + bowl (empty) → {motion.upper()} → egg (cooked)"
    assert peeled_egg(between=cooled) == []


def test_k3_eggs_that_were_only_moved_are_hot_still():
    moved = "egg (cooked; in pot) + bowl (empty) → PUT → egg (cooked; in bowl)"
    last = "egg (cooked; in bowl) + hand → PEEL → egg (peeled; in bowl)"
    assert found("K3", lines(EGGS, moved, last)) == ["K3 (minor) step 7: eggs are peeled boiling hot"]


def test_k3_washing_before_the_boiling_cools_nothing():
    washed = lines("egg (whole) + bowl (empty) → WASH → egg (whole)", EGGS)
    last = "egg (cooked; in pot) + hand + bowl (empty) → PEEL → egg (peeled; in bowl)"
    assert found("K3", lines(washed, last)) == ["K3 (minor) step 7: eggs are peeled boiling hot"]


def test_k3_raw_eggs_are_cracked_and_other_hot_food_is_peeled():
    assert found("K3", "egg (whole) + bowl (empty) → PEEL → egg (peeled; in bowl) + bowl ({egg})") == []
    potato = (
        boiled("potato").strip() + "\npotato (cooked; in pot) + bowl (empty) + hand → PEEL → potato (peeled; in bowl)"
    )
    assert found("K3", potato) == []


# --- K4 tool ---


@pytest.mark.parametrize("tool", ["grater", "peeler", "food processor", "fork"])
def test_k4_grating_with_what_grates_or_peels(tool):
    step = f"carrot (whole) + {tool} + bowl (empty) → GRATE → carrot (grated; in bowl) + bowl ({{carrot}})"
    assert found("K4", step) == []


@pytest.mark.parametrize("tool", ["spoon", "bowl", "mortar"])
def test_k4_grating_without_is_fatal_for_the_robot_and_the_cook(tool):
    step = f"carrot (whole) + {tool} + plate (empty) → GRATE → carrot (grated; on plate) + plate ({{carrot}})"
    judged = report(step)
    assert [str(one) for one in judged.of(["K4"])] == ["K4 step 1: it is grated without grater, peeler or processor"]
    assert (judged.robot, judged.cook) == (False, False)


@pytest.mark.parametrize("motion", ["slice", "mix", "grate", "beat"])
def test_k4_cutting_or_mixing_with_a_lid(motion):
    step = f'carrot (whole) + lid + plate (empty) → "{motion}" → carrot (whole; on plate) + plate ({{carrot}})'
    assert f"K4 step 1 lid: “{motion}” with a lid" in found("K4", step)


@pytest.mark.parametrize("motion", ["cover", "put", "wait", "heat"])
def test_k4_a_lid_may_do_other_things(motion):
    step = f'carrot (whole) + lid + plate (empty) → "{motion}" → carrot (whole; on plate) + plate ({{carrot}})'
    assert found("K4", step) == []


@pytest.mark.parametrize("tool", ["knife", "food processor (on)"])
def test_k4_a_lid_beside_a_tool_or_an_appliance_is_no_tool(tool):
    step = f"carrot (whole) + lid + {tool} + plate (empty) → SLICE → carrot (sliced; on plate) + plate ({{carrot}})"
    assert found("K4", step) == []


def test_k4_the_lid_that_is_named_first_is_told_once():
    step = "carrot (whole) + pot lid + lid + plate (empty) → MIX → carrot (whole; on plate) + plate ({carrot})"
    assert found("K4", step) == ["K4 step 1 pot lid: “mix” with a lid"]


@pytest.mark.parametrize(
    ("motion", "ends"), [("slice", "grated"), ("grate", "diced"), ("mix", "diced"), ("peel", "chopped")]
)
def test_k4_a_motion_that_cannot_give_that_state_is_minor(motion, ends):
    step = (
        f"carrot (whole) + grater + plate (empty) → {motion.upper()} → carrot ({ends}; on plate) + plate ({{carrot}})"
    )
    judged = report(step)
    wrong = [one for one in judged.findings if ends in one.reason and one.rule in {"K4", "K7"}]
    assert [one.minor for one in wrong] == [True]
    assert wrong[0].step == 0
    assert [node.label for node in wrong[0].nodes] == ["carrot"]


@pytest.mark.parametrize(("motion", "ends"), [("slice", "sliced"), ("grate", "grated"), ("slice", "thinly sliced")])
def test_k4_a_motion_that_gives_the_state_it_claims(motion, ends):
    step = (
        f"carrot (whole) + grater + plate (empty) → {motion.upper()} → carrot ({ends}; on plate) + plate ({{carrot}})"
    )
    assert found("K4", step) == []


# --- K3: what makes dough rise ---


@pytest.mark.parametrize(("cooling", "dead"), [("", True), ("COOL", False)])
def test_k3_boiling_water_kills_yeast(cooling, dead):
    states = "boiling, cooled" if cooling else "boiling"
    cooled = f"water (boiling; in pot) + pot (hot; {{water}}) → {cooling} → water ({states}; in pot) + pot ({{water}})"
    tree = lines(
        "water (liquid; in bottle) + pot (empty) → POUR → water (liquid; in pot) + pot ({water})",
        "pot ({water}) + stove (off) → PUT → pot ({water}; on stove) + stove (off)",
        "stove (off) → TURN ON → stove (on)",
        "water (liquid; in pot) + pot ({water}; on stove) + stove (on) → BOIL "
        "→ water (boiling; in pot) + pot (hot; {water})",
        cooled if cooling else "stove (on) → TURN OFF → stove (off)",
        "yeast (powder; in packet) + bowl (empty) → POUR → yeast (powder; in bowl) + bowl ({yeast})",
        f"water ({states}; in pot) + bowl ({{yeast}}) → POUR → water ({states}; in bowl) + bowl ({{water, yeast}})",
        f"water ({states}; in bowl) + yeast (powder; in bowl) + bowl ({{water, yeast}}) + spoon → MIX "
        "→ mixture (mixed; {water, yeast}; in bowl) + bowl ({mixture})",
    )
    assert bool([line for line in found("K3", tree) if "is killed by boiling water" in line]) is dead
