"""A kitchen in which steps happen: each thing is in one place and one state at a time.

:meth:`World.play` plays one step after another and tells what could not happen (docs/contract.md, W1 to W4).
It goes on after a mishap as if the step had been possible, so that one fault is told once. What an output node forgets
to repeat stays where it was; a new product holds every part that went in.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from foon_kg.food import Tables, singular, tables
from foon_kg.model.tree import Mention, Step
from foon_kg.world import contents, foods, power, steam, treatment, vessels
from foon_kg.world.outcome import Outcome
from foon_kg.world.played_step import PlayedStep
from foon_kg.world.reading import NodeReading, Reader, reader
from foon_kg.world.supply import Supply
from foon_kg.world.things import Vessel


class World:
    """One kitchen during one tree. ``asked`` has each required food as often as it is asked for."""

    def __init__(self, asked: Iterable[str] = (), known: Tables | None = None) -> None:
        names = [singular(name) for name in asked]
        self.tables = known or tables()
        called = frozenset(name for name in names if self.tables.utensil(name) is not None)
        self.reader: Reader = reader(self.tables, called)
        counts: dict[str, int] = {}
        for name in names:
            counts[name] = counts.get(name, 0) + 1
        self.supply = Supply(self.reader, counts)
        self.played_steps: list[PlayedStep] = []

    def play(self, step: Step) -> PlayedStep:
        """Play the next step; what cannot happen stands in its ``mishaps``."""
        played_step = PlayedStep(len(self.played_steps), step, self.tables.motion(step.motion))
        self.played_steps.append(played_step)
        said = played_step.input_readings = [self.reader.read(mention.node) for mention in step.inputs]
        played_step.output_readings = [self.reader.read(mention.node) for mention in step.outputs]
        self._take_vessels(step.inputs, said, played_step)
        self._take_foods(step.inputs, said, played_step)
        power.check_inputs(played_step)
        steam.check_inputs(played_step)
        before = {id(lump): lump.where for vessel in played_step.vessels for lump in vessel.lumps}
        before |= {id(lump): lump.where for lump in played_step.inputs}
        outcome = Outcome(self.supply, played_step, before)
        vessels.match(outcome)
        foods.settle(outcome)
        contents.settle(outcome)
        outcome.remember()
        treatment.apply(self.supply, played_step)
        power.check_outputs(self.supply, played_step)
        played_step.hot = power.hot_vessels(self.supply)
        return played_step

    def _take_vessels(self, mentions: Sequence[Mention], said: Sequence[NodeReading], played_step: PlayedStep) -> None:
        """Find the vessels that go in: those that say most first, so that the order of the inputs decides nothing."""
        places = [place for place, one in enumerate(said) if one.utensil is not None]
        ordered = places
        if len(places) > 1:
            ordered = sorted(places, key=lambda place: (-len(said[place].names), mentions[place].node.sort_key))
        found = {place: self._take_vessel(mentions[place], said[place], played_step) for place in ordered}
        played_step.vessels = [found[place] for place in places]
        played_step.tools = [mentions[place].node for place in places if found[place].row.role in {"tool", "lid"}]

    def _take_vessel(self, mention: Mention, said: NodeReading, played_step: PlayedStep) -> Vessel:
        """Return the vessel that goes in as a mention says, standing where its node says."""
        vessel = self.supply.vessel(mention, said, played_step)
        vessel.last = played_step.number
        played_step.vessels.append(vessel)
        if said.place_utensil is not None and (vessel.where is None or vessel.where.label != said.place):
            self.supply.stand(vessel, self.supply.holder(str(said.place)))
        return vessel

    def _take_foods(self, mentions: Sequence[Mention], said: Sequence[NodeReading], played_step: PlayedStep) -> None:
        for mention, one in zip(mentions, said, strict=True):
            if one.utensil is None:
                lump = self.supply.food(mention, one, played_step)
                lump.last = played_step.number
                played_step.inputs.append(lump)
