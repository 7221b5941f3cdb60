"""What is done with appliances and lids: vessels stand on them or in them, and they are turned on and off."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from foon_kg.integration.bench.handwork import Handwork
from foon_kg.integration.bench.steps import RefusedError
from foon_kg.integration.bench.things import Device, Shown, Vessel, foods_of
from foon_kg.integration.bench.timing import with_water_hot_in_time, without_short_breaks
from foon_kg.integration.teaching.operators import Alike, Attested, Likes, Operators, Way

_LIGHTS = ("light",)

_PLACES = {"on": ("pick-and-place", "place"), "in": ("put inside", "insert", "pick-and-place")}
"""By which motions a vessel comes on or in an appliance."""

_SWITCHED = 0.9
"""How sure it is that what can be turned on can be turned off, though no video shows it."""

_LIKE = 0.8
"""How sure it is that a motion stands for one that it is like: what is boiled can be steamed."""

_ATTACHES = ("attach", "insert", "pick-and-place")


class Bench(Handwork):
    """A kitchen during the making of one dish.

    ``likes`` names the known foods that can stand for one, ``alike`` says how sure that is; foods in ``instead`` are
    to be handled like another one. ``standing`` are the vessels that were heated, by their numbers; ``placed`` those
    that stand at an appliance; ``other_motions`` has, for a thing and a motion that no video does to it, the motion of
    the video that attests it, and how sure that is.
    """

    def __init__(self, operators: Operators, likes: Likes, alike: Alike, instead: Collection[str] = ()) -> None:
        super().__init__(operators, likes, alike, instead)
        self.standing: dict[int, Vessel] = {}
        self.placed: list[Vessel] = []
        self.other_motions: dict[tuple[str, str], tuple[str, float]] = {}

    def declare(self, motion: str, attested: Attested, thing: str) -> None:
        """Declare that ``motion`` is done to ``thing`` where one that it is like is ``attested``."""
        if attested.way[0] != motion:
            self.other_motions[thing, motion] = (attested.way[0], _LIKE)

    # --- on and off it ---

    def place(self, vessel: Vessel, label: str, relation: str) -> Device:
        """Stand a vessel on the appliance ``label``, put it in, or attach it, as ``relation`` says.

        What was emptied there is taken off before.
        """
        device = self.device(label)
        self._clear(device, relation, vessel.label)
        ways = [(motion, ()) for motion in _PLACES.get(relation, _ATTACHES)]
        attested = self.first_with(label, ways, foods_of(vessel))

        def change() -> None:
            vessel.device, vessel.relation = device, relation
            if 0 in device.running and self.has_burners(device):  # the burner that was found on
                device.running.remove(0)
                device.running.add(vessel.number)
                self.standing[vessel.number] = vessel

        self.emit(attested, [vessel, device], change, [vessel, (device, vessel)])
        self.placed.append(vessel)
        return device

    def _clear(self, device: Device, relation: str, label: str) -> None:
        """Take off an appliance what was heated there and is emptied, or waits and is called as what comes, ``label``.

        What waits keeps its burner else: which one is meant is known by what stands there.
        """
        self.placed[:] = [one for one in self.placed if one.device is not None]
        if relation != "on":
            return
        for vessel in list(self.placed):
            if vessel.device is device and vessel.relation == "on" and self._is_done_with(vessel, label):
                self.switch(vessel, device, on=False)
                self.take_off(vessel)

    def _is_done_with(self, vessel: Vessel, label: str) -> bool:
        """Whether a vessel that was heated is emptied, or off the heat in the place of one called ``label``."""
        waits = vessel.label == label and not self.is_running(vessel)
        return vessel.number in self.standing and (not vessel.contents or waits)

    def take_off(self, vessel: Vessel) -> None:
        """Take a vessel off, out of or from its appliance."""
        device = vessel.device
        if device is None:
            return
        attached = vessel.relation == "attached to"
        motions = ("detach", "remove") if attached else ("remove", "take out", "pick-and-place")
        back = ("attach", "insert") if attached else ("put inside", "insert", "place")
        name, attested = self._undone(motions, back, device.label, foods_of(vessel))

        def change() -> None:
            vessel.device, vessel.relation = None, ""

        inside = list(vessel.contents) if vessel.relation == "in" else []
        self.emit(attested, [vessel, (device, vessel), *inside], change, [vessel, *inside, device], motion=name)

    def _undone(
        self, names: Sequence[str], others: Sequence[str], device: str, foods: Sequence[str]
    ) -> tuple[str, Attested]:
        """Return how what was done with an appliance is undone, with the evidence.

        ``names`` are the motions that undo it, ``others`` those that do it. Videos show 49 times that something is
        turned on, and 30 times that it is turned off. So where no video shows it, that it was done, else that something
        is done with the appliance, tells as much: the same hand undoes it. It is declared as a substitution.
        """
        try:
            attested = self.first_with(device, [(name, ()) for name in names], foods)
        except RefusedError:
            attested = self.first_with(device, self._ways_with(device, others), foods)
            self.other_motions[device, names[0]] = (attested.way[0], _SWITCHED)
            return names[0], attested
        return attested.way[0], attested

    def _ways_with(self, device: str, motions: Sequence[str]) -> list[Way]:
        """Return the ways without a tool by one of ``motions``, then all that are done with an appliance."""
        ways = [way for motion in motions for way in self.operators.ways_of(motion) if not way[1]]
        bare = (way for way in self.operators.evidence if not way[1])
        return [*ways, *sorted(way for way in bare if self.operators.works_on(way, device))]

    # --- over another vessel ---

    def stand_over(self, vessel: Vessel, pot: Vessel) -> None:
        """Put a vessel into a pot, above the water of that; raises :class:`RefusedError` where the pot is covered."""
        if pot.lid:
            raise RefusedError(f"the {pot.label} is covered")
        attested = self.first([(motion, ()) for motion in _PLACES["in"]], foods_of(vessel))

        def change() -> None:
            vessel.over = pot

        self.emit(attested, [vessel, pot], change, [vessel, pot])

    def lift_off(self, vessel: Vessel) -> None:
        """Take a vessel out of the pot in which it stands; raises :class:`RefusedError` where that is covered."""
        pot = vessel.over
        if pot is None:
            return
        if pot.lid:
            raise RefusedError(f"the {pot.label} is covered")
        attested = self.first([(motion, ()) for motion in ("remove", "take out", "pick-and-place")], foods_of(vessel))

        def change() -> None:
            vessel.over = None

        self.emit(attested, [vessel, pot, *vessel.contents], change, [vessel, pot, *vessel.contents])

    # --- on and off ---

    def switch(self, vessel: Vessel | None, device: Device, *, on: bool) -> None:
        """Turn the appliance ``device`` on or off, a stove under one vessel."""
        number = vessel.number if vessel is not None and self.has_burners(device) else 0
        if device.always_on or (number in device.running) == on:
            return
        on_names, off_names = ("turn on", *_LIGHTS), ("turn off",)
        names, others = (on_names, off_names) if on else (off_names, on_names)
        name, attested = self._undone(names, others, device.label, ())
        thing: Shown = (device, vessel) if vessel is not None else device
        if vessel is not None:
            self.standing[number] = vessel

        def change() -> None:
            (device.running.add if on else device.running.discard)(number)
            device.found = ()

        self.emit(attested, [thing], change, [thing], motion=name)

    def all_off(self) -> None:
        """Turn off whatever is on."""
        for device in self.devices.values():
            for number in sorted(device.running):
                self.switch(self.standing.get(number), device, on=False)

    def heat_off(self, vessel: Vessel) -> None:
        """Turn off the appliance of a vessel, and take the vessel out of it or off it, unless it stands on a stove."""
        device = vessel.device
        if device is None:
            return
        self.switch(vessel, device, on=False)
        if vessel.relation != "on":
            self.take_off(vessel)
            self.uncover(vessel)

    def put_in_time(self) -> None:
        """Bring the steps that happened in the order in which nothing hot waits, nor is turned off needlessly."""
        self.done[:] = without_short_breaks(with_water_hot_in_time(self.done, self.known), self.known)

    # --- lids ---

    def cover(self, vessel: Vessel, lid: str) -> None:
        """Put a lid on a vessel."""
        attested = self.first([("cover", ()), ("close", ())], foods_of(vessel))

        def change() -> None:
            vessel.lid = lid

        self.emit(attested, [vessel, lid], change, [vessel])

    def uncover(self, vessel: Vessel) -> None:
        """Take the lid off a vessel."""
        if not vessel.lid:
            return
        attested = self.first([("uncover", ()), ("open", ())], foods_of(vessel))

        def change() -> None:
            vessel.lid = ""

        self.emit(attested, [vessel, vessel.lid], change, [vessel])
