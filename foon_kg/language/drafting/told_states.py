"""The state that a verb names itself: what is coated becomes so, and what is shaken."""

from __future__ import annotations

from functools import cache

from foon_kg.food import tables
from foon_kg.similarity.states import state_in


@cache
def done(verb: str) -> str | None:
    """Return the state that a verb names itself (coat, coated), ``None`` where nobody says so of foods."""
    word = verb.split(" ", maxsplit=1)[0]
    forms = (f"{word}ed", f"{word}d", f"{word}{word[-1:]}ed", f"{word}n", f"{word}en", word)
    given = tables().motion(word).gives
    return next((state for form in forms if (state := state_in(form) or (form if form in given else None))), None)
