"""Operators of annotated videos, with what drafts of recipes say where no video says anything.

Nobody has watched a draft: it is evidence for a food or kind of food to which no video does a thing in that way, and
never beside a video.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable
from typing import TypeVar

from foon_kg.food import Tables
from foon_kg.integration.teaching.operators import Evidence, Operators
from foon_kg.model import KnownUnit

K = TypeVar("K", bound=Hashable)
W = TypeVar("W", bound=Hashable)


class DraftedOperators(Operators):
    """The operators of ``videos``, filled up with those of ``drafts``.

    Of the foods that drafts name only those count that the tables of foods have: their other names are guesses.
    """

    def __init__(self, videos: Iterable[KnownUnit], drafts: Iterable[KnownUnit], known: Tables) -> None:
        super().__init__(videos, known)
        drafted = Operators(drafts, known)
        for own, others in ((self.evidence, drafted.evidence), (self.acts, drafted.acts)):
            for way, evidence in others.items():
                self._fill(own[way], evidence)
        _fill_counts(self.giving, drafted.giving)
        _fill_counts(self.bringing, drafted.bringing)
        _fill_counts(self.onto, drafted.onto)
        listed = {food for food in drafted.foods if known.foods.is_listed(food)}
        self.foods |= listed
        for name, states in drafted.states.items():
            if name in listed or name.startswith("kind:"):
                self.states[name].update(states)

    def _fill(self, own: Evidence, drafted: Evidence) -> None:
        for food in sorted(drafted.foods.keys() - own.foods.keys()):
            if self.known.foods.is_listed(food):
                own.foods[food] = drafted.foods[food]
                own.often[food] = drafted.often[food]
        for kind in sorted(drafted.kinds.keys() - own.kinds.keys()):
            own.kinds[kind] = drafted.kinds[kind]
        if not own.all:
            own.all, own.count = drafted.all, drafted.count
        for appliance in sorted(drafted.appliances.keys() - own.appliances.keys()):
            own.appliances[appliance] = drafted.appliances[appliance]


def _fill_counts(own: dict[K, Counter[W]], drafted: dict[K, Counter[W]]) -> None:
    """Take over the counts of what no video shows."""
    for key, counts in drafted.items():
        if key not in own:
            own[key] = counts
