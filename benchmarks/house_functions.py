"""The functions of a house: how complex each is, and what its docstring says. ``benchmarks/house.py`` asks this."""

from __future__ import annotations

import ast
import random
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

DRAWN, SEED = 40, 15
"""So many public functions are drawn for the score of docstrings, by this seed."""

FORKS = (ast.If, ast.For, ast.While, ast.IfExp, ast.ExceptHandler, ast.Assert, ast.match_case)


UNIT_WORDS = re.compile(
    r"second|minute|byte|hour|percent|0 to 1|at most|how many|number of|so many|lines?|rows?|metre|°|ms\b"
)
SOURCE_WORDS = re.compile(r"paper|algorithm [1-4]|Sakib|contract|C\d+|docs/|et al|\b(19|20)\d\d\b")
AT_A_DOOR = re.compile(r"\.(command|callback|get|post|tool)\b|\b(typer|Query|Field)\b|^(Files|Json|Quiet|Request)$")
FIRST_WORD = re.compile(r"^[A-Z][a-z]+\b")


@dataclass(frozen=True)
class Function:
    """A function with where it stands."""

    module: str
    node: ast.FunctionDef | ast.AsyncFunctionDef
    public: bool

    @property
    def lines(self) -> int:
        """Return its lines, from ``def`` to its end."""
        return (self.node.end_lineno or self.node.lineno) - self.node.lineno + 1

    @cached_property
    def complexity(self) -> int:
        """Return 1, and one for each fork, comprehension, condition in one, and further operand of and/or."""
        count = 1
        for node in _inside(self.node):
            count += isinstance(node, FORKS)
            if isinstance(node, ast.comprehension):
                count += 1 + len(node.ifs)
            elif isinstance(node, ast.BoolOp):
                count += len(node.values) - 1
        return count

    def __str__(self) -> str:
        return f"{self.module}:{self.node.lineno} {self.node.name}"


def _inside(function: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes of a function, without those of functions in it."""
    for child in ast.iter_child_nodes(function):
        if not isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            yield child
            yield from _inside(child)


@dataclass(frozen=True)
class Score:
    """What a docstring says of what it ought to; ``None`` where there is nothing to say."""

    function: Function
    said: dict[str, bool | None]


def score(function: Function) -> Score:
    """Return what a function's docstring says: by words that can be found, not by whether they are good ones."""
    text = ast.get_docstring(function.node) or ""
    arguments = [one.arg for one in (*function.node.args.args, *function.node.args.kwonlyargs)]
    # a name that begins with "_" is of an argument that nobody reads: an interface asks for it
    arguments = [one for one in arguments if one not in {"self", "cls"} and not one.startswith("_")]
    numbers = [
        one.arg
        for one in (*function.node.args.args, *function.node.args.kwonlyargs)
        if one.annotation is not None and re.search(r"\b(int|float)\b", ast.unparse(one.annotation))
    ]
    raised = {
        ast.unparse(node.exc).partition("(")[0]
        for node in _inside(function.node)
        if isinstance(node, ast.Raise) and node.exc is not None
    }
    told = text.lower()
    return Score(
        function,
        {
            "purpose": bool(FIRST_WORD.match(text)),
            "arguments": all(_is_told(one, told) for one in arguments)
            if arguments and not _is_asked_from_outside(function.node)
            else None,
            "units": bool(UNIT_WORDS.search(text)) if numbers else None,
            "errors": bool(re.search(r"\braises?\b|refuse|Error", text)) if raised else None,
            "source": bool(SOURCE_WORDS.search(text))
            if re.search(r"search|goals|similarity", function.module)
            else None,
            "example": ">>>" in text,
        },
    )


def _is_asked_from_outside(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Return whether ``function`` is a command, an API path or an agents' tool: its arguments have a help each."""
    asked = (one.annotation for one in (*function.args.args, *function.args.kwonlyargs) if one.annotation is not None)
    return any(AT_A_DOOR.search(ast.unparse(one)) for one in (*function.decorator_list, *asked))


def _is_told(argument: str, text: str) -> bool:
    """Whether a text speaks of an argument: by its name, or by the word that the name is made of."""
    return (
        any(word.rstrip("s") in text for word in argument.strip("_").lower().split("_") if len(word) > 2)
        or argument in text
    )


def scores(functions: Iterable[Function]) -> list[Score]:
    """Return the scores of ``DRAWN`` public ones of ``functions``, the same at each call."""
    public = sorted((one for one in functions if one.public), key=str)
    return [score(one) for one in random.Random(SEED).sample(public, DRAWN)]
