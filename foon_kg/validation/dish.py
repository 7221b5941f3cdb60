"""What a cook needs of the whole dish (docs/contract.md, K5 and K6): its name is true, and what was asked is in it."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

from foon_kg.food import Match, is_unbaked, singular, words
from foon_kg.food.lists import says, word_list
from foon_kg.food.parted import parts_asked
from foon_kg.food.rows import Dish, Food
from foon_kg.food.told_states import in_turn
from foon_kg.model import ObjectNode, RequiredIngredient
from foon_kg.validation.case import Case, names, was_taken_out
from foon_kg.validation.named import unheeded
from foon_kg.validation.report import Finding
from foon_kg.world import Part, PlayedStep
from foon_kg.world.becoming import meets

_DONE = frozenset({"boil", "cook"})
"""Treatments after which nothing is raw."""

_BLENDED = 4
"""How fine what was blended is at least."""

_COMES_LAST = (
    "topping", "herb", "spice", "salty", "sweet", "fat", "creamy", "liquid", "water", "ready", "dough", "starch",
)  # fmt: skip
"""Kinds of food that may come to a dish when all else is mixed."""


def defined(case: Case) -> Iterator[Finding]:
    """Yield the findings of K5 in ``case``: what defines the named dish is in it, finished, and hot where it is hot."""
    if case.goal is None:
        return
    if case.dish is None:
        yield Finding("K5", "nothing becomes the dish", None, (case.goal,))
        return
    yield from _unfinished(case)
    yield from unheeded(case)
    yield from _stirred_layers(case, case.goal)
    yield from _called_too_early(case, case.goal)
    for lack in missing(case, case.goal.label, *case.dish_types, case.title):
        yield Finding("K5", f"“{case.goal.label}” without {lack}", None, (case.goal,))
    if not _is_never_hot(case):
        yield from _unheated(case, case.goal)
        if case.recipe:
            yield from _raw_sauce(case, case.goal)
    yield from _unbaked(case, case.goal)


def _unbaked(case: Case, goal: ObjectNode) -> Iterator[Finding]:
    """Yield the names of the dish that are those of baked dishes, where it was not baked and does not set cold."""
    if _baked(case) or is_unbaked(case.title):
        return
    for dish in case.tables.dishes_named(*(case.dish_types if case.recipe else ()), case.title):
        bought = any(part.food.is_a(dish.name) for part in case.parts)  # bread that somebody dips was baked before
        if dish.baked and not bought and not _sets_cold(case, dish) and not _is_flat(case, dish):
            yield Finding("K5", f"“{dish.name}”, and it was never baked", None, (goal,))


def _called_too_early(case: Case, goal: ObjectNode) -> Iterator[Finding]:
    """Yield the steps that call something by the name of the dish before what makes that is in it."""
    needs = [need for dish in case.tables.dishes_named(goal.label) if dish.is_type for need in dish.needs]
    for played_step, need in itertools.product(case.played_steps, needs):
        early = tuple(node for node in played_step.outputs if node.label == goal.label and _lacks(case, node, need))
        if early and _has_one(case, need):
            first = need[0].rpartition(":")[2]
            yield Finding("K5", f"“{goal.label}” before {first} is in it", played_step.number, early)


def _lacks(case: Case, node: ObjectNode, needs: tuple[str, ...]) -> bool:
    """Whether a node tells of its foods, and none of these is or holds what is needed."""
    foods = [food for name in node.ingredients for food in _foods_called(case, name)]
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
    told = words(case.title)
    stirred = says(told, "is laid in no layers")
    return [] if stirred else [word for word in told if word in word_list("is laid in layers")][:1]


def _is_never_hot(case: Case) -> bool:
    """Whether a dish is called as one that is cold."""
    cold = any(dish.heated is False and not dish.is_type for dish in case.tables.dishes_named(case.title))
    return cold or says(words(case.title), "is never hot")


def _unheated(case: Case, goal: ObjectNode) -> Iterator[Finding]:
    """Yield the names of the dish that are those of hot dishes, where nothing in it was heated."""
    for dish in case.tables.dishes_named(goal.label, *case.dish_types, case.title):
        if dish.heated and not (_may_be_cold(case, dish) or _is_asked(case, dish) or _was_hot(case)):
            yield Finding("K5", f"“{dish.name}”, and nothing in it was heated", None, (goal,))


def _may_be_cold(case: Case, dish: Dish) -> bool:
    """Whether a dish of a name that hot ones have is made cold, too."""
    return is_unbaked(case.title) or _sets_cold(case, dish) or _is_blended_raw(case, dish)


def _was_hot(case: Case) -> bool:
    """Whether anything in the dish was heated."""
    return any(part.heated is not None for part in case.parts)


def _raw_sauce(case: Case, goal: ObjectNode) -> Iterator[Finding]:
    """Yield a sauce of raw roots with tomatoes or fruit that nobody heated, and that is not called as what is so."""
    if "sauce" not in case.dish_types or _was_hot(case) or _is_raw_sauce(case, goal):
        return
    roots = [part for part in _of_kind(case, "is fried for a sauce") if _DONE.isdisjoint(part.done)]
    if roots and _of_kind(case, "is simmered to a sauce"):
        yield Finding("K5", f"a sauce with raw {roots[0].name}, and nothing in it was heated", None, (goal,))


def _of_kind(case: Case, listed: str) -> list[Part]:
    """Return the parts of the dish that are of a kind in the list of words called ``listed``."""
    return [part for part in case.parts if part.food.is_any(word_list(listed))]


def _is_raw_sauce(case: Case, goal: ObjectNode) -> bool:
    """Whether a sauce is one that is eaten raw, by its name or by what is in it."""
    called = (*words(case.title), *words(goal.label))
    return says(called, "is a raw sauce") or bool(_of_kind(case, "makes a raw sauce"))


def _baked(case: Case) -> bool:
    """Whether something of the dish was in dry heat, in an oven or in a microwave, or a batter or dough in steam."""
    return any(
        played_step.does("heat") and (played_step.does("dry") or played_step.in_oven or _steams_dough(played_step))
        for played_step in case.played_steps
    )


def _steams_dough(played_step: PlayedStep) -> bool:
    """Whether a step steams what has flour in it."""
    parts = (part for lump in played_step.inputs for part in lump.parts)
    return played_step.does("steam") and any(part.food.is_a("flour", "dough") for part in parts)


def _sets_cold(case: Case, dish: Dish) -> bool:
    """Whether a dish that may be chilled on crumbs or biscuits has nothing in it that wants an oven."""
    raw = any(part.food.is_a("dough", "egg", "flour") for part in case.parts)
    return dish.name in word_list("sets cold on crumbs") and not raw


def _is_blended_raw(case: Case, dish: Dish) -> bool:
    """Whether a dish may be cold that is blended of what nobody heats for it."""
    blended = any(part.fine >= _BLENDED for part in _of_kind(case, "is blended raw"))
    return dish.name in word_list("is cold where it is blended raw") and blended


def _is_flat(case: Case, dish: Dish) -> bool:
    """Whether a dish that may be made in a pan was a batter, or was rolled thin and nothing in it raises it."""
    if dish.name not in word_list("is done in a pan where it is flat") or not _was_hot(case):
        return False
    table = case.tables.foods
    if any(table.food(lump.label).kind == "batter" for played_step in case.played_steps for lump in played_step.made):
        return True
    raises = word_list("makes dough rise") | {"egg", "leaven"}
    thin = any(played_step.does("shape") for played_step in case.played_steps)
    return thin and not any(part.food.is_any(raises) for part in case.parts)


def missing(case: Case, label: str, *texts: str) -> Iterator[str]:
    """Yield what the dish ``label`` of ``case`` needs by its name and has not, and its missing namesakes.

    ``texts`` are its type and title.
    """
    for dish in case.tables.dishes_named(label, *texts):
        for needs in dish.needs if not (_is_asked(case, dish) or _may_be_there(case, dish)) else ():
            if not _has_one(case, needs):
                yield " or ".join(dict.fromkeys(need.rpartition(":")[2] for need in needs))
    yield from (food for food in namesakes(case, label) if not _is_in(case, food))


def _is_asked(case: Case, dish: Dish) -> bool:
    """Whether the recipe asks for a dish as for a food, ready made: it brings its parts, and K1 looks at it."""
    own = set(words(dish.name))
    return dish.name not in case.dish_types and any(own <= set(words(food)) for food in case.required_names)


def _may_be_there(case: Case, dish: Dish) -> bool:
    """Whether a food of which nothing is known may be what a title names by ``dish``: datshi, a cheese."""
    return dish.may_be_unknown and any(not part.food.known for part in case.parts)


def missing_namesakes(case: Case, label: str) -> Iterator[str]:
    """Yield the foods that ``label``, a dish, is named after and ``case`` has not.

    Some are names of dishes too (chicken, tomato).
    """
    for dish in case.tables.dishes_named(label):
        own = [needs for needs in dish.needs if dish.name in {need.rpartition(":")[2] for need in needs}]
        if any(not _has_one(case, needs) for needs in own):
            yield dish.name
    yield from (food for food in namesakes(case, label) if not _is_in(case, food))


def _foods_called(case: Case, name: str) -> list[Food]:
    """Return what is known of the foods of a name that are in the dish, in their states; else of the name alone."""
    return [part.food for part in case.parts_by_name.get(singular(name), ())] or [case.tables.foods.food(name)]


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
    """Yield the foods that ``label``, a dish, is named after, words of dish types and dishes apart; longer names win.

    ``case`` has the tables that say what is a food.
    """
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
    """Yield the findings of K6 in ``case``: every asked food is in the dish, and mixed in where the rest is mixed.

    What is for serving is not cooked.
    """
    if case.dish is None:
        return
    yield from _unparted(case)
    beside = _for_serving(case)
    apart = _only_for(case, "is for the outside") | _only_for(case, "is for what is done")
    for food in sorted(case.required_names):
        parts = _parts_of(case, food)
        if not parts:
            if not was_taken_out(case, food):
                nodes = (case.goal,) if case.goal else ()
                yield Finding("K6", f"{food} was asked for and is not in the dish", None, nodes)
        elif food in beside:
            if _is_cooked_needlessly(parts):
                yield Finding("K6", f"{food} is for serving and is cooked with the rest", parts[0].heated)
        elif food not in apart and _is_left_out(case, parts):
            yield Finding("K6", f"{food} is not mixed with the rest", parts[0].joined)


def _is_left_out(case: Case, parts: Sequence[Part]) -> bool:
    """Whether all ``parts`` that there are of a food came to a mixed dish after the last mixing."""
    mixing = [part.mixed for part in case.parts if part.mixed is not None]
    return bool(mixing) and all(_came_after_mixing(case, part, max(mixing)) for part in parts) and _mixes(case)


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


def _only_for(case: Case, words_of: str) -> frozenset[str]:
    """Return the foods that the recipe asks for nothing but what a list of words says."""
    said = word_list(words_of)
    return frozenset(case.required_names - {singular(one.object) for one in case.required if one.part not in said})


def _is_asked_hot(case: Case, wanted: RequiredIngredient) -> bool:
    """Whether a recipe asks a food in a state that only heat gives."""
    return any(case.tables.state(state).needs_heat for state in in_turn(wanted.state))


def _is_cooked_needlessly(parts: Sequence[Part]) -> bool:
    """Whether all that there is of a food was heated, which needs no heat."""
    return all(part.heated is not None and _DONE.isdisjoint(part.food.owes) for part in parts)


def _parts_of(case: Case, food: str) -> list[Part]:
    if food in case.parts_by_name:
        return case.parts_by_name[food]
    own = set(food.split())
    return [
        part for name, parts in case.parts_by_name.items() for part in parts
        if name.split()[-1:] == food.split()[-1:] and (own <= set(name.split()) or set(name.split()) <= own)
    ]  # fmt: skip


def _came_after_mixing(case: Case, part: Part, last: int) -> bool:
    """Whether a part came to the dish after its ``last`` mixing, and is not of what is laid on or stirred in there."""
    if part.mixed == last or (part.mixed is not None and _is_of_a_dough(case, part.mixed)):
        return False  # it came on with the mixture: batter into a greased tin, a pancake under its sauce
    if part.joined is None or part.joined <= last or part.food.is_any(_COMES_LAST):
        return False
    return not _is_baked_on(case, part.joined) and not _crowns(case, part)


def _is_of_a_dough(case: Case, step: int) -> bool:
    """Whether what was mixed last at a step makes a dough or batter: egg or flour was, too."""
    return any(part.mixed == step and part.food.is_a("egg", "flour") for part in case.parts)


def _is_baked_on(case: Case, joined: int) -> bool:
    """Whether something is in dry heat after the step at which a food came to it: so is what lies on a pizza."""
    return any(played_step.does("dry") and played_step.number > joined for played_step in case.played_steps)


def _crowns(case: Case, part: Part) -> bool:
    """Whether a part lies on top of what is cooked, or of what is drunk."""
    crowns = word_list("lies on what is cooked") | word_list("lies on what is eaten with a spoon")
    drunk = says(case.dish_types, "is drunk")
    return part.food.is_any(crowns) and (drunk or _was_hot(case))


def _mixes(case: Case) -> bool:
    """Whether the dish is one whose foods are mixed: it says so, or it was a dough or batter once."""
    if case.goal is not None and "mixed" in case.goal.states:
        return True
    table, own = case.tables.foods, {id(part) for part in case.parts}
    for played_step in case.played_steps:
        for lump in played_step.made:
            if table.food(lump.label).is_a("dough") and any(id(part) in own for part in lump.parts):
                return True
    return False
