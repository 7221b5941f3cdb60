"""Files that people ask for: written whole or left as they were, and what is told where that cannot be."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from foon_kg.model.errors import FoonError, UsageError

NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
"""What a full disk is called, a used up quota, and a file that may not grow."""
_AT_ONCE = getattr(os, "O_NONBLOCK", 0)
_BINARY = getattr(os, "O_BINARY", 0)


def no_room(place: object) -> FoonError:
    """Return the error for a full disk at a ``place``, which is no mistake of who asked."""
    return FoonError(
        f"{place}: no space is left there",
        hint="Make room, or write to another place; then ask again.",
        code="no-space",
    )


@contextmanager
def writing(path: Path, hint: str) -> Iterator[None]:
    """Turn an OSError of the block, which writes ``path``, into a UsageError with ``hint``, or that of a full disk."""
    try:
        yield
    except OSError as error:
        if error.errno in NO_ROOM:
            raise no_room(path) from error
        raise UsageError(f"{path}: cannot be written: {error.strerror}", hint=hint) from error


def write_file(path: Path, content: str | bytes, hint: str) -> None:
    """Write ``content`` to ``path`` whole, or leave what is there; raises as :func:`writing` does, with ``hint``."""
    with writing(path, hint):
        write_whole(path, content)


def check_place(path: Path, hint: str) -> None:
    """Raise UsageError with ``hint`` where a file at ``path`` would be refused: for what takes long before it writes.

    A place that is all right now may not be so later; :func:`write_file` tells that.
    """
    with writing(path, hint):
        target = Path(os.path.realpath(path))
        if (wrong := _wrong_with(target)) is not None:
            raise OSError(wrong, os.strerror(wrong))


def _wrong_with(target: Path) -> int | None:
    """Return the number of the error with which :func:`write_whole` would refuse ``target``, no link, if it would."""
    if target.is_dir():
        return errno.EISDIR
    if not target.parent.is_dir():
        return errno.ENOTDIR if target.parent.exists() else errno.ENOENT
    places = (target, target.parent) if target.exists() else (target.parent,)  # a file is put in the place of another
    return None if any(os.access(place, os.W_OK) for place in places) else errno.EACCES


def write_whole(path: Path, content: str | bytes, mode: int | None = None) -> None:
    """Write ``content`` to a file beside ``path`` and put it in its place; if that raises OSError, leave nothing of it.

    A link stays one. A file keeps its mode (the bits of ``chmod``) unless ``mode`` says another. Devices, pipes that
    somebody reads, and files in a folder that takes no others, are written where they are.
    """
    data = content.encode() if isinstance(content, str) else content
    target = Path(os.path.realpath(path))
    there = target.exists()
    if target.is_symlink() or (there and not (target.is_file() and os.access(target.parent, os.W_OK))):
        with open_to_write(target) as stream:  # refused where it is a link to itself
            stream.write(data)
        return
    draft = target.with_name(f".{os.urandom(8).hex()}.new")
    try:
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | _BINARY
        with os.fdopen(os.open(draft, flags, 0o666 if mode is None else mode), "wb") as stream:
            if there and mode is None:
                draft.chmod(target.stat().st_mode & 0o777)
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())
        draft.replace(target)
    except BaseException:  # Ctrl-C too
        draft.unlink(missing_ok=True)
        raise


def open_to_write(path: Path, flags: int = os.O_CREAT | os.O_TRUNC, buffering: int = -1) -> BinaryIO:
    """Return the file at ``path``, open for bytes at once: a pipe that nobody reads is an OSError, and not waited for.

    ``flags`` are added to those of :func:`os.open`, ``buffering`` is that of :func:`open`.
    """
    try:
        handle = os.open(path, os.O_WRONLY | flags | _AT_ONCE | _BINARY, 0o666)
    except OSError as error:
        if error.errno == errno.ENXIO and path.is_fifo():
            raise OSError(errno.ENXIO, "it is a pipe, and nobody reads it", str(path)) from error
        raise
    if _AT_ONCE:
        os.set_blocking(handle, True)  # who reads slowly is waited for
    return os.fdopen(handle, "wb", buffering)
