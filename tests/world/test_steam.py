"""Steam: what food stands in and over when it is steamed (contract W3)."""

from __future__ import annotations

import pytest
from world.playing import faults, play, story, told_treatment

WATER = """
water (liquid; from faucet) + faucet + pot (empty) → POUR → water (liquid; in pot) + pot ({water})
pot ({water}) + stove (off) → PICK-AND-PLACE → pot ({water}; on stove) + stove (off; under pot)
stove (off; under pot) → TURN ON → stove (on; under pot)
"""
BASKET = """
carrot (sliced) + steamer basket (empty) → PUT → carrot (sliced; in steamer basket) + steamer basket ({carrot})
"""
OVER = "steamer basket ({carrot}) + pot ({water}; on stove) → PUT → steamer basket ({carrot}; in pot)\n"
LID = "pot ({water}; on stove) + pot lid → COVER → pot ({water}; covered; on stove)\n"
STEAM = """
steamer basket ({carrot}; in pot) + pot ({water}; on stove) + stove (on; under pot) → STEAM
  → carrot (steamed; in steamer basket) + steamer basket ({carrot}; in pot)
"""
EMPTY_POT = """
pot (empty) + stove (off) → PICK-AND-PLACE → pot (empty; on stove) + stove (off; under pot)
stove (off; under pot) → TURN ON → stove (on; under pot)
"""
STORIES = [
    story("over water, under a lid", WATER + BASKET + OVER + LID + STEAM, []),
    story(
        "with no lid on",
        WATER + BASKET + OVER + STEAM,
        ["W3 (minor) step 6 steamer basket ({carrot}; in pot): the steam leaves the steamer basket: no lid is on it"],
    ),
    story(
        "over a pot in which nothing is",
        EMPTY_POT
        + BASKET
        + OVER.replace("{water}", "empty")
        + STEAM.replace("pot ({water}; on stove)", "pot (empty; on stove)"),
        ["W3 step 5 steamer basket ({carrot}; in pot): “steam”, and no water is under the steamer basket"],
    ),
    story(
        "lying in the water",
        WATER
        + """
carrot (sliced) + pot ({water}; on stove) → PUT → carrot (sliced; in pot) + pot ({carrot, water}; on stove)
carrot (sliced; in pot) + pot ({carrot, water}; on stove) + stove (on; under pot) → STEAM → carrot (steamed; in pot)
""",
        ["W3 step 5 carrot (sliced; in pot): “steam”, and what is in the pot lies in the liquid"],
    ),
    story(
        "fried with a little water",
        WATER
        + """
oil (liquid; in bottle) + pot ({water}; on stove) → POUR → oil (liquid; in pot) + pot ({oil, water}; on stove)
carrot (sliced) + pot ({oil, water}; on stove) → PUT → carrot (sliced; in pot) + pot ({carrot, oil, water}; on stove)
carrot (sliced; in pot) + pot ({carrot, oil, water}; on stove) + stove (on; under pot) → STEAM
  → carrot (steamed; in pot)
""",
        [],
    ),
    story(
        "closed up in a microwave",
        """
carrot (sliced) + bowl (empty) → PUT → carrot (sliced; in bowl) + bowl ({carrot})
bowl ({carrot}) + microwave (off) → PUT INSIDE → bowl ({carrot}; in microwave) + microwave (off)
microwave (off) → TURN ON → microwave (on)
carrot (sliced; in bowl) + bowl ({carrot}; in microwave) + microwave (on) → STEAM → carrot (steamed; in bowl)
""",
        [],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_what_is_steamed_stands_over_a_liquid(text, told, asked):
    assert faults(play(text, asked)) == told


def test_steam_cooks_what_stands_in_it():
    world = play(WATER + BASKET + OVER + LID + STEAM)
    (told,) = [line for line in told_treatment(world) if line.startswith("carrot")]
    assert "cook 6" in told
