"""Of a dish that is put together on bread, what has to be cooked is made by itself: patties, flesh, what lies on it."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.composing.coated import coated_apart
from foon_kg.integration.joining.patterns import COOK, MIX, SHAPE, SIMMER, STIR, TOP, TURN
from foon_kg.integration.joining.spots import NATURAL, Join
from foon_kg.integration.preparing.preparation import Want, as_mash, owed
from foon_kg.integration.teaching.frames import Line, Stage

_MIX = replace(MIX, tools=("spatula",))
_SMALL = 3


def made_apart(
    line: Line, joins: Sequence[Join], told: Collection[str], known: Tables, *, grilled: bool
) -> tuple[Line, tuple[Join, ...]]:
    """Return a line that lays on bread what it makes before; ``told`` are the words of the dish's type and title.

    ``grilled``: all is fried together at last, so nothing that needs no cooking is fried before.

    A mass is mixed, shaped and fried; flesh in one piece is coated, where something coats it, and fried. Nothing
    changes where there is no bread, or nothing raw to lie on it.
    """
    if not any(join.want.facts.is_a(*word_list("carries what is stacked")) for join in joins):
        return coated_apart(line, joins)
    body = _Body(joins, told, known)
    if not body.main and (body.falls_apart or (grilled and not body.raw and not body.fried)):
        top = replace(TOP)
        return Line((top,)), tuple(_at(join, top, ()) for join in joins)
    return body.line() if body.main else coated_apart(line, joins)


class _Body:
    def __init__(self, joins: Sequence[Join], told: Collection[str], known: Tables) -> None:
        self.joins = joins
        self.known = known
        self.falls_apart = any(self._falls_apart(join) for join in joins)
        self.raw = [join for join in joins if self._is_raw(join)]
        shaped = not word_list("holds patties").isdisjoint(told)
        mass = self._mass(shaped=shaped)
        self.shaped = bool(mass) and shaped
        flesh = [join for join in self.raw if join.want.facts.is_a(*word_list("is coated")) and join not in mass]
        alone = flesh[0] if len(flesh) == 1 and not mass else None
        self.braised = alone is not None and self._is_braised(alone)
        in_pieces = alone is not None and self._is_cut(alone) and self._has_more_for_the_pan()
        self.loose = (bool(mass) and not self.shaped) or in_pieces or self.braised
        self.main = mass or (flesh if len(flesh) == 1 else [])
        fried = [join for join in joins if join.want.facts.is_a(*word_list("is fried to be stacked"))]
        if not self.main and not self.raw:
            self.main = fried
        self.fried = [join for join in fried if join not in self.main]

    def _mass(self, *, shaped: bool) -> list[Join]:
        """Return what patties are made of: what is raw; where nothing is and they are ``shaped``, what is not.

        Else what falls apart: in shreds it is shaped, too.
        """
        able = [join for join in self.joins if join.want.facts.is_a(*word_list("patties are made of"))]
        raw = [join for join in able if join in self.raw]
        if raw or not shaped:
            return raw
        return able or [join for join in self.joins if self._falls_apart(join)]

    def _is_braised(self, flesh: Join) -> bool:
        wet = any(join.want.facts.is_of(*word_list("is braised in")) for join in self.joins)
        return wet and flesh.want.facts.is_of(*word_list("is braised"))

    def _is_cut(self, join: Join) -> bool:
        return bool(join.want.make) and (self.known.state(join.want.make).fine or 0) > 1

    def _has_more_for_the_pan(self) -> bool:
        """Whether vegetables are there that are fried with what lies on the bread."""
        return any(join.want.facts.is_a(*word_list("is fried with pieces of flesh")) for join in self.joins)

    def _falls_apart(self, join: Join) -> bool:
        """Whether flesh is asked in shreds: it is boiled by itself and falls apart then."""
        flesh = join.want.facts.is_a(*word_list("is flesh")) and "cook" in owed(join.want, self.known)
        return flesh and join.want.make in word_list("only what is cooked is so")

    def _is_raw(self, join: Join) -> bool:
        if self._falls_apart(join):
            return False
        return bool({"cook", "boil"} & owed(join.want, self.known)) and not join.want.cooked

    def line(self) -> tuple[Line, tuple[Join, ...]]:
        """Return the line and where its foods join."""
        dry = [join for join in self.joins if join.want.facts.is_a(*word_list("coats dry"))]
        top = replace(TOP)
        if dry and not self.shaped and self.main[0].want.facts.is_a(*word_list("is coated")):
            rest = [_at(join, top, ()) for join in self.joins if join not in self.fried]
            line, found = coated_apart(Line((top,)), rest)
            return self._with_fried(line, found)
        mix, heat, turn, done = replace(_MIX), replace(COOK), replace(TURN), replace(COOK)
        stages: tuple[Stage, ...] = (mix, replace(SHAPE), heat, turn, done) if self.shaped else (heat, turn, done)
        if self.loose:
            heat = replace(SIMMER, vessel="pot", label="mixture") if self.braised else replace(STIR, label="mixture")
            stages = (heat,)
        top = replace(top, adds=(Line(stages),))
        found = tuple(
            _at(self._mashed(join, stage, mix), stage, (*stages[stages.index(stage) + 1 :], top))
            if (stage := self._stage_of(join, mix if self.shaped else heat, heat)) is not None
            else _at(join, top, ())
            for join in self.joins
            if join not in self.fried
        )
        return self._with_fried(Line((top,)), found)

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
            cooked = want.facts.is_a(*word_list("is cooked with what is loose"))
            return None if want.facts.is_a(*word_list("lies on what is loose")) and not cooked else body
        if want.facts.is_a(*word_list("is smeared on it")):
            return None
        if want.facts.is_a("fat"):
            return heat if self._is_first_fat(join) else None
        return body if want.facts.is_a(*word_list("seasons a body")) or self._is_bound(want) else None

    def _is_bound(self, want: Want) -> bool:
        """Whether a food is mixed into what is shaped."""
        cut = max((self.known.state(state).fine or 0 for state in (want.make, *want.leaf) if state), default=0)
        in_pieces = 0 < cut < _SMALL  # what is asked in slices or rings is laid on it
        binds_it = word_list("binds a mass") | word_list("is bound with it")
        binds_it |= word_list("is cooked and mashed to be shaped")
        carries = want.facts.is_a(*word_list("carries what is stacked"))
        binds = (want.facts.is_a(*binds_it) and not in_pieces and not carries) or (
            cut >= _SMALL and want.facts.is_a("vegetable")
        )
        binds = binds and not want.facts.is_a(*word_list("lies on patties"))
        return self.shaped and (binds or self._is_listed_inside(want, cut))

    def _is_listed_inside(self, want: Want, cut: int) -> bool:
        """Whether a recipe lists what is in small pieces between what patties are made of and what seasons that."""
        if cut < _SMALL and not want.facts.is_a(*word_list("is mixed into patties")):
            return False
        slices = [one.want for one in self.joins if one.want.facts.is_a(*word_list("carries what is stacked"))]
        seasons = [one.want for one in self.joins if one.want.facts.is_a(*word_list("seasons a body"))]
        end = min((place for one in slices for place in one.places), default=0)
        last = max((place for one in seasons for place in one.places if place < end), default=-1)
        first = min((place for one in self.main for place in one.want.places), default=last)
        return any(first < place < last for place in want.places)

    def _is_first_fat(self, join: Join) -> bool:
        fats = [one for one in self.joins if one.want.facts.is_a("fat")]
        return min(fats, key=lambda one: not one.want.facts.is_a("liquid")) is join


def _at(join: Join, stage: Stage, after: tuple[Stage, ...]) -> Join:
    spot = replace(join.spot, stage=stage, after=after, side=bool(after))
    return Join(join.want, spot, min(join.fit, NATURAL))
