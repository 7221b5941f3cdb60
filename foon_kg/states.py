"""The states of foods in twelve classes: how well one state stands for another, and which motion makes it.

The classes are data (``data/states.json``): another file of the same form may be named in ``FOON_KG_STATES``. A state
that no class lists is placed by its adverb, by the words in it, or by the classes of the states nearest to it.
"""

from __future__ import annotations

import json
import os
from collections import Counter, defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files
from itertools import permutations
from pathlib import Path
from typing import Any

from foon_kg import motions
from foon_kg.errors import ReadError
from foon_kg.kitchen import Kitchen
from foon_kg.knowledge import MadeBy, Vocabulary
from foon_kg.names import canonical
from foon_kg.similarity.vectors import food_vectors, stem

STATES_VARIABLE = "FOON_KG_STATES"

_LISTED, _BY_ADVERB, _BY_WORD = 1.0, 0.95, 0.85
_UNKNOWN = 0.1  # one class of twelve, and a little for the commonest
_NEAREST = 5
_DOUBLED = 2
_SMALL_WORDS = frozenset({"and", "with", "in", "of", "off", "out", "on", "as", "from"})
_IRREGULAR = {"ground": "grind", "beaten": "beat", "frozen": "freeze", "torn": "tear", "broken": "break"}


@dataclass(frozen=True)
class StateClasses:
    """The table of classes: states are canonical names (``spelling`` has them as written), pairs go both ways round."""

    class_of: Mapping[str, str]
    spelling: Mapping[str, str]
    processed: frozenset[str]
    neighbours: Mapping[tuple[str, str], float]
    closer: Mapping[tuple[str, str], float]
    adverbs: Mapping[tuple[str, str], str]
    same_class: float
    otherwise: float


def state_class(state: str) -> tuple[str, float]:
    """Answer the class of ``state`` and how sure that is, 0 to 1: 1 for a state that the table lists."""
    return _state_class(canonical(state), _classes())


def state_in(phrase: str) -> str | None:
    """Answer the state that a phrase speaks of, as the table spells it; ``None`` where it speaks of none.

    Of several words, what was done says more than what it looks like, and comes first ("cut into cubes" is cut). An
    adverb stays where it moves the state into another class ("finely chopped").
    """
    classes = _classes()
    words = canonical(phrase.replace(",", " ").replace("-", " ")).split()
    found = [place for place, word in enumerate(words) if word in classes.class_of]
    if not found:
        return None
    place = next((place for place in found if classes.class_of[words[place]] in classes.processed), found[0])
    adverb, state = words[place - 1] if place else "", words[place]
    moved = (adverb, classes.class_of[state]) in classes.adverbs
    return f"{adverb} {state}" if moved else classes.spelling[state]


def state_similarity(a: str, b: str) -> float:
    """Answer how well state ``a`` stands for ``b``, 0 to 1 and the same both ways: 1 for the same state.

    States of one class answer ``same_class`` of the table (or what ``closer`` says of the two), those of neighbouring
    classes what ``neighbours`` says, all others ``otherwise``; a state that had to be guessed weighs less.
    """
    one, other = canonical(a), canonical(b)
    classes = _classes()
    if one == other:
        return 1.0
    (class_a, sure_a), (class_b, sure_b) = _state_class(one, classes), _state_class(other, classes)
    between = (
        classes.same_class if class_a == class_b else classes.neighbours.get((class_a, class_b), classes.otherwise)
    )
    between = classes.closer.get((one, other), between)
    return classes.otherwise + (between - classes.otherwise) * sure_a * sure_b


def is_processed(state: str, food: str = "") -> bool:
    """Whether somebody made ``state``: no shop sells ``food`` in it (C6), and its class is one that hands make."""
    if Kitchen.default().is_start_state(food, state):
        return False
    classes = _classes()
    return _state_class(canonical(state), classes)[0] in classes.processed


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


@lru_cache(maxsize=4_096)
def _guess(state: str, path: str) -> tuple[str, float]:
    """Place a state that no class lists; benchmarks/states.py measures how often each way of guessing is right."""
    classes = state_classes(path)
    said = state_in(state)
    if said is None:
        return _nearest_class(state, classes)
    adverb, _, rest = said.partition(" ")
    if (adverb, classes.class_of.get(rest, "")) in classes.adverbs:
        return classes.adverbs[adverb, classes.class_of[rest]], _BY_ADVERB
    return classes.class_of[canonical(said)], _BY_WORD


def _nearest_class(state: str, classes: StateClasses) -> tuple[str, float]:
    """Answer the class that most of the nearest listed states are in, weighed by their cosines."""
    known = sorted(classes.class_of)
    vectors = food_vectors()
    cosines = (vectors.embed([state]) @ vectors.embed(known).T)[0]
    nearest = sorted(zip(known, cosines.tolist(), strict=True), key=lambda pair: (-pair[1], pair[0]))[:_NEAREST]
    votes: defaultdict[str, float] = defaultdict(float)
    for name, cosine in nearest:
        votes[classes.class_of[name]] += max(cosine, 0.0)
    winner = min(votes, key=lambda name: (-votes[name], name))
    return winner, max(_UNKNOWN, votes[winner] / _NEAREST)


def _state_class(state: str, classes: StateClasses) -> tuple[str, float]:
    if state in classes.class_of:
        return classes.class_of[state], _LISTED
    return _guess(state, os.environ.get(STATES_VARIABLE, ""))


def _classes() -> StateClasses:
    return state_classes(os.environ.get(STATES_VARIABLE, ""))


@lru_cache(maxsize=4)
def state_classes(path: str = "") -> StateClasses:
    """Answer the classes that ship with foon-kg, or those of the file ``path``; ``ReadError`` where it has none."""
    try:
        text = Path(path).read_text(encoding="utf-8") if path else _shipped()
        return _parsed(json.loads(text))
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise ReadError(
            f"{path}: not a table of state classes: {error!r}",
            hint="Take the form of foon_kg/data/states.json: classes, neighbours, closer, adverbs.",
        ) from error


def _shipped() -> str:
    return files("foon_kg.data").joinpath("states.json").read_text(encoding="utf-8")


def _parsed(document: dict[str, Any]) -> StateClasses:
    classes = document["classes"]
    closer: dict[tuple[str, str], float] = {}
    for group in document["closer"]:
        for one, other in permutations(map(canonical, group["states"]), _DOUBLED):
            closer[one, other] = max(group["similarity"], closer.get((one, other), 0.0))
    return StateClasses(
        class_of={canonical(state): row["name"] for row in classes for state in row["states"]},
        spelling={canonical(state): state for row in classes for state in reversed(row["states"])},
        processed=frozenset(row["name"] for row in classes if row["processed"]),
        neighbours={
            pair: row["similarity"] for row in document["neighbours"] for pair in permutations(row["classes"], _DOUBLED)
        },
        closer=closer,
        adverbs={(row["word"], row["from"]): row["to"] for row in document["adverbs"]},
        same_class=document["same_class"],
        otherwise=document["otherwise"],
    )
