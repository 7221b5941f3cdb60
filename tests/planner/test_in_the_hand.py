"""What is eaten on bread, in it or rolled into it, and what is shaped of flesh, is made as such dishes are."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def heated_with(told, food):
    """Return what is in the same vessel as a food when something hot is done to it."""
    hot = {"cook", "cook and stir", "simmer", "boil", "bake"}
    nodes = [node for _, motion, outputs in told if motion in hot for node in outputs]
    return {other for node in nodes if food in node.ingredients for other in node.ingredients}


def test_bread_is_toasted_before_what_is_raw_lies_on_it(steps):
    told = steps("sandwich", "Tomato Bruschetta", "plum tomatoes:diced", "garlic:minced", "olive oil:liquid",
                 "basil leaves:chopped", "baguette:sliced")  # fmt: skip
    assert motions(told).index("bake") < motions(told).index("stir")
    assert "plum tomatoes" not in heated_with(told, "baguette")


def test_flat_bread_is_not_fried_with_what_is_rolled_into_it(steps):
    told = steps("sandwich", "Beef Burritos", "ground beef:uncooked", "onion:chopped", "rice:uncooked",
                 "flour tortillas:plain", "cheddar cheese:shredded", "salsa:sauce")  # fmt: skip
    assert "flour tortillas" not in heated_with(told, "ground beef")
    assert "roll" in motions(told)


def test_eggs_for_a_burrito_are_scrambled(steps):
    told = steps("sandwich", "Breakfast Burritos", "eggs:uncooked", "milk:liquid", "butter:unmelted",
                 "breakfast sausage:raw", "flour tortillas:plain", "salsa:sauce")  # fmt: skip
    assert inside(told, "beat") >= {"eggs", "milk"}
    assert "boil" not in motions(told)


def test_a_sauce_called_by_its_name_is_mixed_by_itself(steps):
    told = steps("burger", "Lamb Burgers", "ground lamb:raw", "cumin:ground", "buns:whole",
                 "yogurt:creamy:sauce", "mint:chopped:sauce", "lemon juice:juice:sauce")  # fmt: skip
    assert inside(told, "stir") == {"yogurt", "mint", "lemon juice"}


def test_chopped_fish_is_shaped_for_a_burger(steps):
    told = steps("burger", "Salmon Burgers", "salmon:chopped", "panko:crumbs", "egg:uncooked", "scallions:chopped",
                 "oil:liquid", "buns:whole")  # fmt: skip
    assert first(told, "salmon", "mash") < motions(told).index("flip")
    assert "buns" not in heated_with(told, "salmon")


def test_rolls_are_baked_for_patties_and_doubled_they_are_no_fried_bread(steps):
    told = steps("burger", "Double Cheeseburgers", "flour:powder", "yeast:powder", "sugar:granulated", "milk:liquid",
                 "oil:liquid", "salt:granulated", "ground beef:uncooked", "cheddar cheese:sliced")  # fmt: skip
    assert inside(told, "knead") >= {"flour", "yeast", "milk"}
    assert motions(told).index("knead") < motions(told).index("bake") < motions(told).index("flip")
    assert not {"flour", "yeast"} & heated_with(told, "ground beef")


def test_what_a_recipe_lists_behind_the_bread_lies_on_patties_and_is_not_in_them(steps):
    told = steps("burger", "Street Burger", "ground beef:uncooked", "onion:minced", "salt:granulated", "buns:whole",
                 "cabbage:shredded", "carrot:grated", "crispy fried onions:crumbs", "ketchup:sauce")  # fmt: skip
    assert inside(told, "mix") == {"ground beef", "onion", "salt"}
    assert not {"cabbage", "carrot", "crispy fried onions"} & heated_with(told, "ground beef")


def test_where_a_raw_egg_stands_behind_the_bread_a_recipe_lists_in_no_order(steps):
    told = steps("burger", "Burgers", "ground beef:uncooked", "buns:whole", "breadcrumbs:crumbs", "egg:uncooked")
    assert inside(told, "mix") == {"ground beef", "breadcrumbs", "egg"}


def test_fish_and_potatoes_are_boiled_and_mashed_for_cakes_in_crumbs(steps):
    told = steps("seafood", "Salmon Fishcakes", "potatoes:peeled", "salmon:raw", "flour:powder", "egg:beaten",
                 "breadcrumbs:crumbs", "oil:liquid")  # fmt: skip
    assert motions(told).index("mash") < motions(told).index("flip")
    assert "breadcrumbs" not in inside(told, "mash")


def test_a_sauce_for_balls_is_cooked_apart_and_pasta_is_no_part_of_it(steps):
    told = steps("meatball", "Spaghetti and Meatballs", "ground beef:uncooked", "breadcrumbs:crumbs", "egg:uncooked",
                 "oil:liquid", "onion:chopped:sauce", "crushed tomatoes:canned:sauce",
                 "spaghetti:uncooked:sauce")  # fmt: skip
    assert inside(told, "mix") == {"ground beef", "breadcrumbs", "egg"}
    assert "spaghetti" not in heated_with(told, "crushed tomatoes")


def test_sausages_lie_rolled_in_bacon_when_they_are_baked(steps):
    told = steps("sausage", "Pigs in Blankets", "cocktail sausages:packaged", "bacon:raw", "honey:thick liquid")
    assert motions(told).index("roll") < motions(told).index("bake")
    assert inside(told, "roll") == {"cocktail sausages", "bacon"}


def test_poached_eggs_lie_on_toast_under_a_sauce_of_yolks(steps):
    told = steps("omelette", "Eggs Benedict", "English muffins:split", "Canadian bacon:raw", "eggs:uncooked",
                 "egg yolks:raw:sauce", "lemon juice:juice:sauce", "butter:melted:sauce")  # fmt: skip
    assert "boil" in motions(told)
    assert "eggs" not in heated_with(told, "egg yolks")
    assert inside(told, "cook and stir") == {"egg yolks", "lemon juice"}
    assert "butter" in heated_with(told, "egg yolks")


def test_eggs_are_opened_into_a_sauce_without_tomatoes_too(steps):
    told = steps("omelette", "Green Shakshuka", "oil:liquid", "leek:sliced", "spinach:leaves", "eggs:uncooked")
    assert "whisk" not in motions(told)


def test_meat_for_a_pizza_is_stewed_and_what_is_fresh_comes_last(steps):
    told = steps("pizza", "Taco Pizza", "pizza dough:whole", "ground beef:uncooked", "taco seasoning:mixed",
                 "cheddar cheese:shredded", "lettuce:shredded", "tomato:chopped")  # fmt: skip
    assert heated_with(told, "taco seasoning") >= {"ground beef"}
    assert not {"lettuce", "tomato"} & heated_with(told, "pizza dough")


def test_eggs_for_a_roll_are_fried_and_not_boiled(steps):
    told = steps("sandwich", "Breakfast Sandwich", "croissants:whole", "eggs:uncooked", "ham:whole", "butter:unmelted")
    assert "boil" not in motions(told)
    assert "croissants" not in heated_with(told, "eggs")


def test_poached_eggs_are_boiled_without_their_shells(steps):
    told = steps("omelette", "Poached Eggs on Toast", "eggs:uncooked", "bread:loaf", "butter:unmelted")
    assert first(told, "eggs", "crack") < motions(told).index("boil")
    assert "peel" not in motions(told)


def test_what_is_sweet_is_folded_into_eggs_of_a_list_without_a_title(steps):
    told = steps("omelette", "", "egg:whole raw", "sugar:ground", "strawberry:sliced", "butter:softened")
    assert inside(told, "whisk") == {"egg", "sugar"}
    assert "fold" in motions(told)


def test_seasoned_eggs_without_a_title_are_rolled_up(steps):
    told = steps("omelette", "", "egg:whole raw", "stock:ground", "sugar:ground", "mirin:juice", "soy sauce:sauce")
    assert "roll" in motions(told)


def test_eggs_and_a_crust_without_a_title_are_baked(steps):
    told = steps("omelette", "", "egg:whole raw", "pie crust:baked", "onion:sliced", "ham:sliced", "butter:softened")
    assert "pie crust" not in inside(told, "whisk")
    assert "bake" in motions(told)


def test_flour_and_milk_are_kneaded_into_what_is_shaped_where_fat_comes_after_them(steps):
    told = steps("meatball", "Frikadeller", "ground pork:raw", "onion:grated", "eggs:uncooked", "flour:powder",
                 "milk:liquid", "butter:unmelted")  # fmt: skip
    assert inside(told, "mix") >= {"flour", "milk", "eggs"}


def test_whole_fish_is_roasted_once_with_what_is_beside_it(steps):
    told = steps("seafood", "Whole Roasted Sea Bream", "sea bream:whole", "fennel:sliced", "lemon:sliced", "oil:liquid")
    assert motions(told).count("bake") == 1
    assert "cook and stir" not in motions(told)


def test_carnitas_are_simmered_and_pulled_apart_before_flat_bread_holds_them(steps):
    told = steps("sandwich", "Carnitas Tacos", "pork shoulder:cubed", "orange:juiced", "onion:quartered",
                 "cumin:ground", "corn tortillas:plain", "cilantro:whole")  # fmt: skip
    assert motions(told).index("simmer") < motions(told).index("pull apart")
    assert "cilantro" not in heated_with(told, "pork shoulder")


def test_a_heading_that_names_a_salsa_keeps_it_raw(steps):
    told = steps("seafood", "Grilled Swordfish with Mango Salsa", "swordfish steaks:raw", "oil:liquid",
                 "mangoes:diced:salsa", "red onion:diced:salsa", "lime juice:juice:salsa")  # fmt: skip
    assert inside(told, "stir") == {"mangoes", "red onion", "lime juice"}


def test_boiled_eggs_come_into_their_sauce_last(steps):
    told = steps("omelette", "Egg Curry", "eggs:boiled", "oil:liquid", "onion:chopped", "tomatoes:chopped",
                 "turmeric:ground", "coconut milk:liquid")  # fmt: skip
    assert first(told, "eggs", "peel") < motions(told).index("simmer")
    assert "eggs" in inside(told[::-1], "simmer")


def test_a_filling_is_closed_in_bought_wrappers_before_they_are_fried(steps):
    told = steps("seafood", "Crab Rangoon", "wonton wrappers:raw", "cream cheese:block", "crabmeat:canned",
                 "oil:liquid")  # fmt: skip
    assert motions(told).index("fold and pinch") < motions(told).index("flip")
    assert inside(told, "fold and pinch") >= {"crabmeat", "cream cheese"}


def test_what_is_sweet_lies_on_a_dough_that_is_baked_before(steps):
    told = steps("pizza", "Chocolate Dessert Pizza", "pizza dough:whole", "Nutella:creamy", "strawberries:sliced")
    assert "strawberries" not in heated_with(told, "pizza dough")


def test_balls_called_baked_come_out_of_the_oven_before_their_sauce(steps):
    told = steps("meatball", "Baked Turkey Meatballs", "ground turkey:raw", "breadcrumbs:crumbs", "egg:uncooked",
                 "marinara sauce:thick liquid")  # fmt: skip
    assert motions(told).index("bake") < motions(told).index("simmer")


def test_leaves_under_the_heading_of_a_sauce_lie_below_it(steps):
    told = steps("seafood", "Shrimp Cocktail", "shrimp:peeled", "ketchup:sauce:sauce", "horseradish:creamy:sauce",
                 "lemon juice:juice:sauce", "lettuce:leaves:sauce")  # fmt: skip
    assert inside(told, "stir") == {"ketchup", "horseradish", "lemon juice"}


def test_a_sauce_that_the_title_names_is_around_what_is_shaped(steps):
    told = steps("meatball", "Teriyaki Meatballs", "ground chicken:raw", "breadcrumbs:crumbs", "egg:uncooked",
                 "teriyaki sauce:sauce")  # fmt: skip
    assert inside(told, "mix") == {"ground chicken", "breadcrumbs", "egg"}


def test_filled_rolls_are_baked_under_what_is_brushed_on_them(steps):
    told = steps("sandwich", "Ham and Cheese Sliders", "rolls:whole", "ham:sliced", "Swiss cheese:block",
                 "butter:melted", "Dijon mustard:creamy", "poppy seeds:seed")  # fmt: skip
    assert heated_with(told, "rolls") >= {"ham", "Swiss cheese"}
    assert inside(told, "stir") >= {"butter", "Dijon mustard"}


def test_herbs_and_oil_under_the_heading_of_a_sauce_are_blended(steps):
    told = steps("seafood", "Sea Bass with Salsa Verde", "sea bass:raw", "salt:granulated", "parsley:leaf:sauce",
                 "capers:whole:sauce", "olive oil:liquid:sauce")  # fmt: skip
    assert inside(told, "blend") == {"parsley", "capers", "olive oil"}


def test_fish_for_flat_bread_is_turned_in_a_batter_where_one_can_be_whisked(steps):
    told = steps("seafood", "Fish Tacos", "cod:cut", "flour:powder", "beer:liquid", "oil:liquid", "tortillas:plain",
                 "cabbage:shredded")  # fmt: skip
    assert any({*node.ingredients} == {"flour", "beer"} for _, _, outputs in told for node in outputs)
    assert motions(told).index("dip") < motions(told).index("flip")


def test_mince_with_nothing_in_it_is_shaped_and_fried_on_both_sides(steps):
    told = steps("burger", "Bacon Cheeseburger", "ground beef:uncooked", "bacon:raw", "cheddar:block", "buns:whole")
    assert motions(told).index("shape") < motions(told).index("flip")


def test_rice_with_ketchup_lies_under_an_omelette_that_is_fried_by_itself(steps):
    told = steps("omelette", "", "egg:whole raw", "rice:baked", "chicken:diced", "ketchup:thick sauce", "butter:creamy",
                 "milk:juice", "salt:ground")  # fmt: skip
    assert inside(told, "whisk") == {"egg", "milk"}
    assert any({"rice", "ketchup"} <= {*node.ingredients} and "egg" not in node.ingredients
               for _, motion, outputs in told if motion == "cook and stir" for node in outputs)  # fmt: skip


@pytest.mark.parametrize(
    ("title", "foods"),
    [
        ("Zapiekanka", ("baguettes:halved", "mushrooms:chopped", "onion:chopped", "butter:unmelted", "gouda:grated",
                        "marjoram:dried", "ketchup:sauce:serving")),
        ("Toast Hawaii", ("white bread:loaf", "butter:unmelted", "ham:processed meat", "pineapple:canned",
                          "gouda:grated")),
        ("French Bread Pizza", ("french bread:halved", "pizza sauce:sauce", "gouda:grated",
                                "pepperoni:processed meat")),
    ],
)  # fmt: skip
def test_cheese_melts_in_the_oven_on_an_open_toast(steps, title, foods):
    told = steps("sandwich", title, *foods)
    assert "gouda" in inside(told, "bake")
    assert "fold" not in motions(told)


def test_onions_for_a_cheesesteak_are_fried_with_the_meat_and_the_cheese_melts_on_it(steps):
    told = steps("sandwich", "Philly Cheesesteak", "ribeye steak:sliced", "onion:diced", "provolone cheese:block",
                 "hoagie rolls:split", "garlic:minced", "mayonnaise:creamy", "oil:liquid")  # fmt: skip
    assert {"onion", "provolone cheese"} <= heated_with(told, "ribeye steak")
    assert "mayonnaise" not in heated_with(told, "ribeye steak")
