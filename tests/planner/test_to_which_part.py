"""Each food joins the part of its dish that it is for: rub, glaze, crust or sauce; and bread closes a sandwich."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions, taking

pytestmark = pytest.mark.shared_data


def wholes(told, motion):
    """Return the foods of each thing that comes of such a motion."""
    return [set(node.ingredients) for _, one, outputs in told if one == motion for node in outputs]


def test_the_other_half_of_a_roll_closes_it_and_is_not_folded(steps):
    told = steps("sandwich", "Pulled Pork Sandwiches", "pork shoulder:raw", "barbecue sauce:sauce", "onion:sliced",
                 "water:liquid", "brioche buns:halved", "coleslaw:shredded")  # fmt: skip
    assert "fold" not in motions(told)
    laid = [place for place, (inputs, _, _) in enumerate(told) if "brioche buns" in inputs]
    assert len(laid) > 1
    assert laid[-1] == len(told) - 1  # the upper half comes last


def test_a_flat_bread_is_folded_around_what_is_in_it(steps):
    told = steps("sandwich", "Breakfast Tacos", "eggs:uncooked", "butter:unmelted", "flour tortillas:plain",
                 "cheddar cheese:shredded")  # fmt: skip
    assert "fold" in motions(told)


def test_what_is_turned_in_egg_and_crumbs_for_a_sandwich_is_fried_and_the_egg_not_boiled(steps):
    told = steps("sandwich", "", "roll:halved", "eggplant:sliced", "egg:beaten", "crumb:ground",
                 "marinara sauce:thick sauce", "provolone:sliced", "oil:juice")  # fmt: skip
    assert motions(told).count("dip") == 2  # in the egg, in the crumbs
    assert "boil" not in motions(told)
    assert {"provolone", "marinara sauce"}.isdisjoint(inside(told, "cook"))


def test_a_cobbler_is_a_dough_on_a_stew(steps):
    told = steps("beef", "Beef Cobbler", "minced beef:uncooked", "onion:chopped", "carrots:diced", "beef stock:liquid",
                 "self-raising flour:powder:cobbler", "butter:cubed:cobbler", "milk:liquid:cobbler")  # fmt: skip
    assert inside(told, "shape") == {"self-raising flour", "butter", "milk"}
    assert motions(told).index("simmer") < motions(told).index("bake")
    assert all("self-raising flour" not in foods for foods in wholes(told, "simmer"))


def test_sugar_and_whites_under_a_heading_are_whisked_and_baked_on_a_pie(steps):
    told = steps("pie", "Sour Cream Raisin Pie", "pie shell:baked", "raisins:whole", "sour cream:creamy",
                 "egg yolks:uncooked", "sugar:granulated", "cornstarch:powder",
                 "egg whites:uncooked:meringue", "caster sugar:granulated:meringue")  # fmt: skip
    whisked = [set(outputs[0].ingredients) for _, motion, outputs in told if motion == "whisk"]
    assert {"egg whites", "caster sugar"} in whisked
    assert "egg whites" not in inside(told, "cook and stir")
    assert motions(told).count("bake") == 2


def test_fresh_cheese_and_milk_of_a_glaze_are_beaten_by_themselves(steps):
    told = steps("cake", "Pumpkin Cake with Cream Cheese Glaze", "flour:powder", "sugar:granulated",
                 "baking soda:powder", "eggs:beaten", "canola oil:liquid", "pumpkin puree:thick sauce",
                 "cream cheese:softened:glaze", "powdered sugar:sifted:glaze", "milk:liquid:glaze")  # fmt: skip
    glaze = {"cream cheese", "powdered sugar", "milk"}
    assert glaze in wholes(told, "blend")
    assert all(foods <= glaze or foods.isdisjoint(glaze) for foods in wholes(told, "mix"))


def test_a_dry_rub_comes_on_the_joint_and_not_on_what_is_roasted_around_it(steps):
    told = steps("roast", "Coffee-Rubbed Venison Roast", "venison roast:raw", "coffee:ground", "brown sugar:granulated",
                 "paprika:smoked", "salt:granulated", "carrots:cut", "onion:cut", "beef broth:liquid")  # fmt: skip
    assert inside(told, "mix") == {"coffee", "brown sugar", "paprika", "salt"}
    assert "brush" not in motions(told)
    rubbed = next(place for place, (inputs, _, _) in enumerate(told) if {"mixture", "baking dish"} <= inputs)
    laid = next(place for place, (inputs, _, _) in enumerate(told) if {"carrots", "baking dish"} <= inputs)
    assert rubbed < laid


def test_gammon_is_roasted_in_its_cider_and_then_under_its_glaze(steps):
    told = steps("roast", "Cider-Roast Gammon", "gammon joint:smoked", "cider:dry", "onion:halved",
                 "demerara sugar:granulated", "mustard:creamy", "apples:cut")  # fmt: skip
    assert inside(told, "stir") == {"demerara sugar", "mustard"}
    assert motions(told).count("bake") == 2
    glazed = next(place for place, (inputs, _, _) in enumerate(told) if {"mixture", "baking dish"} <= inputs)
    assert motions(told).index("bake") < glazed


def test_a_butter_that_a_title_names_is_mixed_and_lies_on_what_is_fried(steps):
    told = steps("steak", "Bavette with Anchovy Butter", "bavette steaks:raw", "groundnut oil:liquid",
                 "butter:unmelted", "anchovies:chopped", "garlic:crushed", "lemon juice:juice")  # fmt: skip
    assert inside(told, "mix") == {"butter", "anchovies", "garlic", "lemon juice"}
    assert {"butter", "anchovies"}.isdisjoint(taking(told, "cook") | inside(told, "cook"))


def test_pulses_for_a_loaf_are_cooked_in_the_stock_that_is_listed_behind_them(steps):
    told = steps("meatloaf", "Lentil Nut Roast Loaf", "red lentils:dried", "vegetable stock:liquid", "oil:liquid",
                 "onion:chopped", "mushrooms:chopped", "cashews:ground", "crumbs:ground", "egg:beaten")  # fmt: skip
    assert inside(told, "simmer") == {"red lentils", "vegetable stock"}
    assert "drain" not in motions(told)


def test_soured_milk_behind_what_seasons_balls_is_their_sauce(steps):
    told = steps("meatball", "", "turkey:ground", "onion:minced", "cumin:ground", "egg:whole raw", "oil:juice",
                 "salt:ground", "pepper:ground", "yogurt:creamy", "sumac:ground")  # fmt: skip
    assert inside(told, "stir") == {"yogurt", "sumac"}
    assert "yogurt" not in inside(told, "mix")


def test_short_dough_under_its_heading_is_kneaded_and_what_fills_it_cooked_first(steps):
    told = steps("pie", "Homity Pie", "flour:powder:pastry", "butter:diced:pastry", "water:cold:pastry",
                 "potatoes:cubed:filling", "onions:chopped:filling", "oil:liquid:filling",
                 "cheddar:grated:filling", "double cream:creamy:filling")  # fmt: skip
    assert inside(told, "knead") == {"flour", "butter", "water"}
    assert first(told, "potatoes", "boil") < motions(told).index("bake")
    assert "onions" in inside(told, "cook and stir")


def test_an_egg_beside_fruit_and_dough_is_brushed_on_an_upper_crust(steps):
    told = steps("pie", "Cherry Pie", "pie crust:dough", "cherries:pitted", "sugar:granulated", "cornstarch:powder",
                 "butter:unmelted", "egg:beaten")  # fmt: skip
    assert "egg" not in inside(told, "mix")
    assert sum("pie crust" in inputs and "packet" in inputs for inputs, _, _ in told) == 2
    assert motions(told).index("mix") < motions(told).index("brush") < motions(told).index("bake")


def test_flesh_in_a_white_sauce_lies_under_its_pastry(steps):
    told = steps("pie", "", "turkey:cooked", "leek:sliced", "mushroom:quartered", "butter:creamy", "flour:ground",
                 "milk:juice", "pastry:thawed", "egg:beaten")  # fmt: skip
    assert {"flour", "milk"} <= taking(told, "cook and stir")
    assert "egg" not in taking(told, "cook and stir")
    assert motions(told).index("cook and stir") < motions(told).index("brush") < motions(told).index("bake")


def test_what_was_fried_comes_onto_the_lower_half_of_a_bun(steps):
    told = steps("burger", "Beetroot Burgers", "chickpeas:rinsed", "beetroot:grated", "breadcrumbs:crumbs",
                 "cumin:ground", "egg:uncooked", "oil:liquid:frying", "buns:whole", "rocket:leaves",
                 "tzatziki:creamy")  # fmt: skip
    below = first(told, "buns", "pick-and-place")
    assert "plate" in told[below][0]
    on_it = {food for node in told[below][2] for food in node.ingredients if node.label == "plate"}
    assert on_it <= {"buns"}


def test_sparkling_water_among_what_seasons_minced_meat_is_in_the_patties(steps):
    told = steps("burger", "Pljeskavica", "ground beef:uncooked", "onion:finely chopped", "paprika:ground",
                 "sparkling water:liquid", "salt:granulated", "flatbreads:plain", "kajmak:creamy")  # fmt: skip
    assert {"ground beef", "sparkling water", "salt"} <= inside(told, "mix")


def test_a_sandwich_is_closed_before_it_is_dipped_in_egg(steps):
    told = steps("sandwich", "Monte Cristo", "bread:loaf", "ham:sliced", "gruyere:sliced", "eggs:uncooked",
                 "milk:liquid", "butter:unmelted")  # fmt: skip
    dipped = motions(told).index("dip")
    assert "sandwich" in told[dipped][0]
    assert {"ham", "gruyere"}.isdisjoint(told[dipped][0])


def test_what_fills_a_flat_bread_is_made_part_by_part(steps):
    told = steps("sandwich", "Sabich", "aubergine:sliced", "oil:liquid:frying", "pita breads:plain",
                 "hard-boiled eggs:sliced", "tahini:creamy", "lemon juice:juice", "tomatoes:diced", "cucumber:diced",
                 "hummus:creamy")  # fmt: skip
    stirred = wholes(told, "stir")
    assert {"tomatoes", "cucumber"} in stirred
    assert {"tahini", "lemon juice"} in stirred
    assert "fold" in motions(told)


def test_flour_and_fat_of_a_sauce_stay_out_of_the_pastry_that_covers_it(steps):
    told = steps("pie", "Chicken and Leek Pie", "flour:powder:pastry", "butter:cubed:pastry", "water:cold:pastry",
                 "chicken breasts:diced:filling", "leeks:sliced:filling", "butter:unmelted:filling",
                 "flour:powder:filling", "milk:liquid:filling", "egg:beaten")  # fmt: skip
    assert inside(told, "knead") == {"flour", "butter", "water"}
    made = {frozenset(node.ingredients) for _, _, outputs in told for node in outputs if node.label == "filling"}
    assert made == {frozenset({"chicken breasts", "leeks", "butter", "flour", "milk"})}
    assert inside(told, "brush") >= {"egg"}


def test_pastry_that_ends_in_its_water_is_told_from_what_it_covers(steps):
    told = steps("pie", "Corned Beef Plate Pie", "flour:powder", "lard:creamy", "water:cold", "corned beef:canned",
                 "potatoes:diced", "onion:chopped", "beef stock cube:granulated", "egg:beaten")  # fmt: skip
    assert inside(told, "knead") == {"flour", "lard", "water"}
    made = {frozenset(node.ingredients) for _, _, outputs in told for node in outputs if node.label == "filling"}
    assert made == {frozenset({"corned beef", "potatoes", "onion", "beef stock cube", "lard"})}


def test_flour_egg_and_crumbs_listed_after_balls_coat_them_one_after_the_other(steps):
    told = steps("meatball", "", "cooked ham:minced", "cheddar:grated", "potato:mashed", "egg yolk:uncooked",
                 "flour:powder", "egg:beaten", "breadcrumbs:crumbs", "oil:liquid")  # fmt: skip
    assert motions(told).count("dip") == 3
    assert inside(told, "shape") == {"cooked ham", "cheddar", "potato", "egg yolk"}


def test_whole_eggs_lie_in_a_loaf_and_its_wine_is_baked_with_it(steps):
    told = steps("meatloaf", "Stefani Roll", "minced meat:raw", "onion:grated", "egg:raw", "eggs:boiled:filling",
                 "gherkins:whole:filling", "white wine:liquid:topping")  # fmt: skip
    assert inside(told, "mix") == {"minced meat", "onion", "egg"}
    assert inside(told, "bake") >= {"white wine", "gherkins"}


def test_baps_are_filled_and_no_part_of_the_mince(steps):
    told = steps("burger", "Pork Burgers", "pork mince:raw", "onion:chopped", "soft baps:split",
                 "lettuce leaves:leaves")  # fmt: skip
    assert inside(told, "shape") == {"pork mince", "onion"}
    assert "lettuce leaves" not in inside(told, "cook")


@pytest.mark.parametrize(
    ("title", "beside"),
    [
        ("Pork Chops with Glazed Apples", ["apples:sliced", "butter:unmelted", "brown sugar:granulated"]),
        ("Pork Chops with Creamed Spinach", ["spinach:leaves", "butter:unmelted", "flour:powder", "milk:liquid"]),
        ("Pork Chops and Scalloped Corn", ["canned corn:canned", "egg:beaten", "soft bread crumbs:crumbs"]),
        ("Pork Chops with Cucumber Salad", ["cucumber:sliced", "vinegar:liquid", "sugar:granulated"]),
    ],
)
def test_what_a_title_says_is_beside_flesh_is_made_by_itself(steps, title, beside):
    told = steps("pork", title, "pork chops:raw", "oil:liquid", *beside)
    foods = {one.split(":")[0] for one in beside}
    cooked = [node for _, one, outputs in told if one in {"cook", "bake"} for node in outputs]
    assert all(foods.isdisjoint(node.ingredients) for node in cooked if "pork chops" in node.ingredients)
    assert foods < {food for node in told[-1][2] for food in node.ingredients}


def test_a_beaten_white_at_the_end_of_a_list_is_brushed_on_before_what_is_strewn(steps):
    told = steps("bread", "Oatmeal Bread", "yeast:powder", "water:warm", "bread flour:powder", "salt:granulated",
                 "egg white:beaten", "oats:uncooked:tops")  # fmt: skip
    assert "egg white" not in inside(told, "knead")
    assert first(told, "oats", "pour") > motions(told).index("brush")


def test_dried_limes_and_herbs_cook_with_a_stew(steps):
    told = steps("beef", "", "stewing beef:cut", "onion:chopped", "limes:dried", "oregano:dried", "oil:liquid",
                 "beef stock:liquid")  # fmt: skip
    assert inside(told, "simmer") >= {"limes", "oregano"}


def test_nuts_for_the_top_come_on_cookies_after_their_syrup(steps):
    told = steps("cookie", "Melomakarona", "olive oil:liquid", "orange juice:juice", "sugar:granulated", "flour:powder",
                 "baking soda:powder", "sugar:granulated:syrup", "water:liquid:syrup", "honey:thick liquid:syrup",
                 "walnuts:chopped:topping")  # fmt: skip
    assert "walnuts" not in inside(told, "bake")
    assert first(told, "walnuts", "pour") == len(told) - 1


def test_soup_and_sugar_listed_after_a_loaf_of_meat_glaze_it(steps):
    told = steps("meatloaf", "", "ham:ground", "pork:ground", "graham cracker:crumbs", "egg:beaten", "milk:liquid",
                 "tomato soup:canned", "vinegar:liquid", "brown sugar:granulated")  # fmt: skip
    assert inside(told, "mix") == {"ham", "pork", "graham cracker", "egg", "milk"}
    assert inside(told, "bake") >= {"tomato soup", "vinegar", "brown sugar"}


def test_nut_butter_is_stirred_into_the_sauce_though_nuts_close_the_list(steps):
    told = steps("stir-fry", "Tofu with Peanut Sauce", "firm tofu:cubed", "oil:liquid", "broccoli:cut",
                 "peanut butter:creamy", "soy sauce:liquid", "brown sugar:granulated", "water:liquid",
                 "peanuts:chopped")  # fmt: skip
    assert inside(told, "stir") == {"peanut butter", "soy sauce", "brown sugar", "water"}


def test_balls_under_a_heading_for_their_sauce_are_poached_in_it(steps):
    told = steps("meatball", "Königsberger Klopse", "minced veal:raw", "roll:soaked", "egg:uncooked",
                 "beef stock:liquid", "butter:unmelted:sauce", "flour:powder:sauce", "cream:creamy:sauce",
                 "egg yolk:uncooked:sauce")  # fmt: skip
    assert inside(told, "shape") == {"minced veal", "roll", "egg"}
    assert inside(told, "whisk") == {"egg yolk", "cream"}


def test_fried_onions_of_a_title_come_between_the_halves_of_a_roll(steps):
    told = steps("burger", "Burgers with Caramelised Onions on Barm Cakes", "beef mince:uncooked", "onions:sliced",
                 "butter:unmelted", "sugar:granulated", "barm cakes:whole", "cheddar:sliced")  # fmt: skip
    assert inside(told, "shape") == {"beef mince"}
    assert taking(told, "cook and stir") >= {"onions", "butter", "sugar"}
    assert "barm cakes" in told[-1][0]


def test_the_flour_of_a_coating_stays_out_of_the_sauce_that_is_shaped(steps):
    told = steps("meatball", "Bitterballen", "cooked beef:shredded", "butter:unmelted", "flour:powder",
                 "beef stock:liquid", "flour:powder", "eggs:beaten", "breadcrumbs:crumbs", "oil:liquid")  # fmt: skip
    assert motions(told).count("dip") == 3
