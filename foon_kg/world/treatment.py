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
from foon_kg.world.played_step import PlayedStep
from foon_kg.world.reading import NodeReading
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
"""How fine pieces are after each class of motion (:class:`~foon_kg.food.rows.State`)."""

_BY_HAND = ("cut", "grate", "grind", "mash", "peel", "core", "stone", "shell", "husk", "open", "clean", "squeeze")
_GATHERS = ("mix", "blend", "mash", "knead", "whip", "heat")


def apply(supply: Supply, played_step: PlayedStep) -> None:
    """Write down what the step of ``played_step`` did to its foods, and tell (K4, K7) what it cannot have done.

    ``supply`` has the tables that say what each state claims.
    """
    played_step.treated = _treated(played_step)
    earned = _earned(played_step.motion.does)
    if earned or played_step.does("separate"):
        for lump in played_step.treated:
            for part in lump.parts:
                _treat(part, lump, earned, supply, played_step)
    if played_step.does("heat", "warm"):
        _heat(supply, played_step)
    elif played_step.does("wait", "clean"):
        _cool(played_step)
    _join(played_step)
    _judge_claims(supply, played_step)


@lru_cache(maxsize=1 << 10)
def _earned(does: frozenset[str]) -> tuple[str, ...]:
    return tuple(treatment for name in sorted(does) for treatment in GIVES.get(name, ()))


@lru_cache(maxsize=1 << 10)
def _fine_after(does: frozenset[str]) -> int:
    """Return how fine what a motion ``does`` makes a food at least; of a cut its state tells that."""
    return max((FINE.get(name, 0) for name in does - {"cut"}), default=0)


def _treated(played_step: PlayedStep) -> list[Lump]:
    """Return what the hands work on: the foods that came out in another form, else those that went in."""
    out = [lump for lump in (*played_step.outputs.values(), *played_step.made) if not lump.gone]
    named = out + [lump for lump in played_step.inputs if not lump.gone and lump not in out]
    if not named:
        return _in_vessels(played_step)
    changed = _changed(played_step) if played_step.does(*_BY_HAND) else []
    return changed or named


def _in_vessels(played_step: PlayedStep) -> list[Lump]:
    """Return what is in the vessels that take part, appliances, tools and packets apart."""
    return [lump for vessel in played_step.vessels if vessel.row.role == "vessel" for lump in vessel.lumps]


def _changed(played_step: PlayedStep) -> list[Lump]:
    """Return the foods of those outputs that say something else than each input, and the products."""
    before = {mention.node for mention in played_step.step.inputs}
    changed = [lump for node, lump in played_step.outputs.items() if node not in before]
    return changed + [lump for lump in played_step.made if lump not in changed]


def _treat(part: Part, lump: Lump, earned: Sequence[str], supply: Supply, played_step: PlayedStep) -> None:
    """Give a part of a food what the motion earns, and the fineness that it makes."""
    if part.remains:
        return
    for treatment in earned:
        part.done.setdefault(treatment, played_step.number)
    part.fine = max(part.fine, _fine_after(played_step.motion.does))
    if _is_pressed_out(lump, supply, played_step):
        for treatment in GIVES["squeeze"]:
            part.done.setdefault(treatment, played_step.number)
    if played_step.does("cut"):
        _cut(part, lump, supply, played_step)


def _is_pressed_out(lump: Lump, supply: Supply, played_step: PlayedStep) -> bool:
    """Whether a food came off one that keeps its skin and core: juice that is separated, zest that is grated."""
    became = supply.reader.tables.foods.food(lump.label, lump.states)
    comes_off = played_step.does("grate") and became.is_any(word_list("is grated off the whole"))
    return comes_off or (played_step.does("separate") and became.is_a("liquid"))


def _cut(part: Part, lump: Lump, supply: Supply, played_step: PlayedStep) -> None:
    """Let a part be as fine as its food is told after a cut; tell it (K7) where it was in finer pieces before."""
    fineness = [supply.reader.tables.state(state).fine for state in lump.states]
    fine = max((one for one in fineness if one is not None), default=FINE["cut"])
    if 0 < fine < part.fine and not lump.mixed:
        played_step.fault("K7", f"{part.name} is in finer pieces already", minor=True)
    part.fine = max(part.fine, fine)


def _told_cooked(supply: Supply, played_step: PlayedStep) -> bool:
    """Whether a step that only makes hot says that its food is cooked then: people heat until it is."""
    states = [state for lump in played_step.outputs.values() for state in lump.states]
    return any("cook" in supply.reader.tables.state(state).earns for state in states)


def _heat(supply: Supply, played_step: PlayedStep) -> None:
    """Heat the vessels of a step and all that is in them."""
    played_step.heated = power.heated_vessels(played_step)
    played_step.in_oven = any(power.stands_in_oven(vessel) for vessel in played_step.heated)
    for vessel in (*played_step.vessels, *played_step.heated):
        vessel.hot = True
    parts = _hot_parts(played_step)
    earned = _earned_by_heat(parts, supply, played_step)
    for part in parts:
        part.heated = played_step.number
        for treatment in earned:
            part.done.setdefault(treatment, played_step.number)


def _earned_by_heat(parts: Sequence[Part], supply: Supply, played_step: PlayedStep) -> tuple[str, ...]:
    """Return which treatments foods earn over heat: all are cooked, and boiled where a liquid is among them."""
    if not (played_step.does("heat") or _told_cooked(supply, played_step)):
        return ()
    bath = any(part.food.is_a("cooking liquid") and not part.spoonful for part in parts)
    return ("cook", "boil") if bath and not played_step.does("dry") else ("cook",)


def _hot_parts(played_step: PlayedStep) -> list[Part]:
    """Return the parts of what is in the heated vessels, and of the foods that the step names."""
    held = [lump for vessel in played_step.heated for lump in vessel.lumps]
    named = [lump for lump in (*played_step.inputs, *played_step.outputs.values()) if not lump.gone]
    return [part for lump in dict.fromkeys([*held, *named]) for part in lump.parts]


def _cool(played_step: PlayedStep) -> None:
    """Note what stood a while, or was rinsed, for the first time since it was heated: it is no longer hot."""
    for part in (part for lump in played_step.treated for part in lump.parts):
        if part.cooled is None or part.cooled < (part.heated or 0):
            part.cooled = played_step.number


def _join(played_step: PlayedStep) -> None:
    """Note which parts come to others, and which are mixed with them."""
    mixes = played_step.does("mix", "blend", "knead", "mash", "whip")
    origin = {id(lump): before for lump, before, _ in played_step.moved}
    for vessel in _places(played_step):
        if vessel.row.role != "storage" and _holds_several(vessel):
            several = len({id(origin.get(id(lump), vessel)) for lump in vessel.lumps}) > 1
            for lump in vessel.lumps:
                _note(lump, played_step.number, joins=several and id(lump) in origin, mixes=mixes)
    if played_step.does(*_GATHERS):
        _mix_outputs(played_step, mixes=mixes or not played_step.does("heat"))


def _mix_outputs(played_step: PlayedStep, *, mixes: bool) -> None:
    """Note what came out as one food of several: its parts are together, and mixed too where the motion ``mixes``."""
    for lump in played_step.outputs.values():
        if lump.mixed:
            _note(lump, played_step.number, joins=False, mixes=mixes)


def _holds_several(vessel: Vessel) -> bool:
    """Whether there is more than one food in a vessel."""
    lumps = vessel.lumps
    if len(lumps) == 1:
        return lumps[0].mixed
    return len({part.name for lump in lumps for part in lump.parts}) > 1


def _places(played_step: PlayedStep) -> list[Vessel]:
    """Return the vessels that took part, and those in which its foods are, each once."""
    lumps = (*played_step.inputs, *played_step.outputs.values())
    return list(dict.fromkeys([*played_step.vessels, *(lump.where for lump in lumps if lump.where is not None)]))


def _note(lump: Lump, number: int, *, joins: bool, mixes: bool) -> None:
    for part in lump.parts:
        if joins or part.joined is None:
            part.joined = number
        if mixes:
            part.mixed = number


def _judge_claims(supply: Supply, played_step: PlayedStep) -> None:
    """Ask of each state that an output says and no input whether this motion gives it."""
    for said in played_step.output_readings:
        lump = played_step.outputs.get(said.node) if said.worked else None
        if lump is None or lump in played_step.made:
            continue
        for state in said.worked:
            if not any(state in mention.node.states for mention in played_step.step.inputs):
                _claimed_so(said, state, supply.reader.tables.state(state), lump, played_step)


def _claimed_so(said: NodeReading, state: str, row: State, lump: Lump, played_step: PlayedStep) -> None:
    """Tell one fresh state that the motion cannot give, or that nothing earned; what is advised anyway is counted."""
    if not _was_before(lump, row):
        never = " or ".join(sorted(row.before))
        played_step.fault("K7", f"it is {state}, and it was never {never}", said.node, minor=True)
    missing = row.earns - {"remains"} - set().union(*(part.done for part in lump.parts))
    if not missing:
        if _cannot_give(state, played_step):
            played_step.fault("K4", f"“{played_step.step.motion}” does not make it {state}", said.node, minor=True)
    elif row.needs_heat and _is_hot(lump, played_step):
        return
    elif _can_give(state, played_step):
        for part in lump.parts:
            part.done |= dict.fromkeys(sorted(ADVISED & missing), played_step.number)
    else:
        played_step.fault("K7", f"it is {state}, and nobody made it so", said.node, minor=True)


def _cannot_give(state: str, played_step: PlayedStep) -> bool:
    """Whether it is known what a motion gives, and this state is not of it."""
    return played_step.motion.known and bool(played_step.motion.gives) and not _can_give(state, played_step)


def _was_before(lump: Lump, row: State) -> bool:
    """Whether a food was in a state in which it has to be before this one; most states ask for none."""
    return not row.before or any(not row.before.isdisjoint(part.states) for part in lump.parts)


def _is_hot(lump: Lump, played_step: PlayedStep) -> bool:
    """Whether a step heats, or a food is in a hot vessel on a source of heat."""
    place = lump.where
    if played_step.does("heat", "warm"):
        return True
    return place is not None and place.where is not None and place.where.row.source == "heat" and place.hot


def _can_give(state: str, played_step: PlayedStep) -> bool:
    own = set(state.lower().replace("-", " ").split())
    return any(state.lower() == given or set(given.split()) & own for given in played_step.motion.gives)
