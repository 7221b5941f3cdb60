"""A kitchen in which a person, or a robot, has named what is at hand.

Naming utensils says that there are no others; naming foods says that there are no others. Of a kind of which nothing is
named everything is there, as C6 of the contract has it. Each thing is an object node that others are held
against: without a state it stands for a food in any state in which it is sold, or a utensil in any state; with
states for these alone, be they processed ones. Without a place it may be anywhere, with a place it is there: what lies
in or on a vessel is taken from there or not at all, and that vessel is not empty. A vessel that is named with contents
holds just these. Storage (a bottle, a shaker) comes with the food that it holds, and what is in storage, or in a place
like the fridge, may be taken out unsaid. Of a utensil there are as many as a person said, else as many as needed. Free
foods, and things like the faucet or a hand, are always there.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Self

from foon_kg.food import singular, tables
from foon_kg.food.lists import word_list
from foon_kg.model import ObjectNode
from foon_kg.model.tree import Step, things_found
from foon_kg.plans.kitchen import Kitchen, Shortage, folded, is_place
from foon_kg.plans.named import called, held_in, in_place, is_heating, is_told, is_vessel, places_of, says, starts_empty

ALWAYS_THERE = word_list("always there")
"""What is there though nobody names it: places, running water, and hands."""


@dataclass(frozen=True, eq=False)
class StockedKitchen(Kitchen):
    """The kitchen that has ``utensils_named`` and ``foods_named``; ``None`` says that nothing of this kind was named.

    ``inside`` are foods that were named only as contents of vessels: these do not say that there are no others.
    ``numbers`` say how many there are of a utensil. Make one with :meth:`of`, or of words with
    :meth:`foon_kg.foon.Foon.kitchen`. What it does not say itself is asked of :class:`~foon_kg.plans.kitchen.Kitchen`.

    >>> named = StockedKitchen.of(Kitchen.default(), [ObjectNode("onion", ("chopped",)), ObjectNode("egg")])
    >>> [named.lacks(ObjectNode(name)) for name in ("egg", "butter", "water", "wok")]
    [False, True, False, False]
    """

    utensils_named: tuple[ObjectNode, ...] | None = None
    foods_named: tuple[ObjectNode, ...] | None = None
    inside: tuple[ObjectNode, ...] = ()
    numbers: Mapping[str, int] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        kitchen: Kitchen,
        things: Collection[ObjectNode],
        numbers: Mapping[str, int] | None = None,
        inside: Collection[ObjectNode] = (),
    ) -> Self:
        """Return ``kitchen`` with just ``things`` in it: its utensils, if they name any, and its foods likewise.

        ``numbers`` say how many there are of a utensil (in the singular); of any other one there are as many as needed.
        ``inside`` are the foods that some of the things hold.

        >>> kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("bowl")], numbers={"bowl": 2})
        >>> kitchen.lacks(ObjectNode("wok")), kitchen.lacks(ObjectNode("butter"))
        (True, False)
        """
        known = {one.name: getattr(kitchen, one.name) for one in fields(Kitchen)}
        utensils = tuple(thing for thing in things if kitchen.is_utensil(thing.label))
        foods = tuple(thing for thing in things if not kitchen.is_utensil(thing.label))
        free = tuple(ObjectNode(name) for name in sorted(kitchen.free_foods))
        return cls(
            **known,
            utensils_named=(*utensils, *places_of(things, kitchen)) if utensils else None,
            foods_named=(*foods, *inside, *free) if foods else None,
            inside=tuple(inside),
            numbers=dict(numbers or {}),
        )

    def with_foods(self, names: Iterable[str]) -> Kitchen:
        """Return the kitchen in which ``names`` are foods, also those named as utensils (a cooking spray).

        >>> kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("egg"), ObjectNode("skewer")])
        >>> kitchen.food_names, kitchen.with_foods(["skewer"]).food_names
        (('egg',), ('egg', 'skewer'))
        """
        foods = super().with_foods(names)
        if foods is self or self.utensils_named is None or self.foods_named is None:
            return foods
        asked = set(map(singular, names))
        both = tuple(thing for thing in self.utensils_named if singular(thing.label) in asked)
        return replace(foods, foods_named=(*self.foods_named, *both))  # type: ignore[call-arg]

    def with_every_food(self) -> Kitchen:
        """Return the kitchen with the same utensils and every food that shops sell.

        >>> kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("egg")])
        >>> kitchen.lacks(ObjectNode("butter")), kitchen.with_every_food().lacks(ObjectNode("butter"))
        (True, False)
        """
        return replace(self, foods_named=None)

    @property
    def food_names(self) -> tuple[str, ...]:
        """The foods that were named, sorted; free foods apart.

        >>> StockedKitchen.of(Kitchen.default(), [ObjectNode("egg"), ObjectNode("wok")]).food_names
        ('egg',)
        """
        return tuple(sorted({thing.label for thing in self.foods_named or () if not self.is_free(thing.label)}))

    def lacks(self, node: ObjectNode) -> bool:
        """Whether ``node`` is nothing that was named, wherever it stands now.

        >>> kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("egg", ("boiled",))])
        >>> kitchen.lacks(ObjectNode("egg", ("boiled",))), kitchen.lacks(ObjectNode("egg", ("poached",)))
        (False, True)
        """
        return not (self._has_utensil(node) if self.is_utensil(node.label) else self._has_food(node))

    def stands_ready(self, food: str, state: str) -> bool:
        """Whether a ``food`` was named in the processed ``state``.

        >>> kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("onion", ("chopped",))])
        >>> kitchen.stands_ready("onion", "chopped"), kitchen.stands_ready("onion", "sliced")
        (True, False)
        """
        return not super().is_start_state(food, state) and any(says(thing, state) for thing in self._foods_called(food))

    def ready_in(self, food: str, state: str) -> str | None:
        """Return in what a food is that was named in a processed state (``""``: it lies free), or ``None``.

        ``None``, too, where it is together with others, or in something that is not at rest: it cannot be taken there.

        >>> onion = ObjectNode("onion", ("chopped",), relation="in", container="bowl")
        >>> StockedKitchen.of(Kitchen.default(), [onion]).ready_in("onion", "chopped")
        'bowl'
        """
        if not self.stands_ready(food, state):
            return None
        return self._nearest_place([thing for thing in self._foods_called(food) if says(thing, state)])

    def lies_in(self, food: str, states: Collection[str]) -> str | None:
        """Return the vessel in which all of a food is that was named so as to be had in ``states``, if it is alone.

        >>> egg = ObjectNode("egg", ("whole",), relation="in", container="bowl")
        >>> StockedKitchen.of(Kitchen.default(), [egg]).lies_in("egg", ["whole"])
        'bowl'
        """
        node = ObjectNode(food, tuple(states))
        things = [thing for thing in self._foods_called(food) if self._in_state(thing, node)]
        return (self._nearest_place(things) or None) if all(self._is_put(thing.container) for thing in things) else None

    def stands_as(self, food: str, states: Collection[str]) -> tuple[str, ...]:
        """Return the states in which a food is there that is not there in ``states``: opened, peeled, and in one piece.

        Nothing where it is there in ``states``, cut or cooked, or in several ways.

        >>> kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("onion", ("peeled",))])
        >>> kitchen.stands_as("onion", ["whole"]), kitchen.stands_as("onion", ["peeled"])
        (('peeled',), ())
        """
        things = self._foods_called(food)
        if any(self._in_state(thing, ObjectNode(food, tuple(states))) for thing in things):
            return ()
        rows = [tables().state(state) for state in self.made_so(food)]
        return things[0].states if rows and all(not row.fineness and not row.needs_heat for row in rows) else ()

    def made_so(self, food: str) -> tuple[str, ...]:
        """Return the states beyond those of shops in which alone a food was named; none where it is there otherwise.

        >>> StockedKitchen.of(Kitchen.default(), [ObjectNode("onion", ("whole", "peeled"))]).made_so("onion")
        ('peeled',)
        """
        named = {thing.states for thing in self._foods_called(food)}
        states = named.pop() if len(named) == 1 else ()
        return tuple(state for state in states if not super(StockedKitchen, self).is_start_state(food, state))

    @property
    def found_on(self) -> Mapping[str, tuple[str, ...]]:
        """The states of the appliances, by name, that were named as giving heat already, and not as off, too.

        >>> StockedKitchen.of(Kitchen.default(), [ObjectNode("oven", ("on",)), ObjectNode("stove")]).found_on
        {'oven': ('on',)}
        """
        named = {thing.label: thing.states for thing in self.utensils_named or () if is_heating(thing)}
        return {name: states for name, states in named.items() if len(self._utensils_called(name)) == 1}

    def names_so(self, node: ObjectNode) -> bool:
        """Whether a person said of ``node`` that it is in these states, in this place, or with these contents.

        >>> kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("onion", ("chopped",)), ObjectNode("egg")])
        >>> kitchen.names_so(ObjectNode("onion", ("chopped",))), kitchen.names_so(ObjectNode("egg"))
        (True, False)
        """
        if self.is_food(node):
            told = filter(is_told, self._foods_called(node.label))
            return any(self._in_state(thing, node) and self._lies_so(thing, node.container) for thing in told)
        if any(self._is_as(thing, node) for thing in filter(is_told, self._utensils_called(node.label))):
            return True
        return bool(self.foods_in(node)) and self._is_filled_so(node)

    def shortages(self, units: Iterable[Step]) -> tuple[Shortage, ...]:
        """Return of what the tree of ``units`` needs more than there are, as a person numbered them.

        >>> from foon_kg.model.tree import Mention, Step
        >>> bowl = ObjectNode("bowl")
        >>> stack = Step((Mention(bowl, 1), Mention(bowl, 2)), "stack", ())
        >>> found = StockedKitchen.of(Kitchen.default(), [bowl], numbers={"bowl": 1}).shortages([stack])
        >>> [(one.leaf.label, one.needed, one.there) for one in found]
        [('bowl', 2, 1)]
        """
        found = [(node, len(things)) for node, things in things_found(units).items() if self._is_numbered(node)]
        needed: Counter[str] = Counter()
        for node, number in found:
            needed[singular(node.label)] += number
        leaves = {singular(node.label): node for node, _ in found}
        numbers = ((leaf, needed[name], self.numbers[name]) for name, leaf in leaves.items())
        return tuple(Shortage(leaf, number, there) for leaf, number, there in numbers if number > there)

    def _is_numbered(self, node: ObjectNode) -> bool:
        """Whether a person said how many there are of a utensil; what food is sold in comes with that."""
        comes_with_food = self.is_storage(node.label) and bool(node.ingredients)
        return self.is_utensil(node.label) and singular(node.label) in self.numbers and not comes_with_food

    def otherwise(self, node: ObjectNode) -> tuple[ObjectNode, ...]:
        """Return the things called like ``node`` that are otherwise: in another state, place or with contents.

        >>> kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("onion", ("sliced",))])
        >>> [str(thing) for thing in kitchen.otherwise(ObjectNode("onion", ("chopped",)))]
        ['onion (sliced)']
        """
        named = (*self._foods_called(node.label), *self._utensils_called(node.label)) if self.lacks(node) else ()
        return tuple(dict.fromkeys(filter(is_told, named)))

    def has(self, node: ObjectNode) -> bool:
        """Whether the kitchen of a search has ``node``: named, and in the form that C6 asks or where it was named.

        >>> kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("onion", ("chopped",))])
        >>> kitchen.has(ObjectNode("onion", ("chopped",))), kitchen.has(ObjectNode("leek"))
        (True, False)
        """
        return not self.lacks(node) and (super().has(node) or self._is_named_here(node))

    def is_start_state(self, label: str, state: str) -> bool:
        """Whether the food ``label`` is there in ``state``; of a food that nobody named, whether it is sold so.

        >>> kitchen = StockedKitchen.of(Kitchen.default(), [ObjectNode("onion", ("chopped",))])
        >>> kitchen.is_start_state("onion", "chopped"), kitchen.is_start_state("onion", "whole")
        (True, False)
        """
        sold = super().is_start_state(label, state)
        named = self._foods_called(label)
        if is_place(state) or not named:
            return sold
        said = any(says(thing, state) if thing.states else sold for thing in named)
        return said or (sold and self.foods_named is None)

    def is_mixture(self, node: ObjectNode) -> bool:
        """Whether ``node`` has to be made of other foods: not where it was named as being there.

        >>> broth = ObjectNode("broth", (), ("carrot", "onion"))
        >>> Kitchen.default().is_mixture(broth), StockedKitchen.of(Kitchen.default(), [broth]).is_mixture(broth)
        (True, False)
        """
        return super().is_mixture(node) and not self._foods_called(node.label)

    def is_running(self, node: ObjectNode) -> bool:
        """Whether somebody has to turn on or heat ``node``: not where it was named as being so.

        >>> oven = ObjectNode("oven", ("on",))
        >>> Kitchen.default().is_running(oven), StockedKitchen.of(Kitchen.default(), [oven]).is_running(oven)
        (True, False)
        """
        return super().is_running(node) and not self._is_named_so(node)

    def at_rest(self, node: ObjectNode) -> bool:
        """Whether a utensil node is as nobody has to make it: at rest, or named as being so.

        >>> pan = ObjectNode("pan", ("greased",))
        >>> Kitchen.default().at_rest(pan), StockedKitchen.of(Kitchen.default(), [pan]).at_rest(pan)
        (False, True)
        """
        return super().at_rest(node) or self._is_named_so(node)

    def may_hold(self, node: ObjectNode, beside: Collection[ObjectNode] = ()) -> bool:
        """Return whether a vessel, a ``node`` that no unit makes, may hold its foods from the start.

        It may, too, where these were named as being in it. ``beside`` are the other leaves of the tree.

        >>> egg, bowl = ObjectNode("egg", (), (), "in", "bowl"), ObjectNode("bowl", (), ("egg",))
        >>> Kitchen.default().may_hold(bowl), StockedKitchen.of(Kitchen.default(), [egg]).may_hold(bowl)
        (False, True)
        """
        return super().may_hold(node, beside) or self._is_filled_so(node)

    def _has_food(self, node: ObjectNode) -> bool:
        if self.foods_named is None:
            return True
        return any(
            self._in_state(thing, node) and self._lies_so(thing, node.container)
            for thing in self._foods_called(node.label)
        )

    def _lies_so(self, thing: ObjectNode, container: str | None) -> bool:
        """Whether a food, ``thing``, may be taken out of ``container`` (``None``: as if it lay free)."""
        return not self._is_put(thing.container) if container is None else in_place(thing, container)

    def _is_put(self, container: str | None) -> bool:
        """Whether what is in ``container`` was put there by somebody, and does not keep there."""
        return container is not None and not self.is_storage(container) and starts_empty(container)

    def _nearest_place(self, things: Collection[ObjectNode]) -> str | None:
        """Return out of what one of some foods is taken: of no vessel (``""``), else of one in which it is alone."""
        free = [thing for thing in things if not self._is_put(thing.container)]
        if free:
            kept = free[0].container
            return kept if kept is not None and self.is_storage(kept) else ""
        return next((thing.container for thing in things if self._is_alone(thing)), None)

    def _is_alone(self, thing: ObjectNode) -> bool:
        """Whether a food is by itself in a vessel that is not heated, hot or on an appliance."""
        place, own = thing.container or "", {singular(thing.label)}
        if not is_vessel(place) or self._foods_at(place) != own:
            return False
        vessels = filter(held_in, self._utensils_called(place))
        return all(held_in(one) == own and self._is_at_rest_aside(one) for one in vessels)

    def _foods_at(self, place: str) -> set[str]:
        """Return the foods that were named as being in ``place``."""
        return {singular(one.label) for one in self._foods if one.container and in_place(one, place)}

    def _is_at_rest_aside(self, vessel: ObjectNode) -> bool:
        return not vessel.states and not self._is_put(vessel.container)

    def _in_state(self, thing: ObjectNode, node: ObjectNode) -> bool:
        """Whether a food node is in a state of ``thing``; beside one that was named, another start state may stand."""
        sold = [super(StockedKitchen, self).is_start_state(node.label, state) for state in node.states]
        if not thing.states:
            return all(sold)
        if not node.states:
            return any(super(StockedKitchen, self).is_start_state(thing.label, state) for state in thing.states)
        said = [says(thing, state) for state in node.states]
        return any(said) and all(one or other for one, other in zip(said, sold, strict=True))

    def _has_utensil(self, node: ObjectNode) -> bool:
        foods = self.foods_in(node)
        comes_with_food = bool(foods) and self.is_storage(node.label)
        if self.utensils_named is None or comes_with_food or folded(node.label) in ALWAYS_THERE:
            return all(self._has_inside(name, node.label) for name in foods)
        return any(self._is_as(thing, node) for thing in self._utensils_called(node.label))

    def _is_as(self, thing: ObjectNode, node: ObjectNode) -> bool:
        """Whether a utensil ``node`` is in the states of ``thing`` and holds what that does.

        What was named without a state and without contents stands for any.
        """
        return self._stands_for(thing, node) and self._holds_as(thing, node)

    def _stands_for(self, thing: ObjectNode, node: ObjectNode) -> bool:
        """Whether ``thing`` was named in every state of ``node``, or in none; what is in no state is at rest."""
        if not thing.states or not node.states:
            return super().at_rest(thing)
        return all(says(thing, state) or is_place(state) for state in node.states)

    def _holds_as(self, thing: ObjectNode, node: ObjectNode) -> bool:
        held, said = set(map(singular, self.foods_in(thing))), self.foods_in(node)
        if held:
            return held == set(map(singular, said)) or self.is_storage(thing.label)
        return not said or (not thing.states and all(self._has_inside(name, node.label) for name in said))

    def _has_inside(self, food: str, vessel: str) -> bool:
        return self.foods_named is None or any(in_place(thing, vessel) for thing in self._foods_called(food))

    def _is_named_here(self, node: ObjectNode) -> bool:
        if self.is_utensil(node.label):
            return bool(self.foods_in(node)) and self.at_rest(node) and self._is_filled_so(node)
        return node.container is not None and any(
            thing.container is not None and in_place(thing, node.container) for thing in self._foods_called(node.label)
        )

    def _is_filled_so(self, vessel: ObjectNode) -> bool:
        return all(
            any(thing.container and in_place(thing, vessel.label) for thing in self._foods_called(name))
            for name in self.foods_in(vessel)
        )

    def _is_named_so(self, node: ObjectNode) -> bool:
        named = [thing for thing in self._utensils_called(node.label) if thing.states]
        return any(self._is_as(thing, node) for thing in named)

    @property
    def _foods(self) -> tuple[ObjectNode, ...]:
        return self.inside if self.foods_named is None else self.foods_named

    def _foods_called(self, label: str) -> list[ObjectNode]:
        return list(called(label, self._foods))

    def _utensils_called(self, label: str) -> list[ObjectNode]:
        return list(called(label, self.utensils_named or ()))
