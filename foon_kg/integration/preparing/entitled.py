"""What title and type of a dish say of a food that its recipe left out: smoked salmon, mashed potato, grilled chicken.

So they say what a whole food is for: its juice, its flesh off the bone, or one from a can.
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

from foon_kg.food import Tables, singular, words
from foon_kg.food.bites import is_eaten_by_bites, stays_whole
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import POWDER, State
from foon_kg.integration.preparing.preparation import CANNED, JUICE, Want
from foon_kg.integration.teaching.operators import Operators

_BESIDE = "beside"
"""With this word before a kind of food the table of homonyms says what a word means beside such a food."""


def as_entitled(want: Want, title: str, known: Tables, operators: Operators) -> Want:
    """Return ``want`` as the title has it, which says what the recipe left out: smoked salmon, mashed potato.

    ``known`` are the tables, ``operators`` what the FOON shows.
    """
    title_words = words(title)
    if _is_called_mashed(want, title_words):
        return replace(want, then=min(word_list("is mashed so")))
    for before in _before_it(want, title_words):
        if _says_more(before, want, known):
            found = _as_called(want, before, known, operators)
            if found is not None:
                return found
    return want


def _is_called_mashed(want: Want, title_words: Sequence[str]) -> bool:
    """Whether a dish is called so that a food is mashed in it: by a word after its name, or as what covers it."""
    mash, heads = word_list("is mash"), words(want.label)[-1:]
    if any(head in heads and word in mash for head, word in itertools.pairwise(title_words)):
        return True
    covers = says(title_words, "is covered with mash")
    return covers and not want.cooked and want.facts.is_any(word_list("covers a dish when it is mashed"))


def _says_more(before: str, want: Want, known: Tables) -> bool:
    """Whether the word ``before`` the name of a food is a state that neither its recipe nor the dish gives it."""
    if before not in known.states or before in {want.asked, *want.leaf, *word_list("is so by the dish")}:
        return False
    dish = known.dishes.get(f"{before} {words(want.label)[-1]}")
    return dish is None or dish.mashed  # grilled cheese is a sandwich


def _as_called(want: Want, state: str, known: Tables, operators: Operators) -> Want | None:
    """Return a food in a state that a title says: bought, cooked or ground so; ``None`` where it means nothing here."""
    row = known.state(state)
    if is_bought_so(row, state, operators):
        return replace(want, leaf=(state,), bought_so=True)
    if state in word_list("is bought so by the title"):
        return _ready_so(want, state, known)
    return _made_so(want, state, row)


def _made_so(want: Want, state: str, row: State) -> Want | None:
    """Return a food that is cooked or ground to a ``state``, of which ``row`` tells; ``None`` where that cannot be."""
    owes = want.facts.owes
    if row.needs_heat and "cook" in row.earns and not want.cooked and "boil" not in owes:
        make = state if state in word_list("is so by boiling") else ""
        return replace(want, cooked=True, make=want.make or make, roasted=state in word_list("is roasted"))
    return replace(want, then=state) if row.fineness >= POWDER and {"cook", "boil"} & owes.keys() else None


def _ready_so(want: Want, state: str, known: Tables) -> Want | None:
    """Return a food that is bought in a state as what is eaten so; ``None`` for what a cook still has to heat."""
    sold = known.foods.food(want.label, [state])
    if not want.facts.is_any(word_list("is eaten as it is bought by the title")) or "ready" not in sold.traits:
        return None
    return replace(want, facts=sold, leaf=(state,), bought_so=True)


def _before_it(want: Want, title_words: Sequence[str]) -> Iterator[str]:
    """Yield the words of a title before the name of a food, of which the last word is enough there (breast)."""
    own = _without_its_cut(words(want.label))
    for place, word in enumerate(title_words):
        if word not in own[-1:]:
            continue
        first = place
        while first and title_words[first - 1] in own[:-1]:
            first -= 1
        if first:
            yield title_words[first - 1]


def _without_its_cut(name: tuple[str, ...]) -> tuple[str, ...]:
    """Return the words of a food's name but for a last one that says which piece of it: trout fillet."""
    return name[:-1] if name[1:] and name[-1] in word_list("is a piece of one") else name


def is_bought_so(row: State, state: str, operators: Operators) -> bool:
    """Return whether no kitchen of this FOON, by its ``operators``, makes a food ``state``, fit to be eaten so.

    ``row`` is what the tables say of the state.
    """
    return "cook" in row.earns and not row.needs_heat and not any(True for _ in operators.making(state))


def as_in_a_dish(wants: Iterable[Want], operators: Operators, title: str, dish_type: str) -> tuple[Want, ...]:
    """Return ``wants``, the foods of a dish, as such a dish has them: of a whole lemon a cake wants the juice.

    The ``dish_type`` and ``title`` say what dish, ``operators`` what the FOON does with such foods.
    """
    wants, known, title_words = tuple(wants), operators.known, frozenset(words(title))
    pressed = dish_type in word_list("is made with juice") and not says(title_words, "is made with slices")
    bites = is_eaten_by_bites((*words(dish_type), *title_words), known.dishes_named(dish_type, title))

    def meant(want: Want) -> Want:
        other = _by_its_company(want, wants, known)
        if other is not None:
            return other
        if not _is_whole(want, known):
            return _by_its_dish(want, dish_type, known)
        if stays_whole(want.facts, (want.asked,), dish_type):
            return replace(want, left_whole=True)
        if pressed and want.facts.is_any(word_list("is pressed for its juice")) and not want.part:
            return _pressed(want, operators)
        if bites and want.facts.is_any(word_list("is pulled off when it is boiled")):
            return replace(want, then=min(word_list("is so when it is pulled off")))
        return _canned(want, known) if _comes_canned(want, wants, title_words) else want

    return tuple(map(meant, wants))


def _is_whole(want: Want, known: Tables) -> bool:
    return not want.make and not want.then and all(known.state(state).undivided for state in want.leaf)


def _by_its_dish(want: Want, dish_type: str, known: Tables) -> Want:
    """Return a food whose word means something else in such a dish: chips in a soup."""
    place = f"in {dish_type}"
    other = any(state == place for state, _ in known.foods.homonyms.get(singular(want.label), ()))
    return replace(want, facts=known.foods.food(want.label, [place])) if other and not want.make else want


def _by_its_company(want: Want, wants: Collection[Want], known: Tables) -> Want | None:
    """Return a food without a state whose word means something else beside one of ``wants``: soda with flour."""
    usual = want.asked in {"", want.facts.sold_as}  # nobody said more of it than its name
    rows = known.foods.homonyms.get(singular(want.label), ()) if usual else ()
    for state, _ in rows:
        place, _, kind = state.partition(" ")
        if place == _BESIDE and any(other.facts.is_a(kind) for other in wants if other is not want):
            facts = known.foods.food(want.label, [state])
            return replace(want, facts=facts, leaf=(facts.sold_as,), storage=facts.sold_in)
    return None


def _pressed(want: Want, operators: Operators) -> Want:
    """Return a food of which only the juice is used as one that is squeezed, if the FOON shows how."""
    return replace(want, make=JUICE, squeezed=True) if operators.giving.get(JUICE) else want


def _comes_canned(want: Want, wants: Collection[Want], title_words: Collection[str]) -> bool:
    """Whether a food that is too much work for a dish of many others is taken out of a can."""
    basis = word_list("a dish is built on") | word_list("a cold dish is built on")
    others = any(one.facts.is_any(basis) for one in wants)
    own = says(title_words, "is eaten with a knife")
    return others and not own and want.facts.is_any(word_list("is canned for a dish"))


def _canned(want: Want, known: Tables) -> Want:
    facts = known.foods.food(want.label, [CANNED])
    return replace(want, facts=facts, leaf=(CANNED,), storage=facts.sold_in)
