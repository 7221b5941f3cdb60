"""What is asked of a classic retrieval, and which object nodes answer to it."""

from __future__ import annotations

import difflib
from collections.abc import Collection
from dataclasses import dataclass
from enum import StrEnum
from typing import Protocol, Self

from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.model.errors import NoTreeError, ReadError, UsageError
from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.knowledge import Vocabulary
from foon_kg.model.levels import Level

_SHOWN = 5


class Criterion(StrEnum):
    """Which tree is the best: that with the fewest units, or that with the greatest product of success rates."""

    UNITS = "units"
    SUCCESS = "success"


class RetrievalView(Protocol):
    """What a classic retrieval asks of a FOON (part of it as a ``KnowledgeView`` has it)."""

    def vocabulary(self) -> Vocabulary:
        """Return the words that the FOON knows."""
        ...

    def called(self, labels: Collection[str]) -> tuple[ObjectNode, ...]:
        """Return every object node with one of ``labels``, sorted."""
        ...

    def behind(
        self, nodes: Collection[ObjectNode], foods: Collection[tuple[str, str]] = (), *, most: int | None = None
    ) -> tuple[KnownUnit, ...]:
        """Return every unit that may take part in making ``nodes`` or ``foods``.

        Where it has to fetch them and they are more than ``most``, raises TooManyUnitsError.
        """
        ...


@dataclass(frozen=True)
class GoalSought:
    """A goal by its label and by what is said of it: it has at least these ``states`` and ``ingredients``.

    ``container`` is where it is, ``None`` for anywhere. Names count as they are written in the FOON. What ``level``
    does not look at cannot be asked there: raises :class:`~foon_kg.model.errors.UsageError`.
    """

    label: str
    states: tuple[str, ...] = ()
    ingredients: tuple[str, ...] = ()
    container: str | None = None
    level: Level = Level.INGREDIENTS
    by: Criterion = Criterion.UNITS

    def __post_init__(self) -> None:
        if not self.label:
            raise UsageError("the goal has no name", hint="Name what is to be made: foon retrieve omelette.")
        told = {"states": self.states, "place": self.container} if self.level is Level.OBJECTS else {}
        told |= {"ingredients": self.ingredients} if self.level is not Level.INGREDIENTS else {}
        if unseen := [what for what, value in told.items() if value]:
            raise UsageError(
                f"at level {int(self.level)} a FOON has no {' and no '.join(unseen)}",
                hint="Ask at level 3, or leave that out: level 1 knows labels, level 2 states and places as well.",
            )

    def fits(self, node: ObjectNode) -> bool:
        """Whether ``node`` is a goal as it was asked for."""
        return (
            node.label == self.label
            and set(self.states) <= set(node.states)
            and set(self.ingredients) <= set(node.ingredients)
            and self.container in {None, node.container}
        )

    def candidates(self, view: RetrievalView) -> tuple[ObjectNode, ...]:
        """Return the object nodes of the FOON of ``view`` that fit, sorted; raises NoTreeError where there is none."""
        called = view.called([self.label])
        found = tuple(node for node in called if self.fits(node))
        if found:
            return found
        if called:
            some = "; ".join(map(str, called[:_SHOWN])) + (
                f" and {len(called) - _SHOWN} more" if called[_SHOWN:] else ""
            )
            raise NoTreeError(f"no {self} in this FOON", hint=f"There is {some}.", code="no-goal")
        raise NoTreeError(f"this FOON has no “{self.label}”", hint=_near(self.label, view), code="no-goal")

    def __str__(self) -> str:
        return str(ObjectNode(self.label, self.states, self.ingredients, None, self.container))

    @classmethod
    def from_json(cls, fields: Fields) -> Self:
        """Return what was asked from the ``fields`` that :meth:`to_json` wrote; raises ReadError for another level."""
        level, by = fields.whole_number("level"), fields.one_of("by", tuple(map(str, Criterion)))
        if level not in list(Level):
            raise ReadError(f"{fields.where}: a FOON has no level {level}", hint="The levels are 1, 2 and 3.")
        return cls(
            fields.text("label"),
            tuple(fields.texts("states")),
            tuple(fields.texts("ingredients")),
            fields.optional_text("container"),
            Level(level),
            Criterion(by),
        )

    def to_json(self) -> JsonObject:
        """Return the ``asked`` field of a result."""
        return {
            "label": self.label,
            "states": list(self.states),
            "ingredients": list(self.ingredients),
            "container": self.container,
            "level": int(self.level),
            "by": str(self.by),
        }


def _near(label: str, view: RetrievalView) -> str:
    alike = difflib.get_close_matches(label, view.vocabulary().labels, n=3)
    return f"Did you mean {' or '.join(alike)}?" if alike else "foon stats counts what there is."
