"""Why a plan makes every ingredient as it does, as lines of a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.console import Group, RenderableType
from rich.padding import Padding
from rich.text import Text

from foon_kg.formats.views.words import ASIDE, STATE
from foon_kg.planning.explanation import Explanation, Joining, PassedOver


def explanation_view(explanations: Sequence[Explanation]) -> RenderableType:
    """Return for each of the ``explanations`` where a food comes from, where it joins, and what was passed over."""
    parts: list[RenderableType] = [Text(), Text("Why each ingredient is made so", "bold")]
    for one in explanations:
        name = Text.assemble(one.want.object, " (", (one.want.state, STATE), ")")
        parts.append(Padding(name, (0, 0, 0, 2)))
        parts.append(Padding(Group(*_sentences(one)), (0, 0, 0, 4)))
    return Group(*parts)


def _sentences(one: Explanation) -> Iterator[Text]:
    yield Text(_origin(one) + _renamed(one))
    if one.joins is not None:
        yield Text(_place(one.joins))
    for why in dict.fromkeys(other.why for other in one.passed_over):
        names = ", ".join(_name(other) for other in one.passed_over if other.why == why)
        yield Text(f"not like {names}: {why}", ASIDE)


def _origin(one: Explanation) -> str:
    seen = f" in {', '.join(one.videos)}" if one.videos else ""
    like = one.label if one.label != one.want.object else "it"
    sure = f", {one.confidence:.2f} sure" if one.confidence < 1 else ""
    chosen = ", as you chose" if one.chosen else ""
    match one.how:
        case "played":
            return f"has a place in the recorded dish, and is handled as FOON handles {like}{seen}{sure}{chosen}"
        case "made":
            return f"is made ready as FOON makes {like}{seen}{sure}{chosen}"
        case "sold":
            return "joins as it is sold"
        case "assumed":
            return "is assumed to be there: nothing in this FOON, nor any fair equivalent, makes it so"
        case "missing":
            return "does not get into this dish"


def _renamed(one: Explanation) -> str:
    pairs = [f"“{asked}” is read as {meant}" for asked, meant in one.renamed]
    return f" ({', '.join(pairs)})" if pairs else ""


def _place(joins: Joining) -> str:
    where = f"joins the others in step {joins.step} ({joins.motion})" if joins.step else f"joins in “{joins.motion}”"
    if joins.like and round(joins.likeness, 1) > 0:
        return f"{where}, where {joins.like} joins in the recorded dish ({joins.likeness:.2f} like it)"
    if joins.left_open:
        return f"{where}, in the place of {', '.join(joins.left_open)}, which nobody asked for"
    return where


def _name(other: PassedOver) -> str:
    return f"{other.state} {other.label} ({other.confidence:.2f})".strip()
