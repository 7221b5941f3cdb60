"""What a dish is put together of: bread below and above, a dressing, a coating, layers."""

from __future__ import annotations

from dataclasses import replace

import pytest
from integration import videos
from integration.school import SNAPSHOT, planned
from integration.told import KITCHEN, snapshot_of

from foon_kg.food import tables
from foon_kg.integration.composing.bodies import made_apart
from foon_kg.integration.composing.coated import coated_alone, coated_apart
from foon_kg.integration.composing.folded import folded, is_folded
from foon_kg.integration.composing.parts import baked_at_last
from foon_kg.integration.composing.pots import is_never_heated, unheated, unmixed
from foon_kg.integration.composing.poured_over import dressed_apart
from foon_kg.integration.composing.techniques import as_a_way_says
from foon_kg.integration.composing.warmed import garnished, stirred
from foon_kg.integration.joining.course import Course, Plan
from foon_kg.integration.joining.spots import Join, Spot
from foon_kg.integration.making.serving import Serving
from foon_kg.integration.preparing.understanding import wants_of
from foon_kg.integration.teaching.frames import Line, Stage
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings


def stage(motion, does, *, vessel="bowl", appliance="", adds=()):
    source = "heat" if appliance else ""
    return Stage(tuple(adds), motion, frozenset(does), (), vessel, "in", appliance, source, "", (), 0)


def joins_at(line, number, *foods):
    """Return these foods as they join one stage of a line."""
    asked = [RequiredIngredient(*food.split("/")) if "/" in food else RequiredIngredient(food, "") for food in foods]
    spot = Spot((number,), line.stages[number], ("mix", "never", False), False, line.stages[number + 1 :])
    return tuple(Join(want, spot, 0.5) for want in wants_of(asked, tables(), SNAPSHOT.methods().operators))


def told(line, joins):
    """Return what joins each stage of a line and of those beside it, in the order of execution."""
    course = Course(line, Plan("dish", "dish", joins))

    def walk(part):
        for one in part.stages:
            for add in one.adds:
                if isinstance(add, Line):
                    yield from walk(add)
            yield one.motion, {join.want.label for join in course.at.get(id(one), ())}

    return list(walk(line))


def by_way(line, joins, title, dishes=(), **asked):
    return as_a_way_says(line, joins, dishes, title.split(), tables(), **asked)


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


def test_what_is_mashed_is_only_mixed():
    line = Line((stage("cook", {"heat"}), stage("flip", {"turn"})))
    joins = joins_at(line, 0, "potato", "butter", "milk", "garlic")
    line, joins = by_way(line, joins, "mashed potato", tables().dishes_named("mashed potato"))
    assert told(line, joins) == [("mix", {"potato", "butter", "milk", "garlic"})]
    wants = {join.want.label: join.want for join in joins}
    assert (wants["potato"].then, wants["garlic"].cooked, wants["milk"].cooked) == ("mashed", True, False)


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


def test_a_hot_drink_is_heated_in_a_pot_and_has_its_foam_on_top():
    line = Line((stage("blend", {"blend", "mix"}),))
    joins = joins_at(line, 0, "milk", "cocoa powder", "whipped cream")
    assert told(*by_way(line, joins, "hot chocolate", when="warmed")) == [
        ("cook and stir", {"milk", "cocoa powder"}),
        ("", set()),
        ("", {"whipped cream"}),
    ]


def test_chocolate_melts_in_a_hot_drink_and_candy_lies_on_it():
    line = Line((stage("blend", {"blend", "mix"}),))
    joins = joins_at(line, 0, "milk", "dark chocolate", "marshmallow")
    assert told(*by_way(line, joins, "hot chocolate", when="warmed")) == [
        ("cook and stir", {"milk", "dark chocolate"}),
        ("", set()),
        ("", {"marshmallow"}),
    ]


@pytest.mark.parametrize("title", ["hot tea", "iced tea"])
def test_of_a_drink_with_ice_only_what_steeps_is_heated(title):
    line = Line((stage("stir", {"mix"}),))
    joins = joins_at(line, 0, "tea bag", "water", "sugar", "ice")
    assert told(*by_way(line, joins, title, when="warmed")) == [
        ("cook and stir", {"tea bag", "water"}),
        ("stir", {"sugar", "ice"}),
    ]


@pytest.mark.parametrize("title", ["iced coffee", "strawberry smoothie", "hot lemonade punch"])
def test_what_is_called_cold_is_not_heated(title):
    line = Line((stage("stir", {"mix"}),))
    joins = joins_at(line, 0, "milk", "sugar")
    assert by_way(line, joins, title, when="warmed") == (line, joins)


def laid(*foods, title="burger"):
    line = Line((stage("", set(), vessel="plate"),))
    return told(*made_apart(line, joins_at(line, 0, *foods), frozenset(title.split()), tables(), grilled=False))


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


def test_what_is_soft_is_smeared_on_slices_before_they_are_baked():
    line = Line((stage("bake", {"dry", "heat"}, vessel="baking tray", appliance="oven"),))
    joins = joins_at(line, 0, "baguette", "butter", "garlic", "parmesan")
    assert told(*by_way(line, joins, "garlic bread")) == [
        ("", {"baguette"}),
        ("mix", {"butter", "garlic"}),
        ("spread", set()),
        ("bake", {"parmesan"}),
    ]
    soaked = joins_at(line, 0, "bread", "butter", "egg", "milk")
    assert by_way(line, soaked, "garlic bread") == (line, soaked)


def portioned(*foods, title="", baked=False):
    line = Line((stage("cook and stir", {"heat", "mix"}, vessel="cooking pan", appliance="stove"),))
    return told(*by_way(line, joins_at(line, 0, *foods), title, when="flesh", baked=baked))


def test_flesh_in_portions_is_fried_on_both_sides_before_its_sauce_comes():
    assert portioned("salmon fillet", "olive oil", "salt", "garlic", "white wine", "parsley") == [
        ("cook", {"salmon fillet", "olive oil", "salt"}),
        ("flip", set()),
        ("simmer", {"garlic", "white wine"}),
        ("", {"parsley"}),
    ]


def test_what_is_called_baked_lies_in_a_dish_under_what_is_mixed_for_it():
    assert portioned("salmon fillet", "olive oil", "mustard", "parsley", baked=True) == [
        ("", {"salmon fillet"}),
        ("mix", {"olive oil", "mustard"}),
        ("", set()),
        ("bake", set()),
        ("", {"parsley"}),
    ]


@pytest.mark.parametrize(("food", "title"), [("salmon fillet/cubed", ""), ("salmon fillet", "fish curry")])
def test_flesh_in_pieces_is_cooked_as_its_video_does(food, title):
    assert portioned(food, "olive oil", title=title) == [("cook and stir", {"olive oil", food.partition("/")[0]})]


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


def test_what_is_called_roasted_is_tossed_and_baked():
    line = Line((stage("cook", {"heat"}, vessel="cooking pan", appliance="stove"),))
    joins = joins_at(line, 0, "broccoli", "olive oil", "parmesan", "parsley")
    assert told(*by_way(line, joins, "roasted broccoli")) == [
        ("mix", {"broccoli", "olive oil"}),
        ("bake", {"parmesan"}),
        ("", {"parsley"}),
    ]
    assert by_way(line, joins, "broccoli") == (line, joins)


def test_a_crust_lines_the_dish_and_what_is_raw_in_its_filling_is_fried_before():
    line = Line((stage("mix", {"mix"}),))
    joins = joins_at(line, 0, "pie crust", "bacon", "egg", "cream")
    line, joins = by_way(line, joins, "quiche")
    assert told(line, joins) == [
        ("", {"pie crust"}), ("mix", {"bacon", "egg", "cream"}), ("", set()), ("bake", set()),
    ]  # fmt: skip
    assert [join.want.label for join in joins if join.slot is not None and join.slot.cooked] == ["bacon"]


def test_a_crust_covers_what_was_cooked_in_a_liquid():
    line = Line((stage("mix", {"mix"}),))
    joins = joins_at(line, 0, "puff pastry", "chicken breast", "butter", "flour", "milk")
    line, joins = by_way(line, joins, "pot pie")
    assert [one.motion for one in line.stages] == ["", "", "bake"]
    assert told(line, joins)[0] == ("cook and stir", {"chicken breast", "butter", "flour", "milk"})


def test_what_is_not_called_so_has_no_crust():
    line = Line((stage("mix", {"mix"}),))
    joins = joins_at(line, 0, "puff pastry", "apple")
    assert by_way(line, joins, "strudel") == (line, joins)


@pytest.mark.parametrize("thin", ["beer", "sparkling water", "milk"])
def test_what_is_called_battered_is_turned_in_its_batter_and_what_goes_with_it_is_fried_by_itself(thin):
    line = Line((stage("cook", {"heat"}, vessel="cooking pan", appliance="stove"),))
    joins = joins_at(line, 0, "cod fillet", "flour", thin, "potato", "oil", "salt")
    line, joins = by_way(line, joins, "fish chip", when="dipped")
    assert told(line, joins) == [
        ("mix", {"flour", thin, "salt"}),
        ("dip", {"cod fillet"}),
        ("cook", {"oil"}),
        ("flip", set()),
        ("cook", set()),
        ("", {"potato"}),
    ]
    assert next(join.slot.cooked for join in joins if join.want.label == "potato") == ("cook",)


def test_bread_is_dipped_into_eggs_and_milk_and_syrup_comes_on_it():
    line = Line((stage("bake", {"heat", "dry"}, vessel="baking tray", appliance="oven"),))
    joins = joins_at(line, 0, "bread", "egg", "milk", "cinnamon", "butter", "maple syrup")
    found = told(*by_way(line, joins, "french toast", when="dipped"))
    assert found[0] == ("mix", {"egg", "milk", "cinnamon"})
    assert found[1] == ("dip", {"bread"})
    assert found[-1] == ("", {"maple syrup"})


def test_mash_covers_what_was_cooked_before():
    line = Line((stage("bake", {"heat", "dry"}, vessel="baking dish", appliance="oven"),))
    joins = joins_at(line, 0, "ground lamb", "potato/mashed", "carrot/diced", "beef broth")
    assert told(*by_way(line, joins, "shepherd pie")) == [
        ("cook and stir", {"ground lamb", "carrot", "beef broth"}),
        ("", set()),
        ("", {"potato"}),
        ("bake", set()),
    ]


@pytest.mark.parametrize(("crust", "pieces"), [("pie crust", 1), ("pie crusts", 2)])
def test_dough_that_is_asked_in_the_plural_lines_a_pie_and_covers_it(crust, pieces):
    line = Line((stage("bake", {"heat", "dry"}, vessel="baking dish", appliance="oven"),))
    _, joins = by_way(line, joins_at(line, 0, "apple/sliced", "sugar", crust), "apple pie")
    assert sum(join.want.label == crust for join in joins) == pieces
    assert len({join.want.number for join in joins}) == len(joins)


def test_what_is_called_baked_is_baked_whole_cut_open_and_topped():
    line = Line((stage("bake", {"heat", "dry"}, vessel="baking tray", appliance="oven"),))
    joins = joins_at(line, 0, "potato", "butter", "sour cream", "chive/chopped")
    made, found = by_way(line, joins, "baked potato")
    assert told(made, found) == [
        ("bake", {"potato"}), ("cut", set()), ("", {"butter", "sour cream", "chive"}),
    ]  # fmt: skip
    assert "cut" not in next(join.want.facts.owes for join in found if join.want.label == "potato")
    assert by_way(line, joins, "mashed potato") == (line, joins)
    assert by_way(line, joins_at(line, 0, "potato/sliced", "butter"), "baked potato")[0] is line
    assert by_way(line, joins_at(line, 0, "potato", "milk"), "baked potato")[0] is line


def test_what_is_called_twice_baked_is_mashed_in_between():
    line = Line((stage("bake", {"heat", "dry"}, vessel="baking tray", appliance="oven"),))
    joins = joins_at(line, 0, "potato", "milk", "butter", "cheddar/shredded")
    assert told(*by_way(line, joins, "twice baked potato")) == [
        ("bake", {"potato"}), ("peel", set()), ("mash", {"milk", "butter"}), ("bake", {"cheddar"}),
    ]  # fmt: skip


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
