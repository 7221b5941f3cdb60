"""Dishes known by the names of many lands: what their family does with their foods is done."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def test_dough_is_closed_around_a_filling_and_fried(steps):
    told = steps(
        "bread",
        "Chebureki",
        "flour:powder",
        "salt:granulated",
        "water:liquid",
        "vegetable oil:liquid",
        "ground lamb:raw",
        "onion:chopped",
        "parsley:chopped",
        "oil:liquid:frying",
    )
    assert "flour" not in told[motions(told).index("cook and stir")][0]
    assert motions(told).index("fold and pinch") < motions(told).index("flip")
    assert "bake" not in motions(told)


@pytest.mark.parametrize(
    ("title", "foods"),
    [
        (
            "Pelmeni",
            ("flour:powder", "egg:uncooked", "water:liquid", "ground pork:raw", "onion:grated", "salt:granulated"),
        ),
        ("Mantou", ("flour:powder", "yeast:powder", "sugar:granulated", "milk:warm")),
        (
            "Baozi",
            ("flour:powder", "yeast:powder", "water:warm", "ground pork:raw", "scallion:chopped", "soy sauce:sauce"),
        ),
        (
            "Red tamales",
            ("masa harina:powder", "lard:creamy", "chicken broth:liquid", "pork shoulder:raw", "corn husks:soaked"),
        ),
        ("Semmelknödel", ("stale rolls:cubed", "milk:liquid", "eggs:uncooked", "onion:chopped", "butter:unmelted")),
        ("Cepelinai", ("potatoes:grated", "ground pork:raw", "onion:chopped", "salt:granulated", "sour cream:creamy")),
    ],
)
def test_what_is_boiled_or_steamed_never_comes_into_the_oven(steps, title, foods):
    told = steps("bread", title, *foods)
    assert "boil" in motions(told)
    assert "bake" not in motions(told)


@pytest.mark.parametrize("title", ["Mandazi", "Oliebollen", "Faworki"])
def test_what_is_fried_in_much_fat_is_no_bread_out_of_the_oven(steps, title):
    told = steps("bread", title, "flour:powder", "egg:uncooked", "milk:liquid", "sugar:granulated", "oil:liquid:frying")
    assert "bake" not in motions(told)
    assert "flip" in motions(told)


def test_fish_joins_last_what_it_is_stewed_in(steps):
    told = steps(
        "seafood",
        "Kerala meen curry",
        "kingfish:sliced",
        "coconut oil:liquid",
        "shallots:sliced",
        "ginger:chopped",
        "coconut milk:liquid",
        "water:liquid",
        "turmeric:ground",
    )
    assert first(told, "coconut milk", "simmer") < first(told, "kingfish", "simmer")


def test_mince_of_a_kebab_is_mixed_shaped_and_grilled(steps):
    told = steps(
        "beef",
        "Ćevapi",
        "ground beef:raw",
        "garlic:minced",
        "paprika:ground",
        "onion:sliced",
        "salt:granulated",
        "flatbread:plain:serving",
    )
    assert inside(told, "mix") == {"ground beef", "garlic", "paprika", "salt"}
    assert "broil" in motions(told)


def test_mash_is_closed_around_what_is_fried(steps):
    told = steps(
        "potatoes",
        "Papa rellena",
        "potatoes:whole",
        "ground beef:raw",
        "onion:chopped",
        "egg:uncooked",
        "flour:powder",
        "oil:liquid:frying",
        "cumin:ground",
    )
    assert motions(told).index("mash") < motions(told).index("fold and pinch") < motions(told).index("flip")
    assert "potatoes" not in inside(told, "cook and stir")


def test_vegetables_are_stuffed_raw_and_simmer_in_their_sauce(steps):
    told = steps(
        "vegetables",
        "Punjene paprike",
        "bell peppers:whole",
        "ground beef:raw",
        "rice:uncooked",
        "onion:chopped",
        "egg:uncooked",
        "tomato passata:sauce",
        "water:liquid",
    )
    assert {"ground beef", "rice", "egg"} <= inside(told, "stir")
    assert {"bell peppers", "tomato passata"} <= inside(told, "simmer")


@pytest.mark.parametrize(
    ("dish_type", "title", "foods"),
    [
        ("pudding", "Queen of Puddings", ("milk:liquid", "breadcrumbs:crumbs", "raspberry jam:jelly")),
        ("pie", "Lemon Meringue Pie", ("pie crust:whole", "cornstarch:powder", "water:liquid", "lemons:juiced")),
    ],
)
def test_whites_of_separated_eggs_are_beaten_with_sugar_and_lie_on_top(steps, dish_type, title, foods):
    told = steps(dish_type, title, *foods, "eggs:separated", "sugar:granulated", "sugar:granulated:meringue")
    whites = next(
        at for at, (things, motion, _) in enumerate(told) if motion == "whisk" and {"egg whites", "sugar"} <= things
    )
    assert "egg yolks" not in told[whites][0]
    assert whites < max(at for at, motion in enumerate(motions(told)) if motion == "bake")
    assert all("egg whites" not in things for things, motion, _ in told if motion == "cook and stir")


def test_semolina_is_fried_in_its_fat_before_syrup_comes_to_it(steps):
    told = steps("pudding", "Sooji Halwa", "semolina:powder", "ghee:creamy", "sugar:granulated", "water:liquid")
    alone = [things for things, motion, _ in told if motion == "cook and stir" and "semolina" in things]
    assert "sugar" not in alone[0]
    assert "sugar" in alone[-1]


def test_onions_lie_on_flat_bread_under_fowl(steps):
    told = steps(
        "chicken",
        "Musakhan",
        "chicken legs:raw",
        "onions:sliced",
        "olive oil:liquid",
        "sumac:ground",
        "flatbread:plain",
        "salt:granulated",
    )
    assert "flatbread" not in inside(told, "cook and stir")
    assert {"flatbread", "onions", "chicken legs"} <= set().union(
        *(things for things, motion, _ in told if motion == "bake")
    )


def test_peppers_and_eggplants_are_roasted_skinned_and_dressed(steps):
    told = steps(
        "vegetables",
        "Escalivada",
        "eggplants:whole",
        "red bell peppers:whole",
        "onions:whole",
        "garlic:minced",
        "olive oil:liquid",
        "vinegar:liquid",
        "salt:granulated",
    )
    assert "cook and stir" not in motions(told)
    assert motions(told).index("bake") < first(told, "vinegar", "mix")


def test_biscuits_of_a_cake_that_is_not_baked_lie_in_layers(steps):
    told = steps(
        "cake", "Bolo de bolacha", "maria biscuits:whole", "coffee:liquid", "butter:softened", "icing sugar:powder"
    )
    assert "bake" not in motions(told)
    assert "chill" in motions(told)


def test_a_plain_custard_has_no_caramel_below_it(steps):
    told = steps("pudding", "Egg Custard", "milk:liquid", "eggs:uncooked", "sugar:granulated", "nutmeg:ground")
    assert "sugar" in inside(told, "whisk")
    assert "sugar" not in inside(told, "cook and stir")


def test_a_bun_whose_name_ends_like_that_of_a_steamed_one_is_baked(steps):
    told = steps(
        "bread", "Gai Mei Bao", "flour:powder", "yeast:dried", "milk:warm", "sugar:granulated", "egg:uncooked",
        "butter:unmelted", "dried coconut:shredded:filling",
    )  # fmt: skip
    assert "bake" in motions(told)
    assert {"boil", "steam"}.isdisjoint(motions(told))
