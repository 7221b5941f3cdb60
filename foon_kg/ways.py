"""The ways to have one food ready, best first, each worked out no sooner than somebody asks for it.

To make a food as its equivalent is made takes a search in FOON for each of its candidates, and mostly the surest one
will do. What is told of a way does not depend on when it was worked out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from typing import Self, overload

from foon_kg import motions
from foon_kg.food.lists import word_list
from foon_kg.kitchen import words
from foon_kg.model import ObjectNode, RequiredIngredient
from foon_kg.script import Casting, Step
from foon_kg.substitution import Candidate

_SPOILT = word_list("spoilt")
"""Words of states in which an opened food is as good as whole still, or in which little of it is left."""


@dataclass(frozen=True)
class Preparation:
    """A required food made apart: its steps, the casting they are played with, and the node that is ready.

    ``candidate`` is the equivalent whose units these are. ``stale`` counts the steps that take what an earlier step
    took away.
    """

    want: RequiredIngredient
    node: ObjectNode
    steps: tuple[Step, ...]
    casting: Casting
    candidate: Candidate
    stale: int

    @property
    def confidence(self) -> float:
        """How likely a cook would accept what the candidate stands for."""
        return self.candidate.confidence

    @cached_property
    def rank(self) -> tuple[object, ...]:
        """The order of the ways to make one food: fresh before stale, surest, shortest, then by content."""
        return (
            self.stale > 0,
            -round(self.confidence, 4),
            len(self.steps),
            self.node.sort_key,
            [step.known.unit.key for step in self.steps],
        )

    @property
    def is_cooked(self) -> bool:
        """Whether a food that is sold raw was heated: an egg that was boiled before it was peeled."""
        return any(motions.heats(step.motion) for step in self.steps)

    @cached_property
    def roughness(self) -> int:
        """How far from how a cook opens a food: 0 where it was peeled, 1 where it was cut, 2 where it is spoilt."""
        if any(not _SPOILT.isdisjoint(words(state)) for state in self.node.states):
            return 2
        return 0 if any(motions.peels(step.motion) for step in self.steps) else 1

    def clashes(self, other: Preparation) -> bool:
        """Say whether a step of each uses up the same food, or vessel with food, and they are not the same step."""
        own, theirs = self._used_up, other._used_up
        return any(theirs.get(node, step) != step for node, step in own.items())

    @cached_property
    def _used_up(self) -> dict[ObjectNode, tuple[object, ...]]:
        """For each food, or vessel that was filled, that a step uses up, what is done in that step."""
        made = {node for step in self.steps for node in step.output_nodes}
        return {
            node: (frozenset(step.input_nodes), step.motion, frozenset(step.output_nodes))
            for step in self.steps
            for node in step.input_nodes
            if node not in step.output_nodes and (node.label == self.want.object or (node.ingredients and node in made))
        }


Make = Callable[[Candidate], Iterable[Preparation]]
"""Answers how a food is made ready as a candidate is; nothing where that does not work."""


class Ways(Sequence[Preparation]):
    """Ways to have one food ready, in an order that is known; make one with :meth:`known` or :meth:`among`."""

    def __init__(self, found: Iterable[Preparation], untried: Iterable[tuple[Make, Sequence[Candidate]]]) -> None:
        self._found = list(found)
        self._stale: list[Preparation] = []
        self._untried = [*untried][::-1]

    @classmethod
    def known(cls, found: Iterable[Preparation]) -> Self:
        """Answer the ways ``found``, which are all there are, in their order."""
        return cls(found, ())

    @classmethod
    def among(cls, candidates: Iterable[Candidate], makes: Iterable[Make]) -> Self:
        """Answer the ways to make a food like one of ``candidates``, which come surest first, in the order of rank.

        Those of ``makes`` are tried one after the other until one of them makes anything of any candidate.
        """
        alike = groupby(candidates, key=lambda candidate: round(candidate.confidence, 4))  # as their rank has it
        groups = [list(group) for _, group in alike]
        return cls((), [(make, group) for make in makes for group in groups])

    def surer_than(self, confidence: float) -> bool:
        """Say whether one of them is fresh and surer than ``confidence``; only what may be so is worked out."""
        while not any(way.confidence > confidence and not way.stale for way in self._found):
            if not any(group[0].confidence > confidence for _, group in self._untried):
                return False
            self._work_out()
        return True

    def _work_out(self) -> None:
        """Work out the next ways that are equally sure; the stale ones are kept to the end."""
        make, group = self._untried.pop()
        found = sorted((way for candidate in group for way in make(candidate)), key=lambda way: way.rank)
        if found:
            self._untried = [(other, later) for other, later in self._untried if other is make]
        self._found += [way for way in found if not way.stale]
        self._stale += [way for way in found if way.stale]
        if not self._untried:
            self._found += self._stale

    def __iter__(self) -> Iterator[Preparation]:
        place = 0
        while True:
            while place == len(self._found) and self._untried:
                self._work_out()
            if place == len(self._found):
                return
            yield self._found[place]
            place += 1

    def __bool__(self) -> bool:
        return next(iter(self), None) is not None

    def __len__(self) -> int:
        return sum(1 for _ in self)

    @overload
    def __getitem__(self, place: int) -> Preparation: ...
    @overload
    def __getitem__(self, place: slice) -> list[Preparation]: ...
    def __getitem__(self, place: int | slice) -> Preparation | list[Preparation]:
        return [*self][place]
