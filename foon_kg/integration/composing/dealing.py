"""Which food of a recipe is for which part of a technique: as the recipe says, as the table means it, or the rest."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

from foon_kg.food import singular, tables, words
from foon_kg.food.lists import word_list
from foon_kg.food.techniques import Around, Foods, Part, Technique
from foon_kg.integration.composing.coated import is_portion
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.preparing.preparation import Want, owed

_ONE_PART = ("is one part below", "is one part above")
"""The lists of names, each of one part of a dish."""

MAIN = "dish"
"""The line of a technique that makes the dish."""


class Dealt(NamedTuple):
    """A food with the part of a technique at which it joins, and the text of the table by which it does."""

    join: Join
    foods: Foods
    part: Part


class _Wish(NamedTuple):
    """Foods that a part of a line asks for."""

    foods: Foods
    part: Part
    line: str


def line_told(part: str, lines: Collection[str]) -> str:
    """Return which of ``lines`` a recipe means that says of a food for which ``part`` it is; ``""`` for none.

    One recipe has another name for it than the next.
    """
    if part in lines:
        return part
    alike = next((names for names in map(word_list, _ONE_PART) if part in names), frozenset())
    return next((line for line in lines if line in alike), "")


def means(foods: Foods, want: Want, around: Around) -> bool:
    """Return whether ``want``, a food of a recipe, is one of those that a text of the table means.

    ``around`` are the foods and the title that it is asked with.
    """
    return foods.mean(want.label, want.facts, _states(want) if foods.state else (), around)


def _states(want: Want) -> set[str]:
    """Return what is said of a food: its states, and what ways ask of how it is named and comes."""
    known, label = tables(), want.label
    due = {"cook", "boil"} & owed(want, known)
    mash = {want.make, want.then} & word_list("only what is soft is so")
    said = {
        "in one piece": not want.make,
        "in pieces": bool(want.make) and known.state(want.make).fineness > 1,
        "portion": is_portion(want, known),
        "due": bool(due),
        "raw": "cook" in due and not (want.cooked and want.make),
        "runs": want.squeezed or want.asked in word_list("runs"),
        "several": label != singular(label) or not word_list("is asked twofold").isdisjoint(words(label)),
        "as mash": bool(mash) or "made" in want.facts.traits,
    }
    return {want.asked, want.make, want.then, *want.leaf, *(name for name, holds in said.items() if holds)}


def takes(one: Technique, want: Want, around: Around) -> bool:
    """Return whether ``want``, a food that a recipe says is for a row, joins ``one``, the technique of that row.

    It does where its lines name the food, take anything, or mix nothing; ``around`` are the other foods with the title.
    """
    foods = [some for parts in one.lines.values() for part in parts for some in part.foods]
    return not foods or any(some.is_rest or means(some, want, around) for some in foods)


def has_its_foods(one: Technique, wants: Sequence[Want], around: Around) -> bool:
    """Return whether ``wants``, the foods of a recipe, are those that the technique ``one`` needs.

    ``around`` are the same foods with the title.
    """
    if not all(any(means(some, want, around) for some in need for want in wants) for need in one.needs):
        return False
    if any(means(some, want, around) for some in one.without for want in wants):
        return False
    return all(sum(means(some, want, around) for want in wants) == 1 for some in one.one)


def dealt(technique: Technique, joins: Sequence[Join], around: Around) -> list[Dealt]:
    """Return at which part of a technique each food joins, and then the second portions of some of them.

    What a recipe says itself of a food comes before all; then what the table names, and what it takes of the rest.
    ``around`` are the foods and the title that they are asked with.
    """
    wishes = _wishes(technique)
    dealer = _Dealer(technique, joins, around)
    apart = dealer.told if any(wish.foods.is_rest for wish in wishes) else set()
    for line in sorted(dealer.told):
        dealer.deal_as_told(line, [wish for wish in wishes if wish.line == line])
    for wish in wishes:
        if wish.foods.again:
            if not dealer.has_as_told(wish):
                dealer.deal_again(wish)
        elif wish.line not in apart:
            dealer.deal(wish)
        else:
            dealer.deal_beside_told(wish)
    dealer.deal_the_others()
    return [*dealer.once.values(), *dealer.more]


def _wishes(technique: Technique) -> list[_Wish]:
    """Return what the lines of a technique ask for, first portions first, and the rest last of these."""
    found = [
        _Wish(foods, part, line) for line, parts in technique.lines.items() for part in parts for foods in part.foods
    ]
    return sorted(found, key=lambda wish: (wish.foods.again, wish.foods.is_rest))


class _Dealer:
    """Deals the foods of a recipe out: ``once`` by their numbers, ``more`` for second portions.

    ``told`` are the lines of which the recipe says itself what is for them; ``taken`` is in which line a food is used
    up, ``""`` where another one may ask for more of it.
    """

    def __init__(self, technique: Technique, joins: Sequence[Join], around: Around) -> None:
        self.lines = technique.lines
        self.joins = joins
        self.around = around
        self.named = [line for line in self.lines if line != MAIN]
        self.told = set(filter(None, map(self._line, joins)))
        self.once: dict[int, Dealt] = {}
        self.more: list[Dealt] = []
        self.taken: dict[int, str] = {}

    def deal_as_told(self, line: str, wishes: Sequence[_Wish]) -> None:
        """Put what the recipe says is for a line where one of its ``wishes`` means it, else where the first one is."""
        poured = line in word_list("is poured over what lies below")
        for join in self.joins:
            below = poured and join.want.facts.is_a(*word_list("lies below what is poured"))
            if self._line(join) == line and not below:
                wish = next((wish for wish in wishes if means(wish.foods, join.want, self.around)), wishes[0])
                self._put(join, wish)
                self.taken[join.want.number] = line

    def has_as_told(self, wish: _Wish) -> bool:
        """Whether the recipe says itself that a food that a wish means is for its line."""
        return wish.line in self.told and any(self._line(join) == wish.line for join in self._meant(wish))

    def _line(self, join: Join) -> str:
        return line_told(join.want.part, self.named)

    def deal(self, wish: _Wish) -> None:
        """Put the foods that a wish means there, unless they are somewhere already."""
        for join in self._meant(wish):
            if join.want.number not in self.once:
                self._put(join, wish)
                self.taken[join.want.number] = wish.line if wish.foods.is_rest else ""  # else two of it: layers

    def deal_again(self, wish: _Wish) -> None:
        """Put second portions there: those that the recipe lists for the same part as other foods of that line."""
        found = [join for join in self._meant(wish) if self.taken.get(join.want.number) != wish.line]
        beside = self._parts_in(wish.line)
        said = [join for join in found if join.want.part in beside]
        for join in said:
            self._put(join, wish)
        if not said:
            self._deal_portions([join for join in found if not join.want.part], wish)

    def _parts_in(self, line: str) -> set[str]:
        """Return for which parts of the dish, that are no lines, the recipe says that the foods of a line are."""
        found = {one.join.want.part for one in self.once.values() if one.part in self.lines[line]}
        return {part for part in found if part and not line_told(part, self.named)}

    def _deal_portions(self, found: Sequence[Join], wish: _Wish) -> None:
        """Put a second portion of each food there; what a recipe names twice is two portions already.

        Of those the one joins that stands nearest, in the recipe, to the other foods of the part.
        """
        there = [one.join.want.number for one in self.once.values() if one.part is wish.part]
        for alike in _by_name(found):
            near = _nearest(alike, there)
            if len(alike) > 1:
                if not any(join.want.number in there for join in alike):
                    self._put(near, wish)
            elif near.want.number not in self.once:
                self._put(near, wish)
            elif near.want.number not in there:
                self.more.append(Dealt(near, wish.foods, wish.part))

    def deal_the_others(self) -> None:
        """Put what no stage names where that joins which is listed nearest, for the same part if any is."""
        for join in self.joins:
            if join.want.number not in self.once and self.once:
                part = min(self.once.values(), key=lambda one: _distance(one.join.want, join.want)).part
                self.once[join.want.number] = Dealt(join, Foods(("*",)), part)

    def _meant(self, wish: _Wish) -> list[Join]:
        return [join for join in self.joins if means(wish.foods, join.want, self.around)]

    def _put(self, join: Join, wish: _Wish) -> None:
        """Put a food there, of which it is the first portion."""
        self.once[join.want.number] = Dealt(join, replace(wish.foods, again=False), wish.part)

    def deal_beside_told(self, wish: _Wish) -> None:
        """Put foods at a stage of a line of which the recipe says what is for it, unless that joins at this stage."""
        if not any(one.part is wish.part and one.join.want.part in self.told for one in self.once.values()):
            self.deal(wish)


def _by_name(joins: Iterable[Join]) -> Iterable[list[Join]]:
    """Return the foods of each name together."""
    found: dict[str, list[Join]] = {}
    for join in joins:
        found.setdefault(singular(join.want.label), []).append(join)
    return found.values()


def _nearest(joins: Sequence[Join], numbers: Sequence[int]) -> Join:
    """Return the first of ``joins`` that stands nearest, in the recipe, to one of ``numbers``."""
    return min(joins, key=lambda join: min((abs(join.want.number - n) for n in numbers), default=0))


def _distance(one: Want, other: Want) -> tuple[bool, int]:
    """Return how far two foods stand from one another in a recipe: in other parts of it, and so many places."""
    return one.part != other.part, abs(one.number - other.number)
