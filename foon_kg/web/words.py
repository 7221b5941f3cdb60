"""The quick questions, answered by any thread: completion, likeness, a look around an object."""

from __future__ import annotations

import difflib
from abc import ABC, abstractmethod
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from foon_kg.food.lists import word_list
from foon_kg.foon import Foon, Snapshot
from foon_kg.formats.video_address import is_web_address, video_address
from foon_kg.model import KnownUnit, Sighting
from foon_kg.model.drafted import Lesson
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.names import canonical
from foon_kg.model.node_json import node_to_json, sighting_to_json
from foon_kg.plans.kitchen import Kitchen
from foon_kg.web.questions import UnknownError

Kind = Literal["ingredient", "food", "avoidable", "object", "thing", "state", "dish", "goal"]

MOST_UNITS = 40
"""How many of the units that make an object, and of those that take it, are told; the rest is counted."""


@dataclass(frozen=True)
class Size:
    """How many units, videos and foods a FOON has."""

    units: int
    videos: int
    foods: int


class Words(ABC):
    """The words of one FOON, wherever it is, and what is around each of them."""

    foon: Foon
    size: Size
    dish_types: Sequence[str]
    states: Sequence[str]
    lessons: Sequence[Lesson]
    """What drafts teach that plans can be made with."""

    @abstractmethod
    def named(self, kind: Kind, text: str) -> Iterable[str]:
        """Return names of foods, objects or goals (``kind``), among them all, or many, that ``text`` may become."""

    @abstractmethod
    def seen_in(self, state: str, text: str) -> Iterable[str]:
        """Return foods that are seen in ``state``, among them all, or many, that ``text`` may become."""

    @abstractmethod
    def around(self, label: str) -> JsonObject:
        """Return the nodes of the object ``label``, its states, the units that make and take it, and its videos.

        Raises UnknownError with the nearest names where the FOON does not have it.
        """

    def summary(self) -> JsonObject:
        """Return how large the FOON is, and its dish types."""
        return {
            "dish_types": list(self.dish_types),
            "units": self.size.units,
            "videos": self.size.videos,
            "foods": self.size.foods,
            "drafts": len(self.lessons),
            "drafted_types": sorted({one.dish_type for one in self.lessons}.difference(self.dish_types)),
        }

    def complete(self, kind: Kind, text: str, limit: int) -> list[str]:
        """Return the at most ``limit`` words of a ``kind`` that ``text`` may become, those that begin so first.

        An ingredient is a state and a food: where ``text`` begins with a state, the foods that are seen in it come
        first. A thing may be at hand: an object or an ingredient. Avoidable are foods and kinds of food. A goal is a
        dish that some video makes.
        """
        if kind == "ingredient":
            return self._ingredients(text, limit)
        said = text.strip().lower()
        found = _matching(dict.fromkeys(self._names(kind, said)), said)
        if kind == "thing":
            found = list(dict.fromkeys((*found, *self._ingredients(text, limit))))
        return found[:limit]

    def similar(self, names: Sequence[str], limit: int, role: str | None = None) -> list[JsonObject]:
        """Return for each of ``names`` at most ``limit`` known foods that can best stand for it, and why.

        With ``role`` ("liquid", "protein"), those that a cook takes for it where it is there for that; UsageError for a
        role that nobody knows.
        """
        foon = self.foon
        found = foon.similar_to_each(names, limit, role=role)
        return [
            {
                "name": name,
                "nearest": [
                    {"name": n.name, "confidence": n.confidence, "why": list(foon.why_similar(name, n.name))}
                    for n in neighbours
                ],
            }
            for name, neighbours in zip(names, found, strict=True)
        ]

    def _names(self, kind: Kind, said: str) -> Iterable[str]:
        if kind == "state":
            return self.states
        if kind == "dish":
            return self.dish_types
        if kind == "avoidable":
            return (*Foon.kinds_of_food(), *self.named("food", said))
        return self.named("object" if kind == "thing" else kind, said)

    def _ingredients(self, text: str, limit: int) -> list[str]:
        said = " ".join(text.lower().split())
        begun = f"{said} " if text[-1:].isspace() else said  # “chopped” may go on; behind “chopped ” comes a food
        state = max((s for s in self.states if begun.startswith(f"{s.lower()} ")), key=len, default="")
        if not state:
            return _matching([*self.named("food", said), *self.states], said)[:limit]
        rest = said[len(state) + 1 :]
        seen = sorted(self.seen_in(state, rest))
        foods = dict.fromkeys((*_matching(seen, rest), *_matching(self.named("food", rest), rest)))
        return [f"{state} {food}" for food in foods][:limit]


class FoonWords(Words):
    """The words of a FOON in memory."""

    def __init__(self, snapshot: Snapshot, lessons: Sequence[Lesson] = ()) -> None:
        self.foon = Foon(snapshot)
        self.snapshot = snapshot
        self.lessons = lessons
        vocabulary = snapshot.vocabulary()
        self.dish_types = vocabulary.dish_types
        self.foods = vocabulary.labels
        self.states = sorted({row.state for row in vocabulary.foods if row.state})
        self.size = Size(len(snapshot.units), len(snapshot.subgraphs), len(self.foods))

    def named(self, kind: Kind, text: str) -> Iterable[str]:
        """Return all foods, objects or goals (``kind``), whatever ``text``."""
        del text
        return {"food": self.foods, "object": self._objects, "goal": self._goals}[kind]

    def seen_in(self, state: str, text: str) -> Iterable[str]:
        """Return the foods that are seen in ``state``, whatever ``text``."""
        del text
        return (row.label for row in self.snapshot.vocabulary().foods if row.state == state)

    def around(self, label: str) -> JsonObject:
        """Return what is around the object ``label``.

        Raises UnknownError with the nearest names where there is none.
        """
        called = self._units_by_label.get(label)
        if called is None:
            raise no_object(label, self._objects)
        made = [known for known in called if any(node.label == label for node in known.unit.output_nodes)]
        taken = [known for known in called if any(node.label == label for node in known.unit.input_nodes)]
        return {
            "label": label,
            "utensil": Kitchen.default().is_utensil(label),
            "nodes": list(map(node_to_json, self.snapshot.called([label]))),
            "made_by": units_to_json(made, len(made)),
            "taken_by": units_to_json(taken, len(taken)),
            "videos": sorted({seen.video for known in called for seen in known.seen_in}),
        }

    @cached_property
    def _goals(self) -> list[str]:
        return sorted({goal.node.label for goal in self.snapshot.goals()})

    @cached_property
    def _objects(self) -> list[str]:
        return sorted(self._units_by_label)

    @cached_property
    def _units_by_label(self) -> dict[str, list[KnownUnit]]:
        units: dict[str, list[KnownUnit]] = {}
        for known in sorted(self.snapshot.units, key=lambda one: (one.seen_in, one.unit.key)):
            nodes = (*known.unit.input_nodes, *known.unit.output_nodes)
            for label in dict.fromkeys(node.label for node in nodes):
                units.setdefault(label, []).append(known)
        return units


def no_object(label: str, known: Iterable[str]) -> UnknownError:
    """Return what is told to who asks for a ``label`` that is not there; ``known`` are names that may be meant."""
    near = difflib.get_close_matches(label, list(known), n=3)
    meant = f"Did you mean {' or '.join(near)}?" if near else "The page and /api/complete complete names."
    return UnknownError(f"this FOON has no object “{label}”", hint=meant)


def place_to_see(sightings: Sequence[Sighting], videos: Collection[str] = ()) -> Sighting | None:
    """Return of all ``sightings`` of a unit the one to look at, or ``None`` where there is none.

    It is in one of ``videos``, where one of them shows it; of those the first that has a time.
    """
    own = [one for one in sightings if one.video in videos] or sightings
    return next((one for one in own if one.start is not None), own[0] if own else None)


def seen_at(sightings: Sequence[Sighting]) -> str | None:
    """Return the web address of the second in which a unit is seen, of one of ``sightings``, or ``None``."""
    seen = place_to_see(sightings)
    if seen is None or seen.source is None or not is_web_address(seen.source):
        return None
    return video_address(seen.source, seen.start)


def _matching(names: Iterable[str], text: str) -> list[str]:
    """Return the names with a word that begins with ``text``, those that begin so themselves first, none misspelled."""
    folded = canonical(text) if text else ""
    misspelled = word_list("is a typing error")
    right = (name for name in names if name not in misspelled and misspelled.isdisjoint(name.split()))
    found = [name for name in right if _fits(name.lower(), text) or (folded and _fits(canonical(name), folded))]
    return sorted(found, key=lambda name: (not name.lower().startswith(text), len(name.split()), name))


def _fits(name: str, text: str) -> bool:
    return name.startswith(text) or f" {text}" in name


def units_to_json(units: Sequence[KnownUnit], count: int) -> JsonObject:
    """Return the first of ``units``, of which there are ``count``."""
    told = units[:MOST_UNITS]
    return {
        "count": count,
        "units": list(map(_unit_to_json, told)),
        "videos": [seen_at(known.seen_in) for known in told],
    }


def _unit_to_json(known: KnownUnit) -> JsonObject:
    return {
        "input_nodes": list(map(node_to_json, known.unit.input_nodes)),
        "motion_node": known.unit.motion,
        "output_nodes": list(map(node_to_json, known.unit.output_nodes)),
        "seen_in": list(map(sighting_to_json, known.seen_in)),
    }
