"""Classic retrieval answers the best tree that there is: compared with trying every set of units."""

from __future__ import annotations

from dataclasses import fields

import pytest
from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from kitchen_stories import node, unit
from robot_kitchens import best_of_all, costs, deep_foons, foons, goals, kitchens, sought

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.model import Annotation, Subgraph
from foon_kg.model.errors import NoTreeError, UsageError
from foon_kg.model.levels import Level, units_at
from foon_kg.plans.kitchen import Kitchen
from foon_kg.search import NoWayError
from foon_kg.search.classic import Criterion, GoalSought, retrieve_tree
from foon_kg.store.snapshot import Snapshot
from foon_kg.validation import KnownFoon, check, tree_from_json

KITCHEN = Kitchen.default()


def answer(snapshot, asked, kitchen, weights):
    try:
        return retrieve_tree(snapshot, asked, kitchen, weights, time_limit=None)
    except NoTreeError:
        return None


@pytest.mark.slow
@pytest.mark.parametrize("by", Criterion)
@pytest.mark.parametrize("level", Level)
@examples(20)
@given(foon=foons() | deep_foons(), goal=goals, beside=st.tuples(costs, kitchens))
def test_no_set_of_units_is_a_better_tree(level, by, foon, goal, beside):
    asked, (weights, kitchen) = sought(goal, level, by), beside
    found = answer(Snapshot.of(foon, KITCHEN), asked, kitchen, weights)
    best = best_of_all(foon, asked, kitchen, weights)
    if best is None:
        assert found is None
        return
    assert (found.goal, sorted(step.known.unit.key for step in found.units)) == best
    assert found.exact


@examples(30)
@given(foons() | deep_foons(), goals, costs, st.sampled_from(Level), st.sampled_from(Criterion))
def test_a_tree_is_executable_ends_with_its_goal_and_names_every_place_where_its_units_were_seen(
    subgraphs, goal, weights, level, by
):
    snapshot = Snapshot.of(subgraphs, KITCHEN)
    found = answer(snapshot, sought(goal, level, by), KITCHEN, weights)
    if found is None:
        return
    have = set(found.kitchen)
    for step in found.units:
        assert have.issuperset(step.known.unit.input_nodes)
        have.update(step.known.unit.output_nodes)
    assert found.goal in found.units[-1].known.unit.output_nodes
    foon = {known.unit.key: known for known in units_at(snapshot.units, level)}
    assert [step.known for step in found.units] == [foon[step.known.unit.key] for step in found.units]
    report = check(tree_from_json(found.to_json()), KnownFoon.of(snapshot.units, snapshot.goals()))
    assert report.findings == ()


def story(*lines):
    return Snapshot.of([Subgraph("a", tuple(Annotation(unit(line)) for line in lines))], KITCHEN)


TWO_WAYS = story(
    "onion(whole); knife > chop > onion(chopped)",
    "onion(chopped) > mix > salad(mixed)",
    "onion(whole) > shake > onion(shaken)",
    "onion(shaken) > pour > onion(poured)",
    "onion(poured) > pour > salad(mixed)",
)


def test_the_shortest_way_is_not_always_the_likeliest():
    weights = MotionCosts({"chop": 0.9, "mix": 0.1, "shake": 0.1, "pour": 0.1})
    by_units = retrieve_tree(TWO_WAYS, GoalSought("salad"), KITCHEN, weights)
    by_success = retrieve_tree(TWO_WAYS, GoalSought("salad", by=Criterion.SUCCESS), KITCHEN, weights)
    assert [step.known.unit.motion for step in by_units.units] == ["chop", "mix"]
    assert [step.known.unit.motion for step in by_success.units] == ["shake", "pour", "pour"]
    assert float(by_units.success) == 0.09
    assert float(by_success.success) == 0.729


def test_of_trees_with_exactly_the_same_success_the_shorter_is_taken():
    weights = MotionCosts({"chop": 0.271, "mix": 0, "shake": 0.1, "pour": 0.1})  # 0.729 = 0.9 · 0.9 · 0.9
    found = retrieve_tree(TWO_WAYS, GoalSought("salad", by=Criterion.SUCCESS), KITCHEN, weights)
    assert [step.known.unit.motion for step in found.units] == ["chop", "mix"]


def test_what_never_succeeds_is_not_used_and_the_error_names_it():
    never = MotionCosts({"mix": 1, "pour": 1})
    with pytest.raises(NoWayError) as caught:
        retrieve_tree(TWO_WAYS, GoalSought("salad", by=Criterion.SUCCESS), KITCHEN, never)
    assert "a robot never succeeds to mix, pour" in caught.value.hint
    assert retrieve_tree(TWO_WAYS, GoalSought("salad"), KITCHEN, never).success == 0


def test_a_motion_without_a_weight_counts_half_and_is_named():
    found = retrieve_tree(TWO_WAYS, GoalSought("salad", by=Criterion.SUCCESS), KITCHEN, MotionCosts({"chop": 0.5}))
    assert (found.assumed, float(found.success)) == (("mix",), 0.25)


def test_success_needs_weights():
    with pytest.raises(UsageError, match="no weights"):
        retrieve_tree(TWO_WAYS, GoalSought("salad", by=Criterion.SUCCESS), KITCHEN, MotionCosts())


def test_a_shared_unit_counts_once():
    shared = story(
        "onion(whole) > chop > onion(chopped)",
        "onion(chopped) > fry > onion(fried)",
        "onion(chopped) > boil > onion(boiled)",
        "onion(fried); onion(boiled) > mix > salad(mixed)",
    )
    weights = MotionCosts(dict.fromkeys(("chop", "fry", "boil", "mix"), 0.5))
    found = retrieve_tree(shared, GoalSought("salad", by=Criterion.SUCCESS), KITCHEN, weights)
    assert (len(found.units), float(found.success)) == (4, 0.0625)


def test_what_is_missing_is_said_nearest_first():
    needs = story("unicorn(tamed); onion(whole) > mix > salad(mixed)", "unicorn(caught) > tame > unicorn(tamed)")
    with pytest.raises(NoWayError) as caught:
        retrieve_tree(needs, GoalSought("salad"), KITCHEN, MotionCosts())
    assert caught.value.missing == (node("unicorn(caught)"),)
    assert caught.value.exit_code == 3


def test_what_is_missing_is_what_the_nearest_of_all_trees_lacks():
    needs = story(
        "unicorn(tamed); dragon(fed) > mix > salad(mixed)",
        "onion(whole); unicorn(caught) > mix > salad(mixed)",
        "phoenix(old); griffin(old) > toss > salad(tossed)",
    )
    for by, weights in ((Criterion.UNITS, {}), (Criterion.SUCCESS, {"mix": 0.5, "toss": 0.1})):
        with pytest.raises(NoWayError) as caught:
            retrieve_tree(needs, GoalSought("salad", by=by), KITCHEN, MotionCosts(weights))
        assert caught.value.missing == (node("unicorn(caught)"),)
        assert caught.value.message == "nothing makes salad (mixed): missing unicorn (caught)"


class _OnionAlone(Kitchen):
    def has(self, node):
        return node.label == "onion"


def test_an_empty_bowl_is_missing_though_full_ones_are_emptied():
    needs = story("bowl(empty); onion(whole) > put > bowl{onion}", "bowl{onion} > pour > bowl(empty); salad(mixed)")
    onion_alone = _OnionAlone(**{field.name: getattr(KITCHEN, field.name) for field in fields(KITCHEN)})
    with pytest.raises(NoWayError) as caught:
        retrieve_tree(needs, GoalSought("salad"), onion_alone, MotionCosts())
    assert caught.value.missing == (node("bowl(empty)"),)


@pytest.mark.parametrize(
    ("level", "motions"), [(Level.OBJECTS, ["mix"]), (Level.STATES, ["fill", "mix"]), (Level.INGREDIENTS, None)]
)
def test_each_level_looks_at_more_of_an_object(level, motions):
    levels = story(
        "onion(whole); bowl(empty) > fill > bowl(full){onion}",
        "bowl(full){onion,egg} > mix > salad(mixed){onion,egg}",
    )
    found = answer(levels, GoalSought("salad", level=level), KITCHEN, MotionCosts())
    assert (found and [step.known.unit.motion for step in found.units]) == motions


def test_a_level_refuses_what_it_does_not_look_at():
    with pytest.raises(UsageError, match="at level 1 a FOON has no states and no place and no ingredients"):
        GoalSought("salad", ("mixed",), ("onion",), "bowl", level=Level.OBJECTS)
    with pytest.raises(UsageError, match="at level 2 a FOON has no ingredients"):
        GoalSought("salad", ("mixed",), ("onion",), level=Level.STATES)


def test_a_goal_that_is_not_there_is_told_from_one_in_other_states():
    with pytest.raises(NoTreeError, match="this FOON has no “salat”") as caught:
        retrieve_tree(TWO_WAYS, GoalSought("salat"), KITCHEN, MotionCosts())
    assert "Did you mean salad?" in caught.value.hint
    with pytest.raises(NoTreeError, match=r"no salad \(burnt\) in this FOON") as caught:
        retrieve_tree(TWO_WAYS, GoalSought("salad", ("burnt",)), KITCHEN, MotionCosts())
    assert "salad (mixed)" in caught.value.hint
