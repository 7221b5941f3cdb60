"""Algorithm 4 of the paper: the reference task tree is made to fit the recipe."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from foon_kg.model import ObjectNode, RequiredIngredient
from foon_kg.model.claims import Alternative, Substitution, SubstitutionKind
from foon_kg.model.errors import NoTreeError
from foon_kg.model.knowledge import Neighbour, Vocabulary
from foon_kg.model.names import canonical
from foon_kg.model.tree import Mention, Step
from foon_kg.planning.paper.reference import Knowledge
from foon_kg.plans.kitchen import Kitchen
from foon_kg.search import NoWayError, ReferenceTree, SearchProblem, retrieve
from foon_kg.similarity import Similarity

_NEAREST = 4
"""How many equivalents are looked for: the one that is taken and the alternatives that are told."""


@dataclass(frozen=True)
class MadeFood:
    """A food in a state that FOON makes, and what is substituted where it is not the required one."""

    label: str
    state: str
    substitutions: tuple[Substitution, ...] = ()


@dataclass(frozen=True)
class FinalTree:
    """The units that make ``goal``, in the order of execution, and what was substituted in them."""

    goal: ObjectNode
    units: tuple[Step, ...] = ()
    substitutions: tuple[Substitution, ...] = ()


def made_for(want: RequiredIngredient, vocabulary: Vocabulary, similarity: Similarity) -> MadeFood:
    """Return what FOON makes that is nearest to ``want``: the nearest object, then the nearest of its states.

    A part of algorithm 4. ``vocabulary`` tells what is made in which states, ``similarity`` how near names are. The
    paper leaves open whether an object in another state or another object in that state is the nearer one; here the
    object counts first. A FOON that makes nothing has the required food as the answer.
    """
    made: dict[str, list[str]] = {}
    for row in vocabulary.foods:
        if row.made and row.state:
            made.setdefault(row.label, []).append(row.state)
    if not made:
        return MadeFood(want.object, want.state)
    objects = _nearest(want.object, sorted(made), similarity)
    states = _nearest(want.state, made[objects[0].name], similarity)
    pairs = (_substitution("object", want, want.object, objects), _substitution("state", want, want.state, states))
    return MadeFood(objects[0].name, states[0].name, tuple(pair for pair in pairs if pair.required != pair.equivalent))


def construct_final_task_tree(
    knowledge: Knowledge, reference: ReferenceTree, made: Mapping[RequiredIngredient, MadeFood]
) -> FinalTree:
    """Return ``reference`` with every required food, and without any other (Sakib et al., algorithm 4).

    ``knowledge`` is of the whole FOON; ``made`` has, for each required (object, state), what stands for it. What the
    reference tree lacks is prepared before everything else: of several subtrees the one with the fewest units. What the
    kitchen has in the required state needs none. Each food is connected to the last unit that is marked to accept any
    number of inputs and makes something that gets into the goal; few real units are marked, and without one it is the
    last such unit that takes several foods, else the last.

    Raises NoTreeError where nothing is left of the tree.
    """
    kitchen, goal = knowledge.kitchen, reference.goal
    units = [Step.of_unit(known.unit, "foon", known.seen_in) for known in reference.units]
    nodes = {node for unit in units for node in (*unit.input_nodes, *unit.output_nodes)}
    there = {(canonical(node.label), state) for node in nodes for state in (*node.states, "")}
    place = _connecting(units, goal, kitchen)
    before, substitutions = list[Step](), list[Substitution]()
    for want, food in made.items():
        if (canonical(want.object), want.state) not in there:
            subtree = _subtree(knowledge, want, food)
            before += subtree.units
            substitutions += subtree.substitutions
            units, goal = _connected(units, place, subtree.goal, goal, kitchen)
    distinct = dict[object, Step]()
    for unit in (*before, *units):
        distinct.setdefault((unit.inputs, unit.motion, unit.outputs), unit)
    whole = FinalTree(goal, tuple(distinct.values()), tuple(dict.fromkeys(substitutions)))
    return _without_others(whole, {canonical(want.object) for want in made}, kitchen)


def _nearest(name: str, known: Sequence[str], similarity: Similarity) -> list[Neighbour]:
    """Return the nearest of ``known``, however far, ties by name; ``name`` itself comes before its other forms."""
    rows = map(Neighbour, known, similarity.matrix([name], known)[0].tolist())
    return sorted(rows, key=lambda near: (near.name != name, -near.confidence, near.name))[:_NEAREST]


def _substitution(
    kind: SubstitutionKind, want: RequiredIngredient, required: str, nearest: Sequence[Neighbour]
) -> Substitution:
    taken, *others = (Alternative(near.name, round(near.confidence, 4)) for near in nearest)
    return Substitution(kind, want.object, required, taken.name, taken.confidence, tuple(others))


def _subtree(knowledge: Knowledge, want: RequiredIngredient, food: MadeFood) -> FinalTree:
    """Return the tree behind ``food``, with its object, state and motion substituted by those of ``want``.

    The motion that gives the state becomes the one that most often gives the required state to any food. There are
    no units where none can make the food.
    """
    bare = ObjectNode(want.object, (want.state,) if want.state else ())
    nodes = _made_as(food, knowledge)
    if knowledge.kitchen.has(bare) or not nodes:
        return FinalTree(bare)
    try:
        tree = retrieve(SearchProblem(knowledge.index, nodes), time_limit=None)
    except NoWayError:
        return FinalTree(bare)
    motion = _motion_instead(want, food, knowledge.vocabulary)
    found, units = list(food.substitutions), list[Step]()
    for known in tree.units:
        unit = Step.of_unit(known.unit, "foon", known.seen_in)
        now = _changed(unit, lambda node: _renamed(node, want, food))
        if motion is not None and motion != unit.motion and _gives(unit, food):
            now = replace(now, motion=motion)
            like = _nearest(motion, [unit.motion], knowledge.similarity)
            found.append(_substitution("motion", want, motion, like))
        units.append(now if now == unit else replace(now, origin="adapted"))
    return FinalTree(_renamed(tree.goal, want, food), tuple(units), tuple(found))


def _motion_instead(want: RequiredIngredient, food: MadeFood, vocabulary: Vocabulary) -> str | None:
    """Return the usual motion to the state of ``want``; ``None`` where there is none or ``food`` is in that state."""
    return None if food.state == want.state else _usual_motion(want.state, vocabulary)


def _made_as(food: MadeFood, knowledge: Knowledge) -> tuple[ObjectNode, ...]:
    """Return the object nodes of the FOON's units that are ``food``; those of nothing else, where there are any."""
    outputs = {node for known in knowledge.index.units for node in known.unit.output_nodes}
    nodes = {node for node in outputs if node.label == food.label and food.state in node.states}
    pure = {node for node in nodes if set(knowledge.kitchen.foods_in(node)) <= {food.label}}
    return tuple(pure or nodes)


def _usual_motion(state: str, vocabulary: Vocabulary) -> str | None:
    """Return the motion that most often gives a state to any food, ties by name; ``None`` where none gives it."""
    rows = [(-row.count, row.motion) for row in vocabulary.motions if row.state == state]
    return min(rows)[1] if rows else None


def _gives(unit: Step, food: MadeFood) -> bool:
    """Whether ``unit`` is what brings ``food`` into its state."""
    before, after = (
        any(node.label == food.label and food.state in node.states for node in side)
        for side in (unit.input_nodes, unit.output_nodes)
    )
    return after and not before


def _renamed(node: ObjectNode, want: RequiredIngredient, food: MadeFood) -> ObjectNode:
    """Return ``node`` with the required object, also as an ingredient and a container, and the required state."""
    own, names = node.label == food.label, {food.label: want.object}
    return ObjectNode(
        names.get(node.label, node.label),
        tuple(want.state if own and state == food.state else state for state in node.states),
        tuple(names.get(name, name) for name in node.ingredients),
        node.relation,
        node.container and names.get(node.container, node.container),
    )


def _changed(unit: Step, change: Callable[[ObjectNode], ObjectNode | None]) -> Step:
    """Return ``unit`` with each node changed, or left out where the change is ``None``."""
    inputs, outputs, moving = (
        dict.fromkeys(new for node in nodes if (new := change(node)) is not None)
        for nodes in (unit.input_nodes, unit.output_nodes, unit.moving)
    )
    before, after = (tuple(map(Mention, nodes)) for nodes in (inputs, outputs))
    return replace(unit, inputs=before, outputs=after, moving=frozenset(moving))


def _connecting(units: Sequence[Step], goal: ObjectNode, kitchen: Kitchen) -> int:
    """Return the place of the unit that foods are connected to: see :func:`construct_final_task_tree`."""
    places = range(len(units) - 1, -1, -1)
    several = [place for place in places if sum(map(kitchen.is_food, units[place].input_nodes)) > 1]
    likely = (*(place for place in places if units[place].accepts_any), *several)
    any_food = ObjectNode("any food")
    return next((p for p in likely if _connected(units, p, any_food, goal, kitchen)[1] != goal), len(units) - 1)


def _connected(
    units: Sequence[Step], place: int, food: ObjectNode, goal: ObjectNode, kitchen: Kitchen
) -> tuple[list[Step], ObjectNode]:
    """Return ``units`` with ``food`` as one more input of the unit at ``place``, and the goal that comes of it.

    Each product or filled vessel that this unit makes, and that is made of those, has it among its ingredients.
    """
    having, result = dict[ObjectNode, ObjectNode](), list(units[:place])
    for unit in units[place:]:
        untouched = set(unit.input_nodes) - having.keys()
        if len(result) == place or len(untouched) < len(unit.input_nodes):
            for node in unit.output_nodes:
                holds = node == goal or kitchen.foods_in(node) or _is_product(node, unit, kitchen)
                if holds and node not in untouched:
                    having[node] = replace(node, ingredients=(*node.ingredients, food.label))
        now = _changed(unit, lambda node: having.get(node, node))
        if len(result) == place:
            now = replace(now, inputs=(*now.inputs, Mention(food)), moving=now.moving | {food})
        result.append(now)
    return result, having.get(goal, goal)


def _is_product(node: ObjectNode, unit: Step, kitchen: Kitchen) -> bool:
    """Whether an output is a food that no input is called or has among its ingredients: dough, broth."""
    names = {name for other in unit.input_nodes for name in (other.label, *other.ingredients)}
    return kitchen.is_food(node) and node.label not in names


def _with_products(required: Collection[str], units: Iterable[Step], kitchen: Kitchen) -> set[str]:
    """Return the names of the ``required`` foods and of the products that ``units`` make of them."""
    kept = set(required)
    for unit in units:
        if any(canonical(name) in kept for node in unit.input_nodes for name in (node.label, *node.ingredients)):
            kept |= {canonical(node.label) for node in unit.output_nodes if _is_product(node, unit, kitchen)}
    return kept


def _without_others(tree: FinalTree, required: Collection[str], kitchen: Kitchen) -> FinalTree:
    """Return ``tree`` without the foods that are not required, and without the units that then serve nothing.

    By its name a food is ``required``, free (water), or a product of required foods (their dough). A vessel that loses
    its foods stays, empty. A unit that loses a food goes where it changes no other; so does every unit that makes
    nothing which the goal needs.
    """
    kept = _with_products(required, tree.units, kitchen)

    def stays(name: str) -> bool:
        return canonical(name) in kept or kitchen.is_free(name) or kitchen.is_utensil(name)

    def bare(node: ObjectNode) -> ObjectNode | None:
        now = replace(node, ingredients=tuple(filter(stays, node.ingredients)))
        holds = any(canonical(name) in kept for name in now.ingredients)
        return now if holds or stays(node.label) or node == tree.goal else None

    goal = bare(tree.goal) or tree.goal
    needed, units = {goal}, list[Step]()
    for unit in reversed(tree.units):
        now = _changed(unit, bare)
        fresh = set(now.output_nodes) - set(now.input_nodes)
        foods = [node for node in fresh if kitchen.is_food(node) or kitchen.foods_in(node)]
        if needed & fresh and (foods or now == unit):
            needed = (needed - fresh).union(now.input_nodes)
            units.append(now)
    if not units:
        raise NoTreeError(f"nothing of {goal.label} is required", code="left-out", hint="Ask for another dish type.")
    return FinalTree(goal, tuple(reversed(units)), tree.substitutions)
