"""Rows of the tables: what is known of one food, state, motion, utensil or dish. Frozen values, no files."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property

from foon_kg.model.values import made_often


class Level(StrEnum):
    """How bad it is not to do what a food asks for before it is served."""

    FATAL = "fatal"
    MINOR = "minor"
    ADVICE = "advice"


class Match(StrEnum):
    """How a name was found in the table of foods, the surest first."""

    NAME = "its name"
    HEAD = "its last words"
    SUFFIX = "its ending"
    PART = "a part of its name"
    UNKNOWN = "unknown"


@dataclass(frozen=True)
class Kind:
    """A kind of food. ``of`` are broader kinds; ``when`` names the kind that a food is of in other states."""

    name: str
    about: str = ""
    of: tuple[str, ...] = ()
    sold_in: str = ""
    sold_as: str = ""
    owes: Mapping[str, Level] = field(default_factory=dict)
    traits: frozenset[str] = frozenset()
    when: Mapping[str, str] = field(default_factory=dict)


@made_often(eq=False)
class Food:
    """What is known of a food in its states.

    ``kinds`` are its kind and all broader ones. ``owes`` says what a cook does to it before it is served. ``match``
    says how its name was found, ``taken_for`` as which name of the table. ``no_more`` is the kind of that name that it
    is no more, ground to a spice: onion powder is no onion.
    """

    name: str
    kind: str
    kinds: frozenset[str]
    owes: Mapping[str, Level]
    traits: frozenset[str]
    sold_in: str
    sold_as: str
    match: Match
    taken_for: str
    no_more: str = ""

    @property
    def known(self) -> bool:
        """Whether the table knows the food, or at least its last words."""
        return self.match is not Match.UNKNOWN

    @cached_property
    def _tags(self) -> frozenset[str]:
        return self.kinds | self.traits | ({self.name, self.taken_for} - {self.no_more})

    def is_a(self, *names: str) -> bool:
        """Whether the food is of one of these kinds, has one of these traits, or is called so."""
        return not self._tags.isdisjoint(names)

    def is_any(self, names: Collection[str]) -> bool:
        """Whether it is one of ``names``, as :meth:`is_a` has them: those of a list."""
        return not self._tags.isdisjoint(names)

    def is_of(self, *kinds: str) -> bool:
        """Whether the food is of one of these kinds, where a trait may have the name of one (stock)."""
        return not self.kinds.isdisjoint(kinds)


HALVED, SLICED, CHOPPED, MINCED, POWDER = 1, 2, 3, 4, 5
"""How fine pieces are (``State.fine``): halves; slices, wedges; chunks, dice; minced, grated; powder and mash."""


@dataclass(frozen=True)
class State:
    """What a state says of a food: what was done to it (``earns``), how fine its pieces are (0 whole to 5 powder).

    ``sold``: a shop sells food so, any food or those in ``sold_for``. ``undivided``: the food is in one piece, so that
    there is no second one once it was used. ``before`` are states one of which comes first (frozen, before defrosted).
    """

    name: str
    earns: frozenset[str] = frozenset()
    fine: int | None = None
    sold: bool = False
    sold_for: frozenset[str] = frozenset()
    undivided: bool = False
    half: bool = False
    needs_heat: bool = False
    before: frozenset[str] = frozenset()

    @property
    def fineness(self) -> int:
        """How fine the pieces are, 0 (whole) where the state says nothing of it."""
        return self.fine or 0

    @property
    def takes_work(self) -> bool:
        """Whether somebody has to give a food this state: it is the name of a treatment, and no shop sells food so."""
        return not self.sold and bool(self.earns or self.fine)


@dataclass(frozen=True)
class Motion:
    """What a motion does, which states it can give, and what it needs.

    ``tools`` has for each of its words the abilities one of which is needed; ``source`` is ``heat``, ``cold``,
    ``power`` or ``""``.
    """

    name: str
    does: frozenset[str] = frozenset()
    gives: frozenset[str] = frozenset()
    tools: tuple[frozenset[str], ...] = ()
    source: str = ""
    known: bool = True


@dataclass(frozen=True)
class Utensil:
    """A utensil: its role (vessel, storage, tool, appliance, lid, wrap, place) and what it can do.

    ``many``: a kitchen has several alike. An appliance has a ``source`` (heat, cold, power, water), ``holds`` what it
    works on (on, in, attached), has one power or one for each vessel (``power``), and may be ``always_on``.
    ``name`` is in the singular, ``written`` as people write it (scissors).
    """

    name: str
    role: str
    group: str
    can: frozenset[str] = frozenset()
    many: bool = False
    source: str = ""
    holds: str = ""
    power: str = "one"
    always_on: bool = False
    written: str = ""

    @cached_property
    def keeps_food(self) -> bool:
        """Whether food is in it as it is sold, or comes out of it: a jar, a tap."""
        return self.role == "storage" or self.source == "water"

    def works_like(self, other: Utensil) -> bool:
        """Return whether this appliance works as the ``other`` does: of its group, or just the same by power.

        Of what heats or cools that is too little: a grill holds, heats and cooks, and so does a slow cooker.
        """
        by_power = self.source == other.source == "power"
        alike = by_power and bool(self.can) and self.can == other.can
        return self.role == other.role == "appliance" and (self.group == other.group or alike)


@dataclass(frozen=True)
class Dish:
    """What defines a dish: of each list in ``needs`` one is in it; ``heated`` is ``None`` where it may be hot or cold.

    ``eases`` are kinds of which raw food is odd in it and no danger (egg in a drink). ``baked``: it
    comes out of an oven, and what is fried in a pan is another dish. ``tin``: what its batter or dough is baked in.
    ``stacked``: it is put together on bread, and what needs no cooking only then.
    ``grilled``: it is fried as a whole once it is put together. ``laid``: its foods lie on dough or bread.
    ``dressed``: a dressing comes over it. ``mashed``: it is boiled and mashed with the rest, and done. ``coated``: with
    crumbs it is flesh in a crust. ``formed``: balls, patties or cakes are shaped of a mass. ``is_no`` are dishes that
    it is not, though a dish type or a word of its name says so (a pancake is no cake). ``raw`` are kinds that are eaten
    raw in what is called so.
    """

    name: str
    needs: tuple[tuple[str, ...], ...] = ()
    heated: bool | None = None
    is_type: bool = False
    eases: frozenset[str] = frozenset()
    baked: bool = False
    tin: str = ""
    stacked: bool = False
    grilled: bool = False
    laid: bool = False
    dressed: bool = False
    mashed: bool = False
    coated: bool = False
    formed: bool = False
    is_no: frozenset[str] = frozenset()
    raw: frozenset[str] = frozenset()

    @property
    def may_be_unknown(self) -> bool:
        """Whether the food of this name may be one of which nothing is known: it is no type, and nobody has to heat it.

        A cheese of another land is eaten as it is; a shoulder of its lamb would come raw on the plate.
        """
        return not self.is_type and not self.heated
