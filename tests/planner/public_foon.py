"""Recipes planned from the public FOON, and what the judge says of the trees: what the slow tests share."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from pathlib import Path

import pytest

from foon_kg import validation
from foon_kg.evaluation.verdicts import Verdicts
from foon_kg.loaders import read_paths
from foon_kg.model import Recipe
from foon_kg.model.errors import NoTreeError
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanFailure, PlanResult
from foon_kg.store.snapshot import Snapshot

SHARED = Path(__file__).resolve().parents[2] / ".." / "shared" / "data"

Answer = PlanResult | PlanFailure


@cache
def public_snapshot() -> Snapshot:
    """Return the public FOON, read once in a process; where its data are not there the test is skipped."""
    if not SHARED.exists():
        pytest.skip(f"the public data is not at {SHARED}")
    read = read_paths([SHARED / "foon-111" / "TXT"])
    return Snapshot.of([result.subgraph for result in read if result.subgraph is not None], Kitchen.default())


@cache
def public_planner() -> Planner:
    """Return the planner over all of the public FOON, made once in a process: an answer is the same after others."""
    snapshot = public_snapshot()
    return Planner(snapshot, PlanSettings(), snapshot.units)


def answers_to(recipes: Iterable[Recipe]) -> list[Answer]:
    """Return a plan result or a failure for each recipe."""
    planner = public_planner()
    found: list[Answer] = []
    for recipe in recipes:
        try:
            found.append(planner.plan(recipe))
        except NoTreeError as error:
            found.append(PlanFailure.of(recipe, error))
    return found


def verdicts_on(answers: Iterable[Answer]) -> Verdicts:
    """Return what the judge says of each tree as its JSON has it, asked against the whole FOON."""
    snapshot = public_snapshot()
    foon = validation.KnownFoon.of(snapshot.units, snapshot.goals())
    return Verdicts(
        tuple(
            validation.check(validation.tree_from_json(answer.to_json()), foon) if has_tree(answer) else None
            for answer in answers
        )
    )


def faults(answers: Iterable[Answer], verdicts: Verdicts) -> list[str]:
    """Return what is fatal in the trees among ``answers``, of which ``verdicts`` are."""
    return [
        f"{answer.recipe.id}: {finding}"
        for answer, report in zip(answers, verdicts.reports, strict=True)
        if report is not None
        for finding in report.findings
        if not finding.minor
    ]


def has_tree(answer: Answer) -> bool:
    """Whether an answer is a tree."""
    return isinstance(answer, PlanResult)


def failures(answers: Iterable[Answer]) -> list[PlanFailure]:
    """Return those of ``answers`` that are no tree."""
    return [answer for answer in answers if isinstance(answer, PlanFailure)]
