"""Units that bring food from where it is into a vessel, or onto other food."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from foon_kg.food import motions
from foon_kg.language.drafting.evidence import Evidence
from foon_kg.language.drafting.making import Maker
from foon_kg.language.drafting.precedents import Precedents
from foon_kg.language.drafting.scene import filled
from foon_kg.language.drafting.told_states import done, with_state
from foon_kg.model import ObjectNode
from foon_kg.model.drafts import DraftUnit
from foon_kg.model.narration import Mention, NarratedAction


@dataclass(frozen=True)
class Bringing:
    """Drafts units that bring."""

    maker: Maker

    def units(
        self, action: NarratedAction, mention: Mention, motion: str, like: Precedents, evidence: Evidence
    ) -> list[DraftUnit]:
        """Return the unit that brings one food (``mention``) by ``motion``; none where nobody knows where to.

        ``like`` is what the FOON knows of such actions, ``evidence`` weighs what is guessed.
        """
        nodes, scene = self.maker.nodes, self.maker.scene
        told = nodes.utensil_place(action)
        before = nodes.there(mention, like, evidence, away_from=told, brought=True)
        target = nodes.target(action, mention, like, before, evidence)
        tools = nodes.tools(action, like, [target or "", before.container or ""])
        left, gone = nodes.sources([before]) if before.container != target else ([], [])
        if target is None and before.container in _containers(like):
            target = before.container  # thrown away once more
        if target is not None and target == before.container:
            into = nodes.vessel(target)
            return [self.maker.unit(action, motion, [into, before], [into, before], evidence)]
        inputs = [*left, before, *tools]
        if target is None:
            after = replace(before, relation=None, container=None)
            return [self.maker.unit(action, motion, inputs, [*gone, after], evidence)]
        if target in scene.foods:
            return [self.maker.unit(action, motion, *self._onto(target, [before, *left, *tools], gone), evidence)]
        scene.focus = target
        after = self._brought(before, target, action, motion)
        into = nodes.vessel(target)
        outputs = [filled(into, [mention.name]), after, *gone]
        return [self.maker.unit(action, motion, [into, *inputs], outputs, evidence)]

    def _brought(self, food: ObjectNode, target: str, action: NarratedAction, motion: str) -> ObjectNode:
        """Return a food in the utensil ``target``, changed where the motion does more than bring: sifted into it."""
        told = None if motions.transfers(motion) else done(action.verb)
        states = food.states if told is None else with_state(food.states, told)
        return replace(food, states=states, relation=self.maker.precedents.relation(target), container=target)

    def _onto(
        self, target: str, inputs: Sequence[ObjectNode], gone: Sequence[ObjectNode]
    ) -> tuple[Sequence[ObjectNode], Sequence[ObjectNode]]:
        """Return what goes in and comes out where a food is brought onto another, which has it on it then."""
        scene = self.maker.scene
        onto, brought = scene.foods[target], inputs[0]
        added = tuple(one for one in scene.parts(brought) if one not in scene.parts(onto))
        covered = replace(onto, ingredients=(*onto.ingredients, *added))
        scene.forget([brought.label])
        if onto.container is not None and self.maker.nodes.in_utensil(onto):
            scene.focus = onto.container
        return [onto, *inputs], [covered, *gone]


def _containers(like: Precedents) -> tuple[str | None, ...]:
    return (like.place_after()[0][1],) if like.rows else ()
