"""What a food can undergo as it is, and what a tool cannot give it (W4): paste, porridge, batter, nut."""

from __future__ import annotations

from dataclasses import replace

import pytest
from validation.dishes import lines
from validation.judging import found

from foon_kg.validation import check
from foon_kg.validation.notation import read_tree


def breaks(step, why):
    """Whether W4 forbids a step for a reason in which the words ``why`` are."""
    return any(why in told for told in found("W4", step))


def worked(foods, motion, state="kneaded, mixed"):
    held = "{" + ", ".join(foods) + "}"
    inputs = " + ".join(f"{food} ({state_}; in bowl)" for food, state_ in foods.items())
    return f"bowl ({held}) + {inputs} → {motion} → mixture ({state}; {held}; in bowl) + bowl ({held})"


@pytest.mark.parametrize(
    ("foods", "fault"),
    [
        ({"egg": "cracked", "butter": "melted", "salt": "granulated"}, True),
        ({"egg": "cracked", "butter": "melted", "flour": "powder"}, False),
        ({"egg": "cracked", "beef": "minced"}, False),
        ({"egg": "cracked", "peanut butter": "creamy"}, False),
        ({"butter": "softened", "sugar": "granulated"}, False),
        ({"condensed milk": "thick", "coconut": "shredded"}, False),
    ],
)
@pytest.mark.parametrize("motion", ["KNEAD", "SHAPE"])
def test_w4_only_what_makes_a_dough_or_paste_is_kneaded_or_shaped(motion, foods, fault):
    assert breaks(worked(foods, motion), "can be kneaded") is fault


def test_w4_flesh_is_shaped_though_nobody_names_it_again():
    named = worked({"beef": "minced", "egg": "cracked"}, "SHAPE", "shaped")
    left_out = "mixture (shaped; {egg, wine}; in bowl)".join(named.split("mixture (shaped; {beef, egg}; in bowl)"))
    assert left_out != named
    assert not breaks(left_out, "can be kneaded")


def test_w4_noodles_of_semolina_keep_their_shape_in_a_strainer():
    foods = "flour, semolina, water"
    step = f"pot (hot; {{{foods}}}) + dough (cut, kneaded, partly cooked; {{{foods}}}; in pot) + strainer (empty) → "
    step += f"DRAIN → strainer ({{{foods}}}) + dough (cut, kneaded, partly cooked; {{{foods}}}; in strainer)"
    assert not breaks(step, "no strainer holds")


def test_w4_what_has_set_may_be_rolled():
    rolled = worked({"egg": "cooked", "stock": "cooked"}, "ROLL", "cooked, rolled")
    assert not breaks(rolled, "rolled out")


@pytest.mark.parametrize(
    ("food", "state", "fault"),
    [("polenta", "cooked", True), ("rice", "cooked", False), ("chilli", "blended", True), ("chilli", "boiled", False)],
)
def test_w4_no_strainer_holds_a_porridge_or_paste(food, state, fault):
    step = f"pot (hot; {{{food}}}) + {food} ({state}; in pot) + strainer (empty) → POUR → "
    step += f"strainer ({{{food}}}) + {food} ({state}; in strainer) + pot (empty, hot)"
    assert breaks(step, "no strainer holds") is fault


@pytest.mark.parametrize(("motion", "fault"), [("PRESS", False), ("STRAIN", False), ("PICK-AND-PLACE", True)])
def test_w4_a_paste_is_poured_into_a_strainer_to_be_pressed_through(motion, fault):
    paste, held = "raspberry (blended; in strainer)", "strainer ({raspberry})"
    pour = f"jar ({{raspberry}}) + raspberry (blended; in jar) + strainer (empty) → POUR → {held} + {paste} + jar"
    then = f"{held} + {paste} + bowl (empty) → {motion} → raspberry (blended; in bowl) + bowl ({{raspberry}})"
    assert breaks(lines(pour, then), "no strainer holds") is fault


@pytest.mark.parametrize(
    ("foods", "place", "fault"),
    [
        ("coconut milk, egg, fish", "on cutting board", True),
        ("coconut milk, egg, fish", "in bowl", False),
        ("egg, flour, milk", "on cutting board", False),
        ("carrot, onion", "on cutting board", False),
    ],
)
def test_w4_what_runs_is_not_laid_on_a_board(foods, place, fault):
    vessel = place.partition(" ")[2]
    step = f"{vessel} (empty) + jug ({{{foods}}}) + filling (mixed; {{{foods}}}; in jug) → POUR → "
    step += f"{vessel} ({{{foods}}}) + filling (mixed; {{{foods}}}; {place}) + jug (empty)"
    assert breaks(step, "runs off") is fault


@pytest.mark.parametrize(
    ("beside", "fault"),
    [("banana leaf (whole; on cutting board)", False), ("knife (on cutting board)", True)],
)
def test_w4_what_runs_lies_on_a_leaf_though_no_board_names_that(beside, fault):
    foods = "coconut milk, egg, fish"
    step = f"cutting board + {beside} + jug ({{{foods}}}) + filling (mixed; {{{foods}}}; in jug) → POUR → "
    step += f"cutting board + {beside} + filling (mixed; {{{foods}}}; on cutting board) + jug (empty)"
    assert breaks(step, "runs off") is fault


@pytest.mark.parametrize(
    ("food", "state", "motion", "tool", "told"),
    [
        ("pistachio", "slivered", "CUT", "scissor", "does not cut"),
        ("vanilla bean", "split", "CUT", "scraper", "does not cut"),
        ("pistachio", "slivered", "CUT", "knife", ""),
        ("chives", "chopped", "CUT", "scissor", ""),
        ("pineapple", "grated", "MINCE", "knife", "without a grater"),
        ("pineapple", "grated", "GRATE", "grater", ""),
        ("pineapple", "grated", "GRATE", "knife + food processor", ""),
        ("pineapple", "minced", "MINCE", "knife", ""),
    ],
)
def test_w4_a_tool_gives_only_what_it_can(food, state, motion, tool, told):
    step = f"{food} (whole) + cutting board (empty) + {tool} → {motion} → "
    step += f"{food} ({state}; on cutting board) + cutting board ({{{food}}})"
    faults = [one for one in found("W4", step) if "does not cut" in one or "without a grater" in one]
    assert ([told in one for one in faults] == [True]) if told else not faults


@pytest.mark.parametrize(
    ("food", "fault"), [("beef brisket (raw", True), ("beef brisket (cubed", False), ("onion (whole", False)]
)
def test_w4_a_joint_in_one_piece_is_turned_and_not_stirred(food, fault):
    name = food.partition(" (")[0]
    step = f"pot ({{{name}}}) + {food}; in pot) + spoon → STIR → {food}, mixed; in pot) + pot ({{{name}}})"
    assert breaks(step, "nobody stirs a whole") is fault


def numbered(text, things):
    """A tree in which each thing has the number that ``things`` says for its label, or for it in one step."""
    tree = read_tree(text)

    def side(mentions, place):
        labels = (one.node.label for one in mentions)
        numbers = (things.get((label, place), things.get(label)) for label in labels)
        return tuple(one._replace(thing=number) for one, number in zip(mentions, numbers, strict=True))

    units = []
    for place, unit in enumerate(tree.units):
        units.append(replace(unit, inputs=side(unit.inputs, place), outputs=side(unit.outputs, place)))
    return replace(tree, units=tuple(units))


def faults_of(tree, why):
    return [finding for finding in check(tree).of(["W4"]) if why in finding.reason]


IN_POT = "pot (empty) + dal (cooked; in bowl) + bowl ({dal}) → POUR → dal (cooked; in pot) + pot ({dal}) + bowl (empty)"


@pytest.mark.parametrize(("state", "fault"), [("cooked, mashed", True), ("cooked", False)])
def test_w4_a_state_that_no_step_gave(state, fault):
    on = f"plate (empty) + pot ({{dal}}) + dal ({state}; in pot) → POUR → dal ({state}; on plate) + plate ({{dal}})"
    tree = numbered(lines(IN_POT, on), {"dal": 1})
    assert bool(faults_of(tree, "no step made it so")) is fault


@pytest.mark.parametrize(
    ("vessel", "second", "fault"), [("blender jar", 8, True), ("blender jar", 7, False), ("bowl", 8, False)]
)
def test_w4_there_is_no_second_of_what_a_kitchen_has_once(vessel, second, fault):
    fill = (
        f"{vessel} (empty) + {{0}} (chopped) → PICK-AND-PLACE → {{0}} (chopped; in {vessel}) + {vessel} ({{{{{{0}}}}}})"
    )
    tree = numbered(lines(fill.format("onion"), fill.format("chilli")), {vessel: 7, (vessel, 1): second})
    assert bool(faults_of(tree, "no second one")) is fault
