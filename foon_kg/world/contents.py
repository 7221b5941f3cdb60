"""What vessels and foods hold after a step: what their nodes tell, and what went in and is told nowhere."""

from __future__ import annotations

from collections.abc import Sequence

from foon_kg.food import Utensil, is_among
from foon_kg.food.lists import says
from foon_kg.model import ObjectNode
from foon_kg.world.outcome import WORKS, Outcome
from foon_kg.world.reading import NodeReading
from foon_kg.world.things import Lump, Vessel

_LETS_GO = ("separate", "discard", "clean")


def settle(out: Outcome) -> None:
    """Bring to each food and vessel of ``out`` what its node holds, and to its place what no node tells of."""
    for place, one in enumerate(out.said):
        if one.utensil is None:
            _gather(out, place)
    for place in sorted(out.vessel_of):
        _fill(out, out.said[place], out.vessel_of[place])
    _let_go(out)
    _fill_spoon(out)
    _run_through(out)
    _keep_back(out)


def _fill_spoon(out: Outcome) -> None:
    """Fill the spoon into which a packet or bottle is poured by a step that tells of neither what came out."""
    if out.played_step.inputs or out.food_labels or not out.played_step.does("move", "fetch"):
        return
    poured = _poured_packet(out.played_step.vessels)
    if poured is not None:
        packet, spoon = poured
        for lump in list(packet.lumps):
            out.leave_rest(lump)
            out.supply.put(lump, spoon)


def _poured_packet(vessels: Sequence[Vessel]) -> tuple[Vessel, Vessel] | None:
    """Return a packet or bottle and the empty spoon that takes part with it; ``None`` where any other vessel does."""
    spoons = list(filter(_is_empty_spoon, vessels))
    packets = [vessel for vessel in vessels if vessel.row.keeps_food and vessel.lumps]
    if any(vessel not in spoons and vessel not in packets and not vessel.is_appliance for vessel in vessels):
        return None
    return (packets[0], spoons[0]) if spoons and packets else None


def _is_empty_spoon(vessel: Vessel) -> bool:
    return vessel.row.role == "tool" and "scoop" in vessel.row.can and not vessel.lumps


def _run_through(out: Outcome) -> None:
    """Let every liquid run out of a strainer: what was poured through it is gone, whatever its node says.

    What was kneaded or shaped keeps the liquid that is worked into it, and so does a batter of eggs that has set.
    """
    for vessel in dict.fromkeys((*out.played_step.vessels, *out.vessel_of.values())):
        for lump in list(vessel.lumps) if _is_strainer(vessel.row) else ():
            if says(lump.states, "keeps its shape") or _has_set(lump):
                continue
            lump.keep([part for part in lump.parts if not part.food.is_a("liquid", "water")])
            if not lump.parts:
                out.supply.put(lump, None)
                lump.gone = True


def _is_strainer(row: Utensil | None) -> bool:
    """Whether it is a vessel that lets liquid through; a skimmer or a slotted spoon is a tool."""
    return row is not None and row.role == "vessel" and "strain" in row.can


def _has_set(lump: Lump) -> bool:
    """Whether flour and eggs were mixed, and heated since."""
    hot = [part.food for part in lump.parts if part.heated is not None]
    return lump.mixed and all(any(food.is_a(trait) for food in hot) for trait in ("egg", "flour"))


def _keep_back(out: Outcome) -> None:
    """Take out of what is poured through a strainer what is told to stay in that."""
    held = _told_in_strainers(out) if out.played_step.does("separate") else frozenset()
    if not held:
        return
    for lump in out.played_step.outputs.values():
        if lump.mixed and lump.label not in held:
            lump.keep([part for part in lump.parts if part.name not in held])


def _told_in_strainers(out: Outcome) -> frozenset[str]:
    """Return the output foods whose nodes say that they are in a strainer."""
    return frozenset(one.label for one in out.said if one.is_food and _is_strainer(one.place_utensil))


def _gather(out: Outcome, place: int) -> None:
    """Bring to a food what its output node holds and what went in beside it: cream that is spread on a dough."""
    one, node = out.said[place], out.mentions[place].node
    if one.names <= {one.label}:
        return
    lump = out.played_step.outputs[node]
    for name in sorted(one.names - _there_with(lump) - {one.label}):
        _bring(out, name, node, lump)


def _there_with(lump: Lump) -> set[str]:
    """Return the names of a food, of its parts, of what lies on it and of what is in its vessel."""
    there = lump.where.names if lump.where else set()
    return there.union(lump.called, *(rider.names for rider in lump.riders if not rider.gone))


def _bring(out: Outcome, name: str, node: ObjectNode, lump: Lump) -> None:
    """Bring into a food one of the foods that its node says it holds."""
    if all(part.unstated for part in lump.parts):
        lump.take(out.supply.name_lump(name, out.played_step.number, None).parts)  # told now of what it is made
        return
    some = _clings(out, name, lump)
    if some is not None:
        _take_some(lump, some, name)
        return
    other = _to_be_moved(out, name, lump.where) or _left_behind(out, name, lump)
    if other is not None and other is not lump:
        lump.take(other.parts)
        lump.call(other.names)
        out.consume(other, lump)
        out.supply.keep(lump, lump.where)
    elif name not in out.labels:
        _derived(out, name, node, lump.where, into=lump)


def _take_some(lump: Lump, other: Lump, name: str) -> None:
    """Let some of another food, which is called ``name``, be on a lump; the rest stays where it is."""
    there_now = {part.name for part in lump.parts}
    lump.take(part.copy() for part in other.parts if part.name not in there_now)
    lump.call([name])


def _clings(out: Outcome, name: str, lump: Lump) -> Lump | None:
    """Return what is told beside a food and of which some is on it now: fat in which it is fried, and what coats it.

    The rest of the fat stays in the pan with it, that of a coat in a vessel of its own.
    """
    heats, coats = out.played_step.does("heat"), out.played_step.does("coat")
    outputs = (out.played_step.outputs.get(mention.node) for mention in out.mentions)
    for one in outputs if heats or coats else ():
        if one is None or one is lump or name not in one.called:
            continue
        if _is_fat_beside(one, lump) if heats else _stays_in_its_bowl(out, one, lump):
            return one
    return None


def _is_fat_beside(one: Lump, lump: Lump) -> bool:
    return one.where is lump.where and all(part.food.is_a("fat") for part in one.parts)


def _stays_in_its_bowl(out: Outcome, one: Lump, lump: Lump) -> bool:
    return one.where is not lump.where and one.where is out.before.get(id(one))


def _left_behind(out: Outcome, name: str, lump: Lump) -> Lump | None:
    """Return a portion of what lay beside a food where it was, and is told to be on or in it where it is now."""
    old = out.before.get(id(lump))
    if old is None or old is lump.where:
        return None
    for other in old.lumps:
        if other is not lump and name in other.names:
            return Lump(name, set(other.names), other.states, [part.copy() for part in other.parts], made=other.made)
    return None


def _derived(out: Outcome, name: str, node: ObjectNode, where: Vessel | None, into: Lump | None = None) -> None:
    """Put into a vessel what only its name tells of: a part of something that went in, or a thing from nowhere."""
    if where is not None and where.row.role == "storage":
        out.supply.name_lump(name, out.played_step.number, where)  # a can that is opened shows what is in it
        return
    for lump in out.lumps():
        if any(_is_part_of(name, other) for other in lump.called):
            _portion_called(out, name, lump, where)
            return
    if out.played_step.does("separate") and out.lumps():
        _portion_called(out, name, out.lumps()[0], where)
    elif not is_among(name, out.brought):
        _out_of_nowhere(out, name, node, where, into)


def _portion_called(out: Outcome, name: str, lump: Lump, where: Vessel | None) -> None:
    if where is not None and (lump.where is where or name in where.names):
        lump.call([name])
        out.supply.keep(lump, lump.where)
        return
    parts = [part.copy() for part in lump.parts]
    out.supply.parts += parts
    portion = Lump(name, {name}, (), parts, made=True, last=out.played_step.number)
    out.supply.keep(portion, where)
    out.mapped.add(id(portion))
    out.played_step.made.append(portion)


def _out_of_nowhere(out: Outcome, name: str, node: ObjectNode, where: Vessel | None, into: Lump | None) -> None:
    """Tell an ingredient that did not go in; it is there all the same from now on, so that it is told once."""
    out.tell_missing(name, node)
    lump = out.supply.name_lump(name, out.played_step.number, where)
    if into is not None:
        into.take(lump.parts)
        into.call([name])
        out.consume(lump, into)
        out.supply.keep(into, into.where)


def _fill(out: Outcome, one: NodeReading, vessel: Vessel) -> None:
    """Bring into a vessel what its output node holds and what has not come there yet."""
    for name in sorted(one.names - vessel.names) if one.names else ():
        lump = _to_be_moved(out, name, vessel)
        if lump is not None:
            out.leave_rest(lump)
            out.supply.put(lump, vessel)
            out.mapped.add(id(lump))
        elif name not in out.labels:
            _derived(out, name, one.node, vessel)
    if one.empty or _is_poured_out(out, one, vessel):
        _empty(out, vessel)


def _is_poured_out(out: Outcome, one: NodeReading, vessel: Vessel) -> bool:
    """Whether a vessel that is told without contents was poured out: another one holds them by its node."""
    if one.names or not vessel.lumps or not out.played_step.does("move"):
        return False
    claimed = [other.names for place, other in enumerate(out.said) if out.vessel_of.get(place) is not vessel]
    return any(not names.isdisjoint(vessel.names) for names in claimed)


def _to_be_moved(out: Outcome, name: str, vessel: Vessel | None) -> Lump | None:
    """Return the food that a vessel is said to hold now and that is elsewhere: of that name, else of one like it."""
    elsewhere = [lump for lump in out.lumps() if lump.where is not vessel and _is_free(out, lump)]
    for lump in elsewhere:
        if name in lump.called:
            return lump
    return next((lump for lump in elsewhere if lump in out.played_step.inputs and is_among(name, lump.names)), None)


def _is_free(out: Outcome, lump: Lump) -> bool:
    """Whether a step may still move a food: it is there, and no output is it, or one that stayed where it was."""
    if lump.gone:
        return False
    return id(lump) not in out.mapped or lump.where is out.before.get(id(lump), lump.where)


def _empty(out: Outcome, vessel: Vessel) -> None:
    """Move what is left of a vessel that is told empty to where the rest went; without such a place it is gone."""
    stored = vessel.row.role == "storage"  # of what is sold so there is more in the shop
    target = None if stored else _target_of_rest(out, vessel)
    for lump in list(vessel.lumps):
        if target is not None and not _is_waste(out, lump):
            out.supply.put(lump, target)
        else:
            out.supply.put(lump, None)
            lump.gone = not stored


def _target_of_rest(out: Outcome, vessel: Vessel) -> Vessel | None:
    """Return where what was in a vessel went by the outputs: into one that holds something, else to where a food is."""
    for place, other in out.vessel_of.items():
        if other is not vessel and out.said[place].names and other.row.role not in {"storage", "appliance"}:
            return other
    places = (lump.where for lump in out.played_step.outputs.values())
    return next((place for place in places if place is not None and place is not vessel), None)


def _is_waste(out: Outcome, lump: Lump) -> bool:
    """Whether what is left in a vessel goes nowhere: it is what nobody eats, or water that runs off."""
    drained = out.played_step.does(*_LETS_GO) and lump.parts and lump.parts[0].food.is_a("water", "liquid")
    return bool(drained) or all(part.remains for part in lump.parts)


def _target(out: Outcome) -> Vessel | None:
    """Return where a step brings things: the first output that is a vessel, else where its first food is."""
    for vessel in out.vessel_of.values():
        if vessel.row.role in {"vessel", "wrap"}:
            return vessel
    return next((lump.where for lump in out.played_step.outputs.values() if lump.where is not None), None)


def _is_carried(out: Outcome, lump: Lump, target: Vessel) -> bool:
    """Whether a food goes along: it was in the hand, on the table or in its packet, or its label is told in there."""
    if lump.where is None or lump.where.row.role in {"storage", "place"}:
        return True
    return lump.label in _claimed_by(out, target)


def _let_go(out: Outcome) -> None:
    """Bring what was put in and is named in no output to where the step brings things: into the one target."""
    left = [lump for lump in out.played_step.inputs if not lump.gone and id(lump) not in out.mapped]
    target = _target(out) if left and out.played_step.does("move", "scatter", *WORKS) else None
    for lump in left:
        if target is not None and _is_carried(out, lump, target):
            out.supply.put(lump, target)
        elif out.played_step.does("discard"):
            out.supply.put(lump, None)
            lump.gone = True


def _claimed_by(out: Outcome, vessel: Vessel) -> frozenset[str]:
    """Return what the output nodes of a vessel say it holds."""
    return frozenset().union(*(out.said[place].names for place, v in out.vessel_of.items() if v is vessel))


def _is_part_of(name: str, other: str) -> bool:
    """Whether one name says more of what another names: lemon juice of a lemon, a beaten egg of an egg."""
    return name != other and bool(other) and set(other.split()) < set(name.split())
