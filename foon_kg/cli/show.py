"""``foon show``: a task tree to look at, in the terminal or as a picture."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from foon_kg.cli.console import Files, Json, Quiet, examples, json_line, print_json, print_view
from foon_kg.cli.shown import Shown, pixels
from foon_kg.model.errors import NoTreeError, ReadError, UsageError
from foon_kg.model.nodes import name_of_file
from foon_kg.model.written_files import write_file

if TYPE_CHECKING:
    from foon_kg.formats.views.shown_tree import ShownTree

EXAMPLES = examples(
    "foon show plan.json",
    "foon show plan.json --output tree.svg",
    "foon show plans.jsonl --line 3 -o tree.html",
    "foon show plan.json --schedule --hands 2 -o schedule.svg",
    "foon show plan.json --difference --files subgraphs/",
    "foon show plan.json --shopping",
    "foon show plan.json --units",
    "foon show plan.json --format png > tree.png",
)

FORMS = ("svg", "png", "html", "json")


def show(
    result: Annotated[
        Path,
        typer.Argument(
            metavar="RESULT", help="A result of foon plan or foon retrieve (JSON), or FOON text; - is standard input."
        ),
    ],
    *,
    form: Annotated[
        Literal["svg", "png", "html", "json"] | None,
        typer.Option("--format", "-f", help="A picture, a page, or JSON; else the ending of --output says."),
    ] = None,
    svg: Annotated[bool, typer.Option("--svg", help="The same as --format svg.")] = False,
    png: Annotated[bool, typer.Option("--png", help="The same as --format png.")] = False,
    html: Annotated[bool, typer.Option("--html", help="The same as --format html: a page that stands on its own.")] = (
        False
    ),
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
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Show a task tree.

    Without an option the steps are printed as sentences, and what the FOON has never seen is blue. --units prints what
    goes in, what is done and what comes out: objects plain, states green, motions red. SVG, PNG and HTML are pictures
    that need nothing else.

    Only --schedule and --difference ask a FOON (of --files, or the database): for the times at which videos show each
    motion, and for the reference tree.
    """
    chosen = _form(form, {"svg": svg, "png": png, "html": html}, output)
    if hands > 1 and not timetable:
        raise UsageError("--hands is for --schedule", hint="Add --schedule, or leave it out.")
    matters = {"progress": progress, "schedule": timetable, "shopping": shopping, "difference": changes}
    matter = _matter(matters | {"units": as_units})
    if as_json or chosen == "json":
        chosen = _only_json(chosen)
    elif chosen:
        _refuse_undrawn(matter, chosen)
    shown = Shown(shown_tree(result, line), matter, hands, files, quiet=quiet, folded=not unfold)
    _tell(shown, chosen, output)


def _tell(shown: Shown, form: str | None, output: Path | None) -> None:
    match form:
        case None:
            print_view(shown.printed())
        case "json" if output is None:
            print_json(shown.as_json())
        case "json":
            _write(f"{json_line(shown.as_json())}\n".encode(), output)
        case "html":
            _write(shown.page().encode(), output)
        case "png":
            _write(pixels(shown.drawn()), output)
        case _:
            _write(shown.drawn().encode(), output)


def _matter(asked: Mapping[str, bool]) -> str:
    """Return the one matter of a tree that is asked for, else the tree; raises UsageError where several are."""
    matters = [matter for matter, is_asked in asked.items() if is_asked]
    _at_most_one("matters", [f"--{matter}" for matter in matters])
    return matters[0] if matters else "tree"


def _refuse_undrawn(matter: str, form: str) -> None:
    """Refuse a picture of what has none, or a page of a matter alone: it has them all."""
    if matter in {"shopping", "units"} or (form == "html" and matter != "tree"):
        raise UsageError(f"--{form} does not show that", hint="A page has the lists; ask for --svg or --png.")


def _form(form: str | None, short: Mapping[str, bool], output: Path | None) -> str | None:
    """Return the form that is asked for by its name or in ``short``, else the ending of the file.

    Raises UsageError where two are asked for, and where the ending says none.
    """
    forms = {"--format": form} if form else {}
    forms |= {f"--{name}": name for name, is_asked in short.items() if is_asked}
    if len(set(forms.values())) > 1:
        _at_most_one("forms", list(forms))
    if forms or output is None:
        return next(iter(forms.values()), None)
    ending = output.suffix.lower().removeprefix(".")
    if ending not in FORMS:
        raise UsageError(f"{output}: its ending says no form", hint=f"Say --format {', '.join(FORMS)}.")
    return ending


def _only_json(form: str | None) -> str:
    if form not in {None, "json"}:
        _at_most_one("forms", ["--json", f"--{form}"])
    return "json"


def _at_most_one(what: str, asked: Sequence[str]) -> None:
    if len(asked) > 1:
        raise UsageError(f"{' and '.join(asked)} ask for two {what} at once", hint="Choose one of them.")


def shown_tree(path: Path, line: int = 1) -> ShownTree:
    """Return the tree to look at: the result at ``line`` of the file at ``path`` (``-``: standard input), or FOON text.

    The file has JSON, one result or a line each. Raises ReadError where there is none, UsageError where none is
    at ``line``, and the error of a recipe that has no tree.
    """
    from foon_kg.cli.tree_files import json_values, text_of

    text = text_of(path)
    if not text.lstrip().startswith("{"):
        if line > 1:
            raise UsageError(f"{path} is no file with many results, and --line asks for {line}", hint="Leave it out.")
        return _of_text(text, path)
    values = list(json_values(path, text))
    if line > len(values):
        raise UsageError(f"{path} has {len(values)} results, and --line asks for {line}", hint="Count from 1.")
    place, value = values[line - 1]
    return _of_json(value, f"{path}:{place}")


def _of_text(text: str, path: Path) -> ShownTree:
    from foon_kg.formats.views.shown_tree import ShownTree
    from foon_kg.loaders import read_text

    subgraph = read_text(text, name_of_file(path), str(path)).subgraph
    if subgraph is None or not subgraph.annotations:
        raise ReadError(f"{path}: no task tree in it", hint="Give a plan result (JSON) or FOON text.")
    return ShownTree.of_subgraph(subgraph)


def _of_json(value: object, where: str) -> ShownTree:
    from foon_kg.cli.tree_files import is_retrieved
    from foon_kg.foon import RetrievalResult
    from foon_kg.formats.views.shown_tree import ShownTree
    from foon_kg.model.json_fields import Fields
    from foon_kg.plans.result import PlanResult

    if isinstance(value, dict) and "error" in value:
        error = Fields(value, where).nested("error")
        hint = error.optional_text("hint") or ""
        raise NoTreeError(f"{where}: {error.text('message')}", hint=hint, code=error.text("code"))
    if is_retrieved(value):
        retrieved = RetrievalResult.from_json(value, where)
        return ShownTree.of_subgraph(retrieved.to_subgraph(), retrieved.goal)
    result = PlanResult.from_json(value, where)
    if not result.units:
        raise ReadError(f"{where}: a result without units is no task tree", hint="Plan the recipe again.")
    return ShownTree.of_result(result)


def _write(content: bytes, output: Path | None) -> None:
    if output is None:
        if sys.stdout.isatty():
            raise UsageError("a picture is nothing to print on a terminal", hint="Name a file with --output.")
        sys.stdout.buffer.write(content)
        return
    write_file(output, content, "Name another file with --output.")
