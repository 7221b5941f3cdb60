"""A video taken out of the FOON becomes a question: its dish, and its foods as they first join one another."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from foon_kg.food import singular, words
from foon_kg.model import FunctionalUnit, ObjectNode, Recipe, RequiredIngredient, Subgraph
from foon_kg.model.tree import newly_made
from foon_kg.plans.kitchen import Kitchen, is_place
from foon_kg.store.snapshot import goals_of


@dataclass(frozen=True)
class LeftOutVideo:
    """What is asked (``recipe``, named after the video), and the true subgraph that a person annotated."""

    recipe: Recipe
    units: tuple[FunctionalUnit, ...]

    @property
    def name(self) -> str:
        """The name of the video."""
        return self.recipe.id or ""


def left_out_video(subgraph: Subgraph, kitchen: Kitchen) -> LeftOutVideo | None:
    """Return the question that ``subgraph`` becomes in ``kitchen``; ``None`` for one that marks no dish, or no foods.

    Of several goals the one of most foods is asked, ties go to the first by content. What is asked is what a cook would
    buy for it (:func:`bought`): its foods, those of which it is made though it does not name them (the bread of a
    sandwich), and the goal itself where it is a food that the video begins with (a beefsteak is made of beefsteak).
    Each is asked in the state in which it first joins others (:func:`joining_state`); ``""`` where it shows none.
    """
    goal = _goal_of_most_foods(subgraph, kitchen)
    if goal is None:
        return None
    node, dish_type = goal
    units = tuple(annotation.unit for annotation in subgraph.annotations)
    foods = _foods_to_buy(units, node, kitchen)
    wants = tuple(joining_state(units, name, node, kitchen) for name in foods)
    return LeftOutVideo(Recipe(dish_type, wants, subgraph.name), units)


def _goal_of_most_foods(subgraph: Subgraph, kitchen: Kitchen) -> tuple[ObjectNode, str] | None:
    """Return the (node, dish type) of the goal that is asked; ``None`` where no goal names a food."""
    goals = [(node, dish) for node, dish in goals_of(subgraph, kitchen) if kitchen.foods_in(node)]
    # They come sorted by content, and max returns the first of equals: that settles ties.
    return max(goals, key=lambda goal: len(kitchen.foods_in(goal[0])), default=None)


def _foods_to_buy(units: Sequence[FunctionalUnit], goal: ObjectNode, kitchen: Kitchen) -> list[str]:
    """Return what a cook buys for the ``goal`` of the video's ``units``, each food once, sorted by name in singular."""
    names = [name for food in kitchen.foods_in(goal) for name in bought(units, food, kitchen)]
    if kitchen.is_food(goal) and _maker(units, goal.label, kitchen) is None:
        names.insert(0, goal.label)
    by_singular = {singular(name): name for name in names}
    for name in _unnamed(units, goal, tuple(by_singular), kitchen):
        by_singular.setdefault(singular(name), name)
    return [by_singular[food] for food in sorted(by_singular)]


def _unnamed(
    units: Sequence[FunctionalUnit], goal: ObjectNode, asked: Sequence[str], kitchen: Kitchen
) -> Iterator[str]:
    """Yield the foods from the start of which ``units`` make the ``goal``, though it names none of them as its own.

    People who annotate leave out what lies below the rest: the bread of a sandwich. ``asked`` foods (in singular) are
    asked as they are, whatever they are made of; what shares a word with one of them is taken to be the same food (rice
    and white rice), and what the video makes elsewhere is asked as its parts.
    """
    known = {word for name in asked for word in words(name)}
    for node in _foods_behind(units, goal, asked, kitchen):
        if known.isdisjoint(words(node.label)) and not _is_at_hand(units, node.label, kitchen):
            yield node.label


def _foods_behind(
    units: Sequence[FunctionalUnit], goal: ObjectNode, asked: Sequence[str], kitchen: Kitchen
) -> Iterator[ObjectNode]:
    """Yield the food nodes of which ``units`` make the ``goal``, but nothing of which one of the ``asked`` is made."""
    needed = {goal}
    for unit in reversed(units):
        if not needed.isdisjoint(unit.output_nodes):
            foods = [node for node in unit.input_nodes if kitchen.is_food(node)]
            yield from foods
            needed |= set(unit.input_nodes) - {node for node in foods if singular(node.label) in asked}


def _is_at_hand(units: Sequence[FunctionalUnit], name: str, kitchen: Kitchen) -> bool:
    """Whether nobody buys the food ``name`` for these ``units``: it is free, or one of them makes it."""
    return kitchen.is_free(name) or any(
        singular(name) in _named(unit.output_nodes, kitchen) and singular(name) not in _named(unit.input_nodes, kitchen)
        for unit in units
    )


def bought(units: Sequence[FunctionalUnit], name: str, kitchen: Kitchen) -> tuple[str, ...]:
    """Return the foods of which the video makes the food ``name``; the food itself where it is there from the start.

    ``units`` are the video's, in its order; ``kitchen`` says what a utensil is, and what is there unasked. Nobody asks
    for a batter: it is asked as the flour, the milk and the egg of the unit in which the video first names it, and
    lemon juice as the lemon. Free foods (water) that go into it are not asked. What is made of one food of quite
    another name (a carrot of an onion) is a slip of the pen, and what is put together of its own parts (an egg of egg
    white and egg yolk) is known by its name: both are asked as they are.
    """
    maker = _maker(units, name, kitchen)
    if maker is None:
        return (name,)
    place, parts = maker
    own = set(words(name))
    is_slip = len(parts) == 1 and own.isdisjoint(words(parts[0]))
    if is_slip or all(own < set(words(part)) for part in parts):
        return (name,)
    return tuple(dict.fromkeys(one for part in parts for one in bought(units[: place + 1], part, kitchen)))


def _maker(units: Sequence[FunctionalUnit], name: str, kitchen: Kitchen) -> tuple[int, list[str]] | None:
    """Return the place of the unit that makes the food, and of which foods; ``None`` where it is taken before that."""
    food = singular(name)
    for place, unit in enumerate(units):
        taken = _named(unit.input_nodes, kitchen)
        if food in taken:
            return None
        if food in _named(unit.output_nodes, kitchen):
            return place, [part for part in taken.values() if not kitchen.is_free(part)]
    return None


def _named(nodes: Sequence[ObjectNode], kitchen: Kitchen) -> dict[str, str]:
    """Return the foods that ``nodes`` are, and those in vessels, as they are written, by their names in singular."""
    foods = [node.label for node in nodes if kitchen.is_food(node)]
    held = [name for node in nodes if not kitchen.is_food(node) for name in kitchen.foods_in(node)]
    return {singular(name): name for name in (*held, *foods)}


def joining_state(units: Sequence[FunctionalUnit], name: str, goal: ObjectNode, kitchen: Kitchen) -> RequiredIngredient:
    """Return the food ``name`` as the video has it when it first joins others, under the video's own label.

    ``units`` are the video's, in its order; ``kitchen`` tells foods from utensils. It joins at the first unit that
    takes the food itself and leaves the goal, or something new that holds it beside another food (any other food, where
    the goal is called after it); where none does, at the last that takes it. Of several states the one that it got last
    counts, somebody's work before how it is sold.
    """
    taken = list(_taken_until_it_joins(units, singular(name), goal, kitchen))
    if not taken:
        return RequiredIngredient(name, "")
    _, joined = taken[-1]
    first_seen = _first_seen(taken)
    worked = kitchen.processed_states(joined)
    states = worked or tuple(state for state in joined.states if not is_place(state))
    last_got = max(states, key=lambda state: (first_seen[state], state), default="")
    return RequiredIngredient(joined.label, last_got)


def _taken_until_it_joins(
    units: Sequence[FunctionalUnit], food: str, goal: ObjectNode, kitchen: Kitchen
) -> Iterator[tuple[int, ObjectNode]]:
    """Yield the nodes of ``food`` (in singular) that ``units`` take, each with the place of its unit.

    Ends after the unit in which it joins others on the way to the ``goal``.
    """
    for place, unit in enumerate(units):
        taken = [node for node in unit.input_nodes if kitchen.is_food(node) and singular(node.label) == food]
        yield from ((place, node) for node in taken)
        if taken and any(_takes_up(node, food, goal, kitchen) for node in newly_made(unit)):
            return


def _first_seen(taken: Iterable[tuple[int, ObjectNode]]) -> dict[str, int]:
    """Return the place of the unit that first takes the food in a state, for each state of the ``taken`` nodes."""
    first: dict[str, int] = {}
    for place, node in taken:
        for state in node.states:
            first.setdefault(state, place)
    return first


def _takes_up(node: ObjectNode, food: str, goal: ObjectNode, kitchen: Kitchen) -> bool:
    """Whether the food (in singular) has joined others in ``node``, on the way to the ``goal``."""
    if node == goal:
        return True
    inside = {singular(name) for name in kitchen.foods_in(node)}
    if food == singular(goal.label):
        # A beefsteak made of beefsteak: what takes it up may be called after it, and need not name it among its foods.
        return not inside <= {food}
    return food in inside and len(inside) > 1 and singular(node.label) != food
