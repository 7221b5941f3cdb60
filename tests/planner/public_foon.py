"""Recipes planned from the public FOON, and what the judge says of the trees: what the slow tests share."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import pytest

from foon_kg.errors import NoTreeError
from foon_kg.form import CONTRACT, KnownFoon, Report, TaskTree, check
from foon_kg.kitchen import Kitchen
from foon_kg.loaders import read_paths
from foon_kg.model import Recipe
from foon_kg.planner import Planner
from foon_kg.result import PlanFailure, PlanResult
from foon_kg.settings import PlanSettings
from foon_kg.snapshot import Snapshot

SHARED = Path(__file__).resolve().parents[2] / ".." / "shared" / "data"

Answer = PlanResult | PlanFailure


def public_snapshot() -> Snapshot:
    """Answer the public FOON; where its data are not there the test is skipped."""
    if not SHARED.exists():
        pytest.skip(f"the public data is not at {SHARED}")
    read = read_paths([SHARED / "foon-111" / "TXT"])
    return Snapshot.of([result.subgraph for result in read if result.subgraph is not None], Kitchen.default())


def answers_to(recipes: Iterable[Recipe], snapshot: Snapshot) -> list[Answer]:
    """Answer a plan result or a failure for each recipe, all from one planner."""
    planner = Planner(snapshot, PlanSettings(), snapshot.units)
    found: list[Answer] = []
    for recipe in recipes:
        try:
            found.append(planner.plan(recipe))
        except NoTreeError as error:
            found.append(PlanFailure.of(recipe, error))
    return found


def reports_on(answers: Iterable[Answer], snapshot: Snapshot) -> list[Report]:
    """Answer what the judge says of each answer as its JSON has it, asked against the whole FOON."""
    foon = KnownFoon.of(snapshot.units, snapshot.goals())
    return [check(TaskTree.from_json(answer.to_json()), foon) for answer in answers]


def breaches(answers: Sequence[Answer], reports: Sequence[Report]) -> list[str]:
    """Answer what breaks the contract in the trees among ``answers``."""
    trees = [(a, report) for a, report in zip(answers, reports, strict=True) if isinstance(a, PlanResult)]
    return [f"{answer.recipe.id}: {finding}" for answer, report in trees for finding in report.of(CONTRACT)]


def failures(answers: Iterable[Answer]) -> list[PlanFailure]:
    """Answer those of ``answers`` that are no tree."""
    return [answer for answer in answers if isinstance(answer, PlanFailure)]
