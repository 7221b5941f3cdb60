"""The documentation cannot rot: every command explains itself, and a page shows how to use it."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

from foon_kg import __version__
from foon_kg.cli import app
from foon_kg.cli.console import ErrorsAtTheEdge
from foon_kg.foon.demo import demo_folder
from foon_kg.model.errors import NoTreeError

ROOT = Path(__file__).parents[2]
PAGES = (ROOT / "README.md", *(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "how-to").glob("*.md"))


def commands(group, words=()):
    """Every command that does something, with the words that call it."""
    for name, command in sorted(group.commands.items()):
        if hasattr(command, "commands"):
            yield from commands(command, (*words, name))
        else:
            yield (*words, name), command


@cache
def every_command():
    found = dict(commands(typer.main.get_command(app)))
    assert len(found) > 25
    return found


@cache
def shown(words):
    """Return the help of a command, or of the group that these words name."""
    answer = CliRunner().invoke(app, [*words, "--help"])
    assert answer.exit_code == 0
    return answer.stdout


def test_every_command_and_option_explains_itself():
    helps = {words: (command.help or "").split("\n\n")[0] for words, command in every_command().items()}
    assert {words: text for words, text in helps.items() if not text.endswith((".", ":"))} == {}
    options = [(words, one) for words, command in every_command().items() for one in command.params]
    assert [(words, one.name) for words, one in options if not getattr(one, "help", None)] == []


def test_every_command_has_examples_that_call_it():
    for words, command in every_command().items():
        calls = [line.strip() for line in (command.epilog or "").splitlines() if line.strip().startswith("foon ")]
        assert calls, words
        assert all(" ".join(["foon", *words]) in call for call in calls), words


def test_every_option_in_an_example_exists():
    for words, command in every_command().items():
        known = {option for p in command.params for option in p.opts} | {"-h", "--help"}
        used = set(re.findall(r"(?<=\s)--?[a-z][a-z-]*", command.epilog or ""))
        assert used <= known, words


def test_a_page_shows_how_to_use_every_command():
    text = "\n".join(page.read_text(encoding="utf-8") for page in PAGES)
    called = [" ".join(("foon", *words)) for words in every_command()]
    assert [one for one in called if not re.search(rf"^(?:    )?{one}\b", text, re.MULTILINE)] == []


def test_help_names_what_is_given_and_no_type_of_python():
    for words in every_command():
        assert not re.search(r"<(?:str|int|float|path|Path|list\W|\w+ range)", shown(words)), words
        assert not re.search(r"[{}]|\.\.\.\W*\.\.\.", shown(words).splitlines()[0]), words


def test_help_fits_a_terminal():
    told = [(), ("server",), ("load",), ("evaluate",), *every_command()]
    assert {words: wide for words in told if (wide := max(map(len, shown(words).splitlines()))) > 80} == {}


@pytest.mark.parametrize("words", [(), ("server",), ("load",), ("evaluate",)], ids=" ".join)
def test_the_list_of_commands_cuts_no_sentence(words):
    listed = shown(words).split("--help", 1)[1]
    assert "..." not in listed


def test_help_imports_nothing_heavy():
    program = "import sys; import foon_kg.cli; print(*sorted(sys.modules))"
    loaded = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout.split()
    heavy = {"neo4j", "numpy", "rich", "requests", "psutil", "jgo", "spacy", "foon_kg.planner", "foon_kg.loaders"}
    assert heavy.isdisjoint(loaded)


def test_version_is_printed():
    answer = CliRunner().invoke(app, ["--version"])
    assert (answer.exit_code, answer.stdout) == (0, f"foon-kg {__version__}\n")


def test_an_error_is_one_line_with_its_hint_whatever_it_holds():
    root = typer.Typer(cls=ErrorsAtTheEdge)

    @root.command()
    def fail() -> None:
        raise NoTreeError("no [bold]tree[/bold] for " + "a very long name " * 9, hint="Ask [again].")

    @root.command()
    def other() -> None: ...

    answer = CliRunner().invoke(root, ["fail"])
    assert answer.exit_code == 3
    error, hint = answer.stderr.splitlines()
    assert error == "error: no [bold]tree[/bold] for " + "a very long name " * 9
    assert hint == "hint: Ask [again]."


def test_a_dish_type_is_completed():
    environment = {"_FOON_COMPLETE": "complete_bash", "COMP_WORDS": "foon plan --dish sa", "COMP_CWORD": "3"}
    answer = CliRunner().invoke(app, [], prog_name="foon", env=environment)
    assert answer.stdout.split() == ["sandwich", "sauce", "salad", "sausage"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("module", "words", "extra"),
    [("fastapi", ["serve"], "web"), ("mcp", ["mcp"], "agents"), ("uvicorn", ["serve"], "web")],
)
def test_what_is_not_installed_is_one_line_that_says_how_to_get_it(module, words, extra):
    code = f"import sys; sys.modules[{module!r}] = None; from foon_kg.cli import main; main()"
    call = [sys.executable, "-c", code, *words, "--files", str(demo_folder())]
    ended = subprocess.run(call, capture_output=True, text=True, check=False)
    assert ended.returncode == 2
    assert "Traceback" not in ended.stderr
    assert f"foon-kg[{extra}]" in ended.stderr


def test_the_package_is_a_program_too():
    told = subprocess.run([sys.executable, "-m", "foon_kg", "--version"], capture_output=True, text=True, check=True)
    assert told.stdout == f"foon-kg {__version__}\n"


@pytest.mark.slow
def test_stats_reads_no_foon_and_imports_nothing_that_plans():
    environment = {**os.environ, "NEO4J_URI": "bolt://127.0.0.1:1"}
    program = (
        "import atexit, sys\natexit.register(lambda: print(*(name for name in sys.modules if sys.modules[name])))\n"
        "from foon_kg.cli import main\nsys.argv = ['foon', 'stats']\nmain()"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False, env=environment)
    assert "no Neo4j answers" in done.stderr
    assert {"numpy", "foon_kg.store.snapshot", "foon_kg.food", "foon_kg.planning"}.isdisjoint(done.stdout.split())
