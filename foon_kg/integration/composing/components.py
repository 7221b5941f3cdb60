"""What a recipe asks for a part of its dish: a glaze, a topping, a sauce, what is strewn on it or served with it.

A component (``food/components.toml``) is a small dish: it is made by itself, and joins what else is made where it
belongs. Which foods are for it is told by the recipe's own words ("for the glaze"), by its title, and by what is listed
beside what.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import singular, words
from foon_kg.food.rows import Dish
from foon_kg.food.techniques import Around, Component, Foods, components_for, is_so
from foon_kg.integration.composing.assigning import means, takes
from foon_kg.integration.preparing.preparation import SECOND, Want

_HOLDS = ("baked", "dressed", "formed", "laid", "stacked", "tin")
"""What of a dish a row of ``food/components.toml`` may ask: fields of :class:`~foon_kg.food.rows.Dish`."""


@dataclass(frozen=True)
class Side:
    """A component of one recipe with its foods."""

    component: Component
    wants: tuple[Want, ...]


def sides_of(
    wants: Sequence[Want],
    kept: Sequence[Want],
    dishes: Iterable[Dish],
    dish_type: str,
    title: str,
    *,
    baked: bool,
    named: Collection[Want] = (),
) -> tuple[tuple[Want, ...], tuple[Side, ...]]:
    """Return what is left of ``wants``, the foods of a recipe, and the components that are made beside it.

    ``kept`` are those that a line of the dish's technique has already, ``named`` those that it names. ``dishes`` are
    those that it is called by ``dish_type`` and ``title``; ``baked``: these say that it comes out of an oven.
    """
    held = {name for name in _HOLDS if any(getattr(dish, name) for dish in dishes)}
    held |= {"baked"} if baked or "tin" in held else set()
    finder = _Finder(wants, kept, held, dish_type, words(title), named={want.number for want in named})
    sides = tuple(side for one in components_for(finder.parts) if (side := finder.side(one)) is not None)
    return tuple(finder.rest), sides


class _Finder:
    """The foods of one recipe, of which those of each component are taken out: ``rest`` is what is left."""

    def __init__(
        self,
        wants: Sequence[Want],
        kept: Sequence[Want],
        held: Collection[str],
        dish_type: str,
        title_words: Sequence[str],
        *,
        named: Collection[int],
    ) -> None:
        self.rest = [*wants, *kept]
        self.held = held
        self.dish_type = dish_type
        self.title_words = title_words
        self.listed = {place: want for want in wants for place in want.places}
        self.parts = {want.part for want in wants} - {""}
        self.highest = 3 * SECOND  # the number of the last second portion
        self.behind: set[int] = set()  # the places right behind what comes on a cold dish
        self.named = named  # the numbers of the foods that the technique of the dish names

    def side(self, component: Component) -> Side | None:
        """Return the foods of a component, which are taken out of the rest; ``None`` where there is none."""
        if not self._may_be(component):
            return None
        around = self._around()
        places = self._places(component, around)
        if not places:
            return None
        found = tuple(dict.fromkeys(self.listed[place] for place in sorted(places)))
        whole = self._used_up(found, places)
        rest = [want for want in self.rest if want not in whole]
        if not rest or not self._suits(component, found, rest, around):
            return None
        self._take(component, places, rest)
        return Side(component, tuple(want if want in whole else self._second(want) for want in found))

    def _take(self, component: Component, places: set[int], rest: list[Want]) -> None:
        """Take what is listed at the places of a component out of the recipe, of which the ``rest`` is left."""
        self.rest = rest
        if component.at == "cooled":
            self.behind.add(max(places) + 1)
        self.listed = {place: want for place, want in self.listed.items() if place not in places}

    def _suits(self, component: Component, found: Sequence[Want], rest: Sequence[Want], around: Around) -> bool:
        """Whether a component has what it needs in the foods ``found`` for it, and leaves enough for the ``rest``."""
        technique = component.technique
        if any(are(technique.without, want, around) for want in self.rest):
            return False
        if not _is_of_its_foods(component, found, around):
            return False
        return have(technique.needs, found, around) and have(component.beside, rest, around)

    def _is_sought(self, component: Component) -> bool:
        """Whether a component is looked for though the recipe says of no food that it is for it."""
        return component.is_sought and component.technique.is_called(self.dish_type, self.title_words)

    def _may_be(self, component: Component) -> bool:
        """Whether a dish of this type and title may have such a component, and any food may be for it."""
        if component.parts.isdisjoint(self.parts) and not self._is_sought(component):
            return False
        technique = component.technique
        holds = all(is_so(name, self.held) for name in technique.dishes)
        typed = not technique.types or self.dish_type in technique.types
        return holds and typed and not technique.is_never(self.title_words)

    def _around(self) -> Around:
        return Around([want.facts for want in self.rest], self.title_words)

    def _used_up(self, wants: Sequence[Want], places: set[int]) -> list[Want]:
        """Return those of ``wants`` that are listed at no other places but these."""
        return [want for want in wants if places.issuperset(self._left(want))]

    def _left(self, want: Want) -> set[int]:
        return {place for place, one in self.listed.items() if one is want}

    def _second(self, want: Want) -> Want:
        self.highest += 1
        return replace(want, number=self.highest)

    def _places(self, component: Component, around: Around) -> set[int]:
        """Return the places in the recipe of the foods of a component.

        A heading above them is surest, then one food that the recipe says is for it, then the food that such a thing is
        made of; that something is listed twice tells least, and counts only where the dish is called so.
        """
        said = self._said(component, around)
        if len(said) > 1 and have(component.technique.needs, self._at(said), around):
            return said  # a heading stands above it
        found = said or self._guessed(component, around)
        if found:
            return self._with_neighbours(found, component, around)
        if component.again and component.technique.is_called(self.dish_type, self.title_words):
            return self._opening(component, around) if component.opens else self._listed_again(component, around)
        return set()

    def _said(self, component: Component, around: Around) -> set[int]:
        """Return the places of the foods of which the recipe says that they are for such a component."""
        found = self._named(component)
        if not component.body:
            return self._taken(found, component, around)
        mixed = self._begun(found, component, around)
        if mixed and component.technique.lines and have(component.technique.needs, self._at(mixed), around):
            return self._taken(mixed, component, around)
        foods = component.body + component.neighbours
        return {place for place in found if are(foods, self.listed[place], around)}

    def _taken(self, places: set[int], component: Component, around: Around) -> set[int]:
        """Return those of places whose foods a component takes."""
        return {place for place in places if takes(component.technique, self.listed[place], around)}

    def _begun(self, places: set[int], component: Component, around: Around) -> set[int]:
        """Return those of places whose foods are for the same as a food with which a component begins."""
        begun = {want.part for want in self._at(places) if are(component.body, want, around)}
        return {place for place in places if self.listed[place].part in begun}

    def _at(self, places: Iterable[int]) -> list[Want]:
        return [self.listed[place] for place in sorted(places)]

    def _named(self, component: Component) -> set[int]:
        around = self._around()
        said = {place: want for place, want in self.listed.items() if want.part and want.part in component.parts}
        return {place for place, want in said.items() if not are(component.leaves, want, around)}

    def _guessed(self, component: Component, around: Around) -> set[int]:
        """Return the place of the food with which a component begins of which the recipe does not say so.

        It is the last one of such foods, or the one right behind what comes on a cold dish.
        """
        if self._named(component) or not component.technique.is_called(self.dish_type, self.title_words):
            return set()
        bodies = self._bodies(component, around)
        if component.behind:
            return self.behind & set(bodies)
        return {place for place in bodies[-1:] if component.guessed and not self.listed[place].part}

    def _bodies(self, component: Component, around: Around) -> list[int]:
        """Return the places of the foods with which a component may begin."""
        found = [place for place, want in self.listed.items() if are(component.body, want, around)]
        named = self.named if component.yields else ()
        return [place for place in found if self.listed[place].number not in named]

    def _opening(self, component: Component, around: Around) -> set[int]:
        """Return the places before a food that is listed again, where all that stands there may be the component's."""
        end = next(iter(self._once_more(component, around)), 0)
        found = {place for place in self.listed if place < end}
        return found if all(self._belongs(place, component, around) for place in found) else set()

    def _listed_again(self, component: Component, around: Around) -> set[int]:
        """Return the places around a food that a recipe lists a second time, once all else of its dish is named."""
        for place in self._once_more(component, around):
            found = self._with_neighbours({place}, component, around)
            if have(component.technique.needs, [self.listed[one] for one in found], around):
                return found
        return set()

    def _once_more(self, component: Component, around: Around) -> list[int]:
        """Return where foods that begin a component are listed again, once all that it comes after was.

        What is listed twice in a row is of two kinds and no second part.
        """
        last = max((place for place, want in self.listed.items() if are(component.after, want, around)), default=-1)
        seen: list[str] = []
        found = []
        for place, want in sorted(self.listed.items()):
            label = singular(want.label)
            again = label in seen[:-1] and label != seen[-1] and not want.part
            behind = component.opens or 0 <= last < place
            if again and behind and are(component.again, want, around):
                found.append(place)
            seen.append(label)
        return found

    def _with_neighbours(self, places: set[int], component: Component, around: Around) -> set[int]:
        """Return places with those after them, and before them if need be, of foods that belong to the same.

        What is there already, listed again after another food, begins something else.
        """
        found, needs = set(places), component.technique.needs
        for start in sorted(places):
            place = start + 1
            while self._belongs(place, component, around) and not self._is_again(place, found):
                found.add(place)
                place += 1
        place = min(found) - 1
        while self._belongs(place, component, around) and (
            are(component.body, self.listed[place], around)
            or not have(needs, [self.listed[one] for one in found], around)
        ):
            found.add(place)
            place -= 1
        return found

    def _is_again(self, place: int, found: Collection[int]) -> bool:
        """Whether what is listed at a place was found before, and not only right before it."""
        label = singular(self.listed[place].label)
        return label in {singular(self.listed[one].label) for one in found if one < place - 1}

    def _belongs(self, place: int, component: Component, around: Around) -> bool:
        want = self.listed.get(place)
        return want is not None and not want.part and are(component.neighbours, want, around)


def are(foods: Sequence[Foods], want: Want, around: Around) -> bool:
    """Return whether ``want``, a food of a recipe, is one of ``foods``; ``around`` are the others with the title."""
    return any(means(one, want, around) for one in foods)


def _is_of_its_foods(component: Component, found: Sequence[Want], around: Around) -> bool:
    """Whether what was found for a component is not only what may stand beside its body, and nothing that it lacks."""
    if any(are(component.lacks, want, around) for want in found):
        return False
    begins = not component.body or bool(component.again)
    return begins or any(are(component.body, want, around) for want in found)


def have(needs: Sequence[Sequence[Foods]], wants: Sequence[Want], around: Around) -> bool:
    """Return whether of each list of ``needs`` one food is among ``wants``; ``around`` are all foods with the title."""
    return all(any(are(need, want, around) for want in wants) for need in needs)
