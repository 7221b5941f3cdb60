"""Which of the 30 dish classes a recipe belongs to, by the words of its title (``dish-classes.txt``).

English names a dish by its last noun: a chicken noodle soup is a soup, and chicken and noodle say what kind. What comes
after ``with``, ``in`` or a comma stands beside the dish. So of all classes that a title names, the last one of its main
part is sure, and the others are possible.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from importlib.resources import files

from foon_kg.food.words import singular_word
from foon_kg.model import DISH_TYPES
from foon_kg.model.collected import DishClass
from foon_kg.model.names import without_accents

_NO_CLASS = "!"
_BESIDE = re.compile(
    r"(?:^|\s)(?:with|in|on|over|for|from|using|w/|served|topped|stuffed with|a la)\s"
    r"|[,:;(\[/|]| - |\u2013|\u2014"  # the last two are dashes
)
_WORD = re.compile(r"[a-z0-9']+|&")


def dish_classes(title: str) -> tuple[DishClass, ...]:
    """Return the classes that ``title`` names: the sure one first, the others in their order in the title.

    A title without any word of a class has none; one that names classes only beside the dish has no sure one.
    """
    text = without_accents(title.lower().replace("\u2019", "'"))
    beside = _BESIDE.search(text)
    main = list(_named(text[: beside.start()] if beside else text))
    further = list(_named(text[beside.start() :])) if beside else []
    sure = main[-1] if main else ()
    names = dict.fromkeys((*sure, *(name for classes in (*main, *further) for name in classes)))
    return tuple(DishClass(name, sure=name in sure[:1]) for name in names)


def _named(text: str) -> Iterator[tuple[str, ...]]:
    """Yield the classes of each of the longest known phrases in ``text``, from left to right."""
    phrases, longest = _phrases()
    words = [singular_word(word) for word in _WORD.findall(text.replace("-", " "))]
    place = 0
    while place < len(words):
        ends = range(min(len(words), place + longest), place, -1)
        end = next((end for end in ends if " ".join(words[place:end]) in phrases), None)
        if end is not None and (classes := phrases[" ".join(words[place:end])]):
            yield classes
        place = end or place + 1


@cache
def _phrases() -> tuple[dict[str, tuple[str, ...]], int]:
    """Return the classes of each phrase, in the order of the file, and the number of words of the longest.

    A phrase of no class has none: "cake mix" hides the cake in it.
    """
    phrases: dict[str, tuple[str, ...]] = {}
    for line in files("foon_kg.food").joinpath("dish-classes.txt").read_text(encoding="utf-8").splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        name, listed = (_NO_CLASS, line[1:]) if line.startswith(_NO_CLASS) else _entry(line)
        for phrase in listed.split(","):
            key = " ".join(map(singular_word, _WORD.findall(phrase.replace("-", " "))))
            known = phrases.get(key, ())
            phrases[key] = known if name == _NO_CLASS else (*known, name)
    return phrases, max(len(key.split()) for key in phrases)


def _entry(line: str) -> tuple[str, str]:
    """Return the class of a ``line`` of the table and the phrases that name it; raises ValueError for no class."""
    name, colon, listed = line.partition(":")
    if not colon or name not in DISH_TYPES:
        raise ValueError(f"dish-classes.txt: “{name}” is none of the dish classes: {', '.join(DISH_TYPES)}")
    return name, listed
