"""What the search for a reference tree pays for leaves that are not at hand."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.model.knowledge import SeenAs, Vocabulary
from foon_kg.plans.kitchen import Kitchen

# What a search pays for a leaf that is not at hand. A sum of cheaper faults should rarely buy off a dearer one:
# a food in an odd place is found easily, a processed one has to be made, a mixture is a dish of its own. A mixture
# costs as much as the foods in it, so that a dish is not taken ready-made for want of a part of it, and what a unit
# makes costs more than what none does: for that there is no way round.
_ODD_PLACE = 1
_FILLED_BY_NOBODY = 2
_USED = 10
_FILLED_BY_A_UNIT = 50
_PROCESSED = 100
_TURNED_ON_BY_A_UNIT = 200
_MIXTURE = 1000
"""For each food in a mixture."""

_MADE = 2
"""How many times as much a mixture costs that a unit makes."""

_UNNAMED = 4
"""How many foods a mixture counts for that names none."""

ABSENT = 3
"""What a search pays for a utensil that is not among those a person named: not so much that it would rather assume that
a food is processed already, for then it would be said that the food is missing, and not the utensil."""


def mixtures(kitchen: Kitchen, vocabulary: Vocabulary, units: Sequence[KnownUnit] | None = None) -> frozenset[str]:
    """Return the foods that a FOON makes and never takes from the shop: dressings, doughs, dishes; those in ``units``.

    ``kitchen`` tells foods from utensils. The words of the whole FOON (``vocabulary``) tell, and not the units behind
    one goal: a part and the whole search alike (C9).
    """

    def is_bought(row: SeenAs) -> bool:
        return row.used > row.made and (not row.state or kitchen.is_start_state(row.label, row.state))

    rows_of = vocabulary.rows_of
    named = rows_of.keys() if units is None else rows_of.keys() & _foods_named(units)
    return frozenset(name for name in named if not any(map(is_bought, rows_of[name])))


def _foods_named(units: Sequence[KnownUnit]) -> set[str]:
    nodes = {node for known in units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
    return {name for node in nodes for name in (node.label, *node.ingredients)}


def gap_cost(
    kitchen: Kitchen, units: Sequence[KnownUnit], mixtures: Collection[str] = ()
) -> Callable[[ObjectNode], int | None]:
    """Return what a search among ``units`` pays for a node that is not at hand: odd places least, mixtures most.

    ``kitchen`` says what is at hand; ``mixtures`` are the foods that count as made wherever they stand: see
    :func:`mixtures`.
    """
    made = {node for known in units for node in known.unit.output_nodes}
    mixed = frozenset(mixtures)

    def cost(node: ObjectNode) -> int | None:
        foods = kitchen.foods_in(node)
        if kitchen.is_food(node):
            if kitchen.is_mixture(node) or (foods and node in made):
                return mixture(node, len(foods))
            processed = _PROCESSED * len(kitchen.processed_states(node))
            return mixture(node, _UNNAMED) if node.label in mixed and node in made else processed or _ODD_PLACE
        if len(foods) > 1 or not mixed.isdisjoint(foods):
            return mixture(node, len(foods) if len(foods) > 1 or node not in made else _UNNAMED)
        if kitchen.is_running(node):
            return _TURNED_ON_BY_A_UNIT if node in made else _USED
        if foods:
            return _FILLED_BY_A_UNIT if node in made else _FILLED_BY_NOBODY
        return _ODD_PLACE if kitchen.at_rest(node) else _USED

    def mixture(node: ObjectNode, foods: int) -> int:
        return _MIXTURE * max(foods, 1) * (_MADE if node in made else 1)

    return cost
