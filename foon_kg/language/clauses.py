"""Instructions as clauses, and each clause as a plain sentence that spaCy's parser reads well.

To the parser "Chop onion" is a noun, and "you chop onion" is not; the extract of "pour the vanilla extract" is a verb.
So imperatives get a subject, for each name of several words that a FOON has a plain noun stands in, and of a motion of
several words (cut open) the first stands for all.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

from foon_kg.language.drafting.verbs import Verbs, is_verb
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.groups import food_groups

VERB, FOOD, UTENSIL = "cut", "onion", "bowl"
"""Words that the parser takes for nothing else; they stand in for what it might."""

_CLAUSES = re.compile(r"(?<=[.!?;])\s+|;\s*")
_FIRST = re.compile(r"(?:(?:\d+[.)]|then|next|now|finally|first|and|-|\*)[\s,]*)*", re.IGNORECASE)
_JOINED = re.compile(
    r"((?:,|\band|\bthen)\s+)([a-z]+)"
    r"(?=\s+(?:an?|the|it|them|until|till|in|into|for|on|over|with|well|together|to|off|everything|all|\w+ly)\b|,|[\s.,]*$)"
)
_BETWEEN = "_"
_NAME = re.compile(r"[^\W_](?:[\w'&-]*_)+[\w'&-]*\w")


@dataclass(frozen=True)
class Told:
    """A clause: ``text`` has names in one word; ``motion`` is what its second word stands for, where that is a verb."""

    clause: str
    text: str
    motion: str | None = None

    def with_stand_in(self) -> Told:
        """Answer the same with a verb that no parser takes for a noun."""
        first, _, rest = self.text.removeprefix("You ").partition(" ")
        return replace(self, text=f"You {VERB} {rest}", motion=self.motion or first)

    def for_parser(self) -> tuple[str, dict[int, str]]:
        """Answer the sentence with plain nouns in place of names, and the names by where these nouns begin."""
        parts: list[str] = []
        names: dict[int, str] = {}
        length = end = 0
        for found in _NAME.finditer(self.text):
            name = found[0].replace(_BETWEEN, " ")
            noun = UTENSIL if Kitchen.default().is_utensil(name) else FOOD
            parts += [self.text[end : found.start()], noun]
            names[length + found.start() - end] = name
            length += found.start() - end + len(noun)
            end = found.end()
        return "".join((*parts, self.text[end:])), names


@dataclass(frozen=True)
class Clauses:
    """Reads texts for the ``verbs`` and the ``names`` of one FOON."""

    verbs: Verbs
    names: tuple[str, ...] = ()

    def of(self, text: str) -> list[Told]:
        """Answer the clauses of ``text`` that have words, in their order."""
        clauses = (part.strip(" ;") for part in _CLAUSES.split(text))
        return [self._told(clause) for clause in clauses if any(map(str.isalpha, clause))]

    def _told(self, clause: str) -> Told:
        bare = self._with_names_as_words(clause[match.end() :] if (match := _FIRST.match(clause)) else clause)
        first = re.match(r"[A-Za-z]+", bare)
        if first is None or not is_verb(first[0], self.verbs.motions):
            return Told(clause, bare)
        motion = self._motions.match(bare)
        rest = bare[(motion or first).end() :]
        said = f"You {first[0].lower()}{_JOINED.sub(self._with_subject, rest)}"
        return Told(clause, said, motion[0].lower() if motion else None)

    def _with_subject(self, joined: re.Match[str]) -> str:
        """Put "you" before a verb that is joined to another; not before a food (salt and butter in a bowl)."""
        word = joined[2]
        verb = is_verb(word, self.verbs.motions) and canonical(word) not in food_groups().places
        return f"{joined[1]}you {word}" if verb else joined[0]

    def _with_names_as_words(self, text: str) -> str:
        return self._several.sub(lambda name: _BETWEEN.join(name[0].split()), text)

    @cached_property
    def _several(self) -> re.Pattern[str]:
        """What finds the names of several words, the longest first, in the singular or plural."""
        return _any_of((name for name in self.names if " " in name), "(?:e?s)?")

    @cached_property
    def _motions(self) -> re.Pattern[str]:
        """What finds the motions of several words; two that are joined are put together after the parsing."""
        several = (motion for motion in self.verbs.motions if " " in motion and " and " not in motion)
        return _any_of(several, "")


def _any_of(phrases: Iterable[str], ending: str) -> re.Pattern[str]:
    longest_first = sorted(phrases, key=lambda phrase: (-len(phrase), phrase))
    words = "|".join(re.escape(phrase).replace(r"\ ", r"\s+") for phrase in longest_first)
    return re.compile(rf"\b(?:{words}){ending}\b" if words else r"(?!)", re.IGNORECASE)
