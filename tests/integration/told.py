"""FOONs told in the notation of docs/contract.md, as the planner's rooms see them."""

from __future__ import annotations

from collections.abc import Mapping

from foon_kg.integration.teaching.operators import Operators
from foon_kg.model import Annotation, FunctionalUnit, Participant, Subgraph
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot
from foon_kg.validation.notation import read_trees

KITCHEN = Kitchen.default()


def subgraphs(text):
    """Return the videos told in ``text``: trees between lines of ``---``, whose goals are of their dish types."""
    return [_subgraph(tree) for tree in read_trees(text)]


def snapshot_of(*texts):
    """Return the FOON of all videos told in ``texts``."""
    return Snapshot.of([one for text in texts for one in subgraphs(text)], KITCHEN)


def operators_of(*texts):
    """Return the operators of the FOON told in ``texts``."""
    return Operators(snapshot_of(*texts).units)


def _subgraph(tree):
    dish_type = tree.recipe.dish_type if tree.recipe is not None else None
    units = []
    for unit in tree.units:
        marked = [Participant(n, dish_type=dish_type if n == tree.goal else None) for n in unit.output_nodes]
        units.append(FunctionalUnit(tuple(map(Participant, unit.input_nodes)), unit.motion, tuple(marked)))
    return Subgraph(tree.name, tuple(map(Annotation, units)))


class Likes:
    """Who is like whom, told as pairs; all else is quite unlike."""

    def __init__(self, pairs: Mapping[tuple[str, str], float] | None = None) -> None:
        self.pairs = dict(pairs or {})

    def __call__(self, food):
        """Return the foods that stand for one, best first."""
        rows = [(known, sure) for (asked, known), sure in self.pairs.items() if asked == food]
        return sorted(rows, key=lambda row: (-row[1], row[0]))

    def alike(self, food, known):
        """Return how sure it is that one stands for the other."""
        return 1.0 if food == known else self.pairs.get((food, known), 0.1)
