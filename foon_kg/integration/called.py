"""A dish whose name says how its parts come together is made so, whatever its video does."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from foon_kg.food import Tables
from foon_kg.food.rows import Dish
from foon_kg.integration.bodies import made_apart
from foon_kg.integration.coated import coated_alone
from foon_kg.integration.formed import formed, is_formed
from foon_kg.integration.frames import Line
from foon_kg.integration.layered import layered
from foon_kg.integration.lined import lined, rolled
from foon_kg.integration.mashed import mashed_only
from foon_kg.integration.places import Join
from foon_kg.integration.portions import in_portions, roasted, stirred_in_pieces
from foon_kg.integration.pots import is_never_heated, unheated
from foon_kg.integration.poured_over import dressed_apart
from foon_kg.integration.rubbed import rubbed
from foon_kg.integration.smeared import smeared_and_baked


@dataclass(frozen=True)
class Called:
    """What a dish is called: the ``dishes`` of that name, the words of its type and title, its recorded ``goal``.

    ``baked``: the words say that it comes out of an oven.
    """

    dishes: Sequence[Dish]
    told: Collection[str]
    goal: str
    baked: bool


def as_it_is_called(line: Line, joins: Sequence[Join], called: Called, known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return how a dish is made whose kind says how its parts come together."""
    made, found = _shaped(line, tuple(joins), called, known)
    if made is not line:
        return made, found
    dishes, told = called.dishes, called.told
    dressed = any(dish.dressed for dish in dishes)
    joins = tuple(joins)
    if is_never_heated(dishes, joins, known):
        line, joins = unheated(line, joins)
    if any(dish.mashed for dish in dishes):
        line, joins = mashed_only(joins)
    if any(dish.stacked for dish in dishes):
        line, joins = made_apart(line, joins, told, known, grilled=any(dish.grilled for dish in dishes))
    elif any(dish.coated for dish in dishes) and not dressed:
        made, found = coated_alone(line, joins, told, known)
        if made is line:
            made, found = in_portions(line, joins, told, known, baked=called.baked)
        line, joins = stirred_in_pieces(line, joins, known) if made is line else (made, found)
    elif not dressed:
        line, joins = roasted(*smeared_and_baked(line, joins), told)
    return dressed_apart(line, joins) if dressed else (line, joins)


def _shaped(line: Line, joins: tuple[Join, ...], called: Called, known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return how a dish is made that is given its form: by dough around it, in a roll, as balls; else as it is."""
    for way in (rubbed, layered, rolled, lined):
        made, found = way(line, joins, called.told)
        if made is not line:
            return made, found
    if is_formed(called.dishes, joins):
        return formed(line, joins, called.told, known, called.goal, baked=called.baked)
    return line, joins
