"""``foon check``: whether task trees keep the contract, and, with ``--sense``, whether they make sense."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, sayer
from foon_kg.cli.kitchen import KitchenFile

if TYPE_CHECKING:
    from foon_kg.cli.tree_files import TreeDocument
    from foon_kg.form import Report
    from foon_kg.model import Recipe
    from foon_kg.snapshot import Snapshot

EXAMPLES = examples(
    "foon plan recipe.json --json | foon check -",
    "foon check plans.jsonl --sense --files subgraphs/",
    "foon check tree.txt --recipe recipe.json --json",
    "foon check plans.jsonl --kitchen kitchen.txt",
)


def check(
    trees: Annotated[
        list[Path],
        typer.Argument(metavar="FILE...", help="Plan results (JSON, JSON Lines) or FOON text; - is standard input."),
    ],
    *,
    recipe: Annotated[
        Path | None, typer.Option("--recipe", metavar="FILE", help="The recipe (JSON) that the trees answer.")
    ] = None,
    kitchen: KitchenFile = None,
    sense: Annotated[bool, typer.Option("--sense", help="Ask the sense measures S1 to S8 as well.")] = False,
    as_json: Json = False,
    files: Files = None,
    quiet: Quiet = False,
) -> None:
    """Check task trees against the contract C1 to C9.

    Every failure is told with its rule, the unit (from 0), the object node and the reason. A rule that lacks what
    it would need (FOON text carries no recipe: give one) is named as not asked. Several answers to one recipe are
    compared with the first (C9). With --kitchen every leaf must be something that the file names (C6).

    Exits with 0 when every tree is sound (with --sense: clean, that is sound and sensible), otherwise with 1.
    """
    from foon_kg.cli.kitchen import kitchen_of
    from foon_kg.cli.knowledge import whole_foon
    from foon_kg.cli.tree_files import read_trees
    from foon_kg.form import KnownFoon
    from foon_kg.form import check as judge

    say = sayer(quiet=quiet)
    snapshot = whole_foon(files, say)  # what the judge looks up may be anywhere in it
    asked = _recipe(recipe, snapshot, say)
    documents = [document for path in trees for document in read_trees(path, asked)]
    for notice in (notice for document in documents for notice in document.notices):
        say(str(notice))
    foon = KnownFoon.of(snapshot.units, snapshot.goals())
    at_hand = kitchen_of(kitchen, snapshot.vocabulary(), say)
    reports = list(_with_repetition(documents, [judge(document.tree, foon, at_hand) for document in documents]))
    for report in reports:
        _show(report if sense else _contract_only(report), sense=sense, as_json=as_json)
    if not all(report.clean if sense else report.sound for report in reports):
        raise typer.Exit(1)


def _recipe(path: Path | None, snapshot: Snapshot, say: Say) -> Recipe | None:
    """Read the recipe as ``foon plan`` reads it, so that both mean the same foods and states."""
    from foon_kg.recipes import IngredientWords, read_recipe

    if path is None:
        return None
    read = read_recipe(path, IngredientWords(snapshot.vocabulary(), snapshot.kitchen))
    for note in read.notes:
        say(note)
    return read.recipe


def _with_repetition(documents: Sequence[TreeDocument], reports: Sequence[Report]) -> Iterator[Report]:
    """Add what C9 says of several answers to one recipe: each is compared with the first."""
    from foon_kg.form import repeatable

    first: dict[str, object] = {}
    for document, report in zip(documents, reports, strict=True):
        if not isinstance(document.value, dict):
            yield report
            continue
        question = json.dumps([document.value.get(asked) for asked in ("recipe", "asked")], sort_keys=True)
        earlier = first.setdefault(question, document.value)
        yield replace(report, findings=(*report.findings, *repeatable([earlier, document.value])))


def _contract_only(report: Report) -> Report:
    from foon_kg.form import CONTRACT

    not_asked = tuple((rule, why) for rule, why in report.not_asked if rule in CONTRACT)
    return replace(report, findings=report.of(CONTRACT), not_asked=not_asked)


def _show(report: Report, *, sense: bool, as_json: bool) -> None:
    if as_json:
        print_json(report.to_json())
        return
    typer.echo("\n".join(_lines(report, sense=sense)))


def _lines(report: Report, *, sense: bool) -> Iterator[str]:
    verdict = "sound" if report.sound else "not sound"
    if sense:
        verdict = "clean" if report.clean else f"{verdict}, not clean"
    yield f"{report.name}: {verdict}" + (f" ({', '.join(report.broken)})" if report.broken else "")
    yield from (f"  {finding}" for finding in report.findings)
    yield from (f"  {note}" for note in report.notes)
    yield from (f"  {rule} not asked: {why}" for rule, why in report.not_asked if rule != "C9")
