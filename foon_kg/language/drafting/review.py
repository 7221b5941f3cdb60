"""What a person should look at before a draft is accepted: doubtful rows, no units, objects from nowhere."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from foon_kg.language.drafting.drafts import DraftFile, DraftRow
from foon_kg.model import ObjectNode
from foon_kg.plans.kitchen import Kitchen

SURE = 0.1
"""Doubts below this must be resolved before a draft is accepted: of units hardly one in ten of which is all right.

The confidence asks for every state, too, which few drafts have all right: nine in ten units from verbs and nouns have
the right motion and main object, and a quarter every state. A person decides about the least sure seventh.
"""


@dataclass(frozen=True)
class Missing:
    """An input of the unit in ``line`` that no earlier row makes, and ``why`` no kitchen has it."""

    line: int
    node: ObjectNode
    why: str


def unresolved(draft: DraftFile, sure: float = SURE) -> tuple[DraftRow, ...]:
    """Return the rows of ``draft`` with doubts and less than ``sure`` confidence (0 to 1), and empty ones.

    Rows that are no units are among them.
    """
    return tuple(row for row in draft.rows if (row.confidence < sure if row.doubts else row.annotation is None))


def missing(draft: DraftFile, kitchen: Kitchen) -> tuple[Missing, ...]:
    """Return the inputs with which the units of ``draft`` cannot be executed in their order (C1 and C6).

    ``kitchen`` says what may be there from the start.
    """
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
