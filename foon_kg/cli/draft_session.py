"""``foon draft review`` at a terminal: a draft decided on row by row, each beside what was said; one key accepts."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from foon_kg.cli.keys import Keys
from foon_kg.cli.streams import data
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.model.nodes import name_of_file, one_spelling
from foon_kg.model.written_files import write_file

if TYPE_CHECKING:
    from rich.console import RenderableType

    from foon_kg.foon import Decision, Review

ASKED = ("motion", "inputs", "outputs", "dish")
"""The cells of a row that are edited, in this order."""

_KEYS = "Enter accept · e edit · d leave out · s later · b back · u undo · q quit"


def review_in_person(path: Path, output: Path | None) -> bool:
    """Ask a person about the draft at ``path`` until nothing is left or they quit; return whether it is decided.

    Each decision is in the file at once, so that the next review goes on from there. A draft that is decided is written
    as FOON text to ``output``, beside the draft where that is ``None``.
    """
    from foon_kg.foon import Review

    if output is not None and output.suffix.lower() != ".txt":
        raise UsageError(f"{output}: what is decided is FOON text", hint="Its name ends in .txt.")
    session = ReviewSession(path, Review.of(read_table(path), name_of_file(path), str(path)))
    with session.keys.open(), suppress(KeyboardInterrupt):  # pressed while a row is still being shown
        session.ask()
    if session.review.decisions:
        left = len(session.review.decisions)
        typer.echo(f"{path}: {left} of its rows are to be decided; foon draft review {path} goes on there.")
        return False
    target = write_subgraph(session.review, output or path.with_suffix(".txt"))
    typer.echo(f"{path}: all is decided. {target}: {session.review.units} units; foon load foon {target} takes it.")
    return True


def read_table(path: Path) -> str:
    """Return the text of the table at ``path``; raises ReadError where it cannot be read."""
    from foon_kg.loaders.notices import UnreadableFile
    from foon_kg.loaders.paths import decode
    from foon_kg.model.regular_files import read_bytes

    try:
        return decode(read_bytes(path))
    except UnreadableFile as bad:
        raise ReadError(f"{path}:{bad.line or 1}: {bad.problem.message}", hint="Save it as UTF-8.") from None
    except OSError as error:
        raise ReadError(f"{path}: cannot be opened: {error.strerror}", hint="Name the file of a draft.") from error


def draft_of_recipe(path: Path, recipe_id: str) -> Path:
    """Put the draft of one recipe, of a file of many, into a file of its own beside that; return its path.

    One that is there already stays: it is being reviewed. Raises UsageError where there is none.
    """
    from foon_kg.loaders.lessons import read_drafted
    from foon_kg.loaders.narrated import is_video_name

    recipe_id = one_spelling(recipe_id)
    found = next((one for one in read_drafted([path]) if one.id == recipe_id), None)
    if found is None or not found.table:
        why = found.problem if found else "no line is of it"
        raise UsageError(f"{path} has no draft of the recipe “{recipe_id}”: {why}", hint="Name another recipe.")
    if not is_video_name(recipe_id):
        raise UsageError(f"no file can be named “{recipe_id}”", hint="Draft the recipe by itself: foon draft text FILE")
    target = path.with_name(f"{recipe_id}.csv")
    if not target.exists():
        write_file(target, found.table, "Put the drafts into a folder that can be written.")
    return target


def write_subgraph(review: Review, target: Path) -> Path:
    """Write the units of a ``review`` as FOON text to ``target``, and return where."""
    from foon_kg.loaders.text_writer import write_text

    write_file(target, write_text(review.subgraph()), "Name a file that can be written after --output.")
    return target


@dataclass
class ReviewSession:
    """A draft that one person reviews, decision after decision; each can be undone."""

    path: Path
    review: Review
    before: list[Review] = field(default_factory=list)
    number: int = 0
    keys: Keys = field(default_factory=Keys)

    def ask(self) -> None:
        """Show one decision after another, and do what each key says, until nothing is left to ask."""
        actions: Mapping[str, Callable[[Decision], bool]] = {
            "\r": self._accept,
            "\n": self._accept,
            "a": self._accept,
            "e": self._edit,
            "d": self._drop,
            "s": self._later,
            "b": self._back,
            "u": self._undo,
            "q": self._quit,
            "\x04": self._quit,
        }
        while self.number < len(self.review.decisions):
            decision = self.review.decisions[self.number]
            data().print(decision_view(decision, self.number + 1, len(self.review.decisions)))
            data().print(_KEYS, style="dim")
            while (action := actions.get(self._key())) is None:
                pass
            if not action(decision):
                return

    def _accept(self, decision: Decision) -> bool:
        return self._decided(self.review.accepted(decision.place), "accepted" if decision.unit else "left out")

    def _drop(self, decision: Decision) -> bool:
        return self._decided(self.review.dropped(decision.place), "left out")

    def _later(self, _: Decision) -> bool:
        self.number += 1
        return True

    def _back(self, _: Decision) -> bool:
        self.number = max(0, self.number - 1)
        return True

    def _quit(self, _: Decision) -> bool:
        return False

    def _undo(self, _: Decision) -> bool:
        if self.before:
            self._keep(self.before.pop())
            typer.echo("undone")
        return True

    def _edit(self, decision: Decision) -> bool:
        """Ask for each cell, what stands there ready to be changed; what is no unit is asked again."""
        cells = {name: decision.cells.get(name, "") for name in ASKED if name in self.review.columns}
        while True:
            try:
                with self.keys.closed():
                    cells = {name: _typed(name, text) for name, text in cells.items()}
                return self._decided(self.review.edited(decision.place, cells), "edited")
            except UsageError as error:
                typer.echo(f"{error.message} — {error.hint} (Ctrl-C leaves it as it was)")
            except (KeyboardInterrupt, EOFError):
                typer.echo("\nas it was")
                return True

    def _key(self) -> str:
        """Return the next key; Ctrl-C and the end of the input quit."""
        try:
            return self.keys.next().lower()
        except (KeyboardInterrupt, EOFError):
            return "q"

    def _decided(self, review: Review, what: str) -> bool:
        self.before.append(self.review)
        self._keep(review)
        typer.echo(what)
        return True

    def _keep(self, review: Review) -> None:
        write_file(self.path, review.text(), "The draft must be writable: decisions are kept in it.")
        self.review = review
        self.number = max(0, min(self.number, len(review.decisions) - 1))


def decision_view(decision: Decision, number: int, of: int) -> RenderableType:
    """Return a ``decision``, ``number`` of so many (``of``): left what was said, right its unit, the reasons below."""
    from rich.console import Group
    from rich.rule import Rule
    from rich.table import Table
    from rich.text import Text

    table = Table(show_header=True, expand=True, box=None, padding=(0, 2, 0, 0))
    table.add_column("said", ratio=2, header_style="dim", overflow="fold")
    table.add_column(f"drafted, {decision.confidence:.2f} sure", ratio=3, header_style="dim", overflow="fold")
    said = Text(decision.said or "(nobody says anything)")
    if decision.moment:
        said.append(f"\n{decision.moment}", "cyan")
    table.add_row(said, _unit_words(decision))
    reasons = [Text(f"  ? {reason.kind}: {reason.text}", "yellow") for reason in decision.reasons]
    return Group(Rule(f"{number} of {of}", align="left"), table, *reasons)


def _unit_words(decision: Decision) -> RenderableType:
    from rich.console import Group
    from rich.table import Table
    from rich.text import Text

    from foon_kg.formats.exports.sentences import sentence
    from foon_kg.plans.kitchen import Kitchen

    if decision.unit is None:
        return Text("no unit", "red")
    table = Table.grid(padding=(0, 1))
    for name in ASKED:
        if text := decision.cells.get(name, ""):
            table.add_row(Text(name, "dim"), Text(text))
    return Group(Text(sentence(decision.unit, Kitchen.default()), "bold"), table)


def _typed(name: str, text: str) -> str:
    with _ready_to_change(text):
        return input(f"{name}: ").strip()


@contextmanager
def _ready_to_change(text: str) -> Iterator[None]:
    """Have ``text`` stand in the next line that is asked for, where the system has a line editor."""
    try:
        import readline
    except ImportError:
        typer.echo(f"(now: {text})")
        yield
        return
    readline.set_startup_hook(lambda: readline.insert_text(text))
    try:
        yield
    finally:
        readline.set_startup_hook()


def is_in_person() -> bool:
    """Whether somebody sits before this program."""
    return sys.stdin.isatty() and sys.stdout.isatty()
