"""What a reader is given: the words that say what to do, and the trees, printed alike whoever made them.

Identifiers of recipes, names of videos, times, evidence and origins of units are not printed, because they tell which
program it was; nor are amounts, which nobody judges. The title is: it says what was asked.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from foon_kg.evaluation.reading import read_text
from foon_kg.model import ObjectNode, Recipe, RequiredIngredient
from foon_kg.model.claims import Substitution
from foon_kg.model.errors import ReadError
from foon_kg.model.tree import Step, TaskTree


def words_in(path: Path) -> str:
    """Return what a reader is told: the quoted lines (``>``) of the Markdown file ``path``, without their marks.

    Raises ReadError where the file cannot be read or quotes nothing.
    """
    quoted = [line[1:].strip() for line in read_text(path).splitlines() if line.startswith(">")]
    if not any(quoted):
        raise ReadError(f"{path}: nothing is quoted in it", hint="Mark the words for the reader with “>”.")
    return "\n".join(quoted)


def page(words: str, trees: Sequence[TaskTree]) -> str:
    """Return the ``words``, then a block for each of ``trees``: its number (from 1), what was asked, a line a step.

    The numbers are those of a reader's sheet; substitutions and assumptions come last in a block.

    >>> print(page("Judge them.", [TaskTree(name="r1", units=())]), end="")
    Judge them.
    <BLANKLINE>
    === tree 1
    dish type: -; title: -
    asked: none
    substitutions: none
    assumptions: none
    """
    blocks = ["\n".join([f"=== tree {number}", *_lines(tree)]) for number, tree in enumerate(trees, start=1)]
    return "\n\n".join([words, *blocks]) + "\n"


def _lines(tree: TaskTree) -> Iterator[str]:
    recipe = tree.recipe or Recipe("-", ())
    yield f"dish type: {recipe.dish_type}; title: {recipe.title or '-'}"
    yield f"asked: {_joined(map(_asked, recipe.ingredients))}"
    for number, unit in enumerate(tree.units, start=1):
        yield f"{number}. {_step(unit)}"
    yield f"substitutions: {_joined(map(_substitution, tree.substitutions or ()))}"
    yield f"assumptions: {_joined(f'{assumed.node}: {assumed.why}' for assumed in tree.assumptions or ())}"


def _asked(wanted: RequiredIngredient) -> str:
    """Return the food that is wanted as the steps print it, so that a reader finds it there."""
    return str(ObjectNode(wanted.object, (wanted.state,) if wanted.state else ()))


def _step(unit: Step) -> str:
    taken, given = (" + ".join(str(one.node) for one in side) for side in (unit.inputs, unit.outputs))
    return f"{taken} → {unit.motion.upper()} → {given}"


def _joined(items: Iterable[str]) -> str:
    return "; ".join(items) or "none"


def _substitution(one: Substitution) -> str:
    return f"{one.object}: {one.required} handled like {one.equivalent or '?'} ({one.kind}, {_confidence(one)})"


def _confidence(one: Substitution) -> str:
    # a tree of another program may leave it out
    return "?" if "confidence" in one.missing else f"{one.confidence:.2f}"
