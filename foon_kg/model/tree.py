"""The steps of a task tree, and what follows from them alone: what they take, make and leave for others.

Planner, judge, exports, pictures and readings share these types. What a step needs of a kitchen is in
:mod:`foon_kg.world`, what a whole plan says of itself in :mod:`foon_kg.plans.result`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal, NamedTuple, Protocol

from foon_kg.model.claims import Assumption, Substitution
from foon_kg.model.levels import Level
from foon_kg.model.nodes import UNMEASURED, FunctionalUnit, Measures, ObjectNode, Participant, Recipe, Sighting

Origin = Literal["foon", "adapted"]
"""Whether a unit of FOON does this to this food, or one to a like food or one of its kind."""

Phase = Literal["prepare", "heat", "finish"]
"""When a unit is carried out: everything is cut first, then heated, then served."""

Grounding = Literal["food", "like", "kind", "motion"]
"""How near the evidence of a unit is: the same food, a like one, one of its kind, the motion alone."""


class Mention(NamedTuple):
    """An object node as a tree mentions it.

    ``thing`` is the number of the thing that it is, ``container_thing`` that of its container; ``None`` where the tree
    does not number its things: they are then told apart by what their nodes say.
    """

    node: ObjectNode
    thing: int | None = None
    container_thing: int | None = None

    def __str__(self) -> str:
        return str(self.node)

    @property
    def identity(self) -> ObjectNode | int:
        """What tells this thing from others: its number, where it has one; two bowls may have equal nodes.

        >>> Mention(ObjectNode("bowl"), thing=3).identity, Mention(ObjectNode("bowl")).identity == ObjectNode("bowl")
        (3, True)
        """
        return self.node if self.thing is None else self.thing


@dataclass(frozen=True)
class Step:
    """A step of a task tree, ``inputs`` → ``motion`` → ``outputs``, and what speaks for it.

    ``origin`` (see :data:`Origin`), ``seen_in``, ``grounding`` (:data:`Grounding`) and ``phase`` (:data:`Phase`) are
    ``None`` where the source of the tree cannot say them; the judge reads trees that say anything. ``measures`` are
    how much, how long (seconds) and how hot (Celsius), where anybody says. These are the fields of a unit of the JSON
    (docs/reference/result.md).

    ``accepts_any`` (the star of a motion) and ``moving`` (the nodes that move) are for the FOON text of the tree, and
    ``number`` (from 1) and ``text`` (a sentence for a cook) for a plan that is told step by step. JSON has no field
    for these four, and they take no part in equality.

    >>> step = Step.of([ObjectNode("onion")], "peel", [ObjectNode("onion", ("peeled",))], "foon")
    >>> step.motion, step.outputs[0].node.states, step.origin, step.phase
    ('peel', ('peeled',), 'foon', None)
    """

    inputs: tuple[Mention, ...]
    motion: str
    outputs: tuple[Mention, ...]
    origin: str | None = None
    seen_in: tuple[Sighting, ...] | None = None
    grounding: str | None = None
    phase: Phase | None = None
    measures: Measures = UNMEASURED
    accepts_any: bool = field(default=False, compare=False)
    moving: frozenset[ObjectNode] = field(default=frozenset(), compare=False)
    number: int | None = field(default=None, compare=False)
    text: str = field(default="", compare=False)

    @classmethod
    def of(
        cls,
        inputs: Iterable[ObjectNode],
        motion: str,
        outputs: Iterable[ObjectNode],
        origin: Origin | None = None,
        seen_in: tuple[Sighting, ...] | None = None,
    ) -> Step:
        """Return the step ``inputs`` → ``motion`` → ``outputs`` of nodes, none of which has a number.

        ``origin`` and ``seen_in`` say what speaks for it, where anybody can say.

        >>> Step.of([ObjectNode("onion", ("whole",))], "chop", [ObjectNode("onion", ("chopped",))]).outputs[0].identity
        ObjectNode(label='onion', states=('chopped',), ingredients=(), relation=None, container=None)
        """
        return cls(tuple(map(Mention, inputs)), motion, tuple(map(Mention, outputs)), origin, seen_in)

    @classmethod
    def of_unit(
        cls, unit: FunctionalUnit, origin: Origin | None = None, seen_in: tuple[Sighting, ...] | None = None
    ) -> Step:
        """Return ``unit`` as it stands as a step; repeated nodes count once, and things have no numbers.

        ``origin`` and ``seen_in`` say what speaks for it, where anybody can say.

        >>> egg = Participant(ObjectNode("egg"))
        >>> len(Step.of_unit(FunctionalUnit((egg, egg), "beat", ()), "foon").inputs)
        1
        """
        moving = frozenset(p.node for p in (*unit.inputs, *unit.outputs) if p.moving)
        step = cls.of(unit.input_nodes, unit.motion, unit.output_nodes, origin, seen_in)
        return replace(step, accepts_any=unit.accepts_any, moving=moving)

    def __str__(self) -> str:
        """Return its sentence with its number; of a step that nobody told so, what is done to what.

        >>> print(Step.of([ObjectNode("onion"), ObjectNode("knife")], "chop", [ObjectNode("onion", ("chopped",))]))
        onion + knife → chop → onion (chopped)
        """
        if self.text:
            return f"{self.number}. {self.text}"
        taken, made = (" + ".join(map(str, side)) for side in (self.input_nodes, self.output_nodes))
        return f"{taken} → {self.motion} → {made}"

    @property
    def sightings(self) -> tuple[Sighting, ...]:
        """Where it was seen; nothing where the source of the tree cannot say.

        >>> Step.of([], "chop", []).sightings
        ()
        """
        return self.seen_in or ()

    @cached_property
    def input_nodes(self) -> tuple[ObjectNode, ...]:
        """The nodes that go in.

        >>> chop = Step.of([ObjectNode("onion")], "chop", [ObjectNode("onion", ("chopped",))])
        >>> [str(node) for node in chop.input_nodes]
        ['onion']
        """
        return tuple(mention.node for mention in self.inputs)

    @cached_property
    def output_nodes(self) -> tuple[ObjectNode, ...]:
        """The nodes that come out.

        >>> chop = Step.of([ObjectNode("onion")], "chop", [ObjectNode("onion", ("chopped",))])
        >>> [str(node) for node in chop.output_nodes]
        ['onion (chopped)']
        """
        return tuple(mention.node for mention in self.outputs)

    @cached_property
    def identity(self) -> tuple[object, ...]:
        """What is done to which things: equal for two units that are the same.

        >>> one, other = (Step((Mention(ObjectNode("bowl"), thing),), "wash", ()) for thing in (1, 2))
        >>> one.identity == other.identity
        False
        """
        return (frozenset(self.inputs), self.motion, frozenset(self.outputs))

    @cached_property
    def nodes_key(self) -> tuple[object, ...]:
        """What is done to what, whichever things they are: as the FOON knows a unit.

        >>> one, other = (Step((Mention(ObjectNode("bowl"), thing),), "wash", ()) for thing in (1, 2))
        >>> one.nodes_key == other.nodes_key
        True
        """
        return (frozenset(self.input_nodes), self.motion, frozenset(self.output_nodes))

    @cached_property
    def new_outputs(self) -> tuple[ObjectNode, ...]:
        """The outputs that are no inputs: what the step makes. A thing with a number is another than its like.

        >>> knife, onion = ObjectNode("knife"), ObjectNode("onion")
        >>> Step.of([onion, knife], "chop", [ObjectNode("onion", ("chopped",)), knife]).new_outputs[0].states
        ('chopped',)
        """
        inputs = set(self.inputs)
        return tuple(mention.node for mention in self.outputs if mention not in inputs)

    def as_unit(self, goal: ObjectNode | None = None, dish_type: str | None = None) -> FunctionalUnit:
        """Return the functional unit; an output that equals ``goal`` is marked as the end product of ``dish_type``.

        >>> step = Step.of([ObjectNode("lettuce")], "mix", [ObjectNode("salad")])
        >>> step.as_unit(ObjectNode("salad"), "salad").outputs[0].dish_type
        'salad'
        """
        inputs = tuple(Participant(node, node in self.moving) for node in self.input_nodes)
        outputs = tuple(
            Participant(node, node in self.moving, dish_type if node == goal else None) for node in self.output_nodes
        )
        return FunctionalUnit(inputs, self.motion, outputs, self.accepts_any)


class TakesAndMakes(Protocol):
    """A functional unit, or a step of a tree."""

    @property
    def input_nodes(self) -> tuple[ObjectNode, ...]:
        """What goes in."""

    @property
    def output_nodes(self) -> tuple[ObjectNode, ...]:
        """What comes out."""


def leaves_of(units: Iterable[TakesAndMakes]) -> tuple[ObjectNode, ...]:
    """Return the inputs that no earlier unit outputs, in the order of their first use.

    ``units`` are in the order of execution. A node that its first taker puts back as it was is a leaf too, or a stove
    could be on without anybody having turned it on.

    >>> whole, cut, fried = (ObjectNode("onion", (state,)) for state in ("whole", "chopped", "fried"))
    >>> units = [Step.of([whole], "chop", [cut]), Step.of([cut], "fry", [fried])]
    >>> [str(node) for node in leaves_of(units)]
    ['onion (whole)']
    """
    there: set[ObjectNode] = set()
    leaves: dict[ObjectNode, None] = {}
    for unit in units:
        leaves.update(dict.fromkeys(node for node in unit.input_nodes if node not in there))
        there.update(unit.input_nodes, unit.output_nodes)
    return tuple(leaves)


def things_found(units: Iterable[Step]) -> dict[ObjectNode, tuple[int, ...]]:
    """Return the numbers of the things that each node is before the first step; of trees without numbers nothing.

    ``units`` are in the order of execution. Two bowls that are both found empty are two numbers of one node.

    >>> bowl = ObjectNode("bowl", ("empty",))
    >>> things_found([Step((Mention(bowl, 1), Mention(bowl, 2)), "stack", ())]) == {bowl: (1, 2)}
    True
    """
    found: dict[ObjectNode, tuple[int, ...]] = {}
    seen: set[int] = set()
    for unit in units:
        for node, thing, _ in unit.inputs:
            if thing is not None and thing not in seen:
                seen.add(thing)
                found[node] = (*found.get(node, ()), thing)
        seen.update(one.thing for one in unit.outputs if one.thing is not None)
    return found


def newly_made(unit: TakesAndMakes) -> list[ObjectNode]:
    """Return the nodes that ``unit`` puts out and did not take: what was only held or passed on is none of them.

    >>> knife, onion, cut = ObjectNode("knife"), ObjectNode("onion"), ObjectNode("onion", ("chopped",))
    >>> chop = Step.of([onion, knife], "chop", [cut, knife])
    >>> [str(node) for node in newly_made(chop)]
    ['onion (chopped)']
    """
    taken = set(unit.input_nodes)
    return [node for node in unit.output_nodes if node not in taken]


def used_up(unit: TakesAndMakes) -> list[ObjectNode]:
    """Return the nodes that ``unit`` takes and does not leave as they were: moved, changed, or gone into another.

    >>> knife, onion, cut = ObjectNode("knife"), ObjectNode("onion"), ObjectNode("onion", ("chopped",))
    >>> chop = Step.of([onion, knife], "chop", [cut, knife])
    >>> [str(node) for node in used_up(chop)]
    ['onion']
    """
    left = set(unit.output_nodes)
    return [node for node in unit.input_nodes if node not in left]


def nodes_of(units: Iterable[TakesAndMakes]) -> tuple[ObjectNode, ...]:
    """Return every object node of ``units`` once, in the order of appearance.

    >>> whole, cut, fried = (ObjectNode("onion", (state,)) for state in ("whole", "chopped", "fried"))
    >>> units = [Step.of([whole], "chop", [cut]), Step.of([cut], "fry", [fried])]
    >>> [str(node) for node in nodes_of(units)]
    ['onion (whole)', 'onion (chopped)', 'onion (fried)']
    """
    return tuple(dict.fromkeys(node for unit in units for node in (*unit.input_nodes, *unit.output_nodes)))


@dataclass(frozen=True)
class TaskTree:
    """Steps in the order of execution, with what is said of the whole.

    ``None`` (and an ``error``) stands for what the source of the tree does not say.

    ``kitchen`` is ``None`` for FOON text, and so are ``substitutions`` and ``assumptions``: nothing is claimed there.
    ``level`` is that of a classic retrieval, which asks for a goal and not for a recipe; ``None`` for all others.
    """

    name: str
    units: tuple[Step, ...]
    goal: ObjectNode | None = None
    recipe: Recipe | None = None
    kitchen: tuple[ObjectNode, ...] | None = None
    substitutions: tuple[Substitution, ...] | None = None
    assumptions: tuple[Assumption, ...] | None = None
    error: str | None = None
    level: Level | None = None

    @cached_property
    def made(self) -> dict[ObjectNode, tuple[int, ...]]:
        """The places of the units that output each node without having taken it.

        >>> whole, cut, fried = (ObjectNode("onion", (state,)) for state in ("whole", "chopped", "fried"))
        >>> units = [Step.of([whole], "chop", [cut]), Step.of([cut], "fry", [fried])]
        >>> TaskTree("fried onion", tuple(units)).made[fried]
        (1,)
        """
        return _places([unit.new_outputs for unit in self.units])

    @cached_property
    def takers(self) -> dict[ObjectNode, tuple[int, ...]]:
        """The places of the units that take each node.

        >>> whole, cut, fried = (ObjectNode("onion", (state,)) for state in ("whole", "chopped", "fried"))
        >>> units = [Step.of([whole], "chop", [cut]), Step.of([cut], "fry", [fried])]
        >>> TaskTree("fried onion", tuple(units)).takers[whole]
        (0,)
        """
        return _places([unit.input_nodes for unit in self.units])

    @cached_property
    def leaves(self) -> tuple[ObjectNode, ...]:
        """The inputs that no earlier unit outputs, in the order of their first use.

        >>> egg, yolk = ObjectNode("egg"), ObjectNode("yolk")
        >>> steps = Step.of([egg], "crack", [yolk]), Step.of([yolk], "beat", [])
        >>> [str(node) for node in TaskTree("egg", steps).leaves]
        ['egg']
        """
        return leaves_of(self.units)

    @cached_property
    def nodes(self) -> tuple[ObjectNode, ...]:
        """Every object node of the tree, in the order of appearance.

        >>> egg, yolk = ObjectNode("egg"), ObjectNode("yolk")
        >>> steps = Step.of([egg], "crack", [yolk]), Step.of([yolk], "beat", [])
        >>> [str(node) for node in TaskTree("egg", steps).nodes]
        ['egg', 'yolk']
        """
        return nodes_of(self.units)


def _places(sides: list[tuple[ObjectNode, ...]]) -> dict[ObjectNode, tuple[int, ...]]:
    places: dict[ObjectNode, tuple[int, ...]] = {}
    for place, nodes in enumerate(sides):
        for node in nodes:
            places[node] = (*places.get(node, ()), place)
    return places
