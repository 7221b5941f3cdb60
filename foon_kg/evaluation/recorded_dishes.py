"""The dishes that the videos of a FOON make, each asked for as a cook would ask for it."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

from foon_kg.evaluation.left_out_video import left_out_video
from foon_kg.model import Goal, Recipe
from foon_kg.store.snapshot import Snapshot

_FEW, _MANY = 4, 7
"""A dish of so many foods shows what a plan is, and still fits on a card."""


@dataclass(frozen=True)
class RecordedDish:
    """A ``goal`` of the FOON, and the ``recipe`` that asks for it: its type, and its foods as they first join others.

    The recipe is named after the goal's first video.
    """

    goal: Goal
    recipe: Recipe

    @property
    def texts(self) -> tuple[str, ...]:
        """The ingredients in words: "chopped onion"."""
        return tuple(f"{wanted.state} {wanted.object}".strip() for wanted in self.recipe.ingredients)


def recorded_dishes(snapshot: Snapshot) -> Iterator[RecordedDish]:
    """Yield the dishes that videos in ``snapshot`` make, types by turns.

    The first are those that show best what a plan is. Videos that do not ask for their goal are passed over.
    """
    for goal in _by_turns(snapshot.goals()):
        subgraph = next(one for one in snapshot.subgraphs if one.name == goal.videos[0])
        asked = left_out_video(subgraph, snapshot.kitchen)
        if asked is not None and asked.recipe.dish_type == goal.dish_type:
            yield RecordedDish(goal, asked.recipe)


def _by_turns(goals: tuple[Goal, ...]) -> Iterator[Goal]:
    """Yield a goal of each dish type, those of most videos first, then another of each, and so on."""
    videos, of_type = Counter[str](), defaultdict[str, list[Goal]](list)
    for goal in sorted(goals, key=_rank):
        videos[goal.dish_type] += len(goal.videos)
        of_type[goal.dish_type].append(goal)
    types = sorted(videos, key=lambda name: (-videos[name], name))
    for turn in range(max(map(len, of_type.values()), default=0)):
        yield from (of_type[name][turn] for name in types if turn < len(of_type[name]))


def _rank(goal: Goal) -> tuple[object, ...]:
    """Return what puts those first that show best what a plan is: of some foods, with a name of their own."""
    foods = len(goal.ingredients)
    return (max(_FEW - foods, foods - _MANY, 0), goal.node.label == goal.dish_type, -foods, goal.node.sort_key)
