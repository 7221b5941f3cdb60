"""Planners of others solve our problems, and their validator accepts our order of steps."""

from __future__ import annotations

import itertools
from importlib.util import find_spec

import pytest
from exports.odd_trees import ODD, of_file
from kitchen_stories import SALAD, subgraph
from pictures.demo_plans import demo_plan

from foon_kg.formats.exports.pddl import foon_to_pddl, tree_to_pddl
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Participant, Subgraph
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot

# to import them takes a second, of each process that collects the tests
THERE = all(find_spec(name) for name in ("unified_planning", "up_fast_downward"))
pytestmark = pytest.mark.skipif(not THERE, reason="the extra [planners] is not installed")


@pytest.fixture
def judged(tmp_path, monkeypatch):
    """Write a problem as files, let Fast Downward solve it, and answer its number of steps and two verdicts."""
    from unified_planning.engines import ValidationResultStatus
    from unified_planning.io import PDDLReader
    from unified_planning.shortcuts import OneshotPlanner, PlanValidator, get_environment

    monkeypatch.chdir(tmp_path)  # Fast Downward writes where it stands
    get_environment().credits_stream = None

    def judge(written, *, lines=None):
        for name, text in (("domain", written.domain), ("problem", written.problem), ("plan", written.plan or "")):
            (tmp_path / name).write_text(text, encoding="utf-8")
        reader = PDDLReader()
        problem = reader.parse_problem(str(tmp_path / "domain"), str(tmp_path / "problem"))
        with OneshotPlanner(name="fast-downward") as planner:
            plan = planner.solve(problem).plan
        with PlanValidator(name="sequential_plan_validator") as validator:
            ours = reader.parse_plan_string(problem, "\n".join(lines) if lines else written.plan or "")
            verdicts = [validator.validate(problem, one).status for one in (plan, ours)]
        return len(plan.actions), *(verdict is ValidationResultStatus.VALID for verdict in verdicts)

    return judge


def test_a_recorded_dish_is_solved_in_as_many_steps_and_our_order_is_accepted(judged):
    written = tree_to_pddl(of_file(subgraph("salad", "salad", *SALAD)))
    assert judged(written) == (len(SALAD), True, True)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["tomato_salad", "courgette_salad", "berry_smoothie"])
def test_a_plan_of_numbered_things_is_solved_in_as_many_steps_and_our_order_is_accepted(judged, name):
    plan = demo_plan(name)
    written = tree_to_pddl(ExportedTree.of_plan(plan))
    assert "(not (at " in written.domain
    assert judged(written) == (len(plan.units), True, True)


@pytest.mark.slow
def test_what_a_step_leaves_is_where_a_planner_goes_on(judged):
    plan = demo_plan("tomato_salad")
    whole = tree_to_pddl(ExportedTree.of_plan(plan))
    for done in (1, len(plan.units) // 2, len(plan.units) - 1):
        rest = tree_to_pddl(ExportedTree.of_plan(plan).after(done))
        assert rest.domain == whole.domain
        assert judged(rest) == (len(plan.units) - done, True, True)


def test_an_order_in_which_something_is_missing_is_not_accepted(judged):
    written = tree_to_pddl(of_file(subgraph("salad", "salad", *SALAD)))
    steps = [line for line in written.plan.splitlines() if line.startswith("(")]
    assert judged(written, lines=[*steps[1:], steps[0]]) == (len(SALAD), True, False)


def test_names_that_hold_marks_of_pddl_are_read_all_the_same(judged):
    nodes = [ObjectNode(name, (name,), (name,), name, name) for name in (*ODD, "object", "and", ";")]
    units = [
        FunctionalUnit((Participant(before),), before.label, (Participant(after),))
        for before, after in itertools.pairwise(nodes)
    ]
    last = units[-1]
    units[-1] = FunctionalUnit(last.inputs, last.motion, (Participant(nodes[-1], dish_type="salad"),))
    tree = of_file(Subgraph("odd\nname", tuple(map(Annotation, units))))
    assert judged(tree_to_pddl(tree)) == (len(units), True, True)


@pytest.mark.slow
def test_a_dish_of_a_whole_foon_is_made_from_what_the_kitchen_has(judged):
    foon = Snapshot.of(
        [subgraph("a", "salad", *SALAD), subgraph("b", "soup", "onion(whole); pot > boil > soup{onion}@pot")],
        Kitchen.default(),
    )
    steps, solved, _ = judged(foon_to_pddl(foon, "salad"))
    assert (steps, solved) == (len(SALAD), True)
    steps, solved, _ = judged(foon_to_pddl(foon, "soup"))
    assert (steps, solved) == (1, True)
