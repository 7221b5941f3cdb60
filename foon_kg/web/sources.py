"""What of a FOON is looked at beside a plan: by the judge, by who tells what stands for what, and for durations."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

from foon_kg.foon import Answer, Foon, Snapshot, WithDrafts
from foon_kg.model import KnownUnit
from foon_kg.model.errors import UsageError
from foon_kg.plans.result import PlanResult
from foon_kg.validation import KnownFoon
from foon_kg.web.evidence import Place, by_place

SAMPLE = 150
"""So many videos of a FOON that is too large for memory tell how long motions take, and are examples of its dishes."""


@dataclass(frozen=True)
class Source:
    """The units and goals with which a plan is compared, and its units by where they are seen."""

    known: KnownFoon
    places: dict[Place, KnownUnit]

    @classmethod
    def of(cls, foon: Snapshot | WithDrafts) -> Source:
        """Return those of a ``foon`` in memory."""
        return cls(KnownFoon.of(foon.units, foon.goals()), by_place(foon.units))


class Sources(Protocol):
    """Where a desk looks things up."""

    @property
    def sample(self) -> Snapshot:
        """The FOON, or some videos of it."""
        ...

    def get_ready(self) -> None:
        """Look up what the first question would wait for."""
        ...

    def check(self, *, with_drafts: bool) -> None:
        """Raise UsageError unless plans can be made with drafts, where that is asked."""
        ...

    def of(self, answer: Answer, *, with_drafts: bool) -> Source:
        """Return with what the plan of an ``answer`` is compared, made with drafts (``with_drafts``) or without."""
        ...


class WholeSources:
    """Everything is in memory."""

    def __init__(self, foon: Foon) -> None:
        self._foon = foon

    @cached_property
    def sample(self) -> Snapshot:
        """The whole FOON."""
        return self._foon.snapshot()

    def get_ready(self) -> None:
        """Put the units where they are found by what shows them."""
        _ = self._alone

    def check(self, *, with_drafts: bool) -> None:
        """Raise nothing, ``with_drafts`` or without."""

    def of(self, _: Answer, *, with_drafts: bool) -> Source:
        """Return the whole FOON, with the drafted steps in it where ``with_drafts``."""
        return self._with_drafts if with_drafts else self._alone

    @cached_property
    def _alone(self) -> Source:
        return Source.of(self.sample)

    @cached_property
    def _with_drafts(self) -> Source:
        return Source.of(self._foon.with_drafts())


class PartSources:
    """The graph is asked for the videos that a plan names, and for some others once."""

    def __init__(self, foon: Foon) -> None:
        self._foon = foon

    @cached_property
    def sample(self) -> Snapshot:
        """Some videos of the FOON, the same as long as none of them is taken out."""
        return self._foon.sample(SAMPLE)

    def get_ready(self) -> None:
        """Read some videos."""
        _ = self.sample

    def check(self, *, with_drafts: bool) -> None:
        """Raise UsageError for drafts, which are read with the whole."""
        if with_drafts:
            hint = "Leave out with_drafts, or serve fewer videos."
            raise UsageError("this FOON is too large to plan with drafts", hint=hint)

    def of(self, answer: Answer, *, with_drafts: bool) -> Source:
        """Return the videos that the plan of an ``answer`` names, and the goals of its dish type.

        Raises UsageError for a plan ``with_drafts``. What the judge knows of other videos' steps ("FOON has an operator
        for such a food") is not looked at.
        """
        self.check(with_drafts=with_drafts)
        if not isinstance(answer.outcome, PlanResult):
            raise TypeError("only a plan has sources")
        plan = answer.outcome
        seen = {sighting.video for unit in plan.units for sighting in unit.sightings}
        part = self._foon.of_videos(seen | set(plan.reference.videos))
        return Source(KnownFoon.of(part.units, self._foon.goals(plan.recipe.dish_type)), by_place(part.units))
