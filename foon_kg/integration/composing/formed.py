"""Balls, patties and cakes: what holds together is mixed, shaped, and then fried, baked or simmered."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Food, Tables, singular, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import CHOPPED, Dish
from foon_kg.integration.bench import fineness
from foon_kg.integration.joining.patterns import (
    BAKE,
    COOK,
    MIX,
    SHAPE,
    SIMMER,
    TOP,
    TURN,
    WHISK,
    fresh,
    put_at,
    with_line,
)
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.preparing.preparation import Want, as_mixed
from foon_kg.integration.teaching.frames import Line, Stage

_SAUCE = word_list("is a sauce around a mass")


def is_formed(dishes: Collection[Dish], joins: Sequence[Join]) -> bool:
    """Return whether ``dishes``, its names, have balls, patties or cakes, and ``joins`` no bread around them."""
    carried = any(join.want.facts.is_any(word_list("carries what is stacked")) for join in joins)
    other = any(dish.dressed or (dish.stacked and carried) for dish in dishes)
    return any(dish.formed for dish in dishes) and not other


def formed(
    line: Line, joins: Sequence[Join], name_words: frozenset[str], known: Tables, goal: str, *, baked: bool
) -> tuple[Line, tuple[Join, ...]]:
    """Return ``line`` and ``joins`` for balls, patties or cakes that are the dish: mixed, shaped, cooked, and simmered.

    ``name_words`` are the words of type and title, ``goal`` is what the recorded dish is called, ``known`` are the
    tables; ``baked``: it comes out of an oven. Nothing changes where there is nothing to be shaped, or where balls are
    but a part of the dish: with pasta, in a soup.
    """
    mass = _Mass(joins, known, name_words)
    if not mass.is_the_dish or says(name_words, "boils in the dish"):
        return line, tuple(joins)
    wet = [join for join in joins if mass.is_sauce(join)]
    smooth = mass.smoothed(wet)
    mix, shape, whisk, top = fresh(MIX, replace(SHAPE, label=_portions(name_words)), WHISK, TOP)
    cooked = _cooked(Line((mix, shape)), goal, baked=baked)
    sauce = _sauced(wet, (Line((whisk,)),) if smooth else ())

    def stage_of(join: Join) -> Stage:
        if mass.is_of_mass(join, alone=False):
            return mix
        if join.want.facts.is_a("fat"):
            return cooked[0]
        if mass.lies_on_it(join):
            return top
        if join in smooth:
            return whisk
        return sauce if join in wet else mix

    at = {join.want.number: stage_of(join) for join in joins}

    def prepared(join: Join) -> Join:
        return replace(join, want=as_mixed(join.want, known)) if at[join.want.number] is mix else join

    stages = (*cooked, sauce, top) if wet else (*cooked, top)
    return put_at(Line(stages), list(map(prepared, joins)), lambda join: at[join.want.number])


def _cooked(shaped: Line, goal: str, *, baked: bool) -> tuple[Stage, ...]:
    """Return the stages that cook what is ``shaped``: in the oven, or on both sides in the pan as ``goal``."""
    if baked:
        return (replace(BAKE, adds=(shaped,), vessel="baking tray", relation="on"),)
    return (replace(COOK, adds=(shaped,), label=goal), *fresh(TURN, COOK))


def _sauced(wet: Sequence[Join], adds: tuple[Line, ...]) -> Stage:
    """Return the stage at which what is ``wet`` joins what is shaped; there is a sauce only where some of it runs."""
    lies = all(join.want.facts.is_any(word_list("only lies in a sauce")) for join in wet)
    return replace(COOK if lies else SIMMER, adds=adds)


def _portions(name_words: frozenset[str]) -> str:
    """Return what shaped portions are called in a dish with these ``name_words``."""
    balls = word_list("is called so in balls")
    return min(word_list("is called so in portions") if name_words.isdisjoint(map(singular, balls)) else balls)


def formed_within(line: Line, joins: Sequence[Join], known: Tables) -> tuple[Line, tuple[Join, ...]]:
    """Return ``line`` and ``joins`` for a dish in which balls are cooked with the rest: shaped before they join.

    ``known`` are the tables.
    """
    mass = _Mass(joins, known)
    meets = mass.main[0].spot.stage if mass.main else None
    if meets is None or not meets.heats or "dry" in meets.does:
        return line, tuple(joins)
    mix, shape = fresh(MIX, replace(SHAPE, label=min(word_list("is called so in balls"))))
    own = [join for join in joins if mass.is_of_mass(join, alone=False)]
    whole, became = with_line(line, meets, Line((mix, shape)))

    def stage_of(join: Join) -> Stage:
        return mix if join in own else became.get(id(join.spot.stage), join.spot.stage)

    moved, found = put_at(whole, joins, stage_of)
    pairs = zip(joins, found, strict=True)
    return moved, tuple(now if now.spot.stage is mix else replace(before, spot=now.spot) for before, now in pairs)


class _Mass:
    """What of a recipe's foods is mixed to be shaped."""

    def __init__(self, joins: Sequence[Join], known: Tables, name_words: frozenset[str] = frozenset()) -> None:
        self.known = known
        self.name_words = name_words
        self.joins = joins
        self.main = self._main()
        facts = [join.want.facts for join in joins]
        self.bound = any(one.is_any(word_list("binds patties")) for one in facts)
        self.begin = self._begin()
        self.wet = any(map(self._is_around, joins))

    def _main(self) -> list[Join]:
        for words_of in ("patties are made of", "is shaped too", "is shaped when it is mashed"):
            found = [join for join in self.joins if join.want.facts.is_any(word_list(words_of))]
            if found:
                return found
        return []

    def _begin(self) -> float:
        """Return the place in the recipe at which what is cooked around the mass begins."""
        first = min(itertools.chain(*(join.want.places for join in self.main)), default=0)
        around = filter(self._is_around, self.joins)
        wet = [join.want for join in around if _is_listed_behind(join.want, first)]
        main = [want for want in wet if want.facts.is_of(*word_list("is the body of a sauce"))]
        others = [want for want in wet if not want.facts.is_any(word_list("is mixed into a mass"))]
        return min((min(want.places) for want in main or others), default=math.inf)

    @property
    def is_the_dish(self) -> bool:
        """Whether something is shaped, and is no mere part of the dish: balls with pasta."""
        sauced = (join for join in self.joins if join.want.facts.is_any(word_list("is eaten with a sauce")))
        return bool(self.main) and all(map(self.holds, sauced))

    def _is_around(self, join: Join) -> bool:
        """Whether a food runs around what is shaped: it soaks nothing, and the recipe lists it for no mass."""
        runs = _runs_around(join.want.facts) or self._is_the_title_s(join)
        return runs and not _is_listed_for_it(join) and not self._soaks_what_binds(join)

    def _is_the_title_s(self, join: Join) -> bool:
        """Whether the title names what would else season a mass: the sauce of teriyaki meatballs is around them."""
        named = not self.name_words.isdisjoint(words(join.want.label))
        return named and join.want.facts.is_any(word_list("is around a mass where a title names it"))

    def holds(self, join: Join) -> bool:
        """Return whether raw grain is shaped with the rest and done in the sauce, before which it is listed."""
        facts = join.want.facts
        early = bool(join.want.places) and min(join.want.places) < self.begin < math.inf
        return early and facts.kind in word_list("is done inside a mass") and not join.want.cooked

    def _is_beside_binder(self, join: Join) -> bool:
        """Whether a recipe lists a food right before or after the crumbs that bind a mass."""
        binders = [one.want for one in self.joins if one.want.facts.is_any(word_list("is soaked to bind"))]
        return any(abs(mine - other) == 1 for one in binders for mine in join.want.places for other in one.places)

    def _is_listed_after(self, join: Join) -> bool:
        """Whether a recipe lists a food after that with which the sauce begins, as it does what belongs to that."""
        facts = join.want.facts
        late = bool(join.want.places) and min(join.want.places) > self.begin
        return late and join not in self.main and not facts.is_a("fat", "egg", *word_list("is soaked to bind"))

    def _is_listed_before(self, join: Join) -> bool:
        """Whether a recipe lists what seasons a mass before the sauce begins."""
        early = bool(join.want.places) and min(join.want.places) < self.begin < math.inf
        return early and join.want.facts.is_any(word_list("seasons a mass"))

    def _fine(self, join: Join) -> int:
        return fineness((join.want.make, *join.want.leaf), self.known)

    def is_of_mass(self, join: Join, *, alone: bool) -> bool:
        """Whether a food is mixed with what is shaped; ``alone``: there is nothing else that it could belong to."""
        facts = join.want.facts
        if not _is_listed_for_it(join) and self._is_beside_it(join):
            return False
        if self._is_surely_of_it(join):
            return True
        if facts.is_a("fat") or self._is_around(join):
            return False
        if facts.is_any(word_list("binds a mass or a sauce")):
            return not self.wet
        if facts.is_any(word_list("is bound with it")):
            return not self.bound and not alone
        return alone and self._is_small_enough(join)

    def _is_small_enough(self, join: Join) -> bool:
        return not join.want.facts.is_a("vegetable") or self._fine(join) >= CHOPPED

    def _is_beside_it(self, join: Join) -> bool:
        """Whether a food is taken out of the dish, lies on it, or is listed with its sauce."""
        taken = join.want.facts.is_any(word_list("is taken out of the dish"))
        return taken or self.lies_on_it(join) or self._is_listed_after(join)

    def _is_surely_of_it(self, join: Join) -> bool:
        """Whether a food is what is shaped, binds or seasons it, is held in it, or listed for it."""
        if self._is_the_title_s(join):
            return _is_listed_for_it(join)
        if join in self.main or self.holds(join) or self._soaks_what_binds(join) or self._is_listed_before(join):
            return True
        binds = join.want.facts.is_a(*word_list("binds patties"), *word_list("is mixed into a mass"))
        return binds or _is_listed_for_it(join)

    def _soaks_what_binds(self, join: Join) -> bool:
        """Whether a liquid is for the crumbs that bind a mass: listed beside them, or if another one is the sauce."""
        if join.want.facts.kind not in word_list("soaks what binds"):
            return False
        if not self.bound:
            return self._is_for_flour(join)
        if self._is_beside_binder(join):
            return True
        others = [one.want.facts for one in self.joins if one is not join]
        drunk = join.want.facts.is_any(word_list("makes a sauce only when it is bound"))
        loose = drunk and not any(one.is_any(word_list("binds a mass or a sauce")) for one in others)
        return loose or any(_runs_around(one) for one in others)

    def _is_for_flour(self, join: Join) -> bool:
        """Whether a liquid thins the flour that binds a mass with its eggs: no sauce, which begins with fat."""
        fats, flour, eggs = (
            [place for one in self.joins if one.want.facts.is_a(kind) for place in one.want.places]
            for kind in ("fat", "flour", "egg")
        )
        others = any(_runs_around(one.want.facts) for one in self.joins if one is not join)
        return bool(flour and eggs) and not others and max(flour) < min(fats, default=math.inf)

    def is_sauce(self, join: Join) -> bool:
        """Return whether a food is cooked around what was shaped."""
        facts = join.want.facts
        if facts.is_a("fat") or self.lies_on_it(join) or self.is_of_mass(join, alone=False):
            return False
        if _runs_around(facts) or self._is_the_title_s(join) or self._is_listed_after(join):
            return True
        return self.wet and not self.is_of_mass(join, alone=True)

    def smoothed(self, wet: Sequence[Join]) -> list[Join]:
        """Return what of a sauce is whisked before it comes to what is hot: flour, and a liquid that is poured."""
        binds = [join for join in wet if join.want.facts.is_any(word_list("binds a mass or a sauce"))]
        liquids = [join for join in wet if join.want.facts.is_of(*word_list("smooths what binds a sauce"))]
        liquids = [join for join in liquids if join.want.facts.is_a("liquid", "water")]
        return [*binds, liquids[0]] if binds and liquids else []

    def lies_on_it(self, join: Join) -> bool:
        """Return whether a food comes on what is done, or beside it."""
        facts = join.want.facts
        if self._is_listed_before(join) or _is_listed_for_it(join):
            return False
        wedge = facts.is_any(word_list("is a wedge beside it")) and not join.want.squeezed
        return wedge or facts.is_a(*word_list("is served with what is fried"), "topping")


def _is_listed_behind(want: Want, place: int) -> bool:
    return bool(want.places) and min(want.places) > place


def _is_listed_for_it(join: Join) -> bool:
    """Whether a recipe lists a food under the heading of what is shaped ("for the patties")."""
    return says(map(singular, words(join.want.part)), "is the heading of a mass")


def _runs_around(facts: Food) -> bool:
    """Whether a food is cooked around what was shaped; of juices those that are drunk."""
    return facts.is_of(*_SAUCE) or facts.kind in word_list("is a sauce around a mass, and its kinds are not")
