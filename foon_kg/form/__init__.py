"""The form of a tree: the old rules C1 to C8 and S1 to S8, by which today's planner chooses among its trees.

They are a private part of that planner and go with it; nobody else asks them. Still they know nothing of how a tree
is made. ``check`` answers a :class:`Report`; each finding says the rule, the unit, the node and the reason. A rule
that lacks what it would need (a recipe, the FOON) is named under ``not_asked``. C9 is asked of several answers, by
:func:`repeatable`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from foon_kg.form import execution, honesty, ingredients, likeness, sense
from foon_kg.form.case import Case
from foon_kg.form.foon import KnownFoon
from foon_kg.form.repeatability import repeatable
from foon_kg.form.report import CONTRACT, SENSE, Finding, Report
from foon_kg.form.tree import TaskTree
from foon_kg.kitchen import Kitchen

__all__ = ["CONTRACT", "SENSE", "Finding", "KnownFoon", "Report", "TaskTree", "check", "repeatable"]

RULES: dict[str, Callable[[Case], Iterator[Finding]]] = {
    "C1": execution.executable,
    "C2": execution.goal,
    "C3": execution.connected,
    "C4": ingredients.complete,
    "C5": ingredients.nothing_else,
    "C6": ingredients.kitchen,
    "C7": honesty.honest,
    "C8": honesty.grounded,
    "S1": sense.fresh,
    "S2": sense.in_time,
    "S3": sense.opened,
    "S4": sense.thrifty,
    "S5": likeness.close,
    "S6": likeness.true_name,
    "S7": sense.state_kept,
    "S8": likeness.kept,
}
"""What is asked of one tree; C9 is asked of several answers by :func:`repeatable`."""

_OF_RECIPES = frozenset({"C4", "C5", "S2", "S3", "S4", "S7"})
_OF_FOON = frozenset({"C2", "C6", "C7", "C8", "S2", "S3", "S6", "S8"})
_OF_RESULTS = frozenset({"C7", "S5", "S8"})
_NOTHING_WITHOUT_FOON = frozenset({"C8", "S3", "S6", "S8"})


def check(tree: TaskTree, foon: KnownFoon | None = None, kitchen: Kitchen | None = None) -> Report:
    """Judge ``tree`` against ``foon``; ``kitchen`` (with its free foods) is the project's own by default."""
    if foon is not None and tree.level is not None:
        foon = foon.at(tree.level)
    asked = (wanted.object for wanted in (tree.recipe.ingredients if tree.recipe else ()))
    case = Case(tree, foon, (kitchen or Kitchen.default()).with_foods(asked))
    not_asked = tuple(_not_asked(case))
    skipped = {rule for rule, why in not_asked if not why.startswith("in part")}
    findings = tuple(finding for rule, ask in RULES.items() if rule not in skipped for finding in ask(case))
    free = ingredients.free_foods(case)
    notes = (f"free foods that nobody asked for: {', '.join(free)}",) if free else ()
    return Report(tree.name, findings, not_asked, notes)


def _not_asked(case: Case) -> Iterator[tuple[str, str]]:
    for rule in (*CONTRACT, *SENSE):
        if rule == "C9":
            yield rule, "one answer alone cannot show whether it repeats"
        elif rule in _OF_RECIPES and case.recipe is None:
            yield rule, "no recipe is known"
        elif rule in _OF_RESULTS - {"C7"} and case.tree.substitutions is None:
            yield rule, "the file is no plan result"
        elif rule in _OF_FOON and case.foon is None:
            whole = rule in _NOTHING_WITHOUT_FOON
            yield rule, "no FOON is known" if whole else "in part: no FOON is known"
