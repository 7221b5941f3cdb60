"""C9 repeatable: whether several answers to one question are one answer."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence

from foon_kg.validation.report import Finding


def repeatable(results: Sequence[object]) -> tuple[Finding, ...]:
    """C9: compare plan results (JSON values) of the same question to the same graph, each with the first.

    One tree alone cannot show it, so ``foon check`` asks it of several answers to one recipe only.
    Everything that a result says is compared, the order of lists included; the order of JSON fields is not.
    """
    return tuple(
        Finding("C9", f"answer {place} differs from the first in {where}")
        for place, result in enumerate(results[1:], start=1)
        for where in _first_difference(results[0], result, "")
    )


def _first_difference(one: object, other: object, where: str) -> Iterator[str]:
    if isinstance(one, dict) and isinstance(other, dict):
        for name in sorted(one.keys() | other.keys()):
            if name not in one or name not in other:
                yield f"{where}.{name}".lstrip(".")
                return
            found = next(_first_difference(one[name], other[name], f"{where}.{name}"), None)
            if found:
                yield found
                return
    elif isinstance(one, list) and isinstance(other, list):
        for place, (left, right) in enumerate(zip(one, other, strict=False)):
            found = next(_first_difference(left, right, f"{where}[{place}]"), None)
            if found:
                yield found
                return
        if len(one) != len(other):
            yield f"the length of {where.lstrip('.')}"
    elif json.dumps(one) != json.dumps(other):
        yield where.lstrip(".")
