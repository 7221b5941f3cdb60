"""Which appliance and which vessel a stage takes: those of the video where they suit."""

from __future__ import annotations

from foon_kg.food import Tables
from foon_kg.food.rows import Utensil
from foon_kg.integration.bench import Bench, Vessel
from foon_kg.integration.joining.course import HEATS
from foon_kg.integration.teaching.frames import Stage


class Utensils:
    """Chooses utensils for stages on a bench."""

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
        row = self.known.utensil(stage.appliance) if stage.appliance else None
        if not stage.does.isdisjoint(HEATS) and (row is None or row.source != "heat"):
            row = self.known.utensil("oven" if "dry" in stage.does else "stove")
        if row is None or row.role != "appliance":
            return None
        if row.source == "heat" and row.holds == "on" and stage.vessel == stage.appliance:
            return self.known.utensil("stove") or row  # food lies on it in the video; in a pan it comes on a stove
        if row.source == "power":
            used = (self.known.utensil(label) for label in self.bench.devices)
            return next((other for other in used if other is not None and other.group == row.group), row)
        return row

    def vessel_label(self, stage: Stage, vessel: Vessel | None, device: str) -> str:
        """Return which vessel a stage takes; ``vessel`` is the one in which the whole is as yet."""
        row = self.known.utensil(stage.vessel) if stage.vessel else None
        fits = row is not None and row.role in {"vessel", "wrap"}
        if device and fits and row is not None:
            appliance = self.known.utensil(device)
            if appliance is not None and appliance.source == "heat":
                fits = self._can_stand(stage.vessel, device, stage)
        if fits:
            return stage.vessel
        if device:
            appliance = self.known.utensil(device)
            if appliance is not None and appliance.source == "heat":
                if vessel is not None and self._can_stand(vessel.label, device, stage):
                    return vessel.label
                if appliance.holds == "in":
                    return "baking tray"
                return "pot" if "liquid" in stage.does else "cooking pan"
        if vessel is None:
            return "cutting board" if stage.relation == "on" and stage.does & {"knead", "shape"} else "bowl"
        return vessel.label

    def _can_stand(self, label: str, device: str, stage: Stage) -> bool:
        """Whether a vessel can be where a stage heats it: what a microwave can warm does not bear an oven."""
        row, appliance = self.known.utensil(label), self.known.utensil(device)
        if row is None or appliance is None:
            return False
        inside = {"bake"} if "dry" in stage.does else {"bake", "microwave"}
        return bool(row.can & {"in": inside, "on": {"heat", "cook"}}.get(appliance.holds, set()))
