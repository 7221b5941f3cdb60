"""``--check``: what an annotator forgot, as the judge meets it when it plays the video in a kitchen."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from foon_kg.cli.console import Say

if TYPE_CHECKING:
    from foon_kg.loaders import Notice, ReadResult
    from foon_kg.validation import Finding, KnownFoon, Report


def played(results: Sequence[ReadResult], say: Say) -> tuple[Notice, ...]:
    """Play every video that was read, say what the judge thinks of each, and return its findings by file and line.

    Asked are the rules of the world and of the table (docs/contract.md) and those of the form that need no recipe.
    What a video uses is looked up in the videos of ``results`` alone.
    """
    from foon_kg.foon import Snapshot
    from foon_kg.plans.kitchen import Kitchen
    from foon_kg.validation import KnownFoon

    subgraphs = [result.subgraph for result in results if result.subgraph is not None]
    snapshot = Snapshot.of(subgraphs, Kitchen.default())
    foon = KnownFoon.of(snapshot.units, snapshot.goals())
    found: list[Notice] = []
    for result in results:
        report = _report(result, foon, snapshot.kitchen.free_foods)
        if report is None:
            continue
        notices = list(_notices(result, report))
        found += notices
        for notice in notices:
            say(str(notice))
        say(f"{report.name}: {_verdict(report)}")
    return tuple(found)


def _report(result: ReadResult, foon: KnownFoon, free_foods: frozenset[str]) -> Report | None:
    from foon_kg.validation import check, tree_from_subgraph

    return None if result.subgraph is None else check(tree_from_subgraph(result.subgraph, None), foon, free_foods)


def _notices(result: ReadResult, report: Report) -> Iterator[Notice]:
    """Yield what the judge found, in the order of the steps; what is said of the whole video comes last."""
    from foon_kg.loaders import Notice, NoticeKind

    in_order = sorted(report.findings, key=lambda one: (one.step is None, one.step or 0))
    for finding in in_order:
        line = None if finding.step is None or not result.lines else result.lines[finding.step]
        action = "odd, yet it can be done" if finding.minor else f"foon check --rule {finding.rule} says more"
        yield Notice(result.path, line, NoticeKind.NOT_PLAYED, _told(result, finding), action)


def _told(result: ReadResult, finding: Finding) -> str:
    about = "; ".join(map(str, finding.nodes))
    what = f"{finding.reason} ({about})" if about else finding.reason
    if finding.step is None or result.subgraph is None:
        return what
    return f"step {finding.step + 1}, {result.subgraph.annotations[finding.step].unit.motion}: {what}"


def _verdict(report: Report) -> str:
    robot = "a robot can carry it out" if report.robot else "a robot cannot carry it out"
    cook = "a cook would serve it" if report.cook else "a cook would not serve it"
    return f"{robot}, {cook}"
