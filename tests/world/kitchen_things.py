"""The things of a walk through a kitchen, and what is known of foods there: see :mod:`world.kitchen_walk`."""

from __future__ import annotations

from dataclasses import dataclass, field

from foon_kg.model import ObjectNode


@dataclass(frozen=True)
class Told:
    """An object node with the numbers of the thing and of what it is in."""

    node: ObjectNode
    thing: int | None = None
    inside: int | None = None


@dataclass(frozen=True)
class Line:
    """One step of a walk.

    ``kind`` is the operator, ``needs`` are the lines that last changed its foods and its appliances, ``about`` is the
    food that it works on, by number.
    """

    kind: str
    inputs: tuple[Told, ...]
    motion: str
    outputs: tuple[Told, ...]
    needs: frozenset[int] = frozenset()
    about: int | None = None


@dataclass(frozen=True)
class Walk:
    """A tree and what its model knows: ``foods`` are those of the dish, by number."""

    lines: tuple[Line, ...]
    goal: ObjectNode
    foods: tuple[Food, ...]


@dataclass(frozen=True)
class Kind:
    """A food as it is bought: its state, in what it is sold, what can be done to it, and what is inedible without."""

    label: str
    state: str
    sold_in: str = ""
    can: frozenset[str] = frozenset()
    owes: frozenset[str] = frozenset()
    liquid: bool = False


def _kind(label: str, state: str, sold_in: str = "", can: str = "", owes: str = "", *, liquid: bool = False) -> Kind:
    return Kind(label, state, sold_in, frozenset(can.split()), frozenset(owes.split()), liquid)


SOLID = (
    _kind("tomato", "whole", can="wash cut", owes="cut"),
    _kind("cucumber", "whole", can="wash peel cut", owes="cut"),
    _kind("onion", "whole", can="peel cut", owes="cut"),
    _kind("carrot", "whole", can="wash peel cut grate", owes="cut"),
    _kind("potato", "whole", can="wash peel cut grate", owes="cook"),
    _kind("banana", "whole", can="peel cut", owes="peel"),
    _kind("mozzarella", "block", can="cut grate"),
    _kind("chicken", "raw", can="wash cut", owes="cook"),
)
EGG = _kind("egg", "whole", owes="cook")
STORED = (
    _kind("salt", "granulated", "shaker"),
    _kind("sugar", "granulated", "bag"),
    _kind("flour", "powder", "bag"),
    _kind("rice", "uncooked", "bag", owes="cook"),
    _kind("olive oil", "liquid", "bottle", liquid=True),
    _kind("milk", "liquid", "carton", liquid=True),
)
WATER = _kind("water", "liquid", "faucet", liquid=True)
FOODS = frozenset(kind.label for kind in (*SOLID, EGG, *STORED, WATER))
CUTS = {"chop": "chopped", "slice": "sliced", "dice": "diced"}
COOKS = {"boil": "boiled", "fry": "fried", "heat": "hot", "bake": "baked"}
PRODUCTS = ("mixture", "mix", "filling", "stew", "smoothie", "medley", "soup")
VESSELS = (
    "bowl", "bowl", "bowl", "plate", "cutting board", "cutting board", "pot", "pan", "baking tray", "blender jar",
    "strainer", "serving bowl", "wooden spoon",
)  # fmt: skip
DEEP = frozenset({"bowl", "pot", "pan", "blender jar"})
FLAT = frozenset({"plate", "cutting board", "baking tray"})
ON = frozenset({"plate", "cutting board", "baking tray"})


@dataclass(eq=False)
class Food:
    """A food thing: its states, what was mixed into it and where it is; ``done`` has what was done to it."""

    kind: Kind
    number: int
    label: str
    states: tuple[str, ...]
    holds: tuple[Food, ...] = field(default=(), repr=False)
    place: Vessel | None = field(default=None, repr=False)
    done: set[str] = field(default_factory=set)

    @property
    def foods(self) -> tuple[Food, ...]:
        """What it is made of, to the last: itself where nothing was mixed."""
        return tuple(one for held in self.holds for one in held.foods) if self.holds else (self,)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all foods in it."""
        return tuple(dict.fromkeys(food.label for food in self.foods))

    @property
    def is_plain(self) -> bool:
        """Whether it is one food from the shop that is still in one piece."""
        return not self.holds and self.done <= {"wash", "peel"}

    @property
    def can_be_mashed(self) -> bool:
        """Whether it is soft enough: a cut banana, a cut potato that was cooked."""
        soft = self.label == "banana" or (self.label == "potato" and "cook" in self.done)
        return soft and not self.holds and "cut" in self.done and "mash" not in self.done


@dataclass(eq=False)
class Vessel:
    """A vessel with its foods; ``stands`` is the appliance on, in or at which it is."""

    label: str
    number: int
    foods: list[Food] = field(default_factory=list)
    stands: Device | None = None
    hot: bool = False
    covered: bool = False

    @property
    def is_within_reach(self) -> bool:
        """Whether food can be put in and taken out: not from the oven, nor while a device works."""
        if self.covered:
            return False
        return (
            self.stands is None
            or self.stands.label == "stove"
            or (self.stands.label == "blender" and not self.stands.on)
        )


@dataclass(eq=False)
class Device:
    """An appliance; ``on`` has the vessels whose burner is lit, or ``""`` for the whole."""

    label: str
    number: int
    relation: str
    on: set[str] = field(default_factory=set)


@dataclass(frozen=True)
class Style:
    """How an annotator writes: one way throughout a tree."""

    tools_come_out: bool = True
    sources_come_out: bool = True
    vessel_tells_parts: bool = False
    pours_tell_foods: bool = True
    packages_are_told: bool = False
    off: str = "off"
    stove: str = "under"
