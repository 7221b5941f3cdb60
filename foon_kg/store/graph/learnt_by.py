"""By what the operators and frames of a graph were learnt: the code that learns, and the tables of cooking."""

from __future__ import annotations

import os
from functools import cache
from importlib import resources
from pathlib import Path

from foon_kg.food.tables import FOODS_VARIABLE, UTENSILS_VARIABLE
from foon_kg.model import content_key
from foon_kg.model.kept import code_key

LEARNT_BY = (
    "food", "world", "integration/teaching", "integration/joining", "integration/preparing", "integration/bench",
    "integration/methods.py", "store/graph/lifting.py", "store/graph/learning.py", "store/graph/frame_rows.py",
    "store/snapshot.py",
)  # fmt: skip
"""The code and the data on which what is learnt depends."""


def methods_key() -> str:
    """Return a hash of all that decides what is learnt of a FOON: the code that learns, and the tables of cooking."""
    own = (os.environ.get(variable, "") for variable in (FOODS_VARIABLE, UTENSILS_VARIABLE))
    return content_key(_program_key(), *(Path(path).read_text(encoding="utf-8") if path else "" for path in own))


@cache
def _program_key() -> str:
    package = resources.files("foon_kg")
    return code_key(package.joinpath(name) for name in LEARNT_BY)
