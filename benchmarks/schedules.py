"""How much a second pair of hands saves, and how far schedules are from the shortest that CP-SAT can rule out.

foon plan ../shared/data/queries --files ../shared/data/foon-111/TXT --output plans.jsonl
python benchmarks/schedules.py plans.jsonl ../shared/data/foon-111/TXT --hands 2
"""

from __future__ import annotations

import argparse
import json
import statistics
from collections import Counter
from pathlib import Path

from ortools.sat.python import cp_model

from foon_kg.loaders.paths import read_paths
from foon_kg.plans.durations import Durations
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult
from foon_kg.plans.schedule import WITHOUT_HANDS, Schedule, schedule
from foon_kg.plans.step_order import earlier_steps
from foon_kg.store.snapshot import Snapshot

KITCHEN = Kitchen.default()
TENTHS = 10  # of a second: CP-SAT counts in whole numbers


def bound(plan: PlanResult, done: Schedule) -> float:
    """Return what no schedule with these durations can beat, in seconds: mostly there is one of that length."""
    model = cp_model.CpModel()
    seconds = {step.place: round((step.end - step.start) * TENTHS) for step in done.steps}
    horizon = sum(seconds.values())
    starts = [model.new_int_var(0, horizon, "") for _ in plan.units]
    intervals = [model.new_fixed_size_interval_var(start, seconds[i], "") for i, start in enumerate(starts)]
    for place, before in enumerate(earlier_steps(plan.units)):
        for earlier in before:
            model.add(starts[place] >= starts[earlier] + seconds[earlier])
    handed = [intervals[i] for i, unit in enumerate(plan.units) if unit.motion not in WITHOUT_HANDS]
    model.add_cumulative(handed, [1] * len(handed), done.hands)
    there = Counter(node.label for node in plan.kitchen)
    for label in {n.label for unit in plan.units for n in unit.input_nodes if KITCHEN.is_utensil(n.label)}:
        users = [intervals[i] for i, unit in enumerate(plan.units) if any(n.label == label for n in unit.input_nodes)]
        model.add_cumulative(users, [1] * len(users), max(there[label], 1))
    length = model.new_int_var(0, horizon, "")
    model.add_max_equality(length, [start + seconds[i] for i, start in enumerate(starts)])
    model.minimize(length)
    solver = cp_model.CpSolver()
    solver.parameters.max_time_in_seconds = 5
    solver.parameters.num_workers = 1
    solver.solve(model)
    work = sum(seconds[i] for i, unit in enumerate(plan.units) if unit.motion not in WITHOUT_HANDS)
    return max(solver.best_objective_bound, work / done.hands) / TENTHS


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plans", type=Path, help="plan results, one a line")
    parser.add_argument("foon", type=Path, help="the folder of the FOON, for its times")
    parser.add_argument("--hands", type=int, default=2)
    arguments = parser.parse_args()
    foon = Snapshot.of([r.subgraph for r in read_paths([arguments.foon]) if r.subgraph], KITCHEN)
    durations = Durations.of_units(foon.units)
    plans = [json.loads(line) for line in arguments.plans.read_text(encoding="utf-8").splitlines()]
    saved, over, proven = [], [], 0
    for value in plans:
        if "units" not in value:
            continue
        plan = PlanResult.from_json(value)
        done = schedule(plan.units, plan.kitchen, durations, KITCHEN, arguments.hands)
        saved.append(1 - done.length / done.alone)
        over.append(done.length / max(bound(plan, done), 0.1) - 1)
        proven += done.shortest
    print(
        f"{len(durations.by_motion)} motions timed, {durations.overall.sightings if durations.overall else 0} sightings"
    )
    print(f"{len(saved)} plans, {arguments.hands} pairs of hands: {statistics.median(saved):.0%} saved (median)")
    print(f"{sum(o < 0.005 for o in over)} are the shortest, {proven} say so; at most {max(over):.1%} above the bound")


if __name__ == "__main__":
    main()
