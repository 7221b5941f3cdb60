"""A driver with its database, and what its errors mean to a person."""

from __future__ import annotations

import logging
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING, Any, Self

import neo4j
from neo4j import exceptions as driver_errors

from foon_kg.model.errors import GraphError
from foon_kg.store.disk import could_not_write
from foon_kg.store.settings import ConnectionSettings

if TYPE_CHECKING:
    from pathlib import Path

    from neo4j.api import BookmarkManager

_UNREACHABLE = (driver_errors.ServiceUnavailable, driver_errors.SessionExpired, driver_errors.ConnectionPoolError)
_SCHEMES = ("bolt://", "bolt+s://", "bolt+ssc://", "neo4j://", "neo4j+s://", "neo4j+ssc://")
_ANSWER_SECONDS = 8.0
"""In which a Neo4j that is up lets a connection in."""
_ADDRESS_HINT = "Check NEO4J_URI: neo4j://host:7687, bolt://host:7687, or neo4j+s:// for an encrypted connection."
_NOT_CAUGHT_UP = ("Neo.TransientError.Transaction.BookmarkTimeout", "Neo.ClientError.Transaction.InvalidBookmark")
_DATABASE_NOT_FOUND = "Neo.ClientError.Database.DatabaseNotFound"


class Connection:
    """One Neo4j database. Opens nothing before the first session; close it, or use it in a ``with`` statement."""

    def __init__(self, settings: ConnectionSettings) -> None:
        self.settings = settings

    @cached_property
    def _driver(self) -> neo4j.Driver:
        if not self.settings.uri.startswith(_SCHEMES):
            raise GraphError(f"{self.settings.uri} is no address of a Neo4j", hint=_ADDRESS_HINT, code="address")
        driver = neo4j.GraphDatabase.driver(
            self.settings.uri,
            auth=(self.settings.user, self.settings.password),
            connection_timeout=_ANSWER_SECONDS,
            connection_acquisition_timeout=_ANSWER_SECONDS,
            notifications_min_severity=neo4j.NotificationMinimumSeverity.OFF,
            warn_notification_severity=neo4j.NotificationMinimumSeverity.OFF,
        )
        try:
            driver.verify_connectivity()  # at once: a managed transaction would try for half a minute
        except BaseException:  # Ctrl-C too: nobody else has the driver, to close its sockets
            driver.close()
            raise
        return driver

    @cached_property
    def _bookmarks(self) -> BookmarkManager | None:
        """What keeps the bookmarks of a cluster; of a single server, which is never behind itself, nothing."""
        if not self.settings.uri.startswith("neo4j"):
            return None
        from foon_kg.store.graph.bookmarks import bookmarks_of  # noqa: PLC0415 - few address a cluster

        return bookmarks_of(self.settings)

    @contextmanager
    def session(
        self, *, writing: bool = False, warned: bool = False, at_once: int | None = None
    ) -> Iterator[neo4j.Session]:
        """Open a session for reading, or for ``writing``. Whatever the driver raises becomes a GraphError.

        Of a cluster, reads go to followers, and see what programs of this user wrote (:mod:`bookmarks`).

        Who wants to be ``warned`` finds in the summaries what the server finds odd about a question. ``at_once`` says
        how many rows the server sends without being asked for more, where that is not what the driver has chosen.
        """
        told: dict[str, Any] = {}
        if at_once is not None:
            told["fetch_size"] = at_once
        if warned:
            told["notifications_min_severity"] = neo4j.NotificationMinimumSeverity.WARNING
            logging.getLogger("neo4j.notifications").setLevel(logging.ERROR)  # who asks reads them, and tells them
        mode = neo4j.WRITE_ACCESS if writing else neo4j.READ_ACCESS
        with (
            explained(self.settings),
            self._driver.session(
                database=self.settings.database,
                default_access_mode=mode,
                bookmark_manager=self._bookmarks,
                **told,
            ) as session,
        ):
            yield session

    def close(self) -> None:
        """Give the sockets back."""
        if "_driver" in self.__dict__:
            self._driver.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


@contextmanager
def explained(settings: ConnectionSettings) -> Iterator[None]:
    """Raise what the driver raises as GraphErrors that say what to do about the Neo4j of these ``settings``."""
    try:
        yield
    except driver_errors.IncompleteCommit as error:
        raise GraphError(
            f"{settings.uri} was lost while it stored a transaction",
            hint="Do it again: what was stored already changes nothing.",
        ) from error
    except _UNREACHABLE as error:
        raise GraphError(
            f"no Neo4j answers at {settings.uri}",
            hint="Start it, or name another in NEO4J_URI; without NEO4J_URI foon-kg runs its own (foon server start).",
            code="unreachable",
        ) from error
    except driver_errors.AuthError as error:
        raise GraphError(
            f"{settings.uri} does not let the user “{settings.user}” in: {error.message}",
            hint="Check NEO4J_USER and NEO4J_PASSWORD.",
            code="login",
        ) from error
    except driver_errors.ConfigurationError as error:
        raise GraphError(f"{settings.uri}: {error}", hint=_ADDRESS_HINT) from error
    except driver_errors.Neo4jError as error:
        raise _refused(error, settings) from error
    except driver_errors.DriverError as error:
        raise GraphError(f"{settings.uri}: {error}", hint="Is this a Neo4j, 5.26 or newer?") from error


def _bookmark_folder() -> Path:
    from foon_kg.store.graph.bookmarks import bookmark_folder  # noqa: PLC0415 - few address a cluster

    return bookmark_folder()


def _refused(error: driver_errors.Neo4jError, settings: ConnectionSettings) -> GraphError:
    """Return what an answer of the server means; after a full disk it answers nothing until it is started anew."""
    if could_not_write(error.code, error.message):
        return GraphError(
            f"the Neo4j at {settings.uri} could not write to its disk, and answers nothing until it is started again",
            hint="End it first (foon server stop; another with kill -9: an orderly end could still write, behind "
            "what was torn off), then make room and start it. What was stored is there.",
            code="broken",
        )
    if (error.code or "").startswith(_NOT_CAUGHT_UP):
        return GraphError(
            f"the member of the cluster {settings.uri} that was asked does not have yet what was written last",
            hint="Ask again when it has. Where the database was replaced since, as from a backup, take away what "
            f"names that transaction: {_bookmark_folder()}.",
            code="behind",
        )
    if error.code == _DATABASE_NOT_FOUND:
        hint = f"There is no database “{settings.database}”: check NEO4J_DATABASE."
    else:
        hint = "See the log of the database."
    return GraphError(f"{settings.uri}: {error.message}", hint=hint)
