"""The answer to a recipe: the task tree, how it differs from what FOON knows, and what was assumed.

Every type here is a plain frozen value with ``to_json`` and ``from_json``; :meth:`PlanResult.to_json` is what
``foon plan --json`` prints. Its steps are those of every task tree (:mod:`foon_kg.model.tree`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from foon_kg.model import Annotation, FunctionalUnit, ObjectNode, Recipe, Subgraph
from foon_kg.model.claims import Assumption, Substitution
from foon_kg.model.errors import FoonError
from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.node_json import node_from_json, node_to_json, recipe_from_json, recipe_to_json
from foon_kg.model.tree import Step, TaskTree, things_found
from foon_kg.model.tree_json import unit_from_json, unit_to_json
from foon_kg.plans.progress import ProgressLine
from foon_kg.plans.shortage import ShortageError, remedy


@dataclass(frozen=True)
class ReferenceSummary:
    """The reference tree in figures: its goal, how many ``units``, and how many required foods it covers.

    ``exact`` says that the search proved that no other tree of the goal covers more, or as much in fewer units.
    ``videos`` are those after which the final tree is made, ``core`` the foods of theirs that the recipe has too.
    Where it is made after a draft, which nobody has watched or reviewed, ``draft_confidence`` says how sure that is.
    ``technique`` names what of foon-kg's own tables gave the order of the steps: then no video shows them in it.
    """

    goal: ObjectNode
    units: int
    overlap: int
    exact: bool
    videos: tuple[str, ...] = ()
    core: tuple[str, ...] = ()
    draft_confidence: float | None = None
    technique: str = ""

    def to_json(self) -> JsonObject:
        """Return the ``reference`` field of a plan result."""
        told: JsonObject = {
            "goal": node_to_json(self.goal),
            "units": self.units,
            "overlap": self.overlap,
            "exact": self.exact,
            "videos": list(self.videos),
            "core": list(self.core),
        }
        if self.draft_confidence is not None:
            told = told | {"draft_confidence": self.draft_confidence}
        return (told | {"technique": self.technique}) if self.technique else told

    @classmethod
    def from_json(cls, fields: Fields) -> Self:
        """Return the summary of the ``fields`` that :meth:`to_json` wrote."""
        goal = node_from_json(fields.nested("goal"))
        return cls(
            goal,
            fields.whole_number("units"),
            fields.whole_number("overlap"),
            fields.truth("exact"),
            fields.texts("videos") if "videos" in fields else (),
            fields.texts("core") if "core" in fields else (),
            fields.number("draft_confidence") if "draft_confidence" in fields else None,
            fields.text("technique") if "technique" in fields else "",
        )


@dataclass(frozen=True)
class GoalPassedOver:
    """A goal that is nearer to the recipe by its ingredients (``similarity``, 0 to 1), and why it was not taken."""

    goal: ObjectNode
    similarity: float
    why: str

    def to_json(self) -> JsonObject:
        """Return one of the ``passed_over`` of a plan result."""
        return {"goal": node_to_json(self.goal), "similarity": self.similarity, "why": self.why}

    @classmethod
    def from_json(cls, fields: Fields) -> Self:
        """Return the goal of the ``fields`` that :meth:`to_json` wrote."""
        return cls(node_from_json(fields.nested("goal")), fields.number("similarity"), fields.text("why"))


@dataclass(frozen=True)
class PlanResult:
    """A task tree for ``recipe``: ``units`` in the order of execution, from ``kitchen`` to ``goal``."""

    recipe: Recipe
    reference: ReferenceSummary
    goal: ObjectNode
    units: tuple[Step, ...]
    kitchen: tuple[ObjectNode, ...]
    substitutions: tuple[Substitution, ...] = ()
    assumptions: tuple[Assumption, ...] = ()
    progress_lines: tuple[ProgressLine, ...] = ()
    passed_over: tuple[GoalPassedOver, ...] = ()

    def to_json(self) -> JsonObject:
        """Return the result as ``foon plan --json`` prints it."""
        found = things_found(self.units)
        return {
            "recipe": recipe_to_json(self.recipe),
            "reference": self.reference.to_json(),
            "goal": node_to_json(self.goal),
            "units": [unit_to_json(unit) for unit in self.units],
            "kitchen": [
                node_to_json(node) | ({"things": list(found[node])} if node in found else {}) for node in self.kitchen
            ],
            "substitutions": [substitution.to_json() for substitution in self.substitutions],
            "assumptions": [assumption.to_json() for assumption in self.assumptions],
            "progress_lines": [line.to_json() for line in self.progress_lines],
            "passed_over": [passed.to_json() for passed in self.passed_over],
        }

    @classmethod
    def from_json(cls, value: object, where: str = "plan") -> Self:
        """Return the plan of a ``value`` that :meth:`to_json` wrote; raises ReadError for any other.

        ``where`` names the document in messages.
        """
        fields = Fields(value, where)
        return cls(
            recipe_from_json(fields.nested("recipe")),
            ReferenceSummary.from_json(fields.nested("reference")),
            node_from_json(fields.nested("goal")),
            tuple(map(unit_from_json, fields.nested_list("units"))),
            tuple(map(node_from_json, fields.nested_list("kitchen"))),
            tuple(map(Substitution.from_json, fields.nested_list("substitutions"))),
            tuple(map(Assumption.from_json, fields.nested_list("assumptions"))),
            tuple(map(ProgressLine.from_json, fields.nested_list("progress_lines"))),
            tuple(map(GoalPassedOver.from_json, fields.nested_list("passed_over"))) if "passed_over" in fields else (),
        )

    @property
    def tree(self) -> TaskTree:
        """The plan as a task tree, as the judge takes it."""
        name = self.recipe.id or self.recipe.title or "plan"
        return TaskTree(name, self.units, self.goal, self.recipe, self.kitchen, self.substitutions, self.assumptions)

    def to_subgraph(self) -> Subgraph:
        """Return the tree as a subgraph, for FOON text: its goal marked, the videos of its units as sources."""
        marked = zip(self._units_with_goal(), self.units, strict=True)
        measured = tuple(Annotation(unit, measures=told.measures, seen_in=told.sightings) for unit, told in marked)
        name = self.recipe.id or self.recipe.title or self.recipe.dish_type
        return Subgraph(name, measured, self._sources())

    def _units_with_goal(self) -> list[FunctionalUnit]:
        """Return the functional units, the goal marked where it is put out last."""
        units = [unit.as_unit() for unit in self.units]
        for place in reversed(range(len(units))):  # not always the last unit: a stove may be turned off after it
            if self.goal in self.units[place].output_nodes:
                units[place] = self.units[place].as_unit(self.goal, self.recipe.dish_type)
                break
        return units

    def _sources(self) -> tuple[str, ...]:
        """Return each source of the videos in which the units were seen, once."""
        sources = (sighting.source for unit in self.units for sighting in unit.sightings)
        return tuple(dict.fromkeys(source for source in sources if source))


def error_to_json(error: FoonError) -> JsonObject:
    """Return what stands in the place of an answer that ended in ``error``.

    It has its ``code``, ``message`` and ``hint``, and what is ``missing``.
    """
    said: JsonObject = {"code": error.code, "message": error.message, "hint": error.hint}
    if isinstance(error, ShortageError) and error.missing:
        said["missing"] = [{"node": node_to_json(node), "remedy": remedy(node)} for node in error.missing]
    return said


@dataclass(frozen=True)
class PlanFailure:
    """There is no tree for ``recipe``: what :class:`~foon_kg.model.errors.FoonError` said, in the place of a result.

    ``missing`` are the leaves that are not at hand, nearest to the goal first, where that is why.
    """

    recipe: Recipe
    code: str
    message: str
    hint: str = ""
    missing: tuple[ObjectNode, ...] = ()

    @classmethod
    def of(cls, recipe: Recipe, error: FoonError) -> Self:
        """Keep what ``error`` says about ``recipe``."""
        missing = error.missing if isinstance(error, ShortageError) else ()
        return cls(recipe, error.code, error.message, error.hint, missing)

    def to_json(self) -> JsonObject:
        """Return the line that stands in the place of a result: no ``units``, an ``error``."""
        error = ShortageError(self.message, missing=self.missing, hint=self.hint, code=self.code)
        return {"recipe": recipe_to_json(self.recipe), "error": error_to_json(error)}

    @classmethod
    def from_json(cls, value: object, where: str = "plan") -> Self:
        """Return the failure of a ``value`` that :meth:`to_json` wrote; raises ReadError for any other.

        ``where`` names the document in messages.
        """
        fields = Fields(value, where)
        error = fields.nested("error")
        recipe = recipe_from_json(fields.nested("recipe"))
        missing = error.nested_list("missing") if "missing" in error else []
        return cls(
            recipe,
            error.text("code"),
            error.text("message"),
            error.optional_text("hint") or "",
            tuple(node_from_json(entry.nested("node")) for entry in missing),
        )
