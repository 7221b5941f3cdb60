"""Which thing of the world an input node is, and what is fetched from the kitchen where it is none.

A node that carries a number is that thing. Of nodes without numbers the thing is taken that says the same: the last
step that put it out so, else the one with the same name in the same place in the same state. Clean vessels and tools of
which a kitchen has several may be fresh ones.
"""

from __future__ import annotations

from collections.abc import Iterator

from foon_kg.food import Food, Utensil, is_among
from foon_kg.model import ObjectNode
from foon_kg.model.tree import Mention
from foon_kg.world.matching import carries, divides_like, in_storage, is_still, place_score, same_place
from foon_kg.world.played_step import PlayedStep
from foon_kg.world.reading import NodeReading, Reader
from foon_kg.world.things import Lump, Part, Vessel

_PLACE = Utensil("", "place", "places")
"""What anything is that somebody puts something on and that no table lists."""


class Supply:
    """All things that are there, and how nodes are told to be one of them.

    ``asked`` says how often each food was asked for, which is how many undivided ones a kitchen has; one of each where
    nobody asked. ``found_on`` are the appliances that are on before the first step, by their names. ``over_heat`` has
    each vessel that stands on or in a source of heat, with that.
    """

    def __init__(self, reader: Reader, asked: dict[str, int]) -> None:
        self.reader = reader
        self.asked = asked
        self.found_on: frozenset[str] = frozenset()
        self.lumps: dict[str, list[Lump]] = {}
        self.vessels: dict[str, list[Vessel]] = {}
        self.over_heat: dict[Vessel, Vessel] = {}
        self.known_lumps: dict[ObjectNode, Lump] = {}
        self.known_vessels: dict[ObjectNode, Vessel] = {}
        self.numbered_lumps: dict[int, Lump] = {}
        self.numbered_vessels: dict[int, Vessel] = {}
        self.taken_whole: dict[str, int] = {}
        self.parts: list[Part] = []

    # --- vessels ---

    def vessel(self, mention: Mention, said: NodeReading, played_step: PlayedStep) -> Vessel:
        """Return the vessel, tool or appliance that an input of the step ``played_step`` is.

        The ``mention`` may number the thing; ``said`` is what its node says. A fresh one is fetched where none there
        can be it.
        """
        if mention.thing is not None:
            return self._numbered_vessel(mention.thing, said, played_step)
        if said.is_appliance:
            return self.appliance(said.label)
        known = self.known_vessels.get(said.node)
        if known is not None and known not in played_step.vessels and self._still_says(known, said):
            return known
        there = [v for v in self.vessels.get(said.label, ()) if v not in played_step.vessels and v.number is None]
        if said.names:
            return self._filled(there, said, played_step)
        return self._empty(there, said, played_step)

    def appliance(self, label: str) -> Vessel:
        """Return the appliance called ``label``: a kitchen has one of each kind."""
        known = self.vessels.get(label)
        return known[0] if known else self.fresh(label)

    def fresh(self, label: str, number: int | None = None) -> Vessel:
        """Return another vessel called ``label`` from the cupboard.

        ``number`` is that of the thing in the tree, if it has one.
        """
        row = self.reader.utensil(label)
        if row is None:  # a food that something lies on, or a place that nobody lists
            row = _PLACE
        vessel = Vessel(label, row, number=number, power={"": True} if label in self.found_on else {})
        self.vessels.setdefault(label, []).append(vessel)
        if number is not None:
            self.numbered_vessels[number] = vessel
        return vessel

    def _numbered_vessel(self, number: int, said: NodeReading, played_step: PlayedStep) -> Vessel:
        vessel = self.numbered_vessels.get(number)
        if vessel is None:
            vessel = self.fresh(said.label, number)
            if said.names:
                self._stock(vessel, said, played_step)
        elif vessel.label != said.label:
            played_step.fault("W2", f"the {vessel.label} has become a {said.label}", said.node)
        elif said.names and not vessel.lumps:
            played_step.fault("W1", f"the {said.label} is empty: its {_names(said.names)} went elsewhere", said.node)
        elif said.names and (missing := _missing(said.names, vessel.names)):
            played_step.fault("W1", f"the {said.label} does not hold {', '.join(missing)}", said.node)
        elif said.empty and vessel.lumps:
            played_step.fault("W1", f"the {said.label} is not empty: it holds {_names(vessel.names)}", said.node)
        return vessel

    def _still_says(self, vessel: Vessel, said: NodeReading) -> bool:
        if said.names:
            return not vessel.names.isdisjoint(said.names)
        return not (said.empty and vessel.lumps)

    def _filled(self, there: list[Vessel], said: NodeReading, played_step: PlayedStep) -> Vessel:
        best = max(there, key=lambda v: (len(said.names & v.names), -len(v.names - said.names), v.last), default=None)
        if best is not None and not said.names.isdisjoint(best.names):
            return best
        emptied = next((v for v in there if not v.lumps and _has_held(v, said.names)), None)
        if emptied is not None and not self._is_storage(said):
            played_step.fault(
                "W1", f"its {_names(said.names & (emptied.had | emptied.held))} was taken out before", said.node
            )
        vessel = self.fresh(said.label)
        self._stock(vessel, said, played_step)
        return vessel

    def _empty(self, there: list[Vessel], said: NodeReading, played_step: PlayedStep) -> Vessel:
        """Return a vessel of which no contents are told: the last used of those where it is told, else a fresh one."""
        placed = [vessel for vessel in there if _stands_as_told(vessel, said)]
        usable = [vessel for vessel in placed if not vessel.lumps] if _has_to_be_clean(said) else placed
        if usable:
            return max(usable, key=lambda vessel: vessel.last)
        if said.empty and said.place:
            _tell_full(placed, said, played_step)
        return self._stand(self.fresh(said.label), said)

    def _stand(self, vessel: Vessel, said: NodeReading) -> Vessel:
        if said.place is not None and said.place_utensil is not None:
            self.stand(vessel, self.holder(said.place))
        return vessel

    def stand(self, vessel: Vessel, where: Vessel | None) -> bool:
        """Let a vessel stand somewhere; nothing stands in itself, or in what stands in it: then it stays."""
        place = where
        while place is not None:
            if place is vessel:
                return False
            place = place.where
        self._move_vessel(vessel, where)
        return True

    def lift(self, vessel: Vessel) -> None:
        """Take a vessel off or out of what it stands on, in or is attached to."""
        self._move_vessel(vessel, None)

    def _move_vessel(self, vessel: Vessel, where: Vessel | None) -> None:
        vessel.where = where
        self.over_heat.pop(vessel, None)
        if where is not None and where.row.source == "heat":
            self.over_heat[vessel] = where

    def burning(self) -> Iterator[Vessel]:
        """Yield the vessels that stand over heat that is on."""
        return (vessel for vessel, source in self.over_heat.items() if source.is_on(vessel.label))

    def holder(self, label: str) -> Vessel:
        """Return what a thing stands on or in, by its label: an appliance, else the last vessel of that name."""
        known = self.vessels.get(label)
        return max(known, key=lambda v: v.last) if known else self.fresh(label)

    def _stock(self, vessel: Vessel, said: NodeReading, played_step: PlayedStep) -> None:
        """Fill a vessel as the kitchen has it: a jar of salt; for any other vessel C6 says that nobody filled it."""
        for name in sorted(said.names):
            played_step.taken += self.name_lump(name, played_step.number, vessel).parts
        self._stand(vessel, said)

    def _is_storage(self, said: NodeReading) -> bool:
        return said.utensil is not None and said.utensil.role == "storage"

    # --- foods ---

    def food(self, mention: Mention, said: NodeReading, played_step: PlayedStep) -> Lump:
        """Return the lump that an input of ``played_step`` is; a new one from the kitchen where none there can be it.

        The ``mention`` may number the thing; ``said`` is what its node says.
        """
        if mention.thing is not None:
            lump = self.numbered_lumps.get(mention.thing)
            if lump is None:
                return self._from_kitchen(said, played_step, mention.thing)
            return self._numbered_lump(lump, said, played_step)
        known = self.known_lumps.get(said.node)
        if known is not None and known not in played_step.inputs and is_still(known, said):
            beside = any(vessel.label == said.place and known not in vessel.lumps for vessel in played_step.vessels)
            if not beside:
                return known
        best = max(self._candidates(said, played_step), key=lambda row: row[0], default=None)
        if best is not None:
            return best[1]
        return self._from_kitchen(said, played_step)

    def _numbered_lump(self, lump: Lump, said: NodeReading, played_step: PlayedStep) -> Lump:
        """Return a lump by its number, and tell what of its node is not so."""
        reason = _why_not(lump, said)
        if reason is not None:
            played_step.fault("W1", reason, said.node)
        for state in said.node.states:
            if state not in lump.states and not self.reader.tables.state(state).sold:
                played_step.fault("K7", f"it is {state}, and nobody made it so", said.node, minor=True)
        return lump

    def _candidates(self, said: NodeReading, played_step: PlayedStep) -> Iterator[tuple[tuple[int, ...], Lump]]:
        """Yield the lumps that a node can be, each with how well it is that one: by place, state and step."""
        there = [vessel.label for vessel in played_step.vessels]
        for lump in self.lumps.get(said.label, ()):
            if lump.gone or lump.number is not None or lump in played_step.inputs or not divides_like(lump, said):
                continue
            place = place_score(said, lump, there, lies_on=self._lies_as_told(said, lump))
            if place == 0:
                continue
            mine, claimed = set(lump.states), set(said.node.states)
            alike = len(claimed & mine) - len(claimed ^ mine)
            inside = any(lump in vessel.lumps for vessel in played_step.vessels)
            yield (place, int(inside), int(lump.label == said.label), alike, lump.last), lump

    def _lies_as_told(self, said: NodeReading, lump: Lump) -> bool | None:
        """Return whether a lump lies on the food that a node names as its place; ``None`` where it names none."""
        if said.place is None or said.place_utensil is not None or not self.reader.tables.foods.is_listed(said.place):
            return None
        return any(lump in under.riders for under in self.lumps.get(said.place, ()) if not under.gone)

    def _from_kitchen(self, said: NodeReading, played_step: PlayedStep, number: int | None = None) -> Lump:
        """Fetch a food. What is undivided is there as often as it was asked; what is divided may be a rest of it."""
        holder = self._holder_of(said, played_step)
        if said.label in self.lumps:
            self._again(said, played_step)
        lump = self.new_lump(said.label, said.node.states, played_step.number, holder, number=number, names=said.names)
        played_step.taken += lump.parts
        if said.undivided and not in_storage(said) and not lump.parts[0].food.is_a("stock"):
            self.taken_whole[said.label] = self.taken_whole.get(said.label, 0) + 1
        return lump

    def _again(self, said: NodeReading, played_step: PlayedStep) -> None:
        """Tell that a food is fetched of which there is no more: it is in finer pieces now, or all of it was taken."""
        facts = self.reader.tables.foods.food(said.label, said.node.states)
        if facts.is_a("stock", "water") or in_storage(said):
            return
        if self._is_all_finer(said):
            played_step.fault("W1", f"none is so any more: {self._fate(said.label)}", said.node)
        elif said.undivided:
            if self._are_all_taken(said.label):
                played_step.fault("W1", f"there is no second {said.label}: {self._fate(said.label)}", said.node)
        elif said.place is not None or said.earns:
            played_step.fault("W1", f"more of it is used than is left: {self._fate(said.label)}", said.node, minor=True)

    def _is_all_finer(self, said: NodeReading) -> bool:
        """Whether all that is there of a food is in finer pieces than a node says, where it says any."""
        left = [lump for lump in self.lumps[said.label] if not lump.gone]
        if not said.fine or not left:
            return False
        return min(lump.fine for lump in left) > said.fine

    def _are_all_taken(self, label: str) -> bool:
        """Whether as many undivided ones of a food were taken as the kitchen has."""
        return self.taken_whole.get(label, 0) >= max(1, self.asked.get(label, 1))

    def _fate(self, label: str) -> str:
        lump = max(self.lumps[label], key=lambda lump: lump.last)
        where = f" in the {lump.where.label}" if lump.where is not None else ""
        state = ", ".join(lump.states) or "used"
        return f"it is {state}{where} since step {lump.last + 1}"

    def _holder_of(self, said: NodeReading, played_step: PlayedStep) -> Vessel | None:
        if said.place is None:
            return None
        inside = next((vessel for vessel in played_step.vessels if vessel.label == said.place), None)
        beside = any(said.label in vessel.names for vessel in played_step.vessels)  # it is scooped in this very step
        if carries(said.place_utensil) and (inside is None or not inside.lumps) and not beside:
            played_step.fault("W2", f"nobody put {said.label} into the {said.place}", said.node)
        return inside or self.fresh(said.place)

    # --- new things ---

    def new_lump(
        self,
        label: str,
        states: tuple[str, ...],
        step: int,
        where: Vessel | None,
        *,
        number: int | None = None,
        names: frozenset[str] = frozenset(),
    ) -> Lump:
        """Return the food ``label``, there from the start, with the history that its ``states`` tell.

        It is ``where`` the step with the number ``step`` finds it. ``number`` is that of the thing in the tree, if it
        has one; ``names`` are the foods that it holds, of which no state is known.
        """
        parts = [self.new_part(label, states, step)]
        held = [self.new_part(name, (), step) for name in sorted(names - {label})]
        for part in held:
            part.unstated = True
        parts += held
        lump = Lump(label, {label}, states, parts, number=number, last=step)
        self.keep(lump, where)
        return lump

    def name_lump(self, name: str, step: int, where: Vessel | None) -> Lump:
        """Return the food ``name`` that only a ``{}`` tells of, ``where`` the step of number ``step`` finds it."""
        lump = self.new_lump(name, (), step, where)
        for part in lump.parts:
            part.unstated = True
        return lump

    def new_part(self, label: str, states: tuple[str, ...], step: int) -> Part:
        """Return a part of the food ``label`` as the step with the number ``step`` takes it from the kitchen.

        Its ``states`` tell what was done to it before.
        """
        rows = [self.reader.tables.state(state) for state in states]
        done = {treatment: -1 for row in rows for treatment in row.earns}
        fine = max((row.fine for row in rows if row.fine is not None), default=0)
        food: Food = self.reader.tables.foods.food(label, states)
        part = Part(food, states, step, done, fine, remains="remains" in done or food.is_a("remains"))
        part.origin = len(self.parts) + 1
        self.parts.append(part)
        return part

    def keep(self, lump: Lump, where: Vessel | None) -> None:
        """Let a lump be found under its names, and stand where it is."""
        called = lump.called
        if called is not lump.filed:
            lump.filed = called
            for name in called:
                found = self.lumps.setdefault(name, [])
                if lump not in found:
                    found.append(lump)
        if lump.number is not None:
            self.numbered_lumps[lump.number] = lump
        self.put(lump, where)

    def put(self, lump: Lump, where: Vessel | None) -> None:
        """Bring a lump to the vessel ``where``, with what lies on it; to no place for ``None``."""
        riders = _riding(lump) if lump.riders else ()
        if lump.where is not None and lump in lump.where.lumps:
            lump.where.lumps.remove(lump)
        lump.where = where
        if where is not None:
            _receive(where, lump)
        for rider in riders:
            if rider.where is not where:
                self.put(rider, where)


def _riding(lump: Lump) -> list[Lump]:
    """Return what lies on a lump and is where it is."""
    return [other for other in lump.riders if not other.gone and other.where is lump.where and other is not lump]


def _receive(vessel: Vessel, lump: Lump) -> None:
    """Let a vessel hold a lump, and remember that it did."""
    vessel.lumps.append(lump)
    vessel.had |= lump.names
    vessel.held.update([part.name for part in lump.parts])
    if carries(vessel.row):
        for part in lump.parts:
            part.spoonful = True


def _stands_as_told(vessel: Vessel, said: NodeReading) -> bool:
    return said.place is None or (vessel.where is not None and vessel.where.label == said.place)


def _has_to_be_clean(said: NodeReading) -> bool:
    """Whether a node speaks of a vessel that is empty, or of a tool: nobody takes up a spoon with something on it."""
    return said.empty or (said.utensil is not None and said.utensil.role == "tool")


def _tell_full(placed: list[Vessel], said: NodeReading, played_step: PlayedStep) -> None:
    """Tell the first of the full vessels on an appliance (W1), which a node says is empty there."""
    full = next((vessel for vessel in placed if vessel.where and vessel.where.is_appliance), None)
    if full is not None:
        played_step.fault("W1", f"it holds {_names(full.names)} there, and is said to be empty", said.node)


def _why_not(lump: Lump, said: NodeReading) -> str | None:
    """Return why a lump cannot be what the node with its number says; ``None`` where it can."""
    if lump.gone:
        return f"this {said.label} was used up before"
    if said.place is not None and lump.where is not None and not same_place(said.place, lump.where):
        return f"it is in the {lump.where.label} and not in the {said.place}"
    if said.undivided and (lump.fine > 0 or (lump.mixed and said.names <= {said.label})):  # or told with its herbs
        return f"it is {', '.join(lump.states) or 'mixed'} by now"
    return None


def _has_held(vessel: Vessel, names: frozenset[str]) -> bool:
    """Whether a vessel once held what a node says: a food by its name, or all the parts of something made."""
    return not names.isdisjoint(vessel.had) or (len(names) > 1 and names <= vessel.held)


def _missing(said: frozenset[str], there: set[str]) -> list[str]:
    """Return the names that are not among those that are there."""
    return [name for name in sorted(said - there) if not is_among(name, there)]


def _names(names: set[str] | frozenset[str]) -> str:
    return ", ".join(sorted(names))
