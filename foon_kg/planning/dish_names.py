"""What names of dishes decide: whether a type is known, what a tree may be called, what a title asks for."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from foon_kg.food import Tables, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import Food
from foon_kg.food.techniques import Technique
from foon_kg.goals.asked import Asked
from foon_kg.goals.choice import Fit, has_mostly_its_foods, is_truly, unmet_needs
from foon_kg.goals.score import missing_core, unexplained
from foon_kg.integration.joining.course import Plan
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.unheeded import Core
from foon_kg.model import DISH_TYPES, Recipe, RequiredIngredient
from foon_kg.model.errors import UsageError
from foon_kg.world.becoming import meets

_CLOSE = 0.7
"""From how much likeness on (0 to 1, of letters) a dish type may have been meant by a word that is none."""


UNSAID = "whole"
"""The state that a food is read in where nothing is said of it and nothing known of the food."""


def refuse_unknown_type(dish_type: str) -> None:
    """Raise UsageError for a dish type that is none, with those that may have been meant."""
    if not dish_type or dish_type in DISH_TYPES:
        return
    close = difflib.get_close_matches(dish_type, DISH_TYPES, n=3, cutoff=_CLOSE)
    hint = f"Did you mean {' or '.join(close)}?" if close else f"Name one of: {', '.join(DISH_TYPES)}."
    raise UsageError(f"“{dish_type}” is no dish type", hint=hint, code="unknown-dish-type")


def has_its_name(fit: Fit, asked: Asked, dish_type: str, tin: str, technique: Technique | None) -> bool:
    """Return whether what is made after a recorded dish (``fit``) may be called as that is; else by its ``dish_type``.

    ``asked`` is the recipe in words, ``tin`` what it is baked in and ``technique`` how it is made, where that is told.
    """
    frame = fit.frame
    is_no = any(dish_type in dish.is_no for dish in asked.dishes)  # a crepe is no cake
    if not is_no and not _is_such_a_dish(fit, asked, dish_type, tin):
        return False
    if technique is None:
        return True
    # a technique makes what the title says, and not what the video makes
    return frame.dish_type == dish_type and set(words(frame.goal.label)) <= set(asked.title_words)


def _is_such_a_dish(fit: Fit, asked: Asked, dish_type: str, tin: str) -> bool:
    """Whether a recorded dish is of the asked type, with its core, in its tin, and explains what the title says.

    Without a title a word of its name that no food explains (greek) is true where all of its foods are there, and
    nothing has its name that is made of other foods for the greater part.
    """
    if fit.frame.dish_type != dish_type or missing_core(fit.dish, asked) or not is_truly(fit):
        return False
    if not asked.title and not has_mostly_its_foods(fit):
        return False
    if unexplained(fit.dish, asked) and (asked.title or not is_truly(fit, 1.0)):
        return False
    return all(dish.tin in {"", tin} for dish in asked.known.dishes_named(fit.frame.goal.label))


def eased(asked: Asked) -> frozenset[str]:
    """Return the kinds of food that dishes of the names in ``asked`` do not treat as others do, or leave raw."""
    kinds = {kind for dish in asked.of_type for kind in dish.eases}
    return frozenset(kinds.union(kind for dish in asked.dishes for kind in dish.raw))


def closing(told: Collection[str], joins: Sequence[Join]) -> str:
    """Return by which motion thin bread is closed around what lies on it, of ``joins``; ``""`` for none.

    ``told`` are the words of the dish's title.
    """
    flat = sum(join.want.facts.is_any(word_list("can be rolled")) for join in joins) == 1
    ways = ("is rolled up", "is folded over")
    return next((min(word_list(f"{way} by")) for way in ways if flat and says(told, way)), "")


def made_as(dish_type: str, title: str, known: Tables) -> str:
    """Return as a dish of which type one of a ``dish_type`` is made: what its ``title`` calls a salad is one.

    Only types that the tables of ``known`` have are read out of a title; what is laid on bread stays that.
    """
    if any(dish.stacked for dish in known.dishes_named(dish_type)):
        return dish_type
    dressed = (dish.name.split()[-1] for dish in known.dishes_named("", title) if dish.dressed)
    return next((name for name in dressed if name in DISH_TYPES), dish_type)


def with_core(recipe: Recipe, known: Tables) -> tuple[Recipe, Core | None]:
    """Return a ``recipe`` with its core understood, and what that was taken for; else as it is, and ``None``.

    Where its foods, as the tables ``known`` have them, lack what its dish cannot be without, the first of those of
    which nothing is known is that: it is called so, too. What is only for serving is none.
    """
    foods = [known.foods.food(one.object, [one.state]) for one in recipe.ingredients]
    unknown = [place for place, one in enumerate(recipe.ingredients) if _may_be_core(one, foods[place], known)]
    core = _core(recipe, foods, known) if unknown else None
    if core is None:
        return recipe, None
    food, dish = core
    own = recipe.ingredients[unknown[0]]
    told = Core(own.object, food.name, dish, len(unknown))
    state = food.sold_as if own.state == UNSAID and food.sold_as else own.state
    listed = list(recipe.ingredients)
    listed[unknown[0]] = replace(own, object=told.label, state=state)
    return replace(recipe, ingredients=tuple(listed)), told


def _core(recipe: Recipe, foods: Sequence[Food], known: Tables) -> tuple[Food, str] | None:
    """Return the food that would do for all that the dish of a recipe of ``foods`` lacks, and the dish's name.

    None does where one of the foods is of its kind: a dish of pork lacks pork where there is lamb, and no other meat.
    """
    dish_type = made_as(recipe.dish_type, recipe.title or "", known)
    unmet = unmet_needs(foods, dish_type, recipe.title or "", known)
    food = known.foods.food(known.cores.get(dish_type, ""))
    there = any(one.known and one.is_of(food.kind) for one in foods)
    does = unmet and not there and all(_is_one_of(needs, food, known) for _, needs in unmet)
    return (food, unmet[0][0]) if does else None


def _is_one_of(needs: Iterable[str], food: Food, known: Tables) -> bool:
    """Whether a ``food`` is what one of ``needs`` says."""
    return any(meets(need, food, known) for need in needs)


def _may_be_core(one: RequiredIngredient, food: Food, known: Tables) -> bool:
    """Whether a required food of which the tables say nothing may be what its dish is made of."""
    is_food = bool(one.object) and known.utensil(one.object) is None
    return is_food and not food.known and not says([one.part], "is for what is done")


def as_told(plan: Plan, asked: Asked, tin: str) -> Plan:
    """Return a ``plan`` with what the words of type and title of what is ``asked`` say of the whole dish.

    ``tin`` is what its batter or dough is baked in.
    """
    told = frozenset((*asked.type_words, *asked.title_words))
    return replace(
        plan,
        tin=_tin(told, tin),
        stacked=asked.stacked,
        cold=_is_one(told, "is served cold"),
        flat=_is_one(told, "is rolled out"),
        grilled=asked.stacked and asked.grilled,
        in_pieces=asked.dressed,
        laid=asked.laid,
        spooned=_is_one(told, "boils in the dish"),
        closed_by=closing(told, plan.joins),
        portioned=_is_one(told, "is portioned"),
    )


def _tin(told: Collection[str], tin: str) -> str:
    """Return in what a dish is baked whose ``tin`` may be that of one piece, while its title says that it is many."""
    portions = _is_one(told, "is portioned") and tin in word_list("holds it in one piece")
    return min(word_list("holds portions")) if portions else tin


def _is_one(told: Collection[str], name: str) -> bool:
    """Whether one of the words of a title stands in the list of a name."""
    return says(told, name)
