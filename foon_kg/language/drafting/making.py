"""One drafted unit: what goes in and comes out, in the scene as it is; and the units that nobody tells.

A food that is elsewhere must have come to where it is changed, and an appliance that heats must have been turned on.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.food.rows import Motion
from foon_kg.language.drafting.evidence import IMPLIED, Evidence
from foon_kg.language.drafting.nodes import NodeDrafter
from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.language.drafting.scene import Scene, filled
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Timing
from foon_kg.model.drafts import DraftUnit
from foon_kg.model.narration import NarratedAction

_READY = word_list("is made ready for the oven")
TURN_ON, TURN_OFF = "turn on", "turn off"


@dataclass(frozen=True)
class OfNodes:
    """What drafts with ``nodes``, and reaches through them what the FOON knows and how everything is."""

    nodes: NodeDrafter

    @property
    def precedents(self) -> FoonPrecedents:
        """What the FOON knows of such actions."""
        return self.nodes.precedents

    @property
    def scene(self) -> Scene:
        """Where and how everything is by now."""
        return self.nodes.scene


@dataclass(frozen=True)
class Maker(OfNodes):
    """Makes units of ``nodes``, and changes their scene as these units do."""

    def unit(
        self,
        action: NarratedAction,
        motion: str,
        inputs: Sequence[ObjectNode],
        outputs: Sequence[ObjectNode],
        evidence: Evidence,
    ) -> DraftUnit:
        """Return the unit of an ``action``: its ``motion``, ``inputs``, ``outputs`` and the ``evidence`` for them.

        The scene is then as the unit leaves it.
        """
        self.scene.keep(outputs)
        sides = [tuple(map(Participant, dict.fromkeys(side))) for side in (inputs, outputs)]
        unit = FunctionalUnit(sides[0], motion, sides[1])
        for node in outputs:
            if not self.precedents.kitchen.is_utensil(node.label):
                self.scene.sure[node.label] = evidence.states
        doubts = tuple(dict.fromkeys(evidence.doubts))
        return DraftUnit(Annotation(unit, action.timing), evidence.product(), doubts, action.said)

    def moved(self, foods: Sequence[str], at: str, action: NarratedAction) -> list[DraftUnit]:
        """Return the units that nobody told, by which ``foods`` come to ``at``, where ``action`` changes them."""
        known = [self.scene.foods[food] for food in foods if food in self.scene.foods]
        known = [node for node in known if at not in {node.container, node.label}]
        if not known:
            return []
        motion = self.precedents.bringing(known[0].label)
        named = ", ".join(node.label for node in known)
        evidence = Evidence(
            [IMPLIED], [f"nobody says how {named} {'comes' if len(known) == 1 else 'come'} to the {at}"]
        )
        into = self.nodes.vessel(at)
        left, gone = self.nodes.sources(known)
        relation = self.precedents.relation(at)
        after = [ObjectNode(one.label, one.states, one.ingredients, relation, at) for one in known]
        quiet = NarratedAction(motion, said=action.said, timing=Timing(assumed=True))
        self.scene.focus = at
        held = filled(into, [node.label for node in known])
        return [self.unit(quiet, motion, [into, *left, *known], [held, *after, *gone], evidence)]

    def source_of(self, action: NarratedAction, motion: str) -> str | None:
        """Return the appliance that gives the ``motion`` of ``action`` its heat or cold; ``None`` where it needs none.

        It is the one that is told, else one that is on, else the usual one.
        """
        known = tables().motion(motion)
        if known.source not in {"heat", "cold"} or not _works_on_food(known):
            return None
        for name in action.instruments:
            if _gives(name, known.source):
                return name
        running = [node.label for node in self.scene.utensils.values() if self.precedents.kitchen.is_running(node)]
        usual = sorted(_usual_appliances(known))
        return next((name for name in running if name in usual and _gives(name, known.source)), usual[0])

    def lit(self, appliance: str, action: NarratedAction) -> list[DraftUnit]:
        """Return the unit that nobody told before ``action``: an ``appliance`` that heats must have been turned on."""
        row, node = tables().utensil(appliance), self.nodes.vessel(appliance)
        if row is None or row.source != "heat" or self.precedents.kitchen.is_running(node):
            return []
        quiet = NarratedAction(TURN_ON, said=action.said, timing=Timing(assumed=True))
        after = ObjectNode(appliance, ("on",), node.ingredients, node.relation, node.container)
        doubt = f"nobody says that the {appliance} is turned on"
        return [self.unit(quiet, TURN_ON, [node], [after], Evidence([IMPLIED], [doubt]))]

    def cooks_in(self, at: str | None, source: str, motion: str) -> bool:
        """Return whether food can be heated by ``motion`` in the vessel ``at``, by the appliance ``source``."""
        row, heater = tables().utensil(at or ""), tables().utensil(source)
        if at is None or row is None:
            return False
        ready = at in self.scene.utensils and not _READY.isdisjoint(self.scene.utensils[at].states)
        if ready and "dry" in tables().motion(motion).does:
            return True
        if heater is not None and "microwave" in heater.group:
            return "microwave" in row.can
        return not row.can.isdisjoint({"bake"} if "dry" in tables().motion(motion).does else {"cook", "heat"})


def _gives(utensil: str, source: str) -> bool:
    """Whether heat or cold (``source``) comes from a utensil."""
    row = tables().utensil(utensil)
    return row is not None and row.source == source


def _works_on_food(motion: Motion) -> bool:
    """Whether a motion needs its heat or cold for food: to turn an oven on needs no other one."""
    return bool(motion.does - {"switch on"})


def _usual_appliances(motion: Motion) -> frozenset[str]:
    """Return the appliances of which a cook takes one for a motion where nobody says which."""
    if motion.source == "cold":
        return word_list("chills")
    return word_list("bakes" if "dry" in motion.does else "cooks")
