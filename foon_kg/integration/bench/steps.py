"""Steps with their evidence: which units of the FOON attest what is done, and what is told of it before and after."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from typing import NamedTuple

from foon_kg.food.lists import word_list
from foon_kg.integration.bench.inventory import Inventory
from foon_kg.integration.bench.things import Shown
from foon_kg.integration.teaching.operators import Alike, Attested, Likes, Nearness, Operators, Way
from foon_kg.world import Step

_MOST_NAMED = 3
"""How many motions an error names; there may be a hundred ways to cut."""


class RefusedError(Exception):
    """A step cannot happen, or nothing in the FOON attests it."""


class Done(NamedTuple):
    """A step that happened, with its evidence and phase."""

    step: Step
    attested: Attested
    phase: str


class Steps(Inventory):
    """The steps that happened in a kitchen. ``likes`` names the known foods that can stand for one."""

    def __init__(self, operators: Operators, likes: Likes, alike: Alike, instead: Collection[str] = ()) -> None:
        super().__init__(operators.known)
        self.operators = operators
        self.likes = likes
        self.alike = alike
        self.instead = instead
        self.done: list[Done] = []
        self.phase = "prepare"
        self.assumed: dict[int, str] = {}
        """Why a thing is there that nobody asked for, by its number."""

    # --- evidence ---

    def attest(self, ways: Iterable[Way], foods: Sequence[str], *, act: bool = False) -> Attested | None:
        """Return the nearest evidence among ``ways`` of doing so to ``foods``; of equally near ones the first way's.

        ``act``: by a unit that changes one of them.
        """
        best: Attested | None = None
        for way in ways:
            found = self.operators.attested(way, foods, self.likes, act=act, instead=self.instead)
            if found is not None and (best is None or found.nearness < best.nearness):
                best = found
                if best.nearness is Nearness.FOOD:
                    return best
        return best

    def far(self, ways: Iterable[Way], foods: Sequence[str], *, act: bool = False) -> Attested | None:
        """Return the evidence among ``ways`` by the likest of all ``foods``, for what nothing nearer attests.

        Where none is like it at all the way decides, and not which food is least unlike. ``act``: by a unit that
        changes one.
        """
        found = (self.operators.farthest(way, foods, self.alike, act=act) for way in ways)
        return max(filter(None, found), key=lambda one: one.like[2] if one.like else 0.0, default=None)

    def near_or_far(self, ways: Sequence[Way], foods: Sequence[str], *, act: bool = False) -> Attested | None:
        """Return :meth:`attest` of the same ``ways``, ``foods`` and ``act``, else :meth:`far`.

        ``None`` where nothing of this FOON is done in one of them.
        """
        return self.attest(ways, foods, act=act) or self.far(ways, foods, act=act)

    def require(self, ways: Iterable[Way], foods: Sequence[str], *, act: bool = False) -> Attested:
        """Return :meth:`near_or_far` of the same ``ways``, ``foods`` and ``act``, or raise :class:`RefusedError`."""
        ways = list(ways)
        found = self.near_or_far(ways, foods, act=act)
        if found is None:
            named = ", ".join(way[0] for way in ways[:_MOST_NAMED]) or "it"
            raise RefusedError(f"no unit of this FOON does “{named}” to {', '.join(foods) or 'nothing'} or its like")
        return found

    def first(self, ways: Iterable[Way], foods: Sequence[str]) -> Attested:
        """Return the evidence for the first of ``ways`` in which anything is done to ``foods``.

        Raises :class:`RefusedError` where nothing is.
        """
        ways = list(ways)
        for way in ways:
            found = self.near_or_far([way], foods)
            if found is not None:
                return found
        return self.require(ways, foods)

    def first_with(self, appliance: str, ways: Iterable[Way], foods: Sequence[str]) -> Attested:
        """Return :meth:`first` of ``ways`` for ``foods``; without food the nearest evidence with ``appliance``.

        Raises :class:`RefusedError` where there is none.
        """
        ways = list(ways)
        if foods:
            return self.first(ways, foods)
        found = (self.operators.attested(way, (), appliance=appliance) for way in ways)
        return min(filter(None, found), key=lambda one: one.nearness, default=None) or self.require(ways, foods)

    def ways_by(self, motions: Collection[str]) -> list[Way]:
        """Return the ways with one of some motions, motion by motion, and of each the most frequent first."""
        return [way for motion in sorted(motions) for way in self.operators.ways_of(motion)]

    def cooling(self, foods: Sequence[str]) -> Attested | None:
        """Return the evidence of how ``foods`` cool by themselves; ``None`` where nothing in this FOON does."""
        return self.near_or_far([way for way in self.ways_by(word_list("cools")) if not way[1]], foods)

    # --- steps ---

    def emit(
        self,
        attested: Attested,
        inputs: Sequence[Shown],
        change: Callable[[], None],
        outputs: Sequence[Shown],
        *,
        motion: str = "",
    ) -> None:
        """Let one step happen as is ``attested``: the nodes of ``inputs`` before and of ``outputs`` after ``change``.

        ``motion`` is what is done, where the evidence shows another motion.
        """
        before = [self.shown(thing) for thing in inputs]
        before += [self.mention(tool) for tool in attested.way[1]]
        change()
        after = [self.shown(thing) for thing in outputs]
        step = Step(tuple(dict.fromkeys(before)), motion or attested.way[0], tuple(dict.fromkeys(after)))
        if set(step.outputs) <= set(step.inputs):
            return  # a unit that changes nothing is none (contract C3)
        self.done.append(Done(step, attested, self.phase))
