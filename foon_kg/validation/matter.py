"""Whether a food as it is can undergo what a step does, and a tool gives it (docs/contract.md, W4)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from foon_kg.food import Food, Utensil
from foon_kg.food.lists import says, word_list
from foon_kg.model import ObjectNode
from foon_kg.model.tree import Mention
from foon_kg.validation.case import Case
from foon_kg.validation.report import Finding
from foon_kg.world import PlayedStep, Vessel


def matter(case: Case) -> Iterator[Finding]:
    """Yield the findings of W4 in ``case`` about the matter of foods: what is kneaded, strained, grated, laid down."""
    for played_step in case.played_steps:
        for node in played_step.outputs:
            thing = _Matter(node, case)
            for reason in _cannot_be(thing, played_step):
                yield Finding("W4", reason, played_step.number, (node,))
            if _is_stirred_whole(thing, played_step):
                yield Finding("W4", f"nobody stirs a whole {node.label}", played_step.number, (node,), minor=True)


class _Matter:
    """What comes out of a step as its node tells it: foods are worked on later, and their things with them."""

    def __init__(self, node: ObjectNode, case: Case) -> None:
        self.node = node
        self.case = case

    @cached_property
    def foods(self) -> list[Food]:
        """What is known of its parts, or of it where it has none."""
        return [self.case.tables.foods.food(name) for name in sorted(self.node.ingredients) or [self.node.label]]

    @property
    def mixed(self) -> bool:
        """Whether it is made of more than one food."""
        return len(self.node.ingredients) > 1

    @cached_property
    def heated(self) -> bool:
        """Whether one of its states is one that only heat gives."""
        rows = map(self.case.tables.state, self.node.states)
        return any(row.needs_heat or "cook" in row.earns for row in rows)

    @cached_property
    def place(self) -> Utensil | None:
        """The vessel that it is in or on."""
        place = self.case.read(self.node).place_utensil
        return place if place is not None and place.role == "vessel" else None

    def has(self, what: str) -> bool:
        """Return whether one of its foods is of the list ``what``."""
        return any(food.is_any(word_list(what)) for food in self.foods)


def _cannot_be(thing: _Matter, played_step: PlayedStep) -> Iterator[str]:
    """Yield why what came out of a step cannot be so: by its matter, where it is, and by the tools of the step."""
    name = thing.node.label
    if _is_no_dough(thing, played_step):
        yield f"nothing in {name} can be kneaded or rolled out"
    if _is_in_a_strainer(thing, played_step) and _runs_through(thing):
        yield f"no strainer holds {name}"
    if _is_on_bare_board(thing, played_step) and _runs_off(thing):
        yield f"{name} runs off a board"
    yield from _unfit_for(thing, played_step)


def _is_no_dough(thing: _Matter, played_step: PlayedStep) -> bool:
    """Whether it was kneaded or rolled out raw, and is wet, and nothing in it makes a dough or paste."""
    worked = played_step.step.motion in word_list("works a dough") and thing.mixed and not thing.heated
    if not worked or not thing.has("makes a dough too wet") or thing.has("can be kneaded"):
        return False
    parts = played_step.outputs[thing.node].parts  # a person may forget to name one again
    return not any(part.food.is_any(word_list("can be kneaded")) for part in parts if part.taken <= played_step.number)


def _is_in_a_strainer(thing: _Matter, played_step: PlayedStep) -> bool:
    """Whether it was poured off into a vessel that lets liquid through, and is not pressed through that later."""
    held = thing.place is not None and "strain" in thing.place.can
    poured = held and played_step.step.motion in word_list("pours off")
    return poured and not _is_pressed_through(thing, played_step)


def _runs_through(thing: _Matter) -> bool:
    """Whether it is a paste, or a meal that was boiled to a porridge."""
    if says(thing.node.states, "keeps its shape"):
        return False
    return says(thing.node.states, "is a paste") or (thing.heated and thing.has("swells to a porridge"))


def _is_pressed_through(thing: _Matter, played_step: PlayedStep) -> bool:
    """Whether it is worked through the strainer later: the seeds of raspberries stay in there, and the rest runs."""
    later = thing.case.played_steps[played_step.number + 1 :]
    through = (one for one in later if one.step.motion in word_list("works through a strainer"))
    return any(mention.node == thing.node for one in through for mention in one.step.inputs)


def _is_on_bare_board(thing: _Matter, played_step: PlayedStep) -> bool:
    """Whether it is on a board on which no other food lies that could hold it, as a leaf or a dough does."""
    if thing.place is None or thing.place.group != "boards" or not played_step.does("move"):
        return False
    return _what_lies_on(thing.node.container, thing.case, played_step) <= {thing.node.label, *thing.node.ingredients}


def _what_lies_on(place: str | None, case: Case, played_step: PlayedStep) -> set[str]:
    """Return the foods that the nodes after a step tell of a ``place``: its own node, and theirs that are there."""
    nodes = [mention.node for mention in played_step.step.outputs]
    held = {name for node in nodes if node.label == place for name in node.ingredients}
    return held | {node.label for node in nodes if node.container == place and case.is_food(node)}


def _runs_off(thing: _Matter) -> bool:
    """Whether it is a raw mixture with a liquid, and nothing in it takes that up."""
    raw = thing.mixed and not thing.heated and not says(thing.node.states, "keeps its shape")
    return raw and thing.has("makes a mixture run") and not thing.has("takes up liquid")


def _unfit_for(thing: _Matter, played_step: PlayedStep) -> Iterator[str]:
    """Yield what none of the tools of a step does: scissors or a scraper cut nothing hard, a knife does not grate."""
    tools = _tools_of(played_step) if played_step.does("cut", "grate") else []
    if not tools:
        return
    if _is_grated(thing, played_step) and not any("grate" in one.row.can for one in played_step.vessels):
        yield f"{thing.node.label} is grated without a grater"
    elif {tool.label for tool in tools} <= word_list("is no knife") and thing.has("no scissors cut"):
        yield f"a {tools[0].label} does not cut {thing.node.label}"


def _tools_of(played_step: PlayedStep) -> list[Vessel]:
    return [vessel for vessel in played_step.vessels if vessel.row.role == "tool"]


def _is_grated(thing: _Matter, played_step: PlayedStep) -> bool:
    """Whether a step says that it is grated, and it was not before."""
    before = {state for one in played_step.step.inputs for state in one.node.states}
    return not (set(thing.node.states) - before).isdisjoint(word_list("is so by a grater"))


def _is_stirred_whole(thing: _Matter, played_step: PlayedStep) -> bool:
    """Whether it is a joint or a bird in one piece, and stirred."""
    stirred = says(played_step.step.motion.split(), "stirs") and not thing.mixed
    fine = max((thing.case.tables.state(state).fineness for state in thing.node.states), default=0)
    return stirred and not fine and thing.has("is turned in one piece")


def out_of_nowhere(case: Case) -> Iterator[Finding]:
    """Yield a finding of W4 for each food of ``case`` that goes into a step in a state that no step gave it."""
    last: dict[int, ObjectNode] = {}
    for place, unit in enumerate(case.tree.units):
        for mention in unit.inputs:
            claimed = _claimed(mention, last, case)
            if claimed:
                reason = f"{mention.node.label} is {', '.join(claimed)} now, and no step made it so"
                yield Finding("W4", reason, place, (mention.node,))
        # a thing without a number cannot be followed: nobody knows which of two onions was chopped
        last.update((one.thing, one.node) for one in unit.outputs if one.thing is not None)


def _claimed(mention: Mention, last: Mapping[int, ObjectNode], case: Case) -> list[str]:
    """Return the states in which a food goes in and that take work, which it had not when it was ``last`` told."""
    was = last.get(mention.thing) if mention.thing is not None else None
    if was is None or not case.is_food(mention.node):
        return []
    fresh = sorted(set(mention.node.states) - set(was.states))
    return [state for state in fresh if _takes_work(case, state)]


def _takes_work(case: Case, state: str) -> bool:
    """Whether somebody has to make a food so: it is not sold so, and it counts as treated or is in pieces then."""
    row = case.tables.state(state)
    return not row.sold and bool(row.earns or row.fine)


def second_of_one(case: Case) -> Iterator[Finding]:
    """Yield a finding of W4 for each vessel of ``case`` that is filled while the only one of its kind is full."""
    full: dict[str, int] = {}
    for place, unit in enumerate(case.tree.units):
        for mention in _vessels(unit.outputs, case):
            label, thing = case.read(mention.node).label, mention.thing
            if thing is None:
                continue
            if not mention.node.ingredients:
                full = {name: number for name, number in full.items() if number != thing}
            elif full.setdefault(label, thing) != thing:  # told once: from here on this one is the full one
                yield Finding("W4", f"the {label} is full, and there is no second one", place, (mention.node,))
                full[label] = thing


def _vessels(mentions: Sequence[Mention], case: Case) -> Iterator[Mention]:
    """Yield those of ``mentions`` that are vessels of which a kitchen has but one."""
    for mention in mentions:
        row = case.read(mention.node).utensil
        if row is not None and row.role == "vessel" and not row.many:
            yield mention
