"""What a list without headings names one after another is made as if a heading stood above it, and that is told."""

from __future__ import annotations

import pytest
from planner.told_steps import inside

pytestmark = pytest.mark.shared_data

PUDDING = (
    "dates:pitted", "baking soda:powder", "butter:softened", "brown sugar:granulated", "egg:uncooked",
    "self-raising flour:powder",
)  # fmt: skip


def test_sugar_that_comes_again_with_butter_and_cream_is_a_sauce_and_not_in_the_batter(steps):
    told = steps("pudding", "Date pudding", *PUDDING, "muscovado sugar:granulated", "butter:softened", "cream:liquid")
    assert "muscovado sugar" in inside(told, "cook and stir")
    assert "muscovado sugar" not in inside(told, "bake")


def test_salt_of_the_dough_comes_into_the_dough_and_not_into_the_filling(public_plans):
    plan = public_plans(
        "pie", "Butter tarts", "flour:powder", "salt:granulated", "lard:solid", "water:liquid",
        "brown sugar:granulated", "corn syrup:liquid", "butter:melted", "egg:uncooked", "raisins:dried",
    )  # fmt: skip
    mixed = [{*out.ingredients} for one in plan.units for out in one.output_nodes if one.motion in {"mix", "knead"}]
    assert not [foods for foods in mixed if {"flour", "butter"} <= foods]
    assert any({"flour", "salt"} <= foods for foods in mixed)
    told = [one.why for one in plan.assumptions]
    assert any("for the pastry" in one and "lard" in one for one in told)
    assert any("for the filling" in one and "brown sugar" in one for one in told)


def test_starch_that_comes_again_is_for_the_sauce_and_the_first_for_the_flesh(steps):
    told = steps(
        "stir-fry", "Beef with snow peas", "flank steak:sliced", "cornstarch:powder", "soy sauce:liquid",
        "snow peas:whole", "oil:liquid", "oyster sauce:liquid", "broth:liquid", "cornstarch:powder", "sugar:granulated",
    )  # fmt: skip
    assert inside(told, "mix") == {"cornstarch", "flank steak", "soy sauce"}
    assert {"oyster sauce", "broth", "cornstarch", "sugar"} <= inside(told, "stir")


def test_syrup_that_is_named_after_the_batter_is_cooked(steps):
    told = steps(
        "cake", "", "semolina:ground", "yogurt:creamy", "sugar:granulated", "baking powder:powder", "butter:melted",
        "sugar:granulated", "water:liquid", "lemon juice:juice",
    )  # fmt: skip
    assert {"sugar", "lemon juice"} <= inside(told, "cook and stir")
    assert "lemon juice" not in inside(told, "bake")
