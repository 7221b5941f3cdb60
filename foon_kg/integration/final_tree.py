"""A dish made on a bench as a tree: its units with their evidence, what was substituted, what was assumed."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import cast

from foon_kg.food import Tables, singular
from foon_kg.food.parted import parts_asked
from foon_kg.food.told_states import in_turn
from foon_kg.integration.bench import Bench, Done, Stuff
from foon_kg.integration.making.cooking import Cooking
from foon_kg.integration.preparing.preparation import Want
from foon_kg.integration.teaching.operators import Nearness
from foon_kg.model import ObjectNode
from foon_kg.model.claims import Alternative, Assumption, Substitution
from foon_kg.model.tree import Phase, Step, leaves_of
from foon_kg.world import Mention

MOST_ALTERNATIVES = 3
"""How many other foods are named beside the one that stands for another."""

_COOKED = "cooked"
_READ = 1.0
"""How sure it is what a crude word of a recipe means: it was read by a table, and no likeness was weighed."""


@dataclass(frozen=True)
class FinalTree:
    """A tree with all that a plan result says of it."""

    goal: ObjectNode
    units: tuple[Step, ...]
    kitchen: tuple[ObjectNode, ...]
    substitutions: tuple[Substitution, ...]
    assumptions: tuple[Assumption, ...]


Others = Callable[[str, str], Sequence[tuple[str, float]]]
"""Given a food and the one that was chosen for it: the other known foods that may stand for it, the likest first."""


def final_tree(bench: Bench, cooking: Cooking, dish: Stuff, wants: Sequence[Want], others: Others) -> FinalTree:
    """Return what happened on ``bench`` until ``dish`` was made.

    ``cooking`` has what was assumed, ``wants`` are the foods that were asked, ``others`` names what else could stand
    for one of them.
    """
    units = tuple(map(_unit, bench.done))
    return FinalTree(
        bench.mention(dish).node,
        units,
        leaves_of(units),
        (*_objects(bench, others), *_motions(bench), *dict.fromkeys(_states(bench, cooking, wants))),
        tuple(dict.fromkeys(_assumptions(bench, cooking))),
    )


def _unit(done: Done) -> Step:
    return replace(
        done.step,
        origin="foon" if done.attested.nearness is Nearness.FOOD else "adapted",
        seen_in=done.attested.seen_in,
        grounding=done.attested.nearness.word,
        phase=cast("Phase", done.phase),
    )


def _objects(bench: Bench, others: Others) -> Iterator[Substitution]:
    """Yield each food that is handled like another one, with the next best."""
    declared: set[tuple[str, str]] = set()
    for done in bench.done:
        if done.attested.like is None:
            continue
        food, like, confidence = done.attested.like
        if (singular(food), like) not in declared:
            declared.add((singular(food), like))
            rest = tuple(Alternative(name, round(sure, 4)) for name, sure in others(food, like)[:MOST_ALTERNATIVES])
            labels = (mention.node.label for mention in (*done.step.inputs, *done.step.outputs))
            name = next((label for label in labels if singular(label) == singular(food)), food)
            yield Substitution("object", name, name, like, round(confidence, 4), rest)


def _motions(bench: Bench) -> Iterator[Substitution]:
    """Yield what no video does to a thing, and is done to it: an appliance is turned off, a fish is steamed."""
    for (thing, required), (equivalent, sure) in sorted(bench.other_motions.items()):
        yield Substitution("motion", thing, required, equivalent, sure, ())


def _states(bench: Bench, cooking: Cooking, wants: Sequence[Want]) -> Iterator[Substitution]:
    """Yield each asked state that no node shows, with the one that stands for it."""
    shown = {
        (singular(mention.node.label), state)
        for done in bench.done
        for mention in (*done.step.inputs, *done.step.outputs)
        for state in mention.node.states
    }
    for want in wants:
        ready = cooking.ready.get(want.number)
        if ready is None:
            continue
        for state in in_turn(want.as_written or want.asked):
            names = (singular(want.label), *parts_asked(want.label, want.facts, state))
            if all((name, state) not in shown for name in names):
                yield Substitution("state", want.label, state, _read_as(want, shown, bench, ready.stuff), _READ)


def _read_as(want: Want, shown: Collection[tuple[str, str]], bench: Bench, stuff: Stuff) -> str:
    """Return the state that a step made of a food, as its own was read (skinned tomatoes are peeled); else its last."""
    made = not want.cooked and (singular(want.label), want.make) in shown
    return want.make if made else _state_now(bench, stuff, want)


def _state_now(bench: Bench, stuff: Stuff, want: Want) -> str:
    """Return the state that a food had last while it was by itself: the one that somebody made, if any did.

    What is asked by a word that only heat gives was at least cooked, whatever else the steps call it.
    """
    if want.cooked and want.asked != _COOKED and bench.known.state(want.asked).needs_heat:
        return _COOKED
    alone = list(_shown_alone(bench, stuff.number))
    last = alone[-1].node.states if alone else ()
    made = [state for state in last if state not in want.leaf]
    return next(iter((*made, *last, *want.leaf)), "")


def _shown_alone(bench: Bench, number: int) -> Iterator[Mention]:
    """Yield the mentions of the food ``number`` in steps that show its states, until it comes together with others.

    The step in which it does shows how it came; after that it is in the states of the mixture.
    """
    for done in bench.done:
        inputs = done.step.inputs
        foods = _foods_among(inputs, bench.known) if number in [one.thing for one in inputs] else []
        if number not in foods:
            continue
        shown = inputs if len(foods) > 1 else (*inputs, *done.step.outputs)
        yield from (mention for mention in shown if mention.thing == number and mention.node.states)
        if len(foods) > 1:
            return


def _foods_among(mentions: Sequence[Mention], known: Tables) -> list[int | None]:
    """Return the numbers of what is no utensil."""
    return [one.thing for one in mentions if known.utensil(singular(one.node.label)) is None]


def _assumptions(bench: Bench, cooking: Cooking) -> Iterator[Assumption]:
    """Yield what was assumed of each food, said of the first node that shows it: contract C6 lets nothing be silent."""
    asked = [(ready.stuff.number, ready.assumptions) for _, ready in sorted(cooking.ready.items())]
    for number, why in (*asked, *((number, [why]) for number, why in bench.assumed.items())):
        inputs = (mention for done in bench.done for mention in done.step.inputs)
        node = next((mention.node for mention in inputs if mention.thing == number), None) if why else None
        if node is not None:
            yield Assumption(node, "; ".join(dict.fromkeys(why)))
