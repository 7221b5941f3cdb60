"""What a cook needs of the whole dish (docs/contract.md, K5 to K7): its name is true, and what was asked is in it."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

from foon_kg.food import Match, is_unbaked, singular, words
from foon_kg.food.lists import word_list
from foon_kg.food.parted import parts_asked
from foon_kg.food.rows import Dish
from foon_kg.food.told_states import in_turn
from foon_kg.model import ObjectNode, RequiredIngredient
from foon_kg.validation.case import Case, names, was_taken_out
from foon_kg.validation.named import unheeded
from foon_kg.validation.report import Finding
from foon_kg.validation.robot import never_lit, of_world
from foon_kg.world import Happening, Part, Vessel
from foon_kg.world.becoming import meets

_DONE = frozenset({"boil", "cook"})
"""Treatments after which nothing is raw."""

_GROUND = 4
"""As fine as this (crushed, grated), a topping binds what it is stirred into."""


def defined(case: Case) -> Iterator[Finding]:
    """K5: what defines the named dish is in it, it is finished, and a hot dish was heated."""
    if case.goal is None:
        return
    if case.dish is None:
        yield Finding("K5", "nothing becomes the dish", None, (case.goal,))
        return
    yield from _unfinished(case)
    yield from unheeded(case)
    yield from _stirred_layers(case, case.goal)
    yield from _called_too_early(case, case.goal)
    title = case.recipe.title or "" if case.recipe else ""
    for lack in missing(case, case.goal.label, *case.dish_types, title):
        yield Finding("K5", f"“{case.goal.label}” without {lack}", None, (case.goal,))
    if not _is_never_hot(case, title):
        yield from _unheated(case, case.goal, title)
        if case.recipe:
            yield from _raw_sauce(case, case.goal, title)
    for dish in case.tables.dishes_named(*(case.dish_types if case.recipe else ()), title):
        bought = any(part.food.is_a(dish.name) for part in case.parts)  # bread that somebody dips was baked before
        if dish.baked and not (bought or _baked(case) or is_unbaked(title) or _sets_cold(case, dish)):
            yield Finding("K5", f"“{dish.name}”, and it was never baked", None, (case.goal,))


def _called_too_early(case: Case, goal: ObjectNode) -> Iterator[Finding]:
    """Yield the steps that call something by the name of the dish before what makes that is in it."""
    needs = [need for dish in case.tables.dishes_named(goal.label) if dish.is_type for need in dish.needs]
    for happening, need in itertools.product(case.happenings, needs):
        early = tuple(node for node in happening.outputs if node.label == goal.label and _lacks(case, node, need))
        if early and _has_one(case, need):
            first = need[0].rpartition(":")[2]
            yield Finding("K5", f"“{goal.label}” before {first} is in it", happening.number, early)


def _lacks(case: Case, node: ObjectNode, needs: tuple[str, ...]) -> bool:
    """Whether a node tells of its foods, and none of these is or holds what is needed."""
    foods = [case.tables.foods.food(name) for name in node.ingredients]
    there = any(food.is_a("made") or any(meets(one, food, case.tables) for one in needs) for food in foods)
    return bool(foods) and not there


def _stirred_layers(case: Case, goal: ObjectNode) -> Iterator[Finding]:
    """Yield a dish that is called by its layers, where the last that mixes anything mixes all that is in it."""
    (last, *others) = {part.mixed for part in case.parts} or {None}
    together = len(case.parts) > 1 and last is not None and not others
    for name in _layered(case) if together else ():
        yield Finding("K5", f"“{name}”, and all of it is stirred together", last, (goal,))


def _layered(case: Case) -> list[str]:
    """Return the first word of the title by which a dish lies in layers, if any."""
    told = words(case.recipe.title or "") if case.recipe else ()
    stirred = not word_list("is laid in no layers").isdisjoint(told)
    return [] if stirred else [word for word in told if word in word_list("is laid in layers")][:1]


def _is_never_hot(case: Case, title: str) -> bool:
    """Whether a dish is called as one that is cold."""
    cold = any(dish.heated is False and not dish.is_type for dish in case.tables.dishes_named(title))
    return cold or not word_list("is never hot").isdisjoint(words(title))


def _unheated(case: Case, goal: ObjectNode, title: str) -> Iterator[Finding]:
    """Yield the names of the dish that are those of hot dishes, where nothing in it was heated."""
    for dish in case.tables.dishes_named(goal.label, *case.dish_types, title):
        warm = _is_asked(case, dish) or is_unbaked(title) or any(part.heated is not None for part in case.parts)
        if dish.heated and not warm:
            yield Finding("K5", f"“{dish.name}”, and nothing in it was heated", None, (goal,))


def _raw_sauce(case: Case, goal: ObjectNode, title: str) -> Iterator[Finding]:
    """Yield a sauce of raw roots with tomatoes or fruit that nobody heated, and that is not called as what is so."""
    called = {*words(title), *words(goal.label)}
    eaten_raw = not word_list("is a raw sauce").isdisjoint(called)
    eaten_raw = eaten_raw or any(part.food.is_a(*word_list("makes a raw sauce")) for part in case.parts)
    if eaten_raw or "sauce" not in case.dish_types or any(part.heated is not None for part in case.parts):
        return
    roots = [part for part in case.parts if part.food.is_a(*word_list("is fried for a sauce"))]
    roots = [part for part in roots if _DONE.isdisjoint(part.done)]
    if roots and any(part.food.is_a(*word_list("is simmered to a sauce")) for part in case.parts):
        yield Finding("K5", f"a sauce with raw {roots[0].name}, and nothing in it was heated", None, (goal,))


def _baked(case: Case) -> bool:
    """Whether something of the dish was in dry heat, in an oven or in a microwave."""
    return any(happening.does("heat") and (happening.does("dry") or happening.in_oven) for happening in case.happenings)


def _sets_cold(case: Case, dish: Dish) -> bool:
    """Whether a dish that may be chilled on crumbs has nothing in it that wants an oven."""
    raw = any(part.food.is_a("dough", "egg", "flour") for part in case.parts)
    return dish.name in word_list("sets cold on crumbs") and not raw


def missing(case: Case, label: str, *texts: str) -> Iterator[str]:
    """Yield what a dish needs by its name (``texts`` are its type and title) and has not, and its missing namesakes."""
    for dish in case.tables.dishes_named(label, *texts):
        for needs in dish.needs if not _is_asked(case, dish) else ():
            if not _has_one(case, needs):
                yield " or ".join(dict.fromkeys(need.rpartition(":")[2] for need in needs))
    yield from (food for food in namesakes(case, label) if not _is_in(case, food))


def _is_asked(case: Case, dish: Dish) -> bool:
    """Whether the recipe asks for a dish as for a food, ready made: it brings its parts, and K1 looks at it."""
    own = set(words(dish.name))
    return dish.name not in case.dish_types and any(own <= set(words(food)) for food in case.required_names)


def missing_namesakes(case: Case, label: str) -> Iterator[str]:
    """Yield the foods that a dish is named after and has not; some are names of dishes too (chicken, tomato)."""
    for dish in case.tables.dishes_named(label):
        own = [needs for needs in dish.needs if dish.name in {need.rpartition(":")[2] for need in needs}]
        if any(not _has_one(case, needs) for needs in own):
            yield dish.name
    yield from (food for food in namesakes(case, label) if not _is_in(case, food))


def _has_one(case: Case, needs: tuple[str, ...]) -> bool:
    if any(meets(need, part.food, case.tables) for need in needs for part in case.parts):
        return True
    gone = (name for name in case.required_names if name not in case.parts_by_name and was_taken_out(case, name))
    return any(meets(need, case.tables.foods.food(name), case.tables) for name in gone for need in needs)


def _unfinished(case: Case) -> Iterator[Finding]:
    if case.goal is None:
        return
    own = words(case.goal.label)
    if own and (own[-1] in case.tables.unfinished or singular(case.goal.label) in case.tables.unfinished):
        yield Finding("K5", f"“{case.goal.label}” is no finished dish", None, (case.goal,))
    for state in case.goal.states:
        if case.tables.state(state).half or state in {"uncooked", "raw", "uncook"}:
            yield Finding("K5", f"the dish is {state}", None, (case.goal,))


def namesakes(case: Case, label: str) -> Iterator[str]:
    """Yield the foods that a dish is named after, the words of dish types and dishes apart; longer names win."""
    own, start = words(label), 0
    while start < len(own):
        for end in range(len(own), start, -1):
            if end - start == len(own) > 1:
                continue  # the dish itself, as a shop may sell it
            name = " ".join(own[start:end])
            if _is_food_name(case, name, last=end == len(own)) and name not in case.tables.dishes:
                yield name
                start = end - 1
                break
        start += 1


def _is_food_name(case: Case, name: str, *, last: bool) -> bool:
    """Whether a name is that of a food, and not of something made; what a label ends with may be bought ready."""
    kind, _, match = case.tables.foods.find(name)
    if match is not Match.NAME:
        return False
    made = {"made", "dough", *(("ready", "creamy", "liquid") if last else ())}
    return made.isdisjoint(case.tables.foods.kinds[kind].traits)


def _is_in(case: Case, food: str) -> bool:
    if food in case.parts_by_name:
        return True
    own, head = set(food.split()), food.rpartition(" ")[2]
    for name in case.parts_by_name:
        if own <= set(name.split()) or (name.rpartition(" ")[2] == head and set(name.split()) <= own):
            return True
    kind = case.tables.foods.find(food)[0]
    return food == kind and any(part.food.is_a(kind) for part in case.parts)


def asked(case: Case) -> Iterator[Finding]:
    """K6: every asked food is in the dish, and mixed in where the rest is mixed; what is for serving is not cooked."""
    if case.dish is None:
        return
    yield from _unparted(case)
    beside = _for_serving(case)
    mixing = [part.mixed for part in case.parts if part.mixed is not None]
    for food in sorted(case.required_names):
        parts = _parts_of(case, food)
        if not parts and not was_taken_out(case, food):
            yield Finding("K6", f"{food} was asked for and is not in the dish", None, (case.goal,) if case.goal else ())
        elif food in beside:
            if parts and _is_cooked_for_nothing(parts):
                yield Finding("K6", f"{food} is for serving and is cooked with the rest", parts[0].heated)
        elif parts and mixing and all(_left_out(case, part, max(mixing)) for part in parts) and _mixes(case):
            yield Finding("K6", f"{food} is not mixed with the rest", parts[0].joined)


def _unparted(case: Case) -> Iterator[Finding]:
    """Yield what is asked in its two parts, which are never apart from each other."""
    labels = {singular(node.label) for node in case.tree.nodes}
    for wanted in sorted(set(case.required)):
        food = singular(wanted.object)
        parts = parts_asked(food, case.tables.foods.food(food), wanted.state)
        if not labels.issuperset(parts):
            reason = f"{wanted.object} is asked {wanted.state}, and {names(parts)} are never apart"
            yield Finding("K6", reason, minor=True)


def _for_serving(case: Case) -> frozenset[str]:
    """Return the foods of which the recipe says that they are served with the dish, and nothing else (not roasted)."""
    said = word_list("is for what is done")
    inside = {
        singular(wanted.object) for wanted in case.required if wanted.part not in said or _is_asked_hot(case, wanted)
    }
    return frozenset(case.required_names - inside)


def _is_asked_hot(case: Case, wanted: RequiredIngredient) -> bool:
    """Whether a recipe asks a food in a state that only heat gives."""
    return any(case.tables.state(state).needs_heat for state in in_turn(wanted.state))


def _is_cooked_for_nothing(parts: Sequence[Part]) -> bool:
    """Whether all that there is of a food was heated, which needs no heat."""
    return all(part.heated is not None and {"boil", "cook"}.isdisjoint(part.food.owes) for part in parts)


def _parts_of(case: Case, food: str) -> list[Part]:
    if food in case.parts_by_name:
        return case.parts_by_name[food]
    own = set(food.split())
    return [
        part for name, parts in case.parts_by_name.items() for part in parts
        if name.split()[-1:] == food.split()[-1:] and (own <= set(name.split()) or set(name.split()) <= own)
    ]  # fmt: skip


def _left_out(case: Case, part: Part, last: int) -> bool:
    if part.mixed == last or (part.mixed is not None and part.food.is_a("egg", "flour")):
        return False  # it came on with the mixture: batter into a greased tin, a pancake under its sauce
    if part.joined is None or part.joined <= last:
        return False
    baked_on = any(h.does("dry") and h.number > part.joined for h in case.happenings)  # as what lies on a pizza
    hot = any(part.heated is not None for part in case.parts)
    drunk = not word_list("is drunk").isdisjoint(case.dish_types)
    crowns = word_list("lies on what is cooked") | word_list("lies on what is eaten with a spoon")
    return (
        not baked_on
        and not ((hot or drunk) and part.food.is_a(*crowns))
        and not part.food.is_a(
            "topping", "herb", "spice", "salty", "sweet", "fat", "creamy", "liquid", "water", "ready", "dough", "starch"
        )
    )


def _mixes(case: Case) -> bool:
    """Whether the dish is one whose foods are mixed: it says so, or it was a dough or batter once."""
    if case.goal is not None and "mixed" in case.goal.states:
        return True
    table, own = case.tables.foods, {id(part) for part in case.parts}
    for happening in case.happenings:
        for lump in happening.made:
            if table.food(lump.label).is_a("dough") and any(id(part) in own for part in lump.parts):
                return True
    return False


def sense(case: Case) -> Iterator[Finding]:
    """K7: what no cook would do: dough of cooked pasta, fat through a strainer, a misread word."""
    yield from of_world("K7", case)
    for happening in case.happenings:
        yield from _dough(happening)
        if happening.does("separate") and _strains(happening) and _all_fat(happening):
            yield Finding("K7", "fat is poured through a strainer", happening.number, minor=True)
        if happening.does("dry"):
            yield from _ungreased(case, happening)
    yield from never_lit(case)
    yield from _misread(case)
    yield from _drunk_in_pieces(case)
    stirred = [part for part in case.parts if part.food.is_a("topping") and part.mixed is not None]
    toppings = {part.name for part in stirred if part.fine < _GROUND}
    if toppings:
        yield Finding("K7", f"{names(toppings)} belongs on top and is stirred in", minor=True)


def _drunk_in_pieces(case: Case) -> Iterator[Finding]:
    """Yield the foods of a drink that had to be blended, where its name does not say that they lie in it."""
    told = set(words(case.recipe.title or "")) if case.recipe else set()
    other = word_list("is called by pieces in it") | word_list("is drunk hot")
    if word_list("is drunk").isdisjoint(case.dish_types) or not told.isdisjoint(other):
        return
    kinds = frozenset[str]()
    if any(part.food.is_a(*word_list("makes a blended drink")) for part in case.parts):
        kinds |= word_list("is drunk blended")
    if not any(part.food.is_a("spirit") for part in case.parts):
        kinds |= word_list("is no drink until it is blended")
    slices = word_list("is a slice on a glass")
    mixed = [part for part in case.parts if part.mixed is not None and part.fine < _GROUND]
    pieces = {part.name for part in mixed if part.food.is_a(*kinds) and not part.food.is_a(*slices)}
    if pieces:
        yield Finding("K7", f"{names(pieces)} is drunk in pieces", min(part.mixed or 0 for part in mixed))


def _misread(case: Case) -> Iterator[Finding]:
    """Yield asked foods whose word means something else in the state in which they were asked (pepper, stick, fat)."""
    table = case.tables.foods
    for wanted in sorted(set(case.required)):
        name = singular(wanted.object)
        if name not in table.homonyms or not wanted.state:
            continue
        meant = table.food(name, (wanted.state,)).kind
        kinds = {part.food.kind for part in case.parts_by_name.get(name, ())}
        if kinds and meant not in kinds:
            yield Finding(
                "K7", f"{wanted.object} ({wanted.state}) is {meant}, and it was taken for {min(kinds)}", minor=True
            )


def _dough(happening: Happening) -> Iterator[Finding]:
    for lump in happening.made:
        if lump.label.rpartition(" ")[2] in {"dough", "batter"}:
            pasta = [part.name for part in lump.parts if part.food.is_a("dry starch") and "boil" in part.done]
            if pasta:
                yield Finding("K7", f"{lump.label} is made of cooked {pasta[0]}", happening.number)


def _strains(happening: Happening) -> bool:
    return any("strain" in vessel.row.can for vessel in happening.vessels)


def _all_fat(happening: Happening) -> bool:
    parts = [part for lump in happening.inputs for part in lump.parts]
    return bool(parts) and all(part.food.is_a("fat") for part in parts)


def _ungreased(case: Case, happening: Happening) -> Iterator[Finding]:
    for vessel in happening.heated:
        soft = [
            lump
            for lump in vessel.lumps
            if lump.mixed and any(part.food.is_a("flour", "dough", "egg") for part in lump.parts)
        ]
        if soft and "bake" in vessel.row.can and not _is_greased(case, vessel, happening):
            yield Finding("K7", f"the {vessel.label} is not greased", happening.number, minor=True)


def _is_greased(case: Case, vessel: Vessel, until: Happening) -> bool:
    for happening in case.happenings[: until.number + 1]:
        for lump, _, now in happening.moved:
            if now is vessel and lump.parts and all(part.food.is_a("fat", "flour") for part in lump.parts):
                return True
        for mention in (*happening.step.inputs, *happening.step.outputs):
            said = case.read(mention.node)
            told = " ".join((*mention.node.states, *mention.node.ingredients))
            if said.label == vessel.label and any(word in told for word in ("greased", "paper", "foil", "floured")):
                return True
    return False
