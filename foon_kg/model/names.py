"""One name for one thing: what a label, a member of ``{}`` and a recipe word are compared by.

A name keeps being shown as it was written; ``canonical`` is only what it is compared by. The table of synonyms and
typing errors is ``aliases.txt`` beside this module; people add their own lines in a file named by ``FOON_KG_ALIASES``.
"""

from __future__ import annotations

import os
import re
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files
from pathlib import Path

from foon_kg.model.errors import ReadError
from foon_kg.model.regular_files import read_text

ALIASES_VARIABLE = "FOON_KG_ALIASES"

_OF_THEIR_OWN = str.maketrans({"\u0131": "i", "ł": "l", "ø": "o", "đ": "d", "æ": "ae", "œ": "oe", "ß": "ss"})
"""Letters that Unicode does not take for others with a sign on them."""
_APOSTROPHES = str.maketrans({"\u2019": "'", "\u2018": "'", "`": "'", "_": " "})
_TIDY = re.compile(r"[^\w&'%/\- ]+")
_STILL_SINGULAR = ("ss", "us", "is", "'s")  # glass, hummus, cassis, baker's
_TAKES_ES = ("ches", "shes", "sses", "xes", "zzes", "oes")
_SHORTEST_PLURAL = 4  # "peas"; "gas" and "bus" are no plurals
_OWN_IE = frozenset({"brownies", "cookies", "hoagies", "pies", "smoothies", "veggies"})
"""Plurals in -ies whose singular ends in -ie: all others are taken for berries, whose singular is berry."""


@dataclass(frozen=True)
class AliasTable:
    """Other names, by what is written: whole names, single words, and words that no rule may touch."""

    wholes: dict[str, str]
    words: dict[str, str]
    kept: frozenset[str]


def canonical(name: str) -> str:
    """Return the name by which ``name`` is compared; names of one thing have equal answers.

    Lower case, single spaces, no accents, singular, with synonyms and typing errors of the alias table resolved.
    Idempotent: ``canonical(canonical(x)) == canonical(x)``. Raises ``ReadError`` for a broken alias file.

    >>> canonical("Crème fraîche"), canonical("  ripe Tomatoes ")
    ('creme fraiche', 'ripe tomato')
    """
    return _canonical(name, os.environ.get(ALIASES_VARIABLE, ""))


def canonical_all(names: tuple[str, ...]) -> tuple[str, ...]:
    """Return :func:`canonical` of each of ``names``; of few lists, as of the words of a FOON, it is kept.

    >>> canonical_all(("Onions", "eggs"))
    ('onion', 'egg')
    """
    return _canonical_all(names, os.environ.get(ALIASES_VARIABLE, ""))


@lru_cache(maxsize=4)
def _canonical_all(names: tuple[str, ...], own_file: str) -> tuple[str, ...]:
    return tuple(_canonical(name, own_file) for name in names)


@lru_cache(maxsize=65_536)
def _canonical(name: str, own_file: str) -> str:
    table = alias_table(own_file)
    path: list[str] = []
    text = _tidied(name)
    while text not in path:  # one step may make another one possible
        path.append(text)
        text = _one_step(text, table)
    return min(path[path.index(text) :])  # where it came to rest; aliases in a ring rest at their first name


def _one_step(text: str, table: AliasTable) -> str:
    """Return a tidy name with its aliases resolved once: as a whole, else word by word, the last word singular."""
    if text in table.wholes:
        return table.wholes[text]
    words = [table.words.get(word, word) for word in text.split()]
    if words and " ".join(words) not in table.kept:
        words[-1] = _singular(words[-1], table.kept)
    return " ".join(table.words.get(word, word) for word in words)  # an alias may name the singular alone


def _tidied(name: str) -> str:
    """Return ``name`` in small plain letters, with single spaces and no other signs than ``&'%/-``."""
    plain = without_accents(name.translate(_APOSTROPHES).casefold())
    # once more: NFKD makes capital letters of some signs (™ becomes TM)
    return " ".join(_TIDY.sub(" ", plain.casefold()).split())


def without_accents(text: str) -> str:
    """Return ``text`` with its letters plain, without accents (pâté: pate; smørrebrød: smorrebrod).

    >>> without_accents("crème brûlée")
    'creme brulee'
    """
    if text.isascii():  # as most is; the rest takes ten times as long
        return text
    letters = unicodedata.normalize("NFKD", text.translate(_OF_THEIR_OWN))
    return "".join(letter for letter in letters if not unicodedata.combining(letter))


def _singular(word: str, kept: frozenset[str]) -> str:
    if word in kept or len(word) < _SHORTEST_PLURAL or not word.endswith("s") or word.endswith(_STILL_SINGULAR):
        return word
    if word.endswith("ies") and word not in _OWN_IE:
        return word[:-3] + "y"
    if word.endswith(_TAKES_ES):
        return word[:-2]
    return word[:-1]


@lru_cache(maxsize=8)
def alias_table(own_file: str = "") -> AliasTable:
    """Return foon-kg's own aliases, overruled by those of ``own_file`` (``""`` for none).

    Raises ReadError where that file cannot be read, with the line where one of its lines cannot.

    >>> alias_table().wholes.keys() >= alias_table().words.keys()
    True
    """
    shipped = files("foon_kg.model").joinpath("aliases.txt").read_text(encoding="utf-8")
    table = _read(shipped.splitlines(), "aliases.txt", AliasTable({}, {}, frozenset()))
    if not own_file:
        return table
    try:
        lines = read_text(Path(own_file), "utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        why = error.strerror if isinstance(error, OSError) else "it is no text in UTF-8"
        raise ReadError(
            f"{own_file}: the alias file cannot be read: {why}",
            hint=f"Name a readable UTF-8 text file in {ALIASES_VARIABLE}, or unset it.",
        ) from error
    return _read(lines, own_file, table)


def _read(lines: Iterable[str], source: str, base: AliasTable) -> AliasTable:
    wholes, words, kept = dict(base.wholes), dict(base.words), set(base.kept)
    for number, line in enumerate(lines, 1):
        text = line.partition("#")[0].strip()
        if text.startswith("keep:"):
            kept.update(_names(text.removeprefix("keep:")))
        elif text:
            _add_aliases(text, f"{source}:{number}", wholes, words)
    return AliasTable(wholes, words, frozenset(kept))


def _add_aliases(text: str, where: str, wholes: dict[str, str], words: dict[str, str]) -> None:
    name, equals, others = text.removeprefix("whole:").partition("=")
    target, aliases = _tidied(name), _names(others)
    if not (equals and target and aliases):
        raise ReadError(
            f"{where}: an alias line has no name, no '=' or no other name: {text!r}",
            hint="Write: name = another name, another name",
        )
    for alias in aliases:
        wholes[alias] = target
        if " " not in alias + target and not text.startswith("whole:"):
            words[alias] = target


def _names(text: str) -> list[str]:
    return [name for name in map(_tidied, text.split(",")) if name]
