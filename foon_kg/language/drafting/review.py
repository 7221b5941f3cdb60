"""What a person should look at before a draft is accepted: doubtful rows, no units, objects from nowhere."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from foon_kg.language.drafting.drafts import DraftFile, DraftRow
from foon_kg.model import ObjectNode
from foon_kg.plans.kitchen import Kitchen

SURE = 0.5
"""Doubts below this must be resolved before a draft is accepted: those of units that are likelier wrong than right."""


@dataclass(frozen=True)
class Missing:
    """An input of the unit in ``line`` that no earlier row makes, and ``why`` no kitchen has it."""

    line: int
    node: ObjectNode
    why: str


def unresolved(draft: DraftFile, sure: float = SURE) -> tuple[DraftRow, ...]:
    """Return the rows that are no units, and those with doubts and less than ``sure`` confidence, in their order."""
    return tuple(row for row in draft.rows if row.annotation is None or (row.doubts and row.confidence < sure))


def missing(draft: DraftFile, kitchen: Kitchen) -> tuple[Missing, ...]:
    """Return the inputs with which the units cannot be executed in their order (contract, C1 and C6)."""
    return tuple(_missing(draft, kitchen))


def _missing(draft: DraftFile, kitchen: Kitchen) -> Iterator[Missing]:
    made: set[ObjectNode] = set()
    for row in draft.rows:
        if row.annotation is None:
            continue
        inputs = row.annotation.unit.input_nodes
        for node in inputs:
            fault = None if node in made else kitchen.leaf_fault(node, inputs)
            if fault is not None:
                yield Missing(row.line, node, str(fault))
        made.update(row.annotation.unit.output_nodes)
