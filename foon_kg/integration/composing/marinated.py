"""Flesh in its marinade: what a recipe lists for that is stirred, the flesh turned in it and left to stand.

Only then does it join what it is cooked in, where it joined that before.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.food.lists import word_list
from foon_kg.food.techniques import Technique
from foon_kg.integration.composing.assigning import line_told
from foon_kg.integration.composing.techniques import stage_of
from foon_kg.integration.joining.additions import is_raw_flesh
from foon_kg.integration.joining.patterns import put_at, with_line
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.teaching.frames import Line, Stage

_BOWL = "mixing bowl"


def marinated(line: Line, joins: Sequence[Join], technique: Technique | None) -> tuple[Line, tuple[Join, ...]]:
    """Return ``line`` and ``joins`` with flesh that stands in what a recipe says is its marinade.

    Nothing changes where the dish's ``technique`` has a line for it, or where no raw flesh comes to a heat.
    """
    joins = tuple(joins)
    told = [join for join in joins if _is_listed_so(join) and not is_raw_flesh(join.want.facts)]
    flesh = _flesh(joins)
    meets = _heat_of(flesh)
    if not told or meets is None or (technique is not None and line_told(_part(), technique.lines)):
        return line, joins
    stir, turn, stand = _stages()
    whole, became = with_line(line, meets, Line((stir, turn, stand)))

    def stage_for(join: Join) -> Stage:
        if join in told:
            return stir
        return turn if join in flesh else became.get(id(join.spot.stage), join.spot.stage)

    moved, found = put_at(whole, joins, stage_for)
    own = (stir, turn)
    pairs = zip(joins, found, strict=True)
    return moved, tuple(now if now.spot.stage in own else replace(before, spot=now.spot) for before, now in pairs)


def _heat_of(flesh: Sequence[Join]) -> Stage | None:
    """Return the one stage at which flesh comes to a heat; ``None`` where there are several, or it is mixed before."""
    stages = [join.spot.stage for join in flesh]
    one = bool(stages) and stages[0].heats and all(stage is stages[0] for stage in stages)
    return stages[0] if one else None


def _flesh(joins: Sequence[Join]) -> list[Join]:
    """Return the raw flesh that is listed with its marinade, or else all that there is."""
    raw = [join for join in joins if is_raw_flesh(join.want.facts) and not join.want.cooked]
    listed = list(filter(_is_listed_so, raw))
    return listed or raw


def _part() -> str:
    """Return the part of a dish in which its flesh stands before it is cooked, and what that is called."""
    return min(word_list("is what flesh stands in"))


def _is_listed_so(join: Join) -> bool:
    return join.want.part == _part()


def _stages() -> tuple[Stage, Stage, Stage]:
    """Return the stages in which a marinade is stirred, flesh is turned in it, and stands."""
    stir = replace(stage_of("stir"), vessel=_BOWL, label=_part())
    return stir, replace(stage_of("turn by hand"), vessel=_BOWL), replace(stage_of("chill"), vessel=_BOWL)
