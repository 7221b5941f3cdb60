"""What the commands of ``foon evaluate`` have in common: their options, and where they work and write."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

import typer

from foon_kg.cli.console import Say
from foon_kg.model.written_files import check_place, write_file

Dish = Annotated[list[str] | None, typer.Option("--dish", metavar="TYPE", help="Only this dish type.")]
Seed = Annotated[int, typer.Option("--seed", metavar="S", help="The same seed draws the same samples.")]
Output = Annotated[
    Path | None,
    typer.Option("--output", "-o", metavar="FILE", help="Keep the answers in this file, and go on where it ends."),
]
Html = Annotated[
    Path | None, typer.Option("--html", metavar="FILE.html", help="Write a report too: a page that stands on its own.")
]
Compare = Annotated[
    Path | None,
    typer.Option("--compare", metavar="OLD.json", help="Say what got better or worse since this (from --json)."),
]
Method = Annotated[
    Literal["frames", "paper"],
    typer.Option("--method", help="For comparison: paper is its four algorithms to the letter."),
]
Jobs = Annotated[
    int | None, typer.Option("--jobs", "-j", metavar="N", min=1, help="Plan in N processes; as a rule all cores.")
]


@dataclass(frozen=True)
class Run:
    """How a run works: the file that keeps its answers, its processes or its cluster, and where messages go."""

    output: Path | None
    jobs: int | None
    dask: str | None
    say: Say
    quiet: bool
    method: Literal["frames", "paper"] = "frames"


_CAN_BE_WRITTEN = "{} names a file that can be written."


def check_places(**places: Path | None) -> None:
    """Raise UsageError where one of ``places`` cannot be written; it is said by its option, before anything is planned.

    >>> check_places(html=None, scores_to=Path("sheet.csv"))
    """
    for name, path in places.items():
        if path is not None:
            check_place(path, _CAN_BE_WRITTEN.format(f"--{name.replace('_', '-')}"))


def write_text(path: Path, text: str, option: str) -> None:
    """Write ``text`` to the file at ``path`` that ``option`` names; raises UsageError where that cannot be."""
    write_file(path, text, _CAN_BE_WRITTEN.format(option))
