"""``foon evaluate trees``: how many of anybody's task trees robot and cook accept."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, print_json, print_view, sayer
from foon_kg.cli.runs import progress_bar

if TYPE_CHECKING:
    from foon_kg.cli.tree_files import TreeDocument
    from foon_kg.evaluation.trees import TreesEvaluation
    from foon_kg.foon import Snapshot

EXAMPLES = examples(
    "foon evaluate trees plans.jsonl",
    "foon evaluate trees subgraphs/ --files subgraphs/",
    "foon evaluate trees theirs/*.txt ours.jsonl --json",
)


def trees(
    paths: Annotated[
        list[Path],
        typer.Argument(
            metavar="FILE|DIR...", help="Plan results (JSON, JSON Lines) or FOON text; - is standard input."
        ),
    ],
    files: Files = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Judge anybody's task trees: how many are accepted.

    The trees are plan results, videos that people recorded as FOON text, or the trees of other programs; a folder is
    read whole. Each is played in a kitchen as foon check does it, against the FOON of --files or of the database.

    Told by dish type: how many trees a robot can carry out (W1 to W5, K4), of how many a cook would serve what comes
    of them (K1 to K7), and how many both accept; then for each rule how many trees have a fatal finding, and how many
    have any. The dish type is that of the recipe, else that with which FOON text marks its goal. A plan result
    without a tree counts as not accepted. FOON text names no recipe, so rules about what was asked are not asked.
    """
    from foon_kg.cli.knowledge import whole_foon
    from foon_kg.cli.tree_files import read_all_trees

    say = sayer(quiet=quiet)
    documents = _judgeable(read_all_trees(paths, say), say)
    evaluation = _evaluated(documents, whole_foon(files, say), quiet=quiet)
    if as_json:
        print_json(evaluation.to_json())
    else:
        from foon_kg.formats.views.evaluation import trees_evaluation_view

        print_view(trees_evaluation_view(evaluation))


def _judgeable(documents: Sequence[TreeDocument], say: Say) -> list[TreeDocument]:
    """Leave out reference trees, of which neither robot nor cook is asked; say so, and what is odd about the files."""
    from foon_kg.loaders import summary
    from foon_kg.model.errors import ReadError

    notices = [notice for document in documents for notice in document.notices]
    if notices:
        say(f"{'; '.join(summary(notices))} in these files (foon check FILE lists them)")
    kept = [document for document in documents if document.tree.level is None]
    if len(kept) < len(documents):
        say(f"{len(documents) - len(kept)} reference trees are passed over: foon check asks what they promise")
    if not kept:
        raise ReadError("there is no tree to judge", hint="Give plan results (JSON) or FOON text.")
    return kept


def _evaluated(documents: Sequence[TreeDocument], snapshot: Snapshot, *, quiet: bool) -> TreesEvaluation:
    from foon_kg.foon import Foon

    given = ((document.where, document.dish_type, document.tree) for document in documents)
    return Foon(snapshot).evaluation.trees(
        given, shown=lambda figures: progress_bar(figures, "Judging trees", len(documents), quiet=quiet)
    )
