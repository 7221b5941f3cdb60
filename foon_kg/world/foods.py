"""Which food each output food is: one that went in, in another state or place, or a product of what went in."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import chain

from foon_kg.model import ObjectNode
from foon_kg.model.tree import Mention
from foon_kg.world.becoming import can_become, is_product
from foon_kg.world.outcome import JOINS, WORKS, Outcome
from foon_kg.world.reading import NodeReading
from foon_kg.world.things import Lump, Part, Vessel


def settle(out: Outcome) -> None:
    """Give every output food its thing and its place: first those that went in, then what was made of the rest."""
    foods = [place for place, one in enumerate(out.said) if one.utensil is None]
    known = [place for place in foods if _is_same(out, place)]
    for place in foods:
        if place not in known:
            _make(out, place)
    if out.played_step.does("open"):
        _use_up(out)


def _use_up(out: Outcome) -> None:
    """Let what was opened be gone where it comes apart into several foods: no second egg is in a shell."""
    origins = Counter(part.origin for lump in out.played_step.made for part in lump.parts)
    for lump in out.played_step.inputs:
        apart = all(origins[part.origin] > 1 for part in lump.parts)
        if apart and not lump.gone and id(lump) not in out.mapped:
            lump.gone = True
            out.supply.put(lump, None)
            out.mapped.add(id(lump))


def _is_same(out: Outcome, place: int) -> bool:
    """Whether an output is a food that went in, in another state or place; it is brought there then."""
    mention, one = out.mentions[place], out.said[place]
    lump = _same(out, mention, one)
    if lump is None:
        return False
    again = id(lump) in out.mapped
    remains = _is_left_over(out, one) and not all(part.remains for part in lump.parts)
    if again or (remains and _named_twice(out, one)):
        lump = _portion(out, lump, one, mention, remains=remains)
    out.mapped.add(id(lump))
    _settle(out, lump, place)
    return True


def _same(out: Outcome, mention: Mention, one: NodeReading) -> Lump | None:
    """Return the food that went in and that an output is; ``None`` where it was made of what went in."""
    numbered = None if mention.thing is None else out.supply.numbered_lumps.get(mention.thing)
    if numbered is not None:
        return numbered
    named = [lump for lump in out.lumps() if one.label in lump.names]
    if named:
        return _likest(out, one, named)
    return None if is_product(out.tables, one) else _known_by_a_part(out, one)


def _likest(out: Outcome, one: NodeReading, named: Sequence[Lump]) -> Lump:
    """Return of ``named`` foods the one an output is: an input, that is no other output, in most of its states."""
    inputs = [lump for lump in named if lump in out.played_step.inputs] or named
    fresh = [lump for lump in inputs if id(lump) not in out.mapped]
    return max(fresh or inputs, key=lambda lump: len(set(lump.states) & set(one.node.states)))


def _known_by_a_part(out: Outcome, one: NodeReading) -> Lump | None:
    """Return the first food that has a part of an output's name, unless others are mixed into it."""
    for lump in out.lumps():
        if any(part.name == one.label for part in lump.parts):
            return None if lump.mixed else lump
    return None


def _named_twice(out: Outcome, one: NodeReading) -> bool:
    return sum(other.utensil is None and set(one.label.split()) <= set(other.label.split()) for other in out.said) > 1


def _is_left_over(out: Outcome, one: NodeReading) -> bool:
    """Whether a food output is what nobody eats: a skin, or what is left of what was squeezed for its juice."""
    if one.remains:
        return True
    if not out.played_step.does("separate") or out.is_liquid(one) or not _named_twice(out, one):
        return False
    came_in = {lump.label for lump in out.played_step.inputs}  # the broth around a roast is not its juice
    return any(other.is_food and other.label not in came_in and out.is_liquid(other) for other in out.said)


def _portion(out: Outcome, lump: Lump, one: NodeReading, mention: Mention, *, remains: bool) -> Lump:
    parts = [part.copy(remains=remains) for part in lump.parts]
    out.supply.parts += parts
    portion = Lump(one.label, {one.label}, lump.states, parts, number=mention.thing, made=lump.made)
    portion.last = out.played_step.number
    out.supply.keep(portion, lump.where)
    return portion


def _settle(out: Outcome, lump: Lump, place: int) -> None:
    """Give a lump the states and the place that its output node says."""
    one, node = out.said[place], out.mentions[place].node
    lump.label, lump.last = one.label, out.played_step.number
    lump.call([one.label])
    out.played_step.outputs[node] = lump
    lump.states = node.states
    where = _place(out, one, node, lump)
    if where is not lump.where:
        out.leave_rest(lump)
        out.supply.put(lump, where)
    thing = out.mentions[place].thing
    anew = thing not in out.supply.numbered_lumps or (out.played_step.does(*JOINS) and one.names)
    if thing is not None and anew:
        lump.number = thing  # what is fried with its fat, and noodles that become a dish of noodles, are numbered anew
    out.supply.keep(lump, lump.where)
    if out.played_step.does(*JOINS) and _gathers(out, one, lump):
        _join_all(out, lump)


def _gathers(out: Outcome, one: NodeReading, lump: Lump) -> bool:
    return len(one.names - {one.label}) > 1 or (lump.made and is_product(out.tables, one))


def _place(out: Outcome, one: NodeReading, node: ObjectNode, lump: Lump) -> Vessel | None:
    """Return where an output food is: where its node says, else where it was, unless the step takes it out of there."""
    if one.place is None:
        return None if _is_taken_out(out, lump) else lump.where
    if one.place_utensil is None:
        return _on_food(out, one, node, lump)
    vessel = _vessel_called(out, one)
    if vessel is not None:
        return vessel
    if any(_is_called(other, one.place) for other in out.lumps() if other is not lump):
        return _on_food(out, one, node, lump)  # a sheet of dough is called a sheet, as one of foil is
    if one.place_utensil.role != "place" and one.node.relation != "from":
        out.played_step.fault("W2", f"there is no {one.place} in which it could be now", node)
    return out.supply.fresh(one.place)


def _is_taken_out(out: Outcome, lump: Lump) -> bool:
    """Whether a step takes a food out of where it was bought or cooled, and so into the hand."""
    if lump.where is None or lump.where.row.role not in {"storage", "appliance"}:
        return False
    return out.played_step.does("fetch", "separate", "move", "open") and out.played_step.motion.known


def _vessel_called(out: Outcome, one: NodeReading) -> Vessel | None:
    """Return the vessel that an output food's node names as its place: by its name, its last word, or what it holds."""
    for vessel in chain(out.vessel_of.values(), out.played_step.vessels, out.holders(), out.standing()):
        if vessel.label == one.place:
            return vessel
    short = (one.place or "").rpartition(" ")[2]
    for vessel in (*out.played_step.vessels, *out.holders()):
        if one.place == vessel.label.rpartition(" ")[2] or vessel.label == short:
            return vessel
    called = [vessel for place, vessel in out.vessel_of.items() if one.label in out.said[place].names]
    return called[0] if len(called) == 1 else None  # told by another name: a tray is called a pan


def _on_food(out: Outcome, one: NodeReading, node: ObjectNode, lump: Lump) -> Vessel | None:
    """Return the vessel of the food on which another lies."""
    under = _food_called(out, str(one.place))
    if under is not None:
        if under is not lump and lump not in under.riders:
            under.riders.append(lump)
            out.played_step.vessels_moved = True
        return under.where
    if out.tables.foods.is_listed(str(one.place)):
        if one.place not in out.labels:
            out.played_step.fault("W2", f"there is no {one.place} on which it could be", node)
        return lump.where
    laid = [*out.vessel_of.values(), *out.played_step.vessels]  # a sheet of foil is called a sheet
    return next((vessel for vessel in laid if vessel.row.role == "wrap"), lump.where)


def _food_called(out: Outcome, name: str) -> Lump | None:
    """Return the food that has a name; where none has it, the first that somebody could call so for short."""
    lumps = out.lumps()
    for lump in lumps:
        if name in lump.names or lump.label == name:
            return lump
    return next((lump for lump in lumps if _is_called(lump, name)), None)


def _make(out: Outcome, place: int) -> None:
    """Make a product: it holds every part that went in, and takes the place of what it was made of."""
    mention, one = out.mentions[place], out.said[place]
    where = _place(out, one, mention.node, Lump(one.label, {one.label}, (), []))
    sources = _sources(out, one, where)
    if not sources and out.played_step.made:
        _alias(out, out.played_step.made[-1], one, mention.node)
        return
    if not _may_become(out, one, sources):
        names = ", ".join(sorted({part.name for lump in sources for part in lump.parts})) or "nothing"
        out.played_step.fault("W2", f"{one.label} does not come of {names}", mention.node)
    keeps = _leaves_its_sources(out, one)
    product = Lump(one.label, {one.label}, mention.node.states, [], number=mention.thing, made=True)
    product.take(_parts_of(out, one, sources, copied=keeps) or _new_parts(out, one))
    product.last = out.played_step.number
    for lump in () if keeps else sources:
        out.consume(lump, product)
    out.supply.keep(product, where)
    out.mapped.add(id(product))
    out.played_step.outputs[mention.node] = product
    out.played_step.made.append(product)


def _leaves_its_sources(out: Outcome, one: NodeReading) -> bool:
    """Whether a product comes off something that is still there: a peel, the juice of a lemon, a slice of ham."""
    splits = out.played_step.does("separate", "open", "shell", "fetch", "cut", "peel", "core", "stone", "husk")
    return one.remains or (splits and not one.names)


def _parts_of(out: Outcome, one: NodeReading, sources: Sequence[Lump], *, copied: bool) -> list[Part]:
    """Return the parts of a product's sources; ``copied`` where these keep their own."""
    parts = [part for lump in sources for part in lump.parts]
    if not copied:
        return parts
    portions = [part.copy(remains=one.remains) for part in parts]
    out.supply.parts += portions
    return portions


def _new_parts(out: Outcome, one: NodeReading) -> list[Part]:
    """Return the part of a product that is made of nothing: it is taken from the kitchen as it is."""
    parts = [out.supply.new_part(one.label, one.node.states, out.played_step.number)]
    out.played_step.taken += parts
    return parts


def _alias(out: Outcome, lump: Lump, one: NodeReading, node: ObjectNode) -> None:
    """Give what was just made a second name: a salad that is also told as the greek salad."""
    lump.call([one.label])
    out.played_step.outputs[node] = lump
    out.supply.keep(lump, lump.where)


def _may_become(out: Outcome, one: NodeReading, sources: Sequence[Lump]) -> bool:
    """Whether what went in can make a food; a tap, a can and an appliance give what they hold."""
    if not sources and any(vessel.row.role in {"storage", "appliance"} for vessel in out.played_step.vessels):
        return True
    return can_become(out.tables, one, sources)


def _sources(out: Outcome, one: NodeReading, where: Vessel | None) -> list[Lump]:
    """Return the foods of which an output may be made: those that went in, and what is in the vessels that did."""
    explicit = _spent_inputs(out, one)
    works = out.played_step.does(*WORKS) or is_product(out.tables, one)
    held: list[Lump] = []
    for vessel in out.played_step.vessels:
        takes_all = works and (vessel is where or not explicit)
        held += vessel.lumps if takes_all else _named_in(vessel, one)
    around = where.lumps if where is not None and works else []
    found = [*explicit, *_without_output(out, held), *_riders(explicit), *_without_output(out, around)]
    return list(dict.fromkeys(found))


def _riders(lumps: Sequence[Lump]) -> list[Lump]:
    """Return what lies on ``lumps``."""
    return [rider for lump in lumps for rider in lump.riders if not rider.gone]


def _named_in(vessel: Vessel, one: NodeReading) -> list[Lump]:
    """Return what is in a vessel of which an output says that it is made."""
    return [lump for lump in vessel.lumps if _is_named(one, lump)]


def _spent_inputs(out: Outcome, one: NodeReading) -> list[Lump]:
    """Return the inputs that no output is called like; where each is, those that are called otherwise than ``one``."""
    going_in = [lump for lump in out.played_step.inputs if not lump.gone]
    return _without_output(out, going_in) or [lump for lump in going_in if lump.label != one.label]


def _without_output(out: Outcome, lumps: Sequence[Lump]) -> list[Lump]:
    """Return those of ``lumps`` that no output food is called like."""
    return [lump for lump in lumps if lump.label not in out.food_labels]


def _is_named(one: NodeReading, lump: Lump) -> bool:
    """Whether an output is called like a part of a food, or names it or a part of it among its ingredients."""
    if not one.names.isdisjoint(lump.called):
        return True
    return any(part.name == one.label for part in lump.parts)


def _join_all(out: Outcome, lump: Lump) -> None:
    """Mix into a lump all else that went in and has no output of its own, with all that shares its vessel."""
    told_apart = out.food_labels - {lump.label}
    others = [other for other in _unclaimed(out, lump) if other.label not in told_apart]
    for other in others:
        lump.take(other.parts)
        out.consume(other, lump)
    if others:
        out.supply.keep(lump, lump.where)


def _unclaimed(out: Outcome, lump: Lump) -> list[Lump]:
    """Return the inputs that no output is yet, and what is so beside a lump."""
    going_in = [other for other in out.played_step.inputs if not other.gone]
    beside = lump.where.lumps if lump.where is not None else []
    return [one for one in dict.fromkeys([*going_in, *beside]) if one is not lump and id(one) not in out.mapped]


def _is_called(lump: Lump, name: str) -> bool:
    """Whether a food is what somebody calls by a short name: a wrapper, meat, a sheet."""
    if any(own.split()[-1:] == [name] for own in lump.names):
        return True
    return any(part.name == name or part.food.is_a(name) for part in lump.parts)
