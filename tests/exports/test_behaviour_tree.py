"""A behaviour tree is what BehaviorTree.CPP 4 reads: one action a step, known models, ports that can be read back."""

from __future__ import annotations

import re
from urllib.parse import unquote
from xml.etree import ElementTree as ET

import pytest
from exports.odd_trees import of_file, trees
from hypothesis import given, settings
from kitchen_stories import SALAD, node, subgraph
from pictures.demo_plans import demo_plan

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.formats.exports.behaviour_tree import write_behaviour_tree
from foon_kg.formats.exports.notation import node_text
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.model import ObjectNode
from foon_kg.model.errors import FormatError

NOTATION = re.compile(
    r"(?P<label>[^;(){}\[\]]*?)(?: \((?P<states>[^)]*)\))?(?: \{(?P<inside>[^}]*)\})?"
    r"(?: \[(?P<relation>[^:\]]*): (?P<place>[^\]]*)\])?"
)
NOT_IN_NAMES = set("<>&\"'/\\:*?|.{}();,")


def node_of(text):
    """Read an object node as anybody could who read the documentation of the notation."""
    match = NOTATION.fullmatch(text)
    assert match, text
    states, inside = ([unquote(one) for one in (match[key] or "").split(", ") if one] for key in ("states", "inside"))
    return ObjectNode(
        unquote(match["label"]),
        tuple(states),
        tuple(inside),
        unquote(match["relation"] or "") or None,
        unquote(match["place"] or "") or None,
    )


@settings(max_examples=40, deadline=None)
@given(trees)
def test_the_xml_keeps_the_rules_of_behaviortree_cpp(tree):
    root = ET.fromstring(write_behaviour_tree(tree))
    assert (root.tag, root.get("BTCPP_format")) == ("root", "4")
    assert [child.tag for child in root] == ["BehaviorTree", "TreeNodesModel"]
    behaviour, model = root
    assert root.get("main_tree_to_execute") == behaviour.get("ID")
    (sequence,) = behaviour
    assert (sequence.tag, len(sequence)) == ("Sequence", len(tree.units))
    ports = {action.get("ID"): [port.get("name") for port in action] for action in model}
    assert len(ports) == len(model) == len({known.unit.motion for known in tree.units})
    for action in sequence:
        assert (action.tag, len(action)) == ("Action", 0)
        assert re.fullmatch("[A-Z][A-Za-z0-9]*", action.get("ID"))
        assert set(action.attrib) - {"ID", "name"} <= set(ports[action.get("ID")])
        assert not NOT_IN_NAMES & set(action.get("name"))
        assert not any(value.startswith("{") for value in action.attrib.values()), (
            "taken for an entry of the blackboard"
        )


@settings(max_examples=40, deadline=None)
@given(trees)
def test_every_object_node_can_be_read_back_from_the_ports(tree):
    actions = ET.fromstring(write_behaviour_tree(tree)).iter("Action")
    for known, action in zip(tree.units, actions, strict=False):
        assert tuple(map(node_of, action.get("inputs").split(";"))) == known.unit.input_nodes
        assert tuple(map(node_of, action.get("outputs").split(";"))) == known.unit.output_nodes
        moving = {p.node for p in (*known.unit.inputs, *known.unit.outputs) if p.moving}
        assert set(map(node_of, filter(None, action.get("moving").split(";")))) == moving


def test_an_action_says_what_it_needs_what_it_makes_and_where_it_was_seen():
    root = ET.fromstring(write_behaviour_tree(of_file(subgraph("greek", "salad", *SALAD))))
    dice = next(action for action in root.iter("Action") if action.get("ID") == "DiceMotion")
    assert dice.attrib == {
        "ID": "DiceMotion",
        "name": "2 dice",
        "inputs": "tomato (whole) [on: cutting board];knife",
        "outputs": "tomato (diced) [on: cutting board]",
        "moving": "",
        "video": "greek",
        "unit": "1",
    }


def test_every_action_of_a_plan_stands_behind_what_has_to_be_so_before_it():
    plan = demo_plan("tomato_salad")
    root = ET.fromstring(write_behaviour_tree(ExportedTree.of_plan(plan)))
    told, before = [], []
    for one in root.find("BehaviorTree/Sequence"):
        if one.tag == "Condition":
            before.append((node_of(one.get("object")), int(one.get("thing"))))
        else:
            told.append((before, one.get("input_things"), one.get("output_things")))
            before = []
    assert [conditions for conditions, _, _ in told] == [
        [(node, thing) for node, thing, _ in unit.inputs] for unit in plan.units
    ]
    assert told[-1][2] == ";".join(str(thing) for _, thing, _ in plan.units[-1].outputs)
    assert root.find("TreeNodesModel/Condition").get("ID") == "IsSo"


def test_an_action_whose_motion_has_a_weight_says_how_likely_it_succeeds():
    tree = of_file(subgraph("salad", "salad", *SALAD))
    root = ET.fromstring(write_behaviour_tree(tree, MotionCosts({"chop": 0.9})))
    rates = [action.get("success_rate") for action in root.iter("Action") if action.get("inputs")]
    assert rates == ["0.1" if known.unit.motion == "chop" else None for known in tree.units]
    assert "0.1" in rates


def test_motions_that_differ_only_in_marks_are_two_actions():
    lines = ("a > cut-up > b", "b > cut up > c", "c > 切る > soup{a}")
    root = ET.fromstring(write_behaviour_tree(of_file(subgraph("x", "soup", *lines))))
    assert [a.get("ID") for a in root.find("BehaviorTree/Sequence")] == ["CutUpMotion", "CutUpMotion2", "Motion"]


def test_control_characters_are_no_xml():
    with pytest.raises(FormatError, match=r"U\+0001"):
        write_behaviour_tree(of_file(subgraph("x\x01", "soup", "a > fry > soup{a}")))


def test_the_notation_keeps_names_apart_from_its_own_marks():
    assert node_text(node("onion(chopped){garlic}@on cutting_board")) == "onion (chopped) {garlic} [on: cutting board]"
    assert node_text(ObjectNode("a;b", ("off (ready)",), (), None, "x:y")) == "a%3Bb (off %28ready%29) [: x%3Ay]"
    assert node_text(ObjectNode("line\nend")) == "line%0Aend"
