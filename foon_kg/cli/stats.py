"""``foon stats``: how much a FOON holds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, data, examples, print_json, sayer
from foon_kg.cli.data_frames import driver_without_arrays

if TYPE_CHECKING:
    from foon_kg.store.statistics import Statistics

EXAMPLES = examples("foon stats", "foon stats --json", "foon stats --files subgraphs/")


def stats(files: Files = None, as_json: Json = False, quiet: Quiet = False) -> None:
    """Count what the FOON holds.

    Videos, units, object nodes, labels, states, motions, the goals of each dish type and the most used motions.
    """
    figures = _statistics(files, sayer(quiet=quiet)).to_json()
    if as_json:
        print_json(figures)
        return
    lines = {name: count for name, count in figures.items() if not isinstance(count, Mapping)}
    _print_table("FOON", lines)
    for name, counts in figures.items():
        if isinstance(counts, Mapping):
            _print_table(name, counts)


def _statistics(files: Sequence[Path] | None, say: Say) -> Statistics:
    """Return the figures: of a graph Neo4j counts them, so that it may be of any size."""
    if files:
        from foon_kg.cli.knowledge import snapshot_of
        from foon_kg.store.statistics import Statistics

        return Statistics.of(snapshot_of(files, say))
    with driver_without_arrays():
        from foon_kg.store.graph.counting import count
    from foon_kg.store.graph.connection import Connection
    from foon_kg.store.server import connection_settings

    with Connection(connection_settings(say)) as connection:
        return count(connection)


def _print_table(title: str, counts: Mapping[str, object]) -> None:
    from rich.table import Table

    if not counts:
        typer.echo(f"no {title.replace('_', ' ')}")
        return
    table = Table(title=title.replace("_", " "), show_header=False, title_justify="left", box=None)
    table.add_column()
    table.add_column(justify="right")
    for name, count in counts.items():
        table.add_row(name.replace("_", " "), str(count))
    data().print(table)
