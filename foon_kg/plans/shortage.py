"""What is missing for a tree, and what to do about it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from typing import Protocol

from foon_kg.food import singular
from foon_kg.model import ObjectNode
from foon_kg.model.errors import NoTreeError
from foon_kg.model.knowledge import FAIR
from foon_kg.model.tree import Step
from foon_kg.plans.kitchen import Kitchen

_TO_DO = ("get ", "buy or make ", "buy ")
"""How a remedy begins that is said once for several things."""

MOST_NAMED = 5
"""How many of the missing things a message names; the rest is counted."""


class ShortageError(NoTreeError):
    """There is no tree from what is at hand; ``missing`` are the leaves that are not, nearest to the goal first."""

    code = "missing"

    def __init__(self, message: str, *, missing: tuple[ObjectNode, ...], hint: str = "", code: str = "") -> None:
        super().__init__(message, hint=hint, code=code)
        self.missing = missing


class Made(Protocol):
    """What there is no kitchen for: the plan of a dish."""

    @property
    def goal(self) -> ObjectNode:
        """The dish."""

    @property
    def units(self) -> Sequence[Step]:
        """The steps, in the order of execution."""


def shortage(
    missing: tuple[ObjectNode, ...], plan: Made, kitchen: Kitchen, alike: Callable[[str, str], float]
) -> ShortageError:
    """Return the error for a ``plan`` of which the leaves ``missing`` are not in the kitchen that a person named.

    ``alike`` says how likely a cook is to accept the second food for the first (0 to 1).
    """
    goal = plan.goal
    few = {
        one.leaf: f"{with_article(one.leaf.label)} ({one.needed} are needed, {one.there} there)"
        for one in kitchen.shortages(plan.units)
    }
    food = next((node.label for node in missing if kitchen.is_food(node)), None)
    leave = "" if food is None else f", or leave out the {food}{_there_like(food, kitchen, alike)}"
    bought = _as_bought(missing, kitchen)
    lacked = dict.fromkeys(few.get(node) or _called(node, kitchen) for node in bought)
    return ShortageError(
        f"the kitchen lacks {_in_a_row(lacked)} for {goal.label}",
        missing=missing,
        hint=f"{remedies(missing, kitchen)}{leave}. What is there after all has to be named as at hand.",
    )


def _there_like(food: str, kitchen: Kitchen, alike: Callable[[str, str], float]) -> str:
    sure = [(alike(food, name), name) for name in kitchen.food_names if singular(name) != singular(food)]
    confidence, name = max(sure, key=lambda row: row[0], default=(0.0, ""))
    return f", or ask for {name} instead ({confidence:.2f} like it)" if confidence >= FAIR else ""


def remedy(node: ObjectNode, kitchen: Kitchen | None = None) -> str:
    """Return what to do about a missing leaf ``node``: ``buy onion``, ``get a bowl``; ``kitchen`` knows utensils."""
    kitchen = kitchen or Kitchen.default()
    if kitchen.is_food(node):
        processed = _made_states(node, kitchen)
        if kitchen.is_mixture(node):
            return f"buy or make {node.label}"
        return f"have {node.label} ready: {', '.join(processed)}" if processed else f"buy {node.label}"
    foods = kitchen.foods_in(node)
    if foods and kitchen.is_storage(node.label):
        return f"buy {' and '.join(foods)} ({node.label})"
    return f"get {with_article(node.label)}"


def remedies(missing: Iterable[ObjectNode], kitchen: Kitchen | None = None) -> str:
    """Return what to do about all of ``missing``, each once, in their order: ``Get a bowl and a knife, buy onion``.

    ``kitchen`` tells what is bought from what is fetched; ``None`` is the usual one.
    """
    found: dict[str, list[str]] = {}
    bought = _as_bought(tuple(missing), kitchen or Kitchen.default())
    for text in dict.fromkeys(remedy(node, kitchen) for node in bought):
        what = next((what for what in _TO_DO if text.startswith(what)), "")
        found.setdefault(what, []).append(text.removeprefix(what))
    told = ", ".join(f"{what}{_in_a_row(things)}" for what, things in found.items())
    return told[:1].upper() + told[1:]


def _as_bought(missing: Sequence[ObjectNode], kitchen: Kitchen) -> Sequence[ObjectNode]:
    """Return ``missing`` without the foods that come in a storage which is missing, too: who buys it has both."""
    sold = {
        (node.label, food)
        for node in missing
        if not kitchen.is_food(node) and kitchen.is_storage(node.label)
        for food in kitchen.foods_in(node)
    }
    return [node for node in missing if (node.container, node.label) not in sold]


def named(missing: Sequence[ObjectNode]) -> str:
    """Return the first of ``missing`` as the FOON writes them, and how many more there are."""
    rest = f" and {len(missing) - MOST_NAMED} more" if missing[MOST_NAMED:] else ""
    return "; ".join(map(str, missing[:MOST_NAMED])) + rest


def _called(node: ObjectNode, kitchen: Kitchen) -> str:
    there = kitchen.otherwise(node)
    told = f" (there is {'; '.join(map(str, there[:MOST_NAMED]))})" if there else ""
    return _by_name(node, kitchen) + told


def _made_states(node: ObjectNode, kitchen: Kitchen) -> list[str]:
    """Return the states of a food in which no shop sells it."""
    return [state for state in node.states if not Kitchen.is_start_state(kitchen, node.label, state)]


def _by_name(node: ObjectNode, kitchen: Kitchen) -> str:
    if kitchen.is_food(node):
        processed = _made_states(node, kitchen)
        return f"{node.label} ({', '.join(processed)})" if processed else node.label
    foods = kitchen.foods_in(node)
    return f"{with_article(node.label)} of {' and '.join(foods)}" if foods else with_article(node.label)


def with_article(label: str) -> str:
    """Return a ``label`` with its article: ``a bowl``, ``an oven``, ``tongs``."""
    if label.endswith("s") and not label.endswith("ss"):
        return label
    return f"{'an' if label[:1] in 'aeiou' else 'a'} {label}"


def _in_a_row(names: Iterable[str]) -> str:
    """Return ``a, b and c``: the first few, and how many more there are."""
    told = list(names)
    if told[MOST_NAMED:]:
        told = [*told[:MOST_NAMED], f"{len(told) - MOST_NAMED} more"]
    return f"{', '.join(told[:-1])} and {told[-1]}" if told[1:] else "".join(told)


def nearest_first(
    leaves: Collection[ObjectNode],
    units: Sequence[tuple[Collection[ObjectNode], Collection[ObjectNode]]],
    goal: ObjectNode,
) -> tuple[ObjectNode, ...]:
    """Return ``leaves`` by how few units are between them and ``goal``; ties by node.

    ``units`` are the (inputs, outputs) of a tree, in the order of execution.
    """
    distance, ring, depth = {goal: 0}, {goal}, 0
    while ring:
        depth += 1
        taken = {node for inputs, outputs in units if ring.intersection(outputs) for node in inputs}
        ring = taken - distance.keys()
        distance |= dict.fromkeys(ring, depth)
    return tuple(sorted(leaves, key=lambda node: (distance.get(node, depth), node.sort_key)))
