"""The table of the twelve classes of states (``states.json``), and where it puts a state that it does not list.

Another table of the same form may be named in ``FOON_KG_STATES``.
"""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from foon_kg.model.errors import ReadError
from foon_kg.model.json_text import json_value
from foon_kg.model.names import canonical
from foon_kg.model.recent import MOST_WORDS, Recent
from foon_kg.model.regular_files import read_text
from foon_kg.similarity.vectors import food_vectors

STATES_VARIABLE = "FOON_KG_STATES"

LISTED, BY_ADVERB, BY_WORD = 1.0, 0.9, 0.7
"""How sure a class is that the table lists, or that the adverb (a place, too) or another word of the state tells
(measured)."""

_UNKNOWN = 0.1  # one class of twelve, and a little for the commonest
_NEAREST = 5  # listed states vote on the class of one that nobody listed
_SURER = 1.3  # the nearest states are right more often than their cosines say

Pair = tuple[str, str]


@dataclass(frozen=True, eq=False)
class StateClasses:
    """The table of classes: states are canonical names (``spelling`` has them as written), pairs go both ways round."""

    class_of: Mapping[str, str]
    spelling: Mapping[str, str]
    processed: frozenset[str]
    adverbs: Mapping[Pair, str]
    places: Mapping[str, str]
    _placed: Recent[str, tuple[str, float]] = field(default_factory=lambda: Recent(MOST_WORDS))

    def place(self, state: str) -> tuple[str, float]:
        """Return the class of a canonical state and how sure that is."""
        if state in self.class_of:
            return self.class_of[state], LISTED
        placed = self._placed.find(state)
        if placed is None:  # guesses alone are kept: one is compared with every state that the table lists
            placed = self._placed[state] = self.guess(state)
        return placed

    def guess(self, state: str) -> tuple[str, float]:
        """Return the class of a state that the table does not list; benchmarks/similarity_states.py measures this."""
        said = self.state_in(state)
        if state.partition(" ")[0] in self.places and not self._is_made(said):
            return self.places[state.partition(" ")[0]], BY_ADVERB
        if said is None:
            return self._of_the_nearest(state)
        adverb, _, rest = said.partition(" ")
        if rest and (adverb, self.class_of.get(rest, "")) in self.adverbs:
            return self.adverbs[adverb, self.class_of[rest]], BY_ADVERB
        return self.class_of[canonical(said)], BY_WORD

    def _is_made(self, said: str | None) -> bool:
        return said is not None and self.class_of.get(canonical(said)) in self.processed

    def state_in(self, phrase: str) -> str | None:
        """Return the state in a ``phrase``, as :func:`foon_kg.similarity.states.state_in` does."""
        words = canonical(phrase.replace(",", " ").replace("-", " ")).split()
        found = [place for place, word in enumerate(words) if word in self.class_of]
        if not found:
            return None
        place = next((place for place in found if self.class_of[words[place]] in self.processed), found[0])
        adverb, state = words[place - 1] if place else "", words[place]
        moved = (adverb, self.class_of[state]) in self.adverbs
        return f"{adverb} {state}" if moved else self.spelling[state]

    def _of_the_nearest(self, state: str) -> tuple[str, float]:
        """Return the class that most of the nearest listed states are in, weighed by their cosines."""
        known = sorted(self.class_of)
        vectors = food_vectors()
        cosines = (vectors.embed([state]) @ vectors.embed(known).T)[0]
        nearest = sorted(zip(known, cosines.tolist(), strict=True), key=lambda pair: (-pair[1], pair[0]))[:_NEAREST]
        votes: defaultdict[str, float] = defaultdict(float)
        for name, cosine in nearest:
            votes[self.class_of[name]] += max(cosine, 0.0)
        winner = min(votes, key=lambda name: (-votes[name], name))
        return winner, min(BY_WORD, max(_UNKNOWN, _SURER * votes[winner] / _NEAREST))


def state_classes() -> StateClasses:
    """Return the classes of the file in ``FOON_KG_STATES``, else those that ship; ``ReadError`` where it has none."""
    return _read(os.environ.get(STATES_VARIABLE, ""))


@lru_cache(maxsize=4)
def _read(path: str) -> StateClasses:
    try:
        return _parsed(json_value(read_text(Path(path)) if path else _shipped()))
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:  # the last: a number for a state
        raise ReadError(
            f"{path}: not a table of state classes: {error!r}",
            hint="Take the form of foon_kg/similarity/states.json: classes, adverbs, places.",
        ) from error


def _shipped() -> str:
    return files("foon_kg.similarity").joinpath("states.json").read_text(encoding="utf-8")


def _parsed(document: dict[str, Any]) -> StateClasses:
    classes = document["classes"]
    return StateClasses(
        class_of={canonical(state): row["name"] for row in classes for state in row["states"]},
        spelling={canonical(state): state for row in classes for state in reversed(row["states"])},
        processed=frozenset(row["name"] for row in classes if row["processed"]),
        adverbs={(row["word"], row["from"]): row["to"] for row in document["adverbs"]},
        places=dict.fromkeys(document["places"]["words"], document["places"]["class"]),
    )
