"""Which commands there are, and where each is defined: what is not asked for is neither imported nor built.

A command of its own is the function of its name with its examples; a group of commands is the ``app`` of its module.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, MutableMapping
from importlib import import_module
from typing import Any, cast

import typer

from foon_kg.cli.console import ErrorsAtTheEdge

HOMES: Mapping[str, tuple[str, str]] = {
    "demo": ("demo", "EXAMPLES"),
    "plan": ("plan", "EXAMPLES"),
    "retrieve": ("retrieve", "EXAMPLES"),
    "check": ("check", "EXAMPLES"),
    "show": ("show", "EXAMPLES"),
    "export": ("export", "EXAMPLES"),
    "suggest": ("suggest", "EXAMPLES"),
    "similar": ("similar", "EXAMPLES"),
    "recipes": ("recipes", "EXAMPLES"),
    "diff": ("videos", "DIFF_EXAMPLES"),
    "remove": ("videos", "REMOVE_EXAMPLES"),
    "stats": ("stats", "EXAMPLES"),
    "cypher": ("cypher", "EXAMPLES"),
    "serve": ("serve", "EXAMPLES"),
    "mcp": ("mcp", "EXAMPLES"),
    "doctor": ("doctor", "EXAMPLES"),
    "evaluate": ("evaluate", ""),
    "load": ("load", ""),
    "draft": ("draft", ""),
    "server": ("server", ""),
}
"""The module of each command and the name of its examples there; a group has its own."""


class Commands(Mapping[str, Any]):
    """The commands by name, each made when it is first asked for (typer has a click of its own: they are Any)."""

    def __init__(self) -> None:
        self._made: dict[str, Any] = {}

    def __getitem__(self, name: str) -> Any:  # noqa: ANN401 - as above
        """Return a command; raises KeyError where there is none of this name."""
        if name not in self._made:
            self._made[name] = _made(name, *HOMES[name])
        return self._made[name]

    def __contains__(self, name: object) -> bool:
        return name in HOMES

    def __iter__(self) -> Iterator[str]:
        return iter(HOMES)

    def __len__(self) -> int:
        return len(HOMES)


def _made(name: str, module: str, examples: str) -> Any:  # noqa: ANN401 - as above
    home = import_module(f"foon_kg.cli.{module}")
    if not examples:
        return typer.main.get_group(home.app)
    alone = typer.Typer(add_completion=False, rich_markup_mode=None, pretty_exceptions_enable=False)
    alone.command(name, epilog=getattr(home, examples))(getattr(home, name))
    return typer.main.get_command(alone)


class Foon(ErrorsAtTheEdge):
    """The root of all commands."""

    def __init__(self, **attributes: Any) -> None:  # noqa: ANN401 - whatever typer gives to a group
        super().__init__(**attributes)
        self.commands = cast("MutableMapping[str, Any]", Commands())
