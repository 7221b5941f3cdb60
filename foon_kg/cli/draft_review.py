"""``foon draft review``: a person decides what is doubtful about drafts, or looks at all of it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, sayer
from foon_kg.cli.streams import data
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.model.drafts import DraftFile
    from foon_kg.plans.difference import VideoDifference

EXAMPLES = examples(
    "foon draft review drafts/P01_01.csv",
    "foon draft review drafts/*.csv --worst-first",
    "foon draft review drafts.jsonl.zst --recipe 000018c8a5",
)
Drafts = Annotated[
    list[Path], typer.Argument(metavar="FILE...", help="Drafts (.csv), or one file of foon draft recipes.")
]


def review(
    paths: Drafts,
    *,
    show: Annotated[bool, typer.Option("--show", help="Show all units, and ask nothing.")] = False,
    worst_first: Annotated[
        bool, typer.Option("--worst-first", help="Show all units, the least sure first, and ask nothing.")
    ] = False,
    recipe: Annotated[
        str | None, typer.Option("--recipe", metavar="ID", help="Of a file of foon draft recipes: this recipe's draft.")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", metavar="FILE", help="Write what is decided here, not beside the draft."),
    ] = None,
    files: Files = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Decide what is doubtful about drafts, or show it.

    At a terminal it asks about the rows that matter, and only those: doubts of the least sure units, what was not
    understood, inputs that nobody makes and no kitchen has, words that no table knows. Each stands beside
    what was said and when. Enter accepts, e edits, d leaves the row out; the draft keeps every decision, so q leaves
    and the same command goes on. When all is decided, FOON text is written that foon load foon takes. A plain table of
    a video (foon load videos) can be reviewed so, too.

    Elsewhere, and with --show, --worst-first or --json, it shows each row with its line, its confidence, the unit, and
    what was said. "?" is a doubt; "!" an input that no earlier row makes and no kitchen has. Then what the draft would
    change in the FOON. Edit the table in any editor: mend a row and empty its doubt, or delete it.
    """
    from foon_kg.cli.draft_session import draft_of_recipe, is_in_person, review_in_person

    _one_draft(paths, recipe, output)
    if recipe is not None:
        paths = [draft_of_recipe(paths[0], recipe)]
    if is_in_person() and not (show or worst_first or as_json):
        for path in paths:
            if not review_in_person(path, output):
                return
        return
    _show_drafts(paths, files, worst_first=worst_first, as_json=as_json, quiet=quiet)


def _one_draft(paths: Sequence[Path], recipe: str | None, output: Path | None) -> None:
    option = "--recipe" if recipe is not None else "--output"
    if len(paths) > 1 and (recipe is not None or output is not None):
        raise UsageError(f"{option} is for one draft, and these are {len(paths)}", hint="Review them one by one.")


def _show_drafts(
    paths: Sequence[Path], files: Sequence[Path] | None, *, worst_first: bool, as_json: bool, quiet: bool
) -> None:
    from foon_kg.foon import Drafting
    from foon_kg.formats.views.difference import difference_json, difference_view
    from foon_kg.formats.views.draft import draft_json, draft_view
    from foon_kg.loaders.draft_tables import read_draft

    drafts = [read_draft(path) for path in paths]
    found = {one.name: one for one in _differences(drafts, files, sayer(quiet=quiet))}
    answers = []
    for draft in drafts:
        gaps = Drafting.missing(draft)
        change = found[draft.subgraph.name] if draft.subgraph else None
        if as_json:
            answers.append(draft_json(draft, gaps) | {"difference": difference_json(change) if change else None})
            continue
        data().print(draft_view(draft, gaps, worst_first=worst_first), soft_wrap=True)
        if change is not None:
            data().print(difference_view(change, units=False), soft_wrap=True)
    if as_json:
        print_json(answers)


def _differences(drafts: Sequence[DraftFile], files: Sequence[Path] | None, say: Say) -> Sequence[VideoDifference]:
    """Return what loading ``drafts`` would change in the FOON of ``files``, else in the graph."""
    from foon_kg.cli.knowledge import front_door

    with front_door(files, say) as foon:
        return foon.differences([draft.subgraph for draft in drafts if draft.subgraph is not None])
