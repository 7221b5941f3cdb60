"""What speaks against making a recipe after a recorded dish, whatever else speaks for it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from foon_kg.goals.asked import Asked
from foon_kg.goals.recorded import Recorded
from foon_kg.integration.poured_over import is_poured_over
from foon_kg.integration.spots import Join, Spot


def vetoes(dish: Recorded, joins: Sequence[Join], asked: Asked) -> Iterator[str]:
    """Yield what a cook would never do with this recipe, and its foods would come to where they join like this."""
    yield from _against_heat(dish, joins, asked)
    if asked.dressed and dish.only_poured:
        solid = (join for join in joins if not is_poured_over(join.want, join.slot))
        if len(list(solid)) > 1:
            yield f"{dish.label} is only what comes over such a dish"
    yield from _against_work(dish, joins, asked)
    for food, join in zip(asked.foods, joins, strict=True):
        if join.slot is not None:
            continue
        label, work = join.want.label, join.spot.post[0]
        if food.runs and id(join.spot) in dish.layout.drained:
            yield f"{label} would run off"
        if work in {"knead", "shape"} and not food.worked_in:
            yield f"{label} would be worked into it"
        if work == "blend" and food.flesh:
            yield f"{label} would be blended"


def _against_work(dish: Recorded, joins: Sequence[Join], asked: Asked) -> Iterator[str]:
    for spot in dish.worked_cold:
        foods = zip(asked.foods, joins, strict=True)
        inside = [(food, join) for food, join in foods if _comes_through(join.spot, spot)]
        if inside and not any(food.carries and join.slot is not None for food, join in inside):
            yield f"nothing of it is to be {spot.stage.motion}ed"
            return


def _against_heat(dish: Recorded, joins: Sequence[Join], asked: Asked) -> Iterator[str]:
    if asked.stacked and dish.heats_base_alone:
        yield f"what it is laid on is heated by itself in {dish.label}"
    if dish.bakes and (asked.unbaked or asked.flat or asked.in_a_pan):
        yield f"it is not to be baked, and {dish.label} is"
    if asked.unbaked:
        return
    hot = dish.heats or (asked.stacked and asked.grilled) or dish.cooks_foods
    for kind in asked.dishes:
        if kind.laid:
            foods = zip(asked.foods, joins, strict=True)
            unheated = (join.want.label for food, join in foods if food.base and not join.spot.heats_later)
            yield from (f"{label} would not be baked" for label in list(unheated)[:1])
        if kind.baked and not dish.bakes:
            yield f"{kind.name} is baked, and {dish.label} is not"
        if kind.heated and not hot:
            if kind.is_type or not any(food.due for food in asked.foods):
                yield f"{kind.name} is hot, and {dish.label} is not"
        elif kind.heated and dish.ends_raw:
            yield f"{kind.name} is hot, and {dish.label} is not cooked once it is shaped"


def _comes_through(joined: Spot, spot: Spot) -> bool:
    """Whether what joins at one stage is in the whole at another one."""
    return joined.stage is spot.stage or any(stage is spot.stage for stage in joined.after)
