"""Two evaluations compared: what got better, what got worse, and whether that is more than chance."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from foon_kg.evaluation.resampling import Interval, paired_difference
from foon_kg.model.errors import ReadError, UsageError
from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.json_text import json_value
from foon_kg.model.regular_files import read_text

CaseKey = tuple[str, str]
"""What tells one question of an evaluation from the others: its name and its dish type."""

_SAME = 1e-6
"""Figures are written to six decimals: what differs by less may have been rounded."""

_SHARES = {"recipes": "correct", "leave-one-out": "units"}
"""Which field of a question's entry is compared, by the kind of the evaluation."""


@dataclass(frozen=True)
class Change:
    """A question that both evaluations asked, with its share (0 to 1) in each."""

    name: str
    dish_type: str
    before: float
    after: float

    @property
    def difference(self) -> float:
        """How much better it got; below 0 for worse."""
        return self.after - self.before

    def to_json(self) -> JsonObject:
        """Return the change as JSON."""
        return {"id": self.name, "dish_type": self.dish_type, "before": self.before, "after": self.after}


@dataclass(frozen=True)
class Comparison:
    """What changed; ``difference`` is the mean over the questions of both, drawn in pairs.

    ``gone`` and ``new`` are questions that only the old or only the new evaluation asked: they say nothing.
    """

    changes: tuple[Change, ...]
    difference: Interval
    gone: tuple[str, ...]
    new: tuple[str, ...]

    @property
    def better(self) -> tuple[Change, ...]:
        """What got better, most first."""
        found = (change for change in self.changes if change.difference > _SAME)
        return tuple(sorted(found, key=lambda c: (-c.difference, c.dish_type, c.name)))

    @property
    def worse(self) -> tuple[Change, ...]:
        """What got worse, most first."""
        found = (change for change in self.changes if change.difference < -_SAME)
        return tuple(sorted(found, key=lambda c: (c.difference, c.dish_type, c.name)))

    @property
    def verdict(self) -> str:
        """Say in words whether the difference is more than chance."""
        if not self.better and not self.worse:
            return "nothing changed"
        if not self.difference.apart_from_zero:
            return "no more than chance"
        return "better, and more than chance" if self.difference.mean > 0 else "worse, and more than chance"

    def to_json(self) -> JsonObject:
        """Return the comparison as JSON."""
        return {
            "asked_by_both": len(self.changes),
            "difference": self.difference.to_json(),
            "verdict": self.verdict,
            "better": [change.to_json() for change in self.better],
            "worse": [change.to_json() for change in self.worse],
            "only_before": list(self.gone),
            "only_now": list(self.new),
        }


@dataclass(frozen=True)
class Earlier:
    """An evaluation of before, in JSON, and the file that it was read from."""

    value: JsonObject
    path: Path

    def compared_with(self, now: JsonObject, seed: int) -> Comparison:
        """Return what changed from this evaluation to that of ``now`` (JSON); ``seed`` is that of the resampling.

        Raises ReadError where this one is not whole.
        """
        return compare(shares_of(self.value, str(self.path)), shares_of(now, "this evaluation"), seed)


def compare(before: Mapping[CaseKey, float], after: Mapping[CaseKey, float], seed: int) -> Comparison:
    """Return what changed from ``before`` to ``after``, each with the share (0 to 1) of every question.

    ``seed`` draws the samples of the interval.
    """
    both = sorted(before.keys() & after.keys())
    changes = tuple(Change(*key, before[key], after[key]) for key in both)
    difference = paired_difference([c.after for c in changes], [c.before for c in changes], seed)
    return Comparison(changes, difference, _names(before.keys() - after.keys()), _names(after.keys() - before.keys()))


def shares_of(value: JsonObject, where: str) -> dict[CaseKey, float]:
    """Return the share of each question of an evaluation in JSON (``value``); raises ReadError for anything else.

    ``where`` names the document in messages.
    """
    fields = Fields(value, where)
    share = _SHARES[fields.one_of("evaluation", tuple(_SHARES))]
    shares: dict[CaseKey, float] = {}
    for entry in fields.nested_list("recipes" if share == "correct" else "videos"):
        key = entry.text("id"), entry.text("dish_type")
        if key in shares:
            raise ReadError(f"{entry.where}: “{key[0]}” is there twice", hint="Give every recipe an id of its own.")
        shares[key] = entry.number(share)
    return shares


def earlier_evaluation(path: Path, kind: str) -> Earlier:
    """Return what an evaluation of ``kind`` printed to the file ``path`` with ``--json``.

    Raises ReadError or UsageError with the file.
    """
    try:
        value = json_value(read_text(path, "utf-8"))
    except json.JSONDecodeError as error:
        raise ReadError(f"{path}:{error.lineno}: not JSON: {error.msg}", hint="Name what --json printed.") from error
    except UnicodeDecodeError as error:
        raise ReadError(f"{path}: not UTF-8 text (byte {error.start})", hint="Name what --json printed.") from error
    except OSError as error:
        raise ReadError(f"{path}: {error.strerror}", hint="--compare names what --json printed before.") from error
    found = Fields(value, str(path)).one_of("evaluation", tuple(_SHARES))
    if found != kind:
        raise UsageError(
            f"{path} is an evaluation of {found}, not of {kind}", hint=f"Compare it in foon evaluate {found}."
        )
    return Earlier(dict(value), path)


def _names(keys: Sequence[CaseKey] | set[CaseKey]) -> tuple[str, ...]:
    return tuple(name for name, _ in sorted(keys))
