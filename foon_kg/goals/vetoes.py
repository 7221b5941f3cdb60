"""What speaks against making a recipe after a recorded dish, before dishes are ranked (algorithm 1).

Each reason is a clause for people: explanations show it beside the dish that was passed over. A dish with fewer
reasons comes before one with more (:mod:`foon_kg.goals.choice`), however like the latter is; so one with some is taken
only where there is none without.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import takewhile

from foon_kg.food.rows import Dish
from foon_kg.goals.asked import Asked, AskedFood
from foon_kg.goals.recorded import Recorded
from foon_kg.integration.composing.poured_over import is_poured_over
from foon_kg.integration.joining.spots import Join, Spot


def vetoes(dish: Recorded, joins: Sequence[Join], asked: Asked) -> Iterator[str]:
    """Yield the reasons why nobody would make what is ``asked`` after ``dish``; none where nothing speaks against it.

    ``joins`` say where each of ``asked.foods`` would join, in their order; raises ValueError for another number.
    """
    yield from _against_heat(dish, joins, asked)
    yield from _against_dressed(dish, joins, asked)
    yield from _against_work(dish, joins, asked)
    for food, join in zip(asked.foods, joins, strict=True):
        if join.slot is None:  # one with a slot was treated so in the video
            yield from _against_company(food, join, dish)


def _against_dressed(dish: Recorded, joins: Sequence[Join], asked: Asked) -> Iterator[str]:
    """Yield that a dish only comes over another one, where several foods are asked that come under one."""
    if asked.dressed and dish.only_poured:
        solid = (join for join in joins if not is_poured_over(join.want, join.slot))
        if len(list(solid)) > 1:  # one alone may be what the dressing is named after
            yield f"{dish.label} is only what comes over such a dish"


def _against_company(food: AskedFood, join: Join, dish: Recorded) -> Iterator[str]:
    """Yield what would go wrong with a ``food`` that has no place of its own in the dish, where it joins the others."""
    label, work = join.want.label, join.spot.stage_type.work
    if food.runs and id(join.spot) in dish.layout.drained:
        yield f"{label} would run off"
    if work in {"knead", "shape"} and not food.worked_in:
        yield f"{label} would be worked into it"
    if work == "blend" and food.flesh:
        yield f"{label} would be blended"


def _against_work(dish: Recorded, joins: Sequence[Join], asked: Asked) -> Iterator[str]:
    """Yield at most one reason: that a dish kneads or shapes cold what nobody would.

    None of what it is built on has a place there, or it is raw flesh in pieces that nothing holds together.
    """
    for spot in dish.worked_cold:
        foods = zip(asked.foods, joins, strict=True)
        inside = [(food, join) for food, join in foods if _comes_through(join.spot, spot)]
        if inside and not any(food.carries and join.slot is not None for food, join in inside):
            yield f"{dish.label} has the step “{spot.stage.motion}”, and nothing here is for that"
            return
        coarse = _coarse(inside, spot)
        if coarse:
            yield f"{coarse} in pieces would come to the step “{spot.stage.motion}”"
            return


def _coarse(inside: Sequence[tuple[AskedFood, Join]], spot: Spot) -> str:
    """Return what raw flesh in pieces comes to a stage where nothing holds it together; ``""`` for none."""
    if any(food.holds for food, _ in inside):
        return ""
    return next((join.want.label for food, join in inside if food.keeps_apart and _is_raw_at(join.spot, spot)), "")


def _against_heat(dish: Recorded, joins: Sequence[Join], asked: Asked) -> Iterator[str]:
    """Yield what a dish heats that is to stay as it is, and what it leaves cold that is to be hot."""
    if asked.stacked and dish.heats_base_alone:
        yield f"what it is laid on is heated by itself in {dish.label}"
    if dish.bakes and (asked.unbaked or asked.named_unbaked or asked.in_a_pan):
        yield f"it is not to be baked, and {dish.label} is"
    if not asked.unbaked:
        for kind in asked.dishes:
            yield from _too_cold(kind, dish, joins, asked)


def _too_cold(kind: Dish, dish: Recorded, joins: Sequence[Join], asked: Asked) -> Iterator[str]:
    """Yield what of the heat that a ``kind`` of dish asks for the recorded ``dish`` would not give."""
    if kind.laid:
        yield from _unbaked_bases(joins, asked)
    if kind.baked and not dish.bakes:
        yield f"{kind.name} is baked, and {dish.label} is not"
    if kind.heated:
        yield from _not_hot(kind, dish, asked)


def _unbaked_bases(joins: Sequence[Join], asked: Asked) -> Iterator[str]:
    """Yield the first food that others are laid on and that would not be heated."""
    for food, join in zip(asked.foods, joins, strict=True):
        if food.base and not join.spot.heats_later:
            yield f"{join.want.label} would not be baked"
            return


def _not_hot(kind: Dish, dish: Recorded, asked: Asked) -> Iterator[str]:
    """Yield why a recorded dish gives no hot one; foods that owe heat are heated by themselves where need be."""
    if dish.heats or (asked.stacked and asked.grilled) or dish.cooks_foods:
        if dish.ends_raw:
            yield f"{kind.name} is hot, and {dish.label} is not cooked once it is shaped"
    elif kind.is_type or not any(food.due for food in asked.foods):
        yield f"{kind.name} is hot, and {dish.label} is not"


def _comes_through(joined: Spot, spot: Spot) -> bool:
    """Whether what joins at ``joined`` is part of the whole when ``spot`` is done."""
    return joined.stage is spot.stage or any(stage is spot.stage for stage in joined.after)


def _is_raw_at(joined: Spot, spot: Spot) -> bool:
    """Whether nothing heats what joins at one stage before it comes to another one."""
    way = takewhile(lambda stage: stage is not spot.stage, (joined.stage, *joined.after))
    return not any(stage.heats for stage in way)
