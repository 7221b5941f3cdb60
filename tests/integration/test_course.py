"""What a course says of its stages, be some of them equal: each is known by its identity."""

from __future__ import annotations

from foon_kg.food import tables
from foon_kg.integration.joining.course import Course, Plan
from foon_kg.integration.joining.patterns import COOK, TURN, fresh
from foon_kg.integration.joining.spots import Join, spots_of
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import Line, place_among

FRIED_ON_BOTH_SIDES = Line(fresh(COOK, TURN, COOK))


def joined(label, place):
    want = Want(place + 1, label, "", tables().foods.food(label), (), "")
    return Join(want, list(spots_of(FRIED_ON_BOTH_SIDES))[place], 1.0)


def test_what_is_turned_over_lies_in_a_hot_pan_though_both_sides_are_cooked_alike():
    course = Course(FRIED_ON_BOTH_SIDES, Plan("steak", "steak", [joined("steak", 0), joined("water", 2)]))
    first, _, last = FRIED_ON_BOTH_SIDES.stages
    assert first == last
    assert not course.is_hot(first)
    assert course.is_hot(last)
    assert course.follows_heat(last)


def test_a_stage_is_found_at_its_own_place_and_not_at_that_of_its_like():
    stages = FRIED_ON_BOTH_SIDES.stages
    assert [place_among(stages, stage) for stage in stages] == [0, 1, 2]
    assert place_among(stages, *fresh(COOK)) is None
