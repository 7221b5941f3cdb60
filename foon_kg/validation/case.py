"""What a rule has before it when it judges a tree: the tree, the FOON, the world in which it was played, the dish."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

from foon_kg.food import Tables, singular, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import Food
from foon_kg.food.told_states import in_turn
from foon_kg.model import ObjectNode, Recipe, RequiredIngredient
from foon_kg.model.tree import Step, TaskTree
from foon_kg.validation.foon import KnownFoon
from foon_kg.world import Lump, Part, PlayedStep, World
from foon_kg.world.reading import NodeReading, Reader

FREE = word_list("free foods")
"""The foods that may be used unasked where no setting says otherwise (C5)."""


@dataclass(frozen=True, eq=False)
class Case:
    """A tree with the FOON it should come from, ``None`` where there is none at hand."""

    tree: TaskTree
    foon: KnownFoon | None
    free: frozenset[str] = FREE
    lacks: Callable[[ObjectNode], bool] | None = None
    named_so: Callable[[ObjectNode], bool] | None = None

    @property
    def recipe(self) -> Recipe | None:
        """The recipe asked, where it is known."""
        return self.tree.recipe

    @property
    def required(self) -> tuple[RequiredIngredient, ...]:
        """What the recipe asks for; nothing where there is none."""
        return self.recipe.ingredients if self.recipe else ()

    @property
    def title(self) -> str:
        """The title of the recipe asked; empty where there is none."""
        return (self.recipe.title or "") if self.recipe else ""

    @cached_property
    def required_names(self) -> frozenset[str]:
        """The required foods, in the singular."""
        return frozenset(singular(wanted.object) for wanted in self.required)

    @cached_property
    def world(self) -> World:
        """The kitchen after the whole tree was played in it."""
        world = World([wanted.object for wanted in self.required])
        on = (node for node in self.tree.leaves if world.reader.read(node).on and self.is_named_so(node))
        world.supply.found_on = frozenset(singular(node.label) for node in on)
        for unit in self.tree.units:
            world.play(unit)
        return world

    @property
    def played_steps(self) -> list[PlayedStep]:
        """What happened in each unit."""
        return self.world.played_steps

    @property
    def tables(self) -> Tables:
        """What is known of cooking."""
        return self.world.tables

    def read(self, node: ObjectNode) -> NodeReading:
        """Return what a node says."""
        said = self._said.get(id(node))
        if said is None:
            said = self._said[id(node)] = self.reader.read(node)
        return said

    @cached_property
    def _said(self) -> dict[int, NodeReading]:
        return {}  # by identity: the tree keeps its nodes, and to compare them costs more than all else

    @cached_property
    def facts(self) -> dict[tuple[frozenset[str], int], object]:
        """What a rule worked out of each unit of the tree, as :attr:`KnownFoon.facts` has it of the FOON's."""
        return {}

    @cached_property
    def reader(self) -> Reader:
        """What reads nodes in this kitchen."""
        return self.world.reader

    def is_named_so(self, node: ObjectNode) -> bool:
        """Whether a person said that a leaf, ``node``, is at hand just so."""
        return self.named_so is not None and self.named_so(node)

    def is_food(self, node: ObjectNode) -> bool:
        """Whether a node is a food in this kitchen."""
        return self.read(node).is_food

    @cached_property
    def goal(self) -> ObjectNode | None:
        """The goal that the tree names; for unmarked FOON text the richest food of the last unit that has any."""
        if self.tree.goal is not None or self.last is None:
            return self.tree.goal
        foods = [node for node in self.tree.units[self.last].output_nodes if self.is_food(node)]
        return max(foods, key=lambda node: (len(node.ingredients), node.sort_key), default=None)

    @cached_property
    def last(self) -> int | None:
        """The place of the last unit that touches food, ``None`` where none does.

        Of a reference tree it is the last unit: any node may have been asked for, a clean bowl too.
        """
        if self.tree.level is not None:
            return len(self.tree.units) - 1 if self.tree.units else None
        places = [place for place, unit in enumerate(self.tree.units) if self.touches_food(unit)]
        return places[-1] if places else None

    def touches_food(self, unit: Step) -> bool:
        """Whether food comes out of a unit: what only puts a vessel away does not."""
        return any(self.is_food(node) for node in unit.output_nodes)

    @cached_property
    def dish(self) -> Lump | None:
        """The goal as a thing of the world; ``None`` where nothing is the goal."""
        if self.goal is None:
            return None
        for played_step in reversed(self.played_steps):
            for node, lump in played_step.outputs.items():
                if node == self.goal:
                    return lump
        return None

    @cached_property
    def dish_lumps(self) -> tuple[Lump, ...]:
        """The goal with all foods that are in the same vessel."""
        if self.dish is None:
            return ()
        beside = self.dish.where.lumps if self.dish.where is not None else []
        return tuple(dict.fromkeys((self.dish, *(lump for lump in beside if not lump.gone))))

    @cached_property
    def parts(self) -> tuple[Part, ...]:
        """What is in the dish, each part once."""
        return tuple(dict.fromkeys(part for lump in self.dish_lumps for part in lump.parts))

    @cached_property
    def parts_by_name(self) -> dict[str, list[Part]]:
        """The parts of the dish by the name of their food."""
        found: dict[str, list[Part]] = {}
        for part in self.parts:
            found.setdefault(part.name, []).append(part)
        for name in self.required_names - found.keys():
            kept = [part for part in self.parts if self._is_kept_of(name, part)]
            found |= {name: kept} if kept else {}
        return found

    def _is_kept_of(self, name: str, part: Part) -> bool:
        """Whether ``name`` is that of what was taken out of a pot, and ``part`` the water that boiled in it."""
        if not self.tables.foods.food(name).is_any(word_list("is the water of a pot")) or not part.food.is_a("water"):
            return False
        taken = (h for h in self.played_steps if name in {singular(node.label) for node in h.outputs})
        return part.heated is not None and any(part.name in {singular(node.label) for node in h.inputs} for h in taken)

    @cached_property
    def dish_types(self) -> tuple[str, ...]:
        """The dish types the goal may be of: the one asked, else those of which the FOON has this product."""
        if self.recipe and self.recipe.dish_type:
            return (self.recipe.dish_type,)
        if self.goal is None or self.foon is None:
            return ()
        return tuple(sorted(t for t, labels in self.foon.end_products.items() if self.goal.label in labels))

    def is_free(self, name: str) -> bool:
        """Return whether the food ``name`` may be used unasked."""
        return name in self.free

    def is_wanted(self, name: str) -> bool:
        """Return whether the food ``name`` was asked for, in these words, fewer or more of them (chicken broth)."""
        return name in self.required_names or any(_alike(name, other) for other in self.required_names)


def _alike(one: str, other: str) -> bool:
    """Return whether two names end alike, and one has all words of the other."""
    mine, theirs = words(one), words(other)
    if not mine or not theirs or mine[-1] != theirs[-1]:
        return False
    return set(mine) <= set(theirs) or set(theirs) <= set(mine)


def names(foods: Iterable[str]) -> str:
    """Return the names of ``foods`` in a sentence, sorted, each once."""
    return ", ".join(sorted(set(foods)))


def was_taken_out(case: Case, food: str) -> bool:
    """Return whether ``food``, which nobody eats, gave its taste in ``case`` before it was taken out again."""
    given = word_list("is taken out of the dish")
    if says(case.dish_types, "is drunk"):
        given |= word_list("is taken out of what is drunk") | word_list("stays in a strainer")
    if not any(facts.is_any(given) for facts in _as_asked(case, food)):
        return False
    nodes = (node for played_step in case.played_steps for node in played_step.outputs)
    return any(len(node.ingredients) > 1 and food in map(singular, node.ingredients) for node in nodes)


def _as_asked(case: Case, food: str) -> Iterator[Food]:
    """Yield what the tables say of a food, by itself and as it is required: tea in leaves is none that is drunk."""
    yield case.tables.foods.food(food)
    yield from (
        case.tables.foods.food(food, in_turn(one.state)) for one in case.required if singular(one.object) == food
    )
