"""What a FOON in a Neo4j can do besides: be asked in Cypher, and be changed."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from foon_kg.foon.opened import Opened, Paths, silent
from foon_kg.model.errors import ReadError

if TYPE_CHECKING:  # every question imports what it needs
    from foon_kg.model import Subgraph
    from foon_kg.plans.difference import VideoDifference
    from foon_kg.store.graph.free_cypher import Answer as CypherAnswer
    from foon_kg.store.graph.loading import LoadReport


class Changing(Opened):
    """A FOON that can be asked in Cypher, loaded and changed, where it is in a Neo4j."""

    def cypher(
        self,
        text: str,
        parameters: Mapping[str, Any] | None = None,
        *,
        write: bool = False,
        limit: int = 1_000,
        timeout: float = 30,
    ) -> CypherAnswer:
        """Return the rows of a question in Cypher with its ``parameters``: at most ``limit``, in ``timeout`` seconds.

        What is more than a look at the graph is refused (:class:`~foon_kg.model.errors.WriteRefused`) unless it shall
        ``write``. Raises :class:`~foon_kg.model.errors.GraphError`, and :class:`~foon_kg.model.errors.UsageError` for a
        FOON in files.
        """
        self._needs_server("to be asked in Cypher")
        from foon_kg.store.graph.free_cypher import ask_freely

        return ask_freely(self._connection, text, parameters, write=write, limit=limit, timeout=timeout)

    def load(self, *paths: Paths) -> LoadReport:
        """Bring files and tables into the graph, all or none, and return which were new, replaced and unchanged.

        Raises :class:`~foon_kg.model.errors.ReadError` where one of them cannot be read whole, and
        :class:`~foon_kg.model.errors.UsageError` for a FOON in files.
        """
        self._needs_server("to load files")
        from foon_kg.loaders import Severity
        from foon_kg.loaders.video_tables import read_videos

        results = list(read_videos([Path(path) for path in paths]))
        bad = [notice for result in results for notice in result.notices if notice.severity is Severity.REJECTED]
        if bad:
            raise ReadError(str(bad[0]), hint="Mend it, or load with “foon load foon --bad-tolerance”.")
        return self.store([result.subgraph for result in results if result.subgraph is not None])

    def store(self, subgraphs: Sequence[Subgraph], stored: Callable[[LoadReport], None] = silent) -> LoadReport:
        """Bring subgraphs that were read already into the graph, as :meth:`load` does.

        ``stored`` is told of each part of them that is in the graph.
        """
        self._needs_server("to load files")
        from foon_kg.store.graph import load

        report = load(self._connection, subgraphs, stored=stored)
        self.__dict__.pop("known", None)
        return report

    def differences(self, subgraphs: Sequence[Subgraph]) -> Sequence[VideoDifference]:
        """Return what loading ``subgraphs`` would change, one by one: units that are new, known, as before or gone.

        >>> from foon_kg.loaders import read_paths
        >>> (salad,) = (one.subgraph for one in read_paths([demo_folder() / "greek_salad.txt"]))
        >>> foon.differences([salad])[0].status.value
        'unchanged'
        """
        if self._snapshot is not None:
            from foon_kg.plans.difference import differences as differences_in_memory

            return differences_in_memory(subgraphs, self._snapshot.subgraphs)
        from foon_kg.store.graph.differences import differences

        return differences(self._connection, subgraphs)

    def remove(self, videos: Sequence[str], *, dry_run: bool = False) -> Sequence[VideoDifference]:
        """Take videos out of the graph, all or none, and return what goes with each: units that no other video shows.

        With ``dry_run`` nothing goes. Raises :class:`~foon_kg.model.errors.UsageError` for a FOON in files, and where
        the graph has no such video.
        """
        self._needs_server("to take videos out of")
        from foon_kg.store.graph import remove
        from foon_kg.store.graph.differences import losses

        found = losses(self._connection, videos)
        if not dry_run:
            remove(self._connection, videos)
            self.__dict__.pop("known", None)
        return found

    def remove_drafts(self, names: Sequence[str], *, dry_run: bool = False) -> None:
        """Take drafts of recipes (``draft:ID``) out of the graph, all or none.

        With ``dry_run`` nothing goes. Raises :class:`~foon_kg.model.errors.UsageError` for a FOON in files, and where
        the graph has no such draft.
        """
        self._needs_server("to take drafts out of")
        from foon_kg.store.graph.drafts import check_drafts, remove_drafts

        check_drafts(self._connection, names)
        if not dry_run:
            remove_drafts(self._connection, names)
