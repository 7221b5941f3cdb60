"""Words that the tables do not know, and what they are taken for: said once when a FOON or recipes are loaded.

A name that is not listed is a food to this program. So a tool of a new video becomes a food silently, and a food of
which nothing is known is never owed any cooking: people have to be told, and can add it to the tables.
"""

from __future__ import annotations

import difflib
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache

from foon_kg.food.lists import word_list
from foon_kg.food.rows import Match
from foon_kg.food.tables import Tables, tables
from foon_kg.food.words import plain_words, singular
from foon_kg.model import ObjectNode

_NEARLY = 0.85
"""How alike two words are written (difflib's ratio) of which one may be a slip of the other."""

_LIKE = 0.6
"""The same of a typing error that the tables have and its word."""

_SLIP_OF_A_MOTION = 0.75
"""The same for motions: they are few, so that one letter of a short one (poor: pour) is told as well."""

_LONG = 4
"""So many letters a word has at least of which another may be a slip: short words have too many that are like them."""

_LETTERS = 64
"""Letters are told apart by the last six bits of their code points."""


class WordKind(StrEnum):
    """Which table does not have a word."""

    FOOD = "food"
    UTENSIL = "utensil"
    STATE = "state"
    MOTION = "motion"


@dataclass(frozen=True, order=True)
class UnknownWord:
    """A word that the table of ``kind`` does not have, why it is thought to belong there, and what it is taken for.

    ``nearly``: its last words are listed, so that what it is taken for is hardly a guess ("garden salad": "salad").
    ``meant`` is a listed word that is written nearly so. ``slip``: the word is in the table, as a typing error.
    """

    kind: WordKind
    word: str
    taken_for: str
    why: str = ""
    nearly: bool = False
    meant: str = ""
    slip: bool = False

    @property
    def what(self) -> str:
        """What is wrong with the word, without what was done about it."""
        if self.slip:
            return f"“{self.word}” is a typing error (is “{self.meant}” meant?)"
        meant = f" (is “{self.meant}” meant?)" if self.meant else ""
        return f"“{self.word}” is not in the table of {self.kind}s{self.why and f', though {self.why}'}{meant}"

    def __str__(self) -> str:
        return f"{self.what}: taken for {self.taken_for}"


def unknown_words(nodes: Iterable[ObjectNode], motions: Iterable[str] = ()) -> tuple[UnknownWord, ...]:
    """Return the labels, names in ``{}``, places and states of ``nodes``, and the ``motions``, that no table lists.

    Each word is told once, by kind, then by the alphabet. A food counts as known where the table lists its name
    itself; a state or motion of several words where it lists each of them. Raises ReadError where a table that a user
    named cannot be read.
    """
    known, there = tables(), dict.fromkeys(nodes)
    found = [
        *_names(there, known),
        *_states(there, known),
        *(word for motion in dict.fromkeys(motions) for word in _motion(motion, known)),
        *_slips(there, known),
    ]
    return tuple(sorted(set(found)))


def by_one_another(words: Mapping[UnknownWord, int]) -> dict[UnknownWord, UnknownWord]:
    """Return each of ``words``, and what is told of it: where more files have a word like it, that it may be a slip.

    ``words`` are those that no table has, with how many files have each.
    """
    alike: defaultdict[tuple[WordKind, str], dict[str, int]] = defaultdict(dict)
    for word, files in words.items():
        lower = word.word.lower()
        there = alike[word.kind, lower[:1]]
        there[lower] = max(files, there.get(lower, 0))
    spelled = {key: Spellings(there) for key, there in alike.items()}
    told = {}
    for word, files in words.items():
        key = word.kind, word.word[:1].lower()
        meant = _commoner(word, files, spelled[key], alike[key])
        told[word] = replace(word, meant=meant) if meant else word
    return told


def _commoner(word: UnknownWord, files: int, spelled: Spellings, having: Mapping[str, int]) -> str:
    """Return which of the words ``spelled`` may be meant by ``word``, which so many ``files`` have: one that more have.

    ``having`` says how many files have each; it is ``""`` where there is none, and where it is known what is meant.
    """
    lower = word.word.lower()
    if word.meant or word.slip or len(lower) < _LONG:
        return ""
    return spelled.closest(lower, _NEARLY, lambda other: having[other] > files)


def _names(nodes: Iterable[ObjectNode], known: Tables) -> Iterator[UnknownWord]:
    """Yield unknown foods, and what looks like a utensil and is none of the table."""
    looks: dict[str, str] = {}
    written: dict[str, str] = {}
    for node in nodes:
        for name in filter(None, (node.label, *node.ingredients, node.container)):
            written.setdefault(singular(name), name)
        if node.container:
            looks.setdefault(singular(node.container), "something is in it or on it")
        if odd := _odd_state(node):
            looks.setdefault(singular(node.label), f"it is {odd}")
    for key, name in written.items():
        if key and known.utensil(key) is None and not known.foods.is_listed(key):
            yield _name(name, looks.get(key, ""), known)


def _odd_state(node: ObjectNode) -> str:
    """Return the first state of ``node`` that utensils alone are in, ``""`` where there is none."""
    return next((state for state in node.states if state.lower() in word_list("states of utensils alone")), "")


def _name(name: str, looks: str, known: Tables) -> UnknownWord:
    """Return what is told of the unlisted ``name``; ``looks`` says why it looks like a utensil, ``""`` for a food."""
    kind, taken_for, match = known.foods.find(name)
    last = singular(name).split()[-1]
    if match in {Match.UNKNOWN, Match.PART} and known.utensil(last) is not None:
        looks = f"its name says {last}"
    meant = _meant_name(singular(name), known)
    if looks and match in {Match.UNKNOWN, Match.PART}:
        return UnknownWord(WordKind.UTENSIL, name, "a food", looks, meant=meant)
    if match is Match.UNKNOWN:
        is_tool = bool(meant) and known.utensil(meant) is not None
        taken_for = "a food" if is_tool else "a food of no known kind"
        return UnknownWord(WordKind.UTENSIL if is_tool else WordKind.FOOD, name, taken_for, meant=meant)
    if match is Match.SUFFIX:
        return UnknownWord(WordKind.FOOD, name, f"a kind of {kind} by its ending “{taken_for}”", meant=meant)
    return UnknownWord(WordKind.FOOD, name, f"“{taken_for}”", nearly=match is Match.HEAD, meant=meant)


def _meant_name(name: str, known: Tables) -> str:
    """Return the listed food or utensil of which ``name`` may be a slip, ``""`` where it is none.

    Of several words only those are taken for slips that are in no listed name, so that "garden salad" is not meant as
    "green salad".
    """
    words, parts = _listed_names(known)
    if " " not in name:
        return _meant([name], words)
    mended = " ".join(part if part in parts else _meant([part], parts) or part for part in name.split())
    return mended if mended != name and mended in words else ""


@lru_cache(maxsize=1)
def _listed_names(known: Tables) -> tuple[frozenset[str], frozenset[str]]:
    """Return the names of all listed foods and utensils but the misspelled ones, and the words of these names."""
    slips = word_list("is a typing error")
    names = frozenset(map(singular, (*known.foods.kind_of, *known.utensils))) - slips
    return names, frozenset(word for name in names for word in name.split())


def _slips(nodes: Iterable[ObjectNode], known: Tables) -> Iterator[UnknownWord]:
    """Yield the typing errors that the tables understand, each with the word that is written most like it."""
    slips = word_list("is a typing error")
    names, _ = _listed_names(known)
    for node in nodes:
        for name in (node.label, *node.ingredients, *([node.container] if node.container else [])):
            if singular(name) in slips:
                kind = WordKind.FOOD if known.utensil(name) is None else WordKind.UTENSIL
                yield _slip(kind, name, names)
        for state in node.states:
            if state.lower() in slips:
                yield _slip(WordKind.STATE, state, frozenset(known.states) - slips)


def _slip(kind: WordKind, word: str, listed: frozenset[str]) -> UnknownWord:
    meant = _closest(word.lower(), listed, _LIKE)
    return UnknownWord(kind, word, f"“{meant}”", nearly=True, meant=meant, slip=True)


def _states(nodes: Iterable[ObjectNode], known: Tables) -> Iterator[UnknownWord]:
    """Yield the states of ``nodes`` that no table lists."""
    of_utensils = frozenset().union(*known.utensil_states.values())
    for node in nodes:
        for state in node.states:
            if state.endswith("]") or state.lower() in known.states or state.lower() in of_utensils:
                continue  # a place that the loader keeps as a state, or a state that some table lists
            yield from _phrase(WordKind.STATE, state, known.states.keys(), "one that says nothing of the food")


def _motion(motion: str, known: Tables) -> Iterator[UnknownWord]:
    if motion.lower() not in known.motions:
        yield from _phrase(WordKind.MOTION, motion, known.motion_words.keys(), "one of which nothing is known")


def _phrase(kind: WordKind, phrase: str, listed: Iterable[str], nothing: str) -> Iterator[UnknownWord]:
    """Yield ``phrase`` where not all of its words are ``listed``, small words apart.

    It is taken for its listed words; ``nothing`` says for what where there are none.
    """
    own = plain_words(phrase) - word_list("small words")
    there = own.intersection(listed)
    if own != there or not own:
        taken_for = " and ".join(f"“{word}”" for word in sorted(there))
        near = _SLIP_OF_A_MOTION if kind is WordKind.MOTION and not there else _NEARLY
        yield UnknownWord(kind, phrase, taken_for or nothing, meant=_meant(own - there, frozenset(listed), near))


def _meant(words: Iterable[str], listed: frozenset[str], near: float = _NEARLY) -> str:
    """Return the listed word that is written most like one of ``words``; ``""`` where none is ``near`` (0 to 1)."""
    close = (_closest(word, listed, near) for word in sorted(words) if len(word) >= _LONG)
    return next(filter(None, close), "")


@lru_cache(maxsize=1 << 12)
def _closest(word: str, listed: frozenset[str], near: float) -> str:
    """Return the ``listed`` word that is written most like ``word``; ``""`` where none is ``near``."""
    return _spelled(listed).closest(word, near)


@lru_cache(maxsize=8)
def _spelled(listed: frozenset[str]) -> Spellings:
    return Spellings(listed)


def _any_word(_word: str) -> bool:
    return True


class Spellings:
    """Words, by how long they are, each with the set of its letters as the bits of a number."""

    def __init__(self, words: Iterable[str]) -> None:
        self._by_length: defaultdict[int, list[tuple[int, str]]] = defaultdict(list)
        for word in frozenset(words):
            self._by_length[len(word)].append((_letters(word), word))

    def closest(self, word: str, near: float, allowed: Callable[[str], bool] = _any_word) -> str:
        """Return the word that is written most like ``word``, of those that are ``allowed``; ``""`` where none is near.

        ``near`` is difflib's ratio, above 0 and at most 1, that it has at least. It is the word that
        ``difflib.get_close_matches`` gives.
        """
        possible = list(filter(allowed, self._possible(word, near)))
        return next(iter(difflib.get_close_matches(word, possible, 1, near)), "")

    def _possible(self, word: str, near: float) -> Iterator[str]:
        """Yield the words that may be ``near``: a letter that the other word lacks has no counterpart there."""
        length, letters = len(word), _letters(word)
        for other_length, members in self._by_length.items():
            both = length + other_length
            if 2.0 * min(length, other_length) < near * both:
                continue
            for other_letters, other in members:
                own, others = (letters & ~other_letters).bit_count(), (other_letters & ~letters).bit_count()
                if 2.0 * min(length - own, other_length - others) >= near * both:
                    yield other


def _letters(word: str) -> int:
    letters = 0
    for letter in word:
        letters |= 1 << ord(letter) % _LETTERS
    return letters
