"""What a draft takes from nowhere: inputs that no earlier row makes, and no kitchen has."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from foon_kg.model import ObjectNode
from foon_kg.model.drafts import DraftFile
from foon_kg.plans.kitchen import Kitchen


@dataclass(frozen=True)
class Missing:
    """An input of the unit in ``line`` that no earlier row makes, and ``why`` no kitchen has it."""

    line: int
    node: ObjectNode
    why: str


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
