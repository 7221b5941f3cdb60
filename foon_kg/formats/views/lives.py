"""The lives of ingredients, told once: what several foods have become part of goes on in a line of its own.

Progress lines follow each food to the dish (:mod:`foon_kg.plans.progress`), so that thirteen foods of a batter end in
thirteen times the same stages. Who reads a plan wants to know where a food joins the others, and what then becomes of
all of them.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from foon_kg.formats.exports.phrases import motion_said
from foon_kg.plans.progress import ProgressLine

Tail = tuple[str, int, ProgressLine]


def lives(lines: Sequence[ProgressLine]) -> tuple[ProgressLine, ...]:
    """Return ``lines`` cut where a food becomes part of what others become part of, too; then a line for each of those.

    A line that is cut ends in what the food has become. What has the same name as another mixture is numbered. Motions
    are as they are said to a cook.
    """
    found, waiting = list[ProgressLine](), list(lines)
    named: dict[Tail, str] = {}
    while waiting:
        common = named.keys() | _shared(waiting)
        new: dict[Tail, str] = {}
        for line in waiting:
            cut = next((tail for tail in _tails(line) if tail in common), None)
            if cut is not None and cut not in named:
                new[cut] = named[cut] = _numbered(cut[0], named)
            found.append(_told(line) if cut is None else _told(_cut(line, cut, named[cut])))
        waiting = [ProgressLine(name, tail[2].steps, tail[2].end_product) for tail, name in new.items()]
    return tuple(found)


def _shared(lines: Sequence[ProgressLine]) -> set[Tail]:
    """Return the ends that several ``lines`` have in common."""
    counts = Counter(tail for line in lines for tail in dict.fromkeys(_tails(line)))
    return {tail for tail, count in counts.items() if count > 1}


def _told(line: ProgressLine) -> ProgressLine:
    return replace(line, steps=tuple(replace(step, motion=motion_said(step.motion)) for step in line.steps))


def _cut(line: ProgressLine, tail: Tail, name: str) -> ProgressLine:
    """Return a line without its ``tail``: it ends in what the food has become, called ``name``."""
    return ProgressLine(line.ingredient, line.steps[: len(line.steps) - tail[1]], name)


def _tails(line: ProgressLine) -> list[Tail]:
    """Return what each change of name leads to: the new name, how many steps are left, and these."""
    name, tails = line.ingredient, []
    for place, step in enumerate(line.steps):
        if step.object and step.object != name and place:
            rest = ProgressLine(step.object, line.steps[place:], line.end_product)
            tails.append((step.object, len(line.steps) - place, rest))
        name = step.object or name
    return tails


def _numbered(name: str, named: dict[Tail, str]) -> str:
    others = sum(tail[0] == name for tail in named)
    return f"{name} {others + 1}" if others else name
