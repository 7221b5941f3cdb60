"""Each rule of the contract: a tree that keeps it, and the same tree spoilt in that rule alone."""

from __future__ import annotations

import pytest
from kitchen_stories import subgraph
from validation.garden import (
    FLUFFY,
    FOON,
    GARDEN,
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

from foon_kg.kitchen import Kitchen
from foon_kg.validation import KnownFoon, TaskTree, check, repeatable


def without(*places):
    """The FOON without some units of the omelettes."""
    return KnownFoon.of(
        [
            known
            for known in FOON.units
            if not any(s.position in places and "omelette" in s.video for s in known.seen_in)
        ],
        FOON.goals,
    )


@pytest.mark.parametrize(
    "tree", [salad(), omelette(), garden(), garnished()], ids=["salad", "omelette", "garden", "feta"]
)
def test_a_good_tree_is_sound_and_clean(tree):
    report = judge(tree)
    assert report.findings == ()
    assert report.sound
    assert report.clean
    assert [rule for rule, _ in report.not_asked] == ["C9"]


class TestC1Executable:
    def test_units_in_the_wrong_order(self):
        tree = salad()
        tree["units"][:2] = tree["units"][1::-1]
        report = judge(tree)
        assert report.broken == ("C1",)
        assert [(f.unit, str(f.node)) for f in report.findings] == [(0, "tomato (whole; on cutting board)")]
        assert "only unit 1 outputs it" in report.findings[0].reason

    def test_a_kitchen_that_lacks_something(self):
        tree = salad()
        tree["kitchen"].remove(nodes("knife")[0])
        assert broken(tree) == ("C1",)

    def test_a_similar_node_is_not_the_same(self):
        tree = omelette()
        tree["kitchen"][tree["kitchen"].index(nodes("egg(whole)")[0])] = nodes("egg(whole,fresh)")[0]
        assert broken(tree) == ("C1",)

    def test_a_unit_cannot_feed_itself(self):
        tree = omelette()
        tree["units"][0]["input_nodes"] = nodes("stove(on)", "stove(off)")
        tree["kitchen"] = nodes("stove(off)") + tree["kitchen"]
        assert "C1" in broken(tree)


class TestC2Goal:
    def test_the_last_unit_makes_something_else(self):
        tree = salad()
        tree["goal"]["states"] = ["tossed"]
        assert broken(tree) == ("C2",)

    def test_an_earlier_unit_makes_the_goal(self):
        tree = salad()
        tree["units"].append(unit("stove(off) > turn on > stove(on)", "omelette", 0, "foon"))
        tree["kitchen"] += nodes("stove(off)")
        assert "C2" in broken(tree)

    def test_no_end_product_of_the_asked_dish_type(self):
        assert broken(salad() | {"recipe": salad()["recipe"] | {"dish_type": "soup"}}) == ("C2",)

    def test_no_units(self):
        assert "C2" in broken(salad() | {"units": []})

    def test_a_failure_is_no_tree(self):
        report = judge({"recipe": salad()["recipe"], "error": {"code": "no-goal", "message": "no salad", "hint": ""}})
        assert report.broken == ("C2",)
        assert "no salad" in report.findings[0].reason


class TestC3Connected:
    def test_a_unit_twice(self):
        tree = omelette()
        tree["units"].insert(1, tree["units"][0])
        report = judge(tree)
        assert report.broken == ("C3",)
        assert [(f.unit, f.reason) for f in report.findings] == [(1, "it is the same as unit 0")]

    def test_a_unit_that_changes_nothing(self):
        tree = salad()
        tree["units"].insert(0, unit("spoon > polish > spoon", "idle", 0, "foon"))
        assert broken(tree) == ("C3",)

    def test_a_unit_that_leads_nowhere(self):
        tree = salad()
        tree["units"].insert(0, unit("fork > polish > fork(clean)", "idle", 1, "foon"))
        tree["kitchen"] += nodes("fork")
        report = judge(tree)
        assert report.broken == ("C3",)
        assert [f.unit for f in report.findings] == [0]

    def test_what_stays_as_it_was_is_no_link(self):
        """The radish goes nowhere, although the knife that cuts it serves the goal afterwards."""
        tree = garden()
        tree["recipe"] = recipe("salad", "tomato chopped", "olive oil liquid", "salt granulated")
        tree["units"][:0] = [
            unit("cutting board(empty); tomato(whole) > pick-and-place > "
                 "cutting board{tomato}; tomato(whole)@on cutting_board", "garden", 0),
            unit("tomato(whole)@on cutting_board; knife > dice > tomato(diced)@on cutting_board; knife", "radish", 1),
        ]  # fmt: skip
        findings = [f for f in judge(tree).findings if "leads to the goal" in f.reason]
        assert 1 in [f.unit for f in findings]


class TestC4Complete:
    def test_a_required_state_is_nowhere(self):
        tree = salad()
        tree["recipe"]["ingredients"].append({"object": "olive oil", "state": "canned"})
        assert broken(tree) == ("C4",)

    def test_the_goal_forgets_a_required_food(self):
        report = judge(omelette("forgetful_omelette"))
        assert report.broken == ("C4",)
        assert "black pepper is required and not among the ingredients of the goal" in report.findings[0].reason

    def test_the_same_food_in_two_states_counts_twice(self):
        tree = salad()
        tree["recipe"]["ingredients"].append({"object": "tomato", "state": "whole"})
        assert "C4" not in broken(tree)
        tree["recipe"]["ingredients"].append({"object": "tomato", "state": "canned"})
        assert "C4" in broken(tree)

    def test_no_state_asked_means_any(self):
        tree = salad()
        tree["recipe"]["ingredients"][0]["state"] = ""
        assert broken(tree) == ()

    def test_plurals_are_the_same_food(self):
        tree = salad()
        tree["recipe"]["ingredients"][0]["object"] = "tomatoes"
        assert broken(tree) == ()


class TestC5NothingElse:
    def test_a_food_nobody_asked_for(self):
        tree = salad()
        del tree["recipe"]["ingredients"][1]
        report = judge(tree)
        assert report.broken == ("C5",)
        assert {str(f.node) for f in report.findings} == {
            "bottle ({olive oil})",
            "olive oil (liquid; in bottle)",
            "garden salad (mixed; {cucumber, olive oil, tomato}; in salad bowl)",
        }

    def test_free_foods_are_let_in_and_told(self):
        tree = salad()
        del tree["recipe"]["ingredients"][1]
        report = check(TaskTree.from_json(tree), FOON, Kitchen.default(["olive oil"]))
        assert report.clean
        assert report.notes == ("free foods that nobody asked for: olive oil",)

    def test_asked_foods_are_not_told_as_free(self):
        assert check(TaskTree.from_json(salad()), FOON, Kitchen.default(["olive oil"])).notes == ()

    def test_the_goal_names_what_was_taken_out(self):
        tree = salad()
        for told in (tree["goal"], tree["units"][-1]["output_nodes"][0]):
            told["ingredients"] = ["cucumber", "olive oil", "salt", "tomato"]
        assert broken(tree) == ("C5", "C8")


class TestC6Kitchen:
    def beaten_eggs_at_hand(self):
        tree = omelette()
        return with_kitchen(tree, *tree["units"][:2], *tree["units"][4:])

    def test_a_processed_food_at_hand(self):
        report = judge(self.beaten_eggs_at_hand())
        assert report.broken == ("C6",)
        assert [str(f.node) for f in report.findings] == ["egg (beaten; in bowl)"]

    def test_an_honest_assumption(self):
        tree = self.beaten_eggs_at_hand()
        tree["assumptions"] = [{"node": nodes("egg(beaten)@in bowl")[0], "why": "nobody beats eggs here"}]
        assert broken(tree, without(2, 3)) == ()

    def test_an_assumption_although_foon_makes_it(self):
        tree = self.beaten_eggs_at_hand()
        tree["assumptions"] = [{"node": nodes("egg(beaten)@in bowl")[0], "why": "nobody beats eggs here"}]
        assert broken(tree) == ("C6",)

    def test_an_assumption_without_a_reason(self):
        tree = self.beaten_eggs_at_hand()
        tree["assumptions"] = [{"node": nodes("egg(beaten)@in bowl")[0], "why": " "}]
        assert broken(tree, without(2, 3)) == ("C6",)

    def test_an_assumption_about_no_leaf(self):
        tree = salad()
        tree["assumptions"] = [{"node": nodes("feta(cube)")[0], "why": "no cheese"}]
        assert broken(tree) == ("C6",)

    def test_a_hot_pan_that_foon_heats(self):
        tree = omelette()
        tree = with_kitchen(tree, tree["units"][0], *tree["units"][2:])
        report = judge(tree)
        assert report.broken == ("C6",)
        assert str(report.findings[0].node) == "cooking pan (hot; on stove)"
        assert broken(tree, without(1)) == ("C8",) or broken(tree, without(1)) == ()

    def test_a_food_of_the_kitchen_that_the_tree_makes(self):
        tree = omelette()
        tree["kitchen"] += nodes("egg(cracked)@in bowl")
        assert broken(tree) == ("C6",)

    def test_a_vessel_whose_food_is_not_beside_it(self):
        tree = omelette()
        tree["units"][4]["input_nodes"] = nodes("bowl{egg}", "cooking pan(hot)@on stove")
        tree = with_kitchen(tree, *tree["units"][:2], *tree["units"][4:])
        assert any(f.rule == "C6" and str(f.node) == "bowl ({egg})" for f in judge(tree).findings)

    def test_a_mixture_at_hand(self):
        tree = salad()
        tree["units"][6]["input_nodes"] += nodes("dressing(creamy){oil,vinegar}")
        tree = with_kitchen(tree, *tree["units"])
        assert any(f.rule == "C6" and f.node.label == "dressing" for f in judge(tree).findings)

    def test_a_used_utensil(self):
        tree = salad()
        tree["units"][1]["input_nodes"] = nodes("tomato(whole)@on cutting_board", "knife(greased)")
        tree = with_kitchen(tree, *tree["units"])
        assert any(f.rule == "C6" and f.node.label == "knife" for f in judge(tree).findings)


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


class TestTextOfAnyone:
    def test_without_a_recipe_the_rest_is_asked(self):
        report = check(TaskTree.from_subgraph(subgraph("mine", "salad", *GARDEN)), FOON)
        assert report.clean
        assert [rule for rule, _ in report.not_asked] == ["C4", "C5", "C9", "S2", "S3", "S4", "S5", "S7", "S8"]

    def test_a_recipe_can_be_given(self):
        asked = TaskTree.from_json(garden()).recipe
        report = check(TaskTree.from_subgraph(subgraph("mine", "salad", *GARDEN), asked), FOON)
        assert report.clean
        assert [rule for rule, _ in report.not_asked] == ["C9", "S5", "S8"]

    def test_an_unmarked_goal_is_what_the_last_unit_makes(self):
        assert check(TaskTree.from_subgraph(subgraph("mine", None, *GARDEN)), FOON).clean

    def test_a_utensil_that_comes_back_is_at_hand_and_a_food_is_not(self):
        lines = (GARDEN[2], *GARDEN[:2], *GARDEN[3:])
        report = check(TaskTree.from_subgraph(subgraph("mine", "salad", *lines)), FOON)
        assert {(f.rule, str(f.node)) for f in report.findings if f.rule == "C1"} == {
            ("C1", "cutting board ({tomato})"),
            ("C1", "tomato (chopped; on cutting board)"),
        }

    def test_a_unit_that_foon_does_not_know(self):
        lines = (*GARDEN[:3], GARDEN[3].replace(" pour ", " juggle "), *GARDEN[4:])
        assert check(TaskTree.from_subgraph(subgraph("mine", "salad", *lines)), FOON).broken == ("C8",)

    def test_without_a_foon_the_rest_is_asked(self):
        report = check(TaskTree.from_subgraph(subgraph("mine", "omelette", *FLUFFY)))
        assert report.clean
        assert dict(report.not_asked)["C8"] == "no FOON is known"
        assert dict(report.not_asked)["C6"] == "in part: no FOON is known"
