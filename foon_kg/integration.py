"""Algorithm 4: from the reference tree to the final tree that holds what the recipe wants and nothing else.

For every required food, in this order: a line of the reference tree plays it (renamed where need be); or it is
made apart, by its own subtree of FOON or an equivalent's, and joins where any number of foods may enter; or, sold
in the wanted state, it joins as it is. Foods of the reference that nobody plays are dropped. Every choice is
proved by executing the tree (:mod:`foon_kg.replay`): a choice that does not bring the food into the goal is given up
for the next one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from itertools import takewhile

from foon_kg.kitchen import Kitchen
from foon_kg.lines import FoodLine
from foon_kg.model import KnownUnit, ObjectNode, RequiredIngredient
from foon_kg.ordering import Played, fresh_order, once
from foon_kg.preparation import Preparations, is_whole, needed, shows
from foon_kg.reading import Reading
from foon_kg.rehearsal import Rehearsal
from foon_kg.script import Casting, Item, Recast, Replayed, Step
from foon_kg.substitution import FAIR, Equivalents, eaten_raw
from foon_kg.validation import Finding
from foon_kg.ways import Preparation


@dataclass(frozen=True)
class Addition:
    """A food that joins the reference tree at the unit of ``place``; ``preparation`` is ``None`` for a bare one."""

    want: RequiredIngredient
    place: int
    node: ObjectNode
    preparation: Preparation | None


@dataclass(frozen=True)
class MadeApart:
    """A food that plays a line of the reference from ``leaves`` on, and is made by ``preparation`` until then."""

    leaves: tuple[ObjectNode, ...]
    preparation: Preparation


@dataclass(frozen=True)
class FinalTree:
    """A tree that was executed: its steps in order, each with the casting that it was played with."""

    goal: ObjectNode
    steps: tuple[Played, ...]
    lines: Mapping[RequiredIngredient, str]
    additions: tuple[Addition, ...]
    missing: tuple[RequiredIngredient, ...]
    made_apart: Mapping[RequiredIngredient, MadeApart] = field(default_factory=dict)


@dataclass(frozen=True)
class Integration:
    """One recipe brought into one reference tree. ``script`` is the reference tree in the order of execution."""

    script: tuple[KnownUnit, ...]
    goal: ObjectNode
    wants: tuple[RequiredIngredient, ...]
    equivalents: Equivalents
    kitchen: Kitchen
    preparations: Preparations
    refused: frozenset[tuple[RequiredIngredient, int]] = frozenset()
    """Places of the script at which a food may not join: the judge would not have it there."""
    joins_alike: bool = True
    """Whether a food joins where one like it does; else at the last unit that takes any number of foods."""
    spent: frozenset[tuple[int, ObjectNode]] = frozenset()
    """Inputs of units of the script, by place, that an earlier unit took away: the judge would have them fresh."""
    _rehearsals: list[Rehearsal] = field(default_factory=list, repr=False)

    @cached_property
    def _reading(self) -> Reading:
        return self.preparations.readings.of(self.script)

    def _rehearsal(self, casting: Casting) -> Rehearsal:
        """Answer what was rehearsed with ``casting``, by this integration or the one that it repairs."""
        known = next((rehearsal for rehearsal in self._rehearsals if rehearsal.casting == casting), None)
        if known is None:
            known = Rehearsal(self._reading.play, casting)
            self._rehearsals.append(known)
        return known

    def run(self) -> FinalTree:
        """Answer the final tree; what could not be brought into it is ``missing``."""
        lines = self._reading.lines
        played = self._play_lines(lines)
        casting = self._casting(played)
        casting, played = self._keep_what_arrives(casting, played)
        party = _Party(casting, lines)
        missing = self._add_all([want for want in self.wants if want not in played], party)
        additions = party.additions
        casting = self._carry(casting, additions)
        return self._finish(casting, played, additions, missing)

    # ---- lines of the reference

    def _play_lines(self, lines: Mapping[str, FoodLine]) -> dict[RequiredIngredient, tuple[str, Recast]]:
        """Give the lines of the reference to the foods that they fit best; each line plays one food."""
        offers = []
        for number, want in enumerate(self.wants):
            for line in lines.values():
                name = self.equivalents.name_confidence(want.object, line.label)
                cast = self._cast(want, line) if name >= FAIR else None
                role = self._role(want, line, cast[0]) if cast is not None else None
                if cast is None or role is None:
                    continue
                if line.label == self.goal.label or not self._is_made_better(want, name * cast[1]):
                    offers.append((-name * cast[1], number, line.label, role))
        offers.sort(key=lambda offer: offer[:3])
        played: dict[RequiredIngredient, tuple[str, Recast]] = {}
        taken: set[str] = set()
        for _, number, label, recast in offers:
            want = self.wants[number]
            if want in played or label in taken:
                continue
            played[want] = (label, recast)
            taken.add(label)
        return played

    def _role(self, want: RequiredIngredient, line: FoodLine, recast: Recast) -> Recast | None:
        """Answer how ``want`` plays a line whose leaves are at hand, or can be made apart and come in their place."""
        if self.preparations.leaves_stand(line, recast):
            return recast
        made = next((made for made in self.preparations.of(want) if not made.stale), None)
        takers = [self._taker(leaf) for leaf in line.leaves]
        if made is None or len(takers) > 1 or (want, takers[0]) in self.refused or not self._is_open(takers[0]):
            return None
        return replace(recast, ready=dict.fromkeys(line.leaves, made.node))

    def _taker(self, node: ObjectNode) -> int:
        return self._reading.slots.taker[node]

    def _is_open(self, place: int) -> bool:
        return place in self._reading.slots.accepting

    def _cast(self, want: RequiredIngredient, line: FoodLine) -> tuple[Recast, float] | None:
        """How a line plays a food: a processed state must be there still where the food joins others (sense, S7)."""
        sold = self.kitchen.is_start_state(want.object, want.state)
        if self.kitchen.stands_ready(want.object, want.state) and not _starts_so(line, want):
            return None  # what is there already need not be made
        if sold and is_whole(want.state) and not line.opened and self._can_be_opened(want):
            return None
        return self.equivalents.recast(want, line.states if sold else line.at_join, line.made_by)

    def _is_made_better(self, want: RequiredIngredient, confidence: float) -> bool:
        """Say whether FOON makes a processed food apart in a way that is surer than a renamed line of the reference."""
        if confidence >= 1 or self.kitchen.is_start_state(want.object, want.state):
            return False
        return self.preparations.of(want).surer_than(confidence)

    def _can_be_opened(self, want: RequiredIngredient) -> bool:
        return bool(self.preparations.of(want))

    def _casting(self, played: Mapping[RequiredIngredient, tuple[str, Recast]]) -> Casting:
        foods: dict[str, Recast | None] = dict.fromkeys(self._reading.names)
        foods |= dict(played.values())
        return Casting(foods, goal=self.goal, spent=self.spent)

    def _keep_what_arrives(
        self,
        casting: Casting,
        played: dict[RequiredIngredient, tuple[str, Recast]],
    ) -> tuple[Casting, dict[RequiredIngredient, tuple[str, Recast]]]:
        """Give up lines that do not reach the goal in the wanted state, one round after the other."""
        while True:
            steps, item = self._executed(self._rehearsal(casting).replay({}))
            arrived = {now for _, now in item.atoms} if item is not None else set()
            lost = [want for want in played if want.object not in arrived or not shows(want, steps)]
            if not lost:
                return casting, played
            played = {want: role for want, role in played.items() if want not in lost}
            casting = self._casting(played)

    def _executed(self, replayed: Replayed) -> tuple[list[Step], Item | None]:
        """Answer the steps that lead to the goal, and what the goal has become."""
        item = replayed.items.get(self.goal)
        if item is None:
            return [], None
        return needed(replayed.steps, item.node), item

    # ---- foods that join

    def _add_all(self, wants: Sequence[RequiredIngredient], party: _Party) -> list[RequiredIngredient]:
        """Let ``wants`` join one after the other; answer those that nothing brings into the goal.

        Mostly the first choice of each is right: as many as can be are tried in one replay, and only those up to the
        first that does not arrive, then that one by itself.
        """
        if not self._may_arrive(wants, party):
            return list(wants)
        missing = []
        waiting, at_once = list(wants), len(wants)
        while waiting:
            chosen = self._first_choices(waiting[:at_once], party) if at_once > 1 else []
            arrived = self._arriving(chosen, party) if len(chosen) > 1 else 0
            if arrived == len(chosen) > 1:
                for addition in chosen:
                    party.let_in(addition)
                waiting, at_once = waiting[arrived:], len(waiting)
            elif arrived > 1:
                at_once = arrived
            else:
                want = waiting.pop(0)
                if not self._add(want, party):
                    missing.append(want)
                at_once = len(waiting)
        return missing

    def _may_arrive(self, wants: Iterable[RequiredIngredient], party: _Party) -> bool:
        """Say whether the goal is made at all, or would be where each of ``wants`` joins at every place."""
        if self._replay_with(party.casting, ()).items.get(self.goal) is not None:
            return True
        places = self._reading.slots.open
        everything = [Addition(want, place, ObjectNode(want.object), None) for want in wants for place in places]
        return self._replay_with(party.casting, everything).items.get(self.goal) is not None

    def _add(self, want: RequiredIngredient, party: _Party) -> bool:
        """Let ``want`` join in the first form, at the first place, from which it gets into the goal."""
        for addition in self._choices(want, party):
            if self._arriving([addition], party):
                party.let_in(addition)
                return True
            party.closed.add(addition.place)
        return False

    def _first_choices(self, wants: Iterable[RequiredIngredient], party: _Party) -> list[Addition]:
        """Answer the first choice of each of ``wants`` where all before arrive, up to one that must be seen first."""
        chosen: list[Addition] = []
        trial = party.copy()
        for want in wants:
            addition = next(self._choices(want, trial), None)
            if addition is None:
                break
            chosen.append(addition)
            trial.let_in(addition)
            if trial.alive is None:
                break
        party.alive = party.alive or trial.alive
        return chosen

    def _choices(self, want: RequiredIngredient, party: _Party) -> Iterator[Addition]:
        """Answer how and where ``want`` may join, best first."""
        places = self._slots(want, party)
        for only_suitable in (True, False):
            for node, preparation in self.preparations.forms(want):
                for place in places:
                    addition = Addition(want, place, node, preparation)
                    if place in party.closed or (want, place) in self.refused:
                        continue
                    if not only_suitable or self._suits(addition, party):
                        yield addition

    def _suits(self, addition: Addition, party: _Party) -> bool:
        """Say whether a food is ready as it should be for what comes, and takes nothing that another one took (S1).

        A food that was asked whole joins raw, but what nobody eats raw joins cooked what is not cooked later: an egg is
        cracked into a dough and boiled for a salad, and raw meat is cooked for one. Where FOON knows but one of the
        two, that one suits.
        """
        made = self.preparations.of(addition.want)
        cooked_later = addition.place in self._reading.slots.heated
        is_flesh = bool(self.equivalents.cooked(addition.want))
        if addition.preparation is None:
            return not made or (is_flesh and (cooked_later or all(map(party.clashes, made))))
        if party.clashes(addition.preparation):
            return False
        if not is_flesh and (not is_whole(addition.want.state) or len({way.is_cooked for way in made}) == 1):
            return True
        if eaten_raw(addition.want.object):
            return not addition.preparation.is_cooked
        return addition.preparation.is_cooked != cooked_later

    def _slots(self, want: RequiredIngredient, party: _Party) -> list[int]:
        """Answer the places where ``want`` may join, best first.

        Never into what only measures another food, if it can be helped. Best is where a food like it joins in the
        reference; then the place that a dropped food left open, so that the way of the reference is kept; then a motion
        whose units mostly take several foods; then a unit that happens anyway; then the latest. After the last unit
        that mixes or heats nothing joins (sense, S2).
        """
        slots = self._reading.slots
        if not self.joins_alike:
            return sorted(slots.open, reverse=True)
        if party.alive is None:
            steps, _ = self._executed(self._replay_with(party.casting, party.additions))
            party.alive = frozenset(step.place for step in steps)
        likeness = self._likeness(want)
        return sorted(
            slots.open,
            key=lambda place: (
                place in slots.measuring,
                -likeness[place],
                place not in party.left_open,
                -self._gathers(place),
                place not in (party.alive or ()),
                -place,
            ),
        )

    def _likeness(self, want: RequiredIngredient) -> Mapping[int, float]:
        """Say how much the foods that join at each place in the reference are like ``want`` (0..1, in tenths)."""
        reading = self._reading
        if want.object not in reading.likeness:
            like = partial(self.equivalents.name_confidence, want.object)
            joined = reading.slots.joined_by
            reading.likeness[want.object] = {
                place: round(max(map(like, joined.get(place, ())), default=0.0), 1) for place in reading.slots.open
            }
        return reading.likeness[want.object]

    def _gathers(self, place: int) -> float:
        """Say how often units with the motion at ``place`` take several foods in the FOON (0..1, in tenths)."""
        return round(self.equivalents.vocabulary.gathers(self.script[place].unit.motion), 1)

    def _arriving(self, joining: Sequence[Addition], party: _Party) -> int:
        """Answer how many of ``joining``, from the first on, get into the goal beside those who joined before."""
        replayed = self._replay_with(party.casting, [*party.additions, *joining])
        item = replayed.items.get(self.goal)
        arrived = {now for _, now in item.atoms} if item is not None else set[str]()
        if not arrived.issuperset(addition.want.object for addition in party.additions):
            return 0
        steps, _ = self._executed(replayed)
        added = {node for step in steps for node in step.added}
        there = (addition.want.object in arrived and addition.node in added for addition in joining)
        return sum(takewhile(bool, there))

    def _replay_with(self, casting: Casting, additions: Sequence[Addition]) -> Replayed:
        joined: dict[int, list[Item]] = {}
        for addition in additions:
            joined.setdefault(addition.place, []).append(_item(addition))
        return self._rehearsal(casting).replay(joined)

    def blamed(self, tree: FinalTree, findings: Iterable[Finding]) -> frozenset[tuple[RequiredIngredient, int]]:
        """Answer which foods joined at which places in the units of ``tree`` in which something was found."""
        steps = [tree.steps[finding.unit][0] for finding in findings if finding.unit is not None]
        places = {step.place for step in steps if self._is_of_script(step)}
        joined = [(addition.want, addition.place) for addition in tree.additions]
        joined += [(want, self._taker(leaf)) for want, made in tree.made_apart.items() for leaf in made.leaves]
        return frozenset((want, place) for want, place in joined if place in places)

    def taken_twice(self, tree: FinalTree, findings: Iterable[Finding]) -> frozenset[tuple[int, ObjectNode]]:
        """Answer which inputs of the script were found to be taken although an earlier unit took them away (S1)."""
        found = set()
        for finding in findings:
            step = tree.steps[finding.unit][0] if finding.unit is not None else None
            if step is not None and self._is_of_script(step):
                found |= {(step.place, node) for node, now in step.taken if now == finding.node}
        return frozenset(found)

    def _is_of_script(self, step: Step) -> bool:
        return step.place < len(self.script) and step.known == self.script[step.place]

    # ---- the whole

    def _carry(self, casting: Casting, additions: Sequence[Addition]) -> Casting:
        """Let mixtures name the foods that the goal would forget, though they are in it (contract, C4)."""
        _, item = self._executed(self._replay_with(casting, additions))
        if item is None:
            return casting
        named = {item.node.label, *item.node.ingredients}
        forgotten = {want.object for want in self.wants} - set(item.node.ingredients)
        inside = {now for _, now in item.atoms}
        return replace(casting, carried=frozenset((forgotten & inside) - (named - {item.node.label})))

    def _finish(
        self,
        casting: Casting,
        played: Mapping[RequiredIngredient, tuple[str, Recast]],
        additions: Sequence[Addition],
        missing: Sequence[RequiredIngredient],
    ) -> FinalTree:
        steps, item = self._executed(self._replay_with(casting, additions))
        goal = item.node if item is not None else self.goal
        prepared: dict[int, list[Played]] = {}
        for addition in additions:
            if addition.preparation is not None:
                own = [(step, addition.preparation.casting) for step in addition.preparation.steps]
                prepared.setdefault(addition.place, []).extend(own)
        made_apart = self._made_apart(played)
        for entry in made_apart.values():
            own = [(step, entry.preparation.casting) for step in entry.preparation.steps]
            prepared.setdefault(min(map(self._taker, entry.leaves)), []).extend(own)
        ordered: list[Played] = []
        for step in steps:
            ordered += prepared.get(step.place, [])
            ordered.append((step, casting))
        furnished = [*self._turned_on(ordered), *ordered]
        lines = {want: label for want, (label, _) in played.items()}
        order = fresh_order(tuple(once(furnished)))
        return FinalTree(goal, order, lines, tuple(additions), tuple(missing), made_apart)

    def _made_apart(
        self, played: Mapping[RequiredIngredient, tuple[str, Recast]]
    ) -> dict[RequiredIngredient, MadeApart]:
        found = {}
        for want, (_, recast) in played.items():
            made = next((made for made in self.preparations.of(want) if made.node in recast.ready.values()), None)
            if made is not None:
                found[want] = MadeApart(tuple(recast.ready), made)
        return found

    def _turned_on(self, steps: Sequence[Played]) -> Iterator[Played]:
        """Answer the steps that make utensils hot or on that nobody made so, where FOON knows how (contract, C6)."""
        made: set[ObjectNode] = set()
        for step, _ in steps:
            for node in step.input_nodes:
                if node not in made and not self.kitchen.is_food(node) and self.kitchen.is_running(node):
                    yield from self.preparations.utensil(node)
            made.update(step.output_nodes)


def _starts_so(line: FoodLine, want: RequiredIngredient) -> bool:
    """Say whether every leaf of ``line`` is in the wanted state."""
    return all(want.state in node.states for node in line.leaves)


class _Party:
    """Who has joined the reference tree so far, and where."""

    def __init__(self, casting: Casting, lines: Mapping[str, FoodLine]) -> None:
        self.casting = casting
        self.lines = lines
        self.additions: list[Addition] = []
        self.left_open = {line.joins for label, line in lines.items() if casting.foods.get(label) is None}
        self.alive: frozenset[int] | None = None
        self.closed: set[int] = set()
        """Places from which nothing gets into the goal, as things stand."""

    def copy(self) -> _Party:
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


def _item(addition: Addition) -> Item:
    return Item(addition.node, frozenset({("", addition.want.object)}))
