"""What heat does to the parts of foods: what boils, cooks, warms or browns."""

from __future__ import annotations

import pytest
from world.playing import play, story, told_treatment
from world.starts import HEATED

STORIES = [
    story(
        "frying in oil cooks and does not boil",
        HEATED
        + """
oil (liquid; in bottle) + rice (dry) + pot (empty; on stove) → PUT → pot ({oil, rice}; on stove)
pot ({oil, rice}; on stove) + stove (on; under pot) → FRY → rice (fried; in pot) + pot ({oil, rice}; on stove)
""",
        ["oil: cook 3 core -1 cut -1 peel -1 shell -1 stone -1 joined 2 heated 3", "rice: cook 3 joined 2 heated 3"],
    ),
    story(
        "dry heat does not boil even beside water",
        HEATED
        + """
water (liquid; in bottle) + rice (dry) + pot (empty; on stove) → PUT → pot ({rice, water}; on stove)
pot ({rice, water}; on stove) + stove (on; under pot) → ROAST → rice (roasted; in pot) + pot ({rice, water}; on stove)
""",
        ["water: cook 3 core -1 cut -1 peel -1 shell -1 stone -1 joined 2 heated 3", "rice: cook 3 joined 2 heated 3"],
    ),
    story(
        "a spoonful of water boils nothing",
        HEATED
        + """
water (liquid; in bottle) + spoon → SCOOP → water (liquid; in spoon) + spoon ({water})
water (liquid; in spoon) + rice (dry) + pot (empty; on stove) → PUT → water (liquid; in pot) + rice (dry; in pot)
rice (dry; in pot) + pot ({rice, water}; on stove) → BOIL → rice (cooked; in pot) + pot ({rice, water}; on stove)
""",
        [
            "water: cook 4 core -1 cut -1 peel -1 shell -1 stone -1 joined 3 heated 4 spoonful",
            "rice: cook 4 joined 3 heated 4",
        ],
    ),
    story(
        "with more of the same mixed in a spoonful is none",
        HEATED
        + """
milk (liquid; in carton) + spoon → SCOOP → milk (liquid; in spoon) + spoon ({milk})
milk (liquid; in spoon) + flour (powder) + bowl (empty) + whisk → MIX → batter ({flour, milk}; in bowl)
batter ({flour, milk}; in bowl) + milk (liquid; in carton) + whisk → MIX → batter ({flour, milk}; in bowl)
batter ({flour, milk}; in bowl) + rice (dry) + pot (empty; on stove) → PUT → batter (in pot) + rice (dry; in pot)
rice (dry; in pot) + pot ({batter, rice}; on stove) → BOIL → rice (cooked; in pot) + pot ({batter, rice}; on stove)
""",
        [
            "milk: boil 6 cook 6 core -1 cut -1 peel -1 shell -1 stone -1 joined 5 mixed 4 heated 6",
            "flour: boil -1 cook 6 cut -1 peel -1 fine 5 joined 5 mixed 4 heated 6",
            "rice: boil 6 cook 6 joined 5 heated 6",
        ],
    ),
    story(
        "warming heats and does not cook",
        HEATED
        + """
milk (liquid; in carton) + pot (empty; on stove) → POUR → milk (liquid; in pot) + pot ({milk}; on stove)
milk (liquid; in pot) + pot ({milk}; on stove) + stove (on; under pot) → HEAT → milk (hot; in pot)
""",
        ["milk: core -1 cut -1 peel -1 shell -1 stone -1 heated 3"],
    ),
    story(
        "warming cooks where its output says so",
        HEATED
        + """
milk (liquid; in carton) + pot (empty; on stove) → POUR → milk (liquid; in pot) + pot ({milk}; on stove)
milk (liquid; in pot) + pot ({milk}; on stove) + stove (on; under pot) → HEAT → milk (boiling; in pot)
""",
        ["milk: boil 3 cook 3 core -1 cut -1 peel -1 shell -1 stone -1 heated 3"],
    ),
    story(
        "mixing in a hot pot does not cook",
        HEATED
        + """
beef (raw) + pot (empty; on stove) → PUT → beef (raw; in pot) + pot ({beef}; on stove)
beef (raw; in pot) + pot ({beef}; on stove) + spoon → MIX → beef (raw, mixed; in pot)
""",
        ["beef:"],
    ),
    story(
        "food that is brought together is joined, and mixed when it is stirred",
        """
tomato (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({tomato})
onion (sliced) + bowl ({tomato}) → PUT → onion (sliced; in bowl) + bowl ({onion, tomato})
bowl ({onion, tomato}) + spoon → MIX → bowl ({onion, tomato})
basil (chopped) + bowl ({onion, tomato}) → PUT → basil (chopped; in bowl) + bowl ({basil, onion, tomato})
""",
        [
            "tomato: cut -1 fine 2 joined 1 mixed 2",
            "onion: cut -1 fine 2 joined 1 mixed 2",
            "basil: cut -1 fine 3 joined 3",
        ],
    ),
    story(
        "a state that this motion cannot give",
        """
carrot (whole) + knife → SLICE → carrot (grated)
onion (whole) + knife → PEEL → onion (sliced)
""",
        [
            "carrot: cut 0 fine 4",
            "onion: peel 1 shell 1",
            "K4 (minor) step 1 carrot (grated): “slice” does not make it grated",
            "K7 (minor) step 2 onion (sliced): it is sliced, and nobody made it so",
        ],
    ),
    story(
        "the coldest fridge browns nothing",
        """
beef (raw) + tray (empty) → PUT → beef (raw; on tray) + tray ({beef})
tray ({beef}) + oven (off) → PUT → tray ({beef}; in oven)
oven (off) → TURN ON → oven (on)
beef (raw; on tray) + tray ({beef}; in oven) → BAKE → beef (raw; on tray) + tray ({beef}; in oven)
tray ({beef}; in oven) + fridge (on) → PUT → tray ({beef}; in fridge)
beef (raw; on tray) + spoon → FLIP → beef (browned; on tray)
""",
        ["beef: cook 3 heated 3"],
    ),
    story(
        "a shell that comes out under its own name is left over",
        """
egg (whole) + bowl (empty) → CRACK → egg shell (in bin) + egg (cracked; in bowl) + bowl ({egg})
""",
        ["egg: open 0 shell 0", "egg: remains"],
    ),
    story(
        "a portion of what nobody told of is told of no better",
        """
bowl ({apple}) + cup (empty) + glass (empty) → SEPARATE → apple (in cup) + apple (in glass)
""",
        ["apple: unstated", "apple: unstated"],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_heat(text, told, asked):
    assert told_treatment(play(text, asked)) == told
