"""Appliances: what is on, over which heat something stands, what is closed (contract W3)."""

from __future__ import annotations

from itertools import pairwise

from foon_kg.model import ObjectNode
from foon_kg.world.played_step import PlayedStep
from foon_kg.world.reading import NodeReading
from foon_kg.world.supply import Supply
from foon_kg.world.things import Lump, Vessel

_SWITCHES = ("switch on", "switch off")


def check_inputs(played_step: PlayedStep) -> None:
    """Tell what of the step ``played_step`` cannot be, by what its appliances and hot vessels are.

    That is an appliance that is not as its input node says or has nothing to work with, food behind closed doors, a
    vessel that is not hot, and what is attached to nothing.
    """
    utensils = [said for said in played_step.input_readings if said.utensil is not None]
    for vessel, said in zip(played_step.vessels, utensils, strict=True):
        if vessel.is_appliance:
            _check_power(vessel, said, said.node, played_step)
        elif said.hot:
            _check_hot(vessel, said.node, played_step)
    _check_source(played_step)
    if played_step.does("attach") or (played_step.does("detach") and not played_step.does("fetch")):
        _check_attached(played_step)


def burner_of(said: NodeReading) -> str:
    """Return the burner that ``said``, an appliance's node, names: the vessel that stands on it; ``""`` for none."""
    return said.covers or (said.place or "" if said.place_utensil is not None else "")


def _check_power(vessel: Vessel, said: NodeReading, node: ObjectNode, played_step: PlayedStep) -> None:
    """Tell an appliance that is off where its node says on, or on where it says off."""
    if vessel.row.always_on:
        return
    burner = burner_of(said)
    on = vessel.is_on(burner)
    if said.on and not on:
        played_step.fault("W3", f"the {vessel.label} is said to be on, and nobody turned it on", node)
        _light(vessel, burner)
    elif said.off and on and (burner in vessel.power or vessel.row.power != "vessel"):
        # what is only taken away from it can be taken from an oven that is on: the hand is burnt, the dish is not
        leaves = played_step.does("fetch", "separate", "move") and not played_step.does("heat", "attach", "detach")
        reason = f"the {vessel.label} is said to be off, and it is on"
        played_step.fault("W3", reason, node, minor=leaves and vessel.row.source == "heat")


def _light(vessel: Vessel, burner: str) -> None:
    """Let an appliance be on for a burner, so that the fault of one who did not turn it on is told once."""
    vessel.power[burner if vessel.row.power == "vessel" else ""] = True


def _check_hot(vessel: Vessel, node: ObjectNode, played_step: PlayedStep) -> None:
    """Tell a vessel that is hot on a source that nobody lit; what was hot once may still be so."""
    source = vessel.where
    if source is None or source.row.source != "heat" or vessel.hot:
        return
    if not source.is_on(vessel.label):
        played_step.fault("W3", f"the {vessel.label} is said to be hot, and the {source.label} is off", node)
        _light(source, vessel.label)
    vessel.hot = True


def _check_source(played_step: PlayedStep) -> None:
    """Tell work that takes heat or power, and that has no source of it, or one that is off."""
    source = played_step.motion.source
    if source not in {"heat", "power"} or played_step.does(*_SWITCHES):
        return
    sources = sources_of(played_step, source)
    if not sources:
        what = "a heat source" if source == "heat" else "an appliance"
        played_step.fault("W3", f"“{played_step.step.motion}” without {what}", *nodes_of(played_step))
    elif not any(vessel.is_on(burner) for vessel, burner in sources):
        names = ", ".join(sorted({vessel.label for vessel, _ in sources}))
        played_step.fault("W3", f"“{played_step.step.motion}” while the {names} is off", *nodes_of(played_step))
        for vessel, burner in sources:
            _light(vessel, burner)


def nodes_of(played_step: PlayedStep) -> tuple[ObjectNode, ...]:
    """Return the node that a fault of the whole of ``played_step`` is told of: its first input, if it has any."""
    return tuple(mention.node for mention in played_step.step.inputs[:1])


def sources_of(played_step: PlayedStep, source: str) -> list[tuple[Vessel, str]]:
    """Return the appliances that give ``source`` (heat, power) in the step ``played_step``, each with the burner.

    These are inputs, and what an input stands on.
    """
    found: list[tuple[Vessel, str]] = []
    vessels = [*played_step.vessels, *(lump.where for lump in played_step.inputs if lump.where is not None)]
    for vessel in vessels:
        if _gives(vessel, source):
            found.append((vessel, next((other.label for other in vessels if other.where is vessel), "")))
        found += [(place, above.label) for above, place in pairwise(vessel.stack()) if _gives(place, source)]
    return found


def _gives(vessel: Vessel, source: str) -> bool:
    return vessel.is_appliance and vessel.row.source == source


def heated_vessels(played_step: PlayedStep) -> list[Vessel]:
    """Return the vessels in which a step that cooks works: all that hold food and take part in ``played_step``.

    Storage and tools are none of them.
    """
    vessels = [vessel for vessel in played_step.vessels if vessel.lumps]
    vessels += [lump.where for lump in played_step.inputs if lump.where is not None]
    found: list[Vessel] = []
    for vessel in vessels:
        if vessel not in found and vessel.row.role not in {"storage", "tool"}:
            found.append(vessel)
    return found


def stands_in_oven(vessel: Vessel) -> bool:
    """Whether ``vessel`` stands in what heats from all sides."""
    return any(place.row.source == "heat" and place.row.holds == "in" for place in vessel.stack())


def _check_attached(played_step: PlayedStep) -> None:
    for vessel in played_step.vessels:
        if vessel.is_appliance and vessel.row.holds == "attached" and vessel.is_on():
            verb = "attached to" if played_step.does("attach") else "taken from"
            played_step.fault("W3", f"something is {verb} the {vessel.label} while it runs", *nodes_of(played_step))


def check_outputs(supply: Supply, played_step: PlayedStep) -> None:
    """Switch what the motion switches in the kitchen of ``supply``, and tell what enters or leaves something closed.

    Both are as ``played_step``, the step, says by its outputs.
    """
    for said in played_step.output_readings:
        if said.is_appliance:
            _switch(supply, said, said.node, played_step)
    for lump, before, now in played_step.moved:
        if lump in played_step.made or played_step.is_made_of(lump, before) or _same_stack(before, now):
            continue
        for vessel in (before, now):
            if vessel is not None and vessel.covered:
                _closed(vessel, lump, played_step)


def _same_stack(before: Vessel | None, now: Vessel | None) -> bool:
    """Whether both are one place, or one stands in the other: what is in a covered pan stays in it."""
    return before is now or (before is not None and now is not None and (before.where is now or now.where is before))


def _closed(vessel: Vessel, lump: Lump, played_step: PlayedStep) -> None:
    if played_step.does("close", "uncover", "open", "attach", "blend", "mix") or vessel.row.role not in {
        "vessel",
        "appliance",
    }:
        return
    played_step.fault(
        "W3", f"the {vessel.label} is closed, and {lump.label} enters or leaves it", *nodes_of(played_step)
    )
    vessel.covered = False


def _switch(supply: Supply, said: NodeReading, node: ObjectNode, played_step: PlayedStep) -> None:
    vessel = supply.appliance(said.label)
    if vessel.row.always_on:
        return
    burner = burner_of(said) if vessel.row.power == "vessel" else ""
    if not (said.on or said.off):
        if played_step.does(*_SWITCHES):
            _turn(vessel, burner, on=played_step.does("switch on"))
        return
    if said.on and not vessel.is_on(burner) and not played_step.does(*_SWITCHES):
        played_step.fault("W3", f"the {vessel.label} is on afterwards, and nobody turned it on", node)
    if played_step.does(*_SWITCHES):
        _turn(vessel, burner, on=said.on)
    else:
        vessel.power[burner] = said.on
    _name_burner(supply, vessel, burner)


def _name_burner(supply: Supply, vessel: Vessel, burner: str) -> None:
    """Let the burner that is on before the first step be the first that is named."""
    if burner and vessel.label in supply.found_on:
        vessel.power.pop("", None)


def _turn(vessel: Vessel, burner: str, *, on: bool) -> None:
    """Turn an appliance on or off; without a burner it is turned as a whole."""
    vessel.power[burner] = on
    if not burner:
        vessel.power = dict.fromkeys(vessel.power, on)


def hot_vessels(supply: Supply) -> list[Vessel]:
    """Return the vessels of the kitchen ``supply`` that hold food and stand over heat that is on."""
    return [vessel for vessel in supply.burning() if vessel.lumps]
