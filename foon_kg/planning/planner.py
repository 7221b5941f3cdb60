"""From a recipe to a task tree: the four algorithms of the paper, one after the other.

What the FOON teaches (:class:`~foon_kg.integration.methods.Methods`) is asked of a view once. A recipe's foods are
understood; the dish that suits them is chosen (algorithms 1 and 2); its exact reference tree is looked up
(algorithm 3); the final tree is built after its frame in a world that refuses what cannot happen (algorithm 4). What is
answered has passed the judge (:mod:`foon_kg.validation`).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cached_property, partial
from typing import NamedTuple

from foon_kg.food import Tables, singular, tables
from foon_kg.food.lists import word_list
from foon_kg.food.named import named_by
from foon_kg.food.parted import parts_asked
from foon_kg.goals.asked import Asked
from foon_kg.goals.choice import Fit, fits, refusals, shortlisted
from foon_kg.integration.bench import Bench, RefusedError
from foon_kg.integration.composing.apart import apart
from foon_kg.integration.composing.called import Called, arranged
from foon_kg.integration.composing.glasses import can_be_blended, can_be_warmed
from foon_kg.integration.composing.listed import as_listed
from foon_kg.integration.composing.parts import Part, parts_of
from foon_kg.integration.final_tree import FinalTree, final_tree
from foon_kg.integration.joining.course import Plan
from foon_kg.integration.joining.joiners import Joiners
from foon_kg.integration.joining.places import Matcher
from foon_kg.integration.making.cooking import Cooking
from foon_kg.integration.methods import Methods, TeachingView
from foon_kg.integration.preparing.entitled import as_in_a_dish
from foon_kg.integration.preparing.preparation import Want, as_there
from foon_kg.integration.preparing.understanding import wants_of
from foon_kg.integration.unheeded import with_core_told, with_parts_told, with_unheeded
from foon_kg.model import KnownUnit, ObjectNode, Recipe, RequiredIngredient
from foon_kg.model.errors import NoTreeError, UsageError
from foon_kg.model.nodes import one_spelling
from foon_kg.planning.attempt import Attempt
from foon_kg.planning.avoidance import household_fat, kitchen_without, names_avoided, why_avoided, without_avoided
from foon_kg.planning.considered import Considered, core_of, made_after, nearer_goals, other_goals
from foon_kg.planning.dish_names import as_told, eased, has_its_name, made_as, refuse_unknown_type, with_core
from foon_kg.planning.explanation import Explanation, explanations
from foon_kg.planning.likes import FoodLikes, RecipeLikes
from foon_kg.planning.references import References
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.kitchen import Kitchen, household_fats
from foon_kg.plans.measures import amounts_asked, with_asked, with_measures
from foon_kg.plans.progress import lines_of_things
from foon_kg.plans.result import GoalPassedOver, PlanResult, ReferenceSummary
from foon_kg.plans.shortage import nearest_first, shortage
from foon_kg.similarity import food_similarity
from foon_kg.validation import check

MOST_TRIES = 5
"""How many frames are tried, the best first, before it is said that there is no tree."""


def plan(view: TeachingView, recipe: Recipe, settings: PlanSettings | None = None) -> PlanResult:
    """Return the task tree that makes ``recipe``, of the FOON of ``view``; without ``settings``, by the usual ones.

    A recipe without a dish type (``""``) may become a dish of any; the answer says which. Raises :class:`UsageError`
    for a recipe without ingredients or with an unknown dish type, and :class:`NoTreeError` where the FOON has no way to
    make it; the code is ``no-goal``, ``no-way``, ``avoided`` or ``missing``.
    """
    return Planner(view, settings or PlanSettings()).plan(recipe)


class Reasons(NamedTuple):
    """A tree, why every required food is made as it is, and the other dishes that were considered."""

    result: PlanResult
    explanations: tuple[Explanation, ...]
    considered: tuple[Considered, ...]


class Teaching:
    """What a FOON teaches, or the part of it that matters to a question, with how well its foods stand for others."""

    def __init__(self, methods: Methods, settings: PlanSettings) -> None:
        self.methods = methods
        self.likes = FoodLikes(settings.similarity or food_similarity(), methods.operators.foods, settings.substitutes)
        self.joiners = Joiners()


class Planner:
    """Plans recipes from one view.

    For many recipes give ``units``, all of the FOON: what they teach is worked out once. Without them each plan asks
    the view for what matters to it.
    """

    def __init__(self, view: TeachingView, settings: PlanSettings, units: Sequence[KnownUnit] | None = None) -> None:
        self.view = view
        self.settings = settings
        self.known: Tables = tables()
        self.references = References(view, settings, units)
        self.in_parts = units is None and settings.similarity is None  # parts are found by the default
        self._latest: Teaching | None = None
        if settings.substitutes:
            _ = self.teaching_for((), "").likes  # a substitute that nobody knows is refused before anything is planned

    def teaching_for(self, foods: Collection[str], dish_type: str) -> Teaching:
        """Return what the FOON teaches of making a dish of ``foods``."""
        if self.in_parts:
            chosen = [substitute.like for substitute in self.settings.substitutes]
            free = sorted({*self.settings.kitchen.free_foods, *household_fats(self.settings.kitchen)})
            methods = self.view.methods_for([*foods, *chosen, *free], dish_type)
        else:
            methods = self.view.methods() if self._latest is None else self._latest.methods
        if self._latest is None or self._latest.methods is not methods:
            try:
                self._latest = Teaching(methods, self.settings)
            except UsageError:  # the nearest to a substitute that nobody knows are sought among all
                return Teaching(self.view.methods(), self.settings)
        return self._latest

    def kitchen_for(self, foods: Sequence[str]) -> Kitchen:
        """Return the kitchen of a recipe that asks for ``foods``."""
        return kitchen_without(self.settings.kitchen, (*self.settings.avoided, *foods)).with_foods(foods)

    def plan(self, recipe: Recipe) -> PlanResult:
        """Return the task tree that makes ``recipe``; raises as :func:`plan` does."""
        return self._finished(self._question(recipe))

    def reasons(self, recipe: Recipe) -> Reasons:
        """Return the tree of ``recipe``, why its foods are made as they are, and what else was considered.

        Raises as :func:`plan` does.
        """
        question = self._question(recipe)
        others = other_goals(question.fits, question.best.fit, recipe.dish_type)
        return Reasons(self._finished(question), explanations(question.best, question.likes), tuple(others))

    def reference_tree(self, recipe: Recipe, goal: ObjectNode) -> tuple[KnownUnit, ...]:
        """Return the reference tree of ``goal`` for ``recipe``, as it was recorded.

        Raises UsageError where ``goal`` is no goal of this FOON.
        """
        found = next((one for one in self.view.goals() if one.node == goal), None)
        if found is None:
            raise UsageError(f"this FOON has no goal {goal}", hint="Give the FOON of the plan with --files.")
        question = PlannedRecipe(self, recipe)
        return self.references.tree(found, question.wanted(found.ingredients)).units

    def _question(self, recipe: Recipe) -> PlannedRecipe:
        """Return ``recipe`` planned with what stands ready, or without it where there is a tree only so; may raise."""
        question = PlannedRecipe(self, recipe)
        if any(want.at_hand for want in question.wants):
            try:
                _ = question.best
            except NoTreeError:
                with suppress(NoTreeError):
                    plain = PlannedRecipe(self, recipe, ready=False)
                    return plain if plain.best else question
                raise
        return question

    def _finished(self, question: PlannedRecipe) -> PlanResult:
        """Return the best tree with its measures and progress lines, which no other one needs."""
        best = question.best
        ready = best.cooking.ready
        amounts = amounts_asked(question.recipe)
        foods = [
            (RequiredIngredient(want.label, want.asked, amounts[want.number - 1]), ready[want.number].stuff.number)
            for want in question.wants
        ]
        frame = best.fit.frame
        goal = question.methods.goal_of(frame)
        recorded = self.references.searched(goal, question.wanted(goal.ingredients)).units
        return replace(
            best.result,
            units=with_measures(with_asked(best.result.units, foods), recorded, frame.video),
            progress_lines=lines_of_things(best.result.units, best.result.goal, foods),
        )


class PlannedRecipe:
    """One recipe being planned: its foods as they are understood, and the dishes that it may be made after.

    ``ready``: a food is taken in the asked state where a person named it so.
    """

    def __init__(self, planner: Planner, recipe: Recipe, *, ready: bool = True) -> None:
        self.planner = planner
        self.settings = planner.settings
        self.known = planner.known
        refuse_unknown_type(recipe.dish_type)
        self.recipe, self.core = with_core(without_avoided(recipe, self.settings.avoided)[0], self.known)
        title, asked = recipe.title or "", [one for one in self.recipe.ingredients if one.object]
        self.teaching = planner.teaching_for(_names_of(asked, self.known), recipe.dish_type)
        self.methods = self.teaching.methods
        understand = partial(wants_of, known=self.known, operators=self.methods.operators, title=title)
        self.recipe, wants, self.inferred = as_listed(self.recipe, understand)
        wants = as_in_a_dish(wants, self.methods.operators, title, self.recipe.dish_type or "")
        if not wants:
            raise UsageError("the recipe names no ingredient", hint="Give at least one, as in “chopped onion”.")
        self.kitchen = planner.kitchen_for([want.label for want in wants])
        self.wants = tuple(as_there(want, self.kitchen) for want in wants) if ready else tuple(wants)
        taught = self.methods.outlines.taught(recipe.dish_type, self.known)
        whole = Asked(self.wants, recipe.dish_type, title, self.known)
        made = apart(self.wants, recipe, whole.dishes, taught, self.known, baked=whole.baked)
        foods, own, self.sides, self.technique = made
        self.asks = named_by(title, recipe.dish_type, [(want.label, want.facts) for want in self.wants])
        self.baked, self.parts = self._parted(own, _named_twice(asked))
        self.likes: RecipeLikes = self.teaching.likes.of_recipe(foods)
        self.matcher = Matcher(self.methods.joining_counts, self.likes.in_slot, foods, self.teaching.joiners)

    def _parted(self, own: tuple[Want, ...], twice: Collection[str]) -> tuple[tuple[Want, ...], tuple[Part, ...]]:
        """Return the ``own`` foods of the dish itself, and what is put on it; ``twice`` are foods named repeatedly."""
        if self.technique is not None:  # it says itself what is put on what
            return own, ()
        strewn = any(side.component.at == "before" for side in self.sides)  # then nothing else is strewn on it
        beside = {singular(want.label) for side in self.sides for want in side.wants}
        title = self.recipe.title or ""
        return parts_of(own, self.recipe.dish_type, title, {*twice} - beside, self.known, strewn=strewn)

    @cached_property
    def best(self) -> Attempt:
        """The tree of the best frame that the judge accepts; raises :class:`NoTreeError` where there is none."""
        attempts: list[Attempt] = []
        troubles: list[str] = []
        for fit in made_after(self.fits, self.settings.after)[:MOST_TRIES]:
            try:
                attempt = self._attempt(fit)
            except RefusedError as error:
                troubles.append(f"{fit.frame.goal.label}: {error}")
                continue
            faults = [one for one in attempt.report.findings if not one.minor]
            if faults:
                troubles.append(f"{fit.frame.goal.label}: {faults[0].reason} ({faults[0].rule})")
            elif attempt.missing:
                attempts.append(attempt)
            else:
                return self._searched(attempt)
        if attempts:
            least = min(attempts, key=lambda one: len(one.missing))
            raise shortage(least.missing, least.result, self.kitchen, self.likes.stands_for)
        raise self._no_way(troubles)

    @cached_property
    def fits(self) -> list[Fit]:
        """How well each dish suits that may be taken, the best first; raises :class:`NoTreeError` where none may."""
        outlines = self.methods.outlines
        title = self.recipe.title or ""
        dish_type = made_as(self.recipe.dish_type, title, self.known)
        if not outlines.are_of(dish_type) and self.technique is None:
            there = ", ".join(sorted(outlines.dish_types))
            raise NoTreeError(
                f"this FOON has no {dish_type or 'dish'}",
                code="no-goal",
                hint=f"It has goals of these dish types: {there}." if there else "It is empty: foon load foon PATH…",
            )
        asked = Asked(self.baked, dish_type, title, self.known)
        lacks = refusals(self.wants, dish_type, title, self.known)
        if lacks:
            raise NoTreeError(lacks[0], code="no-way", hint=self._nearest(asked))
        after = self.settings.after
        return self._fits(asked, [one.key for one in outlines.all if one_spelling(one.label) == after] if after else [])

    def _fits(self, asked: Asked, first: Sequence[str] = ()) -> list[Fit]:
        """Return how well the dishes suit that are worth a closer look, those with the keys ``first`` among them."""
        avoided = self.settings.avoided
        allowed = (lambda label: why_avoided(label, avoided) is None) if avoided else None
        keys = shortlisted(self.methods.outlines, asked, self.likes, allowed)
        layouts = self.methods.layouts_of(list(dict.fromkeys((*first, *keys))))
        self.likes.meet(frozenset().union(*(layout.foods for layout in layouts)))
        return fits(layouts, asked, self.matcher)

    def _nearest(self, asked: Asked) -> str:
        """Return what to do where the asked dish cannot be: the recorded dishes that come nearest to it are named."""
        found = sorted(self._fits(asked), key=lambda fit: fit.frame.dish_type != asked.dish_type)
        hint = f"Add what is missing; the nearest is {_recorded(found[0])}." if found else "Add what is missing."
        for fit in self._fits(Asked(self.baked, "", "", self.known)):
            frame = fit.frame
            if not fit.vetoes and not refusals(self.wants, frame.dish_type, frame.goal.label, self.known):
                return f"{hint} Asked for as {frame.dish_type}, they suit {_recorded(fit)}."
        return hint

    def _attempt(self, fit: Fit) -> Attempt:
        frame, dish_type = fit.frame, self.recipe.dish_type or fit.frame.dish_type
        asked = Asked(self.wants, dish_type, self.recipe.title or "", self.known)
        tin = next((dish.tin for dish in reversed(asked.dishes) if dish.tin), "")
        bench = Bench(self.methods.operators, self.likes, self.likes.alike, self.likes.instead)
        bench.found_on = self.kitchen.found_on
        called = self._called(fit, asked, dish_type, tin)
        line, joins, one_pot = arranged(frame.line, fit.joins, self.parts, called, self.known)
        label = frame.goal.label if has_its_name(fit, asked, dish_type, tin, self.technique) else dish_type
        plan = Plan(label, frame.goal.label, joins, self.methods.cooked_by, eased(asked), one_pot=one_pot)
        in_glass, cold = dish_type in word_list("is drunk"), "cold" in self.technique.plan if self.technique else False
        fat = household_fat(self.wants, asked.title, self.kitchen, self.settings.avoided, bench.operators)
        plan = replace(plan, in_glass=in_glass, cold=cold, cooled=asked.is_eaten_cold, by_bites=asked.by_bites, fat=fat)
        plan = as_told(plan, asked, tin) if self.technique is None else replace(plan, by_table=True)
        cooking = Cooking(bench, line, plan)
        dish = cooking.make()
        tree = final_tree(bench, cooking, dish, self.wants, self.likes.others)
        tree = with_unheeded(with_parts_told(tree, self.inferred, self.recipe), self.asks, self.wants, self.known)
        result = self._result(fit, with_core_told(tree, self.core), dish_type)
        self._refuse_avoided(result)
        report = check(result.tree, free=self.kitchen.free_foods, named_so=self.kitchen.names_so)
        return Attempt(replace(fit, joins=joins), result, report, self._missing(result), cooking)

    def _called(self, fit: Fit, asked: Asked, dish_type: str, tin: str) -> Called:
        """Return what the names of the asked dish and of the recorded one say of how it is put together."""
        told = frozenset((*asked.type_words, *asked.title_words))
        return Called(
            asked.dishes, told, fit.frame.goal.label, asked.title, dish_type, tin,
            baked=asked.baked,
            folded=asked.title_words if asked.title else fit.dish.words,
            warms=can_be_warmed(self.methods.operators),
            blends=can_be_blended(self.methods.operators),
            technique=self.technique,
            asks=self.asks,
            sides=self.sides,
        )  # fmt: skip

    def _result(self, fit: Fit, tree: FinalTree, dish_type: str) -> PlanResult:
        frame = fit.frame
        core, by = core_of(fit, self.likes), self.technique.name if self.technique else ""
        goal = self.methods.goal_of(frame)
        return PlanResult(
            replace(self.recipe, dish_type=dish_type),
            ReferenceSummary(
                goal.node, 0, 0, exact=False, videos=(frame.video,), core=core, technique=by
            ),  # see _searched
            tree.goal,
            tree.units,
            tree.kitchen,
            tree.substitutions,
            tree.assumptions,
            passed_over=tuple(
                GoalPassedOver(one.goal, one.similarity, one.why)
                for one in nearer_goals(self.fits, fit, self.recipe.dish_type)
            ),
        )

    def _searched(self, attempt: Attempt) -> Attempt:
        """Return the attempt that is taken with its reference tree: only for that one it is searched (algorithm 3)."""
        goal, told = self.methods.goal_of(attempt.fit.frame), attempt.result.reference
        found = self.planner.references.summary(goal, self.wanted(goal.ingredients), told.videos, told.core)
        return replace(attempt, result=replace(attempt.result, reference=replace(found, technique=told.technique)))

    def wanted(self, ingredients: Sequence[str]) -> dict[str, int]:
        """Return which ingredients of a goal may stand for which required food, by number: what counts as overlap."""
        found: dict[str, int] = {}
        for number, want in enumerate(self.wants):
            for name in ingredients:
                if name not in found and self.likes.is_fair(want.label, name):
                    found[name] = number
        return found

    def _missing(self, result: PlanResult) -> tuple[ObjectNode, ...]:
        """Return the leaves that are not in the kitchen that a person named, nearest to the goal first."""
        missing = self.kitchen.missing_leaves(result.kitchen, result.units)
        units = [(unit.input_nodes, unit.output_nodes) for unit in result.units]
        return nearest_first(missing, units, result.goal) if missing else ()

    def _refuse_avoided(self, result: PlanResult) -> None:
        if not self.settings.avoided:
            return
        nodes = (node for unit in result.units for node in (*unit.input_nodes, *unit.output_nodes))
        node = next((node for node in nodes if names_avoided(node, self.settings.avoided)), None)
        if node is not None:
            raise RefusedError(f"it names {node.label}, which is to be avoided")

    def _is_all_avoided(self) -> bool:
        """Whether every dish of the asked type is called like something that is to be avoided."""
        own = [one.label for one in self.methods.outlines.all if one.dish_type == self.recipe.dish_type]
        return bool(own) and all(why_avoided(label, self.settings.avoided) is not None for label in own)

    def _no_way(self, troubles: Sequence[str]) -> NoTreeError:
        dish = f"this {self.recipe.dish_type}" if self.recipe.dish_type else "any dish of these"
        near = f" The nearest: {troubles[0]}." if troubles else ""
        return NoTreeError(
            f"this FOON knows no way to make {dish}.{near}",
            code="avoided" if self._is_all_avoided() else "no-way",
            hint="Leave an ingredient out or ask for it in another state, or ask for another dish type.",
        )


def _names_of(asked: Sequence[RequiredIngredient], known: Tables) -> Collection[str]:
    """Return the foods that are asked, each once, and what the food table takes them for."""
    names = [singular(one.object) for one in asked]
    for one in asked:
        facts = known.foods.food(one.object, [one.state])
        names += [facts.taken_for, *parts_asked(one.object, facts, one.state)]
    return dict.fromkeys(filter(None, names))


def _named_twice(asked: Sequence[RequiredIngredient]) -> set[str]:
    """Return the foods that a recipe names more than once: it has parts."""
    return {name for name, count in Counter(singular(one.object) for one in asked).items() if count > 1}


def _recorded(fit: Fit) -> str:
    return f"“{fit.frame.goal.label}” of the video {fit.frame.video}"
