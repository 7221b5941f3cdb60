"""The documents say what is so: their commands are commands, their examples run, their links lead somewhere."""

from __future__ import annotations

import importlib.util
import json
import re
import shlex
from pathlib import Path

import pytest
import typer
from typer.exceptions import TyperException
from typer.testing import CliRunner

from foon_kg import Foon
from foon_kg.cli import app

ROOT = Path(__file__).parents[2]
PAGES = sorted([ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "SECURITY.md", *(ROOT / "docs").rglob("*.md")])
MOST_LINES = 120
FOON = typer.main.get_command(app)


def blocks(page, language):
    return re.findall(rf"```{language}\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)


def commands():
    for page in PAGES:
        for block in blocks(page, "sh"):
            for line in block.replace("\\\n", " ").splitlines():
                if line.startswith("foon "):
                    yield page.stem, line


def parsed(line):
    """Return what is left of the words of a command once its options are read; raises where one is unknown."""
    lexer = shlex.shlex(line, posix=True, punctuation_chars="<>|")
    lexer.whitespace_split = True
    words = []
    for word in lexer:
        if word[0] in "<>|":
            break
        words.append(word)
    command, names = FOON, words[:1]
    rest = words[1:]
    while getattr(command, "commands", None) is not None and rest and rest[0] in command.commands:
        names.append(rest[0])
        command, rest = command.commands[rest[0]], rest[1:]
    context = command.context_class(command, info_name=" ".join(names))
    return command.make_parser(context).parse_args(args=list(rest))[1], command


def wrong_with(line):
    """Return why a line is no command of ours; nothing where it is one."""
    try:
        left, command = parsed(line)
    except TyperException as error:
        return str(error)
    if getattr(command, "commands", None) is not None and line.split()[1:2] != ["--help"]:
        return "there is no such command"
    takes = any(one.param_type_name == "argument" for one in command.params)
    return "takes no arguments" if left and not takes else ""


def test_a_command_in_the_documents_is_one():
    told = list(commands())
    assert len(told) > 100
    assert [(page, line, wrong) for page, line in told if (wrong := wrong_with(line))] == []


@pytest.mark.parametrize("line", ["foon plam --dish salad", "foon server stop it", "foon stats now"])
def test_a_command_that_is_none_is_found(line):
    assert wrong_with(line)


@pytest.mark.parametrize("line", ["foon plan --dish salad --xyzzy", "foon stats --json --limit 3"])
def test_an_option_that_is_none_is_found(line):
    with pytest.raises(Exception, match="No such option"):
        parsed(line)


@pytest.mark.slow
@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "python")], ids=lambda page: page.stem)
def test_the_python_of_a_page_runs(page, capfd):  # a process that an example starts writes to real files
    for example in blocks(page, "python"):
        exec(compile(example, page.name, "exec"), {})
    assert capfd.readouterr().out


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "py")], ids=lambda page: page.stem)
def test_python_for_what_is_not_installed_here_is_python(page):
    for example in blocks(page, "py"):
        assert compile(example, page.name, "exec").co_code


@pytest.fixture(scope="module")
def generate():
    spec = importlib.util.spec_from_file_location("generate", ROOT / "docs" / "generate.py")
    generate = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(generate)
    return generate


def test_the_page_of_commands_says_what_they_say(generate):
    assert generate.TARGET.read_text(encoding="utf-8") == generate.document(), "run python docs/generate.py"


@pytest.mark.slow
def test_the_figures_of_the_house_are_those_of_today(generate):
    told = generate.HOUSE.read_text(encoding="utf-8")
    assert generate.far_off(told, generate.house()) == [], "run python docs/generate.py"


@pytest.mark.parametrize(
    ("told", "found", "off"),
    [
        ("| modules | 312 | 597 |", "| modules | 312 | 601 |", False),
        ("| modules | 312 | 500 |", "| modules | 312 | 601 |", True),
        ("| circles | 1 | 0 |", "| circles | 1 | 1 |", True),
        ("foon_kg.cli:main", "foon_kg.cli:run", True),
        (
            "| docstrings of 40: example | 0 of 40 | 3 of 40 |",
            "| docstrings of 40: example | 0 of 40 | 9 of 40 |",
            False,
        ),
        ("one line", "one line\nand another", True),
    ],
)
def test_a_figure_that_is_far_off_is_found(generate, told, found, off):
    assert bool(generate.far_off(told, found)) is off


@pytest.mark.slow
def test_the_notebook_runs_and_shows_what_its_cells_answer(generate):
    assert generate.NOTEBOOK.read_text(encoding="utf-8") == generate.notebook(), "run python docs/generate.py"


def test_the_cells_of_the_notebook_use_the_front_door_and_link_to_pages(generate):
    cells = json.loads(generate.NOTEBOOK.read_text(encoding="utf-8"))["cells"]
    code = "".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")
    methods = {name for name in dir(Foon) if not name.startswith("_") and callable(getattr(Foon, name))}
    assert {"plan", "similar", "retrieve", "suggest"} <= {name for name in methods if f"foon.{name}(" in code}
    links = re.findall(r"\]\(([^)]+)\)", "".join("".join(cell["source"]) for cell in cells))
    assert links
    assert [link for link in links if not (generate.NOTEBOOK.parent / link).exists()] == []


def test_every_command_is_on_the_page_of_commands():
    told = (ROOT / "docs" / "reference" / "commands.md").read_text(encoding="utf-8")
    listed = re.findall(r"^  ([a-z]+)  ", CliRunner().invoke(app, ["--help"]).output, re.MULTILINE)
    assert len(listed) > 15
    assert [name for name in listed if f"## foon {name}" not in told] == []


def prose(page):
    return re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)


def anchors(page):
    """The headings of a page as links name them."""
    heads = re.findall(r"^#+ (.+)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.strip().lower()).replace(" ", "-") for head in heads}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_links_between_pages_lead_somewhere(page):
    for target, anchor in re.findall(r"\]\((?!https?:)([^)#\s]*)(?:#([^)\s]*))?\)", prose(page)):
        there = page.parent / target if target else page
        assert there.exists(), f"{page.name}: {target}"
        assert not anchor or anchor in anchors(there), f"{page.name}: {target}#{anchor}"


def test_every_page_is_in_a_table_of_contents():
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    pages = {str(page.relative_to(ROOT / "docs").with_suffix("")) for page in PAGES if (ROOT / "docs") in page.parents}
    assert [
        page for page in sorted(pages - {"index"}) if not re.search(rf"^{re.escape(page)}$", index, re.MULTILINE)
    ] == []


def test_readme_can_be_read_at_once():
    assert len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()) <= MOST_LINES
