"""``foon suggest``: what can be made of what is at hand."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, print_view, sayer
from foon_kg.cli.kitchen import KitchenFile, kitchen_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from foon_kg.model.knowledge import Vocabulary
    from foon_kg.plans.kitchen import Kitchen
    from foon_kg.plans.stock import StockedKitchen

EXAMPLES = examples(
    'foon suggest egg onion "grated cheddar"',
    "foon suggest egg --kitchen kitchen.txt --most 3 --json",
)


def suggest(
    foods: Annotated[
        list[str] | None,
        typer.Argument(metavar="FOOD...", help="Foods at hand: “egg”, “chopped onion”, “onion, chopped”."),
    ] = None,
    *,
    kitchen: KitchenFile = None,
    most: Annotated[int, typer.Option("--most", "-n", metavar="N", min=1, help="Name N dishes at most.")] = 5,
    files: Files = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Name the dishes that the foods at hand make best, of all types.

    Of each dish: what it takes of yours (and what of yours stands for what, how surely), what is missing, what would
    have to be ready in another state, and what is left over. This is proven: it is said of the reference tree that
    lacks the least. The best is the dish of which the most is there.

    Utensils that the --kitchen file names are the only ones. For the steps: foon plan --dish TYPE FOOD...
    """
    from foon_kg.cli.knowledge import open_knowledge
    from foon_kg.formats.views.suggestions import suggestions_view
    from foon_kg.planning.suggestion import suggest as suggested

    say = sayer(quiet=quiet)
    with open_knowledge(files, say) as view:
        named = kitchen_of(kitchen, view.vocabulary(), say)
        stocked = _with_foods(foods or (), named, view.vocabulary(), say)
        found = suggested(view, stocked, most=most)
    if not as_json:
        print_view(suggestions_view(found))
        return
    suggestions = [one.to_json() for one in found.found]
    print_json({"suggestions": suggestions, "considered": found.considered, "proven": found.proven})


def _with_foods(texts: Sequence[str], kitchen: Kitchen, vocabulary: Vocabulary, say: Say) -> StockedKitchen:
    """Answer ``kitchen`` with the foods in words as well; what of them was not understood goes to ``say``."""
    from foon_kg.planning.kitchen_file import Entry, ThingReader
    from foon_kg.planning.recipes import IngredientWords
    from foon_kg.plans.kitchen import Kitchen
    from foon_kg.plans.stock import StockedKitchen

    stocked = kitchen if isinstance(kitchen, StockedKitchen) else StockedKitchen.of(kitchen, ())
    reader = ThingReader(IngredientWords(vocabulary, Kitchen.default()))
    things = []
    for text in texts:
        thing, notes = reader.read(Entry(f"“{text}”", text))
        things.append(thing)
        for note in notes:
            say(note)
    return stocked.with_things(things)
