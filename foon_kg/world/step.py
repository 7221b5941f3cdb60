"""One step of a task tree as it is played: which things go in, what is done, which things come out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from foon_kg.model import ObjectNode


class Mention(NamedTuple):
    """An object node as a tree mentions it.

    ``thing`` is the number of the thing that it is, ``container_thing`` that of its container; ``None`` where the tree
    does not number its things: they are then told apart by what their nodes say.
    """

    node: ObjectNode
    thing: int | None = None
    container_thing: int | None = None


@dataclass(frozen=True)
class Step:
    """Inputs → motion → outputs."""

    inputs: tuple[Mention, ...]
    motion: str
    outputs: tuple[Mention, ...]

    @classmethod
    def of(cls, inputs: tuple[ObjectNode, ...], motion: str, outputs: tuple[ObjectNode, ...]) -> Step:
        """Return the step of a functional unit, whose things have no numbers."""
        return cls(tuple(map(Mention, inputs)), motion, tuple(map(Mention, outputs)))
