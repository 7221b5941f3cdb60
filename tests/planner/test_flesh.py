"""Flesh is marinated before it is cooked, and roasts, braises and steaks get what their names promise in its time."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

_MARINADE = ("olive oil:liquid", "lemon juice:juice", "garlic:minced", "oregano:dried", "salt:granulated")


def test_yogurt_marinates_the_meat_of_a_curry_before_anything_is_hot(steps):
    told = steps("chicken", "Chicken Tikka Masala", "chicken thighs:cut", "yogurt:plain", "garam masala:ground",
                 "oil:liquid", "onion:chopped", "garlic:minced", "tomato sauce:sauce", "cream:creamy")  # fmt: skip
    assert {"yogurt", "chicken thighs", "garam masala"} <= inside(told, "chill")
    assert motions(told).index("chill") < motions(told).index("heat") < first(told, "onion", "pour")


def test_what_a_recipe_says_is_for_the_sauce_is_in_no_marinade(steps):
    told = steps("chicken", "Butter Chicken", "chicken thighs:cut:marinade", "yogurt:plain:marinade",
                 "turmeric:ground:marinade", "butter:unmelted:sauce", "garlic:minced:sauce",
                 "canned tomatoes:canned:sauce", "salt:granulated:sauce")  # fmt: skip
    assert inside(told, "chill") == {"chicken thighs", "yogurt", "turmeric"}
    assert first(told, "garlic", "pour") > motions(told).index("melt")


@pytest.mark.parametrize(
    ("dish_type", "title", "meat", "heat"),
    [
        ("chicken", "Greek Grilled Chicken", "chicken breasts:raw", "broil"),
        ("chicken", "Greek Chicken", "chicken breasts:raw", "cook"),
        ("chicken", "Greek Chicken", "chicken drumsticks:raw", "bake"),
        ("pork", "Greek Pork", "pork loin:cubed", "cook and stir"),
        ("pork", "Souvlaki", "pork loin:cubed", "broil"),
    ],
)
def test_flesh_with_nothing_but_what_marinates_it_lies_in_that_first(steps, dish_type, title, meat, heat):
    told = steps(dish_type, title, meat, *_MARINADE, "pita:plain:serving")
    assert {"lemon juice", "garlic", meat.partition(":")[0]} <= inside(told, "chill")
    assert "pita" not in inside(told, "chill")
    assert motions(told).index("chill") < motions(told).index(heat)


def test_vegetables_of_fajitas_are_fried_with_what_was_marinated(steps):
    told = steps("steak", "Steak Fajitas", "skirt steak:raw", "lime juice:juice", "oil:liquid", "cumin:ground",
                 "bell peppers:sliced", "onion:sliced", "flour tortillas:plain", "salsa:sauce:serving")  # fmt: skip
    assert inside(told, "chill") == {"skirt steak", "lime juice", "oil", "cumin"}
    assert {"bell peppers", "onion"} <= inside(told[first(told, "onion", "pour") :], "cook and stir")


def test_no_stew_or_tagine_is_marinated_and_baked(steps):
    told = steps("chicken", "Chicken Tagine", "chicken thighs:raw", "lemon:sliced", "olive oil:liquid",
                 "onions:sliced", "ginger:ground")  # fmt: skip
    assert "chill" not in motions(told)


def test_pulled_meat_is_lifted_out_of_its_liquid_and_comes_back_to_it(steps):
    told = steps("pork", "Pulled Pork", "pork shoulder:raw", "onion:sliced", "paprika:ground", "cider vinegar:liquid",
                 "barbecue sauce:thick liquid", "buns:plain")  # fmt: skip
    order = ["simmer", "remove", "pull apart", "mix", "scoop and pour"]
    assert [motion for motion in motions(told) if motion in order] == order
    (lifted,) = [outputs for _, motion, outputs in told if motion == "remove"]
    assert {(node.label, node.container) for node in lifted} >= {("pork shoulder", "cutting board")}
    assert {"pork shoulder", "onion", "barbecue sauce"} <= inside(told, "mix")


def test_a_joint_is_braised_in_one_piece_carved_and_served_with_its_sauce(steps):
    told = steps("roast", "Pot Roast", "chuck roast:raw", "oil:liquid", "onion:cut", "beef broth:liquid",
                 "carrots:cut", "bay leaves:sprig")  # fmt: skip
    assert motions(told).index("turn off") < first(told, "chuck roast", "slice")
    assert not {"chop", "cut"} & {motion for inputs, motion, _ in told if "chuck roast" in inputs}
    assert [motion for _, motion, _ in told][-2:] == ["pour", "pour"]  # the meat, and over it what it was cooked in


def test_a_roast_is_lifted_off_what_lies_around_it_with_its_rub(steps):
    told = steps("roast", "Roast Leg of Lamb", "leg of lamb:raw", "garlic:minced", "olive oil:liquid", "potatoes:cut",
                 "onions:sliced", "flour:powder:gravy", "lamb stock:liquid:gravy")  # fmt: skip
    board = {food for node in told[first(told, "leg of lamb", "slice")][2] for food in node.ingredients}
    assert {"leg of lamb", "garlic"} <= board
    assert board.isdisjoint({"potatoes", "onions"})
    assert motions(told).index("bake") < first(told, "flour", "beat")


@pytest.mark.parametrize(
    ("meat", "title", "asked"),
    [
        (
            "flank steak",
            "Grilled Steak with Chimichurri",
            ("parsley:chopped:chimichurri", "red wine vinegar:liquid:chimichurri"),
        ),
        ("lamb chops", "Lamb Chops with Mint Sauce", ("mint:chopped:sauce", "vinegar:liquid:sauce")),
        ("ribeye steaks", "Steak with Garlic Butter", ("butter:softened", "garlic:minced")),
    ],
)
def test_raw_sauces_and_butters_are_made_apart_and_never_heated(steps, meat, title, asked):
    told = steps("steak", title, f"{meat}:raw", "oil:liquid", "salt:granulated", *asked)
    sauce = {one.partition(":")[0] for one in asked}
    hot = [inputs for inputs, motion, _ in told if motion in {"cook", "cook and stir", "broil", "melt", "heat"}]
    assert hot
    assert all(sauce.isdisjoint(inputs) for inputs in hot)


def test_ribs_are_rubbed_baked_and_brushed_with_their_sauce(steps):
    told = steps("pork", "BBQ Ribs", "baby back ribs:raw", "brown sugar:granulated", "paprika:ground",
                 "barbecue sauce:thick liquid")  # fmt: skip
    assert motions(told).count("bake") == 2
    assert motions(told).index("bake") < first(told, "barbecue sauce", "brush")


def test_stuffing_is_mixed_and_baked_with_a_whole_bird(steps):
    told = steps("roast", "Roast Chicken with Stuffing", "chicken:whole", "bread cubes:whole", "onion:diced",
                 "butter:unmelted", "sage:chopped", "chicken broth:liquid")  # fmt: skip
    assert {"bread cubes", "onion", "sage"} <= inside(told, "mix")
    assert motions(told).index("mix") < motions(told).index("bake") < first(told, "chicken", "slice")


def test_a_crust_of_two_coats_is_lifted_with_what_was_roasted_under_it(steps):
    told = steps("roast", "Herb Crusted Roast Beef", "eye of round roast:raw", "mustard:creamy", "olive oil:liquid",
                 "thyme:chopped", "garlic:minced")  # fmt: skip
    (board,) = [outputs for inputs, motion, outputs in told if motion == "slice" and "eye of round roast" in inputs]
    assert {food for node in board for food in node.ingredients} >= {"mustard", "thyme"}


def test_minced_meat_with_nothing_that_binds_it_is_fried_loose(steps):
    told = steps("beef", "Picadillo", "ground beef:uncooked", "onion:chopped", "tomato sauce:sauce", "raisins:whole",
                 "oil:liquid")  # fmt: skip
    assert not {"shape", "flip"} & set(motions(told))
    assert {"ground beef", "tomato sauce"} <= inside(told[first(told, "tomato sauce", "pour") :], "cook and stir")


def test_crumbs_coat_a_cutlet_in_a_curry_and_are_not_strewn_on_its_rice(steps):
    told = steps("chicken", "Chicken Katsu Curry", "chicken breasts:raw", "flour:powder", "eggs:beaten",
                 "panko breadcrumbs:crumbs", "oil:liquid:frying", "onion:chopped:sauce", "curry powder:powder:sauce",
                 "chicken stock:liquid:sauce", "rice:steamed:serving")  # fmt: skip
    assert motions(told).count("dip") == 3
    assert first(told, "panko breadcrumbs", "dip") < first(told, "chicken breasts", "flip")


@pytest.mark.parametrize(
    ("title", "meat", "asked", "apart"),
    [
        (
            "Pork Chops with Peach Salsa",
            "pork chops:raw",
            ("peaches:diced:salsa", "red onion:diced:salsa", "lime juice:juice:salsa"),
            "peaches",
        ),
        (
            "Filet Mignon with Bearnaise",
            "filet mignon steaks:raw",
            ("egg yolks:uncooked", "butter:melted", "white wine vinegar:liquid"),
            "egg yolks",
        ),
    ],
)
def test_a_salsa_stays_raw_and_a_bearnaise_has_a_pan_of_its_own(steps, title, meat, asked, apart):
    told = steps("steak", title, meat, "oil:liquid", *asked)
    fried = [inputs for inputs, motion, _ in told if motion in {"cook", "flip"}]
    assert fried
    assert all(apart not in inputs for inputs in fried)


def test_what_is_called_smothered_is_dredged_and_its_cream_is_for_the_sauce(steps):
    told = steps("pork", "Smothered Pork Chops", "pork chops:uncooked", "flour:powder", "paprika:ground",
                 "oil:liquid", "onion:sliced", "chicken broth:liquid", "cream:creamy")  # fmt: skip
    assert first(told, "flour", "mix") < first(told, "pork chops", "dip") < first(told, "cream", "pour")
    assert motions(told).count("dip") == 1


def test_bacon_is_rolled_around_what_is_wrapped_in_it(steps):
    told = steps("pork", "Bacon Wrapped Pork Tenderloin", "pork tenderloin:raw", "bacon:raw",
                 "brown sugar:granulated", "mustard:creamy")  # fmt: skip
    assert {"bacon", "pork tenderloin"} <= inside(told, "roll")
    assert motions(told).index("roll") < motions(told).index("bake") < motions(told).index("slice")


def test_shreds_of_a_taco_are_pulled_and_its_raw_onion_and_lime_come_last(steps):
    told = steps("pork", "Carnitas Tacos", "pork shoulder:cut", "cumin:ground", "chicken broth:liquid",
                 "corn tortillas:plain", "white onion:chopped", "lime:cut")  # fmt: skip
    assert motions(told).index("simmer") < motions(told).index("pull apart") < first(told, "white onion", "pour")


def test_a_sauce_that_a_list_names_beside_a_boiled_joint_is_no_part_of_its_water(steps):
    told = steps("pork", "Gammon with Parsley Sauce", "gammon joint:raw", "onion:halved", "water:liquid",
                 "butter:unmelted:sauce", "flour:powder:sauce", "milk:liquid:sauce")  # fmt: skip
    (mixed,) = [outputs for _, motion, outputs in told if motion == "beat"]
    assert {food for node in mixed for food in node.ingredients} == {"butter", "flour", "milk"}
    assert first(told, "gammon joint", "slice") > first(told, "water", "pour")


def test_flesh_in_slices_with_cream_is_fried_and_not_folded_as_a_filling(steps):
    told = steps("pork", "Pork with Calvados Cream", "pork tenderloin:sliced", "butter:unmelted", "apples:sliced",
                 "cream:creamy")  # fmt: skip
    assert not {"fold", "press", "shape"} & set(motions(told))


def test_a_cream_that_a_list_names_beside_a_roast_is_stirred_cold(steps):
    told = steps("roast", "Roast Rib of Beef with Horseradish", "rib of beef:raw", "oil:liquid", "flour:powder",
                 "salt:granulated", "horseradish:grated:cream", "creme fraiche:creamy:cream")  # fmt: skip
    baked = {food for node in told[motions(told).index("bake")][2] for food in node.ingredients}
    assert "flour" in baked
    assert not {"creme fraiche", "horseradish"} & baked


def test_chops_that_are_called_fried_are_fried_in_their_flour(steps):
    told = steps("pork", "Fried Pork Chops", "pork chops:uncooked", "buttermilk:liquid", "flour:powder",
                 "paprika:ground", "oil:liquid")  # fmt: skip
    assert "bake" not in motions(told)
    assert first(told, "buttermilk", "dip") < first(told, "pork chops", "flip")


def test_yogurt_that_a_curry_is_served_with_marinates_nothing(steps):
    told = steps("chicken", "Chicken Curry", "chicken thighs:cut", "oil:liquid", "onion:chopped", "curry powder:powder",
                 "coconut milk:liquid", "yogurt:plain:serving")  # fmt: skip
    assert "chill" not in motions(told)
    assert first(told, "yogurt", "scoop and pour") > motions(told).index("simmer")


def test_yolks_and_cream_bind_a_stew_at_its_end(steps):
    told = steps("chicken", "Waterzooi", "chicken:uncooked", "butter:unmelted", "leeks:cut", "carrots:cut",
                 "chicken stock:liquid", "potatoes:quartered", "cream:creamy", "egg yolks:uncooked")  # fmt: skip
    assert inside(told, "beat") == {"cream", "egg yolks"}
    assert first(told, "egg mixture", "pour") > motions(told).index("simmer")


def test_meatballs_are_turned_in_the_flour_beside_no_sauce(steps):
    told = steps("meatball", "Keftedes", "minced beef:uncooked", "bread:soaked", "onion:grated", "egg:beaten",
                 "red wine vinegar:liquid", "mint:chopped", "oregano:dried", "salt:granulated", "flour:plain",
                 "oil:liquid")  # fmt: skip
    assert {"mint", "oregano", "red wine vinegar"} <= inside(told, "mix")
    assert "flour" not in inside(told, "mix")
    assert motions(told).index("shape") < motions(told).index("dip") < motions(told).index("cook")


@pytest.mark.parametrize(
    ("dish_type", "foods"),
    [
        ("soup", ("beef brisket:cooked, shredded", "beef stock:liquid", "onion:chopped", "oil:liquid")),
        ("omelette", ("potatoes:cooked, sliced", "bacon:diced", "oil:liquid", "eggs:uncooked")),
    ],
)
def test_cooked_flesh_in_shreds_and_cooked_potatoes_in_slices_are_boiled(steps, dish_type, foods):
    told = steps(dish_type, "", *foods)
    vessels = [set(node.ingredients) for _, _, outputs in told for node in outputs]
    assert {"water", foods[0].partition(":")[0]} in vessels
