"""What a motion's words say of it: who may enter, whether it mixes, heats, moves or opens.

The words are those of the FOON's annotators (``scoop and pour``, ``pick-and-place``); a motion belongs to a
class when one of its words does.
"""

from __future__ import annotations

import re
from functools import cache

_WORD = re.compile(r"[^\W\d_]+")


def _all(text: str) -> frozenset[str]:
    return frozenset(_WORD.findall(text))


ACCEPTS_ANY = _all("add beat blend combine drop fill mix place pour put scoop shake sprinkle stir toss whisk")
"""Words of motions into which any number of foods may enter (contract, C8)."""

MIXES = _all("beat blend combine fold knead mash mix shake stir swirl toss whip whisk")
"""Words of motions that make one thing of several."""

HEATS = _all(
    "bake barbecue boil broil brown cook fry grill heat melt microwave poach preheat reduce roast saute "
    "sauté sear simmer steam toast warm "
)
"""Words of motions that cook what they act on."""

MOIST = _all("blanch boil poach simmer steam")
"""Words of motions that cook in water or its steam."""

DRY = _all("bake barbecue broil brown fry grill roast saute sauté sear toast")
"""Words of motions that cook in hot air or fat."""

TRANSFERS = _all(
    "add drip drizzle drop dump empty fill garnish insert move pick place pour put scoop scrape spoon "
    "sprinkle squeeze transfer "
)
"""Words of motions that bring something from one place to another."""

OPENS = _all(
    "break chop core crack cube cut dice grate halve hull julienne mince open peel pit quarter remove "
    "shave shred slice slit split trim "
)
"""Words of motions that open a whole food: crack, peel or cut it."""


PEELS = _all("crack hull peel shell skin")
"""Words of motions that take off what nobody eats."""


@cache
def words(motion: str) -> frozenset[str]:
    """Answer the words of ``motion`` in lower case."""
    return frozenset(_WORD.findall(motion.lower()))


@cache
def accepts_any(motion: str, *, star: bool = False) -> bool:
    """Say whether any number of foods may enter a unit with this motion (contract, C8)."""
    return star or bool(words(motion) & ACCEPTS_ANY)


@cache
def mixes(motion: str) -> bool:
    """Say whether the motion makes one thing of several."""
    return bool(words(motion) & MIXES)


@cache
def heats(motion: str) -> bool:
    """Say whether the motion cooks what it acts on."""
    return bool(words(motion) & HEATS)


@cache
def transfers(motion: str) -> bool:
    """Say whether the motion only brings something from one place to another."""
    return bool(words(motion) & TRANSFERS) and not mixes(motion) and not heats(motion)


@cache
def opens(motion: str) -> bool:
    """Say whether the motion opens a whole food: cracks, peels or cuts it."""
    return bool(words(motion) & OPENS)


@cache
def peels(motion: str) -> bool:
    """Say whether the motion takes off what nobody eats: a skin, a shell."""
    own = words(motion)
    return bool(own & PEELS) or own >= {"off", "skin"}


@cache
def may_stand_for(motion: str, other: str) -> bool:
    """Say whether ``motion`` can be done with what is there for ``other``.

    Nobody bakes in the water in which something boils, and nothing is blended with a knife on a board.
    """
    own, theirs = words(motion), words(other)
    if (own & DRY and theirs & MOIST) or (own & MOIST and theirs & DRY):
        return False
    return not opens(other) or opens(motion) or not mixes(motion)
