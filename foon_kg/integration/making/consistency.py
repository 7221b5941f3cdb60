"""How foods hold together as they are: whether they run, lie loose, are poured, or are moved in one piece."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from foon_kg.food import Food, Tables, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import CHOPPED
from foon_kg.integration.bench import Stuff, fineness, is_baked, is_heated
from foon_kg.integration.joining.batters import binds
from foon_kg.integration.teaching.forms import form_of
from foon_kg.world.running import is_runny

_DRY = word_list("coats dry")
_BINDS = (_DRY | word_list("coats wet")) - word_list("is a sauce around flesh")
_COATING = _DRY | word_list("coats wet") | word_list("clings to what is coated")
_HOLDS = word_list("holds a mixture together")

SOLID = word_list("keeps its shape") | word_list("is one piece when it is done")
"""In these states a mixture is one piece, whatever it is made of."""


# --- what runs ---


def is_wet(stuff: Stuff, known: Tables) -> bool:
    """Return whether ``stuff``, a mixture, runs by the tables ``known``: it has liquid that was not baked away."""
    if not stuff.mixed or says(stuff.states, "keeps its shape"):
        return False
    if is_runny(stuff.label, stuff.states, stuff.foods, known):
        return True
    foods = [known.foods.food(food) for food in stuff.foods]
    if not is_baked(stuff) and _stays_liquid(stuff, foods):
        return True
    if is_heated(stuff.states, known):
        return not _has_set(stuff, foods, known) and _has_liquid_left(foods)
    return any(food.is_a(*word_list("makes a mixture wet")) for food in foods)


def _stays_liquid(stuff: Stuff, foods: Sequence[Food]) -> bool:
    """Whether a mixture of ``foods`` runs until it is baked, however long it is cooked."""
    return _is_in_liquid(foods) or _is_a_sauce(foods) or _is_melted(stuff, foods)


def _is_in_liquid(foods: Sequence[Food]) -> bool:
    return any(f"kind:{food.kind}" in word_list("stays liquid") for food in foods)


def _is_a_sauce(foods: Sequence[Food]) -> bool:
    """Whether foods make a sauce that flour only thickens: a liquid, and nothing that is solid in it or sets."""
    if not any(food.is_a("cooking liquid") for food in foods):
        return False
    parts = word_list("is in what only gets thick")
    return all(food.is_any(parts) and not food.is_a("dough", "egg", "leaven") for food in foods)


def _is_melted(stuff: Stuff, foods: Sequence[Food]) -> bool:
    """Whether a mixture is hot fat with what only seasons it."""
    hot = "cooked" in stuff.states or (stuff.at is not None and stuff.at.hot)
    seasoned = all(food.is_any(word_list("runs with melted fat")) for food in foods)
    return hot and seasoned and any(food.is_a("fat") for food in foods)


def _has_set(stuff: Stuff, foods: Sequence[Food], known: Tables) -> bool:
    """Whether what ran is solid now that it was heated: what only thickens a sauce on a stove sets nothing."""
    if _is_braised(stuff, known):
        return False
    if _is_baked_firm(stuff, known) or any(food.is_a("egg", "dough", "leaven") for food in foods):
        return True
    thickened = not is_baked(stuff) and any(food.kind in word_list("is a sauce around flesh") for food in foods)
    return not thickened and any(food.is_a("flour") for food in foods)


def _is_baked_firm(stuff: Stuff, known: Tables) -> bool:
    """Whether a mixture was baked or steamed, and something in it bound the rest."""
    if not is_baked(stuff):
        return False
    steamed = "baked" not in stuff.states
    swells = steamed and any(
        known.foods.food(food).is_any(word_list("sets when it is steamed")) for food in stuff.foods
    )
    return swells or (binds(stuff.foods, known) and not _is_braised(stuff, known))


def _is_braised(stuff: Stuff, known: Tables) -> bool:
    """Whether a mixture is pieces in a liquid that is only thickened, be it in an oven: nothing binds all of it.

    In a tin it is a batter.
    """
    row = None if stuff.at is None else known.utensil(stuff.at.label)
    if row is not None and row.group == "tins":
        return False
    foods = [known.foods.food(food) for food in stuff.foods]
    pieces = any(food.is_any(word_list("is stewed in pieces")) for food in foods)
    bound = any(food.is_any(word_list("binds what is stewed")) for food in foods)
    return pieces and not bound and any(food.is_of(*word_list("is stewed in")) for food in foods)


def _has_liquid_left(foods: Sequence[Food]) -> bool:
    """Whether foods that were cooked have liquid around them: fat that clings to flesh is no sauce."""
    fried = any(food.is_any(word_list("is coated")) for food in foods)
    return any(food.is_a("liquid", "creamy") and not (fried and food.is_a("fat")) for food in foods)


def is_loose_in_liquid(stuff: Stuff, known: Tables) -> bool:
    """Return whether ``stuff`` is a mixture in a liquid that does not set, by the tables ``known``.

    Fat alone is no such liquid, egg or flour sets it.
    """
    foods = [known.foods.food(food) for food in stuff.foods]
    runs = any(food.is_a("liquid", "creamy") and not food.is_a("fat") for food in foods)
    return stuff.mixed and runs and not says(stuff.states, "keeps its shape") and not _has_set(stuff, foods, known)


def is_liquid_or_soft(stuff: Stuff, known: Tables) -> bool:
    """Return whether ``stuff`` runs or is scooped, by the tables ``known``."""
    alone = stuff.foods[0] if len(stuff.foods) == 1 and stuff.label in word_list("called a mixture") else stuff.label
    return form_of(known, alone, stuff.states) in {"liquid", "soft"}


# --- what is moved in one piece, and what is not ---


def form_together(stuffs: Sequence[Stuff], known: Tables, *, whole: bool) -> str:
    """Return how ``stuffs`` are moved out of their vessel at once: as ``liquid``, as ``pieces``, or ``whole``.

    ``known`` are the tables; ``whole``: they are one piece, whatever they look like.
    """
    if whole or is_shaped(stuffs, known):
        return "whole"
    if len(stuffs) > 1 or any(_runs(stuff, known) for stuff in stuffs):
        return "liquid"
    return "whole" if stuffs[0].mixed and not _is_loose(stuffs[0], known) else "pieces"


def _runs(stuff: Stuff, known: Tables) -> bool:
    if stuff.mixed and _is_baked_firm(stuff, known):
        return False  # whatever it is called: a pudding, an omelette
    stirred = _is_stirred_in_pot(stuff, known) or _lies_in_sauce(stuff, known)
    return is_liquid_or_soft(stuff, known) or is_wet(stuff, known) or stirred


def _is_stirred_in_pot(stuff: Stuff, known: Tables) -> bool:
    """Whether a mixture was stirred in a deep pot, in which nothing sets in one piece."""
    return stuff.mixed and _is_in_pot(stuff, known) and not is_uncut(stuff, known)


def _is_in_pot(stuff: Stuff, known: Tables) -> bool:
    row = None if stuff.at is None else known.utensil(stuff.at.label)
    return row is not None and row.group == "pots"


def _lies_in_sauce(stuff: Stuff, known: Tables) -> bool:
    """Whether a mixture was cooked in a deep pot, or stirred in a pan, with what gives a sauce."""
    if not stuff.mixed or not SOLID.isdisjoint(stuff.states) or is_baked(stuff):
        return False
    foods = [known.foods.food(food) for food in stuff.foods]
    if not is_heated(stuff.states, known) or not any(map(_gives_a_sauce, foods)):
        return False
    return _is_in_pot(stuff, known) or ("mixed" in stuff.states and not _has_set(stuff, foods, known))


def _gives_a_sauce(food: Food) -> bool:
    return food.is_any(word_list("gives a sauce")) and not food.is_a("fat")


def is_shaped(stuffs: Sequence[Stuff], known: Tables) -> bool:
    """Return whether one of ``stuffs`` has a form of its own by the tables ``known``.

    So has flesh in one piece with nothing around it that runs.
    """
    if any(says(stuff.states, "keeps its shape") for stuff in stuffs):
        return True
    solids = [stuff for stuff in stuffs if stuff.mixed or not known.foods.food(stuff.label).is_a("fat")]
    alone = len(solids) == 1 or not any(_runs(stuff, known) for stuff in stuffs)
    return alone and any(is_uncut(stuff, known) for stuff in solids)


def is_uncut(stuff: Stuff, known: Tables) -> bool:
    """Return whether ``stuff`` is flesh that nobody cut, by the tables ``known``, and no stew that is called by it."""
    if stuff.mixed and _is_cut_in_liquid([known.foods.food(food) for food in stuff.foods]):
        return False
    if _lies_in_sauce(stuff, known):
        return False
    if _is_breaded(stuff, known) or (not stuff.mixed and {"baked", "whole"} <= set(stuff.states)):
        return True
    facts = known.foods.food(stuff.label)
    flesh = facts.is_any(word_list("is coated")) and not facts.is_any(word_list("patties are made of"))
    return flesh and fineness(stuff.states, known) == 0


def _is_cut_in_liquid(foods: Sequence[Food]) -> bool:
    """Whether foods are in a liquid that stays so, or in milk that makes no crust, or all flesh comes in mouthfuls."""
    dairy = any(food.kind in word_list("is a sauce around flesh") for food in foods)
    braised = _is_in_liquid(foods) or (dairy and not any(food.is_any(_BINDS) for food in foods))
    return braised or _comes_in_mouthfuls([food for food in foods if food.is_any(word_list("is coated"))])


def _comes_in_mouthfuls(flesh: Sequence[Food]) -> bool:
    """Whether all ``flesh`` does, whatever is cut small beside it."""
    main = [food for food in flesh if not food.is_any(word_list("is cut small beside flesh"))]
    return all(food.is_any(word_list("is a mouthful")) for food in main or flesh)


def _is_breaded(stuff: Stuff, known: Tables) -> bool:
    """Whether a mixture is one food that comes in portions, with what it was turned in."""
    flesh = {name for name in stuff.foods if known.foods.food(name).is_any(word_list("is coated"))}
    coats = [known.foods.food(name) for name in stuff.foods if name not in flesh]
    portion = len(flesh) == 1 and says(words(*flesh), "is a portion")
    return stuff.mixed and portion and _are_dry_coats(coats)


def _are_dry_coats(foods: Sequence[Food]) -> bool:
    """Whether foods are what another one is turned in, something dry among them."""
    return all(food.is_any(_COATING) for food in foods) and any(food.is_any(_DRY) for food in foods)


def _is_loose(stuff: Stuff, known: Tables) -> bool:
    """Whether a mixture is of dry foods, or of what stays loose when it is cooked, that nothing holds together."""
    foods = [known.foods.food(food) for food in stuff.foods]
    shaped = not SOLID.isdisjoint(stuff.states)
    if not shaped and any(food.is_any(word_list("stays loose")) for food in foods):
        return True
    if is_heated(stuff.states, known):
        return False
    if not shaped and not any(food.is_any(_HOLDS) for food in foods):
        return not {form_of(known, food.name, ()) for food in foods}.isdisjoint({"pieces", "whole"})
    return _is_powder(stuff, foods, known)


def _is_powder(stuff: Stuff, foods: Sequence[Food], known: Tables) -> bool:
    """Whether a mixture has powder in it, and nothing that makes a paste of that."""
    holds = any(food.is_a("creamy", "dough", "egg", "fat", "liquid", "water") for food in foods)
    return not holds and any(form_of(known, food, ()) == "powder" for food in stuff.foods)


@lru_cache(maxsize=1 << 14)
def is_laid(known: Tables, label: str, states: tuple[str, ...], *, flat: bool) -> bool:
    """Return whether a food called ``label`` in ``states`` comes somewhere piece by piece, by the tables ``known``.

    What lies in one piece does, and slices onto what is ``flat``.
    """
    if known.foods.food(label, states).is_any(word_list("carries what is stacked")):
        return True
    if says(states, "lies in one piece"):
        return True
    solid = form_of(known, label, states) in {"pieces", "whole"}
    return flat and solid and not is_poured(known, label, states)


@lru_cache(maxsize=1 << 14)
def is_poured(known: Tables, label: str, states: tuple[str, ...]) -> bool:
    """Return whether nobody picks up a food called ``label`` in ``states`` piece by piece: it runs, or is small.

    ``known`` are the tables.
    """
    form = form_of(known, label, states)
    if form in {"liquid", "powder"} or fineness(states, known) >= CHOPPED:
        return True
    loose = known.foods.food(label, states).is_any(word_list("lies loose"))
    return loose and not says(states, "lies in one piece") and form in {"pieces", "whole"}
