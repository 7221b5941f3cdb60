"""Algorithm 4: from the reference tree to the final tree that holds what the recipe wants and nothing else.

For every required food, in this order: a line of the reference tree plays it (renamed where need be); or it is
made apart, by its own subtree of FOON or an equivalent's, and joins where any number of foods may enter; or, sold
in the wanted state, it joins as it is. Foods of the reference that nobody plays are dropped. Every choice is
proved by executing the tree (:mod:`foon_kg.replay`): a choice that does not bring the food into the goal is given up
for the next one.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from foon_kg.form import Finding
from foon_kg.kitchen import Kitchen
from foon_kg.lines import FoodLine
from foon_kg.model import KnownUnit, ObjectNode, RequiredIngredient
from foon_kg.ordering import Played, fresh_order, once
from foon_kg.party import Addition, Party, Venue
from foon_kg.preparation import Preparations, is_whole, shows
from foon_kg.reading import Reading
from foon_kg.rehearsal import Rehearsal
from foon_kg.script import Casting, Recast, Step
from foon_kg.substitution import FAIR, Equivalents
from foon_kg.ways import Preparation


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

    def _venue(self, casting: Casting) -> Venue:
        return Venue(
            self.goal,
            self._reading,
            self._rehearsal(casting),
            self.equivalents,
            self.preparations,
            self.refused,
            self.joins_alike,
        )

    def run(self) -> FinalTree:
        """Answer the final tree; what could not be brought into it is ``missing``."""
        lines = self._reading.lines
        played = self._play_lines(lines)
        casting = self._casting(played)
        casting, played = self._keep_what_arrives(casting, played)
        party = Party(self._venue(casting))
        missing = party.let_all_in([want for want in self.wants if want not in played])
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
            steps, item = self._venue(casting).executed(())
            arrived = {now for _, now in item.atoms} if item is not None else set()
            lost = [want for want in played if want.object not in arrived or not shows(want, steps)]
            if not lost:
                return casting, played
            played = {want: role for want, role in played.items() if want not in lost}
            casting = self._casting(played)

    # ---- what the judge found

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
        _, item = self._venue(casting).executed(additions)
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
        steps, item = self._venue(casting).executed(additions)
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
