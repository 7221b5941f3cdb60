"""Where what is sold dry and swells is cooked: in what the dish is made of, or in a bath that is poured off."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food import Food
from foon_kg.food.lists import says, word_list
from foon_kg.integration.joining.spots import Join, any_is


def is_soaked_up(joins: Sequence[Join], title_words: Sequence[str]) -> bool:
    """Return whether what swells in a dish soaks up what that is made of, so that nothing is boiled apart and drained.

    That is so where a title (``title_words`` are its words) says that all is made in one vessel, and with what is so
    small that it needs no more than what it is asked with. A liquid of ``joins`` that is bound to a sauce is none to
    cook in.
    """
    raw = [join.want.facts for join in joins if _is_raw_and_swells(join)]
    if not raw or any_is(joins, *word_list("binds a mass or a sauce")) or _is_baked(joins):
        return False
    in_one = _is_in_one_vessel(title_words)
    liquids = word_list("swells what is dry" if in_one else "swells what is small")
    return (in_one or _are_small(raw)) and any(join.want.facts.is_of(*liquids) for join in joins)


def are_only_boiled(joins: Sequence[Join]) -> bool:
    """Return whether ``joins`` are boiled as they are bought, with salt at most: nothing of them is kneaded before."""
    boiled = word_list("is boiled by itself") | word_list("is in what is boiled by itself")
    return bool(joins) and all(join.want.facts.is_any(boiled) for join in joins)


def _is_raw_and_swells(join: Join) -> bool:
    want = join.want
    return want.facts.is_any(word_list("swells")) and "boil" in want.facts.owes and not want.cooked


def _is_in_one_vessel(title_words: Sequence[str]) -> bool:
    """Whether the words of a title, by themselves or two together, say that all is made in one vessel."""
    named = {*title_words, *map(" ".join, itertools.pairwise(title_words))}
    return says(named, "says that all is in one vessel")


def _are_small(foods: Sequence[Food]) -> bool:
    """Whether of what swells all that is boiled by itself elsewhere is small, and needs little to swell in."""
    large = [one for one in foods if one.is_any(word_list("is boiled by itself"))]
    return bool(large) and all(one.is_any(word_list("soaks up its liquid")) for one in large)


def is_eaten_with_its_bath(joins: Sequence[Join], title: Sequence[str], dish_type: str) -> bool:
    """Return whether what is boiled by itself for other dishes is eaten with the liquid that it is asked with.

    Nothing in the ``joins`` of such a dish is bound, creamy or baked; a title, if there is one, has to say it.
    """
    said = not title or says(title, "is eaten with its bath")
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
    return join.want.facts.is_any(word_list("is boiled by itself")) and not left


def _is_baked(joins: Sequence[Join]) -> bool:
    return any("dry" in stage.does for join in joins for stage in (join.spot.stage, *join.spot.after))
