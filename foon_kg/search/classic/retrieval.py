"""From a goal and a kitchen to the best task tree."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.model.errors import UsageError
from foon_kg.model.tree import newly_made
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.shortage import nearest_first
from foon_kg.search import NoWayError, SearchProblem, UnitIndex, retrieve
from foon_kg.search.classic.behind import PartBehind, part_behind
from foon_kg.search.classic.goal import Criterion, GoalSought, RetrievalView
from foon_kg.search.classic.result import RetrievalResult, RetrievedUnit
from foon_kg.search.classic.success import likeliest_tree
from foon_kg.search.deadline import Deadline
from foon_kg.search.missing import no_way, no_way_without


def retrieve_tree(
    view: RetrievalView,
    sought: GoalSought,
    kitchen: Kitchen,
    costs: MotionCosts,
    *,
    time_limit: float | None = 10.0,
) -> RetrievalResult:
    """Return the best tree, by the criterion of ``sought``, for any object node of the FOON of ``view`` that fits it.

    A tree chooses one producer for each object node that is needed and not at hand in ``kitchen``, well-founded; a unit
    that serves several counts once; the goal is made by a unit even where the kitchen has it. Where two trees are as
    good, that with the fewer units is taken, then that with the lexicographically least sorted keys of its units, then
    the least goal. By success (``costs`` are 0 to 1 for each motion), a unit that never succeeds is not used.
    ``time_limit`` is in seconds, ``None`` for none. This is the retrieval of Paulius et al. (2016), and of Sakib et al.
    by weights.

    Raises NoTreeError for a goal that the FOON does not have; NoWayError, naming the leaves that the nearest tree
    lacks, where nothing makes it; UsageError where success is asked and there are no weights.
    """
    if sought.by is Criterion.SUCCESS and not costs:
        raise UsageError(
            "there are no weights of motions to know a success rate by",
            hint="Name a file of weights with --weights FILE, or load one: foon load weights FILE.",
        )
    part = part_behind(view, sought.candidates(view), sought.level, kitchen)
    if sought.by is Criterion.UNITS:
        try:
            tree = retrieve(_problem(part, part.units), time_limit=time_limit)
        except NoWayError as error:
            raise _nearest(part, part.units, time_limit) or error from None
        return _tree(sought, tree.goal, tree.units, costs, tree.bound.units if tree.bound else None)
    usable = [known for known in part.units if costs.success(known.unit.motion)]
    likeliest = likeliest_tree(_problem(part, usable), costs, Deadline.after(time_limit))
    if likeliest is None:
        raise _no_way(part, usable, time_limit)
    return _tree(sought, likeliest.goal, likeliest.units, costs, likeliest.bound)


def _problem(part: PartBehind, units: Sequence[KnownUnit]) -> SearchProblem:
    return SearchProblem(UnitIndex.of(units, at_hand=part.at_hand.__contains__), part.goals)


def _nearest(part: PartBehind, usable: Sequence[KnownUnit], time_limit: float | None) -> NoWayError | None:
    """Return the error that names the leaves that the nearest tree lacks: the fewest; ``None`` where no tree is near.

    A leaf is what no unit makes, and what a usual kitchen has: an empty bowl is made of full ones alone.
    ``time_limit`` is in seconds.
    """
    made = {node for known in usable for node in newly_made(known.unit)}
    usual = Kitchen.default()

    def cost(node: ObjectNode) -> int | None:
        return 1 if node not in made or usual.has(node) else None

    index = UnitIndex.of(usable, at_hand=part.at_hand.__contains__, gap_cost=cost)
    try:
        tree = retrieve(SearchProblem(index, part.goals), time_limit=time_limit)
    except NoWayError:
        return None
    units = [(known.unit.input_nodes, known.unit.output_nodes) for known in tree.units]
    return no_way_without((tree.goal,), nearest_first(tree.gaps, units, tree.goal)) if tree.gaps else None


def _no_way(part: PartBehind, usable: list[KnownUnit], time_limit: float | None) -> NoWayError:
    error = _nearest(part, usable, time_limit) or no_way(_problem(part, usable), part.goals)
    never = sorted({known.unit.motion for known in part.units} - {known.unit.motion for known in usable})
    if never:
        error.hint += f" By these weights a robot never succeeds to {', '.join(never)}."
    return error


def _tree(
    sought: GoalSought, goal: ObjectNode, units: tuple[KnownUnit, ...], costs: MotionCosts, bound: float | None
) -> RetrievalResult:
    steps = tuple(RetrievedUnit(known, costs.success(known.unit.motion) if costs else None) for known in units)
    assumed = costs.unknown(known.unit.motion for known in units) if costs else ()
    return RetrievalResult(sought, goal, steps, exact=bound is None, assumed=assumed, bound=bound)
