"""What a file would change in a FOON, for people: counts first, then the units."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rich.console import Group, RenderableType
from rich.text import Text

from foon_kg.model import FunctionalUnit, ObjectNode
from foon_kg.plans.difference import ShownUnit, VideoDifference

_NAMED = 3
"""So many of the videos that show a unit are named."""

_GOES_ON = "is there as it is; loading it again changes nothing"


def difference_view(one: VideoDifference, *, units: bool) -> RenderableType:
    """Return what one video changes; with ``units`` each of them, not only how many."""
    counts = (
        (len(one.added), "new"),
        (len(one.shared), "known from other videos"),
        (one.kept, "as before"),
        (len(one.left), "left to other videos"),
        (len(one.dropped), "gone"),
    )
    said = ", ".join(f"{count} {what}" for count, what in counts if count) or _GOES_ON
    head = Text.assemble((one.name, "bold"), f" ({one.status}): {said}")
    lines: list[RenderableType] = [head]
    if one.new_labels:
        lines.append(Text(f"  first seen here: {', '.join(one.new_labels)}"))
    if units:
        lines += [_unit("+", "green", unit) for unit in one.added]
        lines += [_shown("=", "cyan", shown) for shown in one.shared]
        lines += [_shown("=", "yellow", shown) for shown in one.left]
        lines += [_unit("-", "red", unit) for unit in one.dropped]
    return Group(*lines)


def difference_json(one: VideoDifference) -> dict[str, object]:
    """Return the same as one object of JSON."""
    return {
        "video": one.name,
        "status": str(one.status),
        "added": [_as_text(unit) for unit in one.added],
        "shared": _json_of(one.shared),
        "left": _json_of(one.left),
        "dropped": [_as_text(unit) for unit in one.dropped],
        "kept": one.kept,
        "new_labels": list(one.new_labels),
    }


def _json_of(shown: Iterable[ShownUnit]) -> list[dict[str, object]]:
    return [{"unit": _as_text(one.unit), "videos": list(one.videos)} for one in shown]


def _unit(mark: str, style: str, unit: FunctionalUnit) -> Text:
    return Text(f"  {mark} {_as_text(unit)}", style=style)


def _shown(mark: str, style: str, shown: ShownUnit) -> Text:
    more = len(shown.videos) - _NAMED
    named = ", ".join(shown.videos[:_NAMED]) + (f" and {more} more" if more > 0 else "")
    return Text.assemble((f"  {mark} {_as_text(shown.unit)}", style), f"  in {named}")


def _as_text(unit: FunctionalUnit) -> str:
    return f"{_nodes(unit.input_nodes)} → {unit.motion} → {_nodes(unit.output_nodes)}"


def _nodes(nodes: Sequence[ObjectNode]) -> str:
    return " + ".join(map(str, nodes))
