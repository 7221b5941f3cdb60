"""Which commands there are, and where each is defined: what is not asked for is neither imported nor built.

A command of its own is the function of its name with its examples; a group of commands is the ``app`` of its module.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, MutableMapping
from importlib import import_module
from typing import Any, NamedTuple, cast

import typer

from foon_kg.cli.console import ErrorsAtTheEdge
from foon_kg.cli.groups import CommandGroup


class Home(NamedTuple):
    """Where a command is: the group it is listed in, its module, and the name of its examples there."""

    panel: str
    module: str
    examples: str = "EXAMPLES"
    """Empty for a group of commands, which has its own."""


BEGIN, PLAN, LOOK, FOON, SERVE, MEASURE = "Begin", "Plan", "Look at trees", "The FOON", "Serve", "Measure"

HOMES: Mapping[str, Home] = {
    "demo": Home(BEGIN, "demo"),
    "doctor": Home(BEGIN, "doctor"),
    "server": Home(BEGIN, "server", ""),
    "plan": Home(PLAN, "plan"),
    "suggest": Home(PLAN, "suggest"),
    "similar": Home(PLAN, "similar"),
    "retrieve": Home(PLAN, "retrieve"),
    "show": Home(LOOK, "show"),
    "check": Home(LOOK, "check"),
    "export": Home(LOOK, "export"),
    "load": Home(FOON, "load", ""),
    "draft": Home(FOON, "draft", ""),
    "diff": Home(FOON, "videos", "DIFF_EXAMPLES"),
    "remove": Home(FOON, "videos", "REMOVE_EXAMPLES"),
    "stats": Home(FOON, "stats"),
    "recipes": Home(FOON, "recipes"),
    "cypher": Home(FOON, "cypher"),
    "serve": Home(SERVE, "serve"),
    "mcp": Home(SERVE, "mcp"),
    "evaluate": Home(MEASURE, "evaluate", ""),
}


class Commands(Mapping[str, Any]):
    """The commands by name, each made when it is first asked for (typer has a click of its own: they are Any)."""

    def __init__(self) -> None:
        self._made: dict[str, Any] = {}

    def __getitem__(self, name: str) -> Any:  # noqa: ANN401 - as above
        """Return a command; raises KeyError where there is none of this name."""
        if name not in self._made:
            self._made[name] = _made(name, HOMES[name])
        return self._made[name]

    def __contains__(self, name: object) -> bool:
        return name in HOMES

    def __iter__(self) -> Iterator[str]:
        return iter(HOMES)

    def __len__(self) -> int:
        return len(HOMES)


def _made(name: str, home: Home) -> Any:  # noqa: ANN401 - as above
    there = import_module(f"foon_kg.cli.{home.module}")
    if home.examples:
        alone = CommandGroup(add_completion=False)
        alone.command(name, epilog=getattr(there, home.examples))(getattr(there, name))
        made: Any = typer.main.get_command(alone)
    else:
        made = typer.main.get_group(there.app)
    made.rich_help_panel = home.panel
    return made


class RootCommand(ErrorsAtTheEdge):
    """The root of all commands."""

    def __init__(self, **attributes: Any) -> None:  # noqa: ANN401 - whatever typer gives to a group
        super().__init__(**attributes)
        self.commands = cast("MutableMapping[str, Any]", Commands())
