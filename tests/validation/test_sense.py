"""K7 (docs/contract.md): each clause kept and broken by a small tree."""

from __future__ import annotations

import pytest
from validation.dishes import lines, recipe, served
from validation.judging import ONE_TOMATO, found

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


def test_k7_the_step_is_named_that_stirs_in_what_had_to_be_blended():
    stirred = (
        "orange (whole; on table) + milk (liquid; on table) + glass (empty) + spoon → STIR → "
        "drinks (in glass; {orange, milk}) + glass ({orange, milk}) + spoon\n"
        "banana (whole; on table) + drinks (in glass; {orange, milk}) + glass ({orange, milk}) + spoon → STIR → "
        "drinks (in glass; {banana, orange, milk}) + glass ({banana, orange, milk}) + spoon"
    )
    told = found("K7", recipe("drinks", "banana; orange; milk") + stirred)
    assert [line for line in told if "drunk in pieces" in line] == ["K7 step 2: banana is drunk in pieces"]
