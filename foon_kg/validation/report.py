"""What the judge says of a task tree: findings by rule, and whether robot and cook accept it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from foon_kg.model import ObjectNode
from foon_kg.model.node_json import node_to_json

FORM: tuple[str, ...] = ("C1", "C2", "C3", "C4", "C5", "C6", "C7", "C8", "C9")
WORLD: tuple[str, ...] = ("W1", "W2", "W3", "W4", "W5")
TABLE: tuple[str, ...] = ("K1", "K2", "K3", "K4", "K5", "K6", "K7")
RULES: tuple[str, ...] = (*FORM, *WORLD, *TABLE)

ROBOT: frozenset[str] = frozenset({*WORLD, "K4"})
"""The rules that a robot needs: with a fatal finding of one of them the tree cannot be carried out."""

COOK: frozenset[str] = frozenset(TABLE)
"""The rules that a cook needs."""

SEEN_BY_COOKS: frozenset[str] = COOK | {"W4", "W5"}
"""The rules whose minor findings a cook sees: what tastes odd, serves nothing or waits; not the slips of a node."""

MOST_MINOR = 2
"""How many of these minor findings a cook puts up with."""


@dataclass(frozen=True)
class Finding:
    """One breach of a rule of the contract.

    ``rule`` is its id (``K1``), ``reason`` says why it is broken, ``step`` at which step (from 0; ``None``: in the tree
    as a whole) and ``nodes`` about what. ``minor``: odd, yet it can be done; without it the finding is fatal.

    >>> print(Finding("K1", "the egg is raw", 4, minor=True))
    K1 (minor) step 5: the egg is raw
    """

    rule: str
    reason: str
    step: int | None = None
    nodes: tuple[ObjectNode, ...] = ()
    minor: bool = False

    def __str__(self) -> str:
        place = "" if self.step is None else f" step {self.step + 1}"
        about = f" {'; '.join(map(str, self.nodes))}" if self.nodes else ""
        return f"{self.rule}{' (minor)' if self.minor else ''}{place}{about}: {self.reason}"

    @property
    def in_words(self) -> str:
        """The finding where its level (fatal or minor) is told already: rule, step (from 1), nodes and reason.

        >>> Finding("K1", "it is raw", 4, (ObjectNode("egg", ("whole",)),)).in_words
        'K1 step 5, egg (whole): it is raw'
        """
        place = "" if self.step is None else f" step {self.step + 1}"
        about = "; ".join(map(str, self.nodes))
        return f"{self.rule}{place}{',' if place and about else ''}{' ' if about else ''}{about}: {self.reason}"

    def to_json(self) -> dict[str, Any]:
        """Return the finding as JSON; ``unit`` counts from 0 and is ``None`` where it is about the tree as a whole.

        >>> Finding("K1", "the egg is raw", 4).to_json()
        {'rule': 'K1', 'level': 'fatal', 'unit': 4, 'nodes': [], 'reason': 'the egg is raw'}
        """
        return {
            "rule": self.rule,
            "level": "minor" if self.minor else "fatal",
            "unit": self.step,
            "nodes": [node_to_json(node) for node in self.nodes],
            "reason": self.reason,
        }


@dataclass(frozen=True)
class Report:
    """Everything found in one tree, in the order of the rules.

    ``not_asked`` names each rule that could not be asked in full, with the reason; ``notes`` says what is allowed but
    must be told, such as the free foods that were let in. ``played`` is false where there is no tree.

    >>> print(Report("plan", (Finding("K1", "the egg is raw", 4),)))
    plan: not accepted (robot yes, cook no, form kept)
      fatal:
        K1 step 5: the egg is raw
    """

    name: str
    findings: tuple[Finding, ...]
    not_asked: tuple[tuple[str, str], ...] = ()
    notes: tuple[str, ...] = ()
    played: bool = True

    @cached_property
    def fatal(self) -> tuple[str, ...]:
        """The rules with at least one fatal finding, in their order.

        >>> Report("plan", (Finding("W3", "the pan is cold"), Finding("C3", "the stove stays on"))).fatal
        ('C3', 'W3')
        """
        found = {finding.rule for finding in self.findings if not finding.minor}
        return tuple(rule for rule in RULES if rule in found)

    @cached_property
    def broken(self) -> tuple[str, ...]:
        """The rules with any finding, minor ones too, in their order.

        >>> Report("plan", (Finding("W3", "the pan is cold"), Finding("K7", "chopped twice", minor=True))).broken
        ('W3', 'K7')
        """
        found = {finding.rule for finding in self.findings}
        return tuple(rule for rule in RULES if rule in found)

    @property
    def form(self) -> bool:
        """Whether there is a tree, and it keeps C1 to C9 as far as they were asked.

        >>> Report("plan", (Finding("C3", "the stove stays on"),)).form
        False
        """
        return self.played and not set(self.fatal) & set(FORM)

    @property
    def robot(self) -> bool:
        """Whether a robot can carry the tree out: no fatal W, no fatal K4.

        >>> Report("plan", (Finding("K1", "the egg is raw"),)).robot, Report("plan", (Finding("W3", "cold"),)).robot
        (True, False)
        """
        return self.played and not set(self.fatal) & ROBOT

    @property
    def cook(self) -> bool:
        """Whether a cook would serve what comes of it: no fatal K and at most two minor findings that a cook sees.

        >>> odd = Finding("K7", "chopped twice", minor=True)
        >>> Report("plan", (odd,) * 2).cook, Report("plan", (odd,) * 3).cook
        (True, False)
        """
        minor = sum(finding.minor for finding in self.findings if finding.rule in SEEN_BY_COOKS)
        return self.played and not set(self.fatal) & COOK and minor <= MOST_MINOR

    @property
    def accepted(self) -> bool:
        """Whether robot and cook both accept the tree; whether it keeps the form is not asked here (:attr:`form`).

        >>> Report("plan", ()).accepted, Report("plan", (Finding("K1", "the egg is raw"),)).accepted
        (True, False)
        """
        return self.robot and self.cook

    def of(self, rules: Iterable[str]) -> tuple[Finding, ...]:
        """Return the findings of some ``rules`` (ids, in capitals), in their order here; none where all are kept.

        >>> report = Report("plan", (Finding("K1", "the egg is raw", 4), Finding("W3", "the pan is cold", 2)))
        >>> [str(finding) for finding in report.of(["W1", "W3"])]
        ['W3 step 3: the pan is cold']
        """
        wanted = frozenset(rules)
        return tuple(finding for finding in self.findings if finding.rule in wanted)

    @property
    def form_in_words(self) -> str:
        """Whether there is a tree that keeps the form, or which of its rules are broken.

        >>> Report("plan", (Finding("C3", "the stove stays on"),)).form_in_words
        'form broken: C3'
        """
        if not self.played:
            return "no tree"
        broken = [rule for rule in self.fatal if rule in FORM]
        return f"form broken: {', '.join(broken)}" if broken else "form kept"

    @property
    def verdict(self) -> str:
        """Whether the tree is accepted, by robot and by cook, and keeps its form, in words.

        A reference tree keeps the paper's own terms, which know neither robot nor cook.

        >>> Report("plan", (Finding("K1", "the egg is raw", 4),)).verdict
        'not accepted (robot yes, cook no, form kept)'
        """
        if not self.played or not ROBOT.isdisjoint(
            rule for rule, why in self.not_asked if not why.startswith("in part")
        ):
            return self.form_in_words
        said = "accepted" if self.accepted else "not accepted"
        robot, cook = ("yes" if accepts else "no" for accepts in (self.robot, self.cook))
        return f"{said} (robot {robot}, cook {cook}, {self.form_in_words})"

    def lines(self) -> Iterator[str]:
        """Yield the lines that ``foon check`` prints: the verdict, findings, notes, which rules were not asked.

        >>> list(Report("plan", (), notes=("free foods that nobody asked for: oil",)).lines())[1:]
        ['  free foods that nobody asked for: oil']
        """
        yield f"{self.name}: {self.verdict}"
        for level, minor in (("fatal", False), ("minor", True)):
            findings = [finding for finding in self.findings if finding.minor is minor]
            if findings:
                yield f"  {level}:"
                yield from (f"    {finding.in_words}" for finding in findings)
        yield from (f"  {note}" for note in self.notes)
        yield from self._not_asked_in_words()

    def _not_asked_in_words(self) -> Iterator[str]:
        """Yield, for each reason, the rules that were not asked; not C9 alone: it compares trees."""
        rules: dict[str, list[str]] = {}
        for rule, why in self.not_asked:
            rules.setdefault(why, []).append(rule)
        for why, named in rules.items():
            if named != ["C9"]:
                yield f"  not asked: {', '.join(named)} ({why})"

    def __str__(self) -> str:
        return "\n".join(self.lines())

    def to_json(self) -> dict[str, Any]:
        """Return the report as ``foon check --json`` prints it: verdicts, findings, rules not asked and notes.

        >>> {name: told for name, told in Report("plan", ()).to_json().items() if told}
        {'name': 'plan', 'accepted': True, 'robot': True, 'cook': True, 'form': True}
        """
        return {
            "name": self.name,
            "accepted": self.accepted,
            "robot": self.robot,
            "cook": self.cook,
            "form": self.form,
            "findings": [finding.to_json() for finding in self.findings],
            "not_asked": [{"rule": rule, "why": why} for rule, why in self.not_asked],
            "notes": list(self.notes),
        }
