"""What lies between the units of videos, as the graph keeps it: which things move, and which step follows which."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import pairwise

from foon_kg.model import Subgraph

Movement = tuple[str, str, str]
"""The unit, the side of it (``inputs`` or ``outputs``) and the object node, the last by its key like the first."""


def movements(subgraphs: Iterable[Subgraph]) -> Counter[Movement]:
    """Return how many sightings in ``subgraphs`` show each object of each unit moving; none of it that never does."""
    found: Counter[Movement] = Counter()
    for annotation in (one for subgraph in subgraphs for one in subgraph.annotations):
        unit = annotation.unit
        for side, participants in (("inputs", unit.inputs), ("outputs", unit.outputs)):
            found.update({(unit.key, side, one.node.key) for one in participants if one.moving})
    return found


def following(subgraph: Subgraph) -> Iterator[tuple[str, str, int]]:
    """Yield the keys of each unit of the video ``subgraph`` and of the next one, and the place of the first."""
    keys = [annotation.unit.key for annotation in subgraph.annotations]
    yield from ((one, other, place) for place, (one, other) in enumerate(pairwise(keys)))
