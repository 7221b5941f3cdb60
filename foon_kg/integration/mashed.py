"""What is mashed is boiled, mashed and mixed with the rest, and that is all: whatever a like dish goes on with.

Garlic and the like that come into it are fried before.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food.lists import word_list
from foon_kg.integration.frames import Line, Slot, Stage
from foon_kg.integration.places import NATURAL, Join
from foon_kg.integration.preparation import Want

_MIXED = Stage((), "mix", frozenset({"mix"}), (), "mixing bowl", "in", "", "", "", (), 0)


def mashed_only(joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line of one stage, at which all foods of a mashed dish are mixed, and their joins."""
    mixed = replace(_MIXED)
    spots = [replace(join.spot, stage=mixed, after=(), side=False) for join in joins]
    fat = any(join.want.facts.is_a("fat") for join in joins)
    fried = [fat and join.want.facts.is_of(*word_list("is fried for mash")) for join in joins]
    slots = [
        Slot(join.want.label, join.want.facts.kind, cooked=("cook",)) if apart else None
        for join, apart in zip(joins, fried, strict=True)
    ]
    return Line((mixed,)), tuple(
        Join(_mashed(join.want, cooked=slot is not None), spot, min(join.fit, NATURAL), slot)
        for join, spot, slot in zip(joins, spots, slots, strict=True)
    )


def _mashed(want: Want, *, cooked: bool) -> Want:
    """Return a food as it comes into mash; a root is mashed once it is cooked, whether it is asked so or not."""
    want = replace(want, cooked=want.cooked or cooked)
    hard = want.facts.is_a(*word_list("covers a dish when it is mashed")) and "made" not in want.facts.traits
    done = want.then or want.make in word_list("only what is soft is so")
    return replace(want, then=min(word_list("is mashed so"))) if hard and not done else want
