"""``foon check``: whether a robot can carry task trees out, and a cook would serve what comes of them."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, sayer
from foon_kg.cli.kitchen import KitchenFile
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.cli.tree_files import TreeDocument
    from foon_kg.foon import Foon
    from foon_kg.model import Recipe
    from foon_kg.model.tree import TaskTree
    from foon_kg.plans.kitchen import Kitchen
    from foon_kg.validation import Finding, KnownFoon, Report

EXAMPLES = examples(
    "foon plan recipe.json --json | foon check -",
    "foon check plans.jsonl --files subgraphs/",
    "foon check tree.txt --recipe recipe.json --json",
    "foon check plans.jsonl --kitchen kitchen.txt",
    "foon check --rules",
    "foon check --rule W3",
)


def check(  # noqa: PLR0917 - each parameter is an option of its own
    trees: Annotated[
        list[Path] | None,
        typer.Argument(metavar="FILE...", help="Plan results (JSON, JSON Lines) or FOON text; - is standard input."),
    ] = None,
    recipe: Annotated[
        Path | None, typer.Option("--recipe", metavar="FILE", help="The recipe (JSON) that the trees answer.")
    ] = None,
    kitchen: KitchenFile = None,
    rules: Annotated[bool, typer.Option("--rules", help="Print the rules, and ask nothing of any tree.")] = False,
    rule: Annotated[
        str | None, typer.Option("--rule", metavar="RULE", help="Print this rule with its two examples.")
    ] = None,
    as_json: Json = False,
    files: Files = None,
    quiet: Quiet = False,
) -> None:
    """Play task trees in a kitchen, and say what breaks the contract.

    A tree is accepted where a robot can carry it out (W1 to W5, K4) and a cook would serve what comes of it (K1 to
    K7). C1 to C9 ask of its form. Every finding says its rule, the step (from 1), the object nodes and the reason.
    Fatal findings come first, then minor ones: odd, yet it can be done. A rule that lacks what it would need (FOON
    text carries no recipe: give one) is named as not asked. Several trees for one recipe are compared with the first
    (C9). With --kitchen every leaf must be something that the file names (C6).

    Exits with 0 when every tree is accepted and no rule has a fatal finding, otherwise with 1.
    """
    if rules or rule is not None:
        _tell_rules(rule, trees or [], both=rules and rule is not None, as_json=as_json)
        return
    if not trees:
        raise UsageError("there is no tree to check", hint="Name files, - for standard input, or --rules.")
    judged = _judged(trees, recipe, kitchen, files, sayer(quiet=quiet))
    for _, report in judged:
        _show(report, as_json=as_json)
    if any(_is_refused(document, report) for document, report in judged):
        raise typer.Exit(1)


def _is_refused(document: TreeDocument, report: Report) -> bool:
    return document.tree.error is not None or bool(report.fatal) or not report.accepted


def _tell_rules(name: str | None, trees: Sequence[Path], *, both: bool, as_json: bool) -> None:
    from foon_kg.cli.rules import show_rule, show_rules

    if trees or both:
        raise UsageError(
            "--rules and --rule stand alone", hint="Check trees by another command: foon check plans.jsonl"
        )
    if name is None:
        show_rules(as_json=as_json)
    else:
        show_rule(name, as_json=as_json)


def _judged(
    trees: Sequence[Path], recipe: Path | None, kitchen: Path | None, files: list[Path] | None, say: Say
) -> list[tuple[TreeDocument, Report]]:
    from foon_kg.cli.kitchen import kitchen_of
    from foon_kg.cli.knowledge import front_door
    from foon_kg.cli.tree_files import read_trees
    from foon_kg.foon import Foon
    from foon_kg.validation import KnownFoon

    with front_door(files, say) as door:
        snapshot = door.snapshot()  # what the judge looks up may be anywhere in it
        whole = Foon(snapshot)
        asked = _recipe(recipe, whole, say)
        documents = [document for path in trees for document in read_trees(path, asked)]
        known = door.with_drafts() if any(map(_is_after_a_draft, documents)) else snapshot
    for notice in (notice for document in documents for notice in document.notices):
        say(str(notice))
    foon = KnownFoon.of(known.units, known.goals())
    at_hand = kitchen_of(kitchen, whole, say)
    reports = [_report(document.tree, foon, at_hand) for document in documents]
    return list(zip(documents, _with_repetition(documents, reports), strict=True))


def _is_after_a_draft(document: TreeDocument) -> bool:
    reference = document.value.get("reference") if isinstance(document.value, dict) else None
    return isinstance(reference, dict) and "draft_confidence" in reference


def _recipe(path: Path | None, foon: Foon, say: Say) -> Recipe | None:
    """Read the recipe as ``foon plan`` reads it, so that both mean the same foods and states."""
    if path is None:
        return None
    read = next(foon.read_recipes(path))
    for note in read.notes:
        say(note)
    return read.recipe


def _report(tree: TaskTree, foon: KnownFoon, kitchen: Kitchen) -> Report:
    """Judge a tree; what a person named as being at hand is a leaf as it was named, be it chopped already."""
    from foon_kg.validation import check as judge

    asked = (wanted.object for wanted in (tree.recipe.ingredients if tree.recipe else ()))
    own = kitchen.with_foods(asked)
    report = judge(tree, foon, own.free_foods, own.lacks, own.names_so)
    return replace(report, findings=(*report.findings, *_too_few(tree, own)))


def _too_few(tree: TaskTree, kitchen: Kitchen) -> Iterator[Finding]:
    """Yield of what the tree takes more than there are in the kitchen that was named (C6)."""
    from foon_kg.validation import Finding

    for leaf, needed, there in kitchen.shortages(tree.units):
        yield Finding("C6", f"{needed} are needed, and the kitchen that was named has {there}", None, (leaf,))


_SAME_WISHES = "C9 takes plans of one recipe for asked in one kitchen and with the same wishes, which they do not tell"


def _with_repetition(documents: Sequence[TreeDocument], reports: Sequence[Report]) -> Iterator[Report]:
    """Yield the reports in their order, with what C9 says of several trees for one recipe: the first is the measure.

    That they were asked in the same kitchen and with the same wishes is assumed, since a plan does not tell these: a
    note says so where two differ.
    """
    from foon_kg.validation import repeatable

    first: dict[str, object] = {}
    for document, report in zip(documents, reports, strict=True):
        if not isinstance(document.value, dict):
            yield report
            continue
        asked = [document.value.get(field) for field in ("recipe", "asked")]
        if not any(asked):  # whatever it answers, no other tree is known to answer the same
            yield report
            continue
        question = json.dumps(asked, sort_keys=True)
        earlier = first.get(question)
        if earlier is None:
            first[question] = document.value
            yield report
            continue
        not_asked = tuple((rule, why) for rule, why in report.not_asked if rule != "C9")
        differing = repeatable([earlier, document.value])
        notes = (*report.notes, _SAME_WISHES) if differing else report.notes
        yield replace(report, findings=(*report.findings, *differing), not_asked=not_asked, notes=notes)


def _show(report: Report, *, as_json: bool) -> None:
    if as_json:
        print_json(report.to_json())
    else:
        typer.echo("\n".join(report.lines()))
