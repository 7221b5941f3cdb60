"""A retrieved task tree as lines of a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from foon_kg.food import tables
from foon_kg.formats.views.words import ASIDE, in_a_row, motion_words, node_words, section, shown_inputs, shown_outputs
from foon_kg.model import ObjectNode
from foon_kg.search.classic import Criterion, RetrievalResult, RetrievedUnit

_LEVELS = {1: "objects alone", 2: "objects with their states", 3: "objects with states and ingredients"}


def retrieval_view(tree: RetrievalResult) -> RenderableType:
    """Return what the tree makes, how good it is, its steps and what has to be in the kitchen."""
    kitchen = in_a_row(map(node_words, _once(tree.kitchen)), " · ")
    return Group(_header(tree), section("Steps", _steps(tree)), section("Kitchen", kitchen))


def _once(kitchen: Sequence[ObjectNode]) -> Iterator[ObjectNode]:
    """Yield what has to be there, an appliance once though videos tell its state by several words: off or off (ready).

    A kitchen has one appliance of each kind.
    """
    things: dict[ObjectNode, list[ObjectNode]] = {}
    for node in kitchen:
        row = tables().utensil(node.label)
        thing = replace(node, states=()) if row is not None and row.role == "appliance" else node
        things.setdefault(thing, []).append(node)
    for thing, told in things.items():
        ways = filter(None, (", ".join(node.states) for node in told))
        yield replace(thing, states=(" or ".join(ways),)) if len(told) > 1 else told[0]


def _header(tree: RetrievalResult) -> RenderableType:
    table = Table.grid(padding=(0, 1))
    table.add_row(Text("makes", ASIDE), node_words(tree.goal))
    table.add_row(Text("level", ASIDE), Text(f"{int(tree.sought.level)}, {_LEVELS[tree.sought.level]}"))
    table.add_row(Text("steps", ASIDE), Text(_units_words(tree)))
    if tree.success is not None:
        table.add_row(Text("success", ASIDE), Text(_success_words(tree, tree.success)))
    return table


def _units_words(tree: RetrievalResult) -> str:
    count = str(len(tree.units))
    if tree.sought.by is not Criterion.UNITS:
        return count
    return f"{count}, proven: no tree has fewer" if tree.exact else f"{count}; it is open whether {tree.bound} would do"


def _success_words(tree: RetrievalResult, success: Fraction) -> str:
    rate = _rate(success)
    if tree.sought.by is Criterion.SUCCESS:
        rate += ", proven: no tree has more" if tree.exact else f"; no tree has more than {tree.bound:.2g}"
    return rate + (f"; assumed without a weight: {', '.join(tree.assumed)}" if tree.assumed else "")


def _steps(tree: RetrievalResult) -> Table:
    table = Table.grid(padding=(0, 1))
    table.add_column(justify="right", style=ASIDE)
    for number, step in enumerate(tree.units, start=1):
        table.add_row(str(number), _step(step))
    return table


def _step(step: RetrievedUnit) -> Text:
    unit, seen_in = step.known.unit, step.known.seen_in
    taken = in_a_row(map(node_words, shown_inputs(unit.input_nodes)), " + ")
    made = in_a_row(map(node_words, shown_outputs(unit.output_nodes)), " + ")
    text = Text.assemble(taken, " → ", motion_words(unit.motion), " → ", made)
    rate = "" if step.success is None else f"{_rate(step.success)}; "
    return text.append(f"  [{rate}from {seen_in[0].video}]" if seen_in else "", ASIDE)


def _rate(rate: Fraction) -> str:
    return f"{float(rate):.2g}"
