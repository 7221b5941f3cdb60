"""``foon demo``: from nothing to a task tree that nobody recorded."""

from __future__ import annotations

from typing import TYPE_CHECKING

from foon_kg.cli.console import Json, Quiet, Say, examples, print_json, print_view, sayer

if TYPE_CHECKING:
    from foon_kg.foon import Foon
    from foon_kg.model import Subgraph
    from foon_kg.plans.result import PlanResult

EXAMPLES = examples("foon demo", "foon demo --json --quiet")

RECIPE = "kohlrabi_salad"
"""No video of the demo's FOON has seen a kohlrabi."""

NEXT = """
This tree was planned from the FOON in your local Neo4j. Next you could

  ask for something else
    foon plan --dish omelette "chopped leek" "beaten egg" "grated cheddar"
    foon plan --dish soup "chopped parsnip" "chopped onion" --json
  look at the graph
    foon stats
    foon cypher "MATCH (v:Video) RETURN v.name ORDER BY v.name"
  load a larger FOON: 111 annotated cooking videos are public
    git clone https://github.com/sadman3/consolidating-task-trees
    foon load foon FOLDER     (the folder of its subgraphs; a few of its units are broken, and skipped)
  stop the server
    foon server stop"""


def demo(as_json: Json = False, quiet: Quiet = False) -> None:
    """Plan a first dish, from a small FOON in a local Neo4j.

    Starts the local Neo4j (the first time fetches it and Java, which takes a minute or two), loads a FOON of 23
    subgraphs of common cooking knowledge, and plans a salad with a vegetable that it has never seen. The FOON never
    goes into the Neo4j that NEO4J_URI names, and loading it again changes nothing.
    """
    from foon_kg.foon import Foon

    say = sayer(quiet=quiet)
    with Foon.on_this_machine(say=say) as foon:
        _load(foon, say)
        result = _planned(foon, say)
    if as_json:
        print_json(result.to_json())
        return
    from foon_kg.formats.views.tree import plan_view

    print_view(plan_view(result))
    say(NEXT)


def _load(foon: Foon, say: Say) -> None:
    subgraphs = demo_subgraphs()
    report = foon.store(subgraphs)
    there = f", {len(report.unchanged)} were there already" if report.unchanged else ""
    say(f"Loaded {len(report.inserted) + len(report.replaced)} of the demo's {len(subgraphs)} subgraphs{there}.")


def demo_subgraphs() -> list[Subgraph]:
    """Read the demo's FOON, sorted by name."""
    from foon_kg.foon.demo import demo_folder
    from foon_kg.loaders import read_paths

    return [result.subgraph for result in read_paths([demo_folder()]) if result.subgraph is not None]


def _planned(foon: Foon, say: Say) -> PlanResult:
    from foon_kg.foon import PlanSettings, Question
    from foon_kg.foon.demo import demo_recipes
    from foon_kg.model.errors import FoonError
    from foon_kg.plans.result import PlanResult

    path = next(path for path in demo_recipes() if path.stem == RECIPE)
    recipe = next(foon.read_recipes(path)).recipe
    say(f"Planning {recipe.title}, from {', '.join(i.object for i in recipe.ingredients)}.\n")
    answer = foon.answer(Question(given=recipe), PlanSettings())
    if not isinstance(answer.outcome, PlanResult):
        raise answer.error or FoonError("the demo has no plan")
    return answer.outcome
