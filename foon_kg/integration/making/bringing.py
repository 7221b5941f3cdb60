"""In which way one food is brought somewhere: as a video brings such a food, else as its form and its packet ask.

Nothing is moved here: :mod:`~foon_kg.integration.making.carrying` does it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple

from foon_kg.food import Tables, singular
from foon_kg.food.lists import says, word_list
from foon_kg.integration.bench import Bench, Stuff, Vessel, is_flat
from foon_kg.integration.making.consistency import is_laid, is_liquid_or_soft, is_poured
from foon_kg.integration.preparing.preparation import Ready, Want
from foon_kg.integration.teaching.forms import form_of
from foon_kg.integration.teaching.frames import Slot
from foon_kg.integration.teaching.operators import Attested, Way
from foon_kg.model.values import made_often

_POUR = frozenset({"pour", "drip"})
"""Words of motions that only a thing obeys that runs, or lies loose."""

_MOVES = frozenset({"move", "scatter", "fetch"})
"""What a motion does that only brings food somewhere."""

_BRINGS_NOT_ALL = frozenset({"throw away", "remove", "measure", "scoop"})
"""Motions that move a food by their words, and yet do not bring all of it to where it is wanted."""

_BY_HAND: tuple[Way, ...] = (("pick-and-place", ()), ("pour", ()))
"""The ways that are open for any food, where no video brings its like."""


@made_often()
class Transport:
    """A food that is to be brought from where it is into ``target``; ``slot`` is what joins there in a video."""

    want: Want
    stuff: Stuff
    target: Vessel
    slot: Slot | None

    @classmethod
    def of(cls, ready: Ready, target: Vessel, slot: Slot | None = None) -> Transport:
        """Return the transport of a food that is ``ready`` to the vessel ``target``.

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


class _Ways(NamedTuple):
    """Ways to bring a food; ``for_any``: whatever it is, so that they are taken by the likest food of all."""

    ways: Sequence[Way]
    for_any: bool = False


class _Handling(NamedTuple):
    """What may be done with a thing as it is."""

    poured: bool
    picked: bool
    scraped: bool
    sprayed: bool

    def allows(self, motion: str) -> bool:
        """Return whether a thing may be brought by this motion."""
        if not self.poured and pours(motion):
            return False
        if not self.picked and motion in word_list("picks up"):
            return False
        if not self.scraped and motion in word_list("is scraped by"):
            return False
        return self.sprayed or motion not in word_list("is sprayed by")


class Bringing:
    """Chooses the ways in which foods are brought on a bench."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.known: Tables = bench.known

    def way(self, transport: Transport) -> Attested:
        """Return how the one food of ``transport`` is brought; raises :class:`~bench.RefusedError` where nothing does.

        As the video of its slot has it comes first, then what its packet asks for, then what is usual for such food.
        """
        groups = list(self._groups(transport))
        found = (
            self._as_recorded(transport, groups[0]) or self._by_groups(transport, groups) or self._by_hand(transport)
        )
        if found is not None:
            return found
        powder = form_of(self.known, transport.stuff.label, transport.stuff.states) == "powder"
        ways = groups[-1].ways or _BY_HAND
        able = [way for way in ways if way[0] not in word_list("picks up")] if powder else ways
        return self.bench.require(able or ways, transport.stuff.foods)

    def _groups(self, transport: Transport) -> Iterator[_Ways]:
        """Yield the ways to bring a food, group by group, the most fitting first."""
        slot, want, operators = transport.slot, transport.want, self.bench.operators
        form = form_of(self.known, want.label, transport.stuff.states)
        usual = operators.brings(form, transport.role)
        yield _Ways(self._as_shown(transport))
        yield _Ways(self._by_store(usual, transport), for_any=True)  # no jar is emptied of what is thick
        if slot is not None and (slot.motion, slot.tools) in usual and not self._opens(slot):
            yield _Ways([(slot.motion, slot.tools)])
        for name in (*want.names, f"kind:{want.facts.kind}"):
            yield self._pure(operators.brings_such(name, form, transport.role))
        yield self._pure(usual)

    def _opens(self, slot: Slot) -> bool:
        """Whether what joins at ``slot`` was in its shell, and was opened there: what has none is not."""
        return "shell" in self.known.motion(slot.motion).does

    def _pure(self, ways: Sequence[Way]) -> _Ways:
        return _Ways([way for way in ways if only_brings(self.known, way[0])])

    def _as_recorded(self, transport: Transport, shown: _Ways) -> Attested | None:
        """Return the evidence of the video for a food that is in the states of its slot, whatever others do."""
        slot = transport.slot
        if slot is None or set(transport.stuff.states) != set(slot.states):
            return None
        return self._attested(transport, shown, strict=False)

    def _by_groups(self, transport: Transport, groups: Sequence[_Ways]) -> Attested | None:
        """Return the evidence of the first group that has any: strictly at first, then less so."""
        wished = not set(self.bench.instead).isdisjoint(transport.stuff.foods)  # handled just as another food is
        # by every group as is proper, before the first one as it can just be done
        for strict in (False,) if wished else (True, False):
            for group in groups:
                found = self._attested(transport, group, strict=strict)
                if found is not None:
                    return found
        return None

    def _attested(self, transport: Transport, group: _Ways, *, strict: bool) -> Attested | None:
        handling, foods = self._handling(transport, strict=strict), transport.stuff.foods
        ways = [way for way in group.ways if handling.allows(way[0])]
        return self.bench.near_or_far(ways, foods) if group.for_any else self.bench.attest(ways, foods)

    def _by_hand(self, transport: Transport) -> Attested | None:
        """Return the evidence for what hands do with any food, as seldom as that may be: none picks up what runs."""
        runs = says(transport.stuff.states, "runs")
        return self._attested(transport, _Ways(_BY_HAND, for_any=runs), strict=False)

    def _as_shown(self, transport: Transport) -> Sequence[Way]:
        """Return how the video brings this very food in such a form."""
        slot, label = transport.slot, transport.want.label
        if slot is None or slot.food != singular(label):
            return []
        form = form_of(self.known, label, transport.stuff.states)
        if slot.motion in word_list("greases") and form == "soft":
            return self.bench.operators.ways_of(slot.motion)
        alike = only_brings(self.known, slot.motion) and form_of(self.known, slot.food, slot.states) == form
        return [(slot.motion, slot.tools)] if alike else []

    def _by_store(self, usual: Sequence[Way], transport: Transport) -> list[Way]:
        """Return the usual ways that what a food comes out of asks for: a mill strews, a tub is scooped out."""
        source = transport.source
        if source is None or not source.storage:
            return []
        row = self.known.utensil(source.label)
        motions: frozenset[str] = frozenset()
        if row is not None and row.group in word_list("strews"):
            motions = word_list("is strewn by")
        elif says(transport.stuff.states, "is scooped"):
            motions = word_list("is scooped by")
        return [way for way in usual if way[0] in motions]

    def _handling(self, transport: Transport, *, strict: bool) -> _Handling:
        """Return what suits a thing: nothing in one piece is poured, nor what runs picked up or scraped; cans spray.

        Where it is ``strict``, small pieces are not picked up either, nor slices poured onto a plate.
        """
        label, states, source = transport.stuff.label, transport.stuff.states, transport.source
        fluid = is_poured(self.known, label, states) if strict else is_liquid_or_soft(transport.stuff, self.known)
        powder = source is not None and form_of(self.known, label, states) == "powder"
        return _Handling(
            poured=not is_laid(self.known, label, states, flat=strict and is_flat(transport.target.label)),
            picked=not fluid and not powder and not says(states, "is too soft to be picked up"),
            scraped=transport.role != "storage" or not says(states, "runs"),
            sprayed=source is not None and source.label in word_list("sprays"),
        )


def pours(motion: str) -> bool:
    """Return whether what is brought by ``motion`` is poured."""
    return not _POUR.isdisjoint(motion.split())


@lru_cache(maxsize=1 << 12)
def only_brings(known: Tables, motion: str) -> bool:
    """Return whether a motion brings a food somewhere and does nothing else to it, by the tables ``known``."""
    does = known.motion(motion).does
    return bool(does) and does <= _MOVES and motion not in _BRINGS_NOT_ALL
