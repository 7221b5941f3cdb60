"""``foon load weights``: how hard each motion is for a robot, onto the motion nodes of the graph."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from foon_kg.cli.console import Json, Quiet, examples, print_json, sayer

EXAMPLES = examples("foon load weights motion_cost.json", "foon load weights motion_cost.json --json")

_SHOWN = 10
"""So many motions are named; --json has them all."""


def weights(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help='JSON: one number from 0 to 1 for each motion, {"chop": 0.9, …}.')
    ],
    *,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Store how hard motions are for a robot.

    0 is for a motion that always succeeds, 1 for one that never does.
    The file takes the place of all weights from before, or nothing is changed. Units that are loaded later get theirs
    from it too. foon retrieve --by success asks for them.
    """
    from foon_kg.foon import Foon
    from foon_kg.loaders import read_weights

    say = sayer(quiet=quiet)
    costs = read_weights(file)
    with Foon.connect(say=say) as foon:
        report = foon.store_weights(costs)
    if report.not_in_graph:
        say(f"no unit of the graph has {_first(report.not_in_graph)}")
    if report.without_weight:
        say(f"without a weight in the graph: {_first(report.without_weight)}")
    if as_json:
        print_json(
            {
                "motions": report.motions,
                "units": report.units,
                "not_in_graph": list(report.not_in_graph),
                "without_weight": list(report.without_weight),
            }
        )
    else:
        typer.echo(f"{report.motions} motions, {report.units} units with a weight")


def _first(motions: Sequence[str]) -> str:
    rest = f" and {len(motions) - _SHOWN} more (--json has them all)" if motions[_SHOWN:] else ""
    return ", ".join(motions[:_SHOWN]) + rest
