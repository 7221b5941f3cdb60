"""What is folded over: what fills it is fried first, beaten eggs set over it unstirred, and all of it is folded."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food.lists import says, word_list
from foon_kg.integration.joining.spots import NATURAL, Join
from foon_kg.integration.teaching.frames import Line, Phase, Stage

_BEAT = Stage((), "whisk", frozenset({"mix", "whip"}), ("whisk",), "mixing bowl", "in", "", "", "", (), 0)
_PAN = replace(_BEAT, motion="cook and stir", does=frozenset({"heat", "mix"}), tools=("spatula",))
_PAN = replace(_PAN, vessel="frying pan", appliance="stove", source="heat")
_SET = replace(_PAN, motion="cook", does=frozenset({"heat"}), tools=())
_MELT = Phase((), "cook", _SET.does, (), "frying pan", "in", "stove", "heat", "", (), 0)
"""What melts on set eggs comes in its own turn: no other food of the pan is put in an order with it."""

_FOLD = replace(_SET, motion="fold", does=frozenset({"shape"}), tools=("turner",), appliance="", source="")
_TOP = replace(_BEAT, motion="", does=frozenset(), tools=(), vessel="plate", relation="on")


def is_folded(joins: Sequence[Join], named: Collection[str]) -> bool:
    """Return whether a dish ``named`` with these words, whose foods have these ``joins``, is folded over.

    One that is baked, or thick with roots, is not.
    """
    if not says(named, "is folded") or says(named, "is not folded"):
        return False
    facts = [join.want.facts for join in joins]
    sets = any(one.is_any(word_list("sets in a pan")) for one in facts)
    return sets and not any(one.is_any(word_list("is too thick to be folded")) for one in facts)


def folded(joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that beats the eggs, fries what fills them, lets them set over it, and folds all of it.

    The foods of ``joins`` are at its stages then.
    """
    beat, pan, melt, fold, top = (replace(one) for one in (_BEAT, _PAN, _MELT, _FOLD, _TOP))
    setting = replace(_SET, adds=(Line((beat,)),))
    stages = (pan, setting, melt, fold, top)
    found = []
    flesh = any(join.want.facts.is_any(word_list("is flesh")) and "cook" in join.want.facts.owes for join in joins)
    for join in joins:
        thin = not flesh and join.want.facts.is_of(*word_list("runs or melts into eggs"))
        stage = beat if thin else _stage_of(join, beat, pan, melt, top)
        after = stages[1:] if stage is beat else stages[stages.index(stage) + 1 :]
        spot = replace(join.spot, stage=stage, after=after, side=stage is beat)
        found.append(replace(join, spot=spot, fit=min(join.fit, NATURAL)))
    return Line(stages), tuple(found)


def _stage_of(join: Join, beat: Stage, pan: Stage, melt: Stage, top: Stage) -> Stage:
    facts = join.want.facts
    if facts.is_a("fat"):
        return pan
    if facts.is_any(word_list("is beaten with eggs")):
        return beat
    if facts.is_any(word_list("is laid on set eggs")):
        return melt
    return top if facts.is_a("topping", "herb") else pan
