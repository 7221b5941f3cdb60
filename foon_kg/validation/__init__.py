"""The judge: whether a task tree keeps the contract of docs/contract.md.

It plays the tree in a kitchen (:mod:`foon_kg.world`) and asks of what happened there. It knows nothing of planning.
``check`` returns a :class:`Report`; each finding says the rule, the step, the nodes, the reason and whether it is
minor. A rule that lacks what it would need (a recipe, the FOON) is named under ``not_asked``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import chain

from foon_kg.model import ObjectNode
from foon_kg.model.tree import TaskTree
from foon_kg.validation import dish, form, handling, honesty, matter, robot, sense, table
from foon_kg.validation.case import FREE, Case
from foon_kg.validation.foon import KnownFoon
from foon_kg.validation.repeatability import repeatable
from foon_kg.validation.report import FORM, RULES, TABLE, WORLD, Finding, Report
from foon_kg.validation.tree import tree_from_json, tree_from_subgraph

__all__ = [
    "FORM",
    "RULES",
    "TABLE",
    "WORLD",
    "Finding",
    "KnownFoon",
    "Report",
    "check",
    "repeatable",
    "tree_from_json",
    "tree_from_subgraph",
]


def _of_world(rule: str) -> Callable[[Case], Iterator[Finding]]:
    return lambda case: robot.of_world(rule, case)


def _all(*asked: Callable[[Case], Iterator[Finding]]) -> Callable[[Case], Iterator[Finding]]:
    return lambda case: chain.from_iterable(ask(case) for ask in asked)


ASKED: dict[str, Callable[[Case], Iterator[Finding]]] = {
    "C1": form.executable,
    "C2": form.goal,
    "C3": form.purposeful,
    "C4": form.complete,
    "C5": form.nothing_else,
    "C6": form.kitchen,
    "C7": honesty.honest,
    "C8": honesty.grounded,
    "W1": _all(_of_world("W1"), handling.used_up),
    "W2": _of_world("W2"),
    "W3": _of_world("W3"),
    "W4": _all(
        robot.idle,
        handling.picked_up,
        handling.by_no_tool,
        handling.lifted_loose,
        handling.too_hard,
        handling.coarser,
        handling.broken_raw,
        matter.matter,
        matter.out_of_nowhere,
        matter.second_of_one,
    ),
    "W5": robot.order,
    "K1": table.raw,
    "K2": table.whole,
    "K3": table.late,
    "K4": table.tools,
    "K5": dish.defined,
    "K6": dish.asked,
    "K7": sense.sense,
}
"""What is asked of one tree; C9 is asked of several answers by :func:`repeatable`."""

_OF_RECIPES = frozenset({"C4", "C5", "K6"})
_OF_FOON = frozenset({"C2", "C6", "C7", "C8"})
_NOTHING_WITHOUT_FOON = frozenset({"C8"})
_OF_REFERENCES = frozenset({"C1", "C2", "C3", "C8"})


def check(
    tree: TaskTree,
    foon: KnownFoon | None = None,
    free: frozenset[str] = FREE,
    lacks: Callable[[ObjectNode], bool] | None = None,
    named_so: Callable[[ObjectNode], bool] | None = None,
) -> Report:
    """Judge ``tree`` against ``foon``; ``free`` are the foods that may be used unasked.

    ``lacks`` says of a leaf whether it is missing from a kitchen that a person named (C6), ``named_so`` whether they
    said that it is so: chopped, in a bowl, on.

    A reference tree (classic retrieval) keeps the paper's terms, in which nothing is used up: only C1, C2, C3 and C8
    are asked of it.
    """
    if foon is not None and tree.level is not None:
        foon = foon.at(tree.level)
    case = Case(tree, foon, free, lacks, named_so)
    not_asked = tuple(_not_asked(case))
    skipped = {rule for rule, why in not_asked if not why.startswith("in part")}
    if tree.error is not None:
        return Report(tree.name, tuple(form.goal(case)), not_asked, played=False)
    findings = tuple(finding for rule, ask in ASKED.items() if rule not in skipped for finding in ask(case))
    found = form.free_foods(case)
    notes = (f"free foods that nobody asked for: {', '.join(found)}",) if found else ()
    return Report(tree.name, tuple(dict.fromkeys(findings)), not_asked, notes)


def _not_asked(case: Case) -> Iterator[tuple[str, str]]:
    for rule in RULES:
        if rule == "C9":
            yield rule, "one answer alone cannot show whether it repeats"
        elif case.tree.level is not None and rule not in _OF_REFERENCES:
            yield rule, "a reference tree keeps the paper's own terms"
        elif rule in _OF_RECIPES and case.recipe is None:
            yield rule, "no recipe is known"
        elif rule in _OF_FOON and case.foon is None:
            yield rule, "no FOON is known" if rule in _NOTHING_WITHOUT_FOON else "in part: no FOON is known"
