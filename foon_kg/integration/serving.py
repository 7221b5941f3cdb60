"""How a dish is finished that its video leaves open: dressed once it is drained, or put together on bread."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, Vessel, foods_of, is_flat
from foon_kg.integration.carrying import Carrier
from foon_kg.integration.course import WORKS, Plan
from foon_kg.integration.frames import Stage
from foon_kg.integration.places import Join
from foon_kg.integration.preparation import Ready
from foon_kg.integration.working import Worker

_SLICES = word_list("carries what is stacked")
_CREAMY = word_list("binds pieces")
_SEASONS = word_list("seasons pieces")
_LAYERS = word_list("is a layer")
_MIXED = "mixture"
_SMALL = 3
"""How fine pieces are that are bound by something creamy (chopped, flaked)."""


class Serving:
    """Finishes one dish on a bench. ``ready`` are the prepared foods by the numbers of what was asked."""

    def __init__(self, bench: Bench, plan: Plan, carry: Carrier, work: Worker, ready: Mapping[int, Ready]) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.plan = plan
        self.carry = carry
        self.work = work
        self.ready = ready

    def is_put_together(self, stage: Stage, joins: Sequence[Join], later: Sequence[Stage]) -> bool:
        """Whether this is where a stacked dish is put together, with foods that its video has not."""
        works = any(not one.does.isdisjoint(WORKS) for one in (stage, *later))
        return not works and any(join.slot is None for join in joins)

    def stack(self, stage: Stage, vessel: Vessel | None, joins: Sequence[Join], lines: Sequence[Vessel]) -> Vessel:
        """Put a dish together on a plate: bread, what was made, then the rest; a spread with pieces is mixed before."""
        plate = self.bench.vessel("plate") if vessel is None or not is_flat(vessel.label) else vessel
        slices = [join for join in joins if join.want.facts.is_a(*_SLICES)]
        rest = [join for join in joins if join not in slices]
        mixed = self._bound(rest)
        bowl = self.bench.vessel("bowl")
        for join in mixed:
            self.carry.bring(self.ready[join.want.number], bowl, None)
        if mixed:
            self.bench.work(bowl, self.work.stirring(foods_of(bowl)), _MIXED, ("mixed",), with_device=False)
        for join in slices:
            self.carry.bring(self.ready[join.want.number], plate, None)
        made = [one for one in (*lines, vessel, bowl) if one is not None and one is not plate and one.contents]
        for one in made:
            self.bench.heat_off(one)
            self.carry.transfer(one, plate, stage)
        there = frozenset().union(*(stuff.wants for stuff in plate.contents))
        for join in rest:
            if join not in mixed and not (join.want.facts.is_a("fat") and join.want.number in there):
                self.carry.bring(self.ready[join.want.number], plate, None)
        self.work.name(plate, self.plan.label)
        return plate

    def _bound(self, joins: Sequence[Join]) -> list[Join]:
        """Return what is mixed to be spread: small pieces with something creamy, and what seasons them."""
        stuffs = {join.want.number: self.ready[join.want.number].stuff for join in joins}
        small = [
            join for join in joins
            if any((self.known.state(state).fine or 0) >= _SMALL for state in stuffs[join.want.number].states)
        ]  # fmt: skip
        creamy = [join for join in joins if join.want.facts.is_a(*_CREAMY)]
        seasons = [join for join in joins if join.want.facts.is_a(*_SEASONS) and join not in creamy]
        pieces = [j for j in small if j not in seasons and j not in creamy and not j.want.facts.is_a(*_LAYERS)]
        return [*pieces, *creamy, *(join for join in seasons if join not in pieces)] if pieces and creamy else []

    def is_warmed(self, vessel: Vessel | None) -> bool:
        """Whether a dish is dressed over the heat: it was drained hot, and is not served cold."""
        row = self.known.utensil(vessel.label) if vessel is not None else None
        return row is not None and "strain" in row.can and not self.plan.cold

    def dress(self, vessel: Vessel) -> None:
        """Mix what came to a dish that was done."""
        self.bench.work(vessel, self.work.stirring(foods_of(vessel)), self.plan.label, ("mixed",), with_device=False)

    def warm(self, stage: Stage, strainer: Vessel, joins: Sequence[Join]) -> Vessel:
        """Toss what was drained over the heat with what it is eaten with; what is raw is fried before."""
        pan = self.bench.vessel("cooking pan")
        device = self.bench.place(pan, "stove", "on")
        tops = [join for join in joins if join.want.facts.is_a("topping", "herb")]
        fats = [join for join in joins if join.want.facts.is_a("fat")]
        raw = [join for join in joins if self._is_raw(join) and join not in tops and join not in fats]
        for join in fats:
            self._bring(join, pan)
        if raw and not fats:
            self.carry.add_fat(pan, self.plan)
        self.bench.switch(pan, device, on=True)
        for join in raw:
            self._bring(join, pan)
        if raw:
            attested = self.work.stirring_hot(foods_of(pan))
            self.work.work_each(pan, attested, ("mixed", "partly cooked"), with_device=True)
        self.carry.transfer(strainer, pan, stage)
        for join in joins:
            if join not in raw and join not in fats and join not in tops:
                self._bring(join, pan)
        self.bench.work(pan, self.work.stirring_hot(foods_of(pan)), self.plan.label, ("cooked", "mixed"))
        self.bench.switch(pan, device, on=False)
        for join in tops:
            self._bring(join, pan)
            self.work.name(pan, self.plan.label)
        return pan

    def _bring(self, join: Join, vessel: Vessel) -> None:
        self.carry.bring(self.ready[join.want.number], vessel, None)

    def _is_raw(self, join: Join) -> bool:
        """Whether a food still has to fry: a vegetable or an egg that nobody cooked."""
        stuff = self.ready[join.want.number].stuff
        cooked = any(self.known.state(state).needs_heat for state in stuff.states)
        return not cooked and join.want.facts.is_a(*word_list("is done in the pan first"))

    def is_dressed(self, stage: Stage, vessel: Vessel | None, joins: Sequence[Join], later: Sequence[Stage]) -> bool:
        """Whether foods come to a dish that is done which are no topping and that nothing mixes in any more."""
        if not stage.does.isdisjoint(WORKS) or any(not one.does.isdisjoint(WORKS) for one in later):
            return False
        if vessel is not None and any("baked" in stuff.states for stuff in vessel.contents):
            return False  # on what comes out of the oven in one piece it only lies
        return any(join.slot is None and not join.want.facts.is_a("topping", "herb") for join in joins)
