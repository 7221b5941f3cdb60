"""What a list without headings names one after another is made as if a heading stood above it, and that is told."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

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


STEW = ("oil:liquid", "beef:cubed", "onion:chopped", "carrot:sliced", "beef stock:liquid")


@pytest.mark.parametrize("part", [":dumplings", ""])
def test_dumplings_are_shaped_and_simmer_in_the_stew_once_all_else_was_cooked(steps, part):
    foods = ("self-raising flour:powder", "suet:shredded", "parsley:chopped", "water:cold")
    told = steps("beef", "Stew", *STEW, *(f"{food}{part}" for food in foods))
    assert inside(told, "mix") == {"self-raising flour", "suet", "parsley", "water"}
    done = motions(told)
    simmers = [place for place, motion in enumerate(done) if motion == "simmer"]
    assert done.index("shape") < simmers[0] < first(told, "dumplings", "pick-and-place") < simmers[-1]


def test_dumplings_lie_on_a_casserole_when_it_is_baked(steps):
    told = steps(
        "casserole", "Beef casserole", *STEW,
        "flour:powder:dumplings", "suet:shredded:dumplings", "water:cold:dumplings",
    )  # fmt: skip
    done = motions(told)
    assert done.index("shape") < first(told, "dumplings", "pick-and-place") < done.index("bake")
    assert [motion for foods, motion, _ in told if "suet" in foods] == ["scoop", "mix"]  # the tin is greased with oil


def test_dumplings_come_into_a_soup_that_was_blended(steps):
    told = steps(
        "soup", "Tomato soup", "oil:liquid", "onion:chopped", "tomato:canned", "stock:liquid",
        "flour:powder:dumplings", "butter:softened:dumplings", "milk:liquid:dumplings",
    )  # fmt: skip
    done = motions(told)
    assert done.index("blend") < first(told, "dumplings", "pick-and-place") < len(done) - done[::-1].index("simmer")


def test_salt_and_oil_of_what_lies_on_a_dough_come_on_it_and_not_into_the_dough(steps):
    told = steps(
        "pizza", "Onion pizza", "flour:powder:dough", "yeast:dried:dough", "water:liquid:dough",
        "salt:granulated:dough", "onion:sliced:topping", "tomato:diced:topping", "paprika:ground:topping",
        "sea salt:granulated:topping", "olive oil:liquid:topping",
    )  # fmt: skip
    assert {"paprika", "sea salt", "olive oil"}.isdisjoint(inside(told, "knead"))
    done = motions(told)
    assert done.index("knead") < first(told, "paprika", "sprinkle") < done.index("bake")


def test_fruit_that_is_named_first_with_sugar_lies_under_the_sponge(steps):
    told = steps(
        "pudding", "Eve's pudding", "apple:sliced", "demerara sugar:granulated", "lemon:zest", "water:liquid",
        "butter:softened", "caster sugar:granulated", "egg:beaten", "self-raising flour:powder",
    )  # fmt: skip
    assert inside(told, "mix") == {"apple", "demerara sugar", "lemon", "water"}
    assert {"demerara sugar", "water"}.isdisjoint(inside(told, "fold"))
    assert inside(told, "blend") == {"butter", "caster sugar"}


def test_an_egg_that_is_named_again_at_the_end_of_a_dough_is_brushed_on_under_its_seeds(steps):
    told = steps(
        "bread", "", "water:liquid", "yeast:dried", "sugar:granulated", "oil:liquid", "egg:uncooked", "flour:powder",
        "egg:beaten", "seed:seed",
    )  # fmt: skip
    assert motions(told).index("brush") < first(told, "seed", "pour") < motions(told).index("bake")


def test_soda_that_is_named_behind_raw_flesh_is_mixed_with_that_and_not_with_the_sauce(steps):
    told = steps(
        "stir-fry", "Chop suey", "chicken breast:sliced", "baking soda:powder", "oil:liquid", "onion:sliced",
        "soy sauce:liquid:sauce", "cornflour:powder:sauce", "chicken stock:liquid:sauce",
    )  # fmt: skip
    made = [{*out.ingredients} for _, motion, outputs in told if motion in {"mix", "stir"} for out in outputs]
    assert {"baking soda", "chicken breast"} in made
    assert first(told, "baking soda", "pour") < motions(told).index("cook and stir")
