"""A task tree as it is looked at, whether it came as a plan result or as FOON text."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Self

from foon_kg.formats.views.lives import lives
from foon_kg.model import ObjectNode, RequiredIngredient, Subgraph, steps_of
from foon_kg.model.claims import Substitution
from foon_kg.model.tree import Step, leaves_of
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.progress import ProgressLine, progress_lines
from foon_kg.plans.result import PlanResult


@dataclass(frozen=True)
class ShownTree:
    """The units of a tree in the order of execution, and what else is known of it.

    ``kitchen`` are the leaves, in the order in which they are taken. ``result`` is the plan result it came from;
    FOON text has none, and then nothing is known of substitutions and assumptions.
    """

    title: str
    units: tuple[Step, ...]
    goal: ObjectNode
    kitchen: tuple[ObjectNode, ...]
    lines: tuple[ProgressLine, ...]
    result: PlanResult | None = None

    @classmethod
    def of_result(cls, result: PlanResult) -> Self:
        """Return the tree of a plan's ``result``, to look at."""
        title = result.recipe.title or " · ".join(filter(None, (result.goal.label, result.recipe.id)))
        return cls(title, result.units, result.goal, result.kitchen, _named_lines(result), result)

    @classmethod
    def of_subgraph(cls, subgraph: Subgraph, goal: ObjectNode | None = None) -> Self:
        """Return the tree of a ``subgraph``, to look at.

        Unless the ``goal`` is known, it is the last output that is marked as one, else the first of the last unit.
        """
        units = tuple(
            replace(Step.of_unit(step.unit, "foon", step.seen_in), measures=note.measures)
            for note, step in zip(subgraph.annotations, steps_of(subgraph), strict=True)
        )
        outputs = [one for note in subgraph.annotations for one in note.unit.outputs]
        marked = [one.node for one in outputs if one.dish_type is not None]
        goal = goal or (marked[-1] if marked else subgraph.annotations[-1].unit.output_nodes[0])
        leaves = leaves_of(units)
        return cls(subgraph.name, units, goal, leaves, _lines_of_leaves(units, goal, leaves))

    def told_once(self) -> Self:
        """Return it with what several foods become part of in a line of its own."""
        return replace(self, lines=lives(self.lines))

    @property
    def substitutions(self) -> tuple[Substitution, ...]:
        """What stands for what, as the plan says; nothing for FOON text."""
        return self.result.substitutions if self.result else ()

    @property
    def unseen(self) -> Mapping[str, Substitution]:
        """The foods that this FOON has not seen so, each with its surest equivalent: single steps may have others."""
        found = (one for one in self.substitutions if one.kind == "object")
        return {one.object: one for one in sorted(found, key=lambda one: one.confidence)}


def _named_lines(result: PlanResult) -> tuple[ProgressLine, ...]:
    """Return the progress lines with the mixtures named that each food became part of: JSON has no field for them."""
    if any(step.object for line in result.progress_lines for step in line.steps):
        return result.progress_lines
    kitchen = Kitchen.default().with_foods(wanted.object for wanted in result.recipe.ingredients)
    tree = [unit.as_unit() for unit in result.units]
    named = progress_lines(tree, result.goal, result.recipe.ingredients, kitchen)
    found = {line: line for line in named}  # equal lines may differ in the names alone
    return tuple(found.get(line, line) for line in result.progress_lines)


def _lines_of_leaves(
    units: tuple[Step, ...], goal: ObjectNode, leaves: tuple[ObjectNode, ...]
) -> tuple[ProgressLine, ...]:
    kitchen = Kitchen.default()
    foods = dict.fromkeys(node.label for node in leaves if kitchen.is_food(node) and not kitchen.is_free(node.label))
    tree = [unit.as_unit() for unit in units]
    lines = progress_lines(tree, goal, [RequiredIngredient(food, "") for food in foods], kitchen)
    return tuple(line for line in lines if line.steps)
