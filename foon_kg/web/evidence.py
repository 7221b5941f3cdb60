"""What each step of a plan goes back to, in words: the second of a video, and what stands for what in it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from foon_kg.model import KnownUnit, ObjectNode, Sighting
from foon_kg.model.claims import Substitution
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.tree import Step

Place = tuple[str, int]
"""A video, and the place of a unit in it."""


def by_place(units: Iterable[KnownUnit]) -> dict[Place, KnownUnit]:
    """Return the units of a FOON by where they are seen."""
    return {_place(seen): known for known in units for seen in known.seen_in}


def stands_in(unit: Step, substitutions: Sequence[Substitution], known: Mapping[Place, KnownUnit]) -> list[JsonObject]:
    """Return which foods of the step ``unit`` stand where the video shows others, and how sure that is (0 to 1).

    They are among the ``substitutions`` of the plan; ``known`` has the units of the FOON by where they are seen. A unit
    of the FOON as it is has none, whatever is in the mixtures that it is done to.
    """
    if unit.origin == "foon":
        return []
    shown = set[str]()
    for seen in unit.sightings:
        recorded = known.get(_place(seen))
        if recorded is not None:
            shown |= _names((*recorded.unit.input_nodes, *recorded.unit.output_nodes))
    own = _names((*unit.input_nodes, *unit.output_nodes)) - shown
    found = [one for one in substitutions if one.kind == "object" and one.object in own and one.equivalent in shown]
    return [{"object": one.object, "equivalent": one.equivalent, "confidence": one.confidence} for one in found]


def _names(nodes: Iterable[ObjectNode]) -> set[str]:
    return {name for node in nodes for name in (node.label, *node.ingredients)}


def _place(seen: Sighting) -> Place:
    return seen.video, seen.position
