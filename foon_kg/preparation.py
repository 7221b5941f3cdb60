"""Foods made apart: the own subtree of a required food, or that of its equivalent (paper, algorithm 4).

A food in a processed state is made as FOON makes it, or as FOON makes a fair equivalent. A food asked whole is
cracked, peeled, opened or cut before it joins others, where FOON knows how. Other foods of such a subtree (the oil in
which the bacon is fried) are left out: nobody asked for them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial

from foon_kg import motions
from foon_kg.kitchen import Kitchen
from foon_kg.lines import FoodLine, opens_food
from foon_kg.model import KnownUnit, ObjectNode, RequiredIngredient
from foon_kg.ordering import Played
from foon_kg.reading import Readings
from foon_kg.recent import Recent
from foon_kg.replay import replay
from foon_kg.script import Casting, Recast, Step
from foon_kg.stock import StockedKitchen
from foon_kg.substitution import Candidate, Equivalents
from foon_kg.ways import Preparation, Ways

MOST_WANTS = 4096
"""For how many wanted foods it is kept how they are made ready in one kitchen."""

Derive = Callable[[Candidate], Sequence[KnownUnit] | None]
"""Answers the units, in order, that make a food in a state (the last one outputs it), or ``None``."""

Make = Callable[[ObjectNode], Sequence[KnownUnit] | None]
"""Answers the units, in order, that make a node (the last one outputs it), or ``None``."""


@dataclass(frozen=True)
class Preparations:
    """The ways to have foods ready in one kitchen; each is worked out once, for whatever recipe."""

    equivalents: Equivalents
    kitchen: Kitchen
    derive: Derive
    make: Make
    _made: Recent[RequiredIngredient, Ways] = field(default_factory=lambda: Recent(MOST_WANTS), repr=False)

    @cached_property
    def readings(self) -> Readings:
        """The scripts read in this kitchen."""
        return Readings(self.kitchen)

    def of(self, want: RequiredIngredient) -> Ways:
        """Answer the ways to make ``want``, best first.

        That is: with the fewest utensils that nobody has; fresh before stale; surest; shortest.
        """
        if want not in self._made:
            self._made[want] = self._ways(want)
        return self._made[want]

    def _ways(self, want: RequiredIngredient) -> Ways:
        if not self.kitchen.is_start_state(want.object, want.state):
            makes = [partial(self._processed, want, stand) for stand in (self.leaves_stand, self._leaves_given)]
            ways = Ways.among(self.equivalents.candidates(want), makes)
        elif is_whole(want.state):
            opened = (*self._opened(want), *self._parts(want))
            ways = Ways.known(sorted(opened, key=lambda made: (made.stale > 0, made.roughness, made.rank)))
        else:
            ways = Ways.among(self.equivalents.cooked(want), [partial(self._cooked, want)])
        if not isinstance(self.kitchen, StockedKitchen):
            return ways
        return Ways.known(sorted(ways, key=lambda made: (self._lacking(made), *made.rank)))

    def forms(self, want: RequiredIngredient) -> Iterator[tuple[ObjectNode, Preparation | None]]:
        """Answer what can join a tree as ``want``, best first; last the bare food, as it is sold or assumed to be."""
        for preparation in self.of(want):
            yield preparation.node, preparation
        yield ObjectNode(want.object, (want.state,) if want.state else ()), None

    def utensil(self, node: ObjectNode) -> tuple[Played, ...]:
        """Answer the steps that bring a utensil into its state, without any food; none where FOON knows none."""
        script = self.make(node)
        if not script:
            return ()
        casting = self._alone(script, {})
        replayed = replay(self.readings.of(script).play, casting)
        item = replayed.items.get(node)
        if item is None or item.node != node:
            return ()
        return tuple((step, casting) for step in needed(replayed.steps, node))

    def _alone(self, script: Sequence[KnownUnit], foods: Mapping[str, Recast]) -> Casting:
        """Answer the casting in which just these foods play, and every other one is dropped."""
        dropped: dict[str, Recast | None] = dict.fromkeys(self.readings.of(script).names)
        return Casting(dropped | dict(foods))

    def leaves_stand(self, line: FoodLine, recast: Recast) -> bool:
        """Say whether every leaf of ``line`` is at hand under its new name (contract, C6)."""
        return all(
            self.kitchen.is_start_state(recast.label, state) for node in line.leaves for state in recast.states_of(node)
        ) and not any(self.kitchen.is_mixture(node) for node in line.leaves)

    def _leaves_given(self, line: FoodLine, recast: Recast) -> bool:
        """Say whether the leaves of ``line`` that are not at hand are such as no unit of FOON makes: assumed, then."""
        return not any(self.kitchen.is_mixture(node) or self._is_made(node, recast) for node in line.leaves)

    def _is_made(self, node: ObjectNode, recast: Recast) -> bool:
        states = recast.states_of(node)
        at_hand = all(self.kitchen.is_start_state(recast.label, state) for state in states)
        return not at_hand and self.make(node) is not None

    def _processed(
        self, want: RequiredIngredient, stands: Callable[[FoodLine, Recast], bool], candidate: Candidate
    ) -> Iterator[Preparation]:
        script = self.derive(candidate)
        line = self.readings.of(script).lines.get(candidate.label) if script else None
        if not script or line is None:
            return
        cast = self.equivalents.recast(want, [candidate.state], line.made_by)
        if cast is not None and stands(line, cast[0]):
            peeled = self._peeled(candidate, script)
            made = [*self._executed(want, want.state, candidate, peeled, cast[0])] if peeled else ()
            yield from made or self._executed(want, want.state, candidate, script, cast[0])

    def _peeled(self, candidate: Candidate, script: Sequence[KnownUnit]) -> Sequence[KnownUnit] | None:
        """Answer the units that also peel what ``script`` cooks in its shell or skin, where FOON does so: an egg."""
        label, state = candidate.label, candidate.state
        if not motions.heats(script[-1].unit.motion) or any(opens_food(label, known) for known in script):
            return None
        for other in self.equivalents.states_known(label):
            if any(motions.peels(motion) for motion, _ in self.equivalents.motions_like(other)):
                longer = self.derive(Candidate(label, other, 1.0, 1.0))
                if longer and motions.peels(longer[-1].unit.motion) and opens_food(label, longer[-1]):
                    there = longer[-1].unit.input_nodes
                    if any(node.label == label and state in node.states for node in there):
                        return longer
        return None

    def _opened(self, want: RequiredIngredient) -> Iterator[Preparation]:
        for state in self.equivalents.states_known(want.object):
            if self.kitchen.is_start_state(want.object, state):
                continue
            script = self.derive(Candidate(want.object, state, 1.0, 1.0))
            if not script or not any(opens_food(want.object, known) for known in script):
                continue
            line = self.readings.of(script).lines.get(want.object)
            if line is None:
                continue
            starts = {start for node in line.leaves for start in node.states}
            cast = self.equivalents.recast(want, starts, ())
            if cast is not None and self.leaves_stand(line, cast[0]):
                candidate = Candidate(want.object, state, 1.0, cast[1])
                prepared = self._executed(want, state, candidate, script, cast[0])
                yield from (preparation for preparation in prepared if shows(want, preparation.steps))

    def _cooked(self, want: RequiredIngredient, candidate: Candidate) -> Iterator[Preparation]:
        """Answer how a food that is asked raw is cooked as ``candidate`` is."""
        script = self.derive(candidate)
        line = self.readings.of(script).lines.get(candidate.label) if script else None
        if not script or line is None:
            return
        starts = {start for node in line.leaves for start in node.states}
        cast = self.equivalents.recast(want, starts, ())
        if cast is not None and self.leaves_stand(line, cast[0]):
            sure = replace(candidate, state_confidence=cast[1])
            made = self._executed(want, candidate.state, sure, script, cast[0])
            yield from (way for way in made if way.is_cooked and shows(want, way.steps))

    def _parts(self, want: RequiredIngredient) -> Iterator[Preparation]:
        """Answer what a food becomes when it is opened, and is called after it: an egg its white and yolk."""
        for label, state in self.equivalents.parts(want.object):
            script = self.derive(Candidate(label, state, 1.0, 1.0))
            lines = self.readings.of(script).lines if script else {}
            if not script or want.object not in lines or not opens_food(want.object, script[-1]):
                continue
            starts = {start for node in lines[want.object].leaves for start in node.states}
            cast = self.equivalents.recast(want, starts, ())
            made = [node for node in script[-1].unit.output_nodes if self.kitchen.is_food(node)]
            if cast is None or not self.leaves_stand(lines[want.object], cast[0]) or len(made) > 1:
                continue
            casting = replace(self._alone(script, {want.object: cast[0]}), carried=frozenset({want.object}))
            replayed = replay(self.readings.of(script).play, casting)
            item = replayed.items.get(made[0])
            steps = tuple(needed(replayed.steps, item.node)) if item is not None else ()
            if item is not None and want.object in item.node.ingredients and steps and shows(want, steps):
                candidate = Candidate(want.object, state, 1.0, cast[1])
                yield Preparation(want, item.node, steps, casting, candidate, stale(steps, self.kitchen))

    def _executed(
        self, want: RequiredIngredient, state: str, candidate: Candidate, script: Sequence[KnownUnit], recast: Recast
    ) -> Iterator[Preparation]:
        """Execute ``script``; its last unit must leave the food, as it is called now, in ``state``."""
        casting = self._alone(script, {candidate.label: recast})
        replayed = replay(self.readings.of(script).play, casting)
        for target in script[-1].unit.output_nodes:
            item = replayed.items.get(target)
            if target.label != candidate.label or candidate.state not in target.states or item is None:
                continue
            steps = tuple(needed(replayed.steps, item.node))
            odd = not steps or any(step.strained for step in steps)  # the food it leaned on was nobody's wish
            odd = odd or not self._lies_in_a_utensil(item.node)
            if not odd and item.node.label == want.object and state in item.node.states:
                yield Preparation(want, item.node, steps, casting, candidate, stale(steps, self.kitchen))
                return

    def _lacking(self, made: Preparation) -> int:
        """Count the utensils of a preparation that are not among those a person named."""
        nodes = {node for step in made.steps for node in step.input_nodes if not self.kitchen.is_food(node)}
        return sum(map(self.kitchen.lacks, nodes))

    def _lies_in_a_utensil(self, node: ObjectNode) -> bool:
        """Say whether a food is where it can be taken from: butter spread on bread needs the bread."""
        return node.container is None or self.kitchen.is_utensil(node.container)


def is_whole(state: str) -> bool:
    """Say whether a food asked in ``state`` is asked whole (sense, S3)."""
    return "whole" in state.split()


def shows(want: RequiredIngredient, steps: Sequence[Step]) -> bool:
    """Say whether a node of ``steps`` is the wanted food in the wanted state."""
    return any(
        node.label == want.object and (not want.state or want.state in node.states)
        for step in steps
        for node in (*step.input_nodes, *step.output_nodes)
    )


def needed(steps: Sequence[Step], goal: ObjectNode) -> list[Step]:
    """Answer the steps that lead to ``goal``, in their order: from the last that makes it, backwards."""
    wanted = {goal}
    kept: list[Step] = []
    for step in reversed(steps):
        made = wanted.intersection(step.output_nodes)
        if made and not made.issubset(step.input_nodes):
            kept.append(step)
            wanted -= made
            wanted.update(step.input_nodes)
    return kept[::-1]


def stale(steps: Sequence[Step], kitchen: Kitchen) -> int:
    """Count the steps that take a food, or a vessel with food, that an earlier step moved or changed (sense, S1)."""
    taken: set[ObjectNode] = set()
    count = 0
    for step in steps:
        holds_food = [node for node in step.input_nodes if kitchen.is_food(node) or kitchen.foods_in(node)]
        count += not taken.isdisjoint(holds_food)
        left = {node.label for node in step.output_nodes}
        taken |= {node for node in holds_food if node.label in left and node not in step.output_nodes}
        taken -= set(step.output_nodes)
    return count
