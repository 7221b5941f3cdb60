"""What a motion is about: who may enter, whether it mixes, heats, moves, opens or peels.

Motions are the words of the FOON's annotators (``scoop and pour``, ``pick-and-place``). What each does is data: the
table of motions and the lists of :mod:`foon_kg.food`.
"""

from __future__ import annotations

from functools import cache

from foon_kg.food import plain_words, tables
from foon_kg.food.lists import word_list

_OPENS = frozenset({"choke", "core", "cut", "grate", "husk", "open", "peel", "shell", "stone"})
_PEELS = frozenset({"husk", "peel", "shell"})
_BRINGS = frozenset({"move", "scatter"})
_WORKS = frozenset({"coat", "heat", "mix"})


def words(motion: str) -> frozenset[str]:
    """Return the words of ``motion`` in lower case."""
    return plain_words(motion)


@cache
def accepts_any(motion: str, *, star: bool = False) -> bool:
    """Return whether any number of foods may enter a unit with this motion (C8)."""
    return star or not words(motion).isdisjoint(word_list("takes any number"))


@cache
def mixes(motion: str) -> bool:
    """Return whether the motion makes one thing of several."""
    return "mix" in _done_by(motion)


@cache
def heats(motion: str) -> bool:
    """Return whether the motion cooks what it acts on, or makes it hot."""
    does = _done_by(motion)
    return "heat" in does or ("warm" in does and tables().motion(motion).source == "heat")


@cache
def transfers(motion: str) -> bool:
    """Return whether the motion only brings something from one place to another."""
    does = _done_by(motion)
    return not does.isdisjoint(_BRINGS) and does.isdisjoint(_WORKS) and not heats(motion)


@cache
def opens(motion: str) -> bool:
    """Return whether the motion opens a whole food: cracks, peels or cuts it."""
    does = _done_by(motion)
    return not does.isdisjoint(_OPENS) and "uncover" not in does


@cache
def peels(motion: str) -> bool:
    """Return whether the motion takes off what nobody eats: a skin, a shell. Zest is eaten."""
    does = _done_by(motion)
    return not does.isdisjoint(_PEELS) and "grate" not in does


@cache
def may_stand_for(motion: str, other: str) -> bool:
    """Return whether ``motion`` can be done with what is there for ``other``.

    Nobody bakes in the water in which something boils, and nothing is blended with a knife on a board.
    """
    if (_is_dry(motion) and _is_moist(other)) or (_is_moist(motion) and _is_dry(other)):
        return False
    return not opens(other) or opens(motion) or not mixes(motion)


def _is_dry(motion: str) -> bool:
    return not _done_by(motion).isdisjoint({"dry", "fat"})


def _is_moist(motion: str) -> bool:
    return "liquid" in _done_by(motion)


def _done_by(motion: str) -> frozenset[str]:
    return tables().motion(motion).does
