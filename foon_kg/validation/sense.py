"""What no cook would do (docs/contract.md, K7): dough of cooked pasta, fat through a strainer, a drink in pieces."""

from __future__ import annotations

from collections.abc import Iterator

from foon_kg.food import singular, words
from foon_kg.food.lists import says, word_list
from foon_kg.validation.case import Case, names
from foon_kg.validation.report import Finding
from foon_kg.validation.robot import never_lit, of_world
from foon_kg.world import Lump, Part, PlayedStep, Vessel

_GROUND = 4
"""As fine as this (crushed, grated), a topping binds what it is stirred into."""

_SLICE = 2
"""As fine as this are slices."""

_LINED = ("greased", "paper", "foil", "floured")
"""Words by which a node says that nothing sticks to a vessel."""


def sense(case: Case) -> Iterator[Finding]:
    """Yield the findings of K7 in ``case``: what no cook would do.

    That is dough of cooked pasta, fat through a strainer, a misread word.
    """
    yield from of_world("K7", case)
    for played_step in case.played_steps:
        yield from _dough(played_step)
        if played_step.does("separate") and _strains(played_step) and _all_fat(played_step):
            yield Finding("K7", "fat is poured through a strainer", played_step.number, minor=True)
        if played_step.does("dry"):
            yield from _ungreased(case, played_step)
    yield from never_lit(case)
    yield from _misread(case)
    yield from _drunk_in_pieces(case)
    yield from _stirred_toppings(case)
    yield from _stirred_bread(case)


def _stirred_toppings(case: Case) -> Iterator[Finding]:
    """Yield the toppings that are mixed into the dish in pieces."""
    toppings = {part.name for part in _mixed_in_pieces(case) if part.food.is_a("topping")}
    if toppings:
        yield Finding("K7", f"{names(toppings)} belongs on top and is stirred in", minor=True)


def _stirred_bread(case: Case) -> Iterator[Finding]:
    """Yield bread in large pieces, untoasted, that is stirred into what it is eaten with."""
    if not says(case.dish_types, "is eaten with bread"):
        return
    for part in _mixed_in_pieces(case):
        mixed = part.mixed or 0
        toasted = part.heated is not None and part.heated < mixed
        if part.food.is_a("bread") and part.fine <= _SLICE and not toasted:
            yield Finding("K7", f"{part.name} in such large pieces is stirred in", mixed)


def _drunk_in_pieces(case: Case) -> Iterator[Finding]:
    """Yield the foods of a drink that had to be blended, where its name does not say that they lie in it."""
    kinds = _only_drunk_blended(case)
    if not kinds:
        return
    pieces = [part for part in _mixed_in_pieces(case) if not part.food.is_any(word_list("is a slice on a glass"))]
    thick = [part for part in pieces if part.food.is_any(kinds)]
    if thick:
        step = min(part.mixed or 0 for part in thick)
        yield Finding("K7", f"{names(part.name for part in thick)} is drunk in pieces", step)


def _mixed_in_pieces(case: Case) -> list[Part]:
    return [part for part in case.parts if part.mixed is not None and part.fine < _GROUND]


def _only_drunk_blended(case: Case) -> frozenset[str]:
    """Return the kinds of food that are in pieces in no drink such as this one; none for what is no drink."""
    pieces_told = word_list("is called by pieces in it") | word_list("is drunk hot")
    if not says(case.dish_types, "is drunk") or not pieces_told.isdisjoint(words(case.title)):
        return frozenset()
    if any(part.food.is_any(word_list("is drunk with pieces in it")) for part in case.parts):
        return frozenset()
    kinds = frozenset[str]()
    if any(part.food.is_any(word_list("makes a blended drink")) for part in case.parts):
        kinds |= word_list("is drunk blended")
    if not any(part.food.is_a("spirit") for part in case.parts):
        kinds |= word_list("is no drink until it is blended")
    return kinds


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


def _dough(played_step: PlayedStep) -> Iterator[Finding]:
    for lump in played_step.made:
        if lump.label.rpartition(" ")[2] in {"dough", "batter"}:
            pasta = [part.name for part in lump.parts if part.food.is_a("dry starch") and "boil" in part.done]
            if pasta:
                yield Finding("K7", f"{lump.label} is made of cooked {pasta[0]}", played_step.number)


def _strains(played_step: PlayedStep) -> bool:
    return any("strain" in vessel.row.can for vessel in played_step.vessels)


def _all_fat(played_step: PlayedStep) -> bool:
    parts = [part for lump in played_step.inputs for part in lump.parts]
    return bool(parts) and all(part.food.is_a("fat") for part in parts)


def _ungreased(case: Case, played_step: PlayedStep) -> Iterator[Finding]:
    """Yield the moulds and trays in which a step bakes a dough or batter that sticks to them."""
    for vessel in played_step.heated:
        sticks = "bake" in vessel.row.can and any(_sticks(lump) for lump in vessel.lumps)
        if sticks and not _is_greased(case, vessel, played_step):
            yield Finding("K7", f"the {vessel.label} is not greased", played_step.number, minor=True)


def _sticks(lump: Lump) -> bool:
    return lump.mixed and any(part.food.is_a("flour", "dough", "egg") for part in lump.parts)


def _is_greased(case: Case, vessel: Vessel, until: PlayedStep) -> bool:
    """Whether fat came into a vessel up to a step, or a node says that it is greased or lined."""
    for played_step in case.played_steps[: until.number + 1]:
        if any(now is vessel and _greases(lump) for lump, _, now in played_step.moved):
            return True
        for mention in (*played_step.step.inputs, *played_step.step.outputs):
            told = " ".join((*mention.node.states, *mention.node.ingredients))
            if any(word in told for word in _LINED) and case.read(mention.node).label == vessel.label:
                return True
    return False


def _greases(lump: Lump) -> bool:
    return bool(lump.parts) and all(part.food.is_a("fat", "flour") for part in lump.parts)
