"""Steam: food stands in it above a liquid that boils, under a lid, and does not lie in that liquid (contract W3)."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.world.played_step import PlayedStep
from foon_kg.world.power import heated_vessels, nodes_of
from foon_kg.world.things import Vessel


def check_inputs(played_step: PlayedStep) -> None:
    """Tell what of ``played_step``, a step that steams, cannot be or is odd, by what its food stands in and over."""
    if not played_step.does("steam"):
        return
    holding = heated_vessels(played_step)
    below = {id(place) for vessel in holding for place in _below(vessel)}
    for vessel in holding:
        if id(vessel) not in below and not vessel.is_appliance:
            _check(vessel, played_step)


def _check(vessel: Vessel, played_step: PlayedStep) -> None:
    """Tell why what is in ``vessel`` is not steamed there, if it is not."""
    below = _below(vessel)
    if _makes_its_own(vessel, below):
        return
    if not any(map(_has_liquid, below)):
        lies = _has_liquid(vessel)
        what = f"what is in the {vessel.label} lies in the liquid" if lies else f"no water is under the {vessel.label}"
        played_step.fault("W3", f"“{played_step.step.motion}”, and {what}", *nodes_of(played_step))
    elif not any(place.covered for place in (vessel, *below)):
        reason = f"the steam leaves the {vessel.label}: no lid is on it"
        played_step.fault("W3", reason, *nodes_of(played_step), minor=True)


def _below(vessel: Vessel) -> Sequence[Vessel]:
    """Return what a vessel stands in or on, and what that stands in or on."""
    return list(vessel.stack())[1:]


def _makes_its_own(vessel: Vessel, below: Sequence[Vessel]) -> bool:
    """Whether food steams by what is in its own vessel: closed up in an appliance, or fried with a little water."""
    closed_in = any(place.is_appliance and place.row.holds != "on" for place in below)
    fat = any(part.food.is_a("fat") for lump in vessel.lumps for part in lump.parts)
    return closed_in or (fat and "heat" in vessel.row.can and _has_liquid(vessel))


def _has_liquid(vessel: Vessel) -> bool:
    """Whether a liquid that boils is in a vessel, by itself: what was mixed into a batter is none."""
    parts = (part for lump in vessel.lumps if not lump.mixed for part in lump.parts)
    return any(part.food.is_a("cooking liquid") and not part.spoonful for part in parts)
