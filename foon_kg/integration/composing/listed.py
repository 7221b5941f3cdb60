"""What the foods of a recipe without headings are for: what is named one after another and makes a part of a dish.

A published list names its foods in the order of use. A run of them at its end, or at its beginning, that is all that a
syrup, a sauce or a dough is made of, and that begins with what was named before, is that part. What suits no row of
``food/listed.toml`` stays in the dish.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from operator import itemgetter

from foon_kg.food import singular, words
from foon_kg.food.listed import Run, runs
from foon_kg.food.lists import word_list
from foon_kg.food.techniques import Around
from foon_kg.integration.composing.components import are, have
from foon_kg.integration.composing.headed import Inferred, as_headed, as_opened, without_headings
from foon_kg.integration.preparing.preparation import Want
from foon_kg.model import Recipe, RequiredIngredient


def as_listed(
    recipe: Recipe, understand: Callable[[Iterable[RequiredIngredient]], tuple[Want, ...]]
) -> tuple[Recipe, tuple[Want, ...], tuple[Inferred, ...]]:
    """Return a ``recipe`` with the parts that its list tells, its foods as ``understand`` reads them, and the parts."""
    recipe = without_headings(recipe)
    wants = understand(recipe.ingredients)
    recipe, opened = as_opened(recipe, wants)
    if opened:
        return recipe, understand(recipe.ingredients), opened
    headed = as_headed(recipe, wants)
    if headed is not recipe:
        recipe, wants = headed, understand(headed.ingredients)
    inferred = parts_inferred(wants, recipe)
    if not inferred:
        return recipe, wants, ()
    recipe = with_parts_said(recipe, inferred)
    return recipe, understand(recipe.ingredients), inferred


def parts_inferred(wants: Sequence[Want], recipe: Recipe) -> tuple[Inferred, ...]:
    """Return the parts that a recipe does not name; ``wants`` are its foods, in the order of its list."""
    listed = sorted(((place, want) for want in wants for place in want.places), key=itemgetter(0))
    return tuple(_Listed(listed, recipe, headed=any(want.is_headed for want in wants)).parts())


def with_parts_said(recipe: Recipe, inferred: Sequence[Inferred]) -> Recipe:
    """Return a recipe that says of its foods the parts that were ``inferred``."""
    said = {place: one.part for one in inferred for place in one.places}
    places = itertools.count()
    foods = (
        replace(food, part=said.get(next(places), food.part)) if food.object else food for food in recipe.ingredients
    )
    return replace(recipe, ingredients=tuple(foods))


class _Listed:
    """The foods of one recipe in the order of its list, of which those of each part are taken out."""

    def __init__(self, listed: Sequence[tuple[int, Want]], recipe: Recipe, *, headed: bool) -> None:
        self.dish_type = recipe.dish_type or ""
        self.title_words = words(recipe.title or "")
        self.all = [want for _, want in listed]
        self.around = Around([want.facts for want in self.all], self.title_words)
        self.left = [one for one in _above_headings(listed) if not one[1].part]
        self.runs = list(_runs_for(self.dish_type, self.title_words, headed=headed))

    def parts(self) -> Iterator[Inferred]:
        """Yield what closes the list, the last first, and then what opens it."""
        for opens in (False, True):
            found = self._next(opens=opens)
            while found is not None:
                yield from found
                found = None if opens else self._next(opens=opens)

    def _next(self, *, opens: bool) -> list[Inferred] | None:
        """Take the first run that closes what is left of the list, or ``opens`` it, and return what it makes."""
        for run in self.runs:
            size = self._size(run) if run.opens == opens else 0
            if size:
                return [one for one in self._taken(run, size) if one.part and one.places]
        return None

    def _taken(self, run: Run, size: int) -> Iterator[Inferred]:
        """Take so many foods out of what is left, and yield what they are for, and what others are for then."""
        at = slice(0, size) if run.opens else slice(len(self.left) - size, len(self.left))
        found = self.left[at]
        del self.left[at]
        own, others = self._for(run, self.left if run.opens else found)
        yield Inferred(run.part, tuple(place for place, _ in found) if run.opens else own)
        yield Inferred(run.rest, own if run.opens else others)

    def _for(self, run: Run, listed: Sequence[tuple[int, Want]]) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """Return the places of what is ``listed``, and apart from them those at its end that it leaves for others."""
        places, end = tuple(place for place, _ in listed), len(listed)
        while end > 1 and are(run.leaves, listed[end - 1][1], self.around):
            end -= 1
        return places[:end], places[end:]

    def _size(self, run: Run) -> int:
        """Return how many foods at the end of what is left, or at its beginning, are such a run; 0 for none."""
        wants = [want for _, want in self.left]
        longest = _alike(run, wants if run.opens else wants[::-1], self.around)
        for size in range(longest, 0, -1):
            found, rest = (wants[:size], wants[size:]) if run.opens else (wants[-size:], wants[:-size])
            if rest and self._is(run, found, rest):
                return size if self._begins_anew(run, found, rest) else 0
        return 0

    def _is(self, run: Run, found: Sequence[Want], rest: Sequence[Want]) -> bool:
        """Whether the foods ``found`` side by side are such a run, and the ``rest`` is what it stands beside."""
        around, technique, bounds = self.around, run.technique, run.bounds
        if not are(bounds.starts, found[0], around) or not are(bounds.ends, found[-1], around):
            return False
        if any(are(bounds.lacks, want, around) for want in found):
            return False
        if any(are(technique.without, want, around) for want in self.all):
            return False
        return have(technique.needs, found, around) and have(run.beside, rest, around)

    def _begins_anew(self, run: Run, found: Sequence[Want], rest: Sequence[Want]) -> bool:
        """Whether what is ``found`` is told from the ``rest``: by what is named in both, and what stands next to it."""
        if are(run.bounds.apart, rest[0] if run.opens else rest[-1], self.around):
            return False
        return have(run.again, found, self.around) and have(run.again, rest, self.around)


def _above_headings(listed: Sequence[tuple[int, Want]]) -> Iterator[tuple[int, Want]]:
    return itertools.takewhile(lambda one: not one[1].is_headed, listed)


def _runs_for(dish_type: str, title_words: Sequence[str], *, headed: bool) -> Iterator[Run]:
    """Yield the runs that such a dish may have, in the order of the table; where its list is ``headed``, few."""
    for run in runs():
        if (run.headed or not headed) and run.technique.is_called(dish_type, title_words):
            yield run


def _alike(run: Run, wants: Sequence[Want], around: Around) -> int:
    """Return how many of ``wants``, from the first on, a run may be of: none is named twice, but zest and juice are."""
    seen: list[str] = []
    for want in wants:
        label = singular(want.label)
        twice = label in (seen[:-1] if want.facts.is_any(word_list("is pressed for its juice")) else seen)
        if twice or not are(run.bounds.of, want, around):
            break
        seen.append(label)
    return len(seen)
