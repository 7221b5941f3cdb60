"""What is asked of a food of which several things are said: "boiled and grated", "melted and cooled"."""

from __future__ import annotations

import re
from collections.abc import Sequence

from foon_kg.food.lists import says, word_list
from foon_kg.food.tables import Tables

_JOINT = ", "
_TWO = r",|\band\b"


def asked_state(states: Sequence[str], known: Tables) -> str:
    """Return the state that is asked by all ``states``, told in the order in which they come about; ``""`` of none.

    That is the last that stays (of "melted, cooled" melted). Where heat made it or a can held it before that, both are
    asked; so are a cut and the cooking after it, and smoked or cured before a cut. What heat makes and what is cut is
    read from the tables ``known``.
    """
    staying = [state for state in states if state not in word_list("passes")] or list(states[-1:])
    if not staying:
        return ""
    last = staying[-1]
    if last in word_list("is in a can") and states[-1] in word_list("is poured off"):
        return states[-1]
    *_, before = "", *(state for state in staying[:-1] if _matters_for(last, state, known))
    return _JOINT.join(filter(None, (before, last)))


def in_turn(state: str) -> tuple[str, ...]:
    """Return the states that an asked state names, in the order in which they come about.

    >>> in_turn("boiled, grated"), in_turn("peeled and deveined"), in_turn("juice and zest")
    (('boiled', 'grated'), ('peeled', 'deveined'), ('juice and zest',))
    """
    parts = _parts(_TWO, state)
    of_two = says(parts, "is off the outside") and len(parts) > 1  # the zest, and the juice of what is left
    return _parts(_JOINT.strip(), state) if of_two else parts


def _parts(between: str, state: str) -> tuple[str, ...]:
    return tuple(part for part in (part.strip() for part in re.split(between, state)) if part)


def _matters_for(last: str, state: str, known: Tables) -> bool:
    """Whether what was done before is asked beside the last state, which says nothing of it."""
    if _is_of_heat(last, known):
        wet = last in word_list("is so by boiling") | word_list("begins cooked")  # toasted nuts are sold cut
        return wet and bool(known.state(state).fine)
    return _is_of_heat(state, known) or state in word_list("is in a can") | word_list("is bought so before it is cut")


def _is_of_heat(state: str, known: Tables) -> bool:
    row = known.state(state)
    return row.needs_heat and "cook" in row.earns
