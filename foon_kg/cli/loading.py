"""What the commands of ``foon load`` share: options, the refusal of too much that is unusable, and the counts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Say, print_json

if TYPE_CHECKING:
    from foon_kg.cli.files_read import Where
    from foon_kg.food.unknown import UnknownWord
    from foon_kg.loaders import Notice

Report = Annotated[
    Path | None,
    typer.Option("--report", metavar="FILE", help="Write what is odd about the files here, as JSON Lines."),
]
BadTolerance = Annotated[
    int | None,
    typer.Option(
        "--bad-tolerance",
        min=0,
        metavar="N",
        help="Load although up to N units or recipes are unusable; as a rule one in a hundred.",
    ),
]
Check = Annotated[
    bool, typer.Option("--check", help="Play each video in a kitchen, and say what the annotator forgot.")
]
DryRun = Annotated[bool, typer.Option("--dry-run", help="Read and report only; change nothing.")]

UNWRITTEN = "Name a file that can be written after --report."

_FEW = 10
"""So many lines a person reads one by one; of more they look into the report."""

_NAMED = 3
_ONE_IN = 100
"""So much may be unusable where nobody said how much: of thousands of units that people typed a few are broken."""


def tell_in_short(
    notices: Sequence[Notice], words: Mapping[UnknownWord, Where], report: Path | None, say: Say, *, named: bool = False
) -> None:
    """Tell ``say`` what is odd about subgraph files: one by one where that is little, else in one line.

    ``notices`` are what was skipped or assumed, ``words`` those that no table has with where they stand. The line names
    ``report``, the file that lists them all, if there is one. Where what was skipped has to be mended, the first of it
    is ``named``.
    """
    skipped = [notice for notice in notices if str(notice.severity) == "rejected"]
    if len(notices) <= _FEW:
        for notice in notices:
            say(str(notice))
        tell_unknown(words, report, say)
        return
    for notice in (*skipped[: _FEW if named else 0], *_slips(words)):
        say(str(notice))
    say(f"{in_short(len(skipped), len(notices) - len(skipped), len(words))}: {where_listed(report)}")


def in_short(skipped: int, assumed: int, unknown: int) -> str:
    """Return how much of some files is odd, as in “3 units skipped, 288 assumptions”.

    So many units are ``skipped``, so much is ``assumed``, and so many words are ``unknown``.
    """
    told = (
        (skipped, f"{_counted(skipped, 'unit')} skipped"),
        (assumed, _counted(assumed, "assumption")),
        (unknown, f"{_counted(unknown, 'word')} in no table"),
    )
    return ", ".join(words for count, words in told if count)


def tell_assumed(notices: Sequence[Notice], count: int, report: Path | None, say: Say) -> None:
    """Say what was read with an assumption: one by one where that is little, else only how much it is, ``count``.

    ``notices`` are the first ones; there may be more. The ``report`` is the file that lists all of them.
    """
    if count <= _FEW:
        for notice in notices:
            say(str(notice))
        return
    say(f"{_counted(count, 'assumption')}: {where_listed(report)}")


def unknown_notice(word: UnknownWord, file: str, line: int | None = None) -> Notice:
    """Return what is said of a ``word`` that no table has; ``file`` and ``line`` are the first that have it."""
    from foon_kg.loaders import Notice, NoticeKind

    return Notice(file, line, NoticeKind(f"unknown-{word.kind}"), word.what, f"taken for {word.taken_for}")


def tell_unknown(words: Mapping[UnknownWord, Where], report: Path | None, say: Say) -> None:
    """Say which ``words`` the tables of foods, utensils, states and motions do not have.

    Few are said one by one, with file and line; of many those that look misspelled, and the others in one line. The
    ``report`` is the file that lists all of them.
    """
    if len(words) <= _FEW:
        for word, where in words.items():
            say(str(unknown_notice(word, *where)))
        return
    for notice in _slips(words):
        say(str(notice))
    kinds: dict[str, list[str]] = {}
    for word in words:
        kinds.setdefault(word.kind, []).append(word.word)
    parts = (f"{_counted(len(own), kind)} ({_first(own)})" for kind, own in kinds.items())
    say(f"{len(words)} words are in no table of foon-kg ({where_listed(report)}): {', '.join(parts)}")


def _slips(words: Mapping[UnknownWord, Where]) -> list[Notice]:
    """Return what is to be said of the first words that look misspelled."""
    return [unknown_notice(word, *where) for word, where in words.items() if word.meant][:_FEW]


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def _first(words: Sequence[str]) -> str:
    return ", ".join([*words[:_NAMED], *(["…"] if len(words) > _NAMED else [])])


def where_listed(report: Path | None) -> str:
    """Return where to find all that is odd: in the ``report``, or how to get one."""
    return f"see {report}" if report else "--report FILE lists them"


def is_too_many(rejected: int, usable: int, tolerance: int | None) -> bool:
    """Return whether more is ``rejected``, beside what is ``usable``, than ``tolerance`` allows.

    As a rule (``None``) that is one in a hundred.
    """
    return rejected > ((rejected + usable) // _ONE_IN if tolerance is None else tolerance)


def refuse_too_many(rejected: int, usable: int, tolerance: int | None, what: str, where: str = "") -> None:
    """Raise ToleranceError where more is ``rejected``, beside what is ``usable``, than ``tolerance`` allows.

    ``what`` is one of it, as in: unit; ``where`` follows in the message.
    """
    from foon_kg.model.errors import ToleranceError

    if is_too_many(rejected, usable, tolerance):
        unusable = f"1 {what} is" if rejected == 1 else f"{rejected} {what}s are"
        raise ToleranceError(
            f"{unusable} unusable{where}; nothing was loaded",
            hint=f"Mend what is named above, or load all the rest with --bad-tolerance {rejected}.",
        )


def show_counts(counts: Mapping[str, int], *, as_json: bool) -> None:
    """Print counts as one JSON object or as words."""
    if as_json:
        print_json(counts)
    else:
        typer.echo(", ".join(f"{count} {what.replace('_', ' ')}" for what, count in counts.items()))
