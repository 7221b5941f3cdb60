"""How help looks: in panels with colour on a terminal, as plain text anywhere else.

Plain help imports nothing that draws, fits 80 columns, and lists the commands in the same groups as the panels do.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from copy import copy
from typing import TYPE_CHECKING, Any

from typer.core import TyperCommand, TyperGroup

if TYPE_CHECKING:
    import typer

OTHERS = "Commands"
"""The group of a command that names none."""


class HelpedCommand(TyperCommand):
    """A command whose help is drawn where somebody looks at it."""

    def collect_usage_pieces(self, ctx: typer.Context) -> list[str]:  # type: ignore[override]
        """Return what stands behind the command's name in the usage line, in the context ``ctx``."""
        return [_plainly(piece) for piece in super().collect_usage_pieces(ctx)]

    def get_params(self, ctx: typer.Context) -> list[Any]:  # type: ignore[override]
        """Return the parameters in the context ``ctx``, without types of Python: their names say what they take."""
        found: list[Any] = super().get_params(ctx)
        for one in found:
            if one.param_type_name == "argument":
                one.display_type_rich = _no_type
        return found

    def format_help(self, ctx: typer.Context, formatter: Any) -> None:  # type: ignore[override]  # noqa: ANN401 - typer's
        """Write the help, or draw it on a terminal."""
        if sys.stdout.isatty():
            _draw(self, ctx)
        else:
            super().format_help(ctx, formatter)


class HelpedGroup(TyperGroup):
    """A group of commands whose help is drawn where somebody looks at it."""

    def format_help(self, ctx: typer.Context, formatter: Any) -> None:  # type: ignore[override]  # noqa: ANN401 - typer's
        """Write the help, or draw it on a terminal."""
        if sys.stdout.isatty():
            _draw(self, ctx)
        else:
            super().format_help(ctx, formatter)

    def format_commands(self, ctx: typer.Context, formatter: Any) -> None:  # type: ignore[override]  # noqa: ANN401 - typer's
        """Write the commands of the context ``ctx`` with ``formatter``, each group below its heading."""
        panels: dict[str, list[tuple[str, str]]] = {}
        commands = {name: self.get_command(ctx, name) for name in self.list_commands(ctx)}
        longest = max(map(len, commands), default=0)
        for name, command in commands.items():
            if command is not None and not command.hidden:
                panel = getattr(command, "rich_help_panel", None) or OTHERS
                short = command.get_short_help_str(formatter.width - 6 - longest)
                panels.setdefault(panel, []).append((name.ljust(longest), short))
        for panel, rows in panels.items():
            with formatter.section(panel):
                formatter.write_dl(rows)


def _plainly(piece: str) -> str:
    """Return an argument of the usage line as people write it: ``PATH...``; ``[FOOD...]`` where it may be missing."""
    name, may_be_missing = piece.removesuffix("...")[1:-1], piece.startswith("[")
    if piece == "[OPTIONS]" or piece[:1] not in {"[", "{"}:
        return piece
    dots = "..." if piece.endswith("...") and not name.endswith("...") else ""
    return f"[{name}{dots}]" if may_be_missing else f"{name}{dots}"


def _no_type(ctx: typer.Context) -> None:  # noqa: ARG001 - what it is called with
    return None


def _draw(command: HelpedCommand | HelpedGroup, ctx: typer.Context) -> None:
    """Draw the help of a command with rich, which typer does; our texts have no markup, and flow."""
    from rich.markup import escape
    from typer.rich_utils import rich_format_help

    shown = copy(command)
    shown.help = "\n\n".join(map(escape, _paragraphs(command.help or "")))
    shown.epilog = None if command.epilog is None else escape(command.epilog.replace("\b\n", ""))
    options = [_escaped(option) for option in command.get_params(ctx)]
    shown.get_params = lambda ctx: options  # type: ignore[method-assign]  # noqa: ARG005 - what it is called with
    rich_format_help(obj=shown, ctx=ctx, markup_mode="rich")


def _paragraphs(text: str) -> Iterator[str]:
    for paragraph in text.split("\n\n"):
        if paragraph.startswith("\b"):
            yield paragraph.removeprefix("\b").strip("\n")
        else:
            yield " ".join(line.strip() for line in paragraph.splitlines())


def _escaped(option: Any) -> Any:  # noqa: ANN401 - a parameter of typer's own click
    from rich.markup import escape

    shown = copy(option)
    shown.help = escape(option.help or "")
    if getattr(option, "is_flag", False):
        shown.metavar = ""  # it takes no value: its type says nothing
    return shown
