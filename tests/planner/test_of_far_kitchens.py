"""Families of Asia, Africa and the Middle East: rice in a broth, toasted rice, what is brushed or poured over."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def test_rice_comes_raw_into_the_broth_of_its_meat(steps):
    told = steps("rice", "Uzbek Plov", "beef chuck:cubed", "carrots:julienned", "onions:sliced",
                 "long-grain rice:uncooked", "vegetable oil:liquid", "salt:granulated")  # fmt: skip
    assert "boil" not in motions(told)
    assert motions(told).count("simmer") == 2
    assert "long-grain rice" not in inside(told, "simmer")


def test_rice_that_no_liquid_is_asked_with_gets_water(steps):
    told = steps("rice", "Takikomi Gohan", "Japanese rice:uncooked", "chicken thigh:cut", "carrot:julienned",
                 "soy sauce:liquid", "mirin:liquid", "dashi:granulated")  # fmt: skip
    assert any(motion == "pour" and "water" in inputs for inputs, motion, _ in told)


def test_vegetables_are_fried_and_laid_below_the_rice(steps):
    told = steps("rice", "Maqluba", "basmati rice:soaked", "aubergines:sliced", "cauliflower:broken",
                 "chicken thighs:raw", "onion:quartered", "baharat:ground", "vegetable oil:liquid")  # fmt: skip
    poured = [place for place, (inputs, motion, _) in enumerate(told) if "basmati rice" in inputs and motion == "pour"]
    assert first(told, "aubergines", "flip") < poured[-1]  # it was poured into water to soak before


def test_rice_for_a_sharp_salad_is_toasted_and_ground(steps):
    told = steps("salad", "Larb Gai", "chicken:minced", "glutinous rice:uncooked", "lime juice:juice",
                 "fish sauce:sauce", "chilli flakes:dried", "mint leaves:leaf", "chicken stock:liquid")  # fmt: skip
    assert motions(told).index("toast") < motions(told).index("mash") < motions(told).index("mix")
    assert "boil" not in motions(told)


def test_pieces_of_raw_meat_are_never_shaped(steps):
    told = steps("pork", "Thit Kho", "pork belly:cut", "eggs:boiled, peeled", "sugar:granulated",
                 "fish sauce:sauce", "garlic:smashed", "shallots:sliced", "coconut water:liquid")  # fmt: skip
    assert {"press", "shape", "roll"}.isdisjoint(motions(told))
    assert first(told, "eggs", "peel") < motions(told).index("simmer")


def test_what_stands_below_a_gravy_is_not_cooked_in_it(steps):
    told = steps("burger", "Loco Moco", "ground beef:uncooked", "breadcrumbs:crumbs", "egg:uncooked",
                 "butter:unmelted:gravy", "onion:sliced:gravy", "flour:powder:gravy", "beef broth:liquid:gravy",
                 "white rice:cooked:gravy", "eggs:fried:gravy")  # fmt: skip
    assert "shape" in motions(told)
    assert inside(told, "simmer").isdisjoint({"white rice", "eggs", "ground beef"})


def test_a_spice_under_a_heading_is_not_prepared_as_the_fruit_beside_it(steps):
    told = steps("cookie", "Kleicha", "flour:powder", "butter:melted", "yeast:powder", "milk:liquid",
                 "dates:chopped:filling", "butter:unmelted:filling", "cardamom:ground:filling")  # fmt: skip
    assert {"boil", "simmer"}.isdisjoint(motions(told))


def test_balls_in_a_batter_have_their_bun_around_them(steps):
    told = steps("sandwich", "Vada Pav", "ladi pav:whole", "potatoes:boiled, mashed", "mustard seeds:whole",
                 "garlic:crushed", "besan:powder", "baking soda:powder", "oil:liquid:frying")  # fmt: skip
    assert inside(told, "beat") >= {"besan", "water"}
    assert "ladi pav" not in {food for inputs, motion, _ in told if motion in {"mix", "cook"} for food in inputs}


def test_a_paste_is_ground_and_cooked_before_flesh_is_brushed_with_it(steps):
    told = steps("chicken", "Ayam Percik", "chicken legs:raw", "turmeric:ground", "chillies:soaked:sauce",
                 "shallots:peeled:sauce", "garlic:clove:sauce", "coconut milk:liquid:sauce",
                 "palm sugar:granulated:sauce")  # fmt: skip
    order = [motions(told).index(motion) for motion in ("blend", "cook and stir", "bake")]
    assert order == sorted(order)


def test_ground_nuts_may_stay_raw(steps):
    told = steps("sauce", "Skordalia", "floury potatoes:cut", "garlic:crushed", "olive oil:liquid",
                 "lemon:juice", "almonds:ground")  # fmt: skip
    assert "almonds" in inside(told, "blend")


def test_what_is_asked_soaked_lies_in_water(steps):
    told = steps("chicken", "Chicken Curry", "chicken:cut", "dried red chillies:soaked", "onion:chopped", "oil:liquid",
                 "coconut milk:liquid")  # fmt: skip
    assert "dried red chillies" in {food for inputs, motion, _ in told if motion == "soak" for food in inputs}


def test_minced_meat_that_is_asked_chilled_is_raw(steps):
    told = steps("meatball", "Bakso", "ground beef:chilled", "tapioca starch:powder", "egg white:uncooked",
                 "beef broth:liquid", "scallions:sliced")  # fmt: skip
    assert first(told, "ground beef", "mix") < motions(told).index("simmer")
    assert "cook" not in motions(told)[: motions(told).index("mix")]


def test_char_siu_lies_in_its_marinade_and_is_baked(steps):
    told = steps("pork", "Char Siu", "pork neck:whole", "hoisin sauce:sauce", "soy sauce:liquid", "honey:thick liquid",
                 "five-spice powder:ground")  # fmt: skip
    assert first(told, "pork neck", "mix") < motions(told).index("chill") < motions(told).index("bake")


def test_wontons_are_filled_before_they_come_into_their_broth(steps):
    told = steps("noodle", "Wonton Noodle Soup", "egg noodles:fresh", "wonton wrappers:whole", "pork mince:raw",
                 "soy sauce:liquid", "chicken bouillon powder:powder")  # fmt: skip
    assert first(told, "wonton wrappers", "fold and pinch") < motions(told).index("simmer")
