"""PDDL: a task tree, or a whole FOON with a kitchen, as a planning problem.

The things of a plan have numbers, and so its problem is a real one (:mod:`foon_kg.formats.exports.pddl_things`): each
thing is in one form and one place, steps use up and move what they take, and every appliance has to be turned off
again.

Of FOON text and of a whole FOON nobody knows which bowl is which. There an object node is there or not, a unit can be
carried out when all its inputs are there, and then all its outputs are there too; nothing is ever used up. A plan is
valid exactly when the units in its order keep C1 of docs/contract.md and the goal node is there at the end.

Either way every functional unit is an action without parameters.

Kept to ``:strips`` and ``:typing``, which every planner reads. What a name stands for is said in the comment beside it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import Self

from foon_kg.formats.exports.notation import node_text, unit_text
from foon_kg.formats.exports.pddl_names import comment, name_of, words_of
from foon_kg.formats.exports.pddl_things import FOOD, UTENSIL, Action, Kitchenful, has_numbers
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.model import FunctionalUnit, ObjectNode
from foon_kg.model.errors import FormatError, UsageError
from foon_kg.model.tree import newly_made, nodes_of
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot

PREDICATE = "at_hand"


@dataclass(frozen=True)
class PlanningProblem:
    """The three texts. ``plan`` has the steps of a tree in our own order; a whole FOON has none (``None``)."""

    domain: str
    problem: str
    plan: str | None = None


def tree_to_pddl(tree: ExportedTree) -> PlanningProblem:
    """Return the problem that a task tree solves: its units, its kitchen, its goal, and its order as a plan.

    Of a tree of which some steps are done the kitchen is as they leave it; the domain is the same, and has all units.
    Raises :class:`~foon_kg.model.errors.FormatError` for a tree that does not say what its goal is.
    """
    if tree.goal is None:
        raise FormatError(
            f"{tree.name}: a planning problem needs a goal, and no output is marked as one",
            hint="Export the plan result (JSON) or mark the goal with its dish class.",
        )
    if tree.result is not None and has_numbers(tree.result):
        return _of_things(tree.title, Kitchenful(tree.result, Kitchen.default(), tree.done), tree.done)
    units = [known.unit for known in tree.units]
    writer = _Writer.of(tree.title, units, tree.kitchen, (tree.goal,), Kitchen.default())
    return PlanningProblem(writer.domain(), writer.problem(), writer.plan())


def _of_things(title: str, kitchenful: Kitchenful, done: int) -> PlanningProblem:
    name = name_of("make", title)
    written = comment(f"{title}, written by foon-kg")
    things = [f"    {thing.name} - {thing.kind}" for thing in kitchenful.things.values()]
    forms = (("    " + comment(node_text(form)), f"    {named} - form") for form, named in kitchenful.forms.items())
    domain = [
        written,
        comment("Each thing is in one form and in one place; a step changes those of what it puts out."),
        f"(define (domain {name})",
        "  (:requirements :strips :typing)",
        f"  (:types {FOOD} {UTENSIL} - thing thing form - object)",
        "  (:constants",
        *things,
        *(line for pair in forms for line in pair),
        "  )",
        "  (:predicates (is ?thing - thing ?form - form) (at ?thing - thing ?place - thing) (unplaced ?thing - thing))",
        *(line for action in kitchenful.actions for line in _written(action)),
        ")",
    ]
    problem = [
        written,
        f"(define (problem {name}_problem)",
        f"  (:domain {name})",
        "  (:init",
        *(f"    {fact}" for fact in kitchenful.begin),
        "  )",
        f"  (:goal (and {' '.join(kitchenful.end)}))",
        ")",
    ]
    plan = [comment(f"{title}: the steps in foon-kg's own order")]
    for action in kitchenful.actions[done:]:
        plan += [comment(unit_text(action.unit.as_unit())), f"({action.name})"]
    texts = ("\n".join(lines) + "\n" for lines in (domain, problem, plan))
    return PlanningProblem(*texts)


def _written(action: Action) -> Iterator[str]:
    yield "  " + comment(unit_text(action.unit.as_unit()))
    yield f"  (:action {action.name}"
    yield "    :parameters ()"
    yield f"    :precondition (and {' '.join(action.needs)})"
    yield f"    :effect (and {' '.join((*(f'(not {fact})' for fact in action.ends), *action.makes))})"
    yield "  )"


def foon_to_pddl(foon: Snapshot, goal: str, kitchen: Kitchen | None = None) -> PlanningProblem:
    """Return the problem of making a dish, called ``goal``, with all that a FOON knows and what ``kitchen`` has.

    At hand is what the kitchen of a search has, and what the contract lets be a leaf (C6) where no unit makes it. Where
    several goal nodes have that label, any of them will do. Raises :class:`~foon_kg.model.errors.UsageError` where
    none has it.
    """
    goals = tuple(dict.fromkeys(known.node for known in foon.goals() if known.node.label == goal))
    if not goals:
        labels = ", ".join(sorted({known.node.label for known in foon.goals()}))
        raise UsageError(f"no dish of this FOON is called “{goal}”", hint=f"It knows {labels or 'none'}.")
    kitchen = kitchen or foon.kitchen
    units = [known.unit for known in foon.units]
    at_hand = sorted(_at_hand(units, kitchen), key=lambda node: node.sort_key)
    writer = _Writer.of(goal, units, at_hand, goals, kitchen)
    return PlanningProblem(writer.domain(), writer.problem())


def _at_hand(units: Sequence[FunctionalUnit], kitchen: Kitchen) -> set[ObjectNode]:
    made = {node for unit in units for node in newly_made(unit)}
    found = {node for node in nodes_of(units) if kitchen.has(node)}
    return found.union(_possible_leaves(units, made, kitchen))


def _possible_leaves(
    units: Sequence[FunctionalUnit], made: Collection[ObjectNode], kitchen: Kitchen
) -> Iterator[ObjectNode]:
    """Yield the inputs, none of them ``made``, that may be leaves beside the others of their units."""
    for unit in units:
        for node in unit.input_nodes:
            beside = [other for other in unit.input_nodes if other != node]
            if node not in made and not kitchen.lacks(node) and kitchen.may_be_leaf(node, beside):
                yield node


@dataclass(frozen=True)
class _Writer:
    """The names of everything, and the texts made of them. ``actions`` are in the order of ``units``."""

    name: str
    title: str
    units: Sequence[FunctionalUnit]
    actions: Sequence[str]
    constants: dict[ObjectNode, str]
    begin: Sequence[ObjectNode]
    end: Sequence[ObjectNode]
    kitchen: Kitchen

    @classmethod
    def of(
        cls,
        title: str,
        units: Sequence[FunctionalUnit],
        begin: Sequence[ObjectNode],
        end: Sequence[ObjectNode],
        kitchen: Kitchen,
    ) -> Self:
        digits = len(str(len(units)))
        actions = [name_of(f"step_{place:0{digits}}", unit.motion) for place, unit in enumerate(units, 1)]
        nodes = enumerate(dict.fromkeys((*nodes_of(units), *begin, *end)), 1)
        constants = {node: name_of(f"n{number}", words_of(node)) for number, node in nodes}
        return cls(name_of("make", title), title, units, actions, constants, tuple(begin), tuple(end), kitchen)

    def domain(self) -> str:
        lines = [
            comment(f"{self.title}, written by foon-kg"),
            comment(
                "An object node is at hand or not; a unit needs its inputs and makes its outputs; nothing is used up."
            ),
            f"(define (domain {self.name})",
            f"  (:requirements {' '.join(self.requirements)})",
            f"  (:types {FOOD} {UTENSIL} - object)",
            "  (:constants",
            *self._constants(),
            "  )",
            "  (:predicates",
            f"    ({PREDICATE} ?node - object)",
            "  )",
            *(
                line
                for unit, action in zip(self.units, self.actions, strict=True)
                for line in self._action(unit, action)
            ),
            ")",
        ]
        return "\n".join(lines) + "\n"

    def problem(self) -> str:
        lines = [
            comment(f"{self.title}, written by foon-kg"),
            f"(define (problem {self.name}_problem)",
            f"  (:domain {self.name})",
            "  (:init",
            *(f"    {self._fact(node)}" for node in dict.fromkeys(self.begin)),
            "  )",
            f"  (:goal {self._goal()})",
            ")",
        ]
        return "\n".join(lines) + "\n"

    def plan(self) -> str:
        lines = [comment(f"{self.title}: the steps in foon-kg's own order")]
        for unit, action in zip(self.units, self.actions, strict=True):
            lines += [comment(unit_text(unit)), f"({action})"]
        return "\n".join(lines) + "\n"

    @property
    def requirements(self) -> tuple[str, ...]:
        """What a planner must understand: any one of several goal nodes asks for more than the rest."""
        return (":strips", ":typing", *((":disjunctive-preconditions",) if len(self.end) > 1 else ()))

    def _constants(self) -> Iterator[str]:
        for node, name in self.constants.items():
            yield "    " + comment(node_text(node))
            yield f"    {name} - {FOOD if self.kitchen.is_food(node) else UTENSIL}"

    def _action(self, unit: FunctionalUnit, action: str) -> Iterator[str]:
        yield "  " + comment(unit_text(unit))
        yield f"  (:action {action}"
        yield "    :parameters ()"
        yield f"    :precondition (and {' '.join(map(self._fact, unit.input_nodes))})"
        yield f"    :effect (and {' '.join(map(self._fact, unit.output_nodes))})"
        yield "  )"

    def _fact(self, node: ObjectNode) -> str:
        return f"({PREDICATE} {self.constants[node]})"

    def _goal(self) -> str:
        facts = " ".join(map(self._fact, self.end))
        return facts if len(self.end) == 1 else f"(or {facts})"
