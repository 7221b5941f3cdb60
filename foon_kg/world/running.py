"""Whether a food runs as it is, so that no hand picks it up."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import Food, Tables
from foon_kg.food.lists import says, word_list

_SEVERAL = 2  # foods make a mixture


def is_runny(label: str, states: Sequence[str], parts: Sequence[str], known: Tables) -> bool:
    """Return whether a food called ``label`` in these states is liquid, by the tables ``known``.

    Of ``parts``, the names of the foods that it was made of, all have to run or to dissolve in one that does.
    """
    if _is_set(states, parts, known):
        return False
    if len(parts) < _SEVERAL:
        return _runs_as_it_is(known.foods.food(parts[0] if parts else label, states), states, known)
    foods = [known.foods.food(name) for name in parts]
    wet = any(food.is_a("liquid", "water") and not food.is_a("fat") for food in foods)
    return wet and all(food.is_any(word_list("runs in a mixture")) for food in foods)


def _runs_as_it_is(facts: Food, states: Sequence[str], known: Tables) -> bool:
    """Whether a single food runs: by itself, by a state that it is in, or because it is out of its shell."""
    opened = facts.is_any(word_list("runs out of its shell")) and "shell" in facts.owes
    cooked = any(known.state(state).needs_heat or "cook" in known.state(state).earns for state in states)
    if opened and not cooked and says(states, "is open and raw"):
        return True
    runs = says(states, "runs") or says(states, "is too soft to be picked up")
    return runs or (facts.is_a("liquid") and not facts.is_a("creamy"))


def _is_set(states: Sequence[str], parts: Sequence[str], known: Tables) -> bool:
    """Whether what ran has set: it was shaped or baked so, or heated with what sets then."""
    if not (word_list("keeps its shape") | word_list("sets what runs")).isdisjoint(states):
        return True
    if not any(known.state(state).needs_heat for state in states):
        return False
    foods = [known.foods.food(name) for name in parts]
    if any(food.is_any(word_list("sets what is heated with it")) for food in foods):
        return True
    return any(food.is_a("egg") and not food.is_a("liquid") for food in foods) and not _is_custard(foods)


def _is_custard(foods: Sequence[Food]) -> bool:
    """Whether eggs are stirred with what is sweet in what keeps them from setting."""
    return all(any(food.is_any(word_list(need)) for food in foods) for need in ("sweetens eggs", "thins eggs"))
