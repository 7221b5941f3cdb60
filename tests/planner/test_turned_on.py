"""Utensils that are hot or on in a tree: made so by units of their own, where FOON has one."""

from __future__ import annotations

import pytest
from kitchen_stories import node, subgraph, unit
from planner.dishes import KITCHEN, SETTINGS

from foon_kg.errors import NoTreeError
from foon_kg.model import Annotation, Recipe, RequiredIngredient, Subgraph
from foon_kg.planner import plan
from foon_kg.snapshot import Snapshot

SOUP = (
    "pot(empty); salt(granulated) > sprinkle > pot{salt}",
    "pot{salt}; stove(on) > boil > pot{soup}; soup(cooked){salt}@pot",
)
SALTED = ("pot(empty); salt(granulated) > sprinkle > pot{salt}", "stove(off) > turn on > stove(on)")


def planned(*others):
    known = Subgraph("known", tuple(Annotation(unit(line)) for line in others))
    snapshot = Snapshot.of([subgraph("soup", "soup", *SOUP), known], KITCHEN)
    return plan(snapshot, Recipe("soup", (RequiredIngredient("salt", "granulated"),)), SETTINGS)


def test_what_nobody_turns_on_is_assumed_to_be_on():
    result = planned()
    assert [assumption.node for assumption in result.assumptions] == [node("stove(on)")]
    assert node("stove(on)") in result.kitchen


def test_what_some_video_turns_on_is_turned_on_before_it_is_needed():
    result = planned(*SALTED)
    assert result.assumptions == ()
    motions = [planned.motion_node for planned in result.units]
    assert motions.index("turn on") < motions.index("boil")


def test_where_it_is_turned_on_only_for_what_nobody_asked_nothing_is_boiled_on_a_stove_that_is_off():
    with pytest.raises(NoTreeError, match="what is off or cold never stands for what is on or hot"):
        planned("pan(empty); onion(whole); stove(off) > place > pan{onion}; onion(hot)@pan; stove(on)")
