"""The weights of motions: a JSON object with one number from 0 to 1 for each motion, how hard it is for a robot."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.model.errors import ReadError
from foon_kg.model.regular_files import read_text

_SHAPE = 'It should be one JSON object with a number for each motion: {"chop": 0.9, "pour": 0.1}.'
_RANGE = "A weight is a number from 0 (a robot always succeeds) to 1 (it never does)."


def read_weights(path: Path) -> MotionCosts:
    """Read the weights in ``path``, all of them or none; white space in names is folded.

    Raises ReadError, with the line where that is known, for a file that cannot be read, is no JSON object, names no
    motion, names one twice, or has a weight that is no number from 0 to 1.
    """
    try:
        text = read_text(path)
    except (OSError, UnicodeDecodeError) as error:
        why = error.strerror if isinstance(error, OSError) else "it is no text in UTF-8"
        raise ReadError(f"{path}: cannot be read: {why}", hint=_SHAPE) from error
    try:
        entries = json.loads(text, object_pairs_hook=_Entries)
    except json.JSONDecodeError as error:
        raise ReadError(f"{path}:{error.lineno}: {error.msg}", hint=_SHAPE) from error
    except (ValueError, RecursionError) as error:  # a number of thousands of digits, or lists in lists in lists
        raise ReadError(f"{path}: no such JSON is read: {error}", hint=_SHAPE) from error
    if not isinstance(entries, _Entries) or not entries:
        raise ReadError(f"{path}: there are no weights in it", hint=_SHAPE)
    return MotionCosts(_checked(path, entries))


def write_weights(costs: MotionCosts) -> str:
    """Return ``costs`` as JSON, which :func:`read_weights` reads back to the same."""
    return json.dumps(dict(sorted(costs.costs.items())), ensure_ascii=False, indent=2) + "\n"


class _Entries(list[tuple[str, object]]):
    """The fields of a JSON object in their order, repeated names included."""


def _checked(path: Path, entries: Iterable[tuple[str, object]]) -> dict[str, float]:
    costs: dict[str, float] = {}
    for name, value in entries:
        motion = " ".join(name.split())
        if not motion:
            raise ReadError(f"{path}: a motion has no name", hint=_SHAPE)
        if motion in costs:
            raise ReadError(f"{path}: “{motion}” is there twice", hint="Keep one weight for each motion.")
        costs[motion] = _weight(path, motion, value)
    return costs


def _weight(path: Path, motion: str, value: object) -> float:
    number = isinstance(value, int | float) and not isinstance(value, bool)
    if not number or not 0 <= value <= 1:  # type: ignore[operator]  # NaN compares with nothing
        shown = json.dumps(value, ensure_ascii=False)
        raise ReadError(f"{path}: the weight of “{motion}” is {shown[:60]}", hint=_RANGE)
    return float(value)  # type: ignore[arg-type]
