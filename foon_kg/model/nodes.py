"""The words of a FOON as plain values: object nodes, functional units, subgraphs, recipes.

Nothing here reads a file, a clock or a database. Everything is frozen, and equal when its contents are.
"""

from __future__ import annotations

import hashlib
import unicodedata
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from pathlib import Path
from typing import NamedTuple

from foon_kg.model.errors import ReadError
from foon_kg.model.json_text import compact_json

DISH_TYPES: tuple[str, ...] = (
    "bread", "soup", "roast", "pizza", "sandwich", "cake", "pie", "sauce", "pudding", "drinks",
    "cookie", "meatball", "muffin", "pasta", "noodle", "salad", "burger", "seafood", "steak", "rice",
    "chicken", "casserole", "vegetables", "omelette", "potatoes", "beef", "pork", "stir-fry", "meatloaf",
    "sausage",
)  # fmt: skip
"""The 30 dish classes; a subgraph file names one by its place in this order, 0 to 29."""

NodeSortKey = tuple[str, tuple[str, ...], tuple[str, ...], str, str]


def content_key(*parts: object) -> str:
    """Return a 32-digit hexadecimal name for ``parts`` (JSON values), the same on every machine and run."""
    return hashlib.blake2b(compact_json(parts).encode(), digest_size=16).hexdigest()


def _as_set(names: Iterable[str]) -> tuple[str, ...]:
    if isinstance(names, tuple) and len(names) <= 1:  # as most are
        return names
    return tuple(sorted(set(names)))


@dataclass(frozen=True)
class ObjectNode:
    """A thing in a state, with what it contains and where it is.

    Two nodes are the same when all five fields are equal; ``states`` and ``ingredients`` are sets, kept
    sorted and without repetition. ``relation`` is the word before the container (``in``, ``on``, ``with``);
    it is ``None`` where a source names a container but no relation.
    """

    label: str
    states: tuple[str, ...] = ()
    ingredients: tuple[str, ...] = ()
    relation: str | None = None
    container: str | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "states", _as_set(self.states))
        object.__setattr__(self, "ingredients", _as_set(self.ingredients))

    @cached_property
    def sort_key(self) -> NodeSortKey:
        """Return the place of this node in a total order, the same in every run: the last word in every tie (C9).

        >>> ObjectNode("onion", ("chopped",), (), "in", "bowl").sort_key
        ('onion', ('chopped',), (), 'in', 'bowl')
        """
        return (self.label, self.states, self.ingredients, self.relation or "", self.container or "")

    @cached_property
    def _hash(self) -> int:
        return hash((self.label, self.states, self.ingredients, self.relation, self.container))

    def __hash__(self) -> int:
        return self._hash  # nodes are looked up far more often than they are made

    def __reduce__(self) -> tuple[type[ObjectNode], tuple[object, ...]]:
        # the kept hash is true in one process only: another one has another seed
        return (ObjectNode, (self.label, self.states, self.ingredients, self.relation, self.container))

    @cached_property
    def key(self) -> str:
        """The content hash under which the graph keeps this node.

        >>> ObjectNode("onion", ("peeled", "chopped")).key == ObjectNode("onion", ("chopped", "peeled")).key
        True
        """
        return content_key(self.label, self.states, self.ingredients, self.relation, self.container)

    def __str__(self) -> str:
        words = [", ".join(self.states)] if self.states else []
        if self.ingredients:
            words.append("{" + ", ".join(self.ingredients) + "}")
        if self.container:
            words.append(f"{self.relation or 'at'} {self.container}")
        return self.label + (f" ({'; '.join(words)})" if words else "")


@lru_cache(maxsize=1 << 13)
def shared_node(
    label: str,
    states: tuple[str, ...] = (),
    ingredients: tuple[str, ...] = (),
    relation: str | None = None,
    container: str | None = None,
) -> ObjectNode:
    """Return the node with this ``label``, these ``states``, ``ingredients``, ``relation`` and ``container``.

    Where one was asked for of late it is the same, which is told at a glance to be equal.

    >>> shared_node("onion", ("chopped",)) is shared_node("onion", ("chopped",))
    True
    """
    return ObjectNode(label, states, ingredients, relation, container)


@dataclass(frozen=True)
class Participant:
    """An object node as one unit uses it: whether it moves, and which dish it completes, if any."""

    node: ObjectNode
    moving: bool = False
    dish_type: str | None = None


@dataclass(frozen=True)
class FunctionalUnit:
    """Input object nodes → one motion → output object nodes.

    ``inputs`` and ``outputs`` keep the order in which they were annotated. ``accepts_any`` is the star after a
    motion: any number of ingredients may enter here. Identity (``key``) is what is done to what: it knows
    nothing of order, moving flags or dish classes, so that the same action seen in two videos is one unit.
    """

    inputs: tuple[Participant, ...]
    motion: str
    outputs: tuple[Participant, ...]
    accepts_any: bool = False

    @cached_property
    def input_nodes(self) -> tuple[ObjectNode, ...]:
        """The distinct input nodes, in the order of annotation.

        >>> bowls = (Participant(ObjectNode("bowl")), Participant(ObjectNode("bowl")), Participant(ObjectNode("egg")))
        >>> [node.label for node in FunctionalUnit(bowls, "mix", ()).input_nodes]
        ['bowl', 'egg']
        """
        return tuple(dict.fromkeys(p.node for p in self.inputs))

    @cached_property
    def output_nodes(self) -> tuple[ObjectNode, ...]:
        """The distinct output nodes, in the order of annotation.

        >>> FunctionalUnit((), "mix", (Participant(ObjectNode("salad")), Participant(ObjectNode("salad")))).output_nodes
        (ObjectNode(label='salad', states=(), ingredients=(), relation=None, container=None),)
        """
        return tuple(dict.fromkeys(p.node for p in self.outputs))

    @cached_property
    def key(self) -> str:
        """The content hash under which the graph keeps this unit (its motion node).

        >>> egg, moved = Participant(ObjectNode("egg")), Participant(ObjectNode("egg"), moving=True)
        >>> FunctionalUnit((egg,), "beat", ()).key == FunctionalUnit((moved,), "beat", ()).key
        True
        """
        return content_key(
            sorted(node.key for node in self.input_nodes),
            self.motion,
            self.accepts_any,
            sorted(node.key for node in self.output_nodes),
        )


@dataclass(frozen=True)
class Timing:
    """When an action was seen, in seconds from the start of its video.

    ``spans`` is empty where nobody wrote a time down; ``assumed`` says that the annotator knew the action must
    have happened although the video does not show it.
    """

    spans: tuple[tuple[float, float], ...] = ()
    assumed: bool = False

    @property
    def start(self) -> float | None:
        """The first second in which the action is seen, or ``None``.

        >>> Timing(((40.0, 44.0), (12.0, 31.0))).start
        12.0
        """
        return min((start for start, _ in self.spans), default=None)

    @property
    def end(self) -> float | None:
        """The last second in which the action is seen, or ``None``.

        >>> Timing(((40.0, 44.0), (12.0, 31.0))).end
        44.0
        """
        return max((end for _, end in self.spans), default=None)


class AskedAmount(NamedTuple):
    """How much of a food somebody asks for, in his words: ("1 1/2 cups", "flour")."""

    amount: str
    food: str


@dataclass(frozen=True)
class Measures:
    """How much, how long and how hot: what a recipe says of one action.

    ``amounts`` are texts of a number, a unit and a food ("200 g flour", "3 piece egg"), ``seconds`` is how long it
    is done, ``celsius`` how hot. What nobody says is ``None``, and no amounts. ``asked`` are the amounts of who asked
    for a plan, which no recorded action has.
    """

    amounts: tuple[str, ...] = ()
    seconds: float | None = None
    celsius: float | None = None
    asked: tuple[AskedAmount, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.amounts or self.asked) or self.seconds is not None or self.celsius is not None


UNMEASURED = Measures()
"""Nobody says how much, how long or how hot."""


@dataclass(frozen=True)
class Annotation:
    """One functional unit at its place in one video, with what is said there of its measures.

    The file of a task tree is no video: in it ``seen_in`` says where each step was seen. ``None`` is a video's own.
    """

    unit: FunctionalUnit
    timing: Timing = Timing()
    measures: Measures = UNMEASURED
    seen_in: tuple[Sighting, ...] | None = None


@dataclass(frozen=True)
class Subgraph:
    """The units of one video in their order. ``name`` is the file name without its ending."""

    name: str
    annotations: tuple[Annotation, ...]
    sources: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "name", one_spelling(self.name))

    @cached_property
    def content_key(self) -> str:
        """Return a hash of everything in it: an equal hash means that loading it again would change nothing.

        >>> beat = Annotation(FunctionalUnit((), "beat", ()))
        >>> Subgraph("omelette", (beat,)).content_key == Subgraph("omelette", (beat, beat)).content_key
        False
        """
        return content_key(self.name, self.sources, [_annotation_as_json(a) for a in self.annotations])


def _annotation_as_json(annotation: Annotation) -> list[object]:
    unit, timing = annotation.unit, annotation.timing
    sides = [[[p.node.key, p.moving, p.dish_type] for p in side] for side in (unit.inputs, unit.outputs)]
    told = [*sides, unit.motion, unit.accepts_any, timing.spans, timing.assumed]
    measures = annotation.measures
    return [*told, measures.amounts, measures.seconds, measures.celsius] if measures else told


@dataclass(frozen=True, order=True)
class Sighting:
    """Where a unit was seen: the place ``position`` (from 0) of the video, with its time in seconds.

    Only units that could be used have a place: those of a video have no gaps, on which the order of steps relies.
    Behind a unit that was left out (the load tells its line) a place is one less than a person counts in the file.
    """

    video: str
    position: int
    source: str | None = field(default=None, compare=False)
    start: float | None = field(default=None, compare=False)
    end: float | None = field(default=None, compare=False)
    measures: Measures = field(default=UNMEASURED, compare=False)


@dataclass(frozen=True)
class KnownUnit:
    """A unit of the universal FOON together with every place where it was seen, in their order."""

    unit: FunctionalUnit
    seen_in: tuple[Sighting, ...]


def sightings_of(subgraph: Subgraph) -> Iterator[tuple[FunctionalUnit, Sighting]]:
    """Yield each unit of ``subgraph`` in its order, with its place; the first source stands for the video.

    >>> beat = Annotation(FunctionalUnit((), "beat", ()), Timing(((12.0, 31.0),)))
    >>> [(seen.video, seen.position, seen.start) for _, seen in sightings_of(Subgraph("omelette", (beat, beat)))]
    [('omelette', 0, 12.0), ('omelette', 1, 12.0)]
    """
    source = subgraph.sources[0] if subgraph.sources else None
    for position, annotation in enumerate(subgraph.annotations):
        start, end = annotation.timing.start, annotation.timing.end
        yield annotation.unit, Sighting(subgraph.name, position, source, start, end, annotation.measures)


def steps_of(subgraph: Subgraph) -> Iterator[KnownUnit]:
    """Yield each unit of ``subgraph`` in its order, seen where it says so: in a task tree's file no unit was seen.

    >>> made = Annotation(FunctionalUnit((), "beat", ()), seen_in=(Sighting("omelette", 3),))
    >>> [known.seen_in[0].position for known in steps_of(Subgraph("plan", (made,)))]
    [3]
    """
    is_tree = any(annotation.seen_in is not None for annotation in subgraph.annotations)
    for annotation, (unit, sighting) in zip(subgraph.annotations, sightings_of(subgraph), strict=True):
        yield KnownUnit(unit, (annotation.seen_in or ()) if is_tree else (sighting,))


@dataclass(frozen=True)
class Goal:
    """The end product of a subgraph: its node, its dish type, the foods it is made of and the videos that make it."""

    node: ObjectNode
    dish_type: str
    ingredients: tuple[str, ...]
    videos: tuple[str, ...]


@dataclass(frozen=True, order=True)
class RequiredIngredient:
    """What a recipe asks for: a food in a state, as the recipe words them.

    ``amount`` is how much of it, in the words of who asks ("1 1/2 cups"); it changes no tree and takes no part in
    equality. ``part`` is for what of the dish the recipe says that it is ("dusting", "glaze"); ``""`` where it says
    nothing.
    """

    object: str
    state: str
    amount: str = field(default="", compare=False)
    part: str = ""


@dataclass(frozen=True)
class Recipe:
    """A dish to be made: its type and the foods it wants. ``title`` is what a person calls it, ``id`` what a file does.

    >>> Recipe("salad", (RequiredIngredient("onion", "chopped"),), title="Onion salad").ingredients[0].state
    'chopped'
    """

    dish_type: str
    ingredients: tuple[RequiredIngredient, ...]
    id: str | None = None
    title: str | None = None

    def __post_init__(self) -> None:
        if self.id is not None:
            object.__setattr__(self, "id", one_spelling(self.id))


def one_spelling(name: str) -> str:
    """Return ``name`` with each letter and its accents as one sign: file systems and keyboards take ö apart, or not.

    By names so spelled videos and recipes are found. What opens a file keeps the path as it is.

    >>> len("cre\u0300me"), len(one_spelling("cre\u0300me"))
    (6, 5)
    """
    return name if name.isascii() else unicodedata.normalize("NFC", name)


def name_of_file(path: Path) -> str:
    """Return what a file at ``path`` names: its own name without the ending, in :func:`one_spelling`."""
    return one_spelling(path.stem)


def distinct_by_name(subgraphs: Iterable[Subgraph]) -> tuple[Subgraph, ...]:
    """Return ``subgraphs`` sorted by name, equal ones once; raises ReadError for two of one name that differ."""
    by_name: dict[str, Subgraph] = {}
    for subgraph in subgraphs:
        if by_name.setdefault(subgraph.name, subgraph).content_key != subgraph.content_key:
            raise two_of_one_name(subgraph.name)
    return tuple(by_name[name] for name in sorted(by_name))


def two_of_one_name(name: str) -> ReadError:
    """Return the error for two subgraphs of one name that differ."""
    return ReadError(
        f"two different subgraphs are called “{name}”",
        hint="A video has one subgraph: load only one of the files, or rename one of them.",
    )
