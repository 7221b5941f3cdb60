"""The step that makes a dish what it is called is in it: it is potted, marinated, under a lid, off its bones."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, last, motions, states_of, taking

pytestmark = pytest.mark.shared_data

COBBLER = ("onion:chopped", "carrot:diced", "beef stock:liquid", "self-raising flour:powder", "butter:cubed",
           "milk:liquid", "cheddar:grated")  # fmt: skip


@pytest.mark.parametrize("dish_type", ["beef", "casserole"])
def test_the_dough_of_a_savoury_cobbler_is_baked_on_what_was_stewed(steps, dish_type):
    told = steps(dish_type, "Beef Cobbler", "minced beef:raw", *COBBLER)
    assert first(told, "minced beef", "cook and stir") < first(told, "dough", "shape") < motions(told).index("bake")
    stewed = {one for inputs, motion, _ in told if motion == "simmer" for one in inputs}
    assert stewed.isdisjoint({"self-raising flour", "milk"})


def test_potatoes_lie_on_a_hotpot_and_are_baked_there(steps):
    told = steps("chicken", "Chicken and Leek Hotpot", "chicken thighs:boned", "leeks:sliced", "flour:powder",
                 "chicken stock:liquid", "potatoes:sliced", "butter:melted")  # fmt: skip
    assert "potatoes" not in taking(told, "simmer")
    assert {"potatoes", "oven"} <= taking(told, "bake")


@pytest.mark.parametrize(
    ("title", "fish"), [("Potted Shrimp", "brown shrimp:cooked"), ("Potted Kippers", "kippers:cooked")]
)
def test_what_is_potted_sets_in_butter(steps, title, fish):
    told = steps("seafood", title, fish, "butter:softened", "mace:ground", "cayenne pepper:ground", "toast:whole")
    together = next(place for place, (inputs, motion, _) in enumerate(told) if motion in {"mash", "cook and stir"})
    assert {"butter", "mace", fish.split(":")[0]} <= told[together][0]
    assert together < motions(told).index("chill")


def test_a_whole_bird_leaves_its_broth_in_the_soup(steps):
    told = steps("soup", "Chicken Noodle Soup", "chicken:whole", "carrot:sliced", "celery:sliced", "onion:chopped",
                 "egg noodles:uncooked", "water:liquid")  # fmt: skip
    assert first(told, "chicken", "simmer") < first(told, "chicken", "pull apart")
    assert "strainer" not in set().union(*(inputs for inputs, _, _ in told))
    assert "shredded" in states_of(told, "chicken")


@pytest.mark.parametrize(
    ("dish_type", "title", "meat", "cooked"),
    [
        ("roast", "Pernil", "bone-in pork shoulder:raw", "bake"),
        ("chicken", "Poulet Yassa", "chicken:cut", "cook and stir"),
    ],
)
def test_it_lies_in_its_marinade_before_it_is_cooked(steps, dish_type, title, meat, cooked):
    told = steps(dish_type, title, meat, "garlic:minced", "onions:sliced", "limes:juice", "black pepper:ground",
                 "olive oil:liquid")  # fmt: skip
    assert {"limes", "garlic"} <= taking(told, "stir")
    assert motions(told).index("stir") < motions(told).index("chill") < motions(told).index(cooked)


def test_a_joint_of_ham_is_glazed_when_it_was_roasted_and_is_carved(steps):
    told = steps("roast", "Cider-Roast Gammon", "gammon joint:smoked", "cider:dry", "onion:halved",
                 "demerara sugar:granulated", "mustard:creamy")  # fmt: skip
    bakes = [inputs for inputs, motion, _ in told if motion == "bake"]
    assert ["mixture" in inputs or "glaze" in inputs for inputs in bakes] == [False, True]
    assert first(told, "gammon joint", "slice") > motions(told).index("bake")


@pytest.mark.parametrize(
    ("title", "foods"),
    [
        ("Cheese and Onion Pie", ("onions:sliced", "butter:unmelted", "Lancashire cheese:grated")),
        ("Cheese and Potato Pie", ("potatoes:diced", "onion:chopped", "cheddar:grated", "milk:liquid")),
        ("Leek and Stilton Pie", ("leeks:sliced", "butter:stick", "flour:powder", "milk:liquid", "Stilton:crumbled")),
        ("Corned Beef and Onion Pie", ("corned beef:canned", "onions:chopped", "potatoes:diced")),
    ],
)
def test_a_pie_of_cheese_or_roots_gets_a_lid_with_its_egg_on_it(steps, title, foods):
    told = steps("pie", title, "shortcrust pastry:raw", *foods, "egg:beaten")
    base, lid = (n for n, one in enumerate(told) if one[1] == "pick-and-place" and "shortcrust pastry" in one[0])
    filled, brushed = first(told, "filling", "pour"), first(told, "egg", "brush")
    assert base < filled < lid < brushed < motions(told).index("bake")


def test_eggs_and_milk_set_as_a_custard_in_a_pie_without_a_lid(steps):
    told = steps("pie", "Cheese and Bacon Pie", "shortcrust pastry:raw", "eggs:uncooked", "milk:liquid",
                 "cheddar:grated", "bacon:chopped", "onion:chopped")  # fmt: skip
    assert {"eggs", "milk", "cheddar"} <= taking(told, "mix")


def test_onions_are_fried_and_roots_boiled_before_a_pie_is_baked(steps):
    told = steps("pie", "Homity Pie", "plain flour:powder:pastry", "butter:diced:pastry", "water:cold:pastry",
                 "potatoes:cubed:filling", "onions:chopped:filling", "oil:liquid:filling",
                 "cheddar:grated:filling")  # fmt: skip
    assert first(told, "onions", "cook and stir") < motions(told).index("bake")
    assert first(told, "potatoes", "boil") < motions(told).index("bake")


def test_tapioca_in_grains_thickens_fruit_and_is_not_boiled_and_drained(steps):
    told = steps("pie", "", "rhubarb:sliced", "strawberry:berries", "sugar:ground", "tapioca:grain", "butter:pieces",
                 "crust:dough")  # fmt: skip
    assert {"rhubarb", "tapioca", "sugar"} <= taking(told, "mix")
    assert "bake" in motions(told)
    assert {"boil", "simmer", "cook"}.isdisjoint(motions(told))


def test_a_joint_is_browned_and_braised_in_milk_and_carved(steps):
    told = steps("pork", "", "pork:shoulder", "milk:juice", "sage:leaves", "lemon:peeled", "garlic:whole",
                 "butter:creamy", "salt:ground")  # fmt: skip
    assert "milk" not in taking(told, "cook and stir")
    assert first(told, "milk", "simmer") < first(told, "pork", "slice")


def test_fish_that_a_title_calls_smoked_is_not_boiled(steps):
    told = steps("pasta", "Smoked Trout Linguine", "linguine:uncooked", "trout fillets:flaked", "creme fraiche:creamy",
                 "watercress:chopped")  # fmt: skip
    assert first(told, "trout fillets", "pull apart") == min(
        place for place, (inputs, _, _) in enumerate(told) if "trout fillets" in inputs
    )


def test_fish_fingers_are_cooked_before_they_lie_on_bread(steps):
    told = steps("sandwich", "Fish Finger Sandwich", "fish fingers:frozen", "bread:loaf", "tartare sauce:creamy")
    assert {"cooked", "baked"} & states_of(told, "fish fingers")


def test_what_a_title_calls_grilled_is_marinated_in_stock_and_ketchup_and_broiled(steps):
    told = steps("chicken", "Huli Huli Grilled Chicken", "chicken thighs:skinless", "brown sugar:granulated",
                 "ketchup:sauce", "soy sauce:liquid", "chicken broth:liquid", "garlic:minced")  # fmt: skip
    assert {"ketchup", "chicken broth", "soy sauce"} <= taking(told, "stir")
    assert motions(told).index("chill") < motions(told).index("broil")


def test_anchovy_butter_lies_on_a_steak_and_cress_beside_it(steps):
    told = steps("steak", "Bavette with Anchovy Butter", "bavette steaks:raw", "oil:liquid", "butter:unmelted",
                 "anchovies in oil:chopped", "garlic:crushed", "watercress:leaves")  # fmt: skip
    assert {"butter", "anchovies in oil"} <= taking(told, "mix")
    assert inside(told, "cook") & {"bavette steaks"}
    assert inside(told, "cook").isdisjoint({"butter", "anchovies in oil", "watercress"})


def test_roots_are_boiled_and_mashed_before_they_are_kneaded_into_a_dough(steps):
    told = steps("bread", "Potato Bread", "russet potato:cubed", "water:liquid", "yeast:powder", "butter:softened",
                 "salt:granulated", "bread flour:powder")  # fmt: skip
    assert first(told, "russet potato", "boil") < first(told, "russet potato", "mash") < motions(told).index("knead")


def test_ground_polenta_is_flour_of_a_cake(steps):
    told = steps("cake", "", "almond:ground", "polenta:ground", "egg:whole raw", "butter:softened", "sugar:ground",
                 "baking powder:ground")  # fmt: skip
    assert "boil" not in motions(told)


def test_cured_ham_comes_on_a_pizza_that_is_baked(steps):
    told = steps("pizza", "", "dough:dough", "prosciutto:sliced", "gorgonzola:crumbled", "vinegar:thick liquid")
    assert motions(told).index("bake") < min(last(told, food) for food in ("prosciutto", "vinegar"))
    assert inside(told, "bake").isdisjoint({"prosciutto", "vinegar"})


def test_crab_is_bound_and_baked_under_crumbs(steps):
    told = steps("seafood", "Deviled Crab", "crabmeat:canned", "celery:minced", "crackers:crushed", "butter:melted",
                 "mayonnaise:creamy", "egg:beaten", "mustard:dry")  # fmt: skip
    assert {"crabmeat", "mayonnaise", "egg"} <= taking(told, "mix")
    assert first(told, "celery", "cook and stir") < motions(told).index("bake")


def test_marinated_carrots_are_boiled_and_left_in_their_dressing(steps):
    told = steps("vegetables", "Copper Pennies", "carrots:sliced", "onion:sliced", "tomato soup:canned",
                 "sugar:granulated", "oil:liquid", "vinegar:liquid")  # fmt: skip
    assert first(told, "carrots", "mix") < motions(told).index("chill")
    assert "carrots" in taking(told, "cook") | taking(told, "boil")


def test_halloumi_is_fried_for_a_salad(steps):
    told = steps("salad", "Halloumi Salad", "halloumi:sliced", "baby spinach:leaves", "cherry tomatoes:halved",
                 "olive oil:liquid", "red wine vinegar:liquid")  # fmt: skip
    assert {"halloumi", "frying pan"} <= taking(told, "cook")


def test_leaves_are_fried_for_a_mash(steps):
    told = steps("potatoes", "", "potato:mashed", "cabbage:shredded", "butter:creamy", "milk:juice", "salt:ground")
    assert first(told, "cabbage", "cook and stir") < first(told, "cabbage", "mix")


def test_soda_is_poured_on_what_was_blended(steps):
    told = steps("drinks", "", "watermelon:cubed", "lime:juice", "sugar:syrup", "soda:juice", "ice:crushed")
    assert motions(told).index("blend") < last(told, "soda")
    assert "soda" not in inside(told, "blend")


def test_a_sauce_of_honey_comes_after_what_is_fried_for_a_moment(steps):
    told = steps("stir-fry", "", "tempeh:cubed", "bok choy:leaves", "pepper:strips", "lime:juice", "soy sauce:juice",
                 "ginger:minced", "honey:thick liquid", "oil:juice", "water:juice")  # fmt: skip
    poured = next(place for place, (inputs, _, _) in enumerate(told) if {"mixture", "cooking pan"} <= inputs)
    assert max(first(told, food, "cook and stir") for food in ("tempeh", "bok choy", "pepper")) < poured


@pytest.mark.parametrize(
    ("dish_type", "title", "flesh"),
    [("pork", "Pork Chops with Mashed Potatoes", "pork chops:raw"), ("sausage", "Bangers and Mash", "sausages:raw")],
)
def test_potatoes_for_mash_are_boiled_once_and_flesh_without_a_gravy_is_only_fried(steps, dish_type, title, flesh):
    told = steps(dish_type, title, flesh, "oil:liquid", "potatoes:whole", "butter:solid", "milk:liquid", "salt:ground")
    assert motions(told).count("boil") == 1
    assert {"potatoes", "butter", "milk", "salt"} <= taking(told, "mash")
    assert "simmer" not in motions(told)


@pytest.mark.parametrize(
    ("dish_type", "title", "starch"),
    [("pasta", "Hamburger Macaroni Skillet", "elbow macaroni:uncooked"),
     ("noodle", "Hamburger Paprika Noodles", "egg noodles:uncooked"),
     ("rice", "Cheeseburger Rice Skillet", "rice:uncooked")],
)  # fmt: skip
def test_mince_that_a_dish_of_pasta_or_rice_is_called_after_is_not_shaped(steps, dish_type, title, starch):
    told = steps(dish_type, title, "ground beef:raw", "onion:diced", starch, "tomato sauce:canned", "cheddar:shredded")
    assert "shape" not in motions(told)
    assert {"ground beef", "onion"} <= taking(told, "cook and stir")


def test_what_is_called_a_melt_is_fried_with_its_bread_around_it(steps):
    told = steps("sandwich", "Turkey and Apple Melts", "bread:sliced", "deli turkey:sliced", "apple:sliced",
                 "cheddar:grated", "butter:softened")  # fmt: skip
    assert motions(told)[-4:-2] == ["flip", "cook"]


def test_scalloped_corn_is_baked_in_its_eggs(steps):
    told = steps("vegetables", "Scalloped Corn", "corn:canned", "crackers:crushed", "eggs:beaten", "milk:liquid",
                 "butter:melted")  # fmt: skip
    assert "oven" in taking(told, "bake")


@pytest.mark.parametrize("fruit", ["pears", "rhubarb"])
def test_a_pudding_that_is_called_steamed_is_steamed_in_its_basin(steps, fruit):
    told = steps("pudding", f"Steamed Ginger and {fruit.title()} Pudding", f"{fruit}:sliced", "butter:softened",
                 "sugar:granulated", "eggs:uncooked", "self-raising flour:powder", "milk:liquid")  # fmt: skip
    assert "pudding basin" in taking(told, "steam")


@pytest.mark.parametrize("fruit", ["gooseberry:berries", "apple:peeled", "plum:halved"])
def test_fruit_and_sugar_without_a_title_are_cooked_to_a_sauce(steps, fruit):
    told = steps("sauce", "", fruit, "sugar:ground", "water:juice")
    assert fruit.split(":")[0] in taking(told, "cook and stir")
