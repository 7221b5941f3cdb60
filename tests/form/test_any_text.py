"""FOON text of anyone is judged by whatever of the contract can be asked of it."""

from __future__ import annotations

from form.garden import (
    FLUFFY,
    FOON,
    GARDEN,
    garden,
)
from kitchen_stories import subgraph

from foon_kg.form import TaskTree, check


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
