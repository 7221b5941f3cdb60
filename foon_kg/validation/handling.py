"""Whether hands and tools can do what a step says to foods as they are (docs/contract.md, W1 and W4)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from foon_kg.food import Food
from foon_kg.food.lists import says, word_list
from foon_kg.model import ObjectNode
from foon_kg.model.tree import Step
from foon_kg.validation.case import Case
from foon_kg.validation.report import Finding
from foon_kg.world import Lump, Part, PlayedStep, Vessel
from foon_kg.world.running import is_runny

_AS_POWDER = 5
"""How fine what is ground is (:class:`~foon_kg.food.rows.State`)."""

# a step that cuts as well as one of these (a food processor) may leave a powder
_MILLS = ("grind", "blend", "mash", "grate", "squeeze")


def picked_up(case: Case) -> Iterator[Finding]:
    """Yield a finding for each liquid of ``case`` that a step picks up by hand, or on what is flat."""
    for played_step in case.played_steps:
        if played_step.step.motion not in word_list("picks up") or _has_hollow_scoop(played_step):
            continue
        # by identity: a lump is the same one whatever becomes of it, and two may look alike
        moved = {id(lump) for lump, before, now in played_step.moved if now is not None and before is not now}
        for node, lump in played_step.outputs.items():
            if id(lump) in moved and _runs(node, played_step, case):
                yield Finding("W4", f"{node.label} runs, and is picked up", played_step.number, (node,))


def _runs(node: ObjectNode, played_step: PlayedStep, case: Case) -> bool:
    """Whether what comes out of a vessel in a step runs: it is liquid, or seasoned fat that was hot there."""
    if is_runny(node.label, node.states, sorted(node.ingredients), case.tables):
        return True
    vessels = (mention.node for mention in played_step.step.inputs if "hot" in mention.node.states)
    hot = any({*node.ingredients} <= {*vessel.ingredients} for vessel in vessels)
    return hot and _is_seasoned_fat([case.tables.foods.food(name) for name in node.ingredients])


def _is_seasoned_fat(foods: Sequence[Food]) -> bool:
    """Whether ``foods`` are fat, and beside it only what seasons that: no salted flesh."""
    seasoned = all(food.is_any(word_list("runs with melted fat")) for food in foods)
    return seasoned and any(f.is_a("fat") for f in foods) and not any(f.is_any(word_list("is flesh")) for f in foods)


def by_no_tool(case: Case) -> Iterator[Finding]:
    """Yield a finding for what no hand and no tool does in ``case``.

    That is to pick up powder, to brush what is dry, to open what has no shell.
    """
    for played_step in case.played_steps:
        moved = [lump for lump, before, now in played_step.moved if now is not None and before is not now]
        why = _why_by_none(played_step, moved, case) if moved else ""
        if why:
            nodes = tuple(node for node, lump in played_step.outputs.items() if lump in moved)
            yield Finding("W4", f"{', '.join(sorted({lump.label for lump in moved}))} {why}", played_step.number, nodes)


def lifted_loose(case: Case) -> Iterator[Finding]:
    """Yield a finding for each small thing of ``case`` that a step is said to lift out of a liquid: tongs find none."""
    for played_step in case.played_steps:
        if played_step.step.motion not in word_list("takes out") or _has_scoop(played_step):
            continue
        for lump in _lifted(played_step, case):
            if _is_strewn(lump):
                yield Finding("W4", f"{lump.label} lies loose in a liquid, and is lifted out", played_step.number)


def _lifted(played_step: PlayedStep, case: Case) -> Iterator[Lump]:
    """Yield what comes in a step out of a vessel in which there is a liquid."""
    for lump, before, now in played_step.moved:
        if before is not None and before is not now and now is not None and _is_wet(played_step, before, case):
            yield lump


def _is_strewn(lump: Lump) -> bool:
    """Whether all of a lump is food in pieces that no tongs hold."""
    return bool(lump.parts) and all(part.food.is_any(word_list("is too small for tongs")) for part in lump.parts)


def _is_wet(played_step: PlayedStep, vessel: Vessel, case: Case) -> bool:
    """Whether the nodes of a step tell a liquid in a ``vessel``."""
    told = (mention.node for mention in played_step.step.inputs if mention.node.label == vessel.label)
    foods = (case.tables.foods.food(name) for node in told for name in node.ingredients)
    return any(food.is_a("cooking liquid", "water") for food in foods)


def _why_by_none(played_step: PlayedStep, moved: Sequence[Lump], case: Case) -> str:
    """Return why no tool brings all that was ``moved`` as a step does; ``""`` where one may."""
    parts = [part for lump in moved for part in lump.parts]
    motion = played_step.step.motion
    if motion in word_list("wets what it is put on"):
        return "is dry, and no brush takes it up" if _are_dry(parts, case) else ""
    if motion in word_list("picks up"):
        loose = not _has_scoop(played_step) and _are_powder(played_step, moved, case)
        return "is a powder, and is picked up" if loose else ""
    return "has no shell to be opened" if played_step.does("shell") and _have_no_shell(parts) else ""


def _are_dry(parts: Sequence[Part], case: Case) -> bool:
    return all(_is_dry(part, case) for part in parts)


def _have_no_shell(parts: Sequence[Part]) -> bool:
    return all(part.food.is_any(word_list("has no shell")) for part in parts)


def _are_powder(played_step: PlayedStep, moved: Sequence[Lump], case: Case) -> bool:
    """Whether single foods that nobody cooked or mixed come loose out of a step, and as fine as a powder."""
    nodes = [node for node, lump in played_step.outputs.items() if lump in moved]
    return bool(nodes) and all(
        not node.ingredients and _finest(node.states, case) >= _AS_POWDER and _is_loose(node, case) for node in nodes
    )


def _is_loose(node: ObjectNode, case: Case) -> bool:
    """Whether a food is sold as a powder, and nothing made a paste of it: no mash."""
    facts = case.tables.foods.food(node.label, node.states)
    return _is_sold_fine(facts, case) and says(node.states, "is a loose powder")


def _is_dry(part: Part, case: Case) -> bool:
    """Whether a food is strewn by itself, and makes no paste of what is strewn."""
    strewn = part.food.is_any(word_list("only flavours")) or _is_sold_fine(part.food, case)
    return strewn and not part.food.is_any(word_list("makes a paste of what is dry"))


def _is_sold_fine(facts: Food, case: Case) -> bool:
    return case.tables.state(facts.sold_as).fineness >= _AS_POWDER


def _has_scoop(played_step: PlayedStep) -> bool:
    return any(vessel.row.role == "tool" and "scoop" in vessel.row.can for vessel in played_step.vessels)


def _has_hollow_scoop(played_step: PlayedStep) -> bool:
    """Whether a tool of a step scoops what runs: a turner does not, which is flat."""
    flat = word_list("holds no liquid")
    tools = (vessel for vessel in played_step.vessels if vessel.row.role == "tool" and "scoop" in vessel.row.can)
    return any(tool.label not in flat for tool in tools)


def too_hard(case: Case) -> Iterator[Finding]:
    """Yield a finding for each hard food of ``case`` that a knife is said to grind, or that is too small to grate."""
    for played_step in case.played_steps:
        if played_step.does("grate"):
            yield from _grated_small(played_step)
        if played_step.does("cut") and not played_step.does(*_MILLS):
            yield from _ground_by_a_knife(played_step, case)


def _ground_by_a_knife(played_step: PlayedStep, case: Case) -> Iterator[Finding]:
    """Yield each food that a cut is said to make as fine as powder and that is not soft."""
    before = {state for mention in played_step.step.inputs for state in mention.node.states}
    for node, lump in played_step.outputs.items():
        soft = all(part.food.is_any(word_list("is soft enough for a knife")) for part in lump.parts)
        if not soft and _finest(set(node.states) - before, case) >= _AS_POWDER:
            yield Finding("W4", f"{lump.label} is too hard to be ground by a knife", played_step.number, (node,))


def coarser(case: Case) -> Iterator[Finding]:
    """Yield a finding for each food of ``case`` that is fine as powder, and of which a cut is said to make pieces."""
    for played_step in case.played_steps:
        if not played_step.does("cut"):
            continue
        before = {mention.node.label: set(mention.node.states) for mention in played_step.step.inputs}
        for node in played_step.outputs:
            was = before.get(node.label, set())
            fine, now = _finest(was, case), _finest(set(node.states) - was, case)
            if fine >= _AS_POWDER and 0 < now < fine:
                yield Finding("W4", f"{node.label} is finer than that already", played_step.number, (node,))


def _finest(states: Iterable[str], case: Case) -> int:
    return max((case.tables.state(state).fine or 0 for state in states), default=0)


def broken_raw(case: Case) -> Iterator[Finding]:
    """Yield a finding for each firm raw food of ``case`` that bare hands are said to break into pieces."""
    for played_step in case.played_steps:
        if played_step.step.motion not in word_list("is done by bare hands") or _has_tool(played_step):
            continue
        for node, lump in played_step.outputs.items():
            if any(_wants_a_knife(part, played_step.number) for part in lump.parts):
                yield Finding("W4", f"nobody breaks {node.label} by hand", played_step.number, (node,))


def _has_tool(played_step: PlayedStep) -> bool:
    return not played_step.does("cut") or any(vessel.row.role == "tool" for vessel in played_step.vessels)


def _wants_a_knife(part: Part, step: int) -> bool:
    """Whether a food is firm and nothing ever heats it, and no knife opened it before a ``step``: halves come apart."""
    firm = part.food.is_any(word_list("wants a knife")) and not part.food.is_any(word_list("is broken by hand"))
    return firm and part.heated is None and part.done.get("cut", step) >= step


def _grated_small(played_step: PlayedStep) -> Iterator[Finding]:
    for mention in played_step.step.inputs:
        small = word_list("is too small for a grater") & set(mention.node.states)
        if small:
            reason = f"it is {min(small)}, and no grater holds that"
            yield Finding("W4", reason, played_step.number, (mention.node,))


def used_up(case: Case) -> Iterator[Finding]:
    """Yield a finding (W1) for food of ``case`` that a step uses up in a vessel, and a later one takes out of there."""
    spent: dict[int, int] = {}
    for place, unit in enumerate(case.tree.units):
        taken = dict(_in_vessels(unit, case))
        for thing, node in taken.items():
            if thing in spent:
                reason = f"it was used up in step {spent[thing] + 1}"
                yield Finding("W1", reason, place, (node,))
        kept = {mention.thing for mention in unit.outputs}
        for thing in taken:
            if thing not in kept:  # it went into another thing, which has a number of its own
                spent.setdefault(thing, place)


def _in_vessels(step: Step, case: Case) -> Iterator[tuple[int, ObjectNode]]:
    """Yield the numbered foods that go into a step out of a vessel that is no store."""
    for mention in step.inputs:
        said = case.read(mention.node)
        row = said.place_utensil
        if said.is_food and mention.thing is not None and row is not None and row.role == "vessel":
            yield mention.thing, mention.node
