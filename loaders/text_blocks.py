"""The text of a file of any length, block by block, and what in it is no text."""

from __future__ import annotations

import codecs
import re
from collections.abc import Iterator
from pathlib import Path

from foon_kg.loaders.notices import UnreadableFile
from foon_kg.model.regular_files import open_regular

CONTROL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f]")

_BLOCK = 1 << 16
"""Bytes read at a time."""


def text_blocks(path: Path) -> Iterator[str]:
    """Yield the text of ``path`` in blocks of 64 KB, without a byte order mark.

    Raises UnreadableFile with line and byte where it is no UTF-8, OSError where the file cannot be opened.
    """
    decoder = codecs.getincrementaldecoder("utf-8")()
    line, passed, first = 1, 0, True
    with open_regular(path) as stream:
        while True:
            block = stream.read(_BLOCK)
            waiting = len(decoder.getstate()[0])
            try:
                text = decoder.decode(block, final=not block)
            except UnicodeDecodeError as error:
                line += error.object[: error.start].count(b"\n")
                at = passed - waiting + error.start
                raise UnreadableFile(f"byte {at} (0x{error.object[error.start]:02x}) is not UTF-8", line) from error
            if not block:
                return
            line += text.count("\n")
            passed += len(block)
            yield text.removeprefix("\ufeff") if first else text
            first = False


def half_character(text: str) -> str | None:
    """Return the half of a character in ``text``, as in U+D83D; ``None`` where there is none.

    JSON can say the first half of an emoji without the second, and no file or database can hold that.
    """
    try:
        text.encode()
    except UnicodeEncodeError as error:
        return f"U+{ord(text[error.start]):04X}"
    return None


def odd_character(text: str) -> str | None:
    """Return what in ``text`` no table can hold: half of a character, or a control character other than white space."""
    if half := half_character(text):
        return f"half of a character ({half})"
    control = CONTROL.search(text)
    return f"the control character U+{ord(control[0]):04X}" if control else None
