"""How much, how long and how hot: what the recorded dish says of it, told of the steps that are made after it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import replace

from foon_kg.food import singular
from foon_kg.food.lists import word_list
from foon_kg.model import UNMEASURED, FunctionalUnit, KnownUnit, Measures, ObjectNode
from foon_kg.model.tree import TreeUnit

_MINUTE, _HOUR = 60, 3600
_LONG = 2 * _HOUR


def amount_of(text: str) -> tuple[str, str]:
    """Return the amount and the food of one of the ``amounts`` of measures: "200 g flour" is 200 g of flour."""
    number, _, rest = text.partition(" ")
    unit, _, food = rest.partition(" ")
    return (number if unit == "piece" else f"{number} {unit}", food) if food else (number, unit)


def measured_words(measures: Measures, motion: str) -> str:
    """Return what measures say, as it follows a sentence: " for 60 min at 165 °C (recorded: 200 g)"; nothing for none.

    Amounts are told as recorded: who asks may have another one in mind.
    """
    by = "to" if motion in word_list("comes to a temperature") else "at"
    said = f" for {_long(measures.seconds)}" if measures.seconds is not None else ""
    said += f" {by} {measures.celsius:g} °C" if measures.celsius is not None else ""
    amounts = [amount_of(text) for text in measures.amounts]
    told = [amount if len(amounts) == 1 else f"{amount} {food}" for amount, food in amounts]
    return f"{said} (recorded: {', '.join(told)})" if told else said


def _long(seconds: float) -> str:
    if seconds < _MINUTE:
        return f"{seconds:g} s"
    return f"{seconds / _HOUR:g} h" if seconds >= _LONG else f"{seconds / _MINUTE:g} min"


def with_measures(units: Sequence[TreeUnit], recorded: Iterable[KnownUnit], video: str) -> tuple[TreeUnit, ...]:
    """Return ``units`` with what ``recorded`` ones say in ``video``.

    A step is done as long and as hot as the first recorded step of its motion, not told yet, that takes one of its
    things. How much of a food is taken is said where it first comes into the tree. Nothing is said of other foods than
    the recorded ones.
    """
    said = [(s.position, known.unit, s.measures) for known in recorded for s in known.seen_in if s.video == video]
    said = sorted((row for row in said if row[2]), key=lambda row: (row[0], row[1].key))
    timed = [(unit, replace(measures, amounts=())) for _, unit, measures in said if replace(measures, amounts=())]
    amounts: defaultdict[str, list[str]] = defaultdict(list)
    for text in (text for _, _, measures in said for text in measures.amounts):
        amounts[singular(amount_of(text)[1])].append(text)
    there: set[ObjectNode] = set()
    told = []
    for unit in units:
        fresh = dict.fromkeys(singular(node.label) for node in unit.input_nodes if node not in there)
        taken = tuple(amounts[food].pop(0) for food in fresh if amounts.get(food))
        own = _first_of(unit, timed)
        told.append(replace(unit, measures=replace(own, amounts=taken)) if own or taken else unit)
        there.update(unit.output_nodes)
    return tuple(told)


def _first_of(unit: TreeUnit, timed: list[tuple[FunctionalUnit, Measures]]) -> Measures:
    """Take out of ``timed`` what is said of such a step as ``unit``."""
    labels = {singular(node.label) for node in unit.input_nodes}
    for place, (recorded, measures) in enumerate(timed):
        if recorded.motion == unit.motion and any(singular(n.label) in labels for n in recorded.input_nodes):
            del timed[place]
            return measures
    return UNMEASURED
