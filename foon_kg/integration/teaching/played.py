"""A video as it was played in the world: where each part of matter was after each step, and what heat reached.

How lines of stages are found in that is in :mod:`~foon_kg.integration.teaching.derivation`.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from functools import cached_property

from foon_kg.food import Tables, is_among, singular
from foon_kg.food.lists import word_list
from foon_kg.model import FunctionalUnit
from foon_kg.model.values import made_often
from foon_kg.world import Lump, Part, PlayedStep, Step, World
from foon_kg.world.reading import NodeReading
from foon_kg.world.things import Vessel

_FLAT = word_list("flat utensils")


_Spot = tuple[str, tuple[str, ...], Vessel | None, Vessel | None, Lump]
"""What a place is made of: label and states of a lump, its vessel, what that stands on, and on which lump it lies."""


@made_often(eq=False)
class Place:
    """Where a part is after a step.

    ``key`` tells its place from others: two parts with the same one have met. ``label`` and ``states`` are those of the
    ``lump`` that it is in; that is in or on (``relation``) a ``vessel``, which ``stands`` on or in an appliance; ``""``
    for none.
    """

    key: Hashable
    lump: Lump
    label: str
    states: tuple[str, ...]
    vessel: str
    relation: str
    stands: str


class Played:
    """The units of a video, played one after the other; parts are known by the numbers of their first sightings.

    ``heated`` are the parts that a step heats, ``over_heat`` the vessels that stand over a fire that burns after it.
    """

    def __init__(self, units: Sequence[FunctionalUnit], known: Tables) -> None:
        self.units = units
        self.known = known
        self.world = World(known=known)
        self.heated: list[frozenset[int]] = []
        self.over_heat: list[frozenset[str]] = []
        self._places: list[dict[int, Place]] = []
        self._numbers: dict[Part, int] = {}
        self._parts: list[Part] = []
        self._latest: dict[Lump, tuple[_Spot, Place]] = {}
        self._portion_places: dict[tuple[int, int], Place | None] = {}
        for unit in units:
            played_step = self.world.play(Step.of(unit.input_nodes, unit.motion, unit.output_nodes))
            self._places.append(self._places_now())
            self.heated.append(self._heated_in(played_step))
            self.over_heat.append(frozenset(vessel.label for vessel in self.world.supply.burning()))

    @property
    def played_steps(self) -> Sequence[PlayedStep]:
        """What happened at each step."""
        return self.world.played_steps

    def number(self, part: Part) -> int:
        """Return the number by which a part is known here."""
        number = self._numbers.get(part)
        if number is None:
            number = self._numbers[part] = len(self._parts)
            self._parts.append(part)
        return number

    @cached_property
    def fetched(self) -> frozenset[str]:
        """The names of foods that go into a unit before any unit gives them: they come from the kitchen."""
        found: set[str] = set()
        given: set[str] = set()
        for played_step in self.played_steps:
            found |= set(map(compact, _foods(played_step.input_readings))) - given
            given.update(map(compact, _foods(played_step.output_readings)))
        return frozenset(found)

    def goes_in(self, part: Part) -> bool:
        """Whether the unit that first tells of a part takes it in; else only a name in its product tells of it."""
        return is_among(part.name, _foods(self.played_steps[part.taken].input_readings))

    def came_mixed(self, part: Part) -> bool:
        """Return whether a part is only told as an ingredient of something that nobody made: it was lost before."""
        if not part.unstated:
            return False
        foods = [said for said in self.played_steps[part.taken].input_readings if said.is_food]
        within = any(part.name in said.names for said in foods)
        return within and all(said.label != part.name for said in foods)

    def parts_of(self, lump: Lump, step: int) -> list[Part]:
        """Return the parts that are in the place of a lump after a step."""
        there = self._places[step]
        key = next((place.key for place in there.values() if place.lump is lump), None)
        found = [part for part, name in self._numbers.items() if name in there and there[name].key == key]
        return found or list(lump.parts)

    def inside(self, step: int) -> set[int]:
        """Return the numbers of the parts of all that a step is about."""
        played_step = self.played_steps[step]
        lumps = [*played_step.inputs, *played_step.outputs.values(), *played_step.made]
        lumps += [lump for vessel in played_step.vessels for lump in vessel.lumps if vessel.row.role != "storage"]
        lumps += [lump for lump, _, _ in played_step.moved]
        return {self.number(part) for lump in lumps for part in lump.parts}

    def place_of(self, number: int, step: int) -> Place | None:
        """Return where the part with a ``number`` was after a step: it, or what it is a portion of."""
        found = self._places[step].get(number)
        if found is not None:
            return found
        if (number, step) not in self._portion_places:
            self._portion_places[number, step] = self._portion_of(number, step)
        return self._portion_places[number, step]

    def _portion_of(self, number: int, step: int) -> Place | None:
        there = self._places[step]
        places = (there[other] for other in self._portions.get(self._parts[number].origin, ()) if other in there)
        return max(places, key=lambda one: _in_use(one.lump), default=None)

    @cached_property
    def _portions(self) -> dict[int, list[int]]:
        """The numbers of the parts that come of the same food, by where that came from."""
        found: dict[int, list[int]] = {}
        for part, number in self._numbers.items():
            found.setdefault(part.origin, []).append(number)
        return found

    def _places_now(self) -> dict[int, Place]:
        found: dict[int, Place] = {}
        below: dict[Lump, Lump] = {}
        lumps = dict.fromkeys(lump for named in self.world.supply.lumps.values() for lump in named if not lump.gone)
        for lump in lumps:
            for rider in lump.riders:
                if not rider.gone and rider is not lump:
                    below[rider] = lump
        for lump in sorted(lumps, key=_in_use):  # of a part that is in two places the latter counts
            place = self._place_now(lump, below)
            for part in lump.parts:
                found[self.number(part)] = place
        return found

    def _place_now(self, lump: Lump, below: dict[Lump, Lump]) -> Place:
        """Return the place of a lump, which is the same as at the step before where nothing of it has changed.

        ``below`` has what each lump lies on.
        """
        where = lump.where
        base = _base(lump, below) if lump in below else lump
        spot = (lump.label, lump.states, where, None if where is None else where.where, base)
        latest = self._latest.get(lump)
        if latest is not None and latest[0] == spot:
            return latest[1]
        place = _place(lump, base)
        self._latest[lump] = spot, place
        return place

    def _heated_in(self, played_step: PlayedStep) -> frozenset[int]:
        """Return the numbers of the parts that a step heats."""
        if not played_step.does("heat", "warm"):
            return frozenset()
        step = played_step.number
        return frozenset(self.number(part) for part in self.world.supply.parts if part.heated == step)


def _foods(told: Iterable[NodeReading]) -> set[str]:
    """Return the names of all foods of which nodes tell, whether they stand there by themselves or in a vessel."""
    names = {said.label for said in told if said.is_food}
    return names.union(*(said.names for said in told))


def compact(name: str) -> str:
    """Return a name without its spaces: annotators write "hash brown" and "hashbrown" in one video."""
    return "".join(singular(name).split())


def _in_use(lump: Lump) -> tuple[bool, int, int]:
    """Return a key by which those come last that are in use: not rests in packets, touched of late, of many foods."""
    return (lump.where is None or not lump.where.row.keeps_food, lump.last, len(lump.parts))


def _place(lump: Lump, base: Lump) -> Place:
    """Return the place of a lump that lies on ``base``, which is itself where it lies on no other."""
    where = lump.where
    if where is None:
        return Place(("lump", id(base)), lump, lump.label, lump.states, "", "in", "")
    relation = "on" if where.label.rpartition(" ")[2] in _FLAT else "in"
    stands = where.where.label if where.where is not None else ""
    key: Hashable = ("lump", id(base)) if _keeps_apart(where) else ("vessel", id(where))
    return Place(key, lump, lump.label, lump.states, where.label, relation, stands)


def _keeps_apart(vessel: Vessel) -> bool:
    """Whether what is in one vessel has not met there: on a board, in a cupboard, in a packet."""
    return vessel.row.role in {"storage", "place", "appliance"} or vessel.row.keeps_food or "cut" in vessel.row.can


def _base(lump: Lump, below: dict[Lump, Lump]) -> Lump:
    """Return the lowest of the lumps that lie on one another; none counts twice, should they lie in a circle."""
    seen = {lump}
    while lump in below and below[lump] not in seen:
        lump = below[lump]
        seen.add(lump)
    return lump
