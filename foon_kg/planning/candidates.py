"""Between which reference trees the choice is (algorithm 3) for the dish after which a recipe is made."""

from __future__ import annotations

from foon_kg.model import Goal, Recipe
from foon_kg.planning.planner import Planner, _Question
from foon_kg.search import SearchProblem


def reference_question(planner: Planner, recipe: Recipe) -> tuple[Goal, SearchProblem]:
    """Return the goal after which ``recipe`` is made, and what algorithm 3 is asked about it.

    Raises as :meth:`~foon_kg.planning.planner.Planner.plan` does.
    """
    taken = planner.plan(recipe).reference.goal
    goal = next(goal for goal in planner.view.goals() if goal.node == taken)
    wanted = _Question(planner, recipe).wanted(goal.ingredients)
    return goal, planner.references.problem(goal, wanted)
