"""Every step of the reference and of the final tree is told once, and what became of it."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode, Participant, Sighting
from foon_kg.model.tree import Step
from foon_kg.plans.step_changes import step_changes


def known(place, inputs, motion, outputs):
    sides = [tuple(Participant(node) for node in side) for side in (inputs, outputs)]
    return KnownUnit(FunctionalUnit(sides[0], motion, sides[1]), (Sighting("video", place),))


def planned(unit, step=None, **changed):
    return replace(step or Step.of_unit(unit.unit), **{"origin": "foon", "seen_in": unit.seen_in, **changed})


CARROT, GRATED = ObjectNode("carrot"), ObjectNode("carrot", ("grated",))
KOHLRABI, GRATED_KOHLRABI = ObjectNode("kohlrabi"), ObjectNode("kohlrabi", ("grated",))
GRATE = known(0, [CARROT], "grate", [GRATED])
SALT = known(1, [GRATED, ObjectNode("salt")], "sprinkle", [GRATED])
TOSS = known(2, [GRATED], "toss", [ObjectNode("salad")])
PEEL = Step.of((KOHLRABI,), "peel", (KOHLRABI,), "foon", (Sighting("other", 4),))


def told(reference, final):
    return [
        (one.change, one.before and one.before[0], one.after and one.after[0]) for one in step_changes(reference, final)
    ]


def test_steps_are_kept_changed_left_out_and_added():
    grate = planned(GRATE, Step.of((KOHLRABI,), "grate", (GRATED_KOHLRABI,)), origin="adapted")
    assert told([GRATE, SALT, TOSS], [PEEL, grate, planned(TOSS)]) == [
        ("added", None, 1),
        ("changed", 1, 2),
        ("left out", 2, None),
        ("kept", 3, 3),
    ]


def test_a_changed_step_says_what_is_gone_and_what_came():
    shave = planned(GRATE, Step.of((KOHLRABI,), "shave", (GRATED_KOHLRABI,)))
    (one,) = step_changes([GRATE], [shave])
    assert (one.gone, one.come) == (("carrot", "grate"), ("kohlrabi", "shave"))


def test_a_step_that_only_moved_is_still_kept():
    assert told([GRATE, SALT], [planned(SALT), planned(GRATE)]) == [("kept", 2, 1), ("kept", 1, 2)]


@given(st.permutations(range(6)), st.integers(0, 6), st.lists(st.integers(0, 6), max_size=3))
def test_every_step_of_both_trees_is_told_once(order, length, added):
    reference = [known(place, [CARROT], "grate", [GRATED]) for place in range(6)]
    final = [planned(reference[place]) for place in order[:length]]
    for place in added:
        final.insert(min(place, len(final)), PEEL)
    rows = step_changes(reference, final)
    assert sorted(one.before[0] for one in rows if one.before) == list(range(1, 7))
    assert [one.after[0] for one in rows if one.after] == list(range(1, len(final) + 1))
    assert sum(one.change == "kept" for one in rows) == length
    assert sum(one.change == "added" for one in rows) == len(added)
