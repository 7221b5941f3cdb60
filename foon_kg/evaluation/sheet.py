"""A sheet on which people score progress lines: written to be filled, and read back.

CSV, UTF-8, one line an ingredient: ``recipe, dish_type, ingredient, state, progress_line, score``. The rule's own
score is not on it, so that nobody copies it.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from foon_kg.evaluation.agreement import Agreement, agreement
from foon_kg.evaluation.figures import RecipeFigures
from foon_kg.model.cells import as_cell, from_cell
from foon_kg.model.errors import ReadError
from foon_kg.model.regular_files import read_text
from foon_kg.plans.progress import ProgressLine, ProgressStep

COLUMNS = ("recipe", "dish_type", "ingredient", "state", "progress_line", "score")
_KEY = COLUMNS[:4]
_SCORES = {"0": 0, "1": 1, "2": 2}

LineKey = tuple[str, ...]
"""What tells one line from all others: recipe, dish type, ingredient and state."""


@dataclass(frozen=True)
class FilledSheet:
    """The scores that people gave, how many lines they left open, and the file that they filled."""

    scores: Mapping[LineKey, int]
    left_open: int
    path: Path

    def agreement_with(self, recipes: Sequence[RecipeFigures]) -> Agreement:
        """Return how well these people and the rule that scored ``recipes`` agree.

        Raises :class:`~foon_kg.model.errors.ReadError` for a line that ``recipes`` do not have.
        """
        return agreement(*scored_by_both(recipes, self))


def write_sheet(recipes: Iterable[RecipeFigures]) -> str:
    """Return the text of a sheet with every line of every tree of ``recipes``, its score left open."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(COLUMNS)
    for recipe in recipes:
        for scored in recipe.scores:
            if scored.line is not None:
                wanted = scored.ingredient
                named = line_key(recipe, wanted.object, wanted.state)
                rows.writerow([*map(as_cell, (*named, line_in_words(scored.line))), ""])
    return text.getvalue()


def read_sheet(path: Path) -> FilledSheet:
    """Return the sheet at ``path`` that people filled; columns may be moved and added, lines left out or left open.

    Raises :class:`~foon_kg.model.errors.ReadError` with file and line for what is no such sheet, a column that is
    missing, a score other than 0, 1 and 2, a line that is there twice, and a sheet on which nothing is scored.
    """
    scores: dict[LineKey, int] = {}
    left_open = 0
    for number, row in _rows(path):
        key, score = tuple(from_cell(row[name]) for name in _KEY), row["score"].strip()
        if not score:
            left_open += 1
            continue
        if score not in _SCORES:
            raise ReadError(f"{path}:{number}: “{score}” is no score", hint="Write 0, 1 or 2, or leave it open.")
        if key in scores:
            raise ReadError(f"{path}:{number}: {_named(key)} is scored twice", hint="Take one of the lines away.")
        scores[key] = _SCORES[score]
    if not scores:
        raise ReadError(f"{path}: nothing is scored", hint="Fill the column “score” with 0, 1 or 2.")
    return FilledSheet(scores, left_open, path)


def scored_by_both(recipes: Sequence[RecipeFigures], sheet: FilledSheet) -> tuple[list[int], list[int]]:
    """Return the rule's and the people's scores of the lines on ``sheet``, in the order of ``recipes``.

    Raises :class:`~foon_kg.model.errors.ReadError` where the sheet scores a line that this evaluation does not have.
    """
    ours = {
        line_key(recipe, scored.ingredient.object, scored.ingredient.state): scored.score
        for recipe in recipes
        for scored in recipe.scores
    }
    for key in sheet.scores:
        if key not in ours:
            raise ReadError(
                f"{sheet.path}: {_named(key)} is not in this evaluation",
                hint="Evaluate the recipes for which the sheet was written.",
            )
    both = [key for key in ours if key in sheet.scores]
    return [ours[key] for key in both], [sheet.scores[key] for key in both]


def line_key(recipe: RecipeFigures, food: str, state: str) -> LineKey:
    """Return what names a line on the sheet: the recipe, and the ``food`` with the ``state`` that it asks for."""
    return recipe.name, recipe.recipe.dish_type, food, state


def line_in_words(line: ProgressLine) -> str:
    """Return a progress line as a person reads it; an empty one does not get to the dish."""
    if not line.steps:
        return "(does not get to the dish)"
    steps = (f"{_stage(step)} → {step.motion}" for step in line.steps)
    return " → ".join([*steps, line.end_product or ""])


def _stage(step: ProgressStep) -> str:
    what = [*([", ".join(step.states)] if step.states else []), *([step.object] if step.object else [])]
    place = [f"{step.relation or 'at'} {step.container}"] if step.container else []
    return " ".join([*what, *place]) or "(as it is)"


def _rows(path: Path) -> Iterable[tuple[int, dict[str, str]]]:
    """Return each line of the sheet with its number in the file."""
    try:
        text = read_text(path)
    except UnicodeDecodeError as error:
        raise ReadError(f"{path}: not UTF-8 text (byte {error.start})", hint="Save it as CSV in UTF-8.") from error
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror}", hint="--scores names a sheet that --scores-to wrote.") from error
    reader = csv.DictReader(io.StringIO(text, newline=""), restval="", strict=True)
    rows = []
    try:
        missing = [name for name in (*_KEY, "score") if name not in (reader.fieldnames or ())]
        if missing:
            raise ReadError(
                f"{path}:1: the column “{missing[0]}” is missing",
                hint=f"Keep the first line as it was written: {','.join(COLUMNS)}",
            )
        for row in reader:
            if None in row:
                raise ReadError(f"{path}:{reader.line_num}: more values than columns", hint="Quote values with commas.")
            rows.append((reader.line_num, row))
    except csv.Error as error:
        raise ReadError(f"{path}:{reader.line_num}: not CSV: {error}", hint="Save it as CSV with commas.") from error
    return rows


def _named(key: LineKey) -> str:
    return f"{key[0]}: {key[2]}, {key[3]}"
