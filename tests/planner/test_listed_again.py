"""A food that a recipe lists a second time, once all of the dough or batter is named, begins another part of it."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

BATTER = (
    "flour:powder", "baking soda:powder", "sugar:granulated", "egg:uncooked", "milk:liquid", "butter:softened",
)  # fmt: skip


def test_butter_and_sugar_that_come_again_after_the_batter_are_a_frosting(steps):
    told = steps("cake", "", *BATTER, "butter:creamy", "cocoa:powder", "sugar:ground", "vanilla:liquid")
    (made,) = [place for place, (_, one, out) in enumerate(told) if one == "blend" and "cocoa" in out[0].ingredients]
    assert set(told[made][2][0].ingredients) == {"butter", "cocoa", "sugar", "vanilla"}
    assert {"cocoa", "vanilla"}.isdisjoint(inside(told, "bake"))
    assert first(told, "mixture", "spread") > motions(told).index("cool down")


def test_sugar_with_a_liquid_that_comes_again_is_a_glaze(steps):
    told = steps("cake", "", *BATTER, "sugar:ground", "lemon juice:juice")
    assert inside(told, "stir") == {"sugar", "lemon juice"}
    assert "lemon juice" not in inside(told, "bake")


def test_what_comes_again_before_the_last_of_the_batter_is_in_the_batter(steps):
    told = steps("cake", "", "sugar:granulated", "butter:softened", "sugar:ground", *BATTER[:2], *BATTER[3:5])
    assert inside(told, "bake") == {"flour", "baking soda", "sugar", "egg", "milk", "butter"}
    assert motions(told).index("bake") > max(place for place, (foods, _, _) in enumerate(told) if "sugar" in foods)


def test_fruit_and_sugar_after_a_dough_that_rises_are_laid_on_it(steps):
    told = steps(
        "cake", "", "milk:liquid", "sugar:ground", "butter:creamy", "yeast:powder", "egg:uncooked", "flour:powder",
        "apple:sliced", "sugar:ground", "cinnamon:ground",
    )  # fmt: skip
    assert {"apple", "cinnamon"}.isdisjoint(inside(told, "knead"))
    assert motions(told).index("knead") < first(told, "apple", "pick-and-place") < motions(told).index("bake")


def test_butter_and_sugar_after_bread_and_custard_are_a_sauce_for_it(steps):
    told = steps(
        "bread", "", "bread:whole", "milk:liquid", "egg:uncooked", "sugar:ground", "butter:creamy", "butter:creamy",
        "sugar:ground", "water:liquid", "whisky:liquid",
    )  # fmt: skip
    assert "whisky" not in inside(told, "bake")
    assert {"butter", "sugar", "whisky"} <= inside(told, "cook and stir")


def test_a_frosting_is_beaten_when_the_cake_is_cold_and_what_is_listed_behind_it_lies_on_it(steps):
    frosting = ("cream cheese:softened", "sugar:ground", "vanilla:liquid", "strawberry:berries")
    told = steps("cake", "", *BATTER, *frosting)
    (made,) = [place for place, (_, one, out) in enumerate(told) if one == "blend" and "vanilla" in out[0].ingredients]
    assert motions(told).index("cool down") < made < first(told, "mixture", "spread")
    assert first(told, "strawberry", "pour") > first(told, "mixture", "spread")


def test_butter_and_milk_beside_fine_sugar_are_its_frosting_where_the_batter_has_fat_of_its_own(steps):
    batter = ("flour:powder", "baking soda:powder", "sugar:granulated", "egg:uncooked", "water:liquid", "oil:liquid")
    told = steps("cake", "", *batter, "butter:softened", "powdered sugar:powder", "milk:liquid")
    assert {"butter", "powdered sugar", "milk"}.isdisjoint(inside(told, "bake"))
    mixed = [set(out[0].ingredients) for _, one, out in told if one in {"mix", "stir", "beat", "blend", "whisk"}]
    assert {"butter", "powdered sugar", "milk"} in mixed


def test_icing_of_brown_sugar_butter_and_milk_is_cooked(steps):
    told = steps("cake", "", *BATTER, "brown sugar:ground", "milk:liquid", "butter:creamy")
    assert inside(told, "cook and stir") == {"brown sugar", "milk", "butter"}


def test_flour_sugar_and_fat_before_the_flour_of_the_batter_are_crumbs_that_are_baked_on_it(steps):
    crumbs = ("flour:powder", "cinnamon:ground", "sugar:ground", "margarine:softened")
    told = steps("cake", "", *crumbs, *BATTER[:5], "oil:liquid")
    (made,) = [place for place, (foods, one, _) in enumerate(told) if one == "mix" and "margarine" in foods]
    assert {"flour", "cinnamon", "sugar", "margarine"} <= told[made][0]
    assert made < motions(told).index("bake")
    assert {"cinnamon", "margarine"}.isdisjoint(inside(told, "blend"))


def test_two_kinds_of_a_food_in_a_row_are_no_second_part(steps):
    told = steps("cake", "", "flour:powder", "flour:whole", *BATTER[1:])
    assert "flour" in inside(told, "bake")
    assert motions(told).count("bake") == 1
    assert not any(one == "mix" and "butter" in foods and "flour" in foods for foods, one, _ in told)
