"""Parts that a recipe tells, or its list shows, are made apart and come to their place: in the tin, on it, beside."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

BATTER = ("flour:powder", "baking powder:powder", "sugar:granulated", "eggs:uncooked", "milk:liquid")
STREUSEL = ("brown sugar:granulated", "cinnamon:ground", "pecans:chopped", "butter:melted")
CHOPS = ("pork chops:raw", "butter:unmelted")
PANCAKES = ("potatoes:grated", "egg:uncooked", "flour:powder", "oil:liquid")


def _under_heading(foods, part):
    return [f"{food}:{part}" for food in foods]


@pytest.mark.parametrize("asked", [STREUSEL, _under_heading(STREUSEL, "topping")])
@pytest.mark.parametrize("dish", ["cake", "muffin"])
def test_nuts_sugar_and_spice_are_strewn_on_a_batter_before_it_is_baked(steps, dish, asked):
    told = steps(dish, "Cinnamon streusel coffee cake", "butter:softened", *BATTER, *asked)
    place = motions(told).index("bake")
    assert any({"brown sugar", "cinnamon", "pecans", "butter"} <= things and "flour" not in things and motion == "mix"
               for things, motion, _ in told[:place])  # fmt: skip
    assert not any("cinnamon" in things for things, _, _ in told[place + 1 :])


def test_the_fat_and_flour_of_a_tin_are_in_no_batter(steps):
    told = steps("cake", "Plain cake", "butter:softened", *BATTER, "shortening:creamy:pan", "rice flour:powder:pan")
    lines = [(things, motion) for things, motion, _ in told if {"shortening", "rice flour"} & set(things)]
    assert [motion for _, motion in lines][:2] == ["spread", "pour"]
    assert all("cake pan" in things for things, _ in lines)


def test_what_is_said_to_be_the_sauce_of_a_loaf_of_meat_lies_on_it(steps):
    told = steps("meatloaf", "Meat loaf", "ground beef:uncooked", "breadcrumbs:crumbs", "egg:uncooked",
                 "tomato sauce:sauce:sauce", "brown sugar:granulated:sauce", "vinegar:liquid:sauce")  # fmt: skip
    assert inside(told, "stir") == {"tomato sauce", "brown sugar", "vinegar"}
    assert inside(told, "mix") == {"ground beef", "breadcrumbs", "egg"}


def test_corn_under_a_heading_is_cooked_and_baked_on_what_is_below(steps):
    below = ("chicken thighs:raw", "ground beef:uncooked", "onion:chopped", "beef stock:liquid", "oil:liquid")
    above = ("corn:grated:topping", "milk:liquid:topping", "lard:creamy:topping")
    told = steps("chicken", "Chicken under corn, baked", *below, *above)
    place = motions(told).index("bake")
    pans = [things for things, motion, _ in told[:place] if motion == "cook and stir"]
    assert any({"corn", "milk", "lard"} <= things for things in pans)
    assert not any({"milk", "lard"} & set(things) for things, _, _ in told[place + 1 :])


def test_a_yolk_binds_the_sauce_that_it_is_for(steps):
    told = steps("meatball", "Meatballs in cream sauce", "ground veal:raw:meatballs", "egg:uncooked:meatballs",
                 "bread:soaked:meatballs", "butter:unmelted:sauce", "flour:powder:sauce", "chicken stock:liquid:sauce",
                 "cream:creamy:sauce", "egg yolk:uncooked:sauce")  # fmt: skip
    assert "egg yolk" not in inside(told, "mix")
    assert first(told, "egg yolk", "pour") < motions(told).index("flip")


@pytest.mark.parametrize(
    ("dish", "title", "flesh", "sauce"),
    [
        ("pork", "Pork chops", CHOPS, ("apples:diced:sauce", "sugar:granulated:sauce")),
        ("pork", "Pork chops with rhubarb sauce", CHOPS, ("rhubarb:sliced", "sugar:granulated")),
        ("potatoes", "Potato pancakes with apple sauce", PANCAKES, ("apples:diced", "sugar:granulated")),
    ],
)
def test_fruit_is_cooked_to_a_sauce_beside_what_is_fried(steps, dish, title, flesh, sauce):
    told = steps(dish, title, *flesh, *sauce)
    fruit = sauce[0].split(":")[0]
    pan = next(things for things, motion, _ in told if motion == "cook and stir" and fruit in things)
    assert not {flesh[0].split(":")[0], "patties"} & set(pan)


def test_nuts_peppers_and_oil_are_blended_beside_an_omelette(steps):
    sauce = _under_heading(("roasted peppers:canned", "almonds:whole", "garlic:clove", "vinegar:liquid"), "sauce")
    told = steps("omelette", "Omelette with romesco", "potatoes:sliced", "eggs:uncooked", "oil:liquid", *sauce)
    assert inside(told, "blend") == {"roasted peppers", "almonds", "garlic", "vinegar"}


@pytest.mark.parametrize("dish", ["stir-fry", "beef"])
def test_grain_with_which_a_title_serves_a_dish_is_boiled_by_itself(steps, dish):
    told = steps(dish, "Beef and peppers with rice", "beef:sliced", "oil:liquid", "green peppers:sliced",
                 "soy sauce:liquid", "rice:uncooked")  # fmt: skip
    boiled = [things - {"pot", "stove"} for things, motion, _ in told if motion == "boil"]
    assert boiled == [{"water"}, {"water", "rice"}]


@pytest.mark.parametrize(
    ("dish", "flesh", "glaze"),
    [
        ("chicken", "chicken thighs:raw", ("apricot jam:jelly", "French dressing:creamy")),
        ("chicken", "chicken breasts:raw", ("peach preserves:jelly", "soy sauce:liquid", "garlic:minced")),
        ("pork", "pork tenderloin:raw", ("cranberry sauce:jelly", "mustard:creamy", "vinegar:liquid")),
    ],
)
def test_jam_and_what_is_stirred_into_it_are_baked_on_flesh(steps, dish, flesh, glaze):
    told = steps(dish, "Glazed in the oven", flesh, *glaze)
    assert inside(told, "stir") == {one.split(":")[0] for one in glaze}
    assert motions(told).index("stir") < motions(told).index("bake")


def test_a_cold_sauce_is_not_stirred_into_the_rice_on_which_it_lies(steps):
    raita = _under_heading(("yogurt:creamy", "cucumber:grated", "mint:chopped"), "raita")
    told = steps("rice", "Chicken biryani with raita", "chicken:uncooked", "yogurt:creamy", "garam masala:ground",
                 "rice:uncooked", "onion:sliced", "ghee:creamy", *raita)  # fmt: skip
    assert motions(told)[-1] == "pour"


def test_a_sauce_is_made_before_the_steak_under_it(steps):
    told = steps("steak", "Steak with red wine sauce", "sirloin steaks:raw", "salt:granulated", "oil:liquid",
                 "shallots:minced", "red wine:liquid", "beef stock:liquid", "butter:unmelted")  # fmt: skip
    assert first(told, "beef stock", "pour") < first(told, "sirloin steaks", "flip")


@pytest.mark.parametrize("sauce", [("mayonnaise:creamy", "garlic:minced"), ("soured cream:creamy", "dill:chopped")])
def test_what_is_stirred_cold_for_patties_is_ready_when_they_come_out_of_the_pan(steps, sauce):
    patties = ("ground lamb:raw", "salt:granulated", "oil:liquid", "burger buns:whole")
    told = steps("burger", "Lamb burgers", *patties, *_under_heading((*sauce, "lemon juice:juice"), "sauce"))
    assert motions(told).index("stir") < motions(told).index("flip")


def test_flat_dough_is_fried_in_some_of_the_fat_that_is_in_it(steps):
    dough = ("all-purpose flour:powder", "yeast:dry", "milk:warm", "yogurt:plain", "sugar:granulated")
    told = steps("bread", "Soft naan", *dough, "ghee:melted", "salt:granulated")
    assert "ghee" in next(things for things, motion, _ in told if motion == "cook" and "dough" in things)


def test_eggs_for_a_sandwich_are_fried_in_fat_that_is_asked_for_its_sauce(steps):
    told = steps("sandwich", "Francesinha", "white bread:loaf", "beef steaks:raw", "ham:cooked", "cheese:block",
                 "eggs:whole", "onion:chopped:sauce", "beer:liquid:sauce", "butter:unmelted:sauce")  # fmt: skip
    pan = next(things for things, motion, _ in told if motion == "cook" and "eggs" in things)
    assert "butter" in pan


def test_fat_of_the_household_is_told_for_each_pan(steps):
    told = steps("burger", "Blue cheese stuffed burgers", "ground beef:uncooked", "blue cheese:crumbled",
                 "Worcestershire sauce:sauce", "garlic powder:ground", "onion:caramelized", "kaiser rolls:split",
                 "arugula:leaves")  # fmt: skip
    assert sum({"oil", "bottle", "cooking pan"} <= things for things, _, _ in told) == 2
