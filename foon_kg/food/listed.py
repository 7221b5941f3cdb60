"""What foods are for that a recipe without headings names one after another: rows of ``food/listed.toml``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from foon_kg.food.shipped import shipped
from foon_kg.food.techniques import Foods, Technique, technique_of


@dataclass(frozen=True)
class Run:
    """Foods that a recipe names one after another, and the ``part`` of the dish that they make together.

    ``technique`` has what they need and for which dishes they are. All of them are ``of`` such foods, the first is one
    of ``starts``, the last one of ``ends``; none is of ``lacks``, and none of ``apart`` stands next to them. Of each
    list of ``again`` one is listed elsewhere as well; ``beside`` are foods of which each list leaves one for the rest.
    The last of them may be ``leaves``, and are for the dish itself, or for ``rest``. It closes the list, or it
    ``opens`` it; then all else is for ``rest``, if there is one, but for the last of it that are ``leaves``.
    ``headed``: it opens lists with headings.
    """

    technique: Technique
    part: str
    of: tuple[Foods, ...]
    starts: tuple[Foods, ...]
    lacks: tuple[Foods, ...]
    ends: tuple[Foods, ...]
    apart: tuple[Foods, ...]
    beside: tuple[tuple[Foods, ...], ...]
    again: tuple[tuple[Foods, ...], ...]
    leaves: tuple[Foods, ...]
    opens: bool
    headed: bool
    rest: str


@cache
def runs() -> tuple[Run, ...]:
    """Return every run in the order of its table: the first that suits is taken."""
    return tuple(_run(name, row) for name, row in shipped("listed")["runs"].items())


def _run(name: str, row: Mapping[str, Any]) -> Run:
    return Run(
        technique_of(name, {"lines": {}, **row}),
        row["part"],
        _foods(row["of"]),
        _foods(row.get("starts", ("*",))),
        _foods(row.get("lacks", ())),
        _foods(row.get("ends", ("*",))),
        _foods(row.get("apart", ())),
        tuple(map(_foods, row.get("beside", ()))),
        tuple(map(_foods, row.get("again", ()))),
        _foods(row.get("leaves", ())),
        row.get("opens", False),
        row.get("headed", False),
        row.get("rest", ""),
    )


def _foods(texts: Iterable[str]) -> tuple[Foods, ...]:
    return tuple(map(Foods.read, texts))
