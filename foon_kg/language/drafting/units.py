"""The units of one action: a food is changed where it is, brought to another place, or mixed with others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from foon_kg.food import motions
from foon_kg.language.drafting.drafts import DraftUnit
from foon_kg.language.drafting.evidence import IMPLIED, SOMETHING, UNSEEN, Evidence, as_one
from foon_kg.language.drafting.nodes import NodeDrafter, listed
from foon_kg.language.drafting.precedents import FoonPrecedents, Precedents
from foon_kg.language.drafting.scene import EMPTY, MIXTURE, Scene, emptied, filled
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Timing
from foon_kg.model.narration import Mention, NarratedAction

_AWAY = frozenset({"into", "onto", "to"})


@dataclass(frozen=True)
class UnitDrafter:
    """Drafts units of ``nodes``, and changes their scene as these units do."""

    nodes: NodeDrafter

    @property
    def precedents(self) -> FoonPrecedents:
        """What the FOON knows of such actions."""
        return self.nodes.precedents

    @property
    def scene(self) -> Scene:
        """Where and how everything is by now."""
        return self.nodes.scene

    def units(self, action: NarratedAction, motion: str, sure: float, doubts: Sequence[str]) -> tuple[DraftUnit, ...]:
        """Answer the units of ``action``, whose objects (at least one) are named as scene or FOON name them."""
        kitchen, first = self.precedents.kitchen, action.objects[0]
        evidence = Evidence([sure], list(doubts))
        if kitchen.is_utensil(first.name):
            return (self._handled(action, motion, evidence),)
        merged = action.product is not None and len(action.objects) > 1
        if merged or (motions.mixes(motion) and self.precedents.merges(motion) and self._mixed_with(action)):
            return self._mixed(action, motion, evidence)
        together = motions.mixes(motion) or motions.heats(motion) or self._lie_together(action, motion)
        if len(action.objects) > 1 and together:
            return (self._changed_together(action, motion, evidence),)
        found: list[DraftUnit] = []
        brought = motions.transfers(motion)
        for mention in action.objects:
            own = Evidence(list(evidence.shares), list(evidence.doubts))
            like = self.nodes.like(motion, mention, own)
            bringing = motions.transfers(motion) or (like.brings and not motions.heats(motion))
            draft = self._brought if bringing else self._changed
            found += draft(action, mention, motion, like, own)
        self.scene.last = tuple(one.name for one in action.objects)
        return (as_one(found),) if brought else tuple(found)

    def _changed(
        self, action: NarratedAction, mention: Mention, motion: str, like: Precedents, evidence: Evidence
    ) -> list[DraftUnit]:
        """Answer a unit that changes a food where it is, and the unit that nobody told which brings it there or away.

        It is brought there before, and away after ("slice it into a bowl").
        """
        at = self.nodes.utensil_place(action)
        away = at if any(place.relation in _AWAY for place in action.places) else None
        at = at if away is None else None
        moved = self._moved(mention.name, at, action) if at is not None else []
        before = self.nodes.there(mention, like, evidence, at=at)
        states = self.nodes.become(before, like, action, evidence)
        after = replace(before, states=states, label=action.product or before.label)
        if after == before and not like.rows:
            evidence.doubts.append(f"the FOON does not say what {motion} changes")
        there = self.nodes.in_utensil(before) and (like.with_vessel or at)
        vessel = [self.nodes.vessel(before.container or "")] if there else []
        tools = self.nodes.tools(action, like, [node.label for node in vessel])
        if before.container is not None:
            self.scene.focus = before.container
        held = vessel
        if action.product is not None:
            self.scene.forget([before.label])
            after = replace(after, ingredients=before.ingredients or (before.label,))
            held = [filled(emptied(one, [before.label]), [after.label]) for one in vessel]
        made = self._unit(action, motion, [*vessel, before, *tools], [*held, after], evidence)
        return [*moved, made, *(self._moved(after.label, away, action) if away is not None else [])]

    def _changed_together(self, action: NarratedAction, motion: str, evidence: Evidence) -> DraftUnit:
        """Answer one unit that changes several foods of one vessel (stir, fry): each becomes what it would alone."""
        at = self.nodes.utensil_place(action) or self.nodes.common_vessel(action)
        vessel = [self.nodes.vessel(at)] if at is not None else []
        befores, afters, leaving = (list[ObjectNode]() for _ in range(3))
        tools = dict[str, None]()
        for mention in action.objects:
            like = self.precedents.of(motion, mention.name)
            own = Evidence()
            before = self.nodes.there(mention, like, own, at=at)
            after = replace(before, states=self.nodes.become(before, like, action, own))
            evidence.states = min(evidence.states, own.states)
            evidence.doubts += [*([like.doubt] if like.doubt else []), *own.doubts]
            tools |= dict.fromkeys(like.tools())
            if at is not None and before.container != at:
                leaving.append(before)
                after = replace(after, relation=self.precedents.relation(at), container=at)
            befores.append(before)
            afters.append(after)
        evidence.weigh(evidence.states)
        left, gone = self.nodes.sources(leaving)
        said = [name for name in action.instruments or tools if name not in {at, *(node.label for node in left)}]
        held = [filled(vessel[0], [node.label for node in afters])] if vessel else []
        self.scene.focus, self.scene.last = at, tuple(node.label for node in afters)
        used = [self.nodes.vessel(name) for name in said]
        return self._unit(action, motion, [*vessel, *left, *befores, *used], [*held, *afters, *gone], evidence)

    def _brought(
        self, action: NarratedAction, mention: Mention, motion: str, like: Precedents, evidence: Evidence
    ) -> list[DraftUnit]:
        """Answer a unit that brings a food from where it is into a vessel, or onto another food."""
        told = self.nodes.utensil_place(action)
        before = self.nodes.there(mention, like, evidence, away_from=told)
        target = self.nodes.target(action, mention, like, before, evidence)
        tools = self.nodes.tools(action, like, [target or "", before.container or ""])
        if target is None:
            after = replace(before, relation=None, container=None)
            left, gone = self.nodes.sources([before])
            return [self._unit(action, motion, [*left, before, *tools], [*gone, after], evidence)]
        left, gone = self.nodes.sources([before]) if before.container != target else ([], [])
        if target in self.scene.foods:
            onto = self.scene.foods[target]
            covered = replace(onto, ingredients=(*onto.ingredients, mention.name))
            self.scene.forget([mention.name])
            return [self._unit(action, motion, [onto, *left, before, *tools], [covered, *gone], evidence)]
        into = self.nodes.vessel(target)
        after = replace(before, relation=self.precedents.relation(target), container=target)
        self.scene.focus = target
        inputs = [into, *left, before, *tools]
        return [self._unit(action, motion, inputs, [filled(into, [mention.name]), after, *gone], evidence)]

    def _moved(self, food: str, at: str, action: NarratedAction) -> list[DraftUnit]:
        """Answer the unit that nobody told: a food that is elsewhere must have come to where it is changed."""
        known = self.scene.foods.get(food)
        if known is None or known.container == at:
            return []
        motion = self.precedents.bringing(food)
        evidence = Evidence([IMPLIED], [f"nobody says how {food} comes to the {at}"])
        into = self.nodes.vessel(at)
        left, gone = self.nodes.sources([known])
        after = replace(known, relation=self.precedents.relation(at), container=at)
        quiet = NarratedAction(motion, said=action.said, timing=Timing(assumed=True))
        self.scene.focus = at
        return [self._unit(quiet, motion, [into, *left, known], [filled(into, [food]), after, *gone], evidence)]

    def _lie_together(self, action: NarratedAction, motion: str) -> bool:
        """Whether all objects are in one vessel already and stay there: what is done is done to them at once."""
        foods = [self.scene.foods.get(one.name) for one in action.objects]
        at = {food.container if food is not None else None for food in foods}
        return len(at) == 1 and None not in at and not motions.transfers(motion)

    def _mixed_with(self, action: NarratedAction) -> bool:
        """Whether several foods are mixed, rather than one stirred."""
        at = self.nodes.utensil_place(action)
        held = self.scene.held(at) if at else ()
        return len({*(one.name for one in action.objects), *held}) > 1

    def _mixed(self, action: NarratedAction, motion: str, evidence: Evidence) -> tuple[DraftUnit, ...]:
        """Answer the unit that makes one mixture of foods, and of what is in their vessel already."""
        at = self.nodes.utensil_place(action) or self.nodes.common_vessel(action)
        if at is None:
            at = self.precedents.vessel_of(motion) or "bowl"
            evidence.weigh(IMPLIED, f"nobody says in what: taken as the {at}")
        names = tuple(dict.fromkeys((*(one.name for one in action.objects), *self.scene.held(at))))
        likes = {one.name: self.precedents.of(motion, one.name) for one in action.objects}
        vessel = self.nodes.vessel(at)
        said = {one.name: one for one in action.objects}
        owns = [Evidence() for _ in names]
        foods = [
            self.nodes.there(said.get(name, Mention(name)), likes.get(name, Precedents(())), own)
            for name, own in zip(names, owns, strict=True)
        ]
        evidence.weigh_states(min(own.states for own in owns) * SOMETHING)
        evidence.doubts += [doubt for own in owns for doubt in own.doubts]
        left, gone = self.nodes.sources(food for food in foods if food.container != at)
        tools = self.nodes.tools(action, next(iter(likes.values()), Precedents(())), [at])
        label = action.product or self._mixture_of(names)
        made_of = tuple(dict.fromkeys(part for food in foods for part in (food.ingredients or (food.label,))))
        mixture = ObjectNode(label, (*action.results, "mixed"), made_of, self.precedents.relation(at), at)
        if action.product is None:
            evidence.doubts.append(f"nobody names what {motion} makes: called “{label}”")
        self.scene.forget(names)
        self.scene.focus, self.scene.last = at, (label,)
        held = replace(filled(vessel, [label]), ingredients=(label,))
        inputs = [vessel, *left, *foods, *tools]
        return (self._unit(action, motion, inputs, [held, mixture, *gone], evidence),)

    def _mixture_of(self, names: Sequence[str]) -> str:
        """Answer what to call a mixture: as it was called before, else after its first food."""
        mixtures = [name for name in names if name.endswith(MIXTURE)]
        return mixtures[0] if mixtures else f"{names[0]} {MIXTURE}"

    def _handled(self, action: NarratedAction, motion: str, evidence: Evidence) -> DraftUnit:
        """Answer a unit that changes a utensil: opened, washed, turned on, put somewhere."""
        mention = action.objects[0]
        like = self.nodes.like(motion, mention, evidence)
        before = self.scene.utensils.get(mention.name)
        if before is None:
            before = ObjectNode(mention.name, like.before()[0] if like.rows else self.precedents.empty(mention.name))
        states, share = like.after(before.states) if like.rows else (before.states, UNSEEN)
        evidence.weigh(share, f"{mention.name} taken to become {listed(states)}" if states else "")
        held = (state for state in states if state != EMPTY or not before.ingredients)
        after = replace(before, states=(*held, *action.results))
        place = self.nodes.utensil_place(action)
        others: list[ObjectNode] = []
        if place is not None and place != mention.name:
            others = [self.nodes.vessel(place)]
            after = replace(after, relation=self.precedents.relation(place), container=place)
        tools = self.nodes.tools(action, like, [place or "", mention.name])
        return self._unit(action, motion, [*others, before, *tools], [*others, after], evidence)

    def _unit(
        self,
        action: NarratedAction,
        motion: str,
        inputs: Sequence[ObjectNode],
        outputs: Sequence[ObjectNode],
        evidence: Evidence,
    ) -> DraftUnit:
        """Answer the unit, and let the scene be as it leaves it."""
        self.scene.keep(outputs)
        sides = [tuple(map(Participant, dict.fromkeys(side))) for side in (inputs, outputs)]
        unit = FunctionalUnit(sides[0], motion, sides[1])
        for node in outputs:
            if not self.precedents.kitchen.is_utensil(node.label):
                self.scene.sure[node.label] = evidence.states
        doubts = tuple(dict.fromkeys(evidence.doubts))
        return DraftUnit(Annotation(unit, action.timing), evidence.product(), doubts, action.said)
