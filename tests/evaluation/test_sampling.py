"""Which recipes are asked: enough goals, and samples that a seed draws again."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from foon_kg.evaluation.sampling import drawn, known_enough, left_out, sampled
from foon_kg.model import Goal, ObjectNode, Recipe

GOALS = [
    Goal(ObjectNode(f"{dish} {n}"), dish, (), ()) for dish, many in (("salad", 3), ("pie", 2)) for n in range(many)
]
names = st.lists(st.text("abc", min_size=1), unique=True, max_size=12)


def test_dish_types_with_fewer_than_three_goals_are_left_out_and_named():
    assert known_enough(GOALS) == {"salad": 3}
    out = left_out(["salad", "pie", "pie", "soup"], GOALS)
    assert [(dish.dish_type, dish.goals, dish.asked) for dish in out] == [("pie", 2, 2), ("soup", 0, 1)]


@given(names, st.integers(1, 12), st.integers(0, 3), st.randoms())
def test_a_seed_draws_the_same_whatever_the_order(names, count, seed, shuffle):
    found = drawn(names, count, seed, "salad")
    again = list(names)
    shuffle.shuffle(again)
    assert found == drawn(again, count, seed, "salad")
    assert len(found) == min(count, len(names))
    assert set(found) <= set(names)


def test_another_seed_draws_others():
    many = [str(number) for number in range(50)]
    assert len({drawn(many, 5, seed, "salad") for seed in range(5)}) == 5


def test_every_dish_type_draws_for_itself():
    salads, soups = ([Recipe(dish, (), f"{n}") for n in range(9)] for dish in ("salad", "soup"))
    alone = sampled(salads, 4, 1)
    both = sampled([*soups, *salads], 4, 1)
    assert [recipe for recipe in both if recipe.dish_type == "salad"] == alone
    assert len(both) == 8
