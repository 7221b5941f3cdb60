"""C7 honest, C8 grounded: whether each unit is a unit of the FOON, and every difference is told."""

from __future__ import annotations

from collections.abc import Iterator

from foon_kg.form.case import Case
from foon_kg.form.report import Finding
from foon_kg.form.tree import Substituted
from foon_kg.kitchen import Kitchen
from foon_kg.model import ObjectNode

KINDS = ("object", "state", "motion")


def honest(case: Case) -> Iterator[Finding]:
    """C7: every entry is whole and used; every difference has one; units that differ do not claim to be FOON's own."""
    used = {entry for found in case.derivations if found for entry in found.used}
    entries = case.tree.substitutions or ()
    for place, entry in enumerate(entries):
        for reason in _incomplete(entry):
            yield Finding("C7", f"substitution {place}, {_told(entry)}: {reason}")
        if entry in entries[:place]:
            yield Finding("C7", f"substitution {place}, {_told(entry)}, is there twice")
        elif case.foon is not None and entry not in used:
            yield Finding("C7", f"substitution {place}, {_told(entry)}: no unit uses it")
    for place, found in enumerate(case.derivations):
        for missing in found.undeclared if found else ():
            yield Finding("C7", f"no substitution says “{_told(missing)}”", place)
        if found and found.used and case.tree.units[place].origin not in (None, "substituted"):
            yield Finding(
                "C7", f"its origin is “{case.tree.units[place].origin}”, and it has something substituted", place
            )


def _incomplete(entry: Substituted) -> Iterator[str]:
    if entry.kind not in KINDS:
        yield f"its kind is “{entry.kind}”, not {', '.join(KINDS)}"
    if not entry.required:
        yield "it does not say what is required"
    if entry.equivalent is None or (not entry.equivalent and entry.kind != "state"):
        yield "it names no equivalent"
    if entry.equivalent == entry.required:
        yield "the equivalent is what was required"
    if entry.confidence is None or not 0 <= entry.confidence <= 1:
        yield "it has no confidence between 0 and 1"
    if not entry.object:
        yield "it does not name its object"
    if entry.alternatives is None:
        yield "it has no list of alternatives"
    elif any(not name or confidence is None for name, confidence in entry.alternatives):
        yield "an alternative has no name or no confidence"


def grounded(case: Case) -> Iterator[Finding]:
    """C8: each unit is derived from every unit of the FOON that it names, and what was to be done is not left out.

    So no raw food stands for a processed one, and nothing at rest for what is on or hot.
    """
    for place, unit in enumerate(case.tree.units):
        if unit.seen_in is None:
            yield from _explained(case, place)
            continue
        if not unit.seen_in:
            yield Finding("C8", "it names no unit of the FOON", place)
        for sighting in unit.seen_in:
            if case.foon is not None and (sighting.video, sighting.position) not in case.foon.by_sighting:
                yield Finding("C8", f"the FOON has no unit {sighting.position} in “{sighting.video}”", place)
        for found in case.comparisons[place]:
            for fault in found.faults:
                yield Finding("C8", fault.reason, place, fault.node)
    for entry in case.tree.substitutions or ():
        for reason in _unfair(entry, case.kitchen):
            yield Finding("C8", f"{_told(entry)}: {reason}")


def _explained(case: Case, place: int) -> Iterator[Finding]:
    found = case.derivations[place]
    if found is None:
        yield Finding("C8", "the FOON has no unit with this motion and any of these outputs", place)
    elif found.faults:
        fault = found.faults[0]
        yield Finding(
            "C8", f"no unit of the FOON explains it; the nearest does not because: {fault.reason}", place, fault.node
        )


def _unfair(entry: Substituted, kitchen: Kitchen) -> Iterator[str]:
    """Answer why one state may not stand for another: what was to be done would be left out."""
    if entry.kind != "state" or not entry.equivalent or not entry.object:
        return
    if kitchen.is_utensil(entry.object):
        before, now = (ObjectNode(entry.object, (state,)) for state in (entry.equivalent, entry.required))
        if kitchen.is_running(before) and not kitchen.is_running(now):
            yield "what is off or cold never stands for what is on or hot"
    sold_before, sold_now = (kitchen.is_start_state(entry.object, s) for s in (entry.equivalent, entry.required))
    if sold_before and not sold_now:
        yield "a whole or raw state never stands for a processed one"


def _told(entry: Substituted) -> str:
    about = f"{entry.object}: " if entry.kind != "object" and entry.object else ""
    return f"{about}{entry.required or 'nothing'} for {entry.equivalent or 'nothing'} ({entry.kind or 'no kind'})"
