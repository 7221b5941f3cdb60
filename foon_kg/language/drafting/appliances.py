"""The appliances of an action: what heats or cools is one of its instruments, wherever it was told.

"Put it in the oven" names a place, "preheat to 180 degrees" nothing, and "remove the lid and bake" a thing that is not
baked.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.language.drafting.verbs import Reading
from foon_kg.model.narration import Mention, NarratedAction, Place

_CHILL = "refrigerate"
_HEATS_ONE = word_list("heats an appliance")
_OVEN = "oven"
_TEMPERS = frozenset({"heat", "cold"})
_HEATED_BESIDE = frozenset({"lid", "tool", "wrap"})
"""Roles of utensils that are with the food while it is heated: it is not they that are baked."""


@dataclass(frozen=True)
class Appliances:
    """Finds the appliances of actions; only of what is told ``free``, in sentences, may a fridge be the verb."""

    precedents: FoonPrecedents
    free: bool

    def used(self, action: NarratedAction, reading: Reading) -> tuple[NarratedAction, Reading]:
        """Return the ``action`` with what heats or cools among its instruments, and how its verb is read then.

        ``reading`` is how it was read before: what is put into a fridge is chilled.
        """
        if action.verb in _HEATS_ONE and not action.objects:
            return _heating_an_appliance(action), reading
        action = _without_heated_beside(action, reading.likeliest)
        sources = {place.name: source for place in action.places if (source := source_of(place.name)) in _TEMPERS}
        if not sources or self._are_utensils(action.objects):
            return action, reading
        if not tables().motion(reading.likeliest).source:
            if not self.free or next(iter(sources.values())) != "cold":
                return action, reading
            action, reading = self.chilled(action)
        return _by_appliances(action, sources), reading

    def chilled(self, action: NarratedAction) -> tuple[NarratedAction, Reading]:
        """Return an ``action`` that puts something into what cools as one that chills, and how that is read."""
        return replace(action, verb=_CHILL), self.precedents.verbs.reading(_CHILL)

    def _are_utensils(self, objects: Sequence[Mention]) -> bool:
        return bool(objects) and all(self.precedents.kitchen.is_utensil(one.name) for one in objects)


def source_of(name: str) -> str:
    """Return what comes from the utensil ``name``, as "heat", "cold" or "water"; ``""`` where nothing does."""
    row = tables().utensil(name)
    return row.source if row is not None else ""


def is_appliance(name: str) -> bool:
    """Return whether ``name`` is that of an appliance."""
    return _role_of(name) == "appliance"


def _role_of(name: str) -> str:
    row = tables().utensil(name)
    return row.role if row is not None else ""


def _heating_an_appliance(action: NarratedAction) -> NarratedAction:
    """Return "preheat to 180 degrees" with what is heated: an appliance among the places, else the oven."""
    heater = next((place.name for place in action.places if source_of(place.name) == "heat"), _OVEN)
    return replace(action, objects=(Mention(heater),), places=())


def _by_appliances(action: NarratedAction, appliances: Collection[str]) -> NarratedAction:
    """Return an action with those of its places that are ``appliances`` among its instruments."""
    places = tuple(place for place in action.places if place.name not in appliances)
    return replace(action, places=places, instruments=(*appliances, *action.instruments))


def _without_heated_beside(action: NarratedAction, motion: str) -> NarratedAction:
    """Return an action that heats without objects that heat nothing: lids and tools, and what the heat comes from.

    "Remove the lid and bake" is said of what is in the pot, and "bake the oven" of nothing: it is where one bakes.
    """
    does = tables().motion(motion)
    names = [one.name for one in action.objects]
    if not (does.source and "heat" in does.does and names):
        return action
    if set(map(_role_of, names)) <= _HEATED_BESIDE:
        return replace(action, objects=())
    if set(map(source_of, names)) == {does.source}:
        heaters = tuple(Place("in", name) for name in names)
        return replace(action, objects=(), places=(*action.places, *heaters))
    return action
