"""``foon load``: bring FOONs and collections of recipes into the graph."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli import load_recipes, load_weights
from foon_kg.cli.console import ErrorsAtTheEdge, Json, Quiet, Say, examples, messages, sayer
from foon_kg.cli.loading import (
    BadTolerance,
    DryRun,
    Report,
    refuse_too_many,
    show_counts,
    tell_assumed,
    tell_unknown,
    unknown_notice,
)

if TYPE_CHECKING:
    from foon_kg.food.unknown import UnknownWord
    from foon_kg.loaders import ReadResult
    from foon_kg.model import Subgraph
    from foon_kg.store.graph import LoadReport

app = typer.Typer(
    cls=ErrorsAtTheEdge,
    name="load",
    no_args_is_help=True,
    rich_markup_mode=None,
    help="Load FOONs and collections of recipes into Neo4j.",
)


@app.callback()
def load() -> None:
    """Load FOONs and collections of recipes into Neo4j."""


@app.command(
    epilog=examples(
        "foon load foon subgraphs/",
        "foon load foon subgraphs/ --bad-tolerance 3 --report notices.jsonl",
        "foon load foon 0001.txt 0002.json --dry-run",
    )
)
def foon(
    paths: Annotated[list[Path], typer.Argument(metavar="PATH...", help="Subgraph files (text or JSON), or folders.")],
    *,
    report: Report = None,
    bad_tolerance: BadTolerance = 0,
    dry_run: DryRun = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Load subgraphs: FOON text in both dialects, or JSON.

    A video is in the graph whole or not at all. Loading it again changes nothing; with other content it replaces what
    was there. Units that cannot be used (no motion, no outputs, ...) are left out, and each is told with file and
    line; when there are more than --bad-tolerance allows, nothing is loaded. Foods, utensils, states and motions that
    no table of foon-kg has are told, with what they are taken for.
    """
    from foon_kg.loaders import read_paths

    results = list(read_paths(paths))
    _bring(results, report, bad_tolerance, dry_run=dry_run, as_json=as_json, quiet=quiet)


@app.command(
    epilog=examples("foon load videos greek_salad.csv", "foon load videos annotated/ --dry-run --report notices.jsonl")
)
def videos(
    paths: Annotated[
        list[Path], typer.Argument(metavar="PATH...", help="Plain tables (.csv), subgraph files, or folders.")
    ],
    *,
    report: Report = None,
    bad_tolerance: BadTolerance = 0,
    dry_run: DryRun = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Load newly annotated videos: plain tables, subgraphs.

    A person writes a table while watching. It has a row a step: start,end,motion,inputs,outputs, and dish where the row
    makes the dish. Things are written like "onion (chopped) on cutting board; bowl {salt}", with semicolons between
    them. All of it is loaded, or nothing. Videos that are only narrated (EPIC-KITCHENS-100, ActivityNet Captions,
    YouCook2) are drafted first: foon draft videos.
    """
    from foon_kg.loaders.video_tables import read_videos

    _refuse_drafts(paths)
    results = list(read_videos(paths))
    _bring(results, report, bad_tolerance, dry_run=dry_run, as_json=as_json, quiet=quiet)


@app.command(epilog=examples("foon load muhai recipe-annotations/", "foon load muhai easy-banana-bread.lisp --dry-run"))
def muhai(
    paths: Annotated[list[Path], typer.Argument(metavar="PATH...", help="MUHAI recipes (*.lisp), or folders.")],
    *,
    report: Report = None,
    bad_tolerance: BadTolerance = 0,
    dry_run: DryRun = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Load MUHAI's recipes: networks of kitchen primitives in Lisp.

    Each primitive becomes a unit, each recipe a video; the title says the dish type. Nothing in a file is evaluated.
    Primitives that cannot be understood are left out, and told with file and line; a recipe that lacks some gives no
    dish.
    """
    from foon_kg.loaders.muhai import read_muhai

    results = list(read_muhai(paths))
    _bring(results, report, bad_tolerance, dry_run=dry_run, as_json=as_json, quiet=quiet)


app.command(epilog=load_recipes.EXAMPLES)(load_recipes.recipes)
app.command(epilog=load_weights.EXAMPLES)(load_weights.weights)


def _refuse_drafts(paths: Sequence[Path]) -> None:
    """Refuse what nobody has reviewed: drafts, and videos that are told without states."""
    from foon_kg.language.drafting.tables import is_draft_file
    from foon_kg.loaders.narrations import is_narrated
    from foon_kg.model.errors import UsageError

    files = [file for path in paths for file in (sorted(path.rglob("*.*")) if path.is_dir() else [path])]
    for file in files:
        if is_narrated(file):
            hint = f"foon draft videos {file} --output drafts/"
            raise UsageError(f"{file}: it narrates videos without states: draft them first", hint=hint)
        if is_draft_file(file):
            hint = f"foon draft review {file}, then foon draft accept {file}"
            raise UsageError(f"{file}: a draft is accepted, not loaded", hint=hint)


def _bring(
    results: Sequence[ReadResult],
    report: Path | None,
    bad_tolerance: int,
    *,
    dry_run: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """Tell what is odd about ``results``, and load them unless too much of them is unusable."""
    say = sayer(quiet=quiet)
    _tell_notices(results, report, say)
    subgraphs = [result.subgraph for result in results if result.subgraph is not None]
    rejected = sum(result.rejected for result in results)
    bad = sum(result.rejected > 0 for result in results)
    refuse_too_many(rejected, bad_tolerance, "unit", f", in {bad} of {len(results)} files")
    loaded = None if dry_run else _load(subgraphs, say, quiet=quiet)
    show_counts(_counts(subgraphs, loaded, rejected), as_json=as_json)


def _tell_notices(results: Sequence[ReadResult], report: Path | None, say: Say) -> None:
    """Write every notice to ``report``; say the rejected ones, and count the others."""
    from foon_kg.loaders import Severity, write_report
    from foon_kg.model.errors import UsageError

    notices = [notice for result in results for notice in result.notices]
    words = _unknown_words(results)
    if report:
        try:
            with report.open("w", encoding="utf-8") as stream:
                write_report((*notices, *(unknown_notice(word, file) for word, file in words.items())), stream)
        except OSError as error:
            hint = "Name a file that can be written after --report."
            raise UsageError(f"{report}: cannot be written: {error.strerror}", hint=hint) from error
    for notice in notices:
        if notice.severity is Severity.REJECTED:
            say(str(notice))
    assumed = [notice for notice in notices if notice.severity is not Severity.REJECTED]
    tell_assumed(assumed, Counter(notice.kind for notice in assumed), report, say)
    tell_unknown(words, report, say)


def _unknown_words(results: Sequence[ReadResult]) -> dict[UnknownWord, str]:
    """Return the words that no table has, each with the first file that has it."""
    from foon_kg.food.unknown import unknown_words

    found: dict[UnknownWord, str] = {}
    for result in results:
        units = [one.unit for one in result.subgraph.annotations] if result.subgraph is not None else []
        nodes = (node for unit in units for node in (*unit.input_nodes, *unit.output_nodes))
        for word in unknown_words(nodes, [unit.motion for unit in units]):
            found.setdefault(word, result.path)
    return dict(sorted(found.items(), key=lambda one: one[0]))


def _load(subgraphs: Sequence[Subgraph], say: Say, *, quiet: bool) -> LoadReport:
    """Load with a progress bar, which only a terminal shows."""
    from rich.progress import Progress

    from foon_kg.foon import Foon

    console = messages(quiet=quiet)
    with Foon.connect(say=say) as foon, Progress(console=console, disable=not console.is_terminal) as progress:
        task = progress.add_task("Loading", total=len(subgraphs))
        return foon.store(subgraphs, stored=lambda report: progress.advance(task, len(report)))


def _counts(subgraphs: Sequence[Subgraph], loaded: LoadReport | None, rejected: int) -> dict[str, int]:
    units = sum(len(subgraph.annotations) for subgraph in subgraphs)
    counts = {"subgraphs": len(subgraphs), "units": units, "rejected_units": rejected}
    if loaded is None:
        return counts
    return {
        "inserted": len(loaded.inserted),
        "unchanged": len(loaded.unchanged),
        "replaced": len(loaded.replaced),
        **counts,
    }
