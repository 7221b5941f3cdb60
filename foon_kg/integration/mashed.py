"""What is mashed is boiled, mashed and mixed with the rest, and that is all: whatever a like dish goes on with."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from foon_kg.integration.frames import Line, Stage
from foon_kg.integration.places import NATURAL, Join

_MIXED = Stage((), "mix", frozenset({"mix"}), (), "mixing bowl", "in", "", "", "", (), 0)


def mashed_only(joins: Sequence[Join]) -> tuple[Line, tuple[Join, ...]]:
    """Return a line of one stage, at which all foods of a mashed dish are mixed, and their joins."""
    mixed = replace(_MIXED)
    spots = [replace(join.spot, stage=mixed, after=(), side=False) for join in joins]
    return Line((mixed,)), tuple(
        Join(join.want, spot, min(join.fit, NATURAL)) for join, spot in zip(joins, spots, strict=True)
    )
