"""No code for a dish or a food: what algorithms 1 and 4 know of them stands in the tables and in the FOON."""

from __future__ import annotations

import ast
import io
import re
import tokenize
import tomllib
from functools import cache
from pathlib import Path

import pytest

import foon_kg

PACKAGE = Path(foon_kg.__file__).parent
AROUND = {"batch", "cluster", "kitchen_file", "processes", "recipes"}
"""What runs and reads around the planner: words of computing, and no algorithm of the paper."""

MODULES = sorted(
    path
    for room in ("integration", "goals", "planning")
    for path in (PACKAGE / room).rglob("*.py")
    if path.stem not in AROUND
)
SHORTEST = 3

EXCEPTED = {
    "what a cook owes to a food, and nothing to eat": {"core", "husk", "peel", "shell", "stone"},
    "motions, what a motion does, and the role of a utensil": {"bake", "chop", "melt", "mix", "wrap"},
    "states in which foods are sold or come": {"jelly", "juice", "paste", "powder", "sauce"},
    "traits, which the table gives to foods of many kinds": {
        "batter", "dough", "egg", "fat", "flour", "herb", "leaven", "remains", "spice", "stock", "sweet", "topping",
    },
    "what is called so has no name of its own": {"mixture"},
    "the free food: C5 of the contract": {"water"},
    "the widest kind of what is cut": {"vegetable"},
    "an example in a message": {"onion"},
}  # fmt: skip
"""Words of foods and dishes that the code has all the same, and what they mean there."""

ALLOWED = frozenset().union(*EXCEPTED.values())


@cache
def food_words():
    """Every name of a food, a kind of food or a dish that the tables list."""
    foods = tomllib.loads((PACKAGE / "food" / "foods.toml").read_text(encoding="utf-8"))
    dishes = tomllib.loads((PACKAGE / "food" / "dishes.toml").read_text(encoding="utf-8"))
    names = {*foods["foods"], *foods["kinds"], *dishes["dishes"]}
    names |= {word.lstrip("*") for row in foods["kinds"].values() for word in row.get("words", ())}
    return frozenset(name for name in names if len(name) >= SHORTEST)


@cache
def pattern():
    longest_first = sorted(map(re.escape, food_words()), key=lambda name: (-len(name), name))
    return re.compile(rf"(?<![a-z])({'|'.join(longest_first)})(?:e?s)?(?![a-z])")


def told_in(source):
    """Yield each string literal and identifier with its line; docstrings and comments apart."""
    tree = ast.parse(source)
    constants = (node.value for node in ast.walk(tree) if isinstance(node, ast.Expr))
    documents = [node for node in constants if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    apart = {line for node in documents for line in range(node.lineno, (node.end_lineno or node.lineno) + 1)}
    kinds = {tokenize.STRING, tokenize.NAME, getattr(tokenize, "FSTRING_MIDDLE", tokenize.STRING)}
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type in kinds and token.start[0] not in apart:
            yield token.start[0], token.string


@cache
def foods_of(text):
    """Return the words of foods and dishes in a literal or a name: most stand a hundred times in the code."""
    return [match[1] for match in pattern().finditer(text.replace("_", " ").lower())]


@cache
def foods_in(source):
    """Return the words of foods and dishes in a module: (line, word)."""
    return [(line, word) for line, text in told_in(source) for word in foods_of(text)]


def test_no_food_and_no_dish_stands_in_the_code():
    told = [(path, *found) for path in MODULES for found in foods_in(path.read_text(encoding="utf-8"))]
    assert [(str(path), line, word) for path, line, word in told if word not in ALLOWED] == []


def test_every_exception_is_needed():
    there = {word for path in MODULES for _, word in foods_in(path.read_text(encoding="utf-8"))}
    assert ALLOWED - there == set()


def test_all_rooms_are_looked_at():
    assert {path.relative_to(PACKAGE).parts[0] for path in MODULES} == {"integration", "goals", "planning"}
    assert len(food_words()) > 2000


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("if dish == 'omelette': pass", ["omelette"]),
        ("def boil_potatoes(): pass", ["potatoes"]),
        ("SALADS = 1", ["salad"]),
        ("told = f'a {x} of tomatoes'", ["tomato"]),
        ("is_spiced_like('red kidney bean')", ["kidney bean"]),
        ("# a salad\nx = 1", []),
        ('def f():\n    """Return a salad."""\n', []),
        ("X = 1\n'''A salad.'''", []),
        ("plain = explained(appleton)", []),
        ("parsnips_and_leeks = None", ["parsnip", "leek"]),
    ],
)
def test_words_are_found_in_literals_and_names_alone(source, words):
    assert [word for _, word in foods_in(source)] == words
