"""Collections of recipes, whatever their files are: first read to their end, then answered one by one."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import AbstractContextManager, ExitStack
from pathlib import Path
from typing import Self

from foon_kg.loaders.notices import Notice, NoticeKind, Severity
from foon_kg.loaders.recipe1m import LAYER_1, Recipe1M, Tell
from foon_kg.loaders.recipe_tables import KNOWN_ENDINGS, read_rows
from foon_kg.loaders.text_blocks import half_character
from foon_kg.model import DISH_TYPES
from foon_kg.model.collected import LONGEST_ID, LONGEST_LINE, CollectedRecipe
from foon_kg.model.errors import UsageError


class RecipeCollections(AbstractContextManager["RecipeCollections"]):
    """The recipes that ``paths`` name: files, and folders with a ``layer1.json`` or with files of known endings.

    Use it in a ``with`` statement; :meth:`check` it before anything is written, then go through it. Of two recipes with
    one id the first counts. ``tell`` receives whatever is odd.
    """

    def __init__(self, paths: Iterable[Path], tell: Tell) -> None:
        self._paths = [file for path in paths for file in _files(path)]
        self._tell = tell
        self._open = ExitStack()
        self._recipe1m: dict[Path, Recipe1M] = {}

    def check(self, progress: Callable[[], None] = lambda: None) -> int:
        """Read every file to its end, tell whatever is odd, and return how many recipes can be used.

        ``progress`` is called at each. Raises ReadError where a file ends too early or is not what its name says,
        before anything has been written.
        """
        for collection in self._recipe1m.values():
            collection.read_beside(self._tell)
        count = 0
        for _ in self._recipes(self._tell):
            count += 1
            progress()
        return count

    def __iter__(self) -> Iterator[CollectedRecipe]:
        """Return the recipes in the order of ``paths``."""
        return self._recipes(lambda _: None)

    def _recipes(self, tell: Tell) -> Iterator[CollectedRecipe]:
        seen: set[str] = set()
        for path in self._paths:
            found = self._recipe1m[path].recipes(tell) if path in self._recipe1m else read_rows(path, tell)
            for recipe in found:
                if problem := _problem(recipe, seen):
                    tell(Notice(recipe.place, None, *problem, "recipe rejected", Severity.REJECTED))
                    continue
                seen.add(recipe.id)
                for oddity in _oddities(recipe):
                    tell(Notice(recipe.place, None, *oddity))
                yield recipe

    def __enter__(self) -> Self:
        for path in self._paths:
            if path.name == LAYER_1:
                self._recipe1m[path] = self._open.enter_context(Recipe1M(path))
        return self

    def __exit__(self, *_: object) -> None:
        self._open.close()


def _problem(recipe: CollectedRecipe, seen: Collection[str]) -> tuple[NoticeKind, str] | None:
    """Return why a recipe cannot be loaded, ``None`` where it can."""
    if len(recipe.id) > LONGEST_ID:
        return NoticeKind.ODD_NAME, f"its id has {len(recipe.id)} characters; {LONGEST_ID} are the most"
    if recipe.id in seen:
        return NoticeKind.SAME_RECIPE, f"a second recipe with the id “{recipe.id}”"
    said = (recipe.id, recipe.title, recipe.dish_type, recipe.partition, recipe.url)
    lines = (text for line in recipe.lines for text in (line.text, line.detected, line.state, line.unit))
    if half := half_character("".join(text for text in (*said, *lines) if text)):
        return NoticeKind.BAD_FIELD, f"half of a character in it ({half})"
    return None


def _oddities(recipe: CollectedRecipe) -> Iterator[tuple[NoticeKind, str, str]]:
    """Yield what is odd about a recipe that is loaded, each with what is done about it."""
    if recipe.dish_type is not None and recipe.dish_type not in DISH_TYPES:
        message = f"“{recipe.dish_type[:40]}” is none of the dish types"
        yield NoticeKind.ODD_CLASS, message, "its title says what dish it is"
    elif recipe.dish_type is None and not any(map(str.isalpha, recipe.title)):
        message = f"the title “{recipe.title[:40]}” has no words"
        yield NoticeKind.TITLE_WITHOUT_WORDS, message, "recipe kept without a dish type"
    for position, line in enumerate(recipe.lines):
        if not line.is_readable:
            message = f"ingredients[{position}] has more than {LONGEST_LINE} characters"
            yield NoticeKind.LONG_CELL, message, "kept as left over"


def _files(path: Path) -> list[Path]:
    if not path.exists():
        raise UsageError(f"{path}: no such file or folder", hint="Check the path.")
    if not path.is_dir():
        return [path]
    if (path / LAYER_1).exists():
        return [path / LAYER_1]
    found = sorted(file for file in path.rglob("*") if file.suffix.lower() in KNOWN_ENDINGS and file.is_file())
    if not found:
        endings = ", ".join(KNOWN_ENDINGS)
        raise UsageError(f"{path} has no recipes", hint=f"Looked for {LAYER_1} and for files ending in {endings}.")
    return found
