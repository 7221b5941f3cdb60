"""The tables of cooking read from their files: ``foods``, ``dishes``, ``states``, ``motions`` and ``utensils`` (TOML).

Everything that foon-kg knows of cooking stands in them; no algorithm has a list of foods or words of its own. A table
of the same form named in ``FOON_KG_UTENSILS`` or ``FOON_KG_FOODS`` adds a user's own utensils or foods.
"""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

from foon_kg.food.faults import FOODS, UTENSILS, malformed, unknown_targets
from foon_kg.food.foods import FoodTable, make_room
from foon_kg.food.lists import names_in, says, word_list
from foon_kg.food.parsing import Toml, dish_row, food_table, motion_row, needs_of, refused, state_row, utensil_rows
from foon_kg.food.rows import Dish, Motion, State, Utensil
from foon_kg.food.shipped import shipped
from foon_kg.food.words import names_inside, plain_words, singular, words
from foon_kg.model.errors import ReadError
from foon_kg.model.regular_files import read_text

UTENSILS_VARIABLE = "FOON_KG_UTENSILS"
FOODS_VARIABLE = "FOON_KG_FOODS"

_MOST_NAMED = 4096
"""For how many titles their dishes are remembered: a service is asked of new ones as long as it runs."""

_QUOTED = re.compile(r'["\u201c\u2018][^"\u201d\u2019]+["\u201d\u2019]')
_FOR = re.compile(r"\s+for\s+", re.IGNORECASE)
_IN_BRACKETS = re.compile(r"\([^()]*\)")


class Tables:
    """The five tables, and how a name is looked up in each. Each is read when it is first asked.

    ``own_utensils`` and ``own_foods`` are the paths of a user's own tables, ``""`` for none. Raises ReadError where one
    cannot be read or is not of its form.
    """

    def __init__(self, own_utensils: str = "", own_foods: str = "") -> None:
        self._own_utensils = list(_own(own_utensils, UTENSILS))
        self._own_foods = list(_own(own_foods, FOODS))
        self._states: dict[str, State] = {}
        self._motions: dict[str, Motion] = {}
        self._named: dict[tuple[str, ...], tuple[Dish, ...]] = {}
        if own_utensils:
            _ = self.utensils  # a fault in a user's own table is told at once
        if own_foods:
            self._check_targets()

    def _check_targets(self) -> None:
        for where, document in self._own_foods:
            table = self.foods
            for fault in unknown_targets(document, table.kinds, table.kind_of):
                raise refused(where, fault)

    @cached_property
    def foods(self) -> FoodTable:
        """The table of foods."""
        return food_table([("foods.toml", shipped("foods")), *self._own_foods])

    @cached_property
    def states(self) -> Mapping[str, State]:
        """What each listed state says."""
        return {name.lower(): state_row(name, row) for name, row in shipped("states")["states"].items()}

    @property
    def _called(self) -> Mapping[str, str]:
        """As which listed state each other word of recipes is read."""
        called: Mapping[str, str] = shipped("states")["called"]
        return called

    @cached_property
    def motions(self) -> Mapping[str, Motion]:
        """Motions of several words that do something else than their words."""
        return {name.lower(): motion_row(name, row) for name, row in self._motion_table.get("motions", {}).items()}

    @cached_property
    def motion_words(self) -> Mapping[str, Motion]:
        """What each word of a motion does."""
        return {name.lower(): motion_row(name, row) for name, row in self._motion_table["words"].items()}

    @cached_property
    def _motion_table(self) -> Toml:
        return shipped("motions")

    @cached_property
    def _utensil_table(self) -> Toml:
        return shipped("utensils")

    @cached_property
    def utensils(self) -> Mapping[str, Utensil]:
        """Every utensil by its name in the singular."""
        documents = [("utensils.toml", self._utensil_table), *self._own_utensils]
        return {name: row for where, document in documents for name, row in utensil_rows(document, where)}

    @cached_property
    def utensil_states(self) -> Mapping[str, frozenset[str]]:
        """The states of utensils by what they say: at rest, on, off, hot, closed."""
        return {name: frozenset(listed) for name, listed in self._utensil_table["states"].items()}

    @cached_property
    def _dish_table(self) -> Toml:
        return shipped("dishes")

    @cached_property
    def dishes(self) -> Mapping[str, Dish]:
        """What defines each named dish."""
        rows: Mapping[str, Mapping[str, Any]] = self._dish_table["dishes"]
        families = {
            one: dish_row(one, row) for name, row in rows.items() if name[0] == "@" for one in names_in(name[1:])
        }
        return families | {singular(name): dish_row(name, row) for name, row in rows.items() if name[0] != "@"}

    @cached_property
    def cores(self) -> Mapping[str, str]:
        """As what a food of which nothing is known is understood, by the type of a dish that needs such a food."""
        cores: Mapping[str, str] = self._dish_table["cores"]
        return cores

    @cached_property
    def unfinished(self) -> frozenset[str]:
        """The names of what is no finished dish: dough, batter, mixture."""
        return frozenset(map(singular, self._dish_table["products"]["unfinished"]))

    @cached_property
    def contains(self) -> Mapping[str, tuple[tuple[str, ...], ...]]:
        """What must be in each product: of every list one."""
        return {singular(name): needs_of(row) for name, row in self._dish_table["products"]["contains"].items()}

    def utensil(self, label: str) -> Utensil | None:
        """Return the utensil called ``label``; ``None`` where it is none, and so a food."""
        return self.utensils.get(singular(label))

    def state(self, name: str) -> State:
        """Return what the state ``name`` says: as it is listed, else as its words are ("thinly sliced" is sliced)."""
        found = self._states.get(name)
        if found is None:
            make_room(self._states)
            low = name.lower()
            found = self._states[name] = self.states.get(self._called.get(low, low)) or self._of_words(name)
        return found

    def state_called(self, name: str) -> str:
        """Return as which listed state recipes mean ``name``, one word or several, else ``name`` itself.

        Of several the last that is a cut counts, unless another says that it is cooked: then the cut is not all.

        >>> tables().state_called("julienne"), tables().state_called("thin slivers"), tables().state_called("smoky")
        ('julienned', 'slivered', 'smoky')
        """
        low = name.lower()
        if low in self.states:
            return name
        if low in self._called:
            return self._called[low]
        meant = [self._called.get(word, word) for word in reversed(low.replace(",", " ").split())]
        listed = [state for state in meant if state in self.states]
        if any("cook" in self.states[state].earns for state in listed):
            return name
        return next((state for state in listed if "cut" in self.states[state].earns), name)

    def motion(self, name: str) -> Motion:
        """Return what the motion ``name`` does: as the phrase is listed, else all that its words do."""
        found = self._motions.get(name)
        if found is None:
            make_room(self._motions)
            found = self._motions[name] = self.motions.get(name.lower()) or self._of_motion_words(name)
        return found

    def _of_words(self, name: str) -> State:
        said = (self._called.get(word, word) for word in sorted(plain_words(name)))
        listed = [self.states[word] for word in said if word in self.states]
        return State(
            name,
            frozenset().union(*(row.earns for row in listed)),
            _finest(listed),
            sold=bool(listed) and all(row.sold for row in listed),
            undivided=any(row.undivided for row in listed),
            half=any(row.half for row in listed),
            needs_heat=any(row.needs_heat for row in listed),
        )

    def _of_motion_words(self, name: str) -> Motion:
        listed = [self.motion_words[word] for word in sorted(plain_words(name)) if word in self.motion_words]
        sources = sorted({row.source for row in listed} - {""})
        return Motion(
            name,
            frozenset().union(*(row.does for row in listed)),
            frozenset().union(*(row.gives for row in listed)),
            tuple(tool for row in listed for tool in row.tools),
            "heat" if "heat" in sources else "".join(sources[:1]),
            known=bool(listed),
        )

    def dishes_named(self, *texts: str) -> tuple[Dish, ...]:
        """Return the dishes that stand in ``texts`` (a goal's label, a title), the longer names only."""
        known = self._named.get(texts)
        if known is None:
            if len(self._named) >= _MOST_NAMED:
                self._named.clear()
            known = self._named[texts] = self._dishes_named(texts)
        return known

    def _dishes_named(self, texts: tuple[str, ...]) -> tuple[Dish, ...]:
        found: dict[str, Dish] = {}
        for text in texts:
            # “tuna” in quotes is none, nor a sauce for steak, and what has no eggs is not called after them
            plain = _QUOTED.sub(" ", _FOR.split(text)[0] or text)
            # what stands in brackets explains a name (arepas, corn cakes): it counts only beside one that nobody knows
            shown = _IN_BRACKETS.sub(" ", plain)
            if not self._add_named(found, shown, texts) and shown != plain:
                explained: dict[str, Dish] = {}
                self._add_named(explained, plain, texts)
                # it explains by a food that people know: spinach, where the recipe has the leaves of another land
                found |= {name: dish if _is_made(dish) else replace(dish, needs=()) for name, dish in explained.items()}
        no = frozenset().union(*(dish.is_no for dish in found.values()))
        return tuple(dish for name, dish in found.items() if name not in no)

    def _add_named(self, found: dict[str, Dish], text: str, types: Collection[str]) -> bool:
        """Add to the dishes ``found`` those that stand in a text, and return whether any does; see `_dish_called`."""
        own, named = _without(words(text)), False
        for start, end in _spans(own):
            name = " ".join(own[start:end])
            if name not in self.dishes or not _is_in_its_number(name, text):
                continue
            named = True
            # a part of a word counts, too: the type cake says nothing beside the title cheesecake
            if not any(name in other for other in found):
                found[name] = self._dish_called(name, own, start, types)
        return named

    def _dish_called(self, name: str, own: Sequence[str], start: int, types: Collection[str]) -> Dish:
        """Return the dish whose ``name`` begins at ``start`` in a title, without its needs where it is only a modifier.

        ``types`` are the texts that may name the type.
        """
        dish = self.dishes[name]
        is_other = says(own[:start], "is not what it is called")
        end = start + len(name.split())
        only_modifies = is_other or (not dish.is_type and self._is_modifier(own, end, types))
        return replace(dish, needs=()) if only_modifies else dish

    def _is_modifier(self, own: Sequence[str], end: int, types: Collection[str]) -> bool:
        """Whether the dish whose name ends at ``end`` in a title only says of what sort the dish is: taco meatballs.

        So it is where the name of its type, one of ``types``, comes behind it and no word between says that both are.
        """
        last = max((at for at in range(end, len(own)) if own[at] in types and self.dishes[own[at]].is_type), default=-1)
        return last >= end and not says(own[end:last], "names another dish or food")


def _is_made(dish: Dish) -> bool:
    """Whether a name is that of a dish, and not of a food that may be in one."""
    return dish.is_type or dish.heated is not None or dish.baked or dish.mashed


def _is_in_its_number(name: str, text: str) -> bool:
    """Whether a name, unless it is one only in the plural, stands so in a text: a fry is no dish of fries."""
    plurals = {one for one in word_list("names a dish only in the plural") if singular(one) == name}
    return not plurals or not plurals.isdisjoint(text.lower().split())


def _finest(states: Iterable[State]) -> int | None:
    """Return how fine the finest of ``states`` is; ``None`` where none says it."""
    return max((state.fine for state in states if state.fine is not None), default=None)


def _spans(own: tuple[str, ...]) -> Iterator[tuple[int, int]]:
    """Yield where each run of the words ``own`` begins and ends that may be a name, the longest runs first.

    A name of a family that stands there only inside a longer one of another is none.
    """
    inside = names_inside(own)
    for length in range(len(own), 0, -1):
        for start in range(len(own) - length + 1):
            if own[start : start + length] not in inside:
                yield start, start + length


def _without(own: tuple[str, ...]) -> tuple[str, ...]:
    """Return the words of a title but those of what it says is not there: "no eggs", "fish-fragrant"; not "no bake"."""
    lacks, does = word_list("says that it is not there"), word_list("is what nobody does")
    gone = {place + 1 for place, word in enumerate(own[:-1]) if word in lacks and own[place + 1] not in does}
    gone |= {place for place, word in enumerate(own[1:]) if word in word_list("is only like what stands before it")}
    return tuple(word for place, word in enumerate(own) if place not in gone)


def tables() -> Tables:
    """Return the shipped tables with what the user's own files add to them.

    Raises ReadError where a file is no table of its form.
    """
    return _tables(os.environ.get(UTENSILS_VARIABLE, ""), os.environ.get(FOODS_VARIABLE, ""))


@lru_cache(maxsize=4)
def _tables(own_utensils: str, own_foods: str) -> Tables:
    return Tables(own_utensils, own_foods)


def _own(path: str, sections: Mapping[str, Mapping[str, str]]) -> Iterator[tuple[str, Toml]]:
    """Yield a user's own table; ReadError where it cannot be read, or what of it is not of the form."""
    if not path:
        return
    import tomllib  # noqa: PLC0415 - few have tables of their own

    try:
        document = tomllib.loads(read_text(Path(path)))
    except (OSError, ValueError) as error:
        raise ReadError(
            f"{path}: the table cannot be read: {error}",
            hint="Take the form of foon_kg/food/utensils.toml or foods.toml; docs/contract.md shows an example.",
        ) from error
    for fault in malformed(document, sections):
        raise refused(path, fault)
    yield path, document
