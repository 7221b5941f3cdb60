"""What a draft takes for granted in a kitchen: where things are, what is at hand, what nobody names."""

from __future__ import annotations

from dataclasses import replace

import pytest
from drafting.told import FOON, action, drafted, from_text, units
from pictures.demo_plans import demo_foon

from foon_kg.language.drafting import draft
from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.language.drafting.told_states import with_state
from foon_kg.model import ObjectNode
from foon_kg.model.narration import Mention, NarratedAction, Narration, Place, Sentence
from foon_kg.plans.kitchen import Kitchen


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
