"""The rules C7 to C9, what a tree says of its sources: a tree that keeps each, and one spoilt in that alone."""

from __future__ import annotations

import pytest
from form.garden import (
    broken,
    entry,
    garden,
    judge,
    nodes,
    omelette,
    salad,
    unit,
    with_kitchen,
)

from foon_kg.form import repeatable


class TestC7Honest:
    @pytest.mark.parametrize(
        ("place", "change", "said"),
        [
            (0, {"confidence": None}, "it has no confidence between 0 and 1"),
            (0, {"confidence": 1.5}, "it has no confidence between 0 and 1"),
            (0, {"confidence": -0.1}, "it has no confidence between 0 and 1"),
            (0, {"alternatives": [{"name": "", "confidence": 0.5}]}, "an alternative has no name or no confidence"),
            (
                0,
                {"alternatives": [{"name": "leek", "confidence": None}]},
                "an alternative has no name or no confidence",
            ),
            (0, {"object": ""}, "it does not name its object"),
            (1, {"object": ""}, "it does not name its object"),
            (1, {"object": "tomato"}, "no unit uses it"),
            (0, {"kind": "thing"}, "its kind is “thing”"),
            (0, {"required": ""}, "it does not say what is required"),
            (2, {"equivalent": ""}, "it names no equivalent"),
            (1, {"equivalent": None}, "it names no equivalent"),
        ],
    )
    def test_an_entry_that_is_not_whole(self, place, change, said):
        tree = salad()
        tree["substitutions"][place] |= change
        findings = [f for f in judge(tree).findings if f.rule.startswith("C")]
        assert {f.rule for f in findings} == {"C7"}
        assert any(said in f.reason and f"substitution {place}" in f.reason for f in findings)

    @pytest.mark.parametrize("confidence", [0, 1])
    def test_the_ends_of_the_scale_are_confidences(self, confidence):
        tree = salad()
        tree["substitutions"][1]["confidence"] = confidence
        assert broken(tree) == ()

    def test_a_state_entry_may_stand_for_no_state(self):
        tree = salad()
        tree["substitutions"][1]["equivalent"] = ""
        assert not any("names no equivalent" in f.reason for f in judge(tree).findings)

    def test_no_list_of_alternatives(self):
        tree = salad()
        del tree["substitutions"][0]["alternatives"]
        assert broken(tree) == ("C7",)

    def test_an_empty_list_of_alternatives_is_fine(self):
        tree = salad()
        tree["substitutions"][0]["alternatives"] = []
        assert broken(tree) == ()

    @pytest.mark.parametrize("place", [0, 1, 2], ids=["object", "state", "motion"])
    def test_a_difference_without_an_entry(self, place):
        tree = salad()
        del tree["substitutions"][place]
        report = judge(tree)
        assert report.broken == ("C7",)
        assert any("no substitution says" in f.reason for f in report.findings)

    def test_an_entry_that_no_unit_uses(self):
        tree = salad()
        tree["substitutions"].append(entry("object", "tomato", "tomato", "potato"))
        assert broken(tree) == ("C7",)

    def test_an_entry_twice(self):
        tree = salad()
        tree["substitutions"].append(tree["substitutions"][0])
        assert broken(tree) == ("C7",)

    def test_an_entry_that_replaces_a_thing_by_itself(self):
        tree = salad()
        tree["substitutions"].append(entry("object", "tomato", "tomato", "tomato"))
        assert broken(tree) == ("C7",)

    def test_a_substituted_unit_that_claims_to_be_foons_own(self):
        tree = salad()
        tree["units"][4]["origin"] = "foon"
        assert broken(tree) == ("C7",)


class TestC8Grounded:
    def test_a_unit_that_names_no_source(self):
        tree = salad()
        tree["units"][1]["seen_in"] = []
        assert broken(tree) == ("C8",)

    @pytest.mark.parametrize(("video", "place"), [("kitchen", 1), ("garden", 60)])
    def test_a_source_that_is_not_there(self, video, place):
        tree = salad()
        tree["units"][1]["seen_in"][0] |= {"video": video, "unit": place}
        assert broken(tree) == ("C8",)

    def test_a_source_where_something_else_happens(self):
        tree = salad()
        tree["units"][1]["seen_in"].append(tree["units"][2]["seen_in"][0])
        assert "C8" in broken(tree)

    def spoilt(self, place, side, old=None, new=None):
        tree = salad()
        if old:
            tree["units"][place][side].remove(nodes(old)[0])
        if new:
            tree["units"][place][side] += nodes(new)
        return [f for f in judge(with_kitchen(tree, *tree["units"])).findings if f.rule == "C8"]

    def test_a_tool_left_out(self):
        assert self.spoilt(1, "input_nodes", old="knife")

    def test_a_tool_added(self):
        assert self.spoilt(6, "input_nodes", new="fork")

    def test_a_food_added_where_no_more_may_enter(self):
        assert self.spoilt(1, "input_nodes", new="salt(granulated)@in shaker")

    def test_a_food_added_where_any_number_may_enter(self):
        assert not self.spoilt(3, "input_nodes", new="cucumber(whole)")

    def test_a_product_left_out(self):
        assert self.spoilt(2, "output_nodes", old="cutting board(empty)")

    def test_a_product_invented(self):
        assert self.spoilt(1, "output_nodes", new="sauce(liquid)")

    def test_an_ingredient_that_did_not_go_in(self):
        assert self.spoilt(3, "output_nodes", "salad bowl{olive oil,tomato}", "salad bowl{olive oil,tomato,feta}")

    def test_an_ingredient_that_gets_lost(self):
        assert self.spoilt(3, "output_nodes", "salad bowl{olive oil,tomato}", "salad bowl{olive oil}")

    def test_another_place_going_in(self):
        found = self.spoilt(1, "input_nodes", "tomato(whole)@on cutting_board", "tomato(whole)@in salad_bowl")
        assert found

    def test_another_place_coming_out(self):
        assert self.spoilt(1, "output_nodes", "tomato(chopped)@on cutting_board", "tomato(chopped)@in salad_bowl")

    def test_no_food_is_left(self):
        tree = salad()
        tree["units"][1] = unit("knife > chop > knife(clean)", "garden", 1)
        assert "C8" in broken(with_kitchen(tree, *tree["units"]))

    def test_a_whole_food_never_stands_for_a_processed_one(self):
        tree = salad()
        tree["substitutions"].append(entry("state", "cucumber", "sliced", "whole"))
        assert "C8" in broken(tree)

    def test_grinding_what_is_sold_ground(self):
        tree = omelette()
        tree["substitutions"].append(entry("state", "black pepper", "ground", "peppercorn"))
        assert "C8" not in broken(tree)

    def test_a_vessel_goes_with_the_food_it_brought(self):
        tree = garden()
        tree["units"] = [*tree["units"][:4], *salad()["units"][4:]]
        tree |= {name: salad()[name] for name in ("recipe", "goal", "substitutions")}
        assert broken(with_kitchen(tree, *tree["units"])) == ()


class TestC9Repeatable:
    def test_equal_answers(self):
        assert repeatable([salad(), dict(reversed(salad().items())), salad()]) == ()

    @pytest.mark.parametrize(
        ("spoil", "where"),
        [
            (lambda tree: tree["units"].reverse(), "units[0]"),
            (lambda tree: tree["kitchen"].pop(), "the length of kitchen"),
            (lambda tree: tree["substitutions"][0].update(confidence=0.81), "substitutions[0].confidence"),
            (lambda tree: tree.pop("assumptions"), "assumptions"),
        ],
    )
    def test_an_answer_that_differs(self, spoil, where):
        other = salad()
        spoil(other)
        (finding,) = repeatable([salad(), salad(), other])
        assert (finding.rule, "answer 2" in finding.reason, where in finding.reason) == ("C9", True, True)
