"""Dishes of rice, noodles and pasta, stir-fries and casseroles: each is made as what it is called is made."""

from __future__ import annotations

import pytest
from planner.told_steps import Told, first, inside, motions

pytestmark = pytest.mark.shared_data


def _into(told: Told, food: str, vessel: str) -> int:
    """Return at which step a food comes into a vessel."""
    return next(n for n, (inputs, one, _) in enumerate(told) if {food, vessel} <= inputs and one != "grate")


def test_the_eggs_of_a_carbonara_never_see_the_heat(steps):
    told = steps("pasta", "Spaghetti Carbonara", "spaghetti:uncooked", "guanciale:diced", "egg yolks:uncooked",
                 "egg:whole", "pecorino romano:grated", "black pepper:ground")  # fmt: skip
    off = max(place for place, motion in enumerate(motions(told)) if motion == "turn off")
    assert off < first(told, "egg mixture", "stir")
    assert "pecorino romano" in inside(told, "whisk")


def test_noodles_are_stirred_with_a_sauce_that_is_mixed_apart(steps):
    told = steps("noodle", "", "rice noodles:uncooked", "oil:liquid", "garlic:minced", "shrimp:peeled",
                 "egg:beaten", "fish sauce:sauce", "soy sauce:liquid", "sugar:granulated", "peanuts:whole")  # fmt: skip
    assert {"fish sauce", "soy sauce", "sugar"} <= inside(told, "stir")
    assert first(told, "shrimp", "cook and stir") < first(told, "mixture", "pour")
    assert _into(told, "peanuts", "noodle") > max(n for n, one in enumerate(motions(told)) if one == "turn off")


def test_a_sauce_of_nuts_is_not_cooked(steps):
    told = steps("noodle", "Spicy Peanut Noodles", "spaghetti:uncooked", "peanut butter:creamy", "soy sauce:liquid",
                 "rice vinegar:liquid", "honey:thick liquid", "cucumber:julienned")  # fmt: skip
    hot = [inputs for inputs, motion, _ in told if motion in {"cook", "simmer", "cook and stir"}]
    assert not [inputs for inputs in hot if {"peanut butter", "cucumber"} & inputs]


def test_starch_beside_a_sauce_with_starch_coats_the_meat(steps):
    told = steps("stir-fry", "Beef and Broccoli", "flank steak:sliced", "cornstarch:powder", "broccoli:floret",
                 "oil:liquid", "soy sauce:liquid:sauce", "cornstarch:powder:sauce",
                 "beef broth:liquid:sauce")  # fmt: skip
    assert inside(told, "mix") == {"flank steak", "cornstarch"}
    assert first(told, "flank steak", "mix") < motions(told).index("cook and stir")


def test_pancakes_of_moo_shu_lie_beside_it(steps):
    told = steps("stir-fry", "Moo Shu Pork", "pork:strips", "eggs:beaten", "cabbage:shredded", "soy sauce:liquid",
                 "cornstarch:powder", "oil:liquid", "moo shu pancakes:whole")  # fmt: skip
    assert not [inputs for inputs, one, _ in told if "moo shu pancakes" in inputs and one.startswith("cook")]
    assert first(told, "eggs", "cook and stir") < first(told, "pork", "cook and stir")


def test_what_lies_on_a_bowl_of_rice_is_not_cooked(steps):
    told = steps("rice", "Chicken Burrito Bowl", "rice:uncooked", "water:liquid", "chicken breast:raw",
                 "black beans:drained", "olive oil:liquid", "avocado:diced", "sour cream:creamy",
                 "cheddar cheese:shredded")  # fmt: skip
    off = max(place for place, motion in enumerate(motions(told)) if motion == "turn off")
    for food in ("avocado", "sour cream", "cheddar cheese"):
        assert max(n for n, (inputs, _, _) in enumerate(told) if food in inputs) > off


def test_rice_for_sushi_boils_in_the_water_that_is_asked(steps):
    told = steps("rice", "California Rolls", "sushi rice:uncooked", "water:liquid", "rice vinegar:liquid", "nori:sheet",
                 "avocado:sliced", "imitation crab:canned")  # fmt: skip
    (inputs,) = [inputs for inputs, motion, _ in told if motion == "simmer"]
    assert "sushi rice" in inputs
    assert not [inputs for inputs, _, _ in told if {"water", "cutting board"} <= inputs]


def test_balls_of_rice_are_turned_in_crumbs_before_they_are_fried(steps):
    told = steps("rice", "Arancini", "risotto rice:cooked", "parmesan:grated", "eggs:uncooked", "flour:powder",
                 "breadcrumbs:crumbs", "oil:liquid")  # fmt: skip
    assert first(told, "breadcrumbs", "dip") < motions(told).index("cook")


def test_base_of_jollof_is_blended_and_cooked_with_the_rice(steps):
    told = steps("rice", "Jollof Rice", "rice:uncooked", "tomatoes:whole", "red bell peppers:whole", "onions:whole",
                 "oil:liquid", "tomato paste:paste", "chicken stock:liquid")  # fmt: skip
    assert inside(told, "blend") == {"tomatoes", "red bell peppers", "onions"}
    assert motions(told).index("blend") < motions(told).index("simmer")


def test_wedges_lie_on_rice_that_is_out_of_its_pot(steps):
    told = steps("rice", "Seafood Paella", "rice:uncooked", "olive oil:liquid", "onion:chopped", "fish stock:liquid",
                 "shrimp:peeled", "lemon wedges:whole:serving")  # fmt: skip
    assert not [inputs for inputs, _, _ in told if {"lemon wedges", "pot"} <= inputs]


def test_sheets_fried_meat_and_white_sauce_are_three_layers(steps):
    told = steps("pasta", "Lasagne al Forno", "lasagne sheets:uncooked", "beef mince:uncooked", "onion:chopped",
                 "tomatoes:canned", "butter:unmelted:sauce", "flour:powder:sauce", "milk:liquid:sauce",
                 "Parmesan:grated")  # fmt: skip
    assert first(told, "beef mince", "cook and stir") < motions(told).index("bake")
    assert not [inputs for inputs, one, _ in told if one == "cook and stir" and {"flour", "beef mince"} <= inputs]


def test_sweet_potatoes_are_mashed_for_a_casserole_though_they_are_asked_cubed(steps):
    told = steps("casserole", "Sweet Potato Casserole", "sweet potatoes:cubed", "sugar:granulated", "eggs:beaten",
                 "milk:liquid", "pecans:chopped")  # fmt: skip
    assert first(told, "sweet potatoes", "boil") < first(told, "sweet potatoes", "mash") < motions(told).index("bake")


@pytest.mark.parametrize(
    ("title", "asked"),
    [
        ("Shepherd's Pie", ("lamb:minced", "onion:chopped", "beef stock:liquid", "potatoes:cut", "butter:unmelted")),
        ("Lancashire Hotpot", ("lamb:cubed", "onions:sliced", "lamb stock:liquid", "potatoes:sliced", "butter:melted")),
        ("Ratatouille", ("eggplant:cubed", "zucchini:sliced", "tomatoes:chopped", "olive oil:liquid")),
    ],
)
def test_what_is_stewed_for_a_casserole_is_baked_then(steps, title, asked):
    told = steps("casserole", title, *asked)
    stewed = asked[0].split(":")[0]
    assert first(told, stewed, "cook and stir") < motions(told).index("bake")


def test_beans_that_were_soaked_are_boiled_before_rice_is_done(steps):
    told = steps("rice", "Hoppin' John", "black-eyed peas:soaked", "bacon:chopped", "onion:chopped", "rice:uncooked",
                 "water:liquid")  # fmt: skip
    assert first(told, "black-eyed peas", "cook") < first(told, "rice", "simmer")


def test_meat_of_a_biryani_lies_in_its_yogurt_before_it_is_cooked(steps):
    told = steps("rice", "Chicken Biryani", "basmati rice:uncooked", "chicken thighs:cut", "yogurt:creamy:marinade",
                 "turmeric:ground:marinade", "onions:sliced", "ghee:creamy", "mint:chopped")  # fmt: skip
    assert first(told, "yogurt", "stir") < first(told, "chicken thighs", "mix") < motions(told).index("cook and stir")


def test_a_sauce_with_starch_is_cooked_with_what_lies_on_a_bowl_of_rice(steps):
    told = steps("rice", "Teriyaki Chicken Rice Bowls", "chicken thighs:cubed", "rice:uncooked", "water:liquid",
                 "soy sauce:liquid:sauce", "honey:thick liquid:sauce", "cornstarch:powder:sauce")  # fmt: skip
    assert "cornstarch" in inside(told, "stir")
    assert first(told, "mixture", "cook and stir") > first(told, "mixture", "pour")


def test_what_is_listed_for_a_marinade_is_not_cooked_beside_the_meat(steps):
    told = steps("stir-fry", "Bulgogi Stir Fry", "ribeye:sliced", "soy sauce:liquid:marinade",
                 "sugar:granulated:marinade", "onion:sliced", "oil:liquid")  # fmt: skip
    assert first(told, "soy sauce", "stir") < first(told, "ribeye", "mix") < motions(told).index("cook and stir")


@pytest.mark.parametrize(
    "asked",
    [
        ("egg noodle:uncooked", "flour:ground", "butter:ground", "milk:juice", "tuna:canned", "potato chip:crushed"),
        ("noodle:uncooked", "ham:diced", "egg:whole", "milk:juice", "bread crumb:ground"),
        ("noodle:uncooked", "cream of chicken soup:creamy", "milk:juice", "pea:berries", "bread crumb:ground"),
    ],
)
def test_noodles_that_are_asked_with_crumbs_are_baked_under_them(steps, asked):
    told = steps("noodle", "", *asked)
    crumbs = next(food.split(":")[0] for food in asked if "crumb" in food or "chip" in food)
    assert _into(told, crumbs, "baking dish") < motions(told).index("bake")


def test_no_vegetable_of_creamed_noodles_stays_raw(steps):
    told = steps("noodle", "", "chicken:shredded", "noodle:uncooked", "celery:chopped", "carrot:sliced",
                 "broth:thick liquid", "cream:juice", "flour:ground", "butter:ground")  # fmt: skip
    off = max(place for place, motion in enumerate(motions(told)) if motion == "turn off")
    for food in ("celery", "carrot"):
        assert max(n for n, (inputs, _, _) in enumerate(told) if food in inputs) < off


def test_noodles_with_vinegar_and_what_is_crisp_are_tossed_cold(steps):
    told = steps("noodle", "", "soba noodle:uncooked", "soy sauce:sauce", "oil:juice", "vinegar:juice",
                 "cucumber:sliced", "carrot:shredded")  # fmt: skip
    assert "cook and stir" not in motions(told)
    assert {"oil", "vinegar", "soy sauce"} <= inside(told, "stir")


def test_crisp_noodles_are_stirred_into_what_melts_and_never_boiled(steps):
    told = steps("noodle", "", "chow mein noodle:crispy", "butterscotch chip:chopped", "peanut butter:creamy")
    assert "boil" not in motions(told)
    assert first(told, "butterscotch chip", "cook and stir") < motions(told).index("chill")


def test_noodles_of_flour_and_egg_are_rolled_and_boiled_in_their_broth(steps):
    told = steps("noodle", "", "flour:ground", "egg:whole", "salt:ground", "stock:thick liquid")
    assert motions(told).index("knead") < motions(told).index("roll") < max(
        place for place, motion in enumerate(motions(told)) if motion == "simmer"
    )  # fmt: skip


def test_rice_with_mayonnaise_is_a_salad(steps):
    told = steps("rice", "", "rice:cooked", "mayonnaise:creamy", "celery:chopped", "lemon:juice", "onion:minced")
    assert "mayonnaise" in inside(told, "stir")
    assert not [inputs for inputs, one, _ in told if "celery" in inputs and one.startswith(("cook", "simmer"))]


def test_a_bowl_of_rice_is_made_though_a_sauce_for_it_is_stirred_apart(steps):
    told = steps("rice", "Salmon Rice Bowl", "salmon fillets:raw", "rice:cooked", "mayonnaise:creamy:sauce",
                 "sriracha:sauce:sauce", "soy sauce:liquid", "avocado:sliced", "edamame:frozen")  # fmt: skip
    off = max(place for place, motion in enumerate(motions(told)) if motion == "turn off")
    assert min(n for n, (inputs, _, _) in enumerate(told) if {"avocado", "bowl"} <= inputs) > off
    assert "mayonnaise" in inside(told, "stir")


def test_nuts_that_are_creamy_are_their_butter_and_join_the_sauce(steps):
    told = steps("noodle", "", "noodle:dried", "peanut:creamy", "soy sauce:sauce", "vinegar:juice", "honey:thick sauce",
                 "cucumber:sliced", "scallion:sliced")  # fmt: skip
    assert {"peanut", "soy sauce"} <= inside(told, "stir")


def _where_from(told: Told, food: str) -> set[str]:
    """Return what a food is in or on, in the first step that has it."""
    return next(inputs for inputs, _, _ in told if food in inputs) - {food}


@pytest.mark.parametrize("food", ["Greek yoghurt", "tkemali", "dendê", "browning", "pul biber", "amba"])
def test_what_is_loose_comes_in_something(steps, food):
    told = steps("soup", "Tomato soup", "tomatoes:canned", "onion:chopped", "stock:liquid", f"{food}:")
    assert _where_from(told, food) & {"bottle", "container", "jar", "shaker", "packet"}


@pytest.mark.parametrize("title", ["Pastitsio", "Macarona Béchamel"])
def test_a_white_sauce_lies_over_the_fried_meat(steps, title):
    told = steps("pasta", title, "penne:uncooked", "olive oil:liquid", "onion:chopped", "minced beef:raw",
                 "tomatoes:canned", "butter:unmelted:sauce", "flour:powder:sauce", "milk:liquid:sauce",
                 "egg:beaten:sauce", "parmesan:grated:sauce")  # fmt: skip
    assert _into(told, "minced beef", "cooking pan") < _into(told, "minced beef", "baking dish")
    assert _into(told, "minced beef", "baking dish") < _into(told, "milk", "baking dish")
    assert not [inputs for inputs, one, _ in told if {"minced beef", "flour"} <= inputs and one.startswith("cook")]


def test_pasta_is_tossed_in_a_green_cream(steps):
    told = steps("pasta", "Tallarines Verdes", "spaghetti:uncooked", "spinach:leaves", "basil:leaf", "oil:liquid",
                 "red onion:chopped", "garlic:clove", "evaporated milk:liquid", "pecans:whole")  # fmt: skip
    assert {"basil", "pecans", "spinach"} <= inside(told, "blend")


def test_meat_on_the_bone_comes_back_into_its_soup(steps):
    told = steps("soup", "Borscht", "beef shin on the bone:raw", "water:liquid", "beetroot:coarsely grated",
                 "onion:chopped", "oil:liquid", "potatoes:cut", "dill:chopped")  # fmt: skip
    pulled = motions(told).index("pull apart")
    assert "beef shin on the bone" in told[pulled][0]
    assert [inputs for inputs, _, _ in told[pulled + 1 :] if "beef shin on the bone" in inputs]
    assert any("coarsely grated" in node.states for _, one, out in told if one == "grate" for node in out)


@pytest.mark.parametrize(("dish_type", "title"), [("noodle", "Sopa de fideo"), ("noodle", "Fideuà"), ("noodle", "")])
def test_thin_noodles_are_fried_and_swell_in_their_broth(steps, dish_type, title):
    told = steps(dish_type, title, "vermicelli:uncooked", "oil:liquid", "tomatoes:chopped", "onion:chopped",
                 "chicken stock:liquid", "queso fresco:crumbled")  # fmt: skip
    assert "vermicelli" in inside(told, "cook and stir")
    assert {"vermicelli", "chicken stock"} <= inside(told, "simmer")


@pytest.mark.parametrize("title", ["Koshari", ""])
def test_rice_pulses_and_pasta_are_boiled_and_lie_under_their_sauce(steps, title):
    told = steps("rice", title, "rice:uncooked", "lentils:dried", "macaroni:uncooked", "onion:sliced", "oil:liquid",
                 "tomato:crushed", "garlic:minced", "vinegar:liquid")  # fmt: skip
    off = max(place for place, motion in enumerate(motions(told)) if motion == "turn off")
    assert _into(told, "rice", "pot") < off < max(n for n, (inputs, _, _) in enumerate(told) if "onion" in inputs)
    assert not [inputs for inputs, _, _ in told if {"rice", "onion", "stove"} <= inputs]


def test_onions_in_flour_are_fried_crisp_over_rice_and_lentils(steps):
    told = steps("rice", "Mujaddara", "lentils:dried", "onions:sliced", "flour:powder", "oil:liquid", "rice:uncooked",
                 "water:liquid", "cumin:ground")  # fmt: skip
    assert inside(told, "mix") == {"flour", "onions"}
    assert "flour" not in inside(told, "simmer")


def test_a_biryani_without_a_name_boils_its_rice(steps):
    told = steps("rice", "", "rice:uncooked", "chicken:pieces", "yogurt:creamy", "onion:sliced", "garlic:crushed",
                 "garam masala:ground", "ghee:creamy", "salt:granulated")  # fmt: skip
    assert {"chicken", "yogurt"} <= {name for node in told[motions(told).index("mix")][2] for name in node.ingredients}
    assert first(told, "rice", "boil") < motions(told).index("simmer")


def test_grains_of_wheat_are_boiled_for_a_salad(steps):
    told = steps("salad", "", "wheat:grain", "parsley:leaves", "tomato:diced", "oil:liquid", "lemon juice:juice")
    assert first(told, "wheat", "cook") < first(told, "parsley", "mix")


def test_spaetzle_are_boiled_and_then_turned_in_fried_onions(steps):
    told = steps("pasta", "Käsespätzle", "flour:powder", "eggs:uncooked", "water:liquid", "salt:granulated",
                 "onions:sliced", "butter:unmelted", "Emmental:grated")  # fmt: skip
    assert {"Emmental", "onions"}.isdisjoint(inside(told, "mix"))
    assert motions(told).index("boil") < first(told, "onions", "cook and stir") < _into(told, "Emmental", "cooking pan")


def test_the_herbs_of_a_pistou_are_blended_and_stirred_into_the_soup(steps):
    told = steps("soup", "Soupe au pistou", "white beans:soaked", "olive oil:liquid", "onion:chopped", "carrots:diced",
                 "water:liquid", "garlic:clove", "basil:leaf", "parmesan:grated")  # fmt: skip
    assert {"basil", "garlic", "parmesan"} <= inside(told, "blend")
    assert "bake" not in motions(told)


def test_vine_leaves_are_rolled_around_their_rice(steps):
    told = steps("rice", "Stuffed vine leaves", "vine leaves in brine:rinsed", "rice:uncooked", "dill:chopped",
                 "onions:chopped", "olive oil:liquid", "water:liquid", "Greek yoghurt::serving")  # fmt: skip
    assert {"rice", "onions"} <= inside(told, "stir")
    assert motions(told).index("roll") < motions(told).index("simmer")


@pytest.mark.parametrize("title", ["Chikhirtma", ""])
def test_eggs_with_flour_come_last_into_a_soup(steps, title):
    told = steps("soup", title, "chicken:pieces", "water:liquid", "onion:chopped", "eggs:beaten", "flour:powder",
                 "vinegar:liquid", "coriander:chopped")  # fmt: skip
    assert {"eggs", "flour"} <= inside(told, "whisk")
    assert _into(told, "chicken", "pot") < _into(told, "egg mixture", "pot")


def test_lentil_soup_is_blended_under_its_butter(steps):
    told = steps("soup", "Mercimek soup", "red lentils:dried", "onion:chopped", "oil:liquid", "stock:liquid",
                 "butter:unmelted", "mint:dried", "pul biber:")  # fmt: skip
    assert {"pul biber", "mint"} <= inside(told[motions(told).index("blend") :], "cook and stir")


def test_tempeh_is_fried_and_not_boiled(steps):
    told = steps("salad", "Gado-gado", "tempeh:fried", "green beans:whole", "eggs:boiled", "cucumber:sliced")
    assert not [inputs for inputs, _, _ in told if {"tempeh", "pot"} <= inputs]
