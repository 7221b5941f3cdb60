"""Bringing subgraphs into the graph, replacing them and taking them out, each video whole or not at all."""

from __future__ import annotations

import uuid
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import chain

import neo4j

from foon_kg.model import Subgraph
from foon_kg.model.errors import SchemaError
from foon_kg.model.nodes import distinct_by_name, two_of_one_name
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.differences import unknown_videos
from foon_kg.store.graph.learnt_by import methods_key
from foon_kg.store.graph.schema import check_readable, kitchen_key, prepare_for_writing, read_state
from foon_kg.store.graph.statements import VIDEO_CONTENTS, VIDEO_NAMES, ask
from foon_kg.store.graph.taught import Ahead, Taught
from foon_kg.store.graph.writing import Writer

UNITS_PER_TRANSACTION = 2_500
"""Bounds the memory of the database for one transaction; the 111 public subgraphs are one."""


VIDEOS_LEARNT_AT_ONCE = 200
FORGOTTEN_AT_ONCE = 50_000
"""Bound the memory of the database where operators and frames are learnt anew."""


@dataclass(frozen=True)
class LoadReport:
    """The names of the videos that were new, that had another content, and that were there already as they are."""

    inserted: tuple[str, ...] = ()
    replaced: tuple[str, ...] = ()
    unchanged: tuple[str, ...] = ()

    def __len__(self) -> int:
        """Return how many videos it is about."""
        return len(self.inserted) + len(self.replaced) + len(self.unchanged)

    def __add__(self, other: LoadReport) -> LoadReport:
        """Return both reports as one."""
        return LoadReport(
            self.inserted + other.inserted, self.replaced + other.replaced, self.unchanged + other.unchanged
        )


def _say_nothing(_: LoadReport) -> None:
    return


def load(
    connection: Connection,
    subgraphs: Iterable[Subgraph],
    kitchen: Kitchen | None = None,
    *,
    stored: Callable[[LoadReport], None] = _say_nothing,
    units_per_transaction: int = UNITS_PER_TRANSACTION,
) -> LoadReport:
    """Bring the graph of ``connection`` to have ``subgraphs``, in few transactions; a known name is replaced.

    ``kitchen`` is the usual one for ``None``; a transaction has so many units (``units_per_transaction``). Of an
    iterator a few transactions' subgraphs are in memory at a time. ``stored`` is told, first (of an iterator: of each
    part), what is there already, and after each transaction which videos are safe from then on. Raises
    :class:`~foon_kg.model.errors.ReadError` when two subgraphs of one name differ, GraphError when the database fails;
    what was reported as stored stays.
    """
    kitchen, total = kitchen or Kitchen.default(), _Total(stored)
    groups = _groups(subgraphs, units_per_transaction)
    with connection.session(writing=True) as session, Ahead(kitchen) as ahead:
        first = next(groups, ())
        if read_state(session) is None:  # all is new: it is learnt from while the database makes its indexes
            ahead.begin(next(batches(first, units_per_transaction), ()))
        _begin(session, kitchen)
        new = _lacking(session, chain([first], groups), total)
        for batch in ahead.through(batches(new, units_per_transaction)):
            total.add(session.execute_write(_write, batch, kitchen, ahead))
    return total.report


class _Total:
    """The report of all parts of a load; ``stored`` is told of each."""

    def __init__(self, stored: Callable[[LoadReport], None]) -> None:
        self._stored = stored
        self.report = LoadReport()

    def add(self, part: LoadReport) -> None:
        """Add the report of one part."""
        self._stored(part)
        self.report += part


def _groups(subgraphs: Iterable[Subgraph], units: int) -> Iterator[Sequence[Subgraph]]:
    """Yield ``subgraphs``, equal ones once: those in memory at once, of an iterator some more than ``units`` at a time.

    Raises ReadError for two of one name that differ: at first where all are in memory.
    """
    if isinstance(subgraphs, Collection):
        yield distinct_by_name(subgraphs)
    else:
        yield from batches(_distinct_in_turn(subgraphs), units)


def _distinct_in_turn(subgraphs: Iterable[Subgraph]) -> Iterator[Subgraph]:
    contents: dict[str, str] = {}
    for subgraph in subgraphs:
        known = contents.setdefault(subgraph.name, "")
        if not known:
            contents[subgraph.name] = subgraph.content_key
            yield subgraph
        elif known != subgraph.content_key:
            raise two_of_one_name(subgraph.name)


def _lacking(session: neo4j.Session, groups: Iterable[Sequence[Subgraph]], total: _Total) -> Iterator[Subgraph]:
    """Yield those of ``groups`` that the graph lacks; ``total`` hears of the others."""
    for group in groups:
        report = session.execute_read(compare, group)
        total.add(report)
        there = set(report.unchanged)
        yield from (subgraph for subgraph in group if subgraph.name not in there)


def remove(connection: Connection, names: Collection[str], kitchen: Kitchen | None = None) -> None:
    """Take the videos called ``names``, and what no other video shows, out of the graph of ``connection``.

    All go in one transaction; ``kitchen`` is the usual one for ``None``. Raises
    :class:`~foon_kg.model.errors.UsageError` when the graph lacks one of ``names``; nothing is removed then.
    """
    kitchen = kitchen or Kitchen.default()
    with connection.session(writing=True) as session:
        _begin(session, kitchen)
        session.execute_write(_remove, sorted(set(names)), kitchen)


def compare(transaction: neo4j.ManagedTransaction, wanted: Sequence[Subgraph]) -> LoadReport:
    """Return, as ``unchanged``, which of ``wanted`` the graph has with the same content, asked in ``transaction``."""
    contents = _contents(transaction, [subgraph.name for subgraph in wanted])
    return LoadReport(unchanged=tuple(s.name for s in wanted if contents.get(s.name) == s.content_key))


def _begin(session: neo4j.Session, kitchen: Kitchen) -> None:
    state = prepare_for_writing(session, kitchen)
    if state.kitchen != kitchen_key(kitchen):
        session.execute_write(_write_anew, kitchen)
        return
    if state.words != word_lists_key():
        session.execute_write(_write_vectors, kitchen)
    if state.methods != methods_key():
        _learn_anew(session, kitchen)


def _write(
    transaction: neo4j.ManagedTransaction, batch: Sequence[Subgraph], kitchen: Kitchen, ahead: Ahead
) -> LoadReport:
    """Write ``batch``; what another program wrote since we looked is found out again."""
    writer = _writer(transaction, kitchen, teach=ahead.taught_by)
    contents = _contents(transaction, [subgraph.name for subgraph in batch])
    changed = [subgraph for subgraph in batch if contents.get(subgraph.name) != subgraph.content_key]
    writer.forget([subgraph.name for subgraph in changed if subgraph.name in contents])
    writer.add(changed)
    writer.finish()
    return _report(batch, {subgraph.name for subgraph in changed}, contents)


def _report(batch: Sequence[Subgraph], changed: Collection[str], contents: Collection[str]) -> LoadReport:
    """Return what became of ``batch``, of which ``changed`` were written; ``contents`` was there before."""
    names = [subgraph.name for subgraph in batch]
    return LoadReport(
        inserted=tuple(name for name in names if name in changed and name not in contents),
        replaced=tuple(name for name in names if name in changed and name in contents),
        unchanged=tuple(name for name in names if name not in changed),
    )


def _remove(transaction: neo4j.ManagedTransaction, names: Sequence[str], kitchen: Kitchen) -> None:
    writer = _writer(transaction, kitchen)
    if unknown := sorted(set(names) - _contents(transaction, names).keys()):
        raise unknown_videos(transaction, unknown)
    writer.forget(names)
    writer.drop_videos(names)
    writer.finish()


def _writer(
    transaction: neo4j.ManagedTransaction,
    kitchen: Kitchen,
    learnt_by: str = "",
    teach: Callable[[Subgraph], Taught] | None = None,
) -> Writer:
    """Open a writer; raises unless the graph still is as this program left it."""
    writer = Writer(partial(ask, transaction), kitchen, teach)
    check_readable(writer.state, kitchen)
    if writer.state is not None and writer.state.methods != (learnt_by or methods_key()):
        raise SchemaError(
            "another foon-kg learnt the operators and frames of the graph anew meanwhile",
            hint="Load again; and let all programs that write this graph be of one version.",
        )
    return writer


def _write_anew(transaction: neo4j.ManagedTransaction, kitchen: Kitchen) -> None:
    Writer(partial(ask, transaction), kitchen).write_anew()


def _write_vectors(transaction: neo4j.ManagedTransaction, kitchen: Kitchen) -> None:
    Writer(partial(ask, transaction), kitchen).finish()


def _learn_anew(session: neo4j.Session, kitchen: Kitchen) -> None:
    """Learn operators and frames of the whole FOON again, as this program does, a part in each transaction.

    Until all is learnt the record has a mark of ours in place of what they were learnt by: nobody reads them, whoever
    writes is told, and where this program is killed the next load begins again.
    """
    mark = f"being learnt by {uuid.uuid4()}"
    names = session.execute_write(_begin_learning, kitchen, mark)
    while session.execute_write(_forget_some, kitchen, mark):
        pass
    for start in range(0, len(names), VIDEOS_LEARNT_AT_ONCE):
        session.execute_write(_learn_some, kitchen, mark, names[start : start + VIDEOS_LEARNT_AT_ONCE])
    session.execute_write(_end_learning, kitchen, mark)


def _begin_learning(transaction: neo4j.ManagedTransaction, kitchen: Kitchen, mark: str) -> list[str]:
    Writer(partial(ask, transaction), kitchen).record(mark)
    return [row.name for row in ask(transaction, VIDEO_NAMES)]


def _forget_some(transaction: neo4j.ManagedTransaction, kitchen: Kitchen, mark: str) -> bool:
    return _writer(transaction, kitchen, mark).forget_methods(FORGOTTEN_AT_ONCE)


def _learn_some(transaction: neo4j.ManagedTransaction, kitchen: Kitchen, mark: str, names: Sequence[str]) -> None:
    _writer(transaction, kitchen, mark).learn(names)


def _end_learning(transaction: neo4j.ManagedTransaction, kitchen: Kitchen, mark: str) -> None:
    writer = _writer(transaction, kitchen, mark)
    writer.recount()
    writer.record(methods_key())


def _contents(transaction: neo4j.ManagedTransaction, names: Sequence[str]) -> dict[str, str]:
    return {row.name: row.content for row in ask(transaction, VIDEO_CONTENTS, names=names)}


def batches(subgraphs: Iterable[Subgraph], units: int) -> Iterator[list[Subgraph]]:
    """Group ``subgraphs``, in their order, so that each group has few more than ``units`` units."""
    batch: list[Subgraph] = []
    size = 0
    for subgraph in subgraphs:
        batch.append(subgraph)
        size += len(subgraph.annotations)
        if size >= units:
            yield batch
            batch, size = [], 0
    if batch:
        yield batch
