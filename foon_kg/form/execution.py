"""C1 executable, C2 goal, C3 connected: whether the units can be run, and whether they lead anywhere."""

from __future__ import annotations

from collections.abc import Iterator

from foon_kg.form.case import Case
from foon_kg.form.report import Finding
from foon_kg.model import ObjectNode


def executable(case: Case) -> Iterator[Finding]:
    """C1: every input is in the kitchen or an output of an earlier unit.

    A tree that names no kitchen (FOON text) starts from its leaves, and from the empty utensils at rest that it also
    puts back later.
    """
    there = set(case.tree.kitchen if case.tree.kitchen is not None else _kitchen_of_text(case))
    for place, unit in enumerate(case.tree.units):
        for node in unit.input_nodes:
            if node not in there:
                yield Finding("C1", _why_missing(case, node, place), place, node)
        there.update(unit.output_nodes)


def _kitchen_of_text(case: Case) -> Iterator[ObjectNode]:
    for node in case.tree.takers:
        if node not in case.tree.newly_made or (not case.kitchen.is_food(node) and case.kitchen.has(node)):
            yield node


def _why_missing(case: Case, node: ObjectNode, place: int) -> str:
    later = [maker for maker in case.tree.newly_made.get(node, ()) if maker >= place]
    if later:
        return f"it is needed before it is made: only unit {later[0]} outputs it"
    return "it is neither in the kitchen nor an output of an earlier unit"


def goal(case: Case) -> Iterator[Finding]:
    """C2: the last unit outputs the goal node, whose label is an end product of the asked dish type in the FOON.

    Without a recipe any dish type will do; where the goal itself was asked for (classic retrieval), any product.
    """
    tree = case.tree
    if tree.error is not None:
        yield Finding("C2", f"there is no tree: {tree.error}")
        return
    if not tree.units:
        yield Finding("C2", "the tree has no units")
        return
    last = len(tree.units) - 1
    if case.goal is None or case.goal not in tree.units[last].output_nodes:
        yield Finding("C2", "the last unit does not output the goal", last, case.goal)
    if case.goal is None or case.foon is None or tree.level is not None:
        return
    products = case.foon.end_products
    dish_types = [case.recipe.dish_type] if case.recipe else sorted(products)
    if not any(case.goal.label in products.get(dish_type, ()) for dish_type in dish_types):
        asked = f"of the dish type {case.recipe.dish_type}" if case.recipe else "of any dish type"
        yield Finding("C2", f"“{case.goal.label}” is no end product {asked} in the FOON", last, case.goal)


def connected(case: Case) -> Iterator[Finding]:
    """C3: each unit leads to the last one; no unit twice, none whose outputs are all among its inputs.

    A chain goes through what a unit newly makes: a stove that was on before and after it leads nowhere.
    """
    units = case.tree.units
    seen: dict[tuple[object, ...], int] = {}
    leads = _leads_to_the_end(case)
    for place, unit in enumerate(units):
        if not unit.new_outputs:
            yield Finding("C3", "all its outputs are among its inputs: it does nothing", place)
        if unit.identity in seen:
            yield Finding("C3", f"it is the same as unit {seen[unit.identity]}", place)
        seen.setdefault(unit.identity, place)
        if place not in leads:
            yield Finding("C3", "nothing that it makes leads to the goal", place)


def _leads_to_the_end(case: Case) -> set[int]:
    units = case.tree.units
    leads = {len(units) - 1}
    for place in reversed(range(len(units) - 1)):
        takers = (taker for node in units[place].new_outputs for taker in case.tree.takers.get(node, ()))
        if any(taker > place and taker in leads for taker in takers):
            leads.add(place)
    return leads
