"""What a cook needs of each food (docs/contract.md, K1 to K4): nothing raw, whole, late or torn by the wrong tool."""

from __future__ import annotations

from collections.abc import Iterator

from foon_kg.food import Level, singular, words
from foon_kg.food.bites import is_eaten_by_bites
from foon_kg.food.lists import word_list
from foon_kg.validation.case import Case
from foon_kg.validation.meeting import hot_on_cold, lumpy
from foon_kg.validation.report import Finding
from foon_kg.validation.robot import of_world
from foon_kg.world import Happening, Part

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
}  # fmt: skip


def raw(case: Case) -> Iterator[Finding]:
    """K1: what must be cooked is cooked by a unit, and dry starch in a liquid."""
    title = case.recipe.title or "" if case.recipe else ""
    called = [dish for dish in case.tables.dishes_named(title) if not dish.is_type]
    eaten_raw = frozenset(kind for dish in called for kind in dish.raw)
    types = set(case.dish_types) & word_list("may hold raw egg") if title else case.dish_types
    eased = frozenset(kind for dish in (*case.tables.dishes_named(*types), *called) for kind in dish.eases)
    bound = bool(title) and not word_list("holds no raw egg").isdisjoint(case.dish_types)
    for part in case.parts:
        if part.remains or part.untold or part.food.is_a(*eaten_raw):
            continue
        for treatment in ("cook", "boil"):
            level = part.food.owes.get(treatment)
            if level in {None, Level.ADVICE} or treatment in part.done:
                continue
            minor = part.food.is_a(*eased) or (level is Level.MINOR and not (bound and part.food.is_a("egg")))
            how = "in enough liquid" if treatment == "boil" else "at all"
            yield Finding("K1", f"{part.name} is in the dish and was not cooked {how}", minor=minor)
    yield from _never_hot(case)


def _never_hot(case: Case) -> Iterator[Finding]:
    """Yield flour that nothing heated, whatever was stirred into it, and what was to make it rise."""
    ours = [part for part in case.parts if not part.remains and not part.untold]
    flours = [part for part in ours if any(map(part.food.is_of, word_list("is raw flour")))]
    leavens = [part for part in ours if flours and part.food.is_a("leaven")]
    dusts = any(part.food.is_a(*word_list("is dusted with starch")) for part in ours)
    for part in [*flours, *(part for part in leavens if part not in flours)]:
        dust = part.food.is_a("starch") and dusts
        if part.heated is None and not dust and not part.food.is_a(*word_list("is flour eaten raw")):
            yield Finding("K1", f"{part.name} is in the dish, and nothing heated it", part.joined)


def whole(case: Case) -> Iterator[Finding]:
    """K2: nothing whole, unpeeled or in its shell that nobody eats so, and no remains for the food."""
    for part in case.parts:
        if part.remains:
            if not _asked_so(case, part):
                yield Finding("K2", f"the remains of {part.name} are in the dish")
            continue
        if part.untold:
            continue
        for treatment, level in sorted(part.food.owes.items()):
            if treatment not in _WHOLE or level is Level.ADVICE or _is_done(part, treatment):
                continue
            spread = part.fine > 0 and treatment in word_list("is spread by cutting")
            yield Finding(
                "K2", f"{part.name} is in the dish {_WHOLE[treatment]}", minor=level is Level.MINOR and not spread
            )
        if part.food.is_a(*word_list("is taken out of the dish")) and _is_left_in(case, part):
            yield Finding("K2", f"{part.name} is in the dish, and nobody eats it", minor=True)
    yield from _more_than_a_bite(case)


def _more_than_a_bite(case: Case) -> Iterator[Finding]:
    """Yield what is in halves that are more than a bite, in a dish that is eaten with a spoon or fork alone."""
    title = case.recipe.title or "" if case.recipe else ""
    told = [word for text in (*case.dish_types, title) for word in words(text)]
    if not is_eaten_by_bites(told, case.tables.dishes_named(*case.dish_types, title)):
        return
    for part in case.parts:
        if part.fine == _HALVED and part.food.is_a(*word_list("is more than a bite in halves")):
            yield Finding("K2", f"half of one {part.name} is more than a bite", minor=True)


def _is_left_in(case: Case, part: Part) -> bool:
    """Whether what only gives its taste is still in the dish, by its name, and in one piece."""
    told = {singular(food) for food in case.goal.ingredients} if case.goal is not None else set[str]()
    plucked = not word_list("is plucked off its stem").isdisjoint((*part.states, *words(part.name)))
    plucked = plucked and not part.food.is_a(*word_list("is a leaf by itself"))
    return part.fine == 0 and not plucked and (part.name in told or not told)


def _is_done(part: Part, treatment: str) -> bool:
    if treatment == "cut" and part.fine > 0:
        return True
    return not ENOUGH.get(treatment, frozenset({treatment})).isdisjoint(part.done)


def _asked_so(case: Case, part: Part) -> bool:
    """Whether a recipe asks for the part of a food that this is (a lemon's zest, an onion's skin)."""
    asked = {state for wanted in case.required if wanted.object == part.name for state in wanted.state.split()}
    states = {state for lump in case.dish_lumps if part in lump.parts for state in (*lump.states, *part.states)}
    return any(asked & set(state.split()) for state in states)


def late(case: Case) -> Iterator[Finding]:
    """K3: liquid after the last cooking; what is cooked beside what is eaten raw; what joins too hot, or too dry."""
    cooked = [part.heated for part in case.parts if part.heated is not None]
    hot = any(dish.heated for dish in case.tables.dishes_named(*case.dish_types))
    if cooked and hot:
        for part in case.parts:
            if part.heated is None and (part.joined or part.taken) > max(cooked) and _needs_heat(part):
                yield Finding("K3", f"{part.name} comes after the last cooking", part.joined, minor=True)
    yield from _cooked_too_much(case)
    for happening in case.happenings:
        yield from _peeled_hot(happening)
        yield from _killed(case, happening)
    yield from hot_on_cold(case)
    yield from lumpy(case)


def _killed(case: Case, happening: Happening) -> Iterator[Finding]:
    """Yield what makes dough rise where it is mixed with water that boiled and did not cool."""
    if not happening.does("mix", "knead"):
        return
    boiling = word_list("is boiled water")
    nodes = [mention.node for mention in happening.step.inputs if case.is_food(mention.node)]
    hot = any(not boiling.isdisjoint(node.states) and "cooled" not in node.states for node in nodes)
    for node in nodes if hot else ():
        food = case.tables.foods.food(node.label, node.states)
        if food.is_a(*word_list("makes dough rise")) and not food.is_a("flour"):
            yield Finding("K3", f"{node.label} is killed by boiling water", happening.number, (node,))


def _needs_heat(part: Part) -> bool:
    return part.food.is_a("cooking liquid") and not part.food.is_a("creamy", "fat", "ready")


def _cooked_too_much(case: Case) -> Iterator[Finding]:
    for happening in case.happenings:
        if not happening.does("heat"):
            continue
        parts = [part for vessel in happening.heated for lump in vessel.lumps for part in lump.parts]
        owing = [part for part in parts if part.food.owes.get("cook") is Level.FATAL]
        leaves = sorted({part.name for part in parts if part.food.is_a("salad leaf")})
        if owing and leaves:
            reason = f"{leaves[0]} is cooked together with {owing[0].name}"
            yield Finding("K3", reason, happening.number, minor=True)


def _peeled_hot(happening: Happening) -> Iterator[Finding]:
    if not happening.does("peel", "shell"):
        return
    for part in (part for lump in happening.treated for part in lump.parts):
        if part.food.is_a("egg") and part.heated is not None and part.heated < happening.number:
            cooled = [part.done.get("wash", -1), part.done.get("soak", -1)]
            if max(cooled) < part.heated:
                yield Finding("K3", "eggs are peeled boiling hot", happening.number, minor=True)
                return


def tools(case: Case) -> Iterator[Finding]:
    """K4: grating without what grates; cutting or mixing with a lid; a motion that cannot give that state."""
    yield from of_world("K4", case)
    for happening in case.happenings:
        if happening.does("grate") and not _has(happening, "grate", "peel"):
            yield Finding("K4", "it is grated without grater, peeler or processor", happening.number)
        lids = [node for node in happening.tools if _is_lid(case, node.label)]
        others = [vessel for vessel in happening.vessels if vessel.row.role in {"tool", "appliance"}]
        if lids and not others and happening.does("cut", "mix", "grate", "whip"):
            yield Finding("K4", f"“{happening.step.motion}” with a lid", happening.number, (lids[0],))


def _has(happening: Happening, *abilities: str) -> bool:
    return any(not vessel.row.can.isdisjoint(abilities) for vessel in happening.vessels)


def _is_lid(case: Case, label: str) -> bool:
    row = case.tables.utensil(label)
    return row is not None and row.role == "lid"
