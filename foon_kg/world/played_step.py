"""What happens in one step, and what cannot happen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from foon_kg.food import Motion
from foon_kg.model import ObjectNode
from foon_kg.model.tree import Step
from foon_kg.world.reading import NodeReading
from foon_kg.world.things import Lump, Part, Vessel


@dataclass(frozen=True)
class Mishap:
    """A rule of the contract (W1 to W4, K4, K7) that a step breaks: why, about which nodes, and whether it is minor."""

    rule: str
    reason: str
    nodes: tuple[ObjectNode, ...] = ()
    minor: bool = False


@dataclass(eq=False)
class PlayedStep:
    """One step as it was played.

    ``moved`` has each lump that came to another place, with the places before and after; ``treated`` what the motion
    worked on, ``heated`` the vessels that stood over heat while it cooked, ``taken`` the parts that were fetched
    from the kitchen, ``made`` the products. ``vessels`` are those that took part, ``hot`` those that hold food over
    heat afterwards, ``in_oven`` whether what was heated stood in an oven, ``emptied`` those that hold nothing any more.
    ``input_readings`` and ``output_readings`` are what the nodes of the step say, in their order.
    """

    number: int
    step: Step
    motion: Motion
    mishaps: list[Mishap] = field(default_factory=list)
    moved: list[tuple[Lump, Vessel | None, Vessel | None]] = field(default_factory=list)
    treated: Sequence[Lump] = ()
    heated: Sequence[Vessel] = ()
    taken: list[Part] = field(default_factory=list)
    made: list[Lump] = field(default_factory=list)
    inputs: list[Lump] = field(default_factory=list)
    outputs: dict[ObjectNode, Lump] = field(default_factory=dict)
    vessels: list[Vessel] = field(default_factory=list)
    tools: Sequence[ObjectNode] = ()
    vessels_moved: bool = False
    emptied: Sequence[Vessel] = ()
    input_readings: Sequence[NodeReading] = ()
    output_readings: Sequence[NodeReading] = ()
    hot: Sequence[Vessel] = ()
    in_oven: bool = False

    def fault(self, rule: str, reason: str, *nodes: ObjectNode, minor: bool = False) -> None:
        """Keep a mishap, each once: the ``rule`` it breaks, the ``reason`` in a sentence, the ``nodes`` that show it.

        A ``minor`` one is odd, yet it can be done.
        """
        mishap = Mishap(rule, reason, nodes, minor)
        if mishap not in self.mishaps:
            self.mishaps.append(mishap)

    def does(self, *classes: str) -> bool:
        """Whether the motion does one of these."""
        return not self.motion.does.isdisjoint(classes)

    def is_made_of(self, lump: Lump, before: Vessel | None) -> bool:
        """Whether ``lump`` went up in a product of the step in the very place where it was ``before``."""
        return lump.gone and any(product.where is before for product in self.made)
