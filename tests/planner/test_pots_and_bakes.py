"""What titles of pasta, noodles, rice, potatoes, soups and casseroles ask for, where no video shows it."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def test_dough_of_dumplings_in_soup_has_all_its_foods(steps):
    told = steps("soup", "Chicken Drop Dumpling Soup", "chicken thighs:raw", "chicken broth:liquid", "onion:chopped",
                 "flour:powder", "baking powder:powder", "milk:liquid")  # fmt: skip
    assert inside(told, "mix") == {"flour", "baking powder", "milk"}


def test_shrimp_are_fried_before_the_sauce_that_was_stirred_beside_them(steps):
    told = steps("stir-fry", "Shrimp and Asparagus Stir-Fry", "shrimp:peeled", "asparagus:cut", "oyster sauce:liquid",
                 "soy sauce:liquid", "garlic:minced", "oil:liquid")  # fmt: skip
    assert first(told, "shrimp", "cook and stir") < first(told, "mixture", "cook and stir")


def test_pasta_of_the_oven_is_baked_and_a_noodle_cake_fried(steps):
    told = steps("pasta", "Sausage Rigatoni al Forno", "rigatoni:uncooked", "Italian sausage:raw",
                 "tomatoes:canned", "mozzarella:shredded")  # fmt: skip
    assert "bake" in motions(told)
    told = steps("noodle", "Crispy Noodle Cake with Beef", "egg noodles:uncooked", "oil:liquid", "flank steak:sliced",
                 "soy sauce:liquid", "cornstarch:powder")  # fmt: skip
    assert first(told, "egg noodles", "boil") < first(told, "egg noodles", "cook")


def test_bread_for_croutons_is_toasted(steps):
    told = steps("soup", "Cream of Celery Soup with Croutons", "celery:chopped", "onion:chopped", "butter:unmelted",
                 "vegetable stock:liquid", "cream:creamy", "bread:cubed")  # fmt: skip
    assert inside(told, "bake") == {"bread"}
