"""Appliances that are on in a tree: turned on and off by units of their own, also where annotators left that out."""

from __future__ import annotations

from kitchen_stories import CHOP_ONION, subgraph, unit
from planner.dishes import KITCHEN, SETTINGS
from planner.judged import fatal
from planner.test_opening import SOUP, STOVE

from foon_kg.model import Annotation, Recipe, RequiredIngredient, Subgraph
from foon_kg.planning.planner import plan
from foon_kg.store.snapshot import Snapshot

NEVER_ON = tuple(line for line in SOUP if "turn on" not in line)


def planned(dish, *others):
    known = Subgraph("known", tuple(Annotation(unit(line)) for line in others))
    snapshot = Snapshot.of([subgraph("soup", "soup", *CHOP_ONION, *dish), known], KITCHEN)
    wanted = (RequiredIngredient("onion", "chopped"), RequiredIngredient("water", "liquid"))
    result = plan(snapshot, Recipe("soup", wanted), SETTINGS)
    assert fatal(result, snapshot) == []
    assert not any(KITCHEN.is_running(node) for node in result.kitchen)
    return [planned.motion for planned in result.units]


def test_what_another_video_turns_on_and_off_is_turned_on_and_off():
    motions = planned(NEVER_ON, *STOVE)
    assert motions.index("turn on") < motions.index("boil") < motions.index("turn off")


def test_what_a_video_leaves_on_is_turned_off():
    assert planned(SOUP)[-1] == "turn off"


def test_what_nobody_ever_turned_on_is_turned_on_and_said():
    assert "turn on" in planned(NEVER_ON)
