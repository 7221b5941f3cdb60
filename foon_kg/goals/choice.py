"""Which frame a recipe is made after: vetoes first, then how natural its foods are there (algorithms 1 and 2)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from foon_kg.food import Tables, singular, words
from foon_kg.food.lists import word_list
from foon_kg.food.rows import Dish, Food
from foon_kg.goals.asked import SEASONS, Asked
from foon_kg.goals.names import BY_TITLE, BY_TYPE
from foon_kg.goals.recorded import Recorded, recorded
from foon_kg.goals.score import score
from foon_kg.goals.vetoes import vetoes
from foon_kg.integration.joining.layouts import Layout
from foon_kg.integration.joining.outlines import Mask, Outlines, Shares, Sought
from foon_kg.integration.joining.places import Matcher
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import Frame
from foon_kg.integration.teaching.operators import Likes
from foon_kg.model.values import made_often
from foon_kg.world.becoming import meets

_MOST_OF_ITS_FOODS = 0.6
"""Which share of the recorded foods a dish must have to be called like it."""

_MOST_SHOWN = 3
"""How many foods are named that would do; the tables have more, from the most usual to the least."""

MOST_FITTED = 16
"""How many frames are looked at closely: in each of them every food is given a place."""

_TYPE_COUNTS, _NAME_COUNTS = 0.5, 0.5
"""What it counts for the shortlist that a dish is of the asked type, and that it is called so.

Which share it has of the foods counts from 0 to 1."""


@made_often()
class Fit:
    """How well a frame suits a recipe: where its foods join, what speaks against it, and a score (greater is better).

    ``similarity`` is how alike the lists of ingredients are, whatever their places: the share of the recipe's foods
    for which one of the goal's can stand (algorithm 2).
    """

    dish: Recorded
    joins: tuple[Join, ...]
    vetoes: tuple[str, ...]
    score: float
    similarity: float = 0.0

    @property
    def frame(self) -> Frame:
        """How the recorded dish is made."""
        return self.dish.frame

    @property
    def order(self) -> tuple[object, ...]:
        """What frames are sorted by: no vetoes first, then the best score; ties by names, the same in every run."""
        return (
            len(self.vetoes),
            -round(self.score, 6),
            self.frame.video,
            self.frame.goal.sort_key,
            self.frame.dish_type,
        )


def shortlisted(
    outlines: Outlines, asked: Asked, likes: Likes, allowed: Callable[[str], bool] | None = None
) -> list[str]:
    """Return the keys of the frames that are worth a closer look, the best first, at most ``MOST_FITTED``.

    They are those of the ``asked`` dish type, and of others those whose dish is heated last as some dish of that type
    is; those first that have a place for most of what the recipe is built on. ``outlines`` tell of every frame what is
    needed for that; ``likes`` gives the known foods that can stand for one, best first. ``allowed`` says which goals,
    by their names, may be taken.
    """
    baked = any(dish.baked for dish in asked.dishes) and not asked.unbaked
    sought = []
    for food in asked.foods:
        label, facts = food.want.label, food.want.facts
        names = {singular(label), facts.taken_for, *(name for name, _ in likes(label))}
        sought.append(Sought(food.weight, names, facts.kind))
    # A cake has to come out of some oven, and a no-bake one out of none; for any other dish its type decides.
    return outlines.best(
        sought,
        asked.dish_type,
        _worth_a_look,
        title=asked.title,
        ends={("bake", "")} if baked else {("", "")} if asked.unbaked else None,
        allowed=allowed,
        most=MOST_FITTED,
    )


def _worth_a_look(there: Shares, own: Mask, named: Mask, headed: Mask) -> Shares:
    """Return how much each of many frames is worth a closer look; the arguments are those of :meth:`Outlines.best`."""
    return there + _TYPE_COUNTS * own + _NAME_COUNTS * np.where(headed, BY_TITLE, BY_TYPE * named)


def fits(layouts: Iterable[Layout], asked: Asked, matcher: Matcher) -> list[Fit]:
    """Return how well each frame of ``layouts`` suits what is ``asked``, the best first.

    ``matcher`` finds the places of foods.
    """
    found = (_fit(recorded(layout, asked.known), asked, matcher) for layout in layouts)
    return sorted(found, key=lambda fit: fit.order)


def _fit(dish: Recorded, asked: Asked, matcher: Matcher) -> Fit:
    joins = matcher.joins(dish.layout, asked.wants, stacked=asked.stacked)
    alike = sum(join.slot is not None for join in joins) / len(joins)
    return Fit(dish, joins, tuple(vetoes(dish, joins, asked)), score(dish, joins, asked, matcher.joining_counts), alike)


def refusals(wants: Sequence[Want], dish_type: str, title: str, known: Tables) -> list[str]:
    """Return what no dish of ``dish_type`` and ``title`` can do without, and the recipe has not, one reason each.

    ``wants`` are the foods of the recipe; ``known`` are the tables that say what dishes need.
    """
    lacked = unmet_needs([want.facts for want in wants], dish_type, title, known)
    return [f"no {name} without {_shown(needs)}" for name, needs in lacked]


def unmet_needs(foods: Sequence[Food], dish_type: str, title: str, known: Tables) -> list[tuple[str, Sequence[str]]]:
    """Return each dish of ``dish_type`` and ``title`` that none of ``foods`` makes, with what would.

    ``known`` are the tables that say what dishes need.
    """
    return [
        (dish.name, needs)
        for dish in known.dishes_named(dish_type, title)
        if not _needs_nothing(dish, foods)
        for needs in dish.needs
        if not _has_any(foods, needs, known)
    ]


def _is_asked_ready(dish: Dish, foods: Sequence[Food]) -> bool:
    """Whether a recipe asks for a dish ready made, as one of its foods; of a dish type only by its whole name."""
    if dish.name in {food.name for food in foods}:
        return True
    return not dish.is_type and any(dish.name in words(food.name) for food in foods)


def _needs_nothing(dish: Dish, foods: Sequence[Food]) -> bool:
    """Whether nobody can say of a list of ``foods`` that it lacks what a dish needs."""
    return _is_asked_ready(dish, foods) or _may_be_there(dish, foods) or _boils_of_its_foods(dish, foods)


def _may_be_there(dish: Dish, foods: Sequence[Food]) -> bool:
    """Whether one of ``foods`` may be what a title names by ``dish``, as nothing is known of it (datshi, a cheese)."""
    return dish.may_be_unknown and any(not food.known for food in foods)


def _boils_of_its_foods(dish: Dish, foods: Sequence[Food]) -> bool:
    """Whether a dish boils in water from the tap, to which something of ``foods`` gives its taste."""
    boils = dish.name in word_list("boils in the dish")
    return boils and any(food.is_any(word_list("boils in water from the tap")) for food in foods)


def _has_any(foods: Sequence[Food], needs: Sequence[str], known: Tables) -> bool:
    return any(meets(need, food, known) for need in needs for food in foods)


def _shown(needs: Sequence[str]) -> str:
    """Return what a dish needs one of in words, the first few by their names."""
    names = list(dict.fromkeys(need.rpartition(":")[2] for need in needs))
    return " or ".join(names if len(names) <= _MOST_SHOWN else [*names[:_MOST_SHOWN], "the like"])


def is_truly(fit: Fit, share: float = _MOST_OF_ITS_FOODS) -> bool:
    """Return whether a dish may be called as the recorded one that it ``fit`` is.

    It has most of that dish's foods but seasonings, at least a ``share`` (0 to 1) of them.
    """
    taken = {id(join.slot) for join in fit.joins if join.slot is not None}
    foods = zip(fit.frame.line.all_slots(), fit.dish.foods, strict=True)
    slots = [id(slot) for slot, food in foods if not food.is_any(SEASONS)]
    # a goal that is only called by its type (soup) says nothing that could be untrue
    plain = fit.dish.type_words.issuperset(fit.dish.words) or not slots
    return plain or sum(slot in taken for slot in slots) >= share * len(slots)


def has_mostly_its_foods(fit: Fit) -> bool:
    """Return whether more than half of what is asked, but seasonings, has a place of its own in the dish of ``fit``."""
    body = [join.slot is not None for join in fit.joins if not join.want.facts.is_any(SEASONS)]
    return 2 * sum(body) > len(body) or fit.dish.type_words.issuperset(fit.dish.words)
