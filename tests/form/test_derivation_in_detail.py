"""What of a unit is which thing in the FOON's unit, and which entries that takes (C7, C8): the finer points."""

from __future__ import annotations

from dataclasses import replace

import pytest
from form.test_derivation import DICE, POUR, SLICED, derivation, entry, faults
from kitchen_stories import node, unit

from foon_kg.form.derivation import derive, may_explain
from foon_kg.form.tree import TreeUnit
from foon_kg.kitchen import Kitchen

CUCUMBER = entry("object", "cucumber", "cucumber", "radish")


def tree_unit(text):
    made = unit(text)
    return TreeUnit(made.input_nodes, made.motion, made.output_nodes)


def told(found):
    return [(e.kind, e.object, e.required, e.equivalent) for e in found.undeclared]


@pytest.mark.parametrize(
    ("mine", "source", "said", "about"),
    [
        ("onion@in pan; knife > chop > onion(chopped)", "onion@in bowl; knife > chop > onion(chopped)",
         "FOON has it in the bowl, and nothing but what stands there may enter here", "onion@in pan"),
        ("onion@in pan; knife > chop > onion(chopped)", "onion; knife > chop > onion(chopped)",
         "FOON has it in no place, and nothing but what stands there may enter here", "onion@in pan"),
        ("onion; knife > chop > onion(chopped)", "onion@in bowl; knife > chop > onion(chopped)",
         "FOON has it in the bowl, and nothing but what stands there may enter here", "onion"),
        ("onion@on bowl; knife > chop > onion(chopped)", "onion@in bowl; knife > chop > onion(chopped)",
         "FOON has it in the bowl, and nothing but what stands there may enter here", "onion@on bowl"),
        ("sugar; bowl(empty)@on table > pour > bowl{sugar}", "sugar; bowl(empty)@on stove > pour > bowl{sugar}",
         "FOON has it on the stove, and nothing but what stands there may enter here", "bowl(empty)@on table"),
        ("onion; knife; fork > chop > onion(chopped)", "onion; knife > chop > onion(chopped)",
         "FOON's unit does not use it, and only foods are added", "fork"),
        ("onion; fork > chop > onion(chopped)", "onion; knife > chop > onion(chopped)",
         "FOON's unit does not use it, and only foods are added", "fork"),
        ("onion; salt; knife > chop > onion(chopped)", "onion; knife > chop > onion(chopped)",
         "added to “chop”, where no more foods may enter", "salt"),
        ("onion; leek > chop > onion(chopped)", "onion; knife > chop > onion(chopped)",
         "added to “chop”, where no more foods may enter", "leek"),
        ("onion; knife > chop > onion(chopped)", "onion; knife; board > chop > onion(chopped)",
         "FOON's unit needs it and it is left out, though it serves what is still there", "board"),
        ("cup{sugar}@on table; bowl{egg} > pour > bowl{egg,sugar}",
         "cup{sugar}@on tray; bowl{egg} > pour > bowl{egg,sugar}",
         "FOON's unit needs it and it is left out, though it serves what is still there", "cup{sugar}@on tray"),
        ("onion; knife > chop > onion(chopped)@in pan", "onion; knife > chop > onion(chopped)@in bowl",
         "FOON's unit leaves it in the bowl", "onion(chopped)@in pan"),
        ("onion; knife > chop > onion(chopped); sauce", "onion; knife > chop > onion(chopped)",
         "FOON's unit does not make it", "sauce"),
        ("cup{tea}; tea@in cup; bowl > tip > bowl{tea}; tea@in bowl",
         "cup{tea}; tea@in cup; bowl > tip > bowl{tea}; tea@in bowl; cup(empty)",
         "FOON's unit makes it of what is still there, and it is left out", "cup(empty)"),
        ("flour; egg; bowl > mix > bowl{dough}", "flour; egg; bowl > mix > dough{egg,flour}@in bowl; bowl{dough}",
         "FOON's unit makes it of what is still there, and it is left out", "dough{egg,flour}@in bowl"),
        ("pan{oil}; onion > fry > pan{oil,onion,thyme}", "pan{oil}; onion > fry > pan{oil,onion}",
         "it holds thyme, which did not go in", "pan{oil,onion,thyme}"),
        ("pan{oil} > fry > pan(hot){oil,leek}", "pan{oil,leek} > fry > pan(hot){oil,leek}",
         "it still holds leek, which was taken out of what goes in", "pan(hot){leek,oil}"),
        ("onion; pan{oil} > fry > pan{oil}", "onion; pan{oil} > fry > pan{oil,onion}",
         "onion goes in and is not in it, as it is in FOON", "pan{oil}"),
    ],
)  # fmt: skip
def test_a_fault_says_what_is_wrong_and_with_which_node(mine, source, said, about):
    found = [(fault.reason, fault.node) for fault in derivation(mine, source).faults]
    assert (said, node(about)) in found, found


def test_a_unit_of_which_all_foods_are_gone_has_nothing_to_do():
    found = derivation("knife > chop > knife(wet)", "onion; knife > chop > onion(chopped); knife(wet)")
    assert ("all foods were taken out, so the unit has nothing to do", None) in [
        (fault.reason, fault.node) for fault in found.faults
    ]


def test_a_place_without_a_relation_is_told_as_at():
    source = unit("onion@in bowl; knife > chop > onion(chopped)")
    bare = replace(source.inputs[0], node=replace(source.inputs[0].node, relation=None))
    source = replace(source, inputs=(bare, *source.inputs[1:]))
    (fault,) = derive(tree_unit("onion; knife > chop > onion(chopped)"), source, (), Kitchen.default()).faults
    assert fault.reason.startswith("FOON has it at the bowl, ")


class TestWhichNodeIsWhich:
    def test_one_food_in_two_states_is_paired_state_by_state(self):
        mine = "onion(whole); onion(chopped); pan > push > onion(whole); pan{onion}"
        assert told(derivation(mine, mine.replace("push", "shove"))) == [("motion", "onion", "push", "shove")]

    def test_one_food_in_two_places_is_paired_place_by_place(self):
        mine = "egg@in bowl; egg@in pan; fork > push > egg(moved)@in bowl; egg(moved)@in pan; fork"
        found = derivation(mine, mine.replace("push", "shove"))
        assert (found.faults, told(found)) == ((), [("motion", "egg", "push", "shove")])

    def test_a_food_is_itself_before_it_stands_for_another(self):
        mine = "cucumber; radish; pan > push > pan{cucumber,radish}"
        found = derivation(mine, mine.replace("push", "shove"), CUCUMBER)
        assert (found.faults, found.used) == ((), frozenset())

    def test_where_any_number_may_enter_a_food_from_elsewhere_is_another(self):
        found = derivation("salt@in cup; cup{salt}; bowl{egg} > pour > bowl{egg,salt}", POUR)
        assert (found.faults, found.undeclared) == ((), ())

    def test_where_any_number_may_enter_a_food_in_another_state_is_another(self):
        pour = "salt(coarse); bowl{egg} > pour > bowl{egg,salt}"
        found = derivation(pour.replace("coarse", "fine"), pour)
        assert (found.faults, found.undeclared) == ((), ())

    def test_a_vessel_goes_whose_foods_are_all_gone(self):
        pour = "cup{sugar}; bowl{egg}; spoon > pour > bowl{egg,sugar}; spoon"
        found = derivation("oil; bowl{egg}; spoon > pour > bowl{egg,oil}; spoon", pour)
        assert (found.faults, found.undeclared) == ((), ())


class TestEntries:
    def test_an_entry_about_other_foods_renames_nothing(self):
        found = derivation(
            "tomato; knife > chop > tomato(chopped)", "onion; knife > chop > onion(chopped)",
            entry("object", "tomato", "tomato", "potato"),
        )  # fmt: skip
        assert (found.used, told(found)) == (frozenset(), [("object", "tomato", "tomato", "onion")])

    def test_only_the_entry_that_renames_is_used(self):
        found = derivation(
            SLICED.replace("slice", "dice"), DICE, CUCUMBER, entry("object", "leek", "leek", "onion"),
            entry("state", "cucumber", "dice", "peeled"),
        )  # fmt: skip
        assert (found.used, found.undeclared) == ({CUCUMBER}, ())

    def test_what_was_declared_counts_as_used_beside_what_is_missing(self):
        sliced = entry("state", "cucumber", "sliced", "diced")
        found = derivation(SLICED.replace("slice >", "dice >"), DICE, sliced)
        assert (found.used, told(found)) == ({sliced}, [("object", "cucumber", "cucumber", "radish")])

    def test_each_of_two_renamings_that_nobody_declared_is_named(self):
        stack = "radish@on board; onion; pan > push > pan{onion,radish}"
        found = derivation("cucumber@on board; leek; pan > push > pan{cucumber,leek}", stack)
        assert sorted(told(found)) == [
            ("object", "cucumber", "cucumber", "radish"),
            ("object", "leek", "leek", "onion"),
        ]

    def test_a_dish_and_a_food_in_it_may_both_be_renamed(self):
        leek, soup = entry("object", "leek", "leek", "onion"), entry("object", "leek soup", "leek soup", "onion soup")
        lift = "onion soup{onion}; ladle > lift > onion soup(warm){onion}; ladle"
        found = derivation(lift.replace("onion", "leek"), lift, leek, soup)
        assert (found.faults, found.used) == ((), {leek, soup})

    def test_a_food_that_only_went_uses_no_entry(self):
        cover = "bowl{carrot,onion} > cover > bowl(covered){carrot,onion}"
        found = derivation(cover.replace(",onion", ""), cover, entry("object", "leek", "leek", "onion"))
        assert found.used == frozenset()

    def test_a_state_that_both_have_uses_no_entry(self):
        push = "onion(diced,sliced); fork > push > onion(diced,sliced)@in pan; fork"
        found = derivation(push, push.replace("push", "shove"), entry("state", "onion", "sliced", "diced"))
        assert found.used == frozenset()

    def test_states_that_nobody_declared_are_named_together(self):
        found = derivation(
            "onion(peeled,washed); knife > chop > onion(chopped)", "onion(old,whole); knife > chop > onion(chopped)"
        )
        assert told(found) == [("state", "onion", "peeled, washed", "old, whole")]

    def test_an_entry_that_explains_one_of_two_states_is_used(self):
        sliced = entry("state", "onion", "sliced", "diced")
        found = derivation("onion(sliced,washed) > lift > onion(lifted)", "onion(diced) > lift > onion(lifted)", sliced)
        assert (found.used, told(found)) == ({sliced}, [("state", "onion", "sliced, washed", "diced")])

    def test_a_vessel_that_was_never_full_is_not_emptied(self):
        found = derivation("bowl(empty); whisk > lift > whisk(wet)", "bowl; whisk > lift > whisk(wet)")
        assert told(found) == [("state", "bowl", "empty", "")]

    def test_another_motion_with_tools_alone_is_about_no_food(self):
        found = derivation("spoon > wipe > spoon(clean)", "spoon > polish > spoon(clean)")
        assert told(found) == [("motion", "", "wipe", "polish")]


class TestMayExplain:
    @pytest.mark.parametrize(
        ("kind", "food", "required", "equivalent", "may"),
        [
            ("object", "cucumber", "cucumber", "radish", True),
            ("object", "tray", "tray", "board", True),
            ("object", "cucumber", "cucumber", "leek", False),
            ("state", "cucumber", "sliced", "diced", True),
            ("state", "leek", "sliced", "diced", False),
            ("motion", "cucumber", "slice", "dice", True),
            ("place", "cucumber", "slice", "dice", False),
        ],
    )
    def test_an_entry_is_about_the_names_of_the_two_units(self, kind, food, required, equivalent, may):
        assert may_explain(entry(kind, food, required, equivalent), tree_unit(SLICED), unit(DICE)) is may

    def test_no_entry_of_a_motion_explains_the_same_motion(self):
        asked = entry("motion", "cucumber", "dice", "slice")
        assert not may_explain(asked, tree_unit(SLICED.replace("> slice >", "> dice >")), unit(DICE))

    def test_a_food_inside_is_named_too(self):
        source = unit("bowl{radish} > cover > bowl(covered){radish}")
        assert may_explain(CUCUMBER, tree_unit("bowl{cucumber} > cover > bowl(covered){cucumber}"), source)


def test_the_same_things_with_another_motion_are_not_the_same_unit():
    assert faults(SLICED, SLICED) == []
    assert told(derivation(SLICED, SLICED.replace("> slice >", "> hack >"))) == [
        ("motion", "cucumber", "slice", "hack")
    ]
