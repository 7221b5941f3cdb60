"""The units of one action: a food is changed where it is, brought to another place, or mixed with others."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from foon_kg import motions
from foon_kg.drafting.drafts import DraftUnit
from foon_kg.drafting.evidence import SOMETHING, Evidence, as_one
from foon_kg.drafting.precedents import FoonPrecedents, Precedents
from foon_kg.drafting.scene import MIXTURE, Scene, emptied, filled
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Timing
from foon_kg.names import canonical
from foon_kg.narration import Mention, NarratedAction

_AWAY = frozenset({"into", "onto", "to"})
_IMPLIED = 0.5
_UNSEEN = 0.5


@dataclass(frozen=True)
class UnitDrafter:
    """Drafts units in a ``scene``, and changes it as they do."""

    precedents: FoonPrecedents
    scene: Scene

    def units(self, action: NarratedAction, motion: str, sure: float, doubts: Sequence[str]) -> tuple[DraftUnit, ...]:
        """Answer the units of ``action``, whose objects (at least one) are named as scene or FOON name them."""
        kitchen, first = self.precedents.kitchen, action.objects[0]
        evidence = Evidence([sure], list(doubts))
        if kitchen.is_utensil(first.name):
            return (self._handled(action, motion, evidence),)
        merged = action.product is not None and len(action.objects) > 1
        if merged or (motions.mixes(motion) and self.precedents.merges(motion) and self._mixed_with(action)):
            return self._mixed(action, motion, evidence)
        if len(action.objects) > 1 and (motions.mixes(motion) or motions.heats(motion)):
            return (self._changed_together(action, motion, evidence),)
        found: list[DraftUnit] = []
        brought = motions.transfers(motion)
        for mention in action.objects:
            own = Evidence(list(evidence.shares), list(evidence.doubts))
            like = self._like(motion, mention, own)
            bringing = motions.transfers(motion) or (like.brings and not motions.heats(motion))
            draft = self._brought if bringing else self._changed
            found += draft(action, mention, motion, like, own)
        self.scene.last = tuple(one.name for one in action.objects)
        return (as_one(found),) if brought else tuple(found)

    def _like(self, motion: str, mention: Mention, evidence: Evidence) -> Precedents:
        like = self.precedents.of(motion, mention.name)
        evidence.shares.append(like.likeness)
        evidence.doubts += [like.doubt] if like.doubt else []
        return like

    # what is there before the action

    def _there(
        self,
        mention: Mention,
        like: Precedents,
        evidence: Evidence,
        *,
        at: str | None = None,
        away_from: str | None = None,
    ) -> ObjectNode:
        """Answer a food as it is now; one that comes for the first time, as the FOON has it before such an action."""
        known = self.scene.foods.get(mention.name)
        if known is not None:
            evidence.weigh_states(self.scene.sure.get(mention.name, 1.0))
            return known
        states, (relation, container) = self._start(mention, like, evidence)
        if at is not None:
            relation, container = self.precedents.relation(at), at
        elif container is not None and (container == away_from or self._in_use(container)):
            relation, container = None, None  # the FOON's bowl is another one than the bowl of this dish
        node = ObjectNode(mention.name, states, (), relation, container)
        self._place(node)
        return node

    def _start(
        self, mention: Mention, like: Precedents, evidence: Evidence
    ) -> tuple[tuple[str, ...], tuple[str | None, str | None]]:
        if like.rows and like.likeness != _UNSEEN:
            place, at = like.place_before()
            if mention.states:
                return mention.states, place
            coming = self.scene.coming.get(canonical(mention.name))
            later = self.precedents.of(coming, mention.name) if coming else like
            states, share = (later if later.rows else like).before()
            evidence.weigh_states(share, f"{mention.name} taken as {_listed(states)}, as in most such units")
            evidence.weigh(max(at, _UNSEEN))
            return states, place
        known = self.precedents.start(mention.name)
        if known is None and not mention.states and (near := self.precedents.nearest(mention.name)) is not None:
            known = self.precedents.start(near.name)
            doubt = f"{mention.name} was never seen before: taken as is {near.name}, {near.confidence:.2f}"
            evidence.weigh_states(near.confidence * SOMETHING, doubt)
        if known is None:
            states = mention.states or ("whole",)
            evidence.weigh_states(_UNSEEN, f"{mention.name} was never seen before: taken as {_listed(states)}")
            return states, (None, None)
        return mention.states or known[0], known[1]

    def _in_use(self, container: str) -> bool:
        return bool(self.scene.held(container)) and not self.precedents.kitchen.is_storage(container)

    def _place(self, node: ObjectNode) -> None:
        """Put a food that comes for the first time into its vessel."""
        if node.container is not None and self.precedents.kitchen.is_utensil(node.container):
            vessel = self._vessel(node.container)
            if node.label not in vessel.ingredients:
                self.scene.keep([filled(vessel, [node.label])])

    def _vessel(self, name: str) -> ObjectNode:
        """Answer a utensil as it is now."""
        if name not in self.scene.utensils:
            self.scene.keep([ObjectNode(name, self.precedents.empty(name))])
        return self.scene.utensils[name]

    def _become(
        self, before: ObjectNode, like: Precedents, action: NarratedAction, evidence: Evidence
    ) -> tuple[str, ...]:
        """Answer the states of a food after an action: those that the narration tells instead of those of the FOON."""
        states, share = like.after(before.states) if like.rows else (before.states, _UNSEEN)
        if action.results:
            return (*action.results, *(state for state in states if state in before.states))
        evidence.weigh_states(share, f"{before.label} taken to become {_listed(states)}")
        return states

    def _tools(self, action: NarratedAction, like: Precedents, besides: Iterable[str]) -> list[ObjectNode]:
        names = action.instruments or like.tools()
        seen = set(besides)
        return [self._vessel(name) for name in dict.fromkeys(names) if name not in seen]

    # the kinds of units

    def _changed(
        self, action: NarratedAction, mention: Mention, motion: str, like: Precedents, evidence: Evidence
    ) -> list[DraftUnit]:
        """Answer a unit that changes a food where it is, and the unit that nobody told which brings it there or away.

        It is brought there before, and away after ("slice it into a bowl").
        """
        at = self._utensil_place(action)
        away = at if any(place.relation in _AWAY for place in action.places) else None
        at = at if away is None else None
        moved = self._moved(mention.name, at, action) if at is not None else []
        before = self._there(mention, like, evidence, at=at)
        states = self._become(before, like, action, evidence)
        after = replace(before, states=states, label=action.product or before.label)
        if after == before and not like.rows:
            evidence.doubts.append(f"the FOON does not say what {motion} changes")
        vessel = [self._vessel(before.container or "")] if self._in_utensil(before) and (like.with_vessel or at) else []
        tools = self._tools(action, like, [node.label for node in vessel])
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
        at = self._utensil_place(action) or self._common_vessel(action)
        vessel = [self._vessel(at)] if at is not None else []
        befores, afters, left, gone = (list[ObjectNode]() for _ in range(4))
        tools = dict[str, None]()
        for mention in action.objects:
            like = self.precedents.of(motion, mention.name)
            own = Evidence()
            before = self._there(mention, like, own, at=at)
            after = replace(before, states=self._become(before, like, action, own))
            evidence.states = min(evidence.states, own.states)
            evidence.doubts += [*([like.doubt] if like.doubt else []), *own.doubts]
            tools |= dict.fromkeys(like.tools())
            if at is not None and before.container != at:
                sides = self._source(before, mention.name)
                left, gone = [*left, *sides[0]], [*gone, *sides[1]]
                after = replace(after, relation=self.precedents.relation(at), container=at)
            befores.append(before)
            afters.append(after)
        evidence.weigh(evidence.states)
        said = [name for name in action.instruments or tools if name not in {at, *(node.label for node in left)}]
        held = [filled(vessel[0], [node.label for node in afters])] if vessel else []
        self.scene.focus, self.scene.last = at, tuple(node.label for node in afters)
        used = [self._vessel(name) for name in said]
        return self._unit(action, motion, [*vessel, *left, *befores, *used], [*held, *afters, *gone], evidence)

    def _brought(
        self, action: NarratedAction, mention: Mention, motion: str, like: Precedents, evidence: Evidence
    ) -> list[DraftUnit]:
        """Answer a unit that brings a food from where it is into a vessel, or onto another food."""
        told = self._utensil_place(action)
        before = self._there(mention, like, evidence, away_from=told)
        target = self._target(action, mention, like, before, evidence)
        tools = self._tools(action, like, [target or "", before.container or ""])
        if target is None:
            after = replace(before, relation=None, container=None)
            left, gone = self._source(before, mention.name)
            return [self._unit(action, motion, [*left, before, *tools], [*gone, after], evidence)]
        left, gone = self._source(before, mention.name) if before.container != target else ([], [])
        if target in self.scene.foods:
            onto = self.scene.foods[target]
            covered = replace(onto, ingredients=(*onto.ingredients, mention.name))
            self.scene.forget([mention.name])
            return [self._unit(action, motion, [onto, *left, before, *tools], [covered, *gone], evidence)]
        into = self._vessel(target)
        after = replace(before, relation=self.precedents.relation(target), container=target)
        self.scene.focus = target
        inputs = [into, *left, before, *tools]
        return [self._unit(action, motion, inputs, [filled(into, [mention.name]), after, *gone], evidence)]

    def _source(self, node: ObjectNode, food: str) -> tuple[list[ObjectNode], list[ObjectNode]]:
        """Answer the vessel that a food leaves, before and after."""
        if not self._in_utensil(node):
            return [], []
        vessel = self._vessel(node.container or "")
        return [vessel], [emptied(vessel, [food])]

    def _target(
        self, action: NarratedAction, mention: Mention, like: Precedents, before: ObjectNode, evidence: Evidence
    ) -> str | None:
        """Answer where a food is brought: as told, else the vessel at hand, else as the FOON does it."""
        for place in action.places:
            name = self.scene.called(place.name) or place.name
            label = self.precedents.labels.get(name, name)
            if label != mention.name:
                return label if self.precedents.kitchen.is_utensil(label) else self._food_place(label)
        focus = self.scene.focus
        if focus is not None and focus != before.container and self.scene.held(focus):
            evidence.weigh(SOMETHING - 0.05, f"nobody says where to: taken as the {focus}")
            return focus
        if like.rows:
            (_, container), share = like.place_after()
            if container is not None and container not in (before.container, mention.name):
                evidence.weigh(share * SOMETHING, f"nobody says where to: taken as the {container}")
                return container if self.precedents.kitchen.is_utensil(container) else self._food_place(container)
        evidence.weigh(_IMPLIED, "nobody says where to")
        return None

    def _food_place(self, label: str) -> str:
        if label not in self.scene.foods:
            states, (relation, container) = self.precedents.start(label) or ((), (None, None))
            self.scene.keep([ObjectNode(label, states, (), relation, container)])
        return label

    def _moved(self, food: str, at: str, action: NarratedAction) -> list[DraftUnit]:
        """Answer the unit that nobody told: a food that is elsewhere must have come to where it is changed."""
        known = self.scene.foods.get(food)
        if known is None or known.container == at:
            return []
        motion = self.precedents.bringing(food)
        evidence = Evidence([_IMPLIED], [f"nobody says how {food} comes to the {at}"])
        into = self._vessel(at)
        left, gone = self._source(known, food)
        after = replace(known, relation=self.precedents.relation(at), container=at)
        quiet = NarratedAction(motion, said=action.said, timing=Timing(assumed=True))
        self.scene.focus = at
        return [self._unit(quiet, motion, [into, *left, known], [filled(into, [food]), after, *gone], evidence)]

    def _mixed_with(self, action: NarratedAction) -> bool:
        """Whether several foods are mixed, rather than one stirred."""
        at = self._utensil_place(action)
        held = self.scene.held(at) if at else ()
        return len({*(one.name for one in action.objects), *held}) > 1

    def _mixed(self, action: NarratedAction, motion: str, evidence: Evidence) -> tuple[DraftUnit, ...]:
        """Answer the unit that makes one mixture of foods, and of what is in their vessel already."""
        at = self._utensil_place(action) or self._common_vessel(action)
        if at is None:
            at = self.precedents.vessel_of(motion) or "bowl"
            evidence.weigh(_IMPLIED, f"nobody says in what: taken as the {at}")
        names = tuple(dict.fromkeys((*(one.name for one in action.objects), *self.scene.held(at))))
        likes = {one.name: self.precedents.of(motion, one.name) for one in action.objects}
        vessel = self._vessel(at)
        said = {one.name: one for one in action.objects}
        owns = [Evidence() for _ in names]
        foods = [
            self._there(said.get(name, Mention(name)), likes.get(name, Precedents(())), own)
            for name, own in zip(names, owns, strict=True)
        ]
        evidence.weigh_states(min(own.states for own in owns) * SOMETHING)
        evidence.doubts += [doubt for own in owns for doubt in own.doubts]
        left = [
            pair for food in foods if food.container != at for pair in zip(*self._source(food, food.label), strict=True)
        ]
        tools = self._tools(action, next(iter(likes.values()), Precedents(())), [at])
        label = action.product or self._mixture_of(names)
        made_of = tuple(dict.fromkeys(part for food in foods for part in (food.ingredients or (food.label,))))
        mixture = ObjectNode(label, (*action.results, "mixed"), made_of, self.precedents.relation(at), at)
        if action.product is None:
            evidence.doubts.append(f"nobody names what {motion} makes: called “{label}”")
        self.scene.forget(names)
        self.scene.focus, self.scene.last = at, (label,)
        held = replace(filled(vessel, [label]), ingredients=(label,))
        inputs = [vessel, *(pair[0] for pair in left), *foods, *tools]
        return (self._unit(action, motion, inputs, [held, mixture, *(pair[1] for pair in left)], evidence),)

    def _mixture_of(self, names: Sequence[str]) -> str:
        """Answer what to call a mixture: as it was called before, else after its first food."""
        mixtures = [name for name in names if name.endswith(MIXTURE)]
        return mixtures[0] if mixtures else f"{names[0]} {MIXTURE}"

    def _common_vessel(self, action: NarratedAction) -> str | None:
        held = (self.scene.foods[one.name].container for one in action.objects if one.name in self.scene.foods)
        return next((at for at in held if at is not None and at in self.scene.utensils), self.scene.focus)

    def _handled(self, action: NarratedAction, motion: str, evidence: Evidence) -> DraftUnit:
        """Answer a unit that changes a utensil: opened, washed, turned on, put somewhere."""
        mention = action.objects[0]
        like = self._like(motion, mention, evidence)
        before = self.scene.utensils.get(mention.name)
        if before is None:
            before = ObjectNode(mention.name, like.before()[0] if like.rows else self.precedents.empty(mention.name))
        states, share = like.after(before.states) if like.rows else (before.states, _UNSEEN)
        evidence.weigh(share, f"{mention.name} taken to become {_listed(states)}" if states else "")
        after = replace(before, states=(*states, *action.results))
        place = self._utensil_place(action)
        others: list[ObjectNode] = []
        if place is not None and place != mention.name:
            others = [self._vessel(place)]
            after = replace(after, relation=self.precedents.relation(place), container=place)
        tools = self._tools(action, like, [place or "", mention.name])
        return self._unit(action, motion, [*others, before, *tools], [*others, after], evidence)

    # what several of them need

    def _utensil_place(self, action: NarratedAction) -> str | None:
        for place in action.places:
            name = self.scene.called(place.name) or place.name
            label = self.precedents.labels.get(name, name)
            if self.precedents.kitchen.is_utensil(label):
                return label
        return None

    def _in_utensil(self, node: ObjectNode) -> bool:
        return node.container is not None and self.precedents.kitchen.is_utensil(node.container)

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
        confidence = evidence.confidence()
        doubts = tuple(dict.fromkeys(evidence.doubts))
        return DraftUnit(Annotation(unit, action.timing), confidence, doubts, action.said)


def _listed(states: Sequence[str]) -> str:
    return ", ".join(states) if states else "it is"
