"""A stage whose turn it is, and what joins it then."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar

from foon_kg.integration.bench import Vessel
from foon_kg.integration.joining.course import MIXES
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.teaching.frames import Line, Stage
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
        """Whether it is heated again by more than being browned at last (``step`` -1): until then it is half done."""
        return any(one.heats for one in self.later if one.step >= 0)


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
