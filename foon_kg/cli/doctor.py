"""``foon doctor``: what stands in the way."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated

import typer

from foon_kg.cli.console import Json, examples, print_json

EXAMPLES = examples("foon doctor", "foon doctor --thorough --json")
_SIGNS = {"fine": "ok", "note": "note", "fault": "FAULT"}


def doctor(
    *,
    thorough: Annotated[
        bool, typer.Option("--thorough", help="Read every file of the local Neo4j and compare it with its pin.")
    ] = False,
    as_json: Json = False,
) -> None:
    """Look for what stands in the way, and say what to do about it.

    Looked at are Python, the extras, your own tables, ports, the Neo4j that NEO4J_URI names or foon-kg's own (Java,
    disk, its files and start-up cache, whether it answers), its version, what you may do there, its indexes, its FOON,
    and what a Neo4j of others should set. Nothing is started, fetched or changed. Exit code 1 where something will not
    work.
    """
    from foon_kg.foon import ThisMachine

    found = list(ThisMachine.examine(thorough=thorough))
    if as_json:
        print_json([asdict(one) for one in found])
    else:
        for one in found:
            typer.echo(f"{_SIGNS[one.level]:6}{one.subject}: {one.what}")
            if one.remedy:
                typer.echo(f"      {one.remedy}")
    if any(one.level == "fault" for one in found):
        raise typer.Exit(1)
