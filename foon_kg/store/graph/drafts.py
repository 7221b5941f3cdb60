"""Drafts of recipes in the graph: loaded, replaced and taken out, apart from all that annotated videos teach.

``(:Draft {name, id, title, dish_type, confidence, units, left_out, motions, foods, table, content})``. Nothing else of
the graph knows of them: what is counted, learnt and found for a plan is that of the videos, whatever drafts there are.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

import neo4j

from foon_kg.loaders.lessons import lesson_of
from foon_kg.model import FunctionalUnit
from foon_kg.model.drafted import DRAFT, DraftedRecipe
from foon_kg.model.errors import UsageError
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.graph import statements as cypher
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.schema import prepare_for_writing
from foon_kg.store.graph.statements import ask

DRAFTS_PER_TRANSACTION = 500


@dataclass(frozen=True)
class DraftsStored:
    """How many drafts were new, had another content, were there as they are, and teach no dish: those are left out."""

    inserted: int = 0
    replaced: int = 0
    unchanged: int = 0
    left_out: int = 0

    def __add__(self, other: DraftsStored) -> DraftsStored:
        """Return both as one."""
        return DraftsStored(
            self.inserted + other.inserted,
            self.replaced + other.replaced,
            self.unchanged + other.unchanged,
            self.left_out + other.left_out,
        )

    def __len__(self) -> int:
        """Return how many drafts it is about."""
        return self.inserted + self.replaced + self.unchanged + self.left_out


def load_drafts(
    connection: Connection,
    drafts: Iterable[DraftedRecipe],
    kitchen: Kitchen | None = None,
    *,
    stored: Callable[[DraftsStored], None] = lambda _: None,
    per_transaction: int = DRAFTS_PER_TRANSACTION,
) -> DraftsStored:
    """Bring the graph of ``connection`` to have ``drafts``; one of a known name is replaced, the same stays as it is.

    Of two of one name the last counts. One that teaches no dish any more takes its former version out with it.

    ``kitchen`` is the usual one for ``None``. ``stored`` is told of each transaction, with so many drafts
    (``per_transaction``), when it is safe: after a kill, the next load goes on behind it. Raises GraphError when the
    database fails.
    """
    kitchen = kitchen or Kitchen.default()
    total = DraftsStored()
    with connection.session(writing=True) as session:
        prepare_for_writing(session, kitchen)
        for batch in _batches(drafts, per_transaction):
            rows = [(one, _row(one, kitchen)) for one in batch]
            latest = {one.name: (one, row) for one, row in rows}
            taught = {name: (one, row) for name, (one, row) in latest.items() if row is not None}
            report = session.execute_write(_write, taught, sorted(latest.keys() - taught.keys()))
            left_out = sum(row is None for _, row in rows)
            report += DraftsStored(replaced=len(rows) - left_out - len(taught), left_out=left_out)
            stored(report)
            total += report
    return total


def remove_drafts(connection: Connection, names: Collection[str]) -> None:
    """Take the drafts called ``names`` out of the graph of ``connection``, all in one transaction.

    Raises :class:`~foon_kg.model.errors.UsageError` where the graph lacks one of ``names``; nothing is removed then.
    """
    with connection.session(writing=True) as session:
        session.execute_write(_remove, sorted(set(names)))


def check_drafts(connection: Connection, names: Collection[str]) -> None:
    """Raise UsageError where the graph of ``connection`` lacks one of the drafts called ``names``."""
    with connection.session() as session:
        there = {row.name for row in session.execute_read(ask, cypher.DRAFT_CONTENTS, names=sorted(names))}
    if unknown := [name for name in names if name not in there]:
        raise unknown_drafts(unknown)


def _write(
    transaction: neo4j.ManagedTransaction,
    taught: dict[str, tuple[DraftedRecipe, dict[str, object]]],
    barren: Sequence[str],
) -> DraftsStored:
    """Write the drafts that are ``taught``, by name, and take out what the graph had of those that are ``barren``."""
    if barren:
        ask(transaction, cypher.FORGET_DRAFTS, names=list(barren))
    names = sorted(taught)
    there = {row.name: row.content for row in ask(transaction, cypher.DRAFT_CONTENTS, names=names)}
    changed = [name for name in names if there.get(name) != taught[name][0].content]
    if changed:
        ask(transaction, cypher.LOAD_DRAFTS, drafts=[taught[name][1] for name in changed])
    known = sum(name in there for name in changed)
    return DraftsStored(len(changed) - known, known, len(names) - len(changed))


def _remove(transaction: neo4j.ManagedTransaction, names: Sequence[str]) -> None:
    gone = {row.key for row in ask(transaction, cypher.FORGET_DRAFTS, names=list(names))}
    if unknown := [name for name in names if name not in gone]:
        raise unknown_drafts(unknown)


def unknown_drafts(names: Sequence[str]) -> UsageError:
    """Return the error that says that the graph does not have the drafts called ``names``."""
    return UsageError(
        f"the graph has no draft “{'”, “'.join(sorted(names))}”",
        hint=f"A draft is named {DRAFT} and the id of its recipe: foon cypher 'MATCH (d:Draft) RETURN d.name'.",
    )


def _row(drafted: DraftedRecipe, kitchen: Kitchen) -> dict[str, object] | None:
    """Return a draft as the graph keeps it, ``None`` where it teaches no dish."""
    lesson = lesson_of(drafted)
    if lesson is None:
        return None
    units = [annotation.unit for annotation in lesson.subgraph.annotations]
    return {
        "name": drafted.name,
        "id": drafted.id,
        "title": drafted.title,
        "dish_type": drafted.dish_type,
        "confidence": drafted.confidence,
        "units": drafted.units,
        "left_out": drafted.left_out,
        "motions": [unit.motion for unit in units],
        "foods": sorted(_foods(units, kitchen)),
        "table": drafted.table,
        "content": drafted.content,
    }


def _foods(units: Iterable[FunctionalUnit], kitchen: Kitchen) -> set[str]:
    nodes = (node for unit in units for node in (*unit.input_nodes, *unit.output_nodes))
    return {node.label for node in nodes if not kitchen.is_utensil(node.label)}


def _batches(drafts: Iterable[DraftedRecipe], size: int) -> Iterator[list[DraftedRecipe]]:
    waiting = iter(drafts)
    while batch := list(islice(waiting, size)):
        yield batch
