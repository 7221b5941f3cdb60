"""What is done in a plan, step by step, in a form that tests can ask."""

from __future__ import annotations

from collections.abc import Callable

from foon_kg.model import ObjectNode, Recipe, RequiredIngredient
from foon_kg.planning.planner import Planner
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.result import PlanResult
from foon_kg.store.snapshot import Snapshot

Told = list[tuple[set[str], str, tuple[ObjectNode, ...]]]


def plans_of(snapshot: Snapshot) -> Callable[..., PlanResult]:
    """Return a function that plans a dish: its type, its title, its foods as ``food:state``, or ``food:state:part``."""
    planner = Planner(snapshot, PlanSettings(snapshot.kitchen, time_limit=None), snapshot.units)

    def plan(dish_type: str, title: str, *asked: str) -> PlanResult:
        told = (one.split(":") for one in asked)
        foods = tuple(RequiredIngredient(food, state, part="".join(part)) for food, state, *part in told)
        return planner.plan(Recipe(dish_type, foods, "x", title))

    return plan


def planned_steps(snapshot: Snapshot) -> Callable[..., Told]:
    """Return a function that plans a dish and returns its steps: the labels that go in, the motion, what comes out."""
    return steps_of(plans_of(snapshot))


def steps_of(plan: Callable[..., PlanResult]) -> Callable[..., Told]:
    """Return a function that returns the steps of what ``plan`` plans."""

    def steps(dish_type: str, title: str, *asked: str) -> Told:
        units = plan(dish_type, title, *asked).units
        return [({n.label for n in one.input_nodes}, one.motion, one.output_nodes) for one in units]

    return steps


def motions(told: Told) -> list[str]:
    """Return what is done, step by step."""
    return [motion for _, motion, _ in told]


def inside(told: Told, motion: str) -> set[str]:
    """Return the foods of what the first such motion works on."""
    (outputs, *_) = [outputs for _, one, outputs in told if one == motion]
    return {food for node in outputs for food in node.ingredients}


def taking(told: Told, motion: str) -> set[str]:
    """Return what goes into any step of such a motion."""
    return {one for inputs, done, _ in told if done == motion for one in inputs}


def last(told: Told, food: str) -> int:
    """Return the last step that takes a food by its own name."""
    return max(place for place, (inputs, _, _) in enumerate(told) if food in inputs)


def states_of(told: Told, food: str) -> set[str]:
    """Return all states in which a food is seen."""
    return {state for _, _, outputs in told for node in outputs if node.label == food for state in node.states}


def first(told: Told, food: str, motion: str) -> int:
    """Return at which step such a motion is first done to a food."""
    return next(place for place, (inputs, one, _) in enumerate(told) if food in inputs and one == motion)
