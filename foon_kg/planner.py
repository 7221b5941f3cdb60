"""From a recipe to a task tree: the four algorithms of the paper, one after the other.

The planner asks a :class:`~foon_kg.knowledge.KnowledgeView` four questions, each one round trip: the words of the
FOON, the goals of the dish type, the units behind the likeliest goals and behind everything that may have to be made
apart, and, only where none of these goals leads to a tree, the units behind more of them.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from foon_kg.avoidance import kitchen_without, names_avoided, why_avoided, without_avoided
from foon_kg.errors import NoTreeError, UsageError
from foon_kg.explanation import Explanation, explanations
from foon_kg.goals import RankedGoal, near_ties, rank_goals
from foon_kg.integration import FinalTree, Integration
from foon_kg.kitchen import Kitchen, words
from foon_kg.knowledge import KnowledgeView
from foon_kg.likeness import Likeness
from foon_kg.model import DISH_TYPES, KnownUnit, ObjectNode, Recipe, RequiredIngredient
from foon_kg.outcome import plan_result, with_progress
from foon_kg.result import PlanResult, ReferenceSummary
from foon_kg.search import ReferenceTree, SearchProblem
from foon_kg.settings import PlanSettings
from foon_kg.shortage import nearest_first, shortage
from foon_kg.submission import submitted
from foon_kg.substitution import FAIR, Equivalents
from foon_kg.validation import CONTRACT, KnownFoon, Report, check
from foon_kg.workshop import Workshop

MOST_GOALS = 6
"""How many trees are made and compared, where none of them is without a fault."""

KEPT = 0.3
"""How much of the goal's video should be in the tree (sense, S8)."""

MOST_REPAIRS = 4
"""How often a tree of one goal is made anew without the choices in which the judge found a fault."""

_REPAIRED = frozenset({*CONTRACT, "S1", "S2", "S7"})
_ASKED_OF_THE_JUDGE = frozenset({"S1", "S2", "S4", "S5", "S7"})

FIRST_GOALS = 3
"""How many of the likeliest goals are looked behind in the first question, and are tried where they are near ties."""


def plan(view: KnowledgeView, recipe: Recipe, settings: PlanSettings | None = None) -> PlanResult:
    """Answer the task tree that makes ``recipe``.

    A recipe without a dish type (``""``) may become a dish of any; the answer says which. Raises :class:`UsageError`
    for a recipe without ingredients or with an unknown dish type, and :class:`NoTreeError` where the FOON has no way to
    make it; the code is ``no-goal``, ``no-way``, ``left-out``, ``avoided`` or ``missing``.
    """
    return Planner(view, settings or PlanSettings()).plan(recipe)


class Planner:
    """Plans recipes from one view.

    For many recipes give ``units``, all of the FOON: they are numbered once, and what was derived for one recipe
    serves the next. Without them each plan asks the view for just the units behind its goals and foods.
    """

    def __init__(self, view: KnowledgeView, settings: PlanSettings, units: Sequence[KnownUnit] | None = None) -> None:
        self.view = view
        self.settings = settings
        self.vocabulary = view.vocabulary()
        self.likeness = Likeness(settings.similarity, self.vocabulary, settings.substitutes)
        self.whole = None if units is None else Workshop(units, view.goals(), settings, self.vocabulary)
        self._equivalents: list[Equivalents] = []

    @cached_property
    def known_foods(self) -> frozenset[str]:
        """Answer the foods of the FOON, each word in the singular."""
        return frozenset(" ".join(words(label)) for label in self.vocabulary.rows_of)

    def equivalents_for(self, foods: Sequence[str]) -> Equivalents:
        """Answer what the FOON's words stand for in the kitchen of a recipe that asks for ``foods``.

        Recipes with equal kitchens share it, and so what was worked out in it.
        """
        # water that is asked is taken once, for the dish, and not for washing beside it (sense, S4)
        kitchen = kitchen_without(self.settings.kitchen, (*self.settings.avoided, *foods)).with_foods(foods)
        self.likeness.learn(foods)
        known = next((e for e in self._equivalents if _same_kitchen(e.kitchen, kitchen)), None)
        if known is None:
            like = self.settings.state_similarity
            motions = self.settings.rules.motions
            known = Equivalents(self.vocabulary, kitchen, self.likeness, like, self.likeness.own, motions)
            self._equivalents.append(known)
        return known

    def plan(self, recipe: Recipe) -> PlanResult:
        """Answer the task tree that makes ``recipe``; raises as :func:`plan` does."""
        return _Question(self, recipe).answer()

    def reference_question(self, recipe: Recipe) -> tuple[RankedGoal, SearchProblem]:
        """Answer the goal that is most like ``recipe`` (algorithm 1), and what algorithm 3 is asked about it."""
        return _Question(self, recipe).reference_question()

    def reference_tree(self, recipe: Recipe, goal: ObjectNode) -> tuple[KnownUnit, ...]:
        """Answer the reference tree of ``goal`` for ``recipe``, as it was recorded: what a plan begins with.

        Raises UsageError where ``goal`` is no goal for this recipe in this FOON.
        """
        return _Question(self, recipe).reference_tree(goal)

    def explain(self, recipe: Recipe) -> tuple[PlanResult, tuple[Explanation, ...]]:
        """Answer the tree, and why every required food is made as it is; raises as :func:`plan` does."""
        return _Question(self, recipe).explained()


@dataclass(frozen=True)
class _Attempt:
    """A tree for one goal, what the judge says of it, out of what it was made, and which leaves are not at hand."""

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
        overlap = self.result.reference.overlap
        unasked = len(self.result.reference.goal.ingredients) - overlap
        return -overlap, unasked, len(self.result.units), round(doubt, 2)


class _Question:
    """One recipe being planned."""

    def __init__(self, planner: Planner, recipe: Recipe) -> None:
        self.planner = planner
        self.settings = planner.settings
        self.recipe, _ = without_avoided(recipe, self.settings.avoided)
        self.wants = _wants(self.recipe)
        self.equivalents = planner.equivalents_for([want.object for want in self.wants])
        self.kitchen = self.equivalents.kitchen
        self.vocabulary = planner.vocabulary
        self._near = 1

    def answer(self) -> PlanResult:
        """Answer the best tree, with its progress lines."""
        return with_progress(self._best().result, self.kitchen)

    def reference_question(self) -> tuple[RankedGoal, SearchProblem]:
        """Answer the likeliest goal, and the search for its reference tree."""
        ranked, workshop = next(self._goals_to_try())
        return ranked, SearchProblem(workshop.index, (ranked.goal.node,), wanted=self._wanted(ranked))

    def reference_tree(self, goal: ObjectNode) -> tuple[KnownUnit, ...]:
        """Answer the units of the reference tree of ``goal``."""
        for ranked, workshop in self._goals_to_try():
            if ranked.goal.node == goal:
                return workshop.script(workshop.reference(goal, self._wanted(ranked)), ranked.goal.videos)
        raise UsageError(
            f"this FOON has no goal {goal} for {self._dish}", hint="Give the FOON of the plan with --files."
        )

    def explained(self) -> tuple[PlanResult, tuple[Explanation, ...]]:
        """Answer the best tree, and why it is as it is."""
        best = self._best()
        return with_progress(best.result, self.kitchen), explanations(best.tree, best.integration)

    def _best(self) -> _Attempt:
        """Try the goals, likeliest first, until one gives a tree without a fault; of near ties all (docs/ties.md)."""
        found: list[tuple[tuple[float, ...], _Attempt]] = []
        trouble: NoTreeError | None = None
        for place, (ranked, workshop) in enumerate(self._goals_to_try()):
            try:
                attempt = self._for_goal(ranked, workshop)
            except NoTreeError as error:
                trouble = trouble or error
            else:
                near = (0, *attempt.worth) if place < self._near else (place,)
                found.append(((len(attempt.missing), *self._faults(attempt, ranked), *near, place), attempt))
            if found and place + 1 >= self._near and self._suffices(found):
                break
        if found:
            _, best = min(found, key=lambda row: row[0])
            if best.missing:
                raise shortage(best.missing, best.result.goal, self.kitchen, self.planner.likeness.own)
            if not best.report.sound:
                raise self._refusal(best.report)
            return best
        raise trouble or NoTreeError(
            f"no way to make {self._dish} was found", code="no-way", hint="Ask for another dish type."
        )

    @property
    def _dish(self) -> str:
        return f"this {self.recipe.dish_type}" if self.recipe.dish_type else "any dish of these"

    @staticmethod
    def _suffices(found: Sequence[tuple[tuple[float, ...], _Attempt]]) -> bool:
        """Whether no further goal need be tried: there is a tree without a fault, or many whose leaves are there."""
        faults = [rank[:3] for rank, _ in found]
        return not any(min(faults)) or (len(found) >= MOST_GOALS and not min(faults)[0])

    def _refusal(self, report: Report) -> NoTreeError:
        """Say why even the best tree is none: no tree that breaks the contract is ever answered."""
        return NoTreeError(
            f"no tree for {self._dish} keeps the contract: {report.of(CONTRACT)[0]}",
            code="no-way",
            hint="Leave this ingredient out or ask for it in another state, or ask for another dish type.",
        )

    def _goals_to_try(self) -> Iterator[tuple[RankedGoal, Workshop]]:
        ranked = self._ranked_goals()
        self._near = min(near_ties(ranked), FIRST_GOALS) if self.settings.rules.ties else 1
        if self.planner.whole is not None:
            yield from ((goal, self.planner.whole) for goal in ranked)
            return
        view, foods = self.planner.view, sorted({f for want in self.wants for f in self.equivalents.makings(want)})
        for chunk in _in_growing_chunks(ranked):
            units = view.behind([r.goal.node for r in chunk], foods)
            workshop = Workshop(units, [r.goal for r in ranked], self.settings, self.vocabulary, memory=view.memory)
            yield from ((goal, workshop) for goal in chunk)

    def _ranked_goals(self) -> Sequence[RankedGoal]:
        dish_type = self.recipe.dish_type
        if dish_type and dish_type not in DISH_TYPES:
            close = difflib.get_close_matches(dish_type, DISH_TYPES, n=3)
            hint = f"Did you mean {' or '.join(close)}?" if close else f"Known are {', '.join(DISH_TYPES)}."
            raise UsageError(f"“{dish_type}” is no dish type", hint=hint, code="unknown-dish-type")
        goals = self.planner.view.goals(dish_type or None)
        if not goals:
            there = ", ".join(self.vocabulary.dish_types) or "none"
            raise NoTreeError(
                f"this FOON has no {dish_type or 'dish'}",
                code="no-goal",
                hint=f"It has goals of these dish types: {there}.",
            )
        fitting = [goal for goal in goals if why_avoided(goal.node.label, self.settings.avoided) is None]
        if not fitting:
            raise self._avoided(goals[0].node.label, goals[0].node.label)
        return rank_goals(
            fitting,
            self.wants,
            name_confidence=self.equivalents.name_confidence,
            known_foods=self.planner.known_foods,
            dish_type=dish_type or None,
        )

    def _for_goal(self, ranked: RankedGoal, workshop: Workshop) -> _Attempt:
        goal = ranked.goal.node
        reference = workshop.reference(goal, self._wanted(ranked))
        script = workshop.script(reference, ranked.goal.videos)
        preparations = workshop.preparations(self.equivalents)
        joins_alike = self.settings.rules.joining
        integration = Integration(
            script, goal, self.wants, self.equivalents, self.kitchen, preparations, joins_alike=joins_alike
        )
        best = attempt = self._judged(integration, ranked, reference, workshop.foon)
        for _ in range(MOST_REPAIRS):
            blamed = attempt.integration.blamed(attempt.tree, attempt.report.of(_REPAIRED)) - integration.refused
            if not blamed:
                break
            integration = replace(integration, refused=integration.refused | blamed)
            attempt = self._judged(integration, ranked, reference, workshop.foon)
            best = min(best, attempt, key=lambda other: self._faults(other, ranked))
        return best

    def _judged(
        self, integration: Integration, ranked: RankedGoal, reference: ReferenceTree, foon: KnownFoon
    ) -> _Attempt:
        goal, tree = integration.goal, integration.run()
        if not tree.steps:
            raise NoTreeError(
                f"nothing of {goal.label} is left for these ingredients",
                code="left-out",
                hint="Ask for another dish type, or add an ingredient that such a dish has.",
            )
        summary = ReferenceSummary(goal, len(reference.units), reference.overlap, reference.exact)
        recipe = replace(self.recipe, dish_type=self.recipe.dish_type or ranked.goal.dish_type)
        result = plan_result(recipe, tree, reference.units, summary, equivalents=self.equivalents, kitchen=self.kitchen)
        self._refuse_avoided(result)
        report = check(submitted(result), foon, self.kitchen)
        return _Attempt(result, report, integration, tree, self._missing(result))

    def _missing(self, result: PlanResult) -> tuple[ObjectNode, ...]:
        """Answer the leaves that are not in the kitchen that a person named, nearest to the goal first."""
        lacking = [node for node in result.kitchen if self.kitchen.lacks(node)]
        units = [(unit.input_nodes, unit.output_nodes) for unit in result.units]
        return nearest_first(lacking, units, result.goal) if lacking else ()

    def _refuse_avoided(self, result: PlanResult) -> None:
        """Raise :class:`NoTreeError` for a tree that names an avoided food, be it only as what a mixture is called."""
        nodes = (node for unit in result.units for node in (*unit.input_nodes, *unit.output_nodes))
        node = next((node for node in nodes if names_avoided(node, self.settings.avoided)), None)
        if node is not None:
            raise self._avoided(result.goal.label, node.label)

    def _avoided(self, goal: str, food: str) -> NoTreeError:
        return NoTreeError(
            f"the {goal} of this FOON names {food}, which is to be avoided",
            code="avoided",
            hint="Ask for another dish type, or avoid less.",
        )

    def _faults(self, attempt: _Attempt, ranked: RankedGoal) -> tuple[int, int]:
        """Answer how many rules of the contract and how many measures of sense are broken.

        The judge is asked only what the units behind the goal can answer, so that a plan from the whole FOON and one
        from just these units choose alike; whether the dish is truly named (S6) is known from the ranking, and how
        much of the video is kept (S8) from the place of its last unit. A person who chose an equivalent is not told
        that it is too unlike (S5).
        """
        broken = set(attempt.report.broken)
        sense = broken & _ASKED_OF_THE_JUDGE - ({"S5"} if self.settings.substitutes else set())
        return len(broken & set(CONTRACT)), len(sense) + bool(ranked.misnamed) + (_kept(attempt.result, ranked) < KEPT)

    def _wanted(self, ranked: RankedGoal) -> dict[str, int]:
        """Which ingredients of the goal may play which required food, by number: what counts as overlap."""
        wanted: dict[str, int] = {}
        for number, want in enumerate(self.wants):
            for name in ranked.goal.ingredients:
                if self.equivalents.name_confidence(want.object, name) >= FAIR:
                    wanted.setdefault(name, number)
        return wanted


def _same_kitchen(one: Kitchen, other: Kitchen) -> bool:
    """Whether two kitchens of one planner are the same: recipes may differ in no more than this."""
    return one.free_foods == other.free_foods and one.utensils == other.utensils


def _in_growing_chunks(ranked: Sequence[RankedGoal]) -> Iterator[Sequence[RankedGoal]]:
    """Answer the goals in chunks to look behind in one question each; there may be thousands, and few are needed."""
    start, size = 0, FIRST_GOALS
    while start < len(ranked):
        yield ranked[start : start + size]
        start, size = start + size, size * 2


def _wants(recipe: Recipe) -> tuple[RequiredIngredient, ...]:
    """Answer the distinct required foods in the order of the recipe: asked twice in one state is asked once."""
    wants = tuple(dict.fromkeys(want for want in recipe.ingredients if want.object))
    if not wants:
        raise UsageError("the recipe names no ingredient", hint="Give at least one, as in “chopped onion”.")
    return wants


def _kept(result: PlanResult, ranked: RankedGoal) -> float:
    """Answer the share of the goal's video that is in the tree (sense, S8); of several videos the greatest."""
    places: dict[str, set[int]] = {video: set() for video in ranked.goal.videos}
    for unit in result.units:
        for sighting in unit.seen_in:
            if sighting.video in places:
                places[sighting.video].add(sighting.position)
    return max((len(found) / (max(found) + 1) for found in places.values() if found), default=0.0)
