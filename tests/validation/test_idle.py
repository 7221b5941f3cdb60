"""W4 (docs/contract.md): each clause kept and broken by a small tree.

How a kitchen comes to its answers is in tests/world; here stand the rules as a person reads them in a report.
"""

from __future__ import annotations

import pytest
from validation.dishes import IN_BOWL, ON_STOVE, ONION, lines
from validation.judging import ONE_TOMATO, found, report


def breaks(step, why):
    """Whether W4 forbids a step for a reason in which the words ``why`` are."""
    return any(why in told for told in found("W4", step))


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
        ("PICK-AND-PLACE", "salsa (sauce", "", ["W4 step 1 salsa (sauce; in bowl): salsa runs, and is picked up"]),
        ("PICK-AND-PLACE", "salsa (sauce", " + ladle", []),
        (
            "PICK-AND-PLACE",
            "salsa (sauce",
            " + turner",
            ["W4 step 1 salsa (sauce; in bowl): salsa runs, and is picked up"],
        ),
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


@pytest.mark.parametrize(
    ("foods", "heat", "told"),
    [
        ("butter, garlic, sage", "hot; ", True),
        ("butter, garlic, sage", "", False),
        ("butter, garlic, mushroom", "hot; ", False),
        ("butter, gammon steak, salt", "hot; ", False),
    ],
)
def test_w4_a_turner_holds_no_melted_fat(foods, heat, told):
    step = (
        f"mixture ({{{foods}}}; in pan) + pan ({heat}{{{foods}}}) + bowl (empty) + turner → PICK-AND-PLACE → "
        f"mixture ({{{foods}}}; in bowl) + bowl ({{{foods}}}) + pan (empty)"
    )
    assert any("mixture runs" in one for one in found("W4", step)) == told


@pytest.mark.parametrize(
    ("thing", "liquid", "tool", "told"),
    [
        ("clove", "cider", "tong", ["W4 step 1: clove lies loose in a liquid, and is lifted out"]),
        ("peppercorn", "cider", "tong", ["W4 step 1: peppercorn lies loose in a liquid, and is lifted out"]),
        ("pine nut", "broth", "tong", ["W4 step 1: pine nut lies loose in a liquid, and is lifted out"]),
        ("peppercorn", "cider", "ladle", []),
        ("peppercorn", "butter", "tong", []),
        ("bay leaf", "cider", "tong", []),
        ("beef", "cider", "tong", []),
    ],
)
def test_w4_tongs_lift_no_small_thing_out_of_a_liquid(thing, liquid, tool, told):
    step = (
        f"{thing} (cooked; in pot) + pot ({{{liquid}, {thing}}}) + plate (empty) + {tool} → REMOVE → "
        f"{thing} (cooked; on plate) + plate ({{{thing}}}) + pot ({{{liquid}}})"
    )
    assert found("W4", step) == told


def test_w4_a_pudding_runs_until_it_is_chilled():
    step = (
        "pudding (cooked; {{milk, starch, sugar}}; in pot) + pot ({{milk, starch, sugar}}) + bowl (empty) → "
        "PICK-AND-PLACE → pudding ({state}; {{milk, starch, sugar}}; in bowl) + bowl ({{milk, starch, sugar}})"
    )
    assert breaks(step.format(state="cooked"), "runs")
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
    assert breaks(step, "too hard") is fault


@pytest.mark.parametrize(
    ("before", "after", "fault"),
    [("ground", "minced", True), ("powder", "chopped", True), ("chopped", "minced", False), ("whole", "minced", False)],
)
def test_w4_no_knife_makes_pieces_of_a_powder(before, after, fault):
    step = f"garlic ({before}) + cutting board (empty) + knife → CHOP → garlic ({after}; on cutting board)"
    assert breaks(step, "finer") is fault


@pytest.mark.parametrize(
    ("food", "tool", "fault"),
    [("pork tenderloin", "", True), ("pineapple", "", True), ("pineapple", " + knife", False), ("lettuce", "", False)],
)
def test_w4_bare_hands_break_nothing_firm_and_raw(food, tool, fault):
    step = f"{food} (whole) + bowl (empty){tool} → BREAK APART → {food} (pieces; in bowl) + bowl ({{{food}}})"
    assert breaks(step, "by hand") is fault


@pytest.mark.parametrize(("boil", "fault"), [("", True), ("before", False)])
def test_w4_bare_hands_break_what_was_cooked_before(boil, fault):
    pot = "pot ({potato, water}; on stove)"
    start = f"""pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
        potato (whole) + water (liquid; in bottle) + pot (empty; on stove) → PUT
          → potato (whole; in pot) + water (liquid; in pot) + {pot}
        stove (off; under pot) → TURN ON → stove (on; under pot)"""
    cooked = f"potato (whole; in pot) + {pot} + stove (on; under pot) → BOIL → potato (boiled; in pot) + {pot}"
    broken = f"potato (whole; in pot) + {pot} → BREAK APART → potato (pieces; in pot) + {pot}"
    order = {"": [broken], "before": [cooked, broken]}[boil]
    assert breaks(lines(start, *order), "by hand") is fault


@pytest.mark.parametrize(("opened", "fault"), [(True, False), (False, True)])
def test_w4_bare_hands_pull_halves_apart_that_a_knife_opened(opened, fault):
    board = "cutting board ({avocado})"
    cut = f"avocado (whole) + cutting board (empty) + knife → CUT → avocado (slit; on cutting board) + {board}"
    pulled = f"avocado (slit; on cutting board) + {board} → PULL APART → avocado (halved; on cutting board) + {board}"
    assert breaks(lines(cut if opened else "", pulled), "by hand") is fault


@pytest.mark.parametrize(("state", "fault"), [("flakes", True), ("powder", True), ("whole", False), ("block", False)])
def test_w4_no_grater_holds_what_is_small(state, fault):
    step = f"coconut ({state}) + bowl (empty) + grater → GRATE → coconut (grated; in bowl) + bowl ({{coconut}})"
    assert breaks(step, "no grater") is fault


@pytest.mark.parametrize(
    ("motion", "thing", "tool", "why"),
    [
        ("PICK-AND-PLACE", "salt (granulated", "", "is a powder, and is picked up"),
        ("PICK-AND-PLACE", "flour (powder", " + spoon", ""),
        ("POUR", "flour (powder", "", ""),
        ("PICK-AND-PLACE", "tomato (whole", "", ""),
        ("PICK-AND-PLACE", "potato (mashed", "", ""),
        ("BRUSH", "paprika (ground", " + brush", "is dry, and no brush takes it up"),
        ("BRUSH", "olive oil (liquid", " + brush", ""),
        ("BRUSH", "mustard (paste", " + brush", ""),
        ("RUB", "paprika (ground", "", ""),
        ("CRACK", "egg (yolk", "", "has no shell to be opened"),
        ("CRACK", "egg white (liquid", "", "has no shell to be opened"),
        ("CRACK", "egg (whole", "", ""),
    ],
)
def test_w4_powder_is_not_picked_up_nor_brushed_and_nothing_is_cracked_twice(motion, thing, tool, why):
    food = thing.partition(" (")[0]
    step = f"{thing}; in jar) + bowl (empty){tool} → {motion} → {thing}; in bowl) + bowl ({{{food}}})"
    told = [one for one in found("W4", step) if "powder" in one or "brush" in one or "shell" in one]
    assert [why in one for one in told] == [True] * bool(why)


def test_w4_a_brush_takes_up_a_rub_that_something_wets():
    def told(wet, foods):
        on = (
            f"brush → BRUSH → mixture (mixed; {{{foods}}}; on plate) + beef (raw; on plate) + plate ({{beef, {foods}}})"
        )
        steps = (
            "paprika (ground; in shaker) + bowl (empty) → POUR → paprika (ground; in bowl) + bowl ({paprika})",
            f"{wet} + bowl ({{paprika}}) → POUR → {wet.partition(';')[0]}; in bowl) + bowl ({{{foods}}})",
            f"bowl ({{{foods}}}) + spoon → MIX → mixture (mixed; {{{foods}}}; in bowl) + bowl ({{{foods}}})",
            f"mixture (mixed; {{{foods}}}; in bowl) + bowl ({{{foods}}}) + beef (on plate) + plate ({{beef}}) + {on}",
        )
        return [one for one in found("W4", lines(*steps)) if "brush" in one]

    assert told("salt (granulated; in shaker)", "paprika, salt")
    assert told("oil (liquid; in bottle)", "oil, paprika") == []
