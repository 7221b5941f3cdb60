"""Which food of a recipe is for which part of a technique: as the recipe says, as the table means it, or the rest."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

from foon_kg.food import singular, tables, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.techniques import Around, Foods, Part, Technique, works
from foon_kg.integration.composing.coated import is_portion
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.preparing.preparation import Want, owed

_ONE_PART = ("is one part below", "is one part above")
"""The lists of names, each of one part of a dish: the crust, the base; the topping, the icing."""

MAIN = "dish"
"""The line of a technique that makes the dish."""


class Assigned(NamedTuple):
    """A food with the part of a technique at which it joins, and the text of the table by which it does."""

    join: Join
    foods: Foods
    part: Part


class _Request(NamedTuple):
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
    named = foods.names(want.label, want.facts, around)  # few are, and what is said of a food takes long
    return named and (not foods.state or foods.suits(_states(want)))


def _states(want: Want) -> set[str]:
    """Return what is said of a food: its states, and what ways ask of how it is named and comes."""
    known, label = tables(), want.label
    due = {"cook", "boil"} & owed(want, known)
    mash = {want.make, want.then} & word_list("only what is soft is so")
    said = {
        "in one piece": not want.make or known.state(want.make).earns == {"wash"},
        "in pieces": bool(want.make) and known.state(want.make).fineness > 1,
        "portion": is_portion(want, known),
        "due": bool(due),
        "raw": "cook" in due and not (want.cooked and want.make),
        "runs": want.squeezed or want.asked in word_list("runs"),
        "several": label != singular(label) or says(words(label), "is asked twofold"),
        "as mash": bool(mash) or "made" in want.facts.traits,
        f"for {want.part}": bool(want.part),
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


def assigned(technique: Technique, joins: Sequence[Join], around: Around) -> list[Assigned]:
    """Return at which part of a technique each food joins, and then the second portions of some of them.

    What a recipe says itself of a food comes before all; then what the table names, and what it takes of the rest.
    ``around`` are the foods and the title that they are asked with.
    """
    requests = _requests(technique)
    assigner = _Assigner(technique, joins, around)
    apart = assigner.named_lines if any(request.foods.is_rest for request in requests) else set()
    for line in sorted(assigner.named_lines):
        assigner.assign_as_told(line, requests)
    for request in requests:
        if request.foods.again:
            if not assigner.has_as_told(request):
                assigner.assign_again(request)
        elif request.line not in apart:
            assigner.assign(request)
        else:
            assigner.assign_beside_told(request)
    assigner.assign_the_others()
    return [*assigner.once.values(), *assigner.more]


def _requests(technique: Technique) -> list[_Request]:
    """Return what the lines of a technique ask for, first portions first, and the rest last of these."""
    found = [
        _Request(foods, part, line) for line, parts in technique.lines.items() for part in parts for foods in part.foods
    ]
    return sorted(found, key=lambda request: (request.foods.again, request.foods.is_rest))


class _Assigner:
    """Assigns the foods of a recipe to parts: ``once`` by their numbers, ``more`` for second portions.

    ``named_lines`` are the lines of which the recipe says itself what is for them, ``others`` all but the dish's own;
    ``taken`` is in which line a food is used up, ``""`` where another one may ask for more of it; at the parts ``late``
    a dish is cooked already, by identity.
    """

    def __init__(self, technique: Technique, joins: Sequence[Join], around: Around) -> None:
        self.lines = technique.lines
        self.joins = joins
        self.around = around
        self.others = [line for line in self.lines if line != MAIN]
        self.named_lines = set(filter(None, map(self._line, joins)))
        self.once: dict[int, Assigned] = {}
        self.more: list[Assigned] = []
        self.taken: dict[int, str] = {}
        self.late = {id(part) for part in _after_heat(technique.lines[MAIN])}

    def assign_as_told(self, line: str, requests: Sequence[_Request]) -> None:
        """Put what the recipe says is for a ``line`` where one of its ``requests`` means it, else at the first one.

        What the lines that join it mean, as onions that are fried for a filling, joins there.
        """
        first = next(request for request in requests if request.line == line)
        unnamed = first._replace(foods=Foods(("*",)))  # it is there, and prepared as no other food
        poured = line in word_list("is poured over what lies below")
        asked = self._asked_for(line, requests)
        for join in self.joins:
            below = poured and _lies_below(join.want)
            if self._line(join) == line and not below:
                self._put(join, next((one for one in asked if means(one.foods, join.want, self.around)), unnamed))
                self.taken[join.want.number] = line

    def _asked_for(self, line: str, requests: Sequence[_Request]) -> list[_Request]:
        """Return those of ``requests`` that are for a line, after those for lines that join it, and the rest last.

        Lines of which the recipe says itself what is for them are no parts of another one.
        """
        fed = {name for part in self.lines[line] for name in part.lines} - self.named_lines
        found = [request for request in requests if request.line == line or request.line in fed]
        return sorted(found, key=lambda one: (one.foods.is_rest, one.line == line))

    def has_as_told(self, request: _Request) -> bool:
        """Return whether the recipe says itself that a food that is requested is for its line."""
        return request.line in self.named_lines and any(
            self._line(join) == request.line for join in self._meant(request)
        )

    def _line(self, join: Join) -> str:
        return line_told(join.want.part, self.others)

    def assign(self, request: _Request) -> None:
        """Put the foods that are requested there, unless they are somewhere already."""
        late = id(request.part) in self.late
        for join in self._meant(request):
            if join.want.number not in self.once and not (late and _only_gives_taste(join)):
                self._put(join, request)
                self.taken[join.want.number] = request.line if request.foods.is_rest else ""  # else two of it: layers

    def assign_again(self, request: _Request) -> None:
        """Put second portions there: those that the recipe lists for the same part as other foods of that line.

        Of what it lists for any other part the table has to name that part: more of the pastry, for the lid.
        """
        found = [join for join in self._meant(request) if self.taken.get(join.want.number) != request.line]
        beside = self._parts_in(request.line)
        said = [join for join in found if join.want.part in beside]
        for join in said:
            self._put(join, request)
        if not said:
            self._assign_portions([join for join in found if _may_be_shared(join, request)], request)

    def _parts_in(self, line: str) -> set[str]:
        """Return for which parts of the dish, that are no lines, the recipe says that the foods of a line are."""
        found = {one.join.want.part for one in self.once.values() if one.part in self.lines[line]}
        return {part for part in found if part and not line_told(part, self.others)}

    def _assign_portions(self, found: Sequence[Join], request: _Request) -> None:
        """Put a second portion of each food there; what a recipe names twice is two portions already.

        Of those the one joins that stands nearest, in the recipe, to the other foods of the part.
        """
        there = [one.join.want.number for one in self.once.values() if one.part is request.part]
        for alike in _by_name(found):
            near = _nearest(alike, there)
            if len(alike) > 1:
                if not any(join.want.number in there for join in alike):
                    self._put(near, request)
            elif near.want.number not in self.once:
                self._put(near, request)
            elif near.want.number not in there:
                self.more.append(Assigned(near, request.foods, request.part))

    def assign_the_others(self) -> None:
        """Put what no stage names where that joins which is listed nearest, for the same part if any is."""
        for join in self.joins:
            if join.want.number not in self.once and self.once:
                part = min(self.once.values(), key=lambda one: _distance(one.join.want, join.want)).part
                self.once[join.want.number] = Assigned(join, Foods(("*",)), part)

    def _meant(self, request: _Request) -> list[Join]:
        return [join for join in self.joins if means(request.foods, join.want, self.around)]

    def _put(self, join: Join, request: _Request) -> None:
        """Put a food there, of which it is the first portion."""
        self.once[join.want.number] = Assigned(join, replace(request.foods, again=False), request.part)

    def assign_beside_told(self, request: _Request) -> None:
        """Put foods at a stage of a line of which the recipe says what is for it, unless that joins at this stage."""
        if not any(one.part is request.part and one.join.want.part in self.named_lines for one in self.once.values()):
            self.assign(request)


def _may_be_shared(join: Join, request: _Request) -> bool:
    """Whether a second portion of a food may be taken: it is for no part, or for the one that the table names."""
    return not join.want.part or request.foods.state == f"for {join.want.part}"


def _lies_below(want: Want) -> bool:
    """Whether something is poured over a food: rice, say, or an egg that is fried."""
    egg = want.facts.is_a("egg") and want.make in word_list("is an egg done by itself")
    return egg or want.facts.is_any(word_list("lies below what is poured"))


def _after_heat(parts: Sequence[Part]) -> Sequence[Part]:
    """Return the ``parts`` of a line that come when all that is heated in it was heated; none where nothing is."""
    heated = [place for place, part in enumerate(parts) if "heat" in works()[part.stage].does]
    return parts[heated[-1] + 1 :] if heated else ()


def _only_gives_taste(join: Join) -> bool:
    """Whether a food is taken out of what it was cooked in: raw on what is done, it is nothing to eat."""
    return join.want.facts.is_any(word_list("is taken out of the dish"))


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
