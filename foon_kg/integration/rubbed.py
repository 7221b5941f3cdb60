"""Dough of flour and cold fat: that of pies, pressed crumbs, and the crumble that is strewn on fruit."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import words
from foon_kg.food.lists import word_list
from foon_kg.integration.frames import Line, Stage
from foon_kg.integration.patterns import BAKE, CHILL, COOL, LAID, MIX, STIR, fresh, put_at
from foon_kg.integration.places import Join
from foon_kg.integration.preparation import Want

_FINE = replace(MIX, tools=("fork",), label=min(word_list("is called so when it is fine")))
_KNEAD = replace(MIX, motion="knead", does=frozenset({"knead", "mix"}), tools=())
_KNEAD = replace(_KNEAD, label=min(word_list("is called so when it is kneaded")))
_BASE = replace(_FINE, label=min(word_list("is called so when it is pressed")))
_INSIDE = replace(MIX, label=min(word_list("is called so inside")))
_FLAT = replace(_KNEAD, motion=min(word_list("is rolled up by")), does=frozenset({"shape"}))
_FLAT = replace(_FLAT, tools=("rolling pin",), vessel="cutting board")


def rubbed(line: Line, joins: Sequence[Join], told: Collection[str]) -> tuple[Line, tuple[Join, ...]]:
    """Return how what is made of flour and cold fat is made, where ``told``, the words of type and title, call it so.

    Nothing changes where the flour or the fat is missing, where eggs, sugar and milk make a batter of them, or where
    bought dough is there.
    """
    dough = _Dough(joins, told)
    if dough.base and not dough.is_bought and not word_list("is held by dough").isdisjoint(told):
        return dough.pressed()
    if dough.dry and dough.fat is not None and not dough.is_bought:
        if not word_list("is rubbed and strewn").isdisjoint(told) and dough.inside:
            return dough.crumble()
        if not word_list("is held by dough").isdisjoint(told) and dough.inside:
            return dough.holding()
    return line, tuple(joins)


class _Dough:
    """The foods of a recipe by what they are for: the dough, what comes into it, and the rest."""

    def __init__(self, joins: Sequence[Join], told: Collection[str]) -> None:
        self.joins = joins
        self.told = told
        others = ("dough", *word_list("makes dough rise"), *word_list("carries what is stacked"))
        self.is_bought = any(join.want.facts.is_a(*others) for join in joins)
        self.dry = [join for join in joins if join.want.facts.is_a("flour")][:1]
        solid = [j for j in joins if j.want.facts.is_a("fat") and not j.want.facts.is_a("liquid")]
        self.fat = next((join for join in solid if join.want.asked not in word_list("runs")), None)
        self.base = self._base()
        mash = not word_list("is covered with mash").isdisjoint(told)
        self.inside = [join for join in joins if self._is_inside(join)] if not mash else []

    def _is_inside(self, join: Join) -> bool:
        """Whether a food is no part of any such dough."""
        facts = join.want.facts
        return facts.is_a(*word_list("is held by what is rubbed")) and not facts.is_a(*word_list("thins a coat"))

    def _base(self) -> list[Join]:
        """Return the crumbs that are pressed to a base, with the fat that holds them; nothing where one is missing."""
        dusty = [join for join in self.joins if join.want.facts.is_a(*word_list("is pressed to a base"))][:1]
        fats = [join for join in self.joins if join.want.facts.is_a("fat")][:1]
        return [*dusty, *fats] if dusty and fats and not self.dry else []

    def pressed(self) -> tuple[Line, tuple[Join, ...]]:
        """Return a line that presses crumbs into a dish and fills them: baked where eggs set it, else chilled."""
        mix, inside, cool, top = fresh(_BASE, _INSIDE, COOL, LAID)
        press = replace(LAID, adds=(Line((mix,)),), motion="press", does=frozenset({"shape"}), label=mix.label)
        eggs = any(join.want.facts.is_a("egg") for join in self.joins)
        last = replace(BAKE if eggs else CHILL, adds=(Line((inside,)),))
        foam = [join for join in self.joins if self._is_whipped(join)]
        late = [join for join in self.joins if join.want.facts.is_a(*word_list("is put on what is filled"))]
        stages = (press, last, cool, top) if eggs else (press, last, top)

        def stage_of(join: Join) -> Stage:
            return mix if join in self.base else top if join in late or join in foam else inside

        joins = [replace(join, want=_whipped(join.want)) if join in foam else join for join in self.joins]
        at = {join.want.number: stage_of(join) for join in self.joins}
        used = stages if foam or late else stages[:2]
        return put_at(Line(used), joins, lambda join: at[join.want.number])

    @staticmethod
    def _is_whipped(join: Join) -> bool:
        """Whether it is cream that is called so because it is whipped."""
        called = not word_list("is called so to be whipped").isdisjoint(words(join.want.label))
        return called and join.want.facts.is_a("creamy") and join.want.facts.is_a("liquid")

    def crumble(self) -> tuple[Line, tuple[Join, ...]]:
        """Return a line that strews what is rubbed on what is laid in a dish, and bakes it."""
        fine, laid, bake = fresh(_FINE, LAID, BAKE)
        bake = replace(bake, adds=(Line((fine,)),))
        sweet = [join for join in self.joins if join.want.facts.is_a(*word_list("sweetens a batter"))]
        strewn = [*self.dry, self.fat, *sweet[-1:]]
        coarse = (*word_list("is coarse in what is strewn on"), "leaven")

        def stage_of(join: Join) -> Stage:
            return fine if join in strewn or join.want.facts.is_a(*coarse) else laid

        return put_at(Line((laid, bake)), self.joins, stage_of)

    def holding(self) -> tuple[Line, tuple[Join, ...]]:
        """Return a line that fills a dish lined with dough, or covers what was stewed with it, and bakes it."""
        raw = any("cook" in join.want.facts.owes and self._is_flesh(join) for join in self.joins)
        egg = self._egg_of_dough(stewed=raw)
        fat = [self.fat] if self.fat is not None else []
        own = [*self.dry, *fat, *egg, *self._water()]
        fine, dough, flat, laid, bake = fresh(_FINE, _KNEAD, _FLAT, LAID, BAKE)
        wet = [join for join in own if join is not self.fat and not join.want.facts.is_a("flour", "leaven")]
        made = Line((fine, dough, flat)) if wet else Line((fine, flat))
        mix = replace(STIR, label=_INSIDE.label) if raw else replace(_INSIDE)
        if raw:
            laid = replace(laid, adds=(Line((mix,)),))
            stages: tuple[Stage, ...] = (laid, replace(bake, adds=(made,)))
        else:
            laid = replace(laid, adds=(made,))
            stages = (laid, replace(bake, adds=(Line((mix,)),)))

        def stage_of(join: Join) -> Stage:
            if join in own or (join.want.facts.is_a("leaven") and not raw):
                return dough if join in wet else fine
            return mix

        return put_at(Line(stages), self.joins, stage_of)

    def _is_flesh(self, join: Join) -> bool:
        return join.want.facts.is_a(*word_list("is flesh"))

    def _egg_of_dough(self, *, stewed: bool) -> list[Join]:
        """Return the eggs that go into the dough: those that nothing in the filling needs to set."""
        sets = any(join.want.facts.is_a(*word_list("sets with eggs")) for join in self.joins)
        return [join for join in self.joins if join.want.facts.is_a("egg") and (stewed or not sets)]

    def _water(self) -> list[Join]:
        return [join for join in self.joins if join.want.facts.is_a("water", *word_list("is frozen water"))]


def _whipped(want: Want) -> Want:
    return replace(want, make=min(word_list("is beaten to a foam")), foamed=True)
