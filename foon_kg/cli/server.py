"""``foon server``: the local Neo4j."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Json, Quiet, examples, print_json, sayer
from foon_kg.cli.groups import CommandGroup

if TYPE_CHECKING:
    from foon_kg.store.server import Status

app = CommandGroup(name="server", help="The local Neo4j, for whoever names no other in NEO4J_URI.")

MEGABYTE = 1_000_000


@app.command(epilog=examples("foon server start", "foon server start --idle 120 --port 7687"))
def start(
    *,
    port: Annotated[
        int | None,
        typer.Option(
            metavar="N", min=1024, max=65535, help="Listen on this port; otherwise on the one it had, first a free one."
        ),
    ] = None,
    idle: Annotated[
        int | None, typer.Option(min=0, metavar="MINUTES", help="Stop after so long without use; 0 is never. [30]")
    ] = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Start the local Neo4j, or find that it runs. The first start fetches it (180 MB).

    It listens on this machine only, keeps its data in the user's data folder (FOON_KG_HOME names another), and stays up
    between commands. Every command that needs a database and finds no NEO4J_URI starts it by itself.
    """
    from foon_kg.foon import ThisMachine

    _show(ThisMachine.start_server(port=port, idle_minutes=idle, say=sayer(quiet=quiet)), as_json=as_json)


@app.command(epilog=examples("foon server stop"))
def stop(*, as_json: Json = False, quiet: Quiet = False) -> None:
    """Stop the local Neo4j; its data stays."""
    from foon_kg.foon import ThisMachine

    stopped = ThisMachine.stop_server(say=sayer(quiet=quiet))
    if as_json:
        print_json({"stopped": stopped})
    elif not stopped:
        typer.echo("The local Neo4j was not running.")


@app.command(epilog=examples("foon server status", "foon server status --json"))
def status(*, as_json: Json = False) -> None:
    """Tell whether the local Neo4j runs.

    Also where it answers, and where its data, password and log are.
    """
    from foon_kg.foon import ThisMachine

    _show(ThisMachine.server_status(), as_json=as_json)


def _show(now: Status, *, as_json: bool) -> None:
    if as_json:
        print_json(asdict(now))
        return
    idle = f"stops after {now.idle_minutes:g} minutes without use" if now.idle_minutes else "runs until it is stopped"
    if now.running:
        typer.echo(f"Neo4j {now.version} answers at {now.uri} (user {now.user}); it {idle}.")
        typer.echo(f"  process   {now.pid}, {(now.memory or 0) // MEGABYTE} MB")
    else:
        typer.echo(f"The local Neo4j ({now.version}) is not running.")
    typer.echo(f"  data      {now.data}\n  password  {now.password_file}\n  log       {now.log_file}")
    typer.echo(f"  start-up cache: {now.startup_cache}")
    if now.started_again:
        typer.echo(f"  started again by itself, last at {now.started_again}")
