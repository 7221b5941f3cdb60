"""What one thing of a FOON is, in words: for who looks at it in the picture."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import chain, islice

from foon_kg.formats.exports.phrases import listed, motion_said
from foon_kg.formats.exports.sentences import sentence
from foon_kg.model import KnownUnit, ObjectNode, Sighting
from foon_kg.web.explore.network import Network, Thing, ThingKind
from foon_kg.web.words import seen_at

MOST = 12
"""So many words of a fact, and so many places in videos, are told; the rest is counted."""


@dataclass(frozen=True)
class Fact:
    """Something that is known of a thing: a heading, and words below it."""

    name: str
    words: tuple[str, ...]


@dataclass(frozen=True)
class Place:
    """Where a thing is seen: the video, the place of the step in it from 0, the second, and the web address of that."""

    video: str
    step: int
    start: float | None
    address: str | None


@dataclass(frozen=True)
class About:
    """What a thing is: a sentence, facts, what else it belongs to (``links``), and where it is seen."""

    text: str
    facts: tuple[Fact, ...] = ()
    links: tuple[Thing, ...] = ()
    places: tuple[Place, ...] = ()


class Telling:
    """Tells what the things of a network are."""

    def __init__(self, network: Network) -> None:
        self.network = network
        self._tell: dict[ThingKind, Callable[[Thing], About]] = {
            "food": self._name,
            "utensil": self._name,
            "object": self._object,
            "step": self._step,
            "motion": self._motion,
            "video": self._video,
            "dish": self._dish,
        }

    def about(self, thing: Thing) -> About:
        """Return what ``thing`` is."""
        return self._tell[thing.kind](thing)

    def in_words(self, thing: Thing) -> Thing:
        """Return ``thing`` as it is told: a step has its sentence as its note, which takes too long for all at once."""
        if thing.kind != "step":
            return thing
        return replace(thing, note=sentence(self.network.step_of(thing).unit, self.network.kitchen))

    def _name(self, thing: Thing) -> About:
        nodes, dishes = self.network.called.get(thing.name, ()), self.network.goals_with.get(thing.name, ())
        states = Counter[str]()
        for node in nodes:
            states.update(dict.fromkeys(node.states, self.network.thing(f"object:{node.key}").steps))
        done = {known.unit.key: motion_said(known.unit.motion) for n in nodes for known in self._takers(n)}
        facts = (
            Fact("Done with it" if thing.vessel else "Done to it", _counted(Counter(done.values()))),
            Fact("Seen in the states", _counted(states)),
            Fact("In the dishes", _few(dict.fromkeys(node.label for node in dishes))),
        )
        text = f"A {thing.kind} that takes part in {_count(thing.steps, 'step')}."
        return About(text, _with_words(facts))

    def _takers(self, node: ObjectNode) -> Sequence[KnownUnit]:
        return self.network.takers.get(node, ())

    def _object(self, thing: Thing) -> About:
        network, node = self.network, self.network.object_of(thing)
        makers, takers = network.makers.get(node, []), network.takers.get(node, [])
        goals = network.goals.get(node, [])
        facts = (Fact("Holds" if thing.vessel else "Is made of", node.ingredients),)
        called = network.thing(f"{'utensil' if thing.vessel else 'food'}:{node.label}")
        types = [network.thing(f"dish:{goal.dish_type}") for goal in goals]
        places = places_of(chain.from_iterable(known.seen_in for known in (*makers, *takers)))
        said = "A dish: the end of a video." if goals else self._said_of(node, len(makers))
        text = f"{said} {_count(len(takers), 'step')} {'takes' if len(takers) == 1 else 'take'} it."
        return About(text, _with_words(facts), (called, *types), tuple(places))

    def _said_of(self, node: ObjectNode, makers: int) -> str:
        what = "A utensil" if self.network.kitchen.is_utensil(node.label) else "A food"
        if self.network.kitchen.has(node):
            return f"{what} as it is at hand in a kitchen."
        if not makers:
            return f"{what} as no kitchen has it and no step makes it."
        return f"{what} as {_count(makers, 'step')} {'makes' if makers == 1 else 'make'} it."

    def _step(self, thing: Thing) -> About:
        known = self.network.step_of(thing)
        facts = (
            Fact("Takes", tuple(map(str, known.unit.input_nodes))),
            Fact("Makes", tuple(map(str, known.unit.output_nodes))),
        )
        links = (self.network.thing(f"motion:{known.unit.motion}"),)
        return About(sentence(known.unit, self.network.kitchen), facts, links, tuple(places_of(known.seen_in)))

    def _motion(self, thing: Thing) -> About:
        is_utensil = self.network.kitchen.is_utensil
        foods, tools, motions = Counter[str](), Counter[str](), set[str]()
        for known in self.network.done_by(thing):
            motions.add(known.unit.motion)
            labels = {node.label for node in known.unit.input_nodes}
            foods.update(label for label in labels if not is_utensil(label))
            tools.update(label for label in labels if is_utensil(label))
        made = (one for one in self.network.snapshot.vocabulary().motions if one.motion in motions)
        makes = Counter({one.state: one.count for one in made})
        facts = (Fact("Makes", _counted(makes)), Fact("Done to", _counted(foods)), Fact("With", _counted(tools)))
        return About(f"A motion of {_count(thing.steps, 'step')}.", _with_words(facts))

    def _video(self, thing: Thing) -> About:
        subgraph = next(one for one in self.network.snapshot.subgraphs if one.name == thing.name)
        goals, types = self.network.goals_in.get(thing.name, ()), self.network.dish_types.get(thing.name, ())
        dishes = listed(node.label for node in goals)
        text = f"A video of {_count(thing.steps, 'step')}" + (f" that ends with {dishes}." if dishes else ".")
        links = tuple(self.network.thing(f"dish:{name}") for name in dict.fromkeys(types))
        whole = (Sighting(subgraph.name, 0, source) for source in subgraph.sources)
        return About(text, (), links, tuple(places_of(whole)))

    def _dish(self, thing: Thing) -> About:
        nodes = self.network.goals_of_type[thing.name]
        foods = Counter(food for node in nodes for food in node.ingredients)
        facts = (Fact("Made of", _counted(foods)),)
        return About(f"A type of dishes: {_count(thing.steps, 'dish', 'es')} of this FOON.", _with_words(facts))


def places_of(sightings: Iterable[Sighting]) -> list[Place]:
    """Return the first places of a step, of all its ``sightings``."""
    return [Place(seen.video, seen.position, seen.start, seen_at([seen])) for seen in islice(sightings, MOST)]


def _count(count: int, word: str, plural: str = "s") -> str:
    return f"{count} {word}{'' if count == 1 else plural}"


def _counted(words: Counter[str]) -> tuple[str, ...]:
    ordered = sorted(words, key=lambda word: (-words[word], word))
    return _few(f"{word} {words[word]}" for word in ordered)


def _few(words: Iterable[str]) -> tuple[str, ...]:
    told = list(dict.fromkeys(words))
    return (*told[:MOST], f"and {len(told) - MOST} more") if len(told) > MOST else tuple(told)


def _with_words(facts: Sequence[Fact]) -> tuple[Fact, ...]:
    return tuple(fact for fact in facts if fact.words)
