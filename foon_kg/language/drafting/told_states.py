"""The state that a verb names itself: what is coated becomes so, and what is shaken; and what it cannot be as well."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.model.recent import MOST_WORDS
from foon_kg.similarity.states import state_in


@lru_cache(maxsize=MOST_WORDS)
def done(verb: str) -> str | None:
    """Return the state that a verb names itself (coat, coated), ``None`` where nobody says so of foods."""
    word = verb.replace("-", " ").split(" ", maxsplit=1)[0]
    forms = (f"{word}ed", f"{word}d", f"{word}{word[-1:]}ed", f"{word}n", f"{word}en", word)
    given = tables().motion(word).gives
    return next((state for form in forms if (state := state_in(form) or (form if form in given else None))), None)


def with_state(states: Sequence[str], told: str) -> tuple[str, ...]:
    """Return ``states`` and ``told``, without those that nothing has beside it: what is opened is closed no more."""
    gone = _others(told)
    return (*(state for state in states if state not in gone and state != told), told)


def before_it(told: str) -> str | None:
    """Return the state that a thing must have had before one that is ``told``, closed before it is opened.

    ``None`` for most.
    """
    return next(iter(sorted(_others(told))), None)


@lru_cache(maxsize=MOST_WORDS)
def _others(state: str) -> frozenset[str]:
    pairs = [set(pair.split()) for pair in word_list("is never both")]
    return frozenset().union(*(pair - {state} for pair in pairs if state in pair))
