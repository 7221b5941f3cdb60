"""W5 (docs/contract.md): each clause kept and broken by a small tree.

How a kitchen comes to its answers is in tests/world; here stand the rules as a person reads them in a report.
"""

from __future__ import annotations

import pytest
from validation.dishes import ON_STOVE, ONION, lines
from validation.judging import found

LIGHT = "stove (off; under pan) → TURN ON → stove (on; under pan)\n"


# --- W5 order ---


OILED = "oil (liquid; in bottle) + pan (empty; on stove) → POUR → oil (liquid; in pan) + pan ({oil}; on stove)\n"


FOODS = ("tomato", "cucumber", "carrot", "celery", "radish", "apple")


def prepared(count):
    """So many steps that prepare other food."""
    return lines(*(ONION.replace("onion", food) for food in FOODS[:count]))


@pytest.mark.parametrize(("count", "waits"), [(3, False), (4, False), (5, True)])
def test_w5_food_waits_in_the_heat_for_four_units_and_no_more(count, waits):
    text = lines(ON_STOVE, OILED, LIGHT, prepared(count))
    assert found("W5", text) == (
        ["W5 (minor) step 8: what is in the pan waits in the heat while other food is prepared"] if waits else []
    )


def test_w5_who_waits_is_told_once():
    assert len(found("W5", lines(ON_STOVE, OILED, LIGHT, prepared(6)))) == 1


def test_w5_an_empty_pan_does_not_wait():
    assert found("W5", lines(ON_STOVE, LIGHT, prepared(5))) == []


def test_w5_water_may_boil_as_long_as_it_likes():
    water = OILED.replace("oil", "water").replace("bottle", "measuring cup")
    assert found("W5", lines(ON_STOVE, water, LIGHT, prepared(5))) == []


def test_w5_a_pan_over_a_cold_stove_does_not_wait():
    assert found("W5", lines(ON_STOVE, OILED, prepared(5))) == []


def test_w5_a_pan_that_is_stirred_does_not_wait():
    stir = "pan ({oil}; on stove) + spoon → STIR → pan ({oil}; on stove)"
    both = prepared(5).split("\n")
    assert found("W5", lines(ON_STOVE, OILED, LIGHT, *both[:3], stir, *both[3:])) == []
    assert found("W5", lines(ON_STOVE, OILED, LIGHT, stir, prepared(5))) != []


def test_w5_a_pan_that_gets_food_does_not_wait():
    salt = "salt (granulated; in shaker) → SPRINKLE → salt (granulated; in pan) + pan ({oil, salt}; on stove)"
    salt = salt.replace("shaker) →", "shaker) + pan ({oil}; on stove) →")
    both = prepared(5).split("\n")
    assert found("W5", lines(ON_STOVE, OILED, LIGHT, *both[:4], salt, *both[4:])) == []


def test_w5_steps_that_prepare_nothing_do_not_count():
    waits = ["spoon → WAIT → spoon (used)"] * 3
    assert found("W5", lines(ON_STOVE, OILED, LIGHT, prepared(4), *waits)) == []


@pytest.mark.parametrize(
    ("motion", "counts"),
    [
        ("slice", True), ("peel", True), ("grate", True), ("open", True), ("core", True), ("wash", True),
        ("mash", True), ("grind", True), ("put", True), ("take out", True), ("shape", True), ("mix", True),
        ("wait", False), ("turn off", False), ("discard", False),
    ],
)  # fmt: skip
def test_w5_what_prepares_food(motion, counts):
    step = f'apple (whole) + bowl (empty) → "{motion}" → apple (whole; in bowl) + bowl ({{apple}})'
    told = found("W5", lines(ON_STOVE, OILED, LIGHT, prepared(4), step))
    assert bool(told) is counts


def test_w5_waiting_begins_anew_after_the_pan_left_the_heat():
    off, on = ("stove (on; under pan) → TURN OFF → stove (off; under pan)", LIGHT)
    both = prepared(6).split("\n")
    assert found("W5", lines(ON_STOVE, OILED, LIGHT, *both[:3], off, on, *both[3:])) == []


FAUCET = "faucet (off) → TURN ON → faucet (on)\n"


FETCH = "water (from faucet) + faucet (on) + cup (empty) → FILL → water (liquid; in cup) + cup ({water})"


def test_w5_water_is_fetched_while_something_waits_in_the_heat():
    assert found("W5", lines(FAUCET, ON_STOVE, OILED, LIGHT, FETCH)) == [
        "W5 (minor) step 5: water is fetched while something waits in the heat"
    ]
    assert found("W5", lines(FAUCET, FETCH, ON_STOVE, OILED, LIGHT)) == []
    tap, fetch = (text.replace("faucet", "tap") for text in (FAUCET, FETCH))
    assert len(found("W5", lines(tap, ON_STOVE, OILED, LIGHT, fetch))) == 1


def test_w5_other_food_may_be_washed_under_the_tap_while_the_pan_is_hot():
    wash = "apple (whole) + faucet (on) → WASH → apple (washed)"
    assert found("W5", lines(FAUCET, ON_STOVE, OILED, LIGHT, wash)) == []


def test_w5_water_from_a_bottle_is_not_fetched():
    step = "water (liquid; in bottle) + cup (empty) → POUR → water (liquid; in cup) + cup ({water})"
    assert found("W5", lines(ON_STOVE, OILED, LIGHT, step)) == []


def fried(food, state="whole", motion="FRY", fat=""):
    add = f"{food} ({state}) + pan ({{}}; on stove) → PUT → {food} ({state}; in pan) + pan ({{{food}}}; on stove)"
    add = add.replace("pan ({}; on stove)", "pan ({oil}; on stove)" if fat else "pan (empty; on stove)")
    fry = f"{food} ({state}; in pan) + pan ({{{food}}}; on stove) → {motion} → {food} (fried; in pan)"
    return lines(ON_STOVE, fat, LIGHT, add, fry)


def test_w5_food_to_be_fried_needs_fat_in_the_pan():
    assert found("W5", fried("onion")) == ["W5 (minor) step 4: it is fried in a dry pan"]
    assert found("W5", fried("onion", fat=OILED)) == []


@pytest.mark.parametrize(
    ("food", "state"), [("beef", "raw"), ("salmon", "raw"), ("butter", "solid"), ("milk", "liquid")]
)
def test_w5_food_with_its_own_fat_or_juice_needs_none(food, state):
    assert found("W5", fried(food, state)) == []


@pytest.mark.parametrize("motion", ["BOIL", "BAKE"])
def test_w5_food_that_is_not_fried_needs_no_fat(motion):
    assert found("W5", fried("onion", motion=motion)) == []


def test_w5_what_is_fried_on_an_appliance_itself_is_in_no_dry_pan():
    put = "onion (sliced) + griddle (off) → PUT → onion (sliced; on griddle) + griddle (off)"
    on = "griddle (off) → TURN ON → griddle (on)"
    fry = "onion (sliced; on griddle) + griddle (on) → FRY → onion (fried; on griddle) + griddle (on)"
    assert found("W5", lines(put, on, fry)) == []


@pytest.mark.parametrize("lit", [False, True])
def test_k7_food_over_heat_that_is_never_turned_on_stands_there_for_nothing(lit):
    told = lines(
        "pan (empty) + carton ({stock}) + stock (liquid; in carton) → POUR → pan ({stock}) + stock (liquid; in pan)",
        "pan ({stock}) + stove (off) → PICK-AND-PLACE → pan ({stock}; on stove) + stove (off; under pan)",
        LIGHT if lit else "",
        "pan ({stock}; on stove) + stock (liquid; in pan) + bowl (empty) → POUR"
        " → bowl ({stock}) + stock (liquid; in bowl) + pan (empty; on stove)",
    )
    step = "K7 step 3: the pan stood over what was never turned on"
    assert found("K7", told) == ([] if lit else [step])


def test_k7_another_vessel_of_that_name_stands_over_no_heat():
    told = lines(
        "pan (empty) + carton ({stock}) + stock (liquid; in carton) → POUR → pan ({stock}) + stock (liquid; in pan)",
        "pan ({stock}) + stove (off) → PICK-AND-PLACE → pan ({stock}; on stove) + stove (off; under pan)",
        LIGHT,
        "pan ({stock}; on stove) + pan ({rice}) + rice (uncooked; in pan) → POUR → pan ({rice, stock}; on stove)"
        " + rice (uncooked; in pan) + pan (empty)",
    )
    assert found("K7", told) == []


@pytest.mark.parametrize(
    ("motion", "food", "dry"),
    [
        ("COOK AND STIR", "onion (chopped", True),
        ("COOK", "mushroom (sliced", True),
        ("COOK", "almond (whole", False),
        ("SIMMER", "onion (chopped", False),
    ],
)
@pytest.mark.parametrize("beside", ["", "oil", "bacon"])
def test_w5_vegetables_are_cooked_in_no_dry_pan_though_they_leave_it_then(motion, food, dry, beside):
    name = food.partition(" ")[0]
    both = ", ".join(filter(None, sorted([name, beside])))
    text = lines(
        f"{beside} (raw) + pan (empty; on stove) → POUR → {beside} (raw; in pan) + pan ({{{beside}}}; on stove)"
        if beside
        else "stove (off) + pan (empty) → PUT → pan (empty; on stove) + stove (off; under pan)",
        f"{food}; in bowl) + pan ({{{both}}}; on stove) → POUR → {food}; in pan) + pan ({{{both}}}; on stove)",
        "stove (off; under pan) → TURN ON → stove (on; under pan)",
        f"{food}; in pan) + pan ({{{both}}}; on stove) + stove (on; under pan) → {motion}"
        f" → {food}, cooked; in pan) + pan (hot; {{{both}}}; on stove)",
        f"{food}, cooked; in pan) + pan (hot; {{{both}}}; on stove) + plate (empty) → POUR"
        f" → {food}, cooked; on plate) + plate ({{{both}}}) + pan (empty; on stove)",
    )
    assert any("dry pan" in told for told in found("W5", text)) is (dry and not beside)
