"""What readers say of trees: one line a tree, ``number | robot | cook | faults``.

The robot says ``yes`` or ``no``, the cook ``yes``, ``yes, but`` or ``no``: ``3 | yes | yes, but | the onion is raw``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from foon_kg.evaluation.reading import read_text
from foon_kg.model.errors import ReadError

YES, YES_BUT, NO = "yes", "yes, but", "no"

_HINT = "Write: number | robot | cook | faults, with yes or no for the robot and yes, “yes, but” or no for the cook."
_MOST_DIGITS = 6
"""More have no numbers of trees."""
_COLUMNS = 4


@dataclass(frozen=True)
class Verdict:
    """What one rater says of a tree, as a robot and as a cook; ``words`` name the faults.

    ``plain`` is whether the cook has no reservation: ``None`` where the rater (the judge) makes no such difference.
    """

    robot: bool
    cook: bool
    plain: bool | None
    words: str = ""

    @property
    def accepted(self) -> bool:
        """Whether it is accepted in both roles."""
        return self.robot and self.cook

    def __str__(self) -> str:
        cook = NO if not self.cook else YES_BUT if self.plain is False else YES
        return f"{YES if self.robot else NO} | {cook} | {self.words}".rstrip()


Sheet = tuple[Verdict, ...]
"""The verdicts of one reader, in the order of the trees."""


def write_sheet(sheet: Sheet) -> str:
    """Return the lines of a sheet; a cook's yes of which nobody knows whether there is a but is a ``yes``."""
    return "".join(f"{number} | {verdict}\n" for number, verdict in enumerate(sheet, start=1))


def read_sheet(path: Path, trees: int) -> Sheet:
    """Return what a reader says, in the file at ``path``, of the trees numbered 1 to ``trees``, in any order.

    Behind a line of dashes, or once each tree has a line, a reader may go on in words. Raises ReadError with file and
    line for any other line that names no tree and verdict, for a number that there is not or that is there twice, and
    where trees are missing or the file cannot be read.
    """
    found: dict[int, Verdict] = {}
    for where, line in _lines_above_dashes(path):
        goes_on_in_words = len(found) == trees and not _names_a_tree(line)
        if goes_on_in_words:
            continue
        number, verdict = _entry(line, where)
        if not 1 <= number <= trees:
            raise ReadError(f"{where}: there is no tree {number}", hint=f"The trees are 1 to {trees}.")
        if number in found:
            raise ReadError(f"{where}: tree {number} is there twice", hint="Take one of the lines away.")
        found[number] = verdict
    numbers = range(1, trees + 1)
    missing = [str(number) for number in numbers if number not in found]
    if missing:
        raise ReadError(f"{path}: nothing is said of trees {', '.join(missing)}", hint=_HINT)
    return tuple(found[number] for number in numbers)


def _lines_above_dashes(path: Path) -> Iterator[tuple[str, str]]:
    """Yield (file:line, text) of each line of the file that is not blank, up to a line of dashes."""
    for line_number, line in enumerate(read_text(path).split("\n"), start=1):
        is_blank = not line.strip()
        is_dashes = not is_blank and not line.strip("-\r\t ")
        if is_dashes:
            return
        if not is_blank:
            yield f"{path}:{line_number}", line


def _names_a_tree(line: str) -> bool:
    columns = _columns(line)
    return len(columns) == _COLUMNS and columns[0].isdecimal() and len(columns[0]) <= _MOST_DIGITS


def _columns(line: str) -> Sequence[str]:
    return [column.strip() for column in line.split("|", _COLUMNS - 1)]


def _entry(line: str, where: str) -> tuple[int, Verdict]:
    if not _names_a_tree(line):
        raise ReadError(f"{where}: this is no line about a tree", hint=_HINT)
    number, *said, words = _columns(line)
    robot, cook = (" ".join(one.lower().split()) for one in said)
    if robot not in {YES, NO}:
        raise ReadError(f"{where}: robot says “{robot}”", hint=_HINT)
    if cook not in {YES, YES_BUT, NO}:
        raise ReadError(f"{where}: cook says “{cook}”", hint=_HINT)
    return int(number), Verdict(robot=robot == YES, cook=cook != NO, plain=cook == YES, words=words)
