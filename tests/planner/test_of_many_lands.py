"""Families of Latin America, Asia, Australia and the Middle East: what is ground, kept raw, filled or browned apart."""

from __future__ import annotations

import pytest
from planner.told_steps import inside, motions

pytestmark = pytest.mark.shared_data


def test_dried_chillies_are_soaked_and_ground_before_the_flesh_is_stewed_in_them(steps):
    told = steps("pork", "Pozole Rojo", "pork shoulder:cut", "guajillo chiles:seeded", "ancho chiles:seeded",
                 "garlic:clove", "onion:whole", "oregano:dried", "chicken stock:liquid", "hominy:drained",
                 "radishes:sliced")  # fmt: skip
    assert motions(told).index("boil") < motions(told).index("blend") < motions(told).index("simmer")
    assert inside(told, "blend") >= {"guajillo chiles", "ancho chiles", "garlic"}
    assert "pork shoulder" not in inside(told, "blend")


def test_tortillas_are_rolled_and_lie_under_a_sauce_of_chillies(steps):
    told = steps("casserole", "Enchiladas Rojas", "corn tortillas:plain", "cooked chicken:shredded",
                 "guajillo chiles:seeded", "garlic:clove", "chicken broth:liquid", "queso fresco:crumbled",
                 "Mexican crema:creamy")  # fmt: skip
    assert "roll" in motions(told)
    assert "guajillo chiles" not in inside(told, "roll")
    assert "Mexican crema" not in inside(told, "bake")


def test_what_is_called_a_fillet_of_meat_is_no_fish(steps):
    told = steps("pork", "Sweet and Sour Pork", "pork fillet:cut", "egg:beaten", "cornflour:powder",
                 "vegetable oil:liquid", "green pepper:cut", "onion:cut", "rice vinegar:liquid",
                 "caster sugar:granulated",
                 "tomato ketchup:sauce", "soy sauce:liquid")  # fmt: skip
    assert inside(told, "stir") >= {"rice vinegar", "tomato ketchup"}
    assert "fold" not in motions(told)


def test_a_sauce_of_fish_sauce_and_lime_is_not_cooked_around_balls(steps):
    told = steps("meatball", "Bun Cha", "pork mince:raw", "garlic:crushed", "shallots:finely chopped",
                 "rice vermicelli:uncooked", "fish sauce:sauce:sauce", "lime juice:juice:sauce",
                 "sugar:granulated:sauce", "mint leaves:leaf:serving")  # fmt: skip
    assert "lime juice" in inside(told, "stir")
    assert "simmer" not in motions(told)


def test_raw_rice_that_is_listed_with_the_meat_cooks_in_the_balls(steps):
    told = steps("meatball", "Albondigas", "beef mince:uncooked", "long-grain rice:uncooked", "egg:uncooked",
                 "onion:chopped:sauce", "tomatoes:canned:sauce", "chicken stock:liquid:sauce")  # fmt: skip
    assert "long-grain rice" in inside(told, "mix")


def test_balls_of_pulses_come_into_bread_and_no_bread_into_the_balls(steps):
    told = steps("sandwich", "Falafel Pittas", "chickpeas:soaked", "onion:chopped", "parsley:chopped", "cumin:ground",
                 "sunflower oil:liquid:frying", "pitta breads:loaf", "tahini:mixed", "tomatoes:chopped")  # fmt: skip
    assert inside(told, "blend") >= {"chickpeas", "onion"}
    assert inside(told, "blend").isdisjoint({"pitta breads", "tahini", "tomatoes"})


def test_a_filling_between_biscuits_is_not_in_their_dough(steps):
    told = steps("cookie", "Melting Moments", "butter:softened", "icing sugar mixture:powder", "flour:plain",
                 "custard powder:powder", "butter:softened:filling", "icing sugar mixture:powder:filling",
                 "passionfruit pulp:whole:filling")  # fmt: skip
    assert "passionfruit pulp" in inside(told, "blend")
    assert "passionfruit pulp" not in inside(told, "bake")
    assert motions(told).index("bake") < motions(told).index("blend")


def test_a_cutlet_in_crumbs_is_browned_under_its_sauce_and_cheese(steps):
    told = steps("steak", "Milanesa a la Napolitana", "beef steaks:uncooked", "eggs:beaten", "garlic:crushed",
                 "breadcrumbs:dry", "vegetable oil:liquid:frying", "tomato sauce:sauce",
                 "mozzarella:sliced")  # fmt: skip
    assert inside(told, "bake") >= {"mozzarella", "tomato sauce"}
    assert any("garlic" in node.ingredients for _, motion, outputs in told if motion == "dip" for node in outputs)


def test_a_whole_bird_in_yogurt_is_roasted(steps):
    told = steps("roast", "Tandoori Roast Chicken", "chicken:whole", "Greek-style yogurt:creamy", "garlic:crushed",
                 "garam masala:ground", "turmeric:ground", "lemon:juice", "vegetable oil:liquid",
                 "red onions:sliced")  # fmt: skip
    assert inside(told, "bake") >= {"chicken", "Greek-style yogurt"}
    assert "cook and stir" not in motions(told)


def test_whole_spices_of_a_crust_are_ground_and_squid_is_cut(steps):
    told = steps("seafood", "Salt and Pepper Squid", "squid hoods:cleaned", "sea salt flakes:granulated",
                 "Sichuan peppercorns:whole", "cornflour:powder", "vegetable oil:liquid",
                 "lemon wedges:whole:serving")  # fmt: skip
    assert any("Sichuan peppercorns" in inputs and motion == "grind" for inputs, motion, _ in told)


def test_patties_called_katsu_are_turned_in_crumbs(steps):
    told = steps("burger", "Prawn Katsu Burger", "prawns:deveined", "egg white:uncooked", "potato starch:powder",
                 "flour:plain", "egg:beaten", "panko breadcrumbs:crumbs", "vegetable oil:liquid:frying",
                 "brioche buns:whole", "cabbage:shredded")  # fmt: skip
    assert inside(told, "mash").isdisjoint({"panko breadcrumbs", "flour"})
    assert motions(told).count("dip") == 3


def test_balls_of_dough_are_soaked_in_syrup_or_simmered_in_it(steps):
    told = steps("pudding", "Gulab Jamun", "milk powder:powder", "flour:plain", "baking powder:powder", "ghee:melted",
                 "milk:warm", "vegetable oil:liquid", "caster sugar:granulated:syrup",
                 "water:liquid:syrup")  # fmt: skip
    assert motions(told).index("shape") < motions(told).index("flip") < motions(told).index("soak")
    told = steps("pudding", "Golden Syrup Dumplings", "self-raising flour:powder", "butter:chopped", "egg:beaten",
                 "milk:liquid", "water:liquid:syrup", "golden syrup:thick liquid:syrup")  # fmt: skip
    assert "bake" not in motions(told)
    assert inside(told, "simmer") >= {"self-raising flour", "golden syrup"}


def test_nuts_of_a_paste_or_sauce_are_ground(steps):
    told = steps("beef", "Beef Suya", "beef sirloin:sliced", "peanuts:roasted", "cayenne pepper:ground",
                 "ginger:ground", "vegetable oil:liquid", "red onion:sliced:serving")  # fmt: skip
    assert inside(told, "blend") >= {"peanuts", "cayenne pepper"}
    told = steps("salad", "Gado-Gado", "potatoes:boiled", "green beans:trimmed", "hard-boiled eggs:halved",
                 "peanuts:roasted:sauce", "red chillies:whole:sauce", "coconut milk:liquid:sauce")  # fmt: skip
    assert inside(told, "blend") == {"peanuts", "red chillies"}


def test_flesh_that_is_poached_is_not_baked_in_its_sauce(steps):
    told = steps("chicken", "Saliva Chicken", "chicken breasts:raw", "ginger:whole", "chilli oil:liquid",
                 "soy sauce:liquid", "black vinegar:liquid", "garlic:minced", "peanuts:chopped")  # fmt: skip
    assert inside(told, "boil") >= {"chicken breasts"}
    assert "chilli oil" in inside(told, "stir")
    assert "bake" not in motions(told)


def test_meal_is_stirred_smooth_before_a_drink_is_cooked(steps):
    told = steps("drinks", "Champurrado", "masa harina:powder", "milk:liquid", "water:liquid",
                 "Mexican chocolate:chopped", "piloncillo:granulated", "cinnamon stick:whole")  # fmt: skip
    assert "masa harina" in inside(told, "beat")
    assert "cook and stir" in motions(told)


def test_long_bread_is_filled_with_marinated_flesh_and_soured_roots(steps):
    told = steps("sandwich", "Banh Mi", "pork shoulder:sliced", "garlic:minced", "fish sauce:sauce", "oil:liquid",
                 "baguettes:loaf", "carrots:julienned", "rice vinegar:liquid", "mayonnaise:creamy")  # fmt: skip
    assert "mayonnaise" not in inside(told, "stir")
    assert any({"carrots", "rice vinegar"} <= set(node.ingredients) and "baguettes" not in node.ingredients
               for _, motion, outputs in told if motion == "stir" for node in outputs)  # fmt: skip


def test_pitta_is_flat(steps):
    told = steps("bread", "Pitta Bread", "strong white flour:powder", "yeast:powder", "salt:granulated",
                 "olive oil:liquid", "water:warm")  # fmt: skip
    assert not any(node.label == "loaf pan" for _, _, outputs in told for node in outputs)


def test_roots_are_ground_with_the_eggs_where_the_cake_is_called_so(steps):
    told = steps("cake", "Bolo de Cenoura", "carrots:chopped", "eggs:uncooked", "vegetable oil:liquid",
                 "sugar:granulated", "flour:powder", "baking powder:powder")  # fmt: skip
    assert inside(told, "blend") >= {"carrots", "eggs"}


def test_minced_meat_is_fried_with_its_onions_before_dough_is_closed_around_it(steps):
    told = steps("pie", "Beef Empanadas", "flour:powder:dough", "lard:creamy:dough", "water:warm:dough",
                 "ground beef:uncooked:filling", "onions:finely chopped:filling", "olive oil:liquid:filling",
                 "cumin:ground:filling", "hard-boiled eggs:chopped:filling")  # fmt: skip
    assert inside(told, "cook and stir") >= {"ground beef", "onions"}
    assert "hard-boiled eggs" not in inside(told, "cook and stir")


def test_no_stone_is_taken_out_of_stuffed_olives(steps):
    told = steps("beef", "Picadillo", "ground beef:uncooked", "onion:chopped", "olive oil:liquid",
                 "tomato sauce:sauce", "pimento-stuffed green olives:halved")  # fmt: skip
    assert not any("pimento-stuffed green olives" in inputs and motion == "core" for inputs, motion, _ in told)


def test_cream_that_is_whipped_is_not_melted_with_chocolate(steps):
    told = steps("cake", "", "flour:ground", "sugar:ground", "cocoa:ground", "baking soda:ground", "oil:juice",
                 "egg:whole", "cream:whipped", "chocolate:grated")  # fmt: skip
    assert not any("cream" in node.ingredients for _, motion, outputs in told if motion == "cook and stir"
                   for node in outputs)  # fmt: skip
