"""Foods by what cooks use them for: the groups and shelves of ``food-groups.txt``.

A food that the table does not list is placed by its last words, or else by the listed foods nearest to it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from importlib.resources import files

import numpy as np
import numpy.typing as npt

from foon_kg.model.names import canonical

Memberships = npt.NDArray[np.float64]
Nearness = Callable[[Sequence[str]], Memberships]
"""How near (0..1) each of some names is to every listed food, in the order of ``FoodGroups.foods``."""

_SHORTENED = 0.9  # "sweet italian basil" is some basil
_NEAREST = 8  # listed foods vote on the groups of a name that is not listed
_AT_ONCE = 512  # names whose nearness to two thousand listed foods is in memory at a time: 9 MB
_SHARPNESS = 12.0  # a food that is nearer by 0.1 has three times the vote


@dataclass(frozen=True, eq=False)
class FoodGroups:
    """Which groups the listed ``foods`` are in (one row of ``listed`` each), and on which shelf each group stands."""

    groups: tuple[str, ...]
    shelf_names: tuple[str, ...]
    shelf_of: npt.NDArray[np.int64]
    foods: tuple[str, ...]
    listed: Memberships
    places: dict[str, int]

    def rows(self, names: Sequence[str], nearness: Nearness) -> Memberships:
        """Return one row of memberships (0 to 1 in each group) for each canonical name.

        ``nearness`` says how near a name is to those that the groups list.
        """
        rows = np.zeros((len(names), len(self.groups)))
        strange = []
        for row, name in enumerate(names):
            if name in self.places:
                rows[row] = self.listed[self.places[name]]
            elif (place := self._place_of_ending(name)) is not None:
                rows[row] = _SHORTENED * self.listed[place]
            else:
                strange.append(row)
        for start in range(0, len(strange), _AT_ONCE):
            some = strange[start : start + _AT_ONCE]
            rows[some] = self._votes(nearness([names[row] for row in some]))
        return rows

    def shelves(self, memberships: Memberships) -> Memberships:
        """Return the memberships in shelves that those in groups amount to."""
        order, starts = self._by_shelf
        return np.maximum.reduceat(memberships[:, order], starts, axis=1)

    @cached_property
    def _by_shelf(self) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.intp]]:
        """The groups in the order of their shelves, and where each shelf begins; there is none without a group."""
        order = np.argsort(self.shelf_of, kind="stable")
        return order, np.searchsorted(np.asarray(self.shelf_of)[order], np.arange(len(self.shelf_names)))

    def on_shelves(self, *names: str) -> Memberships:
        """Return for each group 1 where it stands on one of these shelves, else 0."""
        return np.isin(self.shelf_of, [self.shelf_names.index(name) for name in names]).astype(np.float64)

    def of(self, name: str) -> tuple[str, ...]:
        """Return the groups in which the table lists a canonical name, in the order of the table."""
        if name not in self.places:
            return ()
        return tuple(group for group, member in zip(self.groups, self.listed[self.places[name]], strict=True) if member)

    def has_ending(self, name: str) -> bool:
        """Return whether the table lists a canonical name, or the last words of it."""
        return name in self.places or self._place_of_ending(name) is not None

    def _place_of_ending(self, name: str) -> int | None:
        words = name.split()
        endings = (" ".join(words[start:]) for start in range(1, len(words)))
        return next((self.places[ending] for ending in endings if ending in self.places), None)

    def _votes(self, near: Memberships) -> Memberships:
        """Return the memberships that the listed foods ``near`` each name give it, one row for each name."""
        votes = np.zeros((len(near), len(self.groups)))
        least = np.partition(near, -_NEAREST, axis=1)[:, -_NEAREST]
        for row in np.flatnonzero(near.max(axis=1) > 0):  # what is near to nothing is in no group
            votes[row] = self._vote(near[row], np.flatnonzero(near[row] >= least[row]))
        return votes

    def _vote(self, near: Memberships, among: npt.NDArray[np.intp]) -> Memberships:
        nearest = among[np.argsort(-near[among], kind="stable")][:_NEAREST]
        weights = np.exp(_SHARPNESS * (near[nearest] - 1)) * (near[nearest] > 0)
        votes: Memberships = weights @ self.listed[nearest] / max(float(weights.sum()), np.finfo(float).tiny)
        return votes * max(float(near[nearest[0]]), 0.0)


@lru_cache(maxsize=1)
def food_groups() -> FoodGroups:
    """Return the groups that ship with foon-kg, read once."""
    text = files("foon_kg.similarity").joinpath("food-groups.txt").read_text(encoding="utf-8")
    lines = [line.partition(":") for line in text.splitlines() if line and not line.startswith("#")]
    members = [sorted(set(map(canonical, foods.split(",")))) for _, _, foods in lines]
    foods = sorted(set().union(*members))
    places = {food: place for place, food in enumerate(foods)}
    listed = np.zeros((len(foods), len(lines)))
    for group, names in enumerate(members):
        listed[[places[name] for name in names], group] = 1.0
    shelf_names, groups = zip(*(heading.split(" / ")[:2] for heading, _, _ in lines), strict=True)
    shelves = sorted(set(shelf_names))
    shelf_of = np.array([shelves.index(name) for name in shelf_names])
    return FoodGroups(groups, tuple(shelves), shelf_of, tuple(foods), listed, places)
