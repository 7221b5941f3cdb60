"""What a dish is put together of: bread below and above, a dressing, a coating, layers."""

from __future__ import annotations

from dataclasses import replace

import pytest
from integration import videos
from integration.lines import joins_at, stage, told
from integration.school import planned
from integration.told import KITCHEN, snapshot_of

from foon_kg.food import tables
from foon_kg.integration.composing.coated import coated_alone, coated_apart
from foon_kg.integration.composing.folded import folded, is_folded
from foon_kg.integration.composing.glasses import garnished, stirred
from foon_kg.integration.composing.parts import baked_at_last
from foon_kg.integration.composing.pots import is_never_heated, unheated, unmixed
from foon_kg.integration.composing.poured_over import dressed_apart
from foon_kg.integration.composing.stacked import cooked_apart
from foon_kg.integration.making.serving import Serving
from foon_kg.integration.teaching.frames import Line
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings


def test_a_dressing_is_mixed_by_itself_and_comes_over_the_rest():
    line = Line((stage("mix", {"mix"}),))
    joins = joins_at(line, 0, "lettuce", "olive oil", "vinegar", "salt", "tomato")
    assert told(*dressed_apart(line, joins)) == [
        ("", {"lettuce", "tomato"}),
        ("mix", {"olive oil", "vinegar", "salt"}),
        ("mix", set()),
    ]


@pytest.mark.parametrize("foods", [("lettuce", "mayonnaise", "salt"), ("olive oil", "vinegar", "mustard")])
def test_one_thing_that_runs_is_no_dressing_and_a_dressing_has_none(foods):
    line = Line((stage("mix", {"mix"}),))
    joins = joins_at(line, 0, *foods)
    assert dressed_apart(line, joins) == (line, joins)


def test_what_is_boiled_for_a_salad_comes_to_it_by_itself():
    boiled = Line((stage("boil", {"heat", "liquid"}, vessel="pot", appliance="stove"),))
    line = Line((stage("mix", {"mix"}, adds=[boiled]),))
    joins = (*joins_at(boiled, 0, "egg"), *joins_at(line, 0, "lettuce"))
    assert told(*dressed_apart(line, joins)) == [("boil", set()), ("mix", {"egg", "lettuce"})]


def test_flesh_is_turned_in_what_is_wet_then_in_what_is_dry_and_fried():
    line = Line((stage("", (), vessel="plate"),))
    joins = joins_at(line, 0, "bun", "chicken breast", "flour", "egg", "oil", "lettuce")
    line, joins = coated_apart(line, joins)
    assert told(line, joins) == [
        ("mix", {"egg"}),
        ("dip", {"chicken breast"}),
        ("mix", {"flour"}),
        ("dip", set()),
        ("cook", {"oil"}),
        ("flip", set()),
        ("cook", set()),
        ("", {"bun", "lettuce"}),
    ]
    assert all("heat" in line.stages[0].adds[0].stages[number].does for number in (2, 4))


def test_flesh_in_crumbs_that_is_the_dish_is_baked_under_what_melts_on_it():
    line = Line((stage("mix", {"mix"}),))
    joins = joins_at(line, 0, "chicken breast", "flour", "egg", "breadcrumb", "mozzarella", "tomato sauce")
    line, joins = coated_alone(line, joins, tables())
    assert told(line, joins)[-1] == ("bake", {"mozzarella", "tomato sauce"})
    assert told(line, joins)[:4] == [
        ("dip", {"chicken breast", "flour"}), ("mix", {"egg"}), ("dip", set()), ("mix", {"breadcrumb"}),
    ]  # fmt: skip


def test_whole_portions_that_were_fried_are_not_stirred_with_their_sauce():
    line = Line((stage("cook and stir", {"heat", "mix"}, vessel="cooking pan", appliance="stove"),))
    joins = joins_at(line, 0, "sole fillet", "flour", "butter", "lemon juice")
    made, _ = coated_alone(line, joins, tables())
    assert [one.motion for one in made.stages] == ["cook", ""]


def test_nothing_is_coated_where_no_crumbs_are_or_something_else_has_to_be_cooked():
    line = Line((stage("mix", {"mix"}),))
    for foods in (("chicken breast", "flour", "egg"), ("chicken breast", "egg", "breadcrumb", "potato")):
        joins = joins_at(line, 0, *foods)
        assert coated_alone(line, joins, tables()) == (line, joins)


def test_what_is_shaped_of_a_mass_is_not_coated():
    line = Line((stage("shape", {"shape"}), stage("", (), vessel="plate")))
    joins = joins_at(line, 1, "ground beef", "flour", "egg")
    assert coated_apart(line, joins) == (line, joins)


def test_minced_flesh_is_not_coated_though_nothing_shapes_it():
    line = Line((stage("bake", {"heat", "dry"}),))
    joins = joins_at(line, 0, "ground beef", "egg", "breadcrumb")
    assert coated_alone(line, joins, tables(), baked=True) == (line, joins)
    assert coated_apart(line, joins) == (line, joins)


def test_flesh_in_one_piece_is_coated_though_its_video_shapes_patties():
    line = Line((stage("shape", {"shape"}), stage("", (), vessel="plate")))
    joins = joins_at(line, 1, "cod fillet", "flour", "egg", "breadcrumb")
    line, joins = coated_alone(line, joins, tables())
    assert ("cook", set()) in told(line, joins)


def test_foods_are_laid_on_dough_in_their_layers():
    line = Line((stage("bake", {"heat", "dry"}),))
    joins = joins_at(line, 0, "mozzarella", "tomato sauce", "pizza dough")
    layers = [replace(join, layer=layer) for join, layer in zip(joins, (2, 1, 0), strict=True)]
    assert [join.want.label for join in Serving.in_layers(layers)] == ["pizza dough", "tomato sauce", "mozzarella"]


def test_cooked_eggs_of_a_salad_are_cut_before_they_come_in():
    motions = [unit.motion for unit in planned("egg", "boiled").units]
    assert motions.index("boil") < motions.index("peel", motions.index("boil")) < len(motions)
    assert any({"sliced", "chopped"} & set(n.states) for u in planned("egg", "boiled").units for n in u.output_nodes)


def sandwich(title=""):
    snapshot = snapshot_of(videos.SANDWICH)
    foods = [("bread", "sliced"), ("cheese", "sliced"), ("tomato", "sliced"), ("butter", "creamy")]
    asked = tuple(RequiredIngredient(*food) for food in foods)
    planner = Planner(snapshot, PlanSettings(KITCHEN, time_limit=None), snapshot.units)
    return planner.plan(Recipe("sandwich", asked, "one", title))


def test_bread_lies_below_and_above():
    brought = [u for u in sandwich().units if any(n.label == "plate" for n in u.output_nodes)]
    foods = [{n.label for n in u.input_nodes} - {"plate", "cutting board", "knife"} for u in brought]
    assert "bread" in foods[0]
    assert "bread" in foods[-1]
    assert "butter" in foods[1]


def laid(*foods, title="burger"):
    line = Line((stage("", set(), vessel="plate"),))
    return told(*cooked_apart(line, joins_at(line, 0, *foods), frozenset(title.split()), tables(), grilled=False))


def test_a_mass_is_mixed_shaped_and_fried_and_what_is_fried_for_it_by_itself():
    found = laid("ground beef", "egg", "onion/chopped", "mushroom/sliced", "tomato/sliced", "bun", "olive oil")
    assert found == [
        ("mix", {"ground beef", "egg", "onion"}),
        ("shape", set()),
        ("cook", {"olive oil"}),
        ("flip", set()),
        ("cook", set()),
        ("cook and stir", {"mushroom"}),
        ("", {"bun", "tomato"}),
    ]


def test_flesh_in_one_piece_is_fried_whole():
    found = laid("chicken", "paprika", "mayonnaise", "bun")
    assert found == [("cook", {"chicken", "paprika"}), ("flip", set()), ("cook", set()), ("", {"bun", "mayonnaise"})]


def test_loose_meat_is_stirred_with_its_sauce():
    found = laid("ground beef", "ketchup", "lettuce", "bun", title="sandwich")
    assert found == [("cook and stir", {"ground beef", "ketchup"}), ("", {"bun", "lettuce"})]


def raw_soup():
    blend, heat = stage("blend", {"blend", "mix"}), stage("simmer", {"heat", "liquid"}, vessel="pot", appliance="stove")
    return Line((blend, heat, stage("", set())))


def test_a_soup_that_is_called_cold_is_not_heated():
    line = raw_soup()
    joins = (*joins_at(line, 0, "tomato"), *joins_at(line, 1, "olive oil"))
    dishes = tables().dishes_named("soup", "gazpacho")
    assert is_never_heated(dishes, joins, tables())
    assert told(*unheated(line, joins)) == [("blend", {"tomato", "olive oil"}), ("", set())]
    assert not is_never_heated(tables().dishes_named("soup"), joins, tables())
    assert not is_never_heated(dishes, joins_at(line, 0, "chicken"), tables())


def test_an_omelette_sets_over_what_fills_it_and_is_folded():
    line = Line((stage("cook", {"heat"}, vessel="frying pan", appliance="stove"),))
    joins = joins_at(line, 0, "egg", "milk", "butter", "mushroom", "cheese", "parsley")
    assert is_folded(joins, {"mushroom", "omelette"})
    assert told(*folded(joins)) == [
        ("cook and stir", {"butter", "mushroom"}),
        ("whisk", {"egg", "milk"}),
        ("cook", set()),
        ("cook", {"cheese"}),
        ("fold", set()),
        ("", {"parsley"}),
    ]
    assert not is_folded(joins, {"baked", "omelette"})
    assert not is_folded(joins, {"mushroom", "frittata"})
    assert not is_folded(joins_at(line, 0, "egg", "potato", "oil"), {"omelette"})


def test_slices_and_leaves_come_last_into_a_glass_unless_they_are_muddled():
    line = Line(
        (stage("mash", {"mash", "mix"}, vessel="highball glass"), stage("stir", {"mix"}, vessel="highball glass"))
    )
    joins = (*joins_at(line, 0, "lime/sliced", "mint"), *joins_at(line, 1, "gin", "tonic water"))
    assert told(*garnished(line, joins, frozenset({"gin", "tonic"}))) == [
        ("mash", set()),
        ("stir", {"gin", "tonic water"}),
        ("", {"lime", "mint"}),
    ]
    assert garnished(line, joins, frozenset({"mojito"})) == (line, joins)


def test_crumbs_come_on_what_is_baked_unless_they_bind_it():
    mixed = stage("stir", {"mix"})
    line = Line((mixed, stage("bake", {"heat", "dry"}, vessel="baking dish", appliance="oven")))
    joins = joins_at(line, 0, "macaroni", "cheddar", "breadcrumb")
    assert told(*baked_at_last(line, joins, "")) == [("stir", {"macaroni", "cheddar"}), ("bake", {"breadcrumb"})]
    bound = joins_at(line, 0, "macaroni", "egg", "breadcrumb")
    assert told(*baked_at_last(line, bound, "")) == [("stir", {"macaroni", "egg", "breadcrumb"}), ("bake", set())]


def test_what_is_mixed_cold_with_pasta_is_fried_in_turn():
    boiled = Line((stage("boil", {"heat", "liquid"}, vessel="pot", appliance="stove"),))
    mixed = stage("mix", {"mix"}, adds=[boiled, Line((stage("stir", {"mix"}),))])
    line = Line((mixed, stage("cook", {"heat"}, vessel="cooking pan", appliance="stove"), stage("", set())))
    joins = (*joins_at(boiled, 0, "linguine"), *joins_at(line, 0, "clam", "garlic"), *joins_at(line, 2, "parsley"))
    made, found = unmixed(line, joins)
    assert told(made, found) == [("boil", {"linguine"}), ("cook", {"clam", "garlic"}), ("", {"parsley"})]
    with_egg = (*joins, *joins_at(line, 0, "egg"))
    assert unmixed(line, with_egg) == (line, with_egg)


def test_what_is_only_poured_together_in_a_glass_is_stirred():
    line = Line((stage("", set()), stage("", set(), vessel="highball glass")))
    joins = joins_at(line, 0, "rum", "cola", "ice")
    assert told(*stirred(line, joins)) == [("stir", {"rum", "cola", "ice"})]
    mixes = Line((stage("stir", {"mix"}),))
    joins = joins_at(mixes, 0, "rum", "cola")
    assert stirred(mixes, joins) == (mixes, joins)


def test_flesh_that_is_asked_in_shreds_is_laid_on_bread_and_not_fried():
    assert laid("chicken breast/shredded", "salsa", "tortilla", title="taco") == [
        ("", {"chicken breast", "salsa", "tortilla"})
    ]


def test_what_is_called_a_wrap_is_closed_at_last():
    asked = tuple(RequiredIngredient(*food) for food in [("tortilla", ""), ("cheese", "sliced"), ("tomato", "sliced")])
    snapshot = snapshot_of(videos.SANDWICH, videos.ROLL)
    planner = Planner(snapshot, PlanSettings(KITCHEN, time_limit=None), snapshot.units)
    last = planner.plan(Recipe("sandwich", asked, "one", "tomato wrap")).units[-1]
    assert last.motion == "roll"
    assert any("rolled" in node.states for node in last.output_nodes)
    assert planner.plan(Recipe("sandwich", asked, "one", "tomato sandwich")).units[-1].motion != "roll"
