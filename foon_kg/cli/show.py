"""``foon show``: a task tree to look at, in the terminal or as a picture."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from foon_kg.cli.console import Files, Quiet, examples, print_view, sayer
from foon_kg.model.errors import NoTreeError, ReadError, UsageError
from foon_kg.model.written_files import write_file

if TYPE_CHECKING:
    from rich.console import RenderableType

    from foon_kg.formats.views.shown_tree import ShownTree
    from foon_kg.plans.schedule import Schedule
    from foon_kg.plans.step_changes import StepChange

EXAMPLES = examples(
    "foon show plan.json",
    "foon show plan.json --svg --output tree.svg",
    "foon show plans.jsonl --line 3 --html -o tree.html",
    "foon show plan.json --schedule --hands 2 --svg -o schedule.svg",
    "foon show plan.json --difference --files subgraphs/",
    "foon show plan.json --shopping",
    "foon show plan.json --units",
)


def show(
    result: Annotated[
        Path, typer.Argument(metavar="RESULT", help="A plan result (JSON) or FOON text; - is standard input.")
    ],
    *,
    svg: Annotated[bool, typer.Option("--svg", help="Draw the task tree as SVG.")] = False,
    png: Annotated[bool, typer.Option("--png", help="Draw the task tree as PNG.")] = False,
    html: Annotated[bool, typer.Option("--html", help="Make a page that stands on its own.")] = False,
    progress: Annotated[bool, typer.Option("--progress", help="Draw the progress lines instead of the tree.")] = False,
    changes: Annotated[
        bool, typer.Option("--difference", help="What became of the steps of the reference tree.")
    ] = False,
    timetable: Annotated[
        bool, typer.Option("--schedule", help="Who does what when, by the times of the FOON's videos.")
    ] = False,
    hands: Annotated[int, typer.Option("--hands", metavar="N", min=1, help="Pairs of hands for --schedule.")] = 1,
    shopping: Annotated[bool, typer.Option("--shopping", help="What to buy: the kitchen without utensils.")] = False,
    as_units: Annotated[bool, typer.Option("--units", help="Each step as the FOON writes it.")] = False,
    unfold: Annotated[bool, typer.Option("--unfold", help="Draw every utensil and leftover as a node.")] = False,
    line: Annotated[
        int, typer.Option("--line", metavar="N", min=1, help="Which result of a file with many, from 1.")
    ] = 1,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", metavar="FILE", help="Write to this file, not to stdout.")
    ] = None,
    files: Files = None,
    quiet: Quiet = False,
) -> None:
    """Show a task tree.

    Without an option the steps are printed as sentences, and what the FOON has never seen is blue. --units prints what
    goes in, what is done and what comes out: objects plain, states green, motions red. --svg, --png and --html make a
    picture that needs nothing else.

    Only --schedule and --difference ask a FOON (of --files, or the database): for the times at which videos show each
    motion, and for the reference tree.
    """
    forms = [name for name, asked in (("svg", svg), ("png", png), ("html", html)) if asked]
    _at_most_one("forms", [f"--{form}" for form in forms])
    matters = {"progress": progress, "schedule": timetable, "shopping": shopping, "difference": changes}
    matters["units"] = as_units
    _at_most_one("matters", [f"--{matter}" for matter, asked in matters.items() if asked])
    matter = next((matter for matter, asked in matters.items() if asked), "tree")
    if ((shopping or as_units) and forms) or (html and matter != "tree"):
        raise UsageError(f"--{forms[0]} does not show that", hint="A page has the lists; ask for --svg or --png.")
    shown = _Shown(shown_tree(result, line), matter, hands, files, quiet=quiet, folded=not unfold)
    if not forms:
        print_view(shown.printed())
    elif html:
        _write(shown.page().encode(), output)
    else:
        drawn = shown.drawn()
        _write(_pixels(drawn) if png else drawn.encode(), output)


def _at_most_one(what: str, asked: Sequence[str]) -> None:
    if len(asked) > 1:
        raise UsageError(f"{' and '.join(asked)} ask for two {what} at once", hint="Choose one of them.")


def shown_tree(path: Path, line: int = 1) -> ShownTree:
    """Read the tree to look at: the result at ``line`` of a file (``-``: standard input) of JSON, or FOON text.

    Raises ReadError where there is none, and the error of a recipe that has no tree.
    """
    from foon_kg.cli.tree_files import json_values, text_of

    text = text_of(path)
    if not text.lstrip().startswith("{"):
        return _of_text(text, path)
    values = list(json_values(path, text))
    if line > len(values):
        raise UsageError(f"{path} has {len(values)} results, and --line asks for {line}", hint="Count from 1.")
    place, value = values[line - 1]
    return _of_json(value, f"{path}:{place}")


def _of_text(text: str, path: Path) -> ShownTree:
    from foon_kg.formats.views.shown_tree import ShownTree
    from foon_kg.loaders import read_text

    subgraph = read_text(text, path.stem, str(path)).subgraph
    if subgraph is None or not subgraph.annotations:
        raise ReadError(f"{path}: no task tree in it", hint="Give a plan result (JSON) or FOON text.")
    return ShownTree.of_subgraph(subgraph)


def _of_json(value: object, where: str) -> ShownTree:
    from foon_kg.formats.views.shown_tree import ShownTree
    from foon_kg.plans.result import PlanFailure, PlanResult

    if isinstance(value, dict) and "error" in value:
        failure = PlanFailure.from_json(value, where)
        raise NoTreeError(f"{where}: {failure.message}", hint=failure.hint, code=failure.code)
    result = PlanResult.from_json(value, where)
    if not result.units:
        raise ReadError(f"{where}: a result without units is no task tree", hint="Plan the recipe again.")
    return ShownTree.of_result(result)


@dataclass(frozen=True)
class _Shown:
    """A tree and what is asked to be seen of it (its ``matter``)."""

    tree: ShownTree
    matter: str
    hands: int
    files: Sequence[Path] | None
    quiet: bool
    folded: bool

    def printed(self) -> RenderableType:
        from foon_kg.formats.views.schedule import schedule_view, shopping_view
        from foon_kg.formats.views.step_changes import step_changes_view
        from foon_kg.formats.views.tree import progress_view, tree_view
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.plans.shopping import shopping_list

        match self.matter:
            case "schedule":
                return schedule_view(self.tree, self.schedule())
            case "difference":
                return step_changes_view(self.tree, self.difference())
            case "shopping":
                return shopping_view(shopping_list(self.tree.kitchen, Kitchen.default()), tuple(self.tree.unseen))
            case "progress":
                return progress_view(self.tree)
            case _:
                return tree_view(self.tree, as_units=self.matter == "units")

    def drawn(self) -> str:
        with pictures_extra():
            from foon_kg.formats.pictures.gantt import schedule_svg
            from foon_kg.formats.pictures.progress import progress_svg
            from foon_kg.formats.pictures.step_changes import step_changes_svg
            from foon_kg.formats.pictures.tree import tree_svg
            from foon_kg.plans.kitchen import Kitchen

            match self.matter:
                case "schedule":
                    return schedule_svg(self.tree, self.schedule())
                case "difference":
                    return step_changes_svg(self.tree, self.difference())
                case "progress":
                    return progress_svg(self.tree)
                case _:
                    return tree_svg(self.tree, Kitchen.default(), folded=self.folded)

    def page(self) -> str:
        with pictures_extra():
            from foon_kg.formats.pictures.page import page_of
            from foon_kg.plans.kitchen import Kitchen

            return page_of(self.tree, Kitchen.default(), folded=self.folded)

    def schedule(self) -> Schedule:
        from foon_kg.cli.knowledge import whole_foon
        from foon_kg.plans.durations import Durations
        from foon_kg.plans.kitchen import Kitchen
        from foon_kg.plans.schedule import schedule

        foon = whole_foon(self.files, sayer(quiet=self.quiet))
        text = self.tree.units if self.tree.result is None else ()  # of a plan the FOON has all that was seen
        durations = Durations.of_units(foon.units, [(u.motion_node, seen) for u in text for seen in u.seen_in])
        return schedule(self.tree.units, self.tree.kitchen, durations, Kitchen.default(), self.hands)

    def difference(self) -> tuple[StepChange, ...]:
        from foon_kg.cli.knowledge import open_knowledge
        from foon_kg.planning.planner import Planner
        from foon_kg.planning.settings import PlanSettings
        from foon_kg.plans.step_changes import step_changes

        plan = self.tree.result
        if plan is None:
            raise UsageError("FOON text does not say what its reference was", hint="Give a plan result (JSON).")
        with open_knowledge(self.files, sayer(quiet=self.quiet)) as view:
            reference = Planner(view, PlanSettings()).reference_tree(plan.recipe, plan.reference.goal)
        if len(reference) != plan.reference.units:
            told = f"this FOON's reference tree has {len(reference)} steps, and the plan's had {plan.reference.units}"
            raise UsageError(told, hint="Give the FOON from which it was planned, or plan it anew.")
        return step_changes(reference, self.tree.units)


def _pixels(drawn: str) -> bytes:
    with pictures_extra():
        from foon_kg.formats.pictures.png import png_of

        return png_of(drawn)


@contextmanager
def pictures_extra() -> Iterator[None]:
    """Say which extra is missing where a package for pictures is not there."""
    try:
        yield
    except ModuleNotFoundError as error:
        if error.name not in {"fast_sugiyama", "vl_convert"}:
            raise
        message = f"pictures need the package {error.name}"
        raise UsageError(message, hint='Install it with: pip install "foon-kg[pictures]"') from error


def _write(content: bytes, output: Path | None) -> None:
    if output is None:
        if sys.stdout.isatty():
            raise UsageError("a picture is nothing to print on a terminal", hint="Name a file with --output.")
        sys.stdout.buffer.write(content)
        return
    write_file(output, content, "Name another file with --output.")
