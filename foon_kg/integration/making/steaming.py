"""Foods are cooked in steam: in a basket or a dish that stands in a pot, above water that boils, under a lid.

Where no video of the FOON does it, what is boiled is the evidence; that is declared as a substitution.
"""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Vessel, foods_of
from foon_kg.integration.joining.batters import binds
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.consistency import is_wet
from foon_kg.integration.making.doing import Doing
from foon_kg.integration.making.hands import Hands
from foon_kg.integration.making.outcome import says_raw
from foon_kg.integration.making.turns import Incoming, Turn
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.frames import Stage, Steamed
from foon_kg.integration.teaching.operators import Attested

POT, LID, BASKET, MOTION = "pot", "pot lid", "steamer basket", "steam"
"""What water boils in, what covers that, what stands in it, and what is done there."""

STEAMED, _COOKED = "steamed", "cooked"

_LIKE_IT = ("boil", "simmer", "cook")
"""What tells that a food is steamed, where no video does that: it is cooked by boiling water as well."""

_SURE = 0.8
"""How sure it is that what is boiled can be steamed."""


class Steaming(Hands):
    """Steams the foods of one dish on a bench; ``doing`` says what comes of it."""

    def __init__(self, doing: Doing) -> None:
        placing = doing.placing
        super().__init__(placing.bench, placing.plan, placing.carry, placing.work, placing.ready)
        self.doing = doing
        self.placing = placing

    def done(self, turn: Turn, stage: Steamed, vessel: Vessel | None, incoming: Incoming) -> Vessel:
        """Steam at ``stage``, that of ``turn``, what is in ``vessel`` and what is ``incoming``; return its vessel then.

        Raises :class:`RefusedError` where a step cannot be done.
        """
        holder = self._filled(stage, vessel, incoming)
        self.steam(turn, holder, stage.over)
        return holder

    def steam(self, turn: Turn, holder: Vessel, over: str) -> None:
        """Steam what is in ``holder`` over boiling water in what is called ``over``, as the stage of ``turn`` does."""
        with_wrap = holder.label in word_list("is covered in the steam")
        if with_wrap:
            self.bench.cover(holder, min(word_list("covers what is steamed")))
        pot = self.over_water(holder, over)
        attested = self.evidence(turn.stage.motion, foods_of(holder))
        self._work(turn, holder, attested)
        self.out_of_the_steam(holder, pot)

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

    # --- over the water ---

    def over_water(self, holder: Vessel, over: str) -> Vessel:
        """Stand ``holder`` over boiling water in what is called ``over``, under a lid; return that pot."""
        pot = self.bench.vessel(over)
        self.carry.water.add(pot)
        self.bench.place(pot, "stove", "on")
        self.carry.water.boil(pot)
        self.bench.stand_over(holder, pot)
        self.bench.cover(pot, LID)
        return pot

    def out_of_the_steam(self, holder: Vessel, pot: Vessel) -> None:
        """Turn off the heat and lift ``holder`` out of its ``pot``."""
        self.bench.heat_off(pot)
        self.bench.uncover(pot)
        self.bench.lift_off(holder)
        self.bench.uncover(holder)

    def evidence(self, motion: str, foods: Sequence[str]) -> Attested:
        """Return what attests that ``foods`` are steamed, be it that they, or the like, are boiled.

        ``motion`` is what is done. Raises :class:`RefusedError` where this FOON has neither.
        """
        own = self.bench.near_or_far(self.bench.operators.ways_of(motion), foods)
        return own or self.bench.require([(name, ()) for name in _LIKE_IT], foods)

    def told(self, motion: str, attested: Attested, food: str) -> None:
        """Declare that ``food`` is steamed (``motion``) where another motion is ``attested``."""
        if attested.way[0] != motion:
            self.bench.other_motions[food, motion] = (attested.way[0], _SURE)

    # --- the work ---

    def _work(self, turn: Turn, holder: Vessel, attested: Attested) -> None:
        motion = turn.stage.motion
        product = self.doing.product(turn, holder, attested.way)
        states = tuple(sorted({STEAMED if state == _COOKED else state for state in product.states}))
        self.told(motion, attested, product.label or holder.contents[0].label)
        if product.label:
            self.bench.work(holder, attested, product.label, states, motion=motion)
        else:
            self.each(holder, attested, motion, states)

    def each(self, holder: Vessel, attested: Attested, motion: str, states: Sequence[str]) -> None:
        """Steam (``motion``), as is ``attested``, all in ``holder``: each stays what it is, in ``states`` then."""
        stuffs = list(holder.contents)

        def change() -> None:
            for stuff in stuffs:
                kept = (state for state in stuff.states if not says_raw(state, self.known))
                stuff.states = tuple(sorted({*kept, *states}))
            holder.hot = True

        inputs = [holder, *self.bench.under(holder), *stuffs]
        self.bench.emit(attested, inputs, change, [holder, *stuffs, *self.bench.water_under(holder)], motion=motion)
