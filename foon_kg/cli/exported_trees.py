"""What ``foon export FILE`` reads: task trees from plan results, FOON text and FOON JSON, and amounts from recipes."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

from foon_kg.cli.console import Say
from foon_kg.cli.tree_files import is_retrieved, json_values, text_of
from foon_kg.foon import RetrievalResult, amount_said
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.loaders import ReadResult, read_json, read_text
from foon_kg.model import RequiredIngredient
from foon_kg.model.errors import NoTreeError, ReadError
from foon_kg.model.json_fields import Fields
from foon_kg.model.json_text import json_value
from foon_kg.model.names import canonical
from foon_kg.model.nodes import name_of_file
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult


def read_exported_trees(path: Path, say: Say) -> list[ExportedTree]:
    """Return the trees of the file at ``path``, in their order; ``-`` is standard input.

    Plan results that are no trees are passed over, and ``say`` hears of it. Raises
    :class:`~foon_kg.model.errors.NoTreeError` where that leaves none, :class:`~foon_kg.model.errors.ReadError` for what
    is neither a plan result nor a FOON.
    """
    text = text_of(path)
    if not text.lstrip().startswith(("{", "[")):
        return [_of_file(path, read_text(text, name_of_file(path), str(path)), say)]
    values = list(json_values(path, text))
    if len(values) == 1 and _is_subgraph(values[0][1]):
        return [_of_file(path, read_json(text, name_of_file(path), str(path)), say)]
    return list(_of_plans(path, values, say))


def _is_subgraph(value: object) -> bool:
    return isinstance(value, list) or (isinstance(value, dict) and not value.keys() & {"recipe", "asked", "error"})


def _of_file(path: Path, read: ReadResult, say: Say) -> ExportedTree:
    for notice in read.notices:
        say(str(notice))
    if read.subgraph is None:
        raise ReadError(f"{path}: no task tree in it", hint="Give a plan result (JSON), FOON text or FOON JSON.")
    return ExportedTree.of_subgraph(read.subgraph, Kitchen.default())


def _of_plans(path: Path, values: list[tuple[int, object]], say: Say) -> Iterator[ExportedTree]:
    failed = ""
    for line, value in values:
        where = f"{path}:{line}"
        if isinstance(value, dict) and "error" in value:
            failed = f"{where}: no tree: {Fields(value, where).nested('error').text('message')}"
            say(failed)
        elif is_retrieved(value):
            yield ExportedTree.of_retrieved(RetrievalResult.from_json(value, where))
        else:
            yield ExportedTree.of_plan(PlanResult.from_json(value, where))
    if failed and len(values) == 1:
        raise NoTreeError(failed, hint="Export the answer to a recipe that has a tree.")


def amounts_of(tree: ExportedTree, recipe: Path | None) -> dict[RequiredIngredient, str]:
    """Return how much of each ingredient a recipe file wants, where it says so in ``quantity`` and ``unit``.

    An ingredient of the tree takes the amount of one of the same name, and of the same state if there is such.
    """
    if recipe is None or tree.recipe is None:
        return {}
    stated: dict[tuple[str, str], str] = {}
    for food, state, amount in _amounts(recipe):
        stated.setdefault((canonical(food), state), amount)
        stated.setdefault((canonical(food), ""), amount)
    found = {}
    for wanted in tree.recipe.ingredients:
        name = canonical(wanted.object)
        said = stated.get((name, wanted.state)) or stated.get((name, ""))
        if said is not None:
            found[wanted] = said
    return found


def _amounts(recipe: Path) -> Iterator[tuple[str, str, str]]:
    """Yield food, state and amount of each ingredient that has one."""
    text = text_of(recipe)
    try:
        fields = Fields(json_value(text), str(recipe))
    except json.JSONDecodeError as error:
        raise ReadError(f"{recipe}:{error.lineno}: not JSON: {error.msg}", hint="Correct this line.") from error
    for one in fields.nested_list("ingredients"):
        if amount := amount_said(one):
            yield one.text("object"), (one.optional_text("state") or "").strip(), amount
