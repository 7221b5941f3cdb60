"""``foon retrieve``: classic retrieval, from a goal and a kitchen to the shortest or the likeliest task tree."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from foon_kg.cli.console import AsText, Files, Json, Quiet, Say, examples, print_json, print_view, sayer
from foon_kg.cli.kitchen import KitchenFile, kitchen_of
from foon_kg.model.errors import UsageError

if TYPE_CHECKING:
    from foon_kg.foon import RetrievalResult

EXAMPLES = examples(
    "foon retrieve omelette --state cooked",
    "foon retrieve salad --by success --weights motion_cost.json --level 3 --json",
    "foon retrieve salad --kitchen at_home.txt --files subgraphs/ --foon",
)


Goal = Annotated[str, typer.Argument(metavar="LABEL", help="What is to be made, as the FOON calls it.")]
States = Annotated[
    list[str] | None, typer.Option("--state", metavar="STATE", help="It has this state; may be given many times.")
]
Ingredients = Annotated[
    list[str] | None,
    typer.Option("--ingredient", metavar="FOOD", help="It has this ingredient; may be given many times."),
]
Container = Annotated[str | None, typer.Option("--in", metavar="PLACE", help="It is in, or on, this container.")]
AtLevel = Annotated[
    int, typer.Option(metavar="N", min=1, max=3, help="1: labels; 2: states and places too; 3: ingredients too.")
]
By = Annotated[
    Literal["units", "success"], typer.Option(help="What is best: the fewest units, or the greatest success.")
]
Weights = Annotated[
    Path | None,
    typer.Option("--weights", metavar="FILE", help="How hard motions are (JSON), in place of the stored weights."),
]


def retrieve(
    goal: Goal,
    *,
    states: States = None,
    ingredients: Ingredients = None,
    container: Container = None,
    level: AtLevel = 2,
    by: By = "units",
    weights: Weights = None,
    kitchen: KitchenFile = None,
    as_json: Json = False,
    foon: AsText = False,
    files: Files = None,
    quiet: Quiet = False,
) -> None:
    """Retrieve the shortest or likeliest tree of a goal.

    This is classic retrieval, as robots need it: from what is at hand, every step is a unit of the FOON and nothing
    is substituted. The tree is the best there is, for any node that fits the goal, and proven: enumerating all of
    them would give the same. At level 1 an object is its label, at level 2 its states and place count as well, at
    level 3 its ingredients too.

    Weights say how hard a motion is for a robot, from 0 to 1; a unit succeeds with 1 less its weight, a tree with the
    product of its units. A motion without a weight counts 0.5, and the answer names it.

    Without a tree the error says what is missing (exit code 3).
    """
    from foon_kg.cli.knowledge import front_door
    from foon_kg.loaders import read_weights

    if as_json and foon:
        raise UsageError("--json and --foon ask for two forms of one answer", hint="Choose one of them.")
    say = sayer(quiet=quiet)
    costs = None if weights is None else read_weights(weights)
    with front_door(files, say) as door:
        tree = door.retrieve(
            _folded(goal),
            map(_folded, states or ()),
            map(_folded, ingredients or ()),
            container=None if container is None else _folded(container),
            level=level,
            by=by,
            kitchen=kitchen_of(kitchen, door, say),
            costs=costs,
        )
    _show(tree, say, as_json=as_json, foon=foon)


def _folded(name: str) -> str:
    return " ".join(name.split())


def _show(tree: RetrievalResult, say: Say, *, as_json: bool, foon: bool) -> None:
    if tree.assumed:
        say(f"without a weight, taken as 0.5: {', '.join(tree.assumed)}")
    if as_json:
        print_json(tree.to_json())
    elif foon:
        from foon_kg.loaders import write_text

        typer.echo(write_text(tree.to_subgraph()), nl=False)
    else:
        from foon_kg.formats.views.retrieval import retrieval_view

        print_view(retrieval_view(tree))
