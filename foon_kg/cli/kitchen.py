"""What is at hand for a command: what ``--kitchen FILE`` names, else every utensil and whatever shops sell."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Say

if TYPE_CHECKING:
    from foon_kg.foon import Foon
    from foon_kg.plans.kitchen import Kitchen

KitchenFile = Annotated[
    Path | None,
    typer.Option("--kitchen", metavar="FILE", help="What is at hand: utensils, foods, or both, one a line or JSON."),
]


def kitchen_of(file: Path | None, foon: Foon, say: Say) -> Kitchen:
    """Return the kitchen that ``file`` describes, by the words of ``foon``.

    What had to be decided to read it goes to ``say``.
    """
    from foon_kg.plans.kitchen import Kitchen

    if file is None:
        return Kitchen.default()
    read = foon.kitchen(file)
    for note in read.notes:
        say(note)
    return read.kitchen
