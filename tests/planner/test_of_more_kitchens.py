"""More families of Asia, Africa and the Middle East: what is bound, fried, coated and ground as they are called."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions, taking

pytestmark = pytest.mark.shared_data


def test_rice_with_yolks_is_baked_and_turned_out(steps):
    told = steps("rice", "Tahchin", "basmati rice:soaked", "chicken thighs:raw", "onion:sliced", "yogurt:creamy",
                 "egg yolks:uncooked", "saffron:ground", "butter:melted", "barberries:dried")  # fmt: skip
    assert {"basmati rice", "yogurt", "egg yolks"} <= inside(told, "mix")
    assert "bake" in motions(told)
    assert "shape" not in motions(told)


def test_fish_is_fried_apart_from_the_rice_below_it(steps):
    told = steps("seafood", "Thieboudienne", "fish fillets:raw", "rice:uncooked", "onion:chopped", "tomato paste:paste",
                 "carrot:cut", "fish stock:liquid", "oil:liquid")  # fmt: skip
    assert "fish fillets" not in inside(told, "simmer")
    assert "flip" in motions(told)


def test_patties_are_turned_in_egg_that_is_no_part_of_them(steps):
    told = steps("meatball", "Donggeurang ttaeng", "ground pork:raw", "tofu:mashed", "onion:minced", "flour:powder",
                 "eggs:beaten", "oil:liquid", "salt:granulated")  # fmt: skip
    assert inside(told, "mix").isdisjoint({"eggs", "flour"})
    assert motions(told).count("dip") == 2


def test_a_bird_is_simmered_in_one_piece_with_its_rice(steps):
    told = steps("soup", "Samgyetang", "whole chicken:whole", "glutinous rice:soaked", "garlic:peeled", "jujubes:dried",
                 "water:liquid", "scallions:chopped")  # fmt: skip
    assert {"pull apart", "drain"}.isdisjoint(motions(told))
    assert {"whole chicken", "glutinous rice"} <= taking(told, "simmer")


def test_plantains_are_fried_before_they_come_to_a_stew(steps):
    told = steps("chicken", "Poulet DG", "chicken:cut", "plantains:sliced", "tomatoes:blended", "onion:chopped",
                 "carrots:sliced", "oil:liquid")  # fmt: skip
    assert first(told, "plantains", "flip") < motions(told).index("simmer")
    assert "bake" not in motions(told)


def test_spices_are_fried_before_the_potatoes_are_turned_in_them(steps):
    told = steps("potatoes", "Aloo posto", "potatoes:cubed", "poppy seeds:ground", "nigella seeds:whole",
                 "green chillies:slit", "mustard oil:liquid", "turmeric:ground")  # fmt: skip
    assert first(told, "nigella seeds", "cook and stir") < first(told, "potatoes", "simmer")
    assert "poppy seeds" in taking(told, "simmer")


def test_a_ground_paste_of_coconut_is_cooked_with_its_vegetables(steps):
    told = steps("vegetables", "Avial", "carrot:cut", "green beans:cut", "ash gourd:cut", "coconut:grated",
                 "cumin seeds:whole", "green chillies:whole", "yogurt:creamy", "coconut oil:liquid")  # fmt: skip
    assert {"coconut", "cumin seeds"} <= inside(told, "blend")
    assert motions(told).count("simmer") == 2
    assert {"peel", "core"} <= {motion for inputs, motion, _ in told if "ash gourd" in inputs}


def test_fine_noodles_are_fried_dry_and_boiled_in_milk(steps):
    told = steps("pudding", "Semiya payasam", "vermicelli:broken", "ghee:creamy", "cashews:halved", "milk:liquid",
                 "sugar:granulated", "cardamom:ground")  # fmt: skip
    assert first(told, "vermicelli", "cook and stir") < first(told, "vermicelli", "simmer")
    assert "cashews" in taking(told, "cook and stir")


def test_bread_is_fried_before_milk_comes_over_it(steps):
    told = steps("pudding", "Double ka meetha", "white bread:sliced", "milk:liquid", "sugar:granulated", "ghee:creamy",
                 "cardamom:ground", "almonds:slivered")  # fmt: skip
    assert first(told, "white bread", "flip") < motions(told).index("cook and stir")
    assert "bake" not in motions(told)


def test_a_leaf_lies_below_a_batter(steps):
    told = steps("cake", "Bibingka", "rice flour:powder", "coconut milk:liquid", "sugar:granulated", "eggs:uncooked",
                 "baking powder:powder", "banana leaves:whole", "cheese:grated")  # fmt: skip
    assert "banana leaves" not in inside(told, "whisk")
    assert "cheese" not in inside(told, "whisk")


def test_jam_and_whites_lie_in_cases_of_dough(steps):
    told = steps("cookie", "Hertzoggies", "flour:powder", "sugar:granulated", "butter:cubed", "egg yolks:uncooked",
                 "apricot jam:jelly", "egg whites:uncooked", "desiccated coconut:flakes")  # fmt: skip
    assert inside(told, "knead").isdisjoint({"egg whites", "desiccated coconut", "apricot jam"})
    assert first(told, "egg whites", "beat") < motions(told).index("fold") < motions(told).index("bake")


def test_a_crust_and_a_cooked_filling_take_what_their_headings_say(steps):
    told = steps("pie", "Melktert", "butter:softened:crust", "sugar:granulated:crust", "cake flour:powder:crust",
                 "baking powder:powder:crust", "milk:liquid:filling", "eggs:uncooked:filling",
                 "cornflour:powder:filling", "white sugar:granulated:filling")  # fmt: skip
    assert inside(told, "knead").isdisjoint({"milk", "eggs", "white sugar"})
    assert first(told, "milk", "whisk") < motions(told).index("cook and stir")


def test_dough_is_fried_as_rolls_and_filled(steps):
    told = steps("sandwich", "Fricassé tunisien", "flour:powder", "yeast:dried", "egg:uncooked", "oil:liquid",
                 "potatoes:boiled:filling", "tuna:drained:filling", "harissa:paste:filling")  # fmt: skip
    assert motions(told).index("ferment") < motions(told).index("flip")
    assert {"tuna", "harissa"}.isdisjoint(taking(told, "cook") | taking(told, "cook and stir") | inside(told, "knead"))


def test_spices_of_a_topping_are_not_kneaded_into_the_dough(steps):
    told = steps("pizza", "Sfiha", "flour:plain", "water:warm", "vegetable oil:liquid", "minced lamb:raw",
                 "onion:chopped", "seven spice:ground", "pomegranate molasses:thick liquid")  # fmt: skip
    assert inside(told, "knead").isdisjoint({"seven spice", "pomegranate molasses"})
    assert {"minced lamb", "seven spice"} <= inside(told, "mix")


def test_eggs_of_a_fried_egg_salad_are_fried(steps):
    told = steps("salad", "Yam khai dao", "eggs:uncooked", "vegetable oil:liquid", "onion:sliced", "tomato:cut",
                 "fish sauce:sauce", "lime juice:juice")  # fmt: skip
    assert first(told, "eggs", "flip") < first(told, "eggs", "mix")
    assert "boil" not in motions(told)


def test_a_raw_relish_is_not_heated(steps):
    told = steps("sauce", "Sambal matah", "shallots:sliced", "lemongrass:sliced", "lime:juice", "coconut oil:liquid",
                 "shrimp paste:paste")  # fmt: skip
    assert {"cook", "cook and stir", "heat", "mash"}.isdisjoint(motions(told))


def test_what_is_under_meatballs_is_in_them(steps):
    told = steps("soup", "Almondigas", "ground pork:raw:meatballs", "carrot:minced:meatballs", "flour:powder:meatballs",
                 "onion:sliced", "misua noodles:uncooked", "pork broth:liquid", "patola:sliced")  # fmt: skip
    assert inside(told, "mix") == {"ground pork", "carrot", "flour"}


def test_squid_is_cut_and_cooked_once(steps):
    told = steps("stir-fry", "Ojingeo bokkeum", "squid:cleaned", "onion:sliced", "gochujang:paste", "soy sauce:liquid",
                 "oil:liquid")  # fmt: skip
    assert first(told, "squid", "chop") < first(told, "squid", "cook and stir")
    assert "cook" not in motions(told)


def test_what_was_dried_of_the_sea_lies_in_water_first(steps):
    told = steps("salad", "Yum Woon Sen", "glass noodles:uncooked", "dried shrimp:dried", "lime juice:juice",
                 "fish sauce:sauce", "tomato:cut")  # fmt: skip
    assert (
        first(told, "dried shrimp", "soak") < first(told, "dried shrimp", "drain") < first(told, "dried shrimp", "mix")
    )


def test_ground_melon_seeds_are_cooked_in_their_soup(steps):
    told = steps("soup", "Egusi soup", "egusi:ground", "beef:cut", "palm oil:liquid", "onion:chopped",
                 "stock cubes:granulated", "water:liquid", "ugu:chopped")  # fmt: skip
    assert "egusi" in taking(told, "simmer")


def test_what_is_cut_when_it_is_baked_is_not_chopped_before(steps):
    told = steps("salad", "Salata mechouia", "green peppers:whole", "tomatoes:whole", "onion:whole",
                 "olive oil:liquid", "lemon:juice")  # fmt: skip
    assert "chop" not in motions(told)


def test_a_sauce_that_rice_is_eaten_with_is_cooked_apart(steps):
    told = steps("rice", "Nasi lemak", "rice:uncooked", "coconut milk:liquid", "pandan leaves:whole",
                 "dried chillies:soaked:sauce", "shallots:chopped:sauce", "oil:liquid:sauce",
                 "cucumber:sliced:serving")  # fmt: skip
    assert {"dried chillies", "shallots"} <= inside(told, "blend")
    assert "dried chillies" not in inside(told, "simmer")


def test_what_is_raw_beside_rice_without_a_title_is_not_boiled_with_it(steps):
    told = steps("rice", "", "rice:uncooked", "coconut milk:liquid", "turmeric:ground", "lime leaves:whole",
                 "eggs:sliced", "cucumber:sliced")  # fmt: skip
    assert inside(told, "simmer").isdisjoint({"eggs", "cucumber"})


def test_fine_noodles_are_browned_and_boiled_with_the_rice(steps):
    told = steps("rice", "", "butter:softened", "vermicelli:pieces", "rice:uncooked", "chicken broth:liquid",
                 "onion:minced")  # fmt: skip
    assert "boil" not in motions(told)
    assert first(told, "vermicelli", "cook and stir") < motions(told).index("simmer")


def test_flesh_lies_in_its_sauce_before_it_is_fried(steps):
    told = steps("beef", "Bulgogi", "beef sirloin:sliced", "soy sauce:liquid", "sugar:granulated", "pear:grated",
                 "onion:sliced", "sesame oil:liquid")  # fmt: skip
    assert first(told, "beef sirloin", "mix") < motions(told).index("chill") < motions(told).index("cook and stir")


def test_fish_is_baked_under_sesame_paste(steps):
    told = steps("seafood", "Samke harra", "sea bass:whole", "tahini:creamy", "lemon:juice", "garlic:crushed",
                 "walnuts:chopped", "olive oil:liquid")  # fmt: skip
    assert motions(told).count("bake") == 2
    assert "tahini" in inside(told, "stir")


def test_balls_are_shaped_before_they_come_into_their_sauce(steps):
    told = steps("meatball", "Dawood basha", "minced lamb:raw", "onion:grated", "onions:sliced", "tomatoes:chopped",
                 "pomegranate molasses:thick liquid", "water:liquid", "olive oil:liquid")  # fmt: skip
    assert inside(told, "mix") == {"minced lamb", "onion"}


def test_balls_of_cheese_are_fried_and_lie_in_a_smooth_gravy(steps):
    told = steps("meatball", "Malai kofta", "paneer:grated", "potatoes:boiled, mashed", "cornflour:powder",
                 "oil:liquid:frying", "tomatoes:chopped:gravy", "cream:liquid:gravy")  # fmt: skip
    assert inside(told, "mix").isdisjoint({"tomatoes", "cream"})
    assert "tomatoes" in inside(told, "blend")


def test_a_stew_is_made_before_it_comes_into_a_loaf(steps):
    told = steps("sandwich", "Bunny chow", "white bread loaf:whole", "lamb:cubed", "onion:chopped", "tomatoes:chopped",
                 "curry powder:powder", "oil:liquid", "water:liquid")  # fmt: skip
    assert {"lamb", "tomatoes", "curry powder"} <= taking(told, "simmer")


def test_a_casserole_that_is_called_after_a_stew_is_baked(steps):
    told = steps("casserole", "Turlu guvec", "lamb:cubed", "eggplant:cubed", "zucchini:sliced", "tomatoes:chopped",
                 "onion:chopped", "olive oil:liquid", "water:liquid")  # fmt: skip
    assert "bake" in motions(told)


def test_sauces_come_on_a_savoury_pancake_and_not_into_its_batter(steps):
    told = steps("omelette", "Okonomiyaki", "flour:powder", "dashi:liquid", "eggs:uncooked", "cabbage:shredded",
                 "oil:liquid", "okonomiyaki sauce:sauce", "bonito flakes:whole", "aonori:whole")  # fmt: skip
    assert inside(told, "fold").isdisjoint({"okonomiyaki sauce", "bonito flakes", "aonori"})


def test_greens_are_blanched_and_dressed(steps):
    told = steps("vegetables", "Horenso goma-ae", "spinach:leaves", "sesame seeds:toasted", "soy sauce:liquid",
                 "sugar:granulated")  # fmt: skip
    assert motions(told).index("boil") < first(told, "spinach", "mix")
    assert "soy sauce" not in taking(told, "cook and stir")


def test_a_joint_is_lifted_out_of_what_it_was_simmered_in(steps):
    told = steps("pork", "Bo ssam", "pork belly:raw", "doenjang:paste", "onion:whole", "garlic:clove", "water:liquid",
                 "napa cabbage:whole", "ssamjang:paste")  # fmt: skip
    assert "ssamjang" not in taking(told, "simmer")
    assert motions(told).index("simmer") < motions(told).index("slice")


def test_rice_cakes_swell_in_their_sauce_and_boiled_eggs_lie_on_it(steps):
    told = steps("stir-fry", "Tteokbokki", "tteok:whole", "gochujang:paste", "sugar:granulated", "anchovy stock:liquid",
                 "boiled eggs:halved", "scallions:cut")  # fmt: skip
    assert {"tteok", "gochujang"} <= taking(told, "simmer")
    assert "boiled eggs" not in taking(told, "whisk")


def test_sour_fruit_of_a_chutney_is_simmered_and_blended(steps):
    told = steps("sauce", "Tamarind chutney", "tamarind:paste", "jaggery:granulated", "dates:chopped", "water:liquid")
    assert motions(told).index("simmer") < motions(told).index("blend")


def test_soaked_chillies_of_harissa_are_ground_with_the_rest(steps):
    told = steps("sauce", "Harissa", "dried chillies:soaked", "garlic:clove", "caraway seeds:whole", "olive oil:liquid",
                 "lemon juice:juice")  # fmt: skip
    assert {"dried chillies", "garlic", "olive oil"} <= inside(told, "blend")
    assert "cook" not in motions(told)


@pytest.mark.parametrize("title", ["Sesame noodles", "Dan dan noodles"])
def test_noodles_that_become_a_dish_of_noodles_are_the_boiled_ones(steps, title):
    told = steps("noodle", title, "noodles:uncooked", "minced pork:raw", "soy sauce:liquid", "sesame paste:creamy",
                 "scallions:chopped")  # fmt: skip
    assert first(told, "noodles", "boil") < first(told, "noodles", "mix")


def test_egg_is_stirred_last_into_the_sauce_of_crabs(steps):
    told = steps("seafood", "Singapore chilli crab", "mud crabs:cut", "oil:liquid", "garlic:chopped", "ketchup:sauce",
                 "chicken stock:liquid", "cornflour:powder", "egg:beaten")  # fmt: skip
    assert "mud crabs" in taking(told, "simmer")
    assert first(told, "egg", "cook and stir") > motions(told).index("simmer")
