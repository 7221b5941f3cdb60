"""What a motion is about: whether it mixes, heats, moves or opens.

Motions are the words of the FOON's annotators (``scoop and pour``, ``pick-and-place``). What each does is data: the
table of motions and the lists of :mod:`foon_kg.food`.
"""

from __future__ import annotations

from functools import lru_cache

from foon_kg.food import tables
from foon_kg.model.recent import MOST_WORDS

_OPENS = frozenset({"choke", "core", "cut", "grate", "husk", "open", "peel", "shell", "stone"})
_BRINGS = frozenset({"move", "scatter"})
_WORKS = frozenset({"coat", "heat", "mix"})

# Each answer is kept: they are asked of every unit again and again, and no file of a user's own adds motions.


@lru_cache(maxsize=MOST_WORDS)
def mixes(motion: str) -> bool:
    """Return whether the motion makes one thing of several."""
    return "mix" in _done_by(motion)


@lru_cache(maxsize=MOST_WORDS)
def heats(motion: str) -> bool:
    """Return whether the motion cooks what it acts on, or makes it hot."""
    does = _done_by(motion)
    return "heat" in does or ("warm" in does and tables().motion(motion).source == "heat")


@lru_cache(maxsize=MOST_WORDS)
def transfers(motion: str) -> bool:
    """Return whether the motion only brings something from one place to another."""
    does = _done_by(motion)
    return not does.isdisjoint(_BRINGS) and does.isdisjoint(_WORKS) and not heats(motion)


@lru_cache(maxsize=MOST_WORDS)
def switches_off(motion: str) -> bool:
    """Return whether the motion turns an appliance off."""
    return "switch off" in _done_by(motion)


@lru_cache(maxsize=MOST_WORDS)
def switches_on(motion: str) -> bool:
    """Return whether the motion turns an appliance on."""
    return "switch on" in _done_by(motion)


@lru_cache(maxsize=MOST_WORDS)
def opens(motion: str) -> bool:
    """Return whether the motion opens a whole food: cracks, peels or cuts it."""
    does = _done_by(motion)
    return not does.isdisjoint(_OPENS) and "uncover" not in does


def _done_by(motion: str) -> frozenset[str]:
    return tables().motion(motion).does
