"""How a dish is finished: dressed once it is drained, shaped to portions, and brought to what it is eaten from."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food.lists import says, word_list
from foon_kg.integration.bench import RefusedError, Stuff, Vessel, is_baked, is_flat
from foon_kg.integration.joining.course import WORKS
from foon_kg.integration.joining.spots import Join
from foon_kg.integration.making.consistency import is_wet
from foon_kg.integration.making.hands import Hands
from foon_kg.integration.making.stages import Stages
from foon_kg.integration.teaching.frames import Stage

_SHAPED = "shaped"


class Serving(Hands):
    """Finishes one dish on a bench."""

    @staticmethod
    def in_layers(joins: Sequence[Join]) -> list[Join]:
        """Return what joins a stage, in the order in which it is laid on dough."""
        return sorted(joins, key=lambda join: join.layer)

    def dress(self, vessel: Vessel, tops: Sequence[Join]) -> None:
        """Mix what came into ``vessel`` to a dish that was done, and lay the ``tops`` on it, which only lie there."""
        self.work.stir(vessel, self.plan.label)
        for join in tops:
            self.bring(join, vessel)
            self.work.name(vessel, self.plan.label)

    def is_dressed(self, stage: Stage, vessel: Vessel | None, joins: Sequence[Join], later: Sequence[Stage]) -> bool:
        """Return whether ``joins`` bring to a dish that is done in ``vessel`` what is no topping and stays unmixed.

        ``stage`` is where they join, ``later`` are those that come then.
        """
        if not stage.does.isdisjoint(WORKS) or any(not one.does.isdisjoint(WORKS) for one in later):
            return False
        if vessel is not None and any(map(is_baked, vessel.contents)):
            return False  # on what comes out of the oven in one piece it only lies
        return any(join.slot is None and not self.lies_on_top(join) for join in joins)

    @staticmethod
    def lies_on_top(join: Join) -> bool:
        """Return whether the food of ``join`` only lies on a dish that is done, or beside it."""
        return join.on_top or join.want.facts.is_a("topping", "herb", *word_list("is served with what is fried"))

    def portions(self, stage: Stage, vessel: Vessel) -> str:
        """Return what the mass in ``vessel`` is called when a stage shapes it, ``""`` where it stays in one piece."""
        if stage.motion not in word_list("shapes portions") or len(vessel.contents) != 1 or is_flat(vessel.label):
            return ""
        if stage.label in word_list("is in portions"):
            return stage.label
        mass, kinds = vessel.contents[0], word_list("patties are made of")
        alone = self.known.foods.food(mass.label).is_any(word_list("is shaped by itself"))
        held = alone or (mass.mixed and any(self.known.foods.food(food).is_any(kinds) for food in mass.foods))
        in_one = says(self.plan.label.split(), "is shaped in one piece")
        return min(word_list("is called so in portions")) if held and not in_one else ""

    def shaped(self, stage: Stage, vessel: Vessel, label: str) -> Vessel:
        """Shape the mass in ``vessel`` to portions called ``label``, as ``stage`` does; return the plate of them."""
        plate, (mass,) = self.bench.vessel("plate"), vessel.contents
        attested = self.work.ways.way(stage, vessel)
        if attested is None:
            return vessel
        whole = Stuff(label, self.bench.number(), (_SHAPED,), mass.foods, mass.wants, plate, mixed=True)

        def change() -> None:
            vessel.contents.clear()
            plate.contents.append(whole)

        self.bench.emit(attested, [plate, vessel, mass], change, [plate, whole, vessel])
        return plate

    def served(self, vessel: Vessel, stage: Stage, stages: Stages) -> Vessel:
        """Turn everything off and serve the dish, where nobody eats out of ``vessel``; return what it is in then.

        ``stage`` is the last one of its line; ``stages`` says what is served on a plate, and what in portions.
        """
        self.bench.heat_off(vessel)
        self.bench.all_off()
        group, dish = self._group(vessel), vessel.contents[0]
        if self.plan.in_glass and group in word_list("is not drunk from"):
            return self._brought(vessel, "mug" if vessel.hot else "drinking glass", stage)
        if not self._is_cooked_in(vessel) or "chilled" in dish.states:
            return vessel
        if len(vessel.contents) > 1 or dish.label != self.plan.label:
            self.work.name(vessel, self.plan.label)
        if group in word_list("is served in what it is baked in") and stages.has_no_portions():
            return vessel
        return self._on_a_dish(vessel, stage, stages)

    def _on_a_dish(self, vessel: Vessel, stage: Stage, stages: Stages) -> Vessel:
        """Bring what is in a vessel to what suits it, where the FOON shows how; return in what it is then."""
        try:
            return self._brought(vessel, self._dish_for(vessel, stages), stage)
        except RefusedError:  # nobody of this FOON serves such a dish
            return vessel

    def _dish_for(self, vessel: Vessel, stages: Stages) -> str:
        """Return what suits what is in a vessel: a bowl what runs, unless it is carved or has a side."""
        on_plate = stages.on_plate or self.plan.has_a_side
        return "bowl" if is_wet(vessel.contents[0], self.known) and not on_plate else "plate"

    def _brought(self, vessel: Vessel, label: str, stage: Stage) -> Vessel:
        target = self.bench.vessel(label)
        self.carry.transfer(vessel, target, stage)
        return target

    def _group(self, vessel: Vessel) -> str:
        row = self.known.utensil(vessel.label)
        return row.group if row is not None else ""

    def _is_cooked_in(self, vessel: Vessel) -> bool:
        row = self.known.utensil(vessel.label)
        return row is not None and not row.can.isdisjoint({"heat", "cook", "bake"})
