"""A long JSON list in a file, one element after another in bounded memory."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from foon_kg.loaders.json_document import ENDS_EARLY, stream_items
from foon_kg.loaders.notices import UnreadableFile
from foon_kg.loaders.text_blocks import text_blocks
from foon_kg.model.errors import ReadError


def stream_list(path: Path) -> Iterator[tuple[int, object]]:
    """Yield each element of the list in ``path`` with its number, from 1.

    Raises :class:`~foon_kg.model.errors.ReadError` with the line and the number of the element where the text ends too
    early, is no JSON or no UTF-8, or where the file holds no list.
    """
    number = 0
    try:
        for number, value in enumerate(stream_items(text_blocks(path)), start=1):
            yield number, value
    except UnreadableFile as unreadable:
        message = unreadable.problem.message
        place, hint = f"element {number + 1}: ", "Mend this element; the ones before it are fine."
        if message == ENDS_EARLY:
            hint = "The file ends in the middle: fetch it again."
        elif message.endswith("is not UTF-8"):  # found out block by block, before there are elements
            place, hint = "", "Save it as UTF-8."
        elif "no JSON list" in message:
            place, hint = "", "A collection of recipes is one list: [{…}, {…}]."
        raise ReadError(f"{path}:{unreadable.line or 1}: {place}{message}", hint=hint) from unreadable
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror}", hint="Make the file readable.") from error
