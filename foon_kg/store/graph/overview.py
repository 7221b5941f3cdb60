"""What is asked of a very large FOON by who looks around in it: each question reads a bounded part of the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING

from foon_kg.store.graph.rows import AroundLabelRow, NamesLikeRow, SizeRow
from foon_kg.store.graph.statements import AROUND_LABEL, NAMES_LIKE, SIZE, SOME_VIDEOS

if TYPE_CHECKING:
    from foon_kg.store.graph.reading import GraphView


def size_of(view: GraphView) -> SizeRow:
    """Return how large the FOON of ``view`` is, and its dish types."""
    (row,) = view.ask(SIZE)
    return row


def names_like(view: GraphView, text: str, folded: str, state: str, most: int) -> NamesLikeRow:
    """Return names in ``view`` with a word that begins with ``text``, or are compared by one that begins ``folded``.

    At most ``most`` of each way; of foods it is told whether they are seen in ``state``.
    """
    (row,) = view.ask(NAMES_LIKE, text=text, folded=folded, state=state, most=most)
    return row


def around_label(view: GraphView, label: str, most: int) -> AroundLabelRow | None:
    """Return what is around an object ``label`` in ``view``, at most ``most`` of each; ``None`` if there is none."""
    return next(iter(view.ask(AROUND_LABEL, label=label, most=most)), None)


def some_videos(view: GraphView, most: int) -> tuple[str, ...]:
    """Return the names of at most ``most`` videos of ``view``, sorted: those that the graph finds first."""
    return tuple(sorted(row.name for row in view.ask(SOME_VIDEOS, most=most)))
