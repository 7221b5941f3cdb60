"""A dish whose name asks for a craft that no video of a like dish has is made by the technique that is called so."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def test_a_kugel_is_boiled_noodles_baked_in_eggs(steps):
    told = steps("pudding", "Noodle Kugel", "egg noodles:uncooked", "eggs:uncooked", "sour cream:creamy",
                 "sugar:granulated", "raisins:whole")  # fmt: skip
    assert first(told, "egg noodles", "boil") < first(told, "eggs", "whisk") < first(told, "egg noodles", "fold")
    assert motions(told)[-4:] == ["put inside", "bake", "turn off", "remove"]


def test_pierogi_are_closed_around_mash_and_boiled_in_water_that_boils(steps):
    told = steps("pasta", "Pierogi", "flour:powder", "egg:uncooked", "water:liquid", "potatoes:peeled",
                 "farmer cheese:creamy", "butter:unmelted")  # fmt: skip
    assert first(told, "potatoes", "mash") < motions(told).index("fold and pinch")
    into_the_pot = next(n for n, (inputs, motion, _) in enumerate(told) if {"parcel", "pot"} <= inputs)
    assert first(told, "water", "boil") < into_the_pot < motions(told).index("drain")
    assert "bake" not in motions(told)


def test_milk_soaks_a_cake_that_is_baked(steps):
    told = steps("cake", "Tres Leches Cake", "flour:powder", "eggs:uncooked", "sugar:granulated", "milk:liquid",
                 "evaporated milk:liquid", "condensed milk:thick liquid", "whipping cream:creamy")  # fmt: skip
    assert first(told, "evaporated milk", "stir") > motions(told).index("bake")  # made when the cake is done
    assert motions(told).index("bake") < motions(told).index("chill")
    assert not [motion for inputs, motion, _ in told if motion == "stir" and "cake" in inputs]


def test_what_gave_a_drink_its_taste_stays_in_the_strainer(steps):
    told = steps("drinks", "Masala Chai", "water:liquid", "milk:liquid", "black tea leaves:dried", "ginger:sliced",
                 "cinnamon:ground", "sugar:granulated")  # fmt: skip
    (outputs,) = [outputs for _, motion, outputs in told if motion == "pour and strain"]
    assert {node.label for node in outputs if node.container == "strainer"} == {"black tea leaves", "ginger"}
    assert any("cinnamon" in node.ingredients for node in told[-1][2])


def test_chocolate_is_melted_and_cream_whipped_for_a_mousse(steps):
    told = steps("pudding", "Chocolate Mousse", "dark chocolate:chopped", "eggs:uncooked", "heavy cream:creamy",
                 "sugar:granulated")  # fmt: skip
    states = {(node.label, state) for _, _, outputs in told for node in outputs for state in node.states}
    assert {("dark chocolate", "melted"), ("heavy cream", "whipped"), ("pudding", "chilled")} <= states


def test_what_a_video_makes_by_that_name_no_table_teaches(steps):
    told = steps("cookie", "Peanut Brittle", "sugar:granulated", "peanuts:whole", "butter:stick", "corn syrup:syrup")
    assert "chill" not in motions(told)


def test_rice_milk_is_blended_and_strained(steps):
    told = steps("drinks", "Horchata", "rice:uncooked", "water:liquid", "sugar:granulated", "cinnamon:ground",
                 "milk:liquid")  # fmt: skip
    assert motions(told).index("blend") < motions(told).index("pour and strain") < first(told, "milk", "pour")


def test_bagels_are_boiled_and_then_baked(steps):
    told = steps("bread", "Bagels", "bread flour:powder", "yeast:powder", "water:warm", "honey:thick liquid",
                 "salt:granulated", "egg:uncooked")  # fmt: skip
    assert first(told, "dough", "boil") < motions(told).index("brush") < motions(told).index("bake")
    assert motions(told).count("ferment") == 1


def test_a_roll_is_baked_spread_and_rolled_up(steps):
    told = steps("cake", "Swiss Roll", "eggs:uncooked", "sugar:granulated", "flour:powder", "strawberry jam:jelly")
    assert motions(told).index("bake") < first(told, "cake", "roll") == motions(told).index("roll")
    assert "strawberry jam" in inside(told, "roll")


def test_ravioli_are_filled_closed_and_boiled_before_their_sauce_takes_them(steps):
    told = steps("pasta", "Ricotta Ravioli", "flour:powder", "eggs:uncooked", "ricotta cheese:creamy",
                 "butter:unmelted", "sage leaves:leaf")  # fmt: skip
    order = ["knead", "roll", "fold and pinch", "boil", "melt"]
    assert [motion for motion in dict.fromkeys(motions(told)) if motion in order] == order
    assert inside(told, "fold and pinch") == {"eggs", "flour", "ricotta cheese"}


def test_wontons_come_into_the_broth_when_it_is_hot(steps):
    told = steps("soup", "Wonton Soup", "wonton wrappers:raw", "ground pork:raw", "soy sauce:liquid",
                 "chicken broth:liquid", "bok choy:chopped")  # fmt: skip
    assert inside(told, "fold and pinch") == {"wonton wrappers", "ground pork", "soy sauce"}
    assert motions(told).index("fold and pinch") < motions(told).index("simmer") < first(told, "parcel", "simmer")


def test_bought_wrappers_are_not_kneaded(steps):
    told = steps("pork", "Pork Jiaozi", "dumpling wrappers:raw", "ground pork:raw", "egg:uncooked", "vinegar:liquid")
    assert "knead" not in motions(told)
    assert inside(told, "fold and pinch") == {"dumpling wrappers", "ground pork", "egg"}


def test_leaves_are_taken_off_a_cabbage_that_was_boiled_and_rolled_around_their_filling(steps):
    told = steps("vegetables", "Cabbage Rolls", "cabbage:whole", "ground beef:raw", "rice:cooked", "tomato sauce:sauce")
    assert first(told, "cabbage", "cook") < first(told, "cabbage", "tear apart") < motions(told).index("roll")
    assert inside(told, "roll") == {"cabbage", "ground beef", "rice"}


def test_a_dish_of_a_type_that_no_video_has_is_made_by_its_technique(steps):
    told = steps("meatloaf", "Meatloaf", "ground beef:raw", "egg:uncooked", "breadcrumbs:crumbs", "ketchup:sauce")
    assert inside(told, "shape") == {"ground beef", "egg", "breadcrumbs"}
    assert first(told, "ketchup", "pour") < motions(told).index("bake")


def test_a_loaf_of_meat_is_shaped_in_one_piece_whatever_its_type(steps):
    mass = ("ground beef:raw", "egg:uncooked", "breadcrumbs:crumbs", "onion:chopped")
    told = steps("beef", "Family Meatloaf", *mass, "ketchup:sauce", "brown sugar:granulated")
    assert inside(told, "shape") == {"ground beef", "egg", "breadcrumbs", "onion"}
    assert "loaf" in {node.label for _, motion, outputs in told if motion == "shape" for node in outputs}
    assert "dip" not in motions(told)
    assert "ketchup" in inside(told, "bake")


def test_ginger_in_the_strainer_makes_a_tea(steps):
    told = steps("drinks", "Ginger Tea", "ginger:sliced", "water:liquid", "honey:thick liquid")
    assert "pour and strain" in motions(told)


def test_what_is_asked_cut_is_not_mashed_for_a_filling(steps):
    told = steps("pie", "Cornish Pasties", "flour:powder", "lard:block", "water:cold", "beef skirt:diced",
                 "potatoes:diced", "onion:chopped")  # fmt: skip
    assert "mash" not in motions(told)
    assert "potatoes" in inside(told, "fold and pinch")


def test_a_stir_fry_needs_no_such_name_where_it_is_filed_as_one(steps):
    told = steps("stir-fry", "Pad Krapow", "ground pork:raw", "soy sauce:liquid", "sugar:granulated", "oil:liquid",
                 "fried eggs:whole", "rice:steamed")  # fmt: skip
    assert first(told, "ground pork", "cook and stir") < first(told, "mixture", "pour")
    assert first(told, "mixture", "cook and stir") < first(told, "fried eggs", "pick-and-place")


def test_what_a_cutlet_is_eaten_with_is_not_fried_with_it(steps):
    told = steps("pork", "Tonkatsu", "pork chops:boneless", "flour:powder", "eggs:beaten", "panko:crumbs", "oil:liquid",
                 "cabbage:shredded", "tonkatsu sauce:sauce")  # fmt: skip
    assert motions(told).index("flip") < first(told, "cabbage", "pour")
    assert not [motion for inputs, motion, _ in told if "cabbage" in inputs and motion == "cook and stir"]


def test_eggs_are_whisked_and_come_into_a_soup_last(steps):
    told = steps("soup", "Avgolemono", "chicken stock:liquid", "orzo:uncooked", "eggs:uncooked", "lemon juice:juice")
    assert first(told, "eggs", "whisk") < first(told, "orzo", "simmer") < first(told, "egg mixture", "cook and stir")


def test_a_bowl_on_rice_has_its_eggs_fried_apart(steps):
    told = steps("rice", "Bibimbap", "short-grain rice:uncooked", "ground beef:raw", "carrot:julienned",
                 "eggs:uncooked", "gochujang:paste", "sesame oil:liquid")  # fmt: skip
    assert first(told, "short-grain rice", "boil") < first(told, "ground beef", "cook and stir")
    assert first(told, "ground beef", "cook and stir") < first(told, "eggs", "crack") < first(told, "eggs", "cook")


def test_pieces_in_a_crust_are_fried_before_their_sauce_comes(steps):
    told = steps("stir-fry", "Sweet and Sour Pork", "pork loin:cubed", "egg:uncooked", "cornstarch:powder",
                 "ketchup:sauce", "rice vinegar:liquid", "sugar:granulated", "oil:liquid")  # fmt: skip
    assert first(told, "egg", "crack") < motions(told).index("flip") < motions(told).index("cook and stir")


def test_flesh_is_turned_in_flour_then_in_beaten_eggs_then_in_crumbs(steps):
    told = steps("pork", "Schnitzel", "pork cutlets:raw", "flour:powder", "eggs:uncooked", "breadcrumbs:crumbs",
                 "oil:liquid")  # fmt: skip
    dips = [inputs for inputs, motion, _ in told if motion == "dip"]
    assert [{"flour", "egg mixture", "mixture", "breadcrumbs"} & inputs for inputs in dips] == [
        {"flour"}, {"mixture"}, {"breadcrumbs"},
    ]  # fmt: skip
    assert all("pork cutlets" in inputs for inputs in dips)


def test_what_is_called_raw_stays_raw(steps):
    told = steps("seafood", "Ceviche", "sea bass:cubed", "lime juice:juice", "red onion:sliced", "avocado:diced",
                 "salt:granulated")  # fmt: skip
    assert not {"cook", "boil", "turn on", "heat"} & set(motions(told))
    assert first(told, "lime juice", "stir") < motions(told).index("chill")


def test_what_a_title_calls_pickled_is_not_bought_so_where_it_is_made(steps):
    told = steps("vegetables", "Pickled Red Onions", "red onions:sliced", "vinegar:liquid", "water:liquid",
                 "sugar:granulated", "salt:granulated")  # fmt: skip
    assert motions(told).index("cook and stir") < first(told, "red onions", "stir") < motions(told).index("chill")


def test_a_white_sauce_is_cooked_for_pasta_that_no_title_calls_so(steps):
    told = steps("pasta", "Tuna Pasta Bake", "penne:uncooked", "tuna:canned", "butter:unmelted", "flour:powder",
                 "milk:liquid", "cheddar:grated")  # fmt: skip
    assert motions(told).index("melt") < first(told, "milk", "cook and stir") < first(told, "penne", "mix")


@pytest.mark.parametrize(
    "foods",
    [
        ("bananas:whole", "milk:liquid", "ice:frozen"),
        ("spinach:leaves", "apple:whole", "water:liquid"),
        ("tofu:diced", "strawberries:whole", "yogurt:creamy"),
        ("rolled oats:rolled", "raisins:dried", "milk:liquid"),
    ],
)
def test_fruit_leaves_and_grains_are_blended_in_what_is_drunk_though_no_name_says_so(steps, foods):
    assert motions(steps("drinks", "", *foods)).count("blend") == 1


@pytest.mark.parametrize(
    ("title", "foods"),
    [
        ("Sangria", ("red wine:liquid", "brandy:liquid", "apples:chopped", "sugar:granulated", "ice:frozen")),
        ("Strawberry Lemonade", ("strawberries:whole", "lemon juice:juice", "sugar:granulated", "ice:frozen")),
        ("Iced Latte", ("coffee:liquid", "milk:liquid", "ice:frozen")),
    ],
)
def test_a_drink_in_which_fruit_lies_by_its_name_is_not_blended(steps, title, foods):
    assert "blend" not in motions(steps("drinks", title, *foods))


def test_a_large_fruit_is_cut_before_it_comes_into_a_blender(steps):
    told = steps("drinks", "", "watermelon:whole fruit", "milk:liquid", "ice:frozen")
    assert first(told, "watermelon", "chop") < motions(told).index("blend")


def test_what_would_run_or_burn_beside_eggs_in_the_pan_is_beaten_into_them(steps):
    told = steps("omelette", "", "egg:whole raw", "broccoli:whole", "stock:liquid", "sake:juice", "sugar:ground")
    (beaten,) = [inputs for inputs, motion, _ in told if motion == "whisk"]
    assert {"egg", "stock", "sake", "sugar"} <= beaten
    assert first(told, "broccoli", "cook and stir") < first(told, "mixture", "cook")


def test_water_for_a_frittata_is_beaten_into_its_eggs(steps):
    told = steps("omelette", "", "egg:whole raw", "water:juice", "ham:processed meat")
    assert first(told, "water", "beat") < first(told, "ham", "cook")


def test_noodles_with_eggs_milk_and_sugar_are_baked_in_their_custard(steps):
    told = steps(
        "noodle", "", "noodles:uncooked", "eggs:uncooked", "milk:liquid", "sugar:granulated", "cream cheese:creamy"
    )
    assert first(told, "noodles", "boil") < first(told, "eggs", "whisk") < motions(told).index("bake")


def test_what_is_sold_free_comes_in_a_package_where_it_is_loose(steps):
    told = steps("soup", "", "mushrooms:crumbs", "stock:liquid", "spinach:creamy")
    assert any({"mushrooms", "packet"} <= inputs for inputs, _, _ in told)
    assert any({"spinach", "container"} <= inputs for inputs, _, _ in told)


def test_bread_with_eggs_and_milk_is_baked_in_their_custard_whatever_it_is_filed_under(steps):
    told = steps("bread", "", "bread:whole", "egg:uncooked", "milk:liquid", "sugar:granulated", "raisin:dried")
    assert {"bread", "egg", "milk"} <= inside(told, "fold")
    assert {"bread", "egg", "milk"} <= inside(told, "bake")
    strata = steps("omelette", "", "bread:sliced", "ham:diced", "egg:uncooked", "milk:liquid", "onion:chopped")
    assert "bread" not in inside(strata, "whisk")  # the slices lie in the dish, and the eggs come over them
    assert {"bread", "ham", "egg", "onion"} <= inside(strata, "bake")


def test_bread_with_tomatoes_and_vinegar_is_a_salad(steps):
    asked = ("bread:whole", "tomato:chopped", "onion:sliced", "oil:liquid", "vinegar:liquid", "basil:leaves")
    told = steps("bread", "", *asked)
    assert inside(told, "bake") == {"bread"}
    assert motions(told).index("bake") < first(told, "tomato", "mix")
