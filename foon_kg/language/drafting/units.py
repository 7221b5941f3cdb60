"""The units of one action: a food is changed where it is, brought to another place, or mixed with others."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from foon_kg.food import motions, tables
from foon_kg.food.lists import word_list
from foon_kg.language.drafting.bringing import Bringing
from foon_kg.language.drafting.evidence import IMPLIED, Evidence, as_one
from foon_kg.language.drafting.handling import Handling
from foon_kg.language.drafting.making import Maker, OfNodes
from foon_kg.language.drafting.mixing import Mixing
from foon_kg.language.drafting.precedents import Precedents
from foon_kg.language.drafting.scene import emptied, filled
from foon_kg.model import Annotation, ObjectNode, Timing
from foon_kg.model.drafts import DraftUnit
from foon_kg.model.narration import Mention, NarratedAction, Place

COVERED = word_list("covers with")
"""Verbs by which something comes onto their objects, where it is told with what."""

_SEASONS = word_list("only seasons")
_FREES = frozenset({"separate", "shell"})
_AWAY = frozenset({"into", "onto", "to"})


def _covers(action: NarratedAction, motion: str) -> bool:
    """Whether food is put onto something: with sugar cookies are coated, with water potatoes are covered."""
    onto = any(place.relation in {"on", "over"} for place in action.places)
    return onto and not tables().motion(motion).does.isdisjoint({"coat", "cover", "close"})


def _from_elsewhere(foods: Sequence[ObjectNode], at: str | None) -> Sequence[ObjectNode]:
    """Return those of ``foods`` that are not in the vessel ``at``; none where they need not come anywhere."""
    return [] if at is None else [node for node in foods if node.container != at]


@dataclass(frozen=True)
class _Doing:
    """What is done to one food: the ``motion`` of an ``action``, ``like`` what is known, and what speaks for it."""

    action: NarratedAction
    motion: str
    like: Precedents
    evidence: Evidence


@dataclass(frozen=True)
class _Change:
    """What an action makes of one food: how it is ``before`` and ``after``, and what takes part.

    ``dips`` are the foods that it was put in, ``around`` and ``held`` its vessel before and after.
    """

    before: ObjectNode
    after: ObjectNode
    dips: Sequence[ObjectNode]
    around: Sequence[ObjectNode]
    held: Sequence[ObjectNode]
    tools: Sequence[ObjectNode]

    @property
    def is_none(self) -> bool:
        """Whether nothing is otherwise afterwards."""
        return self.after == self.before and not self.dips

    @property
    def inputs(self) -> Sequence[ObjectNode]:
        """All that goes in."""
        return [*self.around, self.before, *self.dips, *self.tools]

    @property
    def outputs(self) -> Sequence[ObjectNode]:
        """All that comes out, but for tools."""
        return [*self.held, self.after, *self.dips]


@dataclass(frozen=True)
class _Several:
    """Several foods before and after one action on all of them, in one order, and the ``tools`` of such actions."""

    befores: Sequence[ObjectNode]
    afters: Sequence[ObjectNode]
    tools: Sequence[str]


@dataclass(frozen=True)
class UnitDrafter(OfNodes):
    """Drafts units of ``nodes``, and changes their scene as these units do.

    ``free``: the actions are read in free text, which leaves out what everybody knows, as that ovens are turned on.
    """

    free: bool = True

    @cached_property
    def _maker(self) -> Maker:
        return Maker(self.nodes)

    @cached_property
    def _mixing(self) -> Mixing:
        return Mixing(self._maker)

    @cached_property
    def _handling(self) -> Handling:
        return Handling(self._maker)

    @cached_property
    def _bringing(self) -> Bringing:
        return Bringing(self._maker)

    def units(self, action: NarratedAction, motion: str, sure: float, doubts: Sequence[str]) -> tuple[DraftUnit, ...]:
        """Return the units of ``action``, whose objects (at least one) are named as scene or FOON name them.

        ``motion`` is what the FOON calls its verb, ``sure`` (0 to 1) how sure that is, and ``doubts`` those there are
        before.
        """
        evidence = Evidence([sure], list(doubts))
        if self.precedents.kitchen.is_utensil(action.objects[0].name):
            return (self._handling.unit(action, motion, evidence),)
        if self._mixes(action, motion):
            return self._mixing.unit(action, motion, evidence)
        source = self._maker.source_of(action, motion)
        if source is None or not self.free:
            return self._of_foods(action, motion, evidence)
        lit = self._maker.lit(source, action)
        put: list[DraftUnit] = []
        if tables().motion(motion).source == "heat" and (at := self._what_cooks(action, motion, source)) is not None:
            put = self._maker.moved([one.name for one in action.objects], at, action)
            action = replace(action, places=(Place("in", at), *self._food_places(action)))
        told = tuple(dict.fromkeys((source, *action.instruments)))
        return (*lit, *put, *self._of_foods(replace(action, instruments=told), motion, evidence))

    def _mixes(self, action: NarratedAction, motion: str) -> bool:
        """Whether an action makes one thing of several."""
        if action.product is not None and len(action.objects) > 1:
            return True
        if not motions.mixes(motion) or motions.heats(motion) or not self.precedents.merges(motion):
            return False
        return len(self._mixing.members(action, self._mixing.vessel(action))) > 1

    def _of_foods(self, action: NarratedAction, motion: str, evidence: Evidence) -> tuple[DraftUnit, ...]:
        """Return the units of an action on foods: one of all that are changed together, else those of each."""
        if motions.mixes(motion):
            action = self._with_everything(action)
        covered = self._is_covered(action, motion)
        if covered:
            motion = action.verb
            evidence.doubts.append(f"nobody says what “{action.verb}” is done with")
        brings = motions.transfers(motion) and not covered
        if len(action.objects) > 1 and self._at_once(action, motion, stays=not brings):
            return (self._changed_together(action, motion, evidence),)
        found = self._one_by_one(action, motion, evidence, brings=brings)
        left = self._in_scene(action.objects)
        self.scene.last = left or self._in_scene(action.places)[:1]  # what came onto another food is by itself no more
        return (as_one(found),) if brings and found else tuple(found)

    def _one_by_one(
        self, action: NarratedAction, motion: str, evidence: Evidence, *, brings: bool
    ) -> Sequence[DraftUnit]:
        """Return the units of each object of an action, which is brought where the motion ``brings``, else changed."""
        found: list[DraftUnit] = []
        for mention in action.objects:
            own = Evidence(list(evidence.shares), list(evidence.doubts))
            like = self.nodes.like(motion, mention, own)
            brought = brings or _covers(action, motion) or self._brings_as_known(action, motion, like)
            drafted = self._bringing.units if brought else self._changed
            found += drafted(action, mention, motion, like, own)
        return found

    def _with_everything(self, action: NarratedAction) -> NarratedAction:
        """Return an action that mixes with all that is in the vessel among its objects."""
        if (at := self._mixing.vessel(action)) is None:
            return action
        said = {one.name: one for one in action.objects}
        everything = self._mixing.members(action, at)
        return replace(action, objects=tuple(said.get(name, Mention(name)) for name in everything))

    def _in_scene(self, named: Iterable[Mention | Place]) -> tuple[str, ...]:
        return tuple(one.name for one in named if one.name in self.scene.foods)

    def _at_once(self, action: NarratedAction, motion: str, *, stays: bool) -> bool:
        """Whether one unit changes all objects: they are mixed, heated, or lie in one vessel and stay there."""
        return motions.mixes(motion) or motions.heats(motion) or self._lie_together(action, stays=stays)

    def _brings_as_known(self, action: NarratedAction, motion: str, like: Precedents) -> bool:
        """Whether the FOON brings such a food by ``motion``, and the action says where, or need not."""
        if not like.brings or motions.heats(motion) or self._rolled_in(action, motion):
            return False
        return bool(action.places) or not self.free

    def _rolled_in(self, action: NarratedAction, motion: str) -> bool:
        """Whether the objects are coated in a food, and not brought to it."""
        return "coat" in tables().motion(motion).does and bool(self._food_places(action))

    def _food_places(self, action: NarratedAction) -> tuple[Place, ...]:
        return tuple(place for place in action.places if not self.precedents.kitchen.is_utensil(place.name))

    def _what_cooks(self, action: NarratedAction, motion: str, source: str) -> str | None:
        """Return the vessel in which food is heated: as told, where it is, else an empty one as the FOON uses.

        ``source`` is the appliance that heats, on or in which the vessel has to fit.
        """
        told = self.nodes.utensil_place(action)
        lying = [node.container for one in action.objects if (node := self.scene.foods.get(one.name)) is not None]
        focus = self.scene.focus  # the pan in which the oil is hot
        for vessel in (told, *lying, focus):
            if vessel is not None and self._maker.cooks_in(vessel, source, motion):
                return vessel
        return self._empty_to_cook_in(motion, source)

    def _empty_to_cook_in(self, motion: str, source: str) -> str:
        """Return an empty vessel for ``motion``: the one that the FOON uses where it fits, else a plain one."""
        usual = self.precedents.vessel_of(motion)
        row = tables().utensil(usual) if usual is not None else None
        fits = row is not None and row.role == "vessel" and self._maker.cooks_in(usual, source, motion)
        plain = "bowl" if "microwave" in source else "pan"
        vessel = usual if usual is not None and fits else plain
        return self.scene.another(vessel) if self.scene.held(vessel) else vessel

    def _changed(
        self, action: NarratedAction, mention: Mention, motion: str, like: Precedents, evidence: Evidence
    ) -> list[DraftUnit]:
        """Return a unit that changes a food where it is, and the unit that nobody told which brings it there or away.

        It is brought there before, and away after ("slice it into a bowl"). What it is dipped into or rolled in takes
        part, and is on it then.
        """
        at, away = self._where_and_whither(action)
        onto = self._brought_onto(action, mention, motion)
        action = replace(action, places=tuple(place for place in action.places if place not in onto))
        moved = self._moved(mention.name, at, action)
        before = self.nodes.there(mention, like, evidence, at=at)
        doing = _Doing(action, motion, like, evidence)
        change = self._change(before, doing, told=at is not None)
        if change.is_none and (moved or away is not None):  # spread into the pan: so it comes there
            moved = moved or self._moved(change.after.label, away, action)
            return [self._told(one, doing) for one in moved]
        made = self._maker.unit(action, motion, change.inputs, change.outputs, evidence)
        moved_on = [*self._brought(onto, change.after, action), *self._moved(change.after.label, away, action)]
        return [*moved, made, *moved_on]

    def _moved(self, food: str, at: str | None, action: NarratedAction) -> list[DraftUnit]:
        """Return the unit that nobody told by which a food comes to ``at``; none where that is nowhere."""
        return [] if at is None else self._maker.moved([food], at, action)

    def _change(self, before: ObjectNode, doing: _Doing, *, told: bool) -> _Change:
        """Return what is made of a food that is there (``before``); ``told`` says that its vessel was told."""
        action, like = doing.action, doing.like
        dips = self._foods_of_places(action, before.label)
        after = self._after(before, dips, doing)
        around = self._vessel_around(before, like, told=told)
        tools = self.nodes.tools(action, like, [node.label for node in around])
        if before.container is not None:
            self.scene.focus = before.container
        if action.product is None:
            return _Change(before, after, dips, around, around, tools)
        after = self._as_product(before, after)
        held = [filled(emptied(one, [before.label]), [after.label]) for one in around]
        return _Change(before, after, dips, around, held, tools)

    def _where_and_whither(self, action: NarratedAction) -> tuple[str | None, str | None]:
        """Return the utensil in which a food is changed, and the one where it goes then."""
        named = self.nodes.utensil_place(action)
        return (None, named) if any(place.relation in _AWAY for place in action.places) else (named, None)

    def _vessel_around(self, food: ObjectNode, like: Precedents, *, told: bool) -> list[ObjectNode]:
        """Return the utensil that a food is in, where it was ``told`` or the FOON names it with such actions."""
        if food.container is None or not self.nodes.in_utensil(food) or not (like.with_vessel or told):
            return []
        return [self.nodes.vessel(food.container)]

    def _after(self, before: ObjectNode, dips: Sequence[ObjectNode], doing: _Doing) -> ObjectNode:
        """Return a food after what is done: in its new states, by its new name, and with the foods it was put in."""
        states = self.nodes.become(before, doing.like, doing.action, doing.evidence)
        after = replace(before, states=states, label=doing.action.product or before.label)
        if dips:
            own = self.scene.parts(before)
            added = dict.fromkeys(part for one in dips for part in self.scene.parts(one) if part not in own)
            after = replace(after, ingredients=(*before.ingredients, *added))
        if after == before and not doing.like.rows:
            doing.evidence.doubts.append(f"the FOON does not say what {doing.motion} changes")
        return after

    def _as_product(self, before: ObjectNode, after: ObjectNode) -> ObjectNode:
        """Return ``after`` as a thing of its own that is made of ``before``, which is by itself no more."""
        self.scene.forget([before.label])
        self.scene.mixed.add(after.label)
        return replace(after, ingredients=self.scene.parts(before))

    def _brought_onto(self, action: NarratedAction, mention: Mention, motion: str) -> tuple[Place, ...]:
        """Return the foods into which a changed food comes afterwards: a lemon is squeezed into the soup."""
        if tables().motion(motion).does.isdisjoint(_FREES):
            return ()
        into = (place for place in action.places if place.relation in _AWAY and place.name != mention.name)
        return tuple(place for place in into if place.name in self.scene.foods)

    def _brought(self, onto: Sequence[Place], food: ObjectNode, action: NarratedAction) -> list[DraftUnit]:
        """Return the unit that nobody told by which a food comes to the foods of ``onto``, if there are any."""
        if not onto:
            return []
        motion = self.precedents.bringing(food.label)
        quiet = replace(action, verb=motion, places=tuple(onto), instruments=(), timing=Timing(assumed=True))
        told = Evidence([IMPLIED], [f"nobody says how the {food.label} comes to the {onto[0].name}"])
        like = self.precedents.of(motion, food.label)
        return self._bringing.units(quiet, Mention(food.label), motion, like, told)

    def _told(self, moved: DraftUnit, doing: _Doing) -> DraftUnit:
        """Return a unit that brings food as the motion that was told."""
        unit = replace(moved.annotation.unit, motion=doing.motion)
        doubts = tuple(dict.fromkeys(doing.evidence.doubts))
        annotation = Annotation(unit, doing.action.timing)
        return replace(moved, annotation=annotation, confidence=doing.evidence.product(), doubts=doubts)

    def _foods_of_places(self, action: NarratedAction, besides: str) -> list[ObjectNode]:
        """Return the foods that are told as places: the sugar in which cookies are rolled."""
        kitchen = self.precedents.kitchen
        names = [place.name for place in action.places if not kitchen.is_utensil(place.name) and place.name != besides]
        return [self.nodes.there(Mention(name), Precedents(()), Evidence()) for name in dict.fromkeys(names)]

    def _changed_together(self, action: NarratedAction, motion: str, evidence: Evidence) -> DraftUnit:
        """Return one unit that changes several foods of one vessel (stir, fry): each becomes what it would alone."""
        at = self.nodes.utensil_place(action) or self.nodes.common_vessel(action)
        vessel = [self.nodes.vessel(at)] if at is not None else []
        foods = self._each_changed(action, motion, at, evidence)
        evidence.weigh(evidence.states)
        left, gone = self.nodes.sources(_from_elsewhere(foods.befores, at))
        besides = {at, *(node.label for node in left)}
        used = [self.nodes.vessel(name) for name in action.instruments or foods.tools if name not in besides]
        labels = tuple(node.label for node in foods.afters)
        held = [filled(one, labels) for one in vessel]
        self.scene.focus, self.scene.last = at, labels
        inputs = [*vessel, *left, *foods.befores, *used]
        return self._maker.unit(action, motion, inputs, [*held, *foods.afters, *gone], evidence)

    def _each_changed(self, action: NarratedAction, motion: str, at: str | None, evidence: Evidence) -> _Several:
        """Return the objects of an action before and after it, where they come to ``at``; ``evidence`` weighs all."""
        befores, afters = list[ObjectNode](), list[ObjectNode]()
        tools = dict[str, None]()
        for mention in action.objects:
            own = Evidence()
            like = self.nodes.like(motion, mention, own)
            before = self.nodes.there(mention, like, own, at=at)
            after = replace(before, states=self.nodes.become(before, like, action, own))
            if at is not None and before.container != at:
                after = replace(after, relation=self.precedents.relation(at), container=at)
            evidence.states = min(evidence.states, own.states)
            evidence.doubts += own.doubts
            tools |= dict.fromkeys(like.tools())
            befores.append(before)
            afters.append(after)
        return _Several(befores, afters, tuple(tools))

    def _is_covered(self, action: NarratedAction, motion: str) -> bool:
        """Whether the objects are what something comes onto that nobody names: "season to taste"."""
        if action.places or action.verb not in COVERED or not motions.transfers(motion):
            return False
        foods, names = tables().foods, [one.name for one in action.objects]
        there = all(name in self.scene.foods for name in names)
        return there and not all(foods.food(name).is_any(_SEASONS) for name in names)

    def _lie_together(self, action: NarratedAction, *, stays: bool) -> bool:
        """Whether all objects are in one vessel already and stay there: what is done is done to them at once."""
        foods = [self.scene.foods.get(one.name) for one in action.objects]
        at = {food.container if food is not None else None for food in foods}
        return len(at) == 1 and None not in at and stays
