"""Several foods asked at once whether one of them is what a dish needs: the same as each asked by itself."""

from __future__ import annotations

import pytest

from foon_kg.food import tables
from foon_kg.world.becoming import Together, meets

FOODS = ("smoked salmon", "chopped tomato", "egg", "olive oil", "all-purpose flour", "cream cheese", "vegetable broth")


def needs() -> list[str]:
    dishes = tables().dishes.values()
    return sorted({need for dish in dishes for needs in dish.needs for need in needs})


@pytest.mark.parametrize("count", range(len(FOODS) + 1))
def test_one_of_them_is_what_is_needed_if_any_by_itself_is(count: int):
    foods = [tables().foods.food(name) for name in FOODS[:count]]
    together = Together(foods, tables())
    for need in needs():
        assert together.meet(need) == any(meets(need, food, tables()) for food in foods), need


def test_two_foods_do_not_share_the_words_of_a_name():
    foods = [tables().foods.food(name) for name in ("cream cheese", "tomato sauce")]
    assert Together(foods, tables()).meet("cream cheese")
    assert not Together(foods, tables()).meet("tomato cheese")
