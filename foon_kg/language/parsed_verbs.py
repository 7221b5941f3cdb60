"""Which parsed verbs are actions, and how they are called: no purposes, no other ways of doing it, no reasons."""

from __future__ import annotations

from typing import Any

from foon_kg.food.lists import word_list
from foon_kg.language.drafting.verbs import Verbs, is_verb
from foon_kg.language.nouns import BEFORE_A_CLAUSE

MAKES = frozenset({"make", "form", "create", "get"})
LEFT_TO_ITSELF = word_list("leaves it to itself")
OBJECTS = ("dobj", "obj", "nsubjpass", "nsubj:pass")
UNTIL = frozenset({"until", "till"})

_CLAUSE_DEPS = frozenset({"ROOT", "conj", "ccomp", "xcomp", "advcl", "dep", "parataxis", "pcomp"})
_BY_ITSELF = word_list("without hands")
_WHEN_OR_WHY = word_list("tells when or why")

Token = Any  # spaCy says nothing of its types


def is_action(token: Token) -> bool:
    """Return whether a verb (``token``) is something that is done."""
    if token.pos_ != "VERB" or token.dep_ not in _CLAUSE_DEPS or _is_negated(token):
        return False
    if token.dep_ == "pcomp" and token.head.lower_ not in BEFORE_A_CLAUSE:
        return False
    if token.lemma_ in LEFT_TO_ITSELF and _inner(token) is not None:
        return False  # begin to chop, let it cool
    return not (_is_purpose(token) or _is_alternative(token) or _is_background(token))


def _is_negated(verb: Token) -> bool:
    return any(child.dep_ == "neg" for child in verb.children)


def has_object(verb: Token) -> bool:
    """Return whether something stands as the object of a ``verb``."""
    return any(child.dep_ in OBJECTS for child in verb.children)


def _inner(verb: Token) -> Token | None:
    """Return the verb for which another only lets it happen."""
    return next((child for child in verb.children if child.dep_ in {"ccomp", "xcomp"} and child.pos_ == "VERB"), None)


def _is_purpose(token: Token) -> bool:
    """Whether a verb only says what for: "toss to coat"; but to cool is what is done next, and goes on by itself."""
    if not any(child.lower_ == "to" and child.dep_ == "aux" for child in token.children):
        return False
    return token.head.lemma_ not in LEFT_TO_ITSELF and token.lemma_ not in _BY_ITSELF


def _is_alternative(token: Token) -> bool:
    """Whether a verb is the other way of doing it: "roll or press"."""
    return token.dep_ == "conj" and any(child.dep_ == "cc" and child.lower_ == "or" for child in token.head.children)


def other_way(token: Token) -> Token:
    """Return the other verb of ``token`` where only that has an object: the press of "roll or press the dough"."""
    others = [child for child in token.children if child.dep_ == "conj" and _is_alternative(child)]
    return others[0] if others and not has_object(token) else token


def _is_background(token: Token) -> bool:
    """Whether a clause tells when or why: "until golden", "so that it is covered"; stirring meanwhile is an action."""
    if token.dep_ not in {"advcl", "ccomp"}:
        return False
    if token.tag_ == "VBG" and not any(child.dep_ == "nsubj" for child in token.children):
        return False  # stirring meanwhile
    return any(child.dep_ in {"mark", "advmod"} and child.lower_ in _WHEN_OR_WHY for child in token.children)


def lemma_of(verb: Token, verbs: Verbs) -> str:
    """Return a verb as a motion is called; the pipeline makes "shre" of "shred"."""
    if (called := verb.doc.user_data["called"].get(verb.i)) is not None:
        return str(called)
    lemma = str(verb.lemma_).lower()
    return lemma if is_verb(lemma, verbs.motions) or not is_verb(verb.lower_, verbs.motions) else str(verb.lower_)
