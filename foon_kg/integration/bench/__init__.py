"""The kitchen in which a final tree is built: every step happens to things with an identity, or is refused.

Each method does one kind of step. Before it is applied it is bound to the units of the FOON that attest it; a step that
nothing attests, or that cannot happen (food into a covered vessel, an appliance that is off), raises
:class:`RefusedError` and leaves the kitchen as it was.

A :class:`Bench` grows over four modules: ``inventory`` (things and their nodes), ``steps`` (evidence, and what
happened), ``handwork`` (what is done to foods) and ``appliances`` (with their lids).
"""

from __future__ import annotations

from foon_kg.integration.bench.appliances import Bench
from foon_kg.integration.bench.steps import Done, RefusedError
from foon_kg.integration.bench.things import (
    Device,
    Stuff,
    Thing,
    Vessel,
    fineness,
    foods_of,
    is_baked,
    is_flat,
    is_heated,
)

__all__ = [
    "Bench", "Device", "Done", "RefusedError", "Stuff", "Thing", "Vessel",
    "fineness", "foods_of", "is_baked", "is_flat", "is_heated",
]  # fmt: skip
