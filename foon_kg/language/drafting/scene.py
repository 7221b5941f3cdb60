"""Where and how every object is while a narration goes on: what was peeled is what is chopped next."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from foon_kg.model import ObjectNode
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen

MIXTURE = "mixture"
EMPTY = "empty"
EVERYTHING = frozenset({"all", "everything", "ingredient", "content", "rest", "mix", MIXTURE})
PRONOUNS = frozenset({"it", "them", "this", "these", "that", "those"})


@dataclass
class Scene:
    """The objects of one narration as they are now; labels are those of the FOON, or as narrated.

    ``focus`` is the vessel that something was last brought to or done in, ``last`` the foods of the last action.
    ``sure`` says how sure the states of a food are; ``coming`` has, by canonical name, the first motion that will open
    or heat a food that is only moved before.
    """

    kitchen: Kitchen
    foods: dict[str, ObjectNode] = field(default_factory=dict)
    utensils: dict[str, ObjectNode] = field(default_factory=dict)
    focus: str | None = None
    last: tuple[str, ...] = ()
    sure: dict[str, float] = field(default_factory=dict)
    coming: dict[str, str] = field(default_factory=dict)
    taken: dict[str, str] = field(default_factory=dict)

    def called(self, name: str) -> str | None:
        """Answer the food or utensil of the scene that ``name`` speaks of, ``None`` where it is none of them.

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
        """Answer what is in ``vessel``."""
        return self.utensils[vessel].ingredients if vessel in self.utensils else ()

    def at_hand(self) -> tuple[str, ...]:
        """Answer what an action without an object is done to: all in the vessel of the last one, else its foods."""
        held = tuple(food for food in self.held(self.focus or "") if food in self.foods)
        return held or tuple(food for food in self.last if food in self.foods)

    def mixture(self) -> str | None:
        """Answer the mixture that was made last."""
        return next((label for label in reversed(self.foods) if label.endswith(MIXTURE)), None)

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
    """Answer ``vessel`` with ``foods`` in it as well."""
    states = tuple(state for state in vessel.states if state != EMPTY)
    return replace(vessel, states=states, ingredients=(*vessel.ingredients, *foods))


def emptied(vessel: ObjectNode, foods: Sequence[str]) -> ObjectNode:
    """Answer ``vessel`` without ``foods``; it is empty when they were all."""
    left = tuple(food for food in vessel.ingredients if food not in foods)
    return replace(vessel, states=vessel.states if left else (*vessel.states, EMPTY), ingredients=left)
