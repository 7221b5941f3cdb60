"""Small trees played in a kitchen, and the kitchen afterwards told in words."""

from __future__ import annotations

import pytest

from foon_kg.validation.notation import read_tree
from foon_kg.world import World


def story(name, text, told, asked=()):
    """Return a case of a parametrised test: steps, what is told of the kitchen after them, what the recipe asked."""
    return pytest.param(text, told, asked, id=name)


def play(text, asked=()):
    """Return the kitchen in which the steps of ``text`` were played."""
    world = World(asked)
    for unit in read_tree(text).units:
        world.play(unit)
    return world


def faults(world):
    """Return what could not happen: rule, level, step (from 1), nodes and reason."""
    return [
        f"{mishap.rule}{' (minor)' if mishap.minor else ''} step {played_step.number + 1}"
        f"{''.join(f' {node}' for node in mishap.nodes)}: {mishap.reason}"
        for played_step in world.played_steps
        for mishap in played_step.mishaps
    ]


def _told(lump):
    names = sorted(lump.names - {lump.label})
    parts = sorted(part.name for part in lump.parts)
    states = f" ({', '.join(lump.states)})" if lump.states else ""
    also = f" or {' or '.join(names)}" if names else ""
    of = f" of {' + '.join(parts)}" if parts != [lump.label] else ""
    under = f" under {', '.join(sorted(rider.label for rider in lump.riders))}" if lump.riders else ""
    return lump.label + also + states + of + under


def foods(world):
    """Return what is where: ``plate: tomato (sliced)``; ``free`` is what lies nowhere."""
    found = []
    for label, vessels in world.supply.vessels.items():
        found += [f"{label}: {'; '.join(map(_told, vessel.lumps))}" for vessel in vessels if vessel.lumps]
    lumps = dict.fromkeys(lump for listed in world.supply.lumps.values() for lump in listed)
    free = [_told(lump) for lump in lumps if lump.where is None and not lump.gone]
    return sorted(found) + ([f"free: {'; '.join(sorted(free))}"] if free else [])


def vessels(world):
    """Return each vessel in the order in which it appeared: where it stands, what is in it, whether it is on."""
    return [
        label
        + (f" at {vessel.where.label}" if vessel.where else "")
        + ("".join(f" [{told}]" for told in ("covered", "hot") if getattr(vessel, told)))
        + (
            f" on for {sorted(burner for burner, on in vessel.power.items() if on)}"
            if any(vessel.power.values())
            else ""
        )
        + (f" with {', '.join(sorted(lump.label for lump in vessel.lumps))}" if vessel.lumps else "")
        for label, listed in sorted(world.supply.vessels.items())
        for vessel in listed
    ]


def histories(world):
    """Return what was done to each part, with the step (from 0, -1 before) that did it."""
    return [
        f"{part.name}:"
        + "".join(f" {treatment} {step}" for treatment, step in sorted(part.done.items()))
        + (f" fine {part.fine}" if part.fine else "")
        + "".join(
            f" {name} {step}" for name in ("joined", "mixed", "heated") if (step := getattr(part, name)) is not None
        )
        + "".join(f" {name}" for name in ("remains", "unstated", "spoonful") if getattr(part, name))
        for part in world.supply.parts
    ]


def happened(world):
    """Return what the last step did to which things."""
    last = world.played_steps[-1]
    told = {
        "inputs": [lump.label for lump in last.inputs],
        "outputs": [f"{node} is {_told(lump)}" for node, lump in last.outputs.items()],
        "made": [lump.label for lump in last.made],
        "moved": [f"{lump.label} {_at(before)} → {_at(now)}" for lump, before, now in last.moved],
        "taken": [part.name for part in last.taken],
        "treated": [lump.label for lump in last.treated],
        "heated": [vessel.label for vessel in last.heated],
        "hot": [vessel.label for vessel in last.hot],
        "tools": [str(node) for node in last.tools],
        "vessels": [vessel.label for vessel in last.vessels],
    }
    return [f"{name}: {'; '.join(listed)}" for name, listed in told.items() if listed] + (
        ["a vessel moved"] if last.vessels_moved else []
    )


def _at(vessel):
    return vessel.label if vessel else "nowhere"


def told_foods(world):
    """Return the foods, then what could not happen."""
    return foods(world) + faults(world)


def told_outputs(world):
    """Return the foods, what the last step did, then what could not happen."""
    told = [line for line in happened(world) if line.partition(":")[0] in {"made", "moved", "taken", "treated"}]
    return foods(world) + told + faults(world)


def told_power(world):
    """Return the vessels that are warm, on or closed, what was heated last, then what could not happen."""
    warm = [line for line in vessels(world) if "[" in line or " on for " in line]
    heated = [line for line in happened(world) if line.partition(":")[0] in {"heated", "hot"}]
    told = [line.replace(" a appliance", " an appliance") for line in faults(world) if line.startswith("W3")]
    return warm + heated + told


def told_treatment(world):
    """Return the history of each part, then what could not happen."""
    return histories(world) + [told for told in faults(world) if told[0] == "K"]


def told_vessels(world):
    """Return the vessels, then what could not happen."""
    return vessels(world) + faults(world)
