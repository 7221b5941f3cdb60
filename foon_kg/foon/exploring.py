"""How to look around in a FOON in a Neo4j that may be too large for memory: each question reads a bounded part of it.

The examples are of a Neo4j that holds the demo's FOON.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from foon_kg.foon.opened import Opened

if TYPE_CHECKING:  # every question imports what it needs
    from foon_kg.model import Goal, KnownUnit, ObjectNode
    from foon_kg.store.graph.rows import NamesLikeRow, SizeRow
    from foon_kg.store.snapshot import Snapshot


@dataclass(frozen=True)
class AroundObject:
    """The nodes of an object, some of the units that make and take it, how many do, and some of its videos."""

    nodes: Sequence[ObjectNode]
    made: Sequence[KnownUnit]
    made_count: int
    taken: Sequence[KnownUnit]
    taken_count: int
    videos: Sequence[str]


class Exploring(Opened):
    """A FOON whose Neo4j is looked around in; one in files raises ``UsageError`` for all of it."""

    def size(self) -> SizeRow:
        """Return how many units, videos and foods the graph has, and its dish types in no order.

        >>> foon.size().videos
        23
        """
        from foon_kg.store.graph.overview import size_of

        with self._graph.reading() as view:
            return size_of(view)

    def names_like(self, text: str, most: int, *, state: str = "") -> NamesLikeRow:
        """Return foods, objects and goals that ``text`` may become, at most ``most`` of each.

        They have a word that begins with it, or is compared as one that does. Of each food it is told whether it is
        seen in ``state``.

        >>> [name for name, _ in foon.names_like("lettu", most=5).foods]
        ['lettuce']
        """
        from foon_kg.model.names import canonical
        from foon_kg.store.graph.overview import names_like

        with self._graph.reading() as view:
            return names_like(view, text, canonical(text) if text else "", state, most)

    def around(self, label: str, most: int) -> AroundObject | None:
        """Return what is around the object ``label``, at most ``most`` of each kind; ``None`` if there is none.

        Units are sorted by where they are seen.

        >>> foon.around("lettuce", most=1).taken_count > 1
        True
        """
        from foon_kg.store.graph.overview import around_label
        from foon_kg.store.graph.values import node_of

        with self._graph.reading() as view:
            there = around_label(view, label, most)
            if there is None:
                return None
            made, taken = view.units_of(there.made), view.units_of(there.taken)
        return AroundObject(
            sorted(map(node_of, there.nodes), key=lambda node: node.sort_key),
            _by_place(made),
            there.made_count,
            _by_place(taken),
            there.taken_count,
            sorted(there.videos),
        )

    def goals(self, dish_type: str) -> tuple[Goal, ...]:
        """Return the goals of a ``dish_type``, sorted by node.

        >>> [goal.node.label for goal in foon.goals("omelette")][:2]
        ['cheese omelette', 'farmhouse omelette']
        """
        with self._graph.reading() as view:
            return view.goals(dish_type)

    def sample(self, most: int) -> Snapshot:
        """Return at most ``most`` videos in memory: the same as long as none of them is taken out.

        >>> len(foon.sample(3).subgraphs)
        3
        """
        from foon_kg.store.graph.overview import some_videos

        with self._graph.reading() as view:
            names = some_videos(view, most)
        return self.of_videos(names)

    def of_videos(self, names: Collection[str]) -> Snapshot:
        """Return those of the videos ``names`` that the graph has, in memory.

        >>> [one.name for one in foon.of_videos(["greek_salad", "not there"]).subgraphs]
        ['greek_salad']
        """
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.store.snapshot import Snapshot

        with self._graph.reading() as view:
            return Snapshot.of(view.subgraphs(names), Kitchen.default())


def _by_place(units: Sequence[KnownUnit]) -> list[KnownUnit]:
    return sorted(units, key=lambda one: (one.seen_in, one.unit.key))
