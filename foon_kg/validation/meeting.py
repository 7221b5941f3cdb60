"""What meets what, and how hot (docs/contract.md, K3): nothing hot on what stays cold, no dry flour in what is hot."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from foon_kg.food import words
from foon_kg.food.lists import says, word_list
from foon_kg.validation.case import Case
from foon_kg.validation.report import Finding
from foon_kg.world import Lump, Part, PlayedStep, Vessel


def hot_on_cold(case: Case) -> Iterator[Finding]:
    """Yield a finding for what comes hot to leaves or to what is creamy in the dish of ``case``, a cold one.

    It did not cool before.
    """
    if not _is_dressed_cold(case):
        return
    cold = [part for part in case.parts if part.heated is None and part.food.is_any(word_list("suffers from heat"))]
    for part in case.parts:
        met = next((other for other in cold if not _has_cooled(part, other)), None)
        if met is not None and not part.food.is_a("fat", "liquid", "water", *word_list("only flavours")):
            yield Finding("K3", f"{part.name} comes hot to {met.name}", part.joined, minor=True)


def _is_dressed_cold(case: Case) -> bool:
    """Whether a dish is of a type that is dressed, and its title calls it by nothing that is eaten warm."""
    dressed = any(dish.dressed for dish in case.tables.dishes_named(*case.dish_types))
    return dressed and not says(words(case.title), "is eaten warm")


def _has_cooled(part: Part, other: Part) -> bool:
    """Whether a food cooled after its last heating, and not only together with another, or was never hot."""
    if part.heated is None:
        return True
    # what cools in the same step as the other lies with it already, and has warmed it
    return part.cooled is not None and part.cooled > part.heated and part.cooled != other.cooled


def lumpy(case: Case) -> Iterator[Finding]:
    """Yield a finding for each starch or flour of ``case`` that comes dry into a hot liquid: it makes lumps there.

    Not where it makes a batter or a dough with what is in there: eggs or what makes it rise.
    """
    if any(part.food.is_any(word_list("makes no sauce of what binds")) for part in case.parts):
        return
    hot: defaultdict[int, set[str]] = defaultdict(set)  # by the identity of the vessel: two pots may look alike
    for played_step in case.played_steps:
        for lump, _, vessel in played_step.moved:
            names = hot.get(id(vessel), set()) if vessel is not None else set()
            wet = sorted(name for name in names if case.tables.foods.food(name).is_of(*word_list("is a bath")))
            if wet and _is_dry_starch(lump, played_step):
                yield Finding("K3", f"{lump.label} comes dry into hot {wet[0]}", played_step.number)
        _keep_hot(played_step, hot)


def _is_dry_starch(lump: Lump, played_step: PlayedStep) -> bool:
    """Whether what moved is starch or flour by itself, as it comes out of its packet."""
    mention = next((node for node, one in played_step.outputs.items() if one is lump), None)
    if mention is None or mention.ingredients or says(mention.states, "runs"):
        return False
    return any(part.food.kind in word_list("makes lumps") and part.name == lump.label for part in lump.parts)


def _keep_hot(played_step: PlayedStep, hot: dict[int, set[str]]) -> None:
    """Keep by vessel the foods that were heated in it; what cools or is emptied holds none."""
    gone = [*played_step.emptied, *(played_step.vessels if played_step.does("wait", "clean") else ())]
    for vessel in gone:
        hot.pop(id(vessel), None)
    for vessel in played_step.heated if played_step.does("heat", "warm") else ():
        hot[id(vessel)] |= _inside(played_step, vessel)


def _inside(played_step: PlayedStep, vessel: Vessel) -> set[str]:
    """Return the foods that a step says to be in a vessel."""
    nodes = [mention.node for mention in played_step.step.inputs if mention.node.label == vessel.label]
    return {food for node in nodes for food in node.ingredients}
