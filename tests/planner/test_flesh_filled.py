"""What flesh is stuffed with, wrapped in, laid under or served beside is where the name of the dish says."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions, states_of, taking

pytestmark = pytest.mark.shared_data


def test_cheese_lies_inside_stuffed_balls_and_the_sauce_around_them(steps):
    told = steps("meatball", "Mozzarella Stuffed Meatballs", "ground turkey:raw", "panko:crumbs", "egg:uncooked",
                 "mozzarella:cubed", "olive oil:liquid", "marinara sauce:thick liquid")  # fmt: skip
    assert inside(told, "mix") == {"ground turkey", "panko", "egg"}
    assert "mozzarella" in taking(told, "fold and pinch")
    assert "marinara sauce" in inside(told, "simmer")


@pytest.mark.parametrize("fish", ["flounder:raw", "jumbo shrimp:peeled"])
def test_stuffing_is_stirred_without_the_flesh_it_is_folded_into(steps, fish):
    name = fish.partition(":")[0]
    told = steps("seafood", f"Crab Stuffed {name.title()}", fish, "crabmeat:canned", "crackers:crushed",
                 "butter:unmelted", "onion:minced", "egg:beaten", "lemon juice:juice")  # fmt: skip
    assert "onion" in taking(told, "cook and stir")
    assert {"crabmeat", "crackers"} <= inside(told, "stir")
    assert name in taking(told, "fold") - inside(told, "stir")


def test_cordon_bleu_has_its_cheese_inside_and_its_sauce_on_top(steps):
    told = steps("chicken", "Chicken Cordon Bleu", "chicken breasts:raw", "Swiss cheese:block", "ham:sliced",
                 "flour:powder", "eggs:beaten", "breadcrumbs:crumbs", "butter:unmelted:sauce", "flour:powder:sauce",
                 "milk:liquid:sauce", "mustard:creamy:sauce")  # fmt: skip
    assert inside(told, "roll") == {"chicken breasts", "Swiss cheese", "ham"}
    assert first(told, "mustard", "simmer") < motions(told).index("flip") < len(told) - 1


def test_bacon_is_wrapped_around_a_loaf(steps):
    told = steps("meatloaf", "Bacon Wrapped Meatloaf", "ground beef:raw", "breadcrumbs:crumbs",
                 "bacon:raw", "ketchup:sauce", "brown sugar:granulated")  # fmt: skip
    assert "bacon" in taking(told, "wrap")


def test_mince_fills_a_soaked_casing_that_is_closed(steps):
    told = steps("sausage", "Homemade Pork Sausage", "pork shoulder:minced", "hog casings:soaked", "garlic:minced",
                 "fennel seeds:whole", "salt:granulated")  # fmt: skip
    assert "soaked" in states_of(told, "hog casings")
    assert "hog casings" in taking(told, "fold and pinch")


def test_a_parcel_with_oil_in_it_is_carried_as_one(steps):
    told = steps("seafood", "Salmon Parcels with Ginger", "salmon:raw", "ginger:julienned", "pak choi:halved",
                 "sesame oil:liquid", "mirin:liquid")  # fmt: skip
    assert "parcel" in taking(told, "bake")
    assert not any("cutting board" in told[place][0] for place in range(len(told)) if "mirin" in told[place][0])


def test_no_brush_carries_a_stick_of_spice(steps):
    told = steps("roast", "Roast Duck Legs with Red Cabbage", "duck legs:raw", "red cabbage:shredded",
                 "cinnamon stick:whole", "five spice:ground", "vinegar:liquid", "salt:granulated")  # fmt: skip
    assert "five spice" in inside(told, "brush") | inside(told, "stir")
    assert "cinnamon stick" not in inside(told, "stir")


def test_peas_are_mashed_and_not_battered_with_the_fish(steps):
    told = steps("seafood", "Beer Battered Fish and Chips with Mushy Peas", "cod:raw", "flour:powder", "beer:liquid",
                 "potatoes:cut", "oil:liquid", "peas:frozen", "butter:unmelted")  # fmt: skip
    assert "peas" in taking(told, "mash") - taking(told, "dip")


def test_eggs_and_fried_potatoes_lie_beside_a_steak(steps):
    told = steps("steak", "Bistec a lo Pobre", "sirloin steaks:raw", "potatoes:cut", "onions:sliced", "eggs:uncooked",
                 "oil:liquid")  # fmt: skip
    assert not {"potatoes", "onions"} & taking(told, "flip")
    assert first(told, "eggs", "cook") > first(told, "sirloin steaks", "cook")


def test_frozen_peas_that_are_served_with_a_dish_are_boiled(steps):
    told = steps("chicken", "Hunter's Chicken", "chicken breasts:raw", "bacon:raw", "barbecue sauce:thick liquid",
                 "cheddar:grated", "peas:frozen:serving")  # fmt: skip
    assert "peas" in taking(told, "boil")


def test_fruit_that_a_title_says_is_in_a_glaze_is_in_no_ball(steps):
    told = steps("meatball", "Ham Balls in Pineapple Glaze", "ground ham:raw", "ground pork:raw", "crumbs:crumbs",
                 "eggs:beaten", "milk:liquid", "pineapple:canned", "brown sugar:granulated",
                 "vinegar:liquid")  # fmt: skip
    assert "pineapple" not in inside(told, "shape")


def test_dumplings_are_no_liquid_that_a_bird_is_stewed_in(steps):
    told = steps("chicken", "Chicken and Dumplings", "chicken:cut", "carrots:sliced", "onion:chopped", "bay leaf:whole",
                 "flour:powder", "baking powder:powder", "milk:liquid", "butter:unmelted")  # fmt: skip
    assert first(told, "water", "pour") < motions(told).index("simmer")


@pytest.mark.parametrize("title", ["Pizza Meatloaf", "Cheeseburger Meatloaf", "Taco Meatloaf"])
def test_what_a_loaf_tastes_like_asks_for_no_dough(steps, title):
    told = steps("meatloaf", title, "ground beef:raw", "breadcrumbs:crumbs", "egg:uncooked", "cheddar:shredded")
    assert {"mix", "shape", "bake"} <= set(motions(told))


def test_steak_and_kidney_are_steamed_in_a_crust_of_suet(steps):
    told = steps("steak", "Steak and Kidney Pudding", "stewing steak:diced", "kidney:chopped", "flour:powder",
                 "onion:chopped", "beef stock:liquid", "self-raising flour:powder", "suet:shredded",
                 "water:liquid")  # fmt: skip
    assert {"self-raising flour", "suet"} <= inside(told, "roll")
    assert "pudding basin" in taking(told, "steam")


def test_lentils_of_a_loaf_are_cooked_in_the_stock_listed_for_them(steps):
    told = steps("meatloaf", "Cheesy Lentil Loaf", "red lentils:dried", "vegetable stock:liquid", "onion:chopped",
                 "oil:liquid", "cheddar:grated", "egg:beaten", "breadcrumbs:crumbs")  # fmt: skip
    assert {"red lentils", "vegetable stock"} <= taking(told, "simmer")
    assert "red lentils" in inside(told, "bake")


@pytest.mark.parametrize(
    ("dish_type", "title", "flesh", "sauce"),
    [
        ("roast", "Rib Roast with Horseradish Cream", "rib roast:raw", ("sour cream:creamy", "horseradish:creamy")),
        ("seafood", "Tuna Steaks with Wasabi Mayo", "tuna steaks:raw", ("mayonnaise:creamy", "wasabi paste:creamy")),
    ],
)  # fmt: skip
def test_a_cold_sauce_that_a_title_names_is_stirred_and_not_heated(steps, dish_type, title, flesh, sauce):
    told = steps(dish_type, title, flesh, "olive oil:liquid", "salt:granulated", *sauce)
    names = {one.partition(":")[0] for one in sauce}
    assert names <= taking(told, "stir") | taking(told, "mix")
    assert not names & (taking(told, "bake") | taking(told, "cook") | taking(told, "brush"))


def test_a_ham_is_boiled_with_what_seasons_it_and_roasted_under_its_glaze(steps):
    told = steps("roast", "Honey Roast Gammon", "gammon joint:raw", "onion:halved", "peppercorns:whole",
                 "bay leaves:whole", "honey:thick liquid", "mustard:creamy")  # fmt: skip
    assert "honey" not in taking(told, "boil")
    assert motions(told).index("boil") < motions(told).index("bake")


def test_a_dipping_sauce_is_not_boiled_with_the_meat(steps):
    told = steps("roast", "Lechon Kawali", "pork belly:raw", "water:liquid", "bay leaves:whole", "oil:liquid",
                 "vinegar:liquid:sauce", "soy sauce:liquid:sauce", "onion:chopped:sauce")  # fmt: skip
    assert "vinegar" in inside(told, "stir")
    assert not {"vinegar", "onion"} & taking(told, "simmer")


@pytest.mark.parametrize("title", ["Low Country Shrimp Boil", "Seafood Boil"])
def test_a_boil_of_shellfish_is_boiled(steps, title):
    told = steps("seafood", title, "shrimp:raw", "red potatoes:whole", "smoked sausage:cut", "corn:halved",
                 "Old Bay seasoning:ground", "lemons:halved")  # fmt: skip
    assert {"red potatoes", "shrimp"} <= taking(told, "boil")


def test_rolls_are_filled_and_not_fried_with_smoked_sausage(steps):
    told = steps("sausage", "Linguica with Peppers on Rolls", "linguica:sliced", "green peppers:sliced",
                 "onions:sliced", "olive oil:liquid", "red wine:liquid", "rolls:whole")  # fmt: skip
    assert "rolls" not in taking(told, "cook and stir")


def test_sausages_of_cheese_are_shaped_and_turned_in_crumbs(steps):
    told = steps("sausage", "Glamorgan Sausages", "Caerphilly cheese:grated", "breadcrumbs:crumbs", "leek:chopped",
                 "butter:unmelted", "eggs:separated", "milk:liquid", "oil:liquid")  # fmt: skip
    assert {"shape", "dip", "flip"} <= set(motions(told))


def test_the_sauce_of_a_loaf_is_cooked_and_not_mixed_into_the_mince(steps):
    told = steps("meatloaf", "Swedish Meatloaf with Cream Sauce", "ground beef:raw", "breadcrumbs:crumbs",
                 "egg:uncooked", "butter:unmelted:sauce", "flour:powder:sauce", "beef broth:liquid:sauce",
                 "cream:creamy:sauce")  # fmt: skip
    assert "cream" not in inside(told, "mix")
    assert "cream" in taking(told, "cook and stir")


def test_all_that_is_on_a_skewer_lies_in_its_marinade(steps):
    told = steps("steak", "Balsamic Steak Kebabs", "sirloin:cubed", "balsamic vinegar:liquid", "honey:thick liquid",
                 "olive oil:liquid", "garlic:minced", "red onion:chopped")  # fmt: skip
    assert {"sirloin", "honey", "olive oil", "garlic", "red onion"} <= inside(told, "chill")


def test_chopped_tomatoes_are_cooked_with_the_onions_of_a_sausage_roll_and_slices_lie_raw(steps):
    asked = ["boerewors:raw", "bread rolls:whole", "onions:sliced", "oil:liquid", "sugar:granulated"]
    relish = steps("sausage", "Boerewors Rolls with Tomato Relish", *asked, "tomatoes:chopped", "chutney:sauce")
    assert {"tomatoes", "chutney"} <= taking(relish, "cook and stir")
    sliced = steps("sausage", "Boerewors Rolls with Tomato", *asked, "tomatoes:sliced")
    assert "tomatoes" not in taking(sliced, "cook and stir")


@pytest.mark.parametrize(
    ("dish", "title", "asked", "form"),
    [
        ("potatoes", "Herbed Potatoes", ("new potatoes:boiled", "butter:unmelted", "dill:chopped"), "softened"),
        ("bread", "Scones", ("flour:powder", "butter:unmelted", "milk:liquid", "baking powder:powder"), "unmelted"),
    ],
)
def test_butter_is_soft_when_it_is_stirred_cold_but_hard_when_it_is_rubbed_into_flour(steps, dish, title, asked, form):
    assert form in states_of(steps(dish, title, *asked), "butter")


def test_butter_melts_in_a_sauce_and_is_not_whisked_with_cold_starch(steps):
    told = steps("sauce", "Raisin Sauce", "brown sugar:granulated", "cornstarch:powder", "water:liquid",
                 "vinegar:liquid", "raisins:whole", "butter:unmelted")  # fmt: skip
    assert next(place for place, (inputs, _, _) in enumerate(told) if "butter" in inputs) > motions(told).index(
        "turn on"
    )
    assert "butter" in inside(told, "simmer")
