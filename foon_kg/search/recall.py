"""Reference trees that were retrieved before, taken from memory instead of searched for.

A tree is taken only where everything that its choice depends on is the same again: the goal and the wanted foods (the
*question*), and the units behind the goal with what every node costs (the *grounds*). So nothing that happens to the
memory or to the FOON in between can make an answer wrong; at worst it makes it slow.
"""

from __future__ import annotations

from foon_kg.model import content_key
from foon_kg.model.knowledge import RetrievedTree, TreeMemory
from foon_kg.search.core import Core, core_behind
from foon_kg.search.ground import Explored
from foon_kg.search.problem import ReferenceTree, SearchProblem
from foon_kg.search.retrieve import as_tree, retrieve

RULES = 1
"""Names the rules by which :func:`~foon_kg.search.retrieve` prefers trees; others need another number."""


def retrieve_once(
    problem: SearchProblem,
    memory: TreeMemory | None,
    *,
    time_limit: float | None = 2.0,
    explored: Explored | None = None,
) -> ReferenceTree:
    """Return what :func:`~foon_kg.search.retrieve` answers to ``problem``, from ``memory`` if it was asked before.

    What had to be searched for (in ``time_limit`` seconds) is remembered if it is proven. A problem with several
    targets, or with nodes that another tree made, is always searched. ``explored`` holds what was found in the index so
    far.
    """
    (target, *others) = problem.targets
    number = problem.index.number_of.get(target)
    if memory is None or number is None or others or problem.available:
        return retrieve(problem, time_limit=time_limit, explored=explored)
    core = core_behind(problem, number)
    question, grounds = question_of(problem), grounds_of(problem, core)
    known = memory.remembered(question)
    if known is not None and known.grounds == grounds:
        return _made_again(problem, core, known)
    tree = retrieve(problem, time_limit=time_limit, explored=explored)
    if tree.exact:
        units = tuple(sorted(unit.unit.key for unit in tree.units))
        memory.remember(RetrievedTree(question, grounds, tree.goal.key, units, tuple(gap.key for gap in tree.gaps)))
    return tree


def question_of(problem: SearchProblem) -> str:
    """Return a name for what ``problem`` asks: the goal, and which foods count as which required ingredient."""
    return content_key(RULES, problem.targets[0].key, sorted(problem.wanted.items()))


def grounds_of(problem: SearchProblem, core: Core) -> str:
    """Return a name for all in ``core`` that may decide the answer to ``problem``: units, what is there, costs."""
    index = problem.index
    nodes = [(index.nodes[number].key, index.gap_costs[number]) for number in core.nodes]
    return content_key([index.units[number].unit.key for number in core.units], nodes)


def _made_again(problem: SearchProblem, core: Core, known: RetrievedTree) -> ReferenceTree:
    index, gap_count = problem.index, len(core.gap_nodes)
    units, gaps = set(known.units), set(known.gaps)
    steps = [step for step, number in enumerate(core.gap_nodes) if index.nodes[number].key in gaps]
    steps += [gap_count + place for place, number in enumerate(core.units) if index.units[number].unit.key in units]
    return as_tree(problem, core, sum(1 << step for step in steps), None)
