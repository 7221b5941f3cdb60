"""The method of the paper to the letter, kept for comparison only: ``foon plan --method paper``.

"Functional Task Tree Generation from a Knowledge Graph to Solve Unseen Problems" (Sakib, Paulius, Sun 2021) has four
algorithms. Those that find a dish and its tree (1 to 3) are in :mod:`foon_kg.planning.paper.reference`, the one that
makes the tree fit the recipe (4) is in :mod:`foon_kg.planning.paper.final`. Nothing here knows what happens in a
kitchen: no food is used up, nothing cools down, nobody turns the stove off. The planner of foon-kg is elsewhere and
shares only the search.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from foon_kg.model import Goal, ObjectNode, Recipe, RequiredIngredient
from foon_kg.model.claims import Assumption
from foon_kg.model.errors import NoTreeError, UsageError
from foon_kg.model.knowledge import KnowledgeView, Vocabulary
from foon_kg.model.tree import Step, leaves_of
from foon_kg.planning.paper.final import construct_final_task_tree, made_for
from foon_kg.planning.paper.reference import MOST_PATHS, Knowledge, identify_goal_node, retrieve_reference_task_tree
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.progress import progress_lines
from foon_kg.plans.result import PlanResult, ReferenceSummary
from foon_kg.similarity import Similarity, cosine_similarity

__all__ = ["MOST_PATHS", "plan_by_the_paper"]


def plan_by_the_paper(
    view: KnowledgeView, recipe: Recipe, *, similarity: Similarity | None = None, most_paths: int = MOST_PATHS
) -> PlanResult:
    """Return the final task tree of ``recipe`` as the four algorithms of the paper construct it.

    ``similarity`` is the raw cosine of the food vectors unless told otherwise (``spacy_similarity``: the paper's own
    vectors). At most ``most_paths`` combinations of producers are looked at; ``reference.exact`` is false where there
    are more. An (object, state) asked twice counts once. Leaves that the contract would not have are ``assumptions``.
    The view is asked for its goals, its words and the units behind both.

    Raises:
        UsageError: The recipe names no ingredient.
        NoTreeError: FOON has no goal of that dish type (code ``no-goal``), no path makes it (``no-way``, or
            ``too-many`` where the bound was hit before one was found), or nothing of it is required (``left-out``).
    """
    wants, vocabulary = _wants_of(recipe), view.vocabulary()
    goals = _goals_of(recipe, view, vocabulary)
    similarity = similarity or cosine_similarity()
    foods = [want.object for want in wants]
    goal = identify_goal_node(goals, foods, similarity)
    made = {want: made_for(want, vocabulary, similarity) for want in wants}
    units = view.behind([goal.node], sorted({(food.label, food.state) for food in made.values()}))
    knowledge = Knowledge.of(units, Kitchen.default().with_foods(foods), vocabulary, similarity)
    reference = retrieve_reference_task_tree(knowledge, goal.node, foods, most_paths)
    final = construct_final_task_tree(knowledge, reference, made)
    leaves = leaves_of(final.units)
    tree = [unit.as_unit() for unit in final.units]
    return PlanResult(
        recipe=replace(recipe, dish_type=recipe.dish_type or goal.dish_type),
        reference=ReferenceSummary(goal.node, len(reference.units), reference.overlap, reference.exact),
        goal=final.goal,
        units=final.units,
        kitchen=leaves,
        substitutions=final.substitutions,
        assumptions=tuple(_assumptions(leaves, final.units, knowledge.kitchen)),
        progress_lines=progress_lines(tree, final.goal, wants, knowledge.kitchen),
    )


def _wants_of(recipe: Recipe) -> tuple[RequiredIngredient, ...]:
    """Return what ``recipe`` asks for, each (object, state) once; raises UsageError where that is nothing."""
    wants = tuple(dict.fromkeys(want for want in recipe.ingredients if want.object))
    if not wants:
        raise UsageError("the recipe names no ingredient", hint="Give at least one, as in “chopped onion”.")
    return wants


def _goals_of(recipe: Recipe, view: KnowledgeView, vocabulary: Vocabulary) -> Sequence[Goal]:
    """Return the goals of the ``view`` of the dish type of ``recipe``; raises NoTreeError where there are none.

    ``vocabulary`` says of which dish types there are goals instead.
    """
    goals = view.goals(recipe.dish_type or None)
    if not goals:
        hint = f"It has goals of these dish types: {', '.join(vocabulary.dish_types) or 'none'}."
        raise NoTreeError(f"this FOON has no {recipe.dish_type or 'dish'}", hint=hint, code="no-goal")
    return goals


def _assumptions(leaves: Sequence[ObjectNode], units: Sequence[Step], kitchen: Kitchen) -> Iterator[Assumption]:
    for node in leaves:
        taker = next(unit for unit in units if node in unit.input_nodes)
        fault = kitchen.leaf_fault(node, [other for other in taker.input_nodes if other != node])
        if fault is not None:
            yield Assumption(node, f"the paper's method leaves it to be there: {fault}")
