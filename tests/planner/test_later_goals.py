"""Dishes that nobody looked behind at first: a chunk at a time, where the likelier ones lead nowhere."""

from __future__ import annotations

import pytest
from kitchen_stories import subgraph
from planner.dishes import KITCHEN, SETTINGS

from foon_kg.errors import NoTreeError
from foon_kg.model import Recipe, RequiredIngredient
from foon_kg.planner import Planner
from foon_kg.question import FIRST_GOALS
from foon_kg.snapshot import Snapshot

WANTED = tuple(RequiredIngredient(*food) for food in (("salt", "granulated"), ("onion", "whole")))
CLOSED = "jar(sealed){relish}; relish(aged)@jar > open > salad(plated){onion,salt}@"
"""A salad out of a jar that nobody fills: nothing that was asked can get into it."""

MADE = (
    "bowl(empty); salt(granulated) > sprinkle > bowl{salt}",
    "bowl{salt}; spoon > mix* > bowl{salad}; salad(mixed){salt}@bowl",
)


class Counted:
    """A snapshot that counts how often somebody asks what is behind goals."""

    def __init__(self, snapshot):
        self.snapshot, self.asked = snapshot, []

    def __getattr__(self, name):
        return getattr(self.snapshot, name)

    def behind(self, nodes, foods=()):
        self.asked.append(len(nodes))
        return self.snapshot.behind(nodes, foods)


def planned(closed, *others):
    """The goal that is made, or the code of why none is; and of how many goals each question was."""
    videos = [subgraph(f"closed {n}", "salad", f"{CLOSED}cup_{n}") for n in range(closed)]
    snapshot = Snapshot.of([*videos, *others], KITCHEN)
    view = Counted(snapshot)
    answers = []
    for planner in (Planner(view, SETTINGS), Planner(snapshot, SETTINGS, snapshot.units)):
        try:
            answers.append(planner.plan(Recipe("salad", WANTED)).goal.container)
        except NoTreeError as error:
            answers.append(error.code)
    assert answers[0] == answers[1]
    return answers[0], view.asked


@pytest.mark.parametrize(
    ("closed", "asked"),
    [(0, [1]), (FIRST_GOALS - 1, [FIRST_GOALS]), (FIRST_GOALS, [3, 1]), (3 * FIRST_GOALS, [3, 6, 1])],
)
def test_as_many_dishes_are_looked_behind_as_it_takes(closed, asked):
    assert planned(closed, subgraph("made", "salad", *MADE)) == ("bowl", asked)


def test_where_no_dish_can_be_made_the_last_one_was_tried():
    assert planned(4) == ("left-out", [3, 1])
