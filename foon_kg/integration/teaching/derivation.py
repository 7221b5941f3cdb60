"""Frames from videos: a video is played in the world, and the lumps of matter are followed to its goals.

Two foods that are in one place from some step on until the dish is done have met there: one of them joined the other.
So the lines of a dish are found backwards from its goal, where all is in one place, by refining that set step by step.
Where things are is in :mod:`~foon_kg.integration.teaching.played`, how lines grow of what meets in
:mod:`~foon_kg.integration.teaching.lines`.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Sequence

from foon_kg.food import Tables, singular, tables, words
from foon_kg.integration.teaching.frames import Frame, Line, Slot, Stage
from foon_kg.integration.teaching.lines import WORK, Cluster, distinct, joined, place_told
from foon_kg.integration.teaching.played import Place, Played, compact
from foon_kg.model import FunctionalUnit, ObjectNode
from foon_kg.world import Part, PlayedStep
from foon_kg.world.things import Vessel


def frame_of(
    units: Sequence[FunctionalUnit], goal: ObjectNode, dish_type: str, video: str, known: Tables | None = None
) -> Frame | None:
    """Return how ``units``, those of one video in their order, make ``goal``; ``None`` where it is not followed.

    ``dish_type`` is that of the goal; ``known`` are the tables, by default those of the package.
    """
    return _Derivation(units, known or tables()).frame(goal, dish_type, video)


def frames_of(
    units: Sequence[FunctionalUnit], goals: Iterable[tuple[ObjectNode, str]], video: str, known: Tables | None = None
) -> tuple[Frame, ...]:
    """Return how one video, by its ``units`` in their order, makes each of its ``goals`` (node, dish type).

    ``known`` are the tables, by default those of the package.
    """
    derivation = _Derivation(units, known or tables())
    found = (derivation.frame(goal, dish_type, video) for goal, dish_type in goals)
    return tuple(frame for frame in found if frame is not None)


class _Derivation:
    def __init__(self, units: Sequence[FunctionalUnit], known: Tables) -> None:
        self.units = units
        self.known = known
        self.played = Played(units, known)

    def frame(self, goal: ObjectNode, dish_type: str, video: str) -> Frame | None:
        """Return how ``goal`` is made, as the last unit that gives it has it; ``None`` where it is not followed."""
        last = max((n for n, unit in enumerate(self.units) if goal in unit.output_nodes), default=None)
        parts = self._parts_of(goal, last) if last is not None else {}
        if last is None or not parts:
            return None
        line = self._followed(parts, last).line(last)
        if not line.stages:
            return None
        # foods that the dish has and the frame has not: the choice of a frame counts them against it
        weak = (*_lost(goal, line, self.known), *self._mixed(parts.values()))
        return Frame(goal, dish_type, video, line, weak)

    def _parts_of(self, goal: ObjectNode, last: int) -> dict[int, Part]:
        """Return the parts of a goal by their numbers, without those of which only a name tells if there are others."""
        lump = self.played.played_steps[last].outputs.get(goal)
        if lump is None:
            return {}
        parts = {self.played.number(part): part for part in self.played.parts_of(lump, last) if not part.remains}
        called = {compact(goal.label), compact(lump.label)} - self.played.fetched

        def is_only_named(part: Part) -> bool:
            return part.unstated and (compact(part.name) in called or not self.played.goes_in(part))

        return {number: part for number, part in parts.items() if not is_only_named(part)} or parts

    def _mixed(self, parts: Iterable[Part]) -> list[str]:
        """Return the names of foods that only came as an ingredient of something that nobody made, sorted."""
        mixed: set[str] = set()
        others: set[str] = set()
        for part in parts:
            lost = self.played.came_mixed(part)
            if lost:
                mixed.add(part.name)
            if not lost or part.food.is_a("made", "dough"):
                others.add(part.name)
        return sorted(mixed - others)

    def _refined(self, parts: dict[int, Part], last: int) -> list[dict[int, int]]:
        """Return for each step the number of the cluster in which each part is."""
        now = dict.fromkeys(parts, 0)  # at the last step it is one thing
        steps = [now]
        for step in range(last - 1, -1, -1):
            if len(set(now.values())) < len(parts):
                now = self._parted(parts, now, step)
            steps.append(now)
        return steps[::-1]

    def _parted(self, parts: dict[int, Part], later: dict[int, int], step: int) -> dict[int, int]:
        """Return the clusters of ``later`` parted by where their parts were after a step."""
        numbers: dict[Hashable, int] = {}
        now: dict[int, int] = {}
        for name, part in parts.items():
            place = self.played.place_of(name, step) if part.taken <= step else None
            key = (later[name], ("new", name) if place is None else place.key)
            now[name] = numbers.setdefault(key, len(numbers))
        return now

    def _followed(self, parts: dict[int, Part], last: int) -> Cluster:
        """Return the one cluster that all parts are in after the last step, with the stages that led to it."""
        clusters = [Cluster(frozenset([name]), name) for name in parts]
        before: dict[int, int] = {}
        for step, together in enumerate(self._refined(parts, last)):
            if together != before:
                clusters = [self._met(group, parts, step) for group in _grouped(clusters, together)]
                before = together
            inside = self.played.inside(step)
            for cluster in clusters:
                if not inside.isdisjoint(cluster.parts):
                    self._work_on(cluster, parts, step)
        whole = clusters[0]
        self._keep_up(whole, parts, last)
        return whole

    def _keep_up(self, cluster: Cluster, parts: dict[int, Part], step: int) -> None:
        """Let a cluster be in the place where it was after a step, which is the last known where it was in none."""
        earliest = max(cluster.step, parts[cluster.first].taken - 1)
        places = (self.played.place_of(cluster.first, one) for one in range(step, earliest, -1))
        cluster.place = next(filter(None, places), cluster.place)
        cluster.step = step

    def _work_on(self, cluster: Cluster, parts: dict[int, Part], step: int) -> None:
        """Note what a step does to a cluster with which it works."""
        self._keep_up(cluster, parts, step - 1)
        was, place = cluster.place, self.played.place_of(cluster.first, step)
        cluster.place, cluster.step = place or was, step
        played_step = self.played.played_steps[step]
        if cluster.is_untouched and len({parts[name].name for name in cluster.parts}) == 1:
            self._handle_alone(cluster, was, place, step)
        elif _works(played_step) or _is_brought_on(was, place):
            cluster.stages.append(self._stage(cluster, played_step, place, step))
            cluster.waiting = []

    def _handle_alone(self, cluster: Cluster, was: Place | None, now: Place | None, step: int) -> None:
        """Note what a step does to a food by itself, which ``was`` in one place and is in another ``now``."""
        played_step = self.played.played_steps[step]
        if played_step.does("heat") and not self.played.heated[step].isdisjoint(cluster.parts):
            cluster.cooked.append(played_step.step.motion)
        if now is not None and (was is None or was.vessel != now.vessel):
            cluster.brought = (*_motion_of(played_step), was.vessel if was is not None else "")

    def _met(self, group: list[Cluster], parts: dict[int, Part], step: int) -> Cluster:
        """Return clusters that meet in a step as one: that which stays where it is, with what waits to be worked in."""
        if len(group) == 1:
            return group[0]
        for cluster in group:
            self._keep_up(cluster, parts, step - 1)
        receiver = self._receiver(group, parts, step)
        others = [cluster for cluster in group if cluster is not receiver]
        motion = _motion_of(self.played.played_steps[step])
        adds: list[Slot | Line] = [receiver.slot(parts, self.known, receiver.brought)] if receiver.is_untouched else []
        for cluster in others:
            if cluster.is_untouched:
                adds.append(cluster.slot(parts, self.known, (*motion, cluster.vessel)))
            else:
                adds += joined(cluster.line(step))
        receiver.waiting = distinct([*receiver.waiting, *adds], receiver.stages, self.played.fetched, self.known)
        receiver.parts = receiver.parts.union(*(cluster.parts for cluster in others))
        receiver.first = min(receiver.parts)
        return receiver

    def _receiver(self, group: list[Cluster], parts: dict[int, Part], step: int) -> Cluster:
        """Return the cluster that stays where it is while others come to it."""

        # what stays in its vessel, else the greater part, else what was there first
        def order(cluster: Cluster) -> tuple[bool, int, int, int]:
            place = self.played.place_of(cluster.first, step)
            stays = place is not None and bool(cluster.vessel) and cluster.vessel == place.vessel
            first = min(parts[name].taken for name in cluster.parts)
            return (stays, len(cluster.parts), -first, -min(parts[n].origin for n in cluster.parts))

        return max(group, key=order)

    def _stage(self, cluster: Cluster, played_step: PlayedStep, place: Place | None, step: int) -> Stage:
        """Return what a step does to a cluster, which is at ``place`` then, and to what waits to be worked in."""
        motion, tools = _motion_of(played_step)
        appliance, source = _appliance(played_step, place, self.known) if _works(played_step) else ("", "")
        does = played_step.motion.does
        if source == "heat" and place is not None and self._is_stirred_hot(played_step, place, step):
            does |= {"heat"}  # what is stirred over a fire cooks, though nobody noted the cooking
        bath = self._bath(cluster, played_step) if "liquid" in does else []
        adds = (*bath, *cluster.waiting)
        vessel, relation, label, states = place_told(place)
        return Stage(adds, motion, does, tools, vessel, relation, appliance, source, label, states, step)

    def _is_stirred_hot(self, played_step: PlayedStep, place: Place, step: int) -> bool:
        does = played_step.motion.does
        if "mix" not in does:
            return False
        lit = place.vessel in self.played.over_heat[step] and does <= {"mix", "move"}
        return lit or self._told_cooked(place, played_step)

    def _bath(self, cluster: Cluster, played_step: PlayedStep) -> list[Slot]:
        """Return the water in which a dish is cooked that is not in it at the end: somebody poured it away."""
        lumps = [*played_step.inputs, *(lump for vessel in played_step.vessels for lump in vessel.lumps)]
        parts = {self.played.number(part): part for lump in lumps for part in lump.parts}
        others = [part for name, part in sorted(parts.items()) if name not in cluster.parts]
        water = next((part for part in others if part.food.is_a("water")), None)
        if water is None:
            return []
        return [Slot(water.name, self.known.foods.food(water.name, water.states).kind, water.states)]

    def _told_cooked(self, place: Place, played_step: PlayedStep) -> bool:
        """Whether what is at a place is called cooked after a step, and was not before."""
        before = {state for lump in played_step.inputs for state in lump.states if lump.label == place.label}
        rows = [self.known.state(state) for state in place.states if state not in before or played_step.made]
        return any(row.needs_heat or "cook" in row.earns or row.half for row in rows)


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


def _grouped(clusters: Iterable[Cluster], together: dict[int, int]) -> list[list[Cluster]]:
    """Return clusters in groups of those that are ``together``: of the same number, by their first parts."""
    groups: dict[int, list[Cluster]] = {}
    for cluster in clusters:
        groups.setdefault(together[cluster.first], []).append(cluster)
    return list(groups.values())


def _works(played_step: PlayedStep) -> bool:
    """Whether a step changes something, and does not only bring it somewhere."""
    return not played_step.motion.does.isdisjoint(WORK)


def _motion_of(played_step: PlayedStep) -> tuple[str, tuple[str, ...]]:
    """Return the motion of a step and the labels of its tools, sorted: a :data:`~.operators.Way`."""
    return played_step.step.motion, tuple(sorted(singular(node.label) for node in played_step.tools))


def _is_brought_on(was: Place | None, now: Place | None) -> bool:
    """Whether a thing is in another vessel than before; of what comes out of nowhere nobody knows."""
    return was is not None and now is not None and was.vessel != now.vessel


def _appliance(played_step: PlayedStep, place: Place | None, known: Tables) -> tuple[str, str]:
    """Return what works on a thing at ``place`` in a step, and by what (heat, cold, power); ``""`` for nothing."""
    held = _held(played_step)
    if held is not None:
        return held.label, held.row.source
    stands = _stands_on(place, known) if place is not None else None
    if stands is not None:
        return stands
    for vessel in _appliances(played_step.vessels):
        if vessel.row.source in {"heat", "cold", "power"}:
            return vessel.label, vessel.row.source
    return "", ""


def _held(played_step: PlayedStep) -> Vessel | None:
    """Return what hands hold to a thing: whatever the vessel stands on, a hand mixer does what heat does not."""
    if "heat" in played_step.motion.does:
        return None
    held = (one for one in played_step.vessels if one.row.source == "power" and not one.row.holds)
    return next((one for one in held if one.is_appliance), None)


def _stands_on(place: Place, known: Tables) -> tuple[str, str] | None:
    """Return the appliance on which the vessel of a place stands, and by what that works; ``None`` for no such."""
    row = known.utensil(place.stands) if place.stands else None
    return (place.stands, row.source) if row is not None and row.role == "appliance" else None


def _appliances(vessels: Sequence[Vessel]) -> Iterator[Vessel]:
    """Yield the appliances among vessels, then those on which they stand, or stand what they stand on."""
    yield from (vessel for vessel in vessels if vessel.is_appliance)
    for vessel in vessels:
        below = vessel.where
        while below is not None:
            if below.is_appliance:
                yield below
            below = below.where
