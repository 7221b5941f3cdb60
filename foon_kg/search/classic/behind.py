"""What lies behind a goal at a level, brought from wherever the FOON is kept in a few questions."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection
from dataclasses import dataclass, field

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.model.levels import Level, Leveller, units_at
from foon_kg.plans.kitchen import Kitchen
from foon_kg.search.classic.goal import RetrievalView

MOST_UNITS = 20_000
"""More units are not fetched: with what the search makes of them they would take a gigabyte."""


@dataclass(frozen=True)
class PartBehind:
    """The units at a level that may take part in making the ``goals``, and which of their nodes are at hand.

    A node of level 1 or 2 stands for all object nodes that become one there: it is at hand where one of them is.
    """

    goals: tuple[ObjectNode, ...]
    units: tuple[KnownUnit, ...]
    at_hand: frozenset[ObjectNode]


def part_behind(view: RetrievalView, goals: Collection[ObjectNode], level: Level, kitchen: Kitchen) -> PartBehind:
    """Fetch what lies behind ``goals`` at ``level``.

    A view knows the FOON as it was annotated (level 3), and stops at what the default kitchen has. So at lower
    levels, and where ``kitchen`` has less, the units found may need nodes that were not searched: these are asked next.
    Raises TooManyUnitsError where more than ``MOST_UNITS`` would have to be fetched at a time.
    """
    fetch = _Fetch(view, level, kitchen)
    fetch.search(goals)
    forms = set(map(fetch.leveller.node, goals))
    while waiting := fetch.unsearched(forms):
        fetch.search(waiting)
    found = units_at((fetch.units[key] for key in sorted(fetch.needed)), level)
    nodes = {node for known in found for node in known.unit.input_nodes}
    return PartBehind(
        tuple(sorted(forms, key=lambda node: node.sort_key)),
        found,
        frozenset(node for node in nodes | forms if fetch.is_at_hand(node)),
    )


@dataclass(eq=False)
class _Fetch:
    """What was fetched so far.

    ``forms`` holds, for each node of the level, the object nodes that it stands for; ``makers``, the units that
    output it with their inputs at the level. ``needed`` are the units that may take part in making the goals.
    ``at_hand`` remembers what the kitchen was asked.
    """

    view: RetrievalView
    level: Level
    kitchen: Kitchen
    units: dict[str, KnownUnit] = field(default_factory=dict)
    searched: set[ObjectNode] = field(default_factory=set)
    forms: defaultdict[ObjectNode, set[ObjectNode]] = field(default_factory=lambda: defaultdict(set))
    makers: defaultdict[ObjectNode, list[tuple[str, set[ObjectNode]]]] = field(
        default_factory=lambda: defaultdict(list)
    )
    needed: set[str] = field(default_factory=set)
    labels: set[str] = field(default_factory=set)
    at_hand: dict[ObjectNode, bool] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.leveller = Leveller(self.level)
        self.default = Kitchen.default()

    def search(self, nodes: Collection[ObjectNode]) -> None:
        """Fetch the units behind ``nodes``; what they take in and the default kitchen has not was searched as well."""
        self.searched.update(nodes)
        fresh = set(nodes)
        for known in self.view.behind(nodes, most=MOST_UNITS):
            if known.unit.key not in self.units:
                self.units[known.unit.key] = known
                fresh.update(known.unit.input_nodes)
                inputs = set(map(self.leveller.node, known.unit.input_nodes))
                for made in known.unit.output_nodes:
                    self.makers[self.leveller.node(made)].append((known.unit.key, inputs))
        self.searched.update(node for node in fresh - self.searched if not self.default.has(node))
        self._learn_forms(fresh)

    def unsearched(self, goals: Collection[ObjectNode]) -> list[ObjectNode]:
        """Return the object nodes that may be needed for ``goals`` and behind which nobody looked, sorted."""
        needed, seen = list(goals), set(goals)
        for form in needed:  # grows while it is read
            for unit, inputs in self.makers[form]:
                self.needed.add(unit)
                fresh = inputs - seen
                seen |= fresh
                needed += [node for node in fresh if not self.is_at_hand(node)]
        waiting = {node for form in needed for node in self.forms[form]} - self.searched
        return sorted(waiting, key=lambda node: node.sort_key)

    def is_at_hand(self, form: ObjectNode) -> bool:
        """Whether the kitchen has one of the object nodes that ``form`` stands for."""
        if form not in self.at_hand:
            self.at_hand[form] = any(map(self.kitchen.has, self.forms[form]))
        return self.at_hand[form]

    def _learn_forms(self, nodes: Collection[ObjectNode]) -> None:
        if self.level is Level.INGREDIENTS:
            for node in nodes:
                self.forms[node] = {node}
            return
        fresh = {node.label for node in nodes} - self.labels
        self.labels |= fresh
        for node in self.view.called(sorted(fresh)) if fresh else ():
            self.forms[self.leveller.node(node)].add(node)
