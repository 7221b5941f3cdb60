"""How foods come into states that no video gives to one like them, as ``workings.toml`` says."""

from __future__ import annotations

from collections.abc import Collection, Sequence
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
    rows = (one for one in _rows()[0].get(state, ()) if done or not one.once_done)
    fit = (one for one in rows if facts.is_any(one.of) and not facts.is_any(one.never))
    return next(fit, None)


@dataclass(frozen=True)
class First:
    """What is done first to some foods, which brings them into the states that they ``become``, in this order.

    ``of`` are the kinds, traits and names of such foods, ``never`` those of others. ``asked`` are the states of which
    one has to be asked, if any; ``told`` are words that say that it was done. ``cut``: only what is asked in pieces.
    """

    of: frozenset[str]
    never: frozenset[str]
    asked: frozenset[str]
    told: frozenset[str]
    cut: bool
    become: Sequence[str]


def first_states(facts: Food, asked: str, told: Collection[str], *, cut: bool) -> Sequence[str]:
    """Return the states into which a food of which ``facts`` are known is brought before all else.

    ``asked`` is the state in which it is asked, ``told`` are the words of that and of its name; ``cut``: it is asked in
    pieces.
    """
    for one in _rows()[1]:
        fit = facts.is_any(one.of) and not facts.is_any(one.never) and (cut or not one.cut)
        if fit and (not one.asked or asked in one.asked) and one.told.isdisjoint(told):
            return one.become
    return ()


@cache
def _rows() -> tuple[dict[str, list[Working]], Sequence[First]]:
    """Return by each state how foods come into it, and what is done first to some."""
    tables = shipped("workings")
    found: dict[str, list[Working]] = {}
    for row in tables["workings"]:
        one = Working(
            frozenset(row["of"]), frozenset(row.get("not", ())), row["motion"], tuple(row["like"]), row["tool"],
            row["on"], row.get("whole", False), row.get("once_done", False),
        )  # fmt: skip
        for state in row["state"]:
            found.setdefault(state, []).append(one)
    first = [
        First(
            frozenset(row["of"]), frozenset(row.get("not", ())), frozenset(row.get("asked", ())),
            frozenset(row.get("told", ())), row.get("cut", False), tuple(row["becomes"]),
        )
        for row in tables["first"]
    ]  # fmt: skip
    return found, first
