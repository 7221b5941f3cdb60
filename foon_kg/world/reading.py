"""What an object node says, read once: whether it is food, what it holds, where it stands, what state it claims."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from functools import lru_cache

from foon_kg.food import Tables, Utensil, singular
from foon_kg.food.rows import State
from foon_kg.model import ObjectNode
from foon_kg.model.values import made_often

_NOT_IN = frozenset({"with", "contains", "covered", "covering", "coated"})
"""Relations whose ``[]`` is not where a thing is, but what is on it."""

MOST_READ = 1 << 13
"""For how many nodes it is kept what they say."""

_PLACE = re.compile(r"(?:in|on|inside|from) \[([^\]]+)\]")


@made_often(eq=False)
class NodeReading:
    """What a node says. Names are in the singular: ``names`` are the foods that it holds, utensils apart.

    ``place`` is the label of the vessel or food it is in or on, ``covers`` that of what it lies over or is held to
    without being in it (a lid, a burner under its pan). ``fine`` is how small its pieces are, ``earns`` what its states
    say was done to it. ``empty``, ``on``, ``off``, ``hot``, ``covered`` and ``uncovered`` are claims about a utensil.
    ``undivided`` says that a food is one piece as it was bought or peeled, ``remains`` that it is what nobody eats.
    ``worked`` are those of its states that somebody has to give a food: no shop sells it so.
    """

    node: ObjectNode
    label: str
    utensil: Utensil | None
    names: frozenset[str]
    place: str | None
    place_utensil: Utensil | None
    covers: str | None
    empty: bool
    on: bool
    off: bool
    hot: bool
    covered: bool
    uncovered: bool
    undivided: bool
    remains: bool
    fine: int | None
    earns: frozenset[str]
    worked: tuple[str, ...]
    is_food: bool
    is_appliance: bool


class Reader:
    """Reads nodes with one set of tables; ``foods`` are names that are food here though they are utensils elsewhere."""

    def __init__(self, known: Tables, foods: frozenset[str] = frozenset()) -> None:
        self.tables = known
        self.foods = foods
        self._read: dict[ObjectNode, NodeReading] = {}

    def read(self, node: ObjectNode) -> NodeReading:
        """Return what ``node`` says."""
        said = self._read.get(node)
        if said is None:
            if len(self._read) >= MOST_READ:
                self._read.clear()
            said = self._read[node] = self._said(node)
        return said

    def utensil(self, label: str) -> Utensil | None:
        """Return the utensil called ``label``, in the singular; ``None`` for a food."""
        return None if label in self.foods else self.tables.utensil(label)

    def _said(self, node: ObjectNode) -> NodeReading:
        label = singular(node.label)
        utensil = self.utensil(label)
        names = frozenset(name for name in map(singular, node.ingredients) if self.utensil(name) is None)
        place, holder = self._place_of(node, utensil)
        states = [state.lower() for state in node.states]
        claims = self.tables.utensil_states
        rows = list(map(self.tables.state, node.states)) if utensil is None else []
        fine = [row.fine for row in rows if row.fine is not None]
        return NodeReading(
            node,
            label,
            utensil,
            names,
            place,
            None if place is None else self.utensil(place),
            holder,
            empty=not names and "empty" in " ".join(states),
            on=not claims["on"].isdisjoint(states),
            off=not claims["off"].isdisjoint(states),
            hot=not claims["hot"].isdisjoint(states),
            covered=_is_covered(node, states, claims["closed"]),
            uncovered=not claims["open"].isdisjoint(states),
            undivided=_is_undivided(rows),
            remains=self._remains(node, utensil, rows),
            fine=max(fine, default=None),
            earns=frozenset().union(*(row.earns for row in rows)) - {"remains"},
            worked=_worked(node, rows),
            is_food=utensil is None,
            is_appliance=_is_appliance(utensil),
        )

    def _place_of(self, node: ObjectNode, utensil: Utensil | None) -> tuple[str | None, str | None]:
        """Return where a node is, and what it is held to without being in it or on it; one of them at most."""
        held = node.container is not None and (node.relation in _NOT_IN or (utensil and node.relation == "under"))
        if held and node.container is not None:
            return _place_in_states(node), singular(node.container)
        place = _place_in_states(node) if node.container is None or node.relation == "from" else None
        return place or (None if node.container is None else singular(node.container)), None

    def _remains(self, node: ObjectNode, utensil: Utensil | None, rows: Sequence[State]) -> bool:
        """Whether a node is what is left of a food, by its states or by its name."""
        if any("remains" in row.earns for row in rows):
            return True
        return utensil is None and self.tables.foods.food(node.label, node.states).is_a("remains")


def _worked(node: ObjectNode, rows: Sequence[State]) -> tuple[str, ...]:
    """Return those states of a food, of which ``rows`` say what they mean, that somebody has to give it."""
    return tuple(state for state, row in zip(node.states, rows, strict=False) if row.takes_work)


def _is_appliance(utensil: Utensil | None) -> bool:
    return utensil is not None and utensil.role == "appliance"


def _is_covered(node: ObjectNode, states: Sequence[str], closed: Collection[str]) -> bool:
    """Whether a node says that its vessel is closed: by its relation or a state (*covered [foil]* names the lid)."""
    return node.relation == "covered" or any(state.partition(" [")[0] in closed for state in states)


def _is_undivided(rows: Sequence[State]) -> bool:
    """Whether states say that a food is in one piece, and none of them that it is in pieces."""
    return any(row.undivided for row in rows) and not any(row.fine for row in rows)


def _place_in_states(node: ObjectNode) -> str | None:
    """Return the place that a loader kept among the states, as it does of a node with two: ``on [cutting board]``."""
    for state in node.states:
        found = _PLACE.fullmatch(state.lower()) if state.endswith("]") else None
        if found:
            return singular(found.group(1))
    return None


@lru_cache(maxsize=8)
def reader(known: Tables, foods: frozenset[str] = frozenset()) -> Reader:
    """Return a reader of nodes by the tables ``known`` that many trees share: nodes come up again and again.

    ``foods`` are names that are foods though they are also tools.
    """
    return Reader(known, foods)
