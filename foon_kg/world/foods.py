"""Which food each output food is: one that went in, in another state or place, or a product of what went in."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from foon_kg.model import ObjectNode
from foon_kg.model.tree import Mention
from foon_kg.world.becoming import can_become, is_product
from foon_kg.world.outcome import JOINS, WORKS, Outcome
from foon_kg.world.reading import Said
from foon_kg.world.things import Lump, Vessel


def settle(out: Outcome) -> None:
    """Give every output food its thing and its place: first those that went in, then what was made of the rest."""
    foods = [place for place, one in enumerate(out.said) if one.utensil is None]
    known = [place for place in foods if _is_same(out, place)]
    for place in foods:
        if place not in known:
            _make(out, place)
    if out.happening.does("open"):
        _use_up(out)


def _use_up(out: Outcome) -> None:
    """Let what was opened be gone where it comes apart into several foods: no second egg is in a shell."""
    origins = Counter(part.origin for lump in out.happening.made for part in lump.parts)
    for lump in out.happening.inputs:
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


def _same(out: Outcome, mention: Mention, one: Said) -> Lump | None:
    if mention.thing is not None:
        lump = out.supply.numbered_lumps.get(mention.thing)
        if lump is not None:
            return lump
    named = [lump for lump in out.lumps() if one.label in lump.names]
    explicit = [lump for lump in named if lump in out.happening.inputs]
    if explicit or named:
        fresh = [lump for lump in explicit or named if id(lump) not in out.mapped]
        return max(fresh or explicit or named, key=lambda lump: len(set(lump.states) & set(one.node.states)))
    if is_product(out.tables, one):
        return None
    of_part = [lump for lump in out.lumps() if any(part.name == one.label for part in lump.parts)]
    return of_part[0] if of_part and not of_part[0].mixed else None


def _named_twice(out: Outcome, one: Said) -> bool:
    return sum(other.utensil is None and set(one.label.split()) <= set(other.label.split()) for other in out.said) > 1


def _is_left_over(out: Outcome, one: Said) -> bool:
    """Whether a food output is what nobody eats: a skin, or what is left of what was squeezed for its juice."""
    if one.remains:
        return True
    juices = [other for other in out.said if other.utensil is None and out.is_liquid(other)]
    return out.happening.does("separate") and bool(juices) and not out.is_liquid(one) and _named_twice(out, one)


def _portion(out: Outcome, lump: Lump, one: Said, mention: Mention, *, remains: bool) -> Lump:
    parts = [part.copy(remains=remains) for part in lump.parts]
    out.supply.parts += parts
    portion = Lump(one.label, {one.label}, lump.states, parts, number=mention.thing, made=lump.made)
    portion.last = out.happening.number
    out.supply.keep(portion, lump.where)
    return portion


def _settle(out: Outcome, lump: Lump, place: int) -> None:
    """Give a lump the states and the place that its output node says."""
    one, node = out.said[place], out.mentions[place].node
    lump.label, lump.last = one.label, out.happening.number
    lump.names.add(one.label)
    out.happening.outputs[node] = lump
    lump.states = node.states
    where = _place(out, one, node, lump)
    if where is not lump.where:
        out.leave_rest(lump)
        out.supply.put(lump, where)
    out.supply.keep(lump, lump.where)
    if out.happening.does(*JOINS) and _gathers(out, one, lump):
        _join_all(out, lump)


def _gathers(out: Outcome, one: Said, lump: Lump) -> bool:
    return len(one.names - {one.label}) > 1 or (lump.made and is_product(out.tables, one))


def _place(out: Outcome, one: Said, node: ObjectNode, lump: Lump) -> Vessel | None:
    if one.place is None:
        moved = out.happening.does("fetch", "separate", "move", "open") and out.happening.motion.known
        stays = lump.where is not None and not (moved and lump.where.row.role in {"storage", "appliance"})
        return lump.where if stays else None
    if one.place_utensil is None:
        return _on_food(out, one, node, lump)
    vessel = _vessel_called(out, one)
    if vessel is not None:
        return vessel
    if any(_is_called(other, one.place) for other in out.lumps() if other is not lump):
        return _on_food(out, one, node, lump)  # a sheet of dough is called a sheet, as one of foil is
    if one.place_utensil.role != "place" and one.node.relation != "from":
        out.happening.fault("W2", f"there is no {one.place} in which it could be now", node)
    return out.supply.fresh(one.place)


def _vessel_called(out: Outcome, one: Said) -> Vessel | None:
    """Return the vessel that an output food's node names as its place: by its name, its last word, or what it holds."""
    for vessel in (*out.vessel_of.values(), *out.happening.vessels, *out.holders(), *out.standing()):
        if vessel.label == one.place:
            return vessel
    short = (one.place or "").rpartition(" ")[2]
    for vessel in (*out.happening.vessels, *out.holders()):
        if one.place == vessel.label.rpartition(" ")[2] or vessel.label == short:
            return vessel
    told = [vessel for place, vessel in out.vessel_of.items() if one.label in out.said[place].names]
    return told[0] if len(told) == 1 else None  # told by another name: a tray is called a pan


def _on_food(out: Outcome, one: Said, node: ObjectNode, lump: Lump) -> Vessel | None:
    """Return the vessel of the food on which another lies."""
    under = next((o for o in out.lumps() if one.place in o.names or o.label == one.place), None)
    under = under or next((o for o in out.lumps() if _is_called(o, str(one.place))), None)
    if under is not None:
        if under is not lump and lump not in under.riders:
            under.riders.append(lump)
            out.happening.vessels_moved = True
        return under.where
    if out.tables.foods.is_listed(str(one.place)):
        if not any(other.label == one.place for other in out.said):
            out.happening.fault("W2", f"there is no {one.place} on which it could be", node)
        return lump.where
    laid = [*out.vessel_of.values(), *out.happening.vessels]  # a sheet of foil is called a sheet
    return next((vessel for vessel in laid if vessel.row.role == "wrap"), lump.where)


def _make(out: Outcome, place: int) -> None:
    """Make a product: it holds every part that went in, and takes the place of what it was made of."""
    mention, one = out.mentions[place], out.said[place]
    where = _place(out, one, mention.node, Lump(one.label, {one.label}, (), []))
    sources = _sources(out, one, where)
    if not sources and out.happening.made:
        _alias(out, out.happening.made[-1], one, mention.node)
        return
    if not _may_become(out, one, sources):
        names = ", ".join(sorted({part.name for lump in sources for part in lump.parts})) or "nothing"
        out.happening.fault("W2", f"{one.label} does not come of {names}", mention.node)
    splits = out.happening.does("separate", "open", "shell", "fetch", "cut", "peel", "core", "stone", "husk")
    keeps = (splits and not one.names) or one.remains
    shared = [part for lump in sources for part in lump.parts]
    parts = [part.copy(remains=one.remains) for part in shared] if keeps else shared
    if keeps:
        out.supply.parts += parts
    if not parts:
        parts = [out.supply.new_part(one.label, mention.node.states, out.happening.number)]
        out.happening.taken += parts
    product = Lump(one.label, {one.label}, mention.node.states, [], number=mention.thing, made=True)
    product.take(parts)
    product.last = out.happening.number
    for lump in sources:
        if not keeps:
            out.consume(lump, product)
    out.supply.keep(product, where)
    out.mapped.add(id(product))
    out.happening.outputs[mention.node] = product
    out.happening.made.append(product)


def _alias(out: Outcome, lump: Lump, one: Said, node: ObjectNode) -> None:
    """Give what was just made a second name: a salad that is also told as the greek salad."""
    lump.names.add(one.label)
    out.happening.outputs[node] = lump
    out.supply.keep(lump, lump.where)


def _may_become(out: Outcome, one: Said, sources: Sequence[Lump]) -> bool:
    """Whether what went in can make a food; a tap, a can and an appliance give what they hold."""
    if not sources and any(vessel.row.role in {"storage", "appliance"} for vessel in out.happening.vessels):
        return True
    return can_become(out.tables, one, sources)


def _sources(out: Outcome, one: Said, where: Vessel | None) -> list[Lump]:
    """Return the foods of which an output may be made: those that went in, and what is in the vessels that did."""
    outputs = {other.label for other in out.said if other.utensil is None}
    going_in = [lump for lump in out.happening.inputs if not lump.gone]
    explicit = [lump for lump in going_in if lump.label not in outputs]
    if not explicit:
        explicit = [lump for lump in going_in if lump.label != one.label]
    found = list(explicit)
    works = out.happening.does(*WORKS) or is_product(out.tables, one)
    for vessel in out.happening.vessels:
        takes_all = works and (vessel is where or not explicit)
        held = [lump for lump in vessel.lumps if lump.label not in outputs]
        found += [lump for lump in held if lump not in found and (takes_all or _is_named(one, lump))]
    found += [rider for lump in explicit for rider in lump.riders if rider not in found and not rider.gone]
    if where is not None and works:
        found += [lump for lump in where.lumps if lump not in found and lump.label not in outputs]
    return found


def _is_named(one: Said, lump: Lump) -> bool:
    """Whether an output names a food, or a part of it, among its ingredients."""
    return not one.names.isdisjoint(lump.names | {part.name for part in lump.parts})


def _join_all(out: Outcome, lump: Lump) -> None:
    """Mix into a lump all else that went in and has no output of its own, with all that shares its vessel."""
    others = [o for o in out.happening.inputs if o is not lump and id(o) not in out.mapped and not o.gone]
    if lump.where is not None:
        others += [o for o in lump.where.lumps if o is not lump and o not in others and id(o) not in out.mapped]
    told = {one.label for one in out.said if one.utensil is None}  # what has an output of its own is not mixed in
    others = [other for other in others if other.label == lump.label or other.label not in told]
    for other in others:
        lump.take(other.parts)
        out.consume(other, lump)
    if others:
        out.supply.keep(lump, lump.where)


def _is_called(lump: Lump, name: str) -> bool:
    """Whether a food is what somebody calls by a short name: a wrapper, meat, a sheet."""
    if any(own.split()[-1:] == [name] for own in lump.names):
        return True
    return any(part.name == name or part.food.is_a(name) for part in lump.parts)
