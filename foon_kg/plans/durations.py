"""How long motions take, from the times at which videos show them.

What is seen is what the cook in the video shows: chopping is shown as long as it takes, baking and cooling are cut to
some seconds. So what cooks or goes on by itself has no duration from a video, as a motion has none that nobody has
timed; where a recipe says how long ("for 60 min"), that is its duration.
"""

from __future__ import annotations

import statistics
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import chain
from typing import Self

from foon_kg.food import motions
from foon_kg.food.lists import word_list
from foon_kg.model import KnownUnit, Measures, Sighting
from foon_kg.model.recent import MOST_WORDS

_AT_LEAST = 1.0  # annotators write whole seconds: an action that begins and ends in one second takes about one


@dataclass(frozen=True)
class Duration:
    """Seconds that a motion takes: the median of its ``sightings``, and the quartiles around it.

    With no ``sightings`` it is what a recipe says.
    """

    median: float
    low: float
    high: float
    sightings: int


@dataclass(frozen=True)
class Durations:
    """What a FOON says of how long each motion takes; ``overall`` is of all its timed sightings together."""

    by_motion: Mapping[str, Duration]
    overall: Duration | None

    @classmethod
    def of(cls, sightings: Iterable[tuple[str, Sighting]]) -> Self:
        """Measure motions by their sightings. A sighting (a place in a video) counts once, however often it is named.

        Those without a start and an end do not count, nor do those that end before they start, nor those of what is
        cut short in videos (:func:`is_cut_short`).
        """
        seen: dict[str, dict[tuple[str, int], float]] = {}
        for motion, sighting in sightings:
            if sighting.start is None or sighting.end is None or is_cut_short(motion):
                continue
            if sighting.end >= sighting.start:
                seconds = max(sighting.end - sighting.start, _AT_LEAST)
                seen.setdefault(motion, {})[sighting.video, sighting.position] = seconds
        every = [seconds for timed in seen.values() for seconds in timed.values()]
        by_motion = {motion: _duration(timed.values()) for motion, timed in sorted(seen.items())}
        return cls(by_motion, _duration(every) if every else None)

    def of_step(self, motion: str, measures: Measures) -> Duration | None:
        """Return how many seconds a step of ``motion`` takes: as its ``measures`` say, else as videos show.

        ``None`` where neither does.
        """
        if measures.seconds is not None:
            return Duration(measures.seconds, measures.seconds, measures.seconds, 0)
        return self.by_motion.get(motion)

    @classmethod
    def of_units(cls, units: Iterable[KnownUnit], beside: Iterable[tuple[str, Sighting]] = ()) -> Self:
        """Measure the motions of a FOON's ``units``, and of sightings ``beside`` them."""
        return cls.of(chain(((known.unit.motion, seen) for known in units for seen in known.seen_in), beside))


@lru_cache(maxsize=MOST_WORDS)
def is_cut_short(motion: str) -> bool:
    """Return whether videos show only the beginning and the end of a motion: what cooks, rises or cools."""
    return motions.heats(motion) or motion in word_list("without hands")


def _duration(seconds: Iterable[float]) -> Duration:
    every = sorted(seconds)
    if len(every) == 1:
        return Duration(every[0], every[0], every[0], 1)
    low, median, high = statistics.quantiles(every, n=4, method="inclusive")
    return Duration(median, low, high, len(every))
