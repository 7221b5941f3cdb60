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
