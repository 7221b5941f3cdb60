"""``foon load drafts``: bring drafts of recipes into the graph, apart from the annotated videos."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from foon_kg.cli.console import Json, Quiet, examples, sayer
from foon_kg.cli.loading import DryRun, show_counts
from foon_kg.model.errors import UsageError

EXAMPLES = examples("foon load drafts drafts.jsonl.zst", "foon load drafts drafts.jsonl --dry-run")


def drafts(
    paths: Annotated[
        list[Path],
        typer.Argument(metavar="FILE...", help="What foon draft recipes wrote (.jsonl, .gz, .zst)."),
    ],
    *,
    dry_run: DryRun = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Load drafts of recipes, apart from videos.

    Nobody has watched or reviewed them: they change no answer but those that ask for them (foon plan --with-drafts).
    Drafts that make no dish of a known type are left out. Loading one again changes nothing; with other content it
    replaces what was there, and goes where it now makes no such dish. foon remove draft:ID takes one out. As JSON it is
    told how many were inserted, replaced, unchanged and left out; with --dry-run only how many there are to load and
    are left out.
    """
    from foon_kg.cli.runs import counting
    from foon_kg.foon import Foon
    from foon_kg.loaders.lessons import lesson_of, read_drafted

    counts = {"drafts": 0, "left_out": 0}
    with counting("Reading drafts", quiet=quiet) as advance:
        # to its end first, so that a file that is broken loads nothing; and again below, for it may be more than memory
        for drafted in read_drafted(paths):
            counts["left_out" if lesson_of(drafted) is None else "drafts"] += 1
            advance(1)
    if not any(counts.values()):
        named = ", ".join(map(str, paths))
        raise UsageError(f"there is no draft in {named}", hint="foon draft recipes PATH --output FILE writes them.")
    if not dry_run:
        with (
            Foon.connect(say=sayer(quiet=quiet)) as foon,
            counting("Loading drafts", sum(counts.values()), quiet=quiet) as advance,
        ):
            stored = foon.drafting.store(read_drafted(paths), stored=lambda report: advance(len(report)))
        counts = asdict(stored)
    show_counts(counts, as_json=as_json)
