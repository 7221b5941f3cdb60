"""What the judge says of a task tree: the rule that is broken, the unit, the node and the reason."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from foon_kg.model import ObjectNode
from foon_kg.model_json import node_to_json

CONTRACT: tuple[str, ...] = ("C1", "C2", "C3", "C4", "C5", "C6", "C7", "C8", "C9")
SENSE: tuple[str, ...] = ("S1", "S2", "S3", "S4", "S5", "S6", "S7", "S8")


@dataclass(frozen=True)
class Finding:
    """One breach of ``rule``: at the unit of that place in the tree (from 0), about ``node``, and why."""

    rule: str
    reason: str
    unit: int | None = None
    node: ObjectNode | None = None

    def __str__(self) -> str:
        place = "" if self.unit is None else f" unit {self.unit}"
        return f"{self.rule}{place}{f' {self.node}' if self.node else ''}: {self.reason}"

    def to_json(self) -> dict[str, Any]:
        """Answer the finding as JSON."""
        node = None if self.node is None else node_to_json(self.node)
        return {"rule": self.rule, "unit": self.unit, "node": node, "reason": self.reason}


@dataclass(frozen=True)
class Report:
    """Everything found in one tree, in the order of the rules.

    ``not_asked`` names each rule that could not be asked in full, with the reason; ``notes`` says what is allowed but
    must be told, such as the free foods that were let in.
    """

    name: str
    findings: tuple[Finding, ...]
    not_asked: tuple[tuple[str, str], ...] = ()
    notes: tuple[str, ...] = ()

    @cached_property
    def broken(self) -> tuple[str, ...]:
        """The rules with at least one finding, in their order."""
        found = {finding.rule for finding in self.findings}
        return tuple(rule for rule in (*CONTRACT, *SENSE) if rule in found)

    @property
    def sound(self) -> bool:
        """Whether the tree keeps every rule of the contract that was asked."""
        return not set(self.broken) & set(CONTRACT)

    @property
    def clean(self) -> bool:
        """Whether the tree is sound and makes sense by every measure that was asked."""
        return not self.broken

    def of(self, rules: Iterable[str]) -> tuple[Finding, ...]:
        """Answer the findings of some rules."""
        wanted = frozenset(rules)
        return tuple(finding for finding in self.findings if finding.rule in wanted)

    def to_json(self) -> dict[str, Any]:
        """Answer the report as JSON."""
        return {
            "name": self.name,
            "sound": self.sound,
            "clean": self.clean,
            "findings": [finding.to_json() for finding in self.findings],
            "not_asked": [{"rule": rule, "why": why} for rule, why in self.not_asked],
            "notes": list(self.notes),
        }
