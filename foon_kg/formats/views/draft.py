"""A draft for the person who reviews it: each unit beside its doubts, then what is missing and what it would change."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.text import Text

from foon_kg.formats.views.words import ASIDE, in_a_row, motion_words, node_words
from foon_kg.language.drafting.review import Missing
from foon_kg.model import FunctionalUnit, ObjectNode
from foon_kg.model.drafts import SURE, DraftFile, DraftRow

_LIKELY = 0.5
"""From this confidence on a row is more likely right than not, and is shown green."""


def draft_view(draft: DraftFile, missing: Sequence[Missing], *, worst_first: bool = False) -> RenderableType:
    """Return the rows of ``draft`` in their order, or the least sure first, and what is missing to execute it."""
    rows = sorted(draft.rows, key=_sureness) if worst_first else draft.rows
    lines: list[RenderableType] = []
    for row in rows:
        lines += _row(row, [one for one in missing if one.line == row.line])
    units = [row for row in draft.rows if row.annotation is not None]
    doubtful = sum(bool(row.doubts) and row.confidence < SURE for row in units)
    stuck = len({one.line for one in missing})
    counts = (
        f"{len(units)} units, {doubtful} of them doubtful",
        f"{len(draft.rows) - len(units)} rows are no units",
        f"{len(units) - stuck} can be executed as they stand",
    )
    return Group(*lines, Text(f"{draft.path}: {'; '.join(counts)}", "bold"))


def draft_json(draft: DraftFile, missing: Sequence[Missing]) -> dict[str, object]:
    """Return a ``draft``, with the inputs that are ``missing``, as one object of JSON."""
    return {
        "file": draft.path,
        "rows": [
            {
                "line": row.line,
                "unit": _unit_words(row.annotation.unit).plain if row.annotation else None,
                "confidence": row.confidence,
                "doubts": list(row.doubts),
                "said": row.said,
                "missing": [{"object": str(one.node), "why": one.why} for one in missing if one.line == row.line],
            }
            for row in draft.rows
        ],
    }


def _sureness(row: DraftRow) -> tuple[float, int]:
    return (row.confidence if row.doubts or row.annotation is None else 1.0, row.line)


def _row(row: DraftRow, missing: Sequence[Missing]) -> list[RenderableType]:
    unit = _unit_words(row.annotation.unit) if row.annotation else Text("no unit", "red")
    figure = Text(f"{row.confidence:.2f}", _colour(row.confidence) if row.doubts else "green")
    lines: list[RenderableType] = [
        Text.assemble((f"{row.line:>4} ", ASIDE), figure, "  ", unit, "  ", (row.said, ASIDE))
    ]
    lines += [Text(f"           ? {doubt}", "yellow") for doubt in row.doubts]
    lines += [Text(f"           ! {one.node}: {one.why}", "magenta") for one in missing]
    return lines


def _colour(confidence: float) -> str:
    if confidence < SURE:
        return "red"
    return "green" if confidence >= _LIKELY else "yellow"


def _unit_words(unit: FunctionalUnit) -> Text:
    return Text.assemble(_nodes(unit.input_nodes), " → ", motion_words(unit.motion), " → ", _nodes(unit.output_nodes))


def _nodes(nodes: Sequence[ObjectNode]) -> Text:
    return in_a_row(map(node_words, nodes), " + ")
