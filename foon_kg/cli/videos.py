"""``foon diff`` and ``foon remove``: what a video would bring to the FOON, and what goes with it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from foon_kg.cli.console import Files, Json, Quiet, examples, print_json, sayer, where_said
from foon_kg.cli.streams import data
from foon_kg.model.errors import ReadError, UsageError

if TYPE_CHECKING:
    from foon_kg.plans.difference import VideoDifference

DIFF_EXAMPLES = examples("foon diff new_salad.txt", "foon diff new_salad.csv --units", "foon diff subgraphs/ --json")
REMOVE_EXAMPLES = examples(
    "foon remove greek_salad --dry-run", "foon remove greek_salad garden_salad", "foon remove draft:000018c8a5"
)

Units = Annotated[bool, typer.Option("--units", help="Show every unit, not only how many.")]


def diff(
    paths: Annotated[
        list[Path], typer.Argument(metavar="PATH...", help="Subgraph files, plain tables of videos, or folders.")
    ],
    *,
    files: Files = None,
    units: Units = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Show what loading files would change in the FOON.

    Units that are new, known from other videos, as before, or gone; and objects never seen before. Words that no table
    has are told with what may be meant, a few by line and more in short; each rejected unit by line. Changes nothing.
    """
    from foon_kg.cli.files_read import odd_words
    from foon_kg.cli.knowledge import front_door
    from foon_kg.cli.loading import tell_unknown
    from foon_kg.loaders import Severity
    from foon_kg.loaders.video_tables import read_videos

    say = sayer(quiet=quiet)
    results = list(read_videos(paths))
    for result in results:
        for notice in result.notices:
            if notice.severity is Severity.REJECTED:
                say(str(notice))
    subgraphs = [result.subgraph for result in results if result.subgraph is not None]
    if not subgraphs:
        raise ReadError(f"no video in {', '.join(map(str, paths))}", hint=where_said(quiet=quiet))
    with front_door(files, say) as foon:
        tell_unknown(odd_words(results, foon.foods()), None, say)
        found = foon.differences(subgraphs)
    _show(found, units=units, as_json=as_json)


def remove(
    names: Annotated[
        list[str],
        typer.Argument(metavar="VIDEO...", help="Videos, by the names of their files; drafts as draft:ID."),
    ],
    *,
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Show what would go; change nothing.")] = False,
    units: Units = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Take videos out of the FOON, or drafts of recipes.

    With videos go the units that no other video shows. All of the named ones are taken out, or none. As JSON: an array
    with what changed of each video; of drafts an object that says how many.
    """
    from foon_kg.cli.knowledge import front_door
    from foon_kg.cli.loading import show_counts
    from foon_kg.model.drafted import is_draft

    chosen = list(dict.fromkeys(names))
    drafts = [name for name in chosen if is_draft(name)]
    videos = [name for name in chosen if not is_draft(name)]
    if drafts and (videos or units):
        _refuse_beside_drafts(videos)
    with front_door(None, sayer(quiet=quiet)) as foon:
        if drafts:
            foon.drafting.remove(drafts, dry_run=dry_run)
            show_counts({"drafts_to_go" if dry_run else "drafts_gone": len(drafts)}, as_json=as_json)
            return
        found = foon.remove(videos, dry_run=dry_run)
    _show(found, units=units, as_json=as_json)


def _refuse_beside_drafts(videos: Sequence[str]) -> NoReturn:
    """Raise UsageError: beside drafts no ``videos`` can be named, nor units be asked for."""
    what = "videos and drafts cannot be removed together" if videos else "the units of drafts are not shown here"
    raise UsageError(what, hint="Name drafts alone, without --units.")


def _show(found: Sequence[VideoDifference], *, units: bool, as_json: bool) -> None:
    from foon_kg.formats.views.difference import difference_json, difference_view

    if as_json:
        print_json([difference_json(one) for one in found])
        return
    for one in found:
        data().print(difference_view(one, units=units), soft_wrap=True)
    if len(found) > 1:
        typer.echo(_sum(found))


def _sum(found: Iterable[VideoDifference]) -> str:
    """Return how many distinct units come and go in all; two videos may bring the same one."""
    come = {unit.key for one in found for unit in one.added}
    gone = {unit.key for one in found for unit in one.dropped}
    return f"in all {len(come)} units new, {len(gone)} gone"
