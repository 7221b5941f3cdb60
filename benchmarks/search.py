"""How quick the search for reference trees is, and whether a solver that shares nothing with it finds the same.

    python benchmarks/search.py [--queries] [--without-solver] FOLDER

FOLDER holds the subgraphs, by default those beside the checkout. For every goal, with its own ingredients as the wanted
foods (``--queries``: for every public recipe, the likeliest goal by shared names), four ways in one run: the exact
search; OR-tools CP-SAT, the gaps first (needs the extra ``benchmarks``); the greedy tree, cheapest derivations first;
all paths, with no other gaps than the best tree's, where ENUMERATED combinations are enough. Printed: CPU milliseconds,
how many times as long as the exact search each other way took for the same goal, shares proven, and how often greedy
trees are worse. The exit code is 1 where search and solver, both proven, differ in gap penalty, overlap or units, or
where an enumeration that ended has another best tree.
"""

import argparse
import json
import statistics
import sys
import time
from collections import Counter
from pathlib import Path

from foon_kg.loaders import read_paths
from foon_kg.model import Goal
from foon_kg.plans.kitchen import Kitchen
from foon_kg.search import NoWayError, SearchProblem, UnitIndex, enumerate_paths, retrieve, with_gaps_of
from foon_kg.search.core import Core, core_behind
from foon_kg.search.deadline import Deadline
from foon_kg.search.forward import chain, cheapest_first
from foon_kg.search.gaps import gap_cost, mixtures
from foon_kg.search.penalty import needy, reachable, within_least_penalty
from foon_kg.search.reduction import value_of
from foon_kg.store.snapshot import Snapshot

SHARED = Path(__file__).parents[1].parent / "shared" / "data"
ENUMERATED = 200
SOLVER_SECONDS = 20.0
UNITS_AT_MOST, FOODS_AT_MOST = 2_000, 64


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=SHARED / "foon-111" / "TXT")
    parser.add_argument("--queries", action="store_true")
    parser.add_argument("--without-solver", action="store_true")
    parser.add_argument("--time-limit", type=float, default=2.0)
    options = parser.parse_args()
    kitchen = Kitchen.default()
    snapshot = Snapshot.of([result.subgraph for result in read_paths([options.folder])], kitchen)
    started = time.process_time()
    costs = gap_cost(kitchen, snapshot.units, mixtures(kitchen, snapshot.vocabulary()))
    index = UnitIndex.of(snapshot.units, at_hand=kitchen.has, gap_cost=costs)
    print(f"{len(index.units)} units, {len(index.nodes)} nodes; numbered in {ms(started):.0f} ms")
    problems = recipe_problems(snapshot, index) if options.queries else goal_problems(snapshot, index)
    return compare(problems, options.time_limit, with_solver=not options.without_solver)


def goal_problems(snapshot: Snapshot, index: UnitIndex) -> list[SearchProblem]:
    goals = {goal.node: goal for goal in snapshot.goals()}
    return [SearchProblem(index, (node,), wanted_of(goal)) for node, goal in goals.items()]


def recipe_problems(snapshot: Snapshot, index: UnitIndex) -> list[SearchProblem]:
    problems = []
    for path in sorted((SHARED / "queries").glob("*/*.json")):
        recipe = json.loads(path.read_text())
        asked = sorted({entry["object"] for entry in recipe["ingredients"]})
        goal = max(snapshot.goals(recipe["type"]), key=lambda goal: len(set(asked) & set(goal.ingredients)))
        wanted = {name: asked.index(name) for name in goal.ingredients if name in asked}
        problems.append(SearchProblem(index, (goal.node,), wanted))
    return problems


def wanted_of(goal: Goal) -> dict[str, int]:
    return {name: number for number, name in enumerate(goal.ingredients)}


def compare(problems: list[SearchProblem], time_limit: float, *, with_solver: bool) -> int:
    times: dict[str, list[float]] = {}
    ratios: dict[str, list[float]] = {}
    counts: Counter[str] = Counter()
    for number, problem in enumerate(problems):
        print(f"\r{number} of {len(problems)}", end="", file=sys.stderr, flush=True)
        started = time.process_time()
        try:
            tree = retrieve(problem, time_limit=time_limit)
        except NoWayError:
            counts["no way"] += 1
            continue
        searching = ms(started)
        counts["proven"] += tree.exact
        counts["without a gap"] += not tree.gaps
        core = core_behind(problem, problem.index.number_of[problem.targets[0]])
        others = {"greedy": count_greedy(core, tree.objective, counts)}
        if with_solver:
            others["CP-SAT"] = count_solver(core, tree, counts)
        if (taken := count_enumeration(with_gaps_of(problem, tree), tree.objective, counts)) is not None:
            others["enumeration"] = taken
        for name, taken in {"exact search": searching, **others}.items():
            times.setdefault(name, []).append(taken)
            ratios.setdefault(name, []).append(taken / searching)
    print(file=sys.stderr)
    for name, taken in times.items():
        print(
            f"{name:15} {len(taken):4} answers, ms: median {statistics.median(taken):7.1f}, most {max(taken):7.1f}; "
            f"times the exact search: median {statistics.median(ratios[name]):7.2f}, most {max(ratios[name]):7.1f}"
        )
    for name, count in sorted(counts.items()):
        print(f"{name}: {count} of {len(problems)}")
    return 1 if any(name.startswith("DIFFERS") for name in counts) else 0


def count_greedy(core: Core, best: tuple, counts: Counter) -> float:
    started = time.process_time()
    found = value_of(core, cheapest_first(core))[:3]
    taken = ms(started)
    names = ("gaps", "overlap", "units")
    worse = [name for name, mine, its in zip(names, best, found, strict=True) if its > mine]
    counts["greedy is worse, first in " + worse[0] if worse else "greedy is as good"] += 1
    return taken


def count_enumeration(problem: SearchProblem, best: tuple, counts: Counter) -> float | None:
    started = time.process_time()
    enumeration = enumerate_paths(problem, limit=ENUMERATED)
    taken = ms(started)
    if not enumeration.complete:
        counts["more paths than can be enumerated"] += 1
        return None
    if enumeration.found[0].objective != best:
        counts["DIFFERS from the enumeration"] += 1
    return taken


def count_solver(core: Core, tree, counts: Counter) -> float:
    started = time.process_time()
    objective = solve_in_two_parts(core)
    taken = ms(started)
    if objective is None:
        counts["CP-SAT did not prove it"] += 1
    elif tree.exact and objective != tree.objective:
        print("DIFFERS:", tree.goal, tree.objective, "solver", objective)
        counts["DIFFERS from CP-SAT"] += 1
    else:
        counts["the same as CP-SAT"] += tree.exact
    return taken


def solve_in_two_parts(core: Core) -> tuple[int, int, int] | None:
    """Return the least penalty where gaps are needed, then the rest among the steps that can keep it.

    In one piece, with a gap for every node, the solver proves nothing in 20 s.
    """
    _, made = chain(core, range(len(core.gap_nodes), core.step_count))
    least = within_least_penalty(core, Deadline())
    if not made[core.goal]:
        penalty = solve(needy(core, made))
        if penalty is None or penalty[0] != least.penalty:
            return penalty
    return solve(core.only(reachable(core, least.steps)))


def solve(core: Core) -> tuple[int, int, int] | None:
    """One producer for each needed node, ranks against cycles, one weighted sum for the three objectives."""
    from ortools.sat.python import cp_model  # noqa: PLC0415 - the rest runs without the solver

    model = cp_model.CpModel()
    gap_count, nodes = len(core.gap_nodes), range(len(core.nodes))
    used = [model.new_bool_var(f"use{step}") for step in range(core.step_count)]
    needed = [model.new_bool_var(f"need{node}") for node in nodes]
    rank = [model.new_int_var(0, len(core.nodes), f"rank{node}") for node in nodes]
    makers: list[list] = [[] for _ in nodes]
    takers: list[list] = [[] for _ in nodes]
    for step, use in enumerate(used):
        chosen = []
        for node in core.outputs[step]:
            choice = model.new_bool_var(f"choose{node},{step}")
            makers[node].append(choice)
            chosen.append(choice)
            model.add_implication(choice, use)
            for taken in core.inputs[step]:
                model.add(rank[node] > rank[taken]).only_enforce_if(choice)
        model.add_bool_or([*chosen, ~use])
        for taken in core.inputs[step]:
            model.add_implication(use, needed[taken])
            takers[taken].append(use)
    for node in nodes:
        model.add(sum(makers[node]) == needed[node])
        if node != core.goal:
            model.add_bool_or([*takers[node], ~needed[node]])
    model.add(needed[core.goal] == 1)
    covered = []
    for food in range(FOODS_AT_MOST):
        with_food = [use for step, use in enumerate(used) if core.foods[step] >> food & 1]
        if with_food:
            bit = model.new_bool_var(f"food{food}")
            model.add_bool_or([*with_food, ~bit])
            covered.append(bit)
    penalty = sum(cost * use for cost, use in zip(core.costs, used, strict=False))
    units = sum(used[gap_count:])
    model.minimize((penalty * FOODS_AT_MOST - sum(covered)) * UNITS_AT_MOST + units)
    solver = cp_model.CpSolver()
    solver.parameters.num_workers, solver.parameters.max_time_in_seconds = 1, SOLVER_SECONDS
    if solver.solve(model) != cp_model.OPTIMAL:
        return None
    chosen_steps = sum(1 << step for step, use in enumerate(used) if solver.value(use))
    return value_of(core, chosen_steps)[:3]


def ms(started: float) -> float:
    return (time.process_time() - started) * 1000


if __name__ == "__main__":
    sys.exit(main())
