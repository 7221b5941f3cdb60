"""Whether planners of others solve the trees that foon-kg plans, and whether they accept foon-kg's own order of steps.

    foon plan recipes/ --files subgraphs/ --output plans.jsonl
    python benchmarks/pddl.py plans.jsonl [--every N]

Each tree is written as PDDL and read back by unified-planning; Fast Downward solves it, and the sequential plan
validator of unified-planning judges Fast Downward's plan and ours. Printed: how many were solved and accepted, how many
steps either needs, and the CPU seconds of it all. Ends with 1 where a problem was not solved or a plan not accepted.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import resource
import statistics
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from unified_planning.engines import PlanGenerationResultStatus, ValidationResultStatus
from unified_planning.io import PDDLReader
from unified_planning.shortcuts import OneshotPlanner, PlanValidator, get_environment

from foon_kg.formats.exports.pddl import tree_to_pddl
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.plans.result import PlanResult

SOLVED = {PlanGenerationResultStatus.SOLVED_SATISFICING, PlanGenerationResultStatus.SOLVED_OPTIMALLY}


@dataclass(frozen=True)
class Verdict:
    """What the planner and the validator say of one tree of ``units`` steps."""

    name: str
    units: int
    solved: bool
    theirs: int
    their_plan_valid: bool
    our_order_valid: bool
    seconds: float


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plans", type=Path)
    parser.add_argument("--every", type=int, default=1)
    options = parser.parse_args()
    get_environment().credits_stream = None
    verdicts = []
    plans = list(trees(options.plans))[:: options.every]
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):  # Fast Downward writes where it stands
        for tree in plans:
            verdicts.append(judged(tree, Path(folder)))
            print(f"\r{len(verdicts)} judged", end="", file=sys.stderr, flush=True)
    print("\r", end="", file=sys.stderr)
    show(verdicts)
    return 0 if all(v.solved and v.their_plan_valid and v.our_order_valid for v in verdicts) else 1


def trees(plans: Path) -> Iterator[ExportedTree]:
    for number, line in enumerate(plans.read_text(encoding="utf-8").splitlines(), 1):
        value = json.loads(line)
        if "error" not in value:
            yield ExportedTree.of_plan(PlanResult.from_json(value, f"{plans}:{number}"))


def judged(tree: ExportedTree, folder: Path) -> Verdict:
    """Write the problem and the plan as files, as anyone else would get them, and ask."""
    before = cpu_seconds()
    written = tree_to_pddl(tree)
    domain, problem, plan = (folder / name for name in ("domain.pddl", "problem.pddl", "tree.plan"))
    domain.write_text(written.domain, encoding="utf-8")
    problem.write_text(written.problem, encoding="utf-8")
    plan.write_text(written.plan, encoding="utf-8")
    reader = PDDLReader()
    read = reader.parse_problem(str(domain), str(problem))
    with OneshotPlanner(name="fast-downward") as planner:
        result = planner.solve(read)
    with PlanValidator(name="sequential_plan_validator") as validator:
        ours = validator.validate(read, reader.parse_plan(read, str(plan)))
        theirs = validator.validate(read, result.plan) if result.plan is not None else None
    return Verdict(
        tree.name,
        len(tree.units),
        result.status in SOLVED,
        len(result.plan.actions) if result.plan is not None else 0,
        theirs is not None and theirs.status is ValidationResultStatus.VALID,
        ours.status is ValidationResultStatus.VALID,
        cpu_seconds() - before,
    )


def cpu_seconds() -> float:
    """CPU seconds of this process and of those that it started and that ended."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


def show(verdicts: list[Verdict]) -> None:
    count, units = len(verdicts), [verdict.units for verdict in verdicts]
    seconds = sorted(verdict.seconds for verdict in verdicts)
    print(f"{count} trees of {statistics.fmean(units):.1f} units (at most {max(units)})")
    print(f"solved by Fast Downward          {sum(v.solved for v in verdicts)} of {count}")
    print(f"its plans accepted               {sum(v.their_plan_valid for v in verdicts)} of {count}")
    print(f"our order of steps accepted      {sum(v.our_order_valid for v in verdicts)} of {count}")
    print(f"its plan has fewer steps         {sum(v.solved and v.theirs < v.units for v in verdicts)} of {count}")
    print(f"CPU seconds                      {sum(seconds):.0f}, {seconds[count // 2]:.2f} a tree (median)")
    for verdict in verdicts:
        if not (verdict.solved and verdict.their_plan_valid and verdict.our_order_valid):
            print(verdict)


if __name__ == "__main__":
    sys.exit(main())
