"""Where and how every object is while a narration goes on: what was peeled is what is chopped next."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.language.drafting.hands import Hands
from foon_kg.model import ObjectNode
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen

MIXTURE = "mixture"
EMPTY = "empty"
EVERYTHING = word_list("speaks of everything")
_ROOM = word_list("belongs to the room")
PRONOUNS = frozenset({"it", "them", "this", "these", "that", "those"})


@dataclass
class Scene:
    """The objects of one narration as they are now; labels are those of the FOON, or as narrated.

    ``focus`` is the vessel that something was last brought to or done in, ``last`` the foods of the last action.
    ``sure`` says how sure the states of a food are; ``mixed`` has the labels of what several foods became one of: the
    others have themselves in them, and what is on them; ``coming`` has, by canonical name, the first motion that will
    open or heat a food that is only moved before.
    """

    kitchen: Kitchen
    foods: dict[str, ObjectNode] = field(default_factory=dict)
    utensils: dict[str, ObjectNode] = field(default_factory=dict)
    focus: str | None = None
    last: tuple[str, ...] = ()
    sure: dict[str, float] = field(default_factory=dict)
    mixed: set[str] = field(default_factory=set)
    coming: dict[str, str] = field(default_factory=dict)
    hands: Hands = field(default_factory=Hands)

    def called(self, name: str) -> str | None:
        """Return the food or utensil of the scene that ``name`` speaks of, ``None`` where it is none of them.

        The same name, else the only one that ends in it ("onion" for the red onion).
        """
        for things in (self.foods, self.utensils):
            wanted = canonical(name)
            if same := next((label for label in things if canonical(label) == wanted), None):
                return same
            alike = [label for label in things if canonical(label).endswith(f" {wanted}")]
            if len(alike) == 1:
                return alike[0]
        return None

    def held(self, vessel: str) -> tuple[str, ...]:
        """Return what is in ``vessel``."""
        return self.utensils[vessel].ingredients if vessel in self.utensils else ()

    def at_hand(self) -> tuple[str, ...]:
        """Return what an action without an object is done to: all in the vessel of the last one, else its foods."""
        held = tuple(food for food in self.held(self.focus or "") if food in self.foods)
        last = tuple(food for food in self.last if food in self.foods)
        return held if set(last) <= set(held) else last

    def lying(self, besides: Collection[str] = ()) -> str | None:
        """Return the vessel with several foods in it that was touched last, none of them among ``besides``."""
        vessels = (label for label in reversed(self.utensils) if len(self.held(label)) > 1)
        return next((label for label in vessels if set(self.held(label)).isdisjoint(besides)), None)

    def made(self) -> tuple[str, ...]:
        """Return the foods that are made of several, in the order in which they were last touched."""
        return tuple(label for label, food in self.foods.items() if len(self.parts(food)) > 1)

    def parts(self, food: ObjectNode) -> tuple[str, ...]:
        """Return the foods that are in a food: itself, where it is no mixture, and what came onto it."""
        others = tuple(part for part in food.ingredients if part != food.label)
        return others if others and food.label in self.mixed else (food.label, *others)

    def another(self, vessel: str) -> str:
        """Return the name of an empty vessel like ``vessel``: another of its group, else the same with a number."""
        row = tables().utensil(vessel)
        alike = [one.name for one in tables().utensils.values() if row is not None and one.group == row.group]
        head = vessel.rsplit(maxsplit=1)[-1]
        named = [name for name in alike if name.split()[-1] == head and not self.held(name)]
        return named[0] if named else f"other {vessel}"

    def keep(self, nodes: Sequence[ObjectNode]) -> None:
        """Remember how these nodes are now."""
        for node in nodes:
            things = self.utensils if self.kitchen.is_utensil(node.label) else self.foods
            things.pop(node.label, None)  # what was touched last stands last
            things[node.label] = node

    def forget(self, foods: Sequence[str]) -> None:
        """Forget foods that went into a mixture."""
        for food in foods:
            self.foods.pop(food, None)


def filled(vessel: ObjectNode, foods: Sequence[str]) -> ObjectNode:
    """Return ``vessel`` with ``foods`` in it as well; a cupboard holds so much that nobody counts it."""
    if _is_fixture(vessel.label):
        return vessel
    states = tuple(state for state in vessel.states if state != EMPTY)
    held = dict.fromkeys((*vessel.ingredients, *foods))
    return replace(vessel, states=states, ingredients=tuple(held))


def emptied(vessel: ObjectNode, foods: Sequence[str]) -> ObjectNode:
    """Return ``vessel`` without ``foods``; it is empty when they were all."""
    if _is_fixture(vessel.label):
        return vessel
    left = tuple(food for food in vessel.ingredients if food not in foods)
    return replace(vessel, states=vessel.states if left else (*vessel.states, EMPTY), ingredients=left)


def _is_fixture(label: str) -> bool:
    """Whether things are put away there rather than prepared: cupboards, counters, fridges."""
    row = tables().utensil(label)
    return label.rsplit(maxsplit=1)[-1] in _ROOM or (row is not None and row.source == "cold" and row.can == {"hold"})
