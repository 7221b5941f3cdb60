"""Operators and frames out of the rows of the graph: they answer as those that are learnt in memory."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from functools import cached_property

from foon_kg.food import tables
from foon_kg.integration.joining.joining_counts import JoiningCounts
from foon_kg.integration.joining.layouts import Layout
from foon_kg.integration.joining.outlines import Outlines
from foon_kg.integration.joining.spots import StageType
from foon_kg.integration.methods import Methods
from foon_kg.integration.teaching.frames import Frame
from foon_kg.integration.teaching.operators import Evidence, Operators, Way
from foon_kg.model import Goal, Sighting
from foon_kg.model.recent import Recent
from foon_kg.store.graph.frame_rows import frame_of, outline_of
from foon_kg.store.graph.lifting import ANYTHING, APPLIANCE, KIND
from foon_kg.store.graph.method_rows import (
    EvidenceValue,
    FrameReadValue,
    FramesRow,
    MatterValue,
    MethodsCommonRow,
    MethodsRow,
)

Ask = Callable[[Sequence[str]], Iterable[FrameReadValue]]
"""Has the frames of some keys read."""


def methods_of(row: MethodsRow, goals: Iterable[Goal]) -> Methods:
    """Return what was learnt of a FOON with these ``goals``, from a ``row``."""
    methods = Methods(operators_of(row), frames_of(row.frames), tuple(goals))
    vars(methods)["joining_counts"] = joining_counts_of(row)  # they were counted when the frames were learnt
    return methods


def frames_of(texts: Iterable[str]) -> tuple[Frame, ...]:
    """Return the frames of some texts, in the order of methods."""
    frames = map(frame_of, texts)
    return tuple(sorted(frames, key=lambda frame: (frame.video, frame.goal.sort_key, frame.dish_type)))


def operators_of(row: MethodsRow) -> Operators:
    """Return the operators of a ``row``, with all their evidence."""
    found = Operators((), tables())
    ways: list[Way] = [(motion, tuple(tools)) for motion, tools in row.operators]
    _attest_all(found, ways, row)
    for way, gives, brings, places in zip(ways, row.gives, row.brings, row.places, strict=True):
        for state, count in gives:
            found.giving[state][way] = count
        for matter, role, count in brings:
            found.bringing[matter, role][way] = count
        if places:
            found.onto[way].update(dict(places))
    for matter, states in row.states:
        found.states[matter].update(states)
    return found


def _attest_all(found: Operators, ways: Sequence[Way], row: MethodsRow) -> None:
    """Give the operators their evidence: what each of the ``ways`` is done to and with, and where that is seen."""
    sightings = _Sightings()
    sightings.read(value for rows in row.evidence for _, value in rows)
    for way, evidence in zip(ways, row.evidence, strict=True):
        for matter, value in evidence:
            sightings.attest(found, way, matter, value)
        found.foods |= found.evidence[way].foods.keys()


class _Sightings:
    """The sightings that evidence names by their texts, each read once: many are named again and again."""

    def __init__(self) -> None:
        self._read: dict[str, Sighting] = {}

    def read(self, evidence: Iterable[EvidenceValue]) -> None:
        named = (text for _, _, seen, changes in evidence for text in (*seen, *changes))
        texts = [text for text in dict.fromkeys(named) if text not in self._read]
        values = json.loads(f"[{','.join(texts)}]")
        self._read.update((text, Sighting(*value)) for text, value in zip(texts, values, strict=True))

    def attest(self, found: Operators, way: Way, matter: str, evidence: EvidenceValue) -> None:
        """Write into ``found`` what attests that ``way`` is done to ``matter``; it was read before."""
        units, changed, seen, changes = evidence
        _attest(found.evidence[way], matter, units, [self._read[text] for text in seen])
        if changed:
            _attest(found.acts[way], matter, changed, [self._read[text] for text in changes])


def _attest(evidence: Evidence, matter: str, units: int, seen: list[Sighting]) -> None:
    if matter == ANYTHING:
        evidence.count, evidence.all = units, seen
    elif matter.startswith(KIND):
        evidence.kinds[matter.removeprefix(KIND)] = seen
    elif matter.startswith(APPLIANCE):
        evidence.appliances[matter.removeprefix(APPLIANCE)] = seen
    else:
        evidence.often[matter] = units
        evidence.foods[matter] = seen


def joining_counts_of(row: MethodsRow | MethodsCommonRow) -> JoiningCounts:
    """Return where foods of each kind join, from the counts in a ``row``."""
    counts = JoiningCounts((), tables())
    for kind, dish_type, work, heated, joins, count in row.stage_types:
        stage_type = StageType(work, heated, joins)
        for name in counts.names(kind.removeprefix(KIND)):
            for dish in (dish_type, ""):
                for counter, value in zip(counts.counts[name, dish], stage_type, strict=True):
                    counter[value] += count
    for kind, other, count in row.beside:
        counts.beside[kind.removeprefix(KIND)][other.removeprefix(KIND)] += count
    for kind, motion, count in row.cooked:
        for name in counts.names(kind.removeprefix(KIND)):
            counts.cooked[name][motion] += count
    return counts


MOST_LAYOUTS = 2048
"""How many frames are kept as places, 18 kB each: a large FOON has more than a program that serves it can hold."""


class LearntDishes:
    """The frames of one edition: their outlines, and each frame itself once somebody looked at it."""

    def __init__(self, row: FramesRow) -> None:
        self._layouts: Recent[str, Layout] = Recent(MOST_LAYOUTS)
        self._videos: dict[tuple[str, str], tuple[str, ...]] = {}
        self.outlines = Outlines(map(outline_of, sorted(row.frames)))

    def layouts(self, keys: Sequence[str], ask: Ask) -> list[Layout]:
        """Return the places of the frames called ``keys``, in that order.

        ``ask`` is asked for those not looked at lately.

        One that went meanwhile is left out: who wrote then made another edition, and the question is asked anew.
        """
        found = {key: layout for key in keys if (layout := self._layouts.find(key)) is not None}
        if missing := [key for key in keys if key not in found]:
            for key, text, videos in ask(missing):
                frame = frame_of(text)
                self._videos[frame.goal.key, frame.dish_type] = tuple(sorted(videos))
                found[key] = self._layouts[key] = Layout.of(frame, tables())
        return [found[key] for key in keys if key in found]

    def goal_of(self, frame: Frame) -> Goal:
        """Return the goal that a frame is of, which was looked at, with the videos that show a way to it."""
        videos = self._videos[frame.goal.key, frame.dish_type]
        return Goal(frame.goal, frame.dish_type, frame.goal.ingredients, videos)


class MethodsInPart(Methods):
    """The part of the methods that matters to one question; of the frames those are read that it looks at closely."""

    def __init__(self, operators: Operators, counts: JoiningCounts, dishes: LearntDishes, ask: Ask) -> None:
        super().__init__(operators, (), ())
        vars(self).update(joining_counts=counts, outlines=dishes.outlines, _dishes=dishes, _ask=ask)

    def layouts_of(self, keys: Iterable[str]) -> list[Layout]:
        """Return the places of the frames of some keys, in that order."""
        return self._dishes.layouts(list(keys), vars(self)["_ask"])

    def goal_of(self, frame: Frame) -> Goal:
        """Return the goal that a frame is of."""
        return self._dishes.goal_of(frame)

    @property
    def _dishes(self) -> LearntDishes:
        dishes: LearntDishes = vars(self)["_dishes"]
        return dishes


class CommonMethods:
    """What of the methods of one edition matters to every question; :meth:`operators_with` adds what one asks for."""

    def __init__(self, row: MethodsCommonRow) -> None:
        self._row = row
        self._ways: dict[int, Way] = {number: (motion, tuple(tools)) for number, motion, tools, _ in row.operators}
        self._sightings = _Sightings()
        self._sightings.read(value for *_, value in row.operators)
        self._sightings.read(value for *_, value in (*row.usual, *row.appliances))

    @cached_property
    def joining_counts(self) -> JoiningCounts:
        """Where foods of each kind join."""
        return joining_counts_of(self._row)

    @cached_property
    def _shared(self) -> Operators:
        """The operators with what matters to every question; its tables and its evidence are shared by all others."""
        found = Operators((), tables())
        for number, _, _, value in self._row.operators:
            self._sightings.attest(found, self._ways[number], ANYTHING, value)
        for number, matter, value in (*self._row.usual, *self._row.appliances):
            self._sightings.attest(found, self._ways[number], matter, value)
        found.foods.update(*(evidence.foods for evidence in found.evidence.values()))
        for number, state, count in self._row.gives:
            found.giving[state][self._ways[number]] = count
        for number, place, count in self._row.places:
            found.onto[self._ways[number]][place] = count
        for number, matter, role, count in self._row.brings:
            found.bringing[matter, role][self._ways[number]] = count
        for name, states in self._row.states:
            found.states[name].update(states)
        return found

    def operators_with(self, matters: Iterable[MatterValue]) -> Operators:
        """Return the operators with what is done to ``matters``, and how each of these is brought and found."""
        matters = list(matters)
        self._sightings.read(value for _, rows, _, _ in matters for _, value in rows)
        found = self._shared.to_be_told({self._ways[number] for _, rows, _, _ in matters for number, _ in rows})
        for name, rows, brings, states in matters:
            for number, value in rows:
                self._sightings.attest(found, self._ways[number], name, value)
            for number, role, count in brings:
                found.bringing[name, role][self._ways[number]] = count
            found.states[name].update(states)
            if rows and not name.startswith(KIND):
                found.foods.add(name)
        return found

    def methods_with(self, matters: Iterable[MatterValue], dishes: LearntDishes, ask: Ask) -> Methods:
        """Return the methods of a question about ``dishes`` and what ``matters``.

        They ``ask`` for the frames at which the question looks.
        """
        return MethodsInPart(self.operators_with(matters), self.joining_counts, dishes, ask)
