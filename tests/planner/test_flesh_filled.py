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
    told = steps("meatloaf", "Bacon Wrapped Meatloaf", "ground beef:raw", "breadcrumbs:crumbs", "egg:uncooked",
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
