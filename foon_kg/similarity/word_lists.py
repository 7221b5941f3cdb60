"""Which word lists decide where the points of foods are (:mod:`foon_kg.similarity.points`)."""

from __future__ import annotations

import hashlib
import os
from functools import cache
from importlib.resources import files
from pathlib import Path

from foon_kg.food.lists import word_list
from foon_kg.model.names import ALIASES_VARIABLE, alias_table
from foon_kg.similarity.forms import FORM_LISTS

_FORM = "4"  # of the points and of the names beside them; a change of the code that makes them changes it
_WORD_LISTS = (
    ("foon_kg.model", "aliases.txt"),
    ("foon_kg.similarity", "food-groups.txt"),
    ("foon_kg.similarity", "food-taxonomy.txt"),
    ("foon_kg.similarity", "food-vectors.npz"),
)
"""The files: the package that each lies in, and its name."""


def word_lists_key() -> str:
    """Return a hash of all that decides where a name's point is: of other word lists, or aliases, points differ.

    Raises ``ReadError`` for an alias file that is broken or not there.
    """
    own_file = os.environ.get(ALIASES_VARIABLE, "")
    alias_table(own_file)
    return _word_lists_key(Path(own_file).read_bytes() if own_file else b"")


@cache
def _word_lists_key(own_aliases: bytes) -> str:
    lists = (files(package).joinpath(name).read_bytes() for package, name in _WORD_LISTS)
    digest = hashlib.blake2b(_FORM.encode(), digest_size=16)
    for name in FORM_LISTS:
        digest.update("\n".join((name, *sorted(word_list(name)))).encode())
    for content in (*lists, own_aliases):
        digest.update(hashlib.blake2b(content).digest())
    return digest.hexdigest()
