"""What suggested dishes lack of utensils as they would be planned, which is more than their videos show.

Without it a suggestion would name a knife, and the plan of that dish from the same kitchen a whisk and a bowl as well.
"""

from __future__ import annotations

from dataclasses import replace

from foon_kg.food import singular
from foon_kg.integration.methods import TeachingView
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.planning.batch import Cook, Question
from foon_kg.planning.settings import PlanSettings
from foon_kg.planning.suggestion import Suggestion, Suggestions
from foon_kg.plans.shortage import ShortageError
from foon_kg.plans.stock import StockedKitchen


def as_planned(suggestions: Suggestions, view: TeachingView, kitchen: StockedKitchen) -> Suggestions:
    """Return ``suggestions``, each with the utensils that ``kitchen`` lacks for it as it is planned of ``view``.

    They are ordered anew by that. A dish that cannot be planned lacks what its reference tree does; nothing changes
    where nobody named utensils.
    """
    if kitchen.utensils_named is None:
        return suggestions
    told = (_with_utensils(one, view, kitchen) for one in suggestions.found)
    return replace(suggestions, found=tuple(sorted(told, key=lambda one: one.rank)))


def _with_utensils(one: Suggestion, view: TeachingView, kitchen: StockedKitchen) -> Suggestion:
    settings = PlanSettings(kitchen, after=one.goal.videos[0] if one.goal.videos else one.goal.node.label)
    error = Cook(view, settings).answer(Question(given=_recipe(one, kitchen))).error
    if error is not None and not isinstance(error, ShortageError):
        return one
    lacking = error.missing if isinstance(error, ShortageError) else ()
    foods = {name for name in one.missing if not kitchen.is_utensil(name)}
    utensils = {node.label for node in lacking if kitchen.is_utensil(node.label) and not kitchen.foods_in(node)}
    return replace(one, missing=tuple(sorted(foods | utensils)))


def _recipe(one: Suggestion, kitchen: StockedKitchen) -> Recipe:
    """Return the recipe of a dish with one's own foods for those that they stand for."""
    own = {singular(taken.food): taken.own for taken in one.taken}
    foods = [name for name in one.goal.ingredients if not kitchen.is_utensil(name) and not kitchen.is_free(name)]
    names = dict.fromkeys(own.get(singular(name), name) for name in foods)
    return Recipe(one.goal.dish_type, tuple(RequiredIngredient(name, "") for name in names))
