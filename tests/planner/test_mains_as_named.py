"""Mains whose names or headings say how their foods meet: balls and their sauces, crusts, layers, casseroles."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def test_all_but_the_sauce_of_meatballs_is_in_the_balls_and_they_are_turned_in_flour(steps):
    told = steps("meatball", "Meatballs in Tomato Sauce", "beef mince:uncooked", "cumin:ground", "mint:chopped",
                 "egg:uncooked", "flour:powder:dusting", "olive oil:liquid:frying", "canned tomatoes:canned:sauce",
                 "red wine:liquid:sauce", "sugar:granulated:sauce")  # fmt: skip
    assert inside(told, "mix") == {"beef mince", "cumin", "mint", "egg"}
    assert first(told, "flour", "dip") < first(told, "olive oil", "heat")
    assert "simmer" in motions(told)[motions(told).index("flip") :]


@pytest.mark.parametrize("part", ["", "frying"])
def test_what_is_breaded_is_fried_where_its_fat_is_for_that(steps, part):
    told = steps("pork", "Breaded Pork Cutlets", "pork chops:boneless", "flour:powder", "eggs:beaten",
                 "breadcrumbs:dry", f"lard:creamy:{part}")  # fmt: skip
    assert ("bake" in motions(told)) is (not part)


def test_a_milk_gravy_is_no_part_of_the_coat_of_a_fried_steak(steps):
    told = steps(
        "steak",
        "Chicken Fried Steak",
        "cube steaks:raw",
        "flour:powder",
        "baking powder:powder",
        "buttermilk:liquid",
        "egg:uncooked",
        "shortening:creamy:frying",
        "flour:powder",
        "milk:liquid",
    )
    assert inside(told, "whisk") == {"buttermilk", "egg"}
    assert {"flour", "milk"} == inside(told[first(told, "milk", "pour") :], "cook and stir")


def test_meat_under_a_white_sauce_is_fried_though_the_sauce_is_listed_as_one(steps):
    told = steps(
        "casserole",
        "Moussaka",
        "aubergines:sliced",
        "lamb mince:raw",
        "onion:chopped",
        "oil:liquid",
        "canned tomatoes:canned",
        "butter:unmelted:sauce",
        "flour:plain:sauce",
        "milk:liquid:sauce",
    )
    assert first(told, "lamb mince", "cook and stir") < first(told, "aubergines", "bake")


@pytest.mark.parametrize("liquid", ["water:liquid", "white wine:liquid"])
def test_a_casserole_of_meat_and_roots_is_stewed_in_the_oven(steps, liquid):
    told = steps("casserole", "Lamb Casserole", "lamb shoulder:cubed", "carrots:sliced", "onions:sliced",
                 "bay leaf:sprig", liquid)  # fmt: skip
    assert {"lamb shoulder", "carrots", "onions"} <= inside(told, "bake")


def test_halves_are_fried_before_they_are_filled(steps):
    told = steps("vegetables", "Karn\u0131yar\u0131k", "aubergines:whole", "minced beef:uncooked", "onion:chopped",
                 "tomatoes:chopped", "olive oil:liquid")  # fmt: skip
    assert first(told, "aubergines", "cut") < first(told, "aubergines", "cook") < first(told, "minced beef", "bake")


def test_what_is_mashed_after_it_was_roasted_comes_to_what_is_fried(steps):
    told = steps("vegetables", "Baingan Bharta", "aubergine:whole", "oil:liquid", "onion:chopped", "cumin:ground",
                 "tomatoes:chopped")  # fmt: skip
    assert motions(told).index("bake") < motions(told).index("mash") < motions(told).index("heat")


@pytest.mark.parametrize(
    ("title", "grain", "egg"),
    [("Arroz Chaufa", "white rice:cooked", ["eggs:beaten"]), ("Beef Stir-Fry", "ready noodles:cooked", [])],
)
def test_cooked_rice_or_noodles_come_last_to_a_stir_fry(steps, title, grain, egg):
    told = steps("stir-fry", title, "oil:liquid", "beef:sliced", "red pepper:sliced", "soy sauce:liquid", grain, *egg)
    food = grain.partition(":")[0]
    into = next(n for n, (inputs, _, _) in enumerate(told) if {food, "cooking pan"} <= inputs)
    assert first(told, "red pepper", "cook and stir") < into
    assert not motions(told)[into + 1 :].count("mix")


def test_fries_for_serving_are_baked_by_themselves(steps):
    told = steps("steak", "Steak with Butter", "sirloin steak:raw", "butter:unmelted", "french fries:frozen:serving")
    assert inside(told, "bake") == {"french fries"}


def test_potatoes_that_are_baked_twice_are_whole_the_first_time(steps):
    told = steps("potatoes", "Twice-Baked Potatoes", "potatoes:scrubbed", "butter:unmelted", "milk:liquid",
                 "cheddar:shredded")  # fmt: skip
    assert motions(told).index("bake") < motions(told).index("mix")
    assert "chop" not in motions(told)


def test_trimmed_beans_lose_their_ends_once_and_juice_is_not_peeled(steps):
    told = steps("vegetables", "Green Beans Amandine", "green beans:trimmed", "butter:unmelted", "almonds:sliced")
    assert "core" not in motions(told)
    told = steps("steak", "Carne Asada", "skirt steak:raw", "orange:juice", "lime juice:juice", "garlic:minced")
    assert not any("orange" in inputs and motion == "peel" for inputs, motion, _ in told)


def test_a_slow_roast_is_no_braise_and_peppercorns_are_crushed_on_a_steak(steps):
    told = steps("roast", "Slow-Roast Lamb", "lamb shoulder:raw", "garlic:cut", "onions:sliced", "white wine:dry")
    assert "simmer" not in motions(told)
    assert "lamb shoulder" in inside(told, "bake")
    told = steps("steak", "Steak au Poivre", "fillet steaks:raw", "peppercorns:whole", "brandy:liquid", "cream:creamy")
    crushed = [node for _, _, outputs in told for node in outputs if node.label == "peppercorns"]
    assert any("crushed" in node.states for node in crushed)


def test_what_only_gives_its_taste_is_not_laid_on_what_is_done(steps):
    told = steps("beef", "Beef in Cream Sauce", "beef:raw", "onion:chopped", "bay leaf:sprig", "butter:unmelted",
                 "flour:powder", "cream:liquid")  # fmt: skip
    assert "cook and stir" in motions(told)[first(told, "bay leaf", "pick-and-place") :]
