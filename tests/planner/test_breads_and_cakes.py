"""Breads, cakes, muffins and cookies: what soaks, covers or fills them is made apart and joins them in time."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

BATTER = ("flour:powder", "baking powder:powder", "salt:granulated", "butter:softened", "sugar:granulated",
          "eggs:uncooked")  # fmt: skip
DOUGH = ("flour:ground", "yeast:dried", "water:juice", "salt:ground")


def heated(told) -> set[str]:
    """Return all foods that are ever in the oven."""
    found = [outputs for _, motion, outputs in told if motion == "bake"]
    return {food for outputs in found for node in outputs for food in node.ingredients}


@pytest.mark.parametrize(
    "foods",
    [
        ("cream:juice", "powdered sugar:ground", "mascarpone:creamy", "ladyfinger:whole", "coffee:juice"),
        ("angel food cake:whole", "pudding:creamy", "strawberry:sliced", "whipped topping:whipped"),
        ("graham cracker crumb:crushed", "butter:melted", "cream cheese:creamy", "sugar:ground", "whipped topping:"),
    ],
)
def test_a_cake_of_what_was_baked_before_sets_in_the_cold_though_no_title_says_so(steps, foods):
    told = steps("cake", "", *foods)
    assert "bake" not in motions(told)
    assert "chill" in motions(told)


def test_thick_milks_soak_a_cake_that_is_baked_though_no_title_says_so(steps):
    told = steps("cake", "", "flour:ground", "egg:whole raw", "sugar:ground", "milk:juice", "evaporated milk:juice",
                 "condensed milk:juice", "strawberry:sliced")  # fmt: skip
    assert {"evaporated milk", "condensed milk", "strawberry"}.isdisjoint(inside(told, "bake"))


@pytest.mark.parametrize("heading", ["filling", "buttercream"])
def test_butter_and_fine_sugar_of_a_filling_are_beaten_and_jam_is_spread(steps, heading):
    filling = (f"butter:softened:{heading}", f"icing sugar:powder:{heading}", "strawberry jam:jelly:filling")
    told = steps("cake", "Victoria Sponge", *BATTER, *filling)
    assert {"icing sugar", "strawberry jam"}.isdisjoint(inside(told, "bake"))
    assert any({"icing sugar", "butter"} <= inputs and motion == "blend" for inputs, motion, _ in told)
    assert next(n for n, one in enumerate(told) if "strawberry jam" in one[0]) > motions(told).index("cool down")


def test_a_frosting_with_yolks_is_cooked(steps):
    frosting = ("evaporated milk:liquid:frosting", "sugar:granulated:frosting", "egg yolks:uncooked:frosting",
                "butter:unmelted:frosting", "coconut:flakes:frosting")  # fmt: skip
    told = steps("cake", "Chocolate Cake", *BATTER, *frosting)
    assert {"egg yolks", "coconut"} <= inside(told, "cook and stir")
    assert "coconut" not in inside(told, "bake")


def test_a_glaze_of_butter_and_rum_is_cooked_and_poured_on(steps):
    glaze = ("butter:unmelted:glaze", "sugar:granulated:glaze", "water:liquid:glaze", "rum:liquid:glaze")
    told = steps("cake", "Rum Cake", *BATTER, *glaze)
    assert "rum" in inside(told, "cook and stir")
    assert "rum" not in inside(told, "bake")


def test_cream_of_a_topping_is_whipped_with_its_sugar_and_nothing_else(steps):
    topping = ("heavy cream:liquid:topping", "sugar:granulated:topping", "cherries:canned:serving")
    told = steps("cake", "Chocolate Cake", *BATTER, *topping)
    whipped = [inputs for inputs, motion, _ in told if motion == "beat" and "heavy cream" in inputs]
    assert "sugar" in whipped[-1]
    assert not any("cherries" in inputs for inputs in whipped)
    assert motions(told).index("bake") < first(told, "heavy cream", "beat")


def test_sugar_and_juice_of_a_topping_come_on_the_cake_when_it_is_done(steps):
    told = steps("cake", "Lemon Drizzle Cake", *BATTER, "lemon juice:juice:topping", "sugar:granulated:topping")
    assert "lemon juice" in inside(told, "stir")
    assert "lemon juice" not in inside(told, "bake")
    assert "cook and stir" not in motions(told)


def test_a_filling_with_egg_comes_on_the_batter_before_it_is_baked(steps):
    filling = ("cream cheese:softened:filling", "sugar:granulated:filling", "egg yolk:uncooked:filling")
    told = steps("muffin", "Pumpkin Muffins", *BATTER, *filling)
    assert {"cream cheese", "egg yolk"} <= inside(told, "bake")
    (whisked,) = [inputs for inputs, motion, _ in told if motion == "whisk" and "cream cheese" in inputs]
    assert "egg yolk" in whisked


@pytest.mark.parametrize("title", ["Coffee Cake", ""])
def test_a_crumble_after_the_batter_is_rubbed_by_itself(steps, title):
    told = steps("cake", title, *BATTER, "sour cream:creamy", "brown sugar:granulated", "flour:powder",
                 "cinnamon:ground", "butter:cold")  # fmt: skip
    whisked = {food for inputs, motion, _ in told if motion == "blend" for food in inputs}
    assert "brown sugar" not in whisked
    assert "brown sugar" in inside(told, "bake")


def test_what_scones_are_glazed_with_is_brushed_on(steps):
    told = steps("bread", "Scones", "self-raising flour:powder", "butter:cubed", "milk:liquid", "egg:beaten:glaze")
    assert "egg" in first_inputs(told, "brush")
    assert "egg" not in inside(told, "knead")


def first_inputs(told, motion: str) -> set[str]:
    """Return what goes in at the first such motion."""
    return next(inputs for inputs, one, _ in told if one == motion)


@pytest.mark.parametrize("title", ["French Toast", ""])
def test_slices_are_dipped_in_egg_and_milk_and_fried(steps, title):
    told = steps("bread", title, "bread:sliced", "egg:whole raw", "milk:juice", "vanilla:juice", "butter:creamy",
                 "maple syrup:juice")  # fmt: skip
    assert "bake" not in motions(told)
    assert "vanilla" in first_inputs(told, "whisk")
    assert motions(told).index("dip") < motions(told).index("flip") < first(told, "maple syrup", "pour")


@pytest.mark.parametrize("title", ["Bruschetta", ""])
def test_bread_is_toasted_before_tomatoes_lie_on_it(steps, title):
    told = steps("bread", title, "baguette:sliced", "tomato:chopped", "basil:chopped", "garlic:minced",
                 "olive oil:juice")  # fmt: skip
    assert inside(told, "bake") <= {"baguette", "olive oil"}
    assert "cook and stir" not in motions(told)


def test_dough_that_nobody_kneads_is_stirred(steps):
    assert "knead" not in motions(steps("bread", "No-Knead Bread", *DOUGH))


def test_butter_sugar_and_cinnamon_that_follow_a_dough_are_rolled_up_in_it(steps):
    told = steps("bread", "", *DOUGH, "sugar:ground", "butter:melted", "butter:softened", "brown sugar:ground",
                 "cinnamon:ground", "powdered sugar:ground", "cream cheese:creamy")  # fmt: skip
    kneaded = first_inputs(told, "knead")
    assert {"cinnamon", "brown sugar", "cream cheese"}.isdisjoint(kneaded)
    assert motions(told).index("roll") < motions(told).index("bake")
    assert {"powdered sugar", "cream cheese"}.isdisjoint(inside(told, "bake"))


def test_a_filling_is_closed_in_flat_bread_that_is_fried(steps):
    told = steps("bread", "Aloo Paratha", "flour:powder", "water:liquid", "salt:granulated", "potatoes:boiled, mashed",
                 "green chili:chopped", "ghee:creamy")  # fmt: skip
    assert "green chili" not in first_inputs(told, "knead")
    assert motions(told).index("fold and pinch") < motions(told).index("flip")


def test_milk_is_hot_before_starch_makes_a_dough_of_it(steps):
    told = steps("bread", "Pao de Queijo", "tapioca flour:powder", "milk:liquid", "oil:liquid", "eggs:uncooked",
                 "cheese:grated")  # fmt: skip
    assert first(told, "milk", "cook and stir") < first(told, "cheese", "mix") < motions(told).index("shape")


def test_caramel_is_cooked_and_chocolate_melted_on_a_baked_base(steps):
    told = steps("cookie", "Millionaire's Shortbread", "flour:plain", "sugar:granulated", "butter:softened",
                 "butter:unmelted:caramel", "condensed milk:syrup:caramel", "chocolate:dark:topping")  # fmt: skip
    assert {"condensed milk", "chocolate"}.isdisjoint(heated(told))
    assert motions(told).index("bake") < first(told, "condensed milk", "cook and stir") < motions(told).index("chill")


def test_cocoa_for_rolling_covers_truffles_that_have_their_form(steps):
    told = steps("cookie", "Chocolate Truffles", "dark chocolate:chopped", "heavy cream:creamy", "cocoa:powder:rolling")
    assert "cocoa" not in inside(told, "cook and stir")
    assert motions(told).index("shape") < first(told, "cocoa", "dip")


def test_eggs_set_in_the_cups_of_a_tin(steps):
    told = steps("muffin", "Egg Muffins", "eggs:uncooked", "milk:liquid", "spinach:chopped", "cheddar:shredded")
    assert "blend" not in motions(told)
    assert any(node.label == "muffin pan" for inputs, motion, outs in told if motion == "bake" for node in outs)


def test_flakes_of_salt_lie_on_a_bread_that_has_salt_in_it(steps):
    told = steps("bread", "", *DOUGH, "rosemary:chopped", "salt:flakes")
    assert motions(told).index("shape") < max(n for n, (inputs, _, _) in enumerate(told) if "salt" in inputs)


def test_a_cooked_cream_and_a_glaze_of_chocolate_come_on_a_cold_cake(steps):
    cream = ("half and half:liquid:cream", "egg yolks:uncooked:cream", "sugar:granulated:cream", "flour:powder:cream")
    glaze = ("heavy cream:liquid:glaze", "dark chocolate:bar:glaze")
    told = steps("cake", "Boston Cream Pie", *BATTER, *cream, *glaze)
    assert {"egg yolks", "half and half"} <= inside(told, "cook and stir")
    assert {"egg yolks", "heavy cream", "dark chocolate"}.isdisjoint(inside(told, "bake"))


def test_whites_that_are_listed_beside_yolks_are_whipped_and_folded_in_last(steps):
    told = steps("cake", "Chiffon Cake", "flour:powder", "sugar:granulated", "oil:liquid", "water:liquid",
                 "egg yolks:uncooked", "egg whites:uncooked", "baking powder:powder")  # fmt: skip
    assert first(told, "egg whites", "beat") < first(told, "egg whites", "fold") < motions(told).index("bake")


def test_ice_cream_lies_on_crumbs_and_freezes(steps):
    told = steps("cake", "", "oreo:crushed", "butter:melted", "ice cream:creamy", "chocolate syrup:thick sauce")
    assert "bake" not in motions(told)
    assert {"oreo", "butter"} == inside(told, "press")


@pytest.mark.parametrize("word", ["rolling", "coating"])
def test_what_is_dropped_from_a_spoon_is_shaped_before_it_is_rolled_in_anything(steps, word):
    told = steps("cookie", "Molasses Drops", *BATTER, f"powdered sugar:powder:{word}")
    assert motions(told).index("shape") < motions(told).index("dip") < motions(told).index("bake")


def test_dough_that_nothing_raises_is_rolled_thin_and_cooked_in_a_pan(steps):
    told = steps("bread", "", "flour:ground", "salt:ground", "water:juice", "oil:juice", "onion:chopped")
    assert motions(told).index("knead") < motions(told).index("roll") < motions(told).index("flip")
    assert "bake" not in motions(told)


def test_sausage_is_fried_before_it_comes_to_a_batter(steps):
    told = steps("muffin", "Breakfast Muffins", "sausage:raw", "baking mix:powder", "eggs:uncooked", "milk:liquid")
    assert first(told, "sausage", "cook") < first(told, "eggs", "whisk")


def test_cake_is_crumbled_and_shaped_before_it_is_dipped(steps):
    told = steps("cake", "Cake Pops", "cake mix:powder", "eggs:uncooked", "oil:liquid", "frosting:creamy",
                 "chocolate:bar")  # fmt: skip
    assert motions(told).index("bake") < motions(told).index("shape") < motions(told).index("chill")
    assert "frosting" not in inside(told, "bake")


def test_what_a_recipe_tells_of_a_line_of_its_technique_joins_it_once(steps):
    told = steps("cake", "Basbousa", "semolina:powder", "sugar:granulated", "yogurt:creamy", "butter:melted",
                 "sugar:granulated:syrup", "water:liquid:syrup")  # fmt: skip
    into = [inputs for inputs, motion, outs in told if motion == "pour" and {"sugar", "saucepan"} <= inputs]
    assert len([one for one in into if "container" in one]) == 1


def test_butter_and_syrup_are_hot_when_oats_meet_them(steps):
    told = steps("cookie", "Anzac Biscuits", "oats:rolled", "flour:powder", "coconut:flakes", "sugar:granulated",
                 "butter:unmelted", "golden syrup:thick liquid", "baking soda:powder", "water:boiling")  # fmt: skip
    assert first(told, "golden syrup", "cook and stir") < motions(told).index("shape") < motions(told).index("bake")


def test_buns_for_sausages_need_none(steps):
    told = steps("bread", "Hot Dog Buns", *DOUGH, "milk:juice", "butter:softened")
    assert "bake" in motions(told)


def test_gelatin_in_boiling_water_soaks_a_cake_that_is_baked(steps):
    told = steps("cake", "", "cake mix:ground", "egg:whole raw", "oil:juice", "water:juice", "gelatin:ground",
                 "water:boiling", "whipped topping:whipped")  # fmt: skip
    assert {"gelatin", "whipped topping"}.isdisjoint(inside(told, "bake"))
    assert motions(told).index("bake") < first(told, "gelatin", "stir") < motions(told).index("chill")


def test_soft_cheese_and_eggs_are_baked_on_crumbs_that_are_pressed_by_themselves(steps):
    told = steps("cake", "Cheesecake", "graham crackers:crumbs", "butter:melted", "cream cheese:softened",
                 "sugar:granulated", "eggs:uncooked")  # fmt: skip
    assert {"cream cheese", "eggs"}.isdisjoint(inside(told, "press"))
    assert first(told, "cream cheese", "blend") < first(told, "eggs", "whisk") < motions(told).index("bake")


def test_half_the_crumbs_of_oats_lie_on_jam(steps):
    told = steps("cake", "", "flour:ground", "oats:rolled", "brown sugar:ground", "butter:melted", "jam:thick sauce")
    assert "jam" not in inside(told, "press")
    assert "jam" in inside(told, "bake")


def test_the_swirl_of_a_loaf_is_rolled_up_in_its_dough(steps):
    told = steps("bread", "Cinnamon Bread", *DOUGH, "butter:softened", "sugar:granulated:filling",
                 "cinnamon:ground:filling")  # fmt: skip
    assert "cinnamon" not in first_inputs(told, "knead")
    assert any(node.container == "loaf pan" for _, one, outs in told if one == "bake" for node in outs)


def test_chocolate_for_dipping_is_melted_for_what_is_baked_and_cold(steps):
    told = steps("cookie", "Shortbread", "flour:powder", "butter:softened", "sugar:granulated",
                 "dark chocolate:bar:dipping")  # fmt: skip
    assert "dark chocolate" not in inside(told, "bake")
    assert motions(told).index("bake") < max(n for n, (inputs, _, _) in enumerate(told) if "dark chocolate" in inputs)


def test_a_glaze_comes_on_fritters_that_are_fried_and_a_dip_lies_beside(steps):
    told = steps("bread", "Apple Fritters", "flour:powder", "baking powder:powder", "eggs:uncooked", "milk:liquid",
                 "apples:diced", "oil:liquid:frying", "powdered sugar:powder:glaze", "milk:liquid:glaze")  # fmt: skip
    assert first_inputs(told, "stir") >= {"powdered sugar", "milk"}
    dipped = steps("bread", "Cheesy Breadsticks", "pizza dough:whole", "butter:melted", "mozzarella:shredded",
                   "marinara sauce:sauce:dipping")  # fmt: skip
    assert "marinara sauce" not in inside(dipped, "bake")


def test_ice_cream_is_frozen_before_beaten_whites_are_browned_on_it(steps):
    told = steps("cake", "Baked Alaska", "sponge cake:whole", "ice cream:frozen", "egg whites:uncooked",
                 "sugar:granulated")  # fmt: skip
    assert motions(told).index("whisk") < motions(told).index("bake")
    assert first(told, "ice cream", "freeze") < motions(told).index("bake")


def test_milk_as_thick_as_a_syrup_soaks_a_cake_that_is_baked(steps):
    told = steps("cake", "", "egg:whole raw", "sugar:ground", "flour:ground", "baking powder:ground", "milk:whole",
                 "milk:thick liquid", "cream:whipped")  # fmt: skip
    baked = next(place for place, (_, motion, _) in enumerate(told) if motion == "bake")
    assert any("milk" in taken for taken, motion, _ in told[baked:] if motion.startswith("pour"))
    assert "cream" not in inside(told, "bake")


def test_slices_on_brown_sugar_lie_under_the_batter_of_white_sugar(steps):
    told = steps("cake", "", "pineapple:sliced", "cherry:whole fruit", "brown sugar:ground", "butter:juice",
                 "flour:ground", "baking powder:ground", "sugar:ground", "egg:whole raw", "milk:juice")  # fmt: skip
    assert {"pineapple", "brown sugar"}.isdisjoint(inside(told, "fold"))
    assert {"sugar", "flour", "egg"} <= inside(told, "fold")


CAKE = ("flour:powder", "sugar:granulated", "cocoa:powder", "baking soda:powder", "oil:liquid", "water:liquid")


def test_a_cake_is_cut_when_its_icing_is_on_it(steps):
    icing = ("butter:melted:icing", "cocoa:powder:icing", "powdered sugar:powder:icing")
    told = steps("cake", "Wacky Cake with Cocoa Icing", *CAKE, "vinegar:liquid", *icing)
    spread = max(place for place, (taken, one, _) in enumerate(told) if one in {"spread", "pour"} and "cake" in taken)
    assert all(place > spread for place, (_, one, _) in enumerate(told) if one == "cut")


def test_whites_are_folded_into_the_batter_where_their_yolks_are_for_the_filling(steps):
    batter = ("cake flour:powder", "baking powder:powder", "butter:softened", "sugar:granulated", "milk:liquid")
    filling = ("egg yolks:uncooked:filling", "sugar:granulated:filling", "butter:unmelted:filling")
    told = steps("cake", "Lane Cake", *batter, "egg whites:uncooked", *filling, "raisins:chopped:filling")
    assert first(told, "egg whites", "fold") < motions(told).index("bake") < first(told, "egg yolks", "cook and stir")


def test_butter_and_sugar_of_an_upside_down_cake_lie_under_its_fruit_and_make_its_batter(steps):
    told = steps("cake", "Plum Upside-Down Cake", "butter:unmelted", "brown sugar:granulated", "plums:sliced",
                 "flour:powder", "baking powder:powder", "butter:softened", "sugar:granulated", "eggs:uncooked",
                 "milk:liquid")  # fmt: skip
    assert "spread" not in motions(told)[motions(told).index("bake") :]
    assert inside(told, "whisk") >= {"butter", "sugar", "eggs"}
    assert first(told, "brown sugar", "pour") < first(told, "plums", "pour")


def test_nuts_that_are_listed_once_more_at_the_end_come_on_a_batter(steps):
    told = steps("cake", "Dundee Cake", "butter:softened", "sugar:granulated", "eggs:uncooked", "flour:powder",
                 "almonds:ground", "currants:dried", "almonds:blanched")  # fmt: skip
    assert any(one == "pour" and "almonds" in taken and outputs[0].label == "cake pan" for taken, one, outputs in told)


def test_a_garnish_of_ground_nuts_comes_on_a_cake_when_it_is_done(steps):
    told = steps("cake", "Revani", "eggs:uncooked", "sugar:granulated", "semolina:powder", "flour:powder",
                 "sugar:granulated:syrup", "water:liquid:syrup", "pistachios:ground:garnish")  # fmt: skip
    assert "pistachios" not in inside(told, "bake")


def test_dough_in_pieces_is_turned_in_what_is_melted(steps):
    told = steps("bread", "Bubble Loaf with Garlic", "bread flour:powder", "yeast:powder", "milk:warm",
                 "butter:melted", "garlic:minced", "Parmesan:grated")  # fmt: skip
    assert {"butter", "garlic", "Parmesan"}.isdisjoint(inside(told, "knead"))
    assert motions(told).index("cut") < motions(told).index("dip") < motions(told).index("bake")


def test_milk_and_butter_are_made_hot_for_a_cake_that_is_called_so(steps):
    told = steps("cake", "Hot Milk Cake", "eggs:uncooked", "sugar:granulated", "flour:powder", "baking powder:powder",
                 "milk:liquid", "butter:unmelted")  # fmt: skip
    assert inside(told, "cook and stir") == {"milk", "butter"}


def test_cereal_takes_up_its_boiling_water_before_it_comes_to_a_batter(steps):
    told = steps("muffin", "Bran Muffins", "bran cereal:rolled", "water:boiling", "shortening:creamy",
                 "sugar:granulated", "eggs:uncooked", "buttermilk:liquid", "flour:powder",
                 "baking soda:powder")  # fmt: skip
    assert inside(told, "stir") >= {"bran cereal", "water"}
    assert first(told, "bran cereal", "stir") < first(told, "eggs", "blend")


def test_dough_of_pinwheels_is_rolled_up_before_it_is_cut(steps):
    told = steps("cookie", "Date Pinwheels", "dates:chopped", "water:liquid", "butter:softened", "sugar:granulated",
                 "eggs:uncooked", "flour:powder")  # fmt: skip
    assert motions(told).count("roll") == 2
    assert "dates" in inside(told, "cook and stir")
    assert motions(told).index("chill") < len(motions(told)) - motions(told)[::-1].index("cut")
