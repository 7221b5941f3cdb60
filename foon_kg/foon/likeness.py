"""The known foods that can stand for others: by the vector index of a graph, or compared with all that a FOON knows."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from foon_kg.model.knowledge import Neighbour

if TYPE_CHECKING:  # a question imports what it needs
    from foon_kg.similarity import Similarity
    from foon_kg.store.graph import GraphView
    from foon_kg.store.graph.connection import Connection
    from foon_kg.store.snapshot import Snapshot

_MOST_LIKE = 200
"""Of a very large FOON so many foods are looked at for a role that are like the asked one."""

Nearest = Sequence[tuple[Neighbour, ...]]


def by_points(connection: Connection, foods: Sequence[str], limit: int) -> Nearest | None:
    """Return at most ``limit`` foods nearest to each of ``foods``, by the vector index of the graph at ``connection``.

    ``None`` where it cannot tell. Nothing of planning is imported.
    """
    from foon_kg.plans.kitchen import Kitchen
    from foon_kg.store.graph.equivalents import equivalents

    return equivalents(connection, Kitchen.default(), foods, limit)


def in_view(
    view: Snapshot | GraphView, foods: Sequence[str], limit: int, role: str | None, vectors: str | None, *, whole: bool
) -> Nearest:
    """Return at most ``limit`` foods of those in ``view`` that are nearest to each of ``foods``.

    With a ``role``, those that play it; with the name of ``vectors``, by their cosine; else as the foods are alike.
    Unless its ``whole`` vocabulary may be read, those that play a role are sought among the foods that the table of
    foods names and those that are most like ``foods``.
    """
    if role is not None:
        from foon_kg.similarity.in_role import in_role

        labels = view.vocabulary().labels if whole else _likely_in_role(view, foods, role)
        return tuple(in_role(name, labels, role, limit) for name in foods)
    if vectors is None:
        return view.equivalents(foods, limit=limit)
    from foon_kg.similarity.confidences import nearest_of_each

    return nearest_of_each(named_similarity(vectors), foods, view.vocabulary().labels, limit)


def _likely_in_role(view: Snapshot | GraphView, foods: Sequence[str], role: str) -> list[str]:
    from foon_kg.food import tables
    from foon_kg.similarity.roles import roles_of

    listed = {name for name in tables().foods.kind_of if role in roles_of(name)}
    like = {near.name for found in view.equivalents(foods, limit=_MOST_LIKE) for near in found}
    return view.words_named({*listed, *like, *foods}).labels


def named_similarity(vectors: str | None) -> Similarity:
    """Return the similarity of foods: by the vectors of a plug-in or spaCy pipeline, or foon-kg's own.

    Raises :class:`~foon_kg.model.errors.UsageError` where neither has this name.
    """
    from foon_kg.similarity import food_similarity, plugged_similarity, spacy_similarity

    if vectors is None:
        return food_similarity()
    return plugged_similarity(vectors) or spacy_similarity(vectors)
