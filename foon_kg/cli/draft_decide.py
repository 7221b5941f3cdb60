"""``foon draft review --decide``: what was said beside what was drafted of it, and one key for each."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from foon_kg.cli.console import data

if TYPE_CHECKING:
    from foon_kg.language.drafting.deciding import Decision

_RIGHT, _WRONG, _STOP = ("y", "\r", "\n"), ("d",), ("q", "\x03", "\x04", "")
KEYS = "y or Enter: right as it stands   d: delete it   any other key: later   q: stop"


def decide(path: Path) -> bool:
    """Ask for each doubtful sentence of a draft, and write the answers down; false where it was stopped."""
    from foon_kg.formats.views.draft import decision_view
    from foon_kg.language.drafting.deciding import decisions
    from foon_kg.language.drafting.tables import read_draft
    from foon_kg.plans.kitchen import Kitchen

    asked = decisions(read_draft(path))
    right: set[int] = set()
    wrong: set[int] = set()
    typer.echo(f"{path}: {len(asked)} decisions. {KEYS}" if asked else f"{path}: nothing is left to decide")
    stopped = False
    for number, decision in enumerate(asked, 1):
        data().print(decision_view(decision, f"{number}/{len(asked)}", Kitchen.default()))
        key = _key()
        stopped = key in _STOP
        if stopped:
            break
        _note(decision, key, right, wrong)
    _write(path, right, wrong)
    left = len(decisions(read_draft(path)))
    typer.echo(f"{path}: {len(asked) - left} decided, {left} left" + ("" if left else f"; foon draft accept {path}"))
    return not stopped


def _note(decision: Decision, key: str, right: set[int], wrong: set[int]) -> None:
    if key in _RIGHT:
        right |= decision.lines
    elif key in _WRONG:
        wrong |= decision.lines


def _key() -> str:
    """Return the next key; the end of the input is none."""
    try:
        return typer.getchar().lower()
    except (EOFError, KeyboardInterrupt):
        return ""


def _write(path: Path, right: set[int], wrong: set[int]) -> None:
    from foon_kg.language.drafting.deciding import decided
    from foon_kg.loaders.paths import decode
    from foon_kg.model.regular_files import read_bytes
    from foon_kg.model.written_files import write_file

    if right or wrong:
        write_file(path, decided(decode(read_bytes(path)), right, wrong), "Make room, or open the table in an editor.")
