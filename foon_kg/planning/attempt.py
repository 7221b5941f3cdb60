"""A tree that was built after one recorded dish, before it is known whether it is the answer."""

from __future__ import annotations

from dataclasses import dataclass

from foon_kg.goals.choice import Fit
from foon_kg.integration.making.cooking import Cooking
from foon_kg.model import ObjectNode
from foon_kg.plans.result import PlanResult
from foon_kg.validation import Report


@dataclass(frozen=True)
class Attempt:
    """A tree that was built after one frame, with what the judge says of it and what its kitchen lacks."""

    fit: Fit
    result: PlanResult
    report: Report
    missing: tuple[ObjectNode, ...]
    cooking: Cooking
