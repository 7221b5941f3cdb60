"""What can go wrong, as one tree of exceptions.

::

    FoonError
    ├── UsageError            the question cannot be read as asked           (exit code 2)
    │   └── TooManyUnitsError more units may take part in making it than a program should hold
    ├── NoTreeError           there is no task tree, and why                 (exit code 3)
    ├── ReadError             a file cannot be read as what it claims to be
    │   └── ToleranceError    more of it was rejected than was allowed
    ├── FormatError           a FOON holds something that the asked file format cannot say
    ├── GraphError            the database refused, is unreachable or holds something else
    │   ├── SchemaError       its schema is older or newer than this program
    │   └── WriteRefused      a read-only question tried to write or to reach outside the graph
    └── ServerError           the local Neo4j cannot be fetched, started or stopped

Every message says what is wrong and where; ``hint`` says what to do about it.
"""

from __future__ import annotations


class FoonError(Exception):
    """Root of every error that foon-kg raises on purpose.

    ``code`` is a short stable word for programs; ``hint`` is the next thing a person should try.
    """

    code: str = "error"
    exit_code: int = 1

    def __init__(self, message: str, *, hint: str = "", code: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.hint = hint
        if code:
            self.code = code


class UsageError(FoonError):
    """The question itself is not well formed: an unknown option value, an unreadable recipe."""

    code = "usage"
    exit_code = 2


class TooManyUnitsError(UsageError):
    """More units may take part in making a goal than a program should hold."""

    def __init__(self, most: int) -> None:
        super().__init__(
            f"more than {most:,} units may take part in making it",
            hint="Ask at level 3, where vessels of other contents are other things, or say more of the goal.",
        )


class NoTreeError(FoonError):
    """The question is fine and the answer is that there is no tree; ``code`` says which kind of no."""

    code = "no-tree"
    exit_code = 3


class ReadError(FoonError):
    """A file is not what it claims to be. The message carries ``file:line``."""

    code = "read"


class ToleranceError(ReadError):
    """More units of the input were rejected than the caller was ready to accept."""

    code = "tolerance"


class FormatError(FoonError):
    """What should be written cannot be said in that format: it would be read back as something else."""

    code = "format"


class GraphError(FoonError):
    """The database is unreachable, refused the query, or does not hold a FOON."""

    code = "graph"


class SchemaError(GraphError):
    """The graph was written by an older or a newer foon-kg."""

    code = "schema"


class WriteRefused(GraphError):  # noqa: N818 - it says what was done: the write was refused
    """A read-only question tried to change something, or to reach outside the graph."""

    code = "read-only"


class ServerError(FoonError):
    """The local Neo4j could not be fetched, started, reached or stopped."""

    code = "server"
