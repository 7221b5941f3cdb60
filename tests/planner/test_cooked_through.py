"""What has to be cooked, stirred or kept apart for it to be that dish: sauces, soups, white sauces, beaten whites."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

HEATS = {"bake", "boil", "cook", "cook and stir", "simmer"}


def vessels(told):
    """Every label of the dish's own vessels."""
    return {node.container for _, _, outputs in told for node in outputs if node.container}


def test_a_sauce_of_raw_roots_and_tomatoes_is_fried_and_simmered(steps):
    told = steps("sauce", "Sauce of the House", "olive oil:liquid", "onion:finely chopped", "garlic:sliced",
                 "tomatoes:crushed", "oregano:dried", "basil leaves:torn", "salt:granulated")  # fmt: skip
    assert first(told, "onion", "cook and stir") < first(told, "tomatoes", "pour") < motions(told).index("simmer")
    assert {"onion", "tomatoes", "oregano"} <= inside(told, "simmer")
    assert "basil leaves" not in inside(told, "simmer")


def test_a_sauce_of_what_is_sour_and_sweet_is_simmered(steps):
    told = steps("sauce", "Kansas City Sauce", "ketchup:sauce", "apple cider vinegar:liquid",
                 "dark brown sugar:granulated", "garlic powder:ground", "paprika:smoked")  # fmt: skip
    assert {"ketchup", "apple cider vinegar", "dark brown sugar"} <= inside(told, "simmer")


@pytest.mark.parametrize(
    ("title", "asked"),
    [
        ("Tomato Salsa", ("tomatoes:chopped", "onion:chopped", "cilantro:chopped", "lime juice:juice")),
        ("Honey Dressing", ("vinegar:liquid", "honey:thick liquid", "ketchup:sauce", "oil:liquid")),
        ("Chimichurri Sauce", ("parsley:chopped", "garlic:minced", "vinegar:liquid", "oil:liquid", "onion:minced")),
        ("Cocktail Sauce", ("ketchup:sauce", "horseradish:grated", "lemon juice:juice", "sugar:granulated")),
    ],
)
def test_a_sauce_that_is_eaten_raw_stays_raw(steps, title, asked):
    assert HEATS.isdisjoint(motions(steps("sauce", title, *asked)))


def test_a_soup_that_is_called_like_a_baked_dish_is_cooked_in_a_pot(steps):
    told = steps("soup", "Loaded Baked Potato Soup", "bacon:chopped", "onion:diced", "garlic:minced", "flour:powder",
                 "chicken stock:liquid", "russet potatoes:cubed", "milk:liquid", "sour cream:creamy",
                 "cheddar cheese:shredded", "green onions:sliced", "salt:granulated")  # fmt: skip
    assert "bake" not in motions(told)
    assert "pot" in vessels(told)
    assert told[-1][2][0].container != "plate"


def test_flour_in_a_casserole_is_stirred_into_fat_before_milk_comes_to_it(steps):
    told = steps("casserole", "Chicken and Rice Bake", "cooked chicken:cubed", "white rice:cooked",
                 "broccoli florets:floret", "butter:unmelted", "onion:chopped", "flour:powder", "milk:liquid",
                 "chicken broth:liquid", "cheddar:grated", "panko:crumbs")  # fmt: skip
    assert first(told, "flour", "cook and stir") < first(told, "milk", "pour")
    assert {"milk", "flour"} <= inside(told, "mix")


def test_bread_in_meatballs_is_torn_and_soaked_and_flour_whisked_for_their_sauce(steps):
    told = steps("meatball", "Swedish Meatballs", "white bread:loaf", "milk:liquid", "butter:unmelted", "onion:chopped",
                 "ground beef:raw", "egg yolks:uncooked", "flour:powder", "beef broth:liquid",
                 "heavy cream:creamy")  # fmt: skip
    assert {"white bread", "milk", "ground beef"} <= inside(told, "shape")
    bread = [node for _, _, outputs in told for node in outputs if node.label == "white bread"]
    assert "torn" in bread[0].states
    assert {"flour", "beef broth"} == inside(told, "stir")
    assert "heavy cream" not in inside(told, "shape")
    assert first(told, "flour", "stir") < motions(told).index("simmer")


def test_bread_is_served_beside_what_is_cooked_in_a_pan(steps):
    told = steps("seafood", "Garlic Butter Shrimp Scampi", "shrimp:deveined", "butter:unmelted", "olive oil:liquid",
                 "garlic:minced", "white wine:dry", "lemon juice:juice", "parsley:chopped",
                 "crusty bread:loaf")  # fmt: skip
    comes = [place for place, (inputs, _, _) in enumerate(told) if "crusty bread" in inputs]
    off = len(told) - 1 - motions(told)[::-1].index("turn off")
    assert first(told, "crusty bread", "slice") < off < comes[-1]
    assert not [motion for inputs, motion, _ in told if "crusty bread" in inputs and motion in HEATS]


def test_a_filling_under_a_meringue_is_stirred_smooth_before_it_is_cooked(steps):
    told = steps("pie", "Lemon Meringue Pie", "pie crust:raw", "sugar:granulated", "cornstarch:powder",
                 "water:liquid", "eggs:uncooked", "lemon juice:fresh", "butter:unmelted")  # fmt: skip
    assert first(told, "cornstarch", "whisk") < motions(told).index("cook and stir")
    assert "cornstarch" in inside(told, "cook and stir")


def test_nuts_and_seeds_of_a_milk_are_ground_in_it_and_strained(steps):
    told = steps("drinks", "Thandai", "almonds:blanched", "poppy seeds:seed", "fennel seeds:whole", "milk:cold",
                 "sugar:granulated")  # fmt: skip
    assert {"almonds", "fennel seeds", "milk"} <= inside(told, "blend")
    assert motions(told).index("blend") < motions(told).index("pour and strain")


def test_the_sauce_of_a_bread_pudding_is_cooked_by_itself(steps):
    told = steps("pudding", "Bread Pudding with Vanilla Sauce", "day-old bread:torn", "butter:melted", "raisins:whole",
                 "eggs:beaten", "milk:liquid", "sugar:granulated", "vanilla extract:liquid", "heavy cream:creamy",
                 "brown sugar:granulated", "flour:powder")  # fmt: skip
    smooth = [inputs for inputs, motion, _ in told if motion in {"beat", "whisk"} and "flour" in inputs]
    assert smooth[0] >= {"flour", "heavy cream", "brown sugar", "saucepan"}
    assert {"flour", "vanilla extract"} <= inside(told, "cook and stir")
    assert {"eggs", "milk", "day-old bread"} <= inside(told, "bake")
    assert "flour" not in inside(told, "bake")
    assert any("flour" in node.ingredients for node in told[-1][2])
