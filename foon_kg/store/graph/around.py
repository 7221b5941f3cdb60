"""Puts words around parts of a question."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from foon_kg.store.graph.question_words import Token


@dataclass(frozen=True)
class Around:
    """What is put around the pieces from ``first`` to ``last``."""

    first: int
    begins: str
    last: int
    ends: str


def put_around(pieces: Sequence[Token], arounds: Iterable[Around]) -> str:
    """Return the text of a question with what is put around its pieces; none begins in another and ends outside it."""
    before: dict[int, str] = {}
    after: dict[int, str] = {}
    for one in sorted(arounds, key=lambda one: one.last - one.first):  # inner ones first: the others stand outside
        before[one.first] = one.begins + before.get(one.first, "")
        after[one.last] = after.get(one.last, "") + one.ends
    return "".join(f"{before.get(place, '')}{one.text}{after.get(place, '')}" for place, one in enumerate(pieces))
