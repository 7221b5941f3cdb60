"""Algorithms 1 to 3 of the paper: the goal node, the similarity of ingredient lists, the reference task tree."""

from __future__ import annotations

import math
import operator
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from foon_kg.model import FunctionalUnit, Goal, KnownUnit, ObjectNode
from foon_kg.model.errors import NoTreeError
from foon_kg.model.knowledge import Vocabulary
from foon_kg.plans.kitchen import Kitchen
from foon_kg.search import ReferenceTree, SearchProblem, UnitIndex, enumerate_paths
from foon_kg.search.core import core_behind
from foon_kg.search.forward import chain
from foon_kg.search.landmarks import landmarks_of
from foon_kg.similarity import Similarity, count_similar

SIMILAR = 0.90
"""Two ingredients are the same to the paper where the cosine of their vectors is greater (algorithm 2)."""

MOST_PATHS = 200
"""How many combinations of producers are looked at. Goals of the public FOON have many millions; of 5,000 the best
tree is hardly shorter, and covers no more."""


@dataclass(frozen=True)
class Knowledge:
    """What trees are made from: the units of FOON, the kitchen, the words and their similarity. Use :meth:`of`."""

    index: UnitIndex
    kitchen: Kitchen
    vocabulary: Vocabulary
    similarity: Similarity

    @classmethod
    def of(
        cls, units: Iterable[KnownUnit], kitchen: Kitchen, vocabulary: Vocabulary, similarity: Similarity
    ) -> Knowledge:
        """Return the knowledge with ``units`` numbered, and with the leaves at which a search ends.

        ``vocabulary`` has the words of the units, ``similarity`` compares them. The paper leaves open what a leaf is.
        Here: what the ``kitchen`` has, what no unit makes, and what units make only out of each other, in a circle.
        """
        known = tuple(units)
        made = {node for one in known for node in one.unit.output_nodes}
        index = UnitIndex.of(known, at_hand=lambda node: kitchen.has(node) or node not in made)
        in_circles = (cost == math.inf for cost in index.least_penalties)
        at_hand = tuple(map(operator.or_, index.at_hand, in_circles))
        return cls(replace(index, at_hand=at_hand), kitchen, vocabulary, similarity)


def compute_similarity(required: Sequence[str], known: Sequence[str], similarity: Similarity) -> int:
    """Return how many pairs (i, j) of ``required`` and ``known`` have a ``similarity`` over 0.90 (algorithm 2)."""
    return count_similar(required, known, similarity, threshold=SIMILAR)


def identify_goal_node(goals: Sequence[Goal], required: Sequence[str], similarity: Similarity) -> Goal:
    """Return the one of ``goals`` whose ingredient list is the most similar to ``required`` (algorithm 1).

    ``similarity`` counts the pairs by algorithm 2. The paper leaves ties open: the first of ``goals``, which are sorted
    by node, is taken. There is at least one.
    """
    return max(goals, key=lambda goal: compute_similarity(required, goal.ingredients, similarity))


def retrieve_reference_task_tree(
    knowledge: Knowledge, goal: ObjectNode, required: Sequence[str], most_paths: int
) -> ReferenceTree:
    """Return, of all paths of ``knowledge`` that make ``goal``, the one of greatest overlap, then of fewest units.

    This is algorithm 3 of Sakib et al. A path chooses one producer for every object that is needed. Of the producers of
    an object those that overlap nothing ``required`` are pruned; where none overlaps (an oven is turned on) the paper
    leaves open what is done: all are kept. A tree overlaps a required food where it has an object similar to it, a unit
    also where it only names one as an ingredient. Producers of more similar pairs, then of fewer inputs, come first in
    the product. The tree is ``exact`` where all paths were looked at.

    Raises NoTreeError where none of the first ``most_paths`` combinations of producers is a tree.
    """
    paths = None
    if goal in knowledge.index.number_of:
        paths = enumerate_paths(_overlapping(knowledge, goal, required), limit=most_paths)
    if paths is not None and paths.found:
        return paths.first(1)[0]
    if paths is None or paths.complete:
        raise NoTreeError(f"nothing makes {goal} without it", code="no-way", hint="Ask for another dish type.")
    raise NoTreeError(f"none of the first {most_paths} paths makes {goal}", code="too-many", hint="Look at more paths.")


def _overlapping(knowledge: Knowledge, goal: ObjectNode, required: Sequence[str]) -> SearchProblem:
    """Return the problem to make ``goal`` of the producers in ``knowledge`` that overlap what is ``required``."""
    foods = [_foods_of(known.unit, knowledge.kitchen) for known in knowledge.index.units]
    names, asked = sorted(set[str]().union(*foods)), list(dict.fromkeys(required))
    alike = knowledge.similarity.matrix(asked, names) > SIMILAR
    pairs = dict(zip(names, alike.sum(axis=0).tolist(), strict=True))
    wanted = {name: int(alike[:, place].argmax()) for place, name in enumerate(names) if pairs[name]}
    overlaps = [sum(pairs[name] for name in some) for some in foods]
    return _pruned(SearchProblem(knowledge.index, (goal,), wanted), overlaps)


def _foods_of(unit: FunctionalUnit, kitchen: Kitchen) -> set[str]:
    """Return the foods that a unit names, as objects or as their ingredients."""
    names = (name for node in (*unit.input_nodes, *unit.output_nodes) for name in (node.label, *node.ingredients))
    return {name for name in names if not kitchen.is_utensil(name)}


def _pruned(problem: SearchProblem, overlaps: Sequence[int]) -> SearchProblem:
    """Return ``problem`` with only the candidates for its target, and for what that needs, among the producers.

    A producer that cannot be carried out before its own product is there is no candidate: it is in no tree, and real
    FOONs are full of them.
    """
    index = problem.index
    core = core_behind(problem, index.number_of[problem.targets[0]])
    order, _ = chain(core)
    needed = landmarks_of(core, order).nodes_of_step
    candidates: list[list[int]] = [[] for _ in index.nodes]
    for step in order:
        for node in core.outputs[step]:
            if not needed[step] >> node & 1:
                candidates[core.nodes[node]].append(core.units[step])
    for node, units in enumerate(candidates):
        kept = [unit for unit in units if overlaps[unit]] or units
        candidates[node] = sorted(kept, key=lambda unit: (-overlaps[unit], len(index.inputs[unit]), unit))
    return replace(problem, index=replace(index, producers=tuple(map(tuple, candidates))))
