"""Keeping operators and frames true: what a write transaction learns from the units and videos that come and go."""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from itertools import chain
from typing import Any

from foon_kg.integration.teaching.operators import MOST_SIGHTINGS
from foon_kg.model import FunctionalUnit
from foon_kg.store.graph import statements as cypher
from foon_kg.store.graph.frame_rows import Joins, frame_of, slot_foods
from foon_kg.store.graph.lifting import Lifted, Tally, is_food, lifted, matter_rows
from foon_kg.store.graph.statements import Ask
from foon_kg.store.graph.taught import Taught
from foon_kg.store.graph.video_rows import KeptSighting, written_sighting

Pair = tuple[str, str]
"""The key of an operator, and a matter to which it is done."""

Seen = tuple[list[KeptSighting], list[KeptSighting]]
"""Where an operator is done to a matter, and where it changes it."""

Attests = tuple[str, Collection[str], Collection[str]]
"""What a unit attests: the key of its operator, to what that is done, and what of it it changes."""


class Learner:
    """Learns within one transaction.

    In this order: :meth:`forget` videos, :meth:`learn` what is new, :meth:`unlearn` the units that are about to go, and
    :meth:`finish` when they have gone.
    """

    def __init__(self, ask: Ask) -> None:
        self._ask = ask
        self._tally = Tally()
        self._joins = Joins()
        self._matters: set[str] = set()
        self._spoken_of: set[str] = set()
        self._forgotten: set[str] = set()
        self._sighted: defaultdict[str, list[KeptSighting]] = defaultdict(list)
        self._attested: dict[str, Attests] = {}
        self._kept: dict[Pair, tuple[int, int]] = {}
        """Of the pairs that the graph has, how many units it counts, and how many of these change the matter."""

    @property
    def matters(self) -> Set[str]:
        """The names of the matters that were written."""
        return self._matters

    def forget(self, names: Sequence[str]) -> None:
        """Take away the frames of the named videos."""
        self._forgotten.update(names)
        rows = self._ask(cypher.FORGET_FRAMES, names=names)
        frames = [frame_of(row.text) for row in rows]
        self._joins.count(frames, weight=-1)
        self._spoken_of |= slot_foods(frames)

    def learn(self, new: Iterable[str], taught: Sequence[Taught]) -> None:
        """Learn from videos, which the graph has with all their sightings, and from the units ``new`` in it, by key.

        ``taught`` is what each of the videos teaches by itself.
        """
        said = dict(chain.from_iterable(one.units.items() for one in taught))
        units = {key: said[key] for key in new}
        frames = list(chain.from_iterable(one.frames for one in taught))
        self._note_attested(units)
        self._tally.count(units.values())
        self._joins.count(frames)
        self._make_matters(self._tally.matters() | self._joins.matters() | slot_foods(frames))
        for unit, seen in chain.from_iterable(one.rows.seen for one in taught):
            self._sighted[unit].append(seen)
        if units:
            self._ask(cypher.LOAD_OPERATORS, operators=list(_operator_rows(units)))
        if frames:
            self._ask(cypher.LOAD_FRAMES, frames=list(chain.from_iterable(one.frame_rows for one in taught)))

    def _note_attested(self, units: Mapping[str, Lifted]) -> None:
        """Note what new units attest, so that the graph is not asked for what it was just told."""
        self._attested.update((key, (unit.operator, unit.done_to, unit.changes)) for key, unit in units.items())

    def unlearn(self, gone: Iterable[FunctionalUnit], doubtful: Collection[str]) -> None:
        """Take away what units ``gone`` say; they are among the ``doubtful``, which lost a sighting."""
        self._tally.count(map(lifted, gone), weight=-1)
        keys = sorted({*self._sighted, *doubtful} - self._attested.keys())
        for row in self._ask(cypher.ATTESTED, keys=keys) if keys else ():
            self._attested.update((unit, (operator, done, changes)) for unit, operator, done, changes in row.attested)

    def finish(self, doubtful: Collection[str]) -> None:
        """Bring evidence and counts up to date; ``doubtful`` are the units that lost a sighting."""
        pairs = {*self._pairs(doubtful), *self._pairs(self._sighted)}
        if pairs:
            self._ask(cypher.LOAD_EVIDENCE, rows=self._evidence_rows(self._evidence(pairs)))
            if usual := list(self._usual_rows(pairs)):
                self._ask(cypher.USUAL_FOODS, rows=usual)
        counts, joins = self._tally.rows(), self._joins.rows()
        if any(counts.values()):
            self._ask(cypher.COUNT_OPERATORS, **counts)
        if any(joins.values()):
            self._ask(cypher.COUNT_JOINS, **joins)
        if doubtful:
            self._ask(cypher.SWEEP_OPERATORS, foods=sorted(self._spoken_of | self._tally.matters()))

    def _make_matters(self, wanted: set[str]) -> None:
        if fresh := wanted - self._matters:
            self._ask(cypher.LOAD_MATTERS, **matter_rows(fresh))
            self._matters |= fresh

    def _pairs(self, units: Iterable[str]) -> Iterator[Pair]:
        for unit in units:
            operator, done, _ = self._attested[unit]
            yield from ((operator, matter) for matter in done)

    def _evidence(self, pairs: set[Pair]) -> dict[Pair, Seen]:
        """Return the evidence for ``pairs``: what was kept, with what is new.

        Where some of it went it is found out anew if there may be more than was kept: fewer than that are all.
        """
        found: dict[Pair, Seen] = {pair: ([], []) for pair in pairs}
        lost = self._add_kept(found)
        self._add_sighted(found)
        found.update((pair, ([], [])) for pair in lost)
        for again in self._ask(cypher.FIRST_SIGHTINGS, pairs=_by_operator(lost), most=MOST_SIGHTINGS) if lost else ():
            seen, changes = (list(map(written_sighting, sightings)) for sightings in (again.seen, again.changes))
            found[again.operator, again.matter] = seen, changes
        return found

    def _add_kept(self, found: dict[Pair, Seen]) -> set[Pair]:
        """Add the evidence that the graph has; return the pairs of which some went, so that others may be missing."""
        lost: set[Pair] = set()
        for row in self._ask(cypher.EVIDENCE, pairs=_by_operator(found)):
            for operator, matter, units, changed, *kept in row.kept:
                self._kept[operator, matter] = units, changed
                for sightings, texts in zip(found[operator, matter], kept, strict=True):
                    left = [one for one in map(_read, texts) if one[0] not in self._forgotten]
                    sightings.extend(left)
                    if len(left) < len(texts) >= MOST_SIGHTINGS:
                        lost.add((operator, matter))
        return lost

    def _add_sighted(self, found: dict[Pair, Seen]) -> None:
        """Add the evidence that came since."""
        for unit, new in self._sighted.items():
            operator, done, changes = self._attested[unit]
            for matter in done:
                seen, changed = found[operator, matter]
                seen += new
                changed += new if matter in changes else []

    def _usual_rows(self, pairs: set[Pair]) -> Iterator[dict[str, Any]]:
        """Yield, for each operator, the leaders of the foods to which it is done more often now, and all with less."""
        less, more = defaultdict[str, list[str]](list), defaultdict[str, list[tuple[str, int, int]]](list)
        for pair in sorted(pairs):
            if not is_food(pair[1]):
                continue
            done, changed = self._tally.done[pair], self._tally.changed[pair]
            if done < 0 or changed < 0:
                less[pair[0]].append(pair[1])
            if done > 0 or changed > 0:  # perhaps both: new content may do more to a food, and change it less
                kept = self._kept.get(pair, (0, 0))
                more[pair[0]].append((pair[1], kept[0] + done, kept[1] + changed))
        for operator in sorted(less.keys() | more.keys()):
            yield {"operator": operator, "more": _leaders(more[operator]), "less": less[operator]}

    def _evidence_rows(self, evidence: dict[Pair, Seen]) -> list[dict[str, Any]]:
        """Return a row for each operator: its pairs that the graph has, and those that are new in it."""
        rows: dict[str, dict[str, Any]] = {}
        for pair in sorted(evidence):
            row = rows.setdefault(pair[0], {"operator": pair[0], "known": [], "new": []})
            seen, changes = evidence[pair]
            one = {
                "matter": pair[1],
                "units": self._tally.done[pair],
                "changed": self._tally.changed[pair],
                "seen": _first(seen),
                "changes": _first(changes),
            }
            row["known" if pair in self._kept else "new"].append(one)
        return list(rows.values())


def _leaders(foods: Sequence[tuple[str, int, int]]) -> list[str]:
    """Return of ``foods``, each with its units and those that change it, the first by either, as usual_foods ranks."""
    first = sorted(foods, key=lambda food: (-food[1], food[0]))[:1]
    first += sorted((food for food in foods if food[2] > 0), key=lambda food: (-food[2], food[0]))[:1]
    return sorted({food for food, _, _ in first})


def _operator_rows(units: dict[str, Lifted]) -> Iterator[dict[str, Any]]:
    by_way: defaultdict[str, list[tuple[str, Lifted]]] = defaultdict(list)
    for key, unit in units.items():
        by_way[unit.operator].append((key, unit))
    for operator in sorted(by_way):
        motion, tools = by_way[operator][0][1].way
        rows = [
            {"key": key, "done_to": sorted(unit.done_to), "changes": sorted(unit.changes)}
            for key, unit in sorted(by_way[operator], key=lambda member: member[0])
        ]
        yield {"key": operator, "motion": motion, "tools": tools, "units": rows}


def _by_operator(pairs: Iterable[Pair]) -> list[dict[str, Any]]:
    matters: defaultdict[str, list[str]] = defaultdict(list)
    for operator, matter in sorted(pairs):
        matters[operator].append(matter)
    return [{"operator": operator, "matters": names} for operator, names in matters.items()]


def _first(sightings: Iterable[KeptSighting]) -> list[str]:
    """Return the first sightings by video and position, as the graph keeps them."""
    by_place = {(video, position): text for video, position, text in sightings}
    return [by_place[place] for place in sorted(by_place)[:MOST_SIGHTINGS]]


def _read(text: str) -> KeptSighting:
    """Return the sighting that was written as ``text``."""
    video, position, *_ = json.loads(text)
    return video, position, text
