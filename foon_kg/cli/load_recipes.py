"""``foon load recipes``: bring collections of recipes into the graph."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from enum import StrEnum
from io import TextIOWrapper
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TextIO

import typer

from foon_kg.cli.console import Json, Quiet, Say, examples, sayer
from foon_kg.cli.loading import (
    UNWRITTEN,
    BadTolerance,
    DryRun,
    Report,
    refuse_too_many,
    show_counts,
    tell_assumed,
    tell_unknown,
    unknown_notice,
    where_listed,
)
from foon_kg.model.written_files import open_to_write, writing

if TYPE_CHECKING:
    from foon_kg.cli.files_read import Where
    from foon_kg.food.unknown import UnknownWord
    from foon_kg.loaders.notices import Notice
    from foon_kg.loaders.recipe_collections import RecipeCollections
    from foon_kg.model.collected import UnderstoodRecipe
    from foon_kg.store.graph.recipes import RecipesStored
    from foon_kg.store.offline.staged import Staged

EXAMPLES = examples(
    "foon load recipes recipe1m/",
    "foon load recipes recipes.csv --report notices.jsonl",
    "foon load recipes recipe1m/ --parse full",
)
_SHOWN = 10
"""So many recipes are told one by one; a report has them all."""


class Parse(StrEnum):
    """How the lines of ingredients are read."""

    QUICK = "quick"
    FULL = "full"


def recipes(
    paths: Annotated[
        list[Path],
        typer.Argument(metavar="PATH...", help="Folders with a layer1.json, or .json, .jsonl, .csv, .parquet files."),
    ],
    *,
    parse: Annotated[
        Parse, typer.Option(help="quick: the full parser only where the collection names no food itself.")
    ] = Parse.QUICK,
    report: Report = None,
    bad_tolerance: BadTolerance = None,
    dry_run: DryRun = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Load collections: Recipe1M+, CSV, Parquet.

    A folder with a layer1.json is Recipe1M+; det_ingrs.json and recipes_with_nutritional_info.json are read with it if
    they lie beside. Tables and our own recipe files are read by their endings.

    Every file is read to its end first: one that is broken loads nothing. Then the recipes come in many transactions of
    whole recipes each; a load that was stopped goes on where it was when it is started again, and what is there already
    changes nothing. Recipes of one id are there once.
    """
    from foon_kg.cli import data_frames
    from foon_kg.loaders.recipe_collections import RecipeCollections

    data_frames.allow()  # CSV and Parquet are read by them
    say = sayer(quiet=quiet)
    with _journal(report) as journal, RecipeCollections(paths, journal.note) as collections:
        counts = _usable(collections, paths, journal, bad_tolerance, say, quiet=quiet)
        usable = counts["recipes"]
        if not dry_run:
            stored = _load(collections, usable, journal, say, full=parse is Parse.FULL, quiet=quiet)
            counts = _counts(stored) | counts
        journal.tell_left_over(say)
        journal.tell_unknown(say)
    show_counts(counts, as_json=as_json)


class Journal:
    """Counts what is odd about a collection, and writes all of it to ``report`` at once: a million may be odd."""

    def __init__(self, stream: TextIO | None, report: Path | None) -> None:
        self._stream = stream
        self._report = report
        self._rejected: list[Notice] = []
        self._assumed: list[Notice] = []
        self._asked: dict[tuple[str, str], str] = {}
        self.rejected = 0
        self.assumed = 0
        self.left_over = 0

    def note(self, notice: Notice) -> None:
        """Take one notice down."""
        from foon_kg.loaders import Severity

        self._write(notice.to_json())
        if notice.severity is Severity.REJECTED:
            self.rejected += 1
            first = self._rejected
        else:
            self.assumed += 1
            first = self._assumed
        if len(first) < _SHOWN:
            first.append(notice)

    def note_left_over(self, understood: UnderstoodRecipe) -> None:
        """Take down the lines of an ``understood`` recipe in which no food was found."""
        place = understood.recipe.place
        for line in understood.left_over:
            self.left_over += 1
            self._write({"file": place, "kind": "no-food", "message": line, "action": "kept as left over"})

    def note_words(self, understood: UnderstoodRecipe) -> None:
        """Take down which foods and states an ``understood`` recipe asks for, each once, with the first place."""
        for called in understood.ingredients:
            self._asked.setdefault((called.object, called.state), understood.recipe.place)

    def tell(self, say: Say) -> None:
        """Say what is odd: the first rejected recipes one by one, the rest in numbers."""
        for notice in self._rejected:
            say(str(notice))
        if more := self.rejected - len(self._rejected):
            say(f"{more} recipes more were rejected ({where_listed(self._report)})")
        tell_assumed(self._assumed, self.assumed, self._report, say)

    def tell_left_over(self, say: Say) -> None:
        """Say how many lines name no food."""
        if self.left_over:
            say(f"{self.left_over} lines name no food that could be read ({where_listed(self._report)})")

    def tell_unknown(self, say: Say) -> None:
        """Say which of the words that the recipes ask for no table has."""
        from foon_kg.food.unknown import unknown_words
        from foon_kg.model import ObjectNode

        found: dict[UnknownWord, Where] = {}
        for (food, state), place in self._asked.items():
            for word in unknown_words([ObjectNode(food, (state,) if state else ())]):
                found.setdefault(word, (place, None))
        for word, where in found.items():
            self._write(unknown_notice(word, *where).to_json())
        tell_unknown(dict(sorted(found.items())), self._report, say)

    def _write(self, entry: dict[str, object]) -> None:
        if self._stream and self._report:
            with writing(self._report, UNWRITTEN):
                self._stream.write(json.dumps(entry, ensure_ascii=True) + "\n")


@contextmanager
def _journal(report: Path | None) -> Iterator[Journal]:
    if report is None:
        yield Journal(None, None)
        return
    with writing(report, UNWRITTEN):
        stream = TextIOWrapper(open_to_write(report), encoding="utf-8")
    try:
        yield Journal(stream, report)
    finally:
        with writing(report, UNWRITTEN):
            stream.close()


@contextmanager
def beside(
    paths: Sequence[Path], bad_tolerance: int | None, say: Say, *, quiet: bool
) -> Iterator[tuple[Callable[[Staged], None] | None, dict[str, int]]]:
    """Yield what stages the recipes of ``paths`` for an import (``None`` without paths), and counts that it fills.

    ``bad_tolerance`` is how many recipes may be rejected, ``None`` for one in a hundred. What is odd goes to ``say``;
    with ``quiet`` no progress is shown.
    """
    if not paths:
        yield None, {}
        return
    from foon_kg.cli import data_frames
    from foon_kg.cli.runs import counting
    from foon_kg.loaders.recipe_collections import RecipeCollections

    data_frames.allow()  # as above
    with _journal(None) as journal, RecipeCollections(paths, journal.note) as collections:
        counts = _usable(collections, paths, journal, bad_tolerance, say, quiet=quiet)

        def stage(staged: Staged) -> None:
            from foon_kg.foon import Recipes

            with counting("Reading recipes", counts["recipes"], quiet=quiet) as advance:
                stored = Recipes.stage(
                    staged,
                    collections,
                    stored=lambda done: advance(len(done)),
                    understood=journal.note_words,
                    left_over=journal.note_left_over,
                )
            counts["inserted_recipes"] = stored.inserted

        yield stage, counts
        journal.tell_left_over(say)
        journal.tell_unknown(say)


def _usable(
    collections: RecipeCollections,
    paths: Sequence[Path],
    journal: Journal,
    bad_tolerance: int | None,
    say: Say,
    *,
    quiet: bool,
) -> dict[str, int]:
    """Read collections to their end, tell what is odd, and return how many recipes can be used."""
    usable = _check(collections, quiet=quiet)
    journal.tell(say)
    _refuse_nothing(paths, usable + journal.rejected)
    refuse_too_many(journal.rejected, usable, bad_tolerance, "recipe")
    return {"recipes": usable, "rejected_recipes": journal.rejected}


def _check(collections: RecipeCollections, *, quiet: bool) -> int:
    """Read all files to their end; how many recipes there are is not known before."""
    from foon_kg.cli.runs import counting

    with counting("Reading recipes", quiet=quiet) as advance:
        return collections.check(lambda: advance(1))


def _refuse_nothing(paths: Sequence[Path], count: int) -> None:
    from foon_kg.model.errors import UsageError

    if not count:
        hint = "A collection is a JSON list of recipes, or a table with one recipe a row."
        raise UsageError(f"there is no recipe in {', '.join(map(str, paths))}", hint=hint)


def _load(
    collections: RecipeCollections,
    total: int,
    journal: Journal,
    say: Say,
    *,
    full: bool,
    quiet: bool,
) -> RecipesStored:
    from foon_kg.cli.runs import counting
    from foon_kg.foon import Foon

    with Foon.connect(say=say) as foon, counting("Loading recipes", total, quiet=quiet) as advance:
        return foon.recipes.store(
            collections,
            full=full,
            stored=lambda report: advance(len(report)),
            understood=journal.note_words,
            left_over=journal.note_left_over,
        )


def _counts(stored: RecipesStored) -> dict[str, int]:
    return {
        "inserted": stored.inserted,
        "unchanged": stored.unchanged,
        "replaced": stored.replaced,
        "foods": stored.foods,
        "left_over": stored.left_over,
    }
