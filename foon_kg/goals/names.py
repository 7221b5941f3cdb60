"""What the names of dishes say: of the asked one its title and type, of the recorded one its goal's."""

from __future__ import annotations

from functools import lru_cache

from foon_kg.food import Tables, words
from foon_kg.food.lists import says
from foon_kg.food.rows import Motion

BY_TITLE, BY_TYPE = 1.0, 0.6
"""How much a goal is called like the dish that is asked: by its title, and by its type alone."""


def named_alike(label: str, dish_type: str, title: str) -> float:
    """Return how much (0 to 1) the goal ``label`` is called like the dish that is asked.

    It is by the ``dish_type``, or better by the ``title``. Of the goal's name its last word has to be in the title,
    which says what the dish is (tomato *soup*); of its type any word does.
    """
    own = words(label)
    if own and own[-1] in words(title):
        return BY_TITLE
    return 0.0 if set(words(dish_type)).isdisjoint(own) else BY_TYPE


def is_baked(dish_type: str, title: str, known: Tables) -> bool:
    """Return whether a dish of ``dish_type`` is called by its ``title`` so that it comes out of an oven: a gratin.

    A soup never does. ``known`` are the tables of dishes and motions.
    """
    told = words(title)
    if says(told, "boils in the dish"):
        return False
    if any(dish.baked for dish in known.dishes_named(dish_type, title)):
        return True
    if says(told, "comes out of an oven"):
        return True
    return any("dry" in row.does for word in told for row in made_of_verb(word, known))


_ENDINGS = frozenset({"", "ed", "en", "es", "ing", "s"})
"""What a form of a verb adds to it: baked, baking, shaken. What else begins like one is another word: chard, smoky."""


@lru_cache(maxsize=1 << 12)
def made_of_verb(word: str, known: Tables) -> tuple[Motion, ...]:
    """Return the motions in the tables ``known`` of whose verb ``word`` is a form: baked of bake, fried of fry."""
    return tuple(row for verb, row in known.motion_words.items() if _is_form_of(word, verb))


def _is_form_of(word: str, verb: str) -> bool:
    """Return whether ``word`` is a regular form of ``verb``: its last letter falls out, changes or is doubled."""
    stems = {verb, verb.removesuffix("e"), verb.removesuffix("y") + "i" if verb.endswith("y") else verb}
    if any(word.startswith(stem) and word[len(stem) :] in _ENDINGS for stem in stems):
        return True
    return word in {f"{verb}{verb[-1]}ed", f"{verb}{verb[-1]}ing"}
