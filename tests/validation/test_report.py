"""What a report says: findings in words and as JSON, the verdicts of robot and cook, and which rules were asked."""

from __future__ import annotations

from dataclasses import FrozenInstanceError

import pytest
from validation.judging import ONE_TOMATO, report

from foon_kg.model import ObjectNode
from foon_kg.model.tree import TaskTree
from foon_kg.validation import FORM, RULES, TABLE, WORLD, Finding, Report, check, repeatable
from foon_kg.validation.notation import read_tree

TOMATO = ObjectNode("tomato", ("sliced",))
BOWL = ObjectNode("bowl", ("empty",))


def fatal(rule):
    return Finding(rule, "so it is")


def minor(rule):
    return Finding(rule, "so it is", minor=True)


def told(*findings):
    return Report("a tree", findings)


# --- a finding ---


@pytest.mark.parametrize(
    ("finding", "words"),
    [
        (Finding("W1", "it is gone"), "W1: it is gone"),
        (Finding("W1", "it is gone", 0), "W1 step 1: it is gone"),
        (Finding("W1", "it is gone", 3, (TOMATO,)), f"W1 step 4 {TOMATO}: it is gone"),
        (Finding("W1", "it is gone", None, (TOMATO, BOWL)), f"W1 {TOMATO}; {BOWL}: it is gone"),
        (Finding("K3", "late", 1, minor=True), "K3 (minor) step 2: late"),
    ],
)
def test_a_finding_reads_as_rule_level_step_nodes_and_reason(finding, words):
    assert str(finding) == words


def test_a_report_prints_its_verdict_and_every_finding_by_level():
    found = (Finding("W1", "it is gone", 2, minor=True), Finding("C3", "nobody makes it", 0))
    report = Report("salad", found, (("C9", "one tree"), ("C4", "no recipe"), ("C5", "no recipe")), ("water is free",))
    assert str(report).splitlines() == [
        "salad: accepted (robot yes, cook yes, form broken: C3)",
        "  fatal:",
        "    C3 step 1: nobody makes it",
        "  minor:",
        "    W1 step 3: it is gone",
        "  water is free",
        "  not asked: C4, C5 (no recipe)",
    ]
    assert str(Report("soup", (), played=False)) == "soup: no tree"


def test_a_finding_counts_its_step_from_0_in_json_and_names_its_level():
    assert Finding("W1", "it is gone", 0, (TOMATO,)).to_json() == {
        "rule": "W1",
        "level": "fatal",
        "unit": 0,
        "nodes": [{"label": "tomato", "states": ["sliced"], "ingredients": [], "relation": None, "container": None}],
        "reason": "it is gone",
    }
    assert minor("W1").to_json() == {
        "rule": "W1", "level": "minor", "unit": None, "nodes": [], "reason": "so it is",
    }  # fmt: skip


def test_findings_and_reports_do_not_change():
    with pytest.raises(FrozenInstanceError):
        fatal("W1").rule = "W2"
    with pytest.raises(FrozenInstanceError):
        told().name = "another"


# --- the verdict ---


def test_the_rules_are_those_of_form_world_and_table_in_order():
    assert (*FORM, *WORLD, *TABLE) == RULES
    assert tuple(f"C{number}" for number in range(1, 10)) == FORM
    assert tuple(f"W{number}" for number in range(1, 6)) == WORLD
    assert tuple(f"K{number}" for number in range(1, 8)) == TABLE


def test_a_tree_without_findings_is_accepted():
    assert (told().form, told().robot, told().cook, told().accepted) == (True, True, True, True)
    assert told().fatal == told().broken == ()


@pytest.mark.parametrize("rule", RULES)
def test_one_fatal_finding_is_refused_by_those_whom_the_rule_concerns(rule):
    one = told(fatal(rule))
    assert one.form is (rule not in FORM)
    assert one.robot is (rule not in {*WORLD, "K4"})
    assert one.cook is (rule not in TABLE)
    assert one.accepted is (rule in FORM)
    assert one.fatal == one.broken == (rule,)


@pytest.mark.parametrize("rule", RULES)
def test_one_minor_finding_refuses_nothing(rule):
    one = told(minor(rule))
    assert (one.form, one.robot, one.cook, one.accepted) == (True, True, True, True)
    assert one.fatal == ()
    assert one.broken == (rule,)


@pytest.mark.parametrize(("count", "accepts"), [(1, True), (2, True), (3, False), (4, False)])
@pytest.mark.parametrize("rule", [*TABLE, "W4", "W5"])
def test_a_cook_puts_up_with_two_minor_findings_that_a_cook_sees(rule, count, accepts):
    one = told(*[minor(rule)] * count)
    assert one.cook is accepts
    assert one.robot
    assert one.accepted is accepts


def test_minor_findings_of_different_rules_of_the_table_add_up():
    assert told(minor("K1"), minor("K7")).cook
    assert not told(minor("K1"), minor("K2"), minor("K7")).cook
    assert not told(minor("K1"), minor("W4"), minor("W5")).cook


@pytest.mark.parametrize("rule", ["W1", "W2", "W3", "C3"])
def test_a_cook_does_not_mind_minor_findings_of_what_only_a_robot_sees(rule):
    assert told(*[minor(rule)] * 5).cook
    assert told(minor("K2"), minor("K2"), *[minor(rule)] * 5).cook


def test_a_tree_that_was_not_played_is_accepted_by_nobody():
    one = Report("nothing", (), played=False)
    assert (one.form, one.robot, one.cook, one.accepted) == (False, False, False, False)
    assert Report("something", ()).played


def test_robot_and_cook_are_asked_apart():
    robot_only, cook_only = told(fatal("K1")), told(fatal("W1"))
    assert (robot_only.robot, robot_only.cook, robot_only.accepted) == (True, False, False)
    assert (cook_only.robot, cook_only.cook, cook_only.accepted) == (False, True, False)


def test_broken_rules_are_told_once_in_their_order():
    one = told(fatal("K1"), minor("C9"), fatal("W1"), minor("W1"), fatal("K1"), minor("W5"))
    assert one.fatal == ("W1", "K1")
    assert one.broken == ("C9", "W1", "W5", "K1")


def test_findings_of_some_rules_come_in_their_order():
    one = told(fatal("W1"), minor("K1"), minor("W1"))
    assert one.of(["W1"]) == (fatal("W1"), minor("W1"))
    assert one.of(iter(["K1", "W1"])) == one.findings
    assert one.of([]) == ()


def test_a_report_as_json_says_everything():
    one = Report("soup", (fatal("W1"),), (("C8", "no FOON is known"),), ("water was free",))
    assert one.to_json() == {
        "name": "soup",
        "accepted": False,
        "robot": False,
        "cook": True,
        "form": True,
        "findings": [fatal("W1").to_json()],
        "not_asked": [{"rule": "C8", "why": "no FOON is known"}],
        "notes": ["water was free"],
    }


# --- what is asked of a tree ---

SOME_FOON = f"name: one_tomato\n{ONE_TOMATO}"


def not_asked(text, foon=None):
    return dict(report(text, foon).not_asked)


def test_without_recipe_and_foon_the_rules_that_lack_them_are_named():
    assert not_asked(ONE_TOMATO) == {
        "C2": "in part: no FOON is known",
        "C4": "no recipe is known",
        "C5": "no recipe is known",
        "C6": "in part: no FOON is known",
        "C7": "in part: no FOON is known",
        "C8": "no FOON is known",
        "C9": "one answer alone cannot show whether it repeats",
        "K6": "no recipe is known",
    }
    assert [rule for rule, _ in report(ONE_TOMATO).not_asked] == ["C2", "C4", "C5", "C6", "C7", "C8", "C9", "K6"]


def test_with_a_recipe_and_a_foon_only_c9_is_not_asked():
    assert set(not_asked(f"dish: salad\nasked: tomato (sliced)\n{ONE_TOMATO}", SOME_FOON)) == {"C9"}


def test_a_reference_tree_is_asked_c1_c2_c3_and_c8_only():
    left = not_asked(f"level: 3\n{ONE_TOMATO}", SOME_FOON)
    assert {rule for rule, why in left.items() if why == "a reference tree keeps the paper's own terms"} == {
        "C4", "C5", "C6", "C7", *WORLD, *TABLE,
    }  # fmt: skip
    assert set(RULES) - set(left) == {"C1", "C2", "C3", "C8"}


def test_a_rule_that_is_not_asked_has_no_findings():
    stolen = "dish: salad\nasked: cucumber (sliced)\n" + ONE_TOMATO
    assert report(stolen).of(["C5"])
    assert not report(ONE_TOMATO).of(["C4", "C5", "K6"])
    assert not report(f"level: 3\n{stolen}", SOME_FOON).of(["C4", "C5", "K6"])


def test_a_reference_tree_is_compared_with_the_foon_of_its_level():
    bare = "tomato + plate + knife → SLICE → tomato + plate"
    assert not report(f"level: 1\n{bare}", SOME_FOON).of(["C8"])
    assert report(f"level: 2\n{bare}", SOME_FOON).of(["C8"])
    assert report(f"level: 3\n{bare}", SOME_FOON).of(["C8"])


def test_of_a_search_that_found_nothing_only_that_is_told():
    tree = TaskTree("nothing", (), error="no goal is near")
    one = check(tree)
    assert [str(finding) for finding in one.findings] == ["C2: there is no tree: no goal is near"]
    assert one.notes == ()
    assert dict(one.not_asked)["C9"]
    assert (one.played, one.robot, one.cook) == (False, False, False)
    assert report(ONE_TOMATO).played


def test_a_finding_that_two_rules_of_one_step_tell_alike_is_there_once():
    stolen = report("dish: salad\nasked: cucumber (sliced)\n" + ONE_TOMATO)
    assert len(set(stolen.findings)) == len(stolen.findings)


def test_findings_come_in_the_order_of_the_rules():
    rules = [finding.rule for finding in report("dish: omelette\nasked: cucumber (sliced)\n" + ONE_TOMATO).findings]
    assert rules == sorted(rules, key=RULES.index)
    assert {"C4", "C5", "K5", "K6"} <= set(rules)


POUR_WATER = (
    "water (liquid; in bottle) + salt (granulated; in shaker) + glass (empty) → POUR → drink ({water}; in glass)"
)


def test_free_foods_that_a_tree_used_are_noted():
    asked = f"dish: drinks\nasked: salt (granulated)\n{POUR_WATER}"
    assert report(asked).notes == ("free foods that nobody asked for: water",)
    free = frozenset({"water", "salt"})
    assert report(f"dish: drinks\nasked: lemon (juice)\n{POUR_WATER}", free=free).notes == (
        "free foods that nobody asked for: salt, water",
    )
    assert report(f"dish: drinks\nasked: water (liquid); salt (granulated)\n{POUR_WATER}").notes == ()


def test_the_report_carries_the_name_of_the_tree():
    assert check(read_tree(ONE_TOMATO, "my tree")).name == "my tree"
    assert check(TaskTree("no tree", (), error="none")).name == "no tree"


# --- several answers to one question ---


@pytest.mark.parametrize(
    ("one", "other", "where"),
    [
        ({"a": 1}, {"a": 2}, "a"),
        ({"a": 1}, {"a": 1, "b": 2}, "b"),
        ({"a": 1, "b": 2}, {"a": 1}, "b"),
        ({"a": {"b": [1, 2]}}, {"a": {"b": [1, 3]}}, "a.b[1]"),
        ({"a": {"b": [1, 2]}}, {"a": {"b": [1]}}, "the length of a.b"),
        ({"a": []}, {"a": [1]}, "the length of a"),
        ({"a": [{"b": 1}, {"b": 2}]}, {"a": [{"b": 1}, {"b": 3}]}, "a[1].b"),
        ({"a": [1, 2]}, {"a": [2, 1]}, "a[0]"),
        ({"a": {"b": 1}}, {"a": [1]}, "a"),
        ({"a": [1]}, {"a": {"b": 1}}, "a"),
        ({"a": None}, {"a": 0}, "a"),
        ({"b": 1, "a": 1}, {"b": 2, "a": 2}, "a"),
    ],
)
def test_c9_two_answers_differ_where_the_first_difference_is(one, other, where):
    assert [str(found) for found in repeatable([one, other])] == [f"C9: answer 1 differs from the first in {where}"]


def test_c9_equal_answers_have_no_finding_whatever_the_order_of_their_fields():
    assert repeatable([{"a": 1, "b": [2, {"c": 3}]}, {"b": [2, {"c": 3}], "a": 1}]) == ()
    assert repeatable([{"a": 1}]) == ()


def test_c9_every_answer_is_compared_with_the_first():
    told = [str(found) for found in repeatable([{"a": 1}, {"a": 1}, {"a": 2}, {"a": 2}])]
    assert told == ["C9: answer 2 differs from the first in a", "C9: answer 3 differs from the first in a"]
