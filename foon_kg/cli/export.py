"""``foon export``: task trees and whole FOONs for other programs, for robots and for cooks."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Json, Quiet, Say, examples, sayer
from foon_kg.cli.kitchen import KitchenFile
from foon_kg.cli.retrieve import Weights
from foon_kg.model.errors import UsageError
from foon_kg.model.written_files import write_file, writing

if TYPE_CHECKING:
    from foon_kg.food.motion_costs import MotionCosts
    from foon_kg.foon import Foon
    from foon_kg.formats.exports.files import ExportFile
    from foon_kg.formats.exports.tree import ExportedTree

EXAMPLES = examples(
    "foon export plan.json --format markdown",
    "foon export plan.json --output salad.dot",
    "foon export plans.jsonl --format pddl --output problems/",
    "foon export plan.json --after-step 7 --output rest.xml",
    "foon export --format csv --output import/",
    'foon export --files subgraphs/ --format pddl --goal "greek salad" -o pddl/',
    "foon export --format weights --output motion_cost.json",
)
_FORMATS = ("foon", "json", "dot", "mermaid", "graphml", "markdown", "behaviour-tree", "pddl", "csv", "weights")
_GOES_ON = {"behaviour-tree", "pddl"}
_WEIGHTED = {"graphml", "behaviour-tree", "csv", "weights"}


def _formats(incomplete: str) -> list[str]:
    from foon_kg.model.plugins import EXPORTS, names

    return [name for name in (*_FORMATS, *names(EXPORTS)) if name.startswith(incomplete)]


Tree = Annotated[
    Path | None,
    typer.Argument(
        metavar="FILE",
        help="Task trees: answers of foon plan and foon retrieve (JSON, JSON Lines), FOON text or FOON JSON; - is "
        "standard input. "
        "Without one the whole FOON is exported.",
    ),
]
Form = Annotated[
    str | None,
    typer.Option("--format", "-f", metavar="NAME", help="One of those above.", autocompletion=_formats),
]
Output = Annotated[
    Path | None,
    typer.Option("--output", "-o", metavar="PATH", help="A file, or a folder for several; else standard output."),
]
Goal = Annotated[
    str | None, typer.Option("--goal", metavar="NAME", help="For PDDL of the whole FOON: the dish to be made.")
]
AfterStep = Annotated[
    int | None,
    typer.Option("--after-step", metavar="N", min=1, help="For a robot: go on after step N of a plan (PDDL, XML)."),
]
RecipeFile = Annotated[
    Path | None,
    typer.Option("--recipe", metavar="FILE", help="For Markdown: a recipe (JSON) with a quantity and a unit each."),
]


def export(
    tree: Tree = None,
    *,
    form: Form = None,
    output: Output = None,
    goal: Goal = None,
    kitchen: KitchenFile = None,
    recipe: RecipeFile = None,
    after_step: AfterStep = None,
    weights: Weights = None,
    files: Files = None,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Write task trees, or the whole FOON, for other programs.

    \b
    foon            FOON text; a whole FOON is one file a video
    json            the same as JSON, with nothing lost
    dot             the graph for Graphviz
    mermaid         the graph as a Mermaid flowchart
    graphml         the graph with every field: Gephi, yEd, networkx
    markdown        a tree as a recipe to cook from
    behaviour-tree  a tree for robots: XML of BehaviorTree.CPP 4
    pddl            a planning problem: domain, problem, a tree's plan
    csv             a whole FOON for neo4j-admin database import
    weights         how hard its motions are, for foon load weights

    Plug-ins of other packages add formats for trees.

    Without --format the ending of --output decides. The PDDL of a plan is a real problem: each thing is in one form and
    one place, steps use up and move what they take, and in the end everything is off. With --goal and, as a rule,
    --kitchen, PDDL asks a planner to make a dish from the whole FOON; there nothing is used up.

    With --after-step the first N steps of a plan are done: PDDL begins with what they leave, in the same domain, and a
    behaviour tree has the other steps.

    GraphML, behaviour trees (success rates) and CSV (costs) have the weights of motions, too: those of the graph, or of
    --weights, which a tree needs.

    A plan does not say what moves; a retrieved tree (foon retrieve, --json or --foon) does. FOON text keeps where each
    step was seen, and which motions take any number of foods, which the JSON of a plan does not; it has no numbers of
    things: export a plan's JSON for a behaviour tree with conditions, and for PDDL in which things are used up.
    """  # noqa: D301 - click wants the character itself before lines that it must not join
    say = sayer(quiet=quiet)
    form = _chosen(_one_form(form, as_json=as_json), output)
    _refuse_idle(form, recipe, weights, after_step)
    if tree is not None:
        _refuse({"--goal": goal, "--kitchen": kitchen, "--files": files}, "task trees")
        written = _trees(_read(tree, after_step, say), form, recipe, weights)
    elif form == "pddl":
        _refuse({"--after-step": after_step}, "a whole FOON")
        written = _problem(goal, kitchen, files, say)
    else:
        _refuse({"--goal": goal, "--kitchen": kitchen, "--after-step": after_step}, form)
        written = _whole(form, weights, files, say)
    _write(written, output)
    if form == "csv" and output is not None:
        _tell_import(output, say)


def _one_form(form: str | None, *, as_json: bool) -> str | None:
    """Return the form that is asked by its name or by ``--json``; raises UsageError where these are two."""
    if as_json and form not in {None, "json"}:
        raise UsageError(f"--json and --format {form} ask for two forms", hint="Leave one of them out.")
    return "json" if as_json else form


def _tell_import(folder: Path, say: Say) -> None:
    """Say how the files in a ``folder`` come into a Neo4j."""
    say(f"In {folder}: neo4j-admin database import full neo4j @import.txt, start Neo4j, then")
    say("foon cypher --write - < after.cypher, then foon load foon with any of the files, for the constraints.")


def _refuse_idle(form: str, recipe: Path | None, weights: Path | None, after_step: int | None) -> None:
    """Refuse a recipe, weights or a step for a form that takes nothing of them."""
    if form not in _GOES_ON:
        _refuse({"--after-step": after_step}, form)
    if form != "markdown":
        _refuse({"--recipe": recipe}, form)
    if form not in _WEIGHTED:
        _refuse({"--weights": weights}, form)


def _read(file: Path, after_step: int | None, say: Say) -> list[ExportedTree]:
    """Return the trees of a file, and of them what is left after a step, where one is named."""
    from foon_kg.cli.exported_trees import read_exported_trees

    trees = read_exported_trees(file, say)
    return trees if after_step is None else [tree.after(after_step) for tree in trees]


def _trees(trees: Sequence[ExportedTree], form: str, recipe: Path | None, weights: Path | None) -> list[ExportFile]:
    from foon_kg.cli.exported_trees import amounts_of
    from foon_kg.formats.exports.formats import export_tree

    costs = _costs_of_file(weights)
    return [written for tree in trees for written in export_tree(tree, form, amounts_of(tree, recipe), costs)]


def _costs_of_file(weights: Path | None) -> MotionCosts:
    from foon_kg.food.motion_costs import MotionCosts
    from foon_kg.loaders import read_weights

    return MotionCosts() if weights is None else read_weights(weights)


def _chosen(form: str | None, output: Path | None) -> str:
    from foon_kg.formats.exports.formats import ENDINGS, all_formats

    formats = ENDINGS
    if form not in formats and (form is not None or output is not None):
        formats = all_formats()
    if form is None and output is not None:
        form = next((name for name, endings in formats.items() if output.suffix.lower() in endings), None)
    if form is None:
        raise UsageError("say in which format", hint=f"--format takes {', '.join(formats)}.")
    if form not in formats:
        raise UsageError(f"there is no format “{form}”", hint=f"There are {', '.join(formats)}.")
    return form


def _refuse(asked: dict[str, object], where: str) -> None:
    if given := [option for option, value in asked.items() if value]:
        raise UsageError(f"{' and '.join(given)} means nothing for {where}", hint='See "foon export --help".')


def _whole(form: str, weights: Path | None, files: Sequence[Path] | None, say: Say) -> list[ExportFile]:
    from foon_kg.cli.knowledge import front_door
    from foon_kg.formats.exports.formats import export_foon, weights_file

    if form == "weights" and weights is not None:  # of no FOON
        return [weights_file(_costs_of_file(weights))]
    with front_door(files, say) as foon:
        costs = _stored_costs(foon) if weights is None else _costs_of_file(weights)
        return [weights_file(costs)] if form == "weights" else list(export_foon(foon.snapshot(), form, costs))


def _stored_costs(foon: Foon) -> MotionCosts:
    with foon.reading() as view:
        return view.motion_costs()


def _problem(goal: str | None, kitchen: Path | None, files: Sequence[Path] | None, say: Say) -> list[ExportFile]:
    from foon_kg.cli.kitchen import kitchen_of
    from foon_kg.cli.knowledge import whole_foon
    from foon_kg.foon import Foon
    from foon_kg.formats.exports.formats import pddl_files
    from foon_kg.formats.exports.pddl import foon_to_pddl

    if goal is None:
        raise UsageError("a planning problem of the whole FOON needs a goal", hint='Say --goal "greek salad".')
    foon = whole_foon(files, say)
    at_hand = kitchen_of(kitchen, Foon(foon), say)
    return list(pddl_files(goal, foon_to_pddl(foon, goal, at_hand)))


def _write(files: Sequence[ExportFile], output: Path | None) -> None:
    """Write one file to standard output or where it is told, several into a folder, each under its own name."""
    if output is None:
        if len(files) != 1:
            raise UsageError(f"these are {len(files)} files", hint="Name a folder for them: --output FOLDER.")
        typer.echo(files[0].text, nl=False)
        return
    folder = len(files) > 1 or output.is_dir() or str(output).endswith(os.sep)
    hint = "--output names a file or a folder."
    with writing(output, hint):
        (output if folder else output.parent).mkdir(parents=True, exist_ok=True)
    for name, text in _distinct(files):
        write_file(output / name if folder else output, text, hint)


def _distinct(files: Iterable[ExportFile]) -> Iterator[tuple[str, str]]:
    """Yield names and texts; a name that comes again gets a number, in any writing of its letters."""
    taken: set[str] = set()
    for file in files:
        stem, dot, ending = file.name.rpartition(".")
        name, count = file.name, 1
        while name.lower() in taken:
            count += 1
            name = f"{stem}-{count}{dot}{ending}"
        taken.add(name.lower())
        yield name, file.text
