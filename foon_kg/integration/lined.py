"""What is baked in something that holds it: bought dough or mash lines or covers it, or a hollow food is stuffed."""

from __future__ import annotations

import itertools
from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import singular, words
from foon_kg.food.lists import word_list
from foon_kg.integration.frames import Line, Slot, Stage
from foon_kg.integration.places import NATURAL, Join
from foon_kg.integration.preparation import Want

_MIX = Stage((), "mix", frozenset({"mix"}), ("spoon",), "mixing bowl", "in", "", "", "mixture", (), 0)
_PAN = replace(_MIX, motion="cook and stir", does=frozenset({"heat", "mix"}), vessel="cooking pan", appliance="stove")
_PAN = replace(_PAN, source="heat")
_LAID = replace(_MIX, motion="", does=frozenset(), tools=(), vessel="baking dish", label="")
_BAKED = replace(_LAID, motion="bake", does=frozenset({"dry", "heat"}), appliance="oven", source="heat")
_COOLED = replace(_LAID, motion="cool", does=frozenset({"wait"}))
_HOLLOW = "halved"


def lined(line: Line, joins: Sequence[Join], told: Collection[str]) -> tuple[Line, tuple[Join, ...]]:
    """Return how a dish is made that is called so that one of its foods holds the rest.

    ``told`` are the words of type and title. Nothing changes where no such food is there, or nothing to come into it.
    """
    stuffed = not word_list("is called stuffed").isdisjoint(told)
    holders = [join for join in joins if _holds(join, told, stuffed=stuffed)]
    inside = [join for join in joins if join not in holders]
    if len(holders) != 1 or not inside:
        return line, tuple(joins)
    raw = any(_is_raw(join) for join in inside)
    mash = any(_is_mash(join) for join in holders)
    stewed = _is_stewed(inside) or ((stuffed or mash) and raw)
    mix, laid, baked = replace(_PAN if stewed else _MIX), replace(_LAID), replace(_BAKED)
    brought = replace(_LAID, adds=(Line((mix,)),))
    twofold = _is_twofold(holders[0])
    first = (brought, laid) if stewed and not stuffed and not twofold else (laid, brought)
    bound = any(join.want.facts.is_a(*word_list("binds what is inside")) for join in inside)
    bound = bound and (not twofold or any(join.want.facts.is_a(*word_list("sets with eggs")) for join in inside))
    cover = replace(_LAID)
    stages: tuple[Stage, ...] = (*first, cover, baked) if twofold and not bound else (*first, baked)
    tops = [join for join in inside if join.want.facts.is_a(*word_list("is put on what is filled"))]
    top = replace(_LAID)
    if tops and len(tops) < len(inside):
        stages = (*stages, replace(_COOLED), top)
    found = []
    if twofold and not bound:
        number = max(join.want.number for join in joins) + 1
        second = replace(holders[0].want, number=number)
        spot = replace(holders[0].spot, stage=cover, after=(baked,), side=False)
        found.append(Join(second, spot, NATURAL))
    for join in joins:
        is_a = join.want.facts.is_a
        melts = is_a(*word_list("melts on top")) and not is_a("creamy") and len(inside) > 1
        stage = laid if join in holders else baked if melts and not bound else mix
        stage = top if join in tops and top in stages else stage
        stage = baked if twofold and not bound and is_a("egg") else stage  # it makes the crust shine
        place = next(place for place, one in enumerate((mix, *stages)) if one is stage)
        spot = replace(join.spot, stage=stage, after=stages if stage is mix else stages[place:], side=stage is mix)
        apart = _is_raw(join) and not stewed
        fried = Slot(join.want.label, join.want.facts.kind, cooked=("cook",)) if apart else None
        want = _hollow(join.want) if stuffed and join in holders else join.want
        found.append(Join(want, spot, min(join.fit, NATURAL), fried))
    return Line(stages), tuple(found)


def topped(line: Line, joins: Sequence[Join], told: Sequence[str]) -> tuple[Line, tuple[Join, ...]]:
    """Return how a food is baked in one piece and cut open, and the rest comes on it; ``told`` are the title's words.

    Nothing changes where the title does not call it baked, or where it is asked cut.
    """
    pairs = {f"{one} {other}" for one, other in itertools.pairwise(told)}
    whole = [join for join in joins if f"baked {join.want.facts.name.split()[-1]}" in pairs]
    whole = [join for join in whole if join.want.facts.is_a(*word_list("is baked whole")) and not join.want.make]
    if len(whole) != 1 or not word_list("is called stuffed").isdisjoint(told):
        return line, tuple(joins)
    baked, top = replace(_BAKED, vessel="baking tray"), replace(_LAID, vessel="plate", relation="on")
    cut = replace(_LAID, motion="cut", does=frozenset({"cut"}), tools=("knife",), vessel="plate", relation="on")
    brushed = [join for join in joins if join.want.facts.is_a("liquid") and join.want.facts.is_a("fat")]
    stages = (baked, cut, top)
    twice = not word_list("is baked twice").isdisjoint(told)
    if twice:
        cut, top = replace(_MIX, motion="mash", does=frozenset({"mash", "mix"}), tools=("masher",)), replace(_BAKED)
        stages = (baked, cut, top)
    elif any(_runs(join) for join in joins if join not in brushed):
        return line, tuple(joins)
    found = []
    for join in joins:
        stage = baked if join in whole or join in brushed else top
        if twice and stage is top and not join.want.facts.is_a(*word_list("lies on what is baked twice")):
            stage = cut
        place = next(place for place, one in enumerate(stages) if one is stage)
        spot = replace(join.spot, stage=stage, after=stages[place + 1 :], side=False)
        want = _in_one_piece(join.want) if join in whole else join.want
        apart = _is_raw(join) and not join.want.cooked
        fried = Slot(join.want.label, join.want.facts.kind, cooked=("cook",)) if apart else None
        found.append(Join(want, spot, min(join.fit, NATURAL), fried, on_top=stage is top and not twice))
    return Line(stages), tuple(found)


def _holds(join: Join, told: Collection[str], *, stuffed: bool) -> bool:
    """Whether a food holds the rest of a dish that is called so: in one piece, and named by the title if stuffed."""
    facts = join.want.facts
    if not stuffed:
        named = not word_list("is held by dough").isdisjoint(told)
        return named and (facts.is_a(*word_list("lines a dish")) or _is_mash(join))
    return not join.want.make and facts.is_a(*word_list("is stuffed")) and facts.name.split()[-1] in told


def _is_twofold(holder: Join) -> bool:
    """Whether dough is asked of which one piece lines the dish and another one covers it: it is asked in the plural."""
    want = holder.want
    double = not word_list("is asked twofold").isdisjoint(words(want.label))
    return want.facts.is_a("dough") and (double or want.label != singular(want.label))


def _is_mash(join: Join) -> bool:
    """Whether a food is asked mashed: it covers what is cooked before."""
    covers = word_list("covers a dish when it is mashed")
    mashed = {join.want.make, join.want.then} & word_list("only what is soft is so")
    return join.want.facts.is_a(*covers) and (bool(mashed) or "made" in join.want.facts.traits)


def _is_raw(join: Join) -> bool:
    return join.want.facts.is_a(*word_list("is flesh")) and not join.want.facts.is_a("ready")


def _runs(join: Join) -> bool:
    return join.want.facts.is_a("liquid", "egg")


def _in_one_piece(want: Want) -> Want:
    """Return a food that is cooked whole and unpeeled."""
    owes = {name: level for name, level in want.facts.owes.items() if name not in {"cut", "peel"}}
    return replace(want, facts=replace(want.facts, owes=owes))


def _hollow(want: Want) -> Want:
    """Return a food in the form in which it is stuffed: in halves, unless it is small."""
    if not want.facts.is_a(*word_list("is stuffed whole")):
        return replace(want, make=_HOLLOW)
    owes = {name: level for name, level in want.facts.owes.items() if name != "cut"}
    return replace(want, facts=replace(want.facts, owes=owes))


def _is_stewed(inside: Sequence[Join]) -> bool:
    """Whether what is inside is cooked in a liquid, and only covered then."""
    facts = [join.want.facts for join in inside]
    thin = any(one.is_a("liquid") and one.is_of(*word_list("is a bath")) for one in facts)
    bound = any(one.is_a(*word_list("binds what is inside")) for one in facts)
    return thin and not bound and any(one.is_a("fat") for one in facts)
