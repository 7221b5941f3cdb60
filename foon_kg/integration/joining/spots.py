"""Where foods join: the stages of a frame as spots, and the join of one asked food at one of them.

Stages of different dishes are compared by their :class:`StageType`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import NamedTuple

from foon_kg.food.lists import word_list
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.frames import Line, Slot, Stage
from foon_kg.model.values import made_often


class StageType(NamedTuple):
    """By what stages of different dishes are compared.

    ``work`` is what is done to the whole (``blend``, ``knead``, ``mix``, ``heat``, ``bake``, ``boil``, ``shape``,
    ``rest``, ``top``), ``heated`` when it is heated (``now``, ``later``, ``before``, ``never``); ``joins``: its line
    joins another one, and is not the dish's own.
    """

    work: str
    heated: str
    joins: bool


NATURAL = 0.5
"""A slot is natural for a food that its own can stand for with at least this confidence."""

UNNATURAL = NATURAL - 0.01
"""How well a food fits at most where it has no slot: less than in any natural one, so that joins can be compared."""

IN_PLACE = 0.95
"""How well a food fits where a dish makes such a thing itself."""

# The first that holds is what a stage is told by: to bake is to heat with dry heat, so it comes before that.
_WORKS = (
    ("blend", {"blend"}), ("knead", {"knead"}), ("bake", {"dry"}), ("boil", {"liquid"}), ("heat", {"heat", "warm"}),
    ("shape", {"shape"}), ("mix", {"mix", "whip", "mash"}), ("rest", {"wait"}),
)  # fmt: skip


@made_often(eq=False)
class Spot:
    """One stage of a frame with what comes after it (``after``, on its line and on those that this one joins).

    ``side``: its line joins another one. ``path`` leads to it: the place of a stage, the number of what joins there,
    the place of a stage in that, and so on. Two spots are the same only by identity, as stages are.
    """

    path: tuple[int, ...]
    stage: Stage
    stage_type: StageType
    side: bool
    after: tuple[Stage, ...]

    @cached_property
    def heats_later(self) -> bool:
        """Whether the whole is heated here or later."""
        return self.heats > 0

    @cached_property
    def heats(self) -> int:
        """How often the whole is heated, here and later."""
        return sum("heat" in stage.does for stage in (self.stage, *self.after))

    @cached_property
    def kinds(self) -> tuple[str, ...]:
        """The kinds of the foods that join here."""
        return tuple(slot.kind for slot in self.stage.slots)


def spots_of(
    line: Line, *, side: bool = False, after: tuple[Stage, ...] = (), path: tuple[int, ...] = ()
) -> Iterator[Spot]:
    """Yield every stage of a line and of those that join it, in the order of execution.

    ``side``: the line joins another one, whose stages ``after`` come later; ``path`` are the places of the lines down
    to it.
    """
    for place, stage in enumerate(line.stages):
        later = (*line.stages[place + 1 :], *after)
        for number, add in enumerate(stage.adds):
            if isinstance(add, Line):
                yield from spots_of(add, side=True, after=(stage, *later), path=(*path, place, number))
        before = any("heat" in one.does for one in line.stages[:place])
        yield Spot((*path, place), stage, _stage_type(stage, later, before=before, side=side), side, later)


def _stage_type(stage: Stage, later: Sequence[Stage], *, before: bool, side: bool) -> StageType:
    work = next((name for name, does in _WORKS if not stage.does.isdisjoint(does)), "top")
    if "heat" in stage.does:
        when = "now"
    elif any("heat" in one.does for one in later):
        when = "later"
    else:
        when = "before" if before else "never"
    return StageType(work, when, side)


@made_often()
class Join:
    """Where one asked food joins, how well that fits (0 to 1), and the slot that it takes, if one is natural.

    ``layer`` is its place among others that are laid on dough: from below to above, below 0 under all
    else in its tin. ``on_top``: it only lies on the dish.
    """

    want: Want
    spot: Spot
    fit: float
    slot: Slot | None = None
    layer: int = 0
    on_top: bool = False


def any_is(joins: Iterable[Join], *kinds: str) -> bool:
    """Return whether one of the foods of ``joins`` is of one of ``kinds``, has such a trait, or is called so."""
    return any(join.want.facts.is_any(kinds) for join in joins)


def only_carries(stage: Stage) -> bool:
    """Return whether a stage brings the dish to where it is served, or only adds to it."""
    return all(stage.does.isdisjoint(does) for _, does in _WORKS)


def is_ladled(stage: Stage) -> bool:
    """Return whether a dish is in a pot after a stage, out of which nobody eats."""
    return stage.vessel in word_list("is ladled out of")
