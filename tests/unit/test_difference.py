"""What a file would change is what loading it changes: told beforehand, and counted afterwards."""

from __future__ import annotations

import pytest
from foons import foons, subgraphs_named
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.plans.difference import Status, differences

NAMES = ("a", "b", "c", "d")


def units(foon):
    return {a.unit.key for subgraph in foon for a in subgraph.annotations}


def labels(foon):
    return {p.node.label for s in foon for a in s.annotations for p in (*a.unit.inputs, *a.unit.outputs)}


def keys(listed):
    return {unit.key for unit in listed}


@pytest.mark.slow
@given(foons(), st.sampled_from(NAMES).flatmap(subgraphs_named))
def test_added_and_dropped_units_are_what_the_foon_gains_and_loses(foon, video):
    (told,) = differences([video], foon)
    others = [subgraph for subgraph in foon if subgraph.name != video.name]
    before, after = units(foon), units([*others, video])
    assert keys(told.added) == after - before
    assert keys(told.dropped) == before - after
    assert set(told.new_labels) == labels([video]) - labels(foon)


@pytest.mark.slow
@given(foons(), st.sampled_from(NAMES).flatmap(subgraphs_named))
def test_every_distinct_unit_stands_in_one_list(foon, video):
    (told,) = differences([video], foon)
    old = [subgraph for subgraph in foon if subgraph.name == video.name]
    came = keys(told.added) | keys(one.unit for one in told.shared)
    went = keys(told.dropped) | keys(one.unit for one in told.left)
    assert came == units([video]) - units(old)
    assert went == units(old) - units([video])
    assert told.kept == len(units(old) & units([video]))
    assert len(came) == len(told.added) + len(told.shared)


@pytest.mark.slow
@given(foons(), st.sampled_from(NAMES).flatmap(subgraphs_named))
def test_the_videos_named_beside_a_unit_are_the_others_that_show_it(foon, video):
    (told,) = differences([video], foon)
    for one in (*told.shared, *told.left):
        others = [s.name for s in foon if s.name != video.name and one.unit.key in units([s])]
        assert one.videos == tuple(sorted(others)) != ()


@pytest.mark.slow
@given(foons())
def test_what_is_there_already_changes_nothing(foon):
    for told in differences(foon, foon):
        assert (told.status, told.added, told.shared, told.dropped, told.left) == (Status.UNCHANGED, (), (), (), ())
