"""What is turned in a coat is dipped into it, and lies beside it then: what is left of the coat stays behind."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from foon_kg.food import Food
from foon_kg.food.lists import says, word_list
from foon_kg.integration.bench import Stuff, Thing, Vessel, foods_of, is_flat
from foon_kg.integration.joining.course import COATS
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.hands import Hands
from foon_kg.integration.making.outcome import MIXTURE
from foon_kg.integration.making.turns import Incoming, without
from foon_kg.integration.teaching.frames import Stage

_COATS = word_list("coats dry") | word_list("coats wet") | word_list("clings to what is coated")


class Dipping(Hands):
    """Dips the foods of one dish on a bench."""

    def is_for(self, stage: Stage, vessel: Vessel | None, incoming: Incoming) -> bool:
        """Return whether a stage turns what is in ``vessel``, or what joins, in a coat: there may be none for it.

        ``incoming`` is what joins the stage.
        """
        if stage.does != COATS or stage.motion not in word_list("is turned in by"):
            return False
        if vessel is not None:
            return bool(incoming)
        own = any(not self._is_coat(join.want.facts) for join in incoming.joins)
        return own or any(map(self._is_dipped, incoming.lines))

    def done(self, stage: Stage, vessel: Vessel | None, incoming: Incoming) -> Vessel:
        """Dip what is in ``vessel``, or is ``incoming`` at ``stage``, and return what it lies on then.

        Raises :class:`RefusedError` where a step cannot be done.
        """
        inside, dipped = ([vessel], []) if vessel is not None else self._dipped(incoming)
        coat = self._coat(stage, without(incoming.joins, dipped), without(incoming.lines, inside))
        there = self._laid_out(stage, inside, dipped)
        if coat.contents:
            self._coated(stage, there, coat)
        return there

    def _dipped(self, incoming: Incoming) -> tuple[list[Vessel], list[Join]]:
        """Return what of all that joins is dipped, and no coat."""
        foods = [join for join in incoming.joins if not self._is_coat(join.want.facts)]
        return list(filter(self._is_dipped, incoming.lines)), foods

    def _is_coat(self, facts: Food) -> bool:
        return facts.is_any(_COATS)

    def _is_dipped(self, line: Vessel) -> bool:
        """Whether a line makes what is dipped, and not what it is dipped into: it was given a form, or is no batter."""
        states = {state for stuff in line.contents for state in stuff.states}
        if says(states, "keeps its shape"):
            return True
        return any(self.known.foods.food(food).is_any(word_list("is coated")) for food in foods_of(line))

    def _coat(self, stage: Stage, joins: Sequence[Join], lines: Sequence[Vessel]) -> Vessel:
        """Return a bowl with the coat in it, stirred where it is of several foods."""
        bowl = lines[0] if lines else self.bench.vessel("bowl")
        for line in lines[1:]:
            self.carry.transfer(line, bowl, stage)
        for join in joins:
            self.bring(join, bowl)
        if len(bowl.contents) > 1 or any(map(self._is_unbeaten, bowl.contents)):
            self.work.stir(bowl, self._called(foods_of(bowl)))
        return bowl

    def _called(self, foods: Sequence[str]) -> str:
        """Return what a coat of these foods is called, by the one that is more than seasoning."""
        facts = [self.known.foods.food(food) for food in foods]
        if any(one.is_a("flour") for one in facts):
            return min(word_list("is called so when it is fine"))
        if all(one.is_a(*word_list("runs out of its shell"), *word_list("only flavours")) for one in facts):
            return min(word_list("is called so when it is beaten"))
        return MIXTURE

    def _is_unbeaten(self, stuff: Stuff) -> bool:
        """Whether it ran out of its shell, and nobody stirred it."""
        opened = self.known.foods.food(stuff.label).is_any(word_list("runs out of its shell"))
        return opened and not stuff.mixed and not says(stuff.states, "is stirred already")

    def _laid_out(self, stage: Stage, vessels: Sequence[Vessel], dipped: Sequence[Join]) -> Vessel:
        """Return a plate or board with all that is dipped: that on which it lies already, if it lies on one."""
        flat = (one for one in (*vessels, *self._boards(dipped)) if is_flat(one.label))
        plate = next(flat, None) or self.bench.vessel("plate")
        for one in without(vessels, [plate]):
            self.carry.transfer(one, plate, stage)
        for join in dipped:
            self.bring(join, plate)
        return plate

    def _boards(self, dipped: Sequence[Join]) -> Iterator[Vessel]:
        """Yield in or on what a food lies, if it is the only one that is dipped."""
        own = self.ready[dipped[0].want.number].stuff.at if len(dipped) == 1 else None
        if own is not None and len(own.contents) == 1:
            yield own

    def _coated(self, stage: Stage, there: Vessel, coat: Vessel) -> None:
        """Dip what lies somewhere into a coat, of which the rest stays in its bowl."""
        attested = self.bench.require([(stage.motion, stage.tools)], (*foods_of(there), *foods_of(coat)))
        foods, wants = foods_of(coat), frozenset().union(*(one.wants for one in coat.contents))

        def change() -> None:
            for stuff in there.contents:
                stuff.foods = tuple(sorted({*stuff.foods, *foods}))
                stuff.wants = stuff.wants | wants
                stuff.states = tuple(sorted({*stuff.states, "coated"}))
                stuff.mixed = True

        things: list[Thing] = [there, *there.contents, coat, *coat.contents]
        self.bench.emit(attested, things, change, things)
