"""A task tree as the judge reads it: from the JSON of a plan result, or from FOON text of anyone.

The judge has a reader of its own, so that a result that its planner's types would refuse (a substitution without a
confidence) is told apart by rule and not by a parse error.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Self

from foon_kg.food import tables
from foon_kg.model import ObjectNode, Recipe, Subgraph
from foon_kg.model.errors import ReadError
from foon_kg.model.json_fields import Fields
from foon_kg.model.levels import Level
from foon_kg.model.node_json import node_from_json, recipe_from_json, sighting_from_json
from foon_kg.model.tree import Step, TreeUnit, leaves_of, nodes_of
from foon_kg.model.tree_json import step_from_json


@dataclass(frozen=True)
class Substituted:
    """An entry of ``substitutions``; ``None`` and ``""`` stand for what it does not say."""

    kind: str
    object: str
    required: str
    equivalent: str | None
    confidence: float | None
    alternatives: tuple[tuple[str, float | None], ...] | None

    @classmethod
    def from_json(cls, fields: Fields) -> Self:
        """Read an entry; only what it does say must have the right type."""
        alternatives = None
        if "alternatives" in fields:
            entries = fields.nested_list("alternatives")
            alternatives = tuple((a.optional_text("name") or "", a.optional_number("confidence")) for a in entries)
        return cls(
            fields.optional_text("kind") or "",
            fields.optional_text("object") or "",
            fields.optional_text("required") or "",
            fields.optional_text("equivalent"),
            fields.optional_number("confidence"),
            alternatives,
        )


@dataclass(frozen=True)
class Assumed:
    """An entry of ``assumptions``."""

    node: ObjectNode
    why: str


@dataclass(frozen=True)
class TaskTree:
    """A tree to be judged. ``None`` (and an ``error``) stands for what its source does not say.

    ``kitchen`` is ``None`` for FOON text, and so are ``substitutions`` and ``assumptions``: nothing is claimed there.
    ``level`` is that of a classic retrieval, which asks for a goal and not for a recipe; ``None`` for all others.
    """

    name: str
    units: tuple[TreeUnit, ...]
    goal: ObjectNode | None = None
    recipe: Recipe | None = None
    kitchen: tuple[ObjectNode, ...] | None = None
    substitutions: tuple[Substituted, ...] | None = None
    assumptions: tuple[Assumed, ...] | None = None
    error: str | None = None
    level: Level | None = None

    @classmethod
    def from_json(cls, value: object, where: str = "plan") -> TaskTree:
        """Read a plan result (design.md section 6), or the result of a classic retrieval, which says its ``level``.

        Raises ReadError where a field has the wrong type.
        """
        fields = Fields(value, where)
        level = _level(fields) if "level" in fields else None
        recipe = None if level else recipe_from_json(fields.nested("recipe"))
        name = (recipe.id or recipe.title if recipe else fields.nested("goal").text("label")) or where
        if "error" in fields:
            return cls(name, (), recipe=recipe, error=fields.nested("error").text("message"))
        return cls(
            name,
            tuple(map(_unit, fields.nested_list("units"))),
            node_from_json(fields.nested("goal")),
            recipe,
            tuple(map(node_from_json, fields.nested_list("kitchen"))),
            tuple(map(Substituted.from_json, fields.nested_list("substitutions"))),
            tuple(
                Assumed(node_from_json(entry.nested("node")), entry.optional_text("why") or "")
                for entry in fields.nested_list("assumptions")
            ),
            level=level,
        )

    @classmethod
    def from_subgraph(cls, subgraph: Subgraph, recipe: Recipe | None = None) -> TaskTree:
        """Read a tree from FOON text: its goal is the last food that is marked with a dish class."""
        units = [annotation.unit for annotation in subgraph.annotations]
        marked = [p.node for unit in units for p in unit.outputs if p.dish_type and not tables().utensil(p.node.label)]
        return cls(subgraph.name, tuple(map(TreeUnit.of, units)), marked[-1] if marked else None, recipe)

    @cached_property
    def made(self) -> dict[ObjectNode, tuple[int, ...]]:
        """The places of the units that output each node without having taken it."""
        return _places([unit.new_outputs for unit in self.units])

    @cached_property
    def takers(self) -> dict[ObjectNode, tuple[int, ...]]:
        """The places of the units that take each node."""
        return _places([unit.input_nodes for unit in self.units])

    @cached_property
    def leaves(self) -> tuple[ObjectNode, ...]:
        """The inputs that no earlier unit outputs, in the order of their first use."""
        return leaves_of(self.units)

    @cached_property
    def nodes(self) -> tuple[ObjectNode, ...]:
        """Every object node of the tree, in the order of appearance."""
        return nodes_of(self.units)


def _level(fields: Fields) -> Level:
    number = fields.whole_number("level")
    if number not in list(Level):
        raise ReadError(f"{fields.where}: a FOON has no level {number}", hint="The levels are 1, 2 and 3.")
    return Level(number)


def _unit(fields: Fields) -> TreeUnit:
    step = step_from_json(fields)
    return TreeUnit(
        Step(tuple(dict.fromkeys(step.inputs)), step.motion, tuple(dict.fromkeys(step.outputs))),
        fields.optional_text("origin"),
        tuple(map(sighting_from_json, fields.nested_list("seen_in"))) if "seen_in" in fields else (),
        fields.optional_text("grounding"),
    )


def _places(sides: list[tuple[ObjectNode, ...]]) -> dict[ObjectNode, tuple[int, ...]]:
    places: dict[ObjectNode, tuple[int, ...]] = {}
    for place, nodes in enumerate(sides):
        for node in nodes:
            places[node] = (*places.get(node, ()), place)
    return places
