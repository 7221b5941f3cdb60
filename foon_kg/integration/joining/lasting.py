"""How long foods take in a liquid that simmers: what takes hours comes first, and what is soft in minutes late.

Here a food is put into another phase than it has by what it is; that is in
:mod:`~foon_kg.integration.joining.additions`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food import Food, words
from foon_kg.food.foods import as_in_the_table
from foon_kg.food.lists import says, word_list
from foon_kg.integration.joining.additions import BINDS, FRIED, LAST, LONG, SOON, WET, Addition, is_bath
from foon_kg.integration.joining.spots import Join, any_is


def as_long_as_needed(additions: Sequence[Addition], within: Sequence[Join]) -> list[Addition]:
    """Return the ``additions`` of a vessel with a liquid in it, each in a phase after which it has cooked long enough.

    ``within`` are all foods that come together there, those that were mixed before with others, too.
    """
    slow, found = any(map(_takes_hours, within)), list(additions)
    thin = any(join.want.facts.is_of(*word_list("is thin as water")) for join in within)
    if thin and any(map(_is_cooked_in_it, additions)):
        found = list(map(_what_scalds_last, found))
    if slow or any_is(within, *word_list("is hard before it is cooked")):
        found = list(map(_tender_late, found))
    return [_in_its_hour(one, found) for one in found] if slow else found


def tender_flesh_once(additions: Sequence[Addition], order: Sequence[str]) -> list[Addition]:
    """Return ``additions`` with flesh that is done soon among what is stirred in right after it: it is cooked once.

    ``order`` are the phases of their vessel. A sauce alone, stirred beside it, comes to flesh that is fried.
    """
    later = [one for one in additions if one.phase in order[order.index(SOON) + 1 :]]
    stirred_in = any(one.is_solid and one.facts is not None for one in later)
    if not stirred_in or {one.phase for one in later} != {LAST}:
        return list(additions)
    return [_among_the_last(one) for one in additions]


def _among_the_last(addition: Addition) -> Addition:
    """Return raw flesh that is done soon among what is stirred in last; anything else as it is."""
    raw = addition.phase == SOON and _is_raw_flesh(addition)
    return replace(addition, phase=LAST) if raw else addition


def _is_raw_flesh(addition: Addition) -> bool:
    return _is_flesh(addition) and addition.facts is not None and "cook" in addition.facts.owes


def _is_flesh(addition: Addition) -> bool:
    return addition.facts is not None and addition.facts.is_any(word_list("is flesh"))


def _takes_hours(join: Join) -> bool:
    """Whether an asked food is tender only after hours in a liquid: tough flesh, or pulses that are dry."""
    want, facts = join.want, join.want.facts
    if want.cooked or not says((facts.kind, facts.taken_for), LONG):
        return False
    return _is_said_tough(want.label) or not facts.is_any(word_list("is tender in half an hour"))


def is_braised(join: Join) -> bool:
    """Return whether the food of ``join`` stays tough in a pan, and is cooked in a liquid: a shank, not its slices."""
    want = join.want
    if any("dry" in stage.does for stage in join.spot.after):
        return False  # it has its hours in the oven
    told = words(as_in_the_table(want.label))  # a chop with its bone in is no bone
    tough = _is_said_tough(want.label) or says(told, "is tough until it is braised")
    thin = says((want.asked, want.make), "is thin enough for a pan") or says(told, "is fried as it is cut")
    flesh = want.facts.is_any(word_list("is flesh")) and "cook" in want.facts.owes
    return flesh and tough and not thin and not want.cooked


def _is_said_tough(label: str) -> bool:
    """Whether the name of a food says that it is for a stew."""
    return says(words(label), "is said of what takes hours")


def _is_cooked_in_it(addition: Addition) -> bool:
    """Whether something comes with the liquid, or before it, that has to cook in it."""
    facts = addition.facts
    if facts is None or not addition.is_solid:
        return False
    return _is_flesh(addition) or (addition.phase == WET and not facts.is_a("liquid"))


def _what_scalds_last(addition: Addition) -> Addition:
    """Return what skins over and catches while other things cook in it as what is stirred in last."""
    scalds = addition.facts is not None and addition.facts.kind in word_list("is scalded by long cooking")
    return replace(addition, phase=LAST) if scalds and addition.phase == WET else addition


def _tender_late(addition: Addition) -> Addition:
    """Return what is soft in minutes as what is done soon, though it were fried first."""
    facts = addition.facts
    tender = facts is not None and facts.is_any(word_list("is soft in minutes"))
    return replace(addition, phase=SOON) if tender and addition.phase in {FRIED, WET} else addition


def _in_its_hour(addition: Addition, others: Sequence[Addition]) -> Addition:
    """Return a food as one that cooks with what takes hours, or that comes when this is nearly done."""
    if addition.phase not in {FRIED, BINDS, WET}:
        return addition
    facts = addition.facts
    if facts is not None and facts.is_any(word_list("takes half an hour")) and not _wets_alone(facts, others):
        return replace(addition, phase=WET)
    return replace(addition, phase=LONG) if addition.phase == WET else addition


def _wets_alone(facts: Food, others: Sequence[Addition]) -> bool:
    """Whether a food is the only liquid in which ``others`` could cook."""
    baths = [one for one in others if one.is_water or (one.facts is not None and is_bath(one.facts))]
    return is_bath(facts) and len(baths) == 1
