"""``foon load``: bring FOONs and collections of recipes into the graph."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli import load_drafts, load_recipes, load_weights
from foon_kg.cli.console import Json, Quiet, Say, examples, sayer
from foon_kg.cli.data_frames import driver_without_arrays
from foon_kg.cli.groups import CommandGroup
from foon_kg.cli.loading import (
    UNWRITTEN,
    BadTolerance,
    Check,
    DryRun,
    Report,
    is_too_many,
    refuse_too_many,
    show_counts,
    tell_in_short,
    unknown_notice,
)
from foon_kg.model.nodes import distinct_by_name
from foon_kg.model.written_files import write_file

if TYPE_CHECKING:
    from foon_kg.cli.files_read import FilesRead, Spool
    from foon_kg.loaders import Notice, ReadResult
    from foon_kg.model import Subgraph

app = CommandGroup(name="load", help="Load FOONs and collections of recipes into Neo4j.")


@dataclass(frozen=True)
class Counts:
    """How many videos were new, were there as they are, and had another content."""

    inserted: int = 0
    unchanged: int = 0
    replaced: int = 0


@app.callback()
def load() -> None:
    """Load FOONs and collections of recipes into Neo4j."""


@app.command(
    epilog=examples(
        "foon load foon subgraphs/",
        "foon load foon subgraphs/ --bad-tolerance 3 --report notices.jsonl",
        "foon load foon 0001.txt 0002.json --dry-run",
        "foon load foon subgraphs/ --offline --recipes recipe1m/",
    )
)
def foon(
    paths: Annotated[list[Path], typer.Argument(metavar="PATH...", help="Subgraph files (text or JSON), or folders.")],
    *,
    report: Report = None,
    bad_tolerance: BadTolerance = None,
    dry_run: DryRun = False,
    check: Check = False,
    offline: Annotated[
        bool, typer.Option("--offline", help="Import all at once into the empty local server: for a very large FOON.")
    ] = False,
    replace: Annotated[
        bool, typer.Option("--replace", help="With --offline: in place of all that the local server holds.")
    ] = False,
    recipes: Annotated[
        list[Path] | None,
        typer.Option("--recipes", metavar="PATH", help="With --offline: collections that come with it; repeatable."),
    ] = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Load subgraphs: FOON text in both dialects, or JSON.

    A video is in the graph whole or not at all. Loading it again changes nothing; with other content it replaces what
    was there. Units that cannot be used (no motion, no outputs, ...) are left out, and each is told with file and
    line; when there are more than --bad-tolerance allows, nothing is loaded. Foods, utensils, states and motions that
    no table of foon-kg has are told with their line, with what they are taken for and what may be meant.

    With --offline the local server gets them through neo4j-admin's import, with the very graph that a load writes. It
    goes on with what it holds until all is ready. No more than a part of the files is in memory. Collections of recipes
    come with it by --recipes, as foon load recipes brings them.
    """
    from foon_kg.cli.files_read import Spool
    from foon_kg.loaders.found import foon_files

    _refuse_together(offline=offline, replace=replace, check=check, recipes=bool(recipes))
    files = foon_files(paths)
    if offline and not dry_run:
        counts = _import(files, report, bad_tolerance, recipes or [], replace=replace, quiet=quiet)
        show_counts(counts, as_json=as_json)
        return
    say = sayer(quiet=quiet)
    with Spool() as spool:
        read, played = _played_all(files, spool, say) if check else (_read(files, spool), ())
        _tell(read, report, bad_tolerance, say, played)
        loaded = None if dry_run else _stored(files, read, spool, quiet=quiet)
    with load_recipes.beside(recipes or [], bad_tolerance, say, quiet=quiet) as (_, counts):  # of a dry run
        show_counts(_counts(read, loaded) | counts, as_json=as_json)


@app.command(
    epilog=examples(
        "foon load videos greek_salad.csv",
        "foon load videos greek_salad.csv --check --dry-run",
        "foon load videos annotated/ --dry-run --report notices.jsonl",
    )
)
def videos(
    paths: Annotated[
        list[Path], typer.Argument(metavar="PATH...", help="Plain tables (.csv), subgraph files, or folders.")
    ],
    *,
    report: Report = None,
    bad_tolerance: BadTolerance = None,
    dry_run: DryRun = False,
    check: Check = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Load newly annotated videos: plain tables, subgraphs.

    A person writes a table while watching. It has a row a step: start,end,motion,inputs,outputs, and dish where the row
    makes the dish. Things are written like "onion (chopped) on cutting board; bowl {salt}", with semicolons between
    them; a * before a thing says that it moves. A * behind the motion ("mix *") says that the step takes any number of
    foods: other recipes may bring theirs in there. All of it is loaded, or nothing. Videos that are only narrated
    (EPIC-KITCHENS-100, ActivityNet Captions, YouCook2) are drafted first: foon draft videos.

    With --check each video is played in a kitchen, and what was forgotten is told by step and line: nobody lit the
    stove, an onion is chopped that nobody brought.
    """
    from foon_kg.loaders.video_tables import read_videos

    _refuse_drafts(paths)
    results = list(read_videos(paths))
    _bring(results, report, bad_tolerance, dry_run=dry_run, check=check, as_json=as_json, quiet=quiet)


@app.command(epilog=examples("foon load muhai recipe-annotations/", "foon load muhai easy-banana-bread.lisp --dry-run"))
def muhai(
    paths: Annotated[list[Path], typer.Argument(metavar="PATH...", help="MUHAI recipes (*.lisp), or folders.")],
    *,
    report: Report = None,
    bad_tolerance: BadTolerance = None,
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
app.command(epilog=load_drafts.EXAMPLES)(load_drafts.drafts)
app.command(epilog=load_weights.EXAMPLES)(load_weights.weights)


def _refuse_drafts(paths: Sequence[Path]) -> None:
    """Refuse what nobody has reviewed: drafts, and videos that are told without states."""
    from foon_kg.loaders.draft_tables import is_draft_file
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
    bad_tolerance: int | None,
    *,
    dry_run: bool,
    as_json: bool,
    quiet: bool,
    check: bool = False,
) -> None:
    """Tell what is odd about ``results``, and load them unless too much of them is unusable."""
    from foon_kg.cli.files_read import FilesRead

    read, say = FilesRead.of(results), sayer(quiet=quiet)
    _tell(read, report, bad_tolerance, say, _played(results, say) if check else ())
    subgraphs = distinct_by_name(result.subgraph for result in results if result.subgraph is not None)
    loaded = None if dry_run else _load(subgraphs, len(subgraphs), quiet=quiet)
    show_counts(_counts(read, loaded), as_json=as_json)


def _played(results: Sequence[ReadResult], say: Say) -> tuple[Notice, ...]:
    from foon_kg.cli.load_check import played

    return played(results, say)


def _played_all(files: Sequence[Path], spool: Spool, say: Say) -> tuple[FilesRead, tuple[Notice, ...]]:
    """Return what is in ``files``, which come into ``spool``, and what playing them tells."""
    from foon_kg.cli.files_read import FilesRead, remember
    from foon_kg.loaders import read_paths

    results = list(read_paths(files))
    for result in results:
        spool.add(result)
    read = FilesRead.of(results)
    remember(files, read)
    return read, _played(results, say)


def _read(files: Sequence[Path], spool: Spool) -> FilesRead:
    """Return what is in ``files``. Those that were not read before as they are come into ``spool``."""
    from foon_kg.cli.files_read import Gathered, remember, remembered

    if (known := remembered(files)) is not None:
        return known
    from foon_kg.loaders import read_paths

    gathered = Gathered()
    for result in read_paths(files):
        gathered.add(result)
        spool.add(result)
    read = gathered.read()
    remember(files, read)
    return read


def _stored(files: Sequence[Path], read: FilesRead, spool: Spool, *, quiet: bool) -> Counts:
    """Bring ``files`` into the graph; those that were parsed before are parsed again only if it lacks something."""
    if not spool.is_empty or not read.contents:
        return _load(spool, len(read.contents), quiet=quiet)
    return _unchanged(read, quiet=quiet) or _load(_parsed(files), len(read.contents), quiet=quiet)


def _parsed(files: Sequence[Path]) -> Iterator[Subgraph]:
    """Yield the subgraphs of ``files``, parsed as they are taken."""
    from foon_kg.loaders import read_paths

    yield from (result.subgraph for result in read_paths(files) if result.subgraph is not None)


def _tell(
    read: FilesRead, report: Path | None, bad_tolerance: int | None, say: Say, played: Sequence[Notice] = ()
) -> None:
    """Tell what is odd about files; raises ToleranceError where too much of them is unusable."""
    if report:
        _write_report(read, report, played)
    refused = is_too_many(read.rejected, read.units, bad_tolerance)
    tell_in_short(read.notices, read.words, report, say, named=refused)
    refuse_too_many(read.rejected, read.units, bad_tolerance, "unit", f", in {read.bad} of {read.files} files")


def _write_report(read: FilesRead, report: Path, played: Sequence[Notice]) -> None:
    """Write every notice to ``report``, with what was ``played``."""
    from foon_kg.loaders.report import write_report

    stream = StringIO()
    unknown = (unknown_notice(word, *where) for word, where in read.words.items())
    write_report((*read.notices, *unknown, *played), stream)
    write_file(report, stream.getvalue(), UNWRITTEN)


def _unchanged(read: FilesRead, *, quiet: bool) -> Counts | None:
    """Return the counts where all that was read is in the graph; nothing that writes is imported for it."""
    from foon_kg.foon import Foon

    with Foon.connect(say=sayer(quiet=quiet)) as foon, driver_without_arrays():
        there = foon.holds(read.contents)
    return Counts(unchanged=len(read.contents)) if there else None


def _load(subgraphs: Iterable[Subgraph], count: int, *, quiet: bool) -> Counts:
    """Load so many ``subgraphs`` with a progress bar, which only a terminal shows."""
    from foon_kg.cli.runs import counting
    from foon_kg.foon import Foon

    with Foon.connect(say=sayer(quiet=quiet)) as foon, counting("Loading videos", count, quiet=quiet) as advance:
        loaded = foon.store(subgraphs, stored=lambda report: advance(len(report)))
    return Counts(len(loaded.inserted), len(loaded.unchanged), len(loaded.replaced))


def _refuse_together(*, offline: bool, replace: bool, check: bool, recipes: bool) -> None:
    """Refuse options that do not go together."""
    from foon_kg.model.errors import UsageError

    if recipes and not offline:
        hint = "Load the FOON, then the recipes: foon load recipes PATH."
        raise UsageError("--recipes is for --offline: other loads take one after the other", hint=hint)
    if replace and not offline:
        raise UsageError("--replace is for --offline: other loads add to what is there", hint="Leave one of them out.")
    if check and offline:
        raise UsageError(
            "--check has all videos in memory, --offline has not", hint="Play them first: --check --dry-run."
        )


def _import(
    files: Sequence[Path],
    report: Path | None,
    bad_tolerance: int | None,
    recipes: Sequence[Path],
    *,
    replace: bool,
    quiet: bool,
) -> dict[str, int]:
    """Import ``files`` and ``recipes`` offline; what is odd is told when all are read, before anything is imported."""
    from foon_kg.cli.files_read import FilesRead, Gathered
    from foon_kg.cli.runs import counting
    from foon_kg.foon import ThisMachine
    from foon_kg.loaders import read_paths

    say, gathered, read = sayer(quiet=quiet), Gathered(), list[FilesRead]()

    def subgraphs() -> Iterator[Subgraph]:
        for result in read_paths(files):
            gathered.add(result)
            if result.subgraph is not None:
                yield result.subgraph
        read.append(gathered.read())
        _tell(read[0], report, bad_tolerance, say)

    with load_recipes.beside(recipes, bad_tolerance, say, quiet=quiet) as (stage, counts):
        with counting("Reading videos", len(files), quiet=quiet) as advance:
            done = ThisMachine.import_offline(subgraphs(), replace=replace, say=say, told=advance, beside=stage)
        say("seconds: " + ", ".join(f"{part} {seconds}" for part, seconds in done.seconds.items()))
        return _counts(read[0], Counts(inserted=done.videos)) | counts


def _counts(read: FilesRead, loaded: Counts | None) -> dict[str, int]:
    counts = {"subgraphs": len(read.contents), "units": read.units, "rejected_units": read.rejected}
    return counts if loaded is None else {**asdict(loaded), **counts}
