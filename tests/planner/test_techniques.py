"""A dish whose name asks for a craft that no video of a like dish has is made by the technique that is called so."""

from __future__ import annotations

import pytest
from planner.public_foon import public_snapshot
from planner.told_steps import planned_steps

pytestmark = pytest.mark.shared_data


@pytest.fixture(scope="module")
def steps():
    return planned_steps(public_snapshot())


def motions(told):
    return [motion for _, motion, _ in told]


def first(told, food, motion):
    return next(place for place, (inputs, one, _) in enumerate(told) if food in inputs and one == motion)


def test_a_kugel_is_boiled_noodles_baked_in_eggs(steps):
    told = steps("pudding", "Noodle Kugel", "egg noodles:uncooked", "eggs:uncooked", "sour cream:creamy",
                 "sugar:granulated", "raisins:whole")  # fmt: skip
    assert first(told, "egg noodles", "boil") < first(told, "eggs", "whisk") < first(told, "egg noodles", "fold")
    assert motions(told)[-4:] == ["put inside", "bake", "turn off", "remove"]


def test_pierogi_are_closed_around_mash_and_boiled_in_water_that_boils(steps):
    told = steps("pasta", "Pierogi", "flour:powder", "egg:uncooked", "water:liquid", "potatoes:peeled",
                 "farmer cheese:creamy", "butter:unmelted")  # fmt: skip
    assert first(told, "potatoes", "mash") < motions(told).index("fold and pinch")
    into_the_pot = next(n for n, (inputs, motion, _) in enumerate(told) if {"dough", "pot"} <= inputs)
    assert first(told, "water", "boil") < into_the_pot < motions(told).index("drain")
    assert "bake" not in motions(told)


def test_milk_soaks_a_cake_that_is_baked(steps):
    told = steps("cake", "Tres Leches Cake", "flour:powder", "eggs:uncooked", "sugar:granulated", "milk:liquid",
                 "evaporated milk:liquid", "condensed milk:thick liquid", "whipping cream:creamy")  # fmt: skip
    assert first(told, "evaporated milk", "stir") < motions(told).index("bake")
    assert motions(told).index("bake") < motions(told).index("chill")
    assert not [motion for inputs, motion, _ in told if motion == "stir" and "cake" in inputs]


def test_what_gave_a_drink_its_taste_stays_in_the_strainer(steps):
    told = steps("drinks", "Masala Chai", "water:liquid", "milk:liquid", "black tea leaves:dried", "ginger:sliced",
                 "cinnamon:ground", "sugar:granulated")  # fmt: skip
    (outputs,) = [outputs for _, motion, outputs in told if motion == "pour and strain"]
    assert {node.label for node in outputs if node.container == "strainer"} == {"black tea leaves", "ginger"}
    assert any("cinnamon" in node.ingredients for node in told[-1][2])


def test_chocolate_is_melted_and_cream_whipped_for_a_mousse(steps):
    told = steps("pudding", "Chocolate Mousse", "dark chocolate:chopped", "eggs:uncooked", "heavy cream:creamy",
                 "sugar:granulated")  # fmt: skip
    states = {(node.label, state) for _, _, outputs in told for node in outputs for state in node.states}
    assert {("dark chocolate", "melted"), ("heavy cream", "whipped"), ("pudding", "chilled")} <= states
