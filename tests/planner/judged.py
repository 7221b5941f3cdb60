"""What the judge says of a plan, asked through its JSON and against the whole FOON."""

from __future__ import annotations

from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult
from foon_kg.store.snapshot import Snapshot
from foon_kg.validation import KnownFoon, Report, check, tree_from_json

KITCHEN = Kitchen.default()


def judge(result: PlanResult, snapshot: Snapshot, kitchen: Kitchen = KITCHEN) -> Report:
    """Return the judge's report."""
    foon = KnownFoon.of(snapshot.units, snapshot.goals())
    return check(tree_from_json(result.to_json()), foon, kitchen.free_foods, kitchen.lacks, kitchen.names_so)


def fatal(result: PlanResult, snapshot: Snapshot, kitchen: Kitchen = KITCHEN) -> list[str]:
    """Return the fatal findings, as a person reads them; what was named as being there so may be taken so (C6)."""
    return [str(finding) for finding in judge(result, snapshot, kitchen).findings if not finding.minor]
