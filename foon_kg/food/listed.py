"""What foods are for that a recipe without headings names one after another: rows of ``food/listed.toml``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from foon_kg.food.shipped import shipped
from foon_kg.food.techniques import Foods, Technique, technique_of


@dataclass(frozen=True)
class Bounds:
    """Of which foods a run is, and where it begins and ends.

    All of them are ``of`` such foods, the first is one of ``starts``, the last one of ``ends``; none is of ``lacks``,
    and none of ``apart`` stands next to them.
    """

    of: tuple[Foods, ...]
    starts: tuple[Foods, ...]
    ends: tuple[Foods, ...]
    lacks: tuple[Foods, ...]
    apart: tuple[Foods, ...]


@dataclass(frozen=True)
class Run:
    """Foods that a recipe names one after another, and the ``part`` of the dish that they make together.

    ``technique`` has what they need and for which dishes they are; ``bounds`` say which foods they are. Of each
    list of ``again`` one is listed elsewhere as well; ``beside`` are foods of which each list leaves one for the rest.
    The last of them may be ``leaves``, and are for the dish itself, or for ``rest``. It closes the list, or it
    ``opens`` it; then all else is for ``rest``, if there is one, but for the last of it that are ``leaves``.
    ``headed``: it opens lists with headings.
    """

    technique: Technique
    part: str
    bounds: Bounds
    beside: tuple[tuple[Foods, ...], ...]
    again: tuple[tuple[Foods, ...], ...]
    leaves: tuple[Foods, ...]
    rest: str
    opens: bool
    headed: bool


@cache
def runs() -> tuple[Run, ...]:
    """Return every run in the order of its table: the first that suits is taken."""
    return tuple(_run(name, row) for name, row in shipped("listed")["runs"].items())


def _run(name: str, row: Mapping[str, Any]) -> Run:
    return Run(
        technique=technique_of(name, {"lines": {}, **row}),
        part=row["part"],
        bounds=_bounds(row),
        beside=tuple(map(_foods, row.get("beside", ()))),
        again=tuple(map(_foods, row.get("again", ()))),
        leaves=_foods(row.get("leaves", ())),
        rest=row.get("rest", ""),
        opens=row.get("opens", False),
        headed=row.get("headed", False),
    )


def _bounds(row: Mapping[str, Any]) -> Bounds:
    return Bounds(
        of=_foods(row["of"]),
        starts=_foods(row.get("starts", ("*",))),
        ends=_foods(row.get("ends", ("*",))),
        lacks=_foods(row.get("lacks", ())),
        apart=_foods(row.get("apart", ())),
    )


def _foods(texts: Iterable[str]) -> tuple[Foods, ...]:
    return tuple(map(Foods.read, texts))
