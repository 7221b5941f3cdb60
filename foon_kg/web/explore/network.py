"""A FOON as things to wander among: foods, utensils, objects in their states, steps, motions, videos and dish types.

Each thing has an ``id`` (``kind:name``) by which a page asks for it. All is read off one FOON in memory, so that it is
the same whether that came from files or from Neo4j; the indexes are made when they are first needed.
"""

from __future__ import annotations

import difflib
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence, Sized
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, TypeVar, cast

from foon_kg.foon import Snapshot
from foon_kg.formats.exports.phrases import motion_said
from foon_kg.model import Annotation, Goal, KnownUnit, ObjectNode
from foon_kg.web.questions import UnknownError

ThingKind = Literal["food", "utensil", "object", "step", "motion", "video", "dish", "other"]
"""``other`` is what an answer in Cypher has beside these: a node of the graph that has no neighbours here."""


@dataclass(frozen=True)
class Thing:
    """Something in the picture: ``name`` is written on it, ``states`` below; ``steps`` is in how many it takes part.

    The ``note`` of an object says what is in it and where it is, that of a step is a sentence, that of a motion the
    FOON's word for it where that is said otherwise. The ``steps`` of a step are its places in videos.
    A ``vessel`` is an object that is a utensil, and ``empty`` where it holds no food: nothing is followed through it.
    """

    id: str
    kind: ThingKind
    name: str
    states: tuple[str, ...]
    steps: int
    note: str = ""
    vessel: bool = False
    empty: bool = False


@dataclass(frozen=True, order=True)
class Edge:
    """What joins two things, from ``source`` to ``target``, both by their ids.

    ``kind`` is ``takes``, ``makes``, ``called``, ``contains``, ``motion``, ``seen in``, ``type`` or ``shows``; in an
    answer to a question in Cypher also what the graph calls a relationship that is none of these.
    """

    source: str
    target: str
    kind: str


@dataclass(frozen=True)
class Filters:
    """Which steps count: those in one of ``videos``, of one of ``motions``, in a video of one of ``dish_types``.

    An empty one lets all through. Empty utensils that a step takes are left out unless ``utensils``.
    """

    videos: frozenset[str] = frozenset()
    motions: frozenset[str] = frozenset()
    dish_types: frozenset[str] = frozenset()
    utensils: bool = False


NO_FILTERS = Filters()

_CALLED: tuple[ThingKind, ...] = ("food", "utensil", "motion", "dish", "video")
"""What a name alone may be the name of, in this order."""

K = TypeVar("K")
V = TypeVar("V")


class Network:
    """The things of one FOON, and what joins them."""

    def __init__(self, snapshot: Snapshot) -> None:
        self.snapshot = snapshot
        self.kitchen = snapshot.kitchen

    def thing(self, name: str) -> Thing:
        """Return the thing with the id ``name``, else the one of that name; raises UnknownError where there is none."""
        made = self._made.get(name)
        if made is not None:
            return made
        if not self.has(name):
            called = next((one for kind in _CALLED if self.has(one := f"{kind}:{name}")), None)
            if called is None:
                raise UnknownError(f"this FOON has no “{name}”", hint=self._meant(name))
            return self.thing(called)
        kind, _, rest = name.partition(":")
        made = self._made[name] = self._make(cast("ThingKind", kind), rest)
        return made

    def _meant(self, name: str) -> str:
        known = [other for kind in _CALLED for other in self.names(kind)]
        near = difflib.get_close_matches(name, known, n=2)
        return f"Did you mean {' or '.join(near)}?" if near else "Search for a part of its name."

    def has(self, name: str) -> bool:
        """Return whether there is a thing with the id ``name``."""
        kind, _, rest = name.partition(":")
        return rest in self._names.get(kind, ())

    def names(self, kind: ThingKind) -> Collection[str]:
        """Return what follows the colon in the ids of a ``kind``."""
        return self._names[kind]

    def largest(self, counts: Mapping[ThingKind, int]) -> list[Thing]:
        """Return so many things of each kind as ``counts`` say: those that take part in the most steps."""
        found = {kind: [self.thing(f"{kind}:{name}") for name in self.names(kind)] for kind in counts}
        return [
            thing
            for kind, count in counts.items()
            for thing in sorted(found[kind], key=lambda one: (-one.steps, one.id))[:count]
        ]

    def object_of(self, thing: Thing) -> ObjectNode:
        """Return the object node that a thing of the kind ``object`` stands for."""
        return self.nodes[thing.id.partition(":")[2]]

    def done_by(self, thing: Thing) -> Sequence[KnownUnit]:
        """Return the steps with the motion that a thing of the kind ``motion`` stands for."""
        return self.of_motion[thing.id.partition(":")[2]]

    def step_of(self, thing: Thing) -> KnownUnit:
        """Return the functional unit that a thing of the kind ``step`` stands for."""
        return self.units[thing.id.partition(":")[2]]

    def passes(self, known: KnownUnit, filters: Filters) -> bool:
        """Return whether the step of a ``known`` unit passes ``filters``."""
        videos = {seen.video for seen in known.seen_in}
        if filters.motions and known.unit.motion not in filters.motions:
            return False
        if filters.videos and videos.isdisjoint(filters.videos):
            return False
        return not filters.dish_types or any(
            not filters.dish_types.isdisjoint(self.dish_types.get(video, ())) for video in videos
        )

    @cached_property
    def nodes(self) -> Mapping[str, ObjectNode]:
        """Every object node by its key."""
        units = (known.unit for known in self.snapshot.units)
        return {node.key: node for unit in units for node in (*unit.input_nodes, *unit.output_nodes)}

    @cached_property
    def units(self) -> Mapping[str, KnownUnit]:
        """Every functional unit by its key."""
        return {known.unit.key: known for known in self.snapshot.units}

    @cached_property
    def takers(self) -> Mapping[ObjectNode, list[KnownUnit]]:
        """The steps that take an object."""
        return grouped((node, known) for known in self.snapshot.units for node in known.unit.input_nodes)

    @cached_property
    def makers(self) -> Mapping[ObjectNode, list[KnownUnit]]:
        """The steps that make an object."""
        return grouped((node, known) for known in self.snapshot.units for node in known.unit.output_nodes)

    @cached_property
    def called(self) -> Mapping[str, list[ObjectNode]]:
        """The objects with a label."""
        return grouped((node.label, node) for node in self.nodes.values())

    @cached_property
    def of_motion(self) -> Mapping[str, list[KnownUnit]]:
        """The steps with a motion."""
        return grouped((known.unit.motion, known) for known in self.snapshot.units)

    @cached_property
    def in_video(self) -> Mapping[str, list[KnownUnit]]:
        """The steps of a video in their order, each once."""
        found = grouped((seen.video, (seen.position, known)) for known in self.snapshot.units for seen in known.seen_in)
        return {
            video: list({known.unit.key: known for _, known in sorted(steps, key=lambda step: step[0])}.values())
            for video, steps in found.items()
        }

    @cached_property
    def goals(self) -> Mapping[ObjectNode, list[Goal]]:
        """What is known of an object that is a dish."""
        return grouped((goal.node, goal) for goal in self.snapshot.goals())

    @cached_property
    def goals_with(self) -> Mapping[str, list[ObjectNode]]:
        """The dishes that are made of a food."""
        return grouped((food, node) for node in self.goals for food in node.ingredients)

    @cached_property
    def goals_of_type(self) -> Mapping[str, list[ObjectNode]]:
        """The dishes of a type."""
        return grouped((goal.dish_type, goal.node) for goal in self.snapshot.goals())

    @cached_property
    def goals_in(self) -> Mapping[str, list[ObjectNode]]:
        """The dishes that a video shows."""
        return grouped((video, goal.node) for goal in self.snapshot.goals() for video in goal.videos)

    @cached_property
    def dish_types(self) -> Mapping[str, list[str]]:
        """The dish types of a video."""
        return grouped((video, goal.dish_type) for goal in self.snapshot.goals() for video in goal.videos)

    @cached_property
    def _names(self) -> Mapping[str, Collection[str]]:
        names = sorted({*self.called, *self.goals_with})
        return {
            "food": dict.fromkeys(name for name in names if not self.kitchen.is_utensil(name)),
            "utensil": dict.fromkeys(name for name in names if self.kitchen.is_utensil(name)),
            "dish": dict.fromkeys(sorted(self.goals_of_type)),
            "motion": dict.fromkeys(sorted(self.of_motion)),
            "video": dict.fromkeys(subgraph.name for subgraph in self.snapshot.subgraphs),
            "object": self.nodes.keys(),
            "step": self.units.keys(),
        }

    @cached_property
    def _made(self) -> dict[str, Thing]:
        """The things that were asked for: of a large FOON few ever are."""
        return {}

    @cached_property
    def _steps_with(self) -> Mapping[str, int]:
        """In how many steps things with a label take part."""
        units = (known.unit for known in self.snapshot.units)
        return Counter(
            label for unit in units for label in {node.label for node in (*unit.input_nodes, *unit.output_nodes)}
        )

    def _make(self, kind: ThingKind, name: str) -> Thing:
        if kind == "object":
            return self._object(self.nodes[name])
        if kind == "step":
            known = self.units[name]
            return Thing(f"step:{name}", kind, motion_said(known.unit.motion), (), len(known.seen_in))
        if kind == "motion":
            said, steps = motion_said(name), len(self.of_motion[name])
            return Thing(f"motion:{name}", kind, said, (), steps, note="" if said == name else name)
        if kind in {"food", "utensil"}:
            return Thing(f"{kind}:{name}", kind, name, (), self._steps_with.get(name, 0), vessel=kind == "utensil")
        parts: Mapping[str, Sized] = self.goals_of_type if kind == "dish" else self._annotations
        return Thing(f"{kind}:{name}", kind, name, (), len(parts[name]))

    @cached_property
    def _annotations(self) -> Mapping[str, Sequence[Annotation]]:
        return {subgraph.name: subgraph.annotations for subgraph in self.snapshot.subgraphs}

    def _object(self, node: ObjectNode) -> Thing:
        steps = {u.unit.key for u in (*self.takers.get(node, ()), *self.makers.get(node, ()))}
        vessel = self.kitchen.is_utensil(node.label)
        empty = vessel and not self.kitchen.foods_in(node)
        name = f"object:{node.key}"
        return Thing(name, "object", node.label, node.states, len(steps), _note(node), vessel, empty)


def _note(node: ObjectNode) -> str:
    held = "{" + ", ".join(node.ingredients) + "}" if node.ingredients else ""
    place = f"{node.relation or 'at'} {node.container}" if node.container else ""
    return " ".join(filter(None, (held, place)))


def grouped(pairs: Iterable[tuple[K, V]]) -> dict[K, list[V]]:
    """Return the values of each key in ``pairs``, in their order."""
    found: defaultdict[K, list[V]] = defaultdict(list)
    for key, value in pairs:
        found[key].append(value)
    return dict(found)
