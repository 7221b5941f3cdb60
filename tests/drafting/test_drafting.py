"""Narrated actions become units with the states of the FOON, linked through time, and every guess is doubted."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import exp

import pytest
from drafting.kitchen_foon import precedents
from examples import examples
from hypothesis import given
from hypothesis import strategies as st
from pictures.demo_plans import demo_foon

from foon_kg.language.drafting import draft
from foon_kg.language.drafting.calibration import ACTIONS, probability
from foon_kg.language.drafting.drafting import plain_name
from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.language.drafting.tables import read_draft, write_draft
from foon_kg.language.drafting.told_states import done, with_state
from foon_kg.language.drafting.verbs import Verbs
from foon_kg.language.reviewing import Review
from foon_kg.model import ObjectNode
from foon_kg.model.narration import Mention, NarratedAction, Narration, Place, Sentence
from foon_kg.plans.kitchen import Kitchen

FOON = precedents()


def action(verb, *objects, to=None, **fields):
    places = (Place("into", to),) if to else ()
    return NarratedAction(verb, tuple(map(Mention, objects)), places, said=f"{verb} {objects}", **fields)


def drafted(*actions, **wishes):
    return draft(Narration("video", tuple(actions)), FOON, **wishes)


def from_text(*actions):
    """Draft the actions as if they had been read in free text."""
    narration = Narration("video", tuple(actions), (Sentence("as it was said"),))
    return [row.annotation.unit for row in draft(narration, FOON).units]


def units(*actions):
    return [row.annotation.unit for row in drafted(*actions).units]


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


def test_an_instrument_that_is_a_food_is_done_something_to():
    (fill,) = units(action("pour", "bowl", instruments=("olive oil",)))
    assert "olive oil" in {node.label for node in fill.input_nodes}
    assert ObjectNode("bowl", (), ("olive oil",)) in fill.output_nodes
    (mix,) = units(action("mix", "onion", instruments=("olive oil",)))
    assert set(mix.output_nodes[-1].ingredients) == {"onion", "olive oil"}


def test_what_was_taken_out_of_something_comes_from_there():
    taken = NarratedAction("take", (Mention("onion"),), origin="cutting board", said="take onion from board")
    (put,) = units(taken, action("pick-and-place", "onion", to="pot"))
    assert "cutting board" in {node.container for node in put.input_nodes}


def test_a_held_thing_comes_from_what_was_open_where_nobody_says_from_where():
    told = (action("open", "drawer"), action("take", "knife"), action("close", "drawer"), action("take", "spoon"))
    put, unplaced = drafted(*told, action("put", "knife", to="plate"), action("put", "spoon")).rows[-2:]
    assert ObjectNode("knife", (), (), "in", "drawer") in put.annotation.unit.input_nodes
    assert any("nobody says from where the knife is taken: from the drawer" in doubt for doubt in put.doubts)
    assert unplaced.reason == "nobody says where spoon comes from or goes to: left out"


def test_what_is_put_back_comes_to_where_it_was():
    fridge = NarratedAction("take", (Mention("egg"),), origin="fridge", said="take egg from fridge")
    *_, back = units(fridge, action("put", "egg", to="bowl"), action("put-back", "egg"))
    assert "fridge" in {node.container for node in back.output_nodes}


def test_put_on_a_shelf_is_said_of_what_is_held():
    put = NarratedAction("put-on", (Mention("plate"),), said="put it on plate")
    (unit,) = units(action("take", "onion"), put)
    assert any(node.label == "onion" and node.container == "plate" for node in unit.output_nodes)


def test_fixtures_and_appliances_have_the_states_that_what_is_done_to_them_says():
    on, off, opened = units(action("turn on", "hob"), action("turn off", "hob"), action("open", "jar"))
    assert [node.states for node in (*on.input_nodes, *on.output_nodes)] == [("off",), ("on",)]
    assert {node.label for node in on.input_nodes} == {"stove"}, "the FOON calls a hob so"
    assert off.output_nodes[0].states == ("off",)
    assert [node.states for node in (*opened.input_nodes, *opened.output_nodes)] == [("closed",), ("opened",)]
    (tap,) = units(action("open", "tap"))
    assert (tap.motion, tap.output_nodes[0].states) == ("turn on", ("on",))


@pytest.mark.parametrize(
    ("name", "told", "used"),
    [("can", (), {"can opener"}), ("fridge", (), set()), ("packet", (), set()), ("packet", ("knife",), {"knife"})],
)
def test_no_tool_is_taken_over_from_another_utensil(name, told, used):
    """The demo opens cans alone."""
    demo = FoonPrecedents(demo_foon().units, Kitchen.default())
    narration = Narration("video", (action("open", name, instruments=told),))
    (row,) = draft(narration, demo).units
    assert {node.label for node in row.annotation.unit.input_nodes} == {name} | used


def test_nothing_is_opened_and_closed_at_once():
    assert with_state(("closed", "washed"), "opened") == ("washed", "opened")
    assert with_state(("chopped",), "peeled") == ("chopped", "peeled")
    for told in (("close", "jar"), ("open", "jar")), (("open", "egg"), ("close", "egg")):
        last = units(*(action(*one) for one in told))[-1].output_nodes[-1]
        assert len({"closed", "opened"} & set(last.states)) == 1


def test_what_nobody_names_is_what_is_seasoned():
    _, seasoned = from_text(action("pour", "potato", to="bowl"), action("season"))
    assert seasoned.motion == "season"
    assert any(node.label == "potato" and "seasoned" in node.states for node in seasoned.output_nodes)
    assert all(node.container != "pot" for node in seasoned.output_nodes)


def test_what_is_wiped_is_the_bowl_and_not_the_rag():
    (wipe,) = units(action("wash", "bowl", instruments=("rag",)))
    assert [node.label for node in wipe.output_nodes] == ["bowl"]


def test_what_is_wet_and_what_is_dry_are_the_mixtures_that_were_made_so():
    mixed = (action("mix", "flour", "sugar", to="bowl"), action("mix", "egg", "milk", to="jug"))
    *_, pour = from_text(*mixed, action("pour", "wet ingredients", to="dry ingredients"))
    (batter,) = [node for node in pour.output_nodes if node.container == "bowl"]
    assert set(batter.ingredients) == {"flour", "sugar", "egg", "milk"}


def test_a_kind_of_food_is_the_only_one_of_it():
    boil, drain = from_text(action("cook", "spaghetti", to="pot"), action("drain", "pasta"))[-2:]
    assert "spaghetti" in {node.label for node in boil.output_nodes}
    assert "spaghetti" in {node.label for node in drain.input_nodes}


def test_preheat_is_said_of_an_oven_and_baking_never_of_a_lid():
    assert from_text(action("preheat"))[0].output_nodes == (ObjectNode("oven", ("on",)),)
    cooked = from_text(action("pour", "potato", to="pot"), action("cook", "lid"))[-1]
    assert "potato" in {node.label for node in cooked.output_nodes}


def test_what_is_squeezed_into_a_food_is_in_it_afterwards():
    *_, squeeze, comes = from_text(action("mix", "egg", "flour", to="bowl"), action("squeeze", "lemon", to="mixture"))
    assert all(len(node.ingredients) == 0 for node in squeeze.output_nodes if node.label == "lemon")
    assert any("lemon" in node.ingredients and node.container == "bowl" for node in comes.output_nodes)


def test_nothing_is_washed_into_water_nor_folded_over_itself():
    under = NarratedAction("wash", (Mention("onion"),), (Place("under", "cold water"),), said="wash under water")
    over = NarratedAction("peel", (Mention("onion"),), (Place("over", "itself"),), said="peel it over itself")
    assert all(node.ingredients == () for one in (under, over) for unit in from_text(one) for node in unit.output_nodes)


def test_a_fixture_is_never_empty_for_what_leaves_it():
    fridge = NarratedAction("take", (Mention("egg"),), origin="fridge", said="take egg from fridge")
    (put,) = units(fridge, action("put", "egg", to="bowl"))
    assert all("empty" not in node.states for node in put.output_nodes if node.label == "fridge")


def test_a_thing_is_called_as_the_kitchen_calls_it():
    (unit,) = units(action("pour", "onion", to="dirty bowl"))
    assert ObjectNode("bowl", (), ("onion",)) in unit.output_nodes


def test_what_cooks_is_lit_once_and_a_bowl_stays_out_of_the_fire():
    pour, light, moved, cook = from_text(action("pour", "potato", to="bowl"), action("cook", "potato"))
    assert light.output_nodes == (ObjectNode("stove", ("on",)),)
    assert light.output_nodes[0] in cook.input_nodes
    assert "bowl" in {node.label for node in moved.input_nodes}
    assert {node.container for node in cook.input_nodes if node.label == "potato"} == {"pot"}
    assert pour.motion == "pour"


def test_what_nobody_names_is_what_is_at_hand():
    mix, stir = units(action("mix", "egg", "flour", to="bowl"), action("shake"))
    (mixture,) = [node for node in mix.output_nodes if node.ingredients and node.container]
    assert mixture in stir.input_nodes


def test_a_mixture_is_called_by_what_is_in_it():
    mixed = (action("mix", "egg", "flour", to="bowl"), action("mix", "onion", "salt", to="pot"))
    (_, _, pour) = units(*mixed, action("pour", "flour mixture", to="pan"))
    assert "egg mixture" in {node.label for node in pour.input_nodes}
    (_, _, pour) = units(*mixed, action("pour", "onion mixture", to="pan"))
    assert "onion mixture" in {node.label for node in pour.input_nodes}


def test_foods_that_come_together_for_the_first_time_get_a_bowl_of_their_own():
    first, second = units(action("mix", "egg", "flour"), action("mix", "onion", "salt"))
    bowls = [{node.label for node in unit.output_nodes if node.ingredients} for unit in (first, second)]
    assert bowls[0].isdisjoint(bowls[1])
    assert not any("egg" in node.ingredients for node in second.output_nodes)


def test_what_is_mixed_in_joins_what_is_at_hand():
    into = (Place("into", "it"),)
    _, mix = units(action("mix", "egg", "flour"), NarratedAction("mix", (Mention("salt"),), into))
    (mixture,) = [node for node in mix.output_nodes if node.container]
    assert set(mixture.ingredients) == {"egg", "flour", "salt"}


def test_another_bowl_is_another_one_and_the_bowl_the_same():
    egg = replace(action("mix", "egg", "flour"), places=(Place("in", "bowl"),))
    other = replace(action("mix", "onion", "salt"), places=(Place("in", "bowl"),), said="mix onion in another bowl")
    same = replace(other, said="mix onion in the bowl")
    assert not any("egg" in node.ingredients for node in units(egg, other)[1].output_nodes)
    assert any("egg" in node.ingredients for node in units(egg, same)[1].output_nodes)


def test_what_is_put_into_a_fridge_is_chilled_there():
    into = replace(action("pick-and-place", "it"), places=(Place("in", "fridge"),))
    _, chill = from_text(action("mix", "egg", "flour", to="bowl"), into)
    assert chill.motion == "refrigerate"
    assert {node.container for node in chill.output_nodes} <= {"bowl", None}


@pytest.mark.parametrize("name", ["egg mixture", "it", "dough", "the mixture", "everything"])
def test_no_mixture_is_made_of_itself(name):
    into = (Place("into", name),)
    made = units(action("mix", "egg", "flour"), NarratedAction("mix", (Mention("salt"),), into), action("mix", name))
    assert not [node for unit in made for node in unit.output_nodes if node.label in node.ingredients]


def test_what_remains_of_the_listed_ingredients_comes_where_it_is_asked():
    listed = tuple(map(Mention, ("egg", "flour", "salt")))
    mixes = (
        action("mix", "egg", to="bowl"),
        replace(action("mix", "remaining ingredients"), said="mix the remaining ones"),
    )
    narration = Narration("x", mixes, (Sentence("said"),), ingredients=listed)
    (mix,) = [row.annotation.unit for row in draft(narration, FOON).units if row.annotation.unit.motion == "mix"][-1:]
    assert {"flour", "salt"} <= {node.label for node in mix.input_nodes}


def test_a_food_onto_which_others_come_is_in_itself_and_not_listed_so():
    pour = replace(action("pour", "salt"), places=(Place("over", "potato"),))
    mix = action("mix", "potato", "egg")
    (poured, mixed) = from_text(action("peel", "potato"), pour, mix)[-2:]
    (potato,) = [node for node in poured.output_nodes if node.label == "potato"]
    assert potato.ingredients == ("salt",)
    (mixture,) = [node for node in mixed.output_nodes if "mixed" in node.states]
    assert set(mixture.ingredients) == {"egg", "potato", "salt"}


def test_all_of_it_is_what_is_at_hand():
    for name in ("all", "it"):
        mix, pour = from_text(action("mix", "egg", "flour", to="bowl"), action("pour", name, to="pot"))
        (mixture,) = [node for node in mix.output_nodes if "mixed" in node.states]
        assert mixture.label in {node.label for node in pour.input_nodes}
        assert name not in {node.label for node in pour.input_nodes}


def test_what_is_poured_over_and_is_not_there_yet_comes_onto_what_is_at_hand():
    over = NarratedAction("pour", (), (Place("over", "salt"),))
    mix, pour = from_text(action("mix", "egg", "flour", to="bowl"), over)
    (mixture,) = [node for node in mix.output_nodes if "mixed" in node.states]
    (after,) = [node for node in pour.output_nodes if node.label == mixture.label]
    assert set(after.ingredients) == {"egg", "flour", "salt"}


def test_no_food_is_brought_onto_a_dish_that_is_only_in_the_foon():
    labels = {node.label for unit in from_text(action("pour", "onion")) for node in unit.output_nodes}
    assert labels <= {"onion", "bowl", "cutting board"}


def test_what_is_laid_on_a_greased_tray_lies_on_the_tray():
    oil = replace(action("brush", "butter"), places=(Place("on", "baking tray"),))
    lay = replace(action("pick-and-place", "potato"), places=(Place("on", "it"),))
    (unit,) = from_text(oil, lay)[-1:]
    (potato,) = [node for node in unit.output_nodes if node.label == "potato"]
    assert potato.container == "baking tray"
