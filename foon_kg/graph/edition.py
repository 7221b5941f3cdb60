"""What was read of one edition of the FOON: true as long as nobody writes, so the next view need not ask again."""

from __future__ import annotations

from dataclasses import dataclass, field

from foon_kg.knowledge import Vocabulary
from foon_kg.model import Goal, KnownUnit

MOST_UNITS = 20_000
"""Bounds the memory that units read before may take: some 60 MB."""


@dataclass
class Edition:
    """The answers that one edition of the FOON gave so far; views of the same edition share it.

    ``name`` is ``None`` where the graph does not tell editions apart: then every view begins with nothing.
    """

    name: str | None = None
    vocabulary: Vocabulary | None = None
    goals: dict[str, tuple[Goal, ...]] = field(default_factory=dict)
    units: dict[str, KnownUnit] = field(default_factory=dict)

    def still(self, name: str | None) -> Edition:
        """Answer this edition where the graph has it still and it is not too large, else a new one without answers."""
        same = name is not None and name == self.name and len(self.units) <= MOST_UNITS
        return self if same else Edition(name)
