"""What is baked with something soft on it: that is mixed with what seasons it, and smeared on it before."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food.lists import word_list
from foon_kg.integration.frames import Line, Stage
from foon_kg.integration.places import NATURAL, Join

_MIX = Stage((), "mix", frozenset({"mix"}), ("spoon",), "bowl", "in", "", "", "", (), 0)
_LAID = replace(_MIX, motion="", does=frozenset(), tools=(), vessel="baking tray", relation="on")
_SMEARED = replace(_LAID, motion=min(word_list("is smeared by")), does=frozenset({"coat"}), tools=("knife",))
_BAKED = replace(_LAID, motion="bake", does=frozenset({"dry", "heat"}), appliance="oven", source="heat")


def smeared_and_baked(line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return how slices are made that are baked with something smeared on them, where that is what the dish is."""
    base = [join for join in joins if join.want.facts.is_a(*word_list("carries what is stacked"))]
    soft = [join for join in joins if _is_soft(join)]
    bakes = any(stage.appliance == "oven" and "heat" in stage.does for stage in line.all_stages())
    soaks = any(join.want.facts.is_a(*word_list("soaks slices")) for join in joins)
    if len(base) != 1 or not soft or not bakes or soaks:
        return line, tuple(joins)
    mix, laid, baked = replace(_MIX), replace(_LAID), replace(_BAKED)
    smeared = replace(_SMEARED, adds=(Line((mix,)),))
    seasons = [join for join in joins if join.want.facts.is_a(*word_list("is mixed with what is smeared"))]
    found = []
    for join in joins:
        stage = laid if join in base else mix if join in soft or join in seasons else baked
        after = {id(laid): (smeared, baked), id(mix): (smeared, baked), id(baked): ()}[id(stage)]
        spot = replace(join.spot, stage=stage, after=after, side=stage is mix)
        found.append(Join(join.want, spot, min(join.fit, NATURAL)))
    return Line((laid, smeared, baked)), tuple(found)


def _is_soft(join: Join) -> bool:
    facts = join.want.facts
    return facts.is_a("creamy", "fat") and not facts.is_a(*word_list("is not smeared"))
