"""What only gives its taste is taken out: lifted out of the dish, or left in a strainer."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from foon_kg.food import Tables, words
from foon_kg.food.lists import word_list
from foon_kg.food.rows import POWDER
from foon_kg.integration.bench import Bench, Stuff, Vessel, fineness, foods_of, is_heated
from foon_kg.integration.joining.course import Plan
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.operators import Attested, Way

_LEAST = 2
"""Of so many foods has to be what one is taken out of: something has to stay."""


class TakingOut:
    """Takes foods out of one dish on a bench."""

    def __init__(self, bench: Bench, plan: Plan) -> None:
        self.bench = bench
        self.known: Tables = bench.known
        self.plan = plan

    def _is_taken_out(self, want: Want) -> bool:
        """Whether a food only gives its taste, and nobody eats or drinks it."""
        if want.facts.is_any(word_list("is taken out of the dish")):
            return True
        powder = bool(want.make) and fineness([want.make], self.known) >= POWDER  # nothing of it stays in a strainer
        return self.plan.in_glass and not powder and want.facts.is_any(word_list("is taken out of what is drunk"))

    def is_due(self, vessel: Vessel) -> bool:
        """Return whether something in ``vessel`` only gives its taste."""
        return bool(self._to_take_out(vessel))

    def holds_leaves(self, vessel: Vessel) -> bool:
        """Return whether something in ``vessel``, among other foods, only gives its taste, and tongs find it there."""
        found = [want for want in self._to_take_out(vessel) if self._is_in_one_piece(want)]
        return len(vessel.contents) > 1 and any(not want.facts.is_a("spice") for want in found)

    def take_out(self, vessel: Vessel) -> Vessel:
        """Take out of what was cooked in a liquid in ``vessel`` what only gave its taste, where the FOON shows how.

        Return what the rest is in then: what is drunk is poured through a strainer.
        """
        wants = self._to_take_out(vessel)
        loose = any(not want.facts.is_any(word_list("is taken out of the dish")) for want in wants)
        if self.plan.in_glass and loose and len(vessel.contents) == 1:  # a bag or a stick is lifted out
            return self._strain(vessel, wants)
        ways = self.lifting_ways()
        for whole in list(vessel.contents):
            lifted = self._liftable(whole, wants)
            attested = self.bench.near_or_far(ways, lifted[0].names) if lifted else None
            if attested is not None:
                self.lift(vessel, whole, lifted, attested, self.bench.vessel("plate"))
        return vessel

    def strained(self, vessel: Vessel) -> Vessel:
        """Pour what was blended in ``vessel`` through a strainer, in which stays what does not run.

        Return what the rest is in.
        """
        wants = self.inside(vessel, lambda want: want.facts.is_any(word_list("stays in a strainer")))
        return self._strain(vessel, wants) if wants and len(vessel.contents) == 1 else vessel

    def _to_take_out(self, vessel: Vessel) -> list[Want]:
        """Return what only gives its taste to what is in a vessel, and was not ground to a paste before."""
        ground = {join.want.number for join in self.plan.joins if "blend" in join.spot.stage.does}
        return [
            want for want in self.inside(vessel, self._is_taken_out) if self.plan.in_glass or want.number not in ground
        ]

    def inside(self, vessel: Vessel, is_such: Callable[[Want], bool]) -> list[Want]:
        """Return the asked foods in a ``vessel`` for which ``is_such`` holds."""
        inside = {number for stuff in vessel.contents for number in stuff.wants}
        return [join.want for join in self.plan.joins if join.want.number in inside and is_such(join.want)]

    # --- lifted out ---

    def lifting_ways(self) -> list[Way]:
        """Return the ways by which something is lifted out of the rest."""
        return [way for way in self.bench.ways_by(word_list("takes out")) if self._lifts(way)]

    def _lifts(self, way: Way) -> bool:
        """Whether a way is done with a tool that lifts."""
        rows = map(self.known.utensil, way[1])
        return any(row is not None and "lift" in row.can for row in rows)

    def _liftable(self, whole: Stuff, wants: Sequence[Want]) -> list[Want]:
        """Return of some foods those that are in one piece in a mixture, which is more than one food without them."""
        lifted = [want for want in wants if want.number in whole.wants and self._is_in_one_piece(want)]
        return lifted[: max(0, len(whole.wants) - _LEAST + 1)]

    def _is_in_one_piece(self, want: Want) -> bool:
        """Whether a food is still in one piece that can be lifted out: no chopped herb, nor leaves off their stem."""
        states = [state for state in (want.make, want.then, *want.leaf) if state]
        plucked = word_list("is plucked off its stem")
        if want.facts.is_any(word_list("is a leaf by itself")):
            states = [state for state in states if state not in plucked]
        elif not plucked.isdisjoint(words(want.label)):
            return False
        return plucked.isdisjoint(states) and fineness(states, self.known) == 0

    def lift(
        self,
        vessel: Vessel,
        whole: Stuff,
        wants: Sequence[Want],
        attested: Attested,
        target: Vessel,
        *,
        asked: bool = False,
    ) -> None:
        """Lift ``wants`` out of the ``whole`` in a ``vessel`` onto ``target``, in the way that is ``attested``.

        They are still ``asked`` for, unless they only gave their taste. What was not heated is as raw as before.
        """
        parts = self._parts(wants, ("cooked",), target, asked=asked)
        if not vessel.hot and not is_heated(whole.states, self.known):
            for want, part in zip(wants, parts, strict=True):
                part.states = self._as_before(want)

        def change() -> None:
            _forget(whole, wants)
            target.contents += parts

        self.bench.emit(attested, [vessel, whole, target], change, [vessel, whole, target, *parts])

    def _as_before(self, want: Want) -> tuple[str, ...]:
        """Return the states of a food that comes raw out of a mixture: it is no longer as it was bought."""
        states = (want.make,) if want.make else want.leaf
        return tuple(state for state in states if not self.known.state(state).undivided)

    # --- strained ---

    def _strain(self, vessel: Vessel, wants: Sequence[Want]) -> Vessel:
        """Pour what is drunk through a strainer, in which stays what gave its taste; return what the rest is in."""
        attested = self.bench.near_or_far(self.bench.ways_by(word_list("strains")), foods_of(vessel))
        if attested is None:
            return vessel
        strainer, jug = self.bench.vessel("strainer"), self.bench.vessel("pitcher")
        (whole,) = vessel.contents
        whole_states = tuple(state for state in whole.states if state in {"blended", "cooked"})
        left = self._parts(wants, whole_states, strainer)

        def change() -> None:
            _forget(whole, wants)
            strainer.contents += left
            vessel.contents.clear()
            jug.contents.append(whole)
            whole.at = jug

        self.bench.emit(attested, [vessel, whole, strainer, jug], change, [jug, whole, strainer, *left, vessel])
        return jug

    def _parts(
        self, wants: Sequence[Want], states: tuple[str, ...], place: Vessel, *, asked: bool = False
    ) -> list[Stuff]:
        """Return the foods that come out of a mixture into ``place``; unless ``asked`` nobody looks for them then."""
        return [
            Stuff(want.label, self.bench.number(), states, (want.label,), _numbers(want, asked=asked), place)
            for want in wants
        ]


def _numbers(want: Want, *, asked: bool) -> frozenset[int]:
    return frozenset({want.number} if asked else ())


def _forget(whole: Stuff, wants: Sequence[Want]) -> None:
    """Have a mixture without some foods."""
    whole.foods = tuple(food for food in whole.foods if food not in {want.label for want in wants})
    whole.wants -= {want.number for want in wants}
