"""Each sense measure: a tree that has it, and one that lacks it alone."""

from __future__ import annotations

import json

import pytest
from form.garden import (
    FOON,
    STALE,
    broken,
    entry,
    garden,
    garnished,
    judge,
    nodes,
    omelette,
    recipe,
    salad,
    unit,
    with_kitchen,
)
from kitchen_stories import subgraph

from foon_kg.form import KnownFoon, TaskTree, check
from foon_kg.kitchen import Kitchen
from foon_kg.snapshot import Snapshot


def joined(food, state="cube"):
    """The salad with one more food, put bare into the last mixing."""
    tree = salad()
    tree["recipe"]["ingredients"].append({"object": food, "state": state})
    tree["units"][6]["input_nodes"] += nodes(f"{food}({state})")
    for told in (tree["goal"], tree["units"][6]["output_nodes"][0]):
        told["ingredients"] = sorted([*told["ingredients"], food])
    return with_kitchen(tree, *tree["units"])


class TestS1Fresh:
    def test_a_bowl_as_it_was_before(self):
        tree = garden(STALE, "stale")
        report = judge(tree)
        assert report.broken == ("S1",)
        assert [(f.unit, str(f.node)) for f in report.findings] == [(5, "salad bowl ({tomato})")]
        assert report.sound
        assert not report.clean

    def test_a_food_that_was_moved_before(self):
        tree = salad()
        tree["units"][6]["input_nodes"] += nodes("tomato(chopped)@on cutting_board")
        assert "S1" in broken(with_kitchen(tree, *tree["units"]))

    def test_what_is_made_again_is_fresh_again(self):
        """The board with the tomato on it is emptied, and the cucumber comes onto the empty board."""
        assert "S1" not in broken(salad())

    def test_a_board_that_only_stood_by_is_as_it_was(self):
        tree = salad()
        tree["units"][1]["input_nodes"] += nodes("cutting board{tomato}")
        assert "S1" not in broken(with_kitchen(tree, *tree["units"]))

    @pytest.mark.parametrize(("place", "stale"), [("pan", False), ("cooking_pan", False), ("pot", True)])
    def test_a_cooking_pan_in_which_the_food_lies_on_is_as_it_was_though_foon_calls_it_a_pan(self, place, stale):
        lines = (
            f"cooking pan{{tomato}}; tomato(chopped)@in pan; spoon > stir > tomato(cooked)@in {place}; spoon",
            f"cooking pan{{tomato}}; tomato(cooked)@in {place}; plate > pour > tomato(cooked)@on plate",
        )
        units = [unit(line, "stew", number) for number, line in enumerate(lines)]
        tree = salad() | {"recipe": recipe("soup", "tomato cooked"), "goal": units[-1]["output_nodes"][0]}
        report = check(TaskTree.from_json(with_kitchen(tree, *units)), None)
        assert [(f.unit, f.node.label) for f in report.of({"S1"})] == ([(1, "cooking pan")] if stale else [])

    def test_storage_is_not_used_up(self):
        tree = salad()
        tree["units"][3]["output_nodes"] = nodes("salad bowl{olive oil,tomato}", "olive oil(liquid)@in salad_bowl")
        tree["units"][6]["input_nodes"] += nodes("bottle{olive oil}")
        assert "S1" not in broken(with_kitchen(tree, *tree["units"]))


class TestS2InTime:
    def test_a_garnish_that_foon_knows(self):
        assert broken(garnished()) == ()

    def late(self, food):
        tree = garnished()
        tree["recipe"]["ingredients"].append({"object": food, "state": "canned"})
        last = tree["units"][-1]
        last["input_nodes"] += nodes(f"{food}(canned)")
        for told in (tree["goal"], last["output_nodes"][0]):
            told["ingredients"] = sorted([*told["ingredients"], food])
        return with_kitchen(tree, *tree["units"])

    def test_a_food_after_the_last_mixing(self):
        report = judge(self.late("olive"))
        assert report.broken == ("S2",)
        assert [(f.unit, f.reason) for f in report.findings] == [
            (5, "olive joins others after the last mixing or heating")
        ]

    def test_a_free_food_may_come_late(self):
        tree = TaskTree.from_json(self.late("olive"))
        assert check(tree, FOON, Kitchen.default(["olive"])).broken == ()

    def test_an_equivalent_of_the_garnish(self):
        tree = garnished()
        text = json.dumps(tree["units"][-1]).replace("feta", "brie")
        tree["units"][-1] = json.loads(text) | {"origin": "substituted"}
        tree["goal"]["ingredients"] = ["brie", "olive oil", "tomato"]
        tree["recipe"]["ingredients"][2]["object"] = "brie"
        tree["substitutions"] = [entry("object", "brie", "brie", "feta")]
        assert broken(with_kitchen(tree, *tree["units"])) == ()

    def test_nothing_is_late_where_nothing_is_mixed(self):
        tree = garnished()
        tree = with_kitchen(tree, *tree["units"][:4])
        assert "S2" not in broken(tree)


class TestS3Opened:
    def test_a_whole_food_that_foon_can_cut(self):
        report = judge(joined("radish", "whole"))
        assert report.broken == ("S3",)
        assert "radish" in report.findings[0].reason

    def test_a_whole_food_that_foon_never_opens(self):
        assert broken(joined("caper", "whole")) == ()

    def test_a_food_that_is_not_asked_whole(self):
        assert broken(joined("radish", "frozen")) == ()

    def test_a_whole_food_that_is_cut_before(self):
        tree = salad()
        tree["recipe"]["ingredients"][0]["state"] = "whole"
        assert broken(tree) == ()

    def test_cut_after_it_joined_is_too_late(self):
        tree = joined("radish", "whole")
        cut = "radish(whole)@on cutting_board; knife > dice > radish(diced)@on cutting_board; knife"
        tree["units"].append(unit(cut, "radish", 1))
        assert "S3" in broken(tree)


class TestS4Thrifty:
    def twice(self):
        tree = salad()
        tree["units"][6]["input_nodes"] += nodes("olive oil(liquid)@in bottle")
        return tree

    def test_taken_twice_and_asked_once(self):
        report = judge(self.twice())
        assert report.broken == ("S4",)
        assert [(f.unit, f.reason) for f in report.findings] == [(6, "taken 2 times, asked 1 times")]

    def test_taken_twice_and_asked_twice(self):
        tree = self.twice()
        tree["recipe"]["ingredients"].append({"object": "olive oil", "state": ""})
        assert broken(tree) == ()

    def test_what_is_put_back_is_not_taken(self):
        tree = self.twice()
        tree["units"][3]["output_nodes"] += nodes("olive oil(liquid)@in bottle")
        assert "S4" not in broken(tree)

    def test_vessels_do_not_count(self):
        tree = salad()
        tree["units"][6]["input_nodes"] += nodes("bottle{olive oil}")
        assert "S4" not in broken(tree)


class TestS5Close:
    @pytest.mark.parametrize(("confidence", "rules"), [(0.49, ("S5",)), (0.5, ())])
    def test_an_equivalent_object_needs_half(self, confidence, rules):
        tree = salad()
        tree["substitutions"][0]["confidence"] = confidence
        assert broken(tree) == rules

    def test_states_and_motions_are_not_asked(self):
        tree = salad()
        tree["substitutions"][1]["confidence"] = 0.1
        tree["substitutions"][2]["confidence"] = 0.1
        assert broken(tree) == ()


class TestS6TrueName:
    def test_a_name_with_a_food_that_is_not_there(self):
        report = judge(omelette("potato_omelette"))
        assert report.broken == ("S6",)
        assert "names potato" in report.findings[0].reason

    def test_the_word_of_the_dish_type_is_no_food(self):
        assert broken(omelette()) == ()

    def test_a_food_under_a_longer_name_is_there(self):
        tree = omelette("potato_omelette")
        tree["goal"]["ingredients"] = ["black pepper", "egg", "red potato"]
        tree["units"][-1]["output_nodes"][0]["ingredients"] = ["black pepper", "egg", "red potato"]
        assert "S6" not in broken(tree)


class TestS7StateKept:
    def minced(self):
        tree = salad()
        mince = unit("cucumber(sliced)@on cutting_board; knife > mince > cucumber(minced)@on cutting_board; knife",
                     "radish", 2, "substituted")  # fmt: skip
        mix = tree["units"][6]
        mix["input_nodes"] = [n for n in mix["input_nodes"] if n["label"] != "cucumber"]
        mix["input_nodes"] += nodes("cucumber(minced)@on cutting_board")
        return with_kitchen(tree, *tree["units"][:6], mince, mix)

    def test_the_asked_state_is_destroyed_before_it_joins(self):
        report = judge(self.minced())
        assert report.broken == ("S7",)
        assert "cucumber was asked sliced" in report.findings[0].reason

    def test_the_state_that_joins_was_asked(self):
        tree = self.minced()
        tree["recipe"]["ingredients"][2]["state"] = "minced"
        assert "S7" not in broken(tree)

    def test_start_states_need_not_stay(self):
        tree = salad()
        tree["recipe"]["ingredients"][2]["state"] = "whole"
        assert "S7" not in broken(tree)


class TestS8Kept:
    def test_the_reference_is_thrown_away(self):
        tree = salad()
        tree["reference"]["goal"] = omelette()["reference"]["goal"]
        report = judge(tree)
        assert report.broken == ("S8",)
        assert "0% of the units of “omelette”" in report.findings[0].reason

    @pytest.mark.parametrize(("kept", "rules"), [(2, ("S8",)), (3, ())])
    def test_three_of_ten_units_are_enough(self, kept, rules):
        """The omelette has seven units: two are 29 %, three are 43 %."""
        tree = omelette()
        for place, one in enumerate(tree["units"]):
            if place >= kept:
                one["seen_in"][0]["video"] = "potato_omelette"
        assert [rule for rule in broken(tree) if rule == "S8"] == list(rules)

    @pytest.mark.parametrize(("kept", "rules"), [(2, ["S8"]), (3, [])])
    def test_thirty_percent_to_the_unit(self, kept, rules):
        lines = [f"fork > bend > fork(bent {number})" for number in range(9)] + ["fork > bend > cake"]
        foon = Snapshot.of([subgraph("ten", "cake", *lines)], Kitchen.default())
        units = [unit(line, "ten", place) for place, line in enumerate(lines[:kept])]
        tree = with_kitchen(salad(), *units)
        tree["reference"]["goal"] = nodes("cake")[0]
        found = broken(tree, KnownFoon.of(foon.units, foon.goals()))
        assert [rule for rule in found if rule == "S8"] == rules

    def test_a_reference_goal_that_no_video_makes(self):
        tree = salad()
        tree["reference"]["goal"] = nodes("moon cake")[0]
        assert broken(tree) == ("S8",)


def test_a_recipe_that_asks_for_nothing_breaks_no_sense():
    tree = salad() | {"recipe": recipe("salad")}
    assert not set(broken(tree)) & {"S1", "S2", "S3", "S4", "S7"}
