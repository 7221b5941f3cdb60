"""What is at hand before the first step: the kitchen of the contract (C6).

Two notions live here. The kitchen of a *search* is decided by the form of a node alone (:meth:`Kitchen.has`) and is
narrow: what it has is never made. The leaves that a *final* tree may have (:meth:`Kitchen.leaf_fault`) are a wider
set, because C6 lets a food in a start state be anywhere and a vessel stand beside the food that it holds.

Which names are utensils and which states are starts is data: the tables of :mod:`foon_kg.food`.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import TYPE_CHECKING, NamedTuple

from foon_kg.food import State, Tables, singular, tables, words
from foon_kg.food.lists import word_list
from foon_kg.model import ObjectNode

if TYPE_CHECKING:
    from foon_kg.model.tree import Step

_PLACE_KEPT_AS_STATE = re.compile(r"\[[^\]]*\]$")
_INSIDE = frozenset({None, "in", "from"})


class LeafFault(StrEnum):
    """Why a node may not be a leaf of a final tree."""

    RUNNING = "a utensil that is on or hot: somebody made it so"
    USED = "a utensil that is not at rest"
    HELD = "a vessel that is no storage holds a food that is not beside it"
    PROCESSED = "a food in a processed state"
    MIXTURE = "a food made of other foods"


class Shortage(NamedTuple):
    """A leaf of which a tree needs so many (``needed``) as there are not: there are ``there`` called so."""

    leaf: ObjectNode
    needed: int
    there: int


@dataclass(frozen=True, eq=False)
class Kitchen:
    """Which labels are utensils, which states are starts, and so what is at hand.

    Names of utensils compare in the singular, states without regard to case. ``storage`` are the utensils in which
    shops sell food. ``sold_so`` maps a state to the words of the foods that are sold in it (``ground`` → pepper, beef,
    …). ``free_foods`` may be added to any dish unasked (C5).

    This one has every utensil and whatever shops sell; :class:`~foon_kg.plans.stock.StockedKitchen` has what a person
    named.

    >>> kitchen = Kitchen.default()
    >>> kitchen.is_utensil("frying pans"), kitchen.is_start_state("onion", "chopped")
    (True, False)
    >>> kitchen.food_names, kitchen.made_so("onion"), kitchen.stands_as("onion", ["whole"]), kitchen.shortages([])
    ((), (), (), ())
    """

    utensils: frozenset[str]
    storage: frozenset[str]
    start_states: frozenset[str]
    sold_so: Mapping[str, frozenset[str]]
    rest_states: frozenset[str]
    running_states: frozenset[str]
    always_on: frozenset[str]
    free_foods: frozenset[str]

    @staticmethod
    def default(free_foods: Iterable[str] | None = None) -> Kitchen:
        """Return the kitchen of the tables and of a user's own; ``free_foods`` replaces the free foods (water).

        Raises ReadError where a table that a user named cannot be read.

        >>> Kitchen.default(["salt"]).is_free("salt"), Kitchen.default().is_free("salt")
        (True, False)
        """
        return _from_tables(tables(), None if free_foods is None else frozenset(map(folded, free_foods)))

    def with_foods(self, names: Iterable[str]) -> Kitchen:
        """Return the kitchen in which ``names`` are foods: a recipe may ask for a cooking spray.

        >>> Kitchen.default().with_foods(["skewer"]).is_utensil("skewer")
        False
        """
        foods = frozenset(map(singular, names)) & self.utensils
        return replace(self, utensils=self.utensils - foods) if foods else self

    def with_utensils(self, names: Iterable[str]) -> Kitchen:
        """Return the kitchen in which ``names`` are utensils; one that is called after a storage is one (spice bag).

        >>> Kitchen.default().with_utensils(["spice bag"]).is_storage("spice bag")
        True
        """
        fresh = frozenset(map(singular, names)) - self.utensils
        keep_food = {name for name in fresh if name.split()[-1] in self.storage}
        return replace(self, utensils=self.utensils | fresh, storage=self.storage | keep_food)

    def with_every_food(self) -> Kitchen:
        """Return the kitchen in which every food that shops sell is at hand: this one."""
        return self

    @property
    def food_names(self) -> tuple[str, ...]:
        """The foods that a person named as being at hand, sorted; free foods apart. None where nobody named any."""
        return ()

    def lacks(self, _: ObjectNode) -> bool:
        """Whether a leaf is missing from what a person named as being at hand; never where nobody named anything.

        >>> Kitchen.default().lacks(ObjectNode("truffle"))
        False
        """
        return False

    def stands_ready(self, _food: str, _state: str) -> bool:
        """Whether a person named a food as being at hand in a state that otherwise somebody would have to make.

        >>> Kitchen.default().stands_ready("onion", "chopped")
        False
        """
        return False

    def ready_in(self, _food: str, _state: str) -> str | None:
        """For the planner: return in what a ``_food`` stands ready in a ``_state`` (``""``: it lies free), or ``None``.

        >>> Kitchen.default().ready_in("onion", "chopped") is None
        True
        """
        return None

    def lies_in(self, _food: str, _states: Collection[str]) -> str | None:
        """For the planner: return the vessel in which a person named a ``_food`` in ``_states``, else ``None``.

        >>> Kitchen.default().lies_in("onion", ["chopped"]) is None
        True
        """
        return None

    def stands_as(self, _food: str, _states: Collection[str]) -> tuple[str, ...]:
        """For the planner: return the states of a ``_food`` in one piece that a person named, not in ``_states``."""
        return ()

    def made_so(self, _food: str) -> tuple[str, ...]:
        """For the planner: return the states beyond those of shops in which alone a person named a ``_food``."""
        return ()

    @property
    def found_on(self) -> Mapping[str, tuple[str, ...]]:
        """The states of the appliances, by name, that give heat already, as a person said; none where nobody did.

        >>> Kitchen.default().found_on
        {}
        """
        return {}

    def names_so(self, _: ObjectNode) -> bool:
        """Whether a person said of a thing that it is so: in which state, where, or with which contents.

        >>> Kitchen.default().names_so(ObjectNode("onion", ("chopped",)))
        False
        """
        return False

    def otherwise(self, _: ObjectNode) -> tuple[ObjectNode, ...]:
        """Return the things at hand that are called like a missing one, and are otherwise; none where none is missing.

        >>> Kitchen.default().otherwise(ObjectNode("onion", ("chopped",)))
        ()
        """
        return ()

    def missing_leaves(self, leaves: Iterable[ObjectNode], units: Iterable[Step]) -> list[ObjectNode]:
        """Return the ``leaves`` of the tree of ``units`` that are not at hand, or not as often as it needs them.

        >>> Kitchen.default().missing_leaves([ObjectNode("truffle"), ObjectNode("wok")], [])
        []
        """
        few = {one.leaf for one in self.shortages(units)}
        return [leaf for leaf in leaves if leaf in few or self.lacks(leaf)]

    def shortages(self, _: Iterable[Step]) -> tuple[Shortage, ...]:
        """Return of what a tree needs more than there are, as a person numbered them, in the order of its leaves."""
        return ()

    def is_utensil(self, label: str) -> bool:
        """Whether ``label`` names a utensil, appliance, wrap or place; everything else is food.

        >>> Kitchen.default().is_utensil("Bowls"), Kitchen.default().is_utensil("onion")
        (True, False)
        """
        return singular(label) in self.utensils

    def is_food(self, node: ObjectNode) -> bool:
        """Whether ``node`` is a food or a mixture of foods.

        >>> Kitchen.default().is_food(ObjectNode("egg mixture", container="bowl"))
        True
        """
        return not self.is_utensil(node.label)

    def is_storage(self, label: str) -> bool:
        """Whether ``label`` is a utensil in which food is sold: a tin can, a pepper mill.

        >>> Kitchen.default().is_storage("pepper mill"), Kitchen.default().is_storage("bowl")
        (True, False)
        """
        return self.is_utensil(label) and singular(label) in self.storage

    def is_free(self, label: str) -> bool:
        """Whether the food ``label`` may be used without having been asked for (C5).

        >>> Kitchen.default().is_free("water"), Kitchen.default().is_free("salt")
        (True, False)
        """
        return folded(label) in self.free_foods

    def is_start_state(self, label: str, state: str) -> bool:
        """Whether the food ``label`` is sold, or grows, in ``state``.

        A state that only some foods are sold in counts where *any* word of the label names one of them: black pepper
        is sold ground because pepper is, and so are ground beef and garlic powder. A place that the loader kept as a
        state (``on [stem]``) is no state of the food and counts as a start.

        >>> [Kitchen.default().is_start_state(food, "ground") for food in ("black pepper", "leek")]
        [True, False]
        """
        state = folded(state)
        if state in self.start_states or is_place(state):
            return True
        return not self.sold_so.get(state, frozenset()).isdisjoint(words(label))

    def processed_states(self, node: ObjectNode) -> tuple[str, ...]:
        """Return the states of a food node that somebody made: all but the start states.

        >>> Kitchen.default().processed_states(ObjectNode("onion", ("whole", "peeled")))
        ('peeled',)
        """
        return tuple(state for state in node.states if not self.is_start_state(node.label, state))

    def at_rest(self, node: ObjectNode) -> bool:
        """Whether a utensil node is off, cold, clean, open or closed, or has no state; a fridge may be on.

        >>> [Kitchen.default().at_rest(ObjectNode("oven", (state,))) for state in ("off", "on")]
        [True, False]
        """
        return all(self._rests(node.label, state) for state in node.states)

    def is_running(self, node: ObjectNode) -> bool:
        """Whether a utensil node is on or hot; the fridge always is and does not count.

        >>> [Kitchen.default().is_running(ObjectNode(name, ("on",))) for name in ("oven", "fridge")]
        [True, False]
        """
        return singular(node.label) not in self.always_on and any(folded(s) in self.running_states for s in node.states)

    def foods_in(self, node: ObjectNode) -> tuple[str, ...]:
        """Return the ingredients of ``node`` that are foods (``potato contains {packet}`` holds none).

        >>> Kitchen.default().foods_in(ObjectNode("bowl", (), ("onion", "spoon")))
        ('onion',)
        """
        return tuple(name for name in node.ingredients if not self.is_utensil(name))

    def is_mixture(self, node: ObjectNode) -> bool:
        """Whether a food node is an intermediate: made of foods other than itself, or called a mixture.

        ``egg mixture`` and ``broth {chicken broth, flour}`` are; ``olive oil {olive oil}`` is not. A food whose name
        shares a word with its only ingredient (chicken broth, broth) is the same food in other words.

        >>> [Kitchen.default().is_mixture(ObjectNode("broth", (), (of,))) for of in ("chicken broth", "onion")]
        [False, True]
        """
        if "mixture" in words(node.label):
            return True
        own = set(words(node.label))
        return any(own.isdisjoint(words(name)) for name in self.foods_in(node))

    def has(self, node: ObjectNode) -> bool:
        """Whether the kitchen of a *search* has ``node``, by its form alone.

        It has utensils at rest, wherever they stand, empty, or storage that holds one food; and foods in start states
        only (no state is a start), no mixtures, that have no place or lie in storage.

        >>> [Kitchen.default().has(ObjectNode("onion", (state,))) for state in ("whole", "chopped")]
        [True, False]
        """
        if self.is_utensil(node.label):
            foods = self.foods_in(node)
            return self.at_rest(node) and (not foods or (len(foods) == 1 and self.is_storage(node.label)))
        if self.processed_states(node) or self.is_mixture(node) or any(map(is_place, node.states)):
            return False
        return node.container is None or (node.relation in _INSIDE and self.is_storage(node.container))

    def leaf_fault(self, node: ObjectNode, beside: Collection[ObjectNode] = ()) -> LeafFault | None:
        """Return why C6 does not let ``node`` be a leaf of a final tree, or ``None``.

        ``beside`` are the other inputs of the unit that takes it. ``RUNNING`` is a fault only where some unit makes
        the node so: that needs the FOON, and is the caller's to decide. The order of the faults is the order of
        the clauses of C6. A vessel with several foods is held to the rule of a vessel with one, for each of them.

        >>> print(Kitchen.default().leaf_fault(ObjectNode("onion", ("chopped",))))
        a food in a processed state
        """
        if not self.is_utensil(node.label):
            if self.is_mixture(node):
                return LeafFault.MIXTURE
            return LeafFault.PROCESSED if self.processed_states(node) else None
        if self.is_running(node):
            return LeafFault.RUNNING
        if not self.at_rest(node):
            return LeafFault.USED
        return None if self.may_hold(node, beside) else LeafFault.HELD

    def may_hold(self, node: ObjectNode, beside: Collection[ObjectNode] = ()) -> bool:
        """Return whether the vessel ``node`` may hold its foods from the start.

        It is storage, or each food stands ``beside`` it.

        >>> bowl = ObjectNode("bowl", (), ("onion",))
        >>> Kitchen.default().may_hold(bowl), Kitchen.default().may_hold(bowl, [ObjectNode("onion")])
        (False, True)
        """
        if self.is_storage(node.label):
            return True
        there = {singular(other.label) for other in beside if self.is_food(other)}
        return all(singular(name) in there for name in self.foods_in(node))

    def may_be_leaf(self, node: ObjectNode, beside: Collection[ObjectNode] = ()) -> bool:
        """Return whether C6 lets ``node`` be a leaf of a final tree where no unit makes it (see :meth:`leaf_fault`).

        ``beside`` are the other leaves: what stands in a vessel that is one of them may be there.

        >>> [Kitchen.default().may_be_leaf(ObjectNode("pan", (state,))) for state in ("clean", "dirty")]
        [True, False]
        """
        return self.leaf_fault(node, beside) in {None, LeafFault.RUNNING}

    def _rests(self, label: str, state: str) -> bool:
        state = folded(state)
        if state in self.rest_states or is_place(state):
            return True
        return state in self.running_states and singular(label) in self.always_on


def household_fats(kitchen: Kitchen) -> tuple[str, ...]:
    """Return the fats that are at hand unasked in ``kitchen``, the best to fry in first.

    Where a person named foods these are the fats among them: the usual one first, then what runs as it is sold.

    >>> household_fats(Kitchen.default())
    ('oil',)
    """
    usual = word_list("fat of a kitchen")
    if not kitchen.food_names:
        return tuple(sorted(usual))
    named = map(tables().foods.food, kitchen.food_names)
    fats = [fat for fat in named if fat.kind in word_list("is fried in unasked")]
    fats.sort(key=lambda fat: (fat.name not in usual, not fat.is_a("liquid"), fat.name))
    return tuple(fat.name for fat in fats)


def is_place(state: str) -> bool:
    """Whether a state is really a place: the loader keeps all but the last ``[]`` of an object as ``with [rind]``."""
    return _PLACE_KEPT_AS_STATE.search(state) is not None


@functools.lru_cache(maxsize=1 << 16)  # a search asks it of every state of every node
def folded(name: str) -> str:
    """Return a name or a state in small letters, with single spaces."""
    return " ".join(name.lower().split())


@functools.lru_cache(maxsize=8)
def _from_tables(known: Tables, free_foods: frozenset[str] | None) -> Kitchen:
    return Kitchen(
        utensils=frozenset(known.utensils),
        storage=frozenset(name for name, row in known.utensils.items() if row.keeps_food),
        start_states=frozenset(name for name, row in known.states.items() if row.sold),
        sold_so=_sold_so(known.states),
        rest_states=known.utensil_states["rest"],
        running_states=known.utensil_states["on"] | known.utensil_states["hot"],
        always_on=frozenset(name for name, row in known.utensils.items() if row.always_on),
        free_foods=word_list("free foods") if free_foods is None else free_foods,
    )


def _sold_so(states: Mapping[str, State]) -> dict[str, frozenset[str]]:
    """Return the words of the foods that are sold in each state in which only some foods are."""
    return {name: frozenset(map(singular, row.sold_for)) for name, row in states.items() if row.sold_for}
