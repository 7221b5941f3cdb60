"""What the judge says of a plan, asked through its JSON and against the whole FOON."""

from __future__ import annotations

from foon_kg.kitchen import Kitchen
from foon_kg.result import PlanResult
from foon_kg.snapshot import Snapshot
from foon_kg.validation import KnownFoon, Report, TaskTree, check

KITCHEN = Kitchen.default()


def judge(result: PlanResult, snapshot: Snapshot, kitchen: Kitchen = KITCHEN) -> Report:
    """Return the judge's report."""
    foon = KnownFoon.of(snapshot.units, snapshot.goals())
    return check(TaskTree.from_json(result.to_json()), foon, kitchen.free_foods, kitchen.lacks)


def fatal(result: PlanResult, snapshot: Snapshot, kitchen: Kitchen = KITCHEN) -> list[str]:
    """Return the fatal findings, as a person reads them."""
    return [str(finding) for finding in judge(result, snapshot, kitchen).findings if not finding.minor]
