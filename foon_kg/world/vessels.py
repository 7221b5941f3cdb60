"""Which vessel each output vessel is, and where it stands now."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import Utensil
from foon_kg.model import NodeSortKey, ObjectNode
from foon_kg.model.tree import Mention
from foon_kg.world.outcome import Outcome
from foon_kg.world.reading import NodeReading
from foon_kg.world.things import Vessel


def match(out: Outcome) -> None:
    """Give every output vessel its thing, and let it stand where its node says.

    What holds most of what it is said to hold is matched first, so that the order of the outputs decides nothing.
    """
    free = list(out.played_step.vessels)
    utensils = [place for place, one in enumerate(out.said) if one.utensil is not None]
    if len(utensils) > 1:
        utensils.sort(key=lambda place: _surest_first(out, place))
    for place in utensils:
        one = out.said[place]
        vessel = _matching(out, out.mentions[place], one, free)
        if vessel is None:
            vessel = _appearing(out, out.mentions[place], one)
        if vessel is None:
            continue
        if vessel in free:
            free.remove(vessel)
        out.vessel_of[place] = vessel
        _stand(out, vessel, one, out.mentions[place].node)


def _surest_first(out: Outcome, place: int) -> tuple[int, NodeSortKey]:
    one = out.said[place]
    if not one.names:
        return 0, one.node.sort_key
    alike = [len(one.names & vessel.names) for vessel in out.played_step.vessels if vessel.label == one.label]
    return -max(alike, default=0), one.node.sort_key


def _matching(out: Outcome, mention: Mention, one: NodeReading, free: Sequence[Vessel]) -> Vessel | None:
    """Return which of the ``free`` input vessels an output is; a number says it, else name and contents."""
    if mention.thing is not None:
        vessel = out.supply.numbered_vessels.get(mention.thing)
        if vessel is not None and vessel.label != one.label:
            out.played_step.fault("W2", f"the {vessel.label} has become a {one.label}", mention.node)
        return vessel
    alike = [vessel for vessel in free if vessel.label == one.label]
    if not alike:
        return None
    return _emptied(out, one, alike) if one.empty else _filled(out, one, alike)


def _emptied(out: Outcome, one: NodeReading, alike: Sequence[Vessel]) -> Vessel:
    """Return which of several vessels of one name is told empty: a clean one, where another of them is told filled."""
    filled = len(alike) > 1 and any(other.names for other in out.said if other.label == one.label)
    return min(alike, key=lambda vessel: (bool(vessel.lumps) and filled, vessel.last))


def _filled(out: Outcome, one: NodeReading, alike: Sequence[Vessel]) -> Vessel:
    """Return which of several vessels of one name is told to hold something: not that out of which it was poured."""
    sources = {id(lump.where) for lump in out.played_step.inputs if lump.where is not None}
    poured = out.played_step.does("move") and any(id(vessel) not in sources for vessel in alike)
    left = sources if poured else set()
    return max(alike, key=lambda vessel: (id(vessel) not in left, len(one.names & vessel.names), vessel.last))


def _appearing(out: Outcome, mention: Mention, one: NodeReading) -> Vessel | None:
    """Return an output vessel that is no input: one that an input stands in or on, or a clean one."""
    for vessel in (*out.holders(), *out.standing()):
        if vessel.label == one.label:
            return vessel
    if one.is_appliance:
        return out.supply.appliance(one.label)
    if one.names:
        out.played_step.fault("W2", f"a filled {one.label} comes from nowhere", mention.node)
    return out.supply.fresh(one.label, mention.thing)


def _stand(out: Outcome, vessel: Vessel, one: NodeReading, node: ObjectNode) -> None:
    """Let a vessel stand where its node says; what a node forgets to repeat stays where it was."""
    if one.place_utensil is not None and one.place is not None:
        if vessel.where is None or vessel.where.label != one.place:
            out.supply.stand(vessel, _holder(out, one.place, one.place_utensil))
        if _is_new(out, node):
            out.played_step.vessels_moved = True
    elif _is_taken_away(out, vessel, one):
        out.supply.lift(vessel)
        out.played_step.vessels_moved = True
    if vessel.row.role != "wrap":
        _close(out, vessel, one)


def _close(out: Outcome, vessel: Vessel, one: NodeReading) -> None:
    """Close or open a vessel as its node and the motion say, and the one over which a lid is told."""
    if one.covered:
        vessel.covered = True
    elif out.played_step.does("uncover", "open", "detach", "attach"):
        vessel.covered = False
    if one.covers is not None:
        _cover(out, one.covers)


def _is_new(out: Outcome, node: ObjectNode) -> bool:
    """Whether an output node says something else than each input node."""
    return node not in {mention.node for mention in out.played_step.step.inputs}


def _is_taken_away(out: Outcome, vessel: Vessel, one: NodeReading) -> bool:
    """Whether a step takes a vessel off what it stood on: it moves things, and tells the vessel without a place."""
    if vessel.where is None or vessel.is_appliance or not out.played_step.does("detach", "move", "fetch"):
        return False
    return _is_new(out, one.node)


def _cover(out: Outcome, label: str) -> None:
    """Cover the vessel over which a lid is told."""
    if out.played_step.does("close"):
        for vessel in out.played_step.vessels:
            if vessel.label == label:
                vessel.covered = True


def _holder(out: Outcome, label: str, row: Utensil) -> Vessel:
    inside = next((vessel for vessel in out.played_step.vessels if vessel.label == label), None)
    if inside is not None:
        return inside
    return out.supply.appliance(label) if row.role == "appliance" else out.supply.holder(label)
