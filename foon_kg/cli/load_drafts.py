"""``foon load drafts``: bring drafts of recipes into the graph, apart from the annotated videos."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from foon_kg.cli.console import Json, Quiet, examples, messages, sayer
from foon_kg.cli.loading import DryRun, show_counts

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
    replaces what was there. foon remove draft:ID takes one out.
    """
    from rich.progress import Progress

    from foon_kg.loaders.lessons import lesson_of, read_drafted
    from foon_kg.store.graph.connection import Connection
    from foon_kg.store.graph.drafts import DraftsStored, load_drafts
    from foon_kg.store.server import connection_settings

    console = messages(quiet=quiet)
    with Progress(console=console, disable=not console.is_terminal, transient=True) as progress:
        task = progress.add_task("Reading", total=None)
        counts = {"drafts": 0, "left_out": 0}
        for drafted in read_drafted(paths):  # to its end first: a file that is broken loads nothing
            counts["drafts"] += 1
            counts["left_out"] += lesson_of(drafted) is None
            progress.advance(task)
        if not dry_run:
            progress.update(task, description="Loading", total=counts["drafts"], completed=0)

            def stored(report: DraftsStored) -> None:
                progress.advance(task, len(report))

            with Connection(connection_settings(sayer(quiet=quiet))) as connection:
                counts = asdict(load_drafts(connection, read_drafted(paths), stored=stored))
    show_counts(counts, as_json=as_json)
