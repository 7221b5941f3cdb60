"""C9 repeatable: whether several answers to one question are one answer."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from itertools import islice

from foon_kg.validation.report import Finding


def repeatable(results: Sequence[object]) -> tuple[Finding, ...]:
    """Return the findings of C9: plan results (JSON values) of one question to one graph that differ from the first.

    One tree alone cannot show it, so ``foon check`` asks it of several answers to one recipe only.
    Everything that a result says is compared, the order of lists included; the order of JSON fields is not.
    """
    return tuple(
        Finding("C9", f"answer {place} differs from the first in {where}")
        for place, result in enumerate(results[1:], start=1)
        for where in _first_difference(results[0], result, "")
    )


def _first_difference(one: object, other: object, where: str) -> Iterator[str]:
    """Yield the place of the first thing in which two JSON values differ; ``where`` is that of the values."""
    if isinstance(one, dict) and isinstance(other, dict):
        yield from islice(_differing_fields(one, other, where), 1)
    elif isinstance(one, list) and isinstance(other, list):
        yield from islice(_differing_items(one, other, where), 1)
    elif json.dumps(one) != json.dumps(other):
        yield where.lstrip(".")


def _differing_fields(one: dict[str, object], other: dict[str, object], where: str) -> Iterator[str]:
    """Yield the places of the fields in which two objects differ, by their names."""
    for name in sorted(one.keys() | other.keys()):
        inside = f"{where}.{name}"
        if name in one and name in other:
            yield from _first_difference(one[name], other[name], inside)
        else:
            yield inside.lstrip(".")


def _differing_items(one: list[object], other: list[object], where: str) -> Iterator[str]:
    """Yield the places of the items in which two lists differ, and last that one of them is longer."""
    for place, (left, right) in enumerate(zip(one, other, strict=False)):
        yield from _first_difference(left, right, f"{where}[{place}]")
    if len(one) != len(other):
        yield f"the length of {where.lstrip('.')}"
