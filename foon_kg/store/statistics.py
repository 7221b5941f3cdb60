"""How much a FOON holds, in figures."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING

from foon_kg.model.knowledge import MadeBy

if TYPE_CHECKING:
    from foon_kg.store.snapshot import Snapshot

MOST = 10
"""So many motions and states are listed."""


@dataclass(frozen=True)
class Statistics:
    """Counts of a universal FOON; every distinct unit, node and name counts once.

    ``goals`` counts goal nodes by dish type, ``most_used_motions`` units by motion, most first;
    ``most_made_states`` says for the states that the most units make which motion most often makes them.
    """

    videos: int
    units: int
    object_nodes: int
    labels: int
    states: int
    motions: int
    goals: dict[str, int]
    most_used_motions: dict[str, int]
    most_made_states: dict[str, str]

    @classmethod
    def of(cls, foon: Snapshot, most: int = MOST) -> Statistics:
        """Count ``foon``; ``most`` bounds the lists of motions and states. Equal counts are ordered by name."""
        units = [known.unit for known in foon.units]
        nodes = {node for unit in units for node in (*unit.input_nodes, *unit.output_nodes)}
        motions = Counter(unit.motion for unit in units)
        goals = Counter(goal.dish_type for goal in foon.goals())
        return cls(
            videos=len(foon.subgraphs),
            units=len(units),
            object_nodes=len(nodes),
            labels=len({node.label for node in nodes}),
            states=len({state for node in nodes for state in node.states}),
            motions=len(motions),
            goals=most_first(goals),
            most_used_motions=dict(list(most_first(motions).items())[:most]),
            most_made_states=most_made(foon.vocabulary().motions, most),
        )

    def to_json(self) -> dict[str, object]:
        """Return the figures as one JSON object."""
        return asdict(self)


def most_made(motions: Iterable[MadeBy], most: int = MOST) -> dict[str, str]:
    """Return, for the ``most`` states that the most units make, the motion that most often makes them.

    ``motions`` come sorted.
    """
    units: Counter[str] = Counter()
    makers: dict[str, MadeBy] = {}
    for row in motions:  # sorted: of equal counts the first by name stays
        units[row.state] += row.count
        if row.state not in makers or row.count > makers[row.state].count:
            makers[row.state] = row
    states = list(most_first(units))[:most]
    return {state: f"{makers[state].motion}, {makers[state].count} of {units[state]} units" for state in states}


def most_first(counts: Mapping[str, int]) -> dict[str, int]:
    """Return ``counts``, the greatest first; equal ones by name."""
    return dict(sorted(counts.items(), key=lambda item: (-item[1], item[0])))
