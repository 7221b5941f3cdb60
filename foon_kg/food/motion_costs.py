"""How hard each motion is for a robot, and so how likely it succeeds."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction

UNKNOWN_COST = 0.5
"""What a motion costs that the table does not name: neither easy nor hard. Answers say where it was assumed."""


@dataclass(frozen=True)
class MotionCosts:
    """The cost of motions by name, from 0 (a robot always succeeds) to 1 (it never does).

    A cost is taken as the share of tries that fail: the success rate of a motion is 1 less its cost, exactly, as the
    number is written (0.9 leaves 1/10). Units succeed independently of each other: a tree, with the product.
    """

    costs: Mapping[str, float] = field(default_factory=dict)

    def __bool__(self) -> bool:
        """Whether there is any cost."""
        return bool(self.costs)

    def success(self, motion: str) -> Fraction:
        """Return the success rate of ``motion``, from 0 to 1; one that has no cost has that of :data:`UNKNOWN_COST`.

        >>> costs = MotionCosts({"pour": 0.1})
        >>> costs.success("pour"), costs.success("whip")
        (Fraction(9, 10), Fraction(1, 2))
        """
        return 1 - Fraction(repr(self.costs.get(motion, UNKNOWN_COST)))

    def unknown(self, motions: Iterable[str]) -> tuple[str, ...]:
        """Return which of ``motions`` have no cost, sorted and each once.

        >>> MotionCosts({"pour": 0.1}).unknown(["whip", "pour", "chop"])
        ('chop', 'whip')
        """
        return tuple(sorted(set(motions) - self.costs.keys()))


NO_COSTS = MotionCosts()
"""The table that names no motion."""
