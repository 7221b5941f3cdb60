"""In which way one food is brought somewhere: as a video brings such a food, else as its form and its packet ask.

Nothing is moved here: :mod:`~foon_kg.integration.making.carrying` does it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

from foon_kg.food import Tables, singular
from foon_kg.food.lists import word_list
from foon_kg.integration.bench import Bench, Stuff, Vessel, is_flat
from foon_kg.integration.making.consistency import is_laid, is_liquid_or_soft, is_poured
from foon_kg.integration.preparing.preparation import Ready, Want
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.frames import Slot
from foon_kg.integration.teaching.operators import Attested, Way

_POUR = frozenset({"pour", "drip"})
_MOVES = frozenset({"move", "scatter", "fetch"})
_BY_HAND: tuple[Way, ...] = (("pick-and-place", ()), ("pour", ()))


@dataclass(frozen=True)
class Errand:
    """A food that is to be brought from where it is into ``target``; ``slot`` is what joins there in a video."""

    want: Want
    stuff: Stuff
    target: Vessel
    slot: Slot | None

    @classmethod
    def of(cls, ready: Ready, target: Vessel, slot: Slot | None = None) -> Errand:
        """Return the errand of a food that is ``ready``, to the vessel ``target``.

        ``slot`` is its place in the recorded dish, if it has one.
        """
        return cls(ready.want, ready.stuff, target, slot)

    @property
    def source(self) -> Vessel | None:
        """What the food is in."""
        return self.stuff.at

    @property
    def role(self) -> str:
        """What kind of thing the food is in: ``storage``, ``vessel``, ``""`` where it lies free."""
        if self.source is None:
            return ""
        return "storage" if self.source.storage else "vessel"


@dataclass(frozen=True)
class _Ways:
    """Ways to bring a food; ``for_any``: whatever it is, so that they are taken by the likest food of all."""

    ways: Sequence[Way]
    for_any: bool = False


@dataclass(frozen=True)
class _Handling:
    """What may be done with a thing as it is."""

    poured: bool
    picked: bool
    sprayed: bool

    def allows(self, motion: str) -> bool:
        """Whether a thing may be brought by this motion."""
        if not self.poured and pours(motion):
            return False
        if not self.picked and motion in word_list("picks up"):
            return False
        return self.sprayed or motion not in word_list("is sprayed by")


class Bringing:
    """Chooses the ways in which foods are brought on a bench."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.known: Tables = bench.known

    def way(self, errand: Errand) -> Attested:
        """Return how the one food of ``errand`` is brought; raises :class:`~bench.RefusedError` where nothing does.

        As the video of its slot has it comes first, then what its packet asks for, then what is usual for such food.
        """
        groups = list(self._groups(errand))
        found = self._as_recorded(errand, groups[0]) or self._by_groups(errand, groups) or self._by_hand(errand)
        return found or self.bench.require(groups[-1].ways or _BY_HAND, errand.stuff.foods)

    def _groups(self, errand: Errand) -> Iterator[_Ways]:
        """Yield the ways to bring a food, group by group, the most fitting first."""
        slot, want, operators = errand.slot, errand.want, self.bench.operators
        form = form_of(self.known, want.label, errand.stuff.states)
        usual = operators.brings(form, errand.role)
        yield _Ways(self._as_shown(errand))
        yield _Ways(self._by_store(usual, errand), for_any=True)  # no jar is emptied of what is thick
        if slot is not None and (slot.motion, slot.tools) in usual:
            yield _Ways([(slot.motion, slot.tools)])
        for name in (*want.names, f"kind:{want.facts.kind}"):
            yield self._pure(operators.brings_such(name, form, errand.role))
        yield self._pure(usual)

    def _pure(self, ways: Sequence[Way]) -> _Ways:
        return _Ways([way for way in ways if only_brings(self.known, way[0])])

    def _as_recorded(self, errand: Errand, shown: _Ways) -> Attested | None:
        """Return the evidence of the video for a food that is in the states of its slot, whatever others do."""
        slot = errand.slot
        if slot is None or set(errand.stuff.states) != set(slot.states):
            return None
        return self._attested(errand, shown, strict=False)

    def _by_groups(self, errand: Errand, groups: Sequence[_Ways]) -> Attested | None:
        """Return the evidence of the first group that has any: strictly at first, then less so."""
        wished = not set(self.bench.instead).isdisjoint(errand.stuff.foods)  # handled just as another food is
        for strict in (False,) if wished else (True, False):
            for group in groups:
                found = self._attested(errand, group, strict=strict)
                if found is not None:
                    return found
        return None

    def _attested(self, errand: Errand, group: _Ways, *, strict: bool) -> Attested | None:
        handling, foods = self._handling(errand, strict=strict), errand.stuff.foods
        ways = [way for way in group.ways if handling.allows(way[0])]
        return self.bench.near_or_far(ways, foods) if group.for_any else self.bench.attest(ways, foods)

    def _by_hand(self, errand: Errand) -> Attested | None:
        """Return the evidence for what hands do with any food, as seldom as that may be: none picks up what runs."""
        runs = not word_list("runs").isdisjoint(errand.stuff.states)
        return self._attested(errand, _Ways(_BY_HAND, for_any=runs), strict=False)

    def _as_shown(self, errand: Errand) -> Sequence[Way]:
        """Return how the video brings this very food in such a form."""
        slot, label = errand.slot, errand.want.label
        if slot is None or slot.food != singular(label):
            return []
        form = form_of(self.known, label, errand.stuff.states)
        if slot.motion in word_list("greases") and form == "soft":
            return self.bench.operators.ways_of(slot.motion)
        alike = only_brings(self.known, slot.motion) and form_of(self.known, slot.food, slot.states) == form
        return [(slot.motion, slot.tools)] if alike else []

    def _by_store(self, usual: Sequence[Way], errand: Errand) -> list[Way]:
        """Return the usual ways that what a food comes out of asks for: a mill strews, a tub is scooped out."""
        source = errand.source
        if source is None or not source.storage:
            return []
        row = self.known.utensil(source.label)
        motions: frozenset[str] = frozenset()
        if row is not None and row.group in word_list("strews"):
            motions = word_list("is strewn by")
        elif not word_list("is scooped").isdisjoint(errand.stuff.states):
            motions = word_list("is scooped by")
        return [way for way in usual if way[0] in motions]

    def _handling(self, errand: Errand, *, strict: bool) -> _Handling:
        """Return what suits a thing: nothing in one piece is poured, nor what runs picked up; cans spray.

        Where it is ``strict``, small pieces are not picked up either, nor slices poured onto a plate.
        """
        label, states, source = errand.stuff.label, errand.stuff.states, errand.source
        fluid = is_poured(self.known, label, states) if strict else is_liquid_or_soft(errand.stuff, self.known)
        return _Handling(
            poured=not is_laid(self.known, label, states, flat=strict and is_flat(errand.target.label)),
            picked=not fluid,
            sprayed=source is not None and source.label in word_list("sprays"),
        )


def pours(motion: str) -> bool:
    """Whether what is brought by a motion is poured."""
    return not _POUR.isdisjoint(motion.split())


@lru_cache(maxsize=1 << 12)
def only_brings(known: Tables, motion: str) -> bool:
    """Return whether a motion brings a food somewhere and does nothing else to it, by the tables ``known``."""
    does = known.motion(motion).does
    return bool(does) and does <= _MOVES and motion not in {"throw away", "remove", "measure", "scoop"}
