"""C4 to C6 (docs/contract.md): each clause kept and broken by a small tree."""

from __future__ import annotations

import pytest
from validation.judging import ONE_TOMATO, found
from validation.tomato_salad import FOON, SALTED, asked, taken

# --- C4 ---


@pytest.mark.parametrize("foods", ["tomato (sliced)", "tomatoes (sliced)", "tomato", "tomato (whole)"])
def test_c4_a_required_food_was_in_its_state_on_its_way(foods):
    assert found("C4", asked(foods)) == []


def test_c4_a_required_state_that_never_was():
    assert found("C4", asked("tomato (diced)")) == [
        "C4: no node of the tree is tomato in the state “diced”, as required"
    ]


@pytest.mark.parametrize(
    ("states", "never"), [("whole, sliced", ""), ("boiled, sliced", "boiled"), ("sliced, diced", "diced")]
)
def test_c4_each_of_several_required_states_was_there(states, never):
    said = [f"C4: no node of the tree is tomato in the state “{never}”, as required"] if never else []
    assert found("C4", asked(f"tomato ({states})")) == said


def test_c4_a_forgotten_food_is_told_as_no_node_and_as_not_in_the_goal():
    assert found("C4", asked("tomato (sliced); onion")) == [
        "C4: no node of the tree is onion, as required",
        "C4 tomato (sliced; on plate): onion is required and is not in the goal",
    ]


def test_c4_without_a_goal_no_node_is_told():
    assert "C4: onion is required and is not in the goal" in found("C4", asked("onion", "bowl → PUT → bowl (on table)"))


def test_c4_a_food_that_stays_beside_is_not_in_the_goal():
    onion = "onion (whole) + cutting board (empty) + knife → SLICE → onion (sliced; on cutting board)\n"
    assert found("C4", asked("tomato (sliced); onion (sliced)", onion + ONE_TOMATO)) == [
        "C4 tomato (sliced; on plate): onion is required and is not in the goal"
    ]


def test_c4_a_name_in_braces_does_not_bring_a_food_there():
    text = asked("tomato (sliced); onion (sliced)", ONE_TOMATO.replace("plate ({tomato})", "plate ({onion, tomato})"))
    assert "C4: no node of the tree is onion in the state “sliced”, as required" in found("C4", text)


@pytest.mark.parametrize(
    "entry",
    [
        "state (tomato): diced like sliced (1.0); nothing",
        "state (tomatoes): diced like sliced (0.5); nothing",
        "state (tomato): cubed like diced (0.5); nothing",
    ],
)
def test_c4_a_state_that_is_read_as_another_is_declared(entry):
    assert found("C4", f"substitution: {entry}\n{asked('tomato (diced)')}") == []


@pytest.mark.parametrize(
    "entry",
    [
        "object (tomato): diced like sliced (1.0); nothing",
        "state (onion): diced like sliced (1.0); nothing",
        "state (tomato): cubed like sliced (1.0); nothing",
    ],
)
def test_c4_another_declaration_does_not_help(entry):
    assert len(found("C4", f"substitution: {entry}\n{asked('tomato (diced)')}")) == 1


def test_c4_a_food_that_is_asked_twice_is_told_once():
    assert len(found("C4", asked("tomato (diced); tomato (diced)"))) == 1
    assert len(found("C4", asked("tomato (diced); tomato (minced)"))) == 2


def test_c4_foods_are_told_in_the_order_of_their_names():
    told = found("C4", asked("tomato (minced); tomato (diced); onion"))
    assert [line.partition(" is ")[2].split(",")[0] for line in told if "no node" in line] == [
        "onion", "tomato in the state “diced”", "tomato in the state “minced”",
    ]  # fmt: skip


# --- C5 ---


def test_c5_every_food_from_the_kitchen_was_asked_for():
    assert found("C5", asked("tomato (sliced)")) == []
    assert found("C5", asked("onion")) == ["C5 step 1: tomato comes from the kitchen and nobody asked for it"]


def test_c5_a_food_that_comes_twice_is_told_once_at_its_first_step():
    text = asked("tomato (sliced)", f"{ONE_TOMATO}\n{SALTED}{SALTED}")
    assert found("C5", text) == ["C5 step 2: salt comes from the kitchen and nobody asked for it"]


@pytest.mark.parametrize("name", ["broth", "chicken broth", "clear chicken broth"])
def test_c5_a_food_with_a_word_more_or_less_is_the_one_asked(name):
    text = asked("chicken broth", f"{name} (liquid; in carton) + pot (empty) → POUR → {name} (liquid; in pot)")
    assert found("C5", text) == []


@pytest.mark.parametrize("name", ["beef broth", "chicken", "broth powder"])
def test_c5_a_food_with_another_word_or_another_last_word_is_not_the_one_asked(name):
    text = asked("chicken broth", f"{name} (liquid; in carton) + pot (empty) → POUR → {name} (liquid; in pot)")
    assert found("C5", text) == [f"C5 step 1: {name} comes from the kitchen and nobody asked for it"]


def test_c5_water_is_free_unless_a_setting_says_otherwise():
    text = asked(
        "tomato (sliced)",
        ONE_TOMATO + "\nwater (liquid; in bottle) + plate ({tomato}) → POUR → water (liquid; on plate)",
    )
    assert found("C5", text) == []
    assert found("C5", text, free=frozenset()) == ["C5 step 2: water comes from the kitchen and nobody asked for it"]


def test_c5_a_dish_from_the_kitchen_is_left_to_c6():
    step = "cheesecake (whole) + plate ({tomato}) → PUT → cheesecake (whole; on plate)"
    assert found("C5", asked("tomato (sliced)", f"{ONE_TOMATO}\n{step}")) == []


def test_c5_what_only_a_vessel_tells_of_is_told_at_the_step_that_takes_it():
    step = "bowl ({cream}) + plate ({tomato}) → POUR → cream (on plate)"
    assert found("C5", asked("tomato (sliced)", f"{ONE_TOMATO}\n{step}")) == [
        "C5 step 2: cream comes from the kitchen and nobody asked for it"
    ]


FRIED = """
frying pan (empty) + stove (off) → PLACE → frying pan (empty; on stove)
stove (off; under frying pan) → TURN-ON → stove (on; under frying pan)
{fat} (liquid; in bottle) + frying pan (empty; on stove) → POUR
  → {fat} (liquid; in frying pan) + frying pan ({{{fat}}}; on stove)
tomato (sliced; on plate) + frying pan ({{{fat}}}; on stove) + {fat} (liquid; in frying pan) → PLACE
  → tomato (sliced; in frying pan) + frying pan ({{{fat}, tomato}}; on stove)
frying pan ({{{fat}, tomato}}; on stove) + tomato (sliced; in frying pan) + {fat} (liquid; in frying pan)
  + stove (on; under frying pan) → FRY
  → tomato (fried, sliced; in frying pan) + frying pan ({{{fat}, tomato}}; on stove)
"""
DRESSED = "{fat} (liquid; in bottle) + plate (empty) → POUR → {fat} (liquid; on plate)\n"
TOLD = "assumed: {fat} (liquid; in bottle): nobody asked for fat\n"


@pytest.mark.parametrize("fat", ["oil", "olive oil", "lard"])
def test_c5_fat_of_the_household_that_is_told_and_fried_in_is_let_in(fat):
    fried = ONE_TOMATO + FRIED.format(fat=fat)
    told = TOLD.format(fat=fat)
    nobody = f"{fat} comes from the kitchen and nobody asked for it"
    assert found("C5", told + asked("tomato (sliced)", fried)) == []
    assert found("C5", asked("tomato (sliced)", fried)) == [f"C5 step 4: {nobody}"]
    assert found("C5", told + asked("tomato (sliced)", f"{ONE_TOMATO}\n{DRESSED.format(fat=fat)}")) == [
        f"C5 step 2: {nobody}"
    ]


def test_c5_fat_is_let_in_no_more_often_than_it_is_told():
    numbered = DRESSED.format(fat="oil").replace("oil (liquid", "oil#9 (liquid")  # or it may be that of the pan
    twice = asked("tomato (sliced)", ONE_TOMATO + FRIED.format(fat="oil") + numbered)
    told = TOLD.format(fat="oil")
    for times in (1, 2):  # what is poured over at last was never heated, however often it is told
        assert found("C5", told * times + twice) == ["C5 step 7: oil comes from the kitchen and nobody asked for it"]


def test_c5_other_food_is_not_let_in_by_being_told_and_fried():
    text = ONE_TOMATO + FRIED.format(fat="soy sauce")
    assert found("C5", TOLD.format(fat="soy sauce") + asked("tomato (sliced)", text)) == [
        "C5 step 4: soy sauce comes from the kitchen and nobody asked for it"
    ]


def test_c5_a_setting_lets_other_foods_in():
    text = asked("tomato (sliced)", ONE_TOMATO + SALTED)
    assert found("C5", text) == ["C5 step 2: salt comes from the kitchen and nobody asked for it"]
    assert found("C5", text, free=frozenset({"salt"})) == []


# --- C6 ---


@pytest.mark.parametrize(
    "leaf",
    [
        "tomato (whole)", "tomato", "beef (raw)", "peas (frozen; in bag)", "salt (granulated; in shaker)",
        "milk (liquid; in carton)", "milk (liquid; in fridge)", "water (liquid; from faucet)",
        "apple (whole; on table)", "walnut (halved)", "oats (rolled)", "sugar (cubed)", "bowl (empty)", "knife",
        "knife (clean)", "stove (off)",
        "jar (closed; {jam})", "shaker ({salt})", "fridge (on)", "pot (empty; on stove)", "tomato (ripe)",
        "oven (off)", 'stove ("off (ready)")', "dough (frozen; in bag)", 'tomato ("in [bag]")', "flour ({flour})",
        "pepper (ground; in shaker)", "lemon (peel)", 'tomato ("on [sliced bread]")', 'bowl ("on [table]")',
    ],
)  # fmt: skip
def test_c6_things_are_as_a_kitchen_has_them(leaf):
    assert found("C6", taken(leaf)) == []


@pytest.mark.parametrize(
    ("leaf", "reason"),
    [
        ("tomato (sliced)", "it is sliced before anybody made it so"),
        ("tomato (Sliced)", "it is Sliced before anybody made it so"),
        ("beef (cooked)", "it is cooked before anybody made it so"),
        ("avocado (slit)", "it is slit before anybody made it so"),
        ("bread (partly toasted)", "it is partly toasted before anybody made it so"),
        ("almond (halved)", "it is halved before anybody made it so"),
        ("tomato (fresh, sliced)", "it is sliced before anybody made it so"),
        ("puff pastry ({butter, flour})", "it is made of other foods, and nobody made it"),
        ("tomato (whole; in bowl)", "it is in the bowl before anybody put it there"),
        ("tomato (whole; in oven)", "it is in the oven before anybody put it there"),
        ("cake (whole; {flour, sugar})", "it is made of other foods, and nobody made it"),
        ("dough ({flour, water})", "it is made of other foods, and nobody made it"),
        ("stove (on)", "it is on or hot before anybody turned anything on"),
        ("pan (hot)", "it is on or hot before anybody turned anything on"),
        ("oven (preheated)", "it is on or hot before anybody turned anything on"),
        ("bowl ({tomato})", "it is filled, and nobody filled it"),
        ("bowl (dirty)", "it is dirty before anybody used it"),
        ("pan (greased)", "it is greased before anybody used it"),
        ("pan (clean, greased)", "it is greased before anybody used it"),
    ],
)
def test_c6_things_as_no_kitchen_has_them(leaf, reason):
    (told,) = found("C6", taken(leaf))
    assert told.startswith("C6 step 1 ")
    assert told.endswith(f": {reason}")


def test_c6_each_leaf_is_told_at_the_step_that_takes_it_first():
    text = f"{ONE_TOMATO}\nonion (diced) + plate ({{tomato}}) → PUT → onion (diced; on plate)"
    text += "\nonion (diced) + cup → PUT → onion (diced; in cup)"
    assert found("C6", text) == ["C6 step 2 onion (diced): it is diced before anybody made it so"]


def test_c6_what_an_earlier_step_brought_so_is_no_leaf_of_the_kitchen():
    text = f"{ONE_TOMATO}\ntomato (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({{tomato}})"
    assert found("C6", text) == []
    filled = "\nplate ({tomato}; on table) + bowl (empty) → POUR → tomato (sliced; in bowl) + bowl ({tomato})"
    assert found("C6", ONE_TOMATO + filled) == []


def test_c6_what_an_earlier_step_brought_stays_so_beside_food_from_the_kitchen():
    step = "tomato (sliced) + onion (whole) + bowl (empty) → PUT → tomato (sliced; in bowl) + onion (whole; in bowl)"
    assert found("C6", f"{ONE_TOMATO}\n{step}") == []


def test_c6_another_vessel_that_nobody_filled_is_told():
    text = f"{ONE_TOMATO}\nbowl ({{cream}}) + plate ({{tomato}}) → POUR → cream (liquid; on plate)"
    assert found("C6", text) == ["C6 step 2 bowl ({cream}): it is filled, and nobody filled it"]


ASSUMED = "assumed: tomato (sliced): no step slices\n"


def test_c6_a_processed_food_may_be_assumed_with_a_reason():
    assert found("C6", taken("tomato (sliced)", ASSUMED)) == []
    assert found("C6", taken("tomato (diced)", ASSUMED)) == [
        "C6 step 1 tomato (diced): it is diced before anybody made it so",
        "C6 tomato (sliced): it is assumed to be at hand and is no leaf of the tree",
    ]


@pytest.mark.parametrize("why", ['""', '"  "'])
def test_c6_an_assumption_says_why(why):
    assert found("C6", taken("tomato (sliced)", f"assumed: tomato (sliced): {why}\n")) == [
        "C6 tomato (sliced): it is assumed to be at hand and nothing says why"
    ]


def test_c6_an_assumption_of_what_the_foon_can_make():
    reason = "it is assumed to be sliced, and FOON has an operator for such a food"
    assert found("C6", taken("tomato (sliced)", ASSUMED), FOON) == [f"C6 tomato (sliced): {reason}"]


def test_c6_an_assumption_of_what_the_foon_makes_of_a_like_kind():
    head = "assumed: tomatillo (sliced): no step slices a tomatillo\n"
    reason = "it is assumed to be sliced, and FOON has an operator for such a food"
    assert found("C6", taken("tomatillo (sliced)", head), FOON) == [f"C6 tomatillo (sliced): {reason}"]


@pytest.mark.parametrize("states", ["peeled", "fresh, peeled"])
def test_c6_whatever_was_done_to_a_food_has_an_operator_or_not(states):
    foon = "name: v\ntomato (whole) + knife → PEEL → tomato (peeled)"
    head = f"assumed: tomato ({states}): so\n"
    assert found("C6", taken(f"tomato ({states})", head), foon) == [
        f"C6 tomato ({states}): it is assumed to be peeled, and FOON has an operator for such a food"
    ]


@pytest.mark.parametrize(("food", "state"), [("tomato", "wet"), ("lemon", "juice"), ("beef", "frozen")])
def test_c6_a_state_that_nobody_needs_to_make_may_be_assumed(food, state):
    foon = f"name: v\n{food} (whole) + knife → WORK → {food} ({state})"
    assert found("C6", taken(f"{food} ({state})", f"assumed: {food} ({state}): so\n"), foon) == []


@pytest.mark.parametrize("food", ["tomato (diced)", "beef (sliced)", "wibble (sliced)", "tomato (whole)"])
def test_c6_an_assumption_of_what_the_foon_cannot_make(food):
    assert found("C6", taken(food, f"assumed: {food}: no step does so\n"), FOON) == []


def test_c6_of_an_unknown_food_only_its_own_operators_count():
    foon = "name: v\nwobble (whole) + knife → SLICE → wobble (sliced)"
    assert found("C6", taken("wibble (sliced)", "assumed: wibble (sliced): so\n"), foon) == []
    assert len(found("C6", taken("wobble (sliced)", "assumed: wobble (sliced): so\n"), foon)) == 1


def test_c6_only_what_is_in_the_kitchen_that_was_named_is_there():
    def lacks(node):
        return node.label == "knife"

    assert found("C6", ONE_TOMATO, lacks=lacks) == ["C6 step 1 knife: it is not in the kitchen that was named"]
    assert found("C6", ONE_TOMATO, lacks=lambda node: False) == []
    assert len(found("C6", ONE_TOMATO, lacks=lambda node: True)) == 3


def test_c6_an_assumption_does_not_put_a_thing_into_the_kitchen_that_was_named():
    text = taken("tomato (sliced)", ASSUMED)
    assert found("C6", text, lacks=lambda node: True) == [
        "C6 step 1 tomato (sliced): it is not in the kitchen that was named"
    ]
