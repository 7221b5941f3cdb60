"""Recipes that were recorded already: every goal of a FOON, asked as its dish type with its own foods.

A dish that somebody made on film can be made again, so every recipe without a tree is a fault of the plan, or of the
recording.
"""

from collections.abc import Iterator, Sequence

from foon_kg.kitchen import Kitchen, singular, words
from foon_kg.lines import FoodLine, food_lines
from foon_kg.model import KnownUnit, ObjectNode, Recipe, RequiredIngredient, Subgraph
from foon_kg.snapshot import goals_of


def own_goals(subgraphs: Sequence[Subgraph], kitchen: Kitchen) -> Iterator[Recipe]:
    """Answer a recipe for each goal of ``subgraphs``, in their order: its ingredients as they first join others there.

    So is what it is named after (the noodles that are boiled noodles). A food that the subgraph makes (a dressing) is
    asked as the foods that are in it; free foods are not asked.
    """
    for subgraph in subgraphs:
        for node, dish_type in goals_of(subgraph, kitchen):
            units = [KnownUnit(annotation.unit, ()) for annotation in subgraph.annotations]
            wants = tuple(dict.fromkeys(_wants(node, units, kitchen)))
            if wants:
                yield Recipe(dish_type, wants, id=f"{subgraph.name}: {node.label}", title=node.label)


def _wants(goal: ObjectNode, units: Sequence[KnownUnit], kitchen: Kitchen) -> Iterator[RequiredIngredient]:
    lines = food_lines(units, kitchen)
    known = {singular(label): line for label, line in reversed(lines.items())}
    outputs = [node for unit in reversed(units) for node in unit.unit.output_nodes if kitchen.is_food(node)]
    made_of = {singular(node.label): node.ingredients for node in reversed(outputs) if node.ingredients}
    namesakes = [label for label in lines if set(words(label)) & set(words(goal.label))]
    waiting, seen = [*reversed(namesakes), *reversed(goal.ingredients)], set[str]()
    while waiting:
        name = waiting.pop()
        one = singular(name)
        if one in seen or kitchen.is_utensil(name) or kitchen.is_free(name):
            continue
        seen.add(one)
        if one in known:
            yield RequiredIngredient(known[one].label, _state(known[one], units, kitchen))
        elif one in made_of:
            waiting.extend(reversed(made_of[one]))
        else:
            yield RequiredIngredient(name, "")


def _state(line: FoodLine, units: Sequence[KnownUnit], kitchen: Kitchen) -> str:
    """Answer the state in which a food joins others; of several one that somebody made, then the first by name."""
    inputs = [node for node in units[line.joins].unit.input_nodes if node.label == line.label]
    states = {state for node in inputs for state in node.states}
    return min(states, key=lambda state: (kitchen.is_start_state(line.label, state), state), default="")
