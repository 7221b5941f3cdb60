"""A plan's behaviour tree, run by py_trees with the code of the documents: it succeeds in its kitchen, in no other."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest
from pictures.demo_plans import demo_plan

from foon_kg.formats.exports.behaviour_tree import write_behaviour_tree
from foon_kg.formats.exports.tree import ExportedTree

py_trees = pytest.importorskip("py_trees")
PAGE = Path(__file__).parents[2] / "docs" / "how-to" / "robot.md"
RECIPES = ("kohlrabi_salad", "courgette_salad", "tomato_salad")


@pytest.fixture(scope="module")
def names() -> dict[str, Any]:
    """What the code of the page defines."""
    [code] = [
        block
        for block in re.findall(r"```py\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
        if "IsSo" in block
    ]
    defined: dict[str, Any] = {}
    exec(compile(code, PAGE.name, "exec"), defined)
    return defined


@pytest.fixture(params=RECIPES)
def xml(request) -> str:
    return write_behaviour_tree(ExportedTree.of_plan(demo_plan(request.param)))


def counted(done: list[str]) -> Callable[..., bool]:
    return lambda motion, _told: done.append(motion) is None


def test_every_motion_is_done_once_and_in_order(names, xml):
    done: list[str] = []
    root = names["run"](xml, names["Kitchen"](), counted(done))
    assert root.status is py_trees.common.Status.SUCCESS
    assert done == [one.get("ID") for one in ET.fromstring(xml).iter("Action") if one.get("name")]


def test_a_kitchen_that_is_otherwise_is_found_out_at_the_first_step_that_needs_it(names, xml):
    first = ET.fromstring(xml).find("BehaviorTree/Sequence/Condition")
    done: list[str] = []
    root = names["run"](xml, names["Kitchen"]({first.get("thing"): "something else"}), counted(done))
    assert root.status is py_trees.common.Status.FAILURE
    assert root.tip().name == first.get("name")
    assert done == []


def test_a_motion_that_fails_ends_the_tree_there(names, xml):
    done: list[str] = []
    root = names["run"](xml, names["Kitchen"](), lambda motion, _told: (done.append(motion), len(done) < 3)[1])
    assert root.status is py_trees.common.Status.FAILURE
    assert len(done) == 3
    assert root.tip().name.startswith("3 ")


@pytest.mark.parametrize("done", [1, 4])
def test_after_a_failure_the_rest_goes_on_in_the_same_kitchen(names, done):
    tree, kitchen = ExportedTree.of_plan(demo_plan("tomato_salad")), names["Kitchen"]()
    motions: list[str] = []
    names["run"](
        write_behaviour_tree(tree), kitchen, lambda motion, _: (motions.append(motion), len(motions) <= done)[1]
    )
    again = names["run"](write_behaviour_tree(tree), kitchen, counted([]))
    assert again.status is py_trees.common.Status.FAILURE  # the whole tree begins with what is no longer so
    rest: list[str] = []
    root = names["run"](write_behaviour_tree(tree.after(done)), kitchen, counted(rest))
    assert root.status is py_trees.common.Status.SUCCESS
    assert [*motions[:done], *rest] == [
        one.get("ID") for one in ET.fromstring(write_behaviour_tree(tree)).iter("Action") if one.get("name")
    ]


def test_after_the_run_the_dish_is_there(names, xml):
    kitchen = names["Kitchen"]()
    names["run"](xml, kitchen)
    last = list(ET.fromstring(xml).iter("Action"))
    outputs = [one.get("outputs") for one in last if one.get("outputs")][-1].split(";")
    assert set(outputs) <= set(kitchen.values())
