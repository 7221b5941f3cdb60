"""The reference tree beside the final tree as lines of a terminal."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from foon_kg.formats.exports.phrases import motion_said
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.formats.views.words import ASIDE, handled, motion_words
from foon_kg.plans.step_changes import StepChange

COLOURS = {"kept": "", "changed": "blue", "left out": "dim strike", "added": "green"}
_MOST_NAMES = 5


def step_changes_view(tree: ShownTree, changes: Sequence[StepChange]) -> RenderableType:
    """Return the steps of ``tree`` and of its reference side by side by ``changes``, and what only one of them has."""
    table = Table(box=None, padding=(0, 1), header_style=ASIDE, pad_edge=False, collapse_padding=True)
    for title in ("", "reference", "this tree", ""):
        table.add_column(title)
    for one in changes:
        style = COLOURS[one.change]
        table.add_row(Text(one.change, style), _before(one), _after(one), Text(names(one), ASIDE))
    return Group(Text(tree.title, "bold"), table, Text(), Text(totals(changes)))


def totals(changes: Sequence[StepChange]) -> str:
    """Return how many steps were kept, changed, left out and added."""
    count = Counter(one.change for one in changes)
    return ", ".join(f"{count[change]} {change}" for change in ("kept", "changed", "left out", "added")) + "."


def names(one: StepChange) -> str:
    """Return what ``one`` changed step lost and won, as in ``- lettuce  + endive``."""
    signs = ((sign, some) for sign, some in (("-", one.gone), ("+", one.come)) if some)
    return "  ".join(
        f"{sign} {', '.join(some[:_MOST_NAMES])}{' …' * (len(some) > _MOST_NAMES)}" for sign, some in signs
    )


def _before(one: StepChange) -> Text:
    if one.before is None:
        return Text()
    number, known = one.before
    unit = known.unit
    text = Text.assemble((f"{number} ", ASIDE), motion_words(motion_said(unit.motion)), " ", handled(unit.input_nodes))
    text.stylize(COLOURS["left out"] if one.change == "left out" else "")
    return text


def _after(one: StepChange) -> Text:
    if one.after is None:
        return Text()
    number, unit = one.after
    return Text.assemble((f"{number} ", ASIDE), motion_words(motion_said(unit.motion)), " ", handled(unit.input_nodes))
