"""``foon draft recipes``: the instructions of a collection drafted into a file, on all cores, and gone on with."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.blocks import adding, form_of, whole_blocks
from foon_kg.cli.console import Files, Json, Quiet, Say, examples, json_line, print_json, sayer, where_said
from foon_kg.cli.runs import progress_bar
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.model.collected import CollectedRecipe
    from foon_kg.model.drafted import DraftedRecipe

EXAMPLES = examples(
    "foon draft recipes recipe1m/ --output drafts.jsonl.zst",
    "foon draft recipes recipes.json -o drafts.jsonl --files subgraphs/ --jobs 2",
)
_NAMED = 5
"""So many recipes that cannot be drafted are named; the lines of the file say it of each."""


def recipes(
    paths: Annotated[
        list[Path],
        typer.Argument(metavar="PATH...", help="Folders with a layer1.json, or .json, .jsonl, .csv, .parquet files."),
    ],
    *,
    output: Annotated[
        Path,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="Write a draft a line (.jsonl, .jsonl.gz, .jsonl.zst), and go on there.",
        ),
    ] = Path("drafts.jsonl"),
    jobs: Annotated[
        int | None, typer.Option("--jobs", "-j", metavar="N", min=1, help="Draft in N processes; as a rule all cores.")
    ] = None,
    files: Files = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Draft a collection of recipes from their instructions.

    Each recipe becomes a line: its draft as a table with confidences and doubts, or why there is none. Nobody has
    reviewed these drafts. foon load drafts brings them into the graph, apart from the annotated videos, and they count
    only where foon plan --with-drafts asks for them. foon draft review FILE --recipe ID turns one into a subgraph.

    A run that was stopped, started again with the same command, drafts only what is still missing. Sentences are read
    by spaCy's parser (pip install 'foon-kg[text]').
    """
    _check_name(output)
    say = sayer(quiet=quiet)
    tally = _drafted(paths, output, files, say, jobs=jobs, quiet=quiet)
    tally.tell(say)
    if as_json:
        print_json(tally.to_json(output))
    else:
        typer.echo(f"{output}: {tally.recipes} recipes, {tally.drafts} of them drafted with {tally.units} units")


def _check_name(output: Path) -> None:
    """Raise UsageError where drafts cannot go into such a file, ModuleNotFoundError where what it needs is missing."""
    from foon_kg.loaders.lessons import ENDINGS, is_drafts_file

    if not is_drafts_file(output):
        raise UsageError(
            f"{output}: drafts of recipes go into one file", hint=f"Its name ends in {', '.join(ENDINGS)}."
        )
    form_of(output)  # what it needs is missing now, and not when all is drafted


def _drafted(
    paths: Sequence[Path], output: Path, files: Sequence[Path] | None, say: Say, *, jobs: int | None, quiet: bool
) -> _Tally:
    """Draft the recipes at ``paths`` that are not in ``output`` yet into it; return what was drafted of all of them."""
    from foon_kg.cli import data_frames
    from foon_kg.cli.knowledge import front_door
    from foon_kg.loaders.recipe_collections import RecipeCollections

    data_frames.allow()
    with RecipeCollections(paths, lambda notice: say(str(notice))) as collections:
        total = collections.check()
        if not total:
            raise UsageError("there is no recipe to draft", hint=where_said(quiet=quiet))
        size, tally = _done(output, collections, total)
        if tally.recipes:
            say(f"{output} has {tally.recipes} of {total} drafts already")
        if tally.recipes == total:
            return tally
        left = islice(collections, tally.recipes, None)
        with (
            front_door(files, say) as foon,
            foon.drafting.of_recipes(left, jobs=jobs) as drafted,
            adding(output, size) as add,
        ):
            for one in progress_bar(drafted, "Drafting recipes", total, tally.recipes, quiet=quiet):
                add(json_line(one.to_json()))
                tally.add(one)
    return tally


@dataclass
class _Tally:
    """What was drafted so far, and the first recipes that could not be."""

    recipes: int = 0
    drafts: int = 0
    units: int = 0
    problems: tuple[str, ...] = ()

    def add(self, drafted: DraftedRecipe) -> None:
        """Count one recipe."""
        self.recipes += 1
        self.drafts += bool(drafted.units)
        self.units += drafted.units
        if drafted.problem and len(self.problems) < _NAMED:
            self.problems = (*self.problems, f"{drafted.id}: {drafted.problem}")

    def tell(self, say: Say) -> None:
        """Say which recipes could not be drafted, the first of them."""
        for problem in self.problems:
            say(problem)
        if more := self.recipes - self.drafts - len(self.problems):
            say(f"{more} recipes more could not be drafted; their lines say why")

    def to_json(self, output: Path) -> dict[str, object]:
        """Return the counts."""
        return {"file": str(output), "recipes": self.recipes, "drafts": self.drafts, "units": self.units}


def _done(output: Path, collections: Iterable[CollectedRecipe], total: int) -> tuple[int, _Tally]:
    """Return how many bytes of a file stay, and what they hold.

    Raises UsageError where it is of other recipes.
    """
    size, counted, ids = 0, _Tally(), iter(collections)
    for lines, end in _blocks(output, total):
        for drafted in lines:
            recipe = next(ids, None)
            if recipe is None or recipe.id != drafted.id:
                raise UsageError(
                    f"{output}:{counted.recipes + 1}: this is the draft of another recipe than this command drafts",
                    hint="Name another file, or take this one away to begin anew.",
                )
            counted.add(drafted)
        size = end
    return size, counted


def _blocks(output: Path, total: int) -> Iterator[tuple[Sequence[DraftedRecipe], int]]:
    """Yield the drafts of each whole block of a file; a last one that is not full only where nothing is missing."""
    import json

    from foon_kg.model.drafted import DraftedRecipe

    there, full = 0, form_of(output).lines
    for content, end in whole_blocks(output):
        found = []
        for place, line in enumerate(content.splitlines(), there + 1):
            try:
                value = json.loads(line)
            except ValueError as error:
                hint = "Name another file, or take this one away to begin anew."
                raise UsageError(f"{output}:{place}: it holds something else than drafts", hint=hint) from error
            found.append(DraftedRecipe.from_json(value, f"{output}:{place}"))
        there += len(found)
        if len(found) == full or there >= total:
            yield found, end
