"""W1 to W5 (docs/contract.md): each clause kept and broken by a small tree.

How a kitchen comes to its answers is in tests/world; here stand the rules as a person reads them in a report.
"""

from __future__ import annotations

import pytest
from validation.judging import ONE_TOMATO, found, report

ONION = "onion (whole) + cutting board (empty) + knife → SLICE → onion (sliced; on cutting board)\n"
IN_BOWL = (
    "tomato (sliced; on plate) + plate ({tomato}) + bowl (empty) → POUR → tomato (sliced; in bowl) + bowl ({tomato})\n"
)
ON_STOVE = "pan (empty) + stove (off) → PICK-AND-PLACE → pan (empty; on stove) + stove (off; under pan)\n"
LIGHT = "stove (off; under pan) → TURN ON → stove (on; under pan)\n"


def lines(*steps):
    return "\n".join(step.strip() for step in steps)


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


# --- W4 idle ---


@pytest.mark.parametrize("motion", ["POUR", "PICK-AND-PLACE", "SPRINKLE", "PUT"])
def test_w4_nothing_moves(motion):
    step = f"tomato (sliced; on plate) + plate ({{tomato}}) → {motion} → tomato (sliced; on plate) + plate ({{tomato}})"
    assert found("W4", lines(ONE_TOMATO, step)) == [f"W4 step 2: nothing moves in “{motion.lower()}”"]


def test_w4_the_finding_is_fatal_and_of_the_robot():
    step = "tomato (sliced; on plate) + plate ({tomato}) → POUR → tomato (sliced; on plate) + plate ({tomato})"
    judged = report(lines(ONE_TOMATO, step))
    assert (judged.robot, judged.cook) == (False, True)


def test_w4_a_food_that_comes_to_another_place_moves():
    assert found("W4", lines(ONE_TOMATO, IN_BOWL)) == []


def test_w4_a_vessel_that_comes_to_another_place_moves():
    assert found("W4", lines(ONE_TOMATO, "plate ({tomato}) + table → PUT → plate ({tomato}; on table)")) == []
    assert found("W4", ON_STOVE) == []


@pytest.mark.parametrize("motion", ["mix and pour", "fry and pour", "slice and put", "peel and put", "open and pour"])
def test_w4_a_step_that_does_more_than_move_need_move_nothing(motion):
    step = f'tomato (sliced; on plate) + plate ({{tomato}}) + knife → "{motion}" → tomato (sliced; on plate)'
    assert not [told for told in found("W4", lines(ONE_TOMATO, step)) if "nothing moves" in told]


@pytest.mark.parametrize(
    "motion",
    [
        "mix", "fry", "blend", "knead", "shape", "flip", "cover", "attach", "detach", "coat", "turn on", "cut", "grate",
        "grind", "peel", "open",
    ],
)  # fmt: skip
def test_w4_every_other_thing_that_hands_do_is_enough(motion):
    step = f'tomato (sliced; on plate) + plate ({{tomato}}) → "{motion} and put" → tomato (sliced; on plate)'
    assert not [told for told in found("W4", lines(ONE_TOMATO, step)) if "nothing moves" in told]


@pytest.mark.parametrize("tool", ["mortar", "food processor", "pepper mill", "grinder", "grater", "blender"])
def test_w4_grinding_with_what_grinds(tool):
    step = f"almond (whole) + {tool} + bowl (empty) → GRIND → almond (ground; in bowl) + bowl ({{almond}})"
    assert found("W4", step) == []


@pytest.mark.parametrize("tool", ["knife", "spoon", "bowl", "stove"])
def test_w4_grinding_without_what_grinds(tool):
    step = f"almond (whole) + {tool} + plate (empty) → GRIND → almond (ground; on plate) + plate ({{almond}})"
    assert found("W4", step) == ["W4 step 1: it is ground without a mill, mortar, blender or processor"]


def test_w4_a_bowl_that_stands_in_a_processor_grinds():
    attach = (
        "food processor bowl (empty) + food processor (off) → ATTACH → food processor bowl (empty; on food processor)"
    )
    fill = (
        "almond (whole) + food processor bowl (empty; on food processor) → PUT → almond (whole; in food processor bowl)"
    )
    grind = "almond (whole; in food processor bowl) → GRIND → almond (ground; in food processor bowl)"
    by_bowl = "food processor bowl ({almond}; on food processor) → GRIND → almond (ground; in food processor bowl)"
    assert found("W4", lines(attach, fill, by_bowl)) == []
    assert found("W4", lines(fill.replace("; on food processor", ""), grind)) == [
        "W4 step 2: it is ground without a mill, mortar, blender or processor"
    ]


def test_w4_food_that_lies_in_a_mortar_is_ground_there():
    fill = "almond (whole) + mortar (empty) → PUT → almond (whole; in mortar) + mortar ({almond})"
    assert found("W4", lines(fill, "almond (whole; in mortar) → GRIND → almond (ground; in mortar)")) == []


CUT_FOR_NOTHING = "W4 (minor) step 1: onion is prepared and is not in the dish"


def test_w4_food_that_is_cut_and_is_not_in_the_dish():
    assert found("W4", lines(ONION, ONE_TOMATO)) == [CUT_FOR_NOTHING]
    assert found("W4", lines(ONION.replace("SLICE", "GRATE"), ONE_TOMATO)) == [CUT_FOR_NOTHING]


def test_w4_food_that_is_peeled_only_is_no_cut_for_nothing():
    assert found("W4", lines("onion (whole) + knife → PEEL → onion (peeled)", ONE_TOMATO)) == []


def test_w4_food_that_is_cut_and_comes_into_the_dish():
    add = (
        "onion (sliced; on cutting board) + plate ({tomato}) → PUT → onion (sliced; on plate) + plate ({onion, tomato})"
    )
    assert found("W4", lines(ONION, ONE_TOMATO, add)) == []


def test_w4_a_portion_of_what_was_cut_in_the_dish_is_enough():
    half = "tomato (whole) + plate (empty) + knife → HALVE → tomato (halved; on plate) + tomato (halved; on table)"
    assert found("W4", half) == []


def test_w4_a_tree_without_a_dish_cuts_nothing_for_nothing():
    assert found("W4", "goal: soup\n" + lines(ONION, ONE_TOMATO)) == []


def test_w4_food_that_is_moved_only_to_be_moved_on():
    on = "tomato (sliced; in bowl) + bowl ({tomato}) + cup (empty) → POUR → tomato (sliced; in cup) + cup ({tomato})"
    assert found("W4", lines(ONE_TOMATO, IN_BOWL, on)) == [
        "W4 (minor) step 3: tomato was put into the bowl only to be taken out again"
    ]


def test_w4_food_that_is_moved_on_by_a_later_step_waited_there():
    on = "tomato (sliced; in bowl) + bowl ({tomato}) + cup (empty) → POUR → tomato (sliced; in cup) + cup ({tomato})"
    assert found("W4", lines(ONE_TOMATO, IN_BOWL, ON_STOVE, on)) == []


@pytest.mark.parametrize("motion", ["mix", "pour and mix"])
def test_w4_food_that_was_worked_on_in_between_was_there_for_that(motion):
    work = f'tomato (sliced; in bowl) + bowl ({{tomato}}) → "{motion}" → tomato (sliced, mixed; in bowl)'
    on = "tomato (sliced, mixed; in bowl) + cup (empty) → POUR → tomato (sliced, mixed; in cup) + cup ({tomato})"
    assert found("W4", lines(ONE_TOMATO, IN_BOWL, work, on)) == []


@pytest.mark.parametrize("vessel", ["measuring cup", "strainer", "pan", "baking tray", "cup", "kettle", "ramekin"])
def test_w4_a_vessel_that_measures_strains_or_cooks_serves_something(vessel):
    into, on = (IN_BOWL.replace("bowl", vessel), IN_BOWL.replace("bowl", "jug").replace("on plate", f"in {vessel}"))
    assert found("W4", lines(ONE_TOMATO, into, on.replace("plate ({tomato})", f"{vessel} ({{tomato}})"))) == []


def test_w4_a_dish_may_be_put_from_one_vessel_into_another():
    mix = "tomato (sliced) + onion (sliced) + bowl (empty) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})"
    one = "salad ({onion, tomato}; in bowl) + bowl ({salad}) + plate (empty) → PUT → salad ({onion, tomato}; on plate)"
    two = "salad ({onion, tomato}; on plate) + tureen (empty) → PUT → salad ({onion, tomato}; in tureen)"
    assert found("W4", lines(mix, one, two)) == []


def test_w4_a_vessel_in_which_it_joined_others_served_that():
    salt = "salt (granulated; in shaker) + bowl (empty) → SPRINKLE → salt (granulated; in bowl) + bowl ({salt})"
    into = IN_BOWL.replace("bowl (empty)", "bowl ({salt})").replace("bowl ({tomato})", "bowl ({salt, tomato})")
    on = "tomato (sliced; in bowl) + bowl ({salt, tomato}) + cup (empty) → PUT → tomato (sliced; in cup)"
    assert found("W4", lines(ONE_TOMATO, salt, into, on)) == []


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


@pytest.mark.parametrize(
    ("motion", "thing", "tool", "told"),
    [
        ("PICK-AND-PLACE", "broth (liquid", "", ["W4 step 1 broth (liquid; in bowl): broth runs, and is picked up"]),
        ("PICK-AND-PLACE", "broth (liquid", " + ladle", []),
        ("POUR", "broth (liquid", "", []),
        ("PICK-AND-PLACE", "egg (cracked", "", ["W4 step 1 egg (cracked; in bowl): egg runs, and is picked up"]),
        (
            "PICK-AND-PLACE",
            "egg (thick liquid",
            "",
            ["W4 step 1 egg (thick liquid; in bowl): egg runs, and is picked up"],
        ),
        ("PICK-AND-PLACE", "butter (melted", "", ["W4 step 1 butter (melted; in bowl): butter runs, and is picked up"]),
        ("PICK-AND-PLACE", "egg (whole", "", []),
        ("PICK-AND-PLACE", "egg (beaten, cooked", "", []),
        ("PICK-AND-PLACE", "butter (softened", "", []),
        ("PICK-AND-PLACE", "broth (frozen", "", []),
        ("PICK-AND-PLACE", "carrot (sliced", "", []),
    ],
)
def test_w4_what_runs_is_not_picked_up(motion, thing, tool, told):
    name = thing.partition(" ")[0]
    step = (
        f"{thing}; in pan) + pan ({{{name}}}) + bowl (empty){tool} → {motion} → {thing}; in bowl) + bowl ({{{name}}})"
    )
    assert found("W4", step) == told


def test_w4_a_pudding_runs_until_it_is_chilled():
    step = (
        "pudding (cooked; {{milk, starch, sugar}}; in pot) + pot ({{milk, starch, sugar}}) + bowl (empty) → "
        "PICK-AND-PLACE → pudding ({state}; {{milk, starch, sugar}}; in bowl) + bowl ({{milk, starch, sugar}})"
    )
    assert any("runs" in told for told in found("W4", step.format(state="cooked")))
    assert found("W4", step.format(state="chilled")) == []


@pytest.mark.parametrize(
    ("food", "state", "motion", "tool", "fault"),
    [
        ("allspice berry", "ground", "MINCE", "knife", True),
        ("mystery seed", "ground", "MINCE", "knife", True),
        ("allspice berry", "ground", "GRIND", "mortar", False),
        ("beef", "ground", "MINCE", "knife", False),
        ("garlic", "paste", "MINCE", "knife", False),
    ],
)
def test_w4_a_knife_grinds_what_is_soft(food, state, motion, tool, fault):
    step = f"{food} (whole) + cutting board (empty) + {tool} → {motion} → {food} ({state}; on cutting board)"
    assert any("too hard" in told for told in found("W4", step)) is fault


@pytest.mark.parametrize(
    ("before", "after", "fault"),
    [("ground", "minced", True), ("powder", "chopped", True), ("chopped", "minced", False), ("whole", "minced", False)],
)
def test_w4_no_knife_makes_pieces_of_a_powder(before, after, fault):
    step = f"garlic ({before}) + cutting board (empty) + knife → CHOP → garlic ({after}; on cutting board)"
    assert any("finer" in told for told in found("W4", step)) is fault


@pytest.mark.parametrize(
    ("food", "tool", "fault"),
    [("pork tenderloin", "", True), ("pineapple", "", True), ("pineapple", " + knife", False), ("lettuce", "", False)],
)
def test_w4_bare_hands_break_nothing_firm_and_raw(food, tool, fault):
    step = f"{food} (whole) + bowl (empty){tool} → BREAK APART → {food} (pieces; in bowl) + bowl ({{{food}}})"
    assert any("by hand" in told for told in found("W4", step)) is fault


@pytest.mark.parametrize(("state", "fault"), [("flakes", True), ("powder", True), ("whole", False), ("block", False)])
def test_w4_no_grater_holds_what_is_small(state, fault):
    step = f"coconut ({state}) + bowl (empty) + grater → GRATE → coconut (grated; in bowl) + bowl ({{coconut}})"
    assert any("no grater" in told for told in found("W4", step)) is fault


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
