"""The things of a kitchen: foods with a history, and vessels, tools and appliances that hold them.

A *part* is what was once taken from the kitchen (an onion, some salt). A *lump* is one food thing in one place: one
part, or many that were mixed. A *vessel* is whatever holds lumps or other vessels; an appliance is a vessel with power.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, field

from foon_kg.food import Food, Utensil


@dataclass(eq=False, slots=True)
class Part:
    """A ``food`` as it was taken from the kitchen at the step ``taken``, in these ``states``, and what was done since.

    Steps are numbers of the tree's. ``done`` maps each treatment (cut, peel, cook, boil, shell …) to the step that gave
    it, -1 where it was bought or assumed so. ``fine`` says how small its pieces are, 0 whole to 5 powder. ``remains``
    is what nobody eats (a husk, a skin). ``joined`` is the step that last brought it to other foods, ``mixed`` the one
    that last mixed it with them, ``heated`` the one that last heated it, ``cooled`` the first one after that at which
    it waited or was rinsed. ``unstated``: nobody ever said in which state it is (a name in a ``{}``), so that it is not
    judged raw or whole. ``spoonful``: it came in a spoon, too little to cook anything in. ``origin`` numbers what was
    taken once: portions of it have the same. ``name`` is the food's, in the singular.
    """

    food: Food
    states: tuple[str, ...]
    taken: int
    done: dict[str, int]
    fine: int
    remains: bool = False
    joined: int | None = None
    mixed: int | None = None
    heated: int | None = None
    cooled: int | None = None
    unstated: bool = False
    spoonful: bool = False
    origin: int = 0
    name: str = field(init=False)

    def __post_init__(self) -> None:
        self.name = self.food.name

    @property
    def kept_as(self) -> tuple[object, ...]:
        """What tells it from other parts: where it comes from, what was done to it, and whether it was ever hot."""
        return (self.origin, self.remains, frozenset(self.done), self.fine, self.heated is None)

    def meet(self, other: Part) -> None:
        """Be one part again with an ``other`` portion of the same history.

        When it last joined, was mixed, heated and cooled is the later of the two; so a portion that is still hot counts
        as cooled where the other one waited after that. The steps in ``done`` stay its own; they are a spoonful where
        both were.
        """
        self.joined = _later(self.joined, other.joined)
        self.mixed = _later(self.mixed, other.mixed)
        self.heated = _later(self.heated, other.heated)
        self.cooled = _later(self.cooled, other.cooled)
        self.spoonful = self.spoonful and other.spoonful

    def copy(self, *, remains: bool = False) -> Part:
        """Return another portion of it; with ``remains`` what nobody eats of it, as is a portion of such a part."""
        return Part(
            self.food, self.states, self.taken, dict(self.done), self.fine, remains or self.remains,
            self.joined, self.mixed, self.heated, self.cooled, self.unstated, self.spoonful, self.origin,
        )  # fmt: skip


def _later(one: int | None, other: int | None) -> int | None:
    """Return the later of two steps; ``None`` where there is neither."""
    return max((step for step in (one, other) if step is not None), default=None)


@dataclass(eq=False, slots=True)
class Lump:
    """One food thing: its names (what trees called it), its states, its parts and where it is.

    Names and parts are changed by its methods alone.

    ``made``: a step of the tree gave it this label. ``gone``: it is part of another lump now, or was thrown away.
    ``riders`` lie on it and go where it goes. ``last`` is the step that last touched it. ``number`` is the thing's
    number in a tree that numbers them, ``filed`` the very tuple ``called`` under which the kitchen last filed it: it is
    filed anew where ``called`` is another one.
    """

    label: str
    names: set[str]
    states: tuple[str, ...]
    parts: list[Part]
    where: Vessel | None = None
    number: int | None = None
    made: bool = False
    gone: bool = False
    riders: list[Lump] = field(default_factory=list)
    last: int = 0
    filed: tuple[str, ...] = ()
    _called: tuple[str, ...] | None = None

    @property
    def called(self) -> tuple[str, ...]:
        """Its names and those of its parts, each once, in no order."""
        if self._called is None:
            self._called = tuple(dict.fromkeys([*self.names, *[part.name for part in self.parts]]))
        return self._called

    def call(self, names: Collection[str]) -> None:
        """Let it have other names, too."""
        if not self.names.issuperset(names):
            self.names.update(names)
            self._called = None

    def keep(self, parts: list[Part]) -> None:
        """Let it have no other parts than these."""
        self.parts = parts
        self._called = None

    def take(self, parts: Iterable[Part]) -> None:
        """Take parts in: the given ones, and no copies of them.

        Portions of one thing that come together again with one history are one part.
        """
        self._called = None
        there = {part.kept_as: part for part in self.parts}
        for part in parts:
            kept_as = part.kept_as
            if kept_as in there:
                there[kept_as].meet(part)
            else:
                there[kept_as] = part
                self.parts.append(part)

    @property
    def mixed(self) -> bool:
        """Whether it is made of more than one food."""
        return len(self.parts) > 1 and len({part.name for part in self.parts}) > 1

    @property
    def fine(self) -> int:
        """How small its pieces are; of several parts the coarsest counts."""
        return min((part.fine for part in self.parts), default=0)


@dataclass(eq=False, slots=True)
class Vessel:
    """A vessel, tool or appliance with what it holds. ``where`` is what it stands on, in or is attached to.

    ``power`` of an appliance is by burner: the label of the vessel that stands there, ``""`` for all others; two pans
    of one label share one. ``covered``: a lid is on it. ``hot``: what is on gave it heat. ``had`` are names of lumps
    that were ever in it, ``held`` those of their parts. ``last`` is the step that last touched it.
    """

    label: str
    row: Utensil
    lumps: list[Lump] = field(default_factory=list)
    where: Vessel | None = None
    number: int | None = None
    covered: bool = False
    hot: bool = False
    power: dict[str, bool] = field(default_factory=dict)
    had: set[str] = field(default_factory=set)
    held: set[str] = field(default_factory=set)
    last: int = 0

    @property
    def is_appliance(self) -> bool:
        """Whether it is an appliance, with a switch or always on."""
        return self.row.role == "appliance"

    @property
    def names(self) -> set[str]:
        """The names of all foods in it: of its lumps and of their parts."""
        found: set[str] = set()
        for lump in self.lumps:
            found.update(lump.called)
        return found

    def is_on(self, burner: str = "") -> bool:
        """Return whether it is on, for the vessel called ``burner`` where it has a burner for each."""
        if self.row.always_on:
            return True
        if self.row.power != "vessel":
            return any(self.power.values())
        if burner and burner in self.power:
            return self.power[burner]
        return self.power.get("", False) if burner else any(self.power.values())

    def stack(self) -> Iterator[Vessel]:
        """Yield it, what it stands in or on or is attached to, what that stands in or on, and so on down."""
        place: Vessel | None = self
        while place is not None:
            yield place
            place = place.where
