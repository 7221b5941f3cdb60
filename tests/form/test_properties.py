"""The judge against independent oracles: on spoilt trees, and on every video as its own tree."""

from __future__ import annotations

import copy
import pathlib
import subprocess
import sys

import pytest
from form.garden import FOON, broken, garden, judge, omelette, salad
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.form import KnownFoon, TaskTree, check
from foon_kg.kitchen import Kitchen
from foon_kg.snapshot import Snapshot

SHARED = pathlib.Path(__file__).resolve().parents[2] / ".." / "shared" / "data"
TREES = st.sampled_from([salad, omelette, garden]).map(lambda make: make())


@st.composite
def shuffled(draw):
    """A good tree with its units in another order and some left out, and some of its kitchen gone."""
    tree = draw(TREES)
    tree["units"] = draw(st.permutations(tree["units"]))[: draw(st.integers(1, len(tree["units"])))]
    gone = draw(st.sets(st.integers(0, len(tree["kitchen"]) - 1), max_size=2))
    tree["kitchen"] = [node for place, node in enumerate(tree["kitchen"]) if place not in gone]
    return tree


def runs(tree):
    """Oracle of C1: put things on the table one by one."""
    table = copy.deepcopy(tree["kitchen"])
    for one in tree["units"]:
        if any(node not in table for node in one["input_nodes"]):
            return False
        table += one["output_nodes"]
    return True


def is_connected(tree):
    """Oracle of C3: mark what is wanted, from the end, until nothing more is marked."""
    units, marked = tree["units"], {len(tree["units"]) - 1}
    while True:
        more = {
            i
            for j in marked
            for i in range(j)
            if any(n in units[j]["input_nodes"] and n not in units[i]["input_nodes"] for n in units[i]["output_nodes"])
        }
        if more <= marked:
            return len(marked) == len(units)
        marked |= more


@given(shuffled())
def test_execution_agrees_with_the_oracle(tree):
    assert ("C1" in broken(tree)) == (not runs(tree))


@given(shuffled())
def test_connection_agrees_with_the_oracle(tree):
    assert ("C3" in broken(tree)) == (not is_connected(tree))


@given(shuffled(), st.randoms(use_true_random=False))
def test_the_verdict_does_not_depend_on_any_order_but_that_of_the_units(tree, random):
    other = copy.deepcopy(tree)
    lists = [other["kitchen"], other["substitutions"], other["recipe"]["ingredients"]]
    lists += [one[side] for one in other["units"] for side in ("input_nodes", "output_nodes")]
    for some in lists:
        random.shuffle(some)
    units = list(FOON.units)
    random.shuffle(units)
    assert broken(other, KnownFoon.of(units, FOON.goals)) == broken(tree)


@given(shuffled())
def test_every_finding_names_a_unit_of_the_tree(tree):
    for finding in judge(tree).findings:
        assert finding.unit is None or 0 <= finding.unit < len(tree["units"])
        assert finding.reason


def test_the_judge_knows_nothing_of_the_planner():
    code = "import sys, foon_kg.form; print(*sorted(m for m in sys.modules if m.startswith('foon_kg')))"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    others = {"planner", "search", "integration", "substitution", "replay", "outcome", "similarity", "goals"}
    assert not {name.split(".")[1] for name in loaded if "." in name} & others


@pytest.mark.shared_data
def test_every_unit_of_every_video_is_grounded_in_itself():
    folder = SHARED / "foon-111" / "TXT"
    if not folder.is_dir():
        pytest.skip(f"the public data are not at {SHARED}: the judge is not tried on real videos")
    from foon_kg.loaders import read_path

    read = [result.subgraph for result in read_path(folder)]
    snapshot = Snapshot.of([subgraph for subgraph in read if subgraph is not None], Kitchen.default())
    foon = KnownFoon.of(snapshot.units, snapshot.goals())
    assert len(snapshot.subgraphs) > 100
    for subgraph in snapshot.subgraphs:
        assert check(TaskTree.from_subgraph(subgraph), foon).of(["C7", "C8"]) == ()
