"""What many tests of planned dishes share: one planner over the public FOON."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from planner.public_foon import public_snapshot
from planner.told_steps import Told, plans_of, steps_of

from foon_kg.plans.result import PlanResult


@pytest.fixture(scope="session")
def public_plans() -> Callable[..., PlanResult]:
    """Return a function that plans a dish from the public FOON."""
    return plans_of(public_snapshot())


@pytest.fixture(scope="session")
def steps(public_plans: Callable[..., PlanResult]) -> Callable[..., Told]:
    """Return a function that plans a dish from the public FOON and returns its steps."""
    return steps_of(public_plans)
