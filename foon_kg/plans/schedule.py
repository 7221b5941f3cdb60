"""Who does what when: a task tree for one or more pairs of hands.

Resource-constrained scheduling by serial schedule generation (Kelley, 1963): one step after another is put at the
earliest time at which everything it waits for is done, a pair of hands is free, and each utensil it uses is free. Some
order of the steps gives the shortest schedule there is. Several are tried, and the best is bettered by taking single
steps earlier or later for as long as that helps. Whether the schedule is the shortest is told where a bound proves it.
"""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import cached_property

from foon_kg.food import motions
from foon_kg.food.lists import word_list
from foon_kg.model import ObjectNode
from foon_kg.model.errors import UsageError
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.tree import Mention, Step
from foon_kg.plans.durations import Duration, Durations
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.step_order import earlier_steps

WITHOUT_HANDS = word_list("without hands")
"""Motions that go on by themselves: they need their vessel and device, but nobody's hands."""

UNTIMED = 4.0
"""Seconds for a step where nothing at all was ever timed: the median of the public FOON's sightings."""

MOST_TRIES = 400
"""How many orders are tried at most to better a schedule."""

_HANDS = ""  # beside the names of utensils: what nearly every step uses
_ROUNDING = 1e-9  # sums of seconds in another order differ in their last digits
_Span = tuple[float, float]


@dataclass(frozen=True)
class ScheduledStep:
    """A step (its place among the units, from 0) from ``start`` to ``end``, in seconds from the beginning.

    ``hands`` is which pair of hands does it (from 0), ``None`` where it goes on by itself. ``duration`` is what is
    known of its motion; where that is ``None`` nobody has timed it, and the time it gets here is that of a usual step.
    """

    place: int
    start: float
    end: float
    hands: int | None
    duration: Duration | None


@dataclass(frozen=True)
class Schedule:
    """The steps by their start. ``alone`` is how long they take one after the other.

    ``shortest`` says that no schedule with these durations can be shorter.
    """

    steps: tuple[ScheduledStep, ...]
    hands: int
    length: float
    alone: float
    shortest: bool

    @property
    def untimed(self) -> int:
        """How many of the steps nobody has timed: how long all of it takes, nobody knows then."""
        return sum(step.duration is None for step in self.steps)

    @property
    def known_until(self) -> float:
        """The second up to which it is known when something begins: the start of the first step that nobody timed."""
        return min((step.start for step in self.steps if step.duration is None), default=self.length)

    def to_json(self) -> JsonObject:
        """Return the schedule field by field; a step is named by its ``unit``, its place among the units, from 0.

        With ``untimed`` steps all times behind the first of them are those of usual steps, and no knowledge.
        """
        fields: JsonObject = asdict(self) | {"untimed": self.untimed}
        fields["steps"] = [{"unit": step.pop("place"), **step} for step in fields["steps"]]
        return fields


def schedule(
    units: Sequence[Step], leaves: Sequence[ObjectNode], durations: Durations, kitchen: Kitchen, hands: int = 1
) -> Schedule:
    """Return who does which of the ``units`` of a tree when, for so many pairs of ``hands``.

    ``durations`` say how long (seconds) each motion takes. A plan says which utensil a step takes: that one nobody else
    has meanwhile; a stove of the ``kitchen`` has a burner for each vessel on it. In other trees there are as many of
    every utensil as the ``leaves`` have nodes of that name, and one at least. Raises UsageError for less than one pair
    of hands.
    """
    if hands < 1:
        raise UsageError(f"{hands} pairs of hands cannot cook", hint="Ask for one pair of hands or more.")
    work = _Work.of(units, leaves, durations, kitchen, hands)
    places = range(len(units))
    orders = (
        list(places),  # the tree's own: another one has to be shorter
        sorted(places, key=lambda i: (-work.tails[i], i)),
        sorted(places, key=lambda i: (not work.handless[i], -work.tails[i], i)),
        sorted(places, key=lambda i: (-work.followers[i], i)),
        sorted(places, key=lambda i: (-work.seconds[i], i)),
    )
    off = [place for place in places if motions.switches_off(units[place].motion)]  # at once, whatever else waits
    tried = [[*off, *(place for place in order if place not in off)] for order in orders]
    order = _bettered(min(tried, key=lambda order: work.length(work.starts(order))), work)
    return work.told(work.starts(order))


def _bettered(order: list[int], work: _Work) -> list[int]:
    """Take single steps elsewhere in the order of precedence for as long as that makes the schedule shorter."""
    length = work.length(work.starts(order))
    moves = [(step, to) for step in range(len(order)) for to in (0, *range(len(order)))]
    in_vain = 0  # moves tried on this order; once all of them were, more tries find nothing
    for step, to in itertools.islice(itertools.cycle(moves), MOST_TRIES):
        if length <= work.bound or in_vain == len(moves):
            break
        other = _moved(order, step, to)
        shorter = work.length_below(other, length)
        if shorter is None:
            in_vain += 1
        else:
            order, length, in_vain = other, shorter, 0
    return order


def _moved(order: Sequence[int], step: int, to: int) -> list[int]:
    """Return ``order`` with ``step`` at the place ``to``."""
    rest = [place for place in order if place != step]
    return [*rest[:to], step, *rest[to:]]


def _is_free(spans: Sequence[_Span], there: int, start: float, end: float) -> bool:
    """Whether of ``there`` things that are in use for ``spans`` one is free from ``start`` to ``end``."""
    during = [span for span in spans if span[0] < end and span[1] > start]
    if len(during) < there:
        return True
    moments = (start, *(since for since, _ in during if since > start))
    return all(sum(since <= moment < until for since, until in during) < there for moment in moments)


def _name(utensil: Mention) -> str:
    """Return what tells a utensil from others: its number, and for a burner also that of the vessel on it."""
    node, thing, container = utensil
    if thing is None:
        return node.label
    return f"{node.label} {thing}" + (f" {container}" if node.relation == "under" else "")


def _used_by(unit: Step, kitchen: Kitchen) -> frozenset[str]:
    """Return what a step has for itself while it lasts: its utensils, and hands unless it goes on by itself."""
    utensils = frozenset(_name(one) for one in unit.inputs if kitchen.is_utensil(one.node.label))
    return utensils if unit.motion in WITHOUT_HANDS else utensils | {_HANDS}


def _how_many(used: Sequence[frozenset[str]], leaves: Sequence[ObjectNode], hands: int) -> dict[str, int]:
    """Return how many there are of each thing that steps use."""
    have = Counter(node.label for node in set(leaves))
    return {name: max(have[name], 1) for name in sorted(frozenset[str]().union(*used))} | {_HANDS: hands}


@dataclass(frozen=True)
class _Work:
    """The steps of a tree as a schedule asks of them, each by its place.

    ``before`` are the steps that one waits for, ``tails`` how many seconds it and the longest way of steps behind it
    take, ``followers`` how many wait for it; ``uses`` are the things that it has for itself, of which ``there`` counts.
    """

    known: Sequence[Duration | None]
    seconds: Sequence[float]
    handless: Sequence[bool]
    before: Sequence[frozenset[int]]
    tails: Sequence[float]
    followers: Sequence[int]
    uses: Sequence[frozenset[str]]
    there: Mapping[str, int]

    @classmethod
    def of(
        cls,
        units: Sequence[Step],
        leaves: Sequence[ObjectNode],
        durations: Durations,
        kitchen: Kitchen,
        hands: int,
    ) -> _Work:
        usual = durations.overall.median if durations.overall else UNTIMED
        known = [durations.of_step(unit.motion, unit.measures) for unit in units]
        seconds = [usual if one is None else one.median for one in known]
        before = earlier_steps(units)
        tails, behind = _tails(seconds, before), _behind(before)
        handless = [unit.motion in WITHOUT_HANDS for unit in units]
        followers = [len(steps) for steps in behind]
        uses = [_used_by(unit, kitchen) for unit in units]
        return cls(known, seconds, handless, before, tails, followers, uses, _how_many(uses, leaves, hands))

    def starts(self, order: Sequence[int]) -> dict[int, float]:
        """Return when each step begins when they are put in as ``order`` ranks those that are ready."""
        return dict(self._put_in(order))

    def length_below(self, order: Sequence[int], limit: float) -> float | None:
        """Return how long the steps take in ``order``, if that is less than ``limit``."""
        length = 0.0
        for place, start in self._put_in(order):
            if start + self.tails[place] >= limit:
                return None  # what waits for this step is done no sooner
            length = max(length, start + self.seconds[place])
        return length

    def _put_in(self, order: Sequence[int]) -> Iterator[tuple[int, float]]:
        starts: dict[int, float] = {}
        busy: dict[str, list[_Span]] = {name: [] for name in self.there}
        ends: set[float] = set()
        waiting = list(order)
        while waiting:
            place = next(i for i in waiting if self.before[i] <= starts.keys())
            waiting.remove(place)
            start = starts[place] = self._earliest(place, starts, ends, busy)
            yield place, start
            end = start + self.seconds[place]
            ends.add(end)
            for name in self.uses[place]:
                busy[name].append((start, end))

    def _earliest(
        self, place: int, starts: Mapping[int, float], ends: Collection[float], busy: Mapping[str, Sequence[_Span]]
    ) -> float:
        """Return the first time at which there is enough of all that a step uses for as long as it takes."""
        ready = max((starts[i] + self.seconds[i] for i in self.before[place]), default=0.0)
        shared = [(busy[name], self.there[name]) for name in self.uses[place] if busy[name]]
        times = [ready, *sorted(end for end in ends if end > ready)]
        seconds = self.seconds[place]
        return next(at for at in times if all(_is_free(spans, there, at, at + seconds) for spans, there in shared))

    def length(self, starts: Mapping[int, float]) -> float:
        """Return when the last step is done."""
        return max((start + self.seconds[i] for i, start in starts.items()), default=0.0)

    @cached_property
    def bound(self) -> float:
        """What no schedule can beat: the longest chain of steps, and the work for each thing shared by all of it."""
        shared = [
            sum(s for s, uses in zip(self.seconds, self.uses, strict=True) if name in uses) / count
            for name, count in self.there.items()
        ]
        return max([0.0, *shared, *self.tails]) + _ROUNDING

    def told(self, starts: Mapping[int, float]) -> Schedule:
        """Return the schedule, with a pair of hands for every step: whichever is free, the first if it may choose."""
        free = [0.0] * self.there[_HANDS]
        steps = []
        for place, start in sorted(starts.items(), key=lambda one: (one[1], one[0])):
            end, pair = start + self.seconds[place], None
            if not self.handless[place]:
                pair = next(i for i, since in enumerate(free) if since <= start)
                free[pair] = end
            steps.append(ScheduledStep(place, start, end, pair, self.known[place]))
        length = self.length(starts)
        return Schedule(tuple(steps), len(free), length, sum(self.seconds), length <= self.bound)


def _tails(seconds: Sequence[float], before: Sequence[Collection[int]]) -> list[float]:
    """Return for each step how many seconds it and the longest way of steps behind it take."""
    tails = list(seconds)
    for place in reversed(range(len(before))):
        for earlier in before[place]:
            tails[earlier] = max(tails[earlier], seconds[earlier] + tails[place])
    return tails


def _behind(before: Sequence[Collection[int]]) -> list[set[int]]:
    """Return for each step those that wait for it, at once or by way of others."""
    behind = [set[int]() for _ in before]
    for place in reversed(range(len(before))):
        for earlier in before[place]:
            behind[earlier] |= behind[place] | {place}
    return behind
