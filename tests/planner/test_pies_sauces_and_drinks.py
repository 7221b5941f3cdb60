"""Families of pies, puddings, sauces and drinks: which food joins when, what is not heated, what is made apart."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, last, motions

pytestmark = pytest.mark.shared_data

CRUST = ("flour:powder:pastry", "butter:cold:pastry", "water:cold:pastry")


def mixed(told, motion):
    """Return the sets of foods that such a motion makes one of, in their order."""
    return [set(outputs[0].ingredients) for _, one, outputs in told if one == motion]


def test_what_is_listed_under_the_heading_of_a_crust_makes_its_dough_and_nothing_else_does(steps):
    asked = ("apples:sliced:filling", "sugar:granulated:filling", "flour:powder:filling", "lemon juice:juice:filling")
    told = steps("pie", "Apple Pie from Scratch", *CRUST, *asked)
    assert inside(told, "knead") == {"flour", "butter", "water"}
    assert {"apples", "sugar", "flour", "lemon juice"} in mixed(told, "mix")


def test_almonds_and_butter_come_over_jam_in_a_dough_of_their_own(steps):
    filling = ("raspberry jam:jelly:filling", "butter:unmelted:filling", "sugar:granulated:filling")
    told = steps("pie", "Bakewell Tart", *CRUST, *filling, "almonds:ground:filling", "egg:beaten:filling")
    assert inside(told, "knead") == {"flour", "butter", "water"}
    assert mixed(told, "mix")[-1] == {"butter", "sugar", "almonds", "egg"}
    assert first(told, "raspberry jam", "scoop") < motions(told).index("bake")


def test_a_cream_that_is_cooked_sets_on_crumbs_that_are_not_baked(steps):
    crust = ("Oreo cookies:whole:crust", "butter:melted:crust")
    filling = ("sugar:granulated:filling", "cornstarch:powder:filling", "egg yolks:uncooked:filling")
    topping = ("heavy cream:creamy:topping", "powdered sugar:powder:topping")
    told = steps(
        "pie", "Chocolate Cream Pie", *crust, *filling, "milk:liquid:filling", "chocolate:chopped:filling", *topping
    )
    assert "bake" not in motions(told)
    assert inside(told, "cook and stir") == {"sugar", "cornstarch", "egg yolks", "milk", "chocolate"}
    assert motions(told).index("press") < motions(told).index("chill") < first(told, "heavy cream", "beat")
    assert "stir" not in motions(told)  # what has set is covered, and not stirred


def test_only_cream_and_what_sweetens_it_is_whipped_of_a_topping(steps):
    topping = ("heavy cream:creamy:topping", "powdered sugar:powder:topping", "chocolate curls:bar:topping")
    asked = ("chocolate:melted", "butter:softened", "sugar:granulated", "eggs:uncooked")
    told = steps("pie", "French Silk Pie", "pie crust:raw", *asked, *topping)
    assert mixed(told, "beat")[-1] == {"heavy cream", "powdered sugar"}
    assert first(told, "pie crust", "bake") < first(told, "eggs", "cook and stir") < motions(told).index("chill")
    assert motions(told).count("bake") == 1


def test_fruit_lies_under_crumbs_that_are_made_apart_under_a_heading(steps):
    crumble = ("flour:plain:crumble", "brown sugar:granulated:crumble", "butter:cold:crumble", "oats:rolled:crumble")
    told = steps(
        "pie", "Apple Crumble", "apples:sliced:filling", "sugar:granulated:filling", *crumble, "custard::serving"
    )
    assert mixed(told, "mix") == [{"apples", "sugar"}, {"flour", "brown sugar", "butter", "oats"}]
    assert motions(told)[-1] in {"scoop", "pour", "scoop and pour"}
    assert "custard" not in inside(told, "bake")


def test_what_is_served_with_a_cobbler_is_not_baked_with_it(steps):
    topping = ("flour:powder:topping", "sugar:granulated:topping", "baking powder:powder:topping", "butter:cut:topping")
    told = steps(
        "pie", "Peach Cobbler", "peaches:sliced", "brown sugar:granulated", *topping, "ice cream:frozen:serving"
    )
    assert mixed(told, "mix") == [{"peaches", "brown sugar"}, {"flour", "sugar", "baking powder", "butter"}]
    assert "ice cream" not in inside(told, "bake")


def test_a_glaze_of_egg_is_brushed_on_and_eggs_that_were_boiled_are_not(steps):
    asked = ("ground beef:raw", "onion:chopped", "eggs:boiled", "empanada wrappers:raw", "egg:beaten")
    told = steps("pie", "Beef Empanadas", *asked)
    (brushed,) = [inputs for inputs, motion, _ in told if motion == "brush"]
    assert "egg" in brushed
    assert "eggs" in inside(told, "mix")


def test_onions_are_fried_before_they_lie_on_the_dough_of_a_tart(steps):
    told = steps(
        "pie", "Caramelized Onion Tart", "puff pastry:raw", "butter:unmelted", "onions:sliced", "goat cheese:crumbled"
    )
    assert first(told, "onions", "cook and stir") < motions(told).index("bake")


def test_cream_is_whipped_and_nothing_is_cooked_for_an_ice_cream_of_condensed_milk(steps):
    told = steps(
        "pudding", "No Churn Vanilla Ice Cream", "heavy cream:cold", "condensed milk:thick liquid", "vanilla:liquid"
    )
    assert "cook and stir" not in motions(told)
    assert motions(told).index("beat") < motions(told).index("fold")


def test_sugar_is_cooked_before_cream_joins_it(steps):
    told = steps("sauce", "Caramel Sauce", "sugar:granulated", "butter:cut", "heavy cream:creamy", "salt:granulated")
    assert mixed(told, "cook and stir") == [{"sugar"}, {"sugar", "butter", "heavy cream"}]


def test_hot_cream_comes_over_chocolate(steps):
    told = steps("sauce", "Chocolate Ganache", "chocolate:chopped", "heavy cream:creamy")
    assert inside(told, "cook and stir") == {"heavy cream"}
    assert inside(told, "stir") == {"chocolate", "heavy cream"}


def test_butter_joins_what_was_boiled_down(steps):
    told = steps("sauce", "Beurre Blanc", "white wine:dry", "shallot:minced", "butter:cut", "salt:granulated")
    assert mixed(told, "cook and stir")[0] == {"white wine", "shallot"}


def test_eggs_of_a_curd_and_of_a_custard_are_cooked_and_poured(steps):
    told = steps("sauce", "Lemon Curd", "lemon juice:juice", "sugar:granulated", "eggs:uncooked", "butter:cubed")
    assert inside(told, "cook and stir") == {"lemon juice", "sugar", "eggs", "butter"}
    assert told[-1][1] == "pour"
    told = steps("drinks", "Eggnog", "eggs:uncooked", "sugar:granulated", "milk:liquid", "cream:creamy", "rum:liquid")
    poured = next(
        inputs for inputs, motion, _ in told if motion in {"pour", "pick-and-place"} and "drinking glass" in inputs
    )
    assert "turner" not in poured


def test_a_dip_of_pulses_is_blended_and_a_dip_under_cheese_is_baked(steps):
    told = steps("sauce", "Hummus", "chickpeas:drained", "tahini:creamy", "lemon juice:juice", "garlic:minced")
    assert inside(told, "blend") == {"chickpeas", "tahini", "lemon juice", "garlic"}
    told = steps("sauce", "Spinach Dip", "cream cheese:softened", "spinach:thawed", "mozzarella cheese:shredded")
    assert inside(told, "bake") == {"cream cheese", "spinach", "mozzarella cheese"}


def test_spices_in_wine_or_cider_are_drawn_over_the_heat_though_no_title_says_mulled(steps):
    told = steps("drinks", "", "wine:liquid", "cinnamon:stick", "clove:whole", "honey:thick liquid")
    assert first(told, "wine", "cook") < first(told, "mixture", "pour")


def test_cocoa_in_milk_is_drunk_hot_and_with_a_banana_it_is_blended(steps):
    asked = ("milk:liquid", "cocoa:powder", "sugar:granulated")
    assert "cook and stir" in motions(steps("drinks", "", *asked))
    assert "cook and stir" not in motions(steps("drinks", "", *asked, "banana:whole"))


def test_mint_is_bruised_with_sugar_before_the_ice_comes(steps):
    asked = ("bourbon:liquid", "sugar:granulated", "mint:leaves", "ice:frozen")
    told = steps("drinks", "", *asked)
    assert inside(told, "mash") == {"sugar", "mint"}
    assert first(told, "mint", "mash") < first(told, "ice", "pour")


def test_soda_comes_over_ice_cream(steps):
    told = steps("drinks", "Root Beer Float", "root beer:liquid", "vanilla ice cream:frozen")
    assert motions(told).index("scoop and pour") < first(told, "root beer", "pour")
    assert "blend" not in motions(told)


def test_coffee_grounds_stay_in_the_strainer(steps):
    told = steps("drinks", "Iced Coffee", "ground coffee:ground", "water:liquid", "milk:liquid", "ice:frozen")
    assert first(told, "ground coffee", "pour") < motions(told).index("pour and strain") < first(told, "milk", "pour")


def test_a_hulled_berry_is_not_peeled(steps):
    told = steps("sauce", "Strawberry Jam", "strawberries:hulled", "sugar:granulated")
    assert "peel" not in motions(told)


def test_a_mash_with_sugar_is_the_filling_of_a_pie_and_does_not_cover_it(steps):
    asked = ("pie crust:raw", "sweet potatoes:mashed", "sugar:granulated", "eggs:uncooked", "milk:liquid")
    told = steps("pie", "Sweet Potato Pie", *asked)
    assert inside(told, "mix") == {"sweet potatoes", "sugar", "eggs", "milk"}


def test_beaten_whites_lie_on_a_banana_pudding(steps):
    asked = (
        "sugar:granulated",
        "flour:powder",
        "eggs:separated",
        "milk:liquid",
        "vanilla wafers:whole",
        "bananas:sliced",
    )
    told = steps("pudding", "Banana Pudding", *asked)
    assert "egg whites" not in inside(told, "cook and stir")
    assert motions(told).index("cook and stir") < first(told, "egg whites", "whisk") < motions(told).index("bake")


def test_zest_is_grated_where_the_juice_of_the_same_fruit_is_squeezed(steps):
    told = steps("pudding", "Lemon Posset", "double cream:creamy", "sugar:granulated", "lemons:zest", "lemons:juiced")
    assert motions(told).count("squeeze") == 1
    assert "grate" in motions(told)


def test_a_title_with_accents_is_called_as_one_without(steps):
    told = steps("sauce", "Sauce Béarnaise", "vinegar:liquid", "shallot:minced", "egg yolks:uncooked", "butter:melted")
    assert inside(told, "cook and stir") == {"vinegar", "shallot"}


def test_frozen_drinks_are_blended_with_their_ice_and_cold_brew_is_not_heated(steps):
    told = steps("drinks", "Frozen Margarita", "ice:frozen", "tequila:liquid", "lime juice:juice")
    assert inside(told, "blend") == {"ice", "tequila", "lime juice"}
    told = steps("drinks", "Cold Brew Coffee", "coffee beans:ground", "water:cold")
    assert not {"cook", "cook and stir", "boil", "heat"} & set(motions(told))
    assert "pour and strain" in motions(told)


def test_onions_for_a_dip_are_fried_and_cooled_before_they_meet_what_is_soured(steps):
    told = steps("sauce", "French Onion Dip", "onions:chopped", "butter:unmelted", "sour cream:creamy")
    cooled = next(place for place, motion in enumerate(motions(told)) if motion.startswith("cool"))
    assert first(told, "onions", "cook and stir") < cooled < motions(told).index("stir")


def test_chocolate_is_melted_in_hot_cream_for_a_tart_whose_crust_is_baked_alone(steps):
    crust = ("flour:powder:crust", "butter:cold:crust", "egg:uncooked:crust")
    told = steps("pie", "Chocolate Tart", *crust, "dark chocolate:chopped:filling", "heavy cream:creamy:filling")
    assert inside(told, "bake") == {"flour", "butter", "egg"}
    assert inside(told, "cook and stir") == {"heavy cream"}


def test_the_cream_of_a_boston_cream_pie_is_none_of_its_cake(steps):
    cake = ("flour:powder:cake", "sugar:granulated:cake", "eggs:uncooked:cake", "baking powder:powder:cake")
    cream = ("milk:liquid:filling", "cornstarch:powder:filling", "egg yolks:uncooked:filling")
    told = steps("pie", "Boston Cream Pie", *cake, *cream, "chocolate:bar:glaze", "cream:creamy:glaze")
    assert inside(told, "fold") == {"flour", "sugar", "eggs", "baking powder"}
    assert inside(told, "cook and stir") == {"milk", "cornstarch", "egg yolks"}


def test_rhubarb_is_cooked_before_cream_is_folded_into_it(steps):
    told = steps("pudding", "Rhubarb Fool", "rhubarb:chopped", "sugar:granulated", "double cream:creamy")
    assert first(told, "rhubarb", "cook and stir") < motions(told).index("blend") < motions(told).index("fold")


def test_cream_by_itself_is_whipped_and_a_frosting_is_beaten(steps):
    told = steps("sauce", "Whipped Cream", "heavy cream:creamy", "powdered sugar:powder")
    assert "beat" in motions(told)
    told = steps("sauce", "Cream Cheese Frosting", "cream cheese:softened", "butter:softened", "powdered sugar:powder")
    assert inside(told, "blend") == {"cream cheese", "butter", "powdered sugar"}


def test_wine_with_fruit_in_pieces_is_stirred_and_not_blended(steps):
    told = steps("drinks", "", "wine:juice", "brandy:juice", "orange:sliced", "apple:chopped", "sugar:ground",
                 "soda:juice", "ice:solid")  # fmt: skip
    assert "blend" not in motions(told)
    assert {"soda", "ice"}.isdisjoint(inside(told, "stir"))


def test_sauces_of_fruit_and_of_roasted_peppers_are_cooked(steps):
    told = steps("sauce", "Cranberry orange sauce", "cranberries:fresh", "sugar:granulated", "orange juice:juice",
                 "cinnamon stick:whole")  # fmt: skip
    assert "cranberries" in inside(told, "cook and stir")
    told = steps("sauce", "Tkemali", "sour plums:whole", "garlic:clove", "coriander:leaf", "salt:granulated")
    assert first(told, "sour plums", "simmer") < motions(told).index("blend")
    told = steps("sauce", "Ajvar", "long red peppers:whole", "aubergine:whole", "garlic:crushed", "oil:liquid")
    assert inside(told, "bake") >= {"long red peppers", "aubergine"}
    assert motions(told).index("bake") < motions(told).index("blend")


def test_what_is_woody_in_a_satay_sauce_is_blended_with_its_nuts(steps):
    told = steps("sauce", "Satay Sauce", "peanuts:roasted", "lemongrass:chopped", "shallots:chopped", "garlic:clove",
                 "oil:liquid", "coconut milk:liquid", "palm sugar:granulated")  # fmt: skip
    assert {"lemongrass", "peanuts", "shallots"} <= inside(told, "blend")
    assert first(told, "coconut milk", "cook and stir") > motions(told).index("blend")


def test_fruit_of_a_pie_lies_between_two_sheets_of_its_own_short_dough(steps):
    crust = ("flour:powder:crust", "butter:cold:crust", "water:cold:crust")
    filling = ("peaches:sliced:filling", "sugar:granulated:filling", "flour:powder:filling")
    told = steps("pie", "Peach Pie", *crust, *filling)
    assert motions(told).count("roll") == 2
    assert mixed(told, "mix")[1] == {"peaches", "sugar", "flour"}  # after the first dough, before the second
    assert sum("dough" in inputs for inputs, motion, _ in told if motion == "pick-and-place") >= 3


def test_the_egg_and_coarse_sugar_that_close_the_list_of_a_pie_come_on_its_lid(steps):
    crust = ("flour:powder", "salt:granulated", "butter:cubed", "ice water:liquid")
    told = steps(
        "pie", "Apple Lattice Pie", *crust, "apples:chopped", "brown sugar:granulated", "egg:beaten", "coarse sugar:"
    )
    assert {"egg", "coarse sugar"}.isdisjoint(set().union(*mixed(told, "mix")))
    assert first(told, "egg", "brush") < motions(told).index("bake")


def test_whites_that_are_listed_with_a_second_sugar_come_on_the_filling_of_a_baked_crust(steps):
    asked = ("pie crust:baked", "sugar:granulated", "flour:powder", "water:liquid", "vinegar:liquid", "eggs:separated")
    told = steps("pie", "Vinegar Pie", *asked, "butter:unmelted", "sugar:granulated", "cream of tartar:powder")
    assert first(told, "pie crust", "bake") < last(told, "egg whites")
    assert "egg whites" not in inside(told, "cook and stir")
    assert motions(told).count("bake") == 2


def test_cream_is_cooked_in_a_sugar_cream_pie_and_not_whipped(steps):
    asked = ("sugar:granulated", "cornstarch:powder", "heavy cream:creamy", "milk:liquid", "butter:unmelted")
    told = steps("pie", "Sugar Cream Pie", "pie shell:raw", *asked)
    assert "heavy cream" in inside(told, "cook and stir") | set().union(*mixed(told, "beat"))
    assert first(told, "heavy cream", "pour") < motions(told).index("bake")


def test_a_thin_batter_of_baking_mix_comes_over_meat_that_is_fried(steps):
    asked = ("ground beef:uncooked", "onion:chopped", "Cheddar cheese:shredded")
    told = steps("pie", "Cheeseburger Pie", *asked, "Bisquick:powder", "milk:liquid", "eggs:uncooked")
    assert "ground beef" in inside(told, "cook and stir")
    assert "ground beef" not in inside(told, "whisk")
    assert motions(told).index("cook and stir") < motions(told).index("bake")


def test_meal_is_boiled_in_milk_before_it_is_baked_as_a_pudding(steps):
    told = steps("pudding", "Indian Pudding", "milk:liquid", "cornmeal:powder", "molasses:thick liquid",
                 "butter:unmelted", "egg:beaten", "vanilla ice cream:frozen:serving")  # fmt: skip
    assert inside(told, "cook and stir") >= {"milk", "cornmeal"}
    assert motions(told).index("cook and stir") < motions(told).index("bake") < last(told, "vanilla ice cream")


def test_beaten_whites_are_folded_into_gelatin_that_was_dissolved_and_cooled(steps):
    told = steps("pudding", "Lemon Snow Pudding", "gelatin:powder", "water:boiling", "sugar:granulated",
                 "lemon juice:juice", "egg whites:uncooked")  # fmt: skip
    assert first(told, "gelatin", "cook and stir") < first(told, "egg whites", "fold") < motions(told).index("chill")


def test_fruit_is_blended_before_it_comes_to_a_drink_that_meal_thickens(steps):
    told = steps("drinks", "Atole de Fresa", "strawberries:hulled", "milk:liquid", "masa harina:powder", "sugar:",
                 "water:liquid")  # fmt: skip
    assert "strawberries" in inside(told, "blend")
    assert motions(told).index("blend") < motions(told).index("cook and stir")


def test_dried_fruit_is_cooked_soft_before_dough_is_closed_around_it_and_fried(steps):
    told = steps("pie", "Fried Apricot Pies", "apricots:dried", "water:liquid", "sugar:granulated", "flour:powder",
                 "salt:granulated", "shortening:creamy", "water:cold", "vegetable oil:liquid")  # fmt: skip
    assert inside(told, "cook and stir") >= {"apricots", "sugar"}
    assert inside(told, "knead") == {"flour", "shortening", "salt", "water"}
    assert "bake" not in motions(told)


def test_whites_of_a_chiffon_pie_are_folded_into_gelatin_and_not_baked(steps):
    told = steps("pie", "Raspberry Chiffon Pie", "pie shell:baked", "gelatin:powder", "water:cold",
                 "egg whites:uncooked", "sugar:granulated", "raspberries:crushed", "heavy cream:whipped")  # fmt: skip
    assert first(told, "pie shell", "bake") < first(told, "egg whites", "fold") < motions(told).index("chill")
    assert motions(told).count("bake") == 1
    assert "heavy cream" not in inside(told, "cook and stir")


def test_jam_lies_under_the_custard_of_a_tart_that_is_made_so(steps):
    told = steps("pie", "Manchester Tart", "shortcrust pastry:raw", "raspberry jam:jelly", "milk:liquid",
                 "egg yolks:uncooked", "sugar:granulated", "custard powder:powder")  # fmt: skip
    assert "raspberry jam" not in inside(told, "cook and stir")
    assert motions(told).index("bake") < first(told, "raspberry jam", "scoop") < motions(told).index("chill")


def test_milk_is_made_warm_before_rennet_comes_to_it(steps):
    told = steps("pudding", "Junket", "milk:liquid", "sugar:granulated", "rennet:whole", "nutmeg:ground")
    assert "rennet" not in inside(told, "cook and stir")
    assert motions(told).index("cook and stir") < first(told, "rennet", "stir")


def test_rice_of_a_pudding_swells_before_its_sweet_milk_comes_to_it(steps):
    told = steps("pudding", "Arroz con Dulce", "rice:uncooked", "water:liquid", "cinnamon sticks:whole",
                 "coconut milk:liquid", "sugar:granulated", "raisins:whole")  # fmt: skip
    assert "strainer" not in {node.label for _, _, outputs in told for node in outputs}
    assert first(told, "rice", "cook and stir") < last(told, "coconut milk")
    assert "cinnamon sticks" not in told[-1][2][0].ingredients


def test_a_cream_pie_that_is_called_so_gets_its_meringue(steps):
    told = steps("pie", "Banana Cream Pie with Meringue", "pie shell:baked", "sugar:granulated", "flour:powder",
                 "milk:liquid", "egg yolks:uncooked", "bananas:sliced", "egg whites:uncooked",
                 "sugar:granulated")  # fmt: skip
    assert "egg whites" not in inside(told, "cook and stir")
    assert motions(told).count("bake") == 2
    assert first(told, "bananas", "pour") < last(told, "egg whites")


def test_butter_is_melted_for_what_is_baked_rich_in_a_crust(steps):
    told = steps("pie", "Nutty Fudge Pie", "pie shell:raw", "butter:unmelted", "sugar:granulated", "eggs:uncooked",
                 "flour:powder", "cocoa:powder", "walnuts:chopped")  # fmt: skip
    assert "melted" in {
        state for _, _, outs in told for node in outs if node.label == "butter" for state in node.states
    }


def test_what_is_dipped_into_a_dip_is_no_part_of_it(steps):
    told = steps("sauce", "Caramel Apple Dip", "cream cheese:softened", "brown sugar:granulated", "vanilla:liquid")
    assert set(told[-1][2][-1].ingredients) == {"cream cheese", "brown sugar", "vanilla"}
