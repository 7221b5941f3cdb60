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
    return check(tree_from_json(result.to_json()), foon, kitchen.free_foods, kitchen.lacks)


def fatal(result: PlanResult, snapshot: Snapshot, kitchen: Kitchen = KITCHEN) -> list[str]:
    """Return the fatal findings, as a person reads them; what was named as being there so may be taken so (C6)."""

    def is_there_so(finding):
        return finding.rule == "C6" and any(map(kitchen.names_so, finding.nodes))

    found = judge(result, snapshot, kitchen).findings
    return [str(finding) for finding in found if not finding.minor and not is_there_so(finding)]
