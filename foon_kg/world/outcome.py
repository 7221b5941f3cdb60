"""What comes out of one step: which thing each output is, and what all of its outputs share while that is told."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from foon_kg.model import ObjectNode
from foon_kg.world.played_step import PlayedStep
from foon_kg.world.reading import NodeReading
from foon_kg.world.supply import Supply
from foon_kg.world.things import Lump, Vessel

JOINS = ("mix", "blend", "mash", "knead", "whip", "grind", "shape", "coat")
"""Motions that make one thing of several."""

WORKS = (*JOINS, "heat", "warm", "wait", "liquid", "dry", "fat")
"""Motions that work on all that is in a vessel."""


class Outcome:
    """The outputs of one step while they are matched with things.

    ``before`` says where each lump was. ``vessel_of`` has the vessel of each output that is one, by its place among the
    outputs; ``mapped`` the lumps (by identity) that some output is, and so are not moved again.
    """

    def __init__(self, supply: Supply, played_step: PlayedStep, before: dict[int, Vessel | None]) -> None:
        self.supply = supply
        self.tables = supply.reader.tables
        self.played_step = played_step
        self.before = before
        self.mentions = played_step.step.outputs
        self.said = played_step.output_readings
        self.vessel_of: dict[int, Vessel] = {}
        self.mapped: set[int] = set()
        self.brought = self.names_brought()

    def names_brought(self) -> set[str]:
        """Return the names of all foods that went in, and of their parts."""
        return set().union(*(lump.called for lump in self.lumps()))

    @cached_property
    def labels(self) -> frozenset[str]:
        """What the outputs are called."""
        return frozenset(one.label for one in self.said)

    @cached_property
    def food_labels(self) -> frozenset[str]:
        """What those outputs are called that are food: what has an output of its own goes up in no other."""
        return frozenset(one.label for one in self.said if one.is_food)

    def lumps(self) -> list[Lump]:
        """Return the foods that went in, those first that are inputs, then what their vessels hold."""
        found = list(self.played_step.inputs)
        found += [rider for lump in found for rider in lump.riders if not rider.gone and rider not in found]
        found += [lump for vessel in self.played_step.vessels for lump in vessel.lumps if lump not in found]
        return found

    def holders(self) -> Iterable[Vessel]:
        """Yield what the inputs stand in, on or are attached to."""
        for lump in self.played_step.inputs:
            place = self.before.get(id(lump), lump.where)
            if place is not None:
                yield from place.stack()
        for vessel in self.played_step.vessels:
            if vessel.where is not None:
                yield from vessel.where.stack()

    def standing(self) -> Iterable[Vessel]:
        """Yield what stands on or in an input: taking a tray out of the oven names the oven only."""
        for vessels in self.supply.vessels.values():
            for vessel in vessels:
                if vessel.where is not None and vessel.where in self.played_step.vessels:
                    yield vessel

    def leave_rest(self, lump: Lump) -> None:
        """Leave some of ``lump`` in the vessel it is taken from if it is a stock food (salt, oil, flour).

        Nothing is left where the vessel is told empty, and nothing on a place or in an appliance.
        """
        vessel = lump.where
        if vessel is None or not (self._is_stock(lump) or self._is_portioned(lump)):
            return
        emptied = any(v is vessel and self.said[place].empty for place, v in self.vessel_of.items())
        if emptied or vessel.row.role in {"place", "appliance"}:
            return
        parts = [part.copy() for part in lump.parts]
        rest = Lump(lump.label, set(lump.names), lump.states, parts, last=self.played_step.number, made=lump.made)
        self.supply.keep(rest, vessel)
        self.before[id(rest)] = vessel

    def _is_stock(self, lump: Lump) -> bool:
        return not lump.mixed and any(part.food.is_a("stock", "water") for part in lump.parts)

    def _is_portioned(self, lump: Lump) -> bool:
        """Whether a step takes some of a food in pieces: it scoops it, strews it, or lays it on another food."""
        on_food = any(one.label in lump.names and one.place and one.place_utensil is None for one in self.said)
        return (lump.mixed or lump.fine > 0) and (on_food or self.played_step.does("scatter"))

    def tell_missing(self, name: str, node: ObjectNode) -> None:
        """Tell that ``node`` holds an ingredient ``name`` that is in no input (W2)."""
        facts = self.tables.foods.food(name)
        minor = facts.is_a("water", "spice", "herb", "fat", "sweet", "leaven", "salt")
        minor = minor or any(part.food.kind == facts.kind for lump in self.lumps() for part in lump.parts)
        self.played_step.fault("W2", f"it holds {name}, which did not go in", node, minor=minor)

    def consume(self, lump: Lump, product: Lump) -> None:
        """Let ``lump`` go up in ``product``, which is called as it was too where somebody made it."""
        lump.gone = True
        self.supply.put(lump, None)
        if lump.made:
            product.call(lump.names)
        self.mapped.add(id(lump))

    def remember(self) -> None:
        """Keep which thing each output node is, and what moved."""
        for node, lump in self.played_step.outputs.items():
            self.supply.known_lumps[node] = lump
        for place, vessel in self.vessel_of.items():
            self.supply.known_vessels[self.mentions[place].node] = vessel
            if vessel not in self.played_step.vessels:
                self.played_step.vessels.append(vessel)
            vessel.last = self.played_step.number
        self._note_moves()
        self._note_emptied()

    def _note_moves(self) -> None:
        """Keep what came to another place. What was made of foods where they were has not moved, nor have they."""
        origins: set[Vessel | None] = set()
        for lump in self.lumps():
            old = self.before.get(id(lump), lump.where)
            spent = lump.gone and id(lump) in self.before
            if spent:
                origins.add(old)
            if (spent or lump.where is not old) and not self.played_step.is_made_of(lump, old):
                self.played_step.moved.append((lump, old, lump.where))
        self._note_products(origins)

    def _note_products(self, origins: set[Vessel | None]) -> None:
        """Keep as moved what was made of foods from ``origins``, unless it is where all of them were."""
        for product in self.played_step.made:
            if origins != {product.where}:
                self.played_step.moved.append((product, None, product.where))

    def _note_emptied(self) -> None:
        places = dict.fromkeys(old for _, old, _ in self.played_step.moved if old is not None)
        self.played_step.emptied = [vessel for vessel in places if not vessel.lumps]

    def is_liquid(self, one: NodeReading) -> bool:
        """Return whether ``one``, a food output, is a liquid in the state that it says."""
        return self.tables.foods.food(one.label, one.node.states).is_a("liquid")
