"""A file of answers, one JSON line a recipe, with which a run that was stopped goes on."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Collection, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from itertools import chain
from pathlib import Path

from foon_kg.cli.blocks import adding, form_of, whole_blocks
from foon_kg.cli.console import json_line
from foon_kg.model.errors import NoTreeError, ReadError, UsageError
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.json_text import json_value

_EXIT_CODES = {"read": ReadError.exit_code, "usage": UsageError.exit_code, "unknown-dish-type": UsageError.exit_code}
_SIDES = ("input_nodes", "motion_node", "output_nodes")


@dataclass(frozen=True)
class AnswerFile:
    """What ``path`` holds: ``lines`` are the values of its whole blocks, ``size`` the bytes that these take."""

    path: Path
    lines: tuple[JsonObject, ...]
    size: int

    @classmethod
    def read(cls, path: Path, wanted: int = 0) -> AnswerFile:
        """Read ``path``, which need not be there; what was being written when a run ended counts as not there.

        So does a last block that is not full, where more than its lines are ``wanted``. Raises
        :class:`~foon_kg.model.errors.UsageError` where it cannot be read or holds something else than answers.
        """
        blocks = [(content.splitlines(), end) for content, end in whole_blocks(path)]
        there = sum(len(lines) for lines, _ in blocks)
        if there < wanted and blocks and len(blocks[-1][0]) < form_of(path).lines:
            blocks.pop()
        whole = chain.from_iterable(lines for lines, _ in blocks)
        values = tuple(value_of(path, number, line) for number, line in enumerate(whole, 1))
        return cls(path, values, blocks[-1][1] if blocks else 0)

    def mended(self, recipes: Sequence[JsonObject]) -> tuple[int, ...]:
        """Return the places (from 0) of lines that say of one of ``recipes`` that it cannot be read, which now it can.

        Raises ``UsageError`` unless all other lines answer the first of these, in order.
        """
        found = []
        for place, line in enumerate(self.lines):
            if place >= len(recipes) or not _may_answer(line, recipes[place]):
                raise _not_ours(self.path, place + 1, "answers another question than this command asks")
            if line["recipe"] != recipes[place]:
                found.append(place)
        return tuple(found)

    def check(self, recipes: Sequence[JsonObject]) -> None:
        """Raise ``UsageError`` unless the lines answer the first of ``recipes``, in order."""
        for place in self.mended(recipes):
            raise _not_ours(self.path, place + 1, "answers another question than this command asks")

    def surest(self, without: Collection[int]) -> int | None:
        """Return the place of the last line with a tree that is not among ``without``; ``None`` where there is none."""
        trees = (place for place, line in enumerate(self.lines) if "units" in line and place not in without)
        return max(trees, default=None)

    def check_tree(self, place: int, now: JsonObject) -> None:
        """Raise ``UsageError`` where the line at ``place`` has other steps than ``now``: :func:`check_tree`."""
        check_tree(self.path, place + 1, self.lines[place], now)

    def with_lines(self, anew: Mapping[int, JsonObject]) -> AnswerFile:
        """Write the file with other lines at the places of ``anew``, whole or not at all; return what it holds."""
        whole = self.path.resolve()
        beside = whole.with_name(f".{os.getpid()}-{whole.name}")
        try:
            with adding(beside, 0) as add:
                for place, line in enumerate(self.lines):
                    add(json_line(anew.get(place, line)))
            beside.replace(whole)
        finally:
            beside.unlink(missing_ok=True)
        return AnswerFile.read(self.path)

    @property
    def exit_code(self) -> int:
        """Return the exit code that the lines stand for: the highest of those of their errors."""
        return max(map(exit_code_of, self.lines), default=0)

    def going_on(self) -> AbstractContextManager[Callable[[str], None]]:
        """Open the file after its last whole block; return what adds a line to it."""
        return adding(self.path, self.size)


def _may_answer(line: JsonObject, recipe: JsonObject) -> bool:
    """Whether a ``line`` answers ``recipe``, or says that it could not be read when it was still a broken one."""
    asked, error = line["recipe"], line.get("error")
    if asked == recipe:
        return True
    broken = isinstance(error, dict) and error.get("code") in _EXIT_CODES
    return broken and asked.get("ingredients") == [] and asked.get("id") == recipe["id"]


def _steps(told: JsonObject) -> object:
    """Return what a plan makes by which steps; what is told of these may hang on how long a search could take."""
    return told.get("goal"), [[unit[side] for side in _SIDES] for unit in told.get("units", ())]


def check_tree(path: Path, number: int, line: JsonObject, now: JsonObject) -> None:
    """Raise ``UsageError`` where a ``line`` of the file at ``path`` has other steps than its question gives ``now``.

    One question has one answer, so that the file is of another FOON, or was asked with other wishes. ``number`` is the
    line's, from 1.
    """
    if _steps(line) != _steps(json_value(json_line(now))):
        told = line["recipe"].get("id") or "its recipe"
        raise _not_ours(path, number, f"has another tree of {told} than this FOON, kitchen and wishes give")


def exit_code_of(line: JsonObject) -> int:
    """Return the exit code that an answer, a ``line`` of a file, stands for."""
    error = line.get("error")
    return _EXIT_CODES.get(str(error.get("code")), NoTreeError.exit_code) if isinstance(error, dict) else 0


def value_of(path: Path, number: int, line: bytes) -> JsonObject:
    """Return the answer in a ``line`` of the file at ``path``.

    Raises UsageError with its ``number`` where it is none.
    """
    try:
        value = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise _not_ours(path, number, "is no JSON") from error
    if not isinstance(value, dict) or not isinstance(value.get("recipe"), dict) or not _has_units(value):
        raise _not_ours(path, number, "is no answer to a recipe")
    return value


def _has_units(value: JsonObject) -> bool:
    """Whether an answer has steps as a plan has them, or none."""
    units = value.get("units", [])
    return isinstance(units, list) and all(isinstance(unit, dict) and unit.keys() >= set(_SIDES) for unit in units)


def _not_ours(path: Path, number: int, why: str) -> UsageError:
    return UsageError(
        f"{path}:{number}: this line {why}", hint="Name another file, or take this one away to begin anew."
    )
