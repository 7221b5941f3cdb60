"""The quick questions about a FOON that is too large for memory, each asked of its graph."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from foon_kg.foon import Foon
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.node_json import node_to_json
from foon_kg.plans.kitchen import Kitchen
from foon_kg.web.words import MOST_UNITS, Kind, Size, Words, no_object, units_to_json

if TYPE_CHECKING:
    from foon_kg.store.graph.rows import NamesLikeRow

MOST_NAMES = 200
"""So many foods, objects and goals that a text may become are looked at."""


class GraphWords(Words):
    """The words of a FOON in a graph. Of what is around an object at most ``MOST_UNITS`` of each are told.

    Words that begin as it was typed are found, and of foods words inside their names; of other objects than foods and
    utensils only those whose own name begins so.
    """

    def __init__(self, foon: Foon) -> None:
        self.foon = foon
        self.lessons = ()
        size = foon.size()
        with foon.reading() as view:
            words = view.words_for(())
        self.size = Size(size.units, size.videos, size.foods)
        self.dish_types = tuple(sorted(size.dish_types))
        self.states = sorted(filter(None, words.other_states))

    def named(self, kind: Kind, text: str) -> Iterable[str]:
        """Return some of the foods, objects or goals (``kind``) that ``text`` may become."""
        found = self._like(text)
        if kind == "food":
            return [name for name, _ in found.foods]
        return found.goals if kind == "goal" else [*found.objects, *(name for name, _ in found.foods)]

    def seen_in(self, state: str, text: str) -> Iterable[str]:
        """Return some of the foods seen in ``state`` that ``text`` may become."""
        return [name for name, seen in self._like(text, state).foods if seen]

    def around(self, label: str) -> JsonObject:
        """Return what is around the object ``label``.

        Raises UnknownError with names that may be meant if there is none.
        """
        there = self.foon.around(label, MOST_UNITS)
        if there is None:
            raise no_object(label, self.named("object", label[: len(label) // 2 + 1].lower()))
        return {
            "label": label,
            "utensil": Kitchen.default().is_utensil(label),
            "nodes": list(map(node_to_json, there.nodes)),
            "made_by": units_to_json(there.made, there.made_count),
            "taken_by": units_to_json(there.taken, there.taken_count),
            "videos": list(there.videos),
        }

    def _like(self, text: str, state: str = "") -> NamesLikeRow:
        return self.foon.names_like(text, MOST_NAMES, state=state)
