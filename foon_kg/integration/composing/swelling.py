"""Where what is sold dry and swells is cooked: in what the dish is made of, or in a bath that is poured off."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from foon_kg.food.lists import word_list
from foon_kg.integration.joining.spots import Join


def is_soaked_up(joins: Sequence[Join], told: Sequence[str]) -> bool:
    """Whether what swells in a dish soaks up what that is made of, so that nothing is boiled apart and drained.

    That is so where a title (``told`` are its words) says that all is made in one vessel, and with what is so small
    that it needs no more than what it is asked with. A liquid that is bound to a sauce is none to cook in.
    """
    facts = [join.want.facts for join in joins]
    dry = [join.want for join in joins if join.want.facts.is_a(*word_list("swells"))]
    raw = [want.facts for want in dry if "boil" in want.facts.owes and not want.cooked]
    bound = any(one.is_a(*word_list("binds a mass or a sauce")) for one in facts)
    if not raw or bound or any("dry" in stage.does for join in joins for stage in (join.spot.stage, *join.spot.after)):
        return False
    named = {*told, *map(" ".join, itertools.pairwise(told))}
    in_one = not word_list("says that all is in one vessel").isdisjoint(named)
    large = [one for one in raw if one.is_a(*word_list("is boiled by itself"))]
    small = bool(large) and all(one.is_a(*word_list("soaks up its liquid")) for one in large)
    liquids = word_list("swells what is dry" if in_one else "swells what is small")
    return (in_one or small) and any(one.is_of(*liquids) for one in facts)
