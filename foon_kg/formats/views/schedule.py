"""A schedule and a shopping list as lines of a terminal."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from foon_kg.formats.exports.sentences import sentence
from foon_kg.formats.views.shown_tree import ShownTree
from foon_kg.formats.views.words import ASIDE, node_words
from foon_kg.model import ObjectNode
from foon_kg.plans.durations import Duration
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.schedule import Schedule, ScheduledStep

HANDS = ("cyan", "yellow", "magenta", "blue")


def schedule_view(tree: ShownTree, plan: Schedule) -> RenderableType:
    """Return a table of the steps of ``tree`` by their start in ``plan``: when, whose hands, what, how sure."""
    table = Table(box=None, padding=(0, 1), header_style=ASIDE, collapse_padding=True, pad_edge=False)
    timed = plan.known_until > 0
    for title, justify in (("from", "right"), ("to", "right")) if timed else ():
        table.add_column(title, justify=justify)  # type: ignore[arg-type]
    for title in ("hands", "step", "seen"):
        table.add_column(title)
    for step in plan.steps:
        times = (_when(plan, step.start), _when(plan, step.end)) if timed else ()
        table.add_row(*times, _hands(step), _step(tree, step), _seen(step.duration))
    parts: list[RenderableType] = [Text(tree.title, "bold"), table, Text(), Text(summary(plan))]
    return Group(*parts, *([Text(CAUTION, ASIDE)] if plan.untimed < len(plan.steps) else []))


CAUTION = "Times are the medians of what videos show. They cut short what cooks, rises or cools: that has no time here."
UNKNOWN = "unknown"


def summary(plan: Schedule) -> str:
    """Return in a sentence how long the schedule ``plan`` is, and how good.

    Where steps were never timed, nobody knows.
    """
    if plan.untimed:
        return _untimed(plan)
    pairs = "one pair of hands" if plan.hands == 1 else f"{plan.hands} pairs of hands"
    proven = "proven the shortest" if plan.shortest else "the shortest found"
    return f"{clock(plan.length)} with {pairs} ({proven}); {clock(plan.alone)} one step after the other."


def _untimed(plan: Schedule) -> str:
    count = len(plan.steps)
    if plan.untimed == count:
        return f"How long it takes is unknown: no video of this FOON times any of its {count} steps."
    alone = sum(step.duration.median for step in plan.steps if step.duration is not None)
    untimed = f"{plan.untimed} of its {count} steps"
    return (
        f"How long it takes is unknown: nothing tells how long {untimed} take. The others take {clock(alone)} in all."
    )


def _when(plan: Schedule, seconds: float) -> str:
    return clock(seconds) if seconds <= plan.known_until else UNKNOWN


def shopping_view(foods: Sequence[ObjectNode], unseen: Sequence[str] = ()) -> RenderableType:
    """Return the ``foods`` to buy, one a line; those in ``unseen`` are marked as ones that FOON has not seen so."""
    return Group(*(node_words(food, unseen) for food in foods))


def clock(seconds: float) -> str:
    """Return a time as minutes and seconds: 1:05.

    >>> clock(64.6)
    '1:05'
    """
    whole = int(seconds + 0.5)  # as the page rounds
    return f"{whole // 60}:{whole % 60:02}"


def seen_words(duration: Duration) -> str:
    """Return how often the motion of a ``duration`` was seen, and for how long mostly: ``14 times, 3 to 20 s``."""
    if not duration.sightings:
        return f"{clock(duration.median)}, as a recipe says"
    times = "once" if duration.sightings == 1 else f"{duration.sightings} times"
    low, high = f"{duration.low:.0f}", f"{duration.high:.0f}"
    return f"{times}, {low if low == high else f'{low} to {high}'} s"


def _hands(step: ScheduledStep) -> Text:
    if step.hands is None:
        return Text("itself", ASIDE)
    return Text(f"{step.hands + 1}", HANDS[step.hands % len(HANDS)])


def _step(tree: ShownTree, step: ScheduledStep) -> Text:
    said = sentence(tree.units[step.place].as_unit(), Kitchen.default())
    return Text.assemble((f"{step.place + 1} ", ASIDE), said.rstrip("."))


def _seen(duration: Duration | None) -> Text:
    return Text(UNKNOWN if duration is None else seen_words(duration), ASIDE)
