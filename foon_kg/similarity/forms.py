"""Names without what says only in which pieces a food comes: a piece of bacon is bacon."""

from __future__ import annotations

from collections.abc import Collection

from foon_kg.food.lists import says, word_list

FORM_LISTS = ("is only a piece of it", "is only said beside it", "is no piece of it")
"""The lists of words by which names are read here."""


def plain(name: str, listed: Collection[str] = ()) -> str:
    """Return a canonical name without words for pieces and freshness; as it is where the whole of it is ``listed``.

    What a food is packed in (anchovies in oil) is not what it is.
    """
    pieces, beside, own = map(word_list, FORM_LISTS)
    food, _, packed = name.partition(" in ")
    words = (food if says(packed.split(), "foods are packed in it") and name not in listed else name).split()
    while len(words) > 1 and " ".join(words) not in listed and " ".join(words) not in own:
        if words[-1] in pieces:
            words.pop()
        elif words[0] in beside:
            words.pop(0)
        else:
            break
    return " ".join(words)
