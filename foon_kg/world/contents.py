"""What vessels and foods hold after a step: what their nodes tell, and what went in and is told nowhere."""

from __future__ import annotations

from foon_kg.food import is_among
from foon_kg.food.lists import word_list
from foon_kg.model import ObjectNode
from foon_kg.world.outcome import WORKS, Outcome
from foon_kg.world.reading import Said
from foon_kg.world.things import Lump, Vessel

_LETS_GO = ("separate", "discard", "clean")


def settle(out: Outcome) -> None:
    """Bring to each food and into each vessel what its node holds, and to its place what no node tells of."""
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
    if not out.happening.does("move", "fetch") or any(one.utensil is None for one in out.said):
        return
    spoons = [v for v in out.happening.vessels if v.row.role == "tool" and "scoop" in v.row.can and not v.lumps]
    packets = [vessel for vessel in out.happening.vessels if vessel.row.keeps_food and vessel.lumps]
    others = [v for v in out.happening.vessels if v not in spoons and v not in packets and not v.is_appliance]
    if spoons and packets and not others and not out.happening.inputs:
        for lump in list(packets[0].lumps):
            out.leave_rest(lump)
            out.supply.put(lump, spoons[0])


def _run_through(out: Outcome) -> None:
    """Let every liquid run out of a strainer: what was poured through it is gone, whatever its node says.

    What was kneaded or shaped keeps the liquid that is worked into it, and so does a batter of eggs that has set.
    """
    for vessel in dict.fromkeys((*out.happening.vessels, *out.vessel_of.values())):
        if "strain" not in vessel.row.can or vessel.row.role != "vessel":
            continue
        for lump in list(vessel.lumps):
            if not word_list("keeps its shape").isdisjoint(lump.states) or _has_set(lump):
                continue
            lump.parts = [part for part in lump.parts if not part.food.is_a("liquid", "water")]
            if not lump.parts:
                out.supply.put(lump, None)
                lump.gone = True


def _has_set(lump: Lump) -> bool:
    """Whether flour and eggs were mixed, and heated since."""
    hot = [part.food for part in lump.parts if part.heated is not None]
    return lump.mixed and all(any(food.is_a(trait) for food in hot) for trait in ("egg", "flour"))


def _keep_back(out: Outcome) -> None:
    """Take out of what is poured through a strainer what is told to stay in that."""
    if not out.happening.does("separate"):
        return
    places = ((one, one.place_utensil) for one in out.said if one.utensil is None)
    held = {one.label for one, row in places if row is not None and row.role == "vessel" and "strain" in row.can}
    for lump in out.happening.outputs.values():
        if held and lump.mixed and lump.label not in held:
            lump.parts = [part for part in lump.parts if part.name not in held]


def _gather(out: Outcome, place: int) -> None:
    """Bring to a food what its output node holds and what went in beside it: cream that is spread on a dough."""
    one, lump = out.said[place], out.happening.outputs[out.mentions[place].node]
    if one.names <= {one.label}:
        return
    there = set(lump.names) | {part.name for part in lump.parts} | (lump.where.names if lump.where else set())
    there |= {name for rider in lump.riders if not rider.gone for name in rider.names}
    for name in sorted(one.names - there - {one.label}):
        other = _to_be_moved(out, name, lump.where) or _left_behind(out, name, lump)
        if all(part.untold for part in lump.parts):
            lump.take(out.supply.name_lump(name, out.happening.number, None).parts)  # told now of what it is made
        elif (some := _clings(out, name, lump)) is not None:
            there_now = {part.name for part in lump.parts}
            lump.take(part.copy() for part in some.parts if part.name not in there_now)
            lump.names.add(name)
        elif other is not None and other is not lump:
            lump.take(other.parts)
            lump.names |= other.names
            out.consume(other, lump)
            out.supply.keep(lump, lump.where)
        elif name not in {said.label for said in out.said}:
            _derived(out, name, out.mentions[place].node, lump.where, into=lump)


def _clings(out: Outcome, name: str, lump: Lump) -> Lump | None:
    """Return what is told beside a food and of which some is on it now: fat in which it is fried, and what coats it.

    The rest of the fat stays in the pan with it, that of a coat in a vessel of its own.
    """
    told = (out.happening.outputs.get(mention.node) for mention in out.mentions)
    others = [one for one in told if one is not None and one is not lump and name in _held(one)]
    if out.happening.does("heat"):
        return next((one for one in others if _is_fat_beside(one, lump)), None)
    return next((one for one in others if out.happening.does("coat") and _stays_in_its_bowl(out, one, lump)), None)


def _is_fat_beside(one: Lump, lump: Lump) -> bool:
    return one.where is lump.where and all(part.food.is_a("fat") for part in one.parts)


def _stays_in_its_bowl(out: Outcome, one: Lump, lump: Lump) -> bool:
    return one.where is not lump.where and one.where is out.before.get(id(one))


def _held(lump: Lump) -> set[str]:
    return {*lump.names, *(part.name for part in lump.parts)}


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
        out.supply.name_lump(name, out.happening.number, where)  # a can that is opened shows what is in it
        return
    for lump in out.lumps():
        if any(_is_part_of(name, other) for other in (*lump.names, *(part.name for part in lump.parts))):
            _portion_called(out, name, lump, where)
            return
    if out.happening.does("separate") and out.lumps():
        _portion_called(out, name, out.lumps()[0], where)
    elif not is_among(name, out.brought):
        _out_of_nowhere(out, name, node, where, into)


def _portion_called(out: Outcome, name: str, lump: Lump, where: Vessel | None) -> None:
    if where is not None and (lump.where is where or name in where.names):
        lump.names.add(name)
        out.supply.keep(lump, lump.where)
        return
    parts = [part.copy() for part in lump.parts]
    out.supply.parts += parts
    portion = Lump(name, {name}, (), parts, made=True, last=out.happening.number)
    out.supply.keep(portion, where)
    out.mapped.add(id(portion))
    out.happening.made.append(portion)


def _out_of_nowhere(out: Outcome, name: str, node: ObjectNode, where: Vessel | None, into: Lump | None) -> None:
    """Tell an ingredient that did not go in; it is there all the same from now on, so that it is told once."""
    out.tell_missing(name, node)
    lump = out.supply.name_lump(name, out.happening.number, where)
    if into is not None:
        into.take(lump.parts)
        into.names.add(name)
        out.consume(lump, into)
        out.supply.keep(into, into.where)


def _fill(out: Outcome, one: Said, vessel: Vessel) -> None:
    """Bring into a vessel what its output node holds and what has not come there yet."""
    for name in sorted(one.names - vessel.names) if one.names else ():
        lump = _to_be_moved(out, name, vessel)
        if lump is not None:
            out.leave_rest(lump)
            out.supply.put(lump, vessel)
            out.mapped.add(id(lump))
        elif name not in {other.label for other in out.said}:
            _derived(out, name, one.node, vessel)
    if one.empty or (not one.names and out.happening.does("move") and vessel.lumps and _poured_out(out, vessel)):
        _empty(out, vessel)


def _poured_out(out: Outcome, vessel: Vessel) -> bool:
    """Whether a vessel that is told without contents was poured out: another one holds them by its node."""
    claimed = [other.names for place, other in enumerate(out.said) if out.vessel_of.get(place) is not vessel]
    return any(not names.isdisjoint(vessel.names) for names in claimed)


def _to_be_moved(out: Outcome, name: str, vessel: Vessel | None) -> Lump | None:
    """Return the food that a vessel is said to hold now and that is elsewhere: of that name, else of one like it."""
    other: Lump | None = None
    for lump in out.lumps():
        stayed = id(lump) in out.mapped and lump.where is out.before.get(id(lump), lump.where)
        if lump.gone or lump.where is vessel or (id(lump) in out.mapped and not stayed):
            continue
        if name in lump.names or any(part.name == name for part in lump.parts):
            return lump
        if other is None and lump in out.happening.inputs and is_among(name, lump.names):
            other = lump
    return other


def _empty(out: Outcome, vessel: Vessel) -> None:
    """Move what is left of a vessel that is told empty to where the rest went; without such a place it is gone."""
    targets = [
        other for place, other in out.vessel_of.items()
        if other is not vessel and not other.is_appliance and out.said[place].names and other.row.role != "storage"
    ]  # fmt: skip
    targets += [lump.where for lump in out.happening.outputs.values() if lump.where not in (None, vessel)]
    for lump in list(vessel.lumps):
        drained = out.happening.does(*_LETS_GO) and lump.parts and lump.parts[0].food.is_a("water", "liquid")
        left = all(part.remains for part in lump.parts)
        if targets and not drained and not left and vessel.row.role != "storage":
            out.supply.put(lump, targets[0])
        else:
            out.supply.put(lump, None)
            lump.gone = vessel.row.role != "storage"


def _let_go(out: Outcome) -> None:
    """Bring what was put in and is named in no output to where the step brings things: into the one target."""
    targets = [v for v in out.vessel_of.values() if not v.is_appliance and v.row.role in {"vessel", "wrap"}]
    targets += [lump.where for lump in out.happening.outputs.values() if lump.where is not None]
    for lump in out.happening.inputs:
        if lump.gone or id(lump) in out.mapped:
            continue
        carried = lump.where is None or lump.where.row.role in {"storage", "place"}
        carried = carried or (bool(targets) and lump.label in _claimed_by(out, targets[0]))
        if targets and carried and out.happening.does("move", "scatter", *WORKS):
            out.supply.put(lump, targets[0])
        elif out.happening.does("discard"):
            out.supply.put(lump, None)
            lump.gone = True


def _claimed_by(out: Outcome, vessel: Vessel) -> frozenset[str]:
    """Return what the output nodes of a vessel say it holds."""
    return frozenset().union(*(out.said[place].names for place, v in out.vessel_of.items() if v is vessel))


def _is_part_of(name: str, other: str) -> bool:
    """Whether one name says more of what another names: lemon juice of a lemon, a beaten egg of an egg."""
    return name != other and bool(other) and set(other.split()) < set(name.split())
