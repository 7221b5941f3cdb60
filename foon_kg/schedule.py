"""Who does what when: a task tree for one or more pairs of hands.

Resource-constrained scheduling by serial schedule generation (Kelley, 1963): one step after another is put at the
earliest time at which everything it waits for is done, a pair of hands is free, and each utensil it uses is free. That
is tried in several orders, and the shortest schedule is kept. With every order of steps the method would find the
shortest there is; whether the one found is the shortest is told where a bound proves it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from foon_kg.durations import Duration, Durations
from foon_kg.errors import UsageError
from foon_kg.kitchen import Kitchen
from foon_kg.model import ObjectNode
from foon_kg.result import PlannedUnit
from foon_kg.step_order import earlier_steps

WITHOUT_HANDS = frozenset({
    "bake", "boil", "brew", "broil", "chill", "cool", "cool down", "defrost", "ferment", "freeze", "heat", "marinate",
    "melt", "microwave", "preheat", "refrigerate", "rest", "rise", "roast", "set", "simmer", "sit", "soak", "steam",
    "thaw", "toast", "wait",
})  # fmt: skip
"""Motions that go on by themselves: they need their vessel and device, but nobody's hands."""

UNTIMED = 4.0
"""Seconds for a step where nothing at all was ever timed: the median of the public FOON's sightings."""


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


def schedule(
    units: Sequence[PlannedUnit], leaves: Sequence[ObjectNode], durations: Durations, kitchen: Kitchen, hands: int = 1
) -> Schedule:
    """Schedule the ``units`` of a tree for so many pairs of ``hands``.

    Of every utensil there are as many as the tree's ``leaves`` have nodes of that name, and one at least; a step uses
    each utensil that it takes. Raises UsageError for less than one pair of hands.
    """
    if hands < 1:
        raise UsageError(f"{hands} pairs of hands cannot cook", hint="Ask for one pair of hands or more.")
    work = _Work.of(units, leaves, durations, kitchen, hands)
    rules: tuple[Callable[[int], tuple[float, ...]], ...] = (
        lambda i: (-work.tails[i], i),
        lambda i: (i,),
        lambda i: (-work.tails[i] if work.handless[i] else 0.0, i),
        lambda i: (-work.followers[i], i),
        lambda i: (-work.seconds[i], i),
    )
    return min((work.scheduled(rule) for rule in rules), key=lambda one: one.length)


@dataclass(frozen=True)
class _Work:
    known: Sequence[Duration | None]
    seconds: Sequence[float]
    handless: Sequence[bool]
    before: Sequence[frozenset[int]]
    tails: Sequence[float]
    followers: Sequence[int]
    uses: Sequence[frozenset[str]]
    there: Counter[str]
    hands: int

    @classmethod
    def of(
        cls,
        units: Sequence[PlannedUnit],
        leaves: Sequence[ObjectNode],
        durations: Durations,
        kitchen: Kitchen,
        hands: int,
    ) -> _Work:
        usual = durations.overall.median if durations.overall else UNTIMED
        known = [durations.by_motion.get(unit.motion_node) for unit in units]
        seconds = [usual if one is None else one.median for one in known]
        before = earlier_steps(units)
        tails, behind = list(seconds), [set[int]() for _ in units]
        for place in reversed(range(len(units))):
            for earlier in before[place]:
                tails[earlier] = max(tails[earlier], seconds[earlier] + tails[place])
                behind[earlier] |= behind[place] | {place}
        uses = [frozenset(n.label for n in unit.input_nodes if kitchen.is_utensil(n.label)) for unit in units]
        there = Counter(node.label for node in set(leaves))
        handless = [unit.motion_node in WITHOUT_HANDS for unit in units]
        return cls(known, seconds, handless, before, tails, [len(b) for b in behind], uses, there, hands)

    def scheduled(self, rule: Callable[[int], tuple[float, ...]]) -> Schedule:
        """Put the steps in by ``rule`` (least first), each as early as it can be."""
        steps: dict[int, ScheduledStep] = {}
        while len(steps) < len(self.seconds):
            ready = [i for i in range(len(self.seconds)) if i not in steps and self.before[i] <= steps.keys()]
            step = self._earliest(min(ready, key=rule), list(steps.values()))
            steps[step.place] = step
        length = max((step.end for step in steps.values()), default=0.0)
        ordered = tuple(sorted(steps.values(), key=lambda step: (step.start, step.place)))
        return Schedule(ordered, self.hands, length, sum(self.seconds), length <= self._bound() + 1e-9)

    def _earliest(self, place: int, others: Sequence[ScheduledStep]) -> ScheduledStep:
        ready = max((other.end for other in others if other.place in self.before[place]), default=0.0)
        starts = sorted({ready, *(other.end for other in others if other.end > ready)})
        for start in starts:
            during = [o for o in others if o.start < start + self.seconds[place] and o.end > start]
            hands = self._free_hands(place, during)
            if hands != self.hands and self._utensils_free(place, during):
                break
        one = None if self.handless[place] else hands
        return ScheduledStep(place, start, start + self.seconds[place], one, self.known[place])

    def _free_hands(self, place: int, during: Sequence[ScheduledStep]) -> int:
        """Answer the first free pair of hands; as many as there are stands for none."""
        if self.handless[place]:
            return 0
        busy = {other.hands for other in during}
        return next((pair for pair in range(self.hands) if pair not in busy), self.hands)

    def _utensils_free(self, place: int, during: Sequence[ScheduledStep]) -> bool:
        # those at once with this step need not be so with each other; counting them all errs on the safe side
        return all(
            sum(label in self.uses[other.place] for other in during) < max(self.there[label], 1)
            for label in self.uses[place]
        )

    def _bound(self) -> float:
        """Answer what no schedule can beat: the longest chain of steps, and the work shared by all hands."""
        work = sum(s for s, alone in zip(self.seconds, self.handless, strict=True) if not alone)
        return max([work / self.hands, *self.tails])
