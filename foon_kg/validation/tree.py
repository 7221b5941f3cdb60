"""How the judge reads a task tree: from the JSON of a plan result, or from FOON text of anyone.

The judge has a reader of its own, so that a result that the planner's reader would refuse (a substitution without a
confidence) is told apart by rule and not by a parse error.
"""

from __future__ import annotations

from foon_kg.food import tables
from foon_kg.model import Recipe, Subgraph
from foon_kg.model.claims import Alternative, Assumption, Substitution
from foon_kg.model.errors import ReadError
from foon_kg.model.json_fields import Fields
from foon_kg.model.levels import Level
from foon_kg.model.node_json import node_from_json, recipe_from_json, sighting_from_json
from foon_kg.model.tree import Step, TaskTree
from foon_kg.model.tree_json import step_from_json


def tree_from_json(value: object, where: str = "plan") -> TaskTree:
    """Return the tree of a plan result (docs/reference/result.md), or of a classic retrieval, which says its ``level``.

    ``value`` is the result as JSON is read, ``where`` what errors call it. A plan that has an ``error`` is a tree
    without units. Raises ReadError where a field has the wrong type; what a substitution or a step does not say is left
    open, and for the rules to judge.
    """
    fields = Fields(value, where)
    level = _level(fields) if "level" in fields else None
    recipe = None if level else recipe_from_json(fields.nested("recipe"))
    name = (recipe.id or recipe.title if recipe else fields.nested("goal").text("label")) or where
    if "error" in fields:
        return TaskTree(name, (), recipe=recipe, error=fields.nested("error").text("message"))
    return TaskTree(
        name,
        tuple(map(_unit, fields.nested_list("units"))),
        node_from_json(fields.nested("goal")),
        recipe,
        tuple(map(node_from_json, fields.nested_list("kitchen"))),
        tuple(map(_substitution, fields.nested_list("substitutions"))),
        tuple(
            Assumption(node_from_json(entry.nested("node")), entry.optional_text("why") or "")
            for entry in fields.nested_list("assumptions")
        ),
        level=level,
    )


def tree_from_subgraph(subgraph: Subgraph, recipe: Recipe | None = None) -> TaskTree:
    """Return the tree that ``subgraph``, FOON text, tells: its goal is the last food that is marked with a dish class.

    ``recipe`` is what it was made for, if that is known.
    """
    units = [annotation.unit for annotation in subgraph.annotations]
    marked = [p.node for unit in units for p in unit.outputs if p.dish_type and not tables().utensil(p.node.label)]
    return TaskTree(subgraph.name, tuple(map(Step.of_unit, units)), marked[-1] if marked else None, recipe)


def _level(fields: Fields) -> Level:
    number = fields.whole_number("level")
    if number not in list(Level):
        raise ReadError(f"{fields.where}: a FOON has no level {number}", hint="The levels are 1, 2 and 3.")
    return Level(number)


def _unit(fields: Fields) -> Step:
    step = step_from_json(fields)
    return Step(
        tuple(dict.fromkeys(step.inputs)),
        step.motion,
        tuple(dict.fromkeys(step.outputs)),
        fields.optional_text("origin"),
        tuple(map(sighting_from_json, fields.nested_list("seen_in"))) if "seen_in" in fields else (),
        fields.optional_text("grounding"),
    )


def _substitution(fields: Fields) -> Substitution:
    """Read an entry; only what it does say must have the right type."""
    alternatives = None
    if "alternatives" in fields:
        entries = fields.nested_list("alternatives")
        alternatives = tuple(
            Alternative.claimed(a.optional_text("name") or "", a.optional_number("confidence")) for a in entries
        )
    return Substitution.claimed(
        fields.optional_text("kind") or "",
        fields.optional_text("object") or "",
        fields.optional_text("required") or "",
        fields.optional_text("equivalent"),
        confidence=fields.optional_number("confidence"),
        alternatives=alternatives,
    )
