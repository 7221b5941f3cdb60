"""A file of answers, one JSON line a recipe, with which a run that was stopped goes on."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from itertools import chain
from pathlib import Path

from foon_kg.cli.blocks import adding, form_of, whole_blocks
from foon_kg.model.errors import NoTreeError, ReadError, UsageError
from foon_kg.model.json_fields import JsonObject

_EXIT_CODES = {"read": ReadError.exit_code, "usage": UsageError.exit_code, "unknown-dish-type": UsageError.exit_code}


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

    def check(self, recipes: Sequence[JsonObject]) -> None:
        """Raise ``UsageError`` unless the lines answer the first of ``recipes``, in order."""
        for number, line in enumerate(self.lines, 1):
            if number > len(recipes) or line["recipe"] != recipes[number - 1]:
                raise _not_ours(self.path, number, "answers another question than this command asks")

    @property
    def exit_code(self) -> int:
        """Return the exit code that the lines stand for: the highest of those of their errors."""
        return max(map(exit_code_of, self.lines), default=0)

    def going_on(self) -> AbstractContextManager[Callable[[str], None]]:
        """Open the file after its last whole block; return what adds a line to it."""
        return adding(self.path, self.size)


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
    if not isinstance(value, dict) or "recipe" not in value:
        raise _not_ours(path, number, "is no answer to a recipe")
    return value


def _not_ours(path: Path, number: int, why: str) -> UsageError:
    return UsageError(
        f"{path}:{number}: this line {why}", hint="Name another file, or take this one away to begin anew."
    )
