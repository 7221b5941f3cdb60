"""What the file system says, in words a person can act on."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from foon_kg.model.errors import ServerError
from foon_kg.model.written_files import NO_ROOM

_UNWRITTEN = "Neo.DatabaseError.Transaction.TransactionLogError"
_BROKEN = ("critical error, and needs to be restarted", "No space left on device", "File too large", "quota exceeded")


@contextmanager
def explain_os_error(doing: str) -> Iterator[None]:
    """Turn an OSError of the block into a ServerError that begins with ``doing`` and says what to do."""
    try:
        yield
    except OSError as error:
        if error.errno in NO_ROOM:
            raise no_room(doing) from error
        raise ServerError(
            f"{doing}: {error.strerror or error}",
            hint="FOON_KG_HOME names another folder for the data, FOON_KG_CACHE another one for the jars",
            code="disk",
        ) from error


def no_room(doing: str) -> ServerError:
    """Return the error for a disk that got full while ``doing`` something."""
    return ServerError(
        f"{doing}: no space is left there",
        hint="free 1 GB and start again, or let FOON_KG_HOME (data) and FOON_KG_CACHE (jars) name folders elsewhere",
        code="no-space",
    )


def could_not_write(code: str | None, message: str | None) -> bool:
    """Return whether a Neo4j that says this (``code`` and ``message``) has failed to write.

    Then it answers nothing until it is started anew.
    """
    return code == _UNWRITTEN or any(words in (message or "") for words in _BROKEN)
