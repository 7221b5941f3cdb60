"""A plan in a terminal says the same with and without colour, wide and narrow."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console

from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.formats.views.tree import plan_view, tree_view
from foon_kg.formats.views.words import node_words, shown_inputs, shown_outputs
from foon_kg.model import ObjectNode, Recipe, RequiredIngredient, Sighting
from foon_kg.model.claims import Alternative, Assumption, Substitution
from foon_kg.model.tree import Step
from foon_kg.plans.progress import ProgressLine, ProgressStep
from foon_kg.plans.result import GoalPassedOver, PlanResult, ReferenceSummary

ESCAPE = re.compile(r"\x1b\[[0-9;]*m")

KOHLRABI = ObjectNode("kohlrabi", ("whole",))
GRATED = ObjectNode("kohlrabi", ("grated",), (), "in", "salad bowl")
BOWL = ObjectNode("salad bowl", ("empty",))
FULL_BOWL = ObjectNode("salad bowl", (), ("kohlrabi",))
GRATER = ObjectNode("grater")
SALAD = ObjectNode("salad", ("mixed",), ("kohlrabi",), "in", "salad bowl")
CREAM = ObjectNode("cream", ("whipped",))

PLAN = PlanResult(
    recipe=Recipe("salad", (RequiredIngredient("kohlrabi", "grated"),), title="Grated kohlrabi"),
    reference=ReferenceSummary(SALAD, 7, 0, exact=True, videos=("greens",)),
    goal=SALAD,
    units=(
        Step.of((KOHLRABI, GRATER, BOWL), "grate", (GRATED, FULL_BOWL), "adapted", (Sighting("carrot", 2),)),
        Step.of((FULL_BOWL, GRATED, CREAM), "toss", (SALAD, GRATER), "foon", (Sighting("greens", 5),)),
    ),
    kitchen=(KOHLRABI, GRATER, BOWL, CREAM),
    substitutions=(
        Substitution("object", "kohlrabi", "kohlrabi", "carrot", 0.534, (Alternative("celery", 0.2),)),
        Substitution("state", "kohlrabi", "grated", "shredded", 0.9),
    ),
    assumptions=(Assumption(CREAM, "nothing makes it"),),
    passed_over=(GoalPassedOver(BOWL, 0.75, "it has no core"),),
    progress_lines=(
        ProgressLine(
            "kohlrabi",
            (
                ProgressStep(("whole",), None, None, "grate", "kohlrabi"),
                ProgressStep(("grated",), "in", "salad bowl", "toss", "slaw"),
            ),
            "salad",
        ),
        ProgressLine("prune", (), None),
    ),
)


def printed(renderable, width=100, *, colour=False):
    console = Console(width=width, force_terminal=colour, color_system="standard" if colour else None, highlight=False)
    with console.capture() as capture:
        console.print(renderable)
    return capture.get()


def lines_of(renderable, width=100):
    return [line.rstrip() for line in printed(renderable, width).splitlines()]


def test_every_part_of_a_plan_is_there():
    lines = lines_of(plan_view(PLAN), width=139)
    assert lines[0] == "dish  Grated kohlrabi (salad)"
    like = (
        "like  salad (video greens): 7 steps, 0 of the 1 ingredients, proven: no shorter way, and none that takes more"
    )
    assert f"{like} of them" in lines
    assert "  0.53 ~kohlrabi is handled like carrot  or celery 0.20" in lines
    assert "  0.90 grated kohlrabi is made like shredded kohlrabi" in lines
    assert "  cream (whipped): nothing makes it" in lines
    assert "  0.75 salad bowl: it has no core" in lines
    assert "  ~kohlrabi (whole) · grater · salad bowl (empty) · cream (whipped)" in lines


def test_steps_are_sentences_in_which_unseen_foods_are_marked():
    lines = lines_of(plan_view(PLAN), width=139)
    place = lines.index("Steps")
    assert lines[place + 1] == "  1 Grate the ~kohlrabi into the salad bowl with the grater.  [like carrot]"
    assert lines[place + 2].startswith("  2 Toss the ~kohlrabi and cream in the salad bowl")
    assert "~ handled like another food: no video shows it so" in lines


def test_steps_say_what_goes_in_what_is_done_and_what_comes_out():
    lines = lines_of(tree_view(ShownTree.of_result(PLAN), as_units=True), width=139)
    place = lines.index("Steps")
    taken, made = "~kohlrabi (whole) + grater + salad bowl (empty)", "~kohlrabi (grated, in salad bowl)"
    assert lines[place + 1] == f"  1 {taken} → GRATE → {made}  [like carrot]"
    taken, made = f"{made} + cream (whipped)", "salad (mixed, with ~kohlrabi, in salad bowl) + grater"
    assert lines[place + 2] == f"  2 {taken} → TOSS → {made}"


def test_a_progress_line_names_what_the_food_has_become_part_of():
    lines = lines_of(plan_view(PLAN))
    place = lines.index("Progress of each ingredient")
    assert lines[place + 1 : place + 4] == [
        "  ~kohlrabi",
        "    whole → grate → slaw grated, in salad bowl → toss → salad",
        "  prune does not reach the dish",
    ]


@pytest.mark.parametrize("width", [40, 60, 80, 139, 140, 200])
def test_nothing_is_wider_than_the_terminal_and_no_word_is_lost(width):
    wide = printed(plan_view(PLAN), 400)
    narrow = printed(plan_view(PLAN), width)
    assert max(map(len, narrow.splitlines())) <= width
    assert Counter(narrow.split()) == Counter(wide.split())


def test_a_wide_terminal_has_the_kitchen_beside_the_steps_and_a_narrower_one_below():
    titles = [line.split() for line in lines_of(plan_view(PLAN), width=140)]
    assert ["Steps", "Kitchen"] in titles
    titles = [line.split() for line in lines_of(plan_view(PLAN), width=139)]
    assert titles.index(["Steps"]) < titles.index(["Kitchen"])


def test_colour_adds_nothing_but_colour():
    coloured = printed(plan_view(PLAN), colour=True)
    assert ESCAPE.sub("", coloured) == printed(plan_view(PLAN))
    assert "\x1b[32mgrated" in coloured
    assert "\x1b[1;31m→ grate →" in coloured
    assert "\x1b[34m~kohlrabi" in coloured


words = st.sampled_from(["onion", "cutting board", "[bold]", "bowl"])
nodes = st.builds(
    ObjectNode,
    words,
    st.lists(st.sampled_from(["empty", "chopped", "[red]"]), max_size=2).map(tuple),
    st.lists(words, max_size=2).map(tuple),
    st.none() | st.just("on"),
    st.none() | words,
)


@given(nodes)
def test_a_node_in_words_has_every_word_of_the_node(node):
    text = node_words(node).plain
    assert all(word in text for word in (node.label, *node.states, *node.ingredients, node.container or ""))


@given(st.lists(nodes, max_size=5))
def test_a_vessel_is_left_out_only_where_its_foods_say_that_they_are_in_it(some):
    for node in set(some) - set(shown_inputs(some)):
        assert node.ingredients
        assert all(any(o.label == name and o.container == node.label for o in some) for name in node.ingredients)


@given(st.lists(nodes, min_size=1, max_size=5))
def test_of_what_comes_out_something_is_always_shown_where_anything_is_left(some):
    assert bool(shown_outputs(some)) == bool(shown_inputs(some))


@pytest.mark.parametrize(("confidence", "alarmed"), [(0.09, True), (0.1, False), (0.0, True)])
def test_a_food_without_an_equivalent_has_a_mark_and_a_line(confidence, alarmed):
    [object_, *others] = PLAN.substitutions
    plan = replace(PLAN, substitutions=(replace(object_, confidence=confidence), *others))
    lines = lines_of(plan_view(plan), width=139)
    told = f"  {confidence:.2f} ! ~kohlrabi has no equivalent, and is handled like carrot for want of one"
    assert (told in lines) == alarmed
    assert any("~kohlrabi is handled like carrot" in line for line in lines) != alarmed
