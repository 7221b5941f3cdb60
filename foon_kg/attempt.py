"""A tree that was made for one goal, before it is compared with those for other goals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from foon_kg.form import Report
from foon_kg.integration.reenacting import FinalTree, Integration
from foon_kg.model import ObjectNode
from foon_kg.result import PlanResult


@dataclass(frozen=True)
class Attempt:
    """The tree, what the judge says of it, out of what it was made, and which leaves are not at hand."""

    result: PlanResult
    report: Report
    integration: Integration
    tree: FinalTree
    missing: tuple[ObjectNode, ...]

    @property
    def worth(self) -> tuple[float, ...]:
        """What decides between near ties, the lesser the better: overlap, then units, then confidence.

        Overlap counts against a dish too: what it has beside (the bacon of another omelette) nobody asked for. The last
        is how much confidence is lost by substitutions, all in all.
        """
        doubt = sum(1 - substitution.confidence for substitution in self.result.substitutions)
        reference = self.result.reference
        return *prospect(reference.overlap, reference.goal), len(self.result.units), round(doubt, 2)

    def kept(self, videos: Sequence[str]) -> float:
        """Answer the share of the goal's video that is in the tree (sense, S8); of several ``videos`` the greatest."""
        places: dict[str, set[int]] = {video: set() for video in videos}
        for unit in self.result.units:
            for sighting in unit.seen_in:
                if sighting.video in places:
                    places[sighting.video].add(sighting.position)
        return max((len(found) / (max(found) + 1) for found in places.values() if found), default=0.0)


def prospect(overlap: int, goal: ObjectNode) -> tuple[float, float]:
    """Answer how :attr:`Attempt.worth` begins for every tree of ``goal``, whose reference has so much overlap."""
    return -overlap, len(goal.ingredients) - overlap
