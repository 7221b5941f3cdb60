"""How quick classic retrieval is, proven, and what enumerating all paths takes beside it.

    python benchmarks/retrieval.py [--time-limit SECONDS] [--paths N] [FOLDER [WEIGHTS]]

FOLDER holds the subgraphs and WEIGHTS the costs of motions, by default those beside the checkout. Every goal of the
FOON is retrieved at each level, by fewest units and by greatest success, from memory; beside it, in the same run, all
paths are enumerated as the FOON authors' programs do, given up after N combinations of producers. Printed: how many
goals have a tree, how many trees are proven, CPU milliseconds (median, most), and, where enumeration ended, how many
times longer it took. The exit code is 1 where an enumeration that ended has a better tree.
"""

import argparse
import math
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from foon_kg.classic_retrieval import Criterion, GoalSought, RetrievalResult, retrieve_tree
from foon_kg.classic_retrieval.behind import part_behind
from foon_kg.kitchen import Kitchen
from foon_kg.levels import Level, node_at
from foon_kg.loaders import read_paths, read_weights
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.motion_costs import MotionCosts
from foon_kg.search import NoWayError, SearchProblem, UnitIndex, enumerate_paths
from foon_kg.snapshot import Snapshot

T = TypeVar("T")
SHARED = Path(__file__).parents[1].parent / "shared" / "data" / "foon-111"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=SHARED / "TXT")
    parser.add_argument("weights", nargs="?", type=Path, default=SHARED / "motion_cost.json")
    parser.add_argument("--time-limit", type=float, default=10.0)
    parser.add_argument("--paths", type=int, default=2_000)
    options = parser.parse_args()
    results = [result.subgraph for result in read_paths([options.folder])]
    snapshot = Snapshot.of([subgraph for subgraph in results if subgraph is not None], Kitchen.default())
    costs = read_weights(options.weights)
    snapshot.called(["warm"])
    better = 0
    for level in Level:
        goals = sorted({node_at(goal.node, level) for goal in snapshot.goals()}, key=lambda node: node.sort_key)
        print(f"level {int(level)}: {len(goals)} goals")
        for by in Criterion:
            better += measure(snapshot, costs, [asked_for(goal, level, by) for goal in goals], options)
    return 1 if better else 0


def asked_for(goal: ObjectNode, level: Level, by: Criterion) -> GoalSought:
    return GoalSought(goal.label, goal.states, goal.ingredients, goal.container, level, by)


def measure(snapshot: Snapshot, costs: MotionCosts, questions: list[GoalSought], options) -> int:
    times, ratios, units = [], [], []
    proven = better = ended = 0
    for number, asked in enumerate(questions):
        print(f"\r{number} of {len(questions)}", end="", file=sys.stderr, flush=True)
        tree, taken = timed(lambda asked=asked: retrieved(snapshot, asked, costs, options.time_limit))
        if tree is None:
            continue
        times.append(taken)
        units.append(len(tree.units))
        proven += tree.exact
        worth, enumerating = timed(lambda asked=asked: best_path(snapshot, asked, costs, options.paths))
        if worth is not None:
            ended += 1
            ratios.append(enumerating / taken)
            better += worth > worth_of([step.known for step in tree.units], asked.by, costs)
    print("\r", end="", file=sys.stderr)
    if not times:
        print(f"  {questions[0].by}: no tree")
        return 0
    print(
        f"  {questions[0].by:7} {len(times)} have a tree ({statistics.median(units):.0f} units, at most {max(units)}), "
        f"{proven} proven; ms: median {statistics.median(times):.1f}, most {max(times):.1f}; "
        f"enumeration ended for {ended}"
        + (f", {statistics.median(ratios):.2f} times as long (median), at most {max(ratios):.0f}" if ratios else "")
        + (f"; it was BETTER for {better}" if better else "")
    )
    return better


def timed(question: Callable[[], T]) -> tuple[T, float]:
    started = time.process_time()
    return question(), (time.process_time() - started) * 1000


def retrieved(snapshot: Snapshot, asked: GoalSought, costs: MotionCosts, limit: float) -> RetrievalResult | None:
    try:
        return retrieve_tree(snapshot, asked, Kitchen.default(), costs, time_limit=limit)
    except NoWayError:
        return None


def best_path(snapshot: Snapshot, asked: GoalSought, costs: MotionCosts, limit: int) -> tuple | None:
    part = part_behind(snapshot, asked.candidates(snapshot), asked.level, Kitchen.default())
    problem = SearchProblem(UnitIndex.of(part.units, at_hand=part.at_hand.__contains__), part.goals)
    found = enumerate_paths(problem, limit=limit)
    if not found.complete:
        return None
    return max(worth_of(tree.units, asked.by, costs) for tree in found.trees)


def worth_of(units: list[KnownUnit] | tuple[KnownUnit, ...], by: Criterion, costs: MotionCosts) -> tuple:
    success = math.prod(costs.success(known.unit.motion) for known in units)
    return (success if by is Criterion.SUCCESS else 0, -len(units))


if __name__ == "__main__":
    sys.exit(main())
