"""How many examples a property is tried on: some in a run of the tests, ten times as many in ``make campaign``."""

from __future__ import annotations

import os

from hypothesis import HealthCheck, settings

TIMES = 10 if os.environ.get("FOON_KG_CAMPAIGN") == "yes" else 1


def examples(count: int, *, base: settings | None = None) -> settings:
    """Settings for so many examples, whatever the time that each takes and whichever fixtures it is given."""
    return settings(base, max_examples=count * TIMES, deadline=None, suppress_health_check=list(HealthCheck))
