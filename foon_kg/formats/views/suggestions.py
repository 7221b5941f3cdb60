"""Suggestions as lines of a terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.text import Text

from foon_kg.formats.views.words import ASIDE, UNSEEN, UNSEEN_SIGN, in_a_row, node_words
from foon_kg.planning.suggestion import Suggestion, Suggestions, Taken


def suggestions_view(suggestions: Suggestions) -> RenderableType:
    """Return each dish of ``suggestions`` with what of one's own it takes, what is missing and what is left over."""
    dishes = [_dish(number, one) for number, one in enumerate(suggestions.found, 1)]
    proven = f"{suggestions.considered} dishes were compared by name, and of {suggestions.proven} the trees."
    return Group(*dishes, Text(proven, ASIDE))


def _dish(number: int, one: Suggestion) -> RenderableType:
    videos = f" · {one.goal.videos[0]}" if one.goal.videos else ""
    head = Text.assemble(
        (f"{number} ", ASIDE),
        (one.goal.node.label, "bold"),
        f" ({one.goal.dish_type}): {one.share:.0%} is there, {one.units} steps",
        (videos, ASIDE),
    )
    return Group(head, Padding(Group(*_details(one)), (0, 0, 0, 3)))


def _details(one: Suggestion) -> Iterator[RenderableType]:
    yield Text.assemble("takes ", in_a_row(map(_taken, one.taken), ", "))
    if one.missing:
        yield Text.assemble(("missing ", "bold"), ", ".join(one.missing))
    if one.assumed:
        yield Text.assemble("to have ready ", in_a_row(map(node_words, one.assumed), ", "))
    if one.unused:
        yield Text(f"leaves {', '.join(one.unused)}", ASIDE)
    if not one.exact:
        yield Text("the best tree found in time; another may lack less", ASIDE)


def _taken(taken: Taken) -> Text:
    if taken.confidence >= 1:
        return Text(taken.own)
    return Text.assemble((UNSEEN_SIGN + taken.own, UNSEEN), f" for {taken.food} ({taken.confidence:.2f})")
