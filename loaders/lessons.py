"""What drafted recipes teach: the lines that ``foon draft recipes`` writes, and the units of their tables."""

from __future__ import annotations

import gzip
import json
import zlib
from collections.abc import Iterable, Iterator
from contextlib import AbstractContextManager
from dataclasses import replace
from io import TextIOWrapper
from pathlib import Path
from typing import TextIO

from foon_kg.loaders.csv_table import table_rows
from foon_kg.loaders.video_tables import read_video_text
from foon_kg.model import FunctionalUnit, Subgraph
from foon_kg.model.drafted import DraftedRecipe, Lesson
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.model.regular_files import open_regular

ENDINGS = (".jsonl", ".jsonl.gz", ".jsonl.zst")
LONGEST_LINE = 16_000_000
"""More characters than a draft has."""


def is_drafts_file(path: Path) -> bool:
    """Whether a path ends as the files of drafted recipes do."""
    return path.name.lower().endswith(ENDINGS) and not path.is_dir()


def read_drafted(paths: Iterable[Path]) -> Iterator[DraftedRecipe]:
    """Yield the drafted recipes of the files ``paths``, in their order, those that could not be drafted too.

    Raises :class:`~foon_kg.model.errors.ReadError` with the line for what is none.
    """
    for path in paths:
        if not path.exists():
            raise UsageError(f"there is no file {path}", hint="Check the path.")
        if not is_drafts_file(path):
            raise UsageError(f"{path}: no drafts of recipes", hint=f"Their files end in {', '.join(ENDINGS)}.")
        yield from _read(path)


def _read(path: Path) -> Iterator[DraftedRecipe]:
    number = 1
    try:
        with _open(path) as stream:
            while line := stream.readline(LONGEST_LINE):
                yield DraftedRecipe.from_json(json.loads(line), f"{path}:{number}")
                number += 1
    except _wrong_in(path) as error:
        hint = "foon draft recipes writes such files, and goes on where one was left."
        raise ReadError(f"{path}:{number}: it holds no draft of a recipe: {error}", hint=hint) from error
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror or error}", hint="Check the path.") from error


def _wrong_in(path: Path) -> tuple[type[Exception], ...]:
    """Return what is raised of a file that holds no drafts, or whose compression is broken."""
    if path.suffix != ".zst":
        return ValueError, EOFError, RecursionError, zlib.error
    import zstandard  # noqa: PLC0415 - an extra

    return ValueError, EOFError, RecursionError, zstandard.ZstdError


def _open(path: Path) -> AbstractContextManager[TextIO]:
    raw = open_regular(path)
    if path.suffix == ".gz":
        return TextIOWrapper(gzip.GzipFile(fileobj=raw), encoding="utf-8")
    if path.suffix == ".zst":
        import zstandard  # noqa: PLC0415 - an extra

        return TextIOWrapper(zstandard.ZstdDecompressor().stream_reader(raw, read_across_frames=True), encoding="utf-8")
    return TextIOWrapper(raw, encoding="utf-8")


def lesson_of(drafted: DraftedRecipe) -> Lesson | None:
    """Return what a ``drafted`` recipe teaches; ``None`` for no unit, or none that makes a dish of a known type."""
    if not drafted.table or not drafted.dish_type:
        return None
    (result,) = read_video_text(drafted.table, drafted.name)
    if result.subgraph is None or not _makes_a_dish(unit.unit for unit in result.subgraph.annotations):
        return None
    source = next((row.cells.get("source", "") for row in table_rows(drafted.table)), "")
    subgraph = replace(result.subgraph, sources=(source,) if source else ())
    return Lesson(subgraph, drafted.dish_type, drafted.confidence, drafted.title)


def lessons_of(drafted: Iterable[DraftedRecipe]) -> tuple[Lesson, ...]:
    """Return what ``drafted`` recipes teach, sorted by name; of two drafts of one recipe the last counts."""
    found = {one.name: lesson_of(one) for one in drafted}
    return tuple(lesson for _, lesson in sorted(found.items()) if lesson is not None)


def _makes_a_dish(units: Iterable[FunctionalUnit]) -> bool:
    return any(output.dish_type for unit in units for output in unit.outputs)


def subgraphs_of(lessons: Iterable[Lesson]) -> tuple[Subgraph, ...]:
    """Return the units of lessons."""
    return tuple(lesson.subgraph for lesson in lessons)
