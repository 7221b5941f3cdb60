"""``foon plan --enumerate``: the reference trees between which the choice is (algorithm 3), and the exact search."""

from __future__ import annotations

from typing import TYPE_CHECKING

from foon_kg.cli.console import Say, print_json, print_view

if TYPE_CHECKING:
    from foon_kg.foon import Foon, PlanSettings, Question
    from foon_kg.model.json_fields import JsonObject
    from foon_kg.search import ReferenceTree


def show_candidates(
    question: Question, foon: Foon, settings: PlanSettings, most: int, *, as_json: bool, say: Say
) -> None:
    """Print the reference trees of the goal after which the recipe of ``question`` is made, best first.

    They are looked for in ``foon`` by ``settings``, ``most`` combinations of producers; ``as_json`` prints JSON, and
    ``say`` hears what is noted.
    """
    from foon_kg.formats.views.candidates import candidates_view
    from foon_kg.model.node_json import node_to_json, recipe_to_json

    chosen = foon.candidates(question, settings, most)
    for note in chosen.read.notes:
        say(note)
    if not as_json:
        print_view(candidates_view(chosen.goal, chosen.found, chosen.exact))
        return
    print_json(
        {
            "recipe": recipe_to_json(chosen.read.recipe),
            "goal": node_to_json(chosen.goal.node),
            "exact": _tree(chosen.exact),
            "candidates": [_tree(tree) for tree in chosen.found.trees],
            "complete": chosen.found.complete,
            "looked_at": chosen.found.looked_at,
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
