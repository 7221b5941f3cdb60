"""Where foods may join a script, as far as the script alone tells: it is the same for every recipe."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from foon_kg import motions
from foon_kg.food import tables
from foon_kg.kitchen import Kitchen
from foon_kg.lines import FoodLine, opens_food
from foon_kg.model import KnownUnit, ObjectNode


@dataclass(frozen=True, eq=False)
class Slots:
    """The units of a script, by their places, as those whom others may join.

    ``accepting`` are the places at which any number of foods may enter; ``open`` are those of them that bring these
    into something that holds foods, up to the last mixing. ``measuring`` only bring a food into a measure or a spoon.
    ``joined_by`` has the foods whose lines come together with others at a place, ``taker`` the first place that takes a
    node, and ``heated`` are the places at which or after which what joins there is cooked.
    """

    accepting: frozenset[int]
    open: tuple[int, ...]
    measuring: frozenset[int]
    joined_by: Mapping[int, tuple[str, ...]]
    taker: Mapping[ObjectNode, int]
    heated: frozenset[int]

    @classmethod
    def of(cls, units: Sequence[KnownUnit], lines: Mapping[str, FoodLine], kitchen: Kitchen) -> Slots:
        """Read ``units``, whose foods have these ``lines``."""
        places = range(len(units))
        accepting = frozenset(p for p in places if _accepts_any(units[p]))
        last = max((place for place in places if _mixes_or_heats(units[place])), default=len(units))
        usable = (place for place in places[: last + 1] if place in accepting and _receives(units[place], kitchen))
        joined_by: dict[int, tuple[str, ...]] = {}
        for label, line in lines.items():
            joined_by[line.joins] = (*joined_by.get(line.joins, ()), label)
        return cls(
            accepting,
            tuple(place for place in usable if not _prepares(place, units, kitchen)),
            frozenset(place for place in accepting if _measures(units[place], kitchen)),
            joined_by,
            {node: place for place in reversed(places) for node in units[place].unit.input_nodes},
            frozenset(_heated(units, kitchen)),
        )


def _heated(units: Sequence[KnownUnit], kitchen: Kitchen) -> Iterator[int]:
    """Answer the places from which something gets under heat: by a motion, or in a vessel that is hot."""
    under_heat: set[ObjectNode] = set()
    for place in reversed(range(len(units))):
        unit = units[place].unit
        made = [node for node in unit.output_nodes if kitchen.is_food(node) or kitchen.foods_in(node)]
        hot = any(kitchen.is_running(node) for node in made)
        if hot or motions.heats(unit.motion) or not under_heat.isdisjoint(made):
            yield place
            under_heat.update(node for node in unit.input_nodes if kitchen.is_food(node) or kitchen.foods_in(node))


def _accepts_any(known: KnownUnit) -> bool:
    return motions.accepts_any(known.unit.motion, star=known.unit.accepts_any)


def _mixes_or_heats(known: KnownUnit) -> bool:
    return motions.mixes(known.unit.motion) or motions.heats(known.unit.motion)


def _receives(known: KnownUnit, kitchen: Kitchen) -> bool:
    return any(node.ingredients for node in known.unit.output_nodes if not kitchen.is_storage(node.label))


def _prepares(place: int, units: Sequence[KnownUnit], kitchen: Kitchen) -> bool:
    """Say whether a unit brings a food to where it is cut or peeled: nothing joins it before that (sense, S3)."""
    moved = {node.label for node in units[place].unit.input_nodes if kitchen.is_food(node)}
    return any(opens_food(label, known) for known in units[place + 1 :] for label in moved)


def _measures(known: KnownUnit, kitchen: Kitchen) -> bool:
    filled = [node for node in known.unit.output_nodes if node.ingredients and not kitchen.is_food(node)]
    return bool(filled) and all(_is_measure(node.label) for node in filled)


def _is_measure(label: str) -> bool:
    """Say whether a utensil measures, and nobody cooks or serves in it: a jigger, a measuring cup, a spoon."""
    row = tables().utensil(label)
    return row is not None and (row.group == "measures" or (row.role == "tool" and {"hold", "measure"} <= row.can))
