"""What the title of a dish says of a food that its recipe left out: smoked salmon, mashed potato, grilled chicken."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import replace

from foon_kg.food import Tables, words
from foon_kg.food.lists import word_list
from foon_kg.food.rows import State
from foon_kg.integration.preparing.preparation import JUICE, POWDER, Want
from foon_kg.integration.teaching.operators import Operators


def as_pressed(want: Want, known: Tables, operators: Operators) -> Want:
    """Return a whole food of which only the juice is used as one that is squeezed, unless it is for garnish."""
    is_whole = not want.make and all(known.state(state).undivided for state in want.leaf)
    pressed = (
        want.facts.is_a(*word_list("is pressed for its juice")) and not want.part and bool(operators.giving.get(JUICE))
    )
    return replace(want, make=JUICE, squeezed=True) if pressed and is_whole else want


def as_entitled(want: Want, title: str, known: Tables, operators: Operators) -> Want:
    """Return a food as the title has it, which says what the recipe left out: smoked salmon, mashed potato."""
    told = words(title)
    if _is_called_mashed(want, told):
        return replace(want, then=min(word_list("is mashed so")))
    for before in _before_it(want, told):
        if _says_more(before, want, known):
            found = _as_called(want, before, known, operators)
            if found is not None:
                return found
    return want


def _is_called_mashed(want: Want, told: Sequence[str]) -> bool:
    """Whether a dish is called so that a food is mashed in it: by a word after its name, or as what covers it."""
    mash, heads = word_list("is mash"), words(want.label)[-1:]
    if any(head in heads and word in mash for head, word in itertools.pairwise(told)):
        return True
    covers = not word_list("is covered with mash").isdisjoint(told)
    return covers and not want.cooked and want.facts.is_a(*word_list("covers a dish when it is mashed"))


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
    owes = want.facts.owes
    if row.needs_heat and "cook" in row.earns and not want.cooked and "boil" not in owes:
        make = state if state in word_list("is so by boiling") else ""
        return replace(want, cooked=True, make=want.make or make, roasted=state in word_list("is roasted"))
    return replace(want, then=state) if row.fineness >= POWDER and {"cook", "boil"} & owes.keys() else None


def _before_it(want: Want, told: Sequence[str]) -> Iterator[str]:
    """Yield the words of a title before the name of a food, of which the last word is enough there (breast)."""
    own = words(want.label)
    for place, word in enumerate(told):
        if word not in own[-1:]:
            continue
        first = place
        while first and told[first - 1] in own[:-1]:
            first -= 1
        if first:
            yield told[first - 1]


def is_bought_so(row: State, state: str, operators: Operators) -> bool:
    """Whether no kitchen of this FOON makes a food so, which is fit to be eaten then."""
    return "cook" in row.earns and not row.needs_heat and not any(True for _ in operators.making(state))
