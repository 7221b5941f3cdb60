"""Where what is sold dry and swells is cooked: in what the dish is made of, or in a bath that is poured off."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food.lists import word_list
from foon_kg.integration.joining.spots import Join, any_is


def is_soaked_up(joins: Sequence[Join], told: Sequence[str]) -> bool:
    """Whether what swells in a dish soaks up what that is made of, so that nothing is boiled apart and drained.

    That is so where a title (``told`` are its words) says that all is made in one vessel, and with what is so small
    that it needs no more than what it is asked with. A liquid that is bound to a sauce is none to cook in.
    """
    facts = [join.want.facts for join in joins]
    dry = [join.want for join in joins if join.want.facts.is_a(*word_list("swells"))]
    raw = [want.facts for want in dry if "boil" in want.facts.owes and not want.cooked]
    bound = any(one.is_a(*word_list("binds a mass or a sauce")) for one in facts)
    if not raw or bound or _is_baked(joins):
        return False
    named = {*told, *map(" ".join, itertools.pairwise(told))}
    in_one = not word_list("says that all is in one vessel").isdisjoint(named)
    large = [one for one in raw if one.is_a(*word_list("is boiled by itself"))]
    small = bool(large) and all(one.is_a(*word_list("soaks up its liquid")) for one in large)
    liquids = word_list("swells what is dry" if in_one else "swells what is small")
    return (in_one or small) and any(one.is_of(*liquids) for one in facts)


def is_eaten_with_its_bath(joins: Sequence[Join], title: Sequence[str], dish_type: str) -> bool:
    """Whether what is boiled by itself for other dishes is eaten with the liquid that it is asked with.

    Nothing of such a dish is bound, creamy or baked; a title, if there is one, has to say it.
    """
    said = not title or not word_list("is eaten with its bath").isdisjoint(title)
    if not said or dish_type not in word_list("may be eaten with its bath"):
        return False
    wet = any(join.want.facts.is_of(*word_list("swells what is small")) for join in joins)
    bound = any_is(joins, *word_list("makes a sauce of a bath"))
    return any(map(_boils_there, joins)) and wet and not bound and not _is_baked(joins)


def boiled_there(joins: Sequence[Join]) -> tuple[Join, ...]:
    """Return joins of which none is boiled by itself that is eaten with its bath, though it is asked done."""
    return tuple(
        replace(join, want=replace(join.want, cooked=False, make="")) if _boils_there(join) else join for join in joins
    )


def _boils_there(join: Join) -> bool:
    """Whether a food is boiled by itself in other dishes, and is no leftover."""
    left = join.want.asked in word_list("only what was cooked is so")
    return join.want.facts.is_a(*word_list("is boiled by itself")) and not left


def _is_baked(joins: Sequence[Join]) -> bool:
    return any("dry" in stage.does for join in joins for stage in (join.spot.stage, *join.spot.after))
