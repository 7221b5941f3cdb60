"""What is asked, as every recorded dish is compared with it: worked out once for a recipe."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from foon_kg.food import Tables, is_unbaked, words
from foon_kg.food.bites import is_eaten_by_bites
from foon_kg.food.lists import word_list
from foon_kg.food.rows import Dish
from foon_kg.goals.names import is_baked, made_of_verb
from foon_kg.integration.joining.batters import is_of_batter, is_of_dough
from foon_kg.integration.preparing.preparation import Want, owed
from foon_kg.world.becoming import meets

CARRIES = word_list("a dish is built on")
SEASONS = word_list("only seasons")
_BAKED_ON = ("dough", *sorted(word_list("carries what is stacked")))
_WORKED_IN = word_list("is worked in")
_FLESH = word_list("is flesh")
_BLENDED = word_list("is called blended")
_SMOOTH = word_list("may be blended") | _BLENDED

_MEANS = frozenset({"blend", "dry", "fat", "knead", "liquid", "mash", "whip"})
"""What tells ways of making a dish from each other."""


def weight(want: Want, known: Tables) -> float:
    """Return how much the food ``want`` matters to a dish, by the tables ``known``.

    2 is what a dish is built on or what has to be cooked, 0.4 what only seasons it, 1 the rest.
    """
    if want.facts.is_a(*CARRIES) or is_due(want, known):
        return 2.0
    return 0.4 if want.facts.is_a(*SEASONS) else 1.0


def is_due(want: Want, known: Tables) -> bool:
    """Return whether somebody still has to cook the food ``want`` before it is served, by the tables ``known``."""
    return not owed(want, known).isdisjoint({"cook", "boil"})


@dataclass(frozen=True)
class AskedFood:
    """A food of a recipe, how much it matters (``weight``), and what else decides where it may join.

    ``carries``: a dish is built on it. ``due``: it has to be cooked. ``base``: others are laid on it. ``done``: it is
    flesh that needs no cooking. ``runs``: it runs off with the water. ``in_pieces``: it is asked cut, and is no powder.
    """

    want: Want
    weight: float
    carries: bool
    due: bool
    base: bool
    flesh: bool
    done: bool
    runs: bool
    worked_in: bool
    in_pieces: bool

    @classmethod
    def of(cls, want: Want, known: Tables) -> AskedFood:
        """Return what the tables ``known`` say of ``want``, one food that is asked."""
        is_a = want.facts.is_a
        flesh = is_a(*_FLESH)
        fine = (known.state(want.asked).fine or 0) if want.asked else 0
        return cls(
            want,
            weight(want, known),
            carries=is_a(*CARRIES),
            due=is_due(want, known),
            base=is_a(*_BAKED_ON),
            flesh=flesh,
            done=flesh and is_a("ready"),
            runs=is_a("liquid", "creamy", "egg") and not is_a("water", "fat"),
            worked_in=is_a(*_WORKED_IN),
            in_pieces=fine > 0 and not is_a("spice", "stock"),
        )


class Asked:
    """A recipe: its foods, the dish type and the title, with what they say of how the dish is made."""

    def __init__(self, wants: Sequence[Want], dish_type: str, title: str, known: Tables) -> None:
        self.wants = tuple(wants)
        self.dish_type, self.title, self.known = dish_type, title, known
        self.told = words(title)
        self.type_words = words(dish_type)
        self.unbaked = is_unbaked(title)
        self.dishes: tuple[Dish, ...] = known.dishes_named(dish_type, title)
        self.of_type: tuple[Dish, ...] = known.dishes_named(dish_type)
        self.stacked = any(dish.stacked for dish in self.dishes)
        self.grilled = any(dish.grilled for dish in self.dishes)
        self.laid = any(dish.laid for dish in self.dishes)
        self.dressed = any(dish.dressed for dish in self.dishes)
        self.tin = any(dish.tin for dish in self.dishes)
        self.smooth = not _SMOOTH.isdisjoint((*self.type_words, *self.told))
        self.of_batter = self.tin and is_of_batter(self.wants)
        self.of_dough = self.tin and is_of_dough(self.wants)
        self._met: dict[str, bool] = {}
        self._is_there: dict[str, bool] = {}

    @cached_property
    def flat(self) -> bool:
        """Whether it is called something that is not what its type is, and that is not baked."""
        return any(dish.is_no and not dish.baked and not dish.is_type for dish in self.dishes)

    @cached_property
    def cold(self) -> bool:
        """Whether neither its type nor a grill says that it is hot."""
        return not self.grilled and not any(dish.heated for dish in self.of_type)

    @cached_property
    def foods(self) -> tuple[AskedFood, ...]:
        """What is known of its foods, in their order."""
        return tuple(AskedFood.of(want, self.known) for want in self.wants)

    @cached_property
    def by_bites(self) -> bool:
        """Whether it is eaten with a spoon or fork alone."""
        return is_eaten_by_bites((*self.type_words, *self.told), self.dishes)

    @cached_property
    def weight(self) -> float:
        """How much all its foods matter together."""
        return sum(food.weight for food in self.foods)

    @cached_property
    def baked(self) -> bool:
        """Whether the dish is called so that it comes out of an oven."""
        return is_baked(self.dish_type, self.title, self.known)

    @cached_property
    def is_eaten_cold(self) -> bool:
        """Whether a dressing comes over it, and the title does not say that it is warm."""
        return self.dressed and word_list("is eaten warm").isdisjoint(self.told)

    @cached_property
    def in_a_pan(self) -> bool:
        """Whether the title says that the dish is cooked in a pan, and the type does not say that it is baked."""
        named = not word_list("is cooked in a pan").isdisjoint(self.told)
        return named and not is_baked(self.dish_type, "", self.known)

    @cached_property
    def is_cut_when_baked(self) -> bool:
        """Whether the title says that the dish is cut once it is baked."""
        return not word_list("is cut when it is baked").isdisjoint(self.told)

    @cached_property
    def kinds(self) -> frozenset[str]:
        """The kinds of its foods."""
        return frozenset(want.facts.kind for want in self.wants)

    @cached_property
    def ways(self) -> tuple[frozenset[str], ...]:
        """What is done to a dish (one of each suffices) that is made as a word of the title says: pureed, fried."""
        found = []
        for word in self.told:
            if word in _BLENDED:
                found.append(frozenset({"blend"}))
            if word in self.known.states:
                rows = (row for row in made_of_verb(word, self.known) if word in row.gives)
                found.append(frozenset().union(*(row.does for row in rows)) & _MEANS)
        return tuple(way for way in found if way)

    @cached_property
    def said(self) -> frozenset[str]:
        """The words of the title that say how the dish is made (fried) or of which asked food (tomato)."""
        foods = {word for want in self.wants for word in words(want.label)}
        return frozenset(word for word in self.told if word in foods or word in self.known.states)

    @cached_property
    def explained(self) -> frozenset[str]:
        """The words that title, type and foods explain where a goal is called by them."""
        found = {*self.told, *self.type_words}
        for want in self.wants:
            found |= {*want.facts.name.split(), *want.facts.taken_for.split(), want.facts.kind, *want.facts.kinds}
        return frozenset(found)

    @cached_property
    def food_words(self) -> frozenset[str]:
        """The words by which its foods are called."""
        texts = (text for want in self.wants for text in (want.facts.name, want.facts.taken_for))
        return frozenset(word for text in texts for word in text.split())

    @cached_property
    def defining(self) -> tuple[tuple[int, ...], ...]:
        """For each need of the dish type, the places of the foods that meet it: the egg of an omelette."""
        return tuple(
            tuple(
                place
                for place, want in enumerate(self.wants)
                if any(meets(need, want.facts, self.known) for need in needs)
            )
            for dish in self.of_type
            for needs in dish.needs
        )

    def has(self, need: str) -> bool:
        """Whether one of its foods is what a dish needs."""
        found = self._met.get(need)
        if found is None:
            found = self._met[need] = any(meets(need, want.facts, self.known) for want in self.wants)
        return found

    def has_a(self, name: str) -> bool:
        """Return whether one of its foods is of the kind ``name``, has it as a trait, or is called so."""
        found = self._is_there.get(name)
        if found is None:
            found = self._is_there[name] = any(want.facts.is_a(name) for want in self.wants)
        return found
