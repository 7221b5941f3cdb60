"""A task tree as a script: who plays in it, and what each of its units is about.

The words of :mod:`foon_kg.replay`, which executes scripts. Nothing here changes while a script is replayed.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType

from foon_kg import motions
from foon_kg.food.lists import word_list
from foon_kg.kitchen import Kitchen
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.recent import Recent

EMPTY = "empty"
"""The state of a vessel out of which everything was taken."""

GIVEN = word_list("given by contents")
"""States that a vessel has from what is in it or on it."""

MOST_SCENES = 8192
"""How many units are kept as they were read in one kitchen."""

MOST_PERFORMANCES = 16384
"""For how many units, each with one casting of its foods, it is kept what comes of them; of each so many times:"""

_MOST_TIMES = 32

Atom = tuple[str, str]
"""A food inside a node: its name in the script (``""`` for one that was added) and its name now."""


@dataclass(frozen=True)
class Recast:
    """How a food of the script appears now: under another label, in other states, by other motions.

    ``states`` maps a state of the script to the state now; the key ``""`` gives a state to nodes that name none.
    ``ready`` maps leaves of the script to nodes that are made apart and come in their place: onion that the script
    has chopped in a bowl comes from the board on which it is chopped.
    """

    label: str
    states: Mapping[str, str] = field(default_factory=dict)
    motions: Mapping[str, str] = field(default_factory=dict)
    ready: Mapping[ObjectNode, ObjectNode] = field(default_factory=dict)

    @cached_property
    def content(self) -> Hashable:
        """All that it says: equal for two that are equal."""
        changes = (self.states, self.motions, self.ready)
        return (self.label, *(frozenset(change.items()) for change in changes))

    def comes_from_elsewhere(self, vessel: ObjectNode) -> bool:
        """Say whether what the script has in ``vessel`` from the start is made apart now, and lies somewhere else."""
        return any(leaf.container == vessel.label != node.container for leaf, node in self.ready.items())

    def states_of(self, node: ObjectNode) -> tuple[str, ...]:
        """Answer the states in which ``node`` appears now."""
        if not node.states and "" in self.states:
            return (self.states[""],)
        return tuple(self.states.get(state, state) for state in node.states)


@dataclass(frozen=True)
class Item:
    """What a node of the script has become: the current node and the foods inside it."""

    node: ObjectNode
    atoms: frozenset[Atom] = frozenset()

    def __hash__(self) -> int:
        kept = self.__dict__.get("_hash")  # items are looked up far more often than they are made
        if kept is None:
            kept = self.__dict__["_hash"] = hash((self.node, self.atoms))
        return kept

    @property
    def added(self) -> frozenset[Atom]:
        """The foods in it that the script knows nothing of."""
        return frozenset(atom for atom in self.atoms if not atom[0])


@dataclass(frozen=True)
class Step:
    """A unit as it happens now. ``place`` is its place in the script; ``added`` are the nodes that joined here.

    ``strained`` says that something is taken in a state in which the unit of the script does not know it. ``taken``
    says which node of the script each input was.
    """

    place: int
    known: KnownUnit
    input_nodes: tuple[ObjectNode, ...]
    motion: str
    output_nodes: tuple[ObjectNode, ...]
    added: tuple[ObjectNode, ...] = ()
    moving: frozenset[ObjectNode] = frozenset()
    strained: bool = False
    taken: tuple[tuple[ObjectNode, ObjectNode], ...] = field(default=(), compare=False)


@dataclass(frozen=True, eq=False)
class Scene:
    """One unit of a script with what does not change from one replay to the next."""

    known: KnownUnit
    inputs: tuple[ObjectNode, ...]
    outputs: tuple[ObjectNode, ...]
    kept: frozenset[ObjectNode]
    written: frozenset[str]
    beside: frozenset[str]
    acted: tuple[ObjectNode, ...]
    taken: frozenset[ObjectNode]
    holders: tuple[ObjectNode, ...]
    turned: tuple[ObjectNode, ...]
    has_foods: bool
    springs: frozenset[str]
    vanishing: frozenset[ObjectNode]
    foods: frozenset[ObjectNode]
    filled: frozenset[ObjectNode]
    names: tuple[str, ...]
    spoken: frozenset[str]

    @classmethod
    def of(cls, known: KnownUnit, kitchen: Kitchen) -> Scene:
        """Read one unit. ``acted`` are the foods that it moves or changes, ``turned`` the utensils that it does.

        ``taken`` are those of ``acted`` that are gone afterwards: what is put into the oven in its pan is still there.
        ``springs`` are free foods that are there though they are taken from nowhere: water, once the tap is on.
        ``vanishing`` are foods that no output names: they went into what is acted on (salt, into a salted rib).
        ``foods`` are all nodes that are foods, ``filled`` all vessels that name any; ``names`` is everything that is
        named, and ``spoken`` what the foods and the outputs name.
        """
        unit = known.unit
        inputs, outputs, kept = unit.input_nodes, unit.output_nodes, frozenset(unit.output_nodes)
        usual = Kitchen.default()  # where water is asked it is not free, and comes out of the tap all the same
        foods = tuple(node for node in inputs if kitchen.is_food(node))
        acted = tuple(node for node in foods if node not in kept)
        utensils = [node for node in inputs if not kitchen.is_food(node)]
        written, left = _names(inputs), _names(outputs)
        nodes = dict.fromkeys((*inputs, *outputs))
        return cls(
            known,
            inputs,
            outputs,
            kept,
            written=written,
            beside=frozenset(node.label for node in foods),
            acted=acted,
            taken=frozenset(node for node in acted if not stands_by(node, known, kitchen)),
            holders=tuple(node for node in utensils if node.ingredients and node not in kept),
            turned=tuple(node for node in utensils if is_turned(node, outputs)),
            has_foods=bool(foods) or any(kitchen.foods_in(node) for node in inputs),
            springs=frozenset(name for name in left - written if kitchen.is_free(name) or usual.is_free(name)),
            vanishing=frozenset(node for node in foods if node.label not in left),
            foods=frozenset(filter(kitchen.is_food, nodes)),
            filled=frozenset(node for node in nodes if not kitchen.is_food(node) and kitchen.foods_in(node)),
            names=tuple(sorted(written | left)),
            spoken=left | {node.label for node in foods},
        )

    def vessels_alone(self, kitchen: Kitchen) -> Iterator[ObjectNode]:
        """Answer the vessels with food that it takes without a food of theirs that lies in them."""
        there = {(node.container, node.label) for node in self.inputs if kitchen.is_food(node)}
        vessels = (node for node in self.inputs if node.ingredients and not kitchen.is_food(node))
        return (node for node in vessels if not any((node.label, name) in there for name in node.ingredients))


@dataclass(frozen=True)
class Casting:
    """Who plays in a script: recast foods, dropped foods (``None``); a label not named stays as it is.

    ``cut`` names foods that are at hand although the script makes them: their makers are not run.
    ``carried`` names foods (as they are called now) that every mixture must name, where the script forgets them.
    ``goal`` is the node that keeps its label whatever it is made of. ``spent`` names, for places of the script, inputs
    that an earlier unit took away or poured out, whatever the script says.
    """

    foods: Mapping[str, Recast | None] = field(default_factory=dict)
    cut: frozenset[str] = frozenset()
    carried: frozenset[str] = frozenset()
    goal: ObjectNode | None = None
    spent: frozenset[tuple[int, ObjectNode]] = frozenset()

    @cached_property
    def roles(self) -> Mapping[str, Hashable]:
        """What each food that it names plays, to be compared."""
        return {name: recast.content if recast else None for name, recast in self.foods.items()}


@dataclass(frozen=True, eq=False)
class Performance:
    """What comes of a unit where it finds certain things: each node of the script with what it is now, in order.

    ``fetched`` are the leaves it takes and ``labels`` their foods. Where it ``happens``, ``used`` are nodes that are
    gone after it, ``made`` is what it makes of its outputs, ``renewed`` are nodes that are there again as they were,
    and ``become`` says what others have become; ``step`` tells it. Where it does not, ``passed`` has its outputs with
    what they would have been made of, and whether that stands elsewhere.
    """

    fetched: tuple[tuple[ObjectNode, Item | None], ...]
    labels: tuple[str, ...]
    happens: bool
    used: frozenset[ObjectNode] = frozenset()
    made: tuple[tuple[ObjectNode, Item | None], ...] = ()
    renewed: tuple[ObjectNode, ...] = ()
    become: tuple[tuple[ObjectNode, Item], ...] = ()
    step: Step | None = None
    passed: tuple[tuple[ObjectNode, Item | None, bool], ...] = ()

    def told_at(self, place: int) -> Step | None:
        """Answer what happens, as the step of a script in which the unit has this place."""
        if self.step is None or self.step.place == place:
            return self.step
        return replace(self.step, place=place)


Performances = dict[Hashable, Performance]
"""What came of one unit with one casting, by all that it found."""


class Repertoire:
    """What was played so far in one kitchen: the same unit, cast alike, is in many scripts."""

    def __init__(self, kitchen: Kitchen) -> None:
        self.kitchen = kitchen
        self._scenes: Recent[str, Scene] = Recent(MOST_SCENES)
        self._performances: Recent[Hashable, Performances] = Recent(MOST_PERFORMANCES)

    def scene(self, known: KnownUnit) -> Scene:
        """Answer the unit ``known`` as it is read in this kitchen."""
        if known.unit.key not in self._scenes:
            self._scenes[known.unit.key] = Scene.of(known, self.kitchen)
        return self._scenes[known.unit.key]

    def performances(self, scene: Scene, *cast: Hashable) -> Performances:
        """Answer what came so far of ``scene`` where it was ``cast`` so; what comes of it now may be added."""
        kept = self._performances.get((scene, *cast))
        if kept is None or len(kept) >= _MOST_TIMES:
            kept = self._performances[scene, *cast] = {}
        return kept


_NOTHING: Mapping[ObjectNode, ObjectNode] = MappingProxyType({})


@dataclass(frozen=True, eq=False)
class Script:
    """The units of a task tree in their order, read once so that they can be replayed many times."""

    scenes: tuple[Scene, ...]
    repertoire: Repertoire
    taken_alone: frozenset[ObjectNode]
    """Vessels that some unit takes without naming the food in them: only they can tell what is in that food."""
    same: Mapping[ObjectNode, ObjectNode]
    """Inputs that an earlier unit outputs under another name."""

    @classmethod
    def of(
        cls, units: Iterable[KnownUnit], repertoire: Repertoire, same: Mapping[ObjectNode, ObjectNode] = _NOTHING
    ) -> Script:
        """Read ``units``, which are in the order of execution."""
        scenes, kitchen = tuple(map(repertoire.scene, units)), repertoire.kitchen
        alone = frozenset(node for scene in scenes for node in scene.vessels_alone(kitchen))
        return cls(scenes, repertoire, alone, same)


@dataclass(frozen=True)
class Replayed:
    """A script as it was executed: the steps that do something, and what every node has become."""

    steps: tuple[Step, ...]
    items: Mapping[ObjectNode, Item | None]


def _names(nodes: Iterable[ObjectNode]) -> frozenset[str]:
    return frozenset(name for node in nodes for name in (node.label, *node.ingredients))


def is_turned(node: ObjectNode, outputs: Sequence[ObjectNode]) -> bool:
    """Say whether a unit changes the utensil ``node`` itself (its state or place), not only what it holds."""
    after = [other for other in outputs if other.label == node.label]
    plain = {EMPTY}
    return bool(after) and all(
        set(other.states) - plain != set(node.states) - plain or spot_of(other) != spot_of(node) for other in after
    )


def stands_by(node: ObjectNode, known: KnownUnit, kitchen: Kitchen) -> bool:
    """Say whether a food that the outputs leave out is there all the same: its vessel has it, unmixed and uncooked."""
    motion, outputs = known.unit.motion, known.unit.output_nodes
    if motions.mixes(motion) or motions.heats(motion) or any(other.label == node.label for other in outputs):
        return False
    vessels = (other for other in outputs if other.label == node.container and not kitchen.is_food(other))
    return any(node.label in vessel.ingredients for vessel in vessels)


def emptied(node: ObjectNode) -> ObjectNode:
    """Answer the vessel with nothing in it any more: what only its foods gave it (greased) goes with them."""
    left = {state for state in node.states if state not in GIVEN}
    return changed(node, states=left | {EMPTY}, ingredients=())


def spot_of(node: ObjectNode) -> tuple[str | None, str | None]:
    """Answer where a node is: relation and container."""
    return (node.relation, node.container)


def changed(
    node: ObjectNode,
    *,
    label: str | None = None,
    states: Iterable[str] | None = None,
    ingredients: Iterable[str] | None = None,
) -> ObjectNode:
    """Answer ``node`` with another label, other states or other ingredients; its place stays."""
    named = node.label if label is None else label
    shown = node.states if states is None else tuple(states)
    held = node.ingredients if ingredients is None else tuple(ingredients)
    if named == node.label and shown == node.states and held == node.ingredients:
        return node
    return ObjectNode(named, shown, held, node.relation, node.container)
