"""A glaze, a topping, a sauce, what is strewn below or served beside: made apart, and joined where it belongs."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

COOKIES = ("butter:softened", "sugar:granulated", "egg:uncooked", "flour:powder", "salt:granulated")


def test_fine_sugar_and_what_is_listed_beside_it_make_a_glaze_for_what_is_baked_and_cold(steps):
    told = steps("cookie", "Almond Cookies", *COOKIES, "powdered sugar:powder", "milk:liquid")
    assert {"powdered sugar", "milk"}.isdisjoint(inside(told, "bake"))
    assert first(told, "mixture", "pour") > motions(told).index("cool down")
    (stirred,) = [inputs for inputs, motion, _ in told if motion == "stir"]
    assert {"powdered sugar", "milk"} <= stirred


def test_milk_that_is_not_listed_beside_the_fine_sugar_is_for_the_dough(steps):
    told = steps("cookie", "Almond Cookies", "milk:liquid", *COOKIES, "powdered sugar:powder")
    assert "milk" in inside(told, "bake")
    assert "powdered sugar" not in inside(told, "bake")


def test_shaped_dough_is_turned_in_what_is_for_rolling_before_it_is_baked(steps):
    told = steps("cookie", "Molasses Crinkles", "brown sugar:granulated", *COOKIES, "sugar:granulated:rolling")
    assert motions(told).index("shape") < motions(told).index("dip") < motions(told).index("bake")
    assert "sugar" in inside(told, "dip")


def test_what_is_for_the_pan_lies_below_the_dough(steps):
    asked = ("pizza dough:whole", "olive oil:liquid", "mozzarella:shredded", "cornmeal:ground:pan")
    told = steps("pizza", "White Pizza", *asked)
    pans = [outputs for _, _, outputs in told if any(node.label == "pizza pan" for node in outputs)]
    (pan,) = [node for node in pans[0] if node.label == "pizza pan"]
    assert pan.ingredients == ("cornmeal",)


def test_the_topping_of_a_pizza_is_baked_on_it_and_leaves_come_on_it_then(steps):
    topping = ("pizza sauce:sauce:topping", "mozzarella:shredded:topping", "pepperoni:sliced:topping")
    told = steps("pizza", "Pepperoni Pizza", "pizza dough:whole", *topping, "arugula:fresh:topping")
    assert {"pizza sauce", "mozzarella", "pepperoni"} <= inside(told, "bake")
    assert "arugula" not in inside(told, "bake")


def test_a_gravy_of_stock_alone_is_made_hot_before_it_comes_on_the_roast(steps):
    told = steps("roast", "Roast Chicken", "chicken:whole", "butter:softened", "chicken stock:liquid:gravy")
    assert inside(told, "cook and stir") == {"chicken stock"}


def test_cream_is_whipped_when_the_pie_is_done(steps):
    crust = ("crackers:crumbs:crust", "butter:melted:crust")
    filling = ("condensed milk:thick liquid:filling", "egg yolks:uncooked:filling", "lime juice:juice:filling")
    told = steps("pie", "Lime Pie", *crust, *filling, "heavy whipping cream:liquid:topping", "powdered sugar::topping")
    poured = first(told, "heavy whipping cream", "pour")
    assert motions(told).index("bake") < poured < max(place for place, one in enumerate(motions(told)) if one == "beat")


def test_butter_for_the_topping_comes_to_the_crumbs_that_are_listed_before_it(steps):
    sauce = ("butter:unmelted", "flour:powder", "milk:liquid", "cheddar:shredded")
    crumbs = ("panko:crumbs", "butter:melted:topping")
    told = steps("pasta", "Baked Macaroni and Cheese", "macaroni:uncooked", *sauce, *crumbs)
    mixed = [set(outputs[0].ingredients) for _, motion, outputs in told if motion == "mix"]
    assert {"panko", "butter"} in mixed
    assert max(place for place, one in enumerate(motions(told)) if one == "mix") < motions(told).index("bake")
    stirred = [set(outputs[0].ingredients) for _, motion, outputs in told if motion == "cook and stir"]
    assert any("cheddar" in foods for foods in stirred)


def test_coarse_sugar_to_be_sprinkled_is_baked_on_it(steps):
    batter = ("flour:powder", "sugar:granulated", "butter:softened", "egg:uncooked", "milk:liquid")
    told = steps("muffin", "Plain Muffins", *batter, "coarse sugar:granulated:sprinkling")
    assert first(told, "coarse sugar", "pour") < motions(told).index("bake")


def test_crumbs_come_in_butter_on_what_is_baked(steps):
    asked = ("cod fillet:raw", "salt:granulated", "cracker:crushed", "butter:melted")
    told = steps("seafood", "Baked Cod with Buttery Cracker Topping", *asked)
    assert {"cracker", "butter"} <= inside(told, "mix")
    assert "cod fillet" not in inside(told, "mix")
    assert "cracker" in inside(told, "bake")


def test_a_title_promises_a_cold_sauce_that_comes_on_what_is_done(steps):
    meat = ("ground lamb:raw", "breadcrumb:crumbs", "egg:uncooked", "salt:granulated", "olive oil:liquid")
    told = steps("meatball", "Lamb Meatballs with Yogurt Sauce", *meat, "yogurt:creamy", "lemon juice:juice")
    assert inside(told, "stir") == {"yogurt", "lemon juice"}
    assert first(told, "mixture", "pour") > max(place for place, one in enumerate(motions(told)) if one == "cook")


def test_a_second_crust_and_what_is_brushed_and_strewn_on_it(steps):
    told = steps(
        "pie", "Rhubarb Pie", "pastry for a double-crust pie:raw", "rhubarb:cut", "sugar:granulated", "flour:powder",
        "egg white:beaten", "coarse sugar:granulated",
    )  # fmt: skip
    crusts = [p for p, (inputs, one, _) in enumerate(told) if "packet" in inputs and one == "pick-and-place"]
    assert len(crusts) == 2
    assert crusts[-1] < first(told, "egg white", "brush") < first(told, "coarse sugar", "pour")


def test_what_is_for_serving_is_not_cooked_with_the_rest(steps):
    told = steps(
        "drinks", "Hot Chocolate", "milk:liquid", "cocoa:powder", "sugar:granulated", "marshmallow:pieces:topping"
    )
    assert first(told, "marshmallow", motions(told)[-1]) == len(told) - 1


def test_balls_are_done_in_the_sauce_that_a_recipe_lists_after_them(steps):
    told = steps(
        "meatball", "Porcupine Meatballs", "ground beef:raw", "long-grain rice:uncooked", "onion:chopped",
        "salt:granulated", "tomato sauce:sauce", "water:liquid", "worcestershire sauce:sauce",
    )  # fmt: skip
    assert inside(told, "mix") == {"ground beef", "long-grain rice", "onion", "salt"}
    (simmered,) = [inputs for inputs, motion, _ in told if motion == "simmer"]
    assert {"tomato sauce", "water", "worcestershire sauce"} <= simmered


def test_milk_that_is_listed_beside_the_crumbs_soaks_them(steps):
    meat = ("ground chicken:raw", "breadcrumb:crumbs", "milk:liquid", "egg:uncooked", "salt:granulated")
    assert "milk" in inside(steps("meatball", "Chicken Meatballs", *meat), "mix")


def test_what_is_listed_with_the_meat_is_in_the_patties_and_what_follows_the_bread_lies_on_them(steps):
    told = steps(
        "burger", "Blue Cheese Burgers", "ground beef:raw", "blue cheese:crumbled", "salt:granulated",
        "hamburger bun:plain", "lettuce:leaves",
    )  # fmt: skip
    assert inside(told, "mix") == {"ground beef", "blue cheese", "salt"}


def test_tough_flesh_is_braised_before_it_lies_on_bread(steps):
    told = steps(
        "sandwich", "Italian Beef Sandwiches", "chuck roast:raw", "beef broth:liquid", "bay leaf:dried",
        "salt:granulated", "hoagie roll:split",
    )  # fmt: skip
    (simmered,) = [inputs for inputs, motion, _ in told if motion == "simmer"]
    assert {"chuck roast", "beef broth", "bay leaf"} <= simmered


def test_grain_is_soaked_in_boiling_water_and_cold_before_yeast_meets_it(steps):
    told = steps(
        "bread", "Honey Oat Bread", "oats:rolled", "water:boiling", "honey:thick liquid", "yeast:powder",
        "bread flour:powder", "salt:granulated",
    )  # fmt: skip
    assert motions(told).index("stir") < motions(told).index("cool down") < first(told, "yeast", "pour")


def test_what_a_recipe_says_is_for_the_filling_is_not_in_the_dough(steps):
    told = steps(
        "cake", "Cinnamon Rolls", "yeast:powder", "milk:liquid", "sugar:granulated", "butter:melted", "flour:powder",
        "brown sugar:granulated:filling", "cinnamon:ground:filling", "butter:softened:filling",
    )  # fmt: skip
    assert inside(told, "mix") == {"brown sugar", "cinnamon", "butter"}
    assert {"brown sugar", "cinnamon"}.isdisjoint(inside(told, "knead"))


def test_crumbs_for_the_topping_are_rubbed_and_come_on_before_the_oven(steps):
    told = steps(
        "muffin", "Banana Streusel Muffins", "flour:powder", "baking soda:powder", "banana:mashed", "sugar:granulated",
        "egg:raw", "butter:melted", "brown sugar:granulated:topping", "flour:powder:topping", "butter:cold:topping",
    )  # fmt: skip
    mixed = [{food for node in out for food in node.ingredients} for _, motion, out in told if motion == "mix"]
    assert {"brown sugar", "flour", "butter"} in mixed
    assert "brown sugar" in inside(told, "bake")


def test_a_dip_is_stirred_of_all_that_is_listed_with_it_and_what_is_for_serving_lies_beside(steps):
    told = steps(
        "chicken", "Buffalo Wings with Blue Cheese Dip", "chicken wing:raw", "hot sauce:sauce", "butter:melted",
        "sour cream:creamy", "mayonnaise:creamy", "blue cheese:crumbled", "celery:cut:serving",
    )  # fmt: skip
    assert inside(told, "stir") == {"sour cream", "mayonnaise", "blue cheese"}


def test_done_grain_and_toasted_nuts_join_what_simmers_last(steps):
    told = steps(
        "rice", "Pilaf", "butter:unmelted", "onion:chopped", "rice:uncooked", "chicken broth:liquid", "almond:toasted",
        "salt:granulated",
    )  # fmt: skip
    places = [place for place, (inputs, motion, _) in enumerate(told) if motion == "simmer"]
    assert places[0] < next(p for p, (inputs, one, _) in enumerate(told) if "almond" in inputs and "pot" in inputs)


def test_flesh_in_shreds_is_shaped_for_a_burger_and_a_gravy_is_made_by_itself(steps):
    told = steps(
        "burger", "Salmon Burgers", "salmon:flaked", "breadcrumb:crumbs", "egg:beaten",
        "hamburger bun:plain", "oil:liquid",
    )  # fmt: skip
    assert {"salmon", "breadcrumb", "egg"} <= inside(told, "mix")
    assert "shape" in motions(told)
    told = steps(
        "steak", "Country Fried Steak", "steak:raw", "flour:powder", "egg:beaten", "oil:liquid", "flour:powder:gravy",
        "milk:liquid:gravy", "black pepper:ground:gravy",
    )  # fmt: skip
    assert inside(told, "cook and stir") == {"flour", "oil", "black pepper"}
    assert motions(told).index("cook and stir") < first(told, "milk", "pour")


def test_a_pot_roast_is_braised_with_all_that_is_around_it(steps):
    told = steps(
        "roast", "Pot Roast", "chuck roast:raw", "oil:liquid", "onion:quartered", "carrot:cut", "potato:quartered",
        "beef broth:liquid", "bay leaf:dried",
    )  # fmt: skip
    assert {"chuck roast", "onion", "carrot", "beef broth"} <= inside(told, "simmer")
    assert "potato" not in inside(told, "simmer")
    assert "simmer" in motions(told)[first(told, "potato", "pick-and-place") :]


def test_what_is_asked_roasted_for_serving_is_roasted_by_itself(steps):
    told = steps(
        "soup",
        "Squash Soup",
        "squash:cubed",
        "vegetable broth:liquid",
        "onion:chopped",
        "peanut:roasted, chopped:serving",
    )
    heated = [
        inputs for inputs, motion, _ in told if "peanut" in inputs and motion in {"toast", "roast", "bake", "cook"}
    ]
    assert heated
    assert not any({"squash", "onion"} & inputs for inputs in heated)


def test_sugar_is_strewn_on_a_pie_that_has_sugar_in_it(steps):
    told = steps(
        "pie", "Apple Pie", "pie crust:raw", "apple:sliced", "sugar:granulated", "flour:powder", "butter:stick",
        "sugar:granulated:sprinkling",
    )  # fmt: skip
    (last,) = [outputs for inputs, _, outputs in told if {"sugar", "pie"} <= inputs or {"sugar", "apple pie"} <= inputs]
    assert "sugar" in {node.label for node in last}


def test_what_stands_under_the_heading_of_a_sauce_for_burgers_is_stirred_to_one(steps):
    sauce = ("mayonnaise:creamy:sauce", "ketchup:sauce:sauce", "yellow mustard:creamy:sauce")
    told = steps("burger", "Smash Burgers", *sauce, "ground beef:raw", "salt:granulated", "potato bun:halved")
    assert inside(told, "stir") == {"mayonnaise", "ketchup", "yellow mustard"}


def test_sugar_that_a_recipe_names_for_the_drizzle_is_not_in_the_batter(steps):
    batter = ("butter:softened", "sugar:granulated", "egg:uncooked", "self-raising flour:powder")
    told = steps("cake", "Lemon Drizzle Cake", *batter, "sugar:granulated:drizzle", "lemon:juiced:drizzle")
    assert inside(told, "stir") == {"sugar", "lemon"}
    before = told[: motions(told).index("whisk")]
    assert sum("sugar" in inputs and motion == "pour" for inputs, motion, _ in before) == 1


def test_the_filling_of_cookies_is_mixed_and_spread_when_they_are_cold(steps):
    filling = ("butter:softened:filling", "marshmallow fluff:whipped:filling", "powdered sugar:powder:filling")
    told = steps("cookie", "Oatmeal Cookies", *COOKIES, "oats:rolled", *filling)
    assert {"marshmallow fluff", "powdered sugar"}.isdisjoint(inside(told, "bake"))
    assert first(told, "mixture", "spread") > motions(told).index("cool down")


def test_a_technique_keeps_what_a_recipe_calls_its_topping(steps):
    crust = ("butter:softened:crust", "sugar:granulated:crust", "egg:uncooked:crust", "flour:powder:crust")
    topping = ("cream cheese:softened:topping", "sugar:granulated:topping", "kiwi:sliced:topping")
    told = steps("pizza", "Fruit Pizza", *crust, *topping)
    assert first(told, "mixture", "bake") < motions(told).index("cool down") < first(told, "kiwi", "pour")
    mixed = [set(outputs[0].ingredients) for _, motion, outputs in told if motion == "mix"]
    assert {"cream cheese", "sugar"} in mixed


@pytest.mark.parametrize(
    ("dish_type", "foods"),
    [
        ("salad", ("chicken:diced", "apple:diced", "mayonnaise:creamy")),
        ("soup", ("onion:chopped", "oil:liquid", "stock:liquid", "carrot:sliced")),
        ("omelette", ("egg:uncooked", "mushroom:sliced", "oil:liquid")),
    ],
)
def test_buttered_bread_is_fried_and_laid_on_the_dish_and_nobody_stirs_it_in(steps, dish_type, foods):
    told = steps(dish_type, "", *foods, "bread:sliced", "butter:softened")
    assert {"bread", "butter"} <= inside(told, "flip") - {"egg"}
    laid = max(place for place, (inputs, _, _) in enumerate(told) if "bread" in inputs)
    assert motions(told)[laid] in {"pick-and-place", "pour"}
    assert not any("bread" in inputs and {"stir", "mix"} & {one} for inputs, one, _ in told)


def test_rolls_are_warmed_and_served_with_an_omelette(steps):
    told = steps("omelette", "", "egg:uncooked", "cheddar:grated", "butter:softened", "roll:whole")
    assert "roll" in inside(told, "bake")
    assert "roll" not in inside(told, "melt")


def test_chips_lie_on_a_soup(steps):
    told = steps("soup", "", "beef:ground", "bean:canned", "tomato sauce:sauce", "chip:pieces", "cream:creamy")
    assert motions(told)[-1] == "pour"
    assert "chip" in told[-1][0]
    assert not any("melted" in node.states for _, _, outputs in told for node in outputs if node.label == "chip")


def test_bread_and_cheese_at_the_end_of_a_soup_are_toasted_together(steps):
    told = steps(
        "soup", "", "onion:chopped", "oil:liquid", "squash:peeled", "stock:liquid", "baguette:whole", "cheese:grated"
    )
    assert inside(told, "bake") == {"baguette", "cheese"}


def test_crumbs_on_sweet_noodles_are_mixed_with_fat_and_baked_on_them(steps):
    custard = ("noodle:uncooked", "egg:uncooked", "sugar:granulated", "vanilla:liquid", "margarine:creamy")
    told = steps("noodle", "", *custard, "margarine:juice", "corn:crumbs", "brown sugar:granulated")
    (mixed,) = [inputs for inputs, one, _ in told if one == "mix" and "corn" in inputs]
    assert {"corn", "margarine", "brown sugar"} <= mixed
    assert "noodle" in inside(told, "bake")


def test_cubes_of_bread_and_the_oil_behind_them_are_croutons_and_the_second_oil_is_the_dressing(steps):
    asked = ("spinach:leaves", "bread:cubed", "oil:liquid", "garlic:minced", "oil:liquid", "vinegar:liquid")
    told = steps("salad", "", *asked)
    assert inside(told, "flip") == {"bread", "oil", "garlic"}
    dressed = next(out for _, one, out in told if one == "mix" and "vinegar" in out[0].ingredients)
    assert set(dressed[0].ingredients) == {"oil", "vinegar"}


def test_nuts_of_a_salad_are_browned_in_the_butter_listed_beside_them(steps):
    nuts = ("butter:softened", "sugar:ground", "walnut:chopped")
    told = steps("salad", "", *nuts, "vinegar:liquid", "oil:liquid", "mixed green:leaves")
    assert inside(told, "cook and stir") == {"butter", "sugar", "walnut"}
    dressed = next(out for _, one, out in told if one == "mix" and "vinegar" in out[0].ingredients)
    assert set(dressed[0].ingredients) == {"oil", "vinegar"}


@pytest.mark.parametrize("dish_type", ["rice", "noodle"])
def test_crumbs_on_what_comes_out_of_a_pot_are_browned_first(steps, dish_type):
    asked = ("rice:uncooked" if dish_type == "rice" else "spaghetti:uncooked", "oil:liquid", "onion:chopped")
    told = steps(dish_type, "", *asked, "stock:liquid", "breadcrumb:crumbs")
    (browned,) = [out for foods, one, out in told if one == "cook and stir" and "breadcrumb" in foods]
    assert set(browned[0].ingredients) <= {"breadcrumb", "oil"}
    assert "breadcrumb" in told[-1][0]


def test_egg_of_a_sweet_sauce_is_whisked_in_while_it_is_cold(steps):
    pudding = ("bread:whole", "milk:liquid", "egg:uncooked", "sugar:ground", "butter:creamy")
    told = steps("bread", "", *pudding, "butter:creamy", "sugar:ground", "egg yolk:uncooked", "whisky:liquid")
    (whisked,) = [place for place, (foods, one, _) in enumerate(told) if one == "whisk" and "egg yolk" in foods]
    assert whisked < motions(told).index("cook and stir")
    assert inside(told, "cook and stir") == {"butter", "sugar", "egg yolk", "whisky"}


@pytest.mark.parametrize("asked", [("quinoa:grain", "water:liquid"), ("water:liquid", "salt:granulated", "rice:grain")])
def test_grain_of_a_salad_takes_up_the_water_that_is_listed_beside_it(steps, asked):
    told = steps("salad", "", *asked, "cucumber:diced", "oil:liquid", "lemon juice:liquid")
    assert inside(told, "simmer") == {food.split(":")[0] for food in asked}
    assert "strainer" not in {label for foods, _, _ in told for label in foods}
    assert motions(told).index("cool down") > motions(told).index("simmer")


def test_other_water_of_a_salad_is_in_its_dressing(steps):
    told = steps("salad", "", "oil:liquid", "vinegar:liquid", "water:liquid", "honey:thick liquid", "lettuce:chopped")
    assert inside(told, "mix") == {"oil", "vinegar", "water", "honey"}


def test_stock_starch_and_soy_sauce_behind_an_omelette_are_the_sauce_that_is_poured_over_it(steps):
    filling = ("egg:uncooked", "shrimp:peeled", "scallion:chopped", "oil:liquid")
    told = steps("omelette", "", *filling, "broth:liquid", "soy sauce:liquid", "cornstarch:powder")
    assert "soy sauce" not in inside(told, "whisk")
    (sauce,) = [place for place, (foods, one, _) in enumerate(told) if one == "cook and stir" and "soy sauce" in foods]
    poured = max(place for place, (foods, _, _) in enumerate(told) if "soy sauce" in foods)
    assert sauce < motions(told).index("fold") < poured


def test_soy_sauce_and_water_alone_are_beaten_into_the_eggs(steps):
    told = steps("omelette", "", "egg:uncooked", "ham:diced", "oil:liquid", "soy sauce:liquid", "water:liquid")
    mixed = [set(out[0].ingredients) for _, one, out in told if one in {"beat", "mix", "stir"}]
    assert any({"egg", "soy sauce"} <= foods for foods in mixed)
    assert not any("saucepan" in foods for foods, _, _ in told)
