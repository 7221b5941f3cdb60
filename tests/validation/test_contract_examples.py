"""docs/contract.md: every rule has an example that keeps it and one that breaks it, and the judge says the same."""

from __future__ import annotations

import json
import re
import tomllib
from dataclasses import asdict
from importlib import resources
from pathlib import Path

import pytest

from foon_kg.food import Level, tables
from foon_kg.food.tables import FOODS_VARIABLE, UTENSILS_VARIABLE
from foon_kg.model import FunctionalUnit, Goal, KnownUnit, Participant, Sighting
from foon_kg.model.errors import UsageError
from foon_kg.validation import FORM, RULES, KnownFoon, Report, check, repeatable
from foon_kg.validation.contract import example_foon, rule, rules
from foon_kg.validation.notation import read_tree, read_trees, remarks

DOCUMENT = Path(__file__).parents[2] / "docs" / "contract.md"

COMPARED_WITH_A_FOON = {"C2", "C6", "C7", "C8"}


def every_rule():
    """One case a rule."""
    return [pytest.param(one, id=one.id) for one in rules()]


def known_foon():
    """The FOON that the document shows."""
    units, goals = [], []
    for tree in read_trees(example_foon()):
        for place, unit in enumerate(tree.units):
            inputs, outputs = (tuple(map(Participant, side)) for side in (unit.input_nodes, unit.output_nodes))
            units.append(KnownUnit(FunctionalUnit(inputs, unit.motion, outputs), (Sighting(tree.name, place),)))
        goals.append(Goal(tree.goal, tree.recipe.dish_type, tree.goal.ingredients, (tree.name,)))
    return KnownFoon.of(units, goals)


def judged(one, text):
    """What the judge says of an example; of several answers only whether they repeat."""
    trees = read_trees(text, one.id)
    if one.id == "C9":
        return Report("C9", repeatable([json.loads(json.dumps(asdict(tree), default=sorted)) for tree in trees]))
    (tree,) = trees
    return check(tree, known_foon() if one.id in COMPARED_WITH_A_FOON else None)


def test_the_document_has_every_rule_in_order():
    assert tuple(one.id for one in rules()) == RULES


@pytest.mark.parametrize("one", rules(), ids=lambda one: one.id)
def test_a_rule_says_its_level_in_one_sentence_and_more(one):
    assert one.summary.endswith(".")
    assert one.summary in " ".join(one.text.split())
    assert not re.search(r"^(```|#)", one.text, re.MULTILINE)
    if one.id not in FORM:
        assert re.search(r"^- \*\*(fatal|minor)\*\*: ", one.text, re.MULTILINE)


@pytest.mark.parametrize("one", every_rule())
def test_the_keeping_example_has_no_finding(one):
    report = judged(one, one.keeps)
    assert [str(finding) for finding in report.findings] == []
    assert report.accepted
    assert remarks(one.keeps) == ()


@pytest.mark.parametrize("one", every_rule())
def test_the_breaking_example_breaks_the_rule_where_the_document_says(one):
    told = remarks(one.breaks)
    assert told
    found = {(finding.step, finding.minor) for finding in judged(one, one.breaks).of([one.id])}
    assert {(remark.step, remark.minor) for remark in told} <= found


def test_a_rule_that_only_has_minor_findings_is_not_shown_with_a_fatal_one():
    for one in rules():
        levels = set(re.findall(r"\*\*(fatal|minor)\*\*", one.text)) or {"fatal"}
        assert {"minor" if remark.minor else "fatal" for remark in remarks(one.breaks)} <= levels


def test_a_rule_is_asked_by_its_id():
    assert rule("W3") is rule("w3")
    assert rule("W3").name == "appliances"
    with pytest.raises(UsageError, match="no rule “S1”") as caught:
        rule("S1")
    assert "C1, C2" in caught.value.hint


def test_the_installed_document_is_the_one_of_the_repository():
    installed = resources.files("foon_kg.docs").joinpath("contract.md").read_text(encoding="utf-8")
    assert installed == DOCUMENT.read_text(encoding="utf-8")


def blocks(kind):
    return re.findall(rf"^```{kind}\n(.*?)^```$", DOCUMENT.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def test_every_block_of_the_document_is_one_that_the_tests_run():
    infos = re.findall(r"^```(.+)$", DOCUMENT.read_text(encoding="utf-8"), re.MULTILINE)
    assert set(infos) == {"tree", "tree keeps", "tree breaks", "foon", "toml utensils", "toml foods"}
    assert infos.count("tree keeps") == infos.count("tree breaks") == len(RULES)


def test_the_step_that_shows_the_notation_is_of_it():
    (text,) = blocks("tree")
    assert [unit.motion for unit in read_tree(text).units] == ["boil"]


def test_links_within_the_document_and_to_others_lead_somewhere():
    text = DOCUMENT.read_text(encoding="utf-8")
    anchors = {head.strip().lower().replace(" ", "-") for head in re.findall(r"^#+ (.+)$", text, re.MULTILINE)}
    for target in re.findall(r"\]\(([^)]+)\)", text):
        assert target[1:] in anchors if target.startswith("#") else (DOCUMENT.parent / target).exists(), target
    for path in re.findall(r"`((?:foon_kg|tests)/[\w/.]+)`", text):
        assert (DOCUMENT.parents[1] / path).exists(), path


def test_the_tables_of_ones_own_add_what_the_document_says(tmp_path, monkeypatch):
    (utensils,), (foods,) = blocks("toml utensils"), blocks("toml foods")
    assert tables().utensil("ulu") is None
    for variable, text in ((UTENSILS_VARIABLE, utensils), (FOODS_VARIABLE, foods)):
        path = tmp_path / f"{variable}.toml"
        path.write_text(text, encoding="utf-8")
        monkeypatch.setenv(variable, str(path))
    known = tables()
    for group in tomllib.loads(utensils)["groups"].values():
        assert {known.utensil(name).role for name in group["names"]} == {group["role"]}
    assert known.utensil("horno").source == "heat"
    assert known.utensil("knife").role == "tool"
    assert known.foods.food("yacon").owes == known.foods.food("carrot").owes
    leaf = known.foods.food("rosella leaf")
    assert (leaf.kind, leaf.owes["cook"]) == ("my sour leaf", Level.FATAL)
    assert leaf.is_a("vegetable")
    assert known.foods.food("rosella leaf", ("dried",)).kind == "dried herb"
