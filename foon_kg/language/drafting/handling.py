"""Units that change a utensil: opened, washed, greased, turned on, put somewhere."""

from __future__ import annotations

from dataclasses import dataclass, replace

from foon_kg.food import motions, tables
from foon_kg.language.drafting.evidence import IMPLIED, UNSEEN, Evidence
from foon_kg.language.drafting.making import TURN_OFF, TURN_ON, Maker
from foon_kg.language.drafting.nodes import listed
from foon_kg.language.drafting.precedents import Precedents
from foon_kg.language.drafting.scene import EMPTY
from foon_kg.language.drafting.told_states import before_it, done, with_state
from foon_kg.model import ObjectNode
from foon_kg.model.drafts import DraftUnit
from foon_kg.model.narration import NarratedAction

_OPENS, _CLOSES = frozenset({"open"}), frozenset({"close"})


@dataclass(frozen=True)
class Handling:
    """Drafts units of utensils."""

    maker: Maker

    def unit(self, action: NarratedAction, motion: str, evidence: Evidence) -> DraftUnit:
        """Return the unit of ``action``, whose first object is a utensil, by ``motion``.

        ``evidence`` weighs what is guessed.
        """
        name = action.objects[0].name
        motion = _switching(motion, name)
        nodes = self.maker.nodes
        like = nodes.like(motion, action.objects[0], evidence)
        before = nodes.scene.utensils.get(name) or self._at_first(name, motion, like)
        states = self._after(action, motion, before, like, evidence)
        before = self._as_it_was(before, states)
        after = replace(before, states=states)
        place = nodes.utensil_place(action)
        others: list[ObjectNode] = []
        if place is not None and place != name:
            others = [nodes.vessel(place)]
            after = replace(after, relation=self.maker.precedents.relation(place), container=place)
        if _moves(motion):
            before, after = self._moved(before, after, place, evidence)
        # what opens a can opens no fridge: of other utensils no tool is taken over
        shown = like if like.likeness == 1 else Precedents(())
        tools = nodes.tools(action, shown, [place or "", name]) if not _moves(motion) else []
        return self.maker.unit(action, motion, [*others, before, *tools], [*others, after], evidence)

    def _moved(
        self, before: ObjectNode, after: ObjectNode, place: str | None, evidence: Evidence
    ) -> tuple[ObjectNode, ObjectNode]:
        """Return a utensil before and after it is moved, with the place where it was taken, and in it no more."""
        origin = self.maker.nodes.origin(before.label, evidence)
        if before.container is None and origin is not None and origin not in {place, before.label}:
            before = replace(before, relation=self.maker.precedents.relation(origin), container=origin)
        if place is None and before.container is not None:
            after = replace(after, relation=None, container=None)
        return before, after

    def _at_first(self, name: str, motion: str, like: Precedents) -> ObjectNode:
        known = like.rows and like.likeness == 1 and not _moves(motion)
        return ObjectNode(name, like.before()[0] if known else self.maker.precedents.empty(name))

    def _after(
        self, action: NarratedAction, motion: str, before: ObjectNode, like: Precedents, evidence: Evidence
    ) -> tuple[str, ...]:
        """Return the states of a utensil after an action; where it is brought it stays as it is."""
        if motion in {TURN_ON, TURN_OFF}:
            evidence.weigh(IMPLIED if motion == TURN_ON else UNSEEN)
            return with_state(before.states, "on" if motion == TURN_ON else "off")
        if _moves(motion) and not action.results:
            return before.states
        states, share = like.after(before.states) if like.rows else (before.states, UNSEEN)
        if (told := done(action.verb)) is not None:
            states = with_state(_states_left(before, motion), told)
        evidence.weigh(share, f"{before.label} taken to become {listed(states)}" if states else "")
        if before.ingredients:
            states = _without(states, EMPTY)
        return tuple(dict.fromkeys((*states, *action.results)))

    def _as_it_was(self, before: ObjectNode, states: tuple[str, ...]) -> ObjectNode:
        """Return a utensil that comes for the first time as it must have been: what is opened was closed."""
        if before.label in self.maker.scene.utensils:
            return before
        come = [state for state in states if state not in before.states]
        was = next((other for state in come if (other := before_it(state)) is not None), None)
        if was is None or was in before.states:
            return before
        return replace(before, states=with_state([one for one in before.states if one not in come], was))


def _moves(motion: str) -> bool:
    """Whether a utensil only comes to another place by the motion, be it the bin."""
    return motions.transfers(motion) or "discard" in tables().motion(motion).does


def _states_left(utensil: ObjectNode, motion: str) -> tuple[str, ...]:
    """Return the states of a utensil without that which a motion ends: what something is put into is not empty."""
    return _without(utensil.states, EMPTY) if "move" in tables().motion(motion).does else utensil.states


def _without(states: tuple[str, ...], gone: str) -> tuple[str, ...]:
    return tuple(state for state in states if state != gone)


def _switching(motion: str, name: str) -> str:
    """Return the motion that is meant of an appliance: an oven is heated, and a tap opened, by turning it on."""
    row, does = tables().utensil(name), tables().motion(motion).does
    if row is None or row.role != "appliance":
        return motion
    if row.source == "water":
        return TURN_ON if does == _OPENS else TURN_OFF if does == _CLOSES else motion
    return TURN_ON if row.source == "heat" and does <= {"warm", "heat"} else motion
