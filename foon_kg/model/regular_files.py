"""Files that people name: opened only where they are regular files, and read whole only up to a size.

A pipe that nobody writes to would be waited for without end, and a device like ``/dev/zero`` fills the memory. What is
wrong is raised as an OSError, as for any other file that cannot be opened; its ``strerror`` says it in words.
"""

from __future__ import annotations

import errno
import os
import stat
from io import TextIOWrapper
from pathlib import Path
from typing import BinaryIO

MOST_BYTES = 256_000_000
"""How large a file may be that is read whole."""

_WRITE_IT_FIRST = "write what it tells into a file first"
_KINDS = {
    stat.S_IFIFO: "a pipe",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
    stat.S_IFSOCK: "a socket",
}


def open_regular(path: Path, most: int | None = None, advice: str = _WRITE_IT_FIRST) -> BinaryIO:
    """Return the regular file at ``path``, open to read its bytes.

    Raises OSError for anything else, and for more than ``most`` bytes. ``advice`` is what is said to who names a pipe,
    a socket or a device.
    """
    handle = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)  # else a pipe would be waited for here
    stream = os.fdopen(handle, "rb")
    if wrong := _what_is_wrong(os.fstat(handle), most, advice):
        stream.close()
        raise OSError(errno.EINVAL, wrong, str(path))
    return stream


def _what_is_wrong(found: os.stat_result, most: int | None, advice: str) -> str | None:
    if kind := _KINDS.get(stat.S_IFMT(found.st_mode)):
        return f"it is {kind}, not a file: {advice}"
    if most is not None and found.st_size > most:
        return f"it has {found.st_size // 1_000_000} MB, and {most // 1_000_000} MB are the most"
    return None


def read_bytes(path: Path, most: int = MOST_BYTES) -> bytes:
    """Return what is in the regular file at ``path``, of at most ``most`` bytes.

    Raises OSError as :func:`open_regular` does.
    """
    with open_regular(path, most) as stream:
        return stream.read(most)


def read_text(path: Path, encoding: str = "utf-8-sig") -> str:
    """Return the text of the regular file at ``path``, read in an ``encoding``, its lines ended by newlines.

    Raises OSError as :func:`open_regular` does, and UnicodeDecodeError.
    """
    with TextIOWrapper(open_regular(path, MOST_BYTES), encoding=encoding) as stream:
        return stream.read()
