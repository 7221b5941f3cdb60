from types import SimpleNamespace

import pytest
from kitchen_stories import node, script, subgraph
from planner.dishes import KITCHEN, SETTINGS

from foon_kg.errors import NoTreeError
from foon_kg.form import KnownFoon, TaskTree, check
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.planner import plan
from foon_kg.repairs import best_of
from foon_kg.replay import replay
from foon_kg.script import Casting, Repertoire, Script
from foon_kg.snapshot import Snapshot

DOUGH = (
    "bowl(empty); packet{yeast}; yeast(powder)@packet > pour > bowl{yeast}; yeast(powder)@bowl",
    "cup(empty); carton{milk}; milk(liquid)@carton > pour > cup{milk}; milk(liquid)@cup",
    "cup{milk}; bowl{yeast}; yeast(powder)@bowl > pour > cup{milk,yeast}; yeast(powder)@cup",
    "cup{milk,yeast}; milk(liquid)@cup; yeast(powder)@cup; bowl{yeast}; spoon > stir > dough(mixed){milk,yeast}@cup",
)
"""The yeast is poured out of its bowl, and the bowl stands beside the stirring as if it were full."""

POURED_OUT = (3, node("bowl{yeast}"))


def dough(*foods):
    return Recipe("bread", tuple(RequiredIngredient(*food.split()) for food in foods))


def report_of(snapshot, result):
    return check(TaskTree.from_json(result.to_json()), KnownFoon.of(snapshot.units, snapshot.goals()))


def test_a_vessel_that_was_poured_out_stands_by_empty_where_its_food_is():
    units = script(*DOUGH)
    last = replay(Script.of(units, Repertoire(KITCHEN)), Casting(spent=frozenset({POURED_OUT}))).steps[-1]
    assert node("bowl(empty)") in last.input_nodes
    assert last.output_nodes == (node("dough(mixed){milk,yeast}@cup"),)


def test_a_step_says_which_node_of_the_script_each_input_was():
    units = script(*DOUGH)
    last = replay(Script.of(units, Repertoire(KITCHEN)), Casting(spent=frozenset({POURED_OUT}))).steps[-1]
    assert (node("bowl{yeast}"), node("bowl(empty)")) in last.taken


def test_a_food_that_was_taken_away_is_not_there_a_second_time():
    units = script(*DOUGH[:3])
    spent = frozenset({(2, node("yeast(powder)@bowl")), (2, node("bowl{yeast}"))})
    assert len(replay(Script.of(units, Repertoire(KITCHEN)), Casting(spent=spent)).steps) == 2


def test_nothing_is_taken_twice_though_the_video_does_so():
    snapshot = Snapshot.of([subgraph("dough", "bread", *DOUGH)], KITCHEN)
    result = plan(snapshot, dough("yeast powder", "milk liquid"), SETTINGS)
    assert node("bowl(empty)") in result.units[-1].input_nodes
    assert [str(finding) for finding in report_of(snapshot, result).of({"C8", "S1"})] == []


def attempt(number):
    def no_faults(*_):
        return frozenset()

    integration = SimpleNamespace(number=number, refused=frozenset(), blamed=no_faults, taken_twice=no_faults)
    return SimpleNamespace(integration=integration, tree=None, report=SimpleNamespace(of=no_faults))


def faults_of(table):
    return lambda one: (table[one.integration.number],)


def judged(one):
    if one.integration.number < 0:
        raise NoTreeError("nothing is left", code="left-out")
    return one


def best(table, *numbers):
    asked = []

    def judge(integration):
        asked.append(integration.number)
        return judged(next(one for one in attempts if one.integration is integration))

    attempts = [attempt(number) for number in numbers]
    found = best_of((one.integration for one in attempts), judge, faults_of(table))
    return found.integration.number, asked


def test_a_tree_without_a_fault_needs_no_other_script():
    assert best({1: 0, 2: 0}, 1, 2) == (1, [1])


def test_a_tree_with_faults_is_left_for_one_with_fewer_and_kept_before_one_with_as_many():
    assert best({1: 2, 2: 1}, 1, 2) == (2, [1, 2])
    assert best({1: 1, 2: 1}, 1, 2) == (1, [1, 2])


def test_where_the_first_script_has_no_tree_the_next_one_may_have():
    assert best({1: 3}, -1, 1) == (1, [-1, 1])
    with pytest.raises(NoTreeError, match="nothing is left"):
        best({}, -1, -2)
