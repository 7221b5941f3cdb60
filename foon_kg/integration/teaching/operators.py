"""Operators: in which ways a FOON does something to which foods, each with the units that attest it.

An operator is a motion with its tools. It is *attested* for a food by the units that do it to that food; for a food
that no unit has, by those that do it to a like food, or to one of its kind.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import IntEnum
from functools import cached_property

from foon_kg.food import Tables, tables
from foon_kg.food.lists import word_list
from foon_kg.integration.teaching.forms import form_of
from foon_kg.model import UNMEASURED, KnownUnit, Sighting
from foon_kg.model.recent import Recent
from foon_kg.model.values import made_often
from foon_kg.world.reading import NodeReading, Reader, reader

MOST_SIGHTINGS = 3
"""How many units are named as evidence of one step: enough to look one up, and few enough to keep in the graph."""

LIKE_AT_ALL = 0.3
"""From this confidence on it means something that one unlike food is less unlike than another."""

LEAST_SHARE = 0.04
"""A way is usual if at least this share of the units that bring food of a form bring it so.

One odd annotation in 25 (liquid that is "picked and placed") makes no way that others follow."""

MOST_KEPT = 1024
"""For how many states it is kept which ways give them: people may ask for any word as a state."""

Way = tuple[str, tuple[str, ...]]
"""A motion and the labels of its tools, sorted."""

Likes = Callable[[str], Sequence[tuple[str, float]]]
"""The known foods that can stand for a food, best first, each with its confidence."""

Alike = Callable[[str, str], float]
"""How sure a cook is to accept a known food (the second) for another one (the first), 0 to 1."""


class Nearness(IntEnum):
    """How near the evidence of a step is: the same food, a like one, one of its kind, the motion alone.

    Of a step without food the appliance counts: the same one, one that works like it (its kind), the motion alone.
    """

    FOOD = 0
    LIKE = 1
    KIND = 2
    MOTION = 3

    @property
    def word(self) -> str:
        """The word of a plan result."""
        return self.name.lower()


@made_often()
class Attested:
    """A way of doing something, and the units that attest it.

    ``like`` is (food, equivalent, confidence) where the evidence is that of another food which stands for it.
    """

    way: Way
    nearness: Nearness
    sightings: Sequence[Sighting]
    like: tuple[str, str, float] | None = None

    @cached_property
    def seen_in(self) -> tuple[Sighting, ...]:
        """The first of the sightings: what is named as evidence; kept, as sorting costs and few ways are taken."""
        return tuple(_first(self.sightings))


def _first(sightings: Sequence[Sighting]) -> list[Sighting]:
    if len(sightings) == 1:  # as of each unit that is looked at by itself
        return list(sightings)
    return sorted(set(sightings), key=lambda seen: (seen.video, seen.position))[:MOST_SIGHTINGS]


@dataclass
class Evidence:
    """The units that attest a way: the first few of each food and kind, the first few of all, and how many there are.

    ``often`` counts the units by food; ``appliances`` has the first few of each appliance that takes part.
    """

    foods: defaultdict[str, list[Sighting]] = field(default_factory=lambda: defaultdict(list))
    kinds: defaultdict[str, list[Sighting]] = field(default_factory=lambda: defaultdict(list))
    all: list[Sighting] = field(default_factory=list)
    count: int = 0
    often: Counter[str] = field(default_factory=Counter)
    appliances: defaultdict[str, list[Sighting]] = field(default_factory=lambda: defaultdict(list))

    def copy(self) -> Evidence:
        """Return the same evidence, to which more can be added."""
        foods, kinds, often = self.foods.copy(), self.kinds.copy(), self.often.copy()
        return Evidence(foods, kinds, self.all, self.count, often, self.appliances)

    def keep_the_first(self) -> None:
        """Forget all sightings but those that may be named."""
        self.all = _first(self.all)
        for sightings in (self.foods, self.kinds, self.appliances):
            for name, seen in sightings.items():
                sightings[name] = _first(seen)


class Operators:
    """The operators of a FOON. ``units`` may come in any order; what is kept does not depend on it (contract C9).

    ``evidence`` has for each way the units that do so, ``acts`` of these the ones that change a food by it. ``giving``
    counts by state the ways that give it; ``bringing`` by food, kind or form, and by the role of what that comes out
    of, the ways that bring it; ``onto`` by way the vessels in or on which things are then. ``states`` are those in
    which a food or kind is seen, ``foods`` all foods that are.
    """

    def __init__(self, units: Iterable[KnownUnit], known: Tables | None = None) -> None:
        self.known = known or tables()
        self._reader: Reader = reader(self.known)
        self.evidence: defaultdict[Way, Evidence] = defaultdict(Evidence)
        self.acts: defaultdict[Way, Evidence] = defaultdict(Evidence)
        self.giving: defaultdict[str, Counter[Way]] = defaultdict(Counter)
        self.bringing: defaultdict[tuple[str, str], Counter[Way]] = defaultdict(Counter)
        self.onto: defaultdict[Way, Counter[str]] = defaultdict(Counter)
        self.states: defaultdict[str, set[str]] = defaultdict(set)
        self.foods: set[str] = set()
        self._fine: dict[Way, float] = {}
        self._making: Recent[str, tuple[Way, ...]] = Recent(MOST_KEPT)
        self._brings: dict[tuple[str, str], tuple[Way, ...]] = {}
        self._brings_such: dict[tuple[str, str, str], tuple[Way, ...]] = {}
        for known_unit in sorted(units, key=lambda known_unit: known_unit.unit.key):
            self._add(known_unit)
        for evidence in (*self.evidence.values(), *self.acts.values()):
            evidence.keep_the_first()

    def _add(self, known_unit: KnownUnit) -> None:
        unit = known_unit.unit
        seen = [
            replace(one, measures=UNMEASURED) if one.measures else one for one in known_unit.seen_in[:MOST_SIGHTINGS]
        ]
        inputs = [self._reader.read(node) for node in unit.input_nodes]
        outputs = [self._reader.read(node) for node in unit.output_nodes]
        both = (*inputs, *outputs)
        way = (unit.motion, _tools_of(inputs))
        self._attest(self.evidence[way], _foods(both), seen)
        for appliance in sorted({said.label for said in both if said.is_appliance}):
            self.evidence[way].appliances[appliance].extend(seen)
        for said in both:
            self._note_states(said)
        changed = self._changes(inputs, outputs, way)
        if changed:
            self._attest(self.acts[way], changed, seen)

    def _attest(self, evidence: Evidence, foods: set[str], seen: Sequence[Sighting]) -> None:
        evidence.all.extend(seen)
        evidence.count += 1
        evidence.often.update(foods)
        self.foods |= foods
        for food in sorted(foods):
            evidence.foods[food].extend(seen)
        for kind in sorted({self.known.foods.find(food)[0] for food in foods} - {"unknown"}):
            evidence.kinds[kind].extend(seen)

    def _note_states(self, said: NodeReading) -> None:
        """Note in which states a food comes, by its name and by its kind."""
        if said.is_food:
            kind = self.known.foods.food(said.label, said.node.states).kind
            for name in (said.label, f"kind:{kind}"):
                self.states[name].update(said.node.states)

    def _changes(self, inputs: Sequence[NodeReading], outputs: Sequence[NodeReading], way: Way) -> set[str]:
        """Note what a unit does to which food by ``way``; return the foods that it changes."""
        before = {said.label: said for said in inputs if said.is_food}
        changed = set()
        for said in outputs:
            was = before.get(said.label)
            if said.is_food and was is not None and was.node != said.node:
                changed.add(said.label)
                self._note_change(was, said, way)
        return changed

    def _note_change(self, was: NodeReading, said: NodeReading, way: Way) -> None:
        """Note what ``way`` gives to a food, where it is then, and from where to where it was brought."""
        if said.place_utensil is not None and said.place_utensil.role == "vessel":
            self.onto[way][str(said.place)] += 1
        for state in sorted(set(said.node.states) - set(was.node.states)):
            self.giving[state.lower()][way] += 1
        if said.place == was.place or said.place_utensil is None:
            return
        # by its own name, its kind and its form: the fewer units know a food, the broader the name that answers for it
        kind = self.known.foods.food(said.label, was.node.states).kind
        form = form_of(self.known, said.label, was.node.states)
        role = was.place_utensil.role if was.place_utensil is not None else ""
        for name in (said.label, f"kind:{kind}", f"form:{form}"):
            self.bringing[name, role][way] += 1

    def to_be_told(self, ways: Iterable[Way]) -> Operators:
        """Return the same operators, which can be told more of foods to which ``ways`` are done.

        All that does not depend on single foods is shared with these, and worked out once.
        """
        # what is read of single foods is copied, for one recipe; the rest is the same object, which nobody changes
        found = Operators((), self.known)
        found.giving, found.onto = self.giving, self.onto
        found._making, found._fine, found._brings = self._making, self._fine, self._brings
        vars(found).update(ways=self.ways, _ways_of=self._ways_of, _able=self._able)
        found.bringing.update(self.bringing)
        found.states.update(self.states)
        found.foods.update(self.foods)
        for evidence, own_evidence in ((self.evidence, found.evidence), (self.acts, found.acts)):
            own_evidence.update(evidence)
            own_evidence.update((way, evidence[way].copy()) for way in ways if way in evidence)
        return found

    def attested(
        self,
        way: Way,
        foods: Sequence[str],
        likes: Likes | None = None,
        *,
        act: bool = False,
        instead: Collection[str] = (),
        appliance: str = "",
    ) -> Attested | None:
        """Return the nearest evidence that ``way`` is done to one of ``foods`` (singular names, the main one first).

        ``act``: to one that it changes. ``None`` where no unit of the motion has one of them, a like one or one of
        their kind. Of the foods in ``instead`` a person wishes that they be handled like another one. Without foods it
        is done with ``appliance``, where one takes part.
        """
        evidence = self._evidence(way, act=act)
        if evidence is None:
            return None
        if not foods:
            return self._attested_with(way, evidence, appliance)
        for food in foods:
            if food in evidence.foods and food not in instead:
                return Attested(way, Nearness.FOOD, evidence.foods[food])
        alike = _first_alike(evidence, foods, likes) if likes is not None else None
        if alike is not None:
            return Attested(way, Nearness.LIKE, evidence.foods[alike[1]], alike)
        kind = self._first_kind(evidence, foods)
        return Attested(way, Nearness.KIND, evidence.kinds[kind]) if kind is not None else None

    def _attested_with(self, way: Way, evidence: Evidence, appliance: str) -> Attested:
        """Return the ``evidence`` of a ``way`` by units with ``appliance``, else with one like it, else by all."""
        if appliance in evidence.appliances:
            return Attested(way, Nearness.FOOD, evidence.appliances[appliance])
        own = self.known.utensil(appliance)
        for name in sorted(evidence.appliances):
            other = self.known.utensil(name)
            if own is not None and other is not None and own.works_like(other):
                return Attested(way, Nearness.KIND, evidence.appliances[name])
        return Attested(way, Nearness.MOTION, evidence.all)

    def _first_kind(self, evidence: Evidence, foods: Sequence[str]) -> str | None:
        kinds = (self.known.foods.find(food)[0] for food in foods)
        return next((kind for kind in kinds if kind in evidence.kinds), None)

    def _evidence(self, way: Way, *, act: bool) -> Evidence | None:
        return (self.acts if act else self.evidence).get(way)

    def farthest(self, way: Way, foods: Sequence[str], alike: Alike, *, act: bool = False) -> Attested | None:
        """Return the evidence for the likest food to which ``way`` is done, be it not fairly like one of ``foods``.

        Where none is ``alike`` at all (:data:`LIKE_AT_ALL`) the motion alone is attested, by the food to which it is
        done most often, and no food is named that stands for another. ``act``: to a food that it changes.
        """
        evidence = self._evidence(way, act=act)
        if evidence is None or not foods or not evidence.foods:
            return None
        # equally alike ones are ordered by their names, so that the same question has the same answer
        sure, food, known = max((alike(food, known), food, known) for food in foods for known in evidence.foods)
        if sure < LIKE_AT_ALL:
            usual = min(evidence.often, key=lambda name: (-evidence.often[name], name))
            return Attested(way, Nearness.MOTION, evidence.foods[usual])
        return Attested(way, Nearness.LIKE, evidence.foods[known], (food, known, sure))

    def _by_frequency(self) -> list[Way]:
        """Return all ways, the most frequent first."""
        return sorted(self.evidence, key=lambda way: (-self.evidence[way].count, way))

    @cached_property
    def ways(self) -> Mapping[str, tuple[Way, ...]]:
        """The ways whose motion does each class of thing (cut, peel, heat …), the most frequent first."""
        found: defaultdict[str, list[Way]] = defaultdict(list)
        for way in self._by_frequency():
            for name in self.known.motion(way[0]).does:
                found[name].append(way)
        return {name: tuple(ways) for name, ways in found.items()}

    def ways_of(self, motion: str) -> tuple[Way, ...]:
        """Return the ways with one motion, the most frequent first."""
        return self._ways_of.get(motion, ())

    @cached_property
    def _ways_of(self) -> Mapping[str, tuple[Way, ...]]:
        found: defaultdict[str, list[Way]] = defaultdict(list)
        for way in self._by_frequency():
            found[way[0]].append(way)
        return {motion: tuple(ways) for motion, ways in found.items()}

    def works_on(self, way: Way, appliance: str) -> bool:
        """Return whether some unit does ``way`` with an appliance."""
        evidence = self.evidence.get(way)
        return evidence is not None and appliance in evidence.appliances

    def count(self, way: Way) -> int:
        """Return how many units do it in this ``way``."""
        evidence = self.evidence.get(way)
        return evidence.count if evidence is not None else 0

    def making(self, state: str) -> tuple[Way, ...]:
        """Return the ways that give ``state`` in this FOON, the most frequent first, then those that can.

        Of the latter those come first that make pieces as fine as ``state`` says.
        """
        found = self._making.find(state)
        if found is None:
            found = self._making[state] = tuple(self._ways_making(state))
        return found

    def _ways_making(self, state: str) -> Iterator[Way]:
        given = self.giving.get(state, Counter())
        yield from sorted(given, key=lambda way: (-given[way], way))
        fine = self.known.state(state).fineness
        able = (way for way in self._able.get(state, ()) if way not in given)
        yield from sorted(able, key=lambda way: (abs(self._fineness(way) - fine), -self.count(way), way))

    def _fineness(self, way: Way) -> float:
        """Return how fine the pieces are that a way makes in this FOON, in the mean."""
        found = self._fine.get(way)
        if found is None:
            rows = [(self.known.state(state).fineness, ways[way]) for state, ways in self.giving.items() if way in ways]
            rows = [(fine, count) for fine, count in rows if fine]
            found = sum(fine * n for fine, n in rows) / sum(n for _, n in rows) if rows else 0.0
            self._fine[way] = found
        return found

    def brings(self, form: str, role: str) -> tuple[Way, ...]:
        """Return the usual ways to bring food of a form (:func:`form_of`) out of a vessel of a role, best first."""
        found = self._brings.get((form, role))
        if found is None:
            counts = self.bringing.get((f"form:{form}", role), Counter())
            least = sum(counts.values()) * LEAST_SHARE
            ways = sorted(counts, key=lambda way: (-counts[way], way))
            found = self._brings[form, role] = tuple(way for way in ways if counts[way] >= least)
        return found

    def brings_such(self, name: str, form: str, role: str) -> tuple[Way, ...]:
        """Return those of :meth:`brings`, for the same ``form`` and ``role``, that more than one unit brings a food by.

        ``name`` is its own or ``kind:``.
        """
        counts = self.bringing.get((name, role))
        if counts is None:
            return ()
        found = self._brings_such.get((name, form, role))
        if found is None:
            ways = (way for way in self.brings(form, role) if counts.get(way, 0) > 1)
            found = self._brings_such[name, form, role] = tuple(sorted(ways, key=lambda way: (-counts[way], way)))
        return found

    @cached_property
    def _able(self) -> Mapping[str, tuple[Way, ...]]:
        found: defaultdict[str, list[Way]] = defaultdict(list)
        for way in self._by_frequency():
            for state in self.known.motion(way[0]).gives:
                found[state].append(way)
        return {state: tuple(ways) for state, ways in found.items()}


def _first_alike(evidence: Evidence, foods: Sequence[str], likes: Likes) -> tuple[str, str, float] | None:
    """Return the first of ``foods`` with a known food that can stand for it and has evidence, and how well it can."""
    for food in foods:
        for known, sure in likes(food):
            if known in evidence.foods:
                return food, known, sure
    return None


_HANDS = word_list("bare hands")
"""What annotators name as a tool where there is none."""


def _tools_of(inputs: Iterable[NodeReading]) -> tuple[str, ...]:
    tools = {said.label for said in inputs if said.utensil is not None and said.utensil.role == "tool"} - _HANDS
    return tuple(sorted(tools))


def _foods(saids: Iterable[NodeReading]) -> set[str]:
    return {name for said in saids for name in (said.names | {said.label} if said.is_food else said.names)}
