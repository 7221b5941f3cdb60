"""All that methods answer the planner, as plain values that can be compared."""

from __future__ import annotations

from foon_kg.integration.teaching.operators import MOST_SIGHTINGS


def told(methods):
    """Every table of ``methods``; the values that nothing was counted for are left out."""
    operators, joining = methods.operators, methods.joining_counts
    return {
        "evidence": {way: evidence_told(evidence) for way, evidence in operators.evidence.items()},
        "acts": {way: evidence_told(evidence) for way, evidence in operators.acts.items()},
        "giving": counts(operators.giving),
        "bringing": counts(operators.bringing),
        "onto": counts(operators.onto),
        "states": {name: sorted(states) for name, states in operators.states.items() if states},
        "foods": sorted(operators.foods),
        "ways": operators.ways,
        "joins": {name: tuple(map(dict, found)) for name, found in joining.counts.items() if any(found)},
        "beside": counts(joining.beside),
        "cooked": counts(joining.cooked),
        "cooked by": methods.cooked_by,
        "frames": methods.frames,
        "goals": methods.goals,
    }


def evidence_told(evidence):
    return {
        "all": first(evidence.all),
        "count": evidence.count,
        "often": dict(evidence.often),
        "foods": {food: first(seen) for food, seen in evidence.foods.items()},
        "kinds": {kind: first(seen) for kind, seen in evidence.kinds.items()},
        "appliances": {name: first(seen) for name, seen in evidence.appliances.items()},
    }


def first(sightings):
    """The sightings that a plan may name, with all their fields."""
    found = sorted(set(sightings), key=lambda seen: (seen.video, seen.position))
    return [repr(seen) for seen in found[:MOST_SIGHTINGS]]


def counts(table):
    return {name: dict(counter) for name, counter in table.items() if counter}
