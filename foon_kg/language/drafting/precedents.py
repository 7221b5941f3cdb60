"""What a FOON knows of one motion done to one object: the states before and after, the places, the tools.

Where no unit does the motion to the object, the object most like it counts, then any object of its kind.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Collection, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeVar

from foon_kg.food import singular, tables
from foon_kg.food.lists import word_list
from foon_kg.language.drafting.told_states import done
from foon_kg.language.drafting.verbs import Verbs
from foon_kg.model import FunctionalUnit, KnownUnit, ObjectNode
from foon_kg.model.knowledge import Neighbour
from foon_kg.model.names import canonical
from foon_kg.plans.kitchen import Kitchen, is_place
from foon_kg.similarity import food_similarity
from foon_kg.similarity.states import state_class

States = tuple[str, ...]
Place = tuple[str | None, str | None]

_ALIKE = 0.3  # below this another food says no more than any
_FEW = 3
_ANY = 0.5
_NOWHERE: Place = (None, None)
_LIES_ON = word_list("things lie on it")

T = TypeVar("T", bound=Hashable)


@dataclass(frozen=True)
class Seen:
    """One object in one unit that changes it: how and where it is before and after, and what else is used."""

    motion: str
    label: str
    food: bool
    before: States
    after: States
    place_before: Place
    place_after: Place
    tools: tuple[str, ...]
    with_vessel: bool
    weight: float


@dataclass(frozen=True)
class Precedents:
    """The rows of a FOON that are like an action; ``likeness`` is how well their object stands for the narrated one."""

    rows: tuple[Seen, ...]
    likeness: float = 1.0
    doubt: str = ""

    def before(self) -> tuple[States, float]:
        """Return the commonest states before, and their share: of the rows in which it was not so before already."""
        first = [row for row in self.rows if done(row.motion) not in row.before] or self.rows
        return _commonest((row.before, row.weight) for row in first)

    def after(self, before: States) -> tuple[States, float]:
        """Return the states after a motion, and the share of rows that say so.

        They are those of rows with these states ``before`` where there are such.
        """
        alike = [row for row in self.rows if set(row.before) == set(before)]
        if alike:
            return _commonest((row.after, row.weight) for row in alike)
        (gone, come), share = _commonest((_change(row), row.weight) for row in self.rows)
        classes = {state_class(state)[0] for state in come}
        kept = {state for state in {*before} - {*gone} - self._lost() if state_class(state)[0] not in classes}
        return tuple(sorted({*come} | kept)), share

    def _lost(self) -> set[str]:
        """Return the states that some row loses and none keeps."""
        survive = {state for row in self.rows for state in {*row.before} & {*row.after}}
        return {state for row in self.rows for state in {*row.before} - {*row.after}} - survive

    def keeps(self, before: States) -> bool:
        """Return whether rows have these states ``before``: what they say counts, even that states stay as they are."""
        return any(set(row.before) == set(before) for row in self.rows)

    def place_before(self) -> tuple[Place, float]:
        """Return the commonest place before."""
        return _commonest((row.place_before, row.weight) for row in self.rows)

    def place_after(self) -> tuple[Place, float]:
        """Return the commonest place to which the object is brought; nowhere if it never is."""
        brought = [row for row in self.rows if row.place_after not in (row.place_before, _NOWHERE)]
        return _commonest((row.place_after, row.weight) for row in brought) if brought else (_NOWHERE, _ANY)

    def tools(self) -> tuple[str, ...]:
        """Return the tools, those that most of the rows have together."""
        return _commonest((row.tools, row.weight) for row in self.rows)[0] if self.rows else ()

    @property
    def brings(self) -> bool:
        """Whether most of the rows bring the object to another place."""
        return _share(self.rows, lambda row: row.place_after not in (row.place_before, _NOWHERE)) > _ANY

    @property
    def with_vessel(self) -> bool:
        """Whether most of the rows name the vessel of the object as an input."""
        return _share(self.rows, lambda row: row.with_vessel) > _ANY


class FoonPrecedents:
    """Answers for one FOON; ``units`` are its known units, each as often as it was seen."""

    def __init__(self, units: Iterable[KnownUnit], kitchen: Kitchen) -> None:
        self.kitchen = kitchen
        known = list(units)
        self.verbs = Verbs(tuple(sorted({unit.unit.motion for unit in known})))
        self._by_motion: defaultdict[str, list[Seen]] = defaultdict(list)
        self._merging: defaultdict[str, list[bool]] = defaultdict(list)
        self._nodes = Counter[ObjectNode]()
        for unit in known:
            for row in _rows(unit, kitchen):
                self._by_motion[row.motion].append(row)
            if (merges := _makes_one(unit.unit, kitchen)) is not None:
                self._merging[unit.unit.motion].append(merges)
            for node in {*unit.unit.input_nodes, *unit.unit.output_nodes}:
                self._nodes[node] += len(unit.seen_in)

    @cached_property
    def labels(self) -> Mapping[str, str]:
        """The label of the FOON by its canonical name; of several spellings the commonest."""
        counts: defaultdict[str, Counter[str]] = defaultdict(Counter)
        for node, count in self._nodes.items():
            counts[canonical(node.label)][node.label] += count
        return {name: _commonest(found.items())[0] for name, found in counts.items()}

    @property
    def names(self) -> tuple[str, ...]:
        """What the FOON calls its objects."""
        return tuple(sorted({node.label for node in self._nodes}))

    def motion(self, candidates: Sequence[str], label: str) -> str:
        """Return which of ``candidates`` (not empty) the FOON does most often with ``label``, else the first."""
        counts = {motion: sum(row.weight for row in self._of(motion, label)) for motion in candidates}
        best = max(counts.values())
        return next(motion for motion in candidates if counts[motion] == best)

    def of(self, motion: str, label: str) -> Precedents:
        """Return what the FOON knows of ``motion`` done to ``label``; no rows where it never saw the motion."""
        own = self._of(motion, label)
        if own:
            return Precedents(own)
        food = not self.kitchen.is_utensil(label)
        rows = tuple(row for row in self._by_motion.get(motion, ()) if row.food == food)
        if not rows:
            return Precedents((), _ANY * _ANY, f"“{motion}” gives nothing to {label}")
        if food and (near := self._alike(motion, label, rows)) is not None:
            return near
        what = "any food" if food else "any utensil"
        return Precedents(rows, _ANY, f"no unit of the FOON {_third(motion)} {label}; taken from {what}")

    @staticmethod
    def _alike(motion: str, label: str, rows: Sequence[Seen]) -> Precedents | None:
        """Return those of ``rows`` that are of foods like ``label``, each with the weight of its likeness."""
        near = food_similarity().nearest(label, sorted({row.label for row in rows}), limit=_FEW)
        alike = [one for one in near if one.confidence >= _ALIKE]
        if not alike:
            return None
        likeness = {canonical(one.name): one.confidence for one in alike}
        weighed = tuple(
            replace(row, weight=row.weight * likeness[name])
            for row in rows
            if (name := canonical(row.label)) in likeness
        )
        names = ", ".join(f"{one.name} {one.confidence:.2f}" for one in alike)
        doubt = f"no unit of the FOON {_third(motion)} {label}; taken from {names}"
        return Precedents(weighed, alike[0].confidence, doubt)

    def merges(self, motion: str) -> bool:
        """Whether most units in which ``motion`` is done to several foods make one thing of them."""
        found = self._merging.get(motion, [])
        return sum(found) * 2 > len(found)

    def nearest(self, label: str) -> Neighbour | None:
        """Return the known food most like ``label``, if any is like it."""
        foods = sorted(name for name in self.labels.values() if not self.kitchen.is_utensil(name))
        found = food_similarity().nearest(label, foods, limit=1) if foods else ()
        return found[0] if found and found[0].confidence >= _ALIKE else None

    def start(self, label: str) -> tuple[States, Place] | None:
        """Return the commonest start of the food ``label`` (as the shop sells it).

        ``None`` where the FOON does not have it.
        """
        nodes = self._bare(canonical(label))
        starts = [(node, count) for node, count in nodes if not self.kitchen.processed_states(node)] or nodes
        if not starts:
            return None
        states, _ = _commonest((node.states, count) for node, count in starts)
        place, _ = _commonest(((node.relation, node.container), n) for node, n in starts if node.states == states)
        return _plain(states), place

    def _bare(self, name: str) -> list[tuple[ObjectNode, int]]:
        """Return the nodes of a canonical name with nothing in or on them, and how often each was seen."""
        alike = ((node, n) for node, n in self._nodes.items() if canonical(node.label) == name)
        return [(node, count) for node, count in alike if not node.ingredients]

    def relation(self, container: str) -> str:
        """Return the word that the FOON puts before ``container``; "in" for one that it does not know."""
        counts: Counter[str] = Counter()
        for node, count in self._nodes.items():
            if node.container == container and node.relation in {"in", "on"}:
                counts[node.relation] += count
        lies = "on" if singular(container).split()[-1:][0] in _LIES_ON else "in"
        return _commonest(counts.items())[0] if counts else lies

    def empty(self, vessel: str) -> States:
        """Return the commonest states of ``vessel`` while it is empty."""
        found = [
            (node.states, count)
            for node, count in self._nodes.items()
            if node.label == vessel
            and not node.ingredients
            and node.container is None
            and not self.kitchen.is_running(node)
        ]
        return _plain(_commonest(found)[0]) if found else ()

    def appliance(self, name: str) -> str:
        """Return what the FOON calls an appliance of just this group, its stove for a hob; else ``name`` itself."""
        row = tables().utensil(name)
        if row is None or row.role != "appliance" or canonical(name) in self.labels:
            return name
        alike = [known for known in self.labels.values() if _in_group(known, row.group)]
        return min(alike, key=lambda label: (-self._seen(label), label)) if alike else name

    def _seen(self, label: str) -> int:
        return sum(count for node, count in self._nodes.items() if node.label == label)

    def is_tool(self, utensil: str) -> bool:
        """Whether foods are worked on with ``utensil`` rather than kept in it."""
        name = canonical(utensil)
        tool = sum(row.weight for rows in self._by_motion.values() for row in rows if utensil in row.tools)
        kept = sum(count for node, count in self._nodes.items() if node.container and canonical(node.container) == name)
        return tool > kept

    def bringing(self, label: str) -> str:
        """Return the motion that most often brings ``label``, else any food, from one place to another."""
        rows = [
            row for rows in self._by_motion.values() for row in rows if row.food and row.place_after != row.place_before
        ]
        own = [row for row in rows if canonical(row.label) == canonical(label)]
        found = [(row.motion, row.weight) for row in own or rows]
        return _commonest(found)[0] if found else "place"

    def vessel_of(self, motion: str) -> str | None:
        """Return the vessel in which the motion is most often done, if in any."""
        found = [
            (row.place_before[1], row.weight)
            for row in self._by_motion.get(motion, ())
            if row.place_before[1] is not None
        ]
        return _commonest(found)[0] if found else None

    def _of(self, motion: str, label: str) -> tuple[Seen, ...]:
        """Return the rows of one object; those in which it only stands by count where there are no others."""
        name = canonical(label)
        rows = tuple(row for row in self._by_motion.get(motion, ()) if canonical(row.label) == name)
        return tuple(row for row in rows if (row.before, row.place_before) != (row.after, row.place_after)) or rows


def _rows(known: KnownUnit, kitchen: Kitchen) -> Iterator[Seen]:
    """Yield a row for every food of a unit, and for every utensil that is not the same after it."""
    unit = known.unit
    tools = _tools(unit, kitchen)
    for node in unit.input_nodes:
        food = kitchen.is_food(node)
        after = next((other for other in unit.output_nodes if other.label == node.label), None)
        if after is None or (not food and _outside(after) == _outside(node)):
            continue
        vessel = any(other.label == node.container for other in unit.input_nodes)
        yield Seen(
            unit.motion,
            node.label,
            food,
            _plain(node.states),
            _plain(after.states),
            (node.relation, node.container),
            (after.relation, after.container),
            tuple(tool for tool in tools if tool != node.label),
            vessel,
            len(known.seen_in),
        )


def _makes_one(unit: FunctionalUnit, kitchen: Kitchen) -> bool | None:
    """Return whether a unit makes one thing of its foods, most of which are by themselves no more; ``None`` of one."""
    foods = [node.label for node in unit.input_nodes if kitchen.is_food(node)]
    left = {node.label for node in unit.output_nodes}
    return sum(food in left for food in foods) * 2 < len(foods) if len(set(foods)) > 1 else None


def _tools(unit: FunctionalUnit, kitchen: Kitchen) -> tuple[str, ...]:
    """Return the utensils that hold nothing and in which nothing is, before or after."""
    containers = {node.container for node in (*unit.input_nodes, *unit.output_nodes)}
    holding = {node.label for node in (*unit.input_nodes, *unit.output_nodes) if node.ingredients}
    utensils = {node.label for node in unit.input_nodes if kitchen.is_utensil(node.label) and node.container is None}
    return tuple(sorted(utensils - containers - holding))


def _in_group(label: str, group: str) -> bool:
    row = tables().utensil(label)
    return row is not None and row.group == group


def _outside(node: ObjectNode) -> tuple[States, str | None, str | None]:
    return (node.states, node.relation, node.container)


def _plain(states: Collection[str]) -> States:
    """Leave out the places that a loader kept as states, and remarks in brackets, which no table can say."""
    return tuple(state.partition(" (")[0] for state in states if not is_place(state))


def _change(row: Seen) -> tuple[States, States]:
    before, after = set(row.before), set(row.after)
    return tuple(sorted(before - after)), tuple(sorted(after - before))


def _commonest(found: Iterable[tuple[T, float]]) -> tuple[T, float]:
    """Return the value of greatest weight, ties by how it is written, and its share after one more hit and one miss."""
    counts: defaultdict[T, float] = defaultdict(float)
    for value, weight in found:
        counts[value] += weight
    best = min(counts, key=lambda value: (-counts[value], repr(value)))
    return best, (counts[best] + 1) / (sum(counts.values()) + 2)


def _share(rows: Sequence[Seen], test: Callable[[Seen], bool]) -> float:
    total = sum(row.weight for row in rows)
    return sum(row.weight for row in rows if test(row)) / total if total else 0.0


def _third(motion: str) -> str:
    """Return the motion as what a unit does: peels, washes."""
    first, *rest = motion.split(" ")
    if first.endswith("y") and first[-2:-1] not in "aeiou":
        return " ".join([f"{first[:-1]}ies", *rest])
    ending = "es" if first.endswith(("ch", "sh", "ss", "x", "z")) else "s"
    return " ".join([first + ending, *rest])
