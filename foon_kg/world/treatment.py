"""What a motion does to the foods it works on: which treatments they have had after it.

A new state name does nothing by itself: peeled is what somebody peeled, cooked what stood over heat while somebody
cooked. Mixing in a hot pot does not cook.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from foon_kg.food.lists import word_list
from foon_kg.food.rows import State
from foon_kg.world import power
from foon_kg.world.happening import Happening
from foon_kg.world.reading import Said
from foon_kg.world.supply import Supply
from foon_kg.world.things import Lump, Part, Vessel

GIVES = {
    "cut": ("cut",), "grate": ("cut", "grate"), "grind": ("cut", "grind"), "blend": ("cut", "blend"),
    "mash": ("cut", "mash"), "peel": ("peel",), "core": ("core",), "stone": ("stone",), "shell": ("shell",),
    "husk": ("husk",), "open": ("open",), "clean": ("wash",), "wait": ("soak",),
    "squeeze": ("peel", "core", "stone", "shell", "cut"),
}  # fmt: skip
"""What each class of motion earns for a food that it works on."""

ADVISED = frozenset({"thaw", "soak", "drain", "wash", "open"})
"""Treatments that nobody is judged by: what a motion can give is believed."""

FINE = {"grate": 4, "grind": 5, "blend": 5, "mash": 5, "cut": 2}
_BY_HAND = ("cut", "grate", "grind", "mash", "peel", "core", "stone", "shell", "husk", "open", "clean", "squeeze")
_GATHERS = ("mix", "blend", "mash", "knead", "whip", "heat")


def apply(supply: Supply, happening: Happening) -> None:
    """Write down what the step did to its foods."""
    happening.treated = _treated(happening)
    earned = _earned(happening.motion.does)
    if earned or happening.does("separate"):
        for lump in happening.treated:
            for part in lump.parts:
                _treat(part, lump, earned, supply, happening)
    if happening.does("heat", "warm"):
        happening.heated = power.heated_vessels(happening)
        happening.in_oven = any(power.stands_in_oven(vessel) for vessel in happening.heated)
        for vessel in (*happening.vessels, *happening.heated):
            vessel.hot = True
        _heat(supply, happening)
    elif happening.does("wait", "clean"):
        _cool(happening)
    _join(happening)
    before = {state for mention in happening.step.inputs for state in mention.node.states}
    for said in happening.said_out:
        if said.is_food:
            fresh = [state for state in said.node.states if state not in before]
            _claimed(said, fresh, happening.outputs.get(said.node), supply, happening)


@lru_cache(maxsize=1 << 10)
def _earned(does: frozenset[str]) -> tuple[str, ...]:
    return tuple(treatment for name in sorted(does) for treatment in GIVES.get(name, ()))


def _treated(happening: Happening) -> list[Lump]:
    """Return what the hands work on: the foods that came out in another form, else those that went in."""
    out = [lump for lump in (*happening.outputs.values(), *happening.made) if not lump.gone]
    went_in = [lump for lump in happening.inputs if not lump.gone and lump not in out]
    if not out and not went_in:
        return [lump for vessel in happening.vessels for lump in vessel.lumps if vessel.row.role == "vessel"]
    if not happening.does(*_BY_HAND):
        return [*out, *went_in]
    before = {mention.node for mention in happening.step.inputs}
    changed = [lump for node, lump in happening.outputs.items() if node not in before]
    changed += [lump for lump in happening.made if lump not in changed]
    return changed or [*out, *went_in]


def _treat(part: Part, lump: Lump, earned: Sequence[str], supply: Supply, happening: Happening) -> None:
    if part.remains:
        return
    for treatment in earned:
        part.done.setdefault(treatment, happening.number)
    part.fine = max(part.fine, *(FINE.get(name, 0) for name in happening.motion.does if name != "cut"), 0)
    became = supply.reader.tables.foods.food(lump.label, lump.states)
    comes_off = happening.does("grate") and became.is_a(*word_list("is grated off the whole"))
    if comes_off or (happening.does("separate") and became.is_a("liquid")):
        for treatment in GIVES["squeeze"]:
            part.done.setdefault(treatment, happening.number)
    if happening.does("cut"):
        told = [supply.reader.tables.state(state).fine for state in lump.states]
        fine = max((one for one in told if one is not None), default=FINE["cut"])
        if 0 < fine < part.fine and not lump.mixed:
            reason = f"{part.name} is in finer pieces already"
            happening.fault("K7", reason, minor=True)
        part.fine = max(part.fine, fine)


def _told_cooked(supply: Supply, happening: Happening) -> bool:
    """Whether a step that only makes hot says that its food is cooked then: people heat until it is."""
    states = [state for lump in happening.outputs.values() for state in lump.states]
    return any("cook" in supply.reader.tables.state(state).earns for state in states)


def _heat(supply: Supply, happening: Happening) -> None:
    lumps = [lump for vessel in happening.heated for lump in vessel.lumps]
    lumps += [lump for lump in (*happening.inputs, *happening.outputs.values()) if lump not in lumps and not lump.gone]
    bath = any(part.food.is_a("cooking liquid") and not part.spoonful for lump in lumps for part in lump.parts)
    cooked = happening.does("warm") and _told_cooked(supply, happening)
    for lump in lumps:
        for part in lump.parts:
            part.heated = happening.number
            if happening.does("heat") or cooked:
                part.done.setdefault("cook", happening.number)
                if bath and not happening.does("dry"):
                    part.done.setdefault("boil", happening.number)


def _cool(happening: Happening) -> None:
    """Note what stood a while, or was rinsed, for the first time since it was heated: it is no longer hot."""
    for part in (part for lump in happening.treated for part in lump.parts):
        if part.cooled is None or part.cooled < (part.heated or 0):
            part.cooled = happening.number


def _join(happening: Happening) -> None:
    """Note which parts come to others, and which are mixed with them."""
    mixes = happening.does("mix", "blend", "knead", "mash", "whip")
    origin = {id(lump): before for lump, before, _ in happening.moved}
    for vessel in _places(happening):
        parts = [part for lump in vessel.lumps for part in lump.parts]
        if vessel.row.role == "storage" or all(part.name == parts[0].name for part in parts):
            continue
        several = len({id(origin.get(id(lump), vessel)) for lump in vessel.lumps}) > 1
        for lump in vessel.lumps:
            _note(lump, happening.number, joins=several and id(lump) in origin, mixes=mixes)
    for lump in happening.outputs.values():
        if lump.mixed and happening.does(*_GATHERS):
            _note(lump, happening.number, joins=False, mixes=mixes or not happening.does("heat"))


def _places(happening: Happening) -> list[Vessel]:
    """Return the vessels that took part, and those in which its foods are, each once."""
    lumps = (*happening.inputs, *happening.outputs.values())
    return list(dict.fromkeys([*happening.vessels, *(lump.where for lump in lumps if lump.where is not None)]))


def _note(lump: Lump, number: int, *, joins: bool, mixes: bool) -> None:
    for part in lump.parts:
        if joins or part.joined is None:
            part.joined = number
        if mixes:
            part.mixed = number


def _claimed(said: Said, fresh: Sequence[str], lump: Lump | None, supply: Supply, happening: Happening) -> None:
    """Tell fresh states that this motion cannot give (K4), and that nothing earned (K7)."""
    if not fresh or lump is None or lump in happening.made:
        return
    for state in fresh:
        row = supply.reader.tables.state(state)
        if not row.sold and (row.earns or row.fine):
            _claimed_so(said, state, row, lump, happening)


def _claimed_so(said: Said, state: str, row: State, lump: Lump, happening: Happening) -> None:
    """Tell one fresh state that the motion cannot give, or that nothing earned; what is advised anyway is counted."""
    if row.before and not any(one in part.states for part in lump.parts for one in row.before):
        never = " or ".join(sorted(row.before))
        happening.fault("K7", f"it is {state}, and it was never {never}", said.node, minor=True)
    missing = sorted(row.earns - {"remains"} - set().union(*(part.done for part in lump.parts)))
    if not missing:
        if happening.motion.known and happening.motion.gives and not _can_give(state, happening):
            happening.fault("K4", f"“{happening.step.motion}” does not make it {state}", said.node, minor=True)
        return
    if row.needs_heat and (happening.does("heat", "warm") or _is_over_heat(lump)):
        return
    if not _can_give(state, happening):
        happening.fault("K7", f"it is {state}, and nobody made it so", said.node, minor=True)
        return
    for part in lump.parts:
        part.done |= dict.fromkeys(ADVISED.intersection(missing), happening.number)


def _is_over_heat(lump: Lump) -> bool:
    place = lump.where
    return place is not None and place.where is not None and place.where.row.source == "heat" and place.hot


def _can_give(state: str, happening: Happening) -> bool:
    own = set(state.lower().replace("-", " ").split())
    return any(state.lower() == given or set(given.split()) & own for given in happening.motion.gives)
