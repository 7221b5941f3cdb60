"""Recipes of a collection drafted from their instructions: plain values that are kept apart from annotated videos.

Nobody has watched or reviewed a draft. It goes by a name of its own kind (``draft:`` and the recipe's id) wherever it
is evidence, so that no answer can pass it off as a video.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Self

from foon_kg.model import Subgraph, content_key
from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.nodes import one_spelling

DRAFT = "draft:"
"""Begins the name of every draft, and of no video."""

MOST_OF_A_DISH_TYPE = 100
"""So many drafts of each dish type are planned with, the surest: more take long to read and say little new."""


def is_draft(video: str) -> bool:
    """Whether a piece of evidence is a draft and no video.

    >>> is_draft("draft:toast"), is_draft("greek_salad")
    (True, False)
    """
    return video.startswith(DRAFT)


@dataclass(frozen=True)
class DraftedRecipe:
    """The draft of one recipe: ``table`` is what ``foon draft review`` reads, ``""`` where there is no unit.

    ``confidence`` (0 to 1) is how sure its units are in the mean. ``problem`` says why it could not be drafted.
    """

    id: str
    title: str
    dish_type: str
    table: str
    units: int = 0
    left_out: int = 0
    confidence: float = 0.0
    problem: str = ""

    def __post_init__(self) -> None:
        object.__setattr__(self, "id", one_spelling(self.id))

    @property
    def name(self) -> str:
        """The name by which it is evidence.

        >>> DraftedRecipe("toast", "Toast", "bread", "").name
        'draft:toast'
        """
        return DRAFT + self.id

    @cached_property
    def content(self) -> str:
        """Return a hash of everything in it: an equal one means that loading it again would change nothing.

        >>> one, other = (DraftedRecipe("toast", title, "bread", "") for title in ("Toast", "Fine toast"))
        >>> one.content == other.content
        False
        """
        return content_key(self.to_json())

    def to_json(self) -> JsonObject:
        """Return one line of the file that ``foon draft recipes`` writes.

        >>> DraftedRecipe("toast", "Toast", "bread", "", problem="it has no instructions").to_json()["problem"]
        'it has no instructions'
        """
        told: JsonObject = {
            "id": self.id,
            "title": self.title,
            "dish_type": self.dish_type,
            "units": self.units,
            "left_out": self.left_out,
            "confidence": self.confidence,
            "table": self.table,
        }
        return told | ({"problem": self.problem} if self.problem else {})

    @classmethod
    def from_json(cls, value: object, where: str) -> Self:
        """Return the recipe of a ``value`` that :meth:`to_json` wrote.

        Raises ReadError naming ``where`` for any other.

        >>> toast = DraftedRecipe("toast", "Toast", "bread", "")
        >>> DraftedRecipe.from_json(toast.to_json(), "drafts.jsonl:1") == toast
        True
        """
        fields = Fields(value, where)
        return cls(
            fields.text("id"),
            fields.text("title"),
            fields.text("dish_type"),
            fields.text("table"),
            fields.whole_number("units"),
            fields.whole_number("left_out"),
            fields.number("confidence"),
            fields.text("problem") if "problem" in fields else "",
        )


@dataclass(frozen=True)
class Lesson:
    """What one draft teaches: its units as a subgraph that bears the draft's name, and how sure they are."""

    subgraph: Subgraph
    dish_type: str
    confidence: float
    title: str = ""


def surest(lessons: Iterable[Lesson], most: int = MOST_OF_A_DISH_TYPE) -> tuple[Lesson, ...]:
    """Return at most ``most`` lessons of each dish type, the surest, ties by name; all of them sorted by name.

    >>> lessons = [Lesson(Subgraph(f"draft:{sure}", ()), "bread", sure) for sure in (0.4, 0.9, 0.6)]
    >>> [one.confidence for one in surest(lessons, most=2)]
    [0.6, 0.9]
    """
    by_type: dict[str, list[Lesson]] = {}
    for lesson in sorted(lessons, key=lambda one: (-one.confidence, one.subgraph.name)):
        kept = by_type.setdefault(lesson.dish_type, [])
        if len(kept) < most:
            kept.append(lesson)
    return tuple(sorted((one for kept in by_type.values() for one in kept), key=lambda one: one.subgraph.name))
