"""The rules C1 to C6 of the contract: a tree that keeps each, and the same tree spoilt in that rule alone."""

from __future__ import annotations

import pytest
from form.garden import (
    FOON,
    broken,
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

from foon_kg.form import KnownFoon, TaskTree, check
from foon_kg.kitchen import Kitchen


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
