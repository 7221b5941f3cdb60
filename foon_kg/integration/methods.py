"""What a FOON teaches of making dishes: its operators, its frames, and where foods of each kind join."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

from foon_kg.food import Tables, tables
from foon_kg.integration.joining.joining_counts import JoiningCounts
from foon_kg.integration.joining.layouts import Layout
from foon_kg.integration.joining.outlines import Outline, Outlines
from foon_kg.integration.teaching.derivation import frames_of
from foon_kg.integration.teaching.frames import Frame
from foon_kg.integration.teaching.operators import Operators
from foon_kg.model import FunctionalUnit, Goal, KnownUnit, ObjectNode
from foon_kg.model.knowledge import KnowledgeView


@dataclass(frozen=True, eq=False)
class Methods:
    """Operators with their evidence, and a frame for each goal of each video, sorted by video and goal.

    What is worked out of the frames is kept: every recipe asks for it.
    """

    operators: Operators
    frames: tuple[Frame, ...]
    goals: tuple[Goal, ...]

    @classmethod
    def of(cls, units: Collection[KnownUnit], goals: Iterable[Goal], known: Tables | None = None) -> Methods:
        """Learn from the units of a FOON, which say where they were seen, and from its goals.

        ``known`` are the tables, by default those of the package.
        """
        known = known or tables()
        goals = tuple(goals)
        return cls(Operators(units, known), frames_from(units, goals, known), goals)

    @cached_property
    def joining_counts(self) -> JoiningCounts:
        """Where foods of each kind join."""
        return JoiningCounts(self.frames, self.operators.known)

    @cached_property
    def layouts(self) -> Mapping[str, Layout]:
        """The places of each frame, by its key."""
        return {frame.key: Layout.of(frame, self.operators.known) for frame in self.frames}

    @cached_property
    def outlines(self) -> Outlines:
        """What of each frame tells whether it is worth a closer look."""
        return Outlines(Outline.of(layout, self.operators.known) for layout in self.layouts.values())

    def layouts_of(self, keys: Iterable[str]) -> list[Layout]:
        """Return the places of the frames of some keys, in that order."""
        return [self.layouts[key] for key in keys]

    def goal_of(self, frame: Frame) -> Goal:
        """Return the goal that a frame is of."""
        return next(goal for goal in self._goals_of[frame.goal] if frame.video in goal.videos)

    @cached_property
    def _goals_of(self) -> Mapping[ObjectNode, tuple[Goal, ...]]:
        found: defaultdict[ObjectNode, tuple[Goal, ...]] = defaultdict(tuple)
        for goal in self.goals:
            found[goal.node] += (goal,)
        return found

    @cached_property
    def cooked_by(self) -> Mapping[str, tuple[str, ...]]:
        """By kind (or ``trait:…``) the motion by which such foods are most often cooked by themselves."""
        found = {}
        for name, counts in self.joining_counts.cooked.items():
            motion = min(counts, key=lambda motion: (-counts[motion], motion))
            found[name] = (motion,)
        return found


def frames_from(units: Iterable[KnownUnit], goals: Iterable[Goal], known: Tables) -> tuple[Frame, ...]:
    """Return the frames of all ``goals``, each from every video among ``units`` that makes it.

    ``known`` are the tables.
    """
    wanted: defaultdict[str, list[tuple[str, Goal]]] = defaultdict(list)
    for goal in goals:
        for video in goal.videos:
            wanted[video].append((goal.dish_type, goal))
    recorded: defaultdict[str, dict[int, FunctionalUnit]] = defaultdict(dict)
    for known_unit in units:
        for sighting in known_unit.seen_in:
            if sighting.video in wanted:
                recorded[sighting.video][sighting.position] = known_unit.unit
    frames: list[Frame] = []
    for video in sorted(wanted):
        sequence = [unit for _, unit in sorted(recorded[video].items())]
        pairs = [(goal.node, dish_type) for dish_type, goal in wanted[video]]
        frames += frames_of(sequence, pairs, video, known)
    return tuple(sorted(frames, key=lambda frame: (frame.video, frame.goal.sort_key, frame.dish_type)))


class TeachingView(KnowledgeView, Protocol):
    """What a planner asks of a FOON: all that it knows, and what it teaches of making dishes."""

    def methods(self) -> Methods:
        """Return what the FOON teaches of making dishes: its operators and frames."""
        ...

    def methods_for(self, foods: Collection[str], dish_type: str) -> Methods:
        """Return what of that matters to a dish of ``foods``; it may be more, up to all of it."""
        ...
