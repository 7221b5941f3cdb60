"""Progress lines: the life of each ingredient through a task tree."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Self

from foon_kg.json_fields import Fields, JsonObject


@dataclass(frozen=True)
class ProgressStep:
    """One stage in the life of an ingredient: how and where it is, and the motion that ends this stage.

    ``object`` is what the ingredient is or has become part of (an onion, then a mixture); JSON has no field for it.
    """

    states: tuple[str, ...]
    relation: str | None
    container: str | None
    motion: str
    object: str = field(default="", compare=False)


@dataclass(frozen=True)
class ProgressLine:
    """The life of one ingredient through the tree; the motion of the last step makes ``end_product``.

    ``end_product`` is the label of the goal, or ``None`` for an ingredient that does not end in it.
    """

    ingredient: str
    steps: tuple[ProgressStep, ...]
    end_product: str | None

    def to_json(self) -> JsonObject:
        """Answer one of the ``progress_lines`` of a plan result."""
        steps = [
            {"states": list(step.states), "relation": step.relation, "container": step.container, "motion": step.motion}
            for step in self.steps
        ]
        return {"ingredient": self.ingredient, "steps": steps, "end_product": self.end_product}

    @classmethod
    def from_json(cls, fields: Fields) -> Self:
        """Read back what :meth:`to_json` wrote."""
        steps = tuple(
            ProgressStep(s.texts("states"), s.optional_text("relation"), s.optional_text("container"), s.text("motion"))
            for s in fields.nested_list("steps")
        )
        return cls(fields.text("ingredient"), steps, fields.optional_text("end_product"))
