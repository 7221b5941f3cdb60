"""What the tables list by several words is read as that food, and not as another one in a state."""

from __future__ import annotations

import pytest
from demo_foon import demo_foon

from foon_kg.food import tables
from foon_kg.planning.recipes import IngredientWords
from foon_kg.plans.kitchen import Kitchen

BULBS = ("head of garlic",)  # asked so, it is garlic, of which cloves are taken
WORDS = IngredientWords(demo_foon().vocabulary(), Kitchen.default())


def test_every_listed_name_is_its_own_food_unless_it_is_a_food_in_a_state():
    foods, others = tables().foods, []
    for name in sorted(foods.kind_of):
        wanted, _ = WORDS.read(name)
        before = name.removesuffix(wanted.object).split()
        states = all(word in WORDS.states or word in tables().states for word in before)
        same = foods.food(wanted.object).kind == foods.food(name).kind or name in BULBS
        if not same and not (states and foods.is_listed(wanted.object)):
            others.append((name, wanted.object, wanted.state))
    assert others == []


@pytest.mark.parametrize(
    ("text", "food"),
    [
        ("almond milk", "almond milk"),
        ("2 cups of coconut milk", "coconut milk"),
        ("chopped garlic chives", "garlic chives"),
        ("vanilla ice cream", "vanilla ice cream"),
        ("finely chopped onion", "onion"),
        ("sliced cucumber", "cucumber"),
    ],
)
def test_a_food_of_two_words_is_no_state_of_the_second(text, food):
    assert WORDS.read(text)[0].object == food
