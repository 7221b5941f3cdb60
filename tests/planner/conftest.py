"""What many tests of planned dishes share: one planner over the public FOON."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from planner.public_foon import public_snapshot
from planner.told_steps import Told, planned_steps


@pytest.fixture(scope="session")
def steps() -> Callable[..., Told]:
    """Return a function that plans a dish from the public FOON and returns its steps."""
    return planned_steps(public_snapshot())
