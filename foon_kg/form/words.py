"""The contract's words about motions, kept by the judge: a planner that widens its own lists gains nothing."""

from __future__ import annotations

import functools
import re

TAKES_ANY = frozenset(
    {
        "add", "beat", "blend", "combine", "drop", "fill", "mix", "place", "pour", "put", "scoop", "shake", "sprinkle",
        "stir", "toss", "whisk",
    }
)  # fmt: skip
"""Any number of foods may enter a unit whose motion has one of these words (C8)."""

MIXES = frozenset(
    {"beat", "blend", "combine", "fold", "knead", "mash", "mix", "shake", "stir", "swirl", "toss", "whip", "whisk"}
)
HEATS = frozenset(
    {
        "bake", "barbecue", "boil", "broil", "cook", "fry", "grill", "heat", "melt", "microwave", "poach", "roast",
        "saute", "sear", "simmer", "steam", "toast",
    }
)  # fmt: skip
"""With :data:`MIXES`, the motions after which a food comes too late (S2)."""

OPENS = frozenset(
    {
        "break", "chop", "core", "crack", "cube", "cut", "dice", "grate", "halve", "julienne", "mince", "open", "peel",
        "quarter", "shave", "shell", "shred", "skin", "slice", "slit", "split",
    }
)  # fmt: skip
"""To crack, to peel, to open and the ways to cut (S3)."""

_WORD = re.compile(r"[^\W\d_]+")


@functools.cache
def has_word(motion: str, among: frozenset[str]) -> bool:
    """Whether one of the words of ``motion`` (``scoop and pour``, ``pick-and-place``) is ``among`` those."""
    return not among.isdisjoint(_WORD.findall(motion.lower()))


def takes_any(motion: str, *, star: bool = False) -> bool:
    """Whether any number of foods may enter a unit with this motion (C8)."""
    return star or has_word(motion, TAKES_ANY)
