"""Breads, cakes and cookies whose name says how they are put together: rolled up, filled, chilled, raised by whites."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def test_a_swirl_is_rolled_up_in_the_dough_of_a_loaf(steps):
    told = steps("bread", "Chocolate Swirl Loaf", "bread flour:powder", "yeast:powder", "milk:warm", "butter:softened",
                 "sugar:granulated", "chocolate spread:creamy", "egg:beaten")  # fmt: skip
    assert "chocolate spread" not in inside(told, "knead")
    assert motions(told).index("ferment") < first(told, "chocolate spread", "scoop") < motions(told).index("bake")


def test_a_filling_that_is_listed_under_its_heading_is_closed_in_risen_dough(steps):
    filling = ("desiccated coconut:flakes:filling", "brown sugar:granulated:filling")
    told = steps("bread", "Pan de Coco", "bread flour:powder", "yeast:powder", "coconut milk:liquid", *filling)
    assert "desiccated coconut" not in inside(told, "knead")
    assert motions(told).index("fold and pinch") < motions(told).index("bake")


def test_meal_of_a_spoon_bread_is_boiled_and_raised_by_whites(steps):
    told = steps("bread", "Spoon Bread", "cornmeal:ground", "milk:liquid", "eggs:separated", "baking powder:powder")
    assert first(told, "cornmeal", "pour") < motions(told).index("cook and stir") < motions(told).index("fold")
    assert "egg whites" not in inside(told, "cook and stir")


def test_whites_of_an_angel_cake_are_beaten_before_flour_and_fruit_lies_beside(steps):
    told = steps("cake", "Angel Food Cake with Strawberries", "egg whites:uncooked", "cream of tartar:powder",
                 "sugar:granulated", "cake flour:powder", "strawberries:sliced")  # fmt: skip
    assert inside(told, "whisk") == {"egg whites", "cream of tartar"}
    assert inside(told, "fold") == {"egg whites", "cream of tartar", "sugar", "cake flour"}
    assert "strawberries" not in inside(told, "bake")


def test_cream_is_spread_on_a_cake_before_that_is_rolled_up(steps):
    told = steps("cake", "Chocolate Cream Roll", "eggs:uncooked", "sugar:granulated", "cake flour:powder",
                 "cocoa:powder", "powdered sugar:powder", "heavy cream:creamy")  # fmt: skip
    assert first(told, "heavy cream", "beat") < motions(told).index("roll")


def test_dough_from_the_icebox_is_shaped_chilled_and_cut_before_it_is_baked(steps):
    told = steps("cookie", "Icebox Cookies", "butter:softened", "brown sugar:granulated", "eggs:uncooked",
                 "flour:powder", "baking soda:powder")  # fmt: skip
    order = [motions(told).index(one) for one in ("shape", "chill", "cut", "bake")]
    assert order == sorted(order)


def test_small_shells_hold_a_filling_that_is_not_mixed_into_their_dough(steps):
    told = steps("cookie", "Pecan Tassies", "cream cheese:softened", "butter:softened", "flour:powder",
                 "egg:uncooked", "brown sugar:granulated", "pecans:chopped")  # fmt: skip
    assert inside(told, "knead") == {"cream cheese", "butter", "flour"}
    assert inside(told, "whisk") >= {"egg", "brown sugar", "pecans"}


def test_a_chocolate_is_pressed_whole_on_a_cookie_that_is_called_a_blossom(steps):
    told = steps("cookie", "Peanut Blossoms", "butter:softened", "peanut butter:creamy", "sugar:granulated",
                 "egg:uncooked", "flour:powder", "chocolate kisses:bar")  # fmt: skip
    assert "chocolate kisses" not in inside(told, "bake")
    assert "chop" not in motions(told)


def test_a_filling_lies_between_two_sheets_of_what_is_cut_to_slices(steps):
    filling = ("walnuts:ground:filling", "sugar:granulated:filling", "milk:liquid:filling")
    told = steps("cookie", "Nut Slices", "flour:powder", "butter:unmelted", "egg yolks:uncooked", *filling)
    assert motions(told).count("roll") == 2
    assert inside(told, "cook and stir") == {"walnuts", "sugar", "milk"}


def test_jam_is_baked_inside_what_is_filled_with_it(steps):
    told = steps("muffin", "Jam-Filled Doughnut Muffins", "flour:powder", "sugar:granulated", "baking powder:powder",
                 "oil:liquid", "egg:uncooked", "milk:liquid", "strawberry jam:jelly")  # fmt: skip
    assert first(told, "strawberry jam", "scoop") < motions(told).index("bake")
    assert "strawberry jam" not in inside(told, "fold")


def test_fruit_lies_under_the_batter_of_upside_down_muffins(steps):
    told = steps("muffin", "Pineapple Upside-Down Muffins", "butter:melted", "brown sugar:granulated",
                 "pineapple:canned", "flour:powder", "sugar:granulated", "baking powder:powder", "egg:uncooked",
                 "milk:liquid")  # fmt: skip
    assert {"pineapple", "brown sugar"}.isdisjoint(inside(told, "fold"))
