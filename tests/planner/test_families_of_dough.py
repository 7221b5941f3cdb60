"""Families of breads, cakes, pies, puddings and drinks: what is made apart, and what joins when."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

FLOUR = ("flour:powder", "eggs:uncooked", "baking powder:powder")


def test_a_food_that_is_asked_coarsely_grated_is_grated(steps):
    told = steps("muffin", "Carrot muffins", *FLOUR, "butter:melted", "carrot:coarsely grated", "cheddar:finely grated")
    assert first(told, "carrot", "grate") < motions(told).index("bake")


def test_yogurt_is_the_same_however_it_is_written(steps):
    asked = (*FLOUR, "sugar:granulated", "oil:liquid")
    one, other = (steps("cake", "Plain cake", *asked, f"{name}:plain") for name in ("yogurt", "yoghurt"))
    assert motions(one) == motions(other)


def test_a_sweet_custard_is_baked_in_one_crust(steps):
    filling = ("sweet potatoes:mashed", "brown sugar:granulated", "eggs:uncooked", "cream:liquid", "nutmeg:ground")
    told = steps("pie", "Sweet potato pie", "pie crust:raw", *filling)
    assert inside(told, "mix") == {"sweet potatoes", "brown sugar", "eggs", "cream", "nutmeg"}
    assert sum("pie crust" in inputs and one != "bake" for inputs, one, _ in told) == 1


def test_whites_under_a_heading_of_their_own_are_folded_into_the_batter(steps):
    yolks = ("egg yolks:uncooked", "sugar:granulated", "oil:liquid", "orange juice:liquid", "flour:powder")
    told = steps("cake", "Orange chiffon cake", *yolks, "egg whites:uncooked:meringue", "sugar:granulated:meringue")
    whole = {"egg yolks", "sugar", "oil", "orange juice", "flour", "egg whites"}
    folded = [set(outputs[0].ingredients) for _, one, outputs in told if one == "fold"]
    assert folded[-1] == whole


def test_syrup_is_melted_with_the_butter_of_a_ginger_cake(steps):
    asked = ("butter:unmelted", "treacle:thick liquid", "brown sugar:granulated", "milk:liquid", "ginger:ground")
    told = steps("cake", "Sticky gingerbread", *FLOUR, *asked)
    assert inside(told, "cook and stir") == {"butter", "treacle", "brown sugar"}
    assert first(told, "flour", "pour") < motions(told).index("bake")
    assert motions(told)[-1] != "pour"


def test_dried_fruit_is_soaked_before_it_comes_to_a_batter(steps):
    asked = ("raisins:dried", "tea:hot", "brown sugar:granulated", "flour:powder", "egg:uncooked")
    told = steps("bread", "Tea bread", *asked)
    assert inside(told, "stir") == {"raisins", "tea"}


def test_what_is_served_with_a_cake_comes_when_that_is_out_of_its_tin(steps):
    asked = ("butter:softened", "sugar:granulated", "cocoa:powder", "whipped cream:creamy:serving")
    told = steps("cake", "Chocolate cake", *FLOUR, *asked)
    out = next(place for place, (inputs, _, _) in enumerate(told) if {"cake", "plate"} <= inputs)
    assert out < next(place for place, (inputs, _, _) in enumerate(told) if "whipped cream" in inputs)


def test_a_rice_pudding_with_eggs_is_stirred_first_and_baked_then(steps):
    asked = ("rice:uncooked", "milk:liquid", "sugar:granulated", "eggs:uncooked", "vanilla:liquid")
    told = steps("pudding", "Baked rice pudding", *asked)
    assert inside(told, "cook and stir") == {"rice", "milk", "sugar"}
    assert motions(told).index("cook and stir") < motions(told).index("bake")


def test_berries_are_thickened_over_the_heat_and_chilled(steps):
    asked = ("strawberries:berries", "red currants:berries", "sugar:granulated", "potato starch:powder", "water:liquid")
    told = steps("pudding", "Rødgrød", *asked, "cream:liquid:serving")
    assert inside(told, "cook and stir") == {"strawberries", "red currants", "sugar", "potato starch", "water"}
    assert motions(told).index("cook and stir") < motions(told).index("chill") < first(told, "cream", "pour")


def test_slices_with_butter_lie_under_a_custard(steps):
    asked = ("brioche:loaf", "butter:softened", "raisins:dried", "eggs:uncooked", "milk:liquid", "sugar:granulated")
    told = steps("pudding", "Brioche bread and butter pudding", *asked)
    assert inside(told, "whisk") == {"eggs", "milk", "sugar"}
    assert first(told, "brioche", "slice") < motions(told).index("whisk") < motions(told).index("bake")


def test_cheese_lies_in_a_dough_that_rises_and_is_not_kneaded_into_it(steps):
    asked = ("flour:powder", "yeast:dried", "water:warm", "salt:granulated", "feta:crumbled", "mozzarella:grated")
    told = steps("bread", "Khachapuri", *asked, "egg:uncooked")
    assert inside(told, "knead") == {"flour", "yeast", "water", "salt"}
    assert {"feta", "mozzarella"} <= inside(told, "mix")


def test_a_paste_of_flour_is_cooked_and_comes_on_a_loaf_with_its_seeds(steps):
    dough = ("flour:powder:dough", "yeast:dried:dough", "water:warm:dough", "salt:granulated:dough")
    told = steps("bread", "Barbari bread", *dough, "flour:powder:glaze", "water:liquid:glaze", "sesame seeds::topping")
    assert inside(told, "cook and stir") == {"flour", "water"}
    assert first(told, "sesame seeds", "pour") < motions(told).index("bake")


def test_cookies_hold_what_is_spread_on_them(steps):
    asked = ("cornstarch:powder", "flour:powder", "butter:softened", "sugar:granulated", "egg yolks:uncooked")
    told = steps("cookie", "Linzer cookies", *asked, "raspberry jam:jelly")
    assert motions(told).index("bake") < first(told, "raspberry jam", "scoop") < motions(told).index("press")


def test_fine_sugar_sweetens_a_dough_where_no_other_does(steps):
    told = steps("cookie", "Nankhatai", "ghee:creamy", "icing sugar:powder", "flour:powder", "semolina:powder")
    assert "icing sugar" in inside(told, "mix")


def test_a_sauce_of_seeds_for_a_roll_is_stirred_apart(steps):
    sauce = ("tahini:creamy:sauce", "water:liquid:sauce", "lemon juice:juice:sauce", "garlic:crushed:sauce")
    told = steps("sandwich", "Aubergine pitta", "pitta bread:whole", "aubergine:sliced", "tomato:sliced", *sauce)
    assert {"tahini", "water", "lemon juice", "garlic"} <= inside(told, "stir")


def test_a_sauce_for_a_burger_is_cooked_where_it_is_no_spread(steps):
    sauce = ("soy sauce:liquid:sauce", "mirin:liquid:sauce", "sugar:granulated:sauce")
    told = steps("burger", "Teriyaki burger", "minced beef:raw", "onion:chopped", "buns:whole", *sauce)
    assert inside(told, "cook and stir") == {"soy sauce", "mirin", "sugar"}


def test_spices_are_boiled_in_the_water_of_a_drink(steps):
    told = steps("drinks", "", "water:liquid", "ginger:sliced", "cinnamon:stick", "cloves:whole", "sugar:granulated")
    assert motions(told).index("cook") < motions(told).index("pour and strain")


def test_cream_lies_on_hot_coffee(steps):
    told = steps("drinks", "Irish coffee", "coffee:liquid", "whiskey:liquid", "brown sugar:granulated", "cream:creamy")
    assert inside(told, "stir") == {"coffee", "whiskey", "brown sugar"}
    assert motions(told).index("stir") < motions(told).index("beat")


def test_fruit_is_stirred_into_wine_though_a_stick_of_spice_is_in_it(steps):
    asked = ("red wine:liquid", "brandy:liquid", "orange:sliced", "sugar:granulated", "cinnamon:stick", "ice:cubed")
    assert not {"blend", "cook"} & set(motions(steps("drinks", "", *asked)))


def test_mash_is_closed_in_a_dough_that_nothing_raises(steps):
    asked = ("whole wheat flour:powder", "potato:boiled", "green chili:chopped", "cilantro:chopped", "cumin:ground")
    told = steps("bread", "", *asked, "oil:liquid", "water:liquid", "salt:granulated")
    assert inside(told, "knead") <= {"whole wheat flour", "water", "salt", "oil"}
    assert motions(told).index("fold and pinch") < motions(told).index("flip")


def test_fowl_for_thin_sheets_is_stewed_and_pulled(steps):
    asked = ("chicken thighs:raw", "onion:chopped", "cinnamon:ground", "eggs:beaten", "filo pastry:raw")
    told = steps("pie", "Chicken bastilla", *asked, "butter:melted", "almonds:ground")
    assert motions(told).index("simmer") < motions(told).index("pull apart") < motions(told).index("bake")


def test_meat_is_covered_with_ground_corn(steps):
    asked = ("ground beef:raw", "onion:chopped", "corn:frozen", "milk:liquid", "butter:unmelted", "olives:pitted")
    told = steps("pie", "Pastel de choclo", *asked, "hard-boiled eggs:sliced")
    assert inside(told, "blend") == {"corn", "milk"}
    assert motions(told).index("blend") < motions(told).index("bake")


def test_eggs_beaten_with_sugar_raise_what_nothing_else_raises(steps):
    told = steps("cake", "Hot milk sponge", "flour:powder", "eggs:uncooked", "sugar:granulated", "lemon zest:grated")
    assert inside(told, "whisk") == {"eggs", "sugar"}
    assert motions(told).index("whisk") < motions(told).index("fold")


def test_the_second_eggs_of_a_burger_are_fried(steps):
    asked = ("minced beef:raw", "egg:beaten", "breadcrumbs:crumbs", "buns:whole", "eggs:uncooked", "lettuce:shredded")
    told = steps("burger", "Burger with fried eggs", *asked)
    assert "eggs" not in inside(told, "mix")


def test_flour_that_is_seasoned_is_for_the_meat_of_a_pie(steps):
    asked = ("beef:cut", "flour:seasoned", "onion:chopped", "oil:liquid", "ale:liquid", "flour:plain", "lard:diced")
    told = steps("pie", "Beef and ale pie", *asked)
    assert any(one == "pour" and {"flour", "cooking pan"} <= inputs for inputs, one, _ in told)


def test_herbs_are_stirred_with_oil_on_an_open_dough_and_what_is_crisp_stays_raw(steps):
    asked = ("flour:powder", "yeast:dried", "water:warm", "olive oil:liquid", "za'atar:ground", "tomatoes:sliced")
    told = steps("pizza", "Manakish", *asked, "cucumber:sliced")
    assert inside(told, "mix") >= {"za'atar", "olive oil"}
    assert motions(told).index("bake") < max(n for n, (inputs, _, _) in enumerate(told) if "cucumber" in inputs)


def test_biscuits_of_icing_sugar_hold_jam_between_two(steps):
    told = steps("cookie", "Linzer biscuits", "flour:plain", "almonds:ground", "butter:diced", "icing sugar:powder",
                 "egg yolk:uncooked", "redcurrant jam:jelly")  # fmt: skip
    assert first(told, "icing sugar", "mix") < motions(told).index("bake") < motions(told).index("scoop")
    assert motions(told)[-1] == "press"


def test_biscuits_that_are_iced_are_cold_by_then(steps):
    told = steps("cookie", "Iced biscuits", "flour:plain", "butter:unmelted", "caster sugar:granulated", "egg:beaten",
                 "icing sugar:powder", "lemon juice:juice")  # fmt: skip
    assert motions(told).index("bake") < motions(told).index("cool down") < first(told, "icing sugar", "stir")


def test_cream_of_butter_for_a_cake_in_two_is_beaten_apart_and_the_cake_comes_first(steps):
    told = steps("cake", "Victoria sandwich cake", "caster sugar:granulated", "butter:softened", "eggs:beaten",
                 "self-raising flour:powder", "butter:softened:filling", "icing sugar:powder:filling",
                 "strawberry jam:jelly:filling")  # fmt: skip
    jam = next(place for place, (things, _, _) in enumerate(told) if "strawberry jam" in things)
    assert motions(told).index("cool down") < first(told, "cake", "pick-and-place") < jam
    assert jam < motions(told).index("blend", jam) < motions(told).index("spread", jam)


def test_crumbs_of_crackers_lie_under_a_cream_of_cheese(steps):
    told = steps("cake", "", "cracker:crumbs", "butter:juice", "cheese:softened", "sugar:ground", "egg:whole",
                 "cream:creamy", "cherry:thick sauce")  # fmt: skip
    assert motions(told).index("press") < motions(told).index("bake") < motions(told).index("chill")


def test_sweet_cheese_is_no_part_of_a_dough_that_is_rolled_around_cinnamon(steps):
    told = steps("bread", "", "flour:ground", "yeast:ground", "milk:juice", "butter:softened", "sugar:ground",
                 "egg:whole", "cinnamon:ground", "brown sugar:ground", "cheese:softened", "vanilla:juice")  # fmt: skip
    assert not {"cheese", "cinnamon"} & inside(told, "knead")
    assert motions(told).index("bake") < motions(told).index("blend")


@pytest.mark.parametrize("title", ["Uzvar", "Kompot", "Khoshaf", ""])
def test_dried_fruit_is_boiled_for_a_drink(steps, title):
    told = steps("drinks", title, "dried apricots:dried", "prunes:pitted", "raisins:whole", "honey:thick liquid",
                 "water:liquid")  # fmt: skip
    assert {"prunes", "raisins", "dried apricots", "water"} <= inside(told, "cook")
