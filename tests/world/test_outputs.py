"""What comes out of a step by its motion; and what could not become so."""

from __future__ import annotations

import pytest
from world.playing import faults, foods, play


@pytest.mark.parametrize(
    ("food", "minor"),
    [
        ("water", True), ("black pepper", True), ("basil", True), ("butter", True), ("sugar", True), ("yeast", True),
        ("salt", True), ("onion", False), ("beef", False), ("flour", False), ("milk", False),
    ],
)  # fmt: skip
def test_what_did_not_go_in_is_a_slip_only_where_every_kitchen_has_it(food, minor):
    step = f"tomato (sliced) + bowl (empty) → MIX → salad ({{{food}, tomato}}; in bowl) + bowl ({{salad}})"
    (told,) = faults(play(step))
    assert told.startswith("W2 (minor)" if minor else "W2 step")
    assert told.endswith(f": it holds {food}, which did not go in")


def test_an_ingredient_that_did_not_go_in_is_told_once():
    world = play("""
tomato (sliced) + bowl (empty) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
salad ({onion, tomato}; in bowl) + plate (empty) → PUT → salad ({onion, tomato}; on plate) + plate ({salad})
""")
    assert len(faults(world)) == 1


def after(text):
    """Return the foods after the steps."""
    return foods(play(text))


SALAD = """
tomato (sliced) + onion (sliced) + bowl (empty) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
"""


@pytest.mark.parametrize(
    ("motion", "joins"),
    [
        ("combine", True), ("blend", True), ("mash", True), ("knead", True), ("whip", True), ("grind", True),
        ("shape", True), ("coat", True), ("put", False), ("boil", False), ("wait", False), ("slice", False),
    ],
)  # fmt: skip
def test_what_makes_one_thing_of_several_joins_a_food_to_the_dish(motion, joins):
    told = after(f"{SALAD}leek (sliced) + salad ({{onion, tomato}}; in bowl) → {motion.upper()} → salad (in bowl)")
    assert ("bowl: salad of leek + onion + tomato" in told) is joins


@pytest.mark.parametrize(
    ("motion", "works"),
    [
        ("combine", True), ("coat", True), ("boil", True), ("warm", True), ("wait", True), ("bake", True),
        ("fry", True), ("put", False), ("slice", False), ("close", False),
    ],
)  # fmt: skip
def test_what_works_on_a_vessel_works_on_all_that_is_in_it(motion, works):
    text = f"""
tomato (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({{tomato}})
onion (sliced) + bowl ({{tomato}}) → {motion.upper()} → wibble (in bowl) + bowl ({{wibble}})
"""
    assert any("wibble of onion + tomato" in line for line in after(text)) is works


@pytest.mark.parametrize(
    ("motion", "keeps"),
    [
        ("strain", True), ("open", True), ("shell", True), ("take out", True), ("slice", True), ("peel", True),
        ("core", True), ("pit", True), ("husk", True), ("mix", False), ("boil", False), ("put", False),
    ],
)  # fmt: skip
def test_what_takes_something_off_a_food_leaves_the_rest_of_it(motion, keeps):
    told = after(f'wobble (whole) + plate (empty) → "{motion}" → wibble (on plate) + plate ({{wibble}})')
    assert ("free: wobble (whole)" in told) is keeps


@pytest.mark.parametrize(
    ("motion", "goes"),
    [
        ("put", True),
        ("sprinkle", True),
        ("mix", True),
        ("boil", True),
        ("wait", True),
        ("slice", False),
        ("close", False),
    ],
)
def test_what_goes_in_and_is_named_nowhere_goes_into_the_vessel(motion, goes):
    told = after(f"onion (sliced) + bowl (empty) → {motion.upper()} → bowl")
    assert ("bowl: onion (sliced)" in told) is goes
    assert ("free: onion (sliced)" in told) is not goes


def test_what_lies_in_another_vessel_goes_only_where_it_is_told():
    told = "onion (sliced) + cup (empty) → PUT → onion (sliced; in cup) + cup ({onion})\n"
    step = "onion (sliced; in cup) + bowl (empty) → PUT → bowl"
    assert after(told + step) == ["cup: onion (sliced)"]
    assert after(told + step + " ({onion})") == ["bowl: onion (sliced)"]


@pytest.mark.parametrize(("motion", "gone"), [("strain", True), ("discard", True), ("wash", True), ("pour", False)])
def test_water_goes_where_a_vessel_is_drained_and_along_where_it_is_poured(motion, gone):
    text = f"""
water (liquid; in bottle) + leek (sliced) + pot (empty) → PUT → pot ({{leek, water}})
leek (sliced; in pot) + pot ({{leek, water}}) + bowl (empty) → {motion.upper()} → leek (sliced; in bowl) + pot (empty)
"""
    bowl = next(line for line in after(text) if line.startswith("bowl"))
    assert ("water" not in bowl) is gone


@pytest.mark.parametrize(
    ("motion", "leaves"),
    [("take out", True), ("strain", True), ("put", True), ("open", True), ("wash", False), ("frobnicate", False)],
)
def test_a_food_that_is_told_without_a_place_has_left_its_package(motion, leaves):
    told = after(f'carrot (whole; in bag) + hand → "{motion}" → carrot (whole)')
    assert told == (["free: carrot (whole)"] if leaves else ["bag: carrot (whole)"])


@pytest.mark.parametrize("motion", ["take out", "wash"])
def test_a_food_that_is_told_without_a_place_stays_in_its_bowl(motion):
    assert after(f'carrot (whole; in bowl) + hand → "{motion}" → carrot (whole)') == ["bowl: carrot (whole)"]


@pytest.mark.parametrize(
    ("steps", "told"),
    [
        ("bread (sliced) + plate (empty) → PUT → bread (sliced; on plate)", ["plate"]),
        ("jam (spread; in jar) + plate (empty) → PUT → jam (spread; on plate)", ["plate"]),
    ],
)
def test_vessels_that_take_part_are_those_that_went_in(steps, told):
    assert [vessel.label for vessel in play(steps).played_steps[-1].vessels] == told


def test_a_vessel_is_noted_as_emptied_when_its_last_food_left_it():
    world = play("""
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + onion (sliced; in bowl)
tomato (sliced; in bowl) + cup (empty) → PUT → tomato (sliced; in cup)
onion (sliced; in bowl) + cup → PUT → onion (sliced; in cup)
""")
    assert [[vessel.label for vessel in one.emptied] for one in world.played_steps] == [[], [], ["bowl"]]


def test_what_comes_out_again_is_not_mixed_in_whatever_the_order():
    mix = "radish (diced; in cup) + salad ({onion, tomato}; in bowl) → MIX"
    told = after(f"{SALAD}{mix} → salad (mixed; {{onion, tomato}}; in bowl) + radish (diced; in cup)")
    assert told == ["bowl: salad (mixed) of onion + tomato", "cup: radish (diced)"]
