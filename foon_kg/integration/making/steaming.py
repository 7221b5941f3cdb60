"""What a dish steams: it comes into a basket or a dish that stands in a pot, above water that boils, under a lid."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Vessel, foods_of
from foon_kg.integration.joining.batters import binds
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.consistency import is_wet
from foon_kg.integration.making.doing import Doing
from foon_kg.integration.making.hands import Hands
from foon_kg.integration.making.turns import Incoming, Turn
from foon_kg.integration.making.water import Steam
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.frames import Stage, Steamed
from foon_kg.integration.teaching.operators import Attested

_COOKED = {"cooked", "partly cooked"}
"""What steam makes done is called steamed in its stead, whatever is done to it later."""


class Steaming(Hands):
    """Steams the foods of one dish on a bench; ``doing`` says what comes of it."""

    def __init__(self, doing: Doing) -> None:
        placing = doing.placing
        super().__init__(placing.bench, placing.plan, placing.carry, placing.work, placing.ready)
        self.doing = doing
        self.placing = placing
        self.steam = Steam(placing.carry.water)

    def done(self, turn: Turn, stage: Steamed, vessel: Vessel | None, incoming: Incoming) -> Vessel:
        """Steam at ``stage``, that of ``turn``, what is in ``vessel`` and what is ``incoming``; return its vessel then.

        Raises :class:`RefusedError` where a step cannot be done.
        """
        holder = self._filled(stage, vessel, incoming)
        self.work.rising.let_rise_again(holder)
        if holder.label in word_list("is covered in the steam"):
            self.bench.cover(holder, min(word_list("covers what is steamed")))
        pot = self.steam.over_water(holder, stage.over)
        self._work(turn, holder, self.steam.evidence(stage.motion, foods_of(holder)))
        self.steam.out_of_it(holder, pot)
        return holder

    # --- in what ---

    def _filled(self, stage: Stage, vessel: Vessel | None, incoming: Incoming) -> Vessel:
        """Return a basket or dish with all that is steamed."""
        lines = [*([vessel] if vessel is not None else []), *incoming.lines]
        holder = self._holder(stage, lines, incoming.joins)
        under = [] if holder in lines else incoming.take(self.placing.lies_under)
        for join in under:
            self.bring(join, holder)
        for one in lines:
            self.bench.heat_off(one)
            if one is not holder:
                self._come_into(holder, one, stage, greased=bool(under))
        for join in incoming.joins:
            self.bring(join, holder)
        return holder

    def _come_into(self, holder: Vessel, line: Vessel, stage: Stage, *, greased: bool) -> None:
        """Bring what a line made into ``holder``; a batter or dough sticks in a mould that is not ``greased``."""
        if not greased and any(binds(stuff.foods, self.known) for stuff in line.contents):
            self.placing.grease(holder, line)
        self.carry.transfer(line, holder, stage)

    def _holder(self, stage: Stage, lines: Sequence[Vessel], joins: Sequence[Join]) -> Vessel:
        """Return what the foods of some lines, and of ``joins``, are steamed in: what runs in no basket."""
        label = stage.vessel
        row = self.known.utensil(label)
        if row is not None and "strain" in row.can and self._runs(lines, joins):
            label = min(word_list("what runs is steamed in"))
        return next((one for one in lines if one.label == label), None) or self.bench.vessel(label)

    def _runs(self, lines: Sequence[Vessel], joins: Sequence[Join]) -> bool:
        """Whether some of it would run through a basket."""
        if any(is_wet(stuff, self.known) for one in lines for stuff in one.contents):
            return True
        stuffs = [self.ready[join.want.number].stuff for join in joins]
        return any(form_of(self.known, stuff.label, stuff.states) in {"liquid", "soft"} for stuff in stuffs)

    # --- the work ---

    def _work(self, turn: Turn, holder: Vessel, attested: Attested) -> None:
        """Steam what is in ``holder``, as the stage of ``turn`` makes it one thing or leaves each what it is."""
        motion = turn.stage.motion
        product = self.doing.product(turn, holder, attested.way)
        states = tuple(sorted({min(word_list("is so by steam")) if one in _COOKED else one for one in product.states}))
        if not product.label:
            self.steam.each(holder, attested, motion, states)
            return
        self.bench.declare(motion, attested, product.label)
        self.bench.work(holder, attested, product.label, states, motion=motion)
