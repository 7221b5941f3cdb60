"""Where one planner works: numbered units, the kitchen of a search, and what was derived among them so far."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from functools import cached_property

from foon_kg.errors import NoTreeError
from foon_kg.footage import footage
from foon_kg.form import KnownFoon
from foon_kg.kitchen import Kitchen
from foon_kg.knowledge import SeenAs, TreeMemory, Vocabulary
from foon_kg.model import Goal, KnownUnit, ObjectNode
from foon_kg.ordering import as_recorded
from foon_kg.preparation import Preparations
from foon_kg.recent import Recent
from foon_kg.restoration import restored
from foon_kg.search import Explored, ReferenceTree, SearchProblem, UnitIndex, retrieve, retrieve_once
from foon_kg.settings import PlanSettings
from foon_kg.substitution import Candidate, Equivalents

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
_MADE = 2
_UNNAMED = 4
"""How many foods a mixture counts for that names none."""


def mixtures(kitchen: Kitchen, vocabulary: Vocabulary, units: Sequence[KnownUnit] | None = None) -> frozenset[str]:
    """Answer the foods that a FOON makes and never takes from the shop: dressings, doughs, dishes; those in ``units``.

    The words of the whole FOON tell, and not the units behind one goal: a part and the whole search alike (C9).
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
    """Answer what a search among ``units`` pays for a node that is not at hand: odd places least, mixtures most.

    ``mixtures`` are the foods that count as made wherever they stand: see :func:`mixtures`.
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


ABSENT = 3
"""What a search pays for a utensil that is not among those a person named: not so much that it would rather assume that
a food is processed already, for then it would be said that the food is missing, and not the utensil."""


MOST_TREES = 4096
"""How many reference trees a workshop keeps; what else it keeps is no more than the FOON has of it."""

MOST_KITCHENS = 16
"""For how many kitchens a workshop keeps what was made ready in them; most recipes share one."""


class Workshop:
    """Numbered units, and what was found among them: reference trees and the makings of foods."""

    def __init__(
        self,
        units: Sequence[KnownUnit],
        goals: Sequence[Goal],
        settings: PlanSettings,
        vocabulary: Vocabulary,
        *,
        memory: TreeMemory | None = None,
    ) -> None:
        self.memory = memory
        self.kitchen = settings.kitchen.with_every_food()  # foods of a reference are exchanged: the final tree is asked
        self.time_limit = settings.time_limit
        cost = gap_cost(self.kitchen, units, mixtures(self.kitchen, vocabulary, units))
        self.index = UnitIndex.of(
            units,
            at_hand=self.kitchen.has,
            gap_cost=lambda node: ABSENT if self.kitchen.lacks(node) else cost(node),
        )
        self.foon = KnownFoon.of(units, goals)
        self.references: Recent[tuple[ObjectNode, tuple[tuple[str, int], ...]], ReferenceTree] = Recent(MOST_TREES)
        self.units_behind: Recent[tuple[ObjectNode, ...], frozenset[int]] = Recent(MOST_TREES)
        self.explored = Explored()
        self.derived: dict[tuple[str, str], Sequence[KnownUnit] | None] = {}
        self.made: dict[ObjectNode, Sequence[KnownUnit] | None] = {}
        self.prepared: list[Preparations] = []
        self.recorded: Recent[tuple[tuple[str, ...], tuple[str, ...]], tuple[KnownUnit, ...]] = Recent(MOST_TREES)
        self.filmed: Recent[tuple[ObjectNode, tuple[str, ...]], tuple[KnownUnit, ...]] = Recent(MOST_TREES)

    def reference(self, goal: ObjectNode, wanted: dict[str, int]) -> ReferenceTree:
        """Answer the best tree of ``goal``; ``wanted`` maps its ingredients to the foods that they may play."""
        key = (goal, tuple(sorted(wanted.items())))
        if key not in self.references:
            problem = SearchProblem(self.index, (goal,), wanted=wanted)
            self.references[key] = retrieve_once(
                problem, self.memory, time_limit=self.time_limit, explored=self.explored
            )
        return self.references[key]

    def script(self, reference: ReferenceTree, videos: tuple[str, ...]) -> tuple[KnownUnit, ...]:
        """Answer the units of ``reference`` in the order of the ``videos`` of its goal."""
        key = (tuple(known.unit.key for known in reference.units), videos)
        if key not in self.recorded:
            self.recorded[key] = restored(as_recorded(reference.units, videos), self._makers, self.kitchen)
        return self.recorded[key]

    def footage(self, goal: ObjectNode, videos: tuple[str, ...]) -> tuple[KnownUnit, ...]:
        """Answer the units of the first of ``videos`` that may take part in making ``goal``, in their order."""
        if goal not in self.index.number_of:
            return ()
        key = (goal, videos)
        if key not in self.filmed:
            units = footage(goal, videos, self._makers, self.kitchen.has)
            self.filmed[key] = restored(units, self._makers, self.kitchen)
        return self.filmed[key]

    def behind(self, goal: ObjectNode, foods: Collection[tuple[str, str]]) -> tuple[KnownUnit, ...]:
        """Answer every unit that may take part in making ``goal``, or a node of one of ``foods`` (label, state)."""
        found = [self._behind((goal,)), *(self._behind(self._nodes_in(*food)) for food in foods)]
        return tuple(self.index.units[unit] for unit in sorted(frozenset[int]().union(*found)))

    def _nodes_in(self, label: str, state: str) -> tuple[ObjectNode, ...]:
        return tuple(node for node in self._nodes_called.get(label, ()) if state in node.states)

    def _behind(self, nodes: tuple[ObjectNode, ...]) -> frozenset[int]:
        if nodes not in self.units_behind:
            self.units_behind[nodes] = frozenset(self._reached(nodes))
        return self.units_behind[nodes]

    def _reached(self, nodes: tuple[ObjectNode, ...]) -> set[int]:
        index = self.index
        waiting = [index.number_of[node] for node in nodes if node in index.number_of]
        seen, found = set(waiting), set[int]()
        while waiting:
            for unit in index.producers[waiting.pop()]:
                if unit not in found:
                    found.add(unit)
                    fresh = {n for n in index.inputs[unit] if n not in seen and not index.at_hand[n]}
                    seen |= fresh
                    waiting += fresh
        return found

    def preparations(self, equivalents: Equivalents) -> Preparations:
        """Answer the ways to have foods ready; recipes with the same ``equivalents`` share what was made so far."""
        known = next((made for made in self.prepared if made.equivalents is equivalents), None)
        if known is None:
            known = Preparations(equivalents, equivalents.kitchen, self.derive, self.make)
            self.prepared = [known, *self.prepared][:MOST_KITCHENS]
        return known

    def derive(self, candidate: Candidate) -> Sequence[KnownUnit] | None:
        """Answer the fewest units that make a food in a state, or ``None`` where nothing does."""
        key = (candidate.label, candidate.state)
        if key not in self.derived:
            self.derived[key] = self._derive(*key)
        return self.derived[key]

    def make(self, node: ObjectNode) -> Sequence[KnownUnit] | None:
        """Answer the fewest units that make ``node``, or ``None`` where nothing does."""
        if node not in self.made:
            self.made[node] = self._retrieve((node,))
        return self.made[node]

    def _derive(self, label: str, state: str) -> Sequence[KnownUnit] | None:
        return self._retrieve(self._nodes_in(label, state))

    @cached_property
    def _nodes_called(self) -> dict[str, list[ObjectNode]]:
        nodes: dict[str, list[ObjectNode]] = {}
        for node in self.index.nodes:
            nodes.setdefault(node.label, []).append(node)
        return nodes

    def _retrieve(self, targets: tuple[ObjectNode, ...]) -> Sequence[KnownUnit] | None:
        try:
            script = retrieve(
                SearchProblem(self.index, targets), time_limit=self.time_limit, explored=self.explored
            ).units
        except NoTreeError:
            return None
        return restored(script, self._makers, self.kitchen)

    def _makers(self, node: ObjectNode) -> Iterator[KnownUnit]:
        return (self.index.units[number] for number in self.index.producers[self.index.number_of[node]])
