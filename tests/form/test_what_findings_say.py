"""What the judge says, to the word: which rule is broken, at which unit, about which node, and why."""

from __future__ import annotations

from dataclasses import replace

import pytest
from form.garden import (
    FOON,
    GARDEN,
    POTATO,
    entry,
    garden,
    garnished,
    judge,
    nodes,
    omelette,
    salad,
    unit,
    with_kitchen,
)
from kitchen_stories import node, subgraph
from kitchen_stories import unit as functional_unit

from foon_kg.form import TaskTree, check, repeatable
from foon_kg.form.report import Finding, Report
from foon_kg.model import Annotation, Subgraph
from foon_kg.model_json import node_to_json

RENAMED = "substitution 0, cucumber for radish (object)"
RESTATED = "substitution 1, cucumber: sliced for diced (state)"


def said(tree, rule):
    return [(f.unit, None if f.node is None else str(f.node), f.reason) for f in judge(tree).of([rule])]


@pytest.mark.parametrize(
    ("place", "change", "reason"),
    [
        (0, {"confidence": None}, f"{RENAMED}: it has no confidence between 0 and 1"),
        (0, {"kind": "thing"},
         "substitution 0, cucumber: cucumber for radish (thing): its kind is “thing”, not object, state, motion"),
        (0, {"kind": ""},
         "substitution 0, cucumber: cucumber for radish (no kind): its kind is “”, not object, state, motion"),
        (0, {"required": ""}, "substitution 0, nothing for radish (object): it does not say what is required"),
        (0, {"equivalent": "cucumber"},
         "substitution 0, cucumber for cucumber (object): the equivalent is what was required"),
        (1, {"object": ""}, "substitution 1, sliced for diced (state): it does not name its object"),
        (1, {"equivalent": None}, "substitution 1, cucumber: sliced for nothing (state): it names no equivalent"),
        (2, {"equivalent": ""}, "substitution 2, cucumber: slice for nothing (motion): it names no equivalent"),
        (1, {"alternatives": [{"name": "", "confidence": 0.5}]},
         f"{RESTATED}: an alternative has no name or no confidence"),
        (1, {"object": "tomato"}, "substitution 1, tomato: sliced for diced (state): no unit uses it"),
    ],
)  # fmt: skip
def test_an_entry_that_is_not_whole_is_told_with_its_place_and_what_it_is_about(place, change, reason):
    tree = salad()
    tree["substitutions"][place] |= change
    assert (None, None, reason) in said(tree, "C7"), said(tree, "C7")


def test_an_entry_without_a_list_of_alternatives():
    tree = salad()
    del tree["substitutions"][2]["alternatives"]
    assert said(tree, "C7") == [
        (None, None, "substitution 2, cucumber: slice for dice (motion): it has no list of alternatives")
    ]


def test_an_entry_that_is_there_twice():
    tree = salad()
    tree["substitutions"].append(tree["substitutions"][0])
    assert said(tree, "C7") == [(None, None, "substitution 3, cucumber for radish (object), is there twice")]


@pytest.mark.parametrize(
    ("place", "missing"),
    [
        (0, "cucumber for radish (object)"),
        (1, "cucumber: sliced for diced (state)"),
        (2, "cucumber: slice for dice (motion)"),
    ],
)
def test_a_difference_without_an_entry_is_told_where_it_is(place, missing):
    tree = salad()
    del tree["substitutions"][place]
    assert said(tree, "C7") == [(5, None, f"no substitution says “{missing}”")]


def test_an_origin_that_is_not_true():
    tree = salad()
    tree["units"][4]["origin"] = "foon"
    assert said(tree, "C7") == [(4, None, "its origin is “foon”, and it has something substituted")]


def test_sources_that_are_not_there():
    tree = salad()
    tree["units"][1]["seen_in"] = []
    tree["units"][2]["seen_in"][0]["unit"] = 60
    assert said(tree, "C8") == [
        (1, None, "it names no unit of the FOON"),
        (2, None, "the FOON has no unit 60 in “garden”"),
    ]


def test_a_unit_that_is_not_as_its_source_says_where_and_what():
    tree = salad()
    tree["units"][1]["input_nodes"] += nodes("fork")
    tree["kitchen"] += nodes("fork")
    assert said(tree, "C8") == [(1, "fork", "FOON's unit does not use it, and only foods are added")]


def test_a_whole_food_in_the_place_of_a_processed_one():
    tree = salad()
    tree["substitutions"].append(entry("state", "cucumber", "sliced", "whole"))
    assert said(tree, "C8") == [
        (None, None, "cucumber: sliced for whole (state): a whole or raw state never stands for a processed one")
    ]


def test_a_device_that_is_off_in_the_place_of_one_that_is_on():
    tree = salad()
    tree["substitutions"] += [entry("state", "stove", "off", "on"), entry("state", "stove", "on", "off")]
    assert said(tree, "C8") == [
        (None, None, "stove: off for on (state): what is off or cold never stands for what is on or hot")
    ]


def of_text(rule, *lines):
    """What is said of a tree that names no sources, as FOON text does not."""
    report = check(TaskTree.from_subgraph(subgraph("text", "salad", *lines)), FOON)
    return [(f.unit, None if f.node is None else str(f.node), f.reason) for f in report.of([rule])]


def test_of_a_tree_without_sources_the_nearest_unit_says_what_is_wrong():
    ((place, about, why),) = of_text("C8", GARDEN[0], GARDEN[1].replace("knife", "fork"), *GARDEN[2:])
    assert (place, about) == (1, "fork")
    assert why == (
        "no unit of the FOON explains it; the nearest does not because: "
        "FOON's unit does not use it, and only foods are added"
    )


def test_of_a_tree_without_sources_a_motion_that_nobody_knows():
    assert of_text("C8", GARDEN[0], GARDEN[1].replace("chop >", "zap >"), *GARDEN[2:]) == [
        (1, None, "the FOON has no unit with this motion and any of these outputs")
    ]


def test_the_goal_of_text_is_what_its_last_unit_marks():
    last = "stew(hot){olive oil}@in salad_bowl"
    (found,) = of_text("C2", *GARDEN[:5], GARDEN[5].split(" > mix > ")[0] + " > mix > spoon(wet); " + last)
    assert found == (5, "spoon (wet)", "“spoon” is no end product of any dish type in the FOON")


def test_only_the_last_unit_of_text_marks_the_goal():
    marked = subgraph("text", "salad", *GARDEN)
    assert TaskTree.from_subgraph(marked).goal == node(GARDEN[5].split(" > mix > ")[1].split(";")[0])
    earlier = Subgraph("text", (*marked.annotations, *subgraph("text", "salad", *GARDEN[:1]).annotations))
    assert TaskTree.from_subgraph(earlier).goal == node("cutting board{tomato}")
    plain = replace(marked, annotations=(*marked.annotations[:5], Annotation(functional_unit(GARDEN[5]))))
    assert TaskTree.from_subgraph(plain).goal is None


class TestTheContractOfExecution:
    def test_what_is_needed_before_it_is_made_and_what_is_never_there(self):
        tree = salad()
        tree["units"][:2] = tree["units"][1::-1]
        tree["kitchen"].remove(nodes("spoon")[0])
        assert said(tree, "C1") == [
            (0, "tomato (whole; on cutting board)", "it is needed before it is made: only unit 1 outputs it"),
            (6, "spoon", "it is neither in the kitchen nor an output of an earlier unit"),
        ]

    def test_a_unit_does_not_make_what_it_takes(self):
        tree = omelette()
        tree["units"][0]["input_nodes"] = nodes("stove(hot)", "stove(off)")
        tree["units"][0]["output_nodes"] = nodes("stove(on)")
        tree["units"][1]["input_nodes"] += nodes("stove(warm)")
        tree["units"][1]["output_nodes"] += nodes("stove(hot)")
        tree["kitchen"] += nodes("stove(off)")
        found = [row for row in said(tree, "C1") if row[1] in {"stove (hot)", "stove (warm)"}]
        assert found == [
            (0, "stove (hot)", "it is needed before it is made: only unit 1 outputs it"),
            (1, "stove (warm)", "it is neither in the kitchen nor an output of an earlier unit"),
        ]

    def test_what_is_wrong_with_the_goal(self):
        tree = salad() | {"recipe": salad()["recipe"] | {"dish_type": "soup"}}
        tree["goal"]["states"] = ["tossed"]
        made = "garden salad (tossed; {cucumber, olive oil, tomato}; in salad bowl)"
        assert said(tree, "C2") == [
            (6, made, "the last unit does not output the goal"),
            (6, made, "“garden salad” is no end product of the dish type soup in the FOON"),
        ]

    def test_there_is_no_tree(self):
        assert said(salad() | {"units": []}, "C2") == [(None, None, "the tree has no units")]
        failed = {"recipe": salad()["recipe"], "error": {"code": "no-goal", "message": "no salad", "hint": ""}}
        assert said(failed, "C2") == [(None, None, "there is no tree: no salad")]

    def test_units_that_lead_nowhere(self):
        tree = salad()
        tree["units"].insert(0, unit("spoon > polish > spoon", "idle", 0, "foon"))
        tree["units"].insert(1, unit("fork > polish > fork(clean)", "idle", 1, "foon"))
        tree["kitchen"] += nodes("fork")
        assert said(tree, "C3") == [
            (0, None, "all its outputs are among its inputs: it does nothing"),
            (0, None, "nothing that it makes leads to the goal"),
            (1, None, "nothing that it makes leads to the goal"),
        ]


class TestTheContractOfIngredients:
    def test_what_was_asked_and_is_nowhere(self):
        tree = salad()
        tree["recipe"]["ingredients"] += [{"object": "leek", "state": ""}, {"object": "tomato", "state": "canned"}]
        goal = "garden salad (mixed; {cucumber, olive oil, tomato}; in salad bowl)"
        assert said(tree, "C4") == [
            (None, None, "no node of the tree is leek, as required"),
            (None, goal, "leek is required and not among the ingredients of the goal"),
            (None, None, "no node of the tree is tomato in the state “canned”, as required"),
        ]

    def test_what_nobody_asked_for(self):
        tree = garden()
        tree["recipe"]["ingredients"].pop()
        vessel, salt = "shaker ({salt})", "salt (granulated; in shaker)"
        goal = "garden salad (mixed; {olive oil, salt, tomato}; in salad bowl)"
        assert said(tree, "C5") == [
            (4, vessel, "salt comes from the kitchen and nobody asked for it"),
            (4, salt, "salt comes from the kitchen and nobody asked for it"),
            (None, goal, "the goal names salt, which nobody asked for and the tree does not make"),
        ]

    def test_assumptions_that_are_no_leaves_or_have_no_reason(self):
        tree = salad()
        tree["assumptions"] = [{"node": nodes("leek")[0], "why": "none"}, {"node": nodes("knife")[0], "why": " "}]
        assert said(tree, "C6") == [
            (None, "leek", "it is assumed to be at hand and is no leaf of the tree"),
            (None, "knife", "it is assumed to be at hand and nothing says why"),
        ]

    def test_what_the_foon_can_make_is_not_assumed(self):
        tree = omelette()
        tree["units"] = tree["units"][4:]
        tree = with_kitchen(tree, *tree["units"])
        tree["assumptions"] = [{"node": nodes("egg(beaten)@in bowl")[0], "why": "nothing makes it"}]
        beaten = "it is assumed to be beaten, and FOON has a unit that makes it so"
        assert (None, "egg (beaten; in bowl)", beaten) in said(tree, "C6")


class TestSense:
    def test_what_was_moved_before(self):
        tree = salad()
        tree["units"].insert(3, unit(GARDEN[2], "garden", 2))
        assert (3, "tomato (chopped; on cutting board)", "unit 2 moved or changed it before") in said(tree, "S1")

    def test_a_food_that_is_taken_twice(self):
        tree = garden()
        tree["units"].insert(2, tree["units"][0])
        assert said(tree, "S4") == [(2, "tomato (whole)", "taken 2 times, asked 1 times")]

    def test_an_equivalent_that_is_too_unlike(self):
        tree = salad()
        tree["substitutions"][0]["confidence"] = 0.456
        assert said(tree, "S5") == [(None, None, "radish stands for cucumber with 0.46 only")]

    def test_a_food_in_the_name_that_is_not_in_the_dish(self):
        tree = omelette("potato_omelette")
        goal = "potato omelette (cooked; {black pepper, egg}; in cooking pan)"
        assert said(tree, "S6") == [(None, goal, "“potato omelette” names potato, which is not in it")]

    def test_a_food_that_joins_too_late(self):
        tree = garnished()
        tree["recipe"]["ingredients"].append({"object": "leek", "state": "whole"})
        tree["units"][5]["input_nodes"] += nodes("leek(whole)")
        tree["units"][5]["output_nodes"][0]["ingredients"].append("leek")
        assert said(tree, "S2") == [(5, None, "leek joins others after the last mixing or heating")]

    def test_a_food_that_joins_whole(self):
        tree = omelette()
        tree["recipe"]["ingredients"].append({"object": "potato", "state": "whole"})
        tree["units"][4]["input_nodes"] += nodes("potato(whole)")
        tree["units"][4]["output_nodes"][0]["ingredients"].append("potato")
        assert said(tree, "S3") == [(4, None, "potato joins others as a whole, and FOON has a unit that opens it")]

    @pytest.mark.parametrize(("place", "found"), [(4, []), (5, ["S3"])])
    def test_a_food_may_be_opened_just_before_it_joins(self, place, found):
        """The potato joins at unit 4, or 5 where it is sliced first; sliced by then or not before the next unit."""
        tree = omelette()
        tree["recipe"]["ingredients"].append({"object": "potato", "state": "whole"})
        joins = tree["units"][4]
        joins["input_nodes"] += nodes("potato(sliced)" if place == 4 else "potato(whole)")
        joins["output_nodes"][0]["ingredients"].append("potato")
        tree["units"].insert(place, unit(POTATO[0], "potato", 0))
        assert [f.rule for f in judge(tree).of(["S3"])] == found

    def test_a_state_that_was_destroyed(self):
        tree = garden()
        tree["recipe"]["ingredients"][0]["state"] = "sliced"
        assert said(tree, "S7") == [(None, None, "tomato was asked sliced and is not so where it joins the others")]

    def test_a_reference_of_which_little_is_left(self):
        tree = garden()
        for one in tree["units"][1:]:
            one["seen_in"][0]["video"] = "stale"
        tree["units"] = tree["units"][:5]
        assert said(tree, "S8") == []  # the stale video has these units, too, and ends in the same goal
        for one in tree["units"]:
            one["seen_in"][0]["video"] = "garnished"
        tree["units"][0]["seen_in"][0]["video"] = "garden"
        assert said(tree, "S8") == [(None, None, "only 17% of the units of “garden” are in the tree")]

    def test_a_reference_that_no_video_makes(self):
        tree = salad()
        tree["reference"]["goal"] = nodes("moon cake")[0]
        assert said(tree, "S8") == [(None, "moon cake", "no video of the FOON ends in the reference goal")]

    def test_a_tree_that_names_no_reference_is_not_asked_for_it(self):
        assert check(TaskTree.from_subgraph(subgraph("text", "salad", *GARDEN)), FOON).of(["S8"]) == ()


class TestRepeatable:
    @pytest.mark.parametrize(
        ("one", "other", "where"),
        [
            ({"a": [1, 2]}, {"a": [1, 3]}, "a[1]"),
            ({"a": [1, 2], "z": 1}, {"a": [1], "z": 2}, "the length of a"),
            ({"a": []}, {"a": {}}, "a"),
            ({"a": {}}, {"a": []}, "a"),
            ({"a": {"b": 1}}, {"a": {}}, "a.b"),
            ({"a": {"b": 1}}, {"a": {"b": "1"}}, "a.b"),
            ({"a": 1}, {}, "a"),
        ],
    )
    def test_the_first_difference_is_named(self, one, other, where):
        (finding,) = repeatable([one, one, other])
        assert str(finding) == f"C9: answer 2 differs from the first in {where}"


class TestReportAsJson:
    def test_every_field_is_there(self):
        egg = node("egg(whole)")
        found = Finding("C1", "no egg", 2, egg), Finding("S5", "too unlike")
        assert Report("breakfast", found, (("C9", "one answer"),), ("free: water",)).to_json() == {
            "name": "breakfast",
            "sound": False,
            "clean": False,
            "findings": [
                {"rule": "C1", "unit": 2, "node": node_to_json(egg), "reason": "no egg"},
                {"rule": "S5", "unit": None, "node": None, "reason": "too unlike"},
            ],
            "not_asked": [{"rule": "C9", "why": "one answer"}],
            "notes": ["free: water"],
        }

    def test_a_finding_in_one_line(self):
        assert str(Finding("C1", "no egg", 0, node("egg(whole)"))) == "C1 unit 0 egg (whole): no egg"
        assert str(Finding("S5", "too unlike")) == "S5: too unlike"
