"""What is asked of a food of which several things are said: "boiled and grated", "melted and cooled"."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food.lists import word_list
from foon_kg.food.tables import Tables

_JOINT = ", "


def asked_state(states: Sequence[str], known: Tables) -> str:
    """Return the state that is asked by all ``states``, told in the order in which they come about; ``""`` of none.

    That is the last that stays (of "melted, cooled" melted). Where heat made it before that, both are asked.
    """
    thaws = not word_list("is drained of its own water").isdisjoint(states)
    passes = word_list("passes") | (word_list("is drained") if thaws else frozenset())
    staying = [state for state in states if state not in passes] or list(states[-1:])
    last = staying[-1] if staying else ""
    heated = next((state for state in reversed(staying[:-1]) if _is_of_heat(state, known)), None)
    return _JOINT.join(filter(None, (heated, last))) if not _is_of_heat(last, known) else last


def in_turn(state: str) -> tuple[str, ...]:
    """Return the states that an asked state names, in the order in which they come about."""
    return tuple(part for part in (part.strip() for part in state.split(_JOINT.strip())) if part)


def _is_of_heat(state: str, known: Tables) -> bool:
    row = known.state(state)
    return row.needs_heat and "cook" in row.earns
