"""Steps wait for what they need and for nothing else: every order that keeps it does the same with the same nodes."""

from __future__ import annotations

import random

from foons import units as any_units
from hypothesis import given
from hypothesis import strategies as st

from foon_kg.model import ObjectNode
from foon_kg.model.tree import Mention, Step
from foon_kg.plans.step_order import earlier_steps


def step(inputs, motion, outputs):
    return Step.of(tuple(inputs), motion, tuple(outputs), "foon", ())


ONION, CHOPPED = ObjectNode("onion", ("whole",)), ObjectNode("onion", ("chopped",))
EGG, BEATEN = ObjectNode("egg", ("whole",)), ObjectNode("egg", ("beaten",))
KNIFE, OMELETTE = ObjectNode("knife"), ObjectNode("omelette")
CHOP, BEAT = step([ONION, KNIFE], "chop", [CHOPPED, KNIFE]), step([EGG], "beat", [BEATEN])


def test_a_step_waits_for_what_makes_its_inputs_and_not_for_what_is_beside_it():
    fry = step([CHOPPED, BEATEN], "fry", [OMELETTE])
    assert earlier_steps([CHOP, BEAT, fry]) == (frozenset(), frozenset(), {0, 1})


def test_a_tool_that_stays_as_it_is_makes_nobody_wait():
    leek = step([ObjectNode("leek"), KNIFE], "slice", [ObjectNode("leek", ("sliced",)), KNIFE])
    assert earlier_steps([CHOP, leek]) == (frozenset(), frozenset())


def test_what_is_used_up_is_first_given_to_those_who_took_it_before():
    taste = step([CHOPPED], "taste", [CHOPPED, ObjectNode("smile")])
    fry = step([CHOPPED], "fry", [OMELETTE])
    assert earlier_steps([CHOP, taste, fry]) == (frozenset(), {0}, {0, 1})


def makers(units, order):
    """From which unit (or the kitchen) each unit takes each input when they are done in this order."""
    made, takes = {}, {}
    for place in order:
        takes[place] = {node: made.get(node) for node in units[place].input_nodes}
        for node in units[place].output_nodes:
            if node not in units[place].input_nodes:
                made[node] = place
    return takes


@given(st.lists(any_units, min_size=1, max_size=7), st.randoms(use_true_random=False))
def test_in_every_order_that_waits_as_told_the_same_units_take_from_the_same(some, chance: random.Random):
    steps = [Step.of_unit(unit, "foon", ()) for unit in some]
    before = earlier_steps(steps)
    order: list[int] = []
    while len(order) < len(steps):
        ready = [i for i in range(len(steps)) if i not in order and before[i] <= set(order)]
        order.append(chance.choice(ready))
    assert makers(steps, order) == makers(steps, range(len(steps)))


BOWL = ObjectNode("bowl", ("empty",))
FULL = ObjectNode("bowl", (), ("onion",))


def numbered(inputs, motion, outputs, phase=None):
    taken, made = (tuple(Mention(*one) for one in side) for side in (inputs, outputs))
    return Step(taken, motion, made, "foon", (), phase=phase)


def test_two_bowls_that_look_alike_are_filled_side_by_side_and_one_bowl_is_not():
    def fill(bowl, onion):
        return numbered([(BOWL, bowl), (CHOPPED, onion)], "pour", [(FULL, bowl), (CHOPPED, onion)])

    def empty(bowl, onion):
        return numbered([(FULL, bowl), (CHOPPED, onion)], "pour", [(BOWL, bowl)])

    assert earlier_steps([fill(1, 2), fill(3, 4)]) == (frozenset(), frozenset())
    assert earlier_steps([fill(1, 2), empty(1, 2), fill(1, 3)]) == (frozenset(), {0}, {1})


def test_nothing_is_heated_before_what_is_prepared_is_ready():
    chop = numbered([(ONION, 1)], "chop", [(CHOPPED, 1)], "prepare")
    beat = numbered([(EGG, 2)], "beat", [(BEATEN, 2)], "prepare")
    fry = numbered([(BEATEN, 2)], "fry", [(OMELETTE, 3)], "heat")
    serve = numbered([(OMELETTE, 3)], "serve", [(ObjectNode("omelette", ("served",)), 3)], "finish")
    assert earlier_steps([chop, beat, fry, serve]) == (frozenset(), frozenset(), {0, 1}, {2})


def test_a_mixer_is_turned_on_when_what_it_mixes_is_there_and_an_oven_before_that():
    def tree(device):
        off, on = (ObjectNode(device, (state,)) for state in ("off", "on"))
        return (
            numbered([(EGG, 1), (BOWL, 2)], "pour", [(EGG, 1), (FULL, 2)]),
            numbered([(off, 3)], "turn on", [(on, 3)]),
            numbered([(on, 3), (FULL, 2)], "mix", [(on, 3), (ObjectNode("bowl", ("mixed",)), 2)]),
        )

    assert earlier_steps(tree("hand mixer")) == (frozenset(), {0}, {0, 1})
    assert earlier_steps(tree("oven")) == (frozenset(), frozenset(), {0, 1})
