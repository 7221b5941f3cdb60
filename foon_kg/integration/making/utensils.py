"""Which appliance and which vessel a stage takes: those of the video where they suit."""

from __future__ import annotations

from foon_kg.food import Tables
from foon_kg.food.rows import Utensil
from foon_kg.integration.bench import Bench, Vessel
from foon_kg.integration.teaching.frames import HEATS, Stage


class Utensils:
    """Chooses utensils for stages on a bench: what the video has is taken only where the world allows it (W3)."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.known: Tables = bench.known

    def device_for(self, stage: Stage) -> tuple[str, str]:
        """Return the appliance of a stage and how it holds its vessel (``"on"``, ``"in"``, ``""`` by hand)."""
        if not self._needs_device(stage):
            return "", ""
        row = self._appliance_of(stage)
        if row is None:
            return "", ""
        if row.source == "power" and not row.holds:
            return row.name, ""
        if "wait" in stage.does and row.source != "cold":
            return "", ""
        return row.name, "attached to" if row.holds == "attached" else row.holds

    def _needs_device(self, stage: Stage) -> bool:
        """Whether a stage heats, blends or waits, is powered, or is stirred where it stands over the heat."""
        if not stage.does.isdisjoint(HEATS | {"blend", "wait"}) or stage.source == "power":
            return True
        own = self.known.utensil(stage.vessel) if stage.vessel else None
        stands = own is None or own.role != "vessel" or not own.can.isdisjoint({"bake", "cook", "heat"})
        return stage.source == "heat" and stands and not stage.does.isdisjoint({"mix", "turn"})

    def _appliance_of(self, stage: Stage) -> Utensil | None:
        """Return the appliance of the video where it suits, else the usual one; of one kind that is in use already."""
        row = self._shown(stage)
        if row is None or row.role != "appliance":
            return None
        if row.source == "heat" and row.holds == "on" and stage.vessel == stage.appliance:
            return self.known.utensil("stove") or row  # food lies on it in the video; in a pan it comes on a stove
        return self._used_like(row) or row if row.source == "power" else row

    def _shown(self, stage: Stage) -> Utensil | None:
        """Return the appliance of the video, or what usually heats, where a stage heats and that does not."""
        row = self.known.utensil(stage.appliance) if stage.appliance else None
        if stage.heats and (row is None or row.source != "heat"):
            return self.known.utensil("oven" if "dry" in stage.does else "stove")
        return row

    def _used_like(self, row: Utensil) -> Utensil | None:
        """Return an appliance of the same kind that is in use already."""
        used = map(self.known.utensil, self.bench.devices)
        return next((other for other in used if other is not None and other.group == row.group), None)

    def vessel_label(self, stage: Stage, vessel: Vessel | None, device: str) -> str:
        """Return which vessel a stage takes; ``vessel`` is the one in which the whole is as yet.

        ``device`` is the appliance that it comes to, if any.
        """
        heater = self._heater(device)
        if self._is_vessel(stage.vessel) and self._can_stand(stage.vessel, heater, stage):
            return stage.vessel
        if vessel is not None and self._can_stand(vessel.label, heater, stage):
            return vessel.label
        if heater is not None:
            return _over_heat(stage, heater)
        return "cutting board" if stage.relation == "on" and stage.does & {"knead", "shape"} else "bowl"

    def _heater(self, device: str) -> Utensil | None:
        """Return an appliance if it gives heat."""
        row = self.known.utensil(device) if device else None
        return row if row is not None and row.source == "heat" else None

    def _is_vessel(self, label: str) -> bool:
        row = self.known.utensil(label) if label else None
        return row is not None and row.role in {"vessel", "wrap"}

    def _can_stand(self, label: str, heater: Utensil | None, stage: Stage) -> bool:
        """Whether a vessel can be where a stage heats it, if it does: what a microwave can warm bears no oven."""
        if heater is None:
            return True
        row = self.known.utensil(label)
        if row is None:
            return False
        inside = {"bake"} if "dry" in stage.does else {"bake", "microwave"}
        return bool(row.can & {"in": inside, "on": {"heat", "cook"}}.get(heater.holds, set()))


def _over_heat(stage: Stage, heater: Utensil) -> str:
    """Return in what is heated what comes from elsewhere."""
    if heater.holds == "in":
        return "baking tray"
    return "pot" if "liquid" in stage.does else "cooking pan"
