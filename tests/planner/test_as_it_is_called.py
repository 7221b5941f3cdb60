"""A dish that is called so is made so: shaped, rubbed, rolled, laid in layers, whatever the recorded dish did."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def comes(told, food, vessel):
    """At which step a food comes into or onto a vessel."""
    return next(n for n, (inputs, motion, _) in enumerate(told) if {food, vessel} <= inputs and motion in CARRIED)


def cooked(told, food):
    """The motions over heat by which a food is worked on under its own name."""
    return [
        motion for inputs, motion, _ in told if food in inputs and motion in {"boil", "cook", "cook and stir", "bake"}
    ]


HEATS = {"bake", "boil", "cook", "cook and stir"}
CARRIED = {"pick-and-place", "pour", "put"}
MEATBALLS = ("ground beef:raw", "breadcrumbs:crumbs", "egg:whole", "onion:minced", "butter:stick", "beef broth:liquid")


def test_meatballs_are_mixed_shaped_and_fried_before_their_sauce_comes(steps):
    told = steps("meatball", "Swedish Meatballs", *MEATBALLS)
    assert inside(told, "shape") == {"ground beef", "breadcrumbs", "egg", "onion"}
    assert first(told, "mixture", "shape") < motions(told).index("flip") < first(told, "beef broth", "pour")


def test_balls_come_into_a_soup_when_it_boils(steps):
    told = steps("soup", "Meatball Soup", "ground beef:raw", "breadcrumbs:crumbs", "carrot:sliced", "beef broth:liquid",
                 "olive oil:liquid")  # fmt: skip
    assert inside(told, "shape") == {"ground beef", "breadcrumbs"}
    assert motions(told).index("simmer") < max(place for place, one in enumerate(told) if "meatballs" in one[0] and
                                               "pot" in one[0])  # fmt: skip
    assert first(told, "beef broth", "pour") < motions(told).index("simmer")


def test_without_bread_a_burger_is_no_pile(steps):
    told = steps("burger", "Hamburg Steak", "ground beef:raw", "panko:crumbs", "egg:whole", "butter:stick")
    assert "flip" in motions(told)
    assert not [inputs for inputs, motion, _ in told if motion == "spread" and "butter" in inputs]


def test_roots_are_cooked_and_mashed_before_they_are_shaped(steps):
    told = steps("burger", "Sweet Potato Burgers", "sweet potato:peeled", "black beans:drained", "oats:rolled",
                 "buns:whole", "oil:liquid")  # fmt: skip
    assert first(told, "sweet potato", "boil") < first(told, "sweet potato", "mash") < motions(told).index("shape")
    assert {"oats", "black beans", "sweet potato"} <= inside(told, "shape")


def test_scones_are_rubbed_rolled_out_and_cut(steps):
    told = steps("bread", "Cream Scones", "flour:powder", "sugar:granulated", "baking powder:powder", "butter:cold",
                 "heavy cream:liquid")  # fmt: skip
    order = [motion for motion in motions(told) if motion in {"mix", "knead", "roll", "cut", "bake"}]
    assert order == ["mix", "knead", "roll", "cut", "bake"]
    assert "blend" not in motions(told)


def test_pastry_lines_the_dish_and_the_fruit_comes_into_it(steps):
    told = steps("pie", "Apple Pie", "flour:powder", "butter:cold", "water:cold", "apples:sliced", "sugar:granulated")
    assert inside(told, "knead") == {"flour", "butter", "water"}
    assert motions(told).index("roll") < motions(told).index("bake")
    assert not [inputs for inputs, motion, _ in told if motion == "knead" and "apples" in inputs]


def test_bought_pastry_is_made_by_nobody(steps):
    told = steps(
        "pie", "Apple Pie", "pie crust:raw", "flour:powder", "butter:cold", "apples:sliced", "sugar:granulated"
    )
    assert {"knead", "roll"}.isdisjoint(motions(told))


def test_stewed_filling_is_covered(steps):
    told = steps("pie", "Beef Pot Pie", "beef:cubed", "onion:chopped", "broth:liquid", "flour:powder", "butter:cold",
                 "egg:beaten")  # fmt: skip
    assert inside(told, "knead") == {"flour", "butter", "egg"}
    assert motions(told).index("simmer") < motions(told).index("knead") < motions(told).index("bake")


def test_crumble_is_strewn_on_fruit(steps):
    told = steps("pie", "Apple Crumble", "apples:sliced", "flour:powder", "brown sugar:granulated", "butter:stick")
    dish = [outputs for inputs, _, outputs in told if "apples" in inputs and "baking dish" in inputs]
    assert {food for node in dish[0] for food in node.ingredients} == {"apples"}


def test_crumbs_are_pressed_to_a_base_and_cream_that_is_to_be_whipped_is_whipped(steps):
    told = steps("pie", "Key Lime Pie", "graham cracker crumbs:crumbs", "butter:melted", "egg yolks:whole",
                 "condensed milk:thick liquid", "lime juice:juice", "whipping cream:chilled")  # fmt: skip
    assert inside(told, "press") == {"graham cracker crumbs", "butter"}
    assert [motion for inputs, motion, _ in told if "whipping cream" in inputs and motion in {"beat", "whip", "whisk"}]
    assert motions(told).index("bake") < first(told, "whipping cream", "pour") < len(told)


def test_enchiladas_are_rolled_and_baked_under_their_sauce(steps):
    told = steps("chicken", "Chicken Enchiladas", "cooked chicken:shredded", "tortillas:plain", "enchilada sauce:sauce",
                 "cheddar:shredded")  # fmt: skip
    assert motions(told).index("roll") < first(told, "enchilada sauce", "pour") < motions(told).index("bake")
    assert set(cooked(told, "cooked chicken")) <= {"bake"}


def test_lasagna_is_laid_and_not_stirred(steps):
    told = steps("pasta", "Lasagna", "ground beef:raw", "crushed tomatoes:canned", "lasagna noodles:uncooked",
                 "ricotta:creamy", "egg:whole", "mozzarella:shredded")  # fmt: skip
    assert not [inputs for inputs, motion, _ in told if motion == "cook and stir" and "lasagna noodles" in inputs]
    assert first(told, "mozzarella", "pour") > first(told, "ricotta", "mix")


def test_mash_covers_what_is_called_so_though_nobody_says_mashed(steps):
    told = steps("pie", "Shepherd's Pie", "ground lamb:raw", "onion:chopped", "flour:powder", "beef stock:liquid",
                 "potatoes:peeled", "butter:stick")  # fmt: skip
    assert first(told, "potatoes", "mash") < motions(told).index("bake")
    assert "knead" not in motions(told)


def test_a_pancake_filed_under_cakes_is_fried_on_both_sides(steps):
    told = steps(
        "cake", "Pancakes", "flour:powder", "baking powder:powder", "egg:whole", "milk:liquid", "butter:melted"
    )
    assert "bake" not in motions(told)
    assert "cook" in motions(told)[: motions(told).index("flip")]
    assert told[-1][2][1].label == "pancake"


def test_a_title_that_calls_a_food_roasted_has_it_baked_alone(steps):
    told = steps(
        "salad", "Roasted Beet Salad", "beets:whole", "arugula:leaves", "goat cheese:block", "olive oil:liquid"
    )
    assert cooked(told, "beets") == ["bake"]
    assert [motion for inputs, motion, _ in told if "goat cheese" in inputs and motion != "pour"]


def test_a_steak_for_a_salad_is_fried_whole_and_cut_then(steps):
    told = steps("salad", "Steak Salad", "flank steak:raw", "lettuce:chopped", "olive oil:liquid", "vinegar:liquid")
    cut = [place for place, (inputs, _, _) in enumerate(told) if {"flank steak", "knife"} <= inputs]
    assert motions(told).index("cook") < min(cut)


def test_chicken_called_fried_is_coated_and_fried(steps):
    told = steps("chicken", "Buttermilk Fried Chicken", "chicken:cut", "buttermilk:liquid", "flour:powder",
                 "paprika:ground", "oil:liquid")  # fmt: skip
    assert "bake" not in motions(told)
    assert inside(told, "flip") >= {"chicken", "flour", "buttermilk"}


def test_what_is_called_sheet_pan_comes_out_of_the_oven(steps):
    told = steps("chicken", "Sheet Pan Drumsticks", "chicken drumsticks:raw", "olive oil:liquid", "dried oregano:dried",
                 "carrots:sliced")  # fmt: skip
    assert "bake" in motions(told)
    assert first(told, "dried oregano", "sprinkle") < motions(told).index("bake")


def test_scallops_are_seared_in_one_layer_and_mussels_are_not_turned(steps):
    told = steps("seafood", "Seared Scallops", "scallops:raw", "butter:stick", "garlic:minced")
    assert "flip" in motions(told)
    told = steps("seafood", "Mussels in Cider", "mussels:raw", "butter:stick", "shallots:chopped", "white wine:liquid")
    assert "flip" not in motions(told)
    assert comes(told, "shallots", "cooking pan") < comes(told, "mussels", "cooking pan")


def test_garlic_is_minced_before_it_is_eaten_raw(steps):
    told = steps("salad", "Caesar Salad", "romaine:chopped", "garlic:clove", "parmesan:shaved", "olive oil:liquid",
                 "lemon juice:juice")  # fmt: skip
    assert [node for _, _, outputs in told for node in outputs if node.label == "garlic" and "minced" in node.states]


def test_whole_spices_bloom_in_the_fat(steps):
    told = steps("vegetables", "Spinach Paneer", "spinach:washed", "paneer:cubed", "oil:liquid", "cumin seeds:whole",
                 "onion:chopped", "cream:liquid")  # fmt: skip
    seeds = next(place for place, (inputs, _, _) in enumerate(told) if "cumin seeds" in inputs)
    spinach = next(place for place, (inputs, _, _) in enumerate(told) if {"spinach", "cooking pan"} <= inputs)
    assert seeds < spinach


def test_lentils_are_boiled_before_the_rice_that_is_done_long_before_them(steps):
    told = steps("rice", "Mujaddara", "brown lentils:dried", "rice:uncooked", "onions:sliced", "oil:liquid",
                 "water:liquid")  # fmt: skip
    assert cooked(told, "brown lentils") == ["cook"]
    assert first(told, "brown lentils", "cook") < first(told, "rice", "pour")


def test_wedges_lie_in_the_bowl_of_a_soup(steps):
    told = steps("soup", "Harira", "lamb:cubed", "lentils:dried", "water:liquid", "onion:chopped", "lemon wedges:whole")
    assert {"bowl", "lemon wedges"} <= told[-1][0]
    assert not [inputs for inputs, _, _ in told if "plate" in inputs]


def test_wedges_are_served_beside_what_is_baked(steps):
    told = steps("pizza", "Lamb Pizza", "pizza dough:raw", "ground lamb:cooked", "onion:grated", "lemon wedges:whole")
    assert comes(told, "lemon wedges", "plate") > motions(told).index("bake")


def test_a_smoothie_is_blended_though_its_video_strains_it(steps):
    told = steps(
        "drinks", "Watermelon Agua Fresca", "watermelon:cubed", "water:cold", "lime juice:juice", "sugar:granulated"
    )
    assert "blend" in motions(told)
    assert told[-1][2][0].label == "drinking glass"


# --- what the words of a title ask to be done ---

CAKE = ("flour:powder", "sugar:granulated", "eggs:uncooked", "milk:liquid", "baking powder:powder", "salt:granulated")


def test_what_is_called_upside_down_is_turned_over_when_it_is_done(steps):
    told = steps("cake", "Pear Upside-Down Cake", "butter:melted", "brown sugar:granulated", "pears:sliced", *CAKE)
    assert motions(told).index("bake") < motions(told).index("flip and place")


def test_a_thumbprint_is_pressed_before_the_jam_and_the_oven(steps):
    told = steps("cookie", "Jam Thumbprints", "butter:softened", "sugar:granulated", "egg:uncooked", "flour:powder",
                 "apricot jam:jelly")  # fmt: skip
    jam = next(place for place, (inputs, _, _) in enumerate(told) if "apricot jam" in inputs)
    assert motions(told).index("press") < jam < motions(told).index("bake")


def test_what_is_called_pulled_comes_in_shreds_out_of_the_pot(steps):
    told = steps("chicken", "Pulled BBQ Chicken", "chicken breasts:raw", "barbecue sauce:thick liquid",
                 "chicken broth:liquid")  # fmt: skip
    assert motions(told).index("simmer") < motions(told).index("pull apart")
    assert "shredded" in {state for node in told[motions(told).index("pull apart")][2] for state in node.states}


def test_a_word_of_the_title_that_no_step_can_do_is_said(public_plans):
    plan = public_plans("chicken", "Chicken Kebabs", "chicken breast:cubed", "olive oil:liquid", "oregano:dried")
    (told,) = plan.assumptions
    assert (told.node.label, "“kebab”" in told.why) == ("chicken breast", True)


def test_a_food_that_is_asked_twice_is_two_portions_already(steps):
    told = steps("cake", "Pear Upside-Down Cake", "butter:melted", "brown sugar:granulated", "pears:sliced",
                 "butter:softened", *CAKE)  # fmt: skip
    comes = [vessel for inputs, motion, _ in told for vessel in ("cake pan", "mixing bowl")
             if motion in CARRIED and {vessel, "butter"} <= inputs]  # fmt: skip
    assert sorted(comes) == ["cake pan", "mixing bowl"]
    assert [motion for inputs, motion, _ in told if "shaker" in inputs] == ["sprinkle"]


# --- what swells ---


def test_grain_for_a_pudding_swells_in_its_milk(steps):
    told = steps("pudding", "Rice Pudding", "white rice:uncooked", "milk:liquid", "sugar:granulated", "eggs:beaten")
    assert not [inputs for inputs, _, _ in told if "strainer" in inputs or "water" in inputs]
    assert first(told, "milk", "cook and stir") < next(n for n, one in enumerate(told) if {"eggs", "pot"} <= one[0])


@pytest.mark.parametrize(
    ("title", "pasta", "drained"),
    [
        ("One-Pot Beef Macaroni", "elbow macaroni", False),
        ("Beef Macaroni", "elbow macaroni", True),
        ("Beef Orzo", "orzo", False),
    ],
)
def test_pasta_is_drained_unless_it_soaks_up_what_the_dish_is_made_of(steps, title, pasta, drained):
    told = steps("pasta", title, "ground beef:raw", "onion:chopped", f"{pasta}:uncooked", "beef broth:liquid",
                 "olive oil:liquid")  # fmt: skip
    assert any({"strainer", pasta} <= inputs for inputs, _, _ in told) is drained


def test_a_grain_that_thickens_a_filling_is_not_boiled(steps):
    told = steps("pie", "Cherry Pie", "pie crust:unbaked", "cherries:pitted", "quick-cooking tapioca:uncooked",
                 "sugar:granulated")  # fmt: skip
    assert cooked(told, "quick-cooking tapioca") == []


# --- what is drunk ---


def test_iced_tea_is_drawn_and_cooled_before_it_is_poured_on_ice_out_of_a_bag(steps):
    told = steps("drinks", "Peach Iced Tea", "water:liquid", "tea bags:dried", "peaches:sliced", "ice cubes:frozen",
                 "sugar:granulated")  # fmt: skip
    ice = next(place for place, (inputs, _, _) in enumerate(told) if {"ice cubes", "bag"} <= inputs)
    assert first(told, "tea bags", "cook") < motions(told).index("cool down") < ice


def test_slices_and_spices_stay_in_a_strainer_when_a_hot_drink_is_poured(steps):
    told = steps("drinks", "Mulled Cider", "apple cider:liquid", "orange:sliced", "cinnamon sticks:whole",
                 "ginger:sliced", "brown sugar:granulated")  # fmt: skip
    (left,) = [{node.label for node in outputs} for _, motion, outputs in told if motion == "pour and strain"]
    assert {"orange", "cinnamon sticks", "ginger"} <= left


def test_pulled_flesh_for_a_roll_is_stewed_whole_and_pulled_before_it_lies_there(steps):
    told = steps("sandwich", "Pulled Pork Sandwiches", "pork shoulder:raw", "barbecue sauce:thick liquid",
                 "buns:whole", "coleslaw:whole")  # fmt: skip
    assert first(told, "pork shoulder", "simmer") < motions(told).index("pull apart") < first(told, "coleslaw", "pour")
    assert not [motion for inputs, motion, _ in told if motion in {"chop", "cut"} and "pork shoulder" in inputs]


# --- flour and grain ---


def test_meal_for_a_pizza_comes_under_its_dough(steps):
    told = steps("pizza", "Cheese Pizza", "pizza dough:whole", "cornmeal:ground", "tomato sauce:sauce",
                 "mozzarella:shredded")  # fmt: skip
    dough = next(place for place, (inputs, _, _) in enumerate(told) if {"pizza dough", "pizza pan"} <= inputs)
    assert comes(told, "cornmeal", "pizza pan") < dough


def test_boiling_water_soaks_oats_and_cools_before_it_meets_yeast(steps):
    told = steps("bread", "Oatmeal Bread", "oats:rolled", "water:boiling", "yeast:powder", "water:warm",
                 "salt:granulated", "honey:thick liquid", "flour:powder")  # fmt: skip
    assert first(told, "oats", "stir") < motions(told).index("cool down") < motions(told).index("knead")


def test_tortillas_and_what_is_fried_lie_in_layers_though_no_video_makes_a_casserole(steps):
    told = steps("casserole", "King Ranch Casserole", "butter:unmelted", "onion:chopped",
                 "cream of chicken soup:canned", "cooked chicken:shredded", "corn tortillas:cut",
                 "cheddar:shredded")  # fmt: skip
    laid = [place for place, (inputs, _, _) in enumerate(told) if {"corn tortillas", "baking dish"} <= inputs]
    soup = next(place for place, (inputs, _, _) in enumerate(told) if "cream of chicken soup" in inputs)
    assert soup < laid[0] < laid[1] < first(told, "corn tortillas", "bake")


def test_what_is_made_for_many_is_served_in_a_jug(steps):
    told = steps("drinks", "Lemonade", "lemons:juiced", "sugar:granulated", "water:cold", "ice cubes:frozen")
    assert "pitcher" in told[-1][0]


def test_potatoes_baked_twice_are_mashed_in_their_halves(steps):
    told = steps("potatoes", "Twice-Baked Potatoes", "russet potatoes:whole", "sour cream:creamy", "cheddar:shredded")
    assert first(told, "russet potatoes", "cut") < first(told, "russet potatoes", "mix")
    assert "peel" not in motions(told)
    assert motions(told).count("bake") == 2


def test_what_a_title_calls_boiled_is_boiled(steps):
    told = steps("vegetables", "Boiled Corn", "corn:whole", "butter:unmelted", "salt:granulated")
    assert first(told, "corn", "boil") < motions(told).index("melt")


def test_cheese_comes_over_the_sauce_that_it_browns_on(steps):
    told = steps("pasta", "Stuffed Shells", "jumbo shells:uncooked", "ricotta:creamy", "mozzarella:shredded",
                 "marinara sauce:thick liquid")  # fmt: skip
    comes_at = [comes(told, food, "baking dish") for food in ("marinara sauce", "jumbo shells", "mozzarella")]
    assert comes_at == sorted(comes_at)


def test_what_is_asked_cold_was_cooked_before(steps):
    told = steps("potatoes", "Fried Potatoes", "potatoes:cooled", "bacon:chopped", "onion:diced", "butter:unmelted")
    assert first(told, "potatoes", "boil") < motions(told).index("melt")


def test_beer_bread_is_stirred_and_its_butter_comes_over_it(steps):
    told = steps("bread", "Beer Bread", "self-rising flour:powder", "sugar:granulated", "beer:liquid", "butter:melted")
    assert not {"blend", "beat"} & set(motions(told))
    assert first(told, "beer", "stir") < comes(told, "butter", "loaf pan") < motions(told).index("bake")


def test_what_is_served_with_wedges_is_brought_to_one_place_only(steps):
    told = steps("potatoes", "Lemon Roasted Potatoes", "russet potatoes:cut", "olive oil:liquid",
                 "chicken broth:liquid", "garlic:minced", "Lemon wedges:wedge")  # fmt: skip
    assert not [inputs for inputs, _, _ in told if {"bowl", "plate"} <= inputs]


def test_what_is_taken_in_pieces_that_nobody_makes_comes_out_of_what_it_is_sold_in(steps):
    told = steps("salad", "Caesar Salad", "romaine lettuce:torn", "anchovy fillets:mashed", "olive oil:liquid",
                 "lemon juice:juice", "parmesan cheese:shaved")  # fmt: skip
    assert [inputs for inputs, _, _ in told if {"anchovy fillets", "can"} <= inputs]
