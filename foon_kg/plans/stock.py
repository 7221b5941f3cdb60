"""A kitchen in which a person, or a robot, has named what is at hand.

Naming utensils says that there are no others; naming foods says that there are no others. Of a kind of which nothing is
named everything is there, as C6 of the contract has it. Each thing is an object node that others are held
against: without a state it stands for a food in any state in which it is sold, or a utensil in any state; with
states for these alone, be they processed ones. Without a place it may be anywhere, with a place it is there. Storage (a
bottle, a shaker) comes with the food that it holds; free foods, and things like the faucet or a hand, are always there.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, fields, replace
from typing import Self

from foon_kg.food import singular
from foon_kg.food.lists import word_list
from foon_kg.model import ObjectNode
from foon_kg.plans.kitchen import Kitchen, folded, is_place

ALWAYS_THERE = word_list("always there")
"""What is there though nobody names it: places, running water, and hands."""


@dataclass(frozen=True, eq=False)
class StockedKitchen(Kitchen):
    """The kitchen that has ``utensils_named`` and ``foods_named``; ``None`` says that nothing of this kind was named.

    Make one with :meth:`of`.
    """

    utensils_named: tuple[ObjectNode, ...] | None = None
    foods_named: tuple[ObjectNode, ...] | None = None

    @classmethod
    def of(cls, kitchen: Kitchen, things: Collection[ObjectNode]) -> Self:
        """Return ``kitchen`` with just ``things`` in it: its utensils, if they name any, and its foods likewise."""
        known = {field.name: getattr(kitchen, field.name) for field in fields(Kitchen)}
        utensils = tuple(thing for thing in things if kitchen.is_utensil(thing.label))
        foods = tuple(thing for thing in things if not kitchen.is_utensil(thing.label))
        free = tuple(ObjectNode(name) for name in sorted(kitchen.free_foods))
        return cls(
            **known,
            utensils_named=(*utensils, *_places_of(things)) if utensils else None,
            foods_named=(*foods, *free) if foods else None,
        )

    def with_things(self, things: Collection[ObjectNode]) -> Self:
        """Return this kitchen with ``things`` in it as well."""
        return type(self).of(self, [*(self.utensils_named or ()), *(self.foods_named or ()), *things])

    def with_foods(self, names: Iterable[str]) -> Kitchen:
        """Return the kitchen in which ``names`` are foods, also those named as utensils (a cooking spray)."""
        foods = super().with_foods(names)
        if foods is self or self.utensils_named is None or self.foods_named is None:
            return foods
        asked = set(map(singular, names))
        both = tuple(thing for thing in self.utensils_named if singular(thing.label) in asked)
        return replace(foods, foods_named=(*self.foods_named, *both))  # type: ignore[call-arg]

    def with_every_food(self) -> Kitchen:
        """Return the kitchen with the same utensils and every food that shops sell."""
        return replace(self, foods_named=None)

    @property
    def food_names(self) -> tuple[str, ...]:
        """The foods that were named, sorted; free foods apart."""
        return tuple(sorted({thing.label for thing in self.foods_named or () if not self.is_free(thing.label)}))

    def lacks(self, node: ObjectNode) -> bool:
        """Whether ``node`` is nothing that was named, wherever it stands now."""
        return not (self._has_utensil(node) if self.is_utensil(node.label) else self._has_food(node))

    def may_have(self, food: str) -> bool:
        """Whether ``food`` was named in any state, or foods were not named at all."""
        return self.foods_named is None or bool(self._foods_called(food))

    def stands_ready(self, food: str, state: str) -> bool:
        """Whether a food was named in a processed state."""
        return not super().is_start_state(food, state) and any(
            _says(thing, state) for thing in self._foods_called(food)
        )

    def ready_in(self, food: str, state: str) -> str | None:
        """Return in what a food is that was named in a processed state (``""``: it lies free), or ``None``."""
        if not self.stands_ready(food, state):
            return None
        thing = next(thing for thing in self._foods_called(food) if _says(thing, state))
        return thing.container if thing.container is not None and self.is_storage(thing.container) else ""

    def has(self, node: ObjectNode) -> bool:
        """Whether the kitchen of a search has ``node``: named, and in the form that C6 asks or where it was named."""
        return not self.lacks(node) and (super().has(node) or self._is_named_here(node))

    def is_start_state(self, label: str, state: str) -> bool:
        """Whether the food ``label`` is there in ``state``; of a food that nobody named, whether it is sold so."""
        sold = super().is_start_state(label, state)
        named = self._foods_called(label)
        if is_place(state) or not named:
            return sold
        return any(_says(thing, state) if thing.states else sold for thing in named)

    def is_mixture(self, node: ObjectNode) -> bool:
        """Whether ``node`` has to be made of other foods: not where it was named as being there."""
        return super().is_mixture(node) and not self._foods_called(node.label)

    def is_running(self, node: ObjectNode) -> bool:
        """Whether somebody has to turn on or heat ``node``: not where it was named as being so."""
        return super().is_running(node) and not self._is_named_so(node)

    def at_rest(self, node: ObjectNode) -> bool:
        """Whether a utensil node is as nobody has to make it: at rest, or named as being so."""
        return super().at_rest(node) or self._is_named_so(node)

    def may_hold(self, node: ObjectNode, beside: Collection[ObjectNode] = ()) -> bool:
        """Return whether a vessel, a ``node`` that no unit makes, may hold its foods from the start.

        It may, too, where these were named as being in it. ``beside`` are the other leaves of the tree.
        """
        return super().may_hold(node, beside) or self._is_filled_so(node)

    def _has_food(self, node: ObjectNode) -> bool:
        if self.foods_named is None:
            return True
        return any(
            self._in_state(thing, node) and _in_place(thing, node.container) for thing in self._foods_called(node.label)
        )

    def _in_state(self, thing: ObjectNode, node: ObjectNode) -> bool:
        """Whether a food node is in a state of ``thing``; beside one that was named, another start state may stand."""
        sold = [super(StockedKitchen, self).is_start_state(node.label, state) for state in node.states]
        if not thing.states:
            return all(sold)
        if not node.states:
            return any(super(StockedKitchen, self).is_start_state(thing.label, state) for state in thing.states)
        said = [_says(thing, state) for state in node.states]
        return any(said) and all(one or other for one, other in zip(said, sold, strict=True))

    def _has_utensil(self, node: ObjectNode) -> bool:
        foods = self.foods_in(node)
        if not all(self._has_inside(name, node.label) for name in foods):
            return False
        comes_with_food = bool(foods) and self.is_storage(node.label)
        if self.utensils_named is None or comes_with_food or folded(node.label) in ALWAYS_THERE:
            return True
        return any(_stands_for(thing, node) for thing in self._utensils_called(node.label))

    def _has_inside(self, food: str, vessel: str) -> bool:
        return self.foods_named is None or any(_in_place(thing, vessel) for thing in self._foods_called(food))

    def _is_named_here(self, node: ObjectNode) -> bool:
        if self.is_utensil(node.label):
            return bool(self.foods_in(node)) and self.at_rest(node) and self._is_filled_so(node)
        return node.container is not None and any(
            thing.container is not None and _in_place(thing, node.container) for thing in self._foods_called(node.label)
        )

    def _is_filled_so(self, vessel: ObjectNode) -> bool:
        return all(
            any(thing.container and _in_place(thing, vessel.label) for thing in self._foods_called(name))
            for name in self.foods_in(vessel)
        )

    def _is_named_so(self, node: ObjectNode) -> bool:
        named = [thing for thing in self._utensils_called(node.label) if thing.states]
        return any(all(_says(thing, state) for state in node.states) for thing in named)

    def _foods_called(self, label: str) -> list[ObjectNode]:
        return list(_called(label, self.foods_named or ()))

    def _utensils_called(self, label: str) -> list[ObjectNode]:
        return list(_called(label, self.utensils_named or ()))


def _called(label: str, things: Collection[ObjectNode]) -> Iterator[ObjectNode]:
    name = singular(label)
    return (thing for thing in things if singular(thing.label) == name)


def _places_of(things: Iterable[ObjectNode]) -> Iterator[ObjectNode]:
    """Yield the places at which ``things`` were named: who names what is in the fridge has a fridge."""
    return (ObjectNode(thing.container) for thing in things if thing.container)


def _stands_for(thing: ObjectNode, utensil: ObjectNode) -> bool:
    """Whether ``thing``, of the same name, was named in every state of ``utensil``, or in none and so for any."""
    return not thing.states or all(_says(thing, state) or is_place(state) for state in utensil.states)


def _says(thing: ObjectNode, state: str) -> bool:
    return folded(state) in map(folded, thing.states)


def _in_place(thing: ObjectNode, container: str | None) -> bool:
    """Whether ``thing`` may be what stands in ``container``; where one of them says no place, it may."""
    return thing.container is None or container is None or folded(thing.container) == folded(container)
