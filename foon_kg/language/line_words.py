"""What a recipe line asks for, and how the words around a food become its states."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from foon_kg.food import tables
from foon_kg.food.lists import word_list
from foon_kg.food.rows import Level
from foon_kg.food.told_states import asked_state
from foon_kg.model.names import canonical
from foon_kg.similarity.groups import food_groups
from foon_kg.similarity.state_classes import state_classes
from foon_kg.similarity.states import state_in

_PHRASE = re.compile(r",|;|\band\b|\bthen\b|\(|\)", re.IGNORECASE)
_IN_NAMES = word_list("states in names")
_BEGINNINGS = tuple(sorted(word_list("beginnings of names")))
_REMARKS = frozenset({"divided"})  # a FOON divides dough; "4 tablespoons butter, divided" is used in two places
_KEPT_ASIDE = "reserved"


@dataclass(frozen=True)
class RecipeLine:
    """What one line asks for. ``text`` is the line as written; what was not understood of it is in ``left_over``.

    ``object`` is ``None`` where the line names no food (a heading); ``others`` are further foods that may be taken in
    its place ("sugar or honey"), ``beside`` what the line asks for as well ("salt and pepper"). ``state`` is what is
    asked by all that was done to it (:func:`~foon_kg.food.told_states.asked_state`), ``""`` where the line says nothing
    of it; ``states`` are all of them in their order. ``quantity`` ("2", "3/2", "2-3") and
    ``unit`` are ``""`` where there is none; ``size`` is what is said of it ("large"). ``confidence`` is how sure the
    food is, from 0 to 1.
    """

    text: str
    object: str | None
    state: str = ""
    states: tuple[str, ...] = ()
    quantity: str = ""
    unit: str = ""
    size: str = ""
    others: tuple[str, ...] = ()
    beside: tuple[RecipeLine, ...] = ()
    left_over: tuple[str, ...] = ()
    confidence: float = 0.0

    @property
    def foods(self) -> tuple[RecipeLine, ...]:
        """What the line asks for, each food as a line of its own; none where it names no food."""
        return () if self.object is None else (replace(self, beside=()), *self.beside)


def split_name(text: str) -> tuple[tuple[str, ...], str]:
    """Return the states at the front of a name (``text``), and the rest: "frozen chopped" and "spinach".

    "ground beef" and "white rice" stay whole.
    """
    words = text.replace(",", " ").split()
    states = []
    while len(words) > 1 and (state := _state_before(words[0], " ".join(words[1:]))):
        states.append(state)
        words = words[1:]
    return tuple(states), " ".join(words)


def _state_before(word: str, food: str) -> str | None:
    if canonical(word) in food_groups().places:  # "bean" is a state of the FOON, but not in "bean sprout"
        return None
    if word.lower() in _IN_NAMES or f"{word} {food}".lower().startswith(_BEGINNINGS) or is_another_food(word, food):
        return None
    return state_in(word) if "-" not in word or canonical(word) in state_classes().class_of else None


def is_another_food(state: str, food: str) -> bool:
    """Whether the word for a ``state`` makes another food: ground beef is used as no beef is, diced tomato as tomatoes.

    A dish that is nothing but this ``food`` cooked so is none: whoever asks for fried eggs has eggs to fry.
    """
    if _is_only_cooked(state, food):
        return False
    groups = food_groups()
    return not set(groups.of(canonical(f"{state} {food}"))) <= set(groups.of(canonical(food)))


def _is_only_cooked(state: str, food: str) -> bool:
    """Whether ``food`` with the ``state`` is a dish that is made of a raw food alone, by cooking it."""
    foods = tables().foods
    return foods.food(f"{state} {food}").is_a("cooked dish") and foods.food(food).owes.get("cook") is Level.FATAL


def is_bought_so(state: str, food: str) -> bool:
    """Return whether cooked ``food`` is sold by the name with its ``state``: cooked chicken.

    It needs no more than to be cut then.
    """
    name = f"{state} {food}"
    return tables().foods.is_listed(name) and tables().foods.food(name).is_a("cooked meat")


def as_bought(line: RecipeLine, so: Sequence[str] = ()) -> RecipeLine:
    """Return a line whose food is bought ``so``: cooked under that name, where more was done to it, or in a can.

    What a can holds was diced or crushed by nobody here. A utensil is no food (skewers). Words that say nothing of a
    food are no part of its name (reserved pasta water).
    """
    if not line.object:
        return line
    name = _without_praise(line.object)
    line = replace(line, object=name)
    if tables().utensil(name) is not None and not tables().foods.is_listed(name):
        return replace(line, object=None, left_over=(*line.left_over, name))
    if measured := _as_measured(name, line):
        states = (measured, *(state for state in line.states if state not in {measured, *so}))
        return replace(line, state=asked_state(states, tables()), states=states)
    first, rest = line.states[:1], line.states[1:]
    if not rest or not is_bought_so(first[0], name):
        return line
    return replace(line, object=f"{first[0]} {name}", state=asked_state(rest, tables()), states=rest)


def _as_measured(name: str, line: RecipeLine) -> str:
    """Return the state that the unit of ``line`` says of its food; of a spice only where the line says none."""
    foods, units = tables().foods, [line.unit]
    return foods.as_measured(name, units) or ("" if line.states else foods.as_spooned(name, units))


def _without_praise(name: str) -> str:
    """Return a name without the words in front that say nothing of the food; all of one that the table lists."""
    said = word_list("says nothing of a food in a line")
    words = name.split()
    while len(words) > 1 and words[0].lower() in said and not tables().foods.is_listed(" ".join(words)):
        words = words[1:]
    return " ".join(words)


def states_of(preparation: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the states that a preparation speaks of ("peeled and diced"), and its phrases that speak of none."""
    phrases = [phrase.strip() for phrase in _PHRASE.split(preparation) if phrase.strip()]
    read = [(phrase, () if _is_remark(phrase.lower()) else _states_in(phrase)) for phrase in phrases]
    states = tuple(state for _, found in read for state in found)
    return states, tuple(phrase for phrase, found in read if not found)


def _is_remark(phrase: str) -> bool:
    """Whether a phrase says nothing of the food: divided, juice reserved."""
    return phrase in _REMARKS or phrase.endswith(_KEPT_ASIDE)


def _states_in(phrase: str) -> tuple[str, ...]:
    """Return the states of one phrase: all of "chopped peeled seeded", of which the first was done last; else one."""
    places = state_classes().class_of
    words = phrase.lower().split()
    if len(words) > 1 and all(canonical(word) in places for word in words):
        return tuple(state for word in reversed(words) if (state := state_in(word)) is not None)
    state = state_in(phrase)
    return () if state is None else (state,)
