"""A reference tree is kept once it is proven, and searched again where time cut the search short."""

from __future__ import annotations

from dataclasses import replace

from demo_foon import demo_foon

from foon_kg.planning.references import References
from foon_kg.planning.settings import PlanSettings

SNAPSHOT = demo_foon()


def test_what_time_cut_short_is_searched_again_and_what_is_proven_is_kept():
    hasty = References(SNAPSHOT, PlanSettings(time_limit=0.0), SNAPSHOT.units)
    patient = References(SNAPSHOT, PlanSettings(time_limit=None), SNAPSHOT.units)
    cut_short = 0
    for goal in SNAPSHOT.goals():
        wanted = {label: number for number, label in enumerate(goal.node.ingredients[:2])}
        first, proven = hasty.tree(goal, wanted), patient.tree(goal, wanted)
        assert proven.exact
        assert patient.tree(goal, wanted) is proven
        cut_short += not first.exact
        hasty.settings = replace(hasty.settings, time_limit=None)
        assert hasty.tree(goal, wanted).exact  # whatever the first one was
        hasty.settings = replace(hasty.settings, time_limit=0.0)
    assert cut_short > 0
