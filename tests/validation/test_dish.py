"""K5 to K7 (docs/contract.md): each clause kept and broken by a small tree."""

from __future__ import annotations

import pytest
from validation.judging import ONE_TOMATO, foon_of, found, report

from foon_kg.model import ObjectNode
from foon_kg.model.tree import TaskTree
from foon_kg.validation import check


def lines(*steps):
    return "\n".join(step.strip() for step in steps if step)


def recipe(dish, asked, title=""):
    return f"dish: {dish}\nasked: {asked}\n" + (f"title: {title}\n" if title else "")


def served(label, *foods, states=""):
    """One step that makes a dish of some foods on a plate."""
    inputs = " + ".join(f"{food} (liquid; in bottle)" if food in {"milk", "water"} else food for food in foods)
    holds = "{" + ", ".join(sorted(foods)) + "}"
    said = f"{states}; " if states else ""
    return f"{inputs} + plate (empty) + spoon → MIX → {label} ({said}{holds}; on plate) + plate ({{{label}}})"


def heated(label, *foods, motion="BOIL", states="cooked"):
    """Steps that make a dish of some foods in a pot over heat."""
    holds = "{" + ", ".join(sorted(foods)) + "}"
    inputs = " + ".join(f"{food} (whole)" for food in foods)
    outputs = " + ".join(f"{food} (whole; in pot)" for food in foods)
    return f"""
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
{inputs} + pot (empty; on stove) → PUT → {outputs} + pot ({holds}; on stove)
stove (off; under pot) → TURN ON → stove (on; under pot)
{outputs} + pot ({holds}; on stove) + stove (on; under pot) → {motion}
  → {label} ({states}; {holds}; in pot) + pot (hot; {{{label}}}; on stove)
"""


# --- K5 dish: what makes it ---


@pytest.mark.parametrize(
    ("label", "foods", "lack"),
    [
        ("omelette", ("tofu", "butter"), "egg"),
        ("mushroom soup", ("leek", "water"), "mushroom"),
        ("fried rice", ("leek", "oil"), "rice"),
        ("bread", ("leek", "water"), "flour"),
        ("cake", ("leek", "sugar"), "flour"),
        ("garlic bread", ("leek", "butter"), "garlic"),
    ],
)
def test_k5_what_makes_the_named_dish_is_not_in_it(label, foods, lack):
    told = found("K5", heated(label, *foods))
    assert told
    assert all(line.startswith(f"K5 {label} (") for line in told)
    assert any(lack in line.partition("” without ")[2] for line in told)


@pytest.mark.parametrize(
    ("label", "foods"),
    [
        ("omelette", ("egg", "butter")),
        ("mushroom soup", ("mushroom", "water")),
        ("fried rice", ("rice", "oil")),
        ("bread", ("flour", "water")),
        ("cake", ("flour", "sugar")),
        ("garlic bread", ("garlic", "bread")),
    ],
)
def test_k5_what_makes_the_named_dish_is_in_it(label, foods):
    assert found("K5", heated(label, *foods)) == []


def test_k5_what_is_missing_is_told_with_what_would_do():
    (told,) = found("K5", heated("garlic bread", "bread", "butter"))
    assert told.startswith("K5 garlic bread (cooked; {bread, butter}; in pot): “garlic bread” without ")
    assert told.endswith(" without garlic or garlic powder or garlic salt")


def test_k5_a_dish_that_only_the_title_or_the_dish_type_names_counts():
    tree = heated("stew", "leek", "water")
    assert found("K5", tree) == []
    titled = found("K5", recipe("soup", "leek; water", "Mushroom Soup") + tree)
    assert any("without mushroom" in line for line in titled)
    typed = found("K5", recipe("omelette", "leek; water") + tree)
    assert any("“stew” without egg" in line for line in typed)


def test_k5_a_longer_name_takes_the_place_of_those_within_it():
    assert found("K5", served("salad dressing", "oil", "vinegar")) == []
    assert found("K5", heated("crab cake", "crab", "egg")) == []


@pytest.mark.parametrize(
    ("label", "foods", "lacks"),
    [
        ("leek salad", ("tomato", "salt"), ["leek"]),
        ("leek salad", ("leek", "salt"), []),
        ("leek salad", ("baby leek", "salt"), []),
        ("baby leek salad", ("leek", "salt"), []),
        ("leek and radish salad", ("tomato", "salt"), ["leek", "radish"]),
        ("savoy cabbage salad", ("cabbage", "salt"), []),
        ("big salad", ("tomato", "salt"), []),
        ("salad", ("tomato", "salt"), []),
        ("radishes salad", ("radish", "salt"), []),
    ],
)
def test_k5_a_food_after_which_the_dish_is_called_is_in_it(label, foods, lacks):
    told = found("K5", served(label, *foods))
    assert [line.rpartition(" without ")[2] for line in told] == lacks


def test_k5_a_dish_that_is_a_food_that_a_shop_sells_is_not_called_after_itself():
    assert found("K5", served("half and half", "tomato")) == []
    assert found("K5", served("half and half salad", "tomato")) != []


@pytest.mark.parametrize("label", ["onion salad", "green onion salad"])
def test_k5_a_food_whose_words_other_dishes_have_too_is_in_it(label):
    assert found("K5", served(label, "tomato", "salt")) != []


def test_k5_a_kind_in_the_name_is_there_where_one_of_it_is():
    assert found("K5", served("herb salad", "parsley", "salt")) == []
    assert found("K5", served("herb salad", "tomato", "salt")) != []


# --- K5 dish: finished ---


@pytest.mark.parametrize("label", ["dough", "pizza dough", "pancake batter", "batter", "meat mixture", "egg wash"])
def test_k5_a_dough_or_batter_is_no_finished_dish(label):
    told = found("K5", served(label, "flour", "egg", "beef"))
    assert any(line.endswith(f": “{label}” is no finished dish") for line in told)
    assert all(line.startswith(f"K5 {label} (") for line in told)


def test_k5_a_dish_with_dough_inside_its_name_is_finished():
    assert not [line for line in found("K5", served("dough balls", "flour", "egg")) if "no finished dish" in line]


@pytest.mark.parametrize("state", ["uncooked", "raw", "uncook", "partly cooked", "half cooked", "undercooked"])
def test_k5_a_dish_that_is_uncooked_or_half_cooked(state):
    (told,) = found("K5", served("salad", "tomato", "salt", states=state))
    assert told == f"K5 salad ({state}; {{salt, tomato}}; on plate): the dish is {state}"


@pytest.mark.parametrize("state", ["cooked", "mixed", "cold", "ready"])
def test_k5_a_dish_in_any_other_state_is_finished(state):
    assert found("K5", served("salad", "tomato", "salt", states=state)) == []


def test_k5_nothing_was_heated_in_a_dish_that_is_eaten_hot():
    cold = served("soup", "leek", "water")
    (told,) = found("K5", cold)
    assert told == "K5 soup ({leek, water}; on plate): “soup”, and nothing in it was heated"
    assert found("K5", heated("soup", "leek", "water")) == []


SAUCE = ("onion", "tomato", "oil")


def test_k5_a_sauce_of_raw_roots_and_tomatoes_was_never_heated():
    asked = recipe("sauce", "; ".join(SAUCE), "Sauce of the House")
    (told,) = found("K5", asked + served("sauce", *SAUCE))
    assert told.endswith("a sauce with raw onion, and nothing in it was heated")
    assert found("K5", asked + heated("sauce", *SAUCE)) == []


def test_k5_a_sauce_that_is_eaten_raw_by_its_name_or_foods_is_not_to_be_heated():
    assert found("K5", recipe("sauce", "; ".join(SAUCE), "Fresh Salsa") + served("sauce", *SAUCE)) == []
    with_nuts = (*SAUCE, "almond")
    assert found("K5", recipe("sauce", "; ".join(with_nuts), "House Sauce") + served("sauce", *with_nuts)) == []


def test_k5_of_type_and_title_too():
    cold = served("lunch", "leek", "water")
    assert found("K5", cold) == []
    assert found("K5", recipe("soup", "leek; water") + cold)[-1].endswith(": “soup”, and nothing in it was heated")
    titled = found("K5", recipe("salad", "leek; water", "Leek Soup") + cold)
    assert titled[-1].endswith(": “soup”, and nothing in it was heated")


def test_k5_a_cold_dish_need_not_be_heated():
    assert found("K5", served("salad", "leek", "water")) == []
    assert found("K5", served("smoothie", "banana", "milk")) == []


def in_oven(label, *foods, motion="BAKE", appliance="oven"):
    """Steps that make a dish of some foods on a tray in an appliance."""
    holds = "{" + ", ".join(sorted(foods)) + "}"
    return f"""
{" + ".join(foods)} + tray (empty) + spoon → MIX → stuff ({holds}; on tray) + tray ({{stuff}})
tray ({{stuff}}) + {appliance} (off) → PUT → tray ({{stuff}}; in {appliance}) + {appliance} (off)
{appliance} (off) → TURN ON → {appliance} (on)
stuff ({holds}; on tray) + tray ({{stuff}}; in {appliance}) + {appliance} (on) → {motion} → {label} ({holds}; on tray)
"""


NEVER_BAKED = "“bread”, and it was never baked"


@pytest.mark.parametrize(
    "tree",
    [
        in_oven("bread", "flour", "yeast"),
        in_oven("bread", "flour", "yeast", motion="COOK"),
        in_oven("bread", "flour", "yeast", motion="COOK", appliance="microwave"),
        in_oven("bread", "flour", "yeast", appliance="grill"),
    ],
)
def test_k5_what_is_baked_stood_in_an_oven_or_in_dry_heat(tree):
    assert found("K5", recipe("bread", "flour; yeast") + tree) == []


@pytest.mark.parametrize(
    "tree",
    [
        in_oven("bread", "flour", "yeast", motion="COOK", appliance="grill"),
        heated("bread", "flour", "yeast"),
        heated("bread", "flour", "yeast", motion="FRY"),
    ],
)
def test_k5_what_is_baked_was_not_boiled_or_fried(tree):
    (told,) = found("K5", recipe("bread", "flour; yeast") + tree)
    assert told.endswith(f": {NEVER_BAKED}")


def rolled_and_fried(*foods):
    """Steps that roll out a dough of some foods and fry it."""
    holds = "{" + ", ".join(sorted(foods)) + "}"
    return f"""
{" + ".join(foods)} + board (empty) + spoon → MIX → dough ({holds}; on board) + board ({{dough}})
dough ({holds}; on board) + board ({{dough}}) + rolling pin → ROLL → dough (flattened; {holds}; on board)
pan (empty) + stove (off) → PUT → pan (empty; on stove) + stove (off; under pan)
dough (flattened; {holds}; on board) + pan (empty; on stove) → PUT → dough (flattened; {holds}; in pan)
stove (off; under pan) → TURN ON → stove (on; under pan)
dough (flattened; {holds}; in pan) + stove (on; under pan) → FRY → bread (fried; {holds}; in pan)
"""


def test_k5_bread_that_nothing_raises_is_rolled_and_fried():
    assert found("K5", recipe("bread", "flour; salt") + rolled_and_fried("flour", "salt")) == []
    (told,) = found("K5", recipe("bread", "flour; yeast") + rolled_and_fried("flour", "yeast"))
    assert told.endswith(f": {NEVER_BAKED}")
    (told,) = found("K5", recipe("bread", "flour; salt") + heated("bread", "flour", "salt"))
    assert told.endswith(f": {NEVER_BAKED}")


def test_k5_a_cake_of_ready_biscuits_sets_cold_and_one_with_flour_does_not():
    assert found("K5", recipe("cake", "ladyfinger; mascarpone") + served("cake", "ladyfinger", "mascarpone")) == []
    told = found("K5", recipe("cake", "ladyfinger; flour") + served("cake", "ladyfinger", "flour"))
    assert told[-1].endswith(": “cake”, and it was never baked")


def test_k5_a_title_may_say_that_a_dish_is_baked_and_a_goal_alone_does_not():
    tree = heated("bread", "flour", "yeast")
    assert found("K5", tree) == []
    (told,) = found("K5", recipe("soup", "flour; yeast", "Bread").replace("soup", "salad") + tree)
    assert told.endswith(f": {NEVER_BAKED}")


def test_k5_warming_is_heating():
    assert found("K5", heated("soup", "leek", "water", motion="HEAT")) == []


def test_k5_the_dish_type_of_a_tree_without_a_recipe_is_that_of_its_goal_in_the_foon():
    foon = foon_of(f"name: v\ndish: soup\ngoal: lunch\n{ONE_TOMATO}")
    cold = served("lunch", "leek", "water")
    assert found("K5", cold, foon)[-1].endswith(": “soup”, and nothing in it was heated")
    assert found("K5", served("supper", "leek", "water"), foon) == []


def test_k5_a_goal_that_nothing_becomes():
    tree = TaskTree("nothing", (), goal=ObjectNode("soup"))
    assert [str(one) for one in check(tree).of(["K5", "K6"])] == ["K5 soup: nothing becomes the dish"]
    assert found("K5", f"goal: soup\n{ONE_TOMATO}") == ["K5 soup: nothing becomes the dish"]


def test_k5_a_tree_without_food_has_no_dish_to_ask_of():
    assert found("K5", "stove (on) → TURN OFF → stove (off)") == []


def test_k5_findings_are_fatal():
    judged = report(served("soup", "leek", "water"))
    assert (judged.fatal.count("K5"), judged.cook, judged.robot) == (1, False, True)


def turned_over(said, motion):
    """A cake that is called so, baked, and then brought or turned onto a plate."""
    told = recipe("cake", "flour; pineapple", f"Pineapple {said} Cake") + in_oven("cake", "flour", "pineapple")
    inputs, outputs = ("cake ({flour, pineapple}; " + where for where in ("on tray)", "on plate)"))
    return f"{told}{inputs} + plate (empty) → {motion} → {outputs} + plate ({{cake}})"


def test_k5_a_step_does_what_the_title_names():
    assert any("“upside down”" in line for line in found("K5", turned_over("Upside-Down", "PICK-AND-PLACE")))
    assert found("K5", turned_over("Upside-Down", "FLIP AND PLACE")) == []
    assert found("K5", turned_over("Plain", "PICK-AND-PLACE")) == []


@pytest.mark.parametrize(("called", "faults"), [("noodle", 1), ("mixture", 0)])
def test_k5_nothing_is_called_by_the_dish_before_what_makes_it_is_in_it(called, faults):
    tossed = f"""
{called} (cooked; {{leek, water}}; in pot) + pot (hot; {{{called}}}; on stove) + spaghetti (cooked) + spoon → STIR
  → noodle (cooked, mixed; {{leek, spaghetti, water}}; in pot) + pot (hot; {{noodle}}; on stove)
""".replace("\n  →", " →")
    told = found("K5", lines(heated(called, "leek", "water"), tossed))
    assert [line for line in told if "before dry pasta is in it" in line] == told
    assert len(told) == faults


def test_k5_what_lies_in_layers_is_not_all_stirred_together():
    asked = recipe("pudding", "yogurt; strawberry", "Strawberry Parfait")
    assert found("K5", lines(asked, served("pudding", "strawberry", "yogurt"))) == [
        "K5 step 1 pudding ({strawberry, yogurt}; on plate): “parfait”, and all of it is stirred together"
    ]
    assert (
        found("K5", lines(recipe("drinks", "yogurt; milk", "Parfait Shake"), served("drinks", "milk", "yogurt"))) == []
    )
    laid = served("pudding", "strawberry", "yogurt").replace("MIX", "POUR").replace(" + spoon", "")
    assert found("K5", lines(asked, laid)) == []


# --- K6 asked ---


def test_what_only_gives_its_taste_may_be_taken_out_again_but_has_to_be_in_it_first():
    """A bay leaf that was never in the pot is not in the dish."""
    out = """
soup (cooked; {bay leaf, leek, water}; in pot) + pot (hot; {soup}; on stove) + plate (empty) + tong → REMOVE
  → soup (cooked; {leek, water}; in pot) + pot (hot; {soup}; on stove) + bay leaf (cooked; on plate)
  + plate ({bay leaf})
"""
    asked = recipe("soup", "leek; bay leaf; water")
    assert found("K6", asked + heated("soup", "leek", "bay leaf", "water", motion="SIMMER") + out) == []
    assert len(found("K6", asked + heated("soup", "leek", "water", motion="SIMMER"))) == 1


def test_k2_what_only_gave_its_taste_is_taken_out_before_the_dish_is_served():
    left = "K2 (minor): bay leaf is in the dish, and nobody eats it"
    assert found("K2", heated("soup", "bay leaf", "water")) == [left]
    lifted = "soup ({bay leaf, water}; in pot) + plate (empty) → REMOVE → soup ({water}; in pot) + bay leaf (on plate)"
    assert found("K2", heated("soup", "bay leaf", "water") + lifted) == []


def test_k2_a_leaf_is_in_one_piece_and_leaves_that_were_plucked_off_a_stem_are_not():
    def left(food):
        return found("K2", heated("soup", food, "water").replace(f"{food} (whole", f"{food} (leaves"))

    assert left("bay leaf") == ["K2 (minor): bay leaf is in the dish, and nobody eats it"]
    assert left("rosemary") == []
    assert found("K2", heated("soup", "thyme leaf", "water")) == []
    assert len(found("K2", heated("soup", "thyme", "water"))) == 1


def test_k6_an_asked_food_is_in_the_dish():
    assert found("K6", recipe("salad", "tomato; salt") + served("salad", "tomato", "salt")) == []
    assert found("K6", recipe("salad", "tomato; leek") + served("salad", "tomato", "salt")) == [
        "K6 salad ({salt, tomato}; on plate): leek was asked for and is not in the dish"
    ]


@pytest.mark.parametrize("food", ["broth", "chicken broth", "clear chicken broth"])
def test_k6_in_the_same_words_or_a_word_more_or_less(food):
    assert found("K6", recipe("soup", "chicken broth") + served("soup", food, "leek")) == []


@pytest.mark.parametrize("food", ["beef broth", "chicken", "chicken broth powder"])
def test_k6_in_other_words_it_is_another_food(food):
    assert len(found("K6", recipe("soup", "chicken broth") + served("soup", food, "leek"))) == 1


def test_k6_several_foods_are_told_in_the_order_of_their_names():
    told = found("K6", recipe("salad", "radish; leek; leek (sliced)") + served("salad", "tomato", "salt"))
    assert [line.partition(": ")[2].split()[0] for line in told] == ["leek", "radish"]


def test_k6_food_that_lies_beside_on_the_same_plate_is_in_the_dish():
    beside = "leek (whole) + plate ({salad}) → PUT → leek (whole; on plate) + plate ({leek, salad})"
    text = recipe("salad", "tomato; leek") + "goal: salad ({salt, tomato}; on plate)\n"
    assert found("K6", text + lines(served("salad", "tomato", "salt"), beside)) == []


def test_k6_what_is_asked_in_two_parts_comes_apart():
    asked = recipe("cake", "egg (separated); sugar")
    whole = "egg (whole) + bowl (empty) → CRACK → egg (cracked; in bowl) + bowl ({egg})"
    told = found("K6", lines(asked, whole, served("cake", "egg", "sugar")))
    assert told == ["K6 (minor): egg is asked separated, and egg white, egg yolk are never apart"]
    apart = (
        "egg (whole) + bowl (empty) + cup (empty) → CRACK → egg yolk (separated; in bowl) + bowl ({egg yolk})"
        " + egg white (separated; in cup) + cup ({egg white})"
    )
    assert found("K6", lines(asked, apart, served("cake", "egg white", "egg yolk", "sugar"))) == []


def test_k6_without_a_dish_nothing_is_asked():
    assert found("K6", recipe("salad", "leek") + f"goal: soup\n{ONE_TOMATO}") == []


def on_top(food, state="mixed", state_of_food="sliced"):
    """A mixed salad, onto which another food comes at the end."""
    salad = served("salad", "radish", "salt", states=state)
    add = f"{food} ({state_of_food}) + salad ({state}; {{radish, salt}}; on plate) → PUT"
    return lines(salad, f"{add} → salad ({state}; {{{food}, radish, salt}}; on plate) + plate ({{salad}})")


def test_k6_an_asked_food_that_lies_unmixed_on_what_is_mixed():
    assert found("K6", recipe("salad", "cucumber; radish") + on_top("cucumber")) == [
        "K6 step 2: cucumber is not mixed with the rest"
    ]


@pytest.mark.parametrize(
    "food",
    [
        "parsley", "bacon", "guava", "lard", "cream", "egg white", "canned tomato", "spice blend", "topping",
        "sour cream", "sugar", "olive oil", "milk", "almond",
    ],
)  # fmt: skip
def test_k6_what_is_strewn_or_poured_over_a_dish_need_not_be_mixed_in(food):
    assert found("K6", recipe("salad", f"{food}; radish") + on_top(food)) == []


def test_k6_where_the_dish_is_not_mixed_nothing_need_be():
    assert found("K6", recipe("salad", "cucumber; radish") + on_top("cucumber", "ready")) == []


def test_k6_food_that_was_mixed_in_later_is_mixed():
    all_in = "{cucumber, radish, salt}; on plate)"
    mix = f"salad (mixed; {all_in} + spoon → TOSS → salad (mixed, tossed; {all_in}"
    assert found("K6", recipe("salad", "cucumber; radish") + lines(on_top("cucumber"), mix)) == []


def test_k6_a_food_of_which_some_was_mixed_in_is_mixed():
    both = on_top("cucumber").replace("radish", "cucumber", 1)
    assert found("K6", recipe("salad", "cucumber") + both) == []


# --- K7 sense ---


def test_k7_dough_of_cooked_pasta_is_fatal():
    boiled = """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
water (liquid; in bottle) + spaghetti (dry) + pot (empty; on stove) → PUT
  → water (liquid; in pot) + spaghetti (dry; in pot) + pot ({spaghetti, water}; on stove)
stove (off; under pot) → TURN ON → stove (on; under pot)
spaghetti (dry; in pot) + pot ({spaghetti, water}; on stove) + stove (on; under pot) → BOIL → spaghetti (cooked; in pot)
"""
    dough = "spaghetti (cooked; in pot) + flour + bowl (empty) → KNEAD → dough ({flour, spaghetti}; in bowl)"
    assert found("K7", lines(boiled, dough)) == ["K7 step 5: dough is made of cooked spaghetti"]
    assert found("K7", lines(boiled, dough.replace("→ dough", "→ pancake batter"))) == [
        "K7 step 5: pancake batter is made of cooked spaghetti"
    ]
    assert found("K7", lines(boiled, dough.replace("→ dough", "→ salad"))) == []
    assert found("K7", dough.replace("spaghetti (cooked; in pot)", "spaghetti (dry)")) == []


@pytest.mark.parametrize(
    ("first", "second", "told"),
    [
        ("slice", "halve", True), ("chop", "halve", True), ("chop", "slice", True), ("halve", "slice", False),
        ("slice", "chop", False), ("slice", "slice", False),
    ],
)  # fmt: skip
def test_k7_a_food_in_finer_pieces_is_not_cut_in_coarser_ones(first, second, told):
    states = {"slice": "sliced", "halve": "halved", "chop": "chopped"}
    one = f"carrot (whole) + plate (empty) + knife → {first.upper()} → carrot ({states[first]}; on plate)"
    two = f"carrot ({states[first]}; on plate) + knife → {second.upper()} → carrot ({states[second]}, again; on plate)"
    assert found("K7", lines(one, two)) == (["K7 (minor) step 2: carrot is in finer pieces already"] if told else [])


def strained(*foods, motion="STRAIN"):
    inputs = " + ".join(f"{food} (liquid; in bottle)" for food in foods)
    outputs = " + ".join(f"{food} (liquid; in bowl)" for food in foods)
    return f"{inputs} + strainer (empty) + bowl (empty) → {motion} → {outputs} + bowl ({{{', '.join(foods)}}})"


def test_k7_fat_is_poured_through_a_strainer():
    told = ["K7 (minor) step 1: fat is poured through a strainer"]
    assert found("K7", strained("oil")) == told
    assert found("K7", strained("oil", "butter")) == told
    assert found("K7", strained("oil", "broth")) == []
    assert found("K7", strained("broth")) == []
    assert found("K7", strained("oil").replace("strainer", "cup")) == []
    assert found("K7", strained("oil", motion="POUR")) == []
    assert found("K7", "strainer (empty) + bowl (empty) → STRAIN → strainer (empty; over bowl)") == []


def baked(first="", vessel="baking tray", motion="BAKE", food="egg"):
    """Steps that bake a batter of flour and a food in a vessel, after a first one."""
    return f"""
{first}
flour (whole) + {food} (whole) + bowl (empty) + spoon → MIX → batter ({{{food}, flour}}; in bowl) + bowl ({{batter}})
batter ({{{food}, flour}}; in bowl) + {vessel} → POUR → batter ({{{food}, flour}}; in {vessel}) + {vessel} ({{batter}})
{vessel} ({{batter}}) + oven (off) → PUT → {vessel} ({{batter}}; in oven) + oven (off)
oven (off) → TURN ON → oven (on)
batter ({{{food}, flour}}; in {vessel}) + {vessel} ({{batter}}; in oven) + oven (on) → {motion}
  → cake (baked; {{{food}, flour}}; in {vessel}) + {vessel} ({{cake}}; in oven)
"""


def ungreased(text):
    return [line for line in found("K7", text) if "greased" in line]


def test_k7_batter_in_a_tray_that_nobody_greased():
    assert ungreased(baked()) == ["K7 (minor) step 5: the baking tray is not greased"]


@pytest.mark.parametrize(
    "first",
    [
        "butter (solid) + baking tray (empty) → PUT → butter (solid; in baking tray) + baking tray ({butter})",
        "flour (whole; in bag) + baking tray (empty) → SPRINKLE → baking tray ({flour})",
        "butter (solid) + brush + baking tray (empty) → GREASE → baking tray (greased)",
        "baking tray (floured) → PUT → baking tray (floured; on table)",
        "foil + baking tray (empty) → PUT → baking tray ({foil})",
        "baking tray (lined with baking paper) → PUT → baking tray (lined with baking paper; on table)",
    ],
)
def test_k7_a_tray_that_was_made_ready(first):
    assert ungreased(baked(first)) == []


@pytest.mark.parametrize(
    "first",
    [
        "salt (whole; in bag) + baking tray (empty) → SPRINKLE → salt (whole; in baking tray) + baking tray ({salt})",
        "butter (solid) + plate (empty) → GREASE → plate (greased)",
        "baking tray (empty) → WASH → baking tray (clean)",
    ],
)
def test_k7_a_tray_that_was_not_made_ready(first):
    assert ungreased(baked(first)) != []


def test_k7_greasing_after_baking_is_too_late():
    late = "baking tray ({cake}; in oven) → GREASE → baking tray (greased; {cake}; in oven)"
    assert ungreased(lines(baked(), late)) == ["K7 (minor) step 5: the baking tray is not greased"]


@pytest.mark.parametrize("food", ["egg", "flour", "gnocchi", "puff pastry"])
def test_k7_what_sticks_to_a_tray(food):
    assert ungreased(lying(food)) == ["K7 (minor) step 4: the baking tray is not greased"]


def lying(food):
    """Steps that bake a mixture of one food and leeks on a tray."""
    return f"""
{food} (whole) + leek (whole) + baking tray → MIX → wibble ({{{food}, leek}}; in baking tray) + baking tray ({{wibble}})
baking tray ({{wibble}}) + oven (off) → PUT → baking tray ({{wibble}}; in oven) + oven (off)
oven (off) → TURN ON → oven (on)
baking tray ({{wibble}}; in oven) + oven (on) → BAKE → baking tray ({{wibble}}; in oven) + oven (on)
"""


def test_k7_what_does_not_stick_needs_no_grease():
    assert ungreased(lying("potato")) == []


def test_k7_what_is_not_baked_needs_no_grease():
    assert ungreased(baked(motion="BOIL")) == []
    assert ungreased(baked(vessel="steamer basket")) == []


def test_k7_dry_food_in_a_tray_needs_no_grease():
    step = """
carrot (whole) + potato (whole) + baking tray (empty) → PUT
  → carrot (whole; in baking tray) + potato (whole; in baking tray) + baking tray ({carrot, potato})
baking tray ({carrot, potato}) + oven (off) → PUT → baking tray ({carrot, potato}; in oven) + oven (off)
oven (off) → TURN ON → oven (on)
baking tray ({carrot, potato}; in oven) + oven (on) → BAKE → baking tray ({carrot, potato}; in oven) + oven (on)
"""
    assert ungreased(step) == []


def test_k7_flour_alone_is_no_batter():
    alone = """
flour (whole) + baking tray → PUT → flour (whole; in baking tray) + baking tray ({flour})
baking tray ({flour}) + oven (off) → PUT → baking tray ({flour}; in oven) + oven (off)
oven (off) → TURN ON → oven (on)
baking tray ({flour}; in oven) + oven (on) → BAKE → flour (toasted; in baking tray) + oven (on)
"""
    assert ungreased(alone) == []


@pytest.mark.parametrize(("state", "told"), [("thawed", True), ("defrosted", True)])
def test_k7_thawed_of_what_was_never_frozen(state, told):
    def thawed(before):
        step = f"raspberry ({before}) + bowl (empty) → PUT → raspberry ({before}; in bowl) + bowl ({{raspberry}})"
        return lines(step, f"raspberry ({before}; in bowl) → THAW → raspberry ({state}; in bowl)")

    assert found("K7", thawed("frozen")) == []
    assert found("K7", thawed("fresh")) == [
        f"K7 (minor) step 2 raspberry ({state}; in bowl): it is {state}, and it was never frozen"
    ]


def test_k7_a_state_that_nobody_earned():
    step = "carrot (whole) + plate (empty) → PUT → carrot (peeled; on plate) + plate ({carrot})"
    assert found("K7", step) == ["K7 (minor) step 1 carrot (peeled; on plate): it is peeled, and nobody made it so"]


def test_k7_what_belongs_on_top_is_stirred_in():
    told = found("K7", served("salad", "sprinkle", "tomato"))
    assert told == ["K7 (minor): sprinkle belongs on top and is stirred in"]
    assert found("K7", served("salad", "sprinkle", "tomato").replace("sprinkle", "sprinkle (crushed)", 1)) == []
    put = "sprinkle (whole) + plate ({tomato}) → PUT → sprinkle (whole; on plate) + plate ({sprinkle, tomato})"
    assert found("K7", lines(ONE_TOMATO, put)) == []


@pytest.mark.parametrize(
    ("dish", "bread", "told"),
    [
        ("salad", "bread (sliced)", True), ("soup", "roll (whole)", True), ("salad", "bread (cubed)", False),
        ("bread", "bread (sliced)", False), ("salad", "tomato (sliced)", False),
    ],
)  # fmt: skip
def test_k7_slices_of_bread_that_are_stirred_into_what_they_are_eaten_with(dish, bread, told):
    name = bread.partition(" (")[0]
    tree = recipe(dish, f"tomato; {bread}") + served(dish, bread, "lettuce").replace(f"{{{bread}", f"{{{name}")
    tree = tree.replace(f"{bread}, lettuce}}", f"{name}, lettuce}}").replace(
        f"lettuce, {bread}}}", f"lettuce, {name}}}"
    )
    assert [line for line in found("K7", tree) if "large pieces" in line] == (
        [f"K7 step 1: {name} in such large pieces is stirred in"] if told else []
    )


def test_k7_bread_that_was_toasted_before_may_be_stirred_in():
    toast = "bread (sliced) + toaster (on) → TOAST → bread (sliced, toasted) + toaster (on)"
    mixed = served("salad", "bread (sliced, toasted)", "lettuce").replace("{bread (sliced, toasted)", "{bread")
    told = found("K7", recipe("salad", "bread (sliced); lettuce") + lines(toast, mixed))
    assert not [line for line in told if "large pieces" in line]


def misread(asked, taken):
    food = taken.partition(" (")[0]
    step = f"{taken} + tomato (whole) + plate (empty) → PUT → salad ({{{food}, tomato}}; on plate) + plate ({{salad}})"
    return [line for line in found("K7", recipe("salad", asked) + step) if "taken for" in line]


@pytest.mark.parametrize(
    ("asked", "taken", "told"),
    [
        ("pepper (sliced)", "pepper (ground)", "pepper (sliced) is sweet pepper, and it was taken for black pepper"),
        ("pepper (ground)", "pepper (sliced)", "pepper (ground) is black pepper, and it was taken for sweet pepper"),
        ("fat (liquid)", "fat (solid)", "fat (liquid) is oil, and it was taken for fat"),
    ],
)
def test_k7_a_word_with_two_meanings_is_read_with_its_state(asked, taken, told):
    assert misread(asked, taken) == [f"K7 (minor): {told}"]


@pytest.mark.parametrize(
    ("asked", "taken"),
    [
        ("pepper (sliced)", "pepper (sliced)"),
        ("pepper (ground)", "pepper (powder)"),
        ("pepper", "pepper (ground)"),
        ("carrot (sliced)", "carrot (juice)"),
        ("pepper (sliced)", "leek"),
    ],
)
def test_k7_a_word_that_was_read_right_or_has_one_meaning(asked, taken):
    assert misread(asked, taken) == []


def test_coffee_that_comes_of_plain_water_is_fatal_as_tea_is():
    coffee = "water (liquid; in bottle) + cup (empty) → BREW → coffee (hot; in cup) + cup ({coffee})"
    assert "coffee does not come of water" in str(found("W2", coffee))


@pytest.mark.parametrize(
    ("title", "foods", "pieces"),
    [
        ("", ("banana", "milk"), True),
        ("", ("kale", "water"), True),
        ("Banana milk", ("banana", "milk"), True),
        ("Banana punch", ("banana", "milk"), False),
        ("", ("strawberry", "water"), False),
        ("", ("milk", "orange"), False),
        ("", ("kale", "water", "wine"), False),
    ],
)
def test_k7_fruit_in_milk_is_blended_and_not_drunk_in_pieces(title, foods, pieces):
    tree = recipe("drinks", "; ".join(foods), title) + served("drinks", *foods)
    told = [line for line in found("K7", tree) if "is drunk in pieces" in line]
    assert bool(told) is pieces


@pytest.mark.parametrize(("food", "refused"), [("cucumber", False), ("carrot", True)])
def test_k5_a_soup_that_is_blended_of_raw_cucumber_may_be_cold(food, refused):
    tree = (
        f"{food} (chopped; in blender jar) + blender jar ({{{food}}}) → BLEND → "
        f"soup (blended; {{{food}}}; in blender jar) + blender jar ({{{food}}})"
    )
    told = [line for line in found("K5", recipe("soup", food) + tree) if "nothing in it was heated" in line]
    assert bool(told) is refused
