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
        told = Operators(drafts, known)
        for own, others in ((self.evidence, told.evidence), (self.acts, told.acts)):
            for way, evidence in others.items():
                self._fill(own[way], evidence)
        _fill_counts(self.giving, told.giving)
        _fill_counts(self.bringing, told.bringing)
        _fill_counts(self.onto, told.onto)
        listed = {food for food in told.foods if known.foods.is_listed(food)}
        self.foods |= listed
        for name, states in told.states.items():
            if name in listed or name.startswith("kind:"):
                self.states[name].update(states)

    def _fill(self, own: Evidence, told: Evidence) -> None:
        for food in sorted(told.foods.keys() - own.foods.keys()):
            if self.known.foods.is_listed(food):
                own.foods[food] = told.foods[food]
                own.often[food] = told.often[food]
        for kind in sorted(told.kinds.keys() - own.kinds.keys()):
            own.kinds[kind] = told.kinds[kind]
        if not own.all:
            own.all, own.count = told.all, told.count
        if not own.appliances:
            own.appliances.update(told.appliances)


def _fill_counts(own: dict[K, Counter[W]], told: dict[K, Counter[W]]) -> None:
    """Take over the counts of what no video shows."""
    for key in told.keys() - own.keys():
        own[key] = told[key]
