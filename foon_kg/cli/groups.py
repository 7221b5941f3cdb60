"""Groups of commands, all made alike: errors at the edge, drawn help, nothing written over what is read."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, TypeVar

import typer

from foon_kg.cli.console import ErrorsAtTheEdge
from foon_kg.cli.help_pages import HelpedCommand
from foon_kg.model.errors import UsageError

F = TypeVar("F", bound=Callable[..., Any])

_WRITTEN = ("output", "report", "html", "scores_to")
"""The options that name a file to write; every other path is read."""

_READ_IN_FOLDERS = (".csv", ".json", ".lisp", ".txt")
"""How files end that a folder is read for."""


class CommandGroup(typer.Typer):
    """A group of commands; ``options`` are those of ``typer.Typer``."""

    def __init__(self, **options: Any) -> None:  # noqa: ANN401 - whatever typer takes
        alike = {"cls": ErrorsAtTheEdge, "no_args_is_help": True, "rich_markup_mode": None}
        super().__init__(**{**alike, "pretty_exceptions_enable": False, **options})

    def command(self, name: str | None = None, **options: Any) -> Callable[[F], F]:  # noqa: ANN401 - the same
        """Return what makes a command of a function, under ``name`` or else its own."""
        made: Callable[[F], F] = super().command(name, **{"cls": CarefulCommand, **options})
        return made


class CarefulCommand(HelpedCommand):
    """A command that refuses to write over what it reads."""

    def parse_args(self, ctx: typer.Context, args: list[str]) -> list[str]:  # type: ignore[override]
        """Read ``args`` into the context ``ctx``; raises UsageError for an empty path: no folder is meant."""
        given = list(args)
        left: list[str] = super().parse_args(ctx, args)
        empty = any(not one or (one.startswith("--") and one.endswith("=")) for one in given)
        if empty and "." not in given and any(path == Path() for path, _ in _paths(ctx.params)):
            raise UsageError(
                "a path is empty", hint="Is a variable of the shell not set? “.” is the folder you are in."
            )
        return left

    def invoke(self, ctx: typer.Context) -> Any:  # type: ignore[override]  # noqa: ANN401 - as typer has it
        """Run the command in the context ``ctx``; raises UsageError where it would write over a file that it reads."""
        written = dict(_paths({name: ctx.params.get(name) for name in _WRITTEN}))
        read = [path for path, _ in _paths({name: it for name, it in ctx.params.items() if name not in _WRITTEN})]
        for place, name in written.items():
            if _is_read(place, read):
                option = f"--{name.replace('_', '-')}"
                raise UsageError(f"{place}: is read, and would be written over", hint=f"Another file for {option}.")
        return super().invoke(ctx)


def _paths(params: Mapping[str, object]) -> Iterator[tuple[Path, str]]:
    """Yield the paths among the values of parameters, each with the name of its parameter."""
    for name, value in params.items():
        for one in value if isinstance(value, Iterable) and not isinstance(value, str) else [value]:
            if isinstance(one, Path):
                yield one, name


def _is_read(place: Path, read: Iterable[Path]) -> bool:
    """Return whether the file at ``place`` is one of those ``read``, or lies in a folder that is read for its like."""
    if not place.is_file():
        return False
    target = place.resolve()
    in_folders = [path for path in read if path.is_dir()] if place.suffix.lower() in _READ_IN_FOLDERS else []
    return any(path.exists() and path.samefile(target) for path in read) or any(
        path.resolve() in target.parents for path in in_folders
    )
