"""What a robot needs (docs/contract.md, W1 to W5 and K4): whether each step can happen, and in a sensible order."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from foon_kg.validation.case import Case, was_taken_out
from foon_kg.validation.report import Finding
from foon_kg.world import Happening, Lump, Vessel
from foon_kg.world.reading import Said

MOST_WAITING = 4
"""How many units may prepare other food while food waits in a hot vessel."""

_GRINDS = frozenset({"grind", "blend", "grate"})


def of_world(rule: str, case: Case) -> Iterator[Finding]:
    """Return what the world itself could not do (W1 to W3, K4, K7)."""
    for happening in case.happenings:
        for mishap in happening.mishaps:
            if mishap.rule == rule:
                yield Finding(rule, mishap.reason, happening.number, mishap.nodes, mishap.minor)


def idle(case: Case) -> Iterator[Finding]:
    """W4: nothing moves in a step that moves; grinding without a mill; cut food that is not in the dish."""
    yield from of_world("W4", case)
    for happening in case.happenings:
        if happening.does("move", "scatter") and _moves_nothing(happening):
            yield Finding("W4", f"nothing moves in “{happening.step.motion}”", happening.number)
        if happening.does("grind") and not _can(happening, _GRINDS):
            yield Finding("W4", "it is ground without a mill, mortar, blender or processor", happening.number)
    yield from _cut_for_nothing(case)
    yield from _moved_for_nothing(case)


def _moves_nothing(happening: Happening) -> bool:
    if happening.does(
        "mix", "heat", "blend", "knead", "shape", "turn", "close", "attach", "detach", "coat", "switch on"
    ):
        return False
    joined = happening.made and len(happening.inputs) > 1  # a sandwich is laid together where its bread lies
    if happening.moved or happening.vessels_moved or joined:
        return False
    return not happening.does("cut", "grate", "grind", "peel", "open", "press")


def _can(happening: Happening, abilities: frozenset[str]) -> bool:
    for vessel in happening.vessels:
        place: Vessel | None = vessel
        while place is not None:
            if not place.row.can.isdisjoint(abilities):
                return True
            place = place.where
    return any(lump.where is not None and not lump.where.row.can.isdisjoint(abilities) for lump in happening.inputs)


def _cut_for_nothing(case: Case) -> Iterator[Finding]:
    if case.dish is None:
        return
    inside = {id(part) for part in case.parts}
    origins = {(part.name, part.taken) for part in case.parts}
    for happening in case.happenings:
        if not happening.does("cut", "grate"):
            continue
        for lump in happening.treated:
            lost = [p for p in lump.parts if id(p) not in inside and (p.name, p.taken) not in origins and not p.remains]
            lost = [part for part in lost if not was_taken_out(case, part.name)]
            if lost and not any(id(part) in inside for part in lump.parts):
                reason = f"{lost[0].name} is prepared and is not in the dish"
                yield Finding("W4", reason, happening.number, minor=True)


def _moved_for_nothing(case: Case) -> Iterator[Finding]:
    """Yield the first food that is moved and at once moved on, with nothing done in between: one a tree is enough."""
    for earlier, happening in pairwise(case.happenings):
        if not (_only_moved(earlier) and _only_moved(happening)):
            continue
        brought = {id(lump) for lump, _, now in earlier.moved if now is not None}
        for lump, before, _ in sorted(happening.moved, key=lambda row: row[0].label):
            if id(lump) in brought and before in happening.emptied and _serves_nothing(before, lump):
                reason = (
                    f"{lump.label} was put into the {before.label if before else 'hand'} only to be taken out again"
                )
                yield Finding("W4", reason, happening.number, minor=True)
                return


def never_lit(case: Case) -> Iterator[Finding]:
    """Yield (K7) each vessel that is put over heat with food in it, and emptied before anything is turned on there."""
    lit: set[int] = set()
    for happening in case.happenings:
        lit |= {id(vessel) for vessel in (*happening.hot, *happening.heated)}
        over = {said.label for said in happening.said_in if _is_over_heat(said)}
        for vessel in happening.emptied:
            if vessel.label in over and id(vessel) not in lit:
                yield Finding("K7", f"the {vessel.label} stood over what was never turned on", happening.number)


def _is_over_heat(said: Said) -> bool:
    return said.place_utensil is not None and said.place_utensil.source == "heat"


def _only_moved(happening: Happening) -> bool:
    return happening.motion.does <= {"move", "fetch", "scatter"}


def _serves_nothing(place: Vessel | None, lump: Lump) -> bool:
    """Whether a food was in a place to no purpose: nothing measures, carries, holds others or cools there."""
    if place is None or lump.made or place.row.role != "vessel":
        return False
    return place.row.can.isdisjoint({"measure", "strain", "cut", "heat", "bake"})


def order(case: Case) -> Iterator[Finding]:
    """W5: food waits in a hot vessel; food is fried without fat; water is fetched while something waits in the heat."""
    waiting: dict[int, int] = {}
    told: set[int] = set()
    for happening in case.happenings:
        hot = happening.hot
        used = {id(vessel) for vessel in (*happening.vessels, *happening.heated)}
        for vessel in hot:
            key = id(vessel)
            if key in used or key in {id(v) for _, _, v in happening.moved if v is not None}:
                waiting[key] = 0
            elif _prepares(happening):
                waiting[key] = waiting.get(key, 0) + 1
                if waiting[key] > MOST_WAITING and key not in told:
                    told.add(key)
                    reason = f"what is in the {vessel.label} waits in the heat while other food is prepared"
                    yield Finding("W5", reason, happening.number, minor=True)
        for key in set(waiting) - {id(vessel) for vessel in hot}:
            del waiting[key]
        if hot and _fetches_water(happening):
            yield Finding("W5", "water is fetched while something waits in the heat", happening.number, minor=True)
        yield from _fried_dry(happening)


def _prepares(happening: Happening) -> bool:
    return happening.does(
        "cut", "peel", "grate", "open", "core", "clean", "mash", "grind", "move", "fetch", "shape", "mix"
    )


def _fetches_water(happening: Happening) -> bool:
    return any(v.label == "faucet" for v in happening.vessels) and any(
        part.food.is_a("water") for lump in happening.outputs.values() for part in lump.parts
    )


def _fried_dry(happening: Happening) -> Iterator[Finding]:
    if not happening.does("fat"):
        return
    for vessel in happening.heated:
        parts = [part for lump in vessel.lumps for part in lump.parts]
        if (
            vessel.row.role == "vessel"
            and parts
            and not any(part.food.is_a("fat", "meat", "fish", "liquid", "creamy") for part in parts)
        ):
            yield Finding("W5", f"it is fried in a dry {vessel.label}", happening.number, minor=True)
