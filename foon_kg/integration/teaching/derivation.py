"""Frames from videos: a video is played in the world, and the lumps of matter are followed to its goals.

Two foods that are in one place from some step on until the dish is done have met there: one of them joined the other.
So the lines of a dish are found backwards from its goal, where all is in one place, by refining that set step by step.
"""

from __future__ import annotations

from collections.abc import Collection, Hashable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from foon_kg.food import Tables, is_among, singular, tables, words
from foon_kg.food.lists import word_list
from foon_kg.integration.teaching.frames import Frame, Line, Slot, Stage
from foon_kg.model import FunctionalUnit, ObjectNode
from foon_kg.world import Happening, Lump, Part, Step, World
from foon_kg.world.things import Vessel

_WORK = frozenset({
    "blend", "coat", "cut", "heat", "knead", "mash", "mix", "shape", "turn", "wait", "warm", "whip",
})  # fmt: skip
_MAKES = _WORK - {"cut", "turn"}
_FLAT = word_list("flat utensils")


@dataclass(frozen=True)
class _Place:
    """Where a part is after a step: what tells its place from others, the lump it is in, and that lump's vessel."""

    key: Hashable
    lump: Lump
    label: str
    states: tuple[str, ...]
    vessel: str
    relation: str
    stands: str


@dataclass(eq=False)
class _Cluster:
    """Parts that stay together from now on."""

    parts: frozenset[int]
    stages: list[Stage] = field(default_factory=list)
    waiting: list[Slot | Line] = field(default_factory=list)
    cooked: list[str] = field(default_factory=list)
    place: _Place | None = None
    brought: tuple[str, tuple[str, ...], str] = ("", (), "")


def frame_of(
    units: Sequence[FunctionalUnit], goal: ObjectNode, dish_type: str, video: str, known: Tables | None = None
) -> Frame | None:
    """Return how ``units``, those of one video in their order, make ``goal``; ``None`` where it is not followed."""
    return _Derivation(units, known or tables()).frame(goal, dish_type, video)


def frames_of(
    units: Sequence[FunctionalUnit], goals: Iterable[tuple[ObjectNode, str]], video: str, known: Tables | None = None
) -> tuple[Frame, ...]:
    """Return how one video makes each of its ``goals`` (node, dish type)."""
    derivation = _Derivation(units, known or tables())
    found = (derivation.frame(goal, dish_type, video) for goal, dish_type in goals)
    return tuple(frame for frame in found if frame is not None)


class _Derivation:
    def __init__(self, units: Sequence[FunctionalUnit], known: Tables) -> None:
        self.units = units
        self.known = known
        self.world = World(known=known)
        self.places: list[dict[int, _Place]] = []
        self.heated: list[frozenset[int]] = []
        self.over_heat: list[frozenset[str]] = []
        self.names: dict[Part, int] = {}
        self.fetched = self._fetched()
        self._found: dict[tuple[int, int], _Place | None] = {}
        for unit in units:
            number = self.world.play(Step.of(unit.input_nodes, unit.motion, unit.output_nodes)).number
            self.places.append(self._places())
            self.heated.append(frozenset(self._name(part) for part in self.world.supply.parts if part.heated == number))
            self.over_heat.append(self._over_heat())

    def _name(self, part: Part) -> int:
        """Return the number by which a part is known here: that of its first sighting."""
        return self.names.setdefault(part, len(self.names))

    def frame(self, goal: ObjectNode, dish_type: str, video: str) -> Frame | None:
        last = max((n for n, unit in enumerate(self.units) if goal in unit.output_nodes), default=None)
        if last is None:
            return None
        lump = self.world.happenings[last].outputs.get(goal)
        if lump is None:
            return None
        parts = {self._name(part): part for part in self._parts_of(lump, last) if not part.remains}
        if not parts:
            return None
        clusters = self._refined(parts, last)
        called = {_compact(goal.label), _compact(lump.label)}
        called -= self.fetched
        named_only = {n for n, p in parts.items() if p.untold and _compact(p.name) in called}
        named_only |= {n for n, p in parts.items() if p.untold and not self._goes_in(p)}
        parts = {n: p for n, p in parts.items() if n not in named_only} or parts
        clusters = [{n: c for n, c in step.items() if n in parts} for step in clusters]
        whole = self._followed(parts, clusters, last)
        line = _line(whole, last)
        mixed = {part.name for part in parts.values() if self._came_mixed(part)}
        mixed -= {p.name for p in parts.values() if not self._came_mixed(p) or p.food.is_a("made", "dough")}
        return (
            Frame(goal, dish_type, video, line, (*_lost(goal, line, self.known), *sorted(mixed)))
            if line.stages
            else None
        )

    def _fetched(self) -> frozenset[str]:
        """Return the names of foods that go into a unit before any unit gives them: they come from the kitchen."""
        found: set[str] = set()
        given: set[str] = set()
        for unit in self.units:
            names = [
                set(map(_compact, _names_in(nodes, self.known))) for nodes in (unit.input_nodes, unit.output_nodes)
            ]
            found |= names[0] - given
            given |= names[1]
        return frozenset(found)

    def _goes_in(self, part: Part) -> bool:
        """Whether the unit that first tells of a part takes it in; else only a name in its product tells of it."""
        return is_among(part.name, _names_in(self.units[part.taken].input_nodes, self.known))

    def _came_mixed(self, part: Part) -> bool:
        """Whether a part is only told as an ingredient of something that nobody made: it was lost before."""
        if not part.untold:
            return False
        foods = [
            node for node in self.units[part.taken].input_nodes if self.known.utensil(singular(node.label)) is None
        ]
        within = any(part.name in map(singular, node.ingredients) for node in foods)
        return within and all(singular(node.label) != part.name for node in foods)

    def _parts_of(self, lump: Lump, last: int) -> list[Part]:
        there = self.places[last]
        key = next((place.key for place in there.values() if place.lump is lump), None)
        found = [part for part, name in self.names.items() if name in there and there[name].key == key]
        return found or list(lump.parts)

    def _places(self) -> dict[int, _Place]:
        found: dict[int, _Place] = {}
        below: dict[int, Lump] = {}
        lumps = {id(lump): lump for lumps in self.world.supply.lumps.values() for lump in lumps if not lump.gone}
        for lump in lumps.values():
            for rider in lump.riders:
                if not rider.gone and rider is not lump:
                    below[id(rider)] = lump
        for lump in sorted(lumps.values(), key=_in_use):  # of a part that is in two places the latter counts
            place = _place(lump, below)
            for part in lump.parts:
                found[self._name(part)] = place
        return found

    def _place_of(self, part: Part, step: int) -> _Place | None:
        """Return where a part was after a step: it, or what it is a portion of."""
        name = self._name(part)
        found = self.places[step].get(name)
        if found is not None:
            return found
        if (name, step) not in self._found:
            self._found[name, step] = self._portion_of(part, step)
        return self._found[name, step]

    def _portion_of(self, part: Part, step: int) -> _Place | None:
        there = self.places[step]
        places = (there[name] for name in self._portions.get(part.origin, ()) if name in there)
        return max(places, key=lambda one: _in_use(one.lump), default=None)

    @cached_property
    def _portions(self) -> dict[int, list[int]]:
        """The numbers of the parts that come of the same food, by where that came from."""
        found: dict[int, list[int]] = {}
        for part, name in self.names.items():
            found.setdefault(part.origin, []).append(name)
        return found

    def _refined(self, parts: dict[int, Part], last: int) -> list[dict[int, int]]:
        """Return for each step the number of the cluster in which each part is."""
        steps: list[dict[int, int]] = []
        later = dict.fromkeys(parts, 0)
        for step in range(last, -1, -1):
            if step == last:
                steps.append(later)  # now it is one thing
                continue
            numbers: dict[Hashable, int] = {}
            now: dict[int, int] = {}
            for name, part in parts.items():
                place = self._place_of(part, step)
                key = (later[name], place.key if place is not None and part.taken <= step else ("new", name))
                now[name] = numbers.setdefault(key, len(numbers))
            steps.append(now)
            later = now
        return steps[::-1]

    def _followed(self, parts: dict[int, Part], steps: list[dict[int, int]], last: int) -> _Cluster:
        clusters = [_Cluster(frozenset([name])) for name in parts]
        for step in range(last + 1):
            happening = self.world.happenings[step]
            groups: dict[int, list[_Cluster]] = {}
            for cluster in clusters:
                groups.setdefault(steps[step][min(cluster.parts)], []).append(cluster)
            inside = self._inside(happening)
            clusters = [self._together(group, parts, inside, step) for group in groups.values()]
        return clusters[0]

    def _together(self, group: list[_Cluster], parts: dict[int, Part], inside: set[int], step: int) -> _Cluster:
        """Return what a group of clusters is after a step, of whose things those parts are ``inside``."""
        happening = self.world.happenings[step]
        first = self._receiver(group, parts, step) if len(group) > 1 else group[0]
        members = first.parts.union(*(cluster.parts for cluster in group if cluster is not first))
        place = self._place_of(parts[min(members)], step)
        involved = not inside.isdisjoint(members)
        if len(group) > 1:
            told = self._tells(happening)
            adds: list[Slot | Line] = (
                [] if first.stages or first.waiting else [_slot(first, parts, self.known, first.brought)]
            )
            for cluster in group:
                if cluster is not first:
                    adds += _joined(cluster, parts, self.known, told, step)
            first.waiting = _distinct([*first.waiting, *adds], first.stages, self.fetched, self.known)
        was = first.place
        first.parts, first.place = members, place or first.place
        if not involved:
            return first
        single = len({parts[name].name for name in members}) == 1
        works = not happening.motion.does.isdisjoint(_WORK)
        if single and not first.stages and not first.waiting:
            if happening.does("heat") and not self.heated[step].isdisjoint(members):
                first.cooked.append(happening.step.motion)
            if place is not None and (was is None or was.vessel != place.vessel):
                first.brought = (*self._tells(happening), was.vessel if was is not None else "")
            return first
        moved = was is not None and place is not None and (was.vessel, was.stands) != (place.vessel, place.stands)
        if works or (moved and was is not None and place is not None and was.vessel != place.vessel):
            first.stages.append(self._stage(first, happening, place, step, works=works))
            first.waiting = []
        return first

    def _stage(self, cluster: _Cluster, happening: Happening, place: _Place | None, step: int, *, works: bool) -> Stage:
        motion, tools = self._tells(happening)
        appliance, source = _appliance(happening, place, self.known) if works else ("", "")
        does = happening.motion.does
        if source == "heat" and "mix" in does and place is not None:
            lit = place.vessel in self.over_heat[step] and does <= {"mix", "move"}
            if lit or self._told_cooked(place, happening):
                does |= {"heat"}  # what is stirred over a fire cooks, though nobody noted the cooking
        bath = self._bath(cluster, happening) if "liquid" in does else []
        return Stage(
            (*bath, *cluster.waiting),
            motion,
            does,
            tools,
            place.vessel if place else "",
            place.relation if place else "in",
            appliance,
            source,
            place.label if place else "",
            place.states if place else (),
            step,
        )

    def _bath(self, cluster: _Cluster, happening: Happening) -> list[Slot]:
        """Return the water in which a dish is cooked that is not in it at the end: somebody poured it away."""
        lumps = [*happening.inputs, *(lump for vessel in happening.vessels for lump in vessel.lumps)]
        parts = {self._name(part): part for lump in lumps for part in lump.parts}
        others = [part for name, part in sorted(parts.items()) if name not in cluster.parts]
        water = next((part for part in others if part.food.is_a("water")), None)
        if water is None:
            return []
        return [Slot(water.name, self.known.foods.food(water.name, water.states).kind, water.states)]

    def _over_heat(self) -> frozenset[str]:
        """Return the names of the vessels that stand over a fire that burns."""
        vessels = (vessel for many in self.world.supply.vessels.values() for vessel in many)
        return frozenset(
            vessel.label
            for vessel in vessels
            if vessel.where is not None and vessel.where.row.source == "heat" and vessel.where.is_on(vessel.label)
        )

    def _told_cooked(self, place: _Place, happening: Happening) -> bool:
        before = {state for lump in happening.inputs for state in lump.states if lump.label == place.label}
        rows = [self.known.state(state) for state in place.states if state not in before or happening.made]
        return any(row.needs_heat or "cook" in row.earns or row.half for row in rows)

    def _tells(self, happening: Happening) -> tuple[str, tuple[str, ...]]:
        return happening.step.motion, tuple(sorted(singular(node.label) for node in happening.tools))

    def _inside(self, happening: Happening) -> set[int]:
        """Return the numbers of the parts of all that a step is about."""
        lumps = [*happening.inputs, *happening.outputs.values(), *happening.made]
        lumps += [lump for vessel in happening.vessels for lump in vessel.lumps if vessel.row.role != "storage"]
        lumps += [lump for lump, _, _ in happening.moved]
        return {self._name(part) for lump in lumps for part in lump.parts}

    def _receiver(self, group: list[_Cluster], parts: dict[int, Part], step: int) -> _Cluster:
        """Return the cluster that stays where it is while others come to it."""

        def order(cluster: _Cluster) -> tuple[bool, int, int, int]:
            place = self._place_of(parts[min(cluster.parts)], step)
            was = cluster.place.vessel if cluster.place is not None else ""
            stays = place is not None and bool(was) and was == place.vessel
            first = min(parts[name].taken for name in cluster.parts)
            return (
                stays,
                len(cluster.parts),
                -first,
                -min(parts[n].origin for n in cluster.parts),
            )

        return max(group, key=order)


def _names_in(nodes: Iterable[ObjectNode], known: Tables) -> set[str]:
    """Return the names of all foods in ``nodes``, whether they stand there by themselves or in a vessel."""
    names = {singular(name) for node in nodes for name in (node.label, *node.ingredients)}
    return {name for name in names if known.utensil(name) is None}


def _compact(name: str) -> str:
    """Return a name without its spaces: annotators write "hash brown" and "hashbrown" in one video."""
    return "".join(singular(name).split())


def _lost(goal: ObjectNode, line: Line, known: Tables) -> tuple[str, ...]:
    """Return the foods that are in the goal, as its annotator says, and that were not followed."""
    foods = [known.foods.food(slot.food, slot.states) for slot in line.all_slots()]
    foods += [known.foods.food(stage.label) for stage in line.all_stages()]
    there = {word for food in foods for word in (*words(food.name), food.taken_for, food.kind, *food.kinds)}
    told = (known.foods.food(name) for name in goal.ingredients if known.utensil(singular(name)) is None)
    return tuple(
        food.name
        for food in told
        if there.isdisjoint({*words(food.name), food.kind}) and not food.is_a("made", "dough")
    )


def _joined(
    cluster: _Cluster, parts: dict[int, Part], known: Tables, told: tuple[str, tuple[str, ...]], step: int
) -> list[Slot | Line]:
    if cluster.stages or cluster.waiting:
        line = _line(cluster, step)
        if any(not stage.does.isdisjoint(_MAKES) for stage in line.stages):
            return [line]
        return [add for stage in line.stages for add in stage.adds]  # foods that only were cut together
    source = cluster.place.vessel if cluster.place is not None else ""
    return [_slot(cluster, parts, known, (*told, source))]


def _slot(cluster: _Cluster, parts: dict[int, Part], known: Tables, brought: tuple[str, tuple[str, ...], str]) -> Slot:
    part = parts[min(cluster.parts)]
    states = cluster.place.states if cluster.place is not None else part.states
    kind = known.foods.food(part.name, part.states).kind
    return Slot(part.name, kind, states, tuple(dict.fromkeys(cluster.cooked)), *brought)


def _distinct(
    adds: Sequence[Slot | Line], stages: Sequence[Stage], fetched: Collection[str], known: Tables
) -> list[Slot | Line]:
    """Leave out foods that are only the name of what is made here, and portions of one food that come together.

    A dish may be called like a food of it (black beans): that of the names of ``fetched`` foods is no mere name.
    """
    kept: list[Slot | Line] = []
    inside = {slot.food for stage in stages for slot in stage.slots}
    made = {singular(stage.label) for stage in stages}
    for add in adds:
        if isinstance(add, Line):
            made |= {singular(stage.label) for stage in add.stages}
            inside |= {slot.food for slot in add.all_slots()}
    for add in adds:
        if isinstance(add, Slot):
            facts = known.foods.food(add.food, add.states)
            named = add.food in made and (_compact(add.food) not in fetched or facts.is_a("made"))
            if add.food in inside or named or (facts.is_a("made") and facts.is_a("batter", "dough")):
                continue
            inside.add(add.food)
        kept.append(add)
    return kept


def _line(cluster: _Cluster, step: int) -> Line:
    stages = list(cluster.stages)
    if cluster.waiting:
        place = cluster.place
        stages.append(
            Stage(
                tuple(cluster.waiting), "", frozenset(), (), place.vessel if place else "",
                place.relation if place else "in", "", "", place.label if place else "",
                place.states if place else (), step,
            )
        )  # fmt: skip
    last = stages[-1:] if stages and _only_moves(stages[-1]) else []
    return Line((*_without_detours(stages[: len(stages) - len(last)]), *last))


def _without_detours(stages: Sequence[Stage]) -> list[Stage]:
    """Leave out bringing the whole to a place from which it is only brought on."""
    kept: list[Stage] = []
    for stage in stages:
        if kept and _only_moves(kept[-1]):
            before = kept.pop()
            stage = replace(stage, adds=(*before.adds, *stage.adds))  # noqa: PLW2901
        kept.append(stage)
    return kept


def _only_moves(stage: Stage) -> bool:
    return stage.does.isdisjoint(_WORK)


def _in_use(lump: Lump) -> tuple[bool, int, int]:
    """Return a key by which those come last that are in use: not rests in packets, touched of late, of many foods."""
    return (lump.where is None or not lump.where.row.keeps_food, lump.last, len(lump.parts))


def _place(lump: Lump, below: dict[int, Lump]) -> _Place:
    base = lump
    seen = {id(lump)}
    while id(base) in below and id(below[id(base)]) not in seen:
        base = below[id(base)]
        seen.add(id(base))
    where = lump.where
    label = where.label if where is not None else ""
    relation = "on" if label.rpartition(" ")[2] in _FLAT else "in"
    stands = where.where.label if where is not None and where.where is not None else ""
    keeps = where is None or where.row.role in {"storage", "place", "appliance"} or where.row.keeps_food
    cuts = where is not None and "cut" in where.row.can
    own: Hashable = ("lump", id(base)) if keeps or cuts else ("vessel", id(where))
    return _Place(own, lump, lump.label, lump.states, label, relation, stands)


def _appliance(happening: Happening, place: _Place | None, known: Tables) -> tuple[str, str]:
    found: list[Vessel] = [vessel for vessel in happening.vessels if vessel.is_appliance]
    held = next((one for one in found if one.row.source == "power" and not one.row.holds), None)
    if held is not None and "heat" not in happening.motion.does:
        return held.label, held.row.source  # whatever the vessel stands on, a hand mixer does it
    for vessel in happening.vessels:
        below = vessel.where
        while below is not None:
            if below.is_appliance:
                found.append(below)
            below = below.where
    if place is not None and place.stands:
        row = known.utensil(place.stands)
        if row is not None and row.role == "appliance":
            return place.stands, row.source
    for vessel in found:
        if vessel.row.source in {"heat", "cold", "power"}:
            return vessel.label, vessel.row.source
    return "", ""
