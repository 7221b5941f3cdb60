"""The words of a name: in lower case and in the singular, so that what two people write of one thing meets.

And the words that say for what of a dish a food is.
"""

from __future__ import annotations

import functools
import itertools
import re
from collections.abc import Collection, Iterable, Sequence

from foon_kg.food.lists import longer_names, says, word_list
from foon_kg.model.names import without_accents

_WORD = re.compile(r"[^\W\d_]+")
_IRREGULAR = {
    "bouillabaisses": "bouillabaisse", "chilies": "chili", "chillies": "chilli", "halves": "half", "knives": "knife",
    "leaves": "leaf", "loaves": "loaf", "mousses": "mousse",
    "yoghurt": "yogurt", "yoghurts": "yogurt",
}  # fmt: skip
_PLURALS = (("ies", "y"), ("oes", "o"), ("ches", "ch"), ("shes", "sh"), ("sses", "ss"), ("xes", "x"), ("s", ""))
_NO_PLURAL = ("ss", "us", "is")
_SHORT = 3
_BESIDES = re.compile(r"\bplus\b|\b(?:more|extra|some)(?= (?:for|to)\b)", re.IGNORECASE)
"""What follows this is a little more of a food, beside what all the rest is for."""
_USE = re.compile(r"[,(]?\s*\b(?:for|to) (?:the |an? )?(?P<words>[a-z][a-z -]*)\)?", re.IGNORECASE)
_USES = {"serve": "serving", "garnish": "garnish", "finish": "finishing", "decorate": "garnish"}
"""What is said with "to", and for what a food is then."""
_HEADED = re.compile(r"\s*(?:for|to) [a-z -]+:(?=\s*\S)", re.IGNORECASE)
"""A heading that stands in one line with its foods."""
_ALIKE = {"swirl": "filling"}
"""Parts of a dish by another name."""


@functools.lru_cache(maxsize=1 << 16)
def words(name: str) -> tuple[str, ...]:
    """Return the words of a name, lower case, singular, without accents: ``Crèmes Brûlées`` → creme, brulee."""
    return tuple(singular_word(word) for word in _WORD.findall(without_accents(name.lower())))


@functools.lru_cache(maxsize=1 << 16)
def singular(name: str) -> str:
    """Return a name with every word in the singular: labels of a FOON are, its ``{}`` names often are not."""
    return " ".join(words(name))


def singular_word(word: str) -> str:
    """Return one word, in lower case already, in the singular."""
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    one = word.removesuffix("s")
    if one.endswith("ie") and one in word_list("ends in ie"):
        return one
    for ending, one in _PLURALS:
        if word.endswith(ending) and len(word) > max(_SHORT, len(ending) + 1) and not word.endswith(_NO_PLURAL):
            word = word[: -len(ending)] + one
            break
    # cookies and cookie must meet somewhere, and the plural alone does not tell them from cherries
    return word[:-2] + "y" if word.endswith("ie") and len(word) > _SHORT else word


@functools.lru_cache(maxsize=1 << 14)
def plain_words(text: str) -> frozenset[str]:
    """Return the words of ``text``, a motion or a state, as they are written, in lower case."""
    return frozenset(_WORD.findall(text.lower()))


def stands_in(phrase: tuple[str, ...], told: Sequence[str]) -> bool:
    """Return whether the words of ``phrase`` stand in ``told`` side by side."""
    # few words are there at all, so the first is looked for before the rest
    return phrase[0] in told and any(tuple(told[at : at + len(phrase)]) == phrase for at in range(len(told)))


def any_stands_in(phrases: Iterable[tuple[str, ...]], told: Sequence[str]) -> bool:
    """Return whether the words of one of ``phrases`` stand in ``told`` side by side."""
    for phrase in phrases:  # noqa: SIM110 - asked of hundreds of names a plan
        if phrase[0] in told and stands_in(phrase, told):
            return True
    return False


def any_is_told(names: Collection[tuple[str, ...]], told: Sequence[str]) -> bool:
    """Return whether one of ``names`` stands in ``told``, and not only inside a longer one of another family."""
    if not any_stands_in(names, told):  # so it is for all but a few of hundreds of rows
        return False
    inside = names_inside(tuple(told))
    return not inside or any_stands_in((name for name in names if name not in inside), told)


@functools.lru_cache(maxsize=1 << 10)
def names_inside(told: tuple[str, ...]) -> frozenset[tuple[str, ...]]:
    """Return the names of families that stand in ``told`` as parts of longer ones only: what is told is not those."""
    spans = {told[start:end] for start, end in itertools.combinations(range(len(told) + 1), 2)}
    longer = {name: spans.intersection(longer_names()[name]) for name in spans & longer_names().keys()}
    return frozenset(name for name, others in longer.items() if others and not stands_in(name, _without(others, told)))


def _without(names: Collection[tuple[str, ...]], told: tuple[str, ...]) -> tuple[str, ...]:
    """Return ``told`` with nothing where one of ``names`` stands in it."""
    left = list(told)
    for name in names:
        for at in range(len(told)):
            if told[at : at + len(name)] == name:
                left[at : at + len(name)] = [""] * len(name)
    return tuple(left)


def is_among(name: str, names: Collection[str]) -> bool:
    """Return whether the food ``name`` is one of ``names``, in the same words or with more (broth, chicken broth)."""
    own = name.split()
    for other in names:
        theirs = other.split()
        nested = set(own) <= set(theirs) or set(theirs) <= set(own)
        if theirs and own and nested and (own[0] == theirs[0] or own[-1] == theirs[-1]):
            return True
    return False


def is_unbaked(title: str) -> bool:
    """Whether a title says that the dish is made without an oven: a no-bake cheesecake, on the stovetop."""
    told = title.lower().replace("-", " ")
    return "no bake" in told or says(words(told), "is made on a stove")


def without_part(text: str) -> tuple[str, str]:
    """Return the line ``text`` without the words that say for what its food is, and for what; ``""`` for nothing.

    What only more of it is for ("plus extra for dusting") is not what the food is for.

    >>> without_part("powdered sugar, for the glaze"), without_part("lemon wedges to serve"), without_part("1 egg")
    (('powdered sugar', 'glaze'), ('lemon wedges', 'serving'), ('1 egg', ''))
    >>> without_part("2 cups flour, plus extra for dusting")[1]
    ''
    >>> without_part("To serve: dumplings and jam")
    ('dumplings and jam', 'serving')
    """
    rest, part = without_heading(text)
    if part:
        return rest, part
    besides = _BESIDES.search(text)
    for use in _USE.finditer(text) if besides is None else _USE.finditer(text, 0, besides.start()):
        said = use["words"].lower().split()
        found = next((_ALIKE.get(word, word) for word in said if word in _named()), _USES.get(said[0], ""))
        if found:
            return f"{text[: use.start()]}{text[use.end() :]}".strip(), found
    return text, ""


def without_heading(text: str) -> tuple[str, str]:
    """Return ``text``, a line, without a heading in front of its foods, and the part that this names; else ``""``."""
    heading = _HEADED.match(text)
    part = heading_part(heading[0]) if heading else ""
    return (text[heading.end() :].strip(), part) if heading and part else (text, "")


def heading_part(text: str) -> str:
    """Return the part of a dish that ``text``, a heading, names; ``""`` where it names nothing.

    A sauce may be called by its own name. What is no known part is called by the last word that is said of it.

    >>> heading_part("For the lemon glaze:"), heading_part("For the hollandaise:"), heading_part("To serve:")
    ('glaze', 'sauce', 'serving')
    >>> heading_part("For the apple horseradish:")
    'horseradish'
    """
    said = list(reversed(re.findall(r"[^\W\d_]+", text.lower())))
    named = next((word for word in said if word in _named()), "") or next((_USES[w] for w in said if w in _USES), "")
    other = (word for word in said if word not in word_list("small words"))
    return _ALIKE.get(named, named) or _named_otherwise(said) or next(other, "")


def _named_otherwise(said: Sequence[str]) -> str:
    """Return the part of which a word that is ``said`` is a name of its own: a raita is a sauce; ``""`` for none."""
    parts = (part for part in sorted(word_list("has names of its own")) if says(said, f"is a {part} by its name"))
    return next(parts, "")


def is_part(name: str) -> bool:
    """Return whether ``name`` is that of a part of a dish, or says for what a food is."""
    return name in _named() or name in word_list("has names of its own") or name in _USES.values()


def _named() -> frozenset[str]:
    return word_list("parts of a dish") | word_list("says what a food is for")
