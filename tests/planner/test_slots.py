"""Where a food that the reference does not have joins: at what kind of unit, by what the FOON does with its motions."""

from __future__ import annotations

from kitchen_stories import subgraph
from planner.dishes import KITCHEN, SETTINGS

from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.planner import plan
from foon_kg.snapshot import Snapshot

POUR = "bowl(empty); bottle{oil}; oil(liquid)@bottle; salt(granulated) > pour > bowl{oil,salt}; oil(liquid)@bowl"
LAY = "bowl{oil,salt}; oil(liquid)@bowl; plate; egg(whole) > place > plate{egg,oil,salt}; oil(liquid)@plate"
MIX = "plate{egg,oil,salt}; oil(liquid)@plate; fork > swirl > plate{salad}; salad(mixed){egg,oil,salt}@plate"
SALAD = (POUR, LAY, MIX)
LAY_ALONE = tuple(f"{food}(whole); cup > place > cup{{{food}}}; {food}(whole)@cup" for food in ("fig", "pea", "nut"))


def joined(*others):
    """The motion of the unit at which a food joins that is like no food of the salad."""
    videos = [subgraph("salad", "salad", *SALAD), *others]
    foods = (("oil", "liquid"), ("salt", "granulated"), ("egg", "whole"), ("kohlrabi", "raw"))
    recipe = Recipe("salad", tuple(RequiredIngredient(*food) for food in foods))
    result = plan(Snapshot.of(videos, KITCHEN), recipe, SETTINGS)
    return next(unit.motion_node for unit in result.units if any(node.label == "kohlrabi" for node in unit.input_nodes))


def test_of_units_that_are_as_good_a_food_joins_at_the_latest():
    assert joined() == "place"


def test_a_food_joins_where_the_motion_mostly_takes_several_foods_before_a_later_one_that_mostly_takes_one():
    assert joined(subgraph("laid", "vegetables", *LAY_ALONE)) == "pour"
