"""A long JSON list, one element after another in bounded memory."""

from __future__ import annotations

import codecs
from collections.abc import Iterator
from pathlib import Path
from typing import IO

from foon_kg.errors import ReadError, UsageError

_BLOCK = 1 << 16
"""Bytes read at a time; the place of an error is known to within one block."""


def stream_list(path: Path) -> Iterator[tuple[int, object]]:
    """Answer each element of the list in ``path`` with its number, from 1.

    Raises :class:`~foon_kg.errors.ReadError` with the number of the element and the byte where the text ends too early,
    is no JSON or no UTF-8, or where the file holds no list; UsageError where the extra ``recipes`` is not installed.
    """
    try:
        import ijson  # noqa: PLC0415 - an extra
    except ImportError as error:
        hint = "pip install 'foon-kg[recipes]'"
        raise UsageError("ijson is not installed.", hint=hint, code="recipes") from error
    number = 0
    try:
        with path.open("rb") as stream:
            _expect_list(path, stream)
            for number, value in enumerate(ijson.items(stream, "item", use_float=True, buf_size=_BLOCK), start=1):
                yield number, value
    except ijson.JSONError as error:
        where = f"{path}: element {number + 1}"
        raise ReadError(f"{where}: not JSON: {_reason(error)}", hint=_hint(error)) from error
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror}", hint="Make the file readable.") from error


def _expect_list(path: Path, stream: IO[bytes]) -> None:
    """Go to the bracket that opens the list; a byte order mark of UTF-8 before it is passed over."""
    head = stream.read(_BLOCK)
    start = len(codecs.BOM_UTF8) if head.startswith(codecs.BOM_UTF8) else 0
    text = head[start:].lstrip()
    if head.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        raise ReadError(f"{path}:1: not UTF-8: it begins like UTF-16", hint="Save it as UTF-8.")
    if not text.startswith(b"["):
        shown = text[:1].decode("latin-1")
        raise ReadError(
            f"{path}:1: no JSON list ({f'it begins with {shown}' if shown else 'it is empty'})",
            hint="A collection of recipes is one list: [{…}, {…}].",
        )
    stream.seek(start)


def _reason(error: Exception) -> str:
    message = error.args[0] if error.args else ""
    text = message.decode("utf-8", "replace") if isinstance(message, bytes) else str(message)
    return text.splitlines()[0].rstrip(".") if text else "unreadable"


def _hint(error: Exception) -> str:
    reason = _reason(error)
    if "EOF" in reason:
        return "The file ends in the middle: fetch it again."
    return "Save it as UTF-8." if "UTF8" in reason else "Mend this element; the ones before it are fine."
