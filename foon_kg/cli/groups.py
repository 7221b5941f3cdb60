"""Groups of commands, all made alike: errors at the edge, help that is drawn on a terminal."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import typer

from foon_kg.cli.console import ErrorsAtTheEdge
from foon_kg.cli.help_pages import HelpedCommand

F = TypeVar("F", bound=Callable[..., Any])


class CommandGroup(typer.Typer):
    """A group of commands; ``options`` are those of ``typer.Typer``."""

    def __init__(self, **options: Any) -> None:  # noqa: ANN401 - whatever typer takes
        alike = {"cls": ErrorsAtTheEdge, "no_args_is_help": True, "rich_markup_mode": None}
        super().__init__(**{**alike, "pretty_exceptions_enable": False, **options})

    def command(self, name: str | None = None, **options: Any) -> Callable[[F], F]:  # noqa: ANN401 - the same
        """Return what makes a command of a function, under ``name`` or else its own."""
        made: Callable[[F], F] = super().command(name, **{"cls": HelpedCommand, **options})
        return made
