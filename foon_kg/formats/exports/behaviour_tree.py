"""Behaviour trees for robots, in the XML of BehaviorTree.CPP 4: one sequence with one action a functional unit.

The ID of an action is its motion in camel case (``pick-and-place``: ``PickAndPlaceMotion``); what a robot has to
register is listed in ``TreeNodesModel``. Ports are lists of texts between semicolons, as BehaviorTree.CPP reads a
``std::vector<std::string>``; an object node is written as in :mod:`foon_kg.formats.exports.notation`, so that no name
in it is taken for two entries or for one of the blackboard.

Before each action of a plan stands the condition under which it can be carried out: which thing (the numbers tell one
bowl from another) is how and where. A robot that finds it otherwise fails there, and knows why.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from xml.etree import ElementTree as ET

from foon_kg.food.motion_costs import NO_COSTS, MotionCosts
from foon_kg.formats.exports.markup import xml_document, xml_text
from foon_kg.formats.exports.notation import node_text
from foon_kg.formats.exports.pddl_names import slug
from foon_kg.formats.exports.pddl_things import has_numbers
from foon_kg.formats.exports.tree import ExportedTree, best_sighting
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.model.tree import Step

_TREE = "TaskTree"
_TEXTS = "std::vector<std::string>"
_CONDITION = "IsSo"
_CONDITION_PORTS = {
    "object": ("std::string", "the object node as it has to be"),
    "thing": ("int", "the number of the thing that it is"),
    "container_thing": ("int", "the number of the thing in or on which it is"),
}
_PORTS = {
    "inputs": (_TEXTS, "object nodes that have to be there"),
    "outputs": (_TEXTS, "object nodes that are there when it is done"),
    "moving": (_TEXTS, "those of them that move while it is done"),
    "input_things": ("std::vector<int>", "the numbers of the things that the inputs are"),
    "output_things": ("std::vector<int>", "the numbers of the things that the outputs are"),
    "video": ("std::string", "the video in which it was seen"),
    "unit": ("int", "which unit of that video it is, from 0"),
    "address": ("std::string", "the address of that video"),
    "start": ("double", "the second of the video in which it begins"),
    "end": ("double", "the second of the video in which it ends"),
    "success_rate": ("double", "how likely it succeeds, from 0 to 1"),
}


def write_behaviour_tree(tree: ExportedTree, costs: MotionCosts = NO_COSTS) -> str:
    """Return a task tree as a behaviour tree; actions have a success rate where ``costs`` know their motion.

    Of a tree of which some steps are done it has the others. Raises :class:`~foon_kg.model.errors.FormatError` for
    names with control characters, which no XML can hold.
    """
    names = _action_names(dict.fromkeys(known.unit.motion for known in tree.units))
    root = ET.Element("root", {"BTCPP_format": "4", "main_tree_to_execute": _TREE})
    sequence = ET.SubElement(ET.SubElement(root, "BehaviorTree", {"ID": _TREE}), "Sequence")
    sequence.set("name", _instance(tree.title))
    planned = tree.result.units if tree.result is not None and has_numbers(tree.result) else ()
    for place, known in enumerate(tree.units[tree.done :], tree.done + 1):
        attributes = _attributes(place, known, names) | _success(known, costs)
        if planned:
            _add_conditions(sequence, planned[place - 1])
            attributes |= _numbers(planned[place - 1])
        ET.SubElement(sequence, "Action", attributes)
    model = ET.SubElement(root, "TreeNodesModel")
    for name in names.values():
        _add_model(model, "Action", name, _PORTS)
    if planned:
        _add_model(model, "Condition", _CONDITION, _CONDITION_PORTS)
    return xml_document(root)


def _action_names(motions: Iterable[str]) -> dict[str, str]:
    """Return an ID for each motion, which is never one of BehaviorTree.CPP's own actions (``Sleep``, ``Script``)."""
    names: dict[str, str] = {}
    for motion in motions:
        wanted = "".join(word.capitalize() for word in slug(motion).split("_")) + "Motion"
        wanted = wanted if wanted[0].isalpha() else f"Do{wanted}"
        name, count = wanted, 1
        while name in names.values():
            count += 1
            name = f"{wanted}{count}"
        names[motion] = name
    return names


def _attributes(place: int, known: KnownUnit, names: dict[str, str]) -> dict[str, str]:
    unit = known.unit
    moving = dict.fromkeys(p.node for p in (*unit.inputs, *unit.outputs) if p.moving)
    attributes = {
        "ID": names[unit.motion],
        "name": _instance(f"{place} {unit.motion}"),
        "inputs": _listed(unit.input_nodes),
        "outputs": _listed(unit.output_nodes),
        "moving": _listed(moving),
    }
    seen = best_sighting(known)
    if seen is not None:
        attributes |= {"video": _literal(seen.video), "unit": str(seen.position)}
        if seen.source:
            attributes["address"] = _literal(seen.source)
        if seen.start is not None and seen.end is not None:
            attributes |= {"start": f"{seen.start:g}", "end": f"{seen.end:g}"}
    return attributes


def _success(known: KnownUnit, costs: MotionCosts) -> dict[str, str]:
    motion = known.unit.motion
    return {"success_rate": f"{float(costs.success(motion)):g}"} if motion in costs.costs else {}


def _add_conditions(sequence: ET.Element, unit: Step) -> None:
    for one in unit.inputs:
        attributes = {"ID": _CONDITION, "name": _instance(one.node.label), "object": xml_text(node_text(one.node))}
        attributes["thing"] = str(one.thing)
        if one.container_thing is not None:
            attributes["container_thing"] = str(one.container_thing)
        ET.SubElement(sequence, "Condition", attributes)


def _numbers(unit: Step) -> dict[str, str]:
    """Return the numbers of all nodes, in the order of the nodes; here two things that look alike are two."""
    sides = {"input": unit.inputs, "output": unit.outputs}
    told = {f"{name}_things": ";".join(str(one.thing) for one in side) for name, side in sides.items()}
    return told | {f"{name}s": _listed(one.node for one in side) for name, side in sides.items()}


def _add_model(model: ET.Element, tag: str, name: str, ports: Mapping[str, tuple[str, str]]) -> None:
    described = ET.SubElement(model, tag, {"ID": name})
    for port, (kind, meaning) in ports.items():
        ET.SubElement(described, "input_port", {"name": port, "type": kind}).text = meaning


def _listed(nodes: Iterable[ObjectNode]) -> str:
    return xml_text(";".join(map(node_text, nodes)))


def _literal(text: str) -> str:
    """Return ``text`` so that it is not taken for an entry of the blackboard, which stands in braces."""
    return xml_text(text.replace("{", "%7B").replace("}", "%7D"))


def _instance(text: str) -> str:
    """Return ``text`` in the characters that Groot and BehaviorTree.CPP allow in names of nodes."""
    return "".join(c if c.isalnum() or c in " -_" else "_" for c in text)
