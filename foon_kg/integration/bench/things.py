"""What a kitchen has while a dish is made: appliances, vessels, and foods in one place each."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from foon_kg.food import Tables
from foon_kg.food.lists import says, word_list

_FLAT = word_list("flat utensils")


@dataclass(eq=False)
class Device:
    """An appliance, and whether it is on: ``running`` has the numbers of the vessels for which it is.

    A stove has a burner for each vessel; any other appliance is on for all of them, which is the number 0. One that was
    found on is so in the states ``found``, until somebody turns it on or off; on a stove that is the first burner used.
    """

    label: str
    number: int
    always_on: bool = False
    running: set[int] = field(default_factory=set)
    found: tuple[str, ...] = ()

    @property
    def when_on(self) -> tuple[str, ...]:
        """The states in which it is while it is on."""
        return self.found or ("on",)


@dataclass(eq=False)
class Vessel:
    """A vessel with what is in or on it.

    ``device`` is what it stands on or in or is attached to, ``relation`` how (``"on"``, ``"in"``, ``"attached to"``).
    ``over`` is the vessel in which it stands, above the water of that. ``storage``: it is what a food is sold or kept
    in, and no vessel to work in.
    """

    label: str
    number: int
    contents: list[Stuff] = field(default_factory=list)
    device: Device | None = None
    relation: str = ""
    over: Vessel | None = None
    lid: str = ""
    hot: bool = False
    storage: bool = False


@dataclass(eq=False)
class Stuff:
    """A food, or a mixture (``mixed``), in one place: ``at`` a vessel, or free in the kitchen.

    ``foods`` are the names of all foods in it, ``wants`` the numbers of the asked foods
    (:attr:`~foon_kg.integration.preparing.preparation.Want.number`) of which some is in it.
    """

    label: str
    number: int
    states: tuple[str, ...]
    foods: tuple[str, ...]
    wants: frozenset[int]
    at: Vessel | None = None
    mixed: bool = False


Thing = Device | Vessel | Stuff | str
"""What a step happens to; a tool is only its name."""

Shown = Thing | tuple[Device, Vessel]
"""What a step tells: a thing, or an appliance as it is with one of its vessels."""


def is_flat(label: str) -> bool:
    """Return whether things lie on what is called ``label``, and not in it."""
    return label.rpartition(" ")[2] in _FLAT


def foods_of(vessel: Vessel) -> tuple[str, ...]:
    """Return the names of all foods in a vessel."""
    return tuple(dict.fromkeys([food for stuff in vessel.contents for food in stuff.foods]))


def is_baked(stuff: Stuff) -> bool:
    """Return whether ``stuff`` was baked, or steamed, and has set in what it was heated in."""
    return says(stuff.states, "sets in what it is heated in")


def is_heated(states: Iterable[str], known: Tables) -> bool:
    """Return whether one of these states is only given by heat, by the tables ``known``."""
    return any(known.state(state).needs_heat for state in states)


def fineness(states: Iterable[str], known: Tables) -> int:
    """Return how fine the pieces of a food in these states are, 0 (whole) to 5 (powder), by the tables ``known``."""
    return max((known.state(state).fineness for state in states), default=0)
