"""The states of foods in twelve classes: how well one state stands for another, and which motion makes it.

The classes are data (``foon_kg.state_classes``). A state that no class lists is placed by its adverb, by the words
in it, or by the classes of the states nearest to it.
"""

from __future__ import annotations

from collections import Counter

from foon_kg import motions
from foon_kg.kitchen import Kitchen
from foon_kg.knowledge import MadeBy, Vocabulary
from foon_kg.names import canonical
from foon_kg.similarity.vectors import stem
from foon_kg.state_classes import state_classes

_SMALL_WORDS = frozenset({"and", "with", "in", "of", "off", "out", "on", "as", "from"})
_IRREGULAR = {"ground": "grind", "beaten": "beat", "frozen": "freeze", "torn": "tear", "broken": "break"}


def state_class(state: str) -> tuple[str, float]:
    """Answer the class of ``state`` and how sure that is, 0 to 1: 1 for a state that the table lists."""
    return state_classes().place(canonical(state))


def state_in(phrase: str) -> str | None:
    """Answer the state that a phrase speaks of, as the table spells it; ``None`` where it speaks of none.

    Of several words, what was done says more than what it looks like, and comes first ("cut into cubes" is cut). An
    adverb stays where it moves the state into another class ("finely chopped").
    """
    return state_classes().state_in(phrase)


def state_similarity(a: str, b: str) -> float:
    """Answer how well state ``a`` stands for ``b``, 0 to 1 and the same both ways: 1 for the same state.

    States of one class answer ``same_class`` of the table (or what ``closer`` says of the two), those of neighbouring
    classes what ``neighbours`` says, all others ``otherwise``; a state that had to be guessed weighs less.
    """
    return state_classes().similarity(canonical(a), canonical(b))


def is_processed(state: str, food: str = "") -> bool:
    """Whether somebody made ``state``: no shop sells ``food`` in it (C6), and its class is one that hands make."""
    return not Kitchen.default().is_start_state(food, state) and state_class(state)[0] in state_classes().processed


def motion_for(state: str, vocabulary: Vocabulary) -> MadeBy | None:
    """Answer the motion that makes ``state`` in the FOON: the one named after it (minced, mince), else the commonest.

    Motions that only bring things together (pour, place) make no state but their own. Ties go to the first by name.
    ``count`` is 0 where the FOON knows a motion of that name but never saw it make the state; ``None`` where nothing
    speaks for any motion.
    """
    wanted, stems = canonical(state), _stems(state)
    counts: Counter[str] = Counter()
    for row in vocabulary.motions:
        if canonical(row.state) == wanted and (_changes(row.motion) or _stems(row.motion) & stems):
            counts[row.motion] += row.count
    named = {row.motion for row in vocabulary.motions if _stems(row.motion) & stems}
    just_so = {motion for motion in named if _stems(motion) == stems}
    candidates = (named & counts.keys()) or just_so or counts.keys() or named
    if not candidates:
        return None
    motion = min(candidates, key=lambda motion: (-counts[motion], len(motion.split()), motion))
    return MadeBy(state, motion, counts[motion])


def _changes(motion: str) -> bool:
    return any(not motions.transfers(word) for word in motions.words(motion) - _SMALL_WORDS)


def _stems(words: str) -> frozenset[str]:
    plain = motions.words(words) - _SMALL_WORDS
    return frozenset(stem(_IRREGULAR.get(word, word)) for word in plain)
