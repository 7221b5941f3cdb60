"""``foon plan --enumerate``: the reference trees between which the choice is (algorithm 3), and the exact search."""

from __future__ import annotations

from typing import TYPE_CHECKING

from foon_kg.cli.console import Say, print_json, print_view

if TYPE_CHECKING:
    from foon_kg.foon import Foon
    from foon_kg.model.json_fields import JsonObject
    from foon_kg.planning.batch import Question
    from foon_kg.planning.settings import PlanSettings
    from foon_kg.search import ReferenceTree


def show_candidates(
    question: Question, foon: Foon, settings: PlanSettings, most: int, *, as_json: bool, say: Say
) -> None:
    """Print the reference trees of the goal after which a recipe is made, best first, of ``most`` combinations."""
    from foon_kg.formats.views.candidates import candidates_view
    from foon_kg.model.node_json import node_to_json, recipe_to_json
    from foon_kg.planning.batch import Cook
    from foon_kg.planning.candidates import reference_question
    from foon_kg.search import enumerate_paths, retrieve, with_gaps_of

    with foon.reading() as view:
        cook = Cook(view, settings)
        read = question.read(cook.words_for(question), settings.avoided)
        for note in read.notes:
            say(note)
        goal, problem = reference_question(cook.planner, read.recipe)
        exact = retrieve(problem, time_limit=settings.time_limit)
        found = enumerate_paths(with_gaps_of(problem, exact), limit=most)
    if not as_json:
        print_view(candidates_view(goal, found, exact))
        return
    print_json(
        {
            "recipe": recipe_to_json(read.recipe),
            "goal": node_to_json(goal.node),
            "exact": _tree(exact),
            "candidates": [_tree(tree) for tree in found.trees],
            "complete": found.complete,
            "looked_at": found.looked_at,
        }
    )


def _tree(tree: ReferenceTree) -> JsonObject:
    from foon_kg.model.node_json import node_to_json, sighting_to_json

    return {
        "overlap": tree.overlap,
        "units": len(tree.units),
        "penalty": tree.penalty,
        "gaps": [node_to_json(node) for node in tree.gaps],
        "exact": tree.exact,
        "seen_in": [[sighting_to_json(place) for place in known.seen_in] for known in tree.units],
    }
