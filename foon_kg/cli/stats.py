"""``foon stats``: how much a FOON holds."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import nullcontext

import typer

from foon_kg.cli.console import Files, Json, Quiet, examples, print_json, sayer
from foon_kg.cli.data_frames import driver_without_arrays
from foon_kg.cli.streams import data

EXAMPLES = examples("foon stats", "foon stats --json", "foon stats --files subgraphs/")


def stats(files: Files = None, as_json: Json = False, quiet: Quiet = False) -> None:
    """Count what the FOON holds.

    Videos, units, object nodes, labels, states, motions, the goals of each dish type and the most used motions.
    """
    from foon_kg.cli.knowledge import front_door

    with front_door(files, sayer(quiet=quiet)) as foon, nullcontext() if files else driver_without_arrays():
        figures = foon.statistics().to_json()
    if as_json:
        print_json(figures)
        return
    lines = {name: count for name, count in figures.items() if not isinstance(count, Mapping)}
    _print_table("FOON", lines)
    for name, counts in figures.items():
        if isinstance(counts, Mapping):
            _print_table(name, counts)


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
