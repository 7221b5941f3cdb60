"""How the names of utensils are written: tables compare names in the singular, people say "scissors" and "tongs"."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping
from functools import lru_cache
from importlib.resources import files
from pathlib import Path

from foon_kg.food.tables import UTENSILS_VARIABLE, tables
from foon_kg.food.words import singular


def utensil_names() -> Mapping[str, str]:
    """Return every utensil of the tables as it is written, by its name in the singular.

    Raises ReadError where the table that a user named cannot be read.
    """
    tables()  # says what is wrong with a user's own table
    return _names(os.environ.get(UTENSILS_VARIABLE, ""))


@lru_cache(maxsize=4)
def _names(own: str) -> Mapping[str, str]:
    texts = [files("foon_kg.food").joinpath("utensils.toml").read_text(encoding="utf-8")]
    texts += [Path(own).read_text(encoding="utf-8")] if own else []
    groups = [group for text in texts for group in tomllib.loads(text).get("groups", {}).values()]
    return {singular(name): name for group in groups for name in group.get("names", [])}
