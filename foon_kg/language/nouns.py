"""What a parsed noun names: a thing with the states before it, the things that are joined to it, a measure of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.model.names import canonical
from foon_kg.model.narration import Mention
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.states import state_in

BEFORE_A_CLAUSE = frozenset({"after", "before", "by", "while"})
"""Prepositions before what is done (after mixing), so that a verb in -ing behind them names no thing."""

NAMES = frozenset({"NOUN", "PROPN", "PRON", "X"})
_PARTS_OF_A_NAME = frozenset({"compound", "amod", "nmod", "npadvmod"})
_MEASURES = word_list("measures in speech")
_MIXED = word_list("called a mixture")

Token = Any  # spaCy says nothing of its types


def spoken(token: Token) -> str:
    """Return the word of a token, or the name for which it stands in."""
    names: Mapping[int, str] = token.doc.user_data["names"]
    return names.get(token.idx, str(token.text))


def names_in(token: Token) -> Iterator[Mention]:
    """Yield the thing that a noun (``token``) names, and those joined to it; a measure names what it is of."""
    of = _of_what(token)
    measures = token.lemma_.lower() in _MEASURES
    if of and (measures or is_vessel(spoken(token))):
        yield from named_by(of)
        if not measures:
            yield _name(token)  # a pan of water: both
    elif token.pos_ in NAMES or token.dep_ in {"pobj", "dobj", "conj"}:
        yield from (Mention(spoken(one)) for one in _apart(token))
        yield _name(token)
    yield from named_by(_joined_to(token))


def _of_what(token: Token) -> list[Token]:
    return [thing for child in token.children if child.lower_ == "of" for thing in _objects_of(child)]


def named_by(nouns: Iterable[Token]) -> list[Mention]:
    """Return the things that ``nouns`` name, one after another."""
    return [name for noun in nouns for name in names_in(noun)]


def _objects_of(preposition: Token) -> list[Token]:
    return [child for child in preposition.children if child.dep_ == "pobj"]


def _joined_to(token: Token) -> list[Token]:
    """Return the nouns joined to one; none behind "or": of oil or butter the first is taken."""
    if any(child.dep_ == "cc" and child.lower_ == "or" for child in token.children):
        return []
    return [child for child in token.children if child.dep_ in {"conj", "appos"} and child.pos_ in NAMES]


def _name(token: Token) -> Mention:
    parts = _parts_of_name(token)
    states = [child.lower_ for child in parts if child.pos_ == "VERB" and state_in(child.lower_) is not None]
    words = [word for part in parts if part.lower_ not in states for word in (*_inside(part), spoken(part))]
    return Mention(" ".join((*words, spoken(token))), tuple(filter(None, map(state_in, states))))


def _parts_of_name(token: Token) -> list[Token]:
    """Return the words before a noun that are parts of its name; things of their own between them are none."""
    parts = [child for child in token.lefts if child.dep_ in _PARTS_OF_A_NAME and child.is_alpha]
    apart = _apart(token)
    if apart:
        parts = [*(other for part in parts for other in part.conjuncts), *parts]
    return [part for part in parts if part not in apart]


def _apart(token: Token) -> list[Token]:
    """Return the nouns before ``token`` that are things of their own: the garlic of "garlic and vegetable oil"."""
    parts = [child for child in token.lefts if child.dep_ in {"compound", "nmod"} and child.pos_ in {"NOUN", "PROPN"}]
    return [part for part in parts if part.conjuncts and any(child.dep_ == "cc" for child in part.children)]


def _inside(part: Token) -> list[str]:
    return [spoken(child) for child in part.lefts if child.dep_ == "compound" and child.is_alpha]


def governed(preposition: Token) -> list[Mention]:
    """Return what a preposition governs; a noun that the parser takes for a verb (dressing) is one all the same."""
    things = named_by(_objects_of(preposition))
    if not things and preposition.lower_ not in BEFORE_A_CLAUSE:
        things = [Mention(spoken(child)) for child in preposition.children if _is_mixture_like_a_verb(child)]
    nested = [child for child in preposition.children if child.dep_ == "prep"]  # out of, on top of
    return things or [name for child in nested for name in governed(child)]


def _is_mixture_like_a_verb(word: Token) -> bool:
    return word.dep_ == "pcomp" and word.lower_.endswith("ing") and word.lower_ in _MIXED


def is_vessel(name: str) -> bool:
    """Whether the last words of a name are a utensil: a large bowl, the preheated oven."""
    words = name.split()
    return any(Kitchen.default().is_utensil(" ".join(words[place:])) for place in range(len(words)))


def plural(word: str) -> str:
    """Return the plural of a word: patties, trays, dishes, boxes, cubes."""
    if word.endswith("y") and word[-2:-1] not in set("aeiou"):
        return f"{word[:-1]}ies"
    return f"{word}es" if word.endswith(("ch", "sh", "s", "x")) else f"{word}s"


def as_result(name: str) -> str | None:
    """Return the state that something goes on to by a ``name`` ("into cubes"); ``None`` for a place or a thing."""
    last = canonical(name).split()[-1:]
    thing = is_vessel(name) or not _MIXED.isdisjoint(last) or tables().foods.food(name).known
    return None if thing else state_in(name)
