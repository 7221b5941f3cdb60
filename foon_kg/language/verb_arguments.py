"""The arguments of a verb: its objects, and what prepositions say of places, tools, origins and results."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from foon_kg.food.lists import word_list
from foon_kg.language.nouns import as_result, plural
from foon_kg.model.narration import Mention, Place
from foon_kg.plans.kitchen import Kitchen
from foon_kg.similarity.states import state_in

TO = frozenset({"in", "into", "on", "onto", "to", "over", "inside", "under", "at", "among", "between"})
"""Prepositions that say where something goes."""

_FROM = frozenset({"from", "off"})
_WITH = frozenset({"with", "using"})
_COVERED_BY = word_list("covers with")
_SHAPES = word_list("shapes")

AT_HAND = Place("into", "it")
"""Where a thing goes that is mixed in, or with."""
ON_HAND = Place("on", "it")
"""Where a thing goes with which what is at hand is covered."""


@dataclass
class VerbArguments:
    """What stands around a verb: its objects, and what the prepositions say."""

    direct: list[Mention] = field(default_factory=list)
    places: list[Place] = field(default_factory=list)
    used: list[Mention] = field(default_factory=list)
    results: list[str] = field(default_factory=list)
    origin: str | None = None

    def add(self, word: str, names: list[Mention]) -> None:
        """Take in what one preposition says: ``word`` is the preposition, ``names`` what it governs."""
        shapes = [name for name in names if last_word(name).lower() in _SHAPES | set(map(plural, _SHAPES))]
        if word in {"into", "in", "to"} and shapes:
            self.results += filter(None, (state_in(last_word(name)) for name in shapes))
        elif word in TO:
            self._go_to(word, names)
        elif word in _FROM and names:
            self.origin = names[0].name
        elif word in _WITH:
            self.used += names

    def _go_to(self, word: str, names: Sequence[Mention]) -> None:
        """Take in where something goes, or what it becomes: into the bowl, into cubes."""
        result = as_result(names[0].name) if word == "into" and len(names) == 1 else None
        if result:
            self.results.append(result)
        else:
            self.places += [Place(word, name.name) for name in names]

    def settle(self, verb: str, particle: str) -> tuple[str, ...]:
        """Return the tools among what is used; what else is used is covered with, mixed in or an object.

        ``verb`` and ``particle`` are those of the action, as in "stir" and "in".
        """
        kitchen = Kitchen.default()
        tools = tuple(name.name for name in self.used if kitchen.is_utensil(name.name))
        foods = [name for name in self.used if name.name not in tools]
        if foods and verb in _COVERED_BY:
            self._cover_with(foods)
        elif foods:
            self._work_in(foods)
        if particle in {"in", "through"} and self.direct:  # stir in the eggs
            self._go_to_what_is_at_hand()
        return tools

    def _work_in(self, foods: list[Mention]) -> None:
        """Make ``foods`` objects, too; by themselves they go to what is at hand: "toss with the dressing"."""
        if not self.direct:
            self._go_to_what_is_at_hand()
        self.direct += foods

    def _go_to_what_is_at_hand(self) -> None:
        """Note what is at hand as the place, where no other one is told."""
        if not self.places:
            self.places.append(AT_HAND)

    def _cover_with(self, foods: list[Mention]) -> None:
        """Make ``foods`` the objects, and what were objects the places: "brush the loaf with the egg"."""
        on = [Place("on", name.name) for name in self.direct]
        if not on and not self.places:
            on = [ON_HAND]
        self.places[:0] = on
        self.direct = foods


def last_word(name: Mention) -> str:
    """Return the noun at the end of a name: the bowl of a large bowl."""
    return name.name.split()[-1]
