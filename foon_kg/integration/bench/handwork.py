"""What is done to foods: they are cut, brought from place to place, opened, mixed, heated, left to cool.

A step that cannot happen (food into a covered vessel, over an appliance that is off) raises
:class:`~foon_kg.integration.bench.RefusedError` and leaves the kitchen as it was.
"""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food.lists import word_list
from foon_kg.integration.bench.steps import RefusedError, Steps
from foon_kg.integration.bench.things import Device, Shown, Stuff, Thing, Vessel, is_flat
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.operators import Attested, Way


class Handwork(Steps):
    """A kitchen in which foods are worked on."""

    # --- one food ---

    def act(self, stuff: Stuff, attested: Attested, states: tuple[str, ...], board: str = "") -> None:
        """Work on ``stuff``, one food, by hand as is ``attested``: peel, cut, core it. It has ``states`` then.

        ``board``: what it is worked on, where it lies nowhere yet.
        """
        if stuff.at is not None and stuff.at.storage and board:
            self._unpack(stuff, board)
        if board and stuff.at is None:
            self._act_on(self.vessel(board), stuff, attested, states)
            return

        def change() -> None:
            stuff.states = states

        around = [stuff.at] if stuff.at is not None and not is_flat(stuff.at.label) else []
        # a flat thing under a food says nothing that the food's own node does not say
        self.emit(attested, [stuff, *around], change, [stuff])

    def _act_on(self, board: Vessel, stuff: Stuff, attested: Attested, states: tuple[str, ...]) -> None:
        """Lay one food on a board and work on it there."""

        def change() -> None:
            board.contents.append(stuff)
            stuff.at = board
            stuff.states = states

        self.emit(attested, [stuff, board], change, [stuff, board])

    def _unpack(self, stuff: Stuff, board: str) -> None:
        """Take a food out of what it is sold in: what is in a can or jar comes onto ``board``, or into that.

        Of a packet nothing is told: what is cut lies free in the kitchen.
        """
        store = stuff.at
        if store is None:
            return
        if store.label in word_list("is poured out of its can"):
            runs = form_of(self.known, stuff.label, stuff.states) == "liquid"
            ways: list[Way] = [("pour", ()), ("pick-and-place", ())]
            self.bring([stuff], self.vessel(board), self.require(ways if runs else ways[::-1], stuff.foods))
        else:
            store.contents.remove(stuff)
            stuff.at = None

    def part(
        self, whole: Stuff, labels: Sequence[str], states: tuple[str, ...], attested: Attested, place: str
    ) -> dict[str, Stuff]:
        """Open the food ``whole`` as is ``attested`` into what is called ``labels``, and return these.

        Each has ``states`` then, and lies in a ``place`` of its own.
        """
        store = whole.at
        parts: dict[str, Stuff] = {}
        places: list[Vessel] = []
        for label in labels:
            number = self.number()
            places.append(self.vessel(place))
            parts[label] = Stuff(label, number, states, (label,), whole.wants, places[-1])

        def change() -> None:
            if store is not None:
                store.contents.remove(whole)
            for part, own in zip(parts.values(), places, strict=True):
                own.contents.append(part)

        outputs: list[Thing] = [thing for pair in zip(places, parts.values(), strict=True) for thing in pair]
        self.emit(attested, [*places, *([store] if store is not None else []), whole], change, outputs)
        return parts

    # --- from place to place ---

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
        """Bring ``stuffs``, foods of one place, into or onto ``target`` as is ``attested``.

        They have ``states`` then, if these are given. ``onto`` is what there they are spread on; ``leaves``: the step
        tells what stays behind, too. Raises :class:`RefusedError` where one of them is covered.
        """
        source = stuffs[0].at
        for vessel in filter(None, (target, source)):
            if vessel.lid:
                raise RefusedError(f"the {vessel.label} is covered")

        def change() -> None:
            for stuff in stuffs:
                if source is not None:
                    source.contents.remove(stuff)
                target.contents.append(stuff)
                stuff.at = target
                if states is not None:
                    stuff.states = states

        before: list[Vessel] = [] if source is None else [source]
        # a step that empties a vessel shows it empty; what is left in any other one is as it was
        shows_source = source is not None and not source.storage and (leaves or len(stuffs) == len(source.contents))
        after = before if shows_source else []
        self.emit(attested, [target, *before, *stuffs, *onto], change, [target, *stuffs, *onto, *after])

    def bring_part(self, stuff: Stuff, target: Vessel, attested: Attested) -> Stuff:
        """Bring some of ``stuff``, a food in pieces, to ``target`` as is ``attested`` and return that.

        The rest stays where it is.
        """
        part = Stuff(stuff.label, self.number(), stuff.states, stuff.foods, stuff.wants, target)
        source: list[Thing] = [stuff.at] if stuff.at is not None else []

        def change() -> None:
            target.contents.append(part)

        self.emit(attested, [target, *source, stuff], change, [target, part, stuff])
        return part

    # --- all that is in a vessel ---

    def let_cool(self, vessel: Vessel, stuff: Stuff, foods: Sequence[str]) -> None:
        """Let ``stuff``, one thing of a vessel, cool there, where the FOON shows how ``foods`` do.

        All stay what they are.
        """
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
        extra: Device | None = None,
        motion: str = "",
    ) -> Stuff:
        """Work on all that is in a vessel, which is one thing called ``label`` from then on, and return that.

        It is done as is ``attested`` and has ``states`` then. ``with_device``: what the vessel stands on takes part,
        and has to be on where this heats; ``extra``: so does an appliance that is held in the hand. ``motion`` is what
        is done, where the evidence shows another motion. Raises :class:`RefusedError` where it is off.
        """
        did = motion or attested.way[0]
        under = self.under(vessel)
        heats = bool(under) and not self.known.motion(did).does.isdisjoint({"heat", "warm"})
        devices: list[Shown] = [] if extra is None else [extra]
        if with_device and under:
            devices += under
            if heats and not self.is_running(vessel):
                raise RefusedError(f"what is under the {vessel.label} is off")
        inputs: list[Shown] = [vessel, *devices, *vessel.contents]
        whole = self._as_one(vessel, label, states)

        def change() -> None:
            vessel.contents[:] = [whole]
            whole.states = states
            vessel.hot = did not in word_list("cools") and (vessel.hot or heats)

        self.emit(attested, inputs, change, [vessel, whole, *self.water_under(vessel)], motion=motion)
        return whole

    def under(self, vessel: Vessel) -> list[Shown]:
        """Return what is under a vessel: the appliance, or the vessel over whose water it stands and what that has."""
        if vessel.over is not None:
            return [*self.water_under(vessel), *self.under(vessel.over)]
        return [] if vessel.device is None else [(vessel.device, vessel)]

    @staticmethod
    def water_under(vessel: Vessel) -> list[Shown]:
        """Return the vessel over which a ``vessel`` stands, and its water; nothing for what stands in none."""
        return [] if vessel.over is None else [vessel.over, *vessel.over.contents]

    def _as_one(self, vessel: Vessel, label: str, states: tuple[str, ...]) -> Stuff:
        """Return all that is in a vessel as one thing: what is called so already, and what is alone, stays that.

        It keeps its number then, so that the judge finds the very thing that was asked.
        """
        parts = vessel.contents
        only = parts[0] if len(parts) == 1 else None
        same = next((stuff for stuff in parts if stuff.label == label), only)
        if only is not None and only.label == label:
            return only
        foods = tuple(sorted({food for stuff in parts for food in stuff.foods}))
        wants = frozenset().union(*(stuff.wants for stuff in parts))
        number = self.number() if same is None else same.number
        return Stuff(label, number, states, foods, wants, vessel, mixed=len(foods) > 1)
