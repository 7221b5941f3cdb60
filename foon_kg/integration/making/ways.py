"""In which way a stage is done to what is in a vessel: nearest to what the FOON attests."""

from __future__ import annotations

from collections.abc import Sequence, Set

from foon_kg.food import Tables
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, RefusedError, Stuff, Vessel, fineness, foods_of
from foon_kg.integration.joining.course import COATS, MIXES, WORKS
from foon_kg.integration.teaching.frames import HEATS, Asked, Phase, Stage
from foon_kg.integration.teaching.operators import Attested, Nearness, Way


class Ways:
    """Chooses the ways in which stages are done on a bench."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.known: Tables = bench.known

    def way(self, stage: Stage, vessel: Vessel) -> Attested | None:
        """Return how a stage is done to what is in the vessel, or ``None`` where it is left out.

        Raises :class:`~foon_kg.integration.bench.RefusedError` where nothing attests what cannot be left out.
        """
        foods = foods_of(vessel)
        if stage.does >= COATS:
            return self.bench.require([(stage.motion, stage.tools)], foods)
        if stage.does >= {"heat", "mix"} and any(map(self._is_in_one_piece, vessel.contents)):
            return self.bench.require(self.cooking(), foods)
        if stage.motion in word_list("needs a closed vessel") and not _is_closed(vessel):
            return self.stirring(foods)
        if "heat" in stage.does and "heat" not in self.known.motion(stage.motion).does:
            return self.stirring_hot(foods)
        tooled = self._with_a_tool(stage, foods) if _is_mixed_by_hand(stage, vessel) else None
        return tooled or self._attested(stage, foods)

    def _is_in_one_piece(self, stuff: Stuff) -> bool:
        """Whether it is turned in one piece, and nobody cut it: no spoon stirs that."""
        facts = self.known.foods.food(stuff.label)
        turned = not stuff.mixed and facts.is_any(word_list("is turned in one piece"))
        return turned and fineness(stuff.states, self.known) == 0

    def stirring(self, foods: Sequence[str]) -> Attested:
        """Return the likeliest way to mix foods through with a tool, as they are."""
        return self.bench.require([way for way in self._doing({"mix"}, "mix") if way[1]], foods)

    def stirring_hot(self, foods: Sequence[str]) -> Attested:
        """Return the likeliest way to cook foods while they are mixed with a tool: no bare hand does that."""
        return self.bench.require([way for way in self._doing({"heat", "mix"}, "heat") if way[1]], foods)

    def cooking(self) -> list[Way]:
        """Return the ways that do nothing but heat, and after which food may be eaten."""
        return [way for way in self._doing({"heat"}, "heat") if "cooked" in self.known.motion(way[0]).gives]

    def turning(self) -> list[Way]:
        """Return the ways that do nothing but turn food over."""
        return self._doing({"turn"}, "turn")

    def _doing(self, does: Set[str], main: str) -> list[Way]:
        """Return the ways that do just this, the most frequent first; ``main`` is one thing of it."""
        return [way for way in self.bench.operators.ways.get(main, ()) if self.known.motion(way[0]).does == does]

    def _with_a_tool(self, stage: Stage, foods: Sequence[str]) -> Attested | None:
        """Return how the motion of a stage is done with a tool to such foods, or to like ones."""
        tooled = [way for way in self.bench.operators.ways_of(stage.motion) if way[1]]
        found = self.bench.attest(tooled, foods)
        return found if found is not None and found.nearness <= Nearness.LIKE else None

    def _attested(self, stage: Stage, foods: Sequence[str]) -> Attested | None:
        """Return how the motion of a stage is done, as its video does it where that is as near as another way."""
        if stage.motion in word_list("cools"):
            return self.bench.cooling(foods)
        own = self.bench.attest([(stage.motion, stage.tools)], foods)
        if own is not None and own.nearness <= Nearness.LIKE:
            return own
        found = self.bench.attest(self.bench.operators.ways_of(stage.motion), foods)
        if found is not None and (own is None or found.nearness < own.nearness):
            return found
        return own or self._in_its_stead(stage, foods)

    def _in_its_stead(self, stage: Stage, foods: Sequence[str]) -> Attested | None:
        """Return a way that does what a stage does, where its own motion is attested for nothing like these foods."""
        own = [(stage.motion, stage.tools)]
        found = self.bench.far(own, foods) if _is_the_same_for_any(stage) else None
        if found is None:
            main = "heat" if "heat" in stage.does else min(stage.does & WORKS, default="")
            found = self.bench.attest(self._doing(stage.does, main), foods)
        if found is None and (isinstance(stage, Phase) or stage.does >= {"dry", "heat"}):
            found = self.bench.far(own, foods)
        return found or self._at_last(stage, foods)

    def _at_last(self, stage: Stage, foods: Sequence[str]) -> Attested | None:
        """Return how a stage is done that nothing attests: where nobody kneads, it is stirred together."""
        if "knead" in stage.does:
            return self.stirring(foods)
        if not stage.does.isdisjoint(MIXES | HEATS):
            raise RefusedError(f"nothing attests “{stage.motion}” for {', '.join(foods)}")
        return None


def _is_closed(vessel: Vessel) -> bool:
    return bool(vessel.lid) or vessel.label in word_list("closed vessels")


def _is_mixed_by_hand(stage: Stage, vessel: Vessel) -> bool:
    """Whether a stage mixes with no tool what nothing heats and no machine turns, and is no work for hands (dough)."""
    if stage.tools or stage.appliance or vessel.device is not None:
        return False
    return not stage.does.isdisjoint({"mix", "whip", "mash"}) and stage.does.isdisjoint({"shape", "knead"})


def _is_the_same_for_any(stage: Stage) -> bool:
    """Whether a stage is done to any food alike: to roll, pinch and cut are, and what blades and cold do."""
    chilled = stage.source == "cold" and "wait" in stage.does
    if stage.does in ({"shape"}, {"cut"}) or "blend" in stage.does or chilled:
        return True
    return isinstance(stage, Asked) or stage.motion in word_list("pulls flesh apart")
