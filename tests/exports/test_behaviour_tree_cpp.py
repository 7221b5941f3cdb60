"""A plan's behaviour tree, read and run by BehaviorTree.CPP itself, whose bindings to Python are behaviortreepy.

In these bindings a node cannot say which ports it has, and BehaviorTree.CPP makes no tree with ports that no node has:
it reads the file as it is, and runs it without them. A node in C++ says so by ``providedPorts``, as ``TreeNodesModel``
has them.
"""

from __future__ import annotations

from xml.etree import ElementTree as ET

import pytest
from pictures.demo_plans import demo_plan

from foon_kg.formats.exports.behaviour_tree import write_behaviour_tree
from foon_kg.formats.exports.tree import ExportedTree

bt = pytest.importorskip("behaviortreepy", reason="behaviortreepy is not installed")


@pytest.fixture(scope="module")
def xml():
    return write_behaviour_tree(ExportedTree.of_plan(demo_plan("kohlrabi_salad")))


def factory(xml, done, fails=""):
    """Nodes for all that ``TreeNodesModel`` lists; each writes its name into ``done``, and the one called so fails."""
    made = bt.BehaviorTreeFactory()

    def tick(node):
        done.append(node.name())
        return bt.NodeStatus.FAILURE if node.name() == fails else bt.NodeStatus.SUCCESS

    for model in ET.fromstring(xml).find("TreeNodesModel"):
        register = made.register_simple_condition if model.tag == "Condition" else made.register_simple_action
        register(model.get("ID"), tick)
    return made


def without_ports(xml):
    root = ET.fromstring(xml)
    root.remove(root.find("TreeNodesModel"))
    for node in root.find("BehaviorTree/Sequence"):
        for port in set(node.attrib) - {"ID", "name"}:
            del node.attrib[port]
    return ET.tostring(root, encoding="unicode")


def names(xml):
    return [node.get("name") for node in ET.fromstring(xml).find("BehaviorTree/Sequence")]


def test_it_is_read_as_it_is_where_the_nodes_it_lists_are_there(xml):
    made = factory(xml, [])
    made.register_behavior_tree_from_text(xml)
    assert made.registered_behavior_trees() == ["TaskTree"]
    with pytest.raises(RuntimeError, match="Node not recognized: IsSo"):
        bt.BehaviorTreeFactory().register_behavior_tree_from_text(xml)


def test_all_of_it_is_done_in_order(xml):
    done = []
    assert factory(xml, done).create_tree_from_text(without_ports(xml)).tick_while_running() == bt.NodeStatus.SUCCESS
    assert done == names(xml)


def test_it_ends_at_the_first_step_that_fails(xml):
    fails = next(name for name in names(xml) if name.startswith("3 "))
    done = []
    tree = factory(xml, done, fails).create_tree_from_text(without_ports(xml))
    assert tree.tick_while_running() == bt.NodeStatus.FAILURE
    assert done == names(xml)[: len(done)]
    assert done[-1] == fails
