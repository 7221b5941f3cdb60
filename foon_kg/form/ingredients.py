"""C4 complete, C5 nothing else, C6 kitchen: whether the tree is about the foods that were asked, as they were asked."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from foon_kg.form.case import Case
from foon_kg.form.report import Finding
from foon_kg.kitchen import LeafFault, singular
from foon_kg.model import ObjectNode, RequiredIngredient


def complete(case: Case) -> Iterator[Finding]:
    """C4: every required (object, state) is a node of the tree, and the object is an ingredient of the goal node.

    Names compare in the singular (``{}`` names are often plurals), states as they are written. Where no state is asked,
    any node of the food will do.
    """
    if case.tree.error is not None:
        return
    in_goal = frozenset(map(singular, case.goal.ingredients)) if case.goal else frozenset()
    for wanted in sorted(set(case.required)):
        if not any(_is(node, wanted) for node in case.tree.nodes):
            state = f" in the state “{wanted.state}”" if wanted.state else ""
            yield Finding("C4", f"no node of the tree is {wanted.object}{state}, as required")
        if singular(wanted.object) not in in_goal:
            yield Finding(
                "C4", f"{wanted.object} is required and not among the ingredients of the goal", None, case.goal
            )


def _is(node: ObjectNode, wanted: RequiredIngredient) -> bool:
    return singular(node.label) == singular(wanted.object) and (not wanted.state or wanted.state in node.states)


def nothing_else(case: Case) -> Iterator[Finding]:
    """C5: every leaf food is required or free; so is every food in a vessel that is a leaf, and in the goal.

    Intermediates that the tree makes may be in the goal and in vessels; what was taken out may not.
    """
    for node in case.tree.leaves:
        place = case.tree.takers[node][0]
        is_food = case.kitchen.is_food(node)
        names = [node.label] if is_food else case.kitchen.foods_in(node)
        for name in names:
            if not case.is_required_or_free(name) and (is_food or singular(name) not in case.intermediates):
                yield Finding("C5", f"{name} comes from the kitchen and nobody asked for it", place, node)
    for name in case.kitchen.foods_in(case.goal) if case.goal else ():
        if not case.is_required_or_free(name) and singular(name) not in case.intermediates:
            yield Finding(
                "C5", f"the goal names {name}, which nobody asked for and the tree does not make", None, case.goal
            )


def free_foods(case: Case) -> tuple[str, ...]:
    """Answer what the setting of free foods let in (C5), sorted."""
    names = case.names_of(case.tree.leaves)
    return tuple(sorted(name for name in names if name not in case.required_names and case.kitchen.is_free(name)))


def kitchen(case: Case) -> Iterator[Finding]:
    """C6: every leaf is in a start state, or is a processed food that FOON cannot make and that is assumed openly.

    Where a person named what is at hand, every leaf is something named, assumed or not.
    """
    assumed = {entry.node for entry in case.tree.assumptions or ()}
    for node in case.tree.leaves:
        if case.kitchen.lacks(node):
            yield Finding("C6", "it is not in the kitchen that was named", case.tree.takers[node][0], node)
            continue
        for place, reason in _leaf_faults(case, node, assumed):
            yield Finding("C6", reason, place, node)
    for node in _kitchen_foods(case):
        for place in case.tree.newly_made.get(node, ())[:1]:
            yield Finding("C6", "it is in the kitchen, and the tree makes it", place, node)
    yield from _assumptions(case)


def _kitchen_foods(case: Case) -> Iterable[ObjectNode]:
    return dict.fromkeys(node for node in case.tree.kitchen or () if case.kitchen.is_food(node))


def _leaf_faults(case: Case, node: ObjectNode, assumed: set[ObjectNode]) -> Iterator[tuple[int, str]]:
    places = case.tree.takers[node]
    if case.kitchen.is_food(node):
        fault = case.kitchen.leaf_fault(node)
        if fault is not None and node not in assumed:
            yield places[0], f"{fault.value} is taken from the kitchen and not named under assumptions"
        return
    cold = _at_rest_again(case, node)
    if cold != node and _is_made(case, node):
        yield places[0], f"{LeafFault.RUNNING.value}, and a unit of the FOON does"
    for place in places:
        fault = case.kitchen.leaf_fault(cold, case.tree.units[place].input_nodes)
        if fault is not None:
            yield place, fault.value
            return


def _at_rest_again(case: Case, node: ObjectNode) -> ObjectNode:
    """Answer the same utensil without being on or hot: what else C6 asks of it is asked of this."""
    if not case.kitchen.is_running(node):
        return node
    return replace(
        node, states=tuple(s for s in node.states if not case.kitchen.is_running(replace(node, states=(s,))))
    )


def _is_made(case: Case, node: ObjectNode) -> bool:
    """Whether a unit makes a utensil on or hot. By definition no unit of the tree does: the FOON is asked."""
    return case.foon is not None and case.foon.makes(node)


def _assumptions(case: Case) -> Iterator[Finding]:
    leaves = set(case.tree.leaves)
    for entry in case.tree.assumptions or ():
        if entry.node not in leaves:
            yield Finding("C6", "it is assumed to be at hand and is no leaf of the tree", None, entry.node)
        elif not entry.why.strip():
            yield Finding("C6", "it is assumed to be at hand and nothing says why", None, entry.node)
        for state in case.kitchen.processed_states(entry.node) if case.kitchen.is_food(entry.node) else ():
            if case.foon is not None and case.foon.processes(entry.node.label, state):
                yield Finding(
                    "C6", f"it is assumed to be {state}, and FOON has a unit that makes it so", None, entry.node
                )
