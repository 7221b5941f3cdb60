"""The form of a tree (docs/contract.md, C1 to C6): that it runs, leads to the goal, and is about what was asked."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain

from foon_kg.food import Food, singular, words
from foon_kg.food.lists import word_list
from foon_kg.food.parted import parts_asked
from foon_kg.food.rows import State
from foon_kg.food.told_states import in_turn
from foon_kg.model import DISH_TYPES, ObjectNode
from foon_kg.validation.case import Case, was_taken_out
from foon_kg.validation.dish import missing_namesakes
from foon_kg.validation.report import Finding
from foon_kg.world import Part, PlayedStep
from foon_kg.world.reading import NodeReading

_CLOSES = ("switch off", "close", "uncover", "open", "detach", "discard", "clean")
_ENABLES = ("switch on", "attach", "warm")
_SWITCHES = ("switch on", "switch off", "attach", "detach", "close", "uncover")
"""What may be done again once it was undone: W3 asks whether it was."""


def executable(case: Case) -> Iterator[Finding]:
    """Yield the findings of C1 in ``case``: every input is in the kitchen, or an output of an earlier unit."""
    tree = case.tree
    if tree.kitchen is None:
        return  # FOON text names no kitchen: it starts from its leaves, and C6 asks of what kind they are
    there = set(tree.kitchen)
    for place, unit in enumerate(tree.units):
        for node in unit.input_nodes:
            if node not in there:
                yield Finding("C1", _why_missing(case, node, place), place, (node,))
        there.update(unit.output_nodes)


def _why_missing(case: Case, node: ObjectNode, place: int) -> str:
    later = [maker for maker in case.tree.made.get(node, ()) if maker >= place]
    if later:
        return f"it is needed before it is made: only step {later[0] + 1} outputs it"
    return "it is neither in the kitchen nor an output of an earlier step"


def goal(case: Case) -> Iterator[Finding]:
    """Yield the findings of C2 in ``case``: the last unit that touches food outputs the goal, named as such a dish is.

    Its namesakes are in it. Without a recipe any dish type will do; where the goal itself was asked for (classic
    retrieval), any product.
    """
    tree = case.tree
    if tree.error is not None:
        yield Finding("C2", f"there is no tree: {tree.error}")
        return
    last = case.last
    if last is None:
        yield Finding("C2", "the tree has no step with food")
        return
    if case.goal is None or case.goal not in tree.units[last].output_nodes:
        yield Finding("C2", "the last step with food does not output the goal", last, _one(case.goal))
    if case.goal is None or case.foon is None or tree.level is not None:
        return
    yield from _name(case, case.goal)


def _name(case: Case, node: ObjectNode) -> Iterator[Finding]:
    """Yield that a goal is called as no end product of the FOON nor after its type, and what its name wants in it."""
    types = case.dish_types
    if not (_is_called_by_type(node.label, types or DISH_TYPES) or _is_recorded(case, node.label)):
        asked = f"of the dish type {types[0]}" if types else "of any dish type"
        yield Finding("C2", f"“{node.label}” is no end product {asked} in the FOON", case.last, (node,))
    for food in missing_namesakes(case, node.label):
        yield Finding("C2", f"it is called after {food}, which is not in it", case.last, (node,))


def _is_called_by_type(label: str, types: Sequence[str]) -> bool:
    """Whether the last word of a label is a dish type, or a word of one."""
    bare = {singular(word) for dish_type in types for word in (dish_type, *words(dish_type))}
    return not bare.isdisjoint(words(singular(label))[-1:])


def _is_recorded(case: Case, label: str) -> bool:
    """Whether a video of the FOON ends with a product of that label, of the dish types that the goal may be of."""
    products = case.foon.end_products if case.foon else {}
    types = case.dish_types or products
    return singular(label) in {singular(product) for one in types for product in products.get(one, ())}


def _one(node: ObjectNode | None) -> tuple[ObjectNode, ...]:
    return () if node is None else (node,)


def purposeful(case: Case) -> Iterator[Finding]:
    """Yield the findings of C3 in ``case``: each unit leads to the goal or closes what the tree opened.

    None is there twice and none is idle; all is off at the end.
    """
    seen: dict[tuple[object, ...], int] = {}
    last: dict[tuple[object, ...], int] = {}
    leads = _leads_to_the_end(case)
    for place, unit in enumerate(case.tree.units):
        if not unit.new_outputs:
            yield Finding("C3", "all its outputs are among its inputs: it changes nothing", place)
        identity = unit.identity
        if identity in seen and not _was_undone(case, last[identity], place):
            yield Finding("C3", f"it is the same as step {seen[identity] + 1}", place)
        seen.setdefault(identity, place)
        last[identity] = place
        if place not in leads and not case.played_steps[place].does(*_CLOSES):
            yield Finding("C3", "nothing that it makes leads to the goal", place)
    if case.tree.level is None:
        yield from _left_on(case)


def _left_on(case: Case) -> Iterator[Finding]:
    """Yield the appliances that are on after the last step."""
    for vessel in chain.from_iterable(case.world.supply.vessels.values()):
        if vessel.is_appliance and any(vessel.power.values()):
            yield Finding("C3", f"the {vessel.label} is still on at the end")


def _was_undone(case: Case, before: int, place: int) -> bool:
    """Whether a switch or lid was put back between two equal steps, so that it is turned or put on anew."""
    if not case.played_steps[place].does(*_SWITCHES):
        return False
    wanted = set(case.tree.units[place].inputs)
    between = case.tree.units[before + 1 : place]
    return any(not wanted.isdisjoint(set(unit.outputs) - set(unit.inputs)) for unit in between)


def _leads_to_the_end(case: Case) -> set[int]:
    """Return the places of the units that the goal needs: what they make is taken by such a unit, or is in the dish."""
    units = case.tree.units
    last = case.last if case.last is not None else len(units) - 1
    leads = {last}
    inside = {id(part) for part in case.parts}
    for place in reversed(range(len(units))):
        takers = {taker for node in units[place].new_outputs for taker in case.tree.takers.get(node, ())}
        taken = any(taker > place for taker in takers & leads)
        if taken or _serves(case.played_steps[place], inside, before_the_end=place < last):
            leads.add(place)
    return leads


def _serves(played_step: PlayedStep, inside: set[int], *, before_the_end: bool) -> bool:
    """Whether a step works on what is in the dish, by the identities of its parts, or makes a later step possible."""
    lumps = [*played_step.outputs.values(), *(lump for lump, _, _ in played_step.moved)]
    if any(id(part) in inside for lump in lumps for part in lump.parts):
        return True
    return before_the_end and played_step.does(*_ENABLES)


def complete(case: Case) -> Iterator[Finding]:
    """Yield the findings of C4 in ``case``: every required food is in the goal by identity.

    It had its asked state, or it is told how that was read.
    """
    if case.tree.error is not None:
        return
    shown = _shown_states(case)
    for wanted in sorted(set(case.required)):
        food = singular(wanted.object)
        told = _declared_states(case, food)
        for state in in_turn(wanted.state) or ("",):
            if state not in told and not _is_shown(case, food, state, shown):
                so = f" in the state “{state}”" if state else ""
                yield Finding("C4", f"no node of the tree is {wanted.object}{so}, as required")
        if food not in case.parts_by_name and not was_taken_out(case, food):
            yield Finding("C4", f"{wanted.object} is required and is not in the goal", None, _one(case.goal))


def _shown_states(case: Case) -> dict[str, set[str]]:
    """Return all states in which nodes of the tree show each object."""
    shown: dict[str, set[str]] = {}
    for node in case.tree.nodes:
        shown.setdefault(singular(node.label), set()).update(node.states)
    return shown


def _declared_states(case: Case, food: str) -> set[str]:
    """Return the states of a food for which the tree says as what it read them, with those as which it did."""
    entries = [entry for entry in case.tree.substitutions or () if entry.kind == "state"]
    return {state for one in entries if singular(one.object) == food for state in (one.required, one.equivalent)}


def _is_shown(case: Case, food: str, state: str, shown: Mapping[str, set[str]]) -> bool:
    """Whether nodes show a food in a state; of one that is asked in its two parts they may show both of these so."""
    if food not in shown:
        return False
    return not state or state in shown[food] or state in _shown_of_parts(case, food, state, shown)


def _shown_of_parts(case: Case, food: str, state: str, shown: Mapping[str, set[str]]) -> set[str]:
    """Return in which states both parts are that a food comes apart into, where it is asked in its parts."""
    parts = parts_asked(food, case.tables.foods.food(food), state)
    return set.intersection(*(shown.get(part, set()) for part in parts)) if parts else set()


def nothing_else(case: Case) -> Iterator[Finding]:
    """Yield the findings of C5 in ``case``: every food that is taken from the kitchen was asked for, or is free."""
    told: set[str] = set()
    frying = _for_frying(case)
    for part in case.world.supply.parts:
        if part.name in told or part.food.is_a("made") or case.is_wanted(part.name) or case.is_free(part.name):
            continue
        if part.origin in frying:
            continue
        told.add(part.name)
        yield Finding("C5", f"{part.name} comes from the kitchen and nobody asked for it", part.taken)


def _for_frying(case: Case) -> set[int]:
    """Return the origins of fat of the household that something was fried in, as often as it is told to be assumed.

    What is left of it in its bottle was not taken.
    """
    told = Counter(singular(entry.node.label) for entry in case.tree.assumptions or ())
    fats = [p for p in case.world.supply.parts if p.name in told and p.food.kind in word_list("is fried in unasked")]
    return _as_told(case, fats, told) if fats else set()


def _as_told(case: Case, fats: Iterable[Part], told: Counter[str]) -> set[int]:
    """Return the origins of ``fats`` that were heated, the first ones, as often as each is ``told``.

    So are those of what was not taken out of its bottle.
    """
    heated, taken = _heated_and_taken(case)
    found = set[int]()
    for part in fats:
        if part.origin not in taken:
            found.add(part.origin)
        elif part.origin in heated and told[part.name] > 0:
            told[part.name] -= 1
            found.add(part.origin)
    return found


def _heated_and_taken(case: Case) -> tuple[set[int], set[int]]:
    """Return the origins of the parts that were heated, in whatever they went up, and of those not left in storage."""
    lumps = set(chain.from_iterable(case.world.supply.lumps.values()))
    heated = {part.origin for lump in lumps for part in lump.parts if part.heated is not None}
    out = (lump for lump in lumps if lump.where is None or not lump.where.row.keeps_food)
    return heated, {part.origin for lump in out for part in lump.parts}


def free_foods(case: Case) -> tuple[str, ...]:
    """Return what the setting of free foods let into the tree of ``case`` (C5), sorted."""
    taken = {part.name for part in case.world.supply.parts}
    return tuple(sorted(name for name in taken if case.is_free(name) and name not in case.required_names))


def kitchen(case: Case) -> Iterator[Finding]:
    """Yield the findings of C6 in ``case``: every leaf is as a kitchen has it.

    What is processed is assumed openly, where FOON cannot make it.
    """
    assumed = {entry.node for entry in case.tree.assumptions or ()}
    for node in case.tree.leaves:
        place, said = case.tree.takers[node][0], case.read(node)
        if case.lacks is not None and case.lacks(node):
            yield Finding("C6", "it is not in the kitchen that was named", place, (node,))
            continue
        reason = _utensil_fault(case, said) if not said.is_food else _food_fault(case, said)
        if reason and node not in assumed and not _is_so_already(case, node, place):
            yield Finding("C6", reason, place, (node,))
    yield from _assumptions(case)


def _is_so_already(case: Case, node: ObjectNode, place: int) -> bool:
    """Whether a person said that it is so, or an earlier step brought it so, though it did not say the whole node."""
    if case.is_named_so(node):
        return True
    played_step = case.played_steps[place]
    said = case.read(node)
    if said.is_food:
        return not any(part.name == said.label and part.taken == place for part in played_step.taken)
    fetched = {part.name for part in played_step.taken if part.unstated}
    return bool(said.names) and said.names.isdisjoint(fetched)


def _utensil_fault(case: Case, said: NodeReading) -> str:
    if said.utensil is not None and said.utensil.always_on:
        return ""
    if said.on or said.hot:
        return "it is on or hot before anybody turned anything on"
    if said.names and not _keeps_food(said):
        return "it is filled, and nobody filled it"
    rest = case.tables.utensil_states["rest"]
    for state in said.node.states:
        if state.lower() not in rest and "[" not in state:
            return f"it is {state} before anybody used it"
    return ""


def _keeps_food(said: NodeReading) -> bool:
    return said.utensil is not None and said.utensil.role == "storage"


def _food_fault(case: Case, said: NodeReading) -> str:
    """Return why a kitchen has no food as a leaf says; nothing where it has."""
    if _is_put_somewhere(said):
        return f"it is in the {said.place} before anybody put it there"
    facts = case.tables.foods.food(said.label, said.node.states)
    if facts.is_a("made", "dough") and said.names - {said.label}:
        return "it is made of other foods, and nobody made it"
    for state in said.node.states:
        row = case.tables.state(state)
        if "[" not in state and (row.earns or row.fine or row.half) and not _is_sold_so(facts, state, row):
            return f"it is {state} before anybody made it so"
    return ""


def _is_put_somewhere(said: NodeReading) -> bool:
    """Whether a food is told in a vessel or tool, into which somebody has to put it."""
    place = said.place_utensil
    return place is not None and place.role != "place" and not place.always_on and not place.keeps_food


def _is_sold_so(facts: Food, state: str, row: State) -> bool:
    """Whether a shop sells a food in a state: any food, its kind, or itself."""
    return row.sold or facts.sold_as == state or (bool(row.sold_for) and facts.is_a(*row.sold_for))


def _assumptions(case: Case) -> Iterator[Finding]:
    leaves = set(case.tree.leaves)
    for entry in case.tree.assumptions or ():
        if entry.node not in leaves:
            yield Finding("C6", "it is assumed to be at hand and is no leaf of the tree", None, (entry.node,))
        elif not entry.why.strip():
            yield Finding("C6", "it is assumed to be at hand and nothing says why", None, (entry.node,))
        elif case.foon is not None:
            yield from _could_be_made(case, entry.node)


def _could_be_made(case: Case, node: ObjectNode) -> Iterator[Finding]:
    """Yield the states that a food is assumed to be in and that a unit of the FOON gives it, or one of its kind."""
    label = singular(node.label)
    kind = case.tables.foods.food(label).kind
    operators = case.foon.operators if case.foon is not None else ()
    for state in node.states:
        row = case.tables.state(state)
        if row.sold or not (row.earns or row.fine):
            continue
        if (label, state) in operators or (kind != "unknown" and (kind, state) in operators):
            yield Finding("C6", f"it is assumed to be {state}, and FOON has an operator for such a food", None, (node,))
