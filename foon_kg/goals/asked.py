"""What is asked, as every recorded dish is compared with it: worked out once for a recipe."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from foon_kg.food import Tables, is_unbaked, words
from foon_kg.food.bites import is_eaten_by_bites
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import Dish
from foon_kg.goals.names import is_baked, made_of_verb
from foon_kg.integration.joining.batters import is_of_batter, is_of_dough
from foon_kg.integration.preparing.preparation import Want, owed
from foon_kg.model.values import made_often
from foon_kg.world.becoming import Together, meets

CARRIES = word_list("a dish is built on")
SEASONS = word_list("only seasons")
_BASES = ("dough", *sorted(word_list("carries what is stacked")))
_WORKED_IN = word_list("is worked in")
_FLESH = word_list("is flesh")
_COARSE = word_list("keeps apart raw")
_HOLDS = word_list("holds what is shaped")
_BLENDED = word_list("is called blended")
_SMOOTH = word_list("may be blended") | _BLENDED

_WAYS_OF_MAKING = frozenset({"blend", "dry", "fat", "knead", "liquid", "mash", "whip"})
"""Of what motions do (:class:`~foon_kg.food.rows.Motion`) that which tells a baked dish from a fried or a pureed one.

Cutting, mixing and heating are done to nearly every dish, and tell none from another.
"""

_CARRIES, _PLAIN, _SEASONS = 2.0, 1.0, 0.4
"""How much a food counts: what a dish is built on or what has to be cooked, any other, and what only seasons it.

Three seasonings that find their place must not make up for a chicken that finds none.
"""


def weight(want: Want, known: Tables) -> float:
    """Return how much the food ``want`` matters to a dish, by the tables ``known``: 2.0, 1.0 or 0.4."""
    if want.facts.is_any(CARRIES) or is_due(want, known):
        return _CARRIES
    return _SEASONS if want.facts.is_any(SEASONS) else _PLAIN


def is_due(want: Want, known: Tables) -> bool:
    """Return whether somebody still has to cook the food ``want`` before it is served, by the tables ``known``."""
    return not owed(want, known).isdisjoint({"cook", "boil"})


@made_often()
class AskedFood:
    """A food of a recipe, how much it matters (:func:`weight`), and what else decides which dish it may join.

    ``carries``: a dish is built on it. ``due``: it has to be cooked. ``base``: others are laid on it. ``ready_flesh``:
    it is flesh that needs no cooking (ham). ``runs``: it runs off with the water in which others are boiled.
    ``worked_in``: it may be kneaded or shaped with the rest. ``in_pieces``: it is asked cut, and is no spice or stock.
    ``keeps_apart``: raw flesh in pieces, of which nothing can be shaped; ``holds``: it holds what is shaped together.
    """

    want: Want
    weight: float
    carries: bool
    due: bool
    base: bool
    flesh: bool
    ready_flesh: bool
    runs: bool
    worked_in: bool
    in_pieces: bool
    keeps_apart: bool
    holds: bool

    @classmethod
    def of(cls, want: Want, known: Tables) -> AskedFood:
        """Return what the tables ``known`` say of ``want``, one food that is asked."""
        is_a, is_any = want.facts.is_a, want.facts.is_any
        flesh = is_any(_FLESH)
        return cls(
            want,
            weight(want, known),
            carries=is_any(CARRIES),
            due=is_due(want, known),
            base=is_any(_BASES),
            flesh=flesh,
            ready_flesh=flesh and is_a("ready"),
            runs=is_a("liquid", "creamy", "egg") and not is_a("water", "fat"),
            worked_in=is_any(_WORKED_IN),
            in_pieces=known.state(want.asked).fineness > 0 and not is_a("spice", "stock"),
            keeps_apart=flesh and is_any(_COARSE) and not is_any(_HOLDS) and not says(words(want.asked), "is ground"),
            holds=is_any(_HOLDS),
        )


class Asked:
    """A recipe: its foods, the dish type and the title, with what they say of how the dish is made."""

    def __init__(self, wants: Sequence[Want], dish_type: str, title: str, known: Tables) -> None:
        self.wants = tuple(wants)
        self.dish_type, self.title, self.known = dish_type, title, known
        self.title_words = words(title)
        self.type_words = words(dish_type)
        self.unbaked = is_unbaked(title)  # "no-bake": it sets in the cold instead
        self.dishes: tuple[Dish, ...] = known.dishes_named(dish_type, title)
        self.of_type: tuple[Dish, ...] = known.dishes_named(dish_type)
        self.stacked = any(dish.stacked for dish in self.dishes)
        self.grilled = any(dish.grilled for dish in self.dishes)
        self.laid = any(dish.laid for dish in self.dishes)
        self.dressed = any(dish.dressed for dish in self.dishes)
        self.tin = any(dish.tin for dish in self.dishes)
        self.smooth = not _SMOOTH.isdisjoint((*self.type_words, *self.title_words))
        self.of_batter = self.tin and is_of_batter(self.wants)
        self.of_dough = self.tin and is_of_dough(self.wants)
        # each of the frames that are looked at asks for the same few needs and kinds again
        self._met: dict[str, bool] = {}
        self._is_there: dict[str, bool] = {}

    @cached_property
    def named_unbaked(self) -> bool:
        """Whether a word of its name makes it another dish than its type, and one that is not baked: a pancake."""
        return any(dish.is_no and not dish.baked and not dish.is_type for dish in self.dishes)

    @cached_property
    def not_called_hot(self) -> bool:
        """Whether neither its type nor a grill says that it is hot."""
        return not self.grilled and not any(dish.heated for dish in self.of_type)

    @cached_property
    def foods(self) -> tuple[AskedFood, ...]:
        """What is known of its foods, in their order."""
        return tuple(AskedFood.of(want, self.known) for want in self.wants)

    @cached_property
    def by_bites(self) -> bool:
        """Whether it is eaten with a spoon or fork alone."""
        return is_eaten_by_bites((*self.type_words, *self.title_words), self.dishes)

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
        return self.dressed and not says(self.title_words, "is eaten warm")

    @cached_property
    def in_a_pan(self) -> bool:
        """Whether the title says that the dish is cooked in a pan, and the type does not say that it is baked."""
        named = says(self.title_words, "is cooked in a pan")
        return named and not is_baked(self.dish_type, "", self.known)

    @cached_property
    def is_cut_when_baked(self) -> bool:
        """Whether the title says that the dish is cut once it is baked."""
        return says(self.title_words, "is cut when it is baked")

    @cached_property
    def kinds(self) -> frozenset[str]:
        """The kinds of its foods."""
        return frozenset(want.facts.kind for want in self.wants)

    @cached_property
    def ways(self) -> tuple[frozenset[str], ...]:
        """For each word of the title that says how a dish is made (pureed, fried) what is done so: one suffices."""
        found = []
        for word in self.title_words:
            if word in _BLENDED:
                found.append(frozenset({"blend"}))
            if word in self.known.states:
                rows = (row for row in made_of_verb(word, self.known) if word in row.gives)
                found.append(frozenset().union(*(row.does for row in rows)) & _WAYS_OF_MAKING)
        return tuple(way for way in found if way)

    @cached_property
    def telling_words(self) -> frozenset[str]:
        """The words of the title that say how the dish is made (fried) or of which asked food (tomato)."""
        foods = {word for want in self.wants for word in words(want.label)}
        return frozenset(word for word in self.title_words if word in foods or word in self.known.states)

    @cached_property
    def explained_words(self) -> frozenset[str]:
        """The words that title, type and foods explain where a goal is called by them."""
        found = {*self.title_words, *self.type_words}
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

    @cached_property
    def _together(self) -> Together:
        return Together([want.facts for want in self.wants], self.known)

    def has(self, need: str) -> bool:
        """Return whether one of its foods is what a dish needs: ``need`` is one of the names in a dish's ``needs``."""
        found = self._met.get(need)
        if found is None:
            found = self._met[need] = self._together.meet(need)
        return found

    def has_a(self, name: str) -> bool:
        """Return whether one of its foods is of the kind ``name``, has it as a trait, or is called so."""
        found = self._is_there.get(name)
        if found is None:
            found = self._is_there[name] = any(want.facts.is_a(name) for want in self.wants)
        return found
