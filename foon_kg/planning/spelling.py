"""Words of foods and states that are misspelled, as they are spelled.

:mod:`foon_kg.planning.recipes` says by it what somebody may have meant; nothing is planned otherwise for it.
"""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from functools import cache, lru_cache

from foon_kg.food import singular, tables

_CLOSE = 0.74
"""How alike two words are, by the letters that they share in order, that may be the same word misspelled."""


@cache
def _spelling() -> Mapping[str, str]:
    """Return every word of the tables of foods and of states, in their order, with its letters in theirs."""
    known = tables()
    found = sorted({word for name in (*known.foods.kind_of, *known.states) for word in name.split()})
    return {word: "".join(sorted(word)) for word in found}


@lru_cache(maxsize=1 << 12)
def _spelled_word(word: str) -> str | None:
    """Return the known word that ``word`` is, or is likest to; ``None`` where none is like it."""
    known = _spelling()
    if word in known or singular(word) in known:
        return word
    letters = "".join(sorted(word))
    swapped = next((one for one, own in known.items() if own == letters), None)
    return swapped or next(iter(difflib.get_close_matches(word, known, n=1, cutoff=_CLOSE)), None)


def spelled(text: str) -> str | None:
    """Return ``text`` with its words as they are spelled; ``None`` where one of them is like none that is known."""
    found = [_spelled_word(word.lower()) for word in text.replace(",", " ").split()]
    return " ".join(filter(None, found)) if all(found) else None
