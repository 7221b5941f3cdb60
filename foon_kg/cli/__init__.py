"""The command line: ``foon``."""

from __future__ import annotations

import gc
from typing import Annotated

import typer

from foon_kg import __version__
from foon_kg.cli import (
    check,
    cypher,
    data_frames,
    demo,
    doctor,
    draft,
    evaluate,
    export,
    load,
    mcp,
    plan,
    recipes,
    retrieve,
    serve,
    server,
    show,
    similar,
    stats,
    suggest,
    videos,
)
from foon_kg.cli.console import ErrorsAtTheEdge

app = typer.Typer(
    cls=ErrorsAtTheEdge,
    name="foon",
    no_args_is_help=True,
    rich_markup_mode=None,  # plain help is quick to print and fits any width
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="Exit codes: 0 done, 1 failed, 2 wrong usage, 3 no tree.",
)


def _show_version(asked: bool) -> None:
    if asked:
        typer.echo(f"foon-kg {__version__}")
        raise typer.Exit


@app.callback()
def foon(
    version: Annotated[
        bool, typer.Option("--version", callback=_show_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """Plan the steps that make a dish from a knowledge graph of cooking videos, even for recipes nobody recorded."""


app.command(epilog=demo.EXAMPLES)(demo.demo)
app.command(epilog=plan.EXAMPLES)(plan.plan)
app.command(epilog=retrieve.EXAMPLES)(retrieve.retrieve)
app.command(epilog=check.EXAMPLES)(check.check)
app.add_typer(evaluate.app)
app.command(epilog=show.EXAMPLES)(show.show)
app.command(epilog=export.EXAMPLES)(export.export)
app.command(epilog=suggest.EXAMPLES)(suggest.suggest)
app.command(epilog=similar.EXAMPLES)(similar.similar)
app.add_typer(load.app)
app.add_typer(draft.app)
app.command(epilog=recipes.EXAMPLES)(recipes.recipes)
app.command(epilog=videos.DIFF_EXAMPLES)(videos.diff)
app.command(epilog=videos.REMOVE_EXAMPLES)(videos.remove)
app.command(epilog=stats.EXAMPLES)(stats.stats)
app.command(epilog=cypher.EXAMPLES)(cypher.cypher)
app.command(epilog=serve.EXAMPLES)(serve.serve)
app.command(epilog=mcp.EXAMPLES)(mcp.mcp)
app.command(epilog=doctor.EXAMPLES)(doctor.doctor)
app.add_typer(server.app)


def main() -> None:
    """Run ``foon`` (the entry point of the installed program)."""
    gc.set_threshold(100_000, 50, 100)  # a command makes many small values and ends: they are not worth collecting
    data_frames.leave_out()
    app()
