"""What lies behind a goal at a level, brought from wherever the FOON is kept in a few questions."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable
from dataclasses import dataclass, field

from foon_kg.classic_retrieval.goal import RetrievalView
from foon_kg.kitchen import Kitchen
from foon_kg.levels import Level, node_at, units_at
from foon_kg.model import KnownUnit, ObjectNode


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
    """
    fetch = _Fetch(view, level, kitchen)
    fetch.search(goals)
    while waiting := fetch.unsearched({node_at(node, level) for node in goals}):
        fetch.search(waiting)
    found = units_at(fetch.units.values(), level)
    nodes = {node for known in found for node in known.unit.input_nodes}
    forms = {node_at(node, level) for node in goals}
    return PartBehind(
        tuple(sorted(forms, key=lambda node: node.sort_key)), found, frozenset(filter(fetch.is_at_hand, nodes | forms))
    )


@dataclass(eq=False)
class _Fetch:
    """What was fetched so far: ``forms`` holds, for each node of the level, the object nodes that it stands for."""

    view: RetrievalView
    level: Level
    kitchen: Kitchen
    units: dict[str, KnownUnit] = field(default_factory=dict)
    searched: set[ObjectNode] = field(default_factory=set)
    forms: defaultdict[ObjectNode, set[ObjectNode]] = field(default_factory=lambda: defaultdict(set))
    labels: set[str] = field(default_factory=set)

    def search(self, nodes: Collection[ObjectNode]) -> None:
        """Fetch the units behind ``nodes``; what they take in and the default kitchen has not was searched as well."""
        default = Kitchen.default()
        self.searched.update(nodes)
        for known in self.view.behind(nodes):
            self.units[known.unit.key] = known
            self.searched.update(node for node in known.unit.input_nodes if not default.has(node))
        self._learn_forms({node for known in self.units.values() for node in known.unit.input_nodes} | set(nodes))

    def unsearched(self, goals: Iterable[ObjectNode]) -> list[ObjectNode]:
        """Answer the object nodes that may be needed for ``goals`` and behind which nobody looked, sorted."""
        makers: defaultdict[ObjectNode, list[KnownUnit]] = defaultdict(list)
        for known in units_at(self.units.values(), self.level):
            for node in known.unit.output_nodes:
                makers[node].append(known)
        needed = list(goals)
        seen = set(needed)
        for form in needed:  # grows while it is read
            inputs = {node for known in makers[form] for node in known.unit.input_nodes} - seen
            seen |= inputs
            needed += [node for node in inputs if not self.is_at_hand(node)]
        waiting = {node for form in needed for node in self.forms[form]} - self.searched
        return sorted(waiting, key=lambda node: node.sort_key)

    def is_at_hand(self, form: ObjectNode) -> bool:
        """Whether the kitchen has one of the object nodes that ``form`` stands for."""
        return any(map(self.kitchen.has, self.forms[form]))

    def _learn_forms(self, nodes: Iterable[ObjectNode]) -> None:
        if self.level is Level.INGREDIENTS:
            for node in nodes:
                self.forms[node] = {node}
            return
        fresh = {node.label for node in nodes} - self.labels
        self.labels |= fresh
        for node in self.view.called(sorted(fresh)) if fresh else ():
            self.forms[node_at(node, self.level)].add(node)
