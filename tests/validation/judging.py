"""Trees in the notation of docs/contract.md, judged: what the tests of single rules have in common."""

from __future__ import annotations

from foon_kg.model import FunctionalUnit, Goal, KnownUnit, Participant, Sighting
from foon_kg.validation import KnownFoon, check
from foon_kg.validation.notation import read_tree, read_trees

ONE_TOMATO = "tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})"
"""A step with which nothing is wrong."""


def report(text, foon=None, **named):
    """What the judge says of the tree in ``text``; a FOON may be text too, which is read anew each time."""
    return check(read_tree(text), foon_of(foon) if isinstance(foon, str) else foon, **named)


def found(rule, text, foon=None, **named):
    """The findings of one rule, as a person reads them."""
    return [str(finding) for finding in report(text, foon, **named).of([rule])]


def foon_of(text):
    """The FOON whose videos are the trees in ``text``; the goal of each is a goal of its dish type."""
    units, goals = [], []
    for tree in read_trees(text):
        for place, unit in enumerate(tree.units):
            inputs, outputs = (tuple(map(Participant, side)) for side in (unit.input_nodes, unit.output_nodes))
            units.append(KnownUnit(FunctionalUnit(inputs, unit.motion, outputs), (Sighting(tree.name, place),)))
        if tree.goal is not None:
            goals.append(Goal(tree.goal, tree.recipe.dish_type, tree.goal.ingredients, (tree.name,)))
    return KnownFoon.of(units, goals)
