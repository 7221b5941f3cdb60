"""What the judge says of many trees: how many robot and cook accept, and which rules are broken how often."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from foon_kg.model.json_fields import JsonObject
from foon_kg.validation import RULES, Report

ALL = "all"
"""The name under which all dish types are taken together."""


@dataclass(frozen=True)
class RuleCount:
    """Of the ``asked`` trees of which a rule could be asked: those with a fatal finding, and with minor ones alone."""

    asked: int
    fatal: int
    minor: int

    @property
    def broken(self) -> int:
        """How many trees have any finding of the rule."""
        return self.fatal + self.minor

    @property
    def kept(self) -> int:
        """How many trees have no finding of the rule."""
        return self.asked - self.broken

    def to_json(self) -> JsonObject:
        """Return the counts as JSON."""
        return {"kept": self.kept, "asked": self.asked, "fatal": self.fatal, "minor": self.minor}


@dataclass(frozen=True)
class Verdicts:
    """The reports on the trees of some questions, ``None`` for a question without a tree: nobody accepts that."""

    reports: tuple[Report | None, ...]

    @property
    def trees(self) -> tuple[Report, ...]:
        """The reports on the trees that there are."""
        return tuple(report for report in self.reports if report is not None)

    @property
    def robot(self) -> int:
        """How many trees a robot can carry out."""
        return sum(report.robot for report in self.trees)

    @property
    def cook(self) -> int:
        """Of how many trees a cook would serve what comes of them."""
        return sum(report.cook for report in self.trees)

    @property
    def accepted(self) -> int:
        """How many trees robot and cook both accept."""
        return sum(report.accepted for report in self.trees)

    @property
    def form(self) -> int:
        """How many trees keep C1 to C9."""
        return sum(report.form for report in self.trees)

    @property
    def named(self) -> dict[str, int]:
        """The four counts by their names."""
        return {"robot": self.robot, "cook": self.cook, "accepted": self.accepted, "form": self.form}

    def share(self, count: int) -> float:
        """Return ``count`` as a share of all that was asked, what has no tree included."""
        return count / len(self.reports) if self.reports else 0.0

    @cached_property
    def rules(self) -> dict[str, RuleCount]:
        """What came of each rule, in the order of the contract."""
        # kept: a table asks for one rule after another, and each goes through every report
        asked = Counter(rule for report in self.trees for rule in _asked(report))
        fatal = Counter(rule for report in self.trees for rule in report.fatal)
        broken = Counter(rule for report in self.trees for rule in report.broken)
        return {rule: RuleCount(asked[rule], fatal[rule], broken[rule] - fatal[rule]) for rule in RULES}

    def to_json(self) -> JsonObject:
        """Return the four counts, and those of each rule."""
        return {**self.named, "rules": {rule: count.to_json() for rule, count in self.rules.items()}}


def verdict_json(report: Report | None) -> JsonObject:
    """Return what an evaluation says of a tree by the judge's ``report``; ``None`` stands for no tree."""
    if report is None:
        return {**dict.fromkeys(("robot", "cook", "accepted", "form"), False), "broken": [], "fatal": []}
    return {
        "robot": report.robot,
        "cook": report.cook,
        "accepted": report.accepted,
        "form": report.form,
        "broken": list(report.broken),
        "fatal": list(report.fatal),
    }


def _asked(report: Report) -> Sequence[str]:
    left = {rule for rule, why in report.not_asked if not why.startswith("in part")}
    return [rule for rule in RULES if rule not in left]
