"""What speaks for and against one drafted unit, and several units of one action as one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from math import prod

from foon_kg.model import FunctionalUnit, Participant
from foon_kg.model.drafts import DraftUnit

SOMETHING = 0.6
"""A share below this is worth a word."""

IMPLIED = 0.5
"""How sure it is what nobody says and no share speaks for."""

UNSEEN = 0.5
"""How sure it is what was never seen: as likely as not."""


@dataclass
class Evidence:
    """What speaks for a unit: shares that are multiplied, and doubts in words."""

    shares: list[float] = field(default_factory=list)
    doubts: list[str] = field(default_factory=list)
    states: float = 1.0

    def weigh_states(self, share: float, doubt: str = "") -> None:
        """Weigh a ``share`` (0 to 1) of what is guessed of the states of a food, and add ``doubt`` to the doubts.

        It is as unsure in every later unit.
        """
        self.states *= share
        self.weigh(share, doubt)

    def weigh(self, share: float, doubt: str = "") -> None:
        """Weigh a ``share`` (0 to 1), and add ``doubt`` to the doubts where it is small."""
        self.shares.append(share)
        if doubt and share < SOMETHING:
            self.doubts.append(doubt)

    def product(self) -> float:
        """Return all shares multiplied."""
        return prod(self.shares)


def as_one(units: Sequence[DraftUnit]) -> DraftUnit:
    """Return one unit for several that follow each other: what they take from outside, and what is left of them."""
    inputs, outputs = dict[Participant, None](), dict[Participant, None]()
    for draft in units:
        unit = draft.annotation.unit
        inputs |= dict.fromkeys(one for one in unit.inputs if one not in outputs)
        outputs = {one: None for one in outputs if one not in unit.inputs} | dict.fromkeys(unit.outputs)
    first = units[0].annotation
    whole = FunctionalUnit(tuple(inputs), first.unit.motion, tuple(outputs))
    doubts = dict.fromkeys(doubt for draft in units for doubt in draft.doubts)
    return replace(
        units[0],
        annotation=replace(first, unit=whole),
        confidence=min(draft.confidence for draft in units),
        doubts=tuple(doubts),
    )
