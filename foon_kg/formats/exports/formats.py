"""The formats, by name: which endings their files have, and what can be written so."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from foon_kg.food.motion_costs import NO_COSTS, MotionCosts
from foon_kg.formats.exports.behaviour_tree import write_behaviour_tree
from foon_kg.formats.exports.dot import write_dot
from foon_kg.formats.exports.files import ExportFile
from foon_kg.formats.exports.graph import BipartiteGraph
from foon_kg.formats.exports.graphml import write_graphml
from foon_kg.formats.exports.mermaid import write_mermaid
from foon_kg.formats.exports.pddl import PlanningProblem, tree_to_pddl
from foon_kg.formats.exports.recipe import write_recipe
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.loaders import write_json, write_text
from foon_kg.loaders.weights import write_weights
from foon_kg.model import RequiredIngredient
from foon_kg.model.errors import UsageError
from foon_kg.model.plugins import EXPORTS, names, plugin
from foon_kg.store.snapshot import Snapshot

Amounts = Mapping[RequiredIngredient, str]
_OUTSIDE_FILE_NAMES = re.compile(r"[^\w.-]+")

ENDINGS = {
    "foon": (".txt", ".foon"),
    "json": (".json",),
    "dot": (".dot", ".gv"),
    "mermaid": (".mmd", ".mermaid"),
    "graphml": (".graphml",),
    "markdown": (".md", ".markdown"),
    "behaviour-tree": (".xml",),
    "pddl": (),
    "csv": (),
    "weights": (),
}
"""Every format with the endings of its files, the first one for new files; what is always several files has none."""

_GRAPHS: Mapping[str, Callable[[BipartiteGraph], str]] = {
    "dot": write_dot,
    "mermaid": write_mermaid,
    "graphml": write_graphml,
}
_SUBGRAPHS = {"foon": write_text, "json": write_json}


def export_tree(
    tree: ExportedTree, form: str, amounts: Amounts | None = None, costs: MotionCosts = NO_COSTS
) -> tuple[ExportFile, ...]:
    """Return a task tree in the format called ``form``; its files are called after the tree.

    ``amounts`` say how much of each food was asked. ``costs`` give the motions in GraphML and behaviour trees their
    success rates; without any, a retrieved tree has those with which it was found.

    Raises :class:`~foon_kg.model.errors.UsageError` for a format that is for whole FOONs only, and
    :class:`~foon_kg.model.errors.FormatError` where the format cannot say what is in the tree.
    """
    costs = costs or tree.costs
    if form == "pddl":
        return pddl_files(tree.name, tree_to_pddl(tree))
    return (ExportFile(file_name(tree.name) + _ending(form), _tree_text(tree, form, amounts, costs)),)


def _tree_text(tree: ExportedTree, form: str, amounts: Amounts | None, costs: MotionCosts) -> str:
    if form in _SUBGRAPHS:
        return _SUBGRAPHS[form](tree.subgraph)
    if form in _GRAPHS:
        return _GRAPHS[form](BipartiteGraph.of_tree(tree, costs))
    if form == "markdown":
        return write_recipe(tree, amounts)
    if form == "behaviour-tree":
        return write_behaviour_tree(tree, costs)
    write = None if form in ENDINGS else plugin(EXPORTS, form)
    if write is None:
        raise _not_for("a task tree", form)
    return str(write(tree))


def export_foon(foon: Snapshot, form: str, costs: MotionCosts = NO_COSTS) -> tuple[ExportFile, ...]:
    """Return a whole FOON in the format called ``form``; for PDDL, which has to know a goal, see ``foon_to_pddl``.

    ``costs`` are the weights of its motions, which GraphML and CSV have on motion nodes.

    Raises :class:`~foon_kg.model.errors.UsageError` for a format that is for task trees only.
    """
    if form in _SUBGRAPHS:
        write = _SUBGRAPHS[form]
        return tuple(ExportFile(video.name + _ending(form), write(video)) for video in foon.subgraphs)
    if form in _GRAPHS:
        return (ExportFile("foon" + _ending(form), _GRAPHS[form](BipartiteGraph.of_foon(foon, costs))),)
    if form == "csv":
        from foon_kg.formats.exports.neo4j_csv import write_neo4j_csv  # noqa: PLC0415 - it brings the driver of Neo4j with it

        return write_neo4j_csv(foon, costs)
    if form == "weights":
        return (weights_file(costs),)
    raise _not_for("a whole FOON", form)


def weights_file(costs: MotionCosts) -> ExportFile:
    """Return the ``costs`` of motions as the file that ``foon load weights`` reads; raises UsageError without any."""
    if not costs:
        raise UsageError("this FOON has no weights of motions", hint="Store some with: foon load weights FILE")
    return ExportFile("motion_cost.json", write_weights(costs))


def pddl_files(name: str, written: PlanningProblem) -> tuple[ExportFile, ...]:
    """Return a planning problem (``written``) as files that begin with ``name``.

    They are the domain, the problem, and the plan where there is one.
    """
    files = {"-domain.pddl": written.domain, "-problem.pddl": written.problem, ".plan": written.plan}
    return tuple(ExportFile(file_name(name) + ending, text) for ending, text in files.items() if text is not None)


def file_name(name: str) -> str:
    """Return ``name`` as the name of a file on any system.

    >>> file_name("crème brûlée: 2/3")
    'crème_brûlée_2_3'
    """
    return _OUTSIDE_FILE_NAMES.sub("_", name).strip("._") or "tree"


def all_formats() -> dict[str, tuple[str, ...]]:
    """Return every format with its endings, those of plug-ins as well: their files end with their names."""
    return {**{name: (f".{name}",) for name in names(EXPORTS)}, **ENDINGS}


def _ending(form: str) -> str:
    return next(iter(ENDINGS.get(form, (f".{form}",))), "")


def _not_for(what: str, form: str) -> UsageError:
    return UsageError(f"{what} cannot be written as {form}", hint='See "foon export --help" for what goes with what.')
