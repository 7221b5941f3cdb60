"""Instructions as clauses, and each clause as a plain sentence that spaCy's parser reads well.

To the parser "Chop onion" is a noun, and "you chop onion" is not; the extract of "pour the vanilla extract" is a verb.
So imperatives get a subject, for each name of several words that a FOON has a plain noun stands in, and of a motion of
several words (cut open) the first stands for all.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from foon_kg.food import singular, tables
from foon_kg.food.lists import word_list
from foon_kg.language.drafting.verbs import Verbs, is_verb
from foon_kg.language.plain_speech import plain_speech
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.groups import food_groups
from foon_kg.similarity.states import state_in

VERB, FOOD, UTENSIL = "cut", "onion", "bowl"
"""Words that the parser takes for nothing else; they stand in for what it might."""

_CLAUSES = re.compile(r"(?<=[!?;])\s+|(?<=\.)\s+(?=[^a-z])|;\s*")
_FIRST = re.compile(r"(?:(?:\d+[.)]|step\s+\d+\W|then|next|now|finally|first|and|-|\*)[\s,]*)*", re.IGNORECASE)
_MANNER = r"(?:[a-z]+ly\s+(?:and\s+|but\s+)?)*"
_CHAIN = re.compile(r"[A-Za-z]+(?:,\s*[A-Za-z]+)*,?\s+(?:and|or)(?:\s+then)?\s+[A-Za-z]+(?=\s|$)")
_OF_A_THING = re.compile(r"[A-Za-z]+\s+(?:an?|the|all|both|each|it|them|your)\b")
_YOU = re.compile(r"\b([Yy]ou) \w+")
_SEASONS = frozenset({"coat", "scatter", "whip"})
_KEPT = re.compile(r"\bkeep\s+(\w+)ed\b", re.IGNORECASE)
_BEGINS = re.compile(rf"(?i:{_MANNER})([A-Za-z]+)")
_JOINED = re.compile(
    rf"((?:,|\band|\bthen|\bor)\s+(?:(?:and|then)\s+)?){_MANNER}([a-z]+)"
    r"(?=\s+(?:an?|the|it|them|until|till|in|into|for|on|onto|over|with|well|together|to|off|out|up|aside|again|from|your"
    r"|between|before|around|through|everything|all|each|\w+ly)\b|,|\s+(?:and|then)\s+[a-z]+|[\s.,]*$)"
)
_LEFT_TO_ITSELF = word_list("leaves it to itself")
_BETWEEN = "_"
_WORDS = re.compile(r"[^\W_](?:[\w'&-]*\w)?")
_LONGEST_NAME = 5  # words
_NAME = re.compile(r"[^\W_](?:[\w'&-]*_)+(?:[\w'&-]*\w)?")
_ENDS_A_NAME = re.compile(r"\s*(?:[,.;:!?]|$)|\s+(?:and|or|with|in|into|to|on|onto|over|until|till|from|at|together)\b")
_BARE = re.compile(r"\b(to|into|onto|in|on|over|from|with|of)\s+(?=[\w'&-]+_)")


@dataclass(frozen=True)
class PlainClause:
    """A clause as a plain sentence: ``original`` as it was written, ``text`` with names in one word.

    ``motion`` is what the second word of ``text`` stands for, where that is a verb. ``besides`` are the verbs before
    the first of ``text`` that are done to the same things: "peel, core and chop".
    """

    original: str
    text: str
    motion: str | None = None
    besides: tuple[str, ...] = ()

    def with_stand_ins(self, places: Collection[int]) -> PlainClause:
        """Return the same where the verbs at these ``places`` are one that no parser takes for a noun."""
        count = itertools.count()
        text = _YOU.sub(lambda you: f"{you[1]} {VERB}" if next(count) in places else you[0], self.text)
        return replace(self, text=text)

    def for_parser(self) -> tuple[str, dict[int, str]]:
        """Return the sentence with plain nouns in place of names, and the names by where these nouns begin."""
        parts: list[str] = []
        names: dict[int, str] = {}
        length = end = 0
        for found in _NAME.finditer(self.text):
            name = found[0].replace(_BETWEEN, " ").strip()
            noun = UTENSIL if Kitchen.default().is_utensil(name) else FOOD
            parts += [self.text[end : found.start()], noun]
            names[length + found.start() - end] = name
            length += found.start() - end + len(noun)
            end = found.end()
        return "".join((*parts, self.text[end:])), names


@dataclass(frozen=True)
class ClauseReader:
    """Reads texts for the ``verbs`` and the ``names`` of one FOON."""

    verbs: Verbs
    names: tuple[str, ...] = ()

    def of(self, text: str) -> list[PlainClause]:
        """Return the clauses of ``text`` that have words, in their order."""
        clauses = (part.strip(" ;") for part in _CLAUSES.split(text))
        return [self._plain(clause) for clause in clauses if any(map(str.isalpha, clause))]

    def _plain(self, clause: str) -> PlainClause:
        plain = plain_speech(clause[match.end() :] if (match := _FIRST.match(clause)) else clause).strip(" .,!?:")
        plain = _KEPT.sub(self._as_done, plain)
        first = _BEGINS.match(plain)
        if first is None or not self._is_verb(first[1]):
            return PlainClause(clause, _JOINED.sub(self._with_subject, self._with_names_as_words(plain)))
        plain = plain[first.start(1) :]
        besides, plain = self._chained(plain)
        first = _BEGINS.match(plain) or first
        motion = self._motions.match(plain)
        verb = motion[0] if motion else first[1]
        rest = self._with_names_as_words(plain[len(verb) :])
        let = first[1].lower() in _LEFT_TO_ITSELF
        article = " the" if self._begins_with_a_thing(rest) and not let else ""
        said = f"You {first[1].lower()}{article}{_JOINED.sub(self._with_subject, rest)}"
        return PlainClause(clause, said, motion[0].lower() if motion else None, besides)

    def _chained(self, plain: str) -> tuple[tuple[str, ...], str]:
        """Split the verbs off that come before another with the same objects; of alternatives the first is told."""
        chain = _CHAIN.match(plain)
        if chain is None:
            return (), plain
        words = re.findall(r"[A-Za-z]+", chain[0])
        verbs = [word for word in map(str.lower, words) if word not in {"and", "or", "then"}]
        if not all(map(self._is_verb, verbs)):
            return (), plain
        rest = plain[chain.end() - len(verbs[-1]) :]
        sure = _OF_A_THING.match(rest) or not any(map(tables().foods.is_listed, verbs[1:]))
        if self._motions.match(plain) or not sure:
            return (), plain
        if "or" in words[1:]:
            return (), f"{verbs[0]}{rest[len(verbs[-1]) :]}"
        return tuple(verbs[:-1]), rest

    def _is_verb(self, word: str) -> bool:
        return is_verb(word, self.verbs.motions)

    def _as_done(self, kept: re.Match[str]) -> str:
        """Return "refrigerate" for "keep refrigerated", where that is a verb."""
        stem = kept[1].lower()
        forms = (f"{stem}e", stem, stem[:-1] if stem[-1:] == stem[-2:-1] else stem)
        return next((form for form in forms if self._is_verb(form)), kept[0])

    def _is_seasoning(self, word: str) -> bool:
        """Whether a word at the end of a list is a food that may be a verb: salt and pepper."""
        return tables().foods.is_listed(word) and not tables().motion(word).does.isdisjoint(_SEASONS)

    def _begins_with_a_thing(self, rest: str) -> bool:
        """Whether a bare noun stands behind the verb; with an article no parser takes it for a part of that."""
        word = _WORDS.match(rest.strip())
        name = word[0].replace(_BETWEEN, " ").strip() if word is not None else ""
        is_thing = Kitchen.default().is_utensil(name) or tables().foods.is_listed(name)
        return bool(name) and is_thing and state_in(name) is None

    def _with_subject(self, joined: re.Match[str]) -> str:
        """Put "you" before a verb that is joined to another; not before a food (salt and butter in a bowl)."""
        word = joined[2]
        ends = not joined.string[joined.end() :].strip(" .,").strip() or joined.string[joined.end()] == ","
        after = re.match(r"\s+(?:and|then)\s+([a-z]+)", joined.string[joined.end() :])
        if after is not None and not self._is_verb(after[1]):
            return joined[0]
        food = canonical(word) in food_groups().places or (ends and self._is_seasoning(word))
        food = food and word not in tables().unfinished  # a mix is nothing that lies in a bowl
        before = joined[1] if joined[1].strip() != "," else ", and "
        return f"{before}you {word}" if self._is_verb(word) and not food else joined[0]

    def _with_names_as_words(self, text: str) -> str:
        """Return ``text`` with every name of several words as one word: the longest that FOON or tables have."""
        words = list(_WORDS.finditer(text))
        parts: list[str] = []
        place = end = 0
        while place < len(words):
            length = next(
                (n for n in range(_LONGEST_NAME, 1, -1) if self._is_name(text, words[place : place + n], n)), 1
            )
            last = words[place + length - 1]
            name = _BETWEEN.join(text[words[place].start() : last.end()].split())
            alone = _ENDS_A_NAME.match(text, last.end()) is not None and self._is_only_a_food(name)
            parts += [text[end : words[place].start()], name + (_BETWEEN if alone else "")]
            place, end = place + length, last.end()
        return _BARE.sub(r"\1 the ", "".join((*parts, text[end:])))

    def _is_only_a_food(self, word: str) -> bool:
        """Whether a word is a food and nothing else, so that a plain noun may stand in for it."""
        verb = self._is_verb(word) or self._is_verb(singular(word))
        return word.isalpha() and tables().foods.is_listed(word) and not verb and state_in(word) is None

    def _is_name(self, text: str, words: Sequence[re.Match[str]], length: int) -> bool:
        if len(words) < length:
            return False
        said = text[words[0].start() : words[-1].end()]
        return not any(map(str.isdigit, said)) and "," not in said and singular(said) in self._several

    @cached_property
    def _several(self) -> frozenset[str]:
        """The names of several words, in the singular."""
        known = tables()
        several = (name for name in (*known.utensils, *known.foods.kind_of) if " and " not in name)
        return frozenset(name for name in (*map(singular, self.names), *several) if " " in name)

    @cached_property
    def _motions(self) -> re.Pattern[str]:
        """What finds the motions of several words; two that are joined are put together after the parsing."""
        several = (motion for motion in self.verbs.motions if " " in motion and " and " not in motion)
        return _any_of(several, "")


def _any_of(phrases: Iterable[str], ending: str) -> re.Pattern[str]:
    longest_first = sorted(phrases, key=lambda phrase: (-len(phrase), phrase))
    words = "|".join(re.escape(phrase).replace(r"\ ", r"\s+") for phrase in longest_first)
    return re.compile(rf"\b(?:{words}){ending}\b" if words else r"(?!)", re.IGNORECASE)
