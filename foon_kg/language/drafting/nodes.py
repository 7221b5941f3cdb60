"""The object nodes of one action: how a food or a utensil is before it, what it becomes, and where it goes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.language.drafting.evidence import IMPLIED, SOMETHING, UNSEEN, Evidence
from foon_kg.language.drafting.precedents import FoonPrecedents, Precedents
from foon_kg.language.drafting.scene import Scene, emptied, filled
from foon_kg.language.drafting.told_states import done, with_state
from foon_kg.model import ObjectNode
from foon_kg.model.names import canonical
from foon_kg.model.narration import Mention, NarratedAction

Start = tuple[tuple[str, ...], tuple[str | None, str | None]]
"""The states of a food before anything is done to it, and its place: a relation and a container."""

_NOWHERE = (None, None)
_SOLD_SO = SOMETHING - 0.05
"""A little less sure than what is known of something like it: foods are sold in several states."""

_TRUSTED = 0.6
"""Below this, how a food is before an action is rather taken from what it is elsewhere than from another food."""


@dataclass(frozen=True)
class NodeDrafter:
    """Drafts the nodes of an action from the ``scene``, and what is not in it yet from the ``precedents``."""

    precedents: FoonPrecedents
    scene: Scene

    def like(self, motion: str, mention: Mention, evidence: Evidence) -> Precedents:
        """Return what the FOON knows of ``motion`` done to an object (``mention``).

        ``evidence`` weighs how well it knows.
        """
        like = self.precedents.of(motion, mention.name)
        evidence.shares.append(like.likeness)
        evidence.doubts += [like.doubt] if like.doubt else []
        return like

    def there(
        self,
        mention: Mention,
        like: Precedents,
        evidence: Evidence,
        *,
        at: str | None = None,
        away_from: str | None = None,
        brought: bool = False,
    ) -> ObjectNode:
        """Return a food (``mention``) as it is now; one that comes for the first time, as the FOON has it (``like``).

        It is in ``at`` where that is given, and never in ``away_from``. What is ``brought`` leaves the hand, and comes
        from where it was taken. ``evidence`` weighs what is guessed.
        """
        origin = self._utensil_of_origin(mention.name, evidence) if brought else None
        known = self.scene.foods.get(mention.name)
        if known is not None:
            if origin is not None and known.container is None:
                known = replace(known, relation=self.precedents.relation(origin), container=origin)
            evidence.weigh_states(self.scene.sure.get(mention.name, 1.0))
            return known
        states, (relation, container) = self._start(mention, like, evidence)
        if (told := origin or at) is not None:
            relation, container = self.precedents.relation(told), told
        elif container is not None and self._is_elsewhere(container, away_from):
            relation, container = None, None  # the FOON's bowl is another one than the bowl of this dish
        node = ObjectNode(mention.name, states, (), relation, container)
        self._place(node)
        return node

    def _utensil_of_origin(self, name: str, evidence: Evidence) -> str | None:
        """Return the utensil from which a thing that is put was taken, ``None`` where nobody said so."""
        origin = self.origin(name, evidence)
        return origin if origin is not None and self.precedents.kitchen.is_utensil(origin) else None

    def _is_elsewhere(self, container: str, away_from: str | None) -> bool:
        """Whether the place that the FOON has for a food is none of this dish: in use, or a food that is not there."""
        food = not self.precedents.kitchen.is_utensil(container) and container not in self.scene.foods
        return food or container == away_from or self._in_use(container) or _prepares(container)

    def _start(self, mention: Mention, like: Precedents, evidence: Evidence) -> Start:
        """Return the states and the place of a food that comes for the first time.

        What the FOON has before such an action counts first; where that is too unlike, what it has of the food itself.
        """
        trusted = like.likeness >= _TRUSTED or self.precedents.start(mention.name) is None
        if trusted and like.rows and like.likeness != UNSEEN:
            return self._start_like(mention, like, evidence)
        states, place = self.precedents.start(mention.name) or self._start_unseen(mention, evidence)
        return mention.states or states, place

    def _start_like(self, mention: Mention, like: Precedents, evidence: Evidence) -> Start:
        """Return how a food is before such actions in the FOON, or before what is done to it later in the recipe."""
        place, share_of_place = like.place_before()
        if mention.states:
            return mention.states, place
        coming = self.scene.coming.get(canonical(mention.name))
        later = self.precedents.of(coming, mention.name) if coming else like
        first = later if later.rows else like
        states, share = first.before()
        if done(first.rows[0].motion) in states and (sold := self.precedents.start(mention.name)) is not None:
            states = sold[0]  # the FOON beats eggs that are beaten already
        evidence.weigh_states(share, f"{mention.name} taken as {listed(states)}, as in most such units")
        evidence.weigh(max(share_of_place, UNSEEN))
        return states, place

    def _start_unseen(self, mention: Mention, evidence: Evidence) -> Start:
        """Return how a food is that the FOON never saw: as told, else as another, else whole; what is made is not."""
        known = None if mention.states else self._start_like_another(mention.name, evidence)
        if known is not None:
            return known
        made = not {*canonical(mention.name).split()[-1:]}.isdisjoint(tables().unfinished)
        states = mention.states or (() if made else ("whole",))
        evidence.weigh_states(UNSEEN, f"{mention.name} was never seen before: taken as {listed(states)}")
        return states, _NOWHERE

    def _start_like_another(self, name: str, evidence: Evidence) -> Start | None:
        """Return how a food that the FOON never saw is: as it is sold, else as the nearest food that it saw."""
        if as_sold := tables().foods.food(name).sold_as:
            evidence.weigh_states(_SOLD_SO, f"{name} was never seen before: taken as {as_sold}, as it is sold")
            return (as_sold,), _NOWHERE
        if (near := self.precedents.nearest(name)) is None:
            return None
        doubt = f"{name} was never seen before: taken as is {near.name}, {near.confidence:.2f}"
        evidence.weigh_states(near.confidence * SOMETHING, doubt)
        return self.precedents.start(near.name)

    def origin(self, name: str, evidence: Evidence) -> str | None:
        """Return where the thing called ``name`` that is put was taken from.

        ``None`` where nobody said so, or it is known.

        ``evidence`` weighs a guess.
        """
        origin, guessed = self.scene.hands.put(name)
        if origin is not None and guessed:
            evidence.weigh(IMPLIED, f"nobody says from where the {name} is taken: from the {origin}, which was open")
        return origin

    def _in_use(self, container: str) -> bool:
        return bool(self.scene.held(container)) and not self.precedents.kitchen.is_storage(container)

    def _place(self, node: ObjectNode) -> None:
        """Put a food that comes for the first time into its vessel."""
        if node.container is not None and self.precedents.kitchen.is_utensil(node.container):
            vessel = self.vessel(node.container)
            if node.label not in vessel.ingredients:
                self.scene.keep([filled(vessel, [node.label])])

    def become(
        self, before: ObjectNode, like: Precedents, action: NarratedAction, evidence: Evidence
    ) -> tuple[str, ...]:
        """Return the states of a food after ``action``: those that are told, else those of the FOON (``like``).

        ``before`` is the food before it; ``evidence`` weighs what is guessed.
        """
        states, share = like.after(before.states) if like.rows else (before.states, UNSEEN)
        if not set(action.results) <= set(before.states):
            return (*action.results, *(state for state in states if state in before.states))
        known = tables().motion(action.verb)
        if set(states) == set(before.states) and "wait" in known.does:
            so = word_list("is so by cooling" if known.source == "cold" else "is so by waiting")
            states, share = tuple(dict.fromkeys((*states, *sorted(so)))), UNSEEN
        if set(states) == set(before.states) and (told := done(action.verb)):
            states, share = with_state(states, told), UNSEEN
        evidence.weigh_states(share, f"{before.label} taken to become {listed(states)}")
        return states

    def vessel(self, name: str) -> ObjectNode:
        """Return the utensil called ``name`` as it is now."""
        known = self.scene.utensils.get(name)
        if known is None:  # nobody said of it before that it is one
            known = self.scene.utensils[name] = ObjectNode(name, self.precedents.empty(name))
        return known

    def tools(self, action: NarratedAction, like: Precedents, besides: Iterable[str]) -> list[ObjectNode]:
        """Return the instruments that ``action`` tells, else those of the FOON (``like``); none of ``besides``."""
        names = action.instruments or tuple(name for name in like.tools() if not _runs_water(name))
        seen = set(besides)
        return [self.vessel(name) for name in dict.fromkeys(names) if name not in seen]

    def sources(self, foods: Iterable[ObjectNode]) -> tuple[list[ObjectNode], list[ObjectNode]]:
        """Return the vessels that foods leave, each once, before and after."""
        leaving: dict[str, list[str]] = {}
        for food in foods:
            if food.container is not None and self.in_utensil(food):
                leaving.setdefault(food.container, []).append(food.label)
        left = [self.vessel(name) for name in leaving]
        return left, [emptied(vessel, leaving[vessel.label]) for vessel in left]

    def target(
        self, action: NarratedAction, mention: Mention, like: Precedents, before: ObjectNode, evidence: Evidence
    ) -> str | None:
        """Return where ``action`` brings a food (``mention``): as told, else to the vessel at hand, else by ``like``.

        ``before`` is the food before it, ``like`` what the FOON knows; ``evidence`` weighs what is guessed.
        """
        for place in action.places:
            label = self._place_called(place.name)
            if label != mention.name:
                return label if self.precedents.kitchen.is_utensil(label) else self._food_place(label)
        discarded = "discard" in tables().motion(action.verb).does
        if not discarded and (focus := self._vessel_at_hand(before, evidence)) is not None:
            return focus
        if (usual := self._usual_target(like, before, evidence)) is not None:
            return usual
        evidence.weigh(IMPLIED, "nobody says where to")
        return None

    def _vessel_at_hand(self, food: ObjectNode, evidence: Evidence) -> str | None:
        """Return the vessel at hand, in which something is, where a food may come to it or is there already."""
        focus = self.scene.focus
        if focus is None:
            return None
        if focus == food.container:
            return focus if len(self.scene.held(focus)) > 1 else None
        if not self.scene.held(focus):
            return None
        evidence.weigh(SOMETHING - 0.05, f"nobody says where to: taken as the {focus}")
        return focus

    def _usual_target(self, like: Precedents, food: ObjectNode, evidence: Evidence) -> str | None:
        """Return where the FOON brings such a food, if that is there and it is not in it already."""
        if not like.rows:
            return None
        (_, container), share = like.place_after()
        if container is None or container in {food.container, food.label}:
            return None
        if container not in self.scene.foods and not self.precedents.kitchen.is_utensil(container):
            return None
        evidence.weigh(share * SOMETHING, f"nobody says where to: taken as the {container}")
        return container

    def _food_place(self, label: str) -> str:
        if label not in self.scene.foods:
            states, (relation, container) = self.precedents.start(label) or ((), (None, None))
            self.scene.keep([ObjectNode(label, states, (), relation, container)])
        return label

    def utensil_place(self, action: NarratedAction) -> str | None:
        """Return the first place that ``action`` tells and that is a utensil."""
        for place in action.places:
            label = self._place_called(place.name)
            if self.precedents.kitchen.is_utensil(label):
                return label
        return None

    def _place_called(self, name: str) -> str:
        if self.precedents.kitchen.is_utensil(name):
            return name
        known = self.scene.called(name) or name
        return self.precedents.labels.get(known, known)

    def common_vessel(self, action: NarratedAction) -> str | None:
        """Return the utensil that holds one of the objects of ``action``.

        None where they all come for the first time.
        """
        held = (self.scene.foods[one.name].container for one in action.objects if one.name in self.scene.foods)
        return next((at for at in held if at is not None and at in self.scene.utensils), None)

    def in_utensil(self, node: ObjectNode) -> bool:
        """Say whether a node is in or on a utensil."""
        return node.container is not None and self.precedents.kitchen.is_utensil(node.container)


def _runs_water(name: str) -> bool:
    row = tables().utensil(name)
    return row is not None and row.source == "water"


def _prepares(container: str) -> bool:
    """Whether a vessel is for mixing or cooking: no food begins there, though the FOON has it so before such an action.

    Foods begin in what they are sold in, where they are put away, and on boards and plates.
    """
    row = tables().utensil(container)
    return row is not None and row.role == "vessel" and row.can != {"hold"}


def listed(states: Sequence[str]) -> str:
    """Return states in words."""
    return ", ".join(states) if states else "it is"
