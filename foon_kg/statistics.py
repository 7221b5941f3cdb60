"""How much a FOON holds, in figures."""

from __future__ import annotations

from collections import Counter
from dataclasses import asdict, dataclass

from foon_kg.snapshot import Snapshot


@dataclass(frozen=True)
class Statistics:
    """Counts of a universal FOON; every distinct unit, node and name counts once.

    ``goals`` counts goal nodes by dish type, ``most_used_motions`` units by motion, most first.
    """

    videos: int
    units: int
    object_nodes: int
    labels: int
    states: int
    motions: int
    goals: dict[str, int]
    most_used_motions: dict[str, int]

    @classmethod
    def of(cls, foon: Snapshot, most: int = 10) -> Statistics:
        """Count ``foon``; ``most`` bounds the list of motions. Equal counts are ordered by name."""
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
            goals=_most_first(goals),
            most_used_motions=dict(list(_most_first(motions).items())[:most]),
        )

    def to_json(self) -> dict[str, object]:
        """Answer the figures as one JSON object."""
        return asdict(self)


def _most_first(counts: Counter[str]) -> dict[str, int]:
    return dict(sorted(counts.items(), key=lambda item: (-item[1], item[0])))
