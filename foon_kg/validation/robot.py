"""What a robot needs (docs/contract.md, W1 to W5 and K4): whether each step can happen, and in a sensible order."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from foon_kg.food import Food
from foon_kg.food.lists import word_list
from foon_kg.validation.case import Case, was_taken_out
from foon_kg.validation.report import Finding
from foon_kg.world import Lump, Part, PlayedStep, Vessel
from foon_kg.world.reading import NodeReading

MOST_WAITING = 4
"""How many units may prepare other food while food waits in a hot vessel."""

_GRINDS = frozenset({"grind", "blend", "grate"})

_WORKS_IN_PLACE = (
    "mix", "heat", "blend", "knead", "shape", "turn", "close", "attach", "detach", "coat", "switch on",
    "cut", "grate", "grind", "peel", "open", "press",
)  # fmt: skip
"""What a motion that moves things may do besides, so that nothing has to come to another place."""


def of_world(rule: str, case: Case) -> Iterator[Finding]:
    """Yield the findings of ``rule`` in ``case`` that tell what the world itself could not do (W1 to W3, K4, K7)."""
    for played_step in case.played_steps:
        for mishap in played_step.mishaps:
            if mishap.rule == rule:
                yield Finding(rule, mishap.reason, played_step.number, mishap.nodes, mishap.minor)


def idle(case: Case) -> Iterator[Finding]:
    """Yield the findings of W4 in ``case``: nothing moves in a step that moves, or cut food is not in the dish.

    So is what is ground without a mill.
    """
    yield from of_world("W4", case)
    for played_step in case.played_steps:
        if played_step.does("move", "scatter") and _moves_nothing(played_step):
            yield Finding("W4", f"nothing moves in “{played_step.step.motion}”", played_step.number)
        if played_step.does("grind") and not _can(played_step, _GRINDS):
            yield Finding("W4", "it is ground without a mill, mortar, blender or processor", played_step.number)
    yield from _cut_for_nothing(case)
    yield from _moved_for_nothing(case)


def _moves_nothing(played_step: PlayedStep) -> bool:
    """Whether a step brings nothing to another place, and its motion does not do something else as well."""
    if played_step.does(*_WORKS_IN_PLACE) or played_step.moved or played_step.vessels_moved:
        return False
    return not (played_step.made and len(played_step.inputs) > 1)  # a sandwich is laid together where its bread lies


def _can(played_step: PlayedStep, abilities: frozenset[str]) -> bool:
    """Whether a vessel or tool of a step can do one of these, or what it stands on, or that in which an input is."""
    if any(not place.row.can.isdisjoint(abilities) for vessel in played_step.vessels for place in vessel.stack()):
        return True
    return any(lump.where is not None and not lump.where.row.can.isdisjoint(abilities) for lump in played_step.inputs)


def _cut_for_nothing(case: Case) -> Iterator[Finding]:
    """Yield each food that is cut and of which nothing is in the dish."""
    if case.dish is None:
        return
    for played_step in case.played_steps:
        for lump in played_step.treated if played_step.does("cut", "grate") else ():
            lost = _lost_part(case, lump)
            if lost is not None:
                yield Finding("W4", f"{lost.name} is prepared and is not in the dish", played_step.number, minor=True)


def _lost_part(case: Case, lump: Lump) -> Part | None:
    """Return a part of a food that is not in the dish and ought to be; ``None`` where any part of it is."""
    inside = {id(part) for part in case.parts}
    if any(id(part) in inside for part in lump.parts):
        return None
    origins = {(part.name, part.taken) for part in case.parts}
    others = (part for part in lump.parts if (part.name, part.taken) not in origins)
    return next((part for part in others if not _is_missed_by_nobody(case, part)), None)


def _is_missed_by_nobody(case: Case, part: Part) -> bool:
    """Whether a part need not be in the dish: nobody eats it, or it gave its taste and was taken out."""
    return part.remains or was_taken_out(case, part.name)


def _moved_for_nothing(case: Case) -> Iterator[Finding]:
    """Yield the first food that is moved and at once moved on, with nothing done in between: one a tree is enough."""
    for earlier, played_step in pairwise(case.played_steps):
        if not (_only_moved(earlier) and _only_moved(played_step)):
            continue
        for lump, place in _moved_on(earlier, played_step):
            if place in played_step.emptied and _serves_nothing(place, lump):
                reason = f"{lump.label} was put into the {place.label} only to be taken out again"
                yield Finding("W4", reason, played_step.number, minor=True)
                return


def _moved_on(earlier: PlayedStep, later: PlayedStep) -> list[tuple[Lump, Vessel]]:
    """Return the foods that two steps both move, by name, each with the place out of which the later one takes it."""
    brought = {id(lump) for lump, _, now in earlier.moved if now is not None}
    again = [(lump, before) for lump, before, _ in later.moved if id(lump) in brought and before is not None]
    return sorted(again, key=lambda row: row[0].label)


def never_lit(case: Case) -> Iterator[Finding]:
    """Yield the findings of K7 in ``case`` for vessels that are put over heat and emptied before that is turned on."""
    lit: set[int] = set()
    for played_step in case.played_steps:
        lit |= {id(vessel) for vessel in (*played_step.hot, *played_step.heated)}
        utensils = [said for said in played_step.input_readings if said.utensil is not None]
        taken = zip(played_step.vessels, utensils, strict=False)  # vessels that only outputs name follow these
        over = {id(vessel) for vessel, said in taken if _is_over_heat(said)}
        for vessel in played_step.emptied:
            if id(vessel) in over and id(vessel) not in lit:
                yield Finding("K7", f"the {vessel.label} stood over what was never turned on", played_step.number)


def _is_over_heat(said: NodeReading) -> bool:
    return said.place_utensil is not None and said.place_utensil.source == "heat"


def _only_moved(played_step: PlayedStep) -> bool:
    return played_step.motion.does <= {"move", "fetch", "scatter"}


def _serves_nothing(place: Vessel, lump: Lump) -> bool:
    """Whether a food was in a place to no purpose: nothing measures, carries, holds others or cools there."""
    if lump.made or place.row.role != "vessel":
        return False
    return place.row.can.isdisjoint({"measure", "strain", "cut", "heat", "bake"})


def order(case: Case) -> Iterator[Finding]:
    """Yield the findings of W5 in ``case``: food waits in a hot vessel, or is fried without fat.

    Water that is fetched while something waits in the heat is another.
    """
    waits = _Waits()
    for played_step in case.played_steps:
        for vessel in waits.too_long(played_step):
            reason = f"what is in the {vessel.label} waits in the heat while other food is prepared"
            yield Finding("W5", reason, played_step.number, minor=True)
        if _hot_food(played_step) and _fetches_water(played_step):
            yield Finding("W5", "water is fetched while something waits in the heat", played_step.number, minor=True)
        yield from _fried_dry(case, played_step)


class _Waits:
    """For how many steps each hot vessel has waited while other food was prepared, and which of them were told."""

    def __init__(self) -> None:
        self.steps: dict[int, int] = {}
        self.told: set[int] = set()

    def too_long(self, played_step: PlayedStep) -> Iterator[Vessel]:
        """Count a step, and yield each vessel that has waited too long with it, each once."""
        moved_to = [now for _, _, now in played_step.moved if now is not None]
        touched = {id(vessel) for vessel in (*played_step.vessels, *played_step.heated, *moved_to)}
        more = int(_prepares(played_step))
        hot = {id(vessel): vessel for vessel in _hot_food(played_step)}
        self.steps = {key: 0 if key in touched else self.steps.get(key, 0) + more for key in hot}
        for key, vessel in hot.items():
            if self.steps[key] > MOST_WAITING and key not in self.told:
                self.told.add(key)
                yield vessel


def _hot_food(played_step: PlayedStep) -> list[Vessel]:
    """Return the vessels that are hot with more than water in them: that may boil for as long as it likes."""
    return [vessel for vessel in played_step.hot if not _is_water(vessel)]


def _is_water(vessel: Vessel) -> bool:
    return bool(vessel.lumps) and all(part.food.is_a("water") for lump in vessel.lumps for part in lump.parts)


def _prepares(played_step: PlayedStep) -> bool:
    return played_step.does(
        "cut", "peel", "grate", "open", "core", "clean", "mash", "grind", "move", "fetch", "shape", "mix"
    )


def _fetches_water(played_step: PlayedStep) -> bool:
    return any(vessel.row.source == "water" for vessel in played_step.vessels) and any(
        part.food.is_a("water") for lump in played_step.outputs.values() for part in lump.parts
    )


def _fried_dry(case: Case, played_step: PlayedStep) -> Iterator[Finding]:
    """Yield the vessels in which a step fries food, with nothing in them that keeps this from the metal."""
    worked = [part.food for lump in played_step.treated for part in lump.parts]
    for vessel in played_step.heated if worked and _may_fry(played_step) else ():
        foods = [*worked, *_inside(case, played_step, vessel)]
        if vessel.row.role == "vessel" and _burns(played_step, vessel, foods):
            yield Finding("W5", f"it is fried in a dry {vessel.label}", played_step.number, minor=True)


def _inside(case: Case, played_step: PlayedStep, vessel: Vessel) -> Iterator[Food]:
    """Yield the foods that the nodes of a vessel tell in it, and those in it at last, which a node may forget."""
    for mention in played_step.step.inputs:
        if mention.node.label == vessel.label:
            yield from map(case.tables.foods.food, mention.node.ingredients)
    for lump in vessel.lumps:
        yield from (part.food for part in lump.parts)


def _may_fry(played_step: PlayedStep) -> bool:
    """Whether a step fries, or cooks on a stove with no liquid."""
    boils = played_step.in_oven or played_step.does("liquid", "dry")
    return played_step.does("fat") or (played_step.does("heat") and not boils)


def _burns(played_step: PlayedStep, vessel: Vessel, foods: Sequence[Food]) -> bool:
    """Whether nothing keeps ``foods`` from the metal: what is fried, or vegetables that are cooked in a pan alone."""
    if played_step.does("fat"):
        return not any(food.is_a("fat", "meat", "fish", "liquid", "creamy") for food in foods)
    if vessel.row.group not in word_list("is a pan to fry in"):
        return False
    wet = any(food.is_any(word_list("keeps a pan from being dry")) for food in foods)
    return not wet and any(food.is_any(word_list("burns in a pan without fat")) for food in foods)
