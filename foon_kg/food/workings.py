"""How foods come into states that no video gives to one like them, as ``workings.toml`` says."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from foon_kg.food.rows import Food
from foon_kg.food.shipped import shipped


@dataclass(frozen=True)
class Working:
    """How some foods come into a state.

    ``motion`` is done with a ``tool`` (``""``: bare hands) to a food that lies ``on`` something; ``like`` are motions
    of the videos that are like it. ``of`` are the kinds, traits and names of such foods, ``never`` those of others.
    ``whole``: the food is still in one piece then. ``once_done``: it was cooked before.
    """

    of: frozenset[str]
    never: frozenset[str]
    motion: str
    like: Sequence[str]
    tool: str
    on: str
    whole: bool
    once_done: bool


def working(state: str, facts: Food, *, done: bool = False) -> Working | None:
    """Return how a food of which ``facts`` are known comes into ``state``; ``None``: the videos have to show it.

    ``done``: it was cooked before.
    """
    rows = (one for one in _workings().get(state, ()) if done or not one.once_done)
    fit = (one for one in rows if facts.is_any(one.of) and not facts.is_any(one.never))
    return next(fit, None)


@cache
def _workings() -> dict[str, list[Working]]:
    found: dict[str, list[Working]] = {}
    for row in shipped("workings")["workings"]:
        one = Working(
            frozenset(row["of"]), frozenset(row.get("not", ())), row["motion"], tuple(row["like"]), row["tool"],
            row["on"], row.get("whole", False), row.get("once_done", False),
        )  # fmt: skip
        for state in row["state"]:
            found.setdefault(state, []).append(one)
    return found
