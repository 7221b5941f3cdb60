"""How much, how long and how hot, told of the steps of a plan.

Who asks says how much of a food there is; what he leaves open the recorded dish says, of the steps made after it.
Nothing is scaled: a recorded amount, a time or a heat stays what it was for the recorded dish.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace

from foon_kg.food import singular
from foon_kg.food.lists import word_list
from foon_kg.model import (
    UNMEASURED,
    AskedAmount,
    FunctionalUnit,
    KnownUnit,
    Measures,
    ObjectNode,
    Recipe,
    RequiredIngredient,
)
from foon_kg.model.tree import Step

_MINUTE, _HOUR = 60, 3600
_LONG = 2 * _HOUR


def amount_of(text: str) -> tuple[str, str]:
    """Return the amount and the food in the ``text`` of a measure: "200 g flour" is 200 g of flour."""
    number, _, rest = text.partition(" ")
    unit, _, food = rest.partition(" ")
    return (number if unit == "piece" else f"{number} {unit}", food) if food else (number, unit)


def measured_words(measures: Measures, motion: str) -> str:
    """Return what ``measures`` say of a ``motion``, as it follows a sentence; nothing for none.

    For example `` for 60 min at 165 °C (200 g flour)``. Amounts that nobody asked for are told as recorded: who asks
    may have another one in mind.
    """
    by = "to" if motion in word_list("comes to a temperature") else "at"
    said = f" for {_long(measures.seconds)}" if measures.seconds is not None else ""
    said += f" {by} {measures.celsius:g} °C" if measures.celsius is not None else ""
    parts = [_listed(measures.asked)] if measures.asked else []
    if measures.amounts:
        parts.append(f"recorded: {_listed([amount_of(text) for text in measures.amounts])}")
    return f"{said} ({'; '.join(parts)})" if parts else said


def _listed(amounts: Sequence[tuple[str, str]]) -> str:
    """Return amounts in words, each with its food: what stands before it in the sentence may be the knife."""
    return ", ".join(f"{amount} {food}" for amount, food in amounts)


def _long(seconds: float) -> str:
    if seconds < _MINUTE:
        return f"{seconds:g} s"
    return f"{seconds / _HOUR:g} h" if seconds >= _LONG else f"{seconds / _MINUTE:g} min"


def with_measures(units: Sequence[Step], recorded: Iterable[KnownUnit], video: str) -> tuple[Step, ...]:
    """Return ``units`` with what ``recorded`` ones say in ``video``.

    A step is done as long and as hot as the first recorded step of its motion, not told yet, that takes one of its
    things. How much of a food is taken is said where it first comes into the tree, unless somebody asked for an amount
    of it. Nothing is said of other foods than the recorded ones.
    """
    said = _measured_in(video, recorded)
    timed = [(unit, rest) for unit, measures in said if (rest := replace(measures, amounts=()))]
    amounts = _amounts_by_food((measures for _, measures in said), apart_from=_foods_asked(units))
    there: set[ObjectNode] = set()
    told = []
    for unit in units:
        fresh = dict.fromkeys(singular(node.label) for node in unit.input_nodes if node not in there)
        taken = tuple(amounts[food].pop(0) for food in fresh if amounts.get(food))
        told.append(_measured(unit, _first_of(unit, timed), taken))
        there.update(unit.output_nodes)
    return tuple(told)


def _measured(unit: Step, recorded: Measures, amounts: tuple[str, ...]) -> Step:
    """Return a step with what is recorded of it beside what somebody asked."""
    if not (recorded or amounts):
        return unit
    return replace(unit, measures=replace(recorded, amounts=amounts, asked=unit.measures.asked))


def _measured_in(video: str, recorded: Iterable[KnownUnit]) -> list[tuple[FunctionalUnit, Measures]]:
    """Return what a video says of its units, in the order of the video."""
    seen = [(s.position, known.unit, s.measures) for known in recorded for s in known.seen_in if s.video == video]
    said = sorted((row for row in seen if row[2]), key=lambda row: (row[0], row[1].key))
    return [(unit, measures) for _, unit, measures in said]


def _foods_asked(units: Iterable[Step]) -> set[str]:
    """Return the foods (in the singular) of which somebody asked for an amount."""
    return {singular(one.food) for unit in units for one in unit.measures.asked}


def _amounts_by_food(measures: Iterable[Measures], apart_from: Collection[str]) -> dict[str, list[str]]:
    """Return how much is taken of each food (by its name in the singular), in the order in which it is said.

    Foods ``apart_from`` which this is told are left out.
    """
    amounts: defaultdict[str, list[str]] = defaultdict(list)
    for text in (text for one in measures for text in one.amounts):
        food = singular(amount_of(text)[1])
        if food not in apart_from:
            amounts[food].append(text)
    return dict(amounts)


def _first_of(unit: Step, timed: list[tuple[FunctionalUnit, Measures]]) -> Measures:
    """Take out of ``timed`` what is said of such a step as ``unit``."""
    labels = {singular(node.label) for node in unit.input_nodes}
    for place, (recorded, measures) in enumerate(timed):
        if recorded.motion == unit.motion and any(singular(n.label) in labels for n in recorded.input_nodes):
            del timed[place]
            return measures
    return UNMEASURED


def amounts_asked(recipe: Recipe) -> list[str]:
    """Return how much a ``recipe`` asks of each distinct ingredient: "60 g and 5 g" where it is asked twice."""
    amounts: defaultdict[RequiredIngredient, list[str]] = defaultdict(list)
    for one in recipe.ingredients:
        if one.object:
            amounts[one].append(one.amount)
    return [" and ".join(filter(None, said)) for said in amounts.values()]


def with_asked(units: Sequence[Step], foods: Iterable[tuple[RequiredIngredient, int]]) -> tuple[Step, ...]:
    """Return ``units``, whose things have numbers, with the amounts of ``foods``; each food comes with its number.

    An amount is said of the step that first takes the food. Where the tree takes the food several times (oil for the
    pan and for the salad), each of these steps takes a part of it: nobody knows which.
    """
    told: defaultdict[int, list[AskedAmount]] = defaultdict(list)
    first = _first_takings(units)
    numbered = list(foods)
    others = _others_by_food(first, {number for _, number in numbered})
    for wanted, number in numbered:
        if not wanted.amount or number not in first:
            continue
        more = others.get(singular(wanted.object), [])
        amount = f"part of {wanted.amount}" if more else wanted.amount
        for one in (number, *more):
            told[first[one][1]].append(AskedAmount(amount, wanted.object))
    return tuple(
        replace(unit, measures=replace(unit.measures, asked=tuple(told[place]))) if place in told else unit
        for place, unit in enumerate(units)
    )


def _others_by_food(first: Mapping[int, tuple[str, int]], asked: Collection[int]) -> dict[str, list[int]]:
    """Return the numbers of the things first taken (:func:`_first_takings`) that are not ``asked`` for, by name."""
    others: defaultdict[str, list[int]] = defaultdict(list)
    for number, (food, _) in first.items():
        if number not in asked:
            others[food].append(number)
    return dict(others)


def _first_takings(units: Sequence[Step]) -> dict[int, tuple[str, int]]:
    """Return the name of each thing that is in the kitchen, and the place of the first step that takes it."""
    first: dict[int, tuple[str, int]] = {}
    made: set[int | None] = {None}
    for place, unit in enumerate(units):
        for mention in unit.inputs:
            if mention.thing is not None and mention.thing not in made:
                first.setdefault(mention.thing, (singular(mention.node.label), place))
        made.update(mention.thing for mention in unit.outputs)
    return first
