"""Which appliance and which vessel a stage takes: those of the video where they suit."""

from __future__ import annotations

from foon_kg.food import Tables
from foon_kg.integration.bench import Bench, Vessel
from foon_kg.integration.course import HEATS
from foon_kg.integration.frames import Stage


class Utensils:
    """Chooses utensils for stages on a bench."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.known: Tables = bench.known

    def device_for(self, stage: Stage) -> tuple[str, str]:
        """Return the appliance of a stage and how it holds its vessel (``"on"``, ``"in"``, ``""`` by hand)."""
        own = self.known.utensil(stage.vessel) if stage.vessel else None
        stands = own is None or own.role != "vessel" or not own.can.isdisjoint({"bake", "cook", "heat"})
        over_heat = stage.source == "heat" and stands and not stage.does.isdisjoint({"mix", "turn"})
        if stage.does.isdisjoint(HEATS | {"blend", "wait"}) and stage.source != "power" and not over_heat:
            return "", ""
        row = self.known.utensil(stage.appliance) if stage.appliance else None
        if not stage.does.isdisjoint(HEATS) and (row is None or row.source != "heat"):
            row = self.known.utensil("oven" if "dry" in stage.does else "stove")
        if row is None or row.role != "appliance":
            return "", ""
        if row.source == "heat" and row.holds == "on" and stage.vessel == stage.appliance:
            row = self.known.utensil("stove") or row  # food lies on it in the video; in a pan it comes on a stove
        if row.source == "power":
            used = (self.known.utensil(label) for label in self.bench.devices)
            row = next((other for other in used if other is not None and other.group == row.group), row)
        if row.source == "power" and not row.holds:
            return row.name, ""
        if "wait" in stage.does and row.source != "cold":
            return "", ""
        holds = "attached to" if row.holds == "attached" else row.holds
        return row.name, holds

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
