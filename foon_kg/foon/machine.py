"""What foon-kg has and needs on this machine: its own Neo4j, and what stands in its way."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING

from foon_kg.foon.opened import Say, silent

if TYPE_CHECKING:  # every question imports what it needs
    from foon_kg.model import Subgraph
    from foon_kg.store.doctor import Finding
    from foon_kg.store.offline.importing import ImportReport
    from foon_kg.store.offline.staged import Staged
    from foon_kg.store.server import Status as ServerStatus


class ThisMachine:
    """The Neo4j that foon-kg runs by itself, and the machine that it runs on. Nothing here is of a single FOON."""

    @staticmethod
    def examine(*, thorough: bool = False) -> Iterator[Finding]:
        """Yield what stands in the way of foon-kg on this machine, and what to do about it, as ``foon doctor`` does.

        ``thorough`` reads every file of the local Neo4j, too (some seconds). Nothing is started, fetched or written.

        >>> next(ThisMachine.examine()).subject
        'Python'
        """
        from foon_kg.store.doctor import examine

        return examine(thorough=thorough)

    @staticmethod
    def start_server(*, port: int | None = None, idle_minutes: float | None = None, say: Say = silent) -> ServerStatus:
        """Start foon-kg's own Neo4j, or find that it runs, and return how it is now.

        ``port`` is the one it listens on (else the one it had, first a free one); it stops after so many
        ``idle_minutes`` without use (0: never). What is done goes to ``say``. Raises
        :class:`~foon_kg.model.errors.ServerError` where it cannot be started.
        """
        from foon_kg.store.server import start, status

        start(port=port, idle_minutes=idle_minutes, say=say)
        return status()

    @staticmethod
    def stop_server(*, say: Say = silent) -> bool:
        """Stop foon-kg's own Neo4j, whose data stays; whether it ran. What is done goes to ``say``."""
        from foon_kg.store.server import stop

        return stop(say)

    @staticmethod
    def server_status() -> ServerStatus:
        """Return whether foon-kg's own Neo4j runs, where it answers, and where its data, password and log are.

        >>> ThisMachine.server_status().user
        'neo4j'
        """
        from foon_kg.store.server import status

        return status()

    @staticmethod
    def import_offline(
        subgraphs: Iterable[Subgraph],
        *,
        replace: bool = False,
        say: Say = silent,
        told: Callable[[int], None] = silent,
        beside: Callable[[Staged], None] | None = None,
    ) -> ImportReport:
        """Make ``subgraphs`` the FOON of foon-kg's own Neo4j by neo4j-admin's import: for very many of them.

        A part of them is in memory at a time; ``told`` hears how many were read, ``say`` what is done. What comes in
        ``beside`` them (:meth:`Recipes.stage <foon_kg.foon.collected.Recipes.stage>`) is staged when they are. Raises
        ``UsageError`` where NEO4J_URI names another Neo4j, and where the server holds anything that is not to be
        replaced (``replace``).
        """
        from foon_kg.store.offline.importing import load_offline

        return load_offline(subgraphs, replace=replace, say=say, told=told, beside=beside)
