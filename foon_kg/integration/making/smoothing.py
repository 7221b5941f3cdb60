"""Stirring smooth with cold water what would make lumps in a hot liquid: starch, and flour without fat to fry in."""

from __future__ import annotations

from foon_kg.food import Food
from foon_kg.food.lists import says, word_list
from foon_kg.integration.bench import Vessel, foods_of
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.hands import Hands
from foon_kg.integration.making.outcome import MIXTURE


class Smoothing(Hands):
    """Stirs on a bench what binds a sauce."""

    def made(self, join: Join, vessel: Vessel) -> Vessel | None:
        """Stir the food of ``join`` smooth in a bowl of its own and return that, if it would come dry into hot liquid.

        ``vessel`` is what it joins; ``None`` is returned where it joins as it is.
        """
        stuff = self.ready[join.want.number].stuff
        if not self._makes_lumps(join, vessel) or stuff.mixed or says(stuff.states, "runs"):
            return None
        bowl = self.bench.vessel("bowl")
        self.carry.bring(self.ready[join.want.number], bowl, None)
        self.carry.water.add(bowl)
        self.work.stir(bowl, MIXTURE)
        return bowl

    def _makes_lumps(self, join: Join, vessel: Vessel) -> bool:
        """Whether a food makes lumps in what is in a vessel, and no batter or dough with what comes to it."""
        if join.want.facts.kind not in word_list("makes lumps") or not vessel.hot:
            return False
        if any(one.want.facts.is_any(word_list("makes no sauce of what binds")) for one in self.plan.joins):
            return False
        foods = [self.known.foods.food(food) for food in foods_of(vessel)]
        return any(food.is_of(*word_list("is a bath")) or self._runs(food) for food in foods)

    @staticmethod
    def _runs(food: Food) -> bool:
        return food.is_a("liquid", "creamy") and not food.is_a("fat")
