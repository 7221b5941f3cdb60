"""What can become of what: which outputs are products, and whether what went in can make them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import lru_cache

from foon_kg.food import Food, Tables, words
from foon_kg.world.reading import Said
from foon_kg.world.things import Lump

_MADE = ("made", "dough", "remains")


def is_product(known: Tables, one: Said) -> bool:
    """Whether a food output is something that is made of foods: a dish, a dough, a dressing."""
    return len(one.names - {one.label}) > 1 or known.foods.food(one.label, one.node.states).is_a("made", "dough")


def can_become(known: Tables, one: Said, sources: Sequence[Lump]) -> bool:
    """Return whether ``sources`` can make what an output says.

    A product needs what its name promises (dough: flour or its like); a plain food comes only of itself, by any name
    that shares a word with it (lemon juice of lemon), of something of its kind, or of what it is a part of (an egg's
    white).
    """
    parts = [part.food for lump in sources for part in lump.parts]
    if not parts:
        return False
    if not all(_has_one(needs, parts, known) for needs in known.contains.get(one.label, ())):
        return False
    if is_product(known, one) or one.names:
        return True
    facts = known.foods.food(one.label, one.node.states)
    if not facts.known or one.label in known.contains or facts.is_a("remains") or one.remains:
        return True
    if _shares_a_word(one.label, parts, sources):
        return True
    return any(food.kind == facts.kind or food.kind in facts.kinds or facts.kind in food.kinds for food in parts)


def _has_one(needs: Iterable[str], parts: Sequence[Food], known: Tables) -> bool:
    return any(_meets(need, food, known) for need in needs for food in parts)


def _shares_a_word(label: str, parts: Sequence[Food], sources: Sequence[Lump]) -> bool:
    own = set(words(label))
    return any(own & set(food.name.split()) for food in parts) or any(own & name for name in _names(sources))


def _names(sources: Sequence[Lump]) -> list[set[str]]:
    return [set(name.split()) for lump in sources for name in lump.names]


@lru_cache(maxsize=1 << 17)
def _meets(need: str, food: Food, known: Tables) -> bool:
    """Return whether a food is what a table asks for: ``kind:x``, ``trait:x``, a kind, or a word of its name."""
    scheme, _, name = need.rpartition(":")
    if scheme == "trait":
        return name in food.traits
    if scheme == "kind" or name in known.foods.kinds:
        return name in food.kinds or name in food.name.split()
    return food.is_a(name) or set(name.split()) <= set(food.name.split())


meets = _meets
