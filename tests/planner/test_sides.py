"""Potatoes, vegetables, salads and soups are made as what they are called: boiled first, baked whole, served cold."""

from __future__ import annotations

import pytest
from planner.told_steps import first, motions

pytestmark = pytest.mark.shared_data

SEASONED = ("salt:granulated", "black pepper:ground")


def vessels(told, food):
    """Return in or on what a food is, step by step."""
    return [node.container for _, _, outputs in told for node in outputs if node.label == food and node.container]


@pytest.mark.parametrize(
    ("title", "foods", "in_turn"),
    [
        (
            "Colcannon",
            ("potatoes:cubed", "kale:chopped", "milk:liquid", "butter:unmelted", *SEASONED),
            ("boil", "mash"),
        ),
        (
            "Smashed Potatoes",
            ("baby potatoes:whole", "olive oil:liquid", "garlic:minced", *SEASONED),
            ("boil", "press", "bake"),
        ),
        (
            "Hasselback Potatoes",
            ("potatoes:whole", "butter:melted", "garlic:minced", *SEASONED),
            ("cut", "brush", "bake"),
        ),
        (
            "Sweet Potato Casserole",
            ("sweet potatoes:whole", "eggs:whole", "butter:unmelted", "brown sugar:granulated", "marshmallows:mini"),
            ("boil", "mash", "bake"),
        ),
        (
            "Stuffed Sweet Potatoes",
            ("sweet potatoes:whole", "black beans:canned", "cumin:ground", "sour cream:creamy"),
            ("bake", "cut"),
        ),
    ],
)
def test_potatoes_are_boiled_pressed_scored_or_baked_whole_in_turn(steps, title, foods, in_turn):
    worked = {foods[0].split(":")[0], "mixture", "potatoes"}
    done = [motion for inputs, motion, _ in steps("potatoes", title, *foods) if inputs & worked]
    assert [motion for motion in done if motion in in_turn][-len(in_turn) :] == list(in_turn)


def test_new_potatoes_are_boiled_whole_and_turned_in_butter(steps):
    told = steps(
        "potatoes", "New Potatoes with Butter and Dill", "new potatoes:whole", "butter:unmelted", "dill:chopped"
    )
    assert {"grate", "slice", "chop"}.isdisjoint(motion for inputs, motion, _ in told if "new potatoes" in inputs)
    assert first(told, "new potatoes", "boil") < first(told, "butter", "pick-and-place")


def test_what_lies_on_fries_is_not_fried_with_them(steps):
    told = steps(
        "potatoes",
        "Poutine",
        "russet potatoes:cut",
        "vegetable oil:liquid:frying",
        "cheese curds:solid",
        "butter:unmelted:gravy",
        "flour:powder:gravy",
        "beef broth:liquid:gravy",
    )
    assert "oven" not in set().union(*(inputs for inputs, _, _ in told))
    assert "cooking pan" not in vessels(told, "cheese curds")
    assert vessels(told, "flour")[0] == "saucepan"


@pytest.mark.parametrize(
    ("dish_type", "title", "foods", "raw"),
    [
        (
            "vegetables",
            "Cauliflower Steaks with Chimichurri",
            (
                "cauliflower:sliced",
                "olive oil:liquid",
                "parsley:chopped:chimichurri",
                "oregano:fresh:chimichurri",
                "olive oil:liquid:chimichurri",
                "red wine vinegar:liquid:chimichurri",
            ),
            "red wine vinegar",
        ),
        (
            "vegetables",
            "Corn on the Cob with Herb Butter",
            ("corn:whole", "butter:softened", "parsley:chopped", "salt:granulated"),
            "butter",
        ),
        (
            "potatoes",
            "Stuffed Sweet Potatoes",
            ("sweet potatoes:whole", "black beans:canned", "cumin:ground", "avocado:diced"),
            "avocado",
        ),
    ],
)
def test_what_comes_on_cooked_vegetables_is_not_cooked(steps, dish_type, title, foods, raw):
    told = steps(dish_type, title, *foods)
    assert {"cooking pan", "saucepan", "baking tray"}.isdisjoint(vessels(told, raw))


def test_cauliflower_in_batter_is_baked_before_it_is_tossed_in_its_sauce(steps):
    told = steps(
        "vegetables",
        "Buffalo Cauliflower",
        "cauliflower:floret",
        "flour:powder",
        "milk:liquid",
        "hot sauce:liquid",
        "butter:melted",
    )
    done = motions(told)
    assert done.index("dip") < done.index("bake")
    assert vessels(told, "hot sauce")[0] == "saucepan"
    assert "flour" not in vessels(told, "saucepan")


def test_slices_meet_flour_egg_and_crumbs_one_after_another(steps):
    told = steps(
        "vegetables",
        "Eggplant Parmesan",
        "eggplants:sliced",
        "eggs:beaten",
        "breadcrumbs:crumbs",
        "flour:powder",
        "marinara sauce:thick liquid",
        "mozzarella:shredded",
        "olive oil:liquid",
        "basil leaves:leaf",
    )
    assert motions(told).count("dip") == 3


@pytest.mark.parametrize(
    ("title", "foods", "pan"),
    [
        (
            "German Potato Salad",
            (
                "red potatoes:whole",
                "bacon:raw",
                "onion:chopped",
                "vinegar:liquid",
                "flour:powder",
                "sugar:granulated",
                "water:liquid",
            ),
            "vinegar",
        ),
        (
            "Spinach Salad with Warm Bacon Dressing",
            ("baby spinach:whole", "bacon:chopped", "vinegar:liquid", "mushrooms:sliced", "mustard:creamy"),
            "vinegar",
        ),
    ],
)
def test_a_dressing_of_bacon_is_made_in_the_pan(steps, title, foods, pan):
    assert "cooking pan" in vessels(steps("salad", title, *foods), pan)


def test_what_a_salad_calls_crispy_is_baked_and_laid_on_it_last(steps):
    told = steps(
        "salad",
        "Kale Salad with Crispy Chickpeas",
        "kale:chopped",
        "chickpeas:canned",
        "olive oil:liquid",
        "paprika:ground",
        "tahini:creamy:dressing",
        "lemon juice:liquid:dressing",
        "water:liquid:dressing",
    )
    (place,) = [place for place, motion in enumerate(motions(told)) if motion == "bake"]
    assert any("kale" in node.ingredients for _, _, outputs in told[place:] for node in outputs)
    assert motions(told)[-1] == "pour"


def test_pulses_swell_in_the_water_that_is_listed_beside_them(steps):
    told = steps(
        "salad",
        "Lentil Salad",
        "green lentils:dried",
        "water:liquid",
        "bay leaf:sprig",
        "shallot:minced",
        "olive oil:liquid:dressing",
        "vinegar:liquid:dressing",
    )
    assert vessels(told, "water")[-1] == "pot"


@pytest.mark.parametrize("title", ["Vichyssoise", "Cucumber Yogurt Soup"])
def test_a_cold_soup_is_chilled(steps, title):
    told = steps(
        "soup",
        title,
        "leeks:sliced",
        "cucumber:chopped",
        "potatoes:diced",
        "chicken stock:liquid",
        "heavy cream:liquid",
        "yogurt:creamy",
    )
    assert "refrigerator" in set().union(*(inputs for inputs, _, _ in told))


def test_lime_comes_to_a_sour_soup_when_all_else_is_done(steps):
    told = steps(
        "soup",
        "Tom Yum",
        "water:liquid",
        "lemongrass:sliced",
        "mushrooms:halved",
        "shrimp:peeled",
        "fish sauce:liquid",
        "lime juice:liquid",
    )
    assert first(told, "shrimp", "pour") < first(told, "lime juice", "pour")


def test_the_flour_of_a_gumbo_is_browned_in_its_fat_before_vegetables_come_to_it(steps):
    told = steps(
        "soup",
        "Chicken Gumbo",
        "oil:liquid",
        "flour:powder",
        "onion:chopped",
        "celery:chopped",
        "chicken thighs:raw",
        "chicken stock:liquid",
        "okra:sliced",
    )
    assert first(told, "flour", "pour") < first(told, "onion", "pour")


def test_cream_cheese_melts_in_a_soup(steps):
    told = steps(
        "soup",
        "White Chicken Chili",
        "chicken breasts:raw",
        "onion:chopped",
        "white beans:canned",
        "chicken broth:liquid",
        "cream cheese:creamy",
    )
    assert vessels(told, "cream cheese")[-1] in {"pot", "cooking pan", "saucepan"}


@pytest.mark.parametrize(
    ("dish_type", "title", "foods", "body"),
    [
        ("vegetables", "Cauliflower Mash", ("cauliflower:floret", "butter:unmelted", "cream:creamy"), "cauliflower"),
        ("salad", "", ("beet:whole", "goat cheese:creamy", "walnut:chopped", "arugula:leaves", "oil:juice"), "beet"),
        ("vegetables", "Leeks Vinaigrette", ("leeks:whole", "vinegar:liquid", "olive oil:liquid"), "leeks"),
        (
            "potatoes",
            "Creamed New Potatoes",
            ("potatoes:new", "butter:unmelted", "flour:powder", "milk:liquid"),
            "potatoes",
        ),
    ],
)
def test_what_is_hard_is_boiled_before_it_is_mashed_dressed_or_creamed(steps, dish_type, title, foods, body):
    told = steps(dish_type, title, *foods)
    assert first(told, body, "boil") < len(told)
    assert "grate" not in motions(told)


@pytest.mark.parametrize(
    ("title", "foods", "baked"),
    [
        ("Roasted Sweet Potato and Kale Salad",
         ("sweet potatoes:cubed", "olive oil:liquid", "kale:chopped", "vinegar:liquid:dressing"), "sweet potatoes"),
        ("Pear Salad with Crispy Prosciutto",
         ("prosciutto:slices", "pears:sliced", "arugula:leaves", "olive oil:liquid", "vinegar:liquid"), "prosciutto"),
    ],
)  # fmt: skip
def test_what_a_salad_calls_roasted_or_crispy_comes_out_of_the_oven(steps, title, foods, baked):
    told = steps("salad", title, *foods)
    assert "cooking pan" not in vessels(told, baked)
    assert "bake" in motions(told)


def test_slices_for_a_salad_are_breaded_and_fried_before_they_lie_on_it(steps):
    told = steps("salad", "Fried Goat Cheese Salad", "goat cheese:sliced", "egg:beaten", "panko:crumbs", "flour:powder",
                 "oil:liquid", "mixed greens:leaf", "vinegar:liquid:dressing", "olive oil:liquid:dressing")  # fmt: skip
    assert motions(told).count("dip") == 3
    assert first(told, "goat cheese", "dip") < first(told, "goat cheese", "cook")


def test_untitled_potatoes_with_bacon_flour_and_vinegar_get_a_hot_dressing(steps):
    told = steps("salad", "", "potato:whole veg", "bacon:sliced", "onion:chopped", "flour:ground", "sugar:ground",
                 "vinegar:juice", "water:juice", "parsley:minced")  # fmt: skip
    assert "cooking pan" in vessels(told, "flour")


def test_tomatoes_are_baked_in_halves_under_their_crumbs(steps):
    told = steps("vegetables", "Tomatoes Provencal", "tomatoes:halved", "breadcrumbs:crumbs", "garlic:minced",
                 "parsley:chopped", "olive oil:liquid")  # fmt: skip
    assert "cooking pan" not in vessels(told, "tomatoes")
    assert motions(told).index("stir") < motions(told).index("bake")


def test_a_peanut_sauce_is_cooked_before_it_comes_over_vegetables(steps):
    told = steps("salad", "Gado Gado", "potatoes:boiled", "green beans:trimmed", "peanut butter:creamy:sauce",
                 "coconut milk:liquid:sauce", "soy sauce:liquid:sauce")  # fmt: skip
    assert vessels(told, "peanut butter")[0] == "saucepan"


def test_an_almond_soup_is_raw_and_chilled(steps):
    told = steps(
        "soup", "Ajo Blanco", "almonds:blanched", "bread:stale", "garlic:clove", "olive oil:liquid", "water:cold"
    )
    assert "stove" not in set().union(*(inputs for inputs, _, _ in told))
    assert "refrigerator" in set().union(*(inputs for inputs, _, _ in told))


def test_all_that_a_recipe_lists_for_its_dressing_is_mixed_in_it(steps):
    told = steps(
        "salad",
        "Wedge Salad",
        "iceberg lettuce:cut",
        "mayonnaise:creamy:dressing",
        "sour cream:creamy:dressing",
        "blue cheese:crumbled:dressing",
        "lemon juice:liquid:dressing",
    )
    (mixed, *_) = [outputs for _, motion, outputs in told if motion == "mix"]
    assert any({"blue cheese", "mayonnaise"} <= set(node.ingredients) for node in mixed)


def test_beaten_whites_come_to_the_batter_and_not_to_what_is_dipped_in_it(steps):
    told = steps(
        "vegetables",
        "Chiles Rellenos",
        "poblano peppers:whole",
        "Monterey Jack cheese:block",
        "eggs:separated",
        "flour:powder",
        "oil:liquid",
        "salsa:sauce",
    )
    assert motions(told).index("fold") < motions(told).index("dip")


def test_feta_is_strewn_on_beets_when_they_are_roasted(steps):
    told = steps(
        "vegetables", "Roasted Beets with Feta", "beets:whole", "olive oil:liquid", "feta:crumbled", "mint:chopped"
    )
    assert "baking tray" not in vessels(told, "feta")


def test_onions_are_fried_with_home_fries(steps):
    told = steps("potatoes", "Home Fries", "potatoes:diced", "onion:diced", "bell pepper:diced", "vegetable oil:liquid")
    assert motions(told)[-1] != "sprinkle"
    assert not any(
        {"onion", "plate"} <= inputs and "potatoes" in inputs for inputs, motion, _ in told if motion == "pour"
    )


def test_tahini_is_mashed_with_an_eggplant_that_was_roasted(steps):
    told = steps(
        "vegetables",
        "Baba Ganoush Roasted Eggplant with Pomegranate",
        "eggplants:halved",
        "olive oil:liquid",
        "tahini:creamy",
        "lemon juice:liquid",
        "pomegranate seeds:berries",
    )
    assert "baking tray" not in vessels(told, "tahini")
    assert motions(told).index("bake") < motions(told).index("mash")


def test_raw_cucumber_with_bread_and_vinegar_is_blended_and_chilled(steps):
    told = steps("soup", "", "tomato:whole veg", "cucumber:peeled", "pepper:seeded", "garlic:crushed", "bread:crumbs",
                 "oil:juice", "vinegar:juice", "water:juice")  # fmt: skip
    assert [motion for motion in motions(told) if motion in {"blend", "chill", "simmer", "boil"}] == ["blend", "chill"]


def test_what_lies_beside_a_stew_is_eaten_from_a_plate_with_it(steps):
    told = steps("pork", "Pork stew", "pork shoulder:cubed", "onion:chopped", "red wine:liquid", "water:liquid",
                 "white rice:cooked:serving")  # fmt: skip
    (place,) = {node.container for node in told[-1][2] if node.label != "plate" and node.container}
    assert place == "plate"
