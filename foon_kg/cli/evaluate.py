"""``foon evaluate``: how good the trees are: of recipes, of videos left out one by one, and of anybody."""

from __future__ import annotations

from foon_kg.cli import evaluate_recipes, evaluate_trees, evaluate_videos
from foon_kg.cli.groups import CommandGroup

app = CommandGroup(name="evaluate", help="Measure how good the trees are.")


@app.callback()
def evaluate() -> None:
    """Measure how good the trees are."""


app.command(epilog=evaluate_recipes.EXAMPLES)(evaluate_recipes.recipes)
app.command("leave-one-out", epilog=evaluate_videos.EXAMPLES)(evaluate_videos.leave_one_out)
app.command(epilog=evaluate_trees.EXAMPLES)(evaluate_trees.trees)
