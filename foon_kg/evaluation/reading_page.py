"""What a reader is given: the words that say what to do, and the trees, printed alike whoever made them.

Names of recipes and videos, times, evidence and origins of units are not printed: they tell which program it was.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from foon_kg.evaluation.reading import read_text
from foon_kg.model import ObjectNode, Recipe, RequiredIngredient
from foon_kg.model.claims import Substitution
from foon_kg.model.errors import ReadError
from foon_kg.model.tree import TaskTree, TreeUnit


def words_in(path: Path) -> str:
    """Return what a reader is told: the quoted lines (``>``) of the Markdown file ``path``, without their marks.

    Raises ReadError where nothing is quoted.
    """
    quoted = [line[1:].strip() for line in read_text(path).splitlines() if line.startswith(">")]
    if not any(quoted):
        raise ReadError(f"{path}: nothing is quoted in it", hint="Mark the words for the reader with “>”.")
    return "\n".join(quoted)


def page(words: str, trees: Sequence[TaskTree]) -> str:
    """Return the ``words``, then the trees, numbered from 1."""
    blocks = ["\n".join([f"=== tree {number}", *_lines(tree)]) for number, tree in enumerate(trees, start=1)]
    return "\n\n".join([words, *blocks]) + "\n"


def _lines(tree: TaskTree) -> Iterator[str]:
    recipe = tree.recipe or Recipe("-", ())
    yield f"dish type: {recipe.dish_type}; title: {recipe.title or '-'}"
    yield f"asked: {_list(map(_asked, recipe.ingredients))}"
    for number, unit in enumerate(tree.units, start=1):
        yield f"{number}. {_step(unit)}"
    yield f"substitutions: {_list(map(_handled, tree.substitutions or ()))}"
    yield f"assumptions: {_list(f'{assumed.node}: {assumed.why}' for assumed in tree.assumptions or ())}"


def _asked(wanted: RequiredIngredient) -> str:
    """Return the food that is wanted as the steps print it, so that a reader finds it there."""
    return str(ObjectNode(wanted.object, (wanted.state,) if wanted.state else ()))


def _step(unit: TreeUnit) -> str:
    taken, given = (" + ".join(str(one.node) for one in side) for side in (unit.step.inputs, unit.step.outputs))
    return f"{taken} → {unit.motion.upper()} → {given}"


def _list(items: Iterable[str]) -> str:
    return "; ".join(items) or "none"


def _handled(one: Substitution) -> str:
    return f"{one.object}: {one.required} handled like {one.equivalent or '?'} ({one.kind}, {_figure(one)})"


def _figure(one: Substitution) -> str:
    return "?" if "confidence" in one.missing else f"{one.confidence:.2f}"
