"""What techniques make of a line: what is heated, baked, laid or folded by itself, as the title of a dish says."""

from __future__ import annotations

import pytest
from integration.lines import joins_at, stage, told

from foon_kg.food import tables
from foon_kg.integration.composing.techniques import as_a_way_says
from foon_kg.integration.teaching.frames import Line


def by_way(line, joins, title, dishes=(), **asked):
    return as_a_way_says(line, joins, dishes, title.split(), tables(), **asked)


def test_what_is_mashed_is_only_mixed():
    line = Line((stage("cook", {"heat"}), stage("flip", {"turn"})))
    joins = joins_at(line, 0, "potato", "butter", "milk", "garlic")
    line, joins = by_way(line, joins, "mashed potato", tables().dishes_named("mashed potato"))
    assert told(line, joins) == [("mix", {"potato", "butter", "milk", "garlic"})]
    wants = {join.want.label: join.want for join in joins}
    assert (wants["potato"].then, wants["garlic"].cooked, wants["milk"].cooked) == ("mashed", True, False)


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
