"""``foon suggest``: what can be made of what is at hand."""

from __future__ import annotations

from typing import Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, examples, print_json, print_view, sayer
from foon_kg.cli.kitchen import KitchenFile

EXAMPLES = examples(
    'foon suggest egg onion "grated cheddar"',
    "foon suggest egg --kitchen kitchen.txt --limit 3 --json",
)


def suggest(
    foods: Annotated[
        list[str] | None,
        typer.Argument(metavar="FOOD...", help="Foods at hand: “egg”, “chopped onion”, “onion, chopped”."),
    ] = None,
    *,
    kitchen: KitchenFile = None,
    limit: Annotated[int, typer.Option("--limit", "-n", metavar="N", min=1, help="Name N dishes at most.")] = 5,
    files: Files = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Name the dishes that the foods at hand make best, of all types.

    Of each dish: what it takes of yours (and what of yours stands for what, how surely), what is missing, what would
    have to be ready in another state, and what is left over. This is proven: it is said of the reference tree that
    lacks the least. Where utensils are named, those that are missing are what foon plan of that dish lacks. The best is
    the dish of which the most is there.

    Utensils that the --kitchen file names are the only ones. For the steps: foon plan --dish TYPE FOOD...
    """
    from foon_kg.cli.knowledge import front_door
    from foon_kg.formats.views.suggestions import suggestions_view

    say = sayer(quiet=quiet)
    with front_door(files, say) as foon:
        stocked = foon.kitchen(kitchen, foods or ())
        for note in stocked.notes:
            say(note)
        found = foon.suggestions(stocked.kitchen, limit)
    if not as_json:
        print_view(suggestions_view(found))
        return
    suggestions = [one.to_json() for one in found.found]
    print_json({"suggestions": suggestions, "considered": found.considered, "proven": found.proven})
