"""Task trees of anybody judged: recorded videos, plan results, the trees of other programs."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property

from foon_kg.evaluation.verdicts import ALL, Verdicts, verdict_json
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.tree import TaskTree
from foon_kg.validation import KnownFoon, Report, check

NO_DISH_TYPE = "no dish type"
"""The name under which trees are taken together that do not say of which dish type they are."""


@dataclass(frozen=True)
class TreeFigures:
    """One tree: what the judge says of it; ``error`` says why its file has none, then there is no ``report``."""

    name: str
    where: str
    dish_type: str
    report: Report | None = field(default=None, repr=False)
    error: str = ""

    def to_json(self) -> JsonObject:
        """Return the tree's entry under ``trees``."""
        return {
            "id": self.name,
            "where": self.where,
            "dish_type": self.dish_type,
            **verdict_json(self.report),
            "error": self.error or None,
        }


@dataclass(frozen=True)
class TreesEvaluation:
    """What ``foon evaluate trees`` found, in the order of the trees; ``foon`` names the FOON by its content."""

    foon: str
    trees: tuple[TreeFigures, ...]

    @cached_property
    def verdicts(self) -> tuple[tuple[str, Verdicts], ...]:
        """What the judge says by dish type, by name, and of all trees."""
        # kept, since each keeps its counts of the rules
        by_type: defaultdict[str, list[Report | None]] = defaultdict(list)
        for tree in self.trees:
            by_type[tree.dish_type or NO_DISH_TYPE].append(tree.report)
        groups = [*sorted(by_type.items()), (ALL, [tree.report for tree in self.trees])]
        return tuple((name, Verdicts(tuple(reports))) for name, reports in groups)

    @property
    def without_tree(self) -> tuple[TreeFigures, ...]:
        """What has no tree."""
        return tuple(tree for tree in self.trees if tree.report is None)

    def to_json(self) -> JsonObject:
        """Return the evaluation as ``--json`` prints it."""
        return {
            "evaluation": "trees",
            "foon": self.foon,
            "dish_types": [
                {"dish_type": name, "trees": len(found.reports), **found.to_json()} for name, found in self.verdicts
            ],
            "trees": [tree.to_json() for tree in self.trees],
        }


def examined(
    given: Iterable[tuple[str, str, TaskTree]], foon: KnownFoon, free: frozenset[str]
) -> Iterator[TreeFigures]:
    """Yield the figures of each tree, ``given`` with where it is and its dish type.

    Evidence is compared with ``foon``; foods that are ``free`` may be used unasked (C5).
    """
    for where, dish_type, tree in given:
        if tree.error is not None:
            yield TreeFigures(tree.name, where, dish_type, error=tree.error)
        else:
            yield TreeFigures(tree.name, where, dish_type, check(tree, foon, free))
