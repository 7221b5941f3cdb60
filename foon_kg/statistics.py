"""How much a FOON holds, in figures."""

from __future__ import annotations

from collections import Counter
from dataclasses import asdict, dataclass

from foon_kg.knowledge import MadeBy, Vocabulary
from foon_kg.snapshot import Snapshot


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
    def of(cls, foon: Snapshot, most: int = 10) -> Statistics:
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
            goals=_most_first(goals),
            most_used_motions=dict(list(_most_first(motions).items())[:most]),
            most_made_states=_most_made(foon.vocabulary(), most),
        )

    def to_json(self) -> dict[str, object]:
        """Answer the figures as one JSON object."""
        return asdict(self)


def _most_made(words: Vocabulary, most: int) -> dict[str, str]:
    units: Counter[str] = Counter()
    makers: dict[str, MadeBy] = {}
    for row in words.motions:  # sorted: of equal counts the first by name stays
        units[row.state] += row.count
        if row.state not in makers or row.count > makers[row.state].count:
            makers[row.state] = row
    states = list(_most_first(units))[:most]
    return {state: f"{makers[state].motion}, {makers[state].count} of {units[state]} units" for state in states}


def _most_first(counts: Counter[str]) -> dict[str, int]:
    return dict(sorted(counts.items(), key=lambda item: (-item[1], item[0])))
