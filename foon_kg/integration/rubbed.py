"""Dough of flour and cold fat: scones and biscuits, the pastry of pies, and the crumble that is strewn on fruit."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.frames import Line, Stage
from foon_kg.integration.patterns import BAKE, COOL, LAID, MIX, SHAPE, STIR, TOP, fresh, put_at
from foon_kg.integration.places import Join
from foon_kg.integration.preparation import owed

_RUB = replace(MIX, tools=("fork",), label="flour mixture")
_KNEAD = replace(MIX, motion="knead", does=frozenset({"knead", "mix"}), tools=(), label="pastry dough")
_FILLING = replace(MIX, label="pie filling")
_ROLL = replace(_KNEAD, motion="roll", does=frozenset({"shape"}), tools=("rolling pin",), vessel="cutting board")
_CUT = replace(_ROLL, motion="cut", does=frozenset({"cut"}), tools=("knife",), relation="on")
_ON_TRAY = replace(BAKE, vessel="baking tray", relation="on")


def rubbed(
    line: Line, joins: Sequence[Join], told: Collection[str], known: Tables
) -> tuple[Line, tuple[Join, ...]]:
    """Return how what is made of flour and cold fat is made, where ``told``, the words of type and title, call it so.

    Nothing changes where the flour or the fat is missing, where eggs, sugar and milk make a batter of them, or where
    bought dough is there.
    """
    dough = _Dough(joins, told, known)
    if dough.dry and not dough.is_bought and not word_list("is kneaded without yeast").isdisjoint(told):
        return dough.loaf()
    if dough.dry and dough.fat is not None and not dough.is_bought:
        if not word_list("is rubbed and cut").isdisjoint(told):
            return dough.pieces()
        if not word_list("is rubbed and strewn").isdisjoint(told) and dough.filling:
            return dough.crumble()
        if not word_list("is held by dough").isdisjoint(told) and dough.filling:
            return dough.pie()
    return line, tuple(joins)


class _Dough:
    """The foods of a recipe by what they are for: the dough, what comes into it, and the rest."""

    def __init__(self, joins: Sequence[Join], told: Collection[str], known: Tables) -> None:
        self.joins = joins
        self.told = told
        self.known = known
        self.is_bought = any(join.want.facts.is_a("dough", "yeast", "bread") for join in joins)
        self.dry = [join for join in joins if join.want.facts.is_a("flour")][:1]
        solid = [j for j in joins if j.want.facts.is_a("fat") and not j.want.facts.is_a("liquid")]
        self.fat = next((join for join in solid if join.want.asked not in word_list("runs")), None)
        self.filling = [join for join in joins if self._is_filling(join)]

    def _is_filling(self, join: Join) -> bool:
        """Whether a food is no part of any such dough."""
        facts = join.want.facts
        return facts.is_a("fish", "fruit", "meat", "vegetable") and not facts.is_a(*word_list("thins a coat"))

    def pieces(self) -> tuple[Line, tuple[Join, ...]]:
        """Return a line that cuts pieces of dough and bakes them."""
        rub, dough, roll, cut, bake, cool, top = fresh(_RUB, _KNEAD, _ROLL, _CUT, _ON_TRAY, COOL, TOP)
        late = [join for join in self.joins if join.want.facts.is_a(*word_list("is put on what is baked"))]
        stages: tuple[Stage, ...] = (rub, dough, roll, cut, bake)
        stages = (*stages, replace(cool, vessel="baking tray"), top) if late else (*stages, top)

        def stage_of(join: Join) -> Stage:
            facts = join.want.facts
            if join in late:
                return top
            first = join is self.fat or facts.is_a(*word_list("is dry in a batter"), "sugar")
            return rub if first else dough

        return put_at(Line(stages), self.joins, stage_of)

    def loaf(self) -> tuple[Line, tuple[Join, ...]]:
        """Return a line that kneads a dough without yeast, shapes and bakes it."""
        dry, knead, shape, bake, top = fresh(_RUB, _KNEAD, replace(SHAPE, label=_KNEAD.label), _ON_TRAY, TOP)

        def stage_of(join: Join) -> Stage:
            return dry if join.want.facts.is_a(*word_list("is dry in a batter"), "sugar") else knead

        return put_at(Line((dry, knead, shape, bake, top)), self.joins, stage_of)

    def crumble(self) -> tuple[Line, tuple[Join, ...]]:
        """Return a line that strews what is rubbed on what is laid in a dish, and bakes it."""
        rub, laid, bake = fresh(_RUB, LAID, BAKE)
        bake = replace(bake, adds=(Line((rub,)),))
        sweet = [join for join in self.joins if join.want.facts.is_a("sugar")]
        strewn = [*self.dry, self.fat, *sweet[-1:]]
        coarse = ("nut", *word_list("is coarse in what is strewn on"), "leaven")

        def stage_of(join: Join) -> Stage:
            return rub if join in strewn or join.want.facts.is_a(*coarse) else laid

        return put_at(Line((laid, bake)), self.joins, stage_of)

    def pie(self) -> tuple[Line, tuple[Join, ...]]:
        """Return a line that fills a dish lined with dough, or covers what was stewed with it, and bakes it."""
        raw = any("cook" in owed(join.want, self.known) and self._is_flesh(join) for join in self.joins)
        egg = self._egg_of_dough(stewed=raw)
        own = [*self.dry, self.fat, *egg, *self._water()]
        rub, dough, roll, laid, bake = fresh(_RUB, _KNEAD, _ROLL, LAID, BAKE)
        wet = [join for join in own if join is not self.fat and not join.want.facts.is_a("flour", "leaven")]
        pastry = Line((rub, dough, roll)) if wet else Line((rub, roll))
        mix = replace(STIR, label=_FILLING.label) if raw else replace(_FILLING)
        if raw:
            laid = replace(laid, adds=(Line((mix,)),))
            stages: tuple[Stage, ...] = (laid, replace(bake, adds=(pastry,)))
        else:
            laid = replace(laid, adds=(pastry,))
            stages = (laid, replace(bake, adds=(Line((mix,)),)))

        def stage_of(join: Join) -> Stage:
            if join in own or (join.want.facts.is_a("leaven") and not raw):
                return dough if join in wet else rub
            return mix

        return put_at(Line(stages), self.joins, stage_of)

    def _is_flesh(self, join: Join) -> bool:
        return join.want.facts.is_a(*word_list("is flesh"))

    def _egg_of_dough(self, *, stewed: bool) -> list[Join]:
        """Return the eggs that go into the dough: those that nothing in the filling needs to set."""
        sets = any(join.want.facts.is_a(*word_list("sets with eggs")) for join in self.joins)
        return [join for join in self.joins if join.want.facts.is_a("egg") and (stewed or not sets)]

    def _water(self) -> list[Join]:
        return [join for join in self.joins if join.want.facts.is_a("water", "ice")]
