"""Lines in a file, compressed where its ending says so (.gz, .zst): in blocks, so that a run that was killed goes on.

A block is whole in itself (a member of gzip, a frame of zstd), and has so many lines that the same lines make the same
bytes, however often a run was stopped in between. Without compression a block is a line.
"""

from __future__ import annotations

import errno
import gzip
import os
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Protocol

from foon_kg.model.errors import UsageError
from foon_kg.model.regular_files import open_regular
from foon_kg.model.written_files import open_to_write, writing

LINES = 64
"""In a compressed block: what is lost at most when a run is killed."""

MOST_OF_A_LINE = 64_000_000
"""So many bytes no answer has."""

_AT_ONCE = 1 << 20
"""Bytes that are read of a compressed file at a time."""


class Inflating(Protocol):
    """What takes a block apart, as in :mod:`zlib`."""

    @property
    def eof(self) -> bool:
        """Whether the block has ended."""

    @property
    def unused_data(self) -> bytes:
        """What came after its end."""

    def decompress(self, data: bytes, /) -> bytes:
        """Return what comes of more of it."""


@dataclass(frozen=True)
class Form:
    """How a block of ``lines`` is written and read; ``faults`` are raised where it is none."""

    lines: int
    deflated: Callable[[bytes], bytes]
    inflating: Callable[[], Inflating] | None = None
    faults: tuple[type[Exception], ...] = ()


def form_of(path: Path) -> Form:
    """Return the form that the ending of ``path`` asks for; raises ModuleNotFoundError without zstandard for .zst."""
    if path.suffix == ".gz":
        return Form(LINES, lambda data: gzip.compress(data, mtime=0), lambda: zlib.decompressobj(31), (zlib.error,))
    if path.suffix != ".zst":
        return Form(1, lambda data: data)
    import zstandard

    return Form(
        LINES,
        lambda data: zstandard.ZstdCompressor(write_checksum=True).compress(data),
        lambda: zstandard.ZstdDecompressor().decompressobj(),
        (zstandard.ZstdError,),
    )


def whole_blocks(path: Path) -> Iterator[tuple[bytes, int]]:
    """Yield what each whole block of the file at ``path`` holds and where it ends; nothing if there is no such file.

    What follows the last whole block was being written when a run ended. Raises UsageError where the file cannot be
    read, or is not of the form that its ending says.
    """
    form = form_of(path)
    try:
        if path.exists():
            with open_regular(path, advice="what is in it could not be gone on with") as file:
                yield from _lines(file) if form.inflating is None else _inflated(file, form.inflating)
    except OSError as error:
        raise UsageError(f"{path}: {error.strerror}", hint="--output names a file.") from error
    except form.faults as error:
        hint = "Name another file, or take this one away to begin anew."
        raise UsageError(f"{path}: it is not what its ending says: {error}", hint=hint) from error


@contextmanager
def adding(path: Path, size: int) -> Iterator[Callable[[str], None]]:
    """Open the file at ``path`` behind its first ``size`` bytes; return what adds a line.

    A block is on disk when it is full. The last one, too, where the block of ``with`` ends well; else it is left out.
    Raises UsageError for no file.
    """
    form, hint = form_of(path), "--output names a file that can be written."
    with writing(path, hint):
        file = open_to_write(path, os.O_CREAT | os.O_APPEND, buffering=0)
    waiting: list[bytes] = []

    def write() -> None:
        left = memoryview(form.deflated(b"".join(waiting)))
        with writing(path, hint):
            while left:
                left = left[file.write(left) :]
        waiting.clear()

    def add(line: str) -> None:
        waiting.append(f"{line}\n".encode())
        if len(waiting) == form.lines:
            write()

    with file:
        with writing(path, hint):
            file.truncate(size)
        yield add
        if waiting:
            write()


def _lines(file: BinaryIO) -> Iterator[tuple[bytes, int]]:
    end = 0
    while (line := file.readline(MOST_OF_A_LINE)).endswith(b"\n"):
        end += len(line)
        yield line, end
    if len(line) == MOST_OF_A_LINE:
        raise OSError(errno.EINVAL, f"line by line it holds no answers: one has over {MOST_OF_A_LINE // 1_000_000} MB")


def _inflated(file: BinaryIO, inflating: Callable[[], Inflating]) -> Iterator[tuple[bytes, int]]:
    data = file.read(_AT_ONCE)
    while data:
        block, content = inflating(), []
        while data and not block.eof:
            content.append(block.decompress(data))
            data = block.unused_data if block.eof else file.read(_AT_ONCE)
        if not block.eof:
            return
        end = file.tell() - len(data)
        yield b"".join(content), end
        data = data or file.read(_AT_ONCE)
