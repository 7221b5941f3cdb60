"""What all need that handle the foods of one dish on a bench."""

from __future__ import annotations

from collections.abc import Mapping

from foon_kg.food import Tables
from foon_kg.integration.bench import Bench, Vessel
from foon_kg.integration.joining.course import Plan
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.carrying import Carrier
from foon_kg.integration.making.working import Worker
from foon_kg.integration.preparing.preparation import Ready


class Hands:
    """Hands that carry and work on a bench; ``ready`` are the prepared foods by the numbers of what was asked."""

    def __init__(self, bench: Bench, plan: Plan, carry: Carrier, work: Worker, ready: Mapping[int, Ready]) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.plan = plan
        self.carry = carry
        self.work = work
        self.ready = ready

    def bring(self, join: Join, vessel: Vessel) -> None:
        """Bring the food of ``join`` into a vessel as its slot has it, where that suits it."""
        self.carry.bring_joining(join, self.ready[join.want.number], vessel)
