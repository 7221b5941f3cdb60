"""One recipe being planned: which goals are tried, and which of their trees is answered."""

from __future__ import annotations

import difflib
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING

from foon_kg.attempt import Attempt, prospect
from foon_kg.avoidance import kitchen_without, names_avoided, why_avoided, without_avoided
from foon_kg.carriers import Carriers, blamed, carried
from foon_kg.errors import NoTreeError, UsageError
from foon_kg.explanation import Explanation, explanations
from foon_kg.form import CONTRACT, KnownFoon, Report, check
from foon_kg.goals.ranking import RankedGoal, likeliest, near_ties, rank_goals
from foon_kg.integration.reenacting import FinalTree, Integration
from foon_kg.knowledge import LikelyGoals, Vocabulary
from foon_kg.likeness import Likeness
from foon_kg.model import DISH_TYPES, Goal, KnownUnit, ObjectNode, Recipe, RequiredIngredient
from foon_kg.outcome import plan_result, with_progress
from foon_kg.repairs import best_of
from foon_kg.result import PlanResult, ReferenceSummary
from foon_kg.search import ReferenceTree, SearchProblem
from foon_kg.shortage import nearest_first, shortage
from foon_kg.submission import submitted
from foon_kg.substitution import FAIR
from foon_kg.workshop import Workshop

if TYPE_CHECKING:
    from foon_kg.planner import Planner

MOST_TRIES = 3
"""How often foods are brought by steps of their own, without those at which the judge found a fault before."""

MOST_GOALS = 6
"""How many trees are made and compared, where none of them is without a fault."""

MOST_LACKING = 24
"""How many trees are made while each lacks something of the kitchen that a person named. Where that has a wanted food
in no state every tree lacks it, and ``MOST_GOALS`` of them tell what else is missing."""

KEPT = 0.3
"""How much of the goal's video should be in the tree (sense, S8)."""

_ASKED_OF_THE_JUDGE = frozenset({"S1", "S2", "S4", "S5", "S7"})

FIRST_GOALS = 3
"""How many of the likeliest goals are looked behind in the first question, and are tried where they are near ties."""


class Question:
    """One recipe being planned, with the words, the kitchen and the likeness of foods that a planner has for it."""

    def __init__(self, planner: Planner, recipe: Recipe, *, all_words: bool = False) -> None:
        self.planner = planner
        self.settings = planner.settings
        self.recipe, _ = without_avoided(recipe, self.settings.avoided)
        self.wants = _wants(self.recipe)
        self.foods = [want.object for want in self.wants]
        self.kitchen = planner.kitchen_for(self.foods)
        self.in_parts = planner.asks_for_parts and not all_words
        vocabulary = planner.view.words_for(self.foods) if self.in_parts else planner.vocabulary
        self.likeness = Likeness(self.settings.similarity, vocabulary) if self.in_parts else planner.likeness
        self._learn(vocabulary)
        self._near = 1

    def _learn(self, vocabulary: Vocabulary, known: Collection[str] = ()) -> None:
        """Go on with ``vocabulary``, and with how like ``known`` names are to the wanted foods."""
        self.vocabulary = vocabulary
        self.likeness.learn(self.foods, known)
        self.equivalents = self.planner.equivalents(vocabulary, self.likeness, self.kitchen)

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

    def _best(self) -> Attempt:
        """Try the goals, likeliest first, until one gives a tree without a fault; near ties: docs/ties.md."""
        found: list[tuple[tuple[float, ...], Attempt, RankedGoal, Workshop]] = []
        troubles: list[tuple[int, NoTreeError]] = []
        for place, hope, ranked, workshop in self._by_prospect():
            if found and self._suffices([row[0] for row in found], hope):
                break
            try:
                attempt = self._for_goal(ranked, workshop)
            except NoTreeError as error:
                troubles.append((place, error))
            else:
                near = (place,) if hope is None else (0, *attempt.worth)
                rank = (len(attempt.missing), *self._faults(attempt, ranked), *near, place)
                found.append((rank, attempt, ranked, workshop))
        if found:
            _, best, ranked, workshop = min(found, key=lambda row: row[0])
            if best.missing:
                raise shortage(best.missing, best.result.goal, self.kitchen, self.likeness.own)
            if not best.report.sound:
                raise self._refusal(best.report)
            return self._carried(best, ranked, workshop) if self.settings.rules.carriers else best
        raise min(troubles, key=lambda row: row[0], default=(0, self._no_way))[1]

    def _carried(self, best: Attempt, ranked: RankedGoal, workshop: Workshop) -> Attempt:
        """Answer the tree in which foods join by steps of their own, where the judge finds no more fault with it."""
        if not best.tree.additions:
            return best
        goal, faults = ranked.goal.node, self._faults(best, ranked)
        foods = {food for want in self.wants for food in self.equivalents.makings(want)}
        carriers = Carriers.of(workshop.behind(goal, foods), workshop.kitchen, self.planner.carriers)
        like, bare = self.equivalents.name_confidence, frozenset[ObjectNode]()
        for _ in range(MOST_TRIES):
            tree = carried(best.tree, carriers, like, self.kitchen, bare)
            if tree.steps == best.tree.steps:
                break
            reference = workshop.reference(goal, self._wanted(ranked))
            attempt = self._attempt(best.integration, tree, ranked=ranked, reference=reference, foon=workshop.foon)
            if (len(attempt.missing), *self._faults(attempt, ranked)) <= (0, *faults):
                return attempt
            places = (finding.unit for finding in attempt.report.findings if finding.unit is not None)
            found = blamed(tree, places) - bare
            if not found:
                break
            bare |= found
        return best

    def _by_prospect(self) -> Iterator[tuple[int, tuple[float, ...] | None, RankedGoal, Workshop]]:
        """Answer the goals to try with their places: near ties before the others, and with what speaks for each.

        That is how what decides between their trees begins; those come first for which most speaks.
        """
        goals = enumerate(self._goals_to_try())
        near = [*islice(goals, 1)]
        near += islice(goals, max(self._near - 1, 0))
        if len(near) > 1:
            yield from sorted(
                ((place, self._prospect(*goal), *goal) for place, goal in near), key=lambda row: (row[1], row[0])
            )
        else:
            yield from ((place, (), *goal) for place, goal in near)
        yield from ((place, None, *goal) for place, goal in goals)

    def _prospect(self, ranked: RankedGoal, workshop: Workshop) -> tuple[float, ...]:
        try:
            reference = workshop.reference(ranked.goal.node, self._wanted(ranked))
        except NoTreeError:
            return ()  # it is tried, to be told why there is none
        return prospect(reference.overlap, ranked.goal.node)

    @property
    def _dish(self) -> str:
        return f"this {self.recipe.dish_type}" if self.recipe.dish_type else "any dish of these"

    @property
    def _may_have_all(self) -> bool:
        """Whether the kitchen may have every food that is asked for."""
        return all(map(self.kitchen.may_have, self.foods))

    def _suffices(self, ranks: Sequence[tuple[float, ...]], hope: tuple[float, ...] | None) -> bool:
        """Whether the next goal need not be tried: there is a tree without a fault, or many whose leaves are there.

        A near tie is tried all the same while what speaks for it (``hope``) is no worse than what does for the best.
        """
        best = min(ranks)
        if hope is not None:
            return not any(best[:3]) and hope > best[4 : 4 + len(hope)]
        enough = MOST_LACKING if best[0] and self._may_have_all else MOST_GOALS
        return not any(best[:3]) or len(ranks) >= enough

    @property
    def _no_way(self) -> NoTreeError:
        return NoTreeError(f"no way to make {self._dish} was found", code="no-way", hint="Ask for another dish type.")

    def _refusal(self, report: Report) -> NoTreeError:
        """Say why even the best tree is none: no tree that breaks the contract is ever answered."""
        return NoTreeError(
            f"no tree for {self._dish} keeps the contract: {report.of(CONTRACT)[0]}",
            code="no-way",
            hint="Leave this ingredient out or ask for it in another state, or ask for another dish type.",
        )

    def _goals_to_try(self) -> Iterator[tuple[RankedGoal, Workshop]]:
        """Answer the goals, likeliest first; they are looked behind a chunk at a time, and few are needed."""
        start, size = 0, FIRST_GOALS
        ranked = self._ranked_goals(size)
        self._near = min(near_ties(ranked), FIRST_GOALS) if self.settings.rules.ties else 1
        if self.planner.whole is not None:
            yield from ((goal, self.planner.whole) for goal in ranked)
            return
        while chunk := ranked[start : start + size]:
            workshop = self._workshop(chunk, [r.goal for r in ranked])
            yield from ((goal, workshop) for goal in chunk)
            start, size = start + size, size * 2
            ranked = self._ranked_goals(start + size)

    def _workshop(self, chunk: Sequence[RankedGoal], goals: Sequence[Goal]) -> Workshop:
        """Answer where trees for ``chunk`` are made: among the units behind them and behind all that is made apart."""
        view, foods = self.planner.view, sorted({f for want in self.wants for f in self.equivalents.makings(want)})
        units = view.behind([r.goal.node for r in chunk], foods)
        if self.in_parts:
            nodes = {node for known in units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
            names = {name for node in nodes for name in (node.label, *node.ingredients)}
            self._learn(view.words_in(units, self.vocabulary), sorted(names))
        return Workshop(units, goals, self.settings, self.vocabulary, memory=view.memory)

    def _ranked_goals(self, least: int) -> Sequence[RankedGoal]:
        """Answer the goals from the most to the least like the recipe: the first ``least`` of them at least, or all."""
        dish_type = self.recipe.dish_type
        if dish_type and dish_type not in DISH_TYPES:
            close = difflib.get_close_matches(dish_type, DISH_TYPES, n=3)
            hint = f"Did you mean {' or '.join(close)}?" if close else f"Known are {', '.join(DISH_TYPES)}."
            raise UsageError(f"“{dish_type}” is no dish type", hint=hint, code="unknown-dish-type")
        return likeliest(self._likely_goals, self._ranked, least)

    def _likely_goals(self, count: int) -> LikelyGoals:
        dish_type = self.recipe.dish_type or None
        if self.in_parts:
            likely = self.planner.view.likely_goals(dish_type, self.foods, count)
        else:
            likely = LikelyGoals(self.planner.view.goals(dish_type), self.planner.known_foods)
        if likely.goals or likely.most is not None:
            return likely
        there = ", ".join(self.vocabulary.dish_types) or "none"
        raise NoTreeError(
            f"this FOON has no {dish_type or 'dish'}",
            code="no-goal",
            hint=f"It has goals of these dish types: {there}.",
        )

    def _ranked(self, likely: LikelyGoals) -> Sequence[RankedGoal]:
        goals = likely.goals
        fitting = [goal for goal in goals if why_avoided(goal.node.label, self.settings.avoided) is None]
        if goals and not fitting:
            raise self._avoided(goals[0].node.label, goals[0].node.label)
        self.likeness.learn(self.foods, sorted({name for goal in fitting for name in goal.ingredients}))
        return rank_goals(
            fitting,
            self.wants,
            name_confidence=self.equivalents.name_confidence,
            known_foods=likely.known_foods,
            dish_type=self.recipe.dish_type or None,
        )

    def _for_goal(self, ranked: RankedGoal, workshop: Workshop) -> Attempt:
        goal = ranked.goal.node
        reference = workshop.reference(goal, self._wanted(ranked))
        judge = partial(self._judged, ranked=ranked, reference=reference, foon=workshop.foon)
        integrations = (self._integration(s, goal, workshop) for s in _scripts(workshop, reference, ranked.goal))
        return best_of(integrations, judge, partial(self._faults, ranked=ranked))

    def _integration(self, script: tuple[KnownUnit, ...], goal: ObjectNode, workshop: Workshop) -> Integration:
        preparations, joins_alike = workshop.preparations(self.equivalents), self.settings.rules.joining
        return Integration(
            script, goal, self.wants, self.equivalents, self.kitchen, preparations, joins_alike=joins_alike
        )

    def _judged(
        self, integration: Integration, *, ranked: RankedGoal, reference: ReferenceTree, foon: KnownFoon
    ) -> Attempt:
        goal, tree = integration.goal, integration.run()
        if not tree.steps:
            raise NoTreeError(
                f"nothing of {goal.label} is left for these ingredients",
                code="left-out",
                hint="Ask for another dish type, or add an ingredient that such a dish has.",
            )
        return self._attempt(integration, tree, ranked=ranked, reference=reference, foon=foon)

    def _attempt(
        self,
        integration: Integration,
        tree: FinalTree,
        *,
        ranked: RankedGoal,
        reference: ReferenceTree,
        foon: KnownFoon,
    ) -> Attempt:
        goal = integration.goal
        summary = ReferenceSummary(goal, len(reference.units), reference.overlap, reference.exact)
        recipe = replace(self.recipe, dish_type=self.recipe.dish_type or ranked.goal.dish_type)
        result = plan_result(recipe, tree, reference.units, summary, equivalents=self.equivalents, kitchen=self.kitchen)
        self._refuse_avoided(result)
        # as the judge sees it who knows only the answer: what is free does not turn on the recipe
        report = check(submitted(result), foon, kitchen_without(self.settings.kitchen, self.settings.avoided))
        return Attempt(result, report, integration, tree, self._missing(result))

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

    def _faults(self, attempt: Attempt, ranked: RankedGoal) -> tuple[int, int]:
        """Answer how many rules of the contract and how many measures of sense are broken.

        The judge is asked only what the units behind the goal can answer, so that a plan from the whole FOON and one
        from just these units choose alike; whether the dish is truly named (S6) is known from the ranking, and how
        much of the video is kept (S8) from the place of its last unit. A person who chose an equivalent is not told
        that it is too unlike (S5).
        """
        broken = set(attempt.report.broken)
        kept = attempt.kept(ranked.goal.videos)
        sense = broken & _ASKED_OF_THE_JUDGE - ({"S5"} if self.settings.substitutes else set())
        return len(broken & set(CONTRACT)), len(sense) + bool(ranked.misnamed) + (kept < KEPT)

    def _wanted(self, ranked: RankedGoal) -> dict[str, int]:
        """Which ingredients of the goal may play which required food, by number: what counts as overlap."""
        wanted: dict[str, int] = {}
        for number, want in enumerate(self.wants):
            for name in ranked.goal.ingredients:
                if self.equivalents.name_confidence(want.object, name) >= FAIR:
                    wanted.setdefault(name, number)
        return wanted


def _scripts(workshop: Workshop, reference: ReferenceTree, goal: Goal) -> Iterator[tuple[KnownUnit, ...]]:
    """Answer what may be executed to make ``goal``, best first; each is looked for only when it is asked for."""
    script = workshop.script(reference, goal.videos)
    if script:
        yield script
    footage = workshop.footage(goal.node, goal.videos)
    if footage and footage != script:
        yield footage


def _wants(recipe: Recipe) -> tuple[RequiredIngredient, ...]:
    """Answer the distinct required foods in the order of the recipe: asked twice in one state is asked once."""
    wants = tuple(dict.fromkeys(want for want in recipe.ingredients if want.object))
    if not wants:
        raise UsageError("the recipe names no ingredient", hint="Give at least one, as in “chopped onion”.")
    return wants
