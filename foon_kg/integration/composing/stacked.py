"""Of a dish that is put together on bread, what has to be cooked is made by itself: patties, flesh, what lies on it."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import CHOPPED
from foon_kg.integration.bench import fineness
from foon_kg.integration.composing.coated import coated_apart
from foon_kg.integration.joining.patterns import COOK, MIX, SHAPE, SIMMER, STIR, TOP, TURN
from foon_kg.integration.joining.spots import NATURAL, Join, any_is
from foon_kg.integration.preparing.preparation import Want, as_mash, owed
from foon_kg.integration.teaching.frames import Line, Stage

_MIX = replace(MIX, tools=("spatula",))


def cooked_apart(
    line: Line, joins: Sequence[Join], name_words: Collection[str], known: Tables, *, grilled: bool
) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that lays on bread what it makes before, and its ``joins``.

    A mass is mixed, shaped and fried; flesh in one piece is coated, where something coats it, and fried. Nothing
    changes where there is no bread, or nothing raw to lie on it. ``name_words`` are the words of the dish's type and
    title, ``known`` the tables. ``grilled``: all is fried together at last, so nothing that needs no cooking is fried
    before.
    """
    if not any(join.want.facts.is_any(word_list("carries what is stacked")) for join in joins):
        return coated_apart(line, joins)
    body = _CookedApart(joins, name_words, known)
    if not body.main and (body.falls_apart or (grilled and not body.raw and not body.fried)):
        top = replace(TOP)
        return Line((top,)), tuple(_at(join, top, ()) for join in joins)
    return body.line() if body.main else coated_apart(line, joins)


class _CookedApart:
    """The foods of a dish on bread: the ``main`` ones that have to be made apart, and what else is fried beside them.

    ``shaped``: they are a mass for patties. ``loose``: they are cooked in pieces, or ``braised`` in a liquid.
    ``falls_apart``: flesh is asked in shreds, and boiled for that by itself.
    """

    def __init__(self, joins: Sequence[Join], name_words: Collection[str], known: Tables) -> None:
        self.joins = joins
        self.known = known
        self.falls_apart = any(map(self._falls_apart, joins))
        self.raw = list(filter(self._is_raw, joins))
        shaped = says(name_words, "holds patties")
        mass = self._mass(shaped=shaped)
        lone = self._lone_flesh(mass)
        self.shaped = shaped and bool(mass)
        self.braised = any(map(self._is_braised, lone))
        self.loose = self.braised or self._is_fried_in_pieces(lone) or bool(mass and not shaped)
        fried = self._are("is fried to be stacked")
        self.main = mass or lone or (fried if not self.raw else [])
        self.fried = [join for join in fried if join not in self.main]

    def _mass(self, *, shaped: bool) -> list[Join]:
        """Return what patties are made of: what is raw; where nothing is and they are ``shaped``, what is not.

        Else what falls apart: in shreds it is shaped, too.
        """
        able = self._are("patties are made of")
        raw = [join for join in able if join in self.raw]
        if raw or not shaped:
            return raw
        return able or [join for join in self.joins if self._falls_apart(join)]

    def _is_braised(self, flesh: Join) -> bool:
        wet = any(join.want.facts.is_of(*word_list("is braised in")) for join in self.joins)
        return wet and flesh.want.facts.is_of(*word_list("is braised"))

    def _lone_flesh(self, mass: Sequence[Join]) -> list[Join]:
        """Return the one piece of raw flesh on the bread; none beside a ``mass``, or where there are several."""
        flesh = [join for join in self.raw if join.want.facts.is_any(word_list("is coated"))]
        return flesh if len(flesh) == 1 and not mass else []

    def _is_fried_in_pieces(self, flesh: Sequence[Join]) -> bool:
        """Whether flesh is asked cut, and vegetables are there that are fried with it."""
        cut = any(fineness((join.want.make,), self.known) > 1 for join in flesh)
        return cut and any_is(self.joins, *word_list("is fried with pieces of flesh"))

    def _falls_apart(self, join: Join) -> bool:
        """Whether flesh is asked in shreds: it is boiled by itself and falls apart then."""
        flesh = join.want.facts.is_any(word_list("is flesh")) and "cook" in owed(join.want, self.known)
        return flesh and join.want.make in word_list("only what is cooked is so")

    def _is_raw(self, join: Join) -> bool:
        if self._falls_apart(join):
            return False
        return bool({"cook", "boil"} & owed(join.want, self.known)) and not join.want.cooked

    def line(self) -> tuple[Line, tuple[Join, ...]]:
        """Return the line and where its foods join."""
        top = replace(TOP)
        if self._is_coated():
            rest = [_at(join, top, ()) for join in self.joins if join not in self.fried]
            line, found = coated_apart(Line((top,)), rest)
            return self._with_fried(line, found)
        mix, heat = replace(_MIX), replace(COOK)
        if self.loose:
            heat = replace(SIMMER, vessel="pot", label="mixture") if self.braised else replace(STIR, label="mixture")
        stages = self._stages(mix, heat)
        top = replace(top, adds=(Line(stages),))

        def placed(join: Join) -> Join:
            stage = self._stage_of(join, stages[0], heat)
            if stage is None:
                return _at(join, top, ())
            after = (*stages[stages.index(stage) + 1 :], top)
            return _at(self._mashed(join, stage, mix), stage, after)

        return self._with_fried(Line((top,)), [placed(join) for join in self.joins if join not in self.fried])

    def _is_coated(self) -> bool:
        """Whether what lies on the bread is a piece of flesh that something coats."""
        dry = any_is(self.joins, *word_list("coats dry"))
        return dry and not self.shaped and self.main[0].want.facts.is_any(word_list("is coated"))

    def _stages(self, mix: Stage, heat: Stage) -> tuple[Stage, ...]:
        """Return the stages at which what lies on the bread is made: shaped if it is a mass, fried on both sides."""
        if self.loose:
            return (heat,)
        both_sides = (heat, replace(TURN), replace(COOK))
        return (mix, replace(SHAPE), *both_sides) if self.shaped else both_sides

    def _mashed(self, join: Join, stage: Stage, mix: Stage) -> Join:
        """Return a food as it can be shaped, where it is mixed for that."""
        return replace(join, want=as_mash(join.want, self.known)) if self.shaped and stage is mix else join

    def _with_fried(self, line: Line, joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
        """Return a line with a pan in which is fried what lies on the rest."""
        if not self.fried:
            return line, tuple(joins)
        pan, before = replace(STIR), line.stages[-1]
        top = replace(before, adds=(*before.adds, Line((pan,))))
        moved = [
            replace(join, spot=replace(join.spot, stage=top)) if join.spot.stage is before else join for join in joins
        ]
        return Line((*line.stages[:-1], top)), (*moved, *(_at(join, pan, (top,)) for join in self.fried))

    def _stage_of(self, join: Join, body: Stage, heat: Stage) -> Stage | None:
        """Return where a food joins what is made, ``None`` where it lies on the bread by itself."""
        want = join.want
        if join in self.main:
            return body
        if self.loose:
            cooked = want.facts.is_any(word_list("is cooked with what is loose"))
            return None if want.facts.is_any(word_list("lies on what is loose")) and not cooked else body
        if want.facts.is_any(word_list("is smeared on it")):
            return None
        if want.facts.is_a("fat"):
            return heat if self._is_first_fat(join) else None
        return body if want.facts.is_any(word_list("seasons a body")) or self._is_bound(want) else None

    def _is_bound(self, want: Want) -> bool:
        """Whether a food is mixed into what is shaped."""
        cut = fineness((want.make, *want.leaf), self.known)
        if not self.shaped or self._is_listed_behind_the_carrier(want):
            return False
        binds = self._binds(want, cut) and not want.facts.is_any(word_list("lies on patties"))
        return binds or self._is_listed_inside(want, cut)

    def _is_listed_behind_the_carrier(self, want: Want) -> bool:
        """Whether a recipe lists a food behind what carries the rest, and what is shaped before: that lies on it.

        Where something raw stands there that needs heat, it lists in no such order.
        """
        carrier = min(self._places("carries what is stacked"), default=math.inf)
        shaped = max((place for one in self.main for place in one.want.places), default=math.inf)
        raw = [place for one in self.raw if one not in self.main for place in one.want.places]
        return shaped < carrier < min(want.places, default=-1) and not any(place > carrier for place in raw)

    def _binds(self, want: Want, cut: int) -> bool:
        """Whether a food holds a mass together, or is a vegetable so small that it is held by that."""
        if 0 < cut < CHOPPED:
            return False  # what is asked in slices or rings is laid on it
        if cut >= CHOPPED and want.facts.is_a("vegetable"):
            return True
        binds = word_list("binds a mass") | word_list("is bound with it")
        binds |= word_list("is cooked and mashed to be shaped")
        return want.facts.is_any(binds) and not want.facts.is_any(word_list("carries what is stacked"))

    def _is_listed_inside(self, want: Want, cut: int) -> bool:
        """Whether a recipe lists what is in small pieces between what patties are made of and what seasons that."""
        if cut < CHOPPED and not want.facts.is_any(word_list("is mixed into patties")):
            return False
        end = min(self._places("carries what is stacked"), default=0)
        last = max((place for place in self._places("seasons a body") if place < end), default=-1)
        first = min((place for one in self.main for place in one.want.places), default=last)
        return any(first < place < last for place in want.places)

    def _places(self, words_of: str) -> list[int]:
        """Return the places in the recipe of foods of a list."""
        return [place for join in self._are(words_of) for place in join.want.places]

    def _are(self, words_of: str) -> list[Join]:
        return [join for join in self.joins if join.want.facts.is_any(word_list(words_of))]

    def _is_first_fat(self, join: Join) -> bool:
        fats = [one for one in self.joins if one.want.facts.is_a("fat")]
        return min(fats, key=lambda one: not one.want.facts.is_a("liquid")) is join


def _at(join: Join, stage: Stage, after: tuple[Stage, ...]) -> Join:
    spot = replace(join.spot, stage=stage, after=after, side=bool(after))
    return Join(join.want, spot, min(join.fit, NATURAL))
