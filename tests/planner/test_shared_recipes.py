"""Real recipes against the public FOON: the shares of sound and clean trees, which may rise and must not fall."""

from __future__ import annotations

import json

import pytest
from planner.public_foon import SHARED, answers_to, breaches, failures, public_snapshot, reports_on

from foon_kg.planner import Planner
from foon_kg.recipes import IngredientWords, read_recipe
from foon_kg.result import PlanResult
from foon_kg.settings import PlanSettings

pytestmark = [pytest.mark.shared_data, pytest.mark.slow]

EVERY = 3
"""Every third recipe of each dish type, by name: all 210 take minutes on a busy machine."""

SOUND, CLEAN = 1.0, 0.94
"""Measured on all 210: 1.00 and 0.976. Raise them when more is reached."""


@pytest.fixture(scope="module")
def snapshot():
    return public_snapshot()


@pytest.fixture(scope="module")
def answers(snapshot):
    words = IngredientWords(snapshot.vocabulary(), snapshot.kitchen)
    folders = sorted((SHARED / "queries").iterdir())
    paths = [path for folder in folders for path in sorted(folder.glob("*.json"))[::EVERY]]
    return answers_to((read_recipe(path, words).recipe for path in paths), snapshot)


@pytest.fixture(scope="module")
def reports(snapshot, answers):
    return reports_on(answers, snapshot)


def told(reports, rules):
    return "\n".join(f"{report.name}: {finding}" for report in reports for finding in report.of(rules))


def test_every_answer_says_in_json_all_that_it_says(answers):
    for answer in answers:
        value = json.loads(json.dumps(answer.to_json(), ensure_ascii=False))
        assert type(answer).from_json(value) == answer
        assert answer.recipe.id


def test_where_there_is_no_tree_the_reason_names_a_rule_or_the_goal(answers):
    for failure in failures(answers):
        assert failure.code in {"no-way", "left-out"}
        assert failure.message
        assert failure.hint


def test_a_tree_is_sound(answers, reports):
    assert breaches(answers, reports) == []


def test_a_recipe_has_the_same_answer_from_the_units_behind_its_goals_as_from_the_whole_foon(snapshot, answers):
    planner = Planner(snapshot, PlanSettings())
    for answer in answers[::7]:
        if isinstance(answer, PlanResult):
            assert planner.plan(answer.recipe).to_json() == answer.to_json()


def test_nearly_every_recipe_has_a_sound_tree_and_most_have_a_clean_one(reports):
    assert sum(report.sound for report in reports) >= SOUND * len(reports), told(reports, {"C2"})
    assert sum(report.clean for report in reports) >= CLEAN * len(reports), told(reports, {f"S{n}" for n in range(9)})
