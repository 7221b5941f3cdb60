"""The kitchen in which a final tree is built: every step happens to things with an identity, or is refused.

Each method does one kind of step. Before it is applied it is bound to the units of the FOON that attest it; a step that
nothing attests, or that cannot happen (food into a covered vessel, an appliance that is off), raises
:class:`RefusedError` and leaves the kitchen as it was.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, field

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.teaching.operators import Alike, Attested, Likes, Nearness, Operators, Way
from foon_kg.model import ObjectNode, shared_node
from foon_kg.plans.kitchen import Kitchen
from foon_kg.world import Mention, Step

_FLAT = word_list("flat utensils")
_LIGHTS = ("light",)


class RefusedError(Exception):
    """A step cannot happen, or nothing in the FOON attests it."""


@dataclass(eq=False)
class Device:
    """An appliance, and whether it is on (a stove: for each vessel by its number)."""

    label: str
    number: int
    always_on: bool = False
    running: set[int] = field(default_factory=set)


@dataclass(eq=False)
class Vessel:
    """A vessel with what is in or on it. ``device`` is what it stands on, in or is attached to."""

    label: str
    number: int
    contents: list[Stuff] = field(default_factory=list)
    device: Device | None = None
    relation: str = ""
    lid: str = ""
    hot: bool = False
    storage: bool = False


@dataclass(eq=False)
class Stuff:
    """A food in one place. ``foods`` are the names of all foods in it; ``wants`` the numbers of the asked ones.

    ``done`` are the treatments that it had; of a mixture those that all of it had.
    """

    label: str
    number: int
    states: tuple[str, ...]
    foods: tuple[str, ...]
    wants: frozenset[int]
    at: Vessel | None = None
    mixed: bool = False


@dataclass(frozen=True)
class Done:
    """A step that happened, with its evidence and phase."""

    step: Step
    attested: Attested
    phase: str


_BRINGS = frozenset({"coat", "fetch", "move", "scatter"})

Thing = Device | Vessel | Stuff | str


class Bench:
    """A kitchen during the making of one dish. ``likes`` names the known foods that can stand for one."""

    def __init__(
        self,
        operators: Operators,
        likes: Likes,
        alike: Alike,
        kitchen: Kitchen | None = None,
        instead: Collection[str] = (),
    ) -> None:
        self.operators = operators
        self.kitchen = kitchen or Kitchen.default()
        self.alike = alike
        self.instead = instead
        self.known: Tables = operators.known
        self.likes = likes
        self.done: list[Done] = []
        self.phase = "prepare"
        self.devices: dict[str, Device] = {}
        self.tools: dict[str, int] = {}
        self.standing: dict[int, Vessel] = {}
        self.placed: list[Vessel] = []
        self.other_motions: dict[tuple[str, str], str] = {}
        self._numbers = 0

    # --- things ---

    def number(self) -> int:
        """Return the number of a new thing."""
        self._numbers += 1
        return self._numbers

    def vessel(self, label: str, *, storage: bool = False) -> Vessel:
        """Return a clean vessel from the cupboard."""
        return Vessel(label, self.number(), storage=storage)

    def device(self, label: str) -> Device:
        """Return the appliance called ``label``: a kitchen has one."""
        if label not in self.devices:
            row = self.known.utensil(label)
            self.devices[label] = Device(label, self.number(), always_on=row is not None and row.always_on)
        return self.devices[label]

    def fetch(self, label: str, states: tuple[str, ...], wants: Iterable[int], storage: str) -> Stuff:
        """Return a food as the kitchen has it, in what it is sold in (``""``: lying free)."""
        stuff = Stuff(label, self.number(), states, (label,), frozenset(wants))
        row = self.known.utensil(storage) if storage else None
        if row is not None and row.keeps_food:
            vessel = self.vessel(storage, storage=True)
            vessel.contents.append(stuff)
            stuff.at = vessel
        return stuff

    # --- what nodes say ---

    def mention(self, thing: Thing) -> Mention:
        """Return the node of a thing as it is now, with its number."""
        if isinstance(thing, str):
            number = self.tools.get(thing)
            if number is None:
                number = self.tools[thing] = self.number()
            return Mention(shared_node(thing), number)
        if isinstance(thing, Device):
            return self._device(thing, None)
        if isinstance(thing, Vessel):
            return self._vessel(thing)
        if thing.at is None:
            return Mention(self._food(thing, None, None), thing.number)
        row = self.known.utensil(thing.at.label)
        if row is not None and row.source == "water":
            return Mention(self._food(thing, "from", thing.at.label), thing.number, thing.at.number)
        relation = "on" if is_flat(thing.at.label) else "in"
        return Mention(self._food(thing, relation, thing.at.label), thing.number, thing.at.number)

    def _food(self, thing: Stuff, relation: str | None, container: str | None) -> ObjectNode:
        names = thing.foods if thing.mixed else ()
        return shared_node(thing.label, thing.states, names, relation, container)

    def _vessel(self, thing: Vessel) -> Mention:
        row = self.known.utensil(thing.label)
        if thing.storage and row is not None and row.source == "water":
            return Mention(shared_node(thing.label), thing.number)
        names = foods_of(thing)
        states: tuple[str, ...] = () if names or thing.storage else ("empty",)
        if thing.hot:
            states += ("hot",)
        if thing.lid and thing.device is not None:
            states += (f"covered [{thing.lid}]",)
        if thing.device is not None:
            return Mention(
                shared_node(thing.label, states, names, thing.relation, thing.device.label),
                thing.number, thing.device.number,
            )  # fmt: skip
        if thing.lid:
            return Mention(shared_node(thing.label, states, names, "covered", thing.lid), thing.number)
        return Mention(shared_node(thing.label, states, names), thing.number)

    def _device(self, thing: Device, vessel: Vessel | None) -> Mention:
        on = thing.always_on or (
            vessel.number in thing.running if vessel and self._burners(thing) else bool(thing.running)
        )
        states = ("on",) if on else ("off",)
        if vessel is None or vessel.device is not thing:
            return Mention(shared_node(thing.label, states), thing.number)
        relation = "under" if vessel.relation == "on" else "with"
        return Mention(shared_node(thing.label, states, (), relation, vessel.label), thing.number, vessel.number)

    def _burners(self, thing: Device) -> bool:
        row = self.known.utensil(thing.label)
        return row is not None and row.power == "vessel"

    # --- evidence ---

    def attest(self, ways: Iterable[Way], foods: Sequence[str], *, act: bool = False) -> Attested | None:
        """Return the nearest evidence among ``ways``; of equally near ones the first way's."""
        best: Attested | None = None
        for way in ways:
            found = self.operators.attested(way, foods, self.likes, act=act, instead=self.instead)
            if found is not None and (best is None or found.nearness < best.nearness):
                best = found
                if best.nearness is Nearness.FOOD:
                    return best
        return best

    def require(self, ways: Iterable[Way], foods: Sequence[str], *, act: bool = False) -> Attested:
        """Return :meth:`attest`, or raise :class:`RefusedError`."""
        ways = list(ways)
        found = self.attest(ways, foods, act=act) or self.far(ways, foods, act=act)
        if found is None:
            told = ", ".join(way[0] for way in ways[:3]) or "it"
            raise RefusedError(f"no unit of this FOON does “{told}” to {', '.join(foods) or 'nothing'} or its like")
        return found

    def first(self, ways: Iterable[Way], foods: Sequence[str]) -> Attested:
        """Return the evidence for the first way that has any; raises :class:`RefusedError`."""
        ways = list(ways)
        for way in ways:
            found = self.attest([way], foods) or self.far([way], foods)
            if found is not None:
                return found
        return self.require(ways, foods)

    def far(self, ways: Iterable[Way], foods: Sequence[str], *, act: bool = False) -> Attested | None:
        """Return the evidence by the likest food of all, for what nothing nearer attests.

        Where none is like it at all the way decides, and not which food is least unlike.
        """
        found = (self.operators.farthest(way, foods, self.alike, act=act) for way in ways)
        return max(
            (one for one in found if one is not None), key=lambda one: one.like[2] if one.like else 0.0, default=None
        )

    # --- steps ---

    def emit(
        self,
        attested: Attested,
        inputs: Sequence[Thing | tuple[Device, Vessel]],
        change: Callable[[], None],
        outputs: Sequence[Thing | tuple[Device, Vessel]],
        *,
        motion: str = "",
    ) -> None:
        """Let one step happen: the nodes of ``inputs`` before and of ``outputs`` after ``change``.

        ``motion`` is what is done, where the evidence shows another motion.
        """
        before = [self._told(thing) for thing in inputs]
        before += [self.mention(tool) for tool in attested.way[1]]
        change()
        after = [self._told(thing) for thing in outputs]
        step = Step(tuple(dict.fromkeys(before)), motion or attested.way[0], tuple(dict.fromkeys(after)))
        if set(step.outputs) <= set(step.inputs):
            return  # it changes nothing
        self.done.append(Done(step, attested, self.phase))

    def _told(self, thing: Thing | tuple[Device, Vessel]) -> Mention:
        return self._device(*thing) if isinstance(thing, tuple) else self.mention(thing)

    def act(self, stuff: Stuff, attested: Attested, states: tuple[str, ...], board: str = "") -> None:
        """Work on one food by hand: peel, cut, core it. ``board``: what it is worked on, where it lies nowhere yet."""
        if stuff.at is not None and stuff.at.storage and board:
            self._take_out(stuff)
        if board and stuff.at is None:
            place = self.vessel(board)

            def cut() -> None:
                place.contents.append(stuff)
                stuff.at = place
                stuff.states = states

            self.emit(attested, [stuff, place], cut, [stuff, place])
            return

        def change() -> None:
            stuff.states = states

        self.emit(attested, [stuff, *self._around(stuff)], change, [stuff])

    def _around(self, stuff: Stuff) -> list[Thing]:
        return [stuff.at] if stuff.at is not None and not is_flat(stuff.at.label) else []

    def _take_out(self, stuff: Stuff) -> None:
        """Forget the packet that a food is sold in: what is cut lies free in the kitchen."""
        if stuff.at is not None:
            stuff.at.contents.remove(stuff)
            stuff.at = None

    def bring(
        self,
        stuffs: Sequence[Stuff],
        target: Vessel,
        attested: Attested,
        states: tuple[str, ...] | None = None,
        *,
        onto: Sequence[Stuff] = (),
        leaves: bool = False,
    ) -> None:
        """Bring foods of one place into or onto ``target``; ``onto`` is what there they are spread on.

        ``leaves``: the step tells what stays behind, too.
        """
        if target.lid:
            raise RefusedError(f"the {target.label} is covered")
        source = stuffs[0].at
        if source is not None and source.lid:
            raise RefusedError(f"the {source.label} is covered")
        inputs: list[Thing] = [target, *([source] if source is not None else []), *stuffs, *onto]

        def change() -> None:
            for stuff in stuffs:
                if source is not None:
                    source.contents.remove(stuff)
                target.contents.append(stuff)
                stuff.at = target
                if states is not None:
                    stuff.states = states

        outputs: list[Thing] = [target, *stuffs, *onto]
        if source is not None and not source.storage and (leaves or len(stuffs) == len(source.contents)):
            source_out: list[Thing] = [source]
        else:
            source_out = []
        self.emit(attested, inputs, change, [*outputs, *source_out])

    def bring_part(self, stuff: Stuff, target: Vessel, attested: Attested) -> Stuff:
        """Bring some of a food that is in pieces to ``target`` and return that; the rest stays where it is."""
        part = Stuff(stuff.label, self.number(), stuff.states, stuff.foods, stuff.wants, target)
        source: list[Thing] = [stuff.at] if stuff.at is not None else []

        def change() -> None:
            target.contents.append(part)

        self.emit(attested, [target, *source, stuff], change, [target, part, stuff])
        return part

    def part(
        self, whole: Stuff, labels: Sequence[str], states: tuple[str, ...], attested: Attested, place: str
    ) -> dict[str, Stuff]:
        """Open a food that comes apart into what is called ``labels``, each in a ``place`` of its own; return these."""
        store = whole.at
        parts = {
            label: Stuff(label, self.number(), states, (label,), whole.wants, self.vessel(place)) for label in labels
        }
        places = [part.at for part in parts.values() if part.at is not None]

        def change() -> None:
            if store is not None:
                store.contents.remove(whole)
            for part in parts.values():
                if part.at is not None:
                    part.at.contents.append(part)

        outputs: list[Thing] = [thing for pair in zip(places, parts.values(), strict=True) for thing in pair]
        self.emit(attested, [*places, *([store] if store is not None else []), whole], change, outputs)
        return parts

    def cooling(self, foods: Sequence[str]) -> Attested | None:
        """Return the evidence of how foods cool by themselves."""
        ways = [way for motion in sorted(word_list("cools")) for way in self.operators.ways_of(motion) if not way[1]]
        return self.attest(ways, foods) or self.far(ways, foods)

    def let_cool(self, vessel: Vessel, stuff: Stuff, foods: Sequence[str]) -> None:
        """Let one thing of a vessel cool there, where the FOON shows how ``foods`` do; all stay what they are."""
        attested = self.cooling(foods)
        if attested is None:
            return

        def change() -> None:
            stuff.states = tuple(sorted({*stuff.states, "cooled"}))
            vessel.hot = False

        self.emit(attested, [vessel, *vessel.contents], change, [vessel, *vessel.contents])

    def work(
        self,
        vessel: Vessel,
        attested: Attested,
        label: str,
        states: tuple[str, ...],
        *,
        with_device: bool = True,
        mixes: bool = True,
        extra: Device | None = None,
    ) -> Stuff:
        """Work on all that is in a vessel; what is mixed is one thing from then on, called ``label``."""
        inputs: list[Thing | tuple[Device, Vessel]] = [vessel, *vessel.contents]
        device = vessel.device
        if with_device and device is not None:
            inputs.insert(1, (device, vessel))
        if extra is not None:
            inputs.insert(1, extra)
        parts = list(vessel.contents)
        heats = not self.known.motion(attested.way[0]).does.isdisjoint({"heat", "warm"})
        cools = attested.way[0] in word_list("cools")
        if heats and with_device and device is not None and not self.is_running(vessel):
            raise RefusedError(f"the {device.label} under the {vessel.label} is off")
        same = next((stuff for stuff in parts if stuff.label == label), None)
        if len(parts) == 1 and same is not None:
            whole = same
        elif mixes:
            foods = tuple(sorted({food for stuff in parts for food in stuff.foods}))
            wants = frozenset().union(*(stuff.wants for stuff in parts))
            same = same or (parts[0] if len(parts) == 1 else None)
            number = self.number() if same is None else same.number
            whole = Stuff(label, number, states, foods, wants, vessel, mixed=len(foods) > 1)
        else:
            whole = parts[0]

        def change() -> None:
            if mixes:
                vessel.contents[:] = [whole]
            whole.states = states
            vessel.hot = not cools and (vessel.hot or (heats and device is not None))

        outputs: list[Thing] = [vessel, whole] if mixes else [vessel, *parts]
        self.emit(attested, inputs, change, outputs)
        return whole

    # --- appliances ---

    def place(self, vessel: Vessel, label: str, relation: str) -> Device:
        """Stand a vessel on an appliance, put it in, or attach it; what is done with the heat is taken off before."""
        device = self.device(label)
        self._clear(device, relation)
        motions = {"on": ("pick-and-place", "place"), "in": ("put inside", "insert", "pick-and-place")}
        ways = [(motion, ()) for motion in motions.get(relation, ("attach", "insert", "pick-and-place"))]
        attested = self.first(ways, foods_of(vessel))

        def change() -> None:
            vessel.device, vessel.relation = device, relation

        self.emit(attested, [vessel, device], change, [vessel, (device, vessel)])
        self.placed.append(vessel)
        return device

    def _clear(self, device: Device, relation: str) -> None:
        """Take off an appliance what was heated there, and is emptied or off the heat."""
        self.placed[:] = [one for one in self.placed if one.device is not None]
        for one in [one for one in self.placed if one.device is device and one.relation == relation == "on"]:
            if one.hot and (not one.contents or not self.is_running(one)):
                self.switch(one, device, on=False)
                self.take_off(one)

    def take_off(self, vessel: Vessel) -> None:
        """Take a vessel off, out of or from its appliance."""
        device = vessel.device
        if device is None:
            return
        motions = ("detach", "remove") if vessel.relation == "attached to" else ("remove", "take out", "pick-and-place")
        back = ("attach", "insert") if vessel.relation == "attached to" else ("put inside", "insert", "place")
        name, attested = self._undone(motions, back, device.label, foods_of(vessel))

        def change() -> None:
            vessel.device, vessel.relation = None, ""

        inside = list(vessel.contents) if vessel.relation == "in" else []
        self.emit(attested, [vessel, (device, vessel), *inside], change, [vessel, *inside, device], motion=name)

    def _undone(
        self, names: Sequence[str], others: Sequence[str], device: str, foods: Sequence[str]
    ) -> tuple[str, Attested]:
        """Return how what was done with an appliance is undone, with the evidence.

        Where no video shows it, that it was done, else that something is done with the appliance, tells as much: the
        same hand undoes it.
        """
        try:
            attested = self.first([(name, ()) for name in names], foods)
        except RefusedError:
            ways = [way for other in others for way in self.operators.ways_of(other) if not way[1]]
            ways += sorted(
                way for way in self.operators.evidence if not way[1] and self.operators.works_on(way, device)
            )
            attested = self.require(ways, foods)
            self.other_motions[device, names[0]] = attested.way[0]
            return names[0], attested
        return attested.way[0], attested

    def switch(self, vessel: Vessel | None, device: Device, *, on: bool) -> None:
        """Turn an appliance on or off, a stove under one vessel."""
        if device.always_on:
            return
        number = vessel.number if vessel is not None and self._burners(device) else 0
        if (number in device.running) == on:
            return
        on_names, off_names = ("turn on", *_LIGHTS), ("turn off",)
        names, others = (on_names, off_names) if on else (off_names, on_names)
        name, attested = self._undone(names, others, device.label, ())
        thing: Thing | tuple[Device, Vessel] = (device, vessel) if vessel is not None else device
        if vessel is not None:
            self.standing[number] = vessel

        def change() -> None:
            (device.running.add if on else device.running.discard)(number)

        self.emit(attested, [thing], change, [thing], motion=name)

    def forget_short_breaks(self) -> None:
        """Leave an appliance on where it was turned off and on again while food only came into its vessel."""
        kept: list[Done] = []
        for done in self.done:
            place = self._off_before(kept, done) if done.step.motion != "turn off" else None
            if place is None:
                kept.append(done)
            else:
                del kept[place]
        self.done[:] = kept

    def _off_before(self, before: Sequence[Done], done: Done) -> int | None:
        """Return the place of the step that turned off what ``done`` turns on, with nothing but such steps since."""
        if len(done.step.inputs) != 1 or len(done.step.outputs) != 1:
            return None
        (off,), (on,) = done.step.inputs, done.step.outputs
        for place in range(len(before) - 1, -1, -1):
            step = before[place].step
            if step.inputs == (on,) and step.outputs == (off,):
                return place
            into = any(mention.thing == off.container_thing for mention in step.outputs)
            if not into or not self.known.motion(step.motion).does <= _BRINGS:
                return None
        return None

    def is_running(self, vessel: Vessel) -> bool:
        """Whether the appliance of a vessel is on for it."""
        device = vessel.device
        if device is None:
            return False
        return device.always_on or (vessel.number if self._burners(device) else 0) in device.running

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


def is_flat(label: str) -> bool:
    """Whether things lie on it and not in it."""
    return label.rpartition(" ")[2] in _FLAT


def foods_of(vessel: Vessel) -> tuple[str, ...]:
    """Return the names of all foods in a vessel."""
    return tuple(dict.fromkeys(food for stuff in vessel.contents for food in stuff.foods))
