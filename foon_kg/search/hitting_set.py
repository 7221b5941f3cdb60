"""The cheapest set that has a member of each of several sets: branch and bound with dual ascent.

Sets are integers with one bit a member.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from foon_kg.search.core import bits_of
from foon_kg.search.deadline import Deadline


def cheapest_hitting_set(
    sets: Sequence[int], costs: Sequence[int], deadline: Deadline, *, limit: float = math.inf
) -> int | None:
    """Answer a cheapest set that hits all ``sets`` at a cost of at most ``limit``; ``None`` where there is none.

    Sets that share no member, not even through others, are hit apart. Where the deadline passes, the answer may be
    ``None`` or a dearer set.
    """
    parts = _parts(_undominated(minimal(sets), costs))
    bounds = [ascent(part, costs)[0] for part in parts]
    chosen, spare = 0, limit - sum(bounds)
    for part, bound in zip(parts, bounds, strict=True):
        if spare < 0:
            return None
        found = _hitting_all(part, costs, deadline, bound + spare)
        if found is None:
            return None
        chosen |= found
        spare -= cost_of(found, costs) - bound
    return chosen if spare >= 0 else None


def members_of_cheapest(sets: Sequence[int], costs: Sequence[int], deadline: Deadline) -> int:
    """Answer all members of all cheapest sets that hit ``sets``; where the deadline passes, perhaps others as well."""
    possible = 0
    for part in _parts(minimal(sets)):
        bound, left = ascent(part, costs)
        found = cheapest_hitting_set(part, costs, deadline)
        least = math.inf if found is None else cost_of(found, costs)
        possible |= found or 0
        for member in left:
            if not possible >> member & 1 and bound + left[member] <= least:
                others = [one for one in part if not one >> member & 1]
                found = cheapest_hitting_set(others, costs, deadline, limit=least - costs[member])
                if found is not None or deadline.has_passed():
                    possible |= (found or 0) | 1 << member
    return possible


def cost_of(members: int, costs: Sequence[int]) -> int:
    """Answer the sum of the costs of ``members``."""
    return sum(costs[member] for member in bits_of(members))


def _hitting_all(sets: Sequence[int], costs: Sequence[int], deadline: Deadline, limit: float) -> int | None:
    """Answer a cheapest set that hits all ``sets``, by choosing a member of the smallest and going on."""
    bound, left = ascent(sets, costs)
    best, barred = None, 0
    for member in sorted(bits_of(sets[0]), key=lambda member: (left[member], costs[member], member)):
        if bound + left[member] <= limit and not deadline.has_passed():
            rest = [one & ~barred for one in sets if not one >> member & 1]
            if all(rest):
                found = cheapest_hitting_set(rest, costs, deadline, limit=limit - costs[member])
                if found is not None:
                    best = found | 1 << member
                    limit = cost_of(best, costs) - 1
        barred |= 1 << member  # from here on: without it
    return best


def _undominated(sets: list[int], costs: Sequence[int]) -> list[int]:
    """Answer ``sets`` without the members in whose place another one, not dearer, hits the same sets and more."""
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


def _parts(sets: Sequence[int]) -> list[list[int]]:
    """Answer ``sets`` in groups that have no member in common."""
    parts: list[tuple[int, list[int]]] = []
    for one in sets:
        members, group = one, [one]
        apart = []
        for others, part in parts:
            if others & members:
                members, group = members | others, [*part, *group]
            else:
                apart.append((others, part))
        parts = [*apart, (members, group)]
    return [sorted(part, key=lambda one: (one.bit_count(), one)) for _, part in parts]


def minimal(sets: Sequence[int]) -> list[int]:
    """Answer ``sets`` without those that have another one of them in them, the smallest first."""
    kept = list[int]()
    for one in sorted(set(sets), key=lambda members: (members.bit_count(), members)):
        if not any(other & one == other for other in kept):
            kept.append(one)
    return kept


def ascent(sets: Sequence[int], costs: Sequence[int]) -> tuple[int, dict[int, int]]:
    """Answer what hitting all ``sets`` costs at least, and what of the cost of each member that leaves unpaid.

    Each set in turn pays as much as its cheapest member still costs: a solution of the dual linear program.
    """
    bound, left = 0, dict[int, int]()
    for one in sets:
        members = list(bits_of(one))
        price = min([left.get(member, costs[member]) for member in members])
        bound += price
        for member in members:
            left[member] = left.get(member, costs[member]) - price
    return bound, left
