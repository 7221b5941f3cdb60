"""What can become of what: which outputs are products, and whether what went in can make them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache

from foon_kg.food import Food, Tables, words
from foon_kg.world.reading import NodeReading
from foon_kg.world.things import Lump


def is_product(known: Tables, one: NodeReading) -> bool:
    """Return whether ``one``, a food output, is something that is made of foods: a dish, a dough, a dressing.

    ``known`` are the tables that say so of its name.
    """
    return len(one.names - {one.label}) > 1 or known.foods.food(one.label, one.node.states).is_a("made", "dough")


def can_become(known: Tables, one: NodeReading, sources: Sequence[Lump]) -> bool:
    """Return whether ``sources`` can make what ``one``, a food output, says.

    A product needs what its name promises (dough: flour or its like); a plain food comes only of itself, by any name
    that shares a word with it (lemon juice of lemon), of something of its kind, or of what it is a part of (an egg's
    white). The tables ``known`` tell kinds and parts.
    """
    parts = [part.food for lump in sources for part in lump.parts]
    if not parts or not _has_all_it_needs(one.label, parts, known):
        return False
    facts = known.foods.food(one.label, one.node.states)
    if _may_come_of_anything(one, facts, known) or _shares_a_word(one.label, parts, sources):
        return True
    return any(food.kind == facts.kind or food.kind in facts.kinds or facts.kind in food.kinds for food in parts)


def _may_come_of_anything(one: NodeReading, facts: Food, known: Tables) -> bool:
    """Whether nothing is known of what a food comes of, except what its name needs: a product, a rest, an unknown."""
    if one.names or one.remains or not facts.known or one.label in known.contains:
        return True
    return facts.is_a("remains") or is_product(known, one)


def _has_all_it_needs(label: str, parts: Sequence[Food], known: Tables) -> bool:
    return all(_has_one(needs, parts, known) for needs in known.contains.get(label, ()))


def _has_one(needs: Iterable[str], parts: Sequence[Food], known: Tables) -> bool:
    return any(meets(need, food, known) for need in needs for food in parts)


def _shares_a_word(label: str, parts: Sequence[Food], sources: Sequence[Lump]) -> bool:
    own = set(words(label))
    return any(own & set(food.name.split()) for food in parts) or any(own & name for name in _names(sources))


def _names(sources: Sequence[Lump]) -> list[set[str]]:
    return [set(name.split()) for lump in sources for name in lump.names]


@lru_cache(maxsize=1 << 17)  # every need of a dish is asked of every food in it, in each tree that is tried
def meets(need: str, food: Food, known: Tables) -> bool:
    """Return whether ``food`` is what a table's ``need`` says: ``kind:x``, ``trait:x``, a kind, or a word of its name.

    ``known`` says which words are kinds.
    """
    return Together([food], known).meet(need)


class Together:
    """Several ``foods``, of which it is asked at once whether one of them is what a need says, as :func:`meets` asks.

    The tables ``known`` say which words are kinds.
    """

    def __init__(self, foods: Sequence[Food], known: Tables) -> None:
        self._kinds = known.foods.kinds
        self._names = [frozenset(food.name.split()) for food in foods]
        self._words = frozenset[str]().union(*self._names)
        self._of = frozenset[str]().union(*(food.kinds for food in foods))
        self._traits = frozenset[str]().union(*(food.traits for food in foods))
        self._called = {name for food in foods for name in (food.name, food.taken_for)}

    def meet(self, need: str) -> bool:
        """Return whether one of the foods is what ``need`` says."""
        scheme, _, name = need.rpartition(":")
        if scheme == "trait":
            return name in self._traits
        if scheme == "kind" or name in self._kinds:
            return name in self._of or name in self._words
        if name in self._of or name in self._traits or name in self._called:
            return True
        own = name.split()
        return any(words.issuperset(own) for words in self._names)
