"""Every goal of the public FOON has a proven tree that keeps C1 to C3; skipped where the data are not there."""

from pathlib import Path

import pytest

from foon_kg.loaders import read_paths
from foon_kg.plans.kitchen import Kitchen
from foon_kg.search import SearchProblem, UnitIndex, retrieve
from foon_kg.store.snapshot import Snapshot

FOLDER = Path(__file__).parents[2].parent / "shared" / "data" / "foon-111" / "TXT"


@pytest.mark.shared_data
@pytest.mark.slow
@pytest.mark.skipif(not FOLDER.is_dir(), reason=f"the public subgraphs are not at {FOLDER}")
def test_the_tree_of_every_goal_is_proven_executable_and_connected():
    kitchen = Kitchen.default()
    snapshot = Snapshot.of([result.subgraph for result in read_paths([FOLDER])], kitchen)
    index = UnitIndex.of(snapshot.units, at_hand=kitchen.has, gap_cost=lambda _: 1)
    goals = snapshot.goals()
    assert len(goals) > 100
    for goal in goals:
        wanted = {name: number for number, name in enumerate(goal.ingredients)}
        tree = retrieve(SearchProblem(index, (goal.node,), wanted), time_limit=None)
        assert tree.exact
        made = set()
        for known in tree.units:
            assert all(n in made or kitchen.has(n) or n in tree.gaps for n in known.unit.input_nodes)
            made.update(known.unit.output_nodes)
        assert goal.node in tree.units[-1].unit.output_nodes
        useful = {goal.node}
        for known in reversed(tree.units):
            assert not useful.isdisjoint(known.unit.output_nodes)
            useful.update(known.unit.input_nodes)
        assert tree.penalty == len(tree.gaps)
