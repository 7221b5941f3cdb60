"""The command line: ``foon``."""

from __future__ import annotations

import gc
import os
from typing import Annotated

import typer

from foon_kg import __version__
from foon_kg.cli import data_frames
from foon_kg.cli.commands import RootCommand
from foon_kg.cli.groups import CommandGroup

app = CommandGroup(
    cls=RootCommand,
    name="foon",
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


def main() -> None:
    """Run ``foon``; the installed program begins in :mod:`foon_kg.__main__`."""
    gc.set_threshold(1_000_000, 50, 100)  # a command makes many small values and ends: they are not worth collecting
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # numpy's matrices are small here: its threads cost their start
    data_frames.leave_out()
    app()
