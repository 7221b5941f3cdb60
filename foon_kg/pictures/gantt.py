"""A schedule as a chart: one row a step, one colour a pair of hands."""

from __future__ import annotations

import altair as alt
import vl_convert

from foon_kg.schedule import Schedule, ScheduledStep
from foon_kg.views.schedule import summary
from foon_kg.views.shown_tree import ShownTree
from foon_kg.views.words import handled

ITSELF = "by itself"
_COLOURS = ("#0969da", "#bf8700", "#8250df", "#1a7f37")
_ITSELF_COLOUR = "#afb8c1"
_ROW = 18
_MINUTES = "floor(datum.value / 60) + ':' + pad(datum.value % 60, 2, '0', 'left')"
_WIDTH = 640


def schedule_svg(tree: ShownTree, plan: Schedule) -> str:
    """Answer the text of an SVG file with the schedule as a Gantt chart; bars of untimed steps are paler."""
    return str(vl_convert.vegalite_to_svg(_chart(tree, plan)))


def _chart(tree: ShownTree, plan: Schedule) -> str:
    rows = [_row(tree, step) for step in plan.steps]
    names = [str(row["step"]) for row in rows]
    who = [_who(number) for number in range(plan.hands)] + [ITSELF]
    colours = [_COLOURS[number % len(_COLOURS)] for number in range(plan.hands)] + [_ITSELF_COLOUR]
    base = alt.Chart(alt.InlineData(values=rows)).encode(
        y=alt.Y("step:N", sort=names, title=None, axis=alt.Axis(labelLimit=320, ticks=False, domain=False)),
        x=alt.X("start:Q", title="minutes and seconds", axis=alt.Axis(grid=True, labelExpr=_MINUTES)),
    )
    bars = base.mark_bar(height=11, cornerRadius=2).encode(
        x2="end:Q",
        color=alt.Color(
            "who:N", scale=alt.Scale(domain=who, range=colours), title=None, legend=alt.Legend(orient="top")
        ),
        opacity=alt.condition("datum.timed", alt.value(1.0), alt.value(0.4)),
    )
    notes = base.mark_text(align="left", dx=4, fontSize=10, color="#656d76").encode(x="end:Q", text="note:N")
    title = alt.TitleParams(tree.title, subtitle=summary(plan), anchor="start", fontSize=15)
    chart = alt.layer(bars, notes).properties(
        width=_WIDTH, height=_ROW * max(len(rows), 1), title=title, background="white"
    )
    styled = chart.configure_view(stroke=None).configure(font="Helvetica, Arial, sans-serif", padding=16)
    return str(styled.to_json())


def _row(tree: ShownTree, step: ScheduledStep) -> dict[str, object]:
    unit = tree.units[step.place]
    return {
        "step": f"{step.place + 1}  {unit.motion_node}  {handled(unit.input_nodes)}",
        "start": step.start,
        "end": step.end,
        "who": ITSELF if step.hands is None else _who(step.hands),
        "timed": step.duration is not None,
        "note": "" if step.duration else "never timed",
    }


def _who(number: int) -> str:
    return f"pair of hands {number + 1}"
