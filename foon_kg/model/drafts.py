"""A draft: units with how sure each is and what is doubtful about it, and what of the narration gave no unit.

Here are the values. :mod:`foon_kg.language.drafting` makes them, :mod:`foon_kg.loaders.draft_tables` reads and writes
their files, and :mod:`foon_kg.model.drafted` has those of whole collections, which nobody reviews.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from foon_kg.model import Annotation, Subgraph, Timing

SURE = 0.1
"""Doubts below this must be resolved before a draft is accepted: of units hardly one in ten of which is all right.

The confidence asks for every state, too, which few drafts have all right: nine in ten units from verbs and nouns have
the right motion and main object, and a quarter every state. A person decides about the least sure seventh.
"""


@dataclass(frozen=True)
class DraftUnit:
    """One unit as drafted.

    ``confidence`` is the probability that motion, main object and the states of that object are all right. It comes
    from the shares of like actions in the FOON that speak for each thing that the narration leaves unsaid (motion,
    states, places), each counted with one success and one failure more than were seen (Laplace), and from how well the
    food that they are taken from stands for the one narrated; see :mod:`foon_kg.language.drafting.calibration`.
    ``doubts`` say so in words.
    """

    annotation: Annotation
    confidence: float
    doubts: tuple[str, ...] = ()
    said: str = ""


@dataclass(frozen=True)
class LeftOut:
    """A part of the narration that gave no unit, and why.

    ``settled`` says that a person need not decide on it: it changes nothing, or a later unit has it.
    """

    said: str
    reason: str
    timing: Timing = field(default_factory=Timing)
    settled: bool = False


@dataclass(frozen=True)
class Draft:
    """The draft of one video or recipe: units and what was left out, in the order of the narration."""

    name: str
    rows: tuple[DraftUnit | LeftOut, ...]
    source: str = ""
    dish_type: str | None = None

    @property
    def units(self) -> tuple[DraftUnit, ...]:
        """The units alone.

        >>> Draft("toast", (LeftOut("Enjoy!", "it does nothing"),)).units
        ()
        """
        return tuple(row for row in self.rows if isinstance(row, DraftUnit))

    @property
    def left_out(self) -> tuple[LeftOut, ...]:
        """What gave no unit.

        >>> [one.said for one in Draft("toast", (LeftOut("Enjoy!", "it does nothing"),)).left_out]
        ['Enjoy!']
        """
        return tuple(row for row in self.rows if isinstance(row, LeftOut))

    def subgraph(self) -> Subgraph:
        """Return the units as a subgraph, without confidences and doubts.

        >>> Draft("toast", (LeftOut("Enjoy!", "it does nothing"),)).subgraph()
        Subgraph(name='toast', annotations=(), sources=())
        """
        return Subgraph(self.name, tuple(unit.annotation for unit in self.units))


@dataclass(frozen=True)
class DraftRow:
    """One row of a draft as it stands in its file: ``annotation`` is ``None`` where it is no unit (yet)."""

    line: int
    annotation: Annotation | None
    confidence: float
    doubts: tuple[str, ...]
    said: str


@dataclass(frozen=True)
class DraftFile:
    """A draft as it was read: its rows in their order, its units as a subgraph, and what is wrong with the file."""

    path: str
    rows: tuple[DraftRow, ...]
    subgraph: Subgraph | None
    notices: tuple[str, ...]

    def unresolved(self, sure: float = SURE) -> tuple[DraftRow, ...]:
        """Return the rows with doubts and less than ``sure`` confidence (0 to 1), and those that are no units.

        >>> row = DraftRow(2, None, 0.0, ("there is no verb in it",), "“Pancakes”")
        >>> [one.line for one in DraftFile("pancakes.csv", (row,), None, ()).unresolved()]
        [2]
        """
        return tuple(row for row in self.rows if (row.confidence < sure if row.doubts else row.annotation is None))
