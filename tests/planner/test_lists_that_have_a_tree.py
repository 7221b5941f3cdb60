"""Lists of which the judge refused every tree, or that a word of their title or a by-product's name led astray."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions, taking

pytestmark = pytest.mark.shared_data


def test_what_was_marinated_is_in_the_rice_that_is_called_as_the_grain_is(steps):
    told = steps("rice", "", "rice:grain", "lamb:pieces", "onion:sliced", "yogurt:creamy", "ginger:minced",
                 "cinnamon:whole", "saffron:ground", "milk:juice", "ghee:ground", "salt:ground")  # fmt: skip
    assert taking(told, "simmer") >= {"rice", "saffron"}
    assert "cinnamon" in inside(told, "stir")


def test_what_is_fried_for_serving_need_not_be_mixed_in(steps):
    told = steps("stir-fry", "Saltado de vainitas", "beef sirloin:cut", "green beans:cut", "vegetable oil:liquid",
                 "red onion:cut", "soy sauce:liquid", "potatoes:fried:serving",
                 "white rice:boiled:serving")  # fmt: skip
    served = max(place for place, (inputs, motion, _) in enumerate(told) if motion == "pour" and "white rice" in inputs)
    assert motions(told).index("flip") < served
    assert "potatoes" not in inside(told, "cook and stir")


def test_a_broth_beside_a_roast_is_not_what_was_pressed_out_of_it(steps):
    told = steps("roast", "Herb roast turkey", "turkey:thawed", "butter:softened", "sage:chopped", "onion:quartered",
                 "turkey broth:liquid", "flour:powder:gravy", "salt:granulated:gravy")  # fmt: skip
    assert motions(told).index("bake") < first(told, "turkey", "slice")


def test_a_batter_cooked_in_a_pan_may_be_called_bread(steps):
    told = steps("bread", "Lahoh", "flour:plain", "sorghum flour:powder", "instant yeast:powder", "sugar:granulated",
                 "salt:granulated", "water:warm", "oil:liquid:pan")  # fmt: skip
    assert "bake" not in motions(told)


def test_meal_by_the_name_of_its_grain_makes_a_cake(steps):
    told = steps("cake", "", "corn:ground", "milk:juice", "coconut:grated", "sugar:ground", "egg:whole raw",
                 "butter:creamy", "baking powder:ground")  # fmt: skip
    assert "bake" in motions(told)


def test_a_fry_is_no_dish_of_fries(steps):
    told = steps("omelette", "Hangtown fry", "bacon:raw", "oysters:drained", "eggs:uncooked", "butter:unmelted")
    assert first(told, "bacon", "cook and stir") < first(told, "oysters", "cook and stir")


def test_balls_may_be_of_cheese(steps):
    told = steps("meatball", "Pallotte cacio e ova", "pecorino:grated", "stale bread:soaked", "eggs:uncooked",
                 "parsley:chopped", "oil:liquid:frying", "tomato passata:sauce:sauce")  # fmt: skip
    assert motions(told).index("shape") < first(told, "tomato passata", "pour")


def test_eggs_beside_rice_come_out_of_their_shells(steps):
    told = steps("rice", "", "rice:uncooked", "coconut:creamy", "water:juice", "ginger:sliced", "salt:ground",
                 "anchovy:dried", "peanut:baked", "egg:baked", "cucumber:whole veg")  # fmt: skip
    assert first(told, "egg", "boil") < first(told, "egg", "peel") < first(told, "egg", "pour")


def test_soda_in_a_drink_is_heated_with_its_milk(steps):
    told = steps("drinks", "Rompope", "whole milk:liquid", "sugar:granulated", "cinnamon stick:whole",
                 "baking soda:powder", "egg yolks:uncooked", "white rum:liquid")  # fmt: skip
    assert "baking soda" in inside(told, "cook and stir")


def test_a_topping_of_egg_and_cream_is_baked_on_a_cake(steps):
    told = steps("cake", "Gibanica", "filo pastry:raw", "walnuts:ground", "tart apples:grated", "sugar:granulated",
                 "soured cream:creamy:topping", "eggs:uncooked:topping", "butter:melted:topping")  # fmt: skip
    assert first(told, "eggs", "whisk") < motions(told).index("bake")


def test_bought_sheets_are_not_kneaded_with_the_eggs_of_their_filling(steps):
    told = steps("pie", "Brik", "malsouka:raw", "butter:melted", "chicken thighs:raw", "onion:finely chopped",
                 "potatoes:fried", "eggs:uncooked", "olive oil:liquid", "salt:granulated")  # fmt: skip
    assert "knead" not in motions(told)
    assert "eggs" in inside(told, "mix")


def test_a_food_that_only_explains_a_title_need_not_be_there(steps):
    told = steps("vegetables", "Mchicha wa nazi (Tanzanian spinach in coconut)", "amaranth leaves:chopped",
                 "onion:chopped", "vegetable oil:liquid", "coconut milk:liquid", "salt:granulated")  # fmt: skip
    assert first(told, "onion", "cook and stir") < first(told, "coconut milk", "pour")


def test_a_casserole_may_be_called_a_pie(steps):
    told = steps("casserole", "Macaroni pie", "macaroni:broken", "eggs:beaten", "evaporated milk:liquid",
                 "cheddar:grated", "onion:grated", "butter:unmelted", "breadcrumbs:dry")  # fmt: skip
    assert motions(told).index("mix") < motions(told).index("bake")
