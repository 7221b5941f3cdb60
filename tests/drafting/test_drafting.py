"""Narrated actions become units with the states of the FOON, linked through time, and every guess is doubted."""

from __future__ import annotations

from itertools import pairwise
from math import exp

import pytest
from drafting.told import FOON, action, drafted, units
from examples import examples
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.language.drafting.calibration import ACTIONS, probability
from foon_kg.language.drafting.drafting import plain_name
from foon_kg.language.drafting.told_states import done
from foon_kg.language.drafting.verbs import Verbs
from foon_kg.language.reviewing import Review
from foon_kg.loaders.draft_tables import read_draft, write_draft
from foon_kg.model import ObjectNode
from foon_kg.model.narration import Mention, NarratedAction, Place


def test_states_and_tools_are_those_of_the_foon():
    (unit,) = units(action("peel", "onion"))
    assert unit.input_nodes == (ObjectNode("onion", ("whole",)), ObjectNode("knife"))
    assert unit.output_nodes == (ObjectNode("onion", ("peeled",)),)


def test_what_was_peeled_is_what_is_chopped_and_what_goes_into_the_bowl():
    peel, chop, pour = units(action("peel", "onion"), action("chop", "onion"), action("pour", "it", to="bowl"))
    assert peel.output_nodes[0] in chop.input_nodes
    assert chop.output_nodes[-1] in pour.input_nodes
    assert ObjectNode("bowl", (), ("onion",)) in pour.output_nodes
    assert ObjectNode("onion", ("chopped",), (), "in", "bowl") in pour.output_nodes


def test_what_will_be_peeled_is_whole_while_it_is_only_moved():
    move, peel = units(action("pick-and-place", "potato", to="cutting board"), action("peel", "potato"))
    assert move.input_nodes[1].states == ("unpeeled",)
    assert peel.output_nodes[0].states == ("peeled",)


def test_the_bowl_that_got_salt_contains_it():
    pour, sprinkle = units(action("pour", "onion", to="bowl"), action("sprinkle", "salt"))
    assert ObjectNode("bowl", (), ("onion",)) in sprinkle.input_nodes
    assert ObjectNode("bowl", (), ("onion", "salt")) in sprinkle.output_nodes
    assert pour.output_nodes[0] == sprinkle.input_nodes[0]


def test_foods_that_are_mixed_become_a_mixture_that_can_be_spoken_of():
    mix, pour = units(action("mix", "egg", "flour", to="bowl"), action("pour", "mixture", to="pot"))
    mixture = ObjectNode("egg mixture", ("mixed",), ("egg", "flour"), "in", "bowl")
    assert mixture in mix.output_nodes
    assert mixture in pour.input_nodes


def test_a_mixture_that_the_narration_names_is_called_so_without_doubt():
    (row,) = drafted(action("mix", "egg", "flour", to="bowl", product="batter")).units
    assert "batter" in {node.label for node in row.annotation.unit.output_nodes}
    assert not any("nobody names" in doubt for doubt in row.doubts)


def test_a_food_that_nobody_brought_is_brought_by_an_assumed_unit():
    rows = drafted(action("peel", "potato"), NarratedAction("cook", (Mention("potato"),), (Place("in", "pot"),))).units
    assert [row.annotation.timing.assumed for row in rows] == [False, True, False]
    assert rows[1].doubts == ("nobody says how potato comes to the pot",)
    assert rows[1].annotation.unit.output_nodes[1] in rows[2].annotation.unit.input_nodes


def test_an_unseen_food_is_doubted_and_less_sure_than_a_seen_one():
    seen, unseen = drafted(action("peel", "potato")).units[0], drafted(action("peel", "jicama")).units[0]
    assert unseen.confidence < seen.confidence
    assert unseen.doubts[0].startswith("no unit of the FOON peels jicama")


def test_a_guess_stays_as_unsure_in_later_units():
    first, second = drafted(action("peel", "jicama"), action("chop", "jicama")).units
    assert second.confidence < first.confidence


@pytest.mark.parametrize(
    ("told", "reason", "settled"),
    [
        (action("do", "onion"), "“do” changes no object: left out", True),
        (action("zzqx", "onion"), "“zzqx” is no motion of the FOON: left out", False),
        (action("", "onion"), "there is no verb in it: left out", False),
        (action("peel"), "nobody says what “peel” is done to: left out", False),
        (action("open", "cupboard"), "“cupboard” belongs to the room", True),
        (action("take", "onion"), "onion is held until it is put somewhere: left out", True),
        (action("put", "knife"), "nobody says where knife comes from or goes to: left out", True),
        (action("peel", *(f"onion {number}" for number in range(10_000))), "10000 objects are no one action", False),
    ],
)
def test_what_gives_no_unit_is_left_out_with_its_reason_and_asked_about_where_that_matters(told, reason, settled):
    made = drafted(told)
    assert made.units == ()
    assert made.left_out[0].reason.startswith(reason)
    assert len(Review.of(write_draft(made), "video").decisions) == (not settled)


def test_verbs_are_read_by_their_words_their_stems_and_the_table():
    verbs = Verbs(("chop", "pick-and-place", "turn on"))
    assert verbs.reading("turn-on").motions == ("turn on",)
    assert verbs.reading("Chopping").motions == ("chop",)
    assert verbs.reading("put-down").motions == ("pick-and-place",)
    assert verbs.reading("chop").confidence > verbs.reading("chopping").confidence > verbs.reading("put").confidence
    assert verbs.reading("squeeze it out").motions == ("squeeze",), "the table of motions knows it, the FOON does not"
    assert not verbs.reading("ponder it").motions


def test_the_dish_is_what_is_made_last():
    made = drafted(action("mix", "egg", "flour", to="bowl"), dish_type="bread")
    (goal,) = [one for one in made.units[-1].annotation.unit.outputs if one.dish_type]
    assert (goal.dish_type, goal.node.label) == ("bread", "egg mixture")


@pytest.mark.parametrize(
    "name", ["[red] onion {x}", "<b>onion</b>", "onion'}) DETACH DELETE n //", "onion; *bowl", "=cmd()"]
)
def test_no_name_can_write_anything_else_into_a_table(name, tmp_path):
    made = drafted(action("chop", name, to=name))
    (tmp_path / "video.csv").write_text(write_draft(made))
    read = read_draft(tmp_path / "video.csv")
    assert read.subgraph == (made.subgraph() if made.units else None)
    assert not set(plain_name(name)) & set("[]{}();*<>=")


names = st.sampled_from(
    ("onion", "jicama", "it", "everything", "egg", "bowl", "red onion", "mixture", "oil in pan", "@")
)
told = st.builds(
    NarratedAction,
    st.sampled_from(("peel", "chop", "put", "mix", "stir", "cook", "turn on", "take", "sprinkle", "add", "wash")),
    st.lists(st.builds(Mention, names), max_size=3).map(tuple),
    st.lists(st.builds(Place, st.sampled_from(("in", "into", "on")), names), max_size=1).map(tuple),
    product=st.sampled_from((None, None, "dough")),
    said=st.text(max_size=5),
)


@pytest.mark.slow
@examples(30)
@given(st.lists(told, max_size=6))
def test_every_narration_gives_a_draft_that_is_read_back_whole_and_says_the_same_twice(actions):
    made = drafted(*actions)
    assert made == drafted(*actions)
    assert len(made.rows) >= len(actions)
    assert all(0 <= row.confidence <= 1 for row in made.units)
    for row in made.units:
        held = [node for node in row.annotation.unit.output_nodes if FOON.kitchen.is_utensil(node.label)]
        assert len({node.label for node in held}) == len(held)


@pytest.mark.parametrize("verb", ["mix", "stir"])
def test_a_board_that_two_foods_leave_at_once_is_there_once_and_empty(verb):
    brought = (action("put", "onion", to="cutting board"), action("put", "potato", to="cutting board"))
    unit = drafted(*brought, action(verb, "onion", "potato", to="bowl")).units[-1].annotation.unit
    boards = [
        [node for node in side if node.label == "cutting board"] for side in (unit.input_nodes, unit.output_nodes)
    ]
    assert [len(side) for side in boards] == [1, 1]
    assert set(boards[0][0].ingredients) == {"onion", "potato"}
    assert boards[1][0].ingredients == ()


def test_a_confidence_grows_with_what_speaks_for_it_and_is_less_for_what_was_parsed():
    steps = [step / 100 for step in range(101)]
    told, parsed = ([probability(step, parsed=way) for step in steps] for way in (False, True))
    assert all(0 < low <= high < 1 for low, high in pairwise(told))
    assert all(0 < low <= high < 1 for low, high in pairwise(parsed))
    assert parsed[-1] < told[-1]
    odds = exp(ACTIONS[1]) * 0.5 ** ACTIONS[0]
    assert told[50] == pytest.approx(odds / (1 + odds))


def test_what_a_verb_does_to_a_food_is_its_state_where_the_foon_does_not_say():
    twice = drafted(action("peel", "onion"), action("peel", "onion"))
    assert len(twice.units) == 1, "what is peeled can become no more so"
    assert twice.left_out[0].reason == "onion is peeled already: left out"
    (*_, cook) = drafted(NarratedAction("cook", (Mention("potato"),))).units
    assert "cooked" in next(node for node in cook.annotation.unit.output_nodes if node.label == "potato").states
    assert done("coat") == "coated"
    assert done("flip") == "flipped"
    assert done("slice") == "sliced"
    assert done("pour") is None


def test_foods_that_lie_in_one_vessel_are_changed_by_one_unit():
    brought = (action("pour", "onion", to="pot"), action("pour", "potato", to="pot"))
    (_, _, peel) = units(*brought, action("peel", "onion", "potato"))
    assert {node.label for node in peel.output_nodes if "peeled" in node.states} == {"onion", "potato"}
    apart = units(brought[0], action("peel", "onion", "potato"))
    assert [unit.motion for unit in apart] == ["pour", "peel", "peel"]


def test_the_goal_is_the_dish_and_not_what_is_poured_over_it_at_last():
    mix = action("mix", "egg", "flour", to="bowl", product="batter")
    found = drafted(mix, action("cook", "batter", to="pot"), action("sprinkle", "salt", to="pot"), dish_type="cake")
    goals = [
        (number, one.node.label)
        for number, row in enumerate(found.units)
        for one in row.annotation.unit.outputs
        if one.dish_type
    ]
    assert [label for _, label in goals] == ["batter"]
    assert goals[0][0] == len(found.units) - 2


def test_a_mixture_has_the_name_by_which_it_is_spoken_of_next():
    mix, pour = units(action("mix", "egg", "flour", to="bowl"), action("pour", "dough", to="pot"))
    (dough,) = [node for node in mix.output_nodes if node.label == "dough"]
    assert dough.ingredients == ("egg", "flour")
    assert dough in pour.input_nodes
    bought = units(action("pour", "dough", to="pot"), action("mix", "egg", "flour", to="bowl"))
    assert any(node.label == "egg mixture" for node in bought[1].output_nodes), "a dough was spoken of before"
