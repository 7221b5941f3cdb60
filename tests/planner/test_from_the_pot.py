"""Noodles, sauces and soups of the public FOON, step by step."""

from __future__ import annotations

import pytest
from planner.public_foon import answers_to

from foon_kg.food import tables
from foon_kg.model import Recipe, RequiredIngredient

pytestmark = [pytest.mark.shared_data, pytest.mark.slow]

KNOWN = tables()


def steps(dish_type, title, **foods):
    """Return the motion of every step of a tree with the labels of what goes in."""
    asked = tuple(RequiredIngredient(food.replace("_", " "), state) for food, state in foods.items())
    (answer,) = answers_to([Recipe(dish_type, asked, "x", title)])
    return [(unit.motion, {node.label for node in unit.input_nodes}) for unit in answer.units]


def places(done, *foods, does=None):
    """Return the numbers of the steps with all these foods, which do one of these things."""
    return [
        number for number, (motion, there) in enumerate(done)
        if there.issuperset(foods) and (does is None or KNOWN.motion(motion).does & does)
    ]  # fmt: skip


def test_water_boils_before_pasta_comes_and_that_is_boiled_when_its_sauce_is_ready():
    done = steps(
        "pasta", "Spaghetti Bolognese", spaghetti="uncooked", ground_beef="raw", onion="chopped",
        canned_tomato="canned", olive_oil="liquid",
    )  # fmt: skip
    boils, comes = [motion for motion, *_ in done].index("boil"), places(done, "spaghetti")[0]
    last = places(done[:comes], "canned tomato", does={"heat"})[-1]
    assert boils < last < comes  # the sauce does not wait until water boils
    assert not done[boils][1] & {"spaghetti", "canned tomato"}


def test_water_is_hot_when_a_pan_that_only_fries_is_ready_and_that_keeps_its_burner():
    done = steps(
        "pasta", "Orecchiette with Broccoli", orecchiette="uncooked", broccoli="florets", garlic="sliced",
        olive_oil="liquid", pecorino="grated",
    )  # fmt: skip
    boils, comes = [motion for motion, *_ in done].index("boil"), places(done, "orecchiette")[0]
    assert boils < places(done, "broccoli", does={"heat"})[0]
    assert "remove" not in {motion for motion, _ in done[boils:comes]}
    assert places(done, "orecchiette", does={"heat"})


def test_what_is_done_in_a_moment_is_cooked_once_and_a_sausage_browns_before_the_onion():
    mussels = steps("seafood", "Mussels", mussels="whole", shallot="minced", white_wine="liquid", butter="solid",
                    cream="liquid")  # fmt: skip
    assert len(places(mussels, "mussels", does={"heat"})) <= 1
    rice = steps("rice", "Dirty Rice", sausage="raw", chicken_livers="chopped", onion="chopped", rice="uncooked",
                 chicken_broth="liquid")  # fmt: skip
    assert places(rice, "sausage", does={"heat"})[0] < places(rice, "chicken livers", does={"heat"})[0]


def test_tofu_browns_in_the_pan_before_what_gets_it_wet():
    done = steps("stir-fry", "Tofu Stir-Fry", tofu="cubed", broccoli="florets", garlic="minced", oil="liquid",
                 soy_sauce="liquid")  # fmt: skip
    assert places(done, "tofu", does={"heat"})[0] < places(done, "broccoli", does={"heat"})[0]


def test_nuts_stay_crisp_and_beans_are_boiled():
    rice = steps("rice", "Wild Rice with Pecans", wild_rice="uncooked", pecans="halved", onion="chopped",
                 vegetable_broth="liquid", butter="melted")  # fmt: skip
    assert places(rice, "wild rice", does={"heat"})[0] < places(rice, "pecans")[-1]
    roll = steps("sandwich", "Chacarero", rolls="split", steak="sliced", green_beans="cooked", oil="liquid",
                 tomato="sliced")  # fmt: skip
    assert not {"oil"} & roll[places(roll, "green beans", does={"heat"})[0]][1]


def test_whipped_cream_waits_until_what_it_lies_on_is_cool():
    done = steps(
        "pudding", "Persimmon Pudding", persimmon_pulp="whole", sugar="granulated", eggs="beaten", buttermilk="liquid",
        baking_soda="powder", flour="powder", baking_powder="powder", cinnamon="ground", salt="granulated",
        butter="melted", whipped_cream="creamy",
    )  # fmt: skip
    motions = [motion for motion, _ in done]
    assert motions.index("bake") < motions.index("cool down") < places(done, "whipped cream")[0]


def test_water_is_not_hot_before_what_cools_and_so_waits_for_nothing():
    done = steps(
        "salad", "", quinoa="grain", chicken="chopped", apple="halved", lemon="juice", olive_oil="liquid",
        salt="ground",
    )  # fmt: skip
    motions = [motion for motion, *_ in done]
    assert motions.index("cool down") < motions.index("boil")


def test_what_lies_on_noodles_comes_when_nothing_is_cooked_any_more():
    done = steps(
        "noodle", "Noodles", noodle="uncooked", chicken_breast="sliced", oil="liquid", peanut="chopped",
        lime="wedges", green_onion="sliced",
    )  # fmt: skip
    hot = places(done, does={"heat"})
    assert not any({"peanut", "lime", "green onion"} & done[number][1] for number in hot)
    assert all(places(done, food)[-1] > hot[-1] for food in ("peanut", "lime", "green onion"))


def test_a_soup_is_blended_when_it_is_soft_and_one_with_pieces_is_not():
    squash = steps(
        "soup", "Squash Soup", butternut_squash="cubed", onion="chopped", vegetable_broth="liquid",
        butter="stick",
    )  # fmt: skip
    assert places(squash, does={"heat"})[-1] < places(squash, does={"blend"})[0]
    pasta = steps(
        "soup", "Minestrone", canned_tomato="canned", onion="chopped", vegetable_broth="liquid", ditalini="",
    )  # fmt: skip
    assert not places(pasta, does={"blend"})


def test_a_cold_soup_is_not_heated():
    done = steps("soup", "Gazpacho", tomato="chopped", cucumber="chopped", olive_oil="liquid", tomato_juice="liquid")
    assert places(done, does={"blend"})
    assert not places(done, does={"heat"})


def test_a_stew_is_cooked_in_one_pot_whatever_a_like_dish_does():
    done = steps(
        "beef", "Beef Stew", beef="cubed", onion="chopped", potato="cubed", beef_broth="liquid",
        flour="powder", oil="liquid",
    )  # fmt: skip
    assert not places(done, does={"shape"})
    first = [places(done, food, does={"heat"})[0] for food in ("beef", "flour", "beef broth")]
    assert first == sorted(set(first))


def test_flour_is_stirred_into_the_fat_before_milk_comes_though_the_dish_is_baked():
    done = steps(
        "potatoes", "Scalloped Potatoes", potato="sliced", butter="stick", flour="powder", milk="liquid",
        cheddar_cheese="shredded",
    )  # fmt: skip
    first = [places(done, food, does={"heat"})[0] for food in ("flour", "milk", "cheddar cheese")]
    assert first == sorted(set(first))


def test_meat_in_pieces_is_cooked_in_its_sauce_though_the_likest_dish_bakes():
    done = steps(
        "chicken", "Butter Chicken", chicken_thigh="cubed", onion="chopped", tomato_puree="sauce",
        heavy_cream="liquid", butter="stick", garam_masala="ground",
    )  # fmt: skip
    assert not places(done, does={"dry"})


def test_no_machine_makes_a_part_by_which_nobody_calls_the_dish():
    done = steps(
        "pasta", "Linguine with Clams", linguine="uncooked", clam="raw", garlic="sliced", olive_oil="liquid",
        parsley="chopped", lemon="juice",
    )  # fmt: skip
    assert not places(done, does={"blend"})


POTS = {"pot", "cooking pan", "saucepan", "wok"}
NOODLES = {"noodle": "uncooked", "beef": "sliced", "onion": "chopped", "soy_sauce": "liquid", "water": "liquid"}


def plan_of(dish_type, **foods):
    asked = tuple(RequiredIngredient(food.replace("_", " "), state) for food, state in foods.items())
    (answer,) = answers_to([Recipe(dish_type, asked, "x", None)])
    return answer.units


def test_nothing_is_called_noodle_before_noodles_are_in_it_and_they_are_stirred_in():
    units = plan_of("noodle", oil="liquid", broccoli="chopped", cream="liquid", **NOODLES)
    called = [node for unit in units for node in unit.output_nodes if node.label == "noodle" and node.ingredients]
    assert called
    assert all("noodle" in node.ingredients for node in called)
    last = max(number for number, unit in enumerate(units) if "strainer" in {n.label for n in unit.input_nodes})
    assert "mix" in KNOWN.motion(units[last + 1].motion).does


def test_no_second_vessel_comes_onto_the_stove_beside_one_that_is_done():
    rice = {"rice": "cooked", "oil": "liquid", "egg": "whipped", "parsnip": "diced", "garlic": "minced"}
    for units in (
        plan_of("rice", **rice),
        plan_of("noodle", oil="liquid", cream="liquid", **NOODLES),
    ):
        there: set[int | None] = set()
        for unit in units:
            there -= {one.thing for one in unit.outputs if one.node.container != "stove"}
            there |= {one.thing for one in unit.outputs if one.node.container == "stove" and one.node.label in POTS}
            assert len(there) <= 1
        assert any("stove" in {node.label for node in unit.output_nodes} for unit in units)


def test_rice_beside_what_is_no_dish_of_rice_is_not_stirred_into_it():
    foods = {"beef": "sliced", "broccoli": "floret", "soy_sauce": "liquid", "oil": "liquid", "rice": "steamed"}
    units = plan_of("stir-fry", **foods)
    last = max(number for number, unit in enumerate(units) if "rice" in {n.label for n in unit.input_nodes})
    assert not any("mix" in KNOWN.motion(unit.motion).does for unit in units[last:])
