"""From a recipe to a task tree: the four algorithms of the paper, one after the other.

The planner asks a :class:`~foon_kg.knowledge.KnowledgeView` four questions, each one round trip: the words of the
FOON, the goals of the dish type, the units behind the likeliest goals and behind everything that may have to be made
apart, and, only where none of these goals leads to a tree, the units behind the others.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache

from foon_kg.errors import NoTreeError, UsageError
from foon_kg.goals import RankedGoal, rank_goals
from foon_kg.integration import FinalTree, Integration
from foon_kg.kitchen import Kitchen, LeafFault, words
from foon_kg.knowledge import KnowledgeView, Vocabulary
from foon_kg.model import DISH_TYPES, KnownUnit, ObjectNode, Recipe, RequiredIngredient
from foon_kg.outcome import plan_result
from foon_kg.result import PlanResult, ReferenceSummary
from foon_kg.search import ReferenceTree, SearchProblem, UnitIndex, retrieve
from foon_kg.similarity import Similarity, food_similarity
from foon_kg.states import state_similarity
from foon_kg.substitution import Candidate, Equivalents

FIRST_GOALS = 3
"""How many of the likeliest goals are looked behind in the first question."""

_GAP_COSTS = {LeafFault.RUNNING: 10, LeafFault.USED: 10, LeafFault.HELD: 3, LeafFault.PROCESSED: 100, LeafFault.MIXTURE: 1000}
_ODD_PLACE = 1


@dataclass(frozen=True)
class PlanSettings:
    """How to plan: what is at hand, how foods are compared, how long a search may take (seconds)."""

    kitchen: Kitchen = field(default_factory=Kitchen.default)
    similarity: Similarity = field(default_factory=food_similarity)
    time_limit: float | None = 2.0


def plan(view: KnowledgeView, recipe: Recipe, settings: PlanSettings | None = None) -> PlanResult:
    """Answer the task tree that makes ``recipe``.

    Raises :class:`UsageError` for a recipe without ingredients or with an unknown dish type, and
    :class:`NoTreeError` where the FOON has no way to make it; its code says why: ``no-goal``, ``no-way`` or ``left-out``.
    """
    return _Plan(view, recipe, settings or PlanSettings()).run()


def gap_cost(kitchen: Kitchen) -> Callable[[ObjectNode], int | None]:
    """Answer what it costs a search to take a node that is not at hand: odd places least, mixtures most."""

    def cost(node: ObjectNode) -> int | None:
        fault = kitchen.leaf_fault(node)
        return _ODD_PLACE if fault is None else _GAP_COSTS[fault]

    return cost


class _Plan:
    """One recipe being planned from one view."""

    def __init__(self, view: KnowledgeView, recipe: Recipe, settings: PlanSettings) -> None:
        self.view = view
        self.recipe = recipe
        self.settings = settings
        self.kitchen = settings.kitchen
        self.wants = _wants(recipe)
        self.vocabulary = view.vocabulary()
        self.equivalents = _equivalents(self.vocabulary, self.wants, settings)

    def run(self) -> PlanResult:
        ranked = self._ranked_goals()
        foods = sorted({(c.label, c.state) for want in self.wants for c in self.equivalents.candidates(want)})
        best: PlanResult | None = None
        trouble: NoTreeError | None = None
        for number, chunk in enumerate((ranked[:FIRST_GOALS], ranked[FIRST_GOALS:])):
            if not chunk:
                continue
            units = self.view.behind([r.goal.node for r in chunk], foods)
            for goal in chunk:
                try:
                    result, whole = self._for_goal(goal, units)
                except NoTreeError as error:
                    trouble = trouble or error
                    continue
                if whole:
                    return result
                best = best or result
            del number
        if best is not None:
            return best
        raise trouble or NoTreeError(
            f"no way to make this {self.recipe.dish_type} was found", code="no-way", hint="Ask for another dish type."
        )

    def _ranked_goals(self) -> Sequence[RankedGoal]:
        dish_type = self.recipe.dish_type
        if dish_type not in DISH_TYPES:
            close = difflib.get_close_matches(dish_type, DISH_TYPES, n=3)
            hint = f"Did you mean {' or '.join(close)}?" if close else f"Known are {', '.join(DISH_TYPES)}."
            raise UsageError(f"“{dish_type}” is no dish type", hint=hint, code="unknown-dish-type")
        goals = self.view.goals(dish_type)
        if not goals:
            there = ", ".join(self.vocabulary.dish_types) or "none"
            raise NoTreeError(
                f"this FOON has no {dish_type}", code="no-goal", hint=f"It has goals of these dish types: {there}."
            )
        return rank_goals(
            goals,
            self.wants,
            name_confidence=self.equivalents.name_confidence,
            known_foods=frozenset(" ".join(words(row.label)) for row in self.vocabulary.foods),
            dish_type=dish_type,
        )

    def _for_goal(self, ranked: RankedGoal, units: Sequence[KnownUnit]) -> tuple[PlanResult, bool]:
        index = UnitIndex.of(units, at_hand=self.kitchen.has, gap_cost=gap_cost(self.kitchen))
        reference = self._reference(index, ranked)
        tree = Integration(
            reference.units,
            ranked.goal.node,
            self.wants,
            self.equivalents,
            self.kitchen,
            self._deriver(index),
        ).run()
        if not tree.steps:
            raise NoTreeError(
                f"nothing of {ranked.goal.node.label} is left for these ingredients",
                code="left-out",
                hint="Ask for another dish type, or add an ingredient that such a dish has.",
            )
        summary = ReferenceSummary(ranked.goal.node, len(reference.units), reference.overlap, reference.exact)
        result = plan_result(self.recipe, tree, reference.units, summary, self.equivalents, self.kitchen)
        return result, not tree.missing

    def _reference(self, index: UnitIndex, ranked: RankedGoal) -> ReferenceTree:
        wanted: dict[str, int] = {}
        for bit, want in enumerate(self.wants):
            for name in ranked.goal.ingredients:
                if self.equivalents.name_confidence(want.object, name) >= 0.5:  # noqa: PLR2004 - likelier than not
                    wanted.setdefault(name, bit)
        problem = SearchProblem(index, (ranked.goal.node,), wanted=wanted)
        return retrieve(problem, time_limit=self.settings.time_limit)

    def _deriver(self, index: UnitIndex) -> Callable[[Candidate], Sequence[KnownUnit] | None]:
        @cache
        def derive(candidate: Candidate) -> Sequence[KnownUnit] | None:
            targets = tuple(
                node for node in index.nodes if node.label == candidate.label and candidate.state in node.states
            )
            try:
                found = retrieve(SearchProblem(index, targets), time_limit=self.settings.time_limit)
            except NoTreeError:
                return None
            return found.units

        return derive


def _wants(recipe: Recipe) -> tuple[RequiredIngredient, ...]:
    """The distinct required foods in the order of the recipe: a food asked twice in one state is one food."""
    wants = tuple(dict.fromkeys(want for want in recipe.ingredients if want.object))
    if not wants:
        raise UsageError("the recipe names no ingredient", hint="Give at least one, as in “chopped onion”.")
    return wants


def _equivalents(
    vocabulary: Vocabulary, wants: Sequence[RequiredIngredient], settings: PlanSettings
) -> Equivalents:
    labels = sorted({row.label for row in vocabulary.foods})
    objects = sorted({want.object for want in wants})
    matrix = settings.similarity.matrix(objects, labels)
    table = {(o, label): float(matrix[i, j]) for i, o in enumerate(objects) for j, label in enumerate(labels)}

    def name_confidence(required: str, known: str) -> float:
        if required == known:
            return 1.0
        pair = (required, known)
        if pair not in table:
            table[pair] = float(settings.similarity.matrix([required], [known])[0, 0])
        return table[pair]

    return Equivalents(vocabulary, settings.kitchen, name_confidence, state_similarity)
