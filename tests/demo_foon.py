"""The demo's FOON: read once in a process, and what it teaches learnt once, whichever tests ask for it."""

from __future__ import annotations

from functools import cache

from foon_kg.foon.demo import demo_folder
from foon_kg.loaders import read_paths
from foon_kg.model import Subgraph
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot


@cache
def demo_subgraphs() -> tuple[Subgraph, ...]:
    """The subgraphs of its videos, sorted by name."""
    return tuple(result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None)


@cache
def demo_foon() -> Snapshot:
    """All of it, with the kitchen that everybody has."""
    return Snapshot.of(demo_subgraphs(), Kitchen.default())
