"""Plans of the demo's recipes, made once for all tests of pictures."""

from __future__ import annotations

import functools

from demo_foon import demo_foon

from foon_kg.foon.demo import demo_recipes
from foon_kg.planning.planner import plan
from foon_kg.planning.recipes import IngredientWords, read_recipe
from foon_kg.plans.kitchen import Kitchen


@functools.cache
def demo_plan(name):
    """The plan of the demo's recipe ``name``."""
    path = next(path for path in demo_recipes() if path.stem == name)
    words = IngredientWords(demo_foon().vocabulary(), Kitchen.default())
    with demo_foon().reading() as view:
        return plan(view, read_recipe(path, words).recipe)


def demo_recipe_names():
    """The recipes that have a plan: none has that heats, as the demo's videos turn no stove off."""
    return sorted(path.stem for path in demo_recipes() if not path.stem.endswith(("omelette", "soup")))
