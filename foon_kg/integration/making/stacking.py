"""How a dish is put together on bread that its video leaves open: spread, stacked, closed, and fried as a whole."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from foon_kg.food.lists import word_list
from foon_kg.food.rows import CHOPPED
from foon_kg.integration.bench import Bench, Vessel, fineness, foods_of, is_flat
from foon_kg.integration.joining.course import WORKS, Plan
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.carrying import Carrier
from foon_kg.integration.making.hands import Hands
from foon_kg.integration.making.outcome import MIXTURE
from foon_kg.integration.making.turns import Incoming, Turn, without
from foon_kg.integration.making.working import Worker
from foon_kg.integration.preparing.preparation import Ready
from foon_kg.integration.teaching.frames import Stage

_SLICES = word_list("carries what is stacked")
_CREAMY = word_list("binds pieces")
_SEASONS = word_list("seasons pieces")
_LAYERS = word_list("is a layer")
_CLOSES = word_list("closes what is stacked")
_SMEARED = word_list("is smeared on it")


class Stacking(Hands):
    """Puts one dish together on a bench."""

    def __init__(self, bench: Bench, plan: Plan, carry: Carrier, work: Worker, ready: Mapping[int, Ready]) -> None:
        super().__init__(bench, plan, carry, work, ready)
        self.open: list[Join] = []  # bread of which a half or slices lie below, and the others close it

    def lay_open(self, turn: Turn, vessel: Vessel, incoming: Incoming) -> None:
        """Lay bread that is ``incoming`` in a ``turn`` below in a ``vessel``, where a later stage folds it.

        It is cut, so the rest of it is for that stage.
        """
        if is_flat(vessel.label) and not vessel.contents and any(map(_folds, turn.later)):
            closing = [join for join in incoming.joins if self._is_cut_to_close(join)]
            self.open = [join for join in closing if self._lay_below(join, vessel)]
            incoming.joins = without(incoming.joins, self.open)

    def closed(self, stage: Stage, vessel: Vessel | None, *, main: bool) -> Vessel | None:
        """Return the ``vessel`` in which what lies open was closed with bread, instead of folded at a ``stage``.

        ``None`` where nothing lies open. ``main``: it is the dish.
        """
        if vessel is None or not self.open or not _folds(stage):
            return None
        for join in self.open:
            self._bring_as_usual(join, vessel)
        self.open = []
        self.work.name(vessel, self.plan.label if main else stage.label)
        return vessel

    def _is_cut_to_close(self, join: Join) -> bool:
        cut = fineness(self.ready[join.want.number].stuff.states, self.known) > 0
        return cut and join.want.facts.is_any(_CLOSES)

    def is_put_together(self, stage: Stage, joins: Sequence[Join], later: Sequence[Stage]) -> bool:
        """Return whether a stacked dish is put together at ``stage``: what it is stacked on joins, or no video has it.

        ``joins`` are the foods there, ``later`` the stages that come then.
        """
        works = any(not one.does.isdisjoint(WORKS) for one in (stage, *later))
        return not works and any(join.slot is None or join.want.facts.is_any(_SLICES) for join in joins)

    def stack(self, stage: Stage, vessel: Vessel | None, incoming: Incoming) -> Vessel:
        """Put a dish together on a plate and return what it is on: what is in ``vessel`` and ``incoming`` at ``stage``.

        Bread comes first and what is spread on it, then what was made and the rest, and bread again; a spread with
        pieces is mixed before. What is fried as a whole gets its fat in the pan.
        """
        slices = incoming.take(self._is_slice)
        plate = self._plate(vessel, below=bool(slices))
        fats = incoming.take(self._is_fat) if self.plan.grilled else []
        bowl = self.bench.vessel("bowl")
        made = incoming.lines if vessel is None or vessel is plate else [*incoming.lines, vessel]
        self._mix_what_binds(incoming, bowl)
        self._stir_into(made, incoming)
        closing = [join for join in slices if self._lay_below(join, plate)]
        for join in incoming.take(self._is_smeared):
            self._smear(join, plate)
        for one in filter(_is_full, (*made, bowl)):
            self.bench.heat_off(one)
            self.carry.transfer(one, plate, stage)
        self._lay_on(plate, incoming.joins)
        for join in closing:
            self._bring_as_usual(join, plate)
        self.work.name(plate, self.plan.label)
        self._close(plate)
        return self._heat_through(plate, fats, stage) if self.plan.grilled else plate

    def _plate(self, vessel: Vessel | None, *, below: bool) -> Vessel:
        """Return on what a dish is put together: where it lies, if that is flat and nothing comes ``below`` it."""
        if vessel is None or not is_flat(vessel.label) or (below and vessel.contents):
            return self.bench.vessel("plate")
        return vessel

    @staticmethod
    def _is_slice(join: Join) -> bool:
        return join.want.facts.is_any(_SLICES)

    @staticmethod
    def _is_fat(join: Join) -> bool:
        return join.want.facts.is_a("fat")

    def _mix_what_binds(self, incoming: Incoming, bowl: Vessel) -> None:
        """Mix pieces with the spread that binds them in a bowl; they are taken out of ``incoming``."""
        mixed = self._bound(incoming.joins)
        incoming.joins = without(incoming.joins, mixed)
        for join in mixed:
            self._bring_as_usual(join, bowl)
        if len(mixed) > 1:
            self.work.stir(bowl, MIXTURE)

    def _lay_on(self, plate: Vessel, joins: Sequence[Join]) -> None:
        """Lay foods on what is on a plate, first what melts on it; fat that came along in what was made is there."""
        there = frozenset().union(*(stuff.wants for stuff in plate.contents))
        for join in sorted(joins, key=lambda join: not join.want.facts.is_any(word_list("melts on what is hot"))):
            if not (join.want.facts.is_a("fat") and join.want.number in there):
                self._bring_as_usual(join, plate)

    def _close(self, plate: Vessel) -> None:
        """Roll or fold bread around what lies on it, where the dish is called so and the FOON shows how."""
        foods = foods_of(plate)
        ways = [way for way in self.bench.operators.ways_of(self.plan.closed_by) if not way[1]]
        attested = self.bench.near_or_far(ways, foods)
        if attested is not None:
            able = self.known.motion(attested.way[0]).gives  # how the motion is called, it is then: rolled
            own = sorted(state for state in able if state.startswith(attested.way[0]))
            self.bench.work(plate, attested, self.plan.label, tuple(own[:1]), with_device=False)

    def _lay_below(self, join: Join, plate: Vessel) -> bool:
        """Lay bread on a plate; return whether some of it is left, to be laid on top."""
        ready = self.ready[join.want.number]
        cut = fineness(ready.stuff.states, self.known) > 0
        if ready.stuff.at is plate or not (cut and join.want.facts.is_any(_CLOSES)):
            self._bring_as_usual(join, plate)
            return False
        self.carry.bring_part(ready, plate)
        return True

    def _is_smeared(self, join: Join) -> bool:
        """Whether a food is spread on bread: it is creamy, or fat that is no liquid."""
        facts = join.want.facts
        return facts.is_a(*_CREAMY, *_SMEARED) or (facts.is_a("fat") and not facts.is_a("liquid"))

    def _smear(self, join: Join, plate: Vessel) -> None:
        """Spread a food on what lies on a plate, as the FOON spreads such a food; else only lay it on."""
        ready = self.ready[join.want.number]
        ways = [way for way in self.bench.ways_by(word_list("is smeared by")) if way[1]]
        attested = self.bench.near_or_far(ways, ready.want.names)
        if attested is None or ready.stuff.at is plate:
            self._bring_as_usual(join, plate)
        else:
            below = [stuff for stuff in plate.contents if self.known.foods.food(stuff.label).is_any(_SLICES)]
            self.bench.bring([ready.stuff], plate, attested, onto=below)

    def _heat_through(self, plate: Vessel, fats: Sequence[Join], stage: Stage) -> Vessel:
        """Fry what was put together on both sides, and return what it is served on."""
        pan = self.bench.vessel("cooking pan")
        device = self.bench.place(pan, "stove", "on")
        for join in fats:
            self._bring_as_usual(join, pan)
        self.bench.switch(pan, device, on=True)
        self.work.heat_fat(pan)
        self.carry.transfer(plate, pan, stage, whole=True)
        foods = foods_of(pan)
        heated = self.bench.require(self.work.ways.cooking(), foods)
        turned = self.bench.require(self.work.ways.turning(), foods)
        self.bench.work(pan, heated, self.plan.label, ("partly cooked",))
        self.bench.work(pan, turned, self.plan.label, ("flipped", "partly cooked"), with_device=False)
        self.bench.work(pan, heated, self.plan.label, ("cooked",))
        self.bench.heat_off(pan)
        served = self.bench.vessel("plate")
        self.carry.transfer(pan, served, stage, whole=True)
        return served

    def _bound(self, joins: Sequence[Join]) -> list[Join]:
        """Return what is mixed to be spread: small pieces with something creamy, and what seasons them."""
        creamy = [join for join in joins if join.want.facts.is_any(_CREAMY)]
        seasons = [join for join in without(joins, creamy) if join.want.facts.is_any(_SEASONS)]
        pieces = [join for join in without(joins, [*creamy, *seasons]) if self._is_in_small_pieces(join)]
        return [*pieces, *creamy, *seasons] if pieces and creamy else []

    def _is_in_small_pieces(self, join: Join) -> bool:
        """Whether a food is in small pieces, and is no layer of its own."""
        return self._is_small(join) and not join.want.facts.is_any(_LAYERS)

    def _stir_into(self, made: Sequence[Vessel], incoming: Incoming) -> None:
        """Stir small pieces into the creamy mixture that a video makes; they are taken out of ``incoming``."""
        bowl = next(filter(self._is_creamy, made), None)
        if bowl is None:
            return
        stirred = [*incoming.take(self._is_in_small_pieces), *incoming.take(self._only_seasons)]
        for join in stirred:
            self._bring_as_usual(join, bowl)
        if stirred:
            self.work.stir(bowl, MIXTURE)

    def _is_creamy(self, vessel: Vessel) -> bool:
        """Whether something creamy is in what is in a vessel, and it is not hot."""
        return not vessel.hot and any(self.known.foods.food(food).is_any(_CREAMY) for food in foods_of(vessel))

    def _only_seasons(self, join: Join) -> bool:
        """Whether a food seasons pieces, and is not spread by itself."""
        return join.want.facts.is_any(_SEASONS) and not self._is_smeared(join)

    def _is_small(self, join: Join) -> bool:
        fine = fineness(self.ready[join.want.number].stuff.states, self.known)
        return fine >= CHOPPED or join.want.facts.is_any(word_list("falls apart"))

    def _bring_as_usual(self, join: Join, vessel: Vessel) -> None:
        """Bring a food as is usual for it, and not as its slot has it."""
        self.carry.bring(self.ready[join.want.number], vessel, None)


def _is_full(vessel: Vessel) -> bool:
    return bool(vessel.contents)


def _folds(stage: Stage) -> bool:
    """Whether a stage closes with one motion what lies open on a plate."""
    return stage.motion in word_list("closes by folding") and is_flat(stage.vessel)
