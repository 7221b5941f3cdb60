"""A stage whose turn it is, and what joins it then; which lines that join are made first, as they keep."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Vessel
from foon_kg.integration.joining.course import MIXES, Course
from foon_kg.integration.joining.spots import Join, any_is
from foon_kg.integration.teaching.frames import Line, Stage, Steamed
from foon_kg.model.values import made_often


@made_often()
class Turn:
    """A stage whose turn it is.

    ``later`` are the stages that come after it, on its own line and on those that this one joins. ``main``: it is on
    the dish's own line.
    """

    stage: Stage
    later: tuple[Stage, ...]
    main: bool = False

    @cached_property
    def heats(self) -> bool:
        """Whether the stage heats or warms."""
        return self.stage.heats

    @cached_property
    def mixes_cold(self) -> bool:
        """Whether the stage mixes, and heats nothing."""
        return not self.heats and not self.stage.does.isdisjoint(MIXES)

    @cached_property
    def heats_later(self) -> bool:
        """Whether any stage that comes later heats or warms."""
        return any(one.heats for one in self.later)

    @cached_property
    def is_heated_on(self) -> bool:
        """Whether it is heated again, by more than an added stage (to brown it at last): until then it is half done."""
        return any(one.heats for one in self.later if not one.is_added)


def turns_of(line: Line, after: Sequence[Stage], *, main: bool) -> list[Turn]:
    """Return the turns of a line, after which the stages in ``after`` come; ``main``: it is the dish's own line."""
    stages = line.stages
    return [Turn(stage, (*stages[place:], *after), main) for place, stage in enumerate(stages, start=1)]


_Thing = TypeVar("_Thing", Join, Vessel)


def without(things: Iterable[_Thing], others: Collection[_Thing]) -> list[_Thing]:
    """Return ``things`` but for ``others``."""
    return [thing for thing in things if thing not in others]


@dataclass
class Incoming:
    """What joins a stage: foods, and vessels in which other lines were made; what came is taken out."""

    joins: list[Join]
    lines: list[Vessel]

    def take(self, is_such: Callable[[Join], bool]) -> list[Join]:
        """Take out the foods of which ``is_such`` is so, and return them."""
        taken = list(filter(is_such, self.joins))
        self.joins = without(self.joins, taken)
        return taken

    def __bool__(self) -> bool:
        """Whether anything joins."""
        return bool(self.joins or self.lines)


def waiting(line: Line, course: Course) -> list[Line]:
    """Return what joins a line, is laid on what comes out of a hot pan and is made before: a sauce, and what is cold.

    ``course`` says what joins where. A sauce does not wait for what is boiled, which stays hot for longer, nor a dough
    that rises for anything.
    """
    adds = [add for stage in line.stages for add in stage.lines]
    boiled = any(_is_boiled(add) and not _keeps(add) for add in adds)
    return [add for add in laid_later(line.stages) if _waits_cold(add, course) or (_keeps(add) and not boiled)]


def laid_later(stages: Sequence[Stage]) -> list[Line]:
    """Return the lines that join ``stages`` and are laid on what came out of a hot pan of its own before."""
    found: list[Line] = []
    lifted = False
    for stage in stages:
        if lifted and not stage.motion:
            found += stage.lines
        lifted = lifted or any(map(is_over_heat, stage.lines))
    return found


def is_over_heat(line: Line) -> bool:
    """Return whether anything heats a line."""
    return any(stage.heats for stage in line.stages)


def after_the_oven(stages: Sequence[Stage]) -> Sequence[Stage]:
    """Return those of ``stages`` that come after the last one that heats, where that is in the oven or in steam."""
    hot = [place for place, stage in enumerate(stages) if stage.heats]
    if not hot:
        return ()
    last = stages[hot[-1]]
    return stages[hot[-1] + 1 :] if "dry" in last.does or isinstance(last, Steamed) else ()


def _is_boiled(line: Line) -> bool:
    hot = [stage for stage in line.stages if stage.heats]
    return bool(hot) and "liquid" in hot[-1].does


def _keeps(line: Line) -> bool:
    """Whether a line makes what loses nothing while it waits: a sauce."""
    return line.stages[-1].label in word_list("keeps while the rest is made")


def _waits_cold(line: Line, course: Course) -> bool:
    """Whether a line is made without heat, and of nothing that makes a dough."""
    makes_dough = any_is(course.joins_of(line.stages), *word_list("makes a dough that does not wait"))
    return not is_over_heat(line) and not makes_dough
