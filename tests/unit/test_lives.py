"""What several foods become part of goes on in a line of its own."""

from __future__ import annotations

from foon_kg.formats.views.lives import lives
from foon_kg.plans.progress import ProgressLine, ProgressStep


def step(motion, thing, *states):
    return ProgressStep(states, "in", "bowl", motion, thing)


MIXED = (step("bake", "batter", "mixed"), step("cool down", "cake", "baked"))
FLOUR = ProgressLine("flour", (step("pour", "flour"), step("mix", "flour"), *MIXED), "cake")
EGG = ProgressLine("egg", (step("crack", "egg"), step("mix", "egg"), *MIXED), "cake")
SUGAR = ProgressLine("sugar", (step("strew", "sugar"),), "cake")


def told(lines):
    return [(line.ingredient, [one.motion for one in line.steps], line.end_product) for line in lives(lines)]


def test_what_two_foods_become_is_told_once_after_them():
    assert told([FLOUR, EGG, SUGAR]) == [
        ("flour", ["pour", "mix"], "batter"),
        ("egg", ["crack", "mix"], "batter"),
        ("sugar", ["strew"], "cake"),
        ("batter", ["bake", "cool"], "cake"),
    ]


def test_a_food_alone_keeps_its_line_with_motions_as_they_are_said():
    assert told([FLOUR, SUGAR]) == [("flour", ["pour", "mix", "bake", "cool"], "cake"), ("sugar", ["strew"], "cake")]


def test_two_mixtures_of_one_name_have_numbers_and_what_they_become_is_told_once_too():
    end = (step("bake", "cake", "raw"),)
    first = [ProgressLine(food, (step("mix", food), step("add", "mixture", "wet"), *end), "cake") for food in "ab"]
    second = [ProgressLine(food, (step("mix", food), step("sift", "mixture", "dry"), *end), "cake") for food in "cd"]
    names = [(name, motions, end) for name, motions, end in told([*first, *second])]
    assert names[:4] == [(f, ["mix"], "mixture" if f in "ab" else "mixture 2") for f in "abcd"]
    assert names[4:] == [("mixture", ["add"], "cake"), ("mixture 2", ["sift"], "cake"), ("cake", ["bake"], "cake")]
