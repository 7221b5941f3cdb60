"""The front door: a FOON to ask, from Python.

>>> from foon_kg import Foon
>>> from foon_kg.foon.demo import demo_folder
>>> foon = Foon.from_files(demo_folder())
>>> plan = foon.plan("salad", ["chopped onion", "diced tomato", "olive oil"])
>>> print(plan.steps[1].text)
Peel the onion with the knife.
>>> plan.check().accepted
True
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from foon_kg.foon.answering import WHOLE, Answering
from foon_kg.foon.opened import Paths, listed
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:  # every question imports what it needs: a command asks one, and should begin at once
    from foon_kg.food.motion_costs import MotionCosts
    from foon_kg.foon.collected import Recipes as Recipes
    from foon_kg.foon.drafting import Drafting as Drafting
    from foon_kg.foon.evaluating import Evaluation as Evaluation
    from foon_kg.foon.machine import ThisMachine as ThisMachine
    from foon_kg.foon.plan import Plan as Plan
    from foon_kg.language.reviewing import Decision as Decision
    from foon_kg.language.reviewing import Kind as Kind
    from foon_kg.language.reviewing import Reason as Reason
    from foon_kg.language.reviewing import Review as Review
    from foon_kg.model import KnownUnit
    from foon_kg.model.knowledge import Neighbour
    from foon_kg.model.tree import Step as Step
    from foon_kg.planning.batch import Answer as Answer
    from foon_kg.planning.batch import Question as Question
    from foon_kg.planning.candidates import Candidates
    from foon_kg.planning.considered import Considered as Considered
    from foon_kg.planning.explanation import Explanation as Explanation
    from foon_kg.planning.explanation import Joining as Joining
    from foon_kg.planning.explanation import PassedOver as PassedOver
    from foon_kg.planning.kitchen_file import ReadKitchen as ReadKitchen
    from foon_kg.planning.recipes import NO_FOOD as NO_FOOD
    from foon_kg.planning.recipes import NO_STATE as NO_STATE
    from foon_kg.planning.recipes import IngredientWords as IngredientWords
    from foon_kg.planning.recipes import amount_said as amount_said
    from foon_kg.planning.recipes import as_spelled as as_spelled
    from foon_kg.planning.recipes import recipe_files as recipe_files
    from foon_kg.planning.settings import PlanSettings as PlanSettings
    from foon_kg.planning.settings import Substitute as Substitute
    from foon_kg.planning.suggestion import Suggestion, Suggestions
    from foon_kg.planning.suggestion import Taken as Taken
    from foon_kg.plans.kitchen import Kitchen
    from foon_kg.plans.result import PlanResult
    from foon_kg.plans.stock import StockedKitchen
    from foon_kg.search.classic import RetrievalResult as RetrievalResult
    from foon_kg.store.graph import GraphView
    from foon_kg.store.settings import ConnectionSettings as ConnectionSettings
    from foon_kg.store.snapshot import Snapshot as Snapshot
    from foon_kg.store.statistics import Statistics
    from foon_kg.store.with_drafts import WithDrafts as WithDrafts

_HOMES = {
    "Answer": "foon_kg.planning.batch",
    "ConnectionSettings": "foon_kg.store.settings",
    "Considered": "foon_kg.planning.considered",
    "Decision": "foon_kg.language.reviewing",
    "Drafting": "foon_kg.foon.drafting",
    "Evaluation": "foon_kg.foon.evaluating",
    "Explanation": "foon_kg.planning.explanation",
    "IngredientWords": "foon_kg.planning.recipes",
    "Joining": "foon_kg.planning.explanation",
    "Kind": "foon_kg.language.reviewing",
    "NO_FOOD": "foon_kg.planning.recipes",
    "NO_STATE": "foon_kg.planning.recipes",
    "PassedOver": "foon_kg.planning.explanation",
    "Plan": "foon_kg.foon.plan",
    "PlanSettings": "foon_kg.planning.settings",
    "Question": "foon_kg.planning.batch",
    "ReadKitchen": "foon_kg.planning.kitchen_file",
    "Reason": "foon_kg.language.reviewing",
    "Recipes": "foon_kg.foon.collected",
    "RetrievalResult": "foon_kg.search.classic",
    "Review": "foon_kg.language.reviewing",
    "Snapshot": "foon_kg.store.snapshot",
    "Step": "foon_kg.model.tree",
    "Substitute": "foon_kg.planning.settings",
    "Taken": "foon_kg.planning.suggestion",
    "ThisMachine": "foon_kg.foon.machine",
    "WithDrafts": "foon_kg.store.with_drafts",
    "amount_said": "foon_kg.planning.recipes",
    "as_spelled": "foon_kg.planning.recipes",
    "recipe_files": "foon_kg.planning.recipes",
}
"""Where what a FOON is asked with, and what it answers with, is defined; a checker of types reads it from above."""


def __getattr__(name: str) -> object:
    """Return what a FOON is asked or answers with; raises AttributeError for anything else."""
    if name in _HOMES:
        return getattr(import_module(_HOMES[name]), name)
    raise AttributeError(f"module foon_kg.foon has no attribute {name}")


class Foon(Answering):
    """A FOON to plan with: files in memory (:meth:`from_files`) or a Neo4j (:meth:`connect`).

    It is a context manager; :meth:`close` gives connections back.
    """

    def plan(
        self,
        dish_type: str,
        ingredients: Iterable[str | tuple[str, str]],
        *,
        title: str | None = None,
        avoid: Sequence[str] = (),
        substitute: Mapping[str, str] | None = None,
        kitchen: Kitchen | ReadKitchen | None = None,
        after: str = "",
        with_drafts: bool = False,
    ) -> Plan:
        """Return the task tree that makes a dish of ``dish_type`` (``""``: the one most like these foods).

        ``ingredients`` are in words (``"chopped onion"``) or pairs of food and state. ``title`` is read: a creamy soup
        is blended. ``avoid`` names foods or kinds of food that no step may have, ``substitute`` by which known food an
        asked one is handled, ``kitchen`` what is at hand, ``after`` the recorded dish or the video to make it after.
        Dishes that were only drafted from the words of recipes count ``with_drafts``; what is made after one says so
        (``reference.draft_confidence``). Algorithms 1 to 4 of the paper.

        Raises :class:`~foon_kg.model.errors.NoTreeError` where the FOON has no way to make it, and
        :class:`~foon_kg.model.errors.UsageError` for a dish type or foods that nobody knows.

        >>> plan = foon.plan("salad", [("onion", "chopped"), ("olive oil", "")], avoid=["nuts"])
        >>> len(plan)
        6
        """
        from foon_kg.foon.plan import Plan
        from foon_kg.planning.kitchen_file import ReadKitchen
        from foon_kg.planning.settings import PlanSettings, Substitute
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.plans.result import PlanResult

        chosen = tuple(Substitute(food, like) for food, like in (substitute or {}).items())
        there = kitchen.kitchen if isinstance(kitchen, ReadKitchen) else kitchen
        settings = PlanSettings(
            there or Kitchen.default(),
            substitutes=chosen,
            avoided=tuple(listed(avoid, "avoid")),
            after=after,
            with_drafts=with_drafts,
        )
        answer = self.answer(_question(dish_type, listed(ingredients, "ingredients"), title), settings)
        if answer.error is not None or not isinstance(answer.outcome, PlanResult):
            raise answer.error or UsageError("there is no answer", hint="Ask something.")
        return Plan(answer.outcome, self, settings, answer.notes)

    def similar(self, food: str, limit: int = 5, *, role: str | None = None) -> tuple[Neighbour, ...]:
        """Return the known foods that can stand for ``food``, the best first, each with a confidence from 0 to 1.

        None where nothing is like it. With ``role``, what the food does in a dish ("liquid", "protein", …),
        known foods are answered that do the same: broth is unlike water, and is taken for it as a liquid. Algorithm 2
        of the paper, by more than its cosine.

        Raises ``UsageError`` for anything that no food does.

        >>> foon.similar("caper", limit=1)[0].name
        'black olive'
        """
        return self.similar_to_each([food], limit, role=role)[0]

    def similar_to_each(
        self, foods: Sequence[str], limit: int = 5, *, role: str | None = None, vectors: str | None = None
    ) -> Sequence[tuple[Neighbour, ...]]:
        """Return what :meth:`similar` does for each of ``foods``; a graph is asked for all of them at once.

        ``role`` is as there. With ``vectors``, the name of a spaCy pipeline or of a plug-in, they are compared by the
        cosine of its vectors (-1 to 1), as in the paper (section III-C). Raises ``UsageError`` where that is not there.

        >>> [one[0].name for one in foon.similar_to_each(["caper", "milk"], limit=1)]
        ['black olive', 'milk']
        """
        from foon_kg.foon.likeness import by_points, in_view

        plain = role is None and vectors is None
        found = by_points(self._connection, foods, limit) if plain and self._snapshot is None else None
        if found is not None:
            return found
        with self.reading() as view:
            return in_view(view, foods, limit, role, vectors, whole=not self.is_larger_than(WHOLE))

    def why_similar(self, food: str, other: str, *, vectors: str | None = None) -> tuple[str, ...]:
        """Return what speaks for one food to stand for another, in words, the weightiest first; see :meth:`similar`.

        With ``vectors``, the name of a spaCy pipeline or of a plug-in, that is their cosine.

        >>> foon.why_similar("caper", "black olive")[0]
        'named in like company (0.65)'
        """
        from foon_kg.foon.likeness import named_similarity

        return tuple(named_similarity(vectors).why(food, other))

    def retrieve(
        self,
        goal: str,
        states: Iterable[str] = (),
        ingredients: Iterable[str] = (),
        *,
        container: str | None = None,
        level: int = 2,
        by: Literal["units", "success"] = "units",
        kitchen: Kitchen | None = None,
        costs: MotionCosts | None = None,
    ) -> RetrievalResult:
        """Return the best tree of a goal that the FOON has as it is, proven: classic retrieval (algorithm 3).

        ``states``, ``ingredients`` and ``container`` say more of the goal; ``level`` says what counts of an object (1:
        its label, 2: states and places too, 3: ingredients too). The best has the fewest ``units``, or the greatest
        ``success``, by the ``costs`` of motions (0 to 1), which are those of the FOON unless given. ``kitchen`` is what
        is at hand: everything, unless given.

        Raises :class:`~foon_kg.model.errors.NoTreeError` where there is none, and
        :class:`~foon_kg.model.errors.UsageError` for what the level does not look at.

        >>> len(foon.retrieve("omelette").units)
        10
        """
        from foon_kg.model.levels import Level
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.search.classic import Criterion, GoalSought, retrieve_tree

        sought = GoalSought(goal, tuple(states), tuple(ingredients), container, Level(level), Criterion(by))

        def retrieved(view: Snapshot | GraphView) -> RetrievalResult:
            known = view.motion_costs() if costs is None else costs
            return retrieve_tree(view, sought, kitchen or Kitchen.default(), known)

        return self.of_one_state(retrieved)

    def candidates(self, question: Question, settings: PlanSettings, most: int = 1_000) -> Candidates:
        """Return the reference trees of the goal after which a recipe is made, best first, and the exact one.

        They are paths through the combinations of producers (algorithm 3 of the paper), of which at most ``most`` are
        looked at. Raises what :meth:`plan` raises for such a ``question``.

        >>> from foon_kg.planning.batch import Question
        >>> from foon_kg.planning.settings import PlanSettings
        >>> found = foon.candidates(Question(dish_type="salad", texts=("chopped onion", "olive oil")), PlanSettings())
        >>> len(found.exact.units), found.found.complete
        (28, False)
        """
        from foon_kg.planning.candidates import candidates

        with self.reading() as view:
            return candidates(view, settings, question, most)

    def reference_of(self, result: PlanResult) -> Sequence[KnownUnit]:
        """Return the reference tree after which a plan was made: the units of algorithm 3, in order.

        Raises :class:`~foon_kg.model.errors.NoTreeError` where this FOON does not have its goal.

        >>> len(foon.reference_of(plan.result)) == plan.result.reference.units
        True
        """
        from foon_kg.planning.planner import Planner
        from foon_kg.planning.settings import PlanSettings

        with self.reading() as view:
            return Planner(view, PlanSettings()).reference_tree(result.recipe, result.reference.goal)

    def kitchen(self, file: Paths | None = None, foods: Iterable[str] = ()) -> ReadKitchen:
        """Return the kitchen that ``file`` describes (without one, everything), with these ``foods`` at hand as well.

        Its ``notes`` say what had to be decided to read it. Raises :class:`~foon_kg.model.errors.ReadError` with the
        line that cannot be read.

        >>> foon.kitchen(foods=["chopped onion"]).kitchen.foods_named[0].states
        ('chopped',)
        """
        from foon_kg.planning.kitchen_file import Entry, kitchen_with, read_kitchen

        texts = tuple(foods)
        entries = [Entry(f"“{text}”", text) for text in texts]
        if file is None:
            return kitchen_with(entries, self._words_for(texts))
        return read_kitchen(Path(file), self.words(), entries)

    def _words_for(self, texts: Sequence[str]) -> IngredientWords:
        """Return the words in which ``texts`` are read: of a very large FOON no others."""
        if not self.is_larger_than(WHOLE):
            return self.words()
        from foon_kg.planning.recipes import IngredientWords
        from foon_kg.planning.several_asked import names_in
        from foon_kg.plans.kitchen import Kitchen

        with self.reading() as view:
            return IngredientWords(view.words_for((), names_in(texts)), Kitchen.default())

    def suggest(self, foods: Iterable[str] | Kitchen | ReadKitchen, most: int = 5) -> tuple[Suggestion, ...]:
        """Return at most ``most`` dishes that can be made of ``foods``, the best first.

        ``foods`` are names, or a kitchen that names some, as :meth:`kitchen` reads it. Utensils among them are then the
        only ones that are there. Raises what :meth:`suggestions` raises.

        >>> foon.suggest(["egg", "butter", "salt"], most=1)[0].goal.node.label
        'omelette'
        >>> foon.suggest(foon.kitchen(foods=["egg", "butter", "salt"]), most=1)[0].missing
        ()
        """
        return self.suggestions(self._kitchen_of(foods), most).found

    def _kitchen_of(self, foods: Iterable[str] | Kitchen | ReadKitchen) -> StockedKitchen:
        """Return the kitchen that has ``foods``; raises UsageError for one that has everything, and for one word."""
        from foon_kg.planning.kitchen_file import ReadKitchen
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.plans.stock import StockedKitchen

        kitchen = foods.kitchen if isinstance(foods, ReadKitchen) else foods
        if isinstance(kitchen, StockedKitchen):
            return kitchen
        if isinstance(kitchen, Kitchen):
            raise UsageError("this kitchen names no food", hint="Foon.kitchen reads one that names what is at hand.")
        if isinstance(kitchen, str):
            raise UsageError("foods are several names", hint=f'Give a list: ["{kitchen}"].')
        return self.kitchen(foods=kitchen).kitchen

    def suggestions(self, kitchen: StockedKitchen, most: int = 5, time_limit: float | None = 20.0) -> Suggestions:
        """Return the at most ``most`` dishes that ``kitchen`` makes best, and how many were looked at.

        ``time_limit`` (seconds) is for each of them. Raises :class:`~foon_kg.model.errors.UsageError` where the kitchen
        names no food, and :class:`~foon_kg.model.errors.NoTreeError` where no dish takes any of them.

        >>> foon.suggestions(foon.kitchen(foods=["egg", "butter", "salt"]).kitchen, most=1).considered
        23
        """
        from foon_kg.planning.suggested import as_planned
        from foon_kg.planning.suggestion import suggest

        return self.of_one_state(
            lambda view: as_planned(suggest(view, kitchen, most=most, time_limit=time_limit), view, kitchen)
        )

    @property
    def evaluation(self) -> Evaluation:
        """What measures how good the plans of this FOON, and the trees of others, are.

        >>> foon.evaluation.trees([("here", "salad", plan.result.tree)]).trees[0].report.accepted
        True
        """
        from foon_kg.foon.evaluating import Evaluation

        return Evaluation(self)

    def statistics(self) -> Statistics:
        """Return how much the FOON holds: videos, units, objects, goals. Neo4j counts its own, of any size.

        >>> foon.statistics().to_json()["videos"]
        23
        """
        if self._snapshot is not None:
            from foon_kg.store.statistics import Statistics

            return Statistics.of(self._snapshot)
        from foon_kg.store.graph.counting import count

        return count(self._connection)


def _question(dish_type: str, asked: Sequence[str | tuple[str, str]], title: str | None) -> Question:
    """Return the question for a dish of what is ``asked``, all in words or all in pairs of food and state."""
    from foon_kg.model import Recipe, RequiredIngredient
    from foon_kg.planning.batch import Question

    words = [one for one in asked if isinstance(one, str)]
    pairs = [one for one in asked if not isinstance(one, str)]
    if words and pairs:
        raise UsageError("ingredients are words or pairs", hint="Give all of them in one way.")
    if not pairs:
        return Question(dish_type=dish_type, texts=tuple(words), title=title)
    wanted = tuple(RequiredIngredient(food, state) for food, state in pairs)
    return Question(given=Recipe(dish_type, wanted, title=title))
