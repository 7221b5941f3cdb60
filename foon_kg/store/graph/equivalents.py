"""The known foods that may stand for others, by Neo4j's vector index: as by comparing all, without reading all."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from foon_kg.model.knowledge import UNLIKE, Neighbour
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity import food_similarity
from foon_kg.similarity.confidences import nearest_of_each
from foon_kg.similarity.points import Question, question
from foon_kg.similarity.word_lists import word_lists_key
from foon_kg.store.graph.connection import Connection
from foon_kg.store.graph.rows import EquivalentsRow
from foon_kg.store.graph.schema import check_readable
from foon_kg.store.graph.statements import EQUIVALENTS, SCHEMA_STATE
from foon_kg.store.graph.statements import ask as ask_in

FIRST = 64
"""So many points are asked for at first; of the public FOON, 20 hold the first five equivalents of any known food."""

MORE = 8
"""So many times as many are asked for next, where one further away may still be among the best."""

Ask = Callable[[Mapping[str, Any]], list[EquivalentsRow]]


def equivalents(
    connection: Connection, kitchen: Kitchen, names: Sequence[str], limit: int
) -> tuple[tuple[Neighbour, ...], ...] | None:
    """Return, for each of ``names``, the ``limit`` best known foods of the graph of ``connection``.

    Nothing else is read of what a view of it needs. ``None`` where they cannot be told by points (see
    :func:`find_equivalents`). Raises GraphError where no FOON answers, SchemaError for one of another version or
    written with another ``kitchen``.
    """
    with connection.session() as session, session.begin_transaction() as transaction:
        check_readable(next(iter(ask_in(transaction, SCHEMA_STATE)), None), kitchen)
        found = find_equivalents(lambda asked: ask_in(transaction, EQUIVALENTS, **asked), dict.fromkeys(names), limit)
    return None if found is None else tuple(found[name] for name in names)


def find_equivalents(ask: Ask, names: Iterable[str], limit: int) -> dict[str, tuple[Neighbour, ...]] | None:
    """Return the ``limit`` best known foods of each name; ``None`` where they are of other word lists.

    A food of which nothing is known has no point: nothing speaks for it where its name is not equal.

    ``ask`` takes the parameters of ``cypher/equivalents.cypher``. One round trip where 64 points settle every name.
    """
    waiting = {name: question(name) for name in names}
    found: dict[str, tuple[Neighbour, ...]] = {}
    count = max(FIRST, 2 * limit)
    while waiting:
        rows = ask({"words": word_lists_key(), "asked": [_asked(*item) for item in waiting.items()], "count": count})
        if not rows:
            return None
        for row, answer in zip(rows, _best(rows, limit), strict=True):
            is_all = len(row.nearest) < count
            if is_all or _is_settled(answer, row, waiting[row.name], limit):
                found[row.name] = answer
                del waiting[row.name]
        count *= MORE
    return found


def _asked(name: str, about: Question) -> dict[str, Any]:
    return {"name": name, "canonical": about.canonical_name, "point": about.point}


def _best(rows: Sequence[EquivalentsRow], limit: int) -> tuple[tuple[Neighbour, ...], ...]:
    """Return the best foods of each row, out of all that any of them names: one product for all."""
    known = {name for row in rows for name in row.equal}
    known.update(name for row in rows for name, is_food, _ in row.nearest if is_food)
    return nearest_of_each(food_similarity(), [row.name for row in rows], sorted(known), limit)


def _is_settled(answer: Sequence[Neighbour], row: EquivalentsRow, about: Question, limit: int) -> bool:
    """Say whether nothing further away than the last point is like it, or as good as the last of ``answer``."""
    most = about.most(min((cosine for _, _, cosine in row.nearest), default=0.0))
    return most < UNLIKE or (len(answer) == limit and answer[-1].confidence > most)
