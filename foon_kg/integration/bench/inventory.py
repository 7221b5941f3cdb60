"""The things of a kitchen, each under a number of its own, and the nodes that tell how they are now."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from foon_kg.food import Tables
from foon_kg.integration.bench.things import Device, Shown, Stuff, Thing, Vessel, foods_of, is_flat
from foon_kg.model import ObjectNode, shared_node
from foon_kg.world import Mention


class Inventory:
    """The things of a kitchen during the making of one dish.

    ``found_on`` has the states of the appliances, by name, that are on before it.
    """

    def __init__(self, known: Tables) -> None:
        self.known = known
        self.found_on: Mapping[str, tuple[str, ...]] = {}
        self.devices: dict[str, Device] = {}
        self.tools: dict[str, int] = {}
        self._taps: dict[str, Vessel] = {}
        self._numbers = 0

    # --- things ---

    def number(self) -> int:
        """Return the number of a new thing."""
        self._numbers += 1
        return self._numbers

    def vessel(self, label: str, *, storage: bool = False) -> Vessel:
        """Return a clean vessel called ``label`` from the cupboard; one for ``storage`` is what food is sold in."""
        return Vessel(label, self.number(), storage=storage)

    def tap(self, label: str) -> Vessel:
        """Return the tap called ``label``, always the same: a kitchen has one."""
        if label not in self._taps:
            self._taps[label] = self.vessel(label, storage=True)
        return self._taps[label]

    def device(self, label: str) -> Device:
        """Return the appliance called ``label``, always the same: a kitchen has one of each kind."""
        if label not in self.devices:
            row = self.known.utensil(label)
            found = self.found_on.get(label, ())
            running = {0} if found else set()
            always_on = row is not None and row.always_on
            self.devices[label] = Device(label, self.number(), always_on=always_on, running=running, found=found)
        return self.devices[label]

    def fetch(
        self, label: str, states: tuple[str, ...], wants: Iterable[int], storage: str, *, stands: bool = False
    ) -> Stuff:
        """Return the food ``label`` in ``states`` as the kitchen has it, in what it is sold in.

        That is ``storage`` (``""``: it lies free), or, where it ``stands`` there, a vessel in which somebody put it.
        ``wants`` are the numbers of the asked foods that it is for.
        """
        stuff = Stuff(label, self.number(), states, (label,), frozenset(wants))
        row = self.known.utensil(storage) if storage else None
        if row is not None and (row.keeps_food or stands):
            vessel = self.tap(storage) if self._is_tap(storage) else self.vessel(storage, storage=row.keeps_food)
            vessel.contents.append(stuff)
            stuff.at = vessel
        return stuff

    def has_burners(self, device: Device) -> bool:
        """Return whether the appliance ``device`` is turned on for each of its vessels."""
        row = self.known.utensil(device.label)
        return row is not None and row.power == "vessel"

    def is_running(self, vessel: Vessel) -> bool:
        """Return whether the appliance of ``vessel`` is on for it; what stands on none is not heated."""
        if vessel.over is not None:
            return self.is_running(vessel.over)
        device = vessel.device
        if device is None:
            return False
        return device.always_on or (vessel.number if self.has_burners(device) else 0) in device.running

    # --- what nodes say ---

    def mention(self, thing: Thing) -> Mention:
        """Return the node of a thing as it is now, with its number."""
        if isinstance(thing, str):
            return self._tool(thing)
        if isinstance(thing, Device):
            return self._device(thing)
        if isinstance(thing, Vessel):
            return self._vessel(thing)
        return self._stuff(thing)

    def shown(self, thing: Shown) -> Mention:
        """Return the node of a thing, or of an appliance as it is with a vessel."""
        return self._device_with(*thing) if isinstance(thing, tuple) else self.mention(thing)

    def _tool(self, name: str) -> Mention:
        number = self.tools.get(name)
        if number is None:
            number = self.tools[name] = self.number()
        return Mention(shared_node(name), number)

    def _stuff(self, stuff: Stuff) -> Mention:
        if stuff.at is None:
            return Mention(_food(stuff, None, None), stuff.number)
        place = stuff.at.label
        relation = "from" if self._is_tap(place) else "on" if is_flat(place) else "in"
        return Mention(_food(stuff, relation, place), stuff.number, stuff.at.number)

    def _is_tap(self, label: str) -> bool:
        row = self.known.utensil(label)
        return row is not None and row.source == "water"

    def _vessel(self, vessel: Vessel) -> Mention:
        if vessel.storage and self._is_tap(vessel.label):  # water is "from" a tap, and never empties it
            return Mention(shared_node(vessel.label), vessel.number)
        names = foods_of(vessel)
        states = self._states_of(vessel, names)
        under, relation = (vessel.over, "in") if vessel.over is not None else (vessel.device, vessel.relation)
        if under is not None:
            return Mention(shared_node(vessel.label, states, names, relation, under.label), vessel.number, under.number)
        if vessel.lid:
            return Mention(shared_node(vessel.label, states, names, "covered", vessel.lid), vessel.number)
        return Mention(shared_node(vessel.label, states, names), vessel.number)

    @staticmethod
    def _states_of(vessel: Vessel, foods: tuple[str, ...]) -> tuple[str, ...]:
        """Return the states of a vessel with ``foods`` in it; a node has one place only, so a lid may be a state."""
        states: tuple[str, ...] = () if foods or vessel.storage else ("empty",)
        if vessel.hot:
            states += ("hot",)
        if vessel.lid and (vessel.device is not None or vessel.over is not None):
            states += (f"covered [{vessel.lid}]",)
        return states

    def _device(self, device: Device) -> Mention:
        states = device.when_on if device.always_on or device.running else ("off",)
        return Mention(shared_node(device.label, states), device.number)

    def _device_with(self, device: Device, vessel: Vessel) -> Mention:
        running = vessel.number in device.running if self.has_burners(device) else bool(device.running)
        states = device.when_on if device.always_on or running else ("off",)
        if vessel.device is not device:
            return Mention(shared_node(device.label, states), device.number)
        # the node of a vessel says "in [oven]", that of the appliance the same from its side
        relation = "under" if vessel.relation == "on" else "with"
        return Mention(shared_node(device.label, states, (), relation, vessel.label), device.number, vessel.number)


def _food(stuff: Stuff, relation: str | None, container: str | None) -> ObjectNode:
    return shared_node(stuff.label, stuff.states, stuff.foods if stuff.mixed else (), relation, container)
