"""A kitchen in which steps happen: each thing is in one place and one state at a time.

:meth:`World.play` plays one step after another and tells what could not happen (contract W1 to W4, docs/contract.md). It
goes on after a mishap as if the step had been possible, so that one fault is told once. What an output node forgets to
repeat stays where it was; a new product holds every part that went in.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from foon_kg.food import Tables, Utensil, singular, tables
from foon_kg.model import ObjectNode
from foon_kg.world import power, treatment
from foon_kg.world.becoming import can_become, is_product
from foon_kg.world.happening import Happening
from foon_kg.world.reading import Reader, Said, reader
from foon_kg.world.step import Mention, Step
from foon_kg.world.supply import Supply
from foon_kg.world.things import Lump, Part, Vessel

_JOINS = ("mix", "blend", "mash", "knead", "whip", "grind", "shape", "coat")
_WORKS = (*_JOINS, "heat", "warm", "wait", "liquid", "dry", "fat")
_LETS_GO = ("separate", "discard", "clean")


class World:
    """One kitchen during one tree. ``asked`` has each required food as often as it is asked for."""

    def __init__(self, asked: Iterable[str] = (), known: Tables | None = None) -> None:
        names = [singular(name) for name in asked]
        self.tables = known or tables()
        called = frozenset(name for name in names if self.tables.utensil(name) is not None)
        self.reader: Reader = reader(self.tables, called)
        counts: dict[str, int] = {}
        for name in names:
            counts[name] = counts.get(name, 0) + 1
        self.supply = Supply(self.reader, counts)
        self.happenings: list[Happening] = []

    def play(self, step: Step) -> Happening:
        """Play the next step; what cannot happen stands in its ``mishaps``."""
        happening = Happening(len(self.happenings), step, self.tables.motion(step.motion))
        self.happenings.append(happening)
        said = [self.reader.read(mention.node) for mention in step.inputs]
        self._take_vessels(step.inputs, said, happening)
        self._take_foods(step.inputs, said, happening)
        power.check_inputs(self, happening)
        before = {id(lump): lump.where for vessel in happening.vessels for lump in vessel.lumps}
        before |= {id(lump): lump.where for lump in happening.inputs}
        _Outputs(self, happening, before).bring_about()
        treatment.apply(self, happening)
        power.check_outputs(self, happening)
        happening.hot = treatment.hot_vessels(self)
        return happening

    def _take_vessels(self, mentions: Sequence[Mention], said: Sequence[Said], happening: Happening) -> None:
        for mention, one in zip(mentions, said, strict=True):
            if one.utensil is None:
                continue
            vessel = self.supply.vessel(mention, one, happening)
            vessel.last = happening.number
            happening.vessels.append(vessel)
            if one.utensil.role in {"tool", "lid"}:
                happening.tools.append(mention.node)
            if one.place_utensil is not None and (vessel.where is None or vessel.where.label != one.place):
                self.supply.stand(vessel, self.supply.holder(str(one.place)))

    def _take_foods(self, mentions: Sequence[Mention], said: Sequence[Said], happening: Happening) -> None:
        for mention, one in zip(mentions, said, strict=True):
            if one.utensil is None:
                lump = self.supply.food(mention, one, happening)
                lump.last = happening.number
                happening.inputs.append(lump)


class _Outputs:
    """The outputs of one step: which thing each is, where it is now, and what of it could not become so."""

    def __init__(self, world: World, happening: Happening, before: dict[int, Vessel | None]) -> None:
        self.world = world
        self.supply = world.supply
        self.happening = happening
        self.before = before
        self.mentions = happening.step.outputs
        self.said = [world.reader.read(mention.node) for mention in self.mentions]
        self.vessel_of: dict[int, Vessel] = {}
        self.mapped: set[int] = set()
        self.brought = self._names_brought()

    def _names_brought(self) -> set[str]:
        names: set[str] = set()
        for lump in self._all_lumps():
            names |= lump.names
            names.update(part.name for part in lump.parts)
        return names

    def _all_lumps(self) -> list[Lump]:
        found = list(self.happening.inputs)
        found += [lump for vessel in self.happening.vessels for lump in vessel.lumps if lump not in found]
        return found

    def bring_about(self) -> None:
        """Give every output its thing, its place and its contents."""
        self._match_vessels()
        foods = [place for place, one in enumerate(self.said) if one.utensil is None]
        known = [place for place in foods if self._is_same(place)]
        for place in foods:
            if place not in known:
                self._make(place)
        for place in foods:
            self._gather(place)
        for place in sorted(self.vessel_of):
            self._fill(self.said[place], self.vessel_of[place])
        self._let_go()
        self._remember()

    # --- vessels ---

    def _match_vessels(self) -> None:
        free = list(self.happening.vessels)
        for place, one in enumerate(self.said):
            if one.utensil is None:
                continue
            vessel = self._matching(self.mentions[place], one, free)
            if vessel is None:
                vessel = self._appearing(self.mentions[place], one)
            if vessel is None:
                continue
            if vessel in free:
                free.remove(vessel)
            self.vessel_of[place] = vessel
            self._stand(vessel, one, self.mentions[place].node)

    def _matching(self, mention: Mention, one: Said, free: Sequence[Vessel]) -> Vessel | None:
        if mention.thing is not None:
            return self.supply.numbered_vessels.get(mention.thing)
        alike = [vessel for vessel in free if vessel.label == one.label]
        if not alike:
            return None
        if one.empty:
            return min(alike, key=lambda v: (len(v.lumps) > 0 and self._others_filled(one, alike), v.last))
        return max(alike, key=lambda v: (len(one.names & v.names), v.last))

    def _others_filled(self, one: Said, alike: Sequence[Vessel]) -> bool:
        return len(alike) > 1 and any(other.names for other in self.said if other.label == one.label)

    def _appearing(self, mention: Mention, one: Said) -> Vessel | None:
        """Return an output vessel that is no input: one that an input stands in or on, or a clean one."""
        for vessel in (*self._holders(), *self._emptied()):
            if vessel.label == one.label:
                return vessel
        if one.is_appliance:
            return self.supply.appliance(one.label)
        if one.names:
            self.happening.fault("W2", f"a filled {one.label} comes from nowhere", mention.node)
        return self.supply.fresh(one.label, mention.thing)

    def _holders(self) -> Iterable[Vessel]:
        """Yield what the inputs stand in, on or are attached to."""
        for lump in self.happening.inputs:
            place = self.before.get(id(lump), lump.where)
            while place is not None:
                yield place
                place = place.where
        for vessel in self.happening.vessels:
            place = vessel.where
            while place is not None:
                yield place
                place = place.where

    def _emptied(self) -> Iterable[Vessel]:
        """Yield what stands on or in an input: taking a tray out of the oven names the oven only."""
        for vessels in self.supply.vessels.values():
            for vessel in vessels:
                if vessel.where is not None and vessel.where in self.happening.vessels:
                    yield vessel

    def _stand(self, vessel: Vessel, one: Said, node: ObjectNode) -> None:
        """Let a vessel stand where its node says; what a node forgets to repeat stays where it was."""
        if one.place_utensil is not None and one.place is not None:
            if vessel.where is None or vessel.where.label != one.place:
                self.supply.stand(vessel, self._holder(one.place, one.place_utensil))
            if node not in {mention.node for mention in self.happening.step.inputs}:
                self.happening.vessels_moved = True
        elif vessel.where is not None and self.happening.does("detach", "move", "fetch") and not vessel.is_appliance:
            if one.node not in {mention.node for mention in self.happening.step.inputs}:
                vessel.where = None
                self.happening.vessels_moved = True
        if vessel.row.role == "wrap":
            return
        if one.covered != vessel.covered and self.happening.does("close", "uncover", "open", "detach", "attach"):
            vessel.covered = one.covered
        elif one.covered:
            vessel.covered = True
        if one.covers is not None:
            self._cover(one.covers)

    def _cover(self, label: str) -> None:
        """A lid that is told over a vessel covers it."""
        if self.happening.does("close"):
            for vessel in self.happening.vessels:
                if vessel.label == label:
                    vessel.covered = True

    def _holder(self, label: str, row: Utensil) -> Vessel:
        inside = next((vessel for vessel in self.happening.vessels if vessel.label == label), None)
        if inside is not None:
            return inside
        return self.supply.appliance(label) if row.role == "appliance" else self.supply.holder(label)

    # --- foods ---

    def _is_same(self, place: int) -> bool:
        """Whether an output is a food that went in, in another state or place; it is brought there then."""
        mention, one = self.mentions[place], self.said[place]
        lump = self._same(mention, one)
        if lump is None:
            return False
        again = id(lump) in self.mapped
        remains = self._is_left_over(one) and not all(part.remains for part in lump.parts)
        if again or (remains and self._named_twice(one)):
            lump = self._portion(lump, one, mention, remains=remains)
        self.mapped.add(id(lump))
        self._settle(lump, place)
        return True

    def _same(self, mention: Mention, one: Said) -> Lump | None:
        if mention.thing is not None:
            lump = self.supply.numbered_lumps.get(mention.thing)
            if lump is not None:
                return lump
        named = [lump for lump in self._all_lumps() if one.label in lump.names]
        explicit = [lump for lump in named if lump in self.happening.inputs]
        if explicit or named:
            fresh = [lump for lump in explicit or named if id(lump) not in self.mapped]
            return max(fresh or explicit or named, key=lambda lump: len(set(lump.states) & set(one.node.states)))
        if is_product(self.world.tables, one):
            return None
        of_part = [l for l in self._all_lumps() if any(part.name == one.label for part in l.parts)]
        return of_part[0] if of_part and not of_part[0].mixed else None

    def _named_twice(self, one: Said) -> bool:
        return (
            sum(other.utensil is None and set(one.label.split()) <= set(other.label.split()) for other in self.said) > 1
        )

    def _is_left_over(self, one: Said) -> bool:
        """Whether a food output is what nobody eats: a skin, or what is left of what was squeezed for its juice."""
        if one.remains:
            return True
        juices = [other for other in self.said if other.utensil is None and self._is_liquid(other)]
        return self.happening.does("separate") and bool(juices) and not self._is_liquid(one) and self._named_twice(one)

    def _is_liquid(self, one: Said) -> bool:
        return self.world.tables.foods.food(one.label, one.node.states).is_a("liquid")

    def _portion(self, lump: Lump, one: Said, mention: Mention, *, remains: bool) -> Lump:
        parts = [part.copy(remains=remains) for part in lump.parts]
        self.supply.parts += parts
        portion = Lump(one.label, {one.label}, lump.states, parts, number=mention.thing, made=lump.made)
        portion.last = self.happening.number
        self.supply.keep(portion, lump.where)
        return portion

    def _settle(self, lump: Lump, place: int) -> None:
        """Give a lump the states and the place that its output node says."""
        one, node = self.said[place], self.mentions[place].node
        lump.label, lump.last = one.label, self.happening.number
        lump.names.add(one.label)
        self.happening.outputs[node] = lump
        lump.states = node.states
        where = self._place(one, node, lump)
        if where is not lump.where:
            self._leave_rest(lump)
            self.supply.put(lump, where)
        self.supply.keep(lump, lump.where)
        if self.happening.does(*_JOINS) and self._gathers(one, lump):
            self._join_all(lump)

    def _leave_rest(self, lump: Lump) -> None:
        """Leave some of a stock food (salt, oil, flour) in the vessel it is taken from, unless that is told empty."""
        vessel = lump.where
        if vessel is None or lump.mixed or not any(part.food.is_a("stock", "water") for part in lump.parts):
            return
        emptied = any(v is vessel and self.said[place].empty for place, v in self.vessel_of.items())
        if emptied or vessel.row.role in {"place", "appliance"}:
            return
        parts = [part.copy() for part in lump.parts]
        rest = Lump(lump.label, set(lump.names), lump.states, parts, last=self.happening.number, made=lump.made)
        self.supply.keep(rest, vessel)
        self.before[id(rest)] = vessel

    def _gathers(self, one: Said, lump: Lump) -> bool:
        return len(one.names - {one.label}) > 1 or (lump.made and is_product(self.world.tables, one))

    def _place(self, one: Said, node: ObjectNode, lump: Lump) -> Vessel | None:
        if one.place is None:
            moved = self.happening.does("fetch", "separate", "move", "open") and self.happening.motion.known
            stays = lump.where is not None and not (moved and lump.where.row.role in {"storage", "appliance"})
            return lump.where if stays else None
        if one.place_utensil is None:
            return self._on_food(one, node, lump)
        for vessel in (*self.vessel_of.values(), *self.happening.vessels, *self._holders(), *self._emptied()):
            if vessel.label == one.place:
                return vessel
        for vessel in (*self.happening.vessels, *self._holders()):
            if one.place == vessel.label.split()[-1] or vessel.label == one.place.split()[-1]:
                return vessel
        if one.place_utensil.role != "place" and one.node.relation != "from":
            self.happening.fault("W2", f"there is no {one.place} in which it could be now", node)
        return self.supply.fresh(one.place)

    def _on_food(self, one: Said, node: ObjectNode, lump: Lump) -> Vessel | None:
        """Return the vessel of the food on which another lies."""
        under = next((o for o in self._all_lumps() if one.place in o.names or o.label == one.place), None)
        under = under or next((o for o in self._all_lumps() if _is_called(o, str(one.place))), None)
        if under is not None:
            if under is not lump and lump not in under.riders:
                under.riders.append(lump)
            return under.where
        if self.world.tables.foods.is_listed(str(one.place)):
            if not any(other.label == one.place for other in self.said):
                self.happening.fault("W2", f"there is no {one.place} on which it could be", node)
            return lump.where
        laid = [*self.vessel_of.values(), *self.happening.vessels]  # a sheet of foil is called a sheet
        return next((vessel for vessel in laid if vessel.row.role == "wrap"), lump.where)

    def _make(self, place: int) -> None:
        """Make a product: it holds every part that went in, and takes the place of what it was made of."""
        mention, one = self.mentions[place], self.said[place]
        where = self._place(one, mention.node, Lump(one.label, {one.label}, (), []))
        sources = self._sources(one, where)
        if not sources and self.happening.made:
            self._alias(self.happening.made[-1], one, mention.node)
            return
        if not self._may_become(one, sources):
            names = ", ".join(sorted({part.name for lump in sources for part in lump.parts})) or "nothing"
            self.happening.fault("W2", f"{one.label} does not come of {names}", mention.node)
        splits = self.happening.does("separate", "open", "shell", "fetch", "cut", "peel", "core", "stone", "husk")
        keeps = (splits and not one.names) or one.remains
        shared = [part for lump in sources for part in lump.parts]
        parts = [part.copy(remains=one.remains) for part in shared] if keeps else shared
        if keeps:
            self.supply.parts += parts
        if not parts:
            parts = [self.supply.new_part(one.label, mention.node.states, self.happening.number)]
            self.happening.taken += parts
        product = Lump(one.label, {one.label}, mention.node.states, parts, number=mention.thing, made=True)
        product.last = self.happening.number
        for lump in sources:
            if not keeps:
                self._consume(lump, product)
        self.supply.keep(product, where)
        self.mapped.add(id(product))
        self.happening.outputs[mention.node] = product
        self.happening.made.append(product)

    def _alias(self, lump: Lump, one: Said, node: ObjectNode) -> None:
        """Give what was just made a second name: a salad that is also told as the greek salad."""
        lump.names.add(one.label)
        self.happening.outputs[node] = lump
        self.supply.keep(lump, lump.where)

    def _may_become(self, one: Said, sources: Sequence[Lump]) -> bool:
        """Whether what went in can make a food; a tap, a can and an appliance give what they hold."""
        if not sources and any(vessel.row.role in {"storage", "appliance"} for vessel in self.happening.vessels):
            return True
        return can_become(self.world.tables, one, sources)

    def _sources(self, one: Said, where: Vessel | None) -> list[Lump]:
        outputs = {other.label for other in self.said if other.utensil is None}
        explicit = [lump for lump in self.happening.inputs if lump.label not in outputs and not lump.gone]
        if not explicit:
            explicit = [lump for lump in self.happening.inputs if lump.label != one.label and not lump.gone]
        found = list(explicit)
        works = self.happening.does(*_WORKS) or is_product(self.world.tables, one)
        for vessel in self.happening.vessels:
            for lump in vessel.lumps:
                if lump in found or lump.label in outputs:
                    continue
                wanted = not one.names.isdisjoint(lump.names | {part.name for part in lump.parts})
                if wanted or (works and (vessel is where or not explicit)):
                    found.append(lump)
        found += [rider for lump in explicit for rider in lump.riders if rider not in found and not rider.gone]
        if where is not None and works:
            found += [lump for lump in where.lumps if lump not in found and lump.label not in outputs]
        return found

    def _ingredient_fault(self, name: str, node: ObjectNode) -> None:
        facts = self.world.tables.foods.food(name)
        minor = facts.is_a("water", "spice", "herb", "fat", "sweet", "leaven", "salt")
        self.happening.fault("W2", f"it holds {name}, which did not go in", node, minor=minor)

    def _consume(self, lump: Lump, product: Lump) -> None:
        lump.gone = True
        self.supply.put(lump, None)
        product.names |= {name for name in lump.names if lump.made}
        self.mapped.add(id(lump))

    def _join_all(self, lump: Lump) -> None:
        """Mix into a lump all else that went in and has no output of its own, with all that shares its vessel."""
        others = [o for o in self.happening.inputs if o is not lump and id(o) not in self.mapped and not o.gone]
        if lump.where is not None:
            others += [o for o in lump.where.lumps if o is not lump and o not in others and id(o) not in self.mapped]
        for other in others:
            lump.parts += [part for part in other.parts if part not in lump.parts]
            self._consume(other, lump)
        if others:
            self.supply.keep(lump, lump.where)

    # --- contents ---

    def _gather(self, place: int) -> None:
        """Bring to a food what its output node holds and what went in beside it: cream that is spread on a dough."""
        one, lump = self.said[place], self.happening.outputs[self.mentions[place].node]
        there = set(lump.names) | {part.name for part in lump.parts} | (lump.where.names if lump.where else set())
        for name in sorted(one.names - there - {one.label}):
            other = self._to_be_moved(name, lump.where)
            if other is not None and other is not lump:
                lump.parts += [part for part in other.parts if part not in lump.parts]
                lump.names |= other.names
                self._consume(other, lump)
                self.supply.keep(lump, lump.where)
            elif name not in {said.label for said in self.said}:
                self._derived(name, self.mentions[place].node, lump.where)

    def _derived(self, name: str, node: ObjectNode, where: Vessel | None) -> None:
        """Put into a vessel what only its name tells of: a part of something that went in, or a thing from nowhere."""
        if where is not None and where.row.role == "storage":
            self.supply.name_lump(name, self.happening.number, where)  # a can that is opened shows what is in it
            return
        for lump in self._all_lumps():
            if any(_is_part_of(name, other) for other in (*lump.names, *(part.name for part in lump.parts))):
                self._portion_called(name, lump, where)
                return
        if self.happening.does("separate") and self._all_lumps():
            self._portion_called(name, self._all_lumps()[0], where)
        elif not _is_among(name, self.brought):
            self._out_of_nowhere(name, node, where)

    def _portion_called(self, name: str, lump: Lump, where: Vessel | None) -> None:
        if where is not None and (lump.where is where or name in where.names):
            lump.names.add(name)
            self.supply.keep(lump, lump.where)
            return
        parts = [part.copy() for part in lump.parts]
        self.supply.parts += parts
        portion = Lump(name, {name}, (), parts, made=True, last=self.happening.number)
        self.supply.keep(portion, where)
        self.mapped.add(id(portion))
        self.happening.made.append(portion)

    def _out_of_nowhere(self, name: str, node: ObjectNode, where: Vessel | None) -> None:
        """Tell an ingredient that did not go in; it is there all the same from now on, so that it is told once."""
        self._ingredient_fault(name, node)
        self.supply.name_lump(name, self.happening.number, where)

    def _fill(self, one: Said, vessel: Vessel) -> None:
        """Bring into a vessel what its output node holds and what has not come there yet."""
        for name in sorted(one.names - vessel.names):
            lump = self._to_be_moved(name, vessel)
            if lump is not None:
                self._leave_rest(lump)
                self.supply.put(lump, vessel)
                self.mapped.add(id(lump))
            elif name not in {other.label for other in self.said}:
                self._derived(name, one.node, vessel)
        if one.empty or (not one.names and self.happening.does("move") and vessel.lumps and self._poured_out(vessel)):
            self._empty(vessel)

    def _poured_out(self, vessel: Vessel) -> bool:
        """Whether a vessel that is told without contents was poured out: another one holds them by its node."""
        claimed = [other.names for place, other in enumerate(self.said) if self.vessel_of.get(place) is not vessel]
        return any(not names.isdisjoint(vessel.names) for names in claimed)

    def _to_be_moved(self, name: str, vessel: Vessel | None) -> Lump | None:
        for lump in self._all_lumps():
            stayed = id(lump) in self.mapped and lump.where is self.before.get(id(lump), lump.where)
            if lump.gone or lump.where is vessel or (id(lump) in self.mapped and not stayed):
                continue
            if name in lump.names or any(part.name == name for part in lump.parts):
                return lump
        return None

    def _empty(self, vessel: Vessel) -> None:
        """Move what is left of a vessel that is told empty to where the rest went; without such a place it is gone."""
        targets = [
            other for place, other in self.vessel_of.items()
            if other is not vessel and not other.is_appliance and self.said[place].names and other.row.role != "storage"
        ]  # fmt: skip
        targets += [lump.where for lump in self.happening.outputs.values() if lump.where not in (None, vessel)]  # type: ignore[misc]
        for lump in list(vessel.lumps):
            drained = self.happening.does(*_LETS_GO) and lump.parts and lump.parts[0].food.is_a("water", "liquid")
            if targets and not drained and vessel.row.role != "storage":
                self.supply.put(lump, targets[0])
            else:
                self.supply.put(lump, None)
                lump.gone = vessel.row.role != "storage"

    def _let_go(self) -> None:
        """Bring what was put in and is named in no output to where the step brings things: into the one target."""
        targets = [v for v in self.vessel_of.values() if not v.is_appliance and v.row.role in {"vessel", "wrap"}]
        targets += [lump.where for lump in self.happening.outputs.values() if lump.where is not None]
        for lump in self.happening.inputs:
            if lump.gone or id(lump) in self.mapped:
                continue
            carried = lump.where is None or lump.where.row.role in {"storage", "place"}
            carried = carried or (bool(targets) and lump.label in self._claimed_by(targets[0]))
            if targets and carried and self.happening.does("move", "scatter", *_WORKS):
                self.supply.put(lump, targets[0])
            elif self.happening.does("discard"):
                self.supply.put(lump, None)
                lump.gone = True

    def _claimed_by(self, vessel: Vessel) -> frozenset[str]:
        """Return what the output nodes of a vessel say it holds."""
        return frozenset().union(*(self.said[place].names for place, v in self.vessel_of.items() if v is vessel))

    def _remember(self) -> None:
        for node, lump in self.happening.outputs.items():
            self.supply.known_lumps[node] = lump
        for place, vessel in self.vessel_of.items():
            self.supply.known_vessels[self.mentions[place].node] = vessel
            if vessel not in self.happening.vessels:
                self.happening.vessels.append(vessel)
            vessel.last = self.happening.number
        for lump in self._all_lumps():
            old = self.before.get(id(lump), lump.where)
            if lump.where is not old or (lump.gone and id(lump) in self.before):
                self.happening.moved.append((lump, old, lump.where))
        self.happening.moved += [(lump, None, lump.where) for lump in self.happening.made]


def _is_called(lump: Lump, name: str) -> bool:
    """Whether a food is what somebody calls by a short name: a wrapper, meat, a sheet."""
    if any(own.split()[-1:] == [name] for own in lump.names):
        return True
    return any(part.name == name or part.food.is_a(name) for part in lump.parts)


def _is_part_of(name: str, other: str) -> bool:
    """Whether one name says more of what another names: lemon juice of a lemon, a beaten egg of an egg."""
    return name != other and bool(other) and set(other.split()) < set(name.split())


def _is_among(name: str, names: set[str]) -> bool:
    """Whether a food is among others, in the same words or with one word more (broth, chicken broth)."""
    if name in names:
        return True
    own = name.split()
    return any(
        other.split()[-1:] == own[-1:] and (set(own) <= set(other.split()) or set(other.split()) <= set(own))
        for other in names
        if other
    )
