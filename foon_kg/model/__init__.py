"""The words of a FOON as plain values, and what every room needs: nodes, units, recipes, names, errors.

The values themselves are here for everybody: ``from foon_kg.model import ObjectNode``.
"""

from foon_kg.model.nodes import (
    DISH_TYPES,
    UNMEASURED,
    Annotation,
    AskedAmount,
    FunctionalUnit,
    Goal,
    KnownUnit,
    Measures,
    NodeSortKey,
    ObjectNode,
    Participant,
    Recipe,
    RequiredIngredient,
    Sighting,
    Subgraph,
    Timing,
    content_key,
    shared_node,
    sightings_of,
    steps_of,
)

__all__ = [
    "DISH_TYPES",
    "UNMEASURED",
    "Annotation",
    "AskedAmount",
    "FunctionalUnit",
    "Goal",
    "KnownUnit",
    "Measures",
    "NodeSortKey",
    "ObjectNode",
    "Participant",
    "Recipe",
    "RequiredIngredient",
    "Sighting",
    "Subgraph",
    "Timing",
    "content_key",
    "shared_node",
    "sightings_of",
    "steps_of",
]
