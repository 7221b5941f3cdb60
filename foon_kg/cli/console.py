"""What every command shares: data to stdout, messages to stderr, errors as one readable line at the edge.

Exit codes: 0 done, 1 failed, 2 wrong usage, 3 no tree; the error itself knows which (``FoonError.exit_code``).
"""

from __future__ import annotations

import errno
import json
import os
import sys
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from foon_kg.cli.help_pages import HelpedGroup
from foon_kg.cli.streams import data, messages
from foon_kg.model.errors import FoonError, UsageError
from foon_kg.model.written_files import NO_ROOM, no_room

if TYPE_CHECKING:
    from rich.console import RenderableType

_JSON_ASKED = "foon_kg.cli.json"


def _remember(context: typer.Context, asked: bool) -> bool:
    context.meta[_JSON_ASKED] = asked
    return asked


Json = Annotated[
    bool, typer.Option("--json", callback=_remember, is_eager=True, help="Print the answer as JSON, an error too.")
]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Print no messages, only data and errors.")]
Files = Annotated[
    list[Path] | None,
    typer.Option("--files", metavar="DIR", help="Answer from these subgraph files or folders, without a database."),
]

AsText = Annotated[bool, typer.Option("--foon", help="Print the tree as FOON text.")]
Dask = Annotated[
    str | None,
    typer.Option("--dask", metavar="ADDRESS", help="Plan on the workers of this Dask scheduler (extra “cluster”)."),
]

Say = Callable[[str], None]
"""Takes one line for the person at the terminal."""


def examples(*lines: str) -> str:
    """Return the end of a command's help: its examples, each on a line of its own."""
    return "\b\nExamples:\n" + "\n".join(f"  {line}" for line in lines)


_WRONG_USAGE: Any = typer.BadParameter.__base__
"""What typer raises for a command line that cannot be read; it has no public name of its own there."""


def _asks_json(words: Sequence[str]) -> bool:
    return "--json" in words[: words.index("--") if "--" in words else len(words)]


def _as_ours(error: Any) -> FoonError:  # noqa: ANN401 - see _WRONG_USAGE
    """Return the error of a command line that cannot be read, with where its help is; help that was asked for stays."""
    if type(error).__name__ == "NoArgsIsHelpError":
        raise error
    message = " ".join(error.format_message().split()).rstrip(".")
    command = error.ctx.command_path if error.ctx is not None else "foon"
    return UsageError(message[:1].lower() + message[1:], hint=f"{command} --help says what there is.")


class ErrorsAtTheEdge(HelpedGroup):
    """The root of the commands: turns a :class:`~foon_kg.model.errors.FoonError` into a message and its exit code.

    Where JSON was asked for, stdout gets the error as one more JSON value: ``{"error": {"code", "message", "hint"}}``.
    """

    def make_context(self, info_name: str | None, args: list[str], parent: Any = None, **extra: Any) -> Any:  # noqa: ANN401 - as typer has it
        """Return the context of the program ``info_name`` below its ``parent``.

        Its own options are read from ``args``.
        """
        asked = _asks_json(args)
        try:
            context = super().make_context(info_name, args, parent, **extra)
        except _WRONG_USAGE as error:
            raise self._reported(asked, _as_ours(error)) from error
        context.meta[_JSON_ASKED] = asked  # a command that cannot be read remembers nothing
        return context

    def invoke(self, ctx: typer.Context) -> Any:  # type: ignore[override]  # noqa: ANN401 - as typer has it
        """Run the command that was asked for, in the context ``ctx``."""
        try:
            return super().invoke(ctx)
        except _WRONG_USAGE as error:
            raise self._reported(ctx.meta[_JSON_ASKED], _as_ours(error)) from error
        except FoonError as error:
            raise self._reported(ctx.meta[_JSON_ASKED], error) from error
        except ModuleNotFoundError as error:
            from foon_kg.model.extras import missing

            lacks = missing(error)
            if lacks is None:
                raise
            raise self._reported(ctx.meta[_JSON_ASKED], lacks) from error

    def main(self, *arguments: Any, **options: Any) -> Any:  # noqa: ANN401 - as typer has it
        """Run the program; where a disk is full, or nobody reads stdout any more, end it in order."""
        try:
            try:
                return super().main(*arguments, **options)
            finally:
                sys.stdout.flush()  # what fails later nobody can be told
        except OSError as error:
            if error.errno not in {*NO_ROOM, errno.EPIPE}:
                raise
            _give_up_stdout()
            if error.errno != errno.EPIPE:
                show_error(no_room(error.filename or "standard output"))
            sys.exit(1)

    @staticmethod
    def _reported(as_json: bool, error: FoonError) -> typer.Exit:
        """Print an error, and return the end of the program that it asks for."""
        show_error(error)
        if as_json:
            from foon_kg.plans.result import error_to_json

            print_json({"error": error_to_json(error)})
        return typer.Exit(error.exit_code)


def _give_up_stdout() -> None:
    """Drop what is still to be written to stdout where it takes nothing any more.

    Otherwise Python tries once more at its end, and says what went wrong in words of its own.
    """
    try:
        sys.stdout.flush()
    except OSError:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)


@dataclass(frozen=True)
class Sayer:
    """Prints lines to stderr, or keeps them to itself; and shows there, on a terminal, what is waited for."""

    quiet: bool

    def __call__(self, text: str) -> None:
        """Print one line."""
        messages(quiet=self.quiet).print(text, markup=False)

    def waiting(self, text: str) -> AbstractContextManager[object]:
        """Say with ``text`` what begins; for as long as it lasts a terminal shows the seconds."""
        from foon_kg.cli.runs import counting

        if self.quiet or not messages().is_terminal:
            self(text)
            return nullcontext()
        return counting(text, after=0)


def where_said(*, quiet: bool) -> str:
    """Return the hint of an error of which the lines before it say what is wrong, unless ``quiet`` kept them back."""
    return "Without --quiet each line that is wrong is told." if quiet else "The lines above say what is wrong."


def sayer(*, quiet: bool) -> Sayer:
    """Return what prints a line to stderr, or where it shall be ``quiet``, keeps it to itself."""
    return Sayer(quiet)


def print_view(view: RenderableType) -> None:
    """Print what a view made; into a file or a pipe without colours and without spaces at the ends of lines."""
    console = data()
    if console.is_terminal:
        console.print(view)
        return
    with console.capture() as captured:
        console.print(view)
    typer.echo("\n".join(line.rstrip() for line in captured.get().splitlines()))


def print_json(value: object) -> None:
    """Print one JSON value on one line of stdout."""
    typer.echo(json_line(value))


def json_line(value: object) -> str:
    """Return a JSON value as one line."""
    return json.dumps(value, ensure_ascii=False)


def show_error(error: FoonError, about: str | None = None) -> None:
    """Print the ``error`` (of which of many, ``about``) on one line of stderr, and what to do on the next."""
    console = messages()
    console.print("error:", style="bold red", end=" ")
    console.print(f"{about}: {error.message}" if about else error.message, markup=False)
    if error.hint:
        console.print("hint:", style="bold", end=" ")
        console.print(error.hint, markup=False)
