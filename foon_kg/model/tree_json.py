"""The steps of a task tree as the JSON of a plan result has them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import cast, get_args

from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.node_json import (
    measures_from_json,
    measures_to_json,
    node_from_json,
    node_to_json,
    sighting_from_json,
    sighting_to_json,
)
from foon_kg.model.tree import Grounding, Mention, Origin, Phase, Step


def unit_to_json(unit: Step) -> JsonObject:
    """Return one of the ``units`` of a plan result.

    >>> from foon_kg.model.nodes import ObjectNode
    >>> peel = Step.of([ObjectNode("onion")], "peel", [ObjectNode("onion", ("peeled",))], "foon", ())
    >>> list(unit_to_json(peel))
    ['input_nodes', 'motion_node', 'output_nodes', 'origin', 'seen_in']
    """
    told: JsonObject = {
        "input_nodes": _side_to_json(unit.inputs),
        "motion_node": unit.motion,
        "output_nodes": _side_to_json(unit.outputs),
    }
    if unit.phase is not None:
        told["phase"] = unit.phase
    told["origin"] = unit.origin
    if unit.grounding is not None:
        told["grounding"] = unit.grounding
    told["seen_in"] = [sighting_to_json(sighting) for sighting in unit.sightings]
    if unit.measures:
        told["measures"] = measures_to_json(unit.measures)
    return told


def unit_from_json(fields: Fields) -> Step:
    """Return the unit of the ``fields`` that :func:`unit_to_json` wrote. Raises ReadError for a word that no plan has.

    The judge reads units more freely (:mod:`foon_kg.validation.tree`): what a stranger's plan says is for its rules.

    >>> from foon_kg.model.nodes import ObjectNode
    >>> peel = Step.of([ObjectNode("onion")], "peel", [ObjectNode("onion", ("peeled",))], "foon", ())
    >>> unit_from_json(Fields(unit_to_json(peel), "units[0]")) == peel
    True
    """
    phase = fields.one_of("phase", get_args(Phase)) if "phase" in fields else None
    return replace(
        step_from_json(fields),
        origin=fields.one_of("origin", get_args(Origin)),
        seen_in=tuple(map(sighting_from_json, fields.nested_list("seen_in"))),
        grounding=fields.one_of("grounding", get_args(Grounding)) if "grounding" in fields else None,
        phase=cast("Phase | None", phase),
        measures=measures_from_json(fields),
    )


def step_from_json(fields: Fields) -> Step:
    """Return what a unit does to what, from its ``fields``; the step says nothing of what speaks for it.

    >>> step_from_json(Fields({"input_nodes": [], "motion_node": "wait", "output_nodes": []}, "units[0]")).motion
    'wait'
    """
    inputs, outputs = (tuple(map(_mention, fields.nested_list(f"{side}_nodes"))) for side in ("input", "output"))
    return Step(inputs, fields.text("motion_node"), outputs)


def _mention(fields: Fields) -> Mention:
    numbers = (fields.whole_number(name) if name in fields else None for name in ("thing", "container_thing"))
    return Mention(node_from_json(fields), *numbers)


def _side_to_json(side: Iterable[Mention]) -> list[JsonObject]:
    told = []
    for node, thing, container in side:
        one = node_to_json(node)
        if thing is not None:
            one["thing"] = thing
        if container is not None:
            one["container_thing"] = container
        told.append(one)
    return told
