"""A recipe as a text: which of its lines name ingredients, and which say what to do.

A heading tells them apart; without one, the lines at the top that begin with an amount are the ingredients.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

from foon_kg.food import singular, tables
from foon_kg.food.lists import word_list
from foon_kg.language.recipe_lines import read_recipe_lines
from foon_kg.loaders.narrated import is_video_name
from foon_kg.loaders.notices import UnreadableFile
from foon_kg.loaders.paths import decode
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.model.narration import Mention, Narration, Sentence
from foon_kg.model.nodes import name_of_file
from foon_kg.model.regular_files import read_bytes

_BULLET = r"\s*(?:[-*\u2022]\s*)?"
_AMOUNT = re.compile(rf"{_BULLET}(?:\d+(?!\s*[.)\d]\s)|[¼½¾⅓⅔⅛]|\d)(?![.)]\s)")
_TITLE_AND_MORE, _LONGEST_TITLE = 2, 8  # lines, words
_STEP = re.compile(rf"{_BULLET}(?:step\s*)?\d+\s*[.):]\s", re.IGNORECASE)


class RecipeText(NamedTuple):
    """The two parts of a recipe, line by line."""

    ingredients: tuple[str, ...]
    instructions: tuple[str, ...]


def read_narration(path: Path, say: Callable[[str], object]) -> Narration:
    """Return the recipe in the text file at ``path``: its sentences, and the foods that it lists, with their states.

    Its name is the file's without the ending. Where the extra that reads lines of ingredients is not installed, ``say``
    hears it, and the recipe lists none. Raises :class:`~foon_kg.model.errors.ReadError` where nothing in the file says
    what to do, and :class:`~foon_kg.model.errors.UsageError` where no video could have its name.
    """
    if not is_video_name(name := name_of_file(path)):
        raise UsageError(f"{path}: a draft cannot be named after it", hint="Rename it: letters, digits, - and _.")
    parts = recipe_text(_lines(path))
    if not parts.instructions:
        raise ReadError(f"{path}: no words in it that say what to do", hint="A step a line, or running text.")
    try:
        listed = ingredients(parts.ingredients)
    except UsageError as missing:  # the instructions can be drafted all the same
        say(f"{path}: drafted without its list of ingredients: {missing} {missing.hint}")
        listed = ()
    sentences = tuple(map(Sentence, parts.instructions))
    return Narration(name, sentences=sentences, source=path.name, ingredients=listed)


def _lines(path: Path) -> tuple[str, ...]:
    """Return the lines of the file that have words, each with single spaces; raises ReadError where there are none."""
    try:
        lines = decode(read_bytes(path)).removeprefix("\ufeff").splitlines()
    except UnreadableFile as bad:
        raise ReadError(f"{path}:{bad.line or 1}: {bad.problem.message}", hint="Save it as UTF-8 text.") from None
    except OSError as error:
        raise ReadError(f"{path}: cannot be opened: {error.strerror}", hint="Check the path.") from error
    found = tuple(" ".join(line.split()) for line in lines if any(letter.isalpha() for letter in line))
    if not found:
        raise ReadError(f"{path}: no words in it", hint="A step a line, or running text.")
    return found


def recipe_text(lines: Sequence[str]) -> RecipeText:
    """Return the lines of ingredients and the lines of instructions; title and headings are neither.

    What else stands above a heading of ingredients is kept with the instructions, so that it is told where it gives
    nothing.

    >>> recipe_text(["2 eggs", "1 pinch of salt", "Beat the eggs."]).ingredients
    ('2 eggs', '1 pinch of salt')
    """
    lines = lines[1:] if _begins_with_a_title(lines) else lines
    heading = _place_of(lines, "headings of ingredients")
    start = 0 if heading is None else heading + 1
    end = None if heading is None else _place_of(lines, "headings of instructions", start)
    if end is None:
        after = range(start, len(lines))
        end = next((place for place in after if not _is_listed(lines, place, start)), len(lines))
    if heading is None and end == len(lines):  # nothing would be left to do
        end = 0
    return RecipeText(_without_headings(lines[start:end]), _without_headings([*lines[:start], *lines[end:]]))


def _place_of(lines: Sequence[str], headings: str, start: int = 0) -> int | None:
    """Return the place of the first line from ``start`` on that is one of these headings."""
    return next((place for place in range(start, len(lines)) if _is(lines[place], headings)), None)


def _begins_with_a_title(lines: Sequence[str]) -> bool:
    """Whether the first line is short and no sentence, where the text is written in sentences."""
    if len(lines) < _TITLE_AND_MORE or _names_an_amount(lines[0]) or _STEP.match(lines[0]):
        return False
    ends = [line.rstrip()[-1:] in ".!?;:" for line in (lines[0], lines[-1])]
    # one word can be a step ("Stir"), unless what is asked for follows at once
    is_list_next = _names_an_amount(lines[1]) or _is(lines[1], "headings of ingredients")
    least = 1 if is_list_next else _TITLE_AND_MORE
    short = least <= len(lines[0].split()) <= _LONGEST_TITLE
    name = singular(lines[0].strip(" -*"))
    return ends == [False, True] and short and (name in tables().dishes or not tables().foods.is_listed(name))


def _without_headings(lines: Iterable[str]) -> tuple[str, ...]:
    headings = ("headings of ingredients", "headings of instructions")
    return tuple(line for line in lines if not any(_is(line, heading) for heading in headings))


def ingredients(lines: Iterable[str]) -> tuple[Mention, ...]:
    """Return the foods that lines of ingredients ask for, with the states in which they do.

    Raises :class:`~foon_kg.model.errors.UsageError` where the extra that reads them is not installed.
    """
    read = read_recipe_lines(lines)
    return tuple(Mention(line.object, line.states) for line in read if line.object is not None)


def _names_an_amount(line: str) -> bool:
    return _AMOUNT.match(line) is not None and _STEP.match(line) is None


def _is_listed(lines: Sequence[str], place: int, start: int) -> bool:
    """Whether a line names an ingredient: with an amount, or behind one that does by a bare name ("salt")."""
    line = lines[place].strip(" -*\u2022")
    bare = place > start and line[-1:] not in ".!?;:" and tables().foods.is_listed(line.lower())
    return _names_an_amount(line) or bare


def _is(line: str, headings: str) -> bool:
    return line.strip(" :#*-.").lower() in word_list(headings)
