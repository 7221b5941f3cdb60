"""Foods that join a reference tree: in which form, and at which of its units (paper, algorithm 4).

Each joins in the best form, at the best place, from which it gets into the goal; executing the tree shows whether it
does. A place that brings one food nowhere brings none there, as long as no other food joins elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from functools import partial
from itertools import takewhile

from foon_kg.model import ObjectNode, RequiredIngredient
from foon_kg.preparation import Preparations, is_whole, needed
from foon_kg.reading import Reading
from foon_kg.rehearsal import Rehearsal
from foon_kg.script import Item, Replayed, Step
from foon_kg.substitution import Equivalents, eaten_raw
from foon_kg.ways import Preparation


@dataclass(frozen=True)
class Addition:
    """A food that joins the reference tree at the unit of ``place``; ``preparation`` is ``None`` for a bare one."""

    want: RequiredIngredient
    place: int
    node: ObjectNode
    preparation: Preparation | None


@dataclass(frozen=True)
class Venue:
    """A script with one casting, which makes ``goal``, and what is known of the foods that may join it.

    At the ``refused`` places a food may not join. It joins where one like it does (``joins_alike``), or else at the
    last unit that takes any number of foods.
    """

    goal: ObjectNode
    reading: Reading
    rehearsal: Rehearsal
    equivalents: Equivalents
    preparations: Preparations
    refused: frozenset[tuple[RequiredIngredient, int]]
    joins_alike: bool

    def replay_with(self, additions: Iterable[Addition]) -> Replayed:
        """Execute the script where these join."""
        joined: dict[int, list[Item]] = {}
        for addition in additions:
            item = Item(addition.node, frozenset({("", addition.want.object)}))
            joined.setdefault(addition.place, []).append(item)
        return self.rehearsal.replay(joined)

    def executed(self, additions: Iterable[Addition]) -> tuple[list[Step], Item | None]:
        """Answer the steps that lead to the goal where these join, and what the goal has become."""
        replayed = self.replay_with(additions)
        item = replayed.items.get(self.goal)
        if item is None:
            return [], None
        return needed(replayed.steps, item.node), item


class Party:
    """Who has joined the reference tree so far, and where."""

    def __init__(self, venue: Venue) -> None:
        self.venue = venue
        self.additions: list[Addition] = []
        foods, lines = venue.rehearsal.casting.foods, venue.reading.lines
        self.left_open = {line.joins for label, line in lines.items() if foods.get(label) is None}
        self.alive: frozenset[int] | None = None
        self.closed: set[int] = set()
        """Places from which nothing gets into the goal, as things stand."""

    def copy(self) -> Party:
        """Answer a party of the same guests, to which others may come."""
        other = copy(self)
        other.additions, other.left_open, other.closed = [*self.additions], {*self.left_open}, {*self.closed}
        return other

    def clashes(self, preparation: Preparation) -> bool:
        """Say whether somebody who joined uses up what ``preparation`` uses up."""
        return any(preparation.clashes(other.preparation) for other in self.additions if other.preparation)

    def let_in(self, addition: Addition) -> None:
        """Let a food join; what happens in the tree, and so which places lead to the goal, is to be seen anew."""
        if addition.place not in (self.alive or ()):
            self.alive = None
            self.closed.clear()
        self.additions.append(addition)
        self.left_open.discard(addition.place)

    def let_all_in(self, wants: Sequence[RequiredIngredient]) -> list[RequiredIngredient]:
        """Let ``wants`` join one after the other; answer those that nothing brings into the goal.

        Mostly the first choice of each is right: as many as can be are tried in one replay, and only those up to the
        first that does not arrive, then that one by itself.
        """
        if not self._may_arrive(wants):
            return list(wants)
        missing = []
        waiting, at_once = list(wants), len(wants)
        while waiting:
            chosen = self._first_choices(waiting[:at_once]) if at_once > 1 else []
            arrived = self._arriving(chosen) if len(chosen) > 1 else 0
            if arrived == len(chosen) > 1:
                for addition in chosen:
                    self.let_in(addition)
                waiting, at_once = waiting[arrived:], len(waiting)
            elif arrived > 1:
                at_once = arrived
            else:
                want = waiting.pop(0)
                if not self._add(want):
                    missing.append(want)
                at_once = len(waiting)
        return missing

    def _may_arrive(self, wants: Iterable[RequiredIngredient]) -> bool:
        """Say whether the goal is made at all, or would be where each of ``wants`` joins at every place."""
        if self.venue.replay_with(()).items.get(self.venue.goal) is not None:
            return True
        places = self.venue.reading.slots.open
        everything = [Addition(want, place, ObjectNode(want.object), None) for want in wants for place in places]
        return self.venue.replay_with(everything).items.get(self.venue.goal) is not None

    def _add(self, want: RequiredIngredient) -> bool:
        """Let ``want`` join in the first form, at the first place, from which it gets into the goal."""
        for addition in self.choices(want):
            if self._arriving([addition]):
                self.let_in(addition)
                return True
            self.closed.add(addition.place)
        return False

    def _first_choices(self, wants: Iterable[RequiredIngredient]) -> list[Addition]:
        """Answer the first choice of each of ``wants`` where all before arrive, up to one that must be seen first."""
        chosen: list[Addition] = []
        trial = self.copy()
        for want in wants:
            addition = next(trial.choices(want), None)
            if addition is None:
                break
            chosen.append(addition)
            trial.let_in(addition)
            if trial.alive is None:
                break
        self.alive = self.alive or trial.alive
        return chosen

    def choices(self, want: RequiredIngredient) -> Iterator[Addition]:
        """Answer how and where ``want`` may join, best first."""
        places = self._slots(want)
        for only_suitable in (True, False):
            for node, preparation in self.venue.preparations.forms(want):
                for place in places:
                    addition = Addition(want, place, node, preparation)
                    if place in self.closed or (want, place) in self.venue.refused:
                        continue
                    if not only_suitable or self._suits(addition):
                        yield addition

    def _suits(self, addition: Addition) -> bool:
        """Say whether a food is ready as it should be for what comes, and takes nothing that another one took (S1).

        A food that was asked whole joins raw, but what nobody eats raw joins cooked what is not cooked later: an egg is
        cracked into a dough and boiled for a salad, and raw meat is cooked for one. Where FOON knows but one of the
        two, that one suits.
        """
        made = self.venue.preparations.of(addition.want)
        cooked_later = addition.place in self.venue.reading.slots.heated
        is_flesh = bool(self.venue.equivalents.cooked(addition.want))
        if addition.preparation is None:
            return not made or (is_flesh and (cooked_later or all(map(self.clashes, made))))
        if self.clashes(addition.preparation):
            return False
        if not is_flesh and (not is_whole(addition.want.state) or len({way.is_cooked for way in made}) == 1):
            return True
        if eaten_raw(addition.want.object):
            return not addition.preparation.is_cooked
        return addition.preparation.is_cooked != cooked_later

    def _slots(self, want: RequiredIngredient) -> list[int]:
        """Answer the places where ``want`` may join, best first.

        Never into what only measures another food, if it can be helped. Best is where a food like it joins in the
        reference; then the place that a dropped food left open, so that the way of the reference is kept; then a motion
        whose units mostly take several foods; then a unit that happens anyway; then the latest. After the last unit
        that mixes or heats nothing joins (sense, S2).
        """
        slots = self.venue.reading.slots
        if not self.venue.joins_alike:
            return sorted(slots.open, reverse=True)
        if self.alive is None:
            steps, _ = self.venue.executed(self.additions)
            self.alive = frozenset(step.place for step in steps)
        likeness = self._likeness(want)
        return sorted(
            slots.open,
            key=lambda place: (
                place in slots.measuring,
                -likeness[place],
                place not in self.left_open,
                -self._gathers(place),
                place not in (self.alive or ()),
                -place,
            ),
        )

    def _likeness(self, want: RequiredIngredient) -> Mapping[int, float]:
        """Say how much the foods that join at each place in the reference are like ``want`` (0..1, in tenths)."""
        reading = self.venue.reading
        if want.object not in reading.likeness:
            like = partial(self.venue.equivalents.name_confidence, want.object)
            joined = reading.slots.joined_by
            reading.likeness[want.object] = {
                place: round(max(map(like, joined.get(place, ())), default=0.0), 1) for place in reading.slots.open
            }
        return reading.likeness[want.object]

    def _gathers(self, place: int) -> float:
        """Say how often units with the motion at ``place`` take several foods in the FOON (0..1, in tenths)."""
        return round(self.venue.equivalents.vocabulary.gathers(self.venue.reading.units[place].unit.motion), 1)

    def _arriving(self, joining: Sequence[Addition]) -> int:
        """Answer how many of ``joining``, from the first on, get into the goal beside those who joined before."""
        steps, item = self.venue.executed([*self.additions, *joining])
        arrived = {now for _, now in item.atoms} if item is not None else set[str]()
        if not arrived.issuperset(addition.want.object for addition in self.additions):
            return 0
        added = {node for step in steps for node in step.added}
        there = (addition.want.object in arrived and addition.node in added for addition in joining)
        return sum(takewhile(bool, there))
