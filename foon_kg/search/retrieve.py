"""Algorithm 3: the best reference task tree, proven."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.search.branch import OverlapSearch, UnitSearch
from foon_kg.search.core import Core, bits_of
from foon_kg.search.deadline import Deadline
from foon_kg.search.forward import cheapest_first
from foon_kg.search.ground import Explored, Goals, Ground, alike
from foon_kg.search.missing import no_way
from foon_kg.search.problem import Bound, ReferenceTree, SearchProblem, weakest
from foon_kg.search.reduction import Reduced
from foon_kg.search.schedule import last_of, schedule

_PATIENCE = 16
"""How many partial trees to try before looking whether the FOON can be cut down further; doubled each time."""


def retrieve(
    problem: SearchProblem, *, time_limit: float | None = 2.0, explored: Explored | None = None
) -> ReferenceTree:
    """Return the best valid task tree that makes one of the problem's targets.

    A tree chooses one producer for each node that is needed and not at hand, well-founded. Best means, in this order:
    the least gap penalty (none, where that is possible); the greatest overlap with the wanted foods; the fewest
    units; the lexicographically least sorted keys of the units; the least gaps; the least target. The answer depends on
    the contents of the problem alone. It is the one that enumerating every path of the paper's Cartesian product
    gives (Sakib, Paulius, Sun 2021, Algorithm 3), found by branch and bound.

    ``time_limit`` is in seconds, ``None`` for none: a search that it stops returns the best tree found so far with
    ``exact=False`` and what is proven about the best. ``explored`` is what was found for other questions to this index
    and keeps what is found now; it changes no answer that is proven, and serves where nothing is ``available``.

    Raises NoWayError when nothing makes any target, naming the missing nodes nearest to it first.
    """
    deadline = Deadline.after(time_limit)
    targets = sorted(set(problem.targets), key=lambda node: node.sort_key)
    search = _TargetSearch(problem, deadline, Explored() if explored is None or problem.available else explored)
    trees = list(search.trees(targets))
    if not trees:
        raise no_way(problem, targets)
    best = min(trees, key=lambda tree: tree.rank)
    bounds = [tree.bound for tree in trees if tree.bound is not None]
    if not any(bound.objective <= best.objective for bound in bounds):
        return best
    return replace(best, exact=False, bound=weakest([*bounds, _bound_of(best)]))


@dataclass(frozen=True, eq=False)
class _TargetSearch:
    problem: SearchProblem
    deadline: Deadline
    explored: Explored

    def trees(self, targets: Sequence[ObjectNode]) -> Iterator[ReferenceTree]:
        """Yield the best tree of each of ``targets``, or the best of them all alone."""
        number_of, available = self.problem.index.number_of, self.problem.available
        yield from (ReferenceTree(node, (), (), 0, (), exact=True) for node in targets if node in available)
        goals = tuple(number_of[node] for node in targets if node not in available and node in number_of)
        yield from filter(None, self._trees_of(goals))

    def _trees_of(self, goals: Goals) -> Iterator[ReferenceTree | None]:
        """Yield the best tree of all ``goals`` together where no food is wanted, else that of each."""
        together = self._tree(goals) if len(goals) > 1 and not self.problem.wanted else None
        if together is not None:
            yield together
        else:
            yield from (self._tree((goal,)) for goal in goals)

    def _tree(self, goals: Goals) -> ReferenceTree | None:
        ground = self.explored.ground(self.problem, goals, self.deadline)
        if ground is None:
            return None
        undecided = ground.undecided(self.problem.wanted)
        key = (goals, alike(undecided))
        tree = self.explored.trees.get(key)
        if tree is None:
            tree = self._found(goals, ground, undecided)
            if tree is not None and tree.exact:
                self.explored.trees[key] = tree
        return None if tree is None else covering(tree, self.problem.wanted)

    def _found(self, goals: Goals, ground: Ground, undecided: Mapping[str, int]) -> ReferenceTree | None:
        """Search for the best tree; ``None`` where each of several goals has to be asked apart."""
        wanted = self.problem.wanted
        part, steps, bound = _best_steps(ground.wanting(undecided), self.deadline)
        if not ground.is_proven:  # nothing is proven but that
            bound = Bound(ground.at_least, len(set(wanted.values())), units=1)
        elif bound is not None:
            settled = {number for label, number in wanted.items() if label in ground.certain}
            bound = replace(bound, overlap=bound.overlap + len(settled))
        if len(goals) == 1:
            return as_tree(self.problem, part, steps, bound)
        goal = _least_made(self.problem, goals, part, steps) if bound is None else None
        return None if goal is None else _ordered(self.problem, goal, part, steps, bound)


def _best_steps(reduced: Reduced, deadline: Deadline) -> tuple[Core, int, Bound | None]:
    """Return the best tree as a set of steps of a core, and what is proven where that is not that it is the best."""
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
    """Return the set ``steps`` of ``core`` (bits) as a tree of ``problem`` in an order in which it can be executed.

    ``bound`` is what is proven where that is not that the tree is the best.
    """
    return _ordered(problem, problem.index.nodes[core.nodes[core.goal]], core, steps, bound)


def _ordered(problem: SearchProblem, goal: ObjectNode, core: Core, steps: int, bound: Bound | None) -> ReferenceTree:
    gaps = _gaps_in(problem, core, steps)
    units, there = _units_in(problem, core, steps)
    tree = ReferenceTree(
        goal=goal,
        units=schedule(units, {*there, *gaps} - {goal}, goal),
        gaps=tuple(sorted(gaps, key=lambda node: node.sort_key)),
        penalty=core.penalty_of(steps),
        covered=(),
        exact=bound is None,
        bound=bound,
    )
    return covering(tree, problem.wanted)


def covering(tree: ReferenceTree, wanted: Mapping[str, int]) -> ReferenceTree:
    """Return ``tree`` with the foods of ``wanted`` (names by the number of a food) that occur in it."""
    labels = {node.label for known in tree.units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
    return replace(tree, covered=tuple(sorted({number for label, number in wanted.items() if label in labels})))


def _gaps_in(problem: SearchProblem, core: Core, steps: int) -> list[ObjectNode]:
    return [problem.index.nodes[core.gap_nodes[step]] for step in bits_of(steps) if step < len(core.gap_nodes)]


def _units_in(problem: SearchProblem, core: Core, steps: int) -> tuple[list[KnownUnit], set[ObjectNode]]:
    """Return the units among ``steps``, and the nodes that they take from the kitchen or that are available."""
    index = problem.index
    numbers = [core.units[unit] for unit in bits_of(steps >> len(core.gap_nodes))]
    there = {index.nodes[node] for number in numbers for node in index.inputs[number] if index.at_hand[node]}
    return [index.units[number] for number in numbers], there | problem.available


def _least_made(problem: SearchProblem, goals: Goals, core: Core, steps: int) -> ObjectNode | None:
    """Return which of ``goals`` the last unit of the best tree makes out of anything but itself; the least of several.

    The best tree that makes any of them is then the best tree of this one; without wanted foods it has no unit that
    the others could do without, and so one last unit.
    """
    units, there = _units_in(problem, core, steps)
    there.update(_gaps_in(problem, core, steps))
    taken = {node for known in units for node in known.unit.input_nodes}
    nodes = sorted((problem.index.nodes[goal] for goal in goals), key=lambda node: node.sort_key)
    return next((node for node in nodes if node not in taken and last_of(units, there, node) is not None), None)


def _bound_of(tree: ReferenceTree) -> Bound:
    return Bound(tree.penalty, tree.overlap, len(tree.units))
