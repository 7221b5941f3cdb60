"""The states of foods in twelve classes, and which state a phrase speaks of.

The classes are data (``foon_kg.similarity.state_classes``). A state that no class lists is placed by its adverb, by the
words in it, or by the classes of the states nearest to it.
"""

from __future__ import annotations

from foon_kg.model.names import canonical
from foon_kg.similarity.state_classes import state_classes


def state_class(state: str) -> tuple[str, float]:
    """Return the class of ``state`` and how sure that is, 0 to 1: 1 for a state that the table lists."""
    return state_classes().place(canonical(state))


def state_in(phrase: str) -> str | None:
    """Return the state that a phrase speaks of, as the table spells it; ``None`` where it speaks of none.

    Of several words, what was done says more than what it looks like, and comes first ("cut into cubes" is cut). An
    adverb stays where it moves the state into another class ("finely chopped").
    """
    return state_classes().state_in(phrase)
