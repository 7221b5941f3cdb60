"""What single units add to the operators of a FOON: rows that the graph adds up, and can take away again.

Everything that operators are done to is a *matter*, called as
:class:`~foon_kg.integration.teaching.operators.Operators` calls it: a food by its name, a kind of food as ``kind:…``, a
form as ``form:…``, an appliance that takes part as ``appliance:…``. Whatever an operator is done to, it is done to
``ANYTHING``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, TypeVar

from foon_kg.food import tables
from foon_kg.integration.teaching.operators import Evidence, Operators, Way
from foon_kg.model import FunctionalUnit, KnownUnit, Sighting, content_key
from foon_kg.store.snapshot import in_plain_order

ANYTHING = "any:thing"
KIND, FORM, APPLIANCE = "kind:", "form:", "appliance:"

_SOMEWHERE = (Sighting("", 0),)


@dataclass(frozen=True)
class Lifted:
    """What one unit says about its operator ``way``: what it is done to, which of that it changes, and how."""

    way: Way
    done_to: frozenset[str]
    changes: frozenset[str]
    gives: Mapping[str, int]
    brings: Mapping[tuple[str, str], int]
    places: Mapping[str, int]
    states: frozenset[tuple[str, str]]

    @property
    def operator(self) -> str:
        """The key of the operator."""
        return operator_key(self.way)


@lru_cache(maxsize=1 << 12)
def operator_key(way: Way) -> str:
    """Return the content hash under which the graph keeps the operator of a ``way``."""
    return content_key(way[0], way[1])


def lifted(unit: FunctionalUnit) -> Lifted:
    """Return what ``unit`` says, whoever wrote it first."""
    alone = Operators((in_plain_order(KnownUnit(unit, _SOMEWHERE)),), tables())
    ((way, seen),) = alone.evidence.items()
    acts = alone.acts.get(way)
    return Lifted(
        way,
        _matters(seen) | {ANYTHING},
        _matters(acts) | {ANYTHING} if acts is not None else frozenset(),
        {state: ways[way] for state, ways in alone.giving.items()},
        {place: ways[way] for place, ways in alone.bringing.items() if ways},
        dict(alone.onto[way]),
        frozenset((name, state) for name, states in alone.states.items() for state in states),
    )


def _matters(evidence: Evidence) -> frozenset[str]:
    kinds = (f"{KIND}{kind}" for kind in evidence.kinds)
    return frozenset((*evidence.foods, *kinds, *(f"{APPLIANCE}{name}" for name in evidence.appliances)))


Names = TypeVar("Names", tuple[str, str], tuple[str, str, str])


@dataclass
class Tally:
    """Counts over units; those of units that went are below zero."""

    done: Counter[tuple[str, str]] = field(default_factory=Counter)
    changed: Counter[tuple[str, str]] = field(default_factory=Counter)
    gives: Counter[tuple[str, str]] = field(default_factory=Counter)
    brings: Counter[tuple[str, str, str]] = field(default_factory=Counter)
    places: Counter[tuple[str, str]] = field(default_factory=Counter)
    states: Counter[tuple[str, str]] = field(default_factory=Counter)

    def count(self, units: Iterable[Lifted], weight: int = 1) -> None:
        """Add what ``units`` say, each ``weight`` times."""
        for unit in units:
            key = unit.operator
            _add(self.done, ((key, matter) for matter in unit.done_to), weight)
            _add(self.changed, ((key, matter) for matter in unit.changes), weight)
            _add(self.states, unit.states, weight)
            for state, number in unit.gives.items():
                self.gives[key, state] += weight * number
            for (matter, role), number in unit.brings.items():
                self.brings[key, matter, role] += weight * number
            for place, number in unit.places.items():
                self.places[key, place] += weight * number

    def rows(self) -> dict[str, list[dict[str, Any]]]:
        """Return the parameters of ``cypher/count_operators.cypher``; what is done to what apart."""
        return {
            "operators": [
                {"operator": operator, "count": count}
                for (operator, matter), count in sorted(self.done.items())
                if matter == ANYTHING and count
            ],
            "gives": _rows(self.gives, "operator", "state"),
            "brings": _rows(self.brings, "operator", "matter", "role"),
            "places": _rows(self.places, "operator", "utensil"),
            "states": _rows(self.states, "matter", "state"),
        }

    def matters(self) -> set[str]:
        """Return every matter that is counted."""
        found = {matter for _, matter in self.done} | {matter for matter, _ in self.states}
        return found | {matter for _, matter, _ in self.brings}


def _add(counter: Counter[tuple[str, str]], keys: Iterable[tuple[str, str]], weight: int) -> None:
    for key in keys:
        counter[key] += weight


def _rows(counter: Mapping[Names, int], *names: str) -> list[dict[str, Any]]:
    """Return a row for each key that has a count, in their order."""
    return [{**dict(zip(names, key, strict=True)), "count": counter[key]} for key in sorted(counter) if counter[key]]


def is_food(matter: str) -> bool:
    """Say whether a matter is a food, and not a kind or form of food, an appliance or anything at all."""
    return not matter.startswith((KIND, FORM, APPLIANCE)) and matter != ANYTHING


def matter_rows(matters: Iterable[str]) -> dict[str, list[Any]]:
    """Return the parameters of ``cypher/load_matters.cypher``."""
    names = sorted(set(matters))
    foods = list(filter(is_food, names))
    return {
        "foods": [{"name": name, "kind": tables().foods.find(name)[0]} for name in foods],
        "kinds": [name for name in names if name.startswith(KIND)],
        "forms": [name for name in names if name.startswith(FORM)],
        "appliances": [name for name in names if name.startswith(APPLIANCE)],
        "anything": [name for name in names if name == ANYTHING],
    }
