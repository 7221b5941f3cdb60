"""W1 to W3 (docs/contract.md): each clause kept and broken by a small tree.

How a kitchen comes to its answers is in tests/world; here stand the rules as a person reads them in a report.
"""

from __future__ import annotations

import pytest
from validation.dishes import IN_BOWL, ON_STOVE, lines
from validation.judging import ONE_TOMATO, found, report

# --- W1 source ---


@pytest.mark.parametrize("state", ["whole", "raw", "peeled"])
def test_w1_a_food_in_one_piece_is_taken_once(state):
    step = f"cucumber ({state}) + knife + plate (empty) → SLICE → cucumber (sliced; on plate) + plate ({{cucumber}})"
    assert found("W1", step) == []


def test_w1_a_food_in_one_piece_that_was_cut_before_is_gone():
    told = found(
        "W1", lines(ONE_TOMATO, "tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})")
    )
    assert told == ["W1 step 2 tomato (whole): there is no second tomato: it is sliced in the plate since step 1"]


def test_w1_a_recipe_that_asks_twice_has_two():
    twice = lines(ONE_TOMATO, "tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})")
    head = "dish: salad\nasked: tomato (sliced); tomato (whole)\n"
    assert found("W1", head + twice) == []
    third = "\ntomato (whole) + cup (empty) → PUT → tomato (whole; in cup) + cup ({tomato})"
    assert len(found("W1", head + twice + third)) == 1


def test_w1_a_vessel_whose_contents_were_taken_out():
    again = IN_BOWL.replace("bowl", "cup")
    told = found("W1", lines(ONE_TOMATO, IN_BOWL, again))
    assert "W1 step 3 plate ({tomato}): its tomato was taken out before" in told
    assert all(not finding.minor for finding in report(lines(ONE_TOMATO, IN_BOWL, again)).of(["W1"])[:1])


def test_w1_an_empty_vessel_on_an_appliance_that_holds_food_there():
    oil = "oil (liquid; in bottle) + pan (empty; on stove) → POUR → oil (liquid; in pan) + pan ({oil}; on stove)"
    milk = "milk (liquid; in carton) + pan (empty; on stove) → POUR → milk (liquid; in pan) + pan ({milk}; on stove)"
    assert found("W1", lines(ON_STOVE, oil)) == []
    assert found("W1", lines(ON_STOVE, oil, milk)) == [
        "W1 step 3 pan (empty; on stove): it holds oil there, and is said to be empty"
    ]


def test_w1_more_of_a_divided_food_than_is_left_is_minor():
    more = "tomato (sliced; on plate) + cup (empty) → POUR → tomato (sliced; in cup) + cup ({tomato})"
    text = lines(ONE_TOMATO, IN_BOWL, more)
    (told,) = found("W1", text)
    assert told.startswith("W1 (minor) step 3 tomato (sliced; on plate): more of it is used than is left: ")
    assert told.endswith(": it is sliced in the bowl since step 2")
    assert found("W1", lines(ONE_TOMATO, IN_BOWL, more.replace("on plate", "in bowl"))) == []


# --- W2 matter ---


@pytest.mark.parametrize(
    ("step", "told"),
    [
        (
            "tomato (whole; in bag) → PUT → tomato (whole; in bowl) + bowl ({tomato})",
            "W2 step 1 bowl ({tomato}): a filled bowl comes from nowhere",
        ),
        (
            "tomato (whole; in bag) → PUT → tomato (whole; in bowl)",
            "W2 step 1 tomato (whole; in bowl): there is no bowl in which it could be now",
        ),
        (
            "tomato (whole; in bag) + plate → PUT → tomato (whole; on bread) + plate",
            "W2 step 1 tomato (whole; on bread): there is no bread on which it could be",
        ),
        (
            "soup (in ladle) + bowl (empty) → POUR → soup (in bowl) + bowl ({soup})",
            "W2 step 1 soup (in ladle): nobody put soup into the ladle",
        ),
        (
            "water (liquid; in bottle) + cup (empty) → POUR → tea (hot; in cup) + cup ({tea})",
            "W2 step 1 tea (hot; in cup): tea does not come of water",
        ),
        (
            "tomato (whole) + bowl (empty) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})",
            "W2 step 1 salad ({onion, tomato}; in bowl): it holds onion, which did not go in",
        ),
        (
            "tomato (whole) + bowl (empty) → MIX → salad ({salt, tomato}; in bowl) + bowl ({salad})",
            "W2 (minor) step 1 salad ({salt, tomato}; in bowl): it holds salt, which did not go in",
        ),
    ],
)
def test_w2_nothing_comes_from_nowhere(step, told):
    assert found("W2", step) == [told]


@pytest.mark.parametrize(
    "step",
    [
        "tomato (whole; in bag) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})",
        "tomato (whole; in bag) + bread (whole) + plate → PUT → tomato (whole; on bread) + plate",
        "soup (in pot) + ladle + bowl (empty) → SCOOP → soup (in bowl) + bowl ({soup})",
        "water (liquid; in bottle) + tea bag (in box) + cup (empty) → STEEP → tea (hot; in cup) + cup ({tea})",
        "tomato (whole) + onion (whole) + bowl (empty) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})",
    ],
)
def test_w2_what_went_in_may_come_out(step):
    assert found("W2", step) == []


# --- W3 appliances ---


BOIL = """
pot (empty) + stove (off) → PICK-AND-PLACE → pot (empty; on stove) + stove (off; under pot)
water (liquid; in bottle) + pot (empty; on stove) → POUR → water (liquid; in pot) + pot ({water}; on stove)
stove (off; under pot) → TURN ON → stove (on; under pot)
water (liquid; in pot) + pot ({water}; on stove) + stove (on; under pot) → BOIL → water (boiling; in pot)
"""


def boiled(without=None, **changed):
    steps = BOIL.strip().split("\n")
    if without is not None:
        del steps[without]
    text = lines(*steps)
    for old, new in changed.items():
        text = text.replace(old.replace("_", " "), new)
    return text


def test_w3_the_stove_is_lit_before_it_cooks():
    assert found("W3", boiled()) == []
    assert found("W3", boiled(2)) == [
        "W3 step 3 stove (on; under pot): the stove is said to be on, and nobody turned it on"
    ]


def test_w3_a_stove_that_is_off_cooks_nothing():
    text = boiled(2).replace("stove (on; under pot) → BOIL", "stove (off; under pot) → BOIL")
    assert found("W3", text) == ["W3 step 3 water (liquid; in pot): “boil” while the stove is off"]


def test_w3_a_stove_that_is_on_is_not_off():
    again = "stove (off; under pot) + pot ({water}; on stove) → WAIT → pot ({water}; on stove) + stove (off; under pot)"
    assert found("W3", lines(boiled(), again))[0] == (
        "W3 step 5 stove (off; under pot): the stove is said to be off, and it is on"
    )


def test_w3_nothing_boils_without_any_source_of_heat():
    step = "water (liquid; in bottle) + pot (empty) → BOIL → water (boiling; in pot) + pot ({water})"
    assert found("W3", step) == ["W3 step 1 water (liquid; in bottle): “boil” without a heat source"]


def test_w3_nothing_is_blended_without_a_blender():
    step = "milk (liquid; in carton) + cup (empty) + spoon → BLEND → milk (liquid; in cup) + cup ({milk})"
    (told,) = found("W3", step)
    assert told.startswith("W3 step 1 milk (liquid; in carton): “blend” without a")


COVERED = """
water (liquid; in bottle) + pot (empty) → POUR → water (liquid; in pot) + pot ({water})
pot ({water}) + lid → COVER → pot (covered; {water})
"""


def test_w3_food_does_not_enter_a_covered_vessel():
    salt = "salt (granulated; in shaker) + pot ({water}) → SPRINKLE → salt (granulated; in pot) + pot ({salt, water})"
    assert found("W3", lines(*COVERED.strip().split("\n")[:1], salt)) == []
    assert found("W3", lines(COVERED, salt)) == [
        "W3 step 3 salt (granulated; in shaker): the pot is closed, and salt enters or leaves it"
    ]


RUNNING = """
blender jar (empty) + blender (off) → ATTACH → blender jar (empty; attached to blender) + blender (off)
blender (off) → TURN ON → blender (on)
"""


def test_w3_nothing_is_taken_from_an_appliance_that_runs():
    detach = "blender jar (empty; attached to blender) + blender (on) → DETACH → blender jar (empty) + blender (on)"
    off = "blender (on) → TURN OFF → blender (off)"
    assert found("W3", lines(RUNNING, detach)) == [
        "W3 step 3 blender jar (empty; attached to blender): something is taken from the blender while it runs"
    ]
    assert found("W3", lines(RUNNING, off, detach.replace("(on)", "(off)"))) == []


# --- W1 and W4: what hands and tools can do to a food as it is ---


FRIED = (
    "oil#1 (liquid; in pan#2) + bread#3 (sliced; in pan#2) + pan#2 ({bread, oil}; on stove#4) + stove#4 (on)"
    " → FRY → bread#3 (fried; in pan#2) + pan#2 (hot; {bread, oil}; on stove#4)"
)


def test_w1_what_a_step_used_up_is_not_taken_again():
    again = (
        "oil#1 (liquid; in pan#2) + pan#2 (hot; {bread, oil}; on stove#4) + bowl#5 (empty)"
        " → POUR → oil#1 (liquid; in bowl#5) + bowl#5 ({oil})"
    )
    assert [told for told in found("W1", lines(FRIED, again)) if "used up" in told] == [
        "W1 step 2 oil (liquid; in pan): it was used up in step 1"
    ]
    kept = FRIED.replace("→ FRY →", "→ FRY → oil#1 (liquid; in pan#2) +")
    assert not [told for told in found("W1", lines(kept, again)) if "used up" in told]
