"""Commands, page and agents call the front door: no module of theirs opens a database or runs an algorithm itself."""

from __future__ import annotations

import ast
import inspect
import re
from importlib import import_module
from pathlib import Path

import pytest

import foon_kg
from foon_kg import Foon, Kitchen, Plan, Recipe, Step, foon
from foon_kg.foon import Drafting, Evaluation, Recipes, ThisMachine
from foon_kg.model.knowledge import Neighbour
from foon_kg.planning.suggestion import Suggestion
from foon_kg.validation import Report

PACKAGE = Path(__file__).parents[2] / "foon_kg"
AT_THE_DOOR = sorted([*(PACKAGE / "cli").rglob("*.py"), *(PACKAGE / "web").rglob("*.py")])

VALUES = {
    "model", "food", "foon", "formats", "docs", "plans", "cypher", "loaders", "cli", "web",
    "validation.contract",
}  # fmt: skip
"""What a question is made of and an answer is told with: values, tables, files, forms of telling."""

ALLOWED = {
    "planning.batch": {"cores"},
    "planning.processes": None,  # how processes begin and end: nothing of a FOON
    "validation": None,  # the judge: it knows nothing of planning, and is asked of trees of anybody
}
"""Names of other rooms that anybody at the door may use; ``None``: all."""

ROOMS_OF_THEIR_OWN = {
    "cli.evaluate_videos": "evaluation.video_line",  # a line of the file of answers
    "web.plan_answer": "language.plain_lines",
}
"""Which modules at the door (all that begin so) have a room besides, or several."""


def runs(tree):
    """Yield the imports of a module that are done when it runs: those for types are of what the door returns."""
    hidden = {
        id(node)
        for branch in ast.walk(tree)
        if isinstance(branch, ast.If) and ast.unparse(branch.test) == "TYPE_CHECKING"
        for node in ast.walk(branch)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and id(node) not in hidden and (node.module or "").startswith("foon_kg."):
            yield from ((node.module.removeprefix("foon_kg."), alias.name) for alias in node.names)


def may(own, module, name):
    if any(module == one or module.startswith(f"{one}.") for one in VALUES):
        return True
    for there in (module, f"{module}.{name}"):
        if there in ALLOWED and (ALLOWED[there] is None or name in ALLOWED[there]):
            return True
    return any(own.startswith(who) and f"{module}.{name}".startswith(room) for who, room in ROOMS_OF_THEIR_OWN.items())


def named(path):
    return ".".join(path.relative_to(PACKAGE).with_suffix("").parts).removesuffix(".__init__")


def test_a_module_at_the_door_calls_nothing_behind_it():
    beyond = [
        f"{named(path)}: {module}.{name}"
        for path in AT_THE_DOOR
        for module, name in runs(ast.parse(path.read_text(encoding="utf-8")))
        if not may(named(path), module, name)
    ]
    assert beyond == [], "ask foon_kg.foon.Foon, and give it a method where it has none"


def test_what_is_behind_the_door_is_found():
    deep = ast.parse("from foon_kg.store.graph import Connection\nfrom foon_kg.search import retrieve")
    assert [may("cli.recipes", module, name) for module, name in runs(deep)] == [False, False]


def public(owner):
    return [
        (name, value)
        for name, value in inspect.getmembers_static(owner)
        if not name.startswith("_") and (callable(value) or isinstance(value, property | classmethod | staticmethod))
    ]


NO_EXAMPLE = {"on_this_machine", "start_server", "stop_server", "import_offline", "stage"}
"""They start, or replace, what whoever runs the examples has."""

QUESTIONS = ("plan", "answer", "answers", "similar", "retrieve", "suggest", "suggestions", "kitchen")
"""The methods that a user's own questions are asked by."""

ASKED_WITH = ("Answer", "Explanation", "PlanSettings", "Question", "ReadKitchen", "RetrievalResult", "Substitute")
"""What they take and return, of the names of ``foon_kg.foon``."""

OF_OTHERS = {
    "Any", "DataFrame", "DiGraph", "Iterable", "Iterator", "JsonObject", "Literal", "Mapping", "None", "Paths",
    "Sequence",
}  # fmt: skip
"""Names of Python, of other packages, and what is a dictionary of JSON or a path by another name."""


def has_example(value):
    return ">>> " in (inspect.getdoc(value) or "")


OWNERS = (Foon, Plan, Recipes, Drafting, Evaluation, ThisMachine)

of_each = pytest.mark.parametrize("owner", OWNERS, ids=lambda owner: owner.__name__)


@of_each
def test_every_public_name_has_an_example(owner):
    names = public(owner)
    assert len(names) > 4
    assert [name for name, value in names if not has_example(value) and name not in NO_EXAMPLE] == []


def test_what_is_asked_with_and_answered_has_an_example():
    known = [Kitchen, Recipe, Step, Neighbour, Report, Suggestion, *(getattr(foon, name) for name in ASKED_WITH)]
    assert [one.__name__ for one in known if not has_example(one)] == []
    makers = [Kitchen.default, Kitchen.with_foods, Kitchen.with_utensils]
    assert [one.__name__ for one in makers if not has_example(one)] == []


def test_what_a_question_takes_and_returns_is_in_the_reference():
    questions = [getattr(Foon, name) for name in QUESTIONS]
    questions += [getattr(value, "fget", None) or getattr(value, "func", value) for _, value in public(Plan)]
    said = {
        word for one in questions for told in one.__annotations__.values() for word in re.findall(r"\b[A-Z]\w+", told)
    }
    reference = (PACKAGE.parent / "docs" / "reference" / "python.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"autoclass:: [\w.]+\.(\w+)", reference))
    assert len(listed) > 15
    assert said - listed - OF_OTHERS == set()


@of_each
def test_every_argument_at_the_door_is_told(owner):
    """Each parameter of a public method is named in its docstring, or in that of the class where it is made."""
    missing = []
    for name, value in public(owner):
        function = value.__func__ if isinstance(value, classmethod | staticmethod) else value
        if isinstance(function, property):
            continue
        told = inspect.getdoc(value) or ""
        arguments = [one for one in inspect.signature(function).parameters if one not in {"self", "cls"}]
        missing += [f"{name}({one})" for one in arguments if one not in told]
    assert missing == []


def test_the_names_at_the_door_are_there_and_documented():
    for name in foon_kg.__all__:
        assert getattr(foon_kg, name) is not None
        assert name == "__version__" or inspect.getdoc(getattr(foon_kg, name))


def test_the_errors_are_one_tree_that_its_module_draws():
    errors = import_module("foon_kg.model.errors")
    classes = [one for _, one in inspect.getmembers(errors, inspect.isclass) if one.__module__ == errors.__name__]
    assert all(issubclass(one, errors.FoonError) for one in classes)
    assert [one.__name__ for one in classes if one.__name__ not in (errors.__doc__ or "")] == []
