"""Foods join a heat by how long they take, and what is done waits no longer than it can."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def test_pasta_is_boiled_when_its_sauce_is_ready(steps):
    told = steps("pasta", "Bigoli with anchovies", "bigoli spaghetti:uncooked", "white onions:sliced",
                 "anchovies:salted", "olive oil:liquid", "white wine:dry", "black pepper:ground")  # fmt: skip
    assert first(told, "white onions", "cook and stir") < first(told, "bigoli spaghetti", "boil")
    assert first(told, "white wine", "cook and stir") < first(told, "bigoli spaghetti", "boil")


def test_pasta_for_a_sauce_of_a_moment_is_boiled_before(steps):
    told = steps("pasta", "Spaghetti aglio e olio", "spaghetti:uncooked", "olive oil:liquid", "garlic:sliced",
                 "red pepper flakes:crushed")  # fmt: skip
    assert first(told, "spaghetti", "boil") < first(told, "garlic", "cook and stir")


def test_noodles_that_wait_to_be_fried_are_rinsed(steps):
    told = steps("noodle", "Chicken Lo Mein", "lo mein noodles:uncooked", "chicken breast:sliced", "carrot:julienned",
                 "garlic:minced", "vegetable oil:liquid", "soy sauce:liquid")  # fmt: skip
    boiled = first(told, "lo mein noodles", "boil")
    assert boiled < first(told, "lo mein noodles", "rinse") < first(told, "chicken breast", "cook and stir")


def test_wine_is_boiled_away_before_pasta_is_tossed_in_the_pan(steps):
    told = steps("pasta", "Penne with sausage", "penne:uncooked", "italian sausage:sliced", "onion:chopped",
                 "white wine:dry", "olive oil:liquid")  # fmt: skip
    cooked = [inputs for inputs, motion, _ in told if motion.startswith("cook") and "white wine" in inputs]
    assert "penne" not in cooked[0]


def test_bones_and_shoulder_are_braised_though_no_liquid_is_asked(steps):
    told = steps("beef", "Tafelspitz", "beef rump cap:whole", "marrow bones:raw", "onion:halved", "carrot:peeled",
                 "leek:halved", "bay leaf:whole", "salt:granulated")  # fmt: skip
    assert {"beef rump cap", "marrow bones", "water"} <= inside(told, "simmer")


def test_thin_slices_of_shoulder_are_fried(steps):
    told = steps("stir-fry", "Pork with peppers", "pork shoulder:thinly sliced", "bell pepper:sliced", "garlic:minced",
                 "oil:liquid", "soy sauce:liquid")  # fmt: skip
    assert "simmer" not in motions(told)


@pytest.mark.parametrize("thighs", ["bone-in chicken thighs", "chicken thighs, bone-in"])
def test_a_piece_with_its_bone_in_is_fried_and_no_bone_that_is_braised(steps, thighs):
    told = steps("chicken", "Fried chicken", f"{thighs}:raw", "oil:liquid", "garlic:minced", "salt:granulated")
    assert not any("water" in inputs for inputs, _, _ in told)


@pytest.mark.parametrize(("meat", "before"), [("beef chuck", True), ("chicken thighs", False)])
def test_potatoes_come_into_a_stew_when_what_takes_longer_is_nearly_done(steps, meat, before):
    told = steps("soup", "Stew", f"{meat}:cubed", "potatoes:cubed", "onion:chopped", "oil:liquid", "stock:liquid")
    simmered = [inputs for inputs, motion, _ in told if motion in {"cook", "simmer"}]
    assert ("potatoes" not in simmered[0]) == before
    assert "potatoes" in simmered[-1]
