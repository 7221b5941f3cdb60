"""A video taken out of the FOON becomes a question: its dish, and its foods as they first join one another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from foon_kg.kitchen import Kitchen, is_place, singular
from foon_kg.model import FunctionalUnit, ObjectNode, Recipe, RequiredIngredient, Subgraph
from foon_kg.snapshot import goals_of


@dataclass(frozen=True)
class LeftOutVideo:
    """What is asked (``recipe``, named after the video), and the true subgraph that a person annotated."""

    recipe: Recipe
    units: tuple[FunctionalUnit, ...]

    @property
    def name(self) -> str:
        """The name of the video."""
        return self.recipe.id or ""


def left_out_video(subgraph: Subgraph, kitchen: Kitchen) -> LeftOutVideo | None:
    """Answer the question that ``subgraph`` becomes; ``None`` for one that marks no dish, or one of no foods.

    Of several goals the one of most foods is asked, ties go to the first by content. Each of its foods is asked in the
    state in which it first joins others (:func:`joining_state`); ``""`` where the video shows none.
    """
    goals = [(node, dish) for node, dish in goals_of(subgraph, kitchen) if kitchen.foods_in(node)]
    if not goals:
        return None
    node, dish_type = min(goals, key=lambda goal: (-len(kitchen.foods_in(goal[0])), goal[0].sort_key, goal[1]))
    units = tuple(annotation.unit for annotation in subgraph.annotations)
    foods = {singular(name): name for name in kitchen.foods_in(node)}
    wants = tuple(joining_state(units, foods[food], node, kitchen) for food in sorted(foods))
    return LeftOutVideo(Recipe(dish_type, wants, subgraph.name), units)


def joining_state(units: Sequence[FunctionalUnit], name: str, goal: ObjectNode, kitchen: Kitchen) -> RequiredIngredient:
    """Answer the food ``name`` as the video has it when it first joins others, under the video's own label.

    It joins at the first unit that takes the food itself and leaves the goal, or something new that holds it beside
    another food; where none does, at the last that takes it. Of several states the one that it got last counts,
    somebody's work before how it is sold.
    """
    food, got, joined = singular(name), dict[str, int](), None
    for place, unit in enumerate(units):
        taken = [node for node in unit.input_nodes if kitchen.is_food(node) and singular(node.label) == food]
        for state in (state for node in taken for state in node.states):
            got.setdefault(state, place)
        if taken:
            joined = taken[-1]
            if any(_takes_up(node, food, goal, kitchen) for node in unit.output_nodes if node not in unit.input_nodes):
                break
    if joined is None:
        return RequiredIngredient(name, "")
    made = kitchen.processed_states(joined)
    states = made or tuple(state for state in joined.states if not is_place(state))
    return RequiredIngredient(joined.label, max(states, key=lambda state: (got[state], state), default=""))


def _takes_up(node: ObjectNode, food: str, goal: ObjectNode, kitchen: Kitchen) -> bool:
    if node == goal:
        return True
    inside = {singular(name) for name in kitchen.foods_in(node)}
    return food in inside and len(inside) > 1 and singular(node.label) != food
