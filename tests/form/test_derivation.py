"""How a unit of a tree may differ from its unit of the FOON (C8), case by case."""

from __future__ import annotations

import pytest
from kitchen_stories import unit

from foon_kg.form.derivation import derive
from foon_kg.form.tree import Substituted, TreeUnit
from foon_kg.kitchen import Kitchen


def entry(kind, food, required, equivalent):
    return Substituted(kind, food, required, equivalent, 0.8, ())


def derivation(mine, source, *entries):
    made = unit(mine)
    tree_unit = TreeUnit(made.input_nodes, made.motion, made.output_nodes)
    return derive(tree_unit, unit(source), entries, Kitchen.default())


def faults(mine, source, *entries):
    return [fault.reason for fault in derivation(mine, source, *entries).faults]


POUR = "spoon{salt}; salt@in spoon; bowl{egg,milk} > pour > bowl{egg,milk,salt}; salt@in bowl; spoon(empty)"


@pytest.mark.parametrize(
    "source",
    [
        POUR,
        "faucet(off); cup(empty) > turn on > faucet(on); cup{water}; water@in cup",
        "egg(whole); bowl(empty) > crack > bowl{egg white,egg yolk}; egg white@in bowl; egg yolk@in bowl",
    ],
)
def test_every_unit_comes_from_itself(source):
    found = derivation(source, source)
    assert (found.faults, found.used, found.undeclared) == ((), frozenset(), ())


@pytest.mark.parametrize(
    ("mine", "source"),
    [
        # foods taken out, consistently
        ("spoon{salt}; salt@in spoon; bowl{egg} > pour > bowl{egg,salt}; salt@in bowl; spoon(empty)", POUR),
        ("spoon{salt}; salt@in spoon; bowl(empty) > pour > bowl{salt}; salt@in bowl; spoon(empty)", POUR),
        # a food exchanged for another where any number may enter; the spoon served only the salt
        ("sugar; bowl{egg,milk} > pour > bowl{egg,milk,sugar}", POUR),
        ("sugar@in cup; cup{sugar}; bowl{egg} > pour > bowl{egg,sugar}; sugar@in bowl; cup(empty)", POUR),
        # a food added
        ("spoon{salt}; salt@in spoon; oil; bowl{egg} > pour > bowl{egg,oil,salt}; salt@in bowl; spoon(empty)", POUR),
        # what came in with a vessel stays in it
        ("bowl{egg,oil}; whisk > lift > bowl{egg,oil}; whisk(wet)", "bowl{egg}; whisk > lift > bowl{egg}; whisk(wet)"),
        # the oil is gone, and with it what it did to the tray
        ("tray(empty); bun > lay > tray{bun}; bun@on tray",
         "tray(empty,greased){oil}; bun > lay > tray{bun,oil}; bun@on tray"),
        ("tray; bun > lay > tray{bun}; bun@on tray", "tray@coated oil; bun > lay > tray{bun}; bun@on tray"),
        # one of two products taken out
        ("egg(whole); bowl(empty) > crack > bowl{egg white}; egg white@in bowl",
         "egg(whole); bowl(empty) > crack > bowl{egg white,egg yolk}; egg white@in bowl; egg yolk@in bowl"),
        # the ice of the glass is gone; there is ice in the juice that is poured, too
        ("glass(empty); jug{juice,ice}; juice{ice}@in jug > pour > glass{juice}; juice{ice}@in glass",
         "glass{ice}; ice@in glass; jug{juice}; juice@in jug > pour > glass{ice,juice}; juice@in glass"),
        # plural and singular are one name
        ("oats; bowl > weigh > bowl{oats}; oats@in bowl", "oats; bowl > weigh > bowl{oat}; oats@in bowl"),
    ],
)  # fmt: skip
def test_allowed_without_any_entry(mine, source):
    found = derivation(mine, source)
    assert (found.faults, found.undeclared) == ((), ())


@pytest.mark.parametrize(
    ("mine", "source", "said"),
    [
        ("onion; knife > chop > onion(chopped)", "onion; knife; board > chop > onion(chopped)", "left out"),
        ("onion; knife; fork > chop > onion(chopped)", "onion; knife > chop > onion(chopped)", "only foods are added"),
        ("onion; salt; knife > chop > onion(chopped)", "onion; knife > chop > onion(chopped)", "no more foods"),
        ("onion@in pan; knife > chop > onion(chopped)", "onion@in bowl; knife > chop > onion(chopped)", "in the bowl"),
        ("onion; knife > chop > onion(chopped)@in pan", "onion; knife > chop > onion(chopped)@in bowl", "leaves it"),
        ("onion; knife > chop > onion(chopped); sauce", "onion; knife > chop > onion(chopped)", "does not make it"),
        ("onion; knife > chop > knife(wet)", "onion; knife > chop > onion(chopped); knife(wet)", "is left out"),
        ("onion; pan{oil} > fry > pan{oil}", "onion; pan{oil} > fry > pan{oil,onion}", "is not in it"),
        ("pan{oil}; onion > fry > pan{oil,onion,leek}", "pan{oil}; onion > fry > pan{oil,onion}", "did not go in"),
        ("pan{oil} > fry > pan(hot){oil,leek}", "pan{oil,leek} > fry > pan(hot){oil,leek}", "taken out"),
        ("knife > chop > knife(wet)", "onion; knife > chop > onion(chopped); knife(wet)", "nothing to do"),
        ("salt@in spoon; bowl{egg} > pour > bowl{egg,salt}; salt@in bowl", POUR, "serves what is still there"),
        ("fork; sugar; bowl{egg} > pour > bowl{egg,sugar}", POUR, "only foods are added"),
    ],
)  # fmt: skip
def test_not_allowed(mine, source, said):
    assert any(said in reason for reason in faults(mine, source)), faults(mine, source)


DICE = "radish(whole)@on board; knife > dice > radish(diced)@on board; knife"
SLICED = "cucumber(whole)@on board; knife > slice > cucumber(sliced)@on board; knife"


def test_declared_substitutions_are_used():
    entries = (
        entry("object", "cucumber", "cucumber", "radish"),
        entry("state", "cucumber", "sliced", "diced"),
        entry("motion", "cucumber", "slice", "dice"),
    )
    found = derivation(SLICED, DICE, *entries)
    assert (found.faults, found.undeclared, found.used) == ((), (), frozenset(entries))


def test_what_is_not_declared_is_named():
    found = derivation(SLICED, DICE)
    assert found.faults == ()
    assert [(e.kind, e.object, e.required, e.equivalent) for e in found.undeclared] == [
        ("motion", "cucumber", "slice", "dice"),
        ("state", "cucumber", "sliced", "diced"),
        ("object", "cucumber", "cucumber", "radish"),
    ]


def test_an_entry_about_another_food_explains_nothing():
    found = derivation(
        "radish(whole)@on board; knife > slice > radish(sliced)@on board; knife",
        DICE,
        entry("state", "cucumber", "sliced", "diced"),
        entry("motion", "cucumber", "slice", "dice"),
    )
    assert not found.used
    assert {e.kind for e in found.undeclared} == {"state", "motion"}


def test_an_entry_for_a_food_inside_is_used():
    renamed = entry("object", "cucumber", "cucumber", "radish")
    found = derivation(
        "bowl{cucumber} > cover > bowl(covered){cucumber}", "bowl{radish} > cover > bowl(covered){radish}", renamed
    )
    assert (found.faults, found.used) == ((), {renamed})


def test_a_food_without_states_can_be_given_the_asked_one():
    given = entry("state", "pepper", "ground", "")
    weighed = "pepper(ground); bowl > weigh > pepper(ground)@in bowl"
    found = derivation(weighed, weighed.replace("(ground)", ""), given)
    assert (found.faults, found.undeclared, found.used) == ((), (), {given})


def test_a_state_that_gets_lost_is_a_difference():
    pressed = "garlic(peeled); press > press > garlic(paste)"
    found = derivation(pressed, pressed.replace("(peeled)", "(clove,peeled)"))
    assert [(e.required, e.equivalent) for e in found.undeclared] == [("", "clove")]


def test_a_vessel_is_empty_until_it_holds_something():
    lifted = "bowl(empty); whisk > lift > bowl(empty); whisk(wet)"
    assert derivation(lifted.replace("bowl(empty)", "bowl{oil}"), lifted).undeclared == ()
    (missing, *_) = derivation(lifted.replace("bowl(empty)", "bowl"), lifted).undeclared
    assert (missing.kind, missing.object, missing.equivalent) == ("state", "bowl", "empty")
