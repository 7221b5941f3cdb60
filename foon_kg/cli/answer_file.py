"""A file of answers, one JSON line a recipe, with which a run that was stopped goes on."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from io import FileIO
from pathlib import Path

from foon_kg.model.errors import NoTreeError, ReadError, UsageError
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.regular_files import read_bytes
from foon_kg.model.written_files import writing

MOST_BYTES = 4_000_000_000
"""How large a file of answers may be that is gone on with."""

_EXIT_CODES = {"read": ReadError.exit_code, "usage": UsageError.exit_code, "unknown-dish-type": UsageError.exit_code}


@dataclass(frozen=True)
class AnswerFile:
    """What ``path`` holds: ``lines`` are the values of its whole lines, ``size`` the bytes that these take."""

    path: Path
    lines: tuple[JsonObject, ...]
    size: int

    @classmethod
    def read(cls, path: Path) -> AnswerFile:
        """Read ``path``, which need not be there; a last line without its end counts as not there.

        Raises :class:`~foon_kg.model.errors.UsageError` where it cannot be read or holds something else than answers.
        """
        try:
            content = read_bytes(path, MOST_BYTES) if path.exists() else b""
        except OSError as error:
            raise UsageError(f"{path}: {error.strerror}", hint="--output names a file.") from error
        whole = content[: content.rfind(b"\n") + 1]
        lines = tuple(_value(path, number, line) for number, line in enumerate(whole.splitlines(), 1))
        return cls(path, lines, len(whole))

    def check(self, recipes: Sequence[JsonObject]) -> None:
        """Raise ``UsageError`` unless the lines answer the first of ``recipes``, in order."""
        for number, line in enumerate(self.lines, 1):
            if number > len(recipes) or line["recipe"] != recipes[number - 1]:
                raise _not_ours(self.path, number, "answers another question than this command asks")

    @property
    def exit_code(self) -> int:
        """Answer the exit code that the lines stand for: the highest of those of their errors."""
        codes = (error.get("code") for line in self.lines if isinstance(error := line.get("error"), dict))
        return max((_EXIT_CODES.get(str(code), NoTreeError.exit_code) for code in codes), default=0)

    @contextmanager
    def going_on(self) -> Iterator[Callable[[str], None]]:
        """Open the file after its last whole line; answer what adds a line to it, at once."""
        hint = "--output names a file that can be written."
        with writing(self.path, hint):
            file = self.path.open("ab", buffering=0)
        with file:
            file.truncate(self.size)
            yield partial(_add, file, self.path, hint)


def _add(file: FileIO, path: Path, hint: str, line: str) -> None:
    left = memoryview(f"{line}\n".encode())
    with writing(path, hint):
        while left:
            left = left[file.write(left) :]


def _value(path: Path, number: int, line: bytes) -> JsonObject:
    try:
        value = json.loads(line)
    except ValueError as error:
        raise _not_ours(path, number, "is no JSON") from error
    if not isinstance(value, dict) or "recipe" not in value:
        raise _not_ours(path, number, "is no answer to a recipe")
    return value


def _not_ours(path: Path, number: int, why: str) -> UsageError:
    return UsageError(
        f"{path}:{number}: this line {why}", hint="Name another file, or take this one away to begin anew."
    )
