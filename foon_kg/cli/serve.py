"""``foon serve``: the page and the API."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, sayer
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.web.service import FoonSource

EXAMPLES = examples(
    "foon serve",
    "foon serve --files subgraphs/ --port 8080",
    "foon serve --cypher",
    "foon serve --host 0.0.0.0 --token-file ~/.foon-token",
    "foon serve --name foon.example.org --proxy 127.0.0.1 --token-file token",
)


def serve(  # noqa: PLR0917 - each parameter is an option of its own
    host: Annotated[
        str, typer.Option(metavar="ADDRESS", help="The address to bind to; another than loopback asks for a token.")
    ] = ("127.0.0.1"),
    port: Annotated[int, typer.Option(metavar="N", min=0, max=65535, help="The port; 0 takes a free one.")] = 8000,
    token_file: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Ask who calls the API for the token in this file (made if missing)."),
    ] = None,
    names: Annotated[
        list[str] | None,
        typer.Option("--name", metavar="NAME", help="Also answer under this name: a proxy serves it so. Repeatable."),
    ] = None,
    proxies: Annotated[
        list[str] | None,
        typer.Option(
            "--proxy",
            metavar="ADDRESS",
            help="Believe this proxy (an address or a network) who asks through it. Repeatable.",
        ),
    ] = None,
    cypher: Annotated[
        bool, typer.Option("--cypher", help="Let who may ask also ask the graph in Cypher, on the page /explore.")
    ] = False,
    files: Files = None,
    jobs: Annotated[
        int | None, typer.Option("--jobs", "-j", metavar="N", min=1, help="Plan in N processes; as a rule all cores.")
    ] = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Serve a page to plan dishes, and the same as JSON.

    /explore is a picture of the FOON to wander through; with --cypher it takes questions in Cypher that only look. The
    JSON is under /api; /api/docs describes it.

    Only programs on this machine can reach it, unless --host says otherwise; then it asks for the token. The page asks
    for it too, or takes it from the address that is printed. Sizes, times and rates are limited. A graph that somebody
    changes is read anew; it may be empty at first. A proxy that serves it under a name of its own is told with --name,
    and has to bring TLS. All who come through it share one rate, unless --proxy says that what it writes into
    X-Forwarded-For is to be believed.
    """
    from foon_kg.foon import Foon
    from foon_kg.web import serving

    say = sayer(quiet=quiet)
    reached = serving.Reached.at(host, names or (), proxies or (), token_file)
    if cypher and files:
        raise UsageError("files cannot be asked in Cypher", hint="Leave out --cypher, or load them into Neo4j.")
    foon = served_foon(files, say)
    in_cypher = partial(Foon.connect, say=say) if cypher else None
    announce = _print_address if as_json else say
    serving.serve(foon, reached, port, announce, jobs=jobs, asked_in_cypher=in_cypher)


def _print_address(address: str) -> None:
    print_json({"address": address})


def served_foon(files: Sequence[Path] | None, say: Say) -> FoonSource:
    """Return the FOON to serve: of ``files``, else of the environment's Neo4j or the local one, and ``say`` which."""
    from foon_kg.cli.knowledge import front_door
    from foon_kg.foon import Foon
    from foon_kg.web.foon import EMPTY, FixedFoon, LiveFoon

    if files:
        with front_door(files, say) as read:
            return FixedFoon(read.snapshot(), read.lessons())
    foon = LiveFoon(lambda: Foon.connect(say=say))
    if foon.edition() == EMPTY:  # what is wrong is said now, and not to the first who asks
        say("The database holds no FOON yet. Load one: foon load foon PATH…; what is loaded is served at once.")
    return foon
