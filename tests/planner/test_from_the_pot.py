"""Noodles, sauces and soups of the public FOON, step by step."""

from __future__ import annotations

import pytest
from planner.public_foon import answers_to, public_snapshot

from foon_kg.food import tables
from foon_kg.model import Recipe, RequiredIngredient

pytestmark = [pytest.mark.shared_data, pytest.mark.slow]

KNOWN = tables()


@pytest.fixture(scope="module")
def snapshot():
    return public_snapshot()


def steps(snapshot, dish_type, title, **foods):
    """Return the motion of every step of a tree with the labels of what goes in."""
    asked = tuple(RequiredIngredient(food.replace("_", " "), state) for food, state in foods.items())
    (answer,) = answers_to([Recipe(dish_type, asked, "x", title)], snapshot)
    return [(unit.motion_node, {node.label for node in unit.input_nodes}) for unit in answer.units]


def places(done, *foods, does=None):
    """Return the numbers of the steps with all these foods, which do one of these things."""
    return [
        number for number, (motion, there) in enumerate(done)
        if there.issuperset(foods) and (does is None or KNOWN.motion(motion).does & does)
    ]  # fmt: skip


def test_water_boils_before_pasta_comes_and_that_is_boiled_when_its_sauce_is_ready(snapshot):
    done = steps(
        snapshot, "pasta", "Spaghetti Bolognese", spaghetti="uncooked", ground_beef="raw", onion="chopped",
        canned_tomato="canned", olive_oil="liquid",
    )  # fmt: skip
    assert done[places(done, "spaghetti")[0] - 1][0] == "boil"
    assert places(done, "canned tomato", does={"heat"})[0] < places(done, "spaghetti")[0]


def test_what_lies_on_noodles_comes_when_nothing_is_cooked_any_more(snapshot):
    done = steps(
        snapshot, "noodle", "Noodles", noodle="uncooked", chicken_breast="sliced", oil="liquid", peanut="chopped",
        lime="wedges", green_onion="sliced",
    )  # fmt: skip
    hot = places(done, does={"heat"})
    assert not any({"peanut", "lime", "green onion"} & done[number][1] for number in hot)
    assert all(places(done, food)[-1] > hot[-1] for food in ("peanut", "lime", "green onion"))
