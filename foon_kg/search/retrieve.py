"""Algorithm 3: the best reference task tree, proven."""

from __future__ import annotations

from dataclasses import replace

from foon_kg.model import ObjectNode
from foon_kg.search.branch import OverlapSearch, UnitSearch
from foon_kg.search.core import Core, bits_of, core_behind
from foon_kg.search.deadline import Deadline
from foon_kg.search.forward import cheapest_first
from foon_kg.search.missing import no_way
from foon_kg.search.penalty import within_least_penalty
from foon_kg.search.problem import Bound, ReferenceTree, SearchProblem, weakest
from foon_kg.search.reduction import Reduced
from foon_kg.search.schedule import schedule

_PATIENCE = 16
"""How many partial trees to try before looking whether the FOON can be cut down further; doubled each time."""


def retrieve(problem: SearchProblem, *, time_limit: float | None = 2.0) -> ReferenceTree:
    """Answer the best valid task tree that makes one of the problem's targets.

    A tree chooses one producer for each node that is needed and not at hand, well-founded. Best means, in this order:
    the least gap penalty (none, where that is possible); the greatest overlap with the wanted foods; the fewest
    units; the lexicographically least sorted keys of the units; the least gaps; the least target. The answer depends on
    the contents of the problem alone. It is the one that enumerating every path of the paper's Cartesian product
    gives (Sakib, Paulius, Sun 2021, Algorithm 3), found by branch and bound.

    ``time_limit`` is in seconds, ``None`` for none: a search that it stops answers the best tree found so far with
    ``exact=False`` and what is proven about the best.

    Raises NoWayError when nothing makes any target, naming the missing nodes nearest to it first.
    """
    deadline = Deadline.after(time_limit)
    targets = sorted(set(problem.targets), key=lambda node: node.sort_key)
    trees = [tree for target in targets if (tree := _tree_of(problem, target, deadline)) is not None]
    if not trees:
        raise no_way(problem, targets)
    best = min(trees, key=lambda tree: tree.rank)
    bounds = [tree.bound for tree in trees if tree.bound is not None]
    if not any(bound.objective <= best.objective for bound in bounds):
        return best
    return replace(best, exact=False, bound=weakest([*bounds, _bound_of(best)]))


def _tree_of(problem: SearchProblem, target: ObjectNode, deadline: Deadline) -> ReferenceTree | None:
    if target in problem.available:
        return ReferenceTree(target, (), (), penalty=0, covered=(), exact=True)
    number = problem.index.number_of.get(target)
    if number is None:
        return None
    core = core_behind(problem, number)
    least = within_least_penalty(core, deadline)
    if least is None:
        return None
    part, steps, bound = _best_steps(Reduced.of(core, least.penalty, least.steps), deadline)
    if least.at_least < least.penalty:  # nothing is proven but that
        bound = Bound(least.at_least, len(set(problem.wanted.values())), units=1)
    return as_tree(problem, part, steps, bound)


def _best_steps(reduced: Reduced, deadline: Deadline) -> tuple[Core, int, Bound | None]:
    """Answer the best tree as a set of steps of a core, and what is proven where that is not that it is the best."""
    first = cheapest_first(reduced.core)
    widest = OverlapSearch(reduced, first, deadline)
    if not widest.run():
        return reduced.core, widest.best or first, widest.bound()
    search, patience = UnitSearch.from_tree(reduced, widest.best, deadline), _PATIENCE
    while True:
        length = search.value[2]
        if search.run(patience):
            return search.reduced.core, search.best, None
        if deadline.has_passed():
            return search.reduced.core, search.best, search.bound()
        patience *= 2
        if search.value[2] < length:  # a shorter tree rules more out: worth starting again with less
            search = UnitSearch.from_tree(search.reduced, search.best, deadline)


def as_tree(problem: SearchProblem, core: Core, steps: int, bound: Bound | None) -> ReferenceTree:
    """Answer the set ``steps`` of ``core`` as a tree in an order in which it can be executed."""
    index, gap_count = problem.index, len(core.gap_nodes)
    goal = index.nodes[core.nodes[core.goal]]
    gaps = [index.nodes[core.gap_nodes[step]] for step in bits_of(steps) if step < gap_count]
    numbers = [core.units[step - gap_count] for step in bits_of(steps) if step >= gap_count]
    there = {index.nodes[n] for unit in numbers for n in index.inputs[unit] if index.at_hand[n]}
    return ReferenceTree(
        goal=goal,
        units=schedule((index.units[n] for n in numbers), {*there, *problem.available, *gaps} - {goal}, goal),
        gaps=tuple(sorted(gaps, key=lambda node: node.sort_key)),
        penalty=core.penalty_of(steps),
        covered=tuple(bits_of(core.foods_of(steps))),
        exact=bound is None,
        bound=bound,
    )


def _bound_of(tree: ReferenceTree) -> Bound:
    return Bound(tree.penalty, tree.overlap, len(tree.units))
