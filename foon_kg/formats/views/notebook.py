"""How a plan result shows itself in a notebook: as HTML, and as a table of its steps.

Both work on the JSON of a result (:meth:`foon_kg.plans.result.PlanResult.to_json`), which says everything there is to
show.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any

from foon_kg.model.errors import UsageError
from foon_kg.model.json_fields import JsonObject

if TYPE_CHECKING:
    import pandas as pd

_STYLE = {  # these stand out on light and on dark paper
    "state": "color:#2da44e",
    "motion": "color:#e5534b;font-weight:bold",
    "unseen": "color:#388bfd;border-bottom:1px dashed",
    "aside": "opacity:.65",
}
_CELL = "text-align:left;vertical-align:top;padding:.15em .8em .15em 0"


def plan_html(plan: JsonObject) -> str:
    """Return a plan result (its JSON) as a piece of HTML: its steps, what stands for what, and what is assumed."""
    recipe = plan["recipe"]
    unseen = {one["object"] for one in plan["substitutions"] if one["kind"] == "object"}
    title = recipe.get("title") or recipe.get("id") or recipe["dish_type"]
    steps = _rows(
        (str(number), _nodes(unit["input_nodes"], unseen), _styled("motion", unit["motion_node"]),
         _nodes(unit["output_nodes"], unseen), _styled("aside", unit["origin"]))
        for number, unit in enumerate(plan["units"], start=1)
    )  # fmt: skip
    head = "".join(f'<th style="{_CELL}">{name}</th>' for name in ("", "takes", "motion", "makes", "origin"))
    parts = [f"<b>{escape(title)}</b> → {_node(plan['goal'], unseen)}"]
    parts.append(f"<table><thead><tr>{head}</tr></thead><tbody>{steps}</tbody></table>")
    parts += [_substitution(one) for one in plan["substitutions"]]
    parts += [f"{_node(one['node'], unseen)}: {escape(one['why'])}<br>" for one in plan["assumptions"]]
    return f"<div>{''.join(parts)}</div>"


def steps_frame(plan: JsonObject) -> pd.DataFrame:
    """Return the steps of a plan result (its JSON) as a table, a row a step, numbered from 1.

    Columns: ``motion``, ``inputs`` and ``outputs`` (lists of nodes as words), ``origin``, and of the first place where
    the step was seen ``video``, ``start`` and ``end`` (seconds). Raises UsageError where pandas is not installed.
    """
    try:
        import pandas as pd  # noqa: PLC0415 - only this needs it, and it is not always there
    except ModuleNotFoundError as error:
        raise UsageError(
            "to_frame() needs pandas, which is not installed", hint="pip install 'foon-kg[recipes]'"
        ) from error
    rows = [_row(unit) for unit in plan["units"]]
    columns = ["motion", "inputs", "outputs", "origin", "video", "start", "end"]
    return pd.DataFrame(rows, columns=columns, index=pd.RangeIndex(1, len(rows) + 1, name="step"))


def _row(unit: Mapping[str, Any]) -> dict[str, object]:
    seen = unit["seen_in"][0] if unit["seen_in"] else {"video": None, "start": None, "end": None}
    return {
        "motion": unit["motion_node"],
        "inputs": [_words(node) for node in unit["input_nodes"]],
        "outputs": [_words(node) for node in unit["output_nodes"]],
        "origin": unit["origin"],
        "video": seen["video"],
        "start": seen["start"],
        "end": seen["end"],
    }


def _words(node: Mapping[str, Any]) -> str:
    told = [", ".join(node["states"]), "{" + ", ".join(node["ingredients"]) + "}" if node["ingredients"] else ""]
    told.append(f"{node['relation'] or 'at'} {node['container']}" if node["container"] else "")
    return f"{node['label']} ({'; '.join(filter(None, told))})" if any(told) else str(node["label"])


def _rows(rows: Iterable[Sequence[str]]) -> str:
    cells = ("".join(f'<td style="{_CELL}">{cell}</td>' for cell in row) for row in rows)
    return "".join(f"<tr>{row}</tr>" for row in cells)


def _nodes(nodes: Iterable[Mapping[str, Any]], unseen: Iterable[str]) -> str:
    return "<br>".join(_node(node, unseen) for node in nodes)


def _node(node: Mapping[str, Any], unseen: Iterable[str]) -> str:
    label = node["label"]
    told = [_styled("state", ", ".join(node["states"]))] if node["states"] else []
    told += [_styled("aside", f"with {', '.join(node['ingredients'])}")] if node["ingredients"] else []
    told += [_styled("aside", f"{node['relation'] or 'at'} {node['container']}")] if node["container"] else []
    return " ".join([_styled("unseen", f"~{label}") if label in unseen else escape(label), *told])


def _styled(kind: str, text: str) -> str:
    return f'<span style="{_STYLE[kind]}">{escape(text)}</span>'


def _substitution(one: Mapping[str, Any]) -> str:
    what = (
        _styled("unseen", one["required"]) if one["kind"] == "object" else escape(f"{one['object']}: {one['required']}")
    )
    others = ", ".join(f"{other['name']} {other['confidence']:.2f}" for other in one["alternatives"])
    told = f"{one['confidence']:.2f} {what} like {escape(one['equivalent'])}"
    return told + (f" {_styled('aside', 'or ' + others)}" if others else "") + "<br>"
