"""Trees of one goal that are made anew where the judge found a fault, and the best of them.

Two things can be mended: a tree takes again what an earlier step took away or poured out, because the script does
(sense, S1); and a food joins where the judge would not have it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace

from foon_kg.attempt import Attempt
from foon_kg.errors import NoTreeError
from foon_kg.form import CONTRACT
from foon_kg.integration.reenacting import Integration

MOST_REPAIRS = 4
"""How often a tree of one goal is made anew without the choices in which the judge found a fault."""

_REPAIRED = frozenset({*CONTRACT, "S1", "S2", "S7"})


Judge = Callable[[Integration], Attempt]
Faults = Callable[[Attempt], tuple[int, ...]]


def best_of(integrations: Iterable[Integration], judge: Judge, faults: Faults) -> Attempt:
    """Answer the best tree of the first of ``integrations`` that has one without a fault, else the best of all.

    Raises :class:`~foon_kg.errors.NoTreeError`, that of the first, where none has a tree.
    """
    best: Attempt | None = None
    trouble: NoTreeError | None = None
    for integration in integrations:
        try:
            attempt = repaired(integration, judge, faults)
        except NoTreeError as error:
            trouble = trouble or error
            continue
        best = attempt if best is None else min(best, attempt, key=faults)
        if not any(faults(best)):
            break
    if best is None:
        raise trouble or NoTreeError("there is nothing to make a tree of", code="no-way")
    return best


def repaired(integration: Integration, judge: Judge, faults: Faults) -> Attempt:
    """Answer the tree of ``integration``, made anew as often as that may help: the first with the fewest faults.

    Raises :class:`~foon_kg.errors.NoTreeError` where ``judge`` does so for the first one, or for a later one of which
    nothing is left.
    """
    best = attempt = _taken_once(judge(integration), judge, faults)
    integration = attempt.integration
    for _ in range(MOST_REPAIRS):
        blamed = attempt.integration.blamed(attempt.tree, attempt.report.of(_REPAIRED)) - integration.refused
        if not blamed:
            break
        integration = replace(integration, refused=integration.refused | blamed)
        attempt = judge(integration)
        best = min(best, attempt, key=faults)
    return best


def _taken_once(best: Attempt, judge: Judge, faults: Faults) -> Attempt:
    """Answer the tree in which nothing is taken again that the script takes twice, as long as that is any better."""
    for _ in range(MOST_REPAIRS):
        twice = best.integration.taken_twice(best.tree, best.report.of({"S1"}))
        if not twice:
            break
        try:
            attempt = judge(replace(best.integration, spent=best.integration.spent | twice))
        except NoTreeError:
            break
        if faults(attempt) > faults(best) or not _takes_less(attempt, best):
            break
        best = attempt
    return best


def _takes_less(attempt: Attempt, before: Attempt) -> bool:
    """Whether a tree takes fewer things again than one did before."""
    return len(attempt.report.of({"S1"})) < len(before.report.of({"S1"}))
