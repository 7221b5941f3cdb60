"""Units that make one thing of several: in which vessel, with what is in it already, and what that is called."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import tables
from foon_kg.language.drafting.evidence import IMPLIED, SOMETHING, Evidence
from foon_kg.language.drafting.making import Maker
from foon_kg.language.drafting.precedents import Precedents
from foon_kg.language.drafting.scene import MIXTURE, filled
from foon_kg.model import ObjectNode
from foon_kg.model.drafts import DraftUnit
from foon_kg.model.narration import Mention, NarratedAction

_KEEPS = frozenset({"storage", "place"})
_BOWL = "bowl"


@dataclass(frozen=True)
class Mixing:
    """Drafts units that mix."""

    maker: Maker

    def vessel(self, action: NarratedAction) -> str | None:
        """Return the vessel in which an action mixes: as told, where its things are, ``None`` for an empty one."""
        if (told := self.maker.nodes.utensil_place(action)) is not None:
            return told
        return self._around(place.name for place in action.places) or self._around(one.name for one in action.objects)

    def _around(self, foods: Iterable[str]) -> str | None:
        """Return the vessel in which one of ``foods`` is and can be mixed; one with others in it before others."""
        scene = self.maker.scene
        at = [scene.foods[name].container for name in foods if name in scene.foods]
        inside = [vessel for vessel in at if vessel is not None and self._holds(vessel)]
        return max(inside, key=lambda one: (len(scene.held(one)) > 1, one == scene.focus), default=None)

    def members(self, action: NarratedAction, vessel: str | None) -> tuple[str, ...]:
        """Return all that ``action`` mixes: the objects, what they go into, and what is in the ``vessel``."""
        scene = self.maker.scene
        foods = [place.name for place in action.places if place.name in scene.foods]
        held = [food for food in scene.held(vessel or "") if food in scene.foods]
        return tuple(dict.fromkeys((*(one.name for one in action.objects), *foods, *held)))

    def unit(self, action: NarratedAction, motion: str, evidence: Evidence) -> tuple[DraftUnit, ...]:
        """Return the unit by which ``action`` makes one mixture of foods, and of what is in their vessel already.

        ``motion`` is what is done; ``evidence`` weighs what is guessed.
        """
        nodes, scene, precedents = self.maker.nodes, self.maker.scene, self.maker.precedents
        at = self.vessel(action)
        names = self.members(action, at)
        if at is None:
            at = self._empty_one(precedents.vessel_of(motion))
            evidence.weigh(IMPLIED, f"nobody says in what: taken as the {at}")
        likes = {one.name: precedents.of(motion, one.name) for one in action.objects}
        nodes.vessel(at)  # foods that come for the first time come after it
        foods = self._foods(action, names, at, likes, evidence)
        vessel = nodes.vessel(at)
        left, gone = nodes.sources(food for food in foods if food.container != at)
        tools = nodes.tools(action, next(iter(likes.values()), Precedents(())), [at, *(node.label for node in left)])
        mixture = self._mixture(action, motion, foods, at, evidence)
        scene.forget(names)
        scene.mixed.add(mixture.label)
        scene.focus, scene.last = at, (mixture.label,)
        held = replace(filled(vessel, [mixture.label]), ingredients=(mixture.label,))
        inputs = [vessel, *left, *foods, *tools]
        return (self.maker.unit(action, motion, inputs, [held, mixture, *gone], evidence),)

    def _foods(
        self,
        action: NarratedAction,
        names: Sequence[str],
        at: str,
        likes: Mapping[str, Precedents],
        evidence: Evidence,
    ) -> list[ObjectNode]:
        """Return the foods that are mixed in ``at``, as they are; they are as sure as the least sure of them."""
        said = {one.name: one for one in action.objects}
        owns = [Evidence() for _ in names]
        foods = [
            self.maker.nodes.there(said.get(name, Mention(name)), likes.get(name, Precedents(())), own, away_from=at)
            for name, own in zip(names, owns, strict=True)
        ]
        evidence.weigh_states(min(own.states for own in owns) * SOMETHING)
        evidence.doubts += [doubt for own in owns for doubt in own.doubts]
        return foods

    def _mixture(
        self, action: NarratedAction, motion: str, foods: Sequence[ObjectNode], at: str, evidence: Evidence
    ) -> ObjectNode:
        label = action.product or self._name_of(foods)
        made_of = dict.fromkeys(part for food in foods for part in self.maker.scene.parts(food))
        parts = tuple(part for part in made_of if part != label) or tuple(made_of)
        if action.product is None and label not in {food.label for food in foods}:
            evidence.doubts.append(f"nobody names what {motion} makes: called “{label}”")
        states = tuple(dict.fromkeys((*action.results, "mixed")))
        return ObjectNode(label, states, parts, self.maker.precedents.relation(at), at)

    def _name_of(self, foods: Sequence[ObjectNode]) -> str:
        """Return what to call a mixture: as what it was before, else after its first food; each its own name."""
        made = [food.label for food in foods if food.label in self.maker.scene.mixed]
        if made:
            return made[0]
        others = set(self.maker.scene.foods)
        names = (f"{food.label} {MIXTURE}" for food in foods)
        return next((name for name in names if name not in others), f"{foods[0].label} {MIXTURE}")

    def _empty_one(self, usual: str | None) -> str:
        vessel = usual if usual is not None and self._holds(usual) else _BOWL
        return vessel if not self.maker.scene.held(vessel) else self.maker.scene.another(vessel)

    def _holds(self, vessel: str) -> bool:
        """Whether things are mixed in a vessel: not on a board, nor in what they are sold in."""
        row = tables().utensil(vessel)
        if row is None or row.role in _KEEPS:
            return row is not None and row.role == "storage" and len(self.maker.scene.held(vessel)) > 1
        return row.role == "vessel" and not {"scoop", "cook", "pour", "bake", "blend"}.isdisjoint(row.can)
