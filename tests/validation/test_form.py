"""C1 to C3 (docs/contract.md): each clause kept and broken by a small tree."""

from __future__ import annotations

import pytest
from validation.judging import ONE_TOMATO, found, report
from validation.tomato_salad import FOON, SALTED, asked, taken

from foon_kg.model import ObjectNode
from foon_kg.model.tree import TaskTree
from foon_kg.validation import check

POURED = (
    "tomato (sliced; on plate) + plate ({tomato}) + bowl (empty) → POUR → tomato (sliced; in bowl) + bowl ({tomato})"
)


# --- C1 ---


def test_c1_every_input_is_in_the_kitchen_or_made_before():
    kitchen = "kitchen: tomato (whole) + plate (empty) + knife + bowl (empty)\n"
    assert found("C1", kitchen + ONE_TOMATO + "\n" + POURED) == []


def test_c1_an_input_that_is_nowhere():
    assert found("C1", f"kitchen: tomato (whole) + plate (empty)\n{ONE_TOMATO}") == [
        "C1 step 1 knife: it is neither in the kitchen nor an output of an earlier step"
    ]


def test_c1_an_input_that_is_made_too_late_names_the_step():
    kitchen = "kitchen: tomato (whole) + plate (empty) + knife + bowl (empty)\n"
    told = found("C1", kitchen + POURED + "\n" + ONE_TOMATO)
    assert [line.partition(": ")[2] for line in told] == [
        "it is needed before it is made: only step 2 outputs it",
        "it is needed before it is made: only step 2 outputs it",
    ]
    assert [line.partition(" tomato")[0] for line in told[:1]] == ["C1 step 1"]


def test_c1_an_input_that_its_own_step_makes_is_needed_before_it_is_made():
    kitchen = "kitchen: knife + tomato (whole)\n"
    text = (
        kitchen + "tomato (whole) + knife → SLICE → tomato (sliced)\nonion (raw) → PEEL → onion (raw) + onion (peeled)"
    )
    assert found("C1", text) == ["C1 step 2 onion (raw): it is neither in the kitchen nor an output of an earlier step"]


def test_c1_an_input_that_was_made_once_before_is_there():
    text = "kitchen: a\na → SLICE → b\nb → DICE → c\nc + b → MIX → d"
    assert found("C1", text) == []


def test_c1_text_that_names_no_kitchen_starts_from_its_leaves():
    assert found("C1", ONE_TOMATO) == []
    assert len(found("C1", f"kitchen: nothing\n{ONE_TOMATO}")) == 3


# --- C2 ---


@pytest.mark.parametrize(
    "goal", ["tomato (sliced; on plate)", "plate ({tomato})"],
)  # fmt: skip
def test_c2_the_last_step_with_food_puts_out_the_goal(goal):
    assert found("C2", f"goal: {goal}\n{ONE_TOMATO}") == []


def test_c2_a_goal_that_an_earlier_step_puts_out():
    assert found("C2", f"goal: tomato (sliced; on plate)\n{ONE_TOMATO}\n{POURED}") == [
        "C2 step 2 tomato (sliced; on plate): the last step with food does not output the goal"
    ]


def test_c2_steps_with_utensils_alone_may_come_after_the_goal():
    text = f"goal: tomato (sliced; on plate)\n{ONE_TOMATO}\nstove (on) → TURN OFF → stove (off)"
    assert found("C2", text) == []


def test_c2_a_tree_without_steps_or_without_food():
    assert found("C2", "name: nothing") == ["C2: the tree has no step with food"]
    assert found("C2", "stove (on) → TURN OFF → stove (off)") == ["C2: the tree has no step with food"]


def test_c2_an_error_is_all_that_there_is():
    assert found("C2", "error: no goal is near") == ["C2: there is no tree: no goal is near"]


def test_c2_without_a_marked_goal_the_richest_food_of_the_last_step_is_it():
    assert found("C2", f"dish: salad\nasked: tomato (sliced)\n{ONE_TOMATO}{SALTED}", FOON) == []
    assert found("C2", f"{ONE_TOMATO}\nknife + plate ({{tomato}}) → PUT → plate ({{tomato}}; on table)", FOON) == [
        "C2 step 1 tomato (sliced; on plate): “tomato” is no end product of any dish type in the FOON"
    ]


SALAD = f"dish: salad\nasked: tomato (sliced)\n{ONE_TOMATO}"


def served(label, holds="salt, tomato", head=SALAD):
    """The tomato salad under another name."""
    return head + SALTED.replace("({salt, tomato}", f"({{{holds}}}").replace("tomato salad", label)


@pytest.mark.parametrize("label", ["tomato salad", "tomato salads", "salad", "simple salad"])
def test_c2_a_recorded_end_product_or_the_bare_dish_type_is_a_true_name(label):
    assert found("C2", served(label), FOON) == []


def test_c2_a_name_that_no_video_of_the_dish_type_has():
    (told,) = found("C2", served("tomato surprise"), FOON)
    assert told.startswith("C2 step 2 tomato surprise ({salt, tomato}; on plate): ")
    assert told.endswith(": “tomato surprise” is no end product of the dish type salad in the FOON")


def test_c2_a_recorded_end_product_may_be_called_anything():
    foon = FOON.replace("tomato salad (", "caprese (")
    assert found("C2", served("caprese"), foon) == []
    assert found("C2", served("caprese", head=ONE_TOMATO), foon) == []


def test_c2_the_dish_type_stands_at_the_end_of_a_name():
    (told,) = found("C2", served("salad surprise"), FOON)
    assert "“salad surprise” is no end product" in told


def test_c2_the_name_of_another_dish_type_is_none_of_the_one_asked():
    soup = SALAD.replace("dish: salad", "dish: soup")
    (told,) = found("C2", served("tomato salad", head=soup), FOON)
    assert told.endswith(": “tomato salad” is no end product of the dish type soup in the FOON")


def test_c2_without_a_recipe_any_dish_type_will_do():
    assert found("C2", served("tomato salad", head=ONE_TOMATO), FOON) == []
    assert found("C2", served("roast", head=ONE_TOMATO), FOON) == []
    assert found("C2", served("surprise", head=ONE_TOMATO), FOON) == [
        "C2 step 2 surprise ({salt, tomato}; on plate): “surprise” is no end product of any dish type in the FOON"
    ]


def test_c2_a_namesake_that_is_not_in_the_dish():
    assert found("C2", served("leek salad"), FOON) == [
        "C2 step 2 leek salad ({salt, tomato}; on plate): it is called after leek, which is not in it"
    ]


def test_c2_a_food_that_is_the_name_of_a_dish_too_must_be_in_it():
    (told,) = found("C2", served("chicken salad"), FOON)
    assert told.startswith("C2 step 2 chicken salad ({salt, tomato}; on plate): it is called after ")
    assert "chicken" in told.partition("after ")[2]


def test_c2_names_are_not_asked_without_a_foon():
    assert found("C2", served("surprise")) == []


def test_c2_the_name_of_a_reference_tree_is_not_asked():
    assert found("C2", f"level: 3\n{served('surprise', head=ONE_TOMATO)}", FOON) == []


# --- C3 ---


LIT = """
pot (empty) + stove (off) → PICK-AND-PLACE → pot (empty; on stove) + stove (off; under pot)
milk (liquid; in carton) + pot (empty; on stove) → POUR → milk (liquid; in pot) + pot ({milk}; on stove)
stove (off; under pot) → TURN ON → stove (on; under pot)
milk (liquid; in pot) + pot ({milk}; on stove) + stove (on; under pot) → HEAT
  → milk (hot; in pot) + pot (hot; {milk}; on stove)
"""


OUT = "stove (on; under pot) → TURN OFF → stove (off; under pot)\n"


def test_c3_all_is_off_at_the_end():
    assert found("C3", LIT + OUT) == []
    assert found("C3", LIT) == ["C3: the stove is still on at the end"]


def test_c3_of_two_appliances_each_is_told():
    text = LIT + "grill (off) → TURN ON → grill (on)"
    assert "C3: the grill is still on at the end" in found("C3", text)
    assert "C3: the stove is still on at the end" in found("C3", text)


def test_c3_what_stays_on_in_a_reference_tree_is_no_fault():
    assert found("C3", f"level: 3\n{LIT}") == []


def test_c3_a_fridge_is_always_on():
    text = "milk (liquid; in fridge) + cup (empty) + fridge (on) → POUR → milk (liquid; in cup) + fridge (on)"
    assert found("C3", text) == []


def test_c3_a_step_that_leaves_everything_as_it_was():
    text = f"{ONE_TOMATO}\ntomato (sliced; on plate) + plate ({{tomato}}) → WAIT → tomato (sliced; on plate)"
    assert found("C3", text) == ["C3 step 2: all its outputs are among its inputs: it changes nothing"]


def test_c3_a_step_that_is_there_twice_names_the_first():
    text = f"{ONE_TOMATO}\n{ONE_TOMATO}"
    assert "C3 step 2: it is the same as step 1" in found("C3", text)
    assert "C3 step 3: it is the same as step 1" in found("C3", f"{text}\n{ONE_TOMATO}")


def test_c3_the_same_step_with_another_thing_is_another_step():
    text = """
tomato#1 (whole) + plate#3 + knife → SLICE → tomato#1 (sliced; on plate#3)
tomato#2 (whole) + plate#3 + knife → SLICE → tomato#2 (sliced; on plate#3)
"""
    assert found("C3", text) == []


def test_c3_a_step_that_leads_nowhere():
    text = "onion (whole) + cutting board (empty) + knife → SLICE → onion (sliced; on cutting board)\n"
    assert found("C3", text + ONE_TOMATO) == ["C3 step 1: nothing that it makes leads to the goal"]
    assert found("C3", ONE_TOMATO + "\n" + POURED) == []


def test_c3_a_step_after_the_goal_leads_nowhere_unless_it_ends_something():
    goal = f"goal: tomato (sliced; on plate)\n{ONE_TOMATO}\n"
    assert found("C3", goal + "bowl (empty) → PUT → bowl (empty; on table)") == [
        "C3 step 2: nothing that it makes leads to the goal"
    ]


@pytest.mark.parametrize(
    "step",
    [
        "stove (on) → TURN OFF → stove (off)",
        "jar (open) → CLOSE → jar (closed)",
        "pot (covered) → UNCOVER → pot (uncovered)",
        "jar (closed) → OPEN → jar (open)",
        "blender jar (attached) → DETACH → blender jar (no attachments)",
        "paper (used) → THROW AWAY → paper (in bin)",
        "knife (dirty) → WASH → knife (clean)",
    ],
)
def test_c3_what_ends_something_needs_to_lead_nowhere(step):
    assert found("C3", f"goal: tomato (sliced; on plate)\n{ONE_TOMATO}\n{step}") == []


def test_c3_turning_on_leads_to_the_goal_only_before_it():
    on, off = "oven (off) → TURN ON → oven (on)\n", "\noven (on) → TURN OFF → oven (off)"
    goal = "goal: tomato (sliced; on plate)\n"
    assert found("C3", goal + on + ONE_TOMATO + off) == []
    assert found("C3", goal + ONE_TOMATO + "\n" + on + off) == ["C3 step 2: nothing that it makes leads to the goal"]


def test_c3_a_step_leads_to_the_goal_through_others():
    text = (
        f"{ONE_TOMATO}\n{POURED}\ntomato (sliced; in bowl) + bowl ({{tomato}}) + cup → POUR → tomato (sliced; in cup)"
    )
    assert found("C3", text) == []


def test_c3_without_food_the_last_step_is_the_goal():
    first = "plate (empty) → PUT → plate (empty; on table)\n"
    assert found("C3", first + "plate (empty; on table) → PUT → plate (empty; on shelf)") == []
    assert found("C3", first + "bowl (empty) → PUT → bowl (empty; on shelf)") == [
        "C3 step 1: nothing that it makes leads to the goal"
    ]


def test_c3_a_food_that_ends_in_the_dish_led_there_though_its_node_is_taken_by_nobody():
    text = f"{ONE_TOMATO}\nplate ({{tomato}}) + bowl (empty) → POUR → tomato (sliced; in bowl) + bowl ({{tomato}})"
    assert found("C3", text) == []


# --- C1 to C6 ---


def test_every_finding_of_form_is_fatal():
    text = asked("onion", f"kitchen: nothing\n{taken('tomato (sliced)')}")
    told = report(text).of(["C1", "C2", "C3", "C4", "C5", "C6"])
    assert {finding.rule for finding in told} >= {"C1", "C4", "C5", "C6"}
    assert not any(finding.minor for finding in told)


def test_a_goal_that_no_step_puts_out_is_named_in_the_finding():
    tree = TaskTree("empty", (), goal=ObjectNode("soup"))
    assert [str(one) for one in check(tree).of(["C2"])] == ["C2: the tree has no step with food"]


FRIED = """dish: omelette
asked: egg (whole)
{told}
egg (whole; in carton) + bowl (empty) → CRACK → egg (cracked; in bowl) + bowl ({{egg}})
pan (empty) + stove (off) → PUT → pan (empty; on stove) + stove (off; under pan)
{fat} (liquid; in bottle) + pan (empty; on stove) → POUR → {fat} (liquid; in pan) + pan ({{{fat}}}; on stove)
stove (off; under pan) → TURN ON → stove (on; under pan)
egg (cracked; in bowl) + bowl ({{egg}}) + pan ({{{fat}}}; on stove) → POUR
  → egg (cracked; in pan) + pan ({{egg, {fat}}}; on stove) + bowl (empty)
egg (cracked; in pan) + {fat} (liquid; in pan) + pan ({{egg, {fat}}}; on stove) + stove (on; under pan) → FRY
  → omelette (fried; {{egg, {fat}}}; in pan) + pan (hot; {{omelette}}; on stove)
stove (on; under pan) → TURN OFF → stove (off; under pan)
"""


@pytest.mark.parametrize(
    ("fat", "told", "refused"),
    [
        ("oil", "assumed: oil (liquid; in bottle): nobody asked for fat", False),
        ("oil", "", True),
        ("vinegar", "assumed: vinegar (liquid; in bottle): nobody asked for it", True),
    ],
)
def test_c5_the_fat_of_the_household_is_free_to_fry_in_where_it_is_told(fat, told, refused):
    assert bool(found("C5", FRIED.format(fat=fat, told=told))) is refused


def test_c5_the_fat_of_the_household_is_not_free_on_a_salad():
    text = """dish: salad
asked: tomato (sliced)
assumed: oil (liquid; in bottle): nobody asked for fat
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
oil (liquid; in bottle) + tomato (sliced; on plate) + plate ({tomato}) → POUR
  → salad ({oil, tomato}; on plate) + plate ({salad})
"""
    assert found("C5", text)
