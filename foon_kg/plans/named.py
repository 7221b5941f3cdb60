"""What a person said of one thing that they named: its state, its contents, where it is.

What follows from it for a kitchen, see :mod:`foon_kg.plans.stock`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

from foon_kg.food import singular, tables
from foon_kg.model import ObjectNode
from foon_kg.plans.kitchen import Kitchen, folded


def called(label: str, things: Collection[ObjectNode]) -> Iterator[ObjectNode]:
    """Yield those of ``things`` that are called ``label``, in the singular or plural."""
    name = singular(label)
    return (thing for thing in things if singular(thing.label) == name)


def places_of(things: Collection[ObjectNode], kitchen: Kitchen) -> Iterator[ObjectNode]:
    """Yield the places of ``kitchen`` at which ``things`` were named, unless they were named themselves.

    Who names what is in the fridge has a fridge; who names what is on a board has a board with that on it.
    """
    utensils = [thing for thing in things if kitchen.is_utensil(thing.label)]
    for thing in things:
        if thing.container:
            inside = (thing.label,) if _is_put_by(thing, kitchen) else ()
            if not any(held_in(one) >= set(map(singular, inside)) for one in called(thing.container, utensils)):
                yield ObjectNode(thing.container, (), inside)


def _is_put_by(thing: ObjectNode, kitchen: Kitchen) -> bool:
    """Whether ``thing`` is a food that somebody put where it is."""
    place = thing.container or ""
    return kitchen.is_food(thing) and not kitchen.is_storage(place) and starts_empty(place)


def held_in(vessel: ObjectNode) -> set[str]:
    """Return the names, in the singular, of what ``vessel`` holds."""
    return set(map(singular, vessel.ingredients))


def is_told(thing: ObjectNode) -> bool:
    """Whether more was said of ``thing`` than its name."""
    return bool(thing.states or thing.ingredients or thing.container)


def is_vessel(label: str) -> bool:
    """Whether ``label`` names a vessel, such as a bowl or pan."""
    row = tables().utensil(label)
    return row is not None and row.role == "vessel"


def starts_empty(container: str) -> bool:
    """Whether ``container`` is empty until somebody puts something into it: no place, tap, fridge or packet."""
    row = tables().utensil(container)
    return row is None or not (row.role == "place" or row.always_on or row.keeps_food)


def is_heating(thing: ObjectNode) -> bool:
    """Whether ``thing`` is an appliance that heats, and is on."""
    row, on = tables().utensil(thing.label), tables().utensil_states["on"]
    heats = row is not None and row.role == "appliance" and row.source == "heat" and not row.always_on
    return heats and not on.isdisjoint(map(folded, thing.states))


def says(thing: ObjectNode, state: str) -> bool:
    """Whether ``thing`` was named in ``state``, among others maybe."""
    return folded(state) in map(folded, thing.states)


def in_place(thing: ObjectNode, container: str | None) -> bool:
    """Whether ``thing`` may be what stands in ``container``; where one of them says no place, it may."""
    return thing.container is None or container is None or folded(thing.container) == folded(container)
