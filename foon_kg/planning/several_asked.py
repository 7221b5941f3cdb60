"""Words that ask for several foods at once, or for so much of one: "chopped onion and 2 tomatoes", "500 g flour"."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from itertools import takewhile

from foon_kg.food import singular, tables
from foon_kg.food.lists import word_list
from foon_kg.food.words import without_part
from foon_kg.model import RequiredIngredient

_AND = re.compile(r"\s+(?:and|&)\s+", re.IGNORECASE)
_AND_OR_COMMA = re.compile(rf"\s*,\s*(?:and\s+|&\s+)?|{_AND.pattern}", re.IGNORECASE)

Read = Callable[[str], tuple[RequiredIngredient, tuple[str, ...]]]
"""What reads the words for one food: it returns what they ask for, with notes."""


def each_food(text: str) -> tuple[str, ...]:
    """Return the words for each food that ``text`` asks for: all of it, where it names one.

    The parts around "and" are several foods where each ends with one that the tables list and has no other in
    front of it; what has a name with "and" of its own is one.

    >>> each_food("400 g chopped onion and 2 tomatoes, diced"), each_food("salt and pepper")
    (('400 g chopped onion', '2 tomatoes, diced'), ('salt', 'pepper'))
    >>> each_food("salt, pepper and olive oil"), each_food("1 tsp onion and garlic powder")
    (('salt', 'pepper', 'olive oil'), ('1 tsp onion powder', 'garlic powder'))
    >>> each_food("1 cup half and half"), each_food("onion, peeled and chopped"), each_food("salt and pepper crackers")
    (('1 cup half and half',), ('onion, peeled and chopped',), ('salt and pepper crackers',))
    """
    if _AND.search(text) is None or _has_a_name_with_and(text):
        return (text,)
    apart = _parts(text)
    for parts in (_sharing_the_last_word(apart), apart):
        if len(parts) > 1 and all(map(_names_one, parts)):
            return parts
    return (text,)


def _parts(text: str) -> tuple[str, ...]:
    """Return what stands between commas and each "and", a part without a food together with the one before it."""
    found: list[str] = []
    begin = 0
    for between in (*_AND_OR_COMMA.finditer(text), None):
        end = len(text) if between is None else between.start()
        if found and not _names_one(text[begin:end].strip()):
            found[-1] = text[text.rindex(found[-1], 0, begin) : end].strip()  # "diced" of "tomatoes, diced"
        else:
            found.append(text[begin:end].strip())
        begin = len(text) if between is None else between.end()
    return tuple(part for part in found if part)


def _sharing_the_last_word(parts: tuple[str, ...]) -> tuple[str, ...]:
    """Return ``parts`` of which the first have the last word of the last, where that names foods: onion powder."""
    *others, last = parts
    _, *more = last.partition(",")[0].split()
    if not more:
        return parts
    shared = [f"{part} {more[-1]}" for part in others]
    are_listed = all(tables().foods.is_listed(f"{part.split()[-1]} {more[-1]}") for part in others)
    return (*shared, last) if others and are_listed else parts


def read_each(text: str, read: Read) -> list[tuple[RequiredIngredient, tuple[str, ...]]]:
    """Return what ``text`` asks for, food by food, each with the notes of ``read``; that they are several is noted.

    What ``text`` says they are for ("to serve") holds for all of them. Raises what ``read`` raises.
    """
    plain, part = without_part(text)
    parts = each_food(plain)
    if len(parts) == 1:
        return [read(text)]
    found = [read(one) for one in parts]
    told = f"“{text}” is read as {len(parts)} foods: {'; '.join(parts)}"
    return [
        (replace(wanted, part=wanted.part or part), notes if place else (told, *notes))
        for place, (wanted, notes) in enumerate(found)
    ]


def names_in(texts: Iterable[str]) -> tuple[str, ...]:
    """Return all that :meth:`IngredientWords.read` may take for the name of a food in ``texts``."""
    names: dict[str, None] = {}
    for text in (one for several in texts for one in (several, *each_food(without_part(several)[0]))):
        for words in (text.partition(",")[0].split(), text.replace(",", " ").split()):
            names |= dict.fromkeys(" ".join(words[n:]) for n in range(len(words)))
    return tuple(names)


def _has_a_name_with_and(text: str) -> bool:
    """Return whether words on both sides of an "and" are together the name of a food."""
    words = text.replace(",", " , ").split()
    return any(_is_listed(words[start:end]) for end in range(len(words) + 1) for start in range(end - 2))


def _is_listed(words: Sequence[str]) -> bool:
    name = singular(" ".join(words).replace("&", "and"))  # which has no signs and no numbers any more
    is_one = tables().foods.is_listed(name) and name not in word_list("names several foods")
    return is_one and _AND.search(name) is not None


def _names_one(part: str) -> bool:
    """Return whether the words before a comma end with a listed food, or its piece, and name no other before it."""
    words = part.partition(",")[0].split()
    is_piece = len(words) > 1 and singular(words[-1]) in word_list("is only a piece of it")
    return _ends_with_one(words) or (is_piece and _ends_with_one(words[:-1]))


def _ends_with_one(words: Sequence[str]) -> bool:
    is_listed = tables().foods.is_listed
    begin = next((place for place in range(len(words)) if is_listed(" ".join(words[place:]))), None)
    return begin is not None and not any(map(is_listed, words[:begin]))


def counting(words: Sequence[str]) -> int:
    """Return how many words in front say how much: two of “500 g potato”, three of “a pinch of salt”."""
    lower = [word.lower().rstrip(".") or word for word in words]
    begin = int(lower[:1] in (["a"], ["an"]))
    if not (lower and lower[0][0].isnumeric()) and lower[begin + 1 : begin + 2] != ["of"]:
        return 0
    many = len(list(takewhile(_counts, lower[begin:])))
    return begin + many if many else 0


def _counts(word: str) -> bool:
    """Return whether a ``word`` in lower case says how much: a number, a measure, or what stands between these."""
    from foon_kg.language.plain_lines import is_measure  # noqa: PLC0415 - few questions count anything

    measures = word_list("measures what is canned") | word_list("measures a food") | {"of", "to", "-"}
    return word[0].isnumeric() or word in measures or is_measure(word)


def amount_of(words: Sequence[str]) -> str:
    """Return how much words say: “2 cups” of “2 cups of”."""
    return " ".join(words[:-1] if words and words[-1].lower() == "of" else words)
