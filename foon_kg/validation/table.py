"""What a cook needs of each food (docs/contract.md, K1 to K4): nothing raw, whole, late or torn by the wrong tool."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from foon_kg.food import Level, singular, words
from foon_kg.food.bites import is_eaten_by_bites, stays_whole
from foon_kg.food.lists import says, word_list
from foon_kg.food.rows import Dish
from foon_kg.model import ObjectNode
from foon_kg.validation.case import Case
from foon_kg.validation.meeting import hot_on_cold, lumpy
from foon_kg.validation.report import Finding
from foon_kg.validation.robot import of_world
from foon_kg.world import Part, PlayedStep

ENOUGH = {
    "cut": frozenset({"cut", "grate", "grind", "blend", "mash"}),
    "peel": frozenset({"peel"}),
    "shell": frozenset({"shell", "open", "peel"}),
    "core": frozenset({"core", "stone"}),
    "stone": frozenset({"stone", "core"}),
    "husk": frozenset({"husk", "peel", "cut"}),
    "choke": frozenset({"choke", "core"}),
}
"""What does for each treatment that a food asks for."""

_HALVED = 1
"""How fine a food in halves is (:class:`~foon_kg.food.rows.State`)."""

_WHOLE = {
    "cut": "in one piece", "peel": "in its skin", "shell": "in its shell", "core": "with its core",
    "stone": "with its stone", "husk": "in its husk", "choke": "with its choke",
    "soak": "as hard as it was dried",
}  # fmt: skip


def raw(case: Case) -> Iterator[Finding]:
    """Yield the findings of K1 in ``case``: what must be cooked and no unit cooks (dry starch: boils), raw flour."""
    called = [dish for dish in case.tables.dishes_named(case.title) if not dish.is_type]
    eased = _eased(case, called)
    for part in _eaten_cooked(case, called):
        for treatment, level in _owed_heat(case, part):
            how = "in enough liquid" if treatment == "boil" else "at all"
            minor = level is Level.MINOR or (part.food.is_any(eased) and not _is_asked_cooked(case, part))
            yield Finding("K1", f"{part.name} is in the dish and was not cooked {how}", minor=minor)
    yield from _never_hot(case)
    yield from _bare(case)


def _bare(case: Case) -> Iterator[Finding]:
    """Yield what nobody eats raw by itself (garlic, curry powder), on what is hot, with nothing that takes it up."""
    late = _after_all_heat(case)
    if any(part.food.is_any(word_list("takes up what is raw")) for part in late):
        return
    asked = {singular(one.object) for one in case.required if one.part} | {*words(case.title or "")}
    for part in late:
        if part.food.is_any(word_list("is not eaten raw by itself")) and part.name not in asked:
            yield Finding("K1", f"{part.name} lies raw on what is done", part.joined)


def _after_all_heat(case: Case) -> list[Part]:
    """Return the parts of a dish that come to it when nothing is heated any more; none where nothing ever was."""
    heated = [part.heated for part in case.parts if part.heated is not None]
    cold = [part for part in case.parts if part.heated is None and not part.unstated]
    return [part for part in cold if heated and (part.joined or part.taken) > max(heated)]


def _eaten_cooked(case: Case, called: Sequence[Dish]) -> list[Part]:
    """Return the parts of the dish that nobody eats raw, in a dish that is ``called`` so."""
    eaten_raw = frozenset(kind for dish in called for kind in dish.raw)
    told = [part for part in case.parts if not part.unstated and not part.remains]
    return [part for part in told if not part.food.is_any(eaten_raw)]


def _eased(case: Case, called: Sequence[Dish]) -> frozenset[str]:
    """Return the kinds of food that may be raw without being fatal: by the dish's type, and by what it is ``called``.

    A title says more than the type: where there is one, only a type that may hold raw egg eases anything.
    """
    types = set(case.dish_types) & word_list("may hold raw egg") if case.title else case.dish_types
    return frozenset(kind for dish in (*case.tables.dishes_named(*types), *called) for kind in dish.eases)


def _is_asked_cooked(case: Case, part: Part) -> bool:
    """Whether a recipe asks for the food that a part is in states alone that heat gives: boiled eggs for a sauce."""
    asked = [one.state for one in case.required if singular(one.object) == part.name]
    return bool(asked) and all(case.tables.state(state).needs_heat for state in asked)


def _may_not_be_raw_egg(case: Case, part: Part) -> bool:
    """Whether a part is egg in a dish with a title, of a type that holds no raw egg."""
    return bool(case.title) and part.food.is_a("egg") and says(case.dish_types, "holds no raw egg")


def _owed_heat(case: Case, part: Part) -> Iterator[tuple[str, Level]]:
    """Yield the ways of cooking that a part of a food still needs, each with how bad it is to leave it out."""
    for treatment in ("cook", "boil"):
        level = part.food.owes.get(treatment)
        if level is None or level is Level.ADVICE or treatment in part.done:
            continue
        yield treatment, Level.FATAL if _may_not_be_raw_egg(case, part) else level


def _never_hot(case: Case) -> Iterator[Finding]:
    """Yield flour that nothing heated, whatever was stirred into it, and what was to make it rise."""
    ours = [part for part in case.parts if not part.remains and not part.unstated]
    dusts = any(part.food.is_any(word_list("is dusted with starch")) for part in ours)
    for part in _raised(ours):
        dust = dusts and part.food.is_a("starch")
        if part.heated is None and not dust and not part.food.is_any(word_list("is flour eaten raw")):
            yield Finding("K1", f"{part.name} is in the dish, and nothing heated it", part.joined)


def _raised(parts: Sequence[Part]) -> list[Part]:
    """Return those of ``parts`` that are flour, then what makes this rise, where there is any flour."""
    flours = [part for part in parts if any(map(part.food.is_of, word_list("is raw flour")))]
    leavens = [part for part in parts if part.food.is_a("leaven") and part not in flours]
    return flours + leavens if flours else []


def whole(case: Case) -> Iterator[Finding]:
    """Yield the findings of K2 in ``case``: food that nobody eats whole, unpeeled or in its shell, and remains."""
    for part in case.parts:
        if part.remains:
            if not _asked_so(case, part):
                yield Finding("K2", f"the remains of {part.name} are in the dish")
        elif not part.unstated:
            if not _stays_whole(case, part):
                yield from _untreated(part)
            if part.food.is_any(word_list("is taken out of the dish")) and _is_left_in(case, part):
                yield Finding("K2", f"{part.name} is in the dish, and nobody eats it", minor=True)
    yield from _more_than_a_bite(case)


def _stays_whole(case: Case, part: Part) -> bool:
    """Whether a recipe asks for a food in one piece that stays so in a dish of such a type: olives, a whole chilli."""
    asked = [one.state for one in case.required if singular(one.object) == part.name]
    return part.fine == 0 and any(stays_whole(part.food, asked, dish_type) for dish_type in case.dish_types)


def _untreated(part: Part) -> Iterator[Finding]:
    """Yield what a part of a food needed before anybody eats it and did not get, heat apart."""
    for treatment, level in sorted(part.food.owes.items()):
        if treatment not in _WHOLE or level is Level.ADVICE or _is_done(part, treatment):
            continue
        if treatment == "soak" and part.food.is_any(word_list("is done without soaking")):
            continue
        spread = part.fine > 0 and treatment in word_list("is spread by cutting")
        minor = level is Level.MINOR and not spread
        yield Finding("K2", f"{part.name} is in the dish {_WHOLE[treatment]}", minor=minor)


def _more_than_a_bite(case: Case) -> Iterator[Finding]:
    """Yield what is in halves that are more than a bite, in a dish that is eaten with a spoon or fork alone."""
    told = [word for text in (*case.dish_types, case.title) for word in words(text)]
    if not is_eaten_by_bites(told, case.tables.dishes_named(*case.dish_types, case.title)):
        return
    for part in case.parts:
        small = says(words(part.name), "is a small one")
        small = small or _is_asked_in_soft_halves(case, part)
        if part.fine == _HALVED and not small and part.food.is_any(word_list("is more than a bite in halves")):
            yield Finding("K2", f"half of one {part.name} is more than a bite", minor=True)


def _is_asked_in_soft_halves(case: Case, part: Part) -> bool:
    """Whether a recipe asks for halves that were cooked, which a spoon divides."""
    soft = part.food.is_any(word_list("is soft in halves when it is cooked"))
    return soft and not part.done.keys().isdisjoint({"cook", "boil"}) and _asked_so(case, part)


def _is_left_in(case: Case, part: Part) -> bool:
    """Whether what only gives its taste is still in the dish, by its name, and in one piece."""
    told = {singular(food) for food in case.goal.ingredients} if case.goal is not None else set[str]()
    plucked = says((*part.states, *words(part.name)), "is plucked off its stem")
    plucked = plucked and not part.food.is_any(word_list("is a leaf by itself"))
    return part.fine == 0 and not plucked and (part.name in told or not told)


def _is_done(part: Part, treatment: str) -> bool:
    if treatment == "cut" and part.fine > 0:
        return True
    return not ENOUGH.get(treatment, frozenset({treatment})).isdisjoint(part.done)


def _asked_so(case: Case, part: Part) -> bool:
    """Whether a recipe asks for the part of a food that this is (a lemon's zest, an onion's skin)."""
    wanted = (one for one in case.required if singular(one.object) == part.name)
    asked = {word for one in wanted for word in one.state.split()}
    states = {state for lump in case.dish_lumps if part in lump.parts for state in (*lump.states, *part.states)}
    return any(asked & set(state.split()) for state in states)


def late(case: Case) -> Iterator[Finding]:
    """Yield the findings of K3 in ``case``: what comes too late, too hot or too dry, or is cooked beside raw food."""
    yield from _after_the_heat(case)
    yield from _cooked_too_much(case)
    for played_step in case.played_steps:
        yield from _peeled_hot(played_step)
        yield from _killed(case, played_step)
    yield from hot_on_cold(case)
    yield from lumpy(case)


def _after_the_heat(case: Case) -> Iterator[Finding]:
    """Yield the liquids of a hot dish that come to it when nothing is heated any more."""
    heated = [part.heated for part in case.parts if part.heated is not None]
    if not heated or not any(dish.heated for dish in case.tables.dishes_named(*case.dish_types)):
        return
    for part in filter(_needs_heat, case.parts):
        if (part.joined or part.taken) > max(heated):
            yield Finding("K3", f"{part.name} comes after the last cooking", part.joined, minor=True)


def _killed(case: Case, played_step: PlayedStep) -> Iterator[Finding]:
    """Yield what makes dough rise where it is mixed with water that boiled and did not cool."""
    if not played_step.does("mix", "knead"):
        return
    nodes = [mention.node for mention in played_step.step.inputs if case.is_food(mention.node)]
    if not any(_is_boiling(node) for node in nodes):
        return
    for node in nodes:
        food = case.tables.foods.food(node.label, node.states)
        if food.is_any(word_list("makes dough rise")) and not food.is_a("flour"):
            yield Finding("K3", f"{node.label} is killed by boiling water", played_step.number, (node,))


def _is_boiling(node: ObjectNode) -> bool:
    return "cooled" not in node.states and says(node.states, "is boiled water")


def _needs_heat(part: Part) -> bool:
    """Whether a part is a liquid in which something is cooked, and was never over heat."""
    return part.heated is None and part.food.is_a("cooking liquid") and not part.food.is_a("creamy", "fat", "ready")


def _cooked_too_much(case: Case) -> Iterator[Finding]:
    """Yield leaves that are eaten raw, where they are over heat with what has to be cooked."""
    for played_step in case.played_steps:
        parts = _over_heat(played_step) if played_step.does("heat") else []
        owing = [part.name for part in parts if part.food.owes.get("cook") is Level.FATAL]
        leaves = [part.name for part in parts if part.food.is_a("salad leaf")]
        if owing and leaves:
            reason = f"{min(leaves)} is cooked together with {owing[0]}"
            yield Finding("K3", reason, played_step.number, minor=True)


def _over_heat(played_step: PlayedStep) -> list[Part]:
    """Return the parts of all foods in the vessels that a step heats."""
    return [part for vessel in played_step.heated for lump in vessel.lumps for part in lump.parts]


def _peeled_hot(played_step: PlayedStep) -> Iterator[Finding]:
    if not played_step.does("peel", "shell"):
        return
    for part in (part for lump in played_step.treated for part in lump.parts):
        if part.food.is_a("egg") and part.heated is not None and part.heated < played_step.number:
            cooled = [part.done.get("wash", -1), part.done.get("soak", -1)]
            if max(cooled) < part.heated:
                yield Finding("K3", "eggs are peeled boiling hot", played_step.number, minor=True)
                return


def tools(case: Case) -> Iterator[Finding]:
    """Yield the findings of K4 in ``case``: grating without what grates, cutting or mixing with a lid.

    So is a motion that cannot give its state.
    """
    yield from of_world("K4", case)
    for played_step in case.played_steps:
        if played_step.does("grate") and not _has(played_step, "grate", "peel"):
            yield Finding("K4", "it is grated without grater, peeler or processor", played_step.number)
        if played_step.does("cut", "mix", "grate", "whip"):
            yield from _with_a_lid(case, played_step)


def _with_a_lid(case: Case, played_step: PlayedStep) -> Iterator[Finding]:
    """Yield a step that has a lid, and no tool or appliance to do its work with."""
    lids = [node for node in played_step.tools if _is_lid(case, node.label)]
    if lids and not any(vessel.row.role in {"tool", "appliance"} for vessel in played_step.vessels):
        yield Finding("K4", f"“{played_step.step.motion}” with a lid", played_step.number, (lids[0],))


def _has(played_step: PlayedStep, *abilities: str) -> bool:
    return any(not vessel.row.can.isdisjoint(abilities) for vessel in played_step.vessels)


def _is_lid(case: Case, label: str) -> bool:
    row = case.tables.utensil(label)
    return row is not None and row.role == "lid"
