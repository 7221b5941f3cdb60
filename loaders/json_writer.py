"""Write a FOON subgraph as JSON. Nothing of it is lost: see ``foon_kg.loaders.json_reader`` for the fields."""

from __future__ import annotations

import json

from foon_kg.loaders.json_reader import read_json
from foon_kg.model import Annotation, Participant, Subgraph
from foon_kg.model.errors import FormatError
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.node_json import measures_to_json, node_to_json, sighting_to_json


def write_json(subgraph: Subgraph) -> str:
    """Return ``subgraph`` as JSON, which ``read_json`` reads back to the same; its name is the file's to carry.

    Raises ``FormatError`` where it would be read back as something else: for a subgraph without units, for names that
    are empty or hold control characters or white space other than single blanks, for times that are none.
    """
    units = [annotation_to_json(annotation) for annotation in subgraph.annotations]
    text = json.dumps({"sources": list(subgraph.sources), "units": units}, ensure_ascii=False, indent=2) + "\n"
    read = read_json(text, subgraph.name)
    if read.subgraph != subgraph:
        reasons = [str(notice) for notice in read.notices] or [f"{subgraph.name}: a name with odd white space"]
        raise FormatError(f"cannot be written as JSON: {reasons[0]}", hint="Correct what it names.")
    return text


def annotation_to_json(annotation: Annotation) -> JsonObject:
    """Return one unit with its time (``annotation``) as an object of JSON."""
    unit, timing = annotation.unit, annotation.timing
    told: JsonObject = {
        "input_nodes": [_participant_to_json(one) for one in unit.inputs],
        "motion_node": unit.motion,
        "accepts_any": unit.accepts_any,
        "output_nodes": [_participant_to_json(one) for one in unit.outputs],
        "timing": {"spans": [list(span) for span in timing.spans], "assumed": timing.assumed},
    }
    if annotation.measures:
        told["measures"] = measures_to_json(annotation.measures)
    if annotation.seen_in is not None:
        told["seen_in"] = [sighting_to_json(seen) for seen in annotation.seen_in]
    return told


def _participant_to_json(participant: Participant) -> JsonObject:
    return node_to_json(participant.node) | {"moving": participant.moving, "dish_type": participant.dish_type}
