"""What is asked of the search, and what it returns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.plans.shortage import ShortageError
from foon_kg.search.unit_index import UnitIndex

Objective = tuple[int, int, int]
"""(gap penalty, minus the overlap, units): the lesser the better."""


@dataclass(frozen=True, eq=False)
class SearchProblem:
    """One question to a FOON: the best tree that makes any one of ``targets``.

    ``wanted`` maps a food's label to the number (0 and up) of the required ingredient that it stands for; several
    labels may stand for one. ``available`` are nodes that another tree has made already: they cost nothing, and a
    target among them needs no unit. A target is made by a unit even where the kitchen has it.
    """

    index: UnitIndex
    targets: tuple[ObjectNode, ...]
    wanted: Mapping[str, int] = field(default_factory=dict)
    available: frozenset[ObjectNode] = frozenset()


@dataclass(frozen=True)
class Bound:
    """What is proven about the best tree where the search was stopped: no tree is better than this in any part."""

    penalty: int
    overlap: int
    units: int

    @property
    def objective(self) -> Objective:
        """(gap penalty, minus the overlap, units): the lesser the better."""
        return (self.penalty, -self.overlap, self.units)


def weakest(bounds: Sequence[Bound]) -> Bound:
    """Return what holds for the best of several trees, of each of which one of ``bounds`` holds."""
    return Bound(
        penalty=min(bound.penalty for bound in bounds),
        overlap=max(bound.overlap for bound in bounds),
        units=min(bound.units for bound in bounds),
    )


@dataclass(frozen=True)
class ReferenceTree:
    """A task tree as FOON knows it: ``units`` in an order in which they can be executed.

    Every input of a unit is at hand, available, one of ``gaps`` or an output of an earlier unit; the last unit outputs
    ``goal``. ``penalty`` is the sum of the costs of the gaps, ``covered`` the numbers of the wanted foods that occur.
    ``exact`` says that no other tree is better; ``bound`` is there where that is not proven.
    """

    goal: ObjectNode
    units: tuple[KnownUnit, ...]
    gaps: tuple[ObjectNode, ...]
    penalty: int
    covered: tuple[int, ...]
    exact: bool
    bound: Bound | None = None

    @property
    def overlap(self) -> int:
        """How many of the wanted foods occur in the tree."""
        return len(self.covered)

    @property
    def objective(self) -> Objective:
        """(gap penalty, minus the overlap, units): the lesser the better."""
        return (self.penalty, -self.overlap, len(self.units))

    @property
    def rank(self) -> tuple[object, ...]:
        """The total order between trees: the objective, then the sorted keys of the units, the gaps and the goal."""
        keys = tuple(sorted(known.unit.key for known in self.units))
        return (*self.objective, keys, tuple(gap.sort_key for gap in self.gaps), self.goal.sort_key)


class NoWayError(ShortageError):
    """Nothing makes the goal, not even with gaps. ``missing`` are the nodes that nobody has or makes, nearest first."""

    code = "no-way"
