"""What a FOON in a Neo4j can do besides: be asked in Cypher, and be changed.

The examples are of a Neo4j that holds the demo's FOON.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from foon_kg.foon.exploring import Exploring
from foon_kg.foon.opened import Paths, path_at, silent
from foon_kg.model.errors import ReadError
from foon_kg.model.nodes import one_spelling

if TYPE_CHECKING:  # every question imports what it needs
    from foon_kg.food.motion_costs import MotionCosts
    from foon_kg.foon.collected import Recipes
    from foon_kg.foon.drafting import Drafting
    from foon_kg.model import Subgraph
    from foon_kg.plans.difference import VideoDifference
    from foon_kg.store.graph.free_cypher import Answer as CypherAnswer
    from foon_kg.store.graph.loading import LoadReport
    from foon_kg.store.graph.weights import WeightsReport


class Changing(Exploring):
    """A FOON that can be asked in Cypher, loaded and changed, where it is in a Neo4j."""

    @property
    def recipes(self) -> Recipes:
        """The recipes of collections that the Neo4j holds beside the videos.

        >>> foon.recipes.get("limeade").title
        'Limeade'
        """
        from foon_kg.foon.collected import Recipes

        return Recipes(self)

    @property
    def drafting(self) -> Drafting:
        """What drafts subgraphs of recipes and videos that are told in words, and keeps drafts in the Neo4j.

        >>> foon.drafting.store([]).inserted
        0
        """
        from foon_kg.foon.drafting import Drafting

        return Drafting(self)

    def cypher(
        self,
        text: str,
        parameters: Mapping[str, Any] | None = None,
        *,
        write: bool = False,
        limit: int = 1_000,
        timeout: float = 30,
    ) -> CypherAnswer:
        """Return the rows of a question in Cypher: at most ``limit``, in ``timeout`` seconds.

        Its ``text`` may have ``parameters`` (``$name``). What is more than a look at the graph is refused
        (:class:`~foon_kg.model.errors.WriteRefused`) unless it shall ``write``. Raises
        :class:`~foon_kg.model.errors.GraphError`, and :class:`~foon_kg.model.errors.UsageError` for a FOON in files.

        >>> foon.cypher("MATCH (v:Video) WHERE v.name STARTS WITH $x RETURN v.name", {"x": "greek"}).rows
        (('greek_salad',),)
        """
        connection = self.connection_for("to be asked in Cypher")
        from foon_kg.store.graph.free_cypher import ask_freely

        return ask_freely(connection, text, parameters, write=write, limit=limit, timeout=timeout)

    def load(self, *paths: Paths) -> LoadReport:
        """Bring files and tables into the graph, all or none, and return which were new, replaced and unchanged.

        ``paths`` are subgraphs (text or JSON), tables of steps (CSV) and folders of them.

        Raises :class:`~foon_kg.model.errors.ReadError` where one of them cannot be read whole, and
        :class:`~foon_kg.model.errors.UsageError` for a FOON in files.

        >>> foon.load(demo_folder() / "greek_salad.txt").unchanged
        ('greek_salad',)
        """
        self._needs_server("to load files")
        from foon_kg.loaders import Severity
        from foon_kg.loaders.video_tables import read_videos

        results = list(read_videos([path_at(path) for path in paths]))
        bad = [notice for result in results for notice in result.notices if notice.severity is Severity.REJECTED]
        if bad:
            raise ReadError(str(bad[0]), hint="Mend it, or load with “foon load foon --bad-tolerance”.")
        return self.store([result.subgraph for result in results if result.subgraph is not None])

    def store(
        self, subgraphs: Iterable[Subgraph], stored: Callable[[LoadReport], None] = silent, *, at_once: bool = False
    ) -> LoadReport:
        """Bring subgraphs that were read already into the graph, as :meth:`load` does.

        ``stored`` is told of each part of them that is in the graph; ``at_once`` there is one part only, all or none.
        Else only a part of an iterator is in memory at a time.

        >>> len(foon.store(foon.snapshot().subgraphs[:2]).unchanged)
        2
        """
        connection = self.connection_for("to load files")
        from foon_kg.store.graph import load

        if not at_once:
            return load(connection, subgraphs, stored=stored)
        all_of_them = list(subgraphs)
        units = 1 + sum(len(subgraph.annotations) for subgraph in all_of_them)
        return load(connection, all_of_them, stored=stored, units_per_transaction=units)

    def holds(self, contents: Mapping[str, str]) -> bool:
        """Return whether the graph has videos of these names and ``contents`` (hashes), written as this program would.

        A graph of another schema, or none at all, does not: a load tells why.

        >>> foon.holds({"greek_salad": "another content"})
        False
        """
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.store.graph.unchanged import all_there

        return all_there(self.connection_for("to load files"), contents, Kitchen.default())

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

        >>> [(one.name, one.status.value) for one in foon.remove(["greek_salad"], dry_run=True)]
        [('greek_salad', 'removed')]
        """
        connection = self.connection_for("to take videos out of")
        from foon_kg.store.graph import remove
        from foon_kg.store.graph.differences import losses

        names = list(map(one_spelling, videos))
        found = losses(connection, names)
        if not dry_run:
            remove(connection, names)
        return found

    def store_weights(self, costs: MotionCosts) -> WeightsReport:
        """Store the ``costs`` of motions for a robot (0: always succeeds, 1: never), in place of all stored before.

        >>> from foon_kg.food.motion_costs import MotionCosts
        >>> foon.store_weights(MotionCosts({"chop": 0.9})).motions
        1
        """
        from foon_kg.store.graph import load_weights

        return load_weights(self.connection_for("for weights"), costs)
