"""Between which reference trees the choice is (algorithm 3) for the dish after which a recipe is made."""

from __future__ import annotations

from dataclasses import dataclass

from foon_kg.integration.methods import TeachingView
from foon_kg.model import Goal, Recipe
from foon_kg.planning.batch import Cook, Question
from foon_kg.planning.planner import PlannedRecipe, Planner
from foon_kg.planning.recipes import ReadRecipe
from foon_kg.planning.settings import PlanSettings
from foon_kg.search import Enumeration, ReferenceTree, SearchProblem, enumerate_paths, retrieve, with_gaps_of


@dataclass(frozen=True)
class Candidates:
    """The reference trees that were ``found`` for the goal of a recipe, and the ``exact`` one, which is proven."""

    read: ReadRecipe
    goal: Goal
    exact: ReferenceTree
    found: Enumeration


def candidates(view: TeachingView, settings: PlanSettings, question: Question, most: int) -> Candidates:
    """Return the reference trees for a ``question``, best first, of at most ``most`` combinations of producers.

    They are of the FOON of ``view``, planned by ``settings``. Raises as :meth:`~foon_kg.planning.planner.Planner.plan`
    does.
    """
    cook = Cook(view, settings)
    read = question.read(cook.words_for(question), settings.avoided)
    goal, problem = reference_question(cook.planner, read.recipe)
    exact = retrieve(problem, time_limit=settings.time_limit)
    return Candidates(read, goal, exact, enumerate_paths(with_gaps_of(problem, exact), limit=most))


def reference_question(planner: Planner, recipe: Recipe) -> tuple[Goal, SearchProblem]:
    """Return the goal after which ``recipe`` is made, and what algorithm 3 is asked about it.

    Raises as :meth:`~foon_kg.planning.planner.Planner.plan` does.
    """
    taken = planner.plan(recipe).reference.goal
    goal = next(goal for goal in planner.view.goals() if goal.node == taken)
    wanted = PlannedRecipe(planner, recipe).wanted(goal.ingredients)
    return goal, planner.references.problem(goal, wanted)
