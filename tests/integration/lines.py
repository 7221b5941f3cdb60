"""Lines of stages, what joins them, and what was put together in words."""

from __future__ import annotations

from integration.school import SNAPSHOT

from foon_kg.food import tables
from foon_kg.integration.joining.course import Course, Plan
from foon_kg.integration.joining.spots import Join, Spot, StageType
from foon_kg.integration.preparing.understanding import wants_of
from foon_kg.integration.teaching.frames import Line, Stage
from foon_kg.model import RequiredIngredient


def stage(motion, does, *, vessel="bowl", appliance="", adds=()):
    source = "heat" if appliance else ""
    return Stage(tuple(adds), motion, frozenset(does), (), vessel, "in", appliance, source, "", (), 0)


def joins_at(line, number, *foods):
    """Return these foods as they join one stage of a line."""
    asked = [RequiredIngredient(*food.split("/")) if "/" in food else RequiredIngredient(food, "") for food in foods]
    mixed = StageType("mix", "never", joins=False)
    spot = Spot((number,), line.stages[number], mixed, False, line.stages[number + 1 :])
    return tuple(Join(want, spot, 0.5) for want in wants_of(asked, tables(), SNAPSHOT.methods().operators))


def told(line, joins):
    """Return what joins each stage of a line and of those beside it, in the order of execution."""
    course = Course(line, Plan("dish", "dish", joins))

    def walk(part):
        for one in part.stages:
            for add in one.adds:
                if isinstance(add, Line):
                    yield from walk(add)
            yield one.motion, {join.want.label for join in course.at.get(id(one), ())}

    return list(walk(line))
