"""How quick classic retrieval is, proven, and what enumerating all paths takes beside it.

    python benchmarks/retrieval.py [--time-limit SECONDS] [--paths N] [FOLDER [WEIGHTS]]

FOLDER holds the subgraphs and WEIGHTS the costs of motions, by default those beside the checkout. Every goal of the
FOON is retrieved at each of the three levels, by fewest units and by greatest success, from memory; beside it, in the
same run, all paths are enumerated as the FOON authors' programs do, given up after N combinations of producers. What
lies behind a goal is fetched and numbered once for both, and not counted in either. Printed: how many goals have a
tree, how many trees are proven, CPU milliseconds of fetching and of searching (median, most), and, where enumeration
ended, how many times longer than searching it took (median, most). The exit code is 1 where an enumeration that ended
has a better tree.
"""

import argparse
import math
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.loaders import read_paths, read_weights
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.model.levels import Level, node_at
from foon_kg.plans.kitchen import Kitchen
from foon_kg.search import NoWayError, SearchProblem, UnitIndex, enumerate_paths, retrieve
from foon_kg.search.classic import Criterion, GoalSought
from foon_kg.search.classic.behind import part_behind
from foon_kg.search.classic.success import likeliest_tree
from foon_kg.search.deadline import Deadline
from foon_kg.store.snapshot import Snapshot

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
    fetching, times, ratios, units = [], [], [], []
    proven = better = 0
    for number, asked in enumerate(questions):
        print(f"\r{number} of {len(questions)}", end="", file=sys.stderr, flush=True)
        problem, fetched = timed(lambda asked=asked: problem_of(snapshot, asked, costs))
        found, taken = timed(lambda asked=asked, problem=problem: searched(problem, asked, costs, options.time_limit))
        if found is None:
            continue
        tree, is_proven = found
        fetching.append(fetched)
        times.append(taken)
        units.append(len(tree))
        proven += is_proven
        worth, enumerating = timed(lambda asked=asked, problem=problem: best_path(problem, asked, costs, options.paths))
        if worth is not None:
            ratios.append(enumerating / taken)
            better += worth > worth_of(tree, asked.by, costs)
    print("\r", end="", file=sys.stderr)
    if not times:
        print(f"  {questions[0].by}: no tree")
        return 0
    print(
        f"  {questions[0].by:7} {len(times)} have a tree ({statistics.median(units):.0f} units, at most {max(units)}), "
        f"{proven} proven; ms: fetching {middle_and_most(fetching)}, searching {middle_and_most(times)}; "
        f"enumeration ended for {len(ratios)}"
        + (f" and took {middle_and_most(ratios)} times as long" if ratios else "")
        + (f"; it was BETTER for {better}" if better else ""),
        flush=True,
    )
    return better


def middle_and_most(values: list[float]) -> str:
    return f"{statistics.median(values):.1f} (at most {max(values):.0f})"


def timed(question: Callable[[], T]) -> tuple[T, float]:
    started = time.process_time()
    return question(), (time.process_time() - started) * 1000


def problem_of(snapshot: Snapshot, asked: GoalSought, costs: MotionCosts) -> SearchProblem:
    part = part_behind(snapshot, asked.candidates(snapshot), asked.level, Kitchen.default())
    usable = [known for known in part.units if asked.by is Criterion.UNITS or costs.success(known.unit.motion)]
    return SearchProblem(UnitIndex.of(usable, at_hand=part.at_hand.__contains__), part.goals)


def searched(
    problem: SearchProblem, asked: GoalSought, costs: MotionCosts, limit: float
) -> tuple[tuple[KnownUnit, ...], bool] | None:
    if asked.by is Criterion.SUCCESS:
        likeliest = likeliest_tree(problem, costs, Deadline.after(limit))
        return likeliest and (likeliest.units, likeliest.bound is None)
    try:
        tree = retrieve(problem, time_limit=limit)
    except NoWayError:
        return None
    return tree.units, tree.exact


def best_path(problem: SearchProblem, asked: GoalSought, costs: MotionCosts, limit: int) -> tuple | None:
    found = enumerate_paths(problem, limit=limit)
    if not found.complete:
        return None
    return max(worth_of(tree.units, asked.by, costs) for tree in found.found)


def worth_of(units: tuple[KnownUnit, ...], by: Criterion, costs: MotionCosts) -> tuple:
    success = math.prod(costs.success(known.unit.motion) for known in units)
    return (success if by is Criterion.SUCCESS else 0, -len(units))


if __name__ == "__main__":
    sys.exit(main())
