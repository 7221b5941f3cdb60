"""The cheapest set that has a member of each of several sets: branch and bound with dual ascent.

Sets are integers with one bit a member.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from foon_kg.search.core import bits_of
from foon_kg.search.deadline import Deadline


@dataclass(eq=False)
class HittingSets:
    """Questions about sets whose members have these ``costs``.

    What was found out before the ``deadline`` is ``known``: for sets that hang together, the limit under which a
    cheapest set that hits them was looked for, and what was found. The same come again, in one question and the next.
    """

    costs: Sequence[int]
    deadline: Deadline
    known: dict[tuple[int, ...], tuple[float, int | None]] = field(default_factory=dict)

    def cheapest(self, sets: Sequence[int], limit: float = math.inf) -> int | None:
        """Return a cheapest set that hits all ``sets`` at a cost of at most ``limit``; ``None`` where there is none.

        Sets that share no member, not even through others, are hit apart. Where the deadline passes, the answer may be
        ``None`` or a dearer set.
        """
        parts = parts_of(_undominated(minimal(sets), self.costs))
        bounds = [ascent(part, self.costs)[0] for part in parts]
        chosen, spare = 0, limit - sum(bounds)
        for part, bound in zip(parts, bounds, strict=True):
            found = self._cheapest_of_part(part, bound + spare) if spare >= 0 else None
            if found is None:
                return None
            chosen |= found
            spare -= self.cost_of(found) - bound
        return chosen if spare >= 0 else None

    def members_of_cheapest(self, sets: Sequence[int]) -> int:
        """Return all members of all cheapest sets that hit ``sets``; where the deadline passes, perhaps others too."""
        possible = 0
        for part in parts_of(minimal(sets)):
            possible |= self._members_of_part(part)
        return possible

    def _members_of_part(self, part: tuple[int, ...]) -> int:
        """Return the members of all cheapest sets that hit a part that shares no member with the others."""
        bound, left = ascent(part, self.costs)
        found = self.cheapest(part)
        least = math.inf if found is None else self.cost_of(found)
        possible = found or 0
        for member in left:
            if not possible >> member & 1 and bound + left[member] <= least:
                found = self.cheapest(_without(part, member), least - self.costs[member])
                if found is not None or self.deadline.has_passed():
                    possible |= (found or 0) | 1 << member
        return possible

    def cost_of(self, members: int) -> int:
        """Return the sum of the costs of ``members``, a set with one bit a member."""
        return sum(self.costs[member] for member in bits_of(members))

    def _cheapest_of_part(self, sets: tuple[int, ...], limit: float) -> int | None:
        tried, found = self.known.get(sets, (-1, None))
        if found is not None:
            return found if self.cost_of(found) <= limit else None
        if limit <= tried:
            return None
        found = self._with_a_member_of_the_smallest(sets, limit)
        if not self.deadline.has_passed():
            self.known[sets] = (limit, found)
        return found

    def _with_a_member_of_the_smallest(self, sets: tuple[int, ...], limit: float) -> int | None:
        bound, left = ascent(sets, self.costs)
        best, barred = None, 0
        for member in sorted(bits_of(sets[0]), key=lambda member: (left[member], self.costs[member], member)):
            if bound + left[member] <= limit and not self.deadline.has_passed():
                rest = [one & ~barred for one in sets if not one >> member & 1]
                found = self.cheapest(rest, limit - self.costs[member]) if all(rest) else None
                if found is not None:
                    best = found | 1 << member
                    limit = self.cost_of(best) - 1
            barred |= 1 << member  # from here on: without it
        return best


def _undominated(sets: list[int], costs: Sequence[int]) -> list[int]:
    """Return ``sets`` without the members in whose place another one, not dearer, hits the same sets and more."""
    beside: dict[int, int] = {}  # for each member, those that are in every set in which it is
    for one in sets:
        for member in bits_of(one):
            beside[member] = beside.get(member, one) & one
    idle = 0
    for member, rivals in beside.items():
        for rival in bits_of(rivals & ~idle & ~(1 << member)):
            equal = costs[rival] == costs[member] and beside[rival] >> member & 1
            if rival < member if equal else costs[rival] <= costs[member]:
                idle |= 1 << member
                break
    return minimal([one & ~idle for one in sets]) if idle else sets


def _without(sets: Iterable[int], member: int) -> list[int]:
    """Return the ``sets`` that ``member`` does not hit."""
    return [one for one in sets if not one >> member & 1]


def parts_of(sets: Sequence[int]) -> list[tuple[int, ...]]:
    """Return ``sets`` (one bit a member) in groups that have no member in common, in each the smallest first."""
    parts: list[tuple[int, list[int]]] = []
    for one in sets:
        members, group, apart = one, [one], []
        for part in parts:
            if part[0] & members:
                members, group = members | part[0], [*part[1], *group]
            else:
                apart.append(part)
        parts = [*apart, (members, group)]
    return [tuple(sorted(group, key=lambda one: (one.bit_count(), one))) for _, group in parts]


def minimal(sets: Sequence[int]) -> list[int]:
    """Return ``sets`` (one bit a member) without those that have another one of them in them, the smallest first."""
    kept = list[int]()
    for one in sorted(set(sets), key=lambda members: (members.bit_count(), members)):
        if not any(other & one == other for other in kept):
            kept.append(one)
    return kept


def ascent(sets: Sequence[int], costs: Sequence[int]) -> tuple[int, dict[int, int]]:
    """Return what hitting all ``sets`` costs at least, and what of the cost of each member that leaves unpaid.

    Each set in turn pays as much as its cheapest member still costs: a solution of the dual linear program.
    """
    bound, left = 0, dict[int, int]()
    for one in sets:
        members = bits_of(one)
        price = min([left.get(member, costs[member]) for member in members])
        bound += price
        for member in members:
            left[member] = left.get(member, costs[member]) - price
    return bound, left
