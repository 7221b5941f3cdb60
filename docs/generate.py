"""Write what documents show of foon-kg from foon-kg itself: commands, the outputs of the notebook, a plan, counts.

python docs/generate.py          # writes the files
python docs/generate.py --check  # exits with 1 where one of them says something else
"""

from __future__ import annotations

import argparse
import ast
import io
import json
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import redirect_stdout
from itertools import zip_longest
from pathlib import Path
from typing import Any

import typer
from rich.console import Console

from foon_kg import Foon
from foon_kg.cli import app
from foon_kg.foon.demo import demo_folder, demo_recipes
from foon_kg.formats.views.tree import plan_view
from foon_kg.model.errors import FoonError
from foon_kg.planning.batch import Question
from foon_kg.planning.settings import PlanSettings
from foon_kg.plans.result import PlanResult

TARGET = Path(__file__).parent / "reference" / "commands.md"
NOTEBOOK = Path(__file__).parent / "how-to" / "notebook.ipynb"
PICTURE = Path(__file__).parent / "plan.svg"
HOUSE = Path(__file__).parent / "explanation" / "house.md"
MEASURE = Path(__file__).parents[1] / "benchmarks" / "house.py"
FIGURE = 52
"""Where in a line of that program a figure begins."""

NUMBER = re.compile(r"\d[\d,]*(?:\.\d+)?")
NEAR = 0.05
"""So far from what is counted a figure that documents tell may be, as a share of it."""

HEAD = """# Commands

Every command as it describes itself; `foon COMMAND --help` says the same. This page is written by
`python docs/generate.py`.

## Exit codes

| code | means | `error.code` of `--json` is, for instance |
|---|---|---|
{exit_codes}

Of many recipes the exit code is the highest. Ctrl-C ends a command with 130; what it had written whole stays.
"""
EXIT_CODES = {
    0: "done",
    1: "failed; of `foon check`: a tree is not accepted; of `foon doctor`: something will not work",
    2: "wrong usage: the question cannot be read as asked",
    3: "the question is fine, and there is no tree: the answer says why and what is missing",
}
"""What an exit code means, for all commands alike."""


def described(command: Any, path: tuple[str, ...]) -> Iterator[str]:  # noqa: ANN401 - typer has a click of its own
    """Yield the lines of a command and of those below it."""
    below = getattr(command, "commands", None)
    if below is not None:
        for name, one in below.items():
            yield from described(one, (*path, name))
        return
    context = command.context_class(command, info_name=" ".join(path))
    yield from ("", f"## {' '.join(path)}", "")
    yield from ("```text", command.get_usage(context).removeprefix("Usage: "), "```", "")
    yield " ".join(line.strip() for line in (command.help or "").split("\n\n")[0].split("\n"))
    for paragraph in (command.help or "").split("\n\n")[1:]:
        yield from ("", " ".join(line.strip() for line in paragraph.replace("\b", "").split("\n")))
    rows = [row for option in command.params if (row := option.get_help_record(context)) is not None]
    if rows:
        yield from ("", "| option | what it does |", "|---|---|")
        for names, text in rows:
            yield f"| `{names.replace('|', chr(92) + '|')}` | {' '.join(text.split()).replace('|', chr(92) + '|')} |"
    examples = [line.strip() for line in (command.epilog or "").replace("\b", "").splitlines() if "foon " in line]
    if examples:
        yield from ("", "```sh", *examples, "```")


def exit_codes() -> str:
    """Return the rows of the table of exit codes; whose errors end with which they know themselves."""
    errors: list[type[FoonError]] = [FoonError, *every(FoonError)]
    return "\n".join(
        f"| {code} | {means} | {', '.join(sorted({f'`{one.code}`' for one in errors if one.exit_code == code}))} |"
        for code, means in EXIT_CODES.items()
    )


def every(kind: type[FoonError]) -> Iterator[type[FoonError]]:
    """Yield the errors below ``kind`` that foon_kg.model.errors names."""
    for below in kind.__subclasses__():
        if below.__module__ == kind.__module__:
            yield below
            yield from every(below)


def document() -> str:
    """Return the whole page."""
    return HEAD.format(exit_codes=exit_codes()) + "\n".join(described(typer.main.get_command(app), ("foon",))) + "\n"


def notebook() -> str:
    """Return the notebook with the outputs that its cells have today, as Jupyter writes it."""
    value = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
    names: dict[str, Any] = {}
    for count, cell in enumerate((cell for cell in value["cells"] if cell["cell_type"] == "code"), start=1):
        cell |= {"execution_count": count, "outputs": list(_outputs("".join(cell["source"]), names, count))}
    return json.dumps(value, indent=1, sort_keys=True, ensure_ascii=False) + "\n"


def _outputs(source: str, names: dict[str, Any], count: int) -> Iterator[dict[str, Any]]:
    """Run a cell with ``names``; yield what it prints and, where it ends with an expression, how its value is shown."""
    body = ast.parse(source).body
    end = body.pop() if isinstance(body[-1], ast.Expr) else None
    last = ast.Expression(end.value) if isinstance(end, ast.Expr) else None
    with redirect_stdout(io.StringIO()) as printed:
        exec(compile(ast.Module(body, []), "notebook", "exec"), names)  # noqa: S102 - the cells are our own
        shown = None if last is None else eval(compile(last, "notebook", "eval"), names)  # noqa: S307 - the same
    if printed.getvalue():
        yield {"output_type": "stream", "name": "stdout", "text": printed.getvalue().splitlines(keepends=True)}
    if shown is not None:
        data = {"text/plain": repr(shown).splitlines(keepends=True)}
        if hasattr(shown, "_repr_html_"):
            data["text/html"] = shown._repr_html_().splitlines(keepends=True)
        yield {"output_type": "execute_result", "execution_count": count, "data": data, "metadata": {}}


def picture() -> str:
    """Return what ``foon plan courgette_salad.json`` shows at a terminal, as a picture that fetches no fonts."""
    recipe = next(path for path in demo_recipes() if path.stem == "courgette_salad")
    answer = Foon.from_files(demo_folder()).answer(Question(recipe), PlanSettings())
    if not isinstance(answer.outcome, PlanResult):
        raise SystemExit("the salad of the README is not planned any more")
    console = Console(record=True, width=92, file=io.StringIO(), force_terminal=True, color_system="truecolor")
    console.print(plan_view(answer.outcome))
    drawn = console.export_svg(title=f"foon plan {recipe.name}", unique_id="plan")
    return re.sub(r"@font-face \{.*?\}\s*", "", drawn, flags=re.DOTALL)


def house() -> str:
    """Return the page of the house with the figures and the way of a recipe that benchmarks/house.py finds today."""
    page = HOUSE.read_text(encoding="utf-8")
    for line in _measured():
        name, figure = line[:FIGURE].strip(), line[FIGURE:].strip()
        row = re.compile(rf"^(\| {re.escape(name)} \| [^|]* \| )[^|]*( \|)$", re.MULTILINE)
        page = row.sub(rf"\g<1>{figure}\g<2>", page)
    way = "\n".join(("```text", *_measured("--way"), "```"))
    return re.sub(r"```text\nfoon_kg\.cli:main\n.*?```", lambda _: way, page, flags=re.DOTALL)


def _measured(*options: str) -> list[str]:
    done = subprocess.run([sys.executable, MEASURE, *options], capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


def far_off(told: str, found: str) -> list[str]:
    """Return the lines of a page as ``found`` that ``told`` has otherwise, or whose numbers are a twentieth off.

    A count that grows with every change need not be written anew with each; what is drawn by lot (a sample of 40
    docstrings) is not compared.
    """
    pairs = zip_longest(told.splitlines(), found.splitlines(), fillvalue="")
    return [new for old, new in pairs if not new.startswith("| docstrings of ") and not _near(old, new)]


def _near(old: str, new: str) -> bool:
    first, second = ([float(one.replace(",", "")) for one in NUMBER.findall(line)] for line in (old, new))
    alike = all(abs(one - other) <= NEAR * other for one, other in zip(first, second, strict=False))
    return alike and NUMBER.sub("", old) == NUMBER.sub("", new)


WRITTEN = {TARGET: document, NOTEBOOK: notebook, PICTURE: picture}


def main() -> int:
    """Write the files, or compare them."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    check = parser.parse_args().check
    old = [path for path, made in WRITTEN.items() if path.read_text(encoding="utf-8") != made()]
    figures = house()
    if far_off(HOUSE.read_text(encoding="utf-8"), figures):
        old.append(HOUSE)
    elif not check:
        HOUSE.write_text(figures, encoding="utf-8")
    for path in old:
        if check:
            print(f"docs/{path.relative_to(Path(__file__).parent)} is old: run python docs/generate.py")
        else:
            path.write_text(figures if path == HOUSE else WRITTEN[path](), encoding="utf-8")
    return 1 if check and old else 0


if __name__ == "__main__":
    sys.exit(main())
