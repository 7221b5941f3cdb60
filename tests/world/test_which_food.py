"""Which food an input node is, of several: the kitchen after small trees."""

from __future__ import annotations

import pytest
from world.playing import play, story, told_foods

STORIES = [
    story(
        "of two lumps the one in this place is meant",
        """
salt (granulated; in shaker) + bowl (empty) → PUT → salt (granulated; in bowl) + bowl ({salt})
salt (granulated; in shaker) + cup (empty) → PUT → salt (granulated; in cup) + cup ({salt})
salt (granulated; in bowl) + pot (empty) → PUT → salt (granulated; in pot) + pot ({salt}) + bowl (empty)
""",
        ["cup: salt (granulated)", "pot: salt (granulated)", "shaker: salt (granulated)"],
    ),
    story(
        "of two lumps the one in a vessel that takes part is meant",
        """
basil (chopped) + bowl (empty) → PUT → basil (chopped; in bowl) + bowl ({basil})
basil (chopped) + cup (empty) → PUT → basil (chopped; in cup) + cup ({basil})
basil (chopped) + cup + pot (empty) → PUT → basil (chopped; in pot) + pot ({basil})
""",
        ["pot: basil (chopped)"],
    ),
    story(
        "skin and fruit are told apart",
        """
banana (whole) + hand + table → PEEL → banana (peeled; on table) + banana (skin; on table)
banana (skin) + bin → PUT → banana (skin; in bin)
banana (peeled) + plate (empty) → PUT → banana (peeled; on plate) + plate ({banana})
""",
        ["bin: banana (skin)", "plate: banana (peeled)"],
    ),
    story(
        "a pan may be called by its last word",
        """
onion (sliced) + frying pan (empty) → PUT → onion (sliced; in frying pan) + frying pan ({onion})
onion (sliced; in pan) + plate (empty) → PUT → onion (sliced; on plate) + plate ({onion})
""",
        ["plate: onion (sliced)"],
    ),
    story(
        "another place is another food",
        """
onion (sliced) + bowl (empty) → PUT → onion (sliced; in bowl) + bowl ({onion})
onion (sliced; in cup) + plate (empty) → PUT → onion (sliced; on plate) + plate ({onion})
""",
        [
            "bowl: onion (sliced)",
            "plate: onion (sliced)",
            (
                "W1 (minor) step 2 onion (sliced; in cup): more of it is used than is left:"
                " it is sliced in the bowl since step 1"
            ),
        ],
    ),
    story(
        "a food that lies on another goes where that goes",
        """
bread (sliced) + plate (empty) → PUT → bread (sliced; on plate) + plate ({bread})
cheese (sliced) + bread (sliced; on plate) → PUT → cheese (sliced; on bread) + bread (sliced; on plate)
bread (sliced; on plate) + tray (empty) → PUT → bread (sliced; on tray) + tray ({bread})
cheese (sliced; on bread) + bowl (empty) → PUT → cheese (sliced; in bowl) + bowl ({cheese})
""",
        ["bowl: cheese (sliced)", "tray: bread (sliced) under cheese"],
    ),
    story(
        "nobody filled the spoon",
        """
sugar (granulated; in spoon) + cup (empty) → POUR → sugar (granulated; in cup) + cup ({sugar})
""",
        [
            "cup: sugar (granulated)",
            "spoon: sugar (granulated)",
            "W2 step 1 sugar (granulated; in spoon): nobody put sugar into the spoon",
        ],
    ),
    story(
        "a spoon that was filled",
        """
sugar (granulated; in bag) + spoon → SCOOP → sugar (granulated; in spoon) + spoon ({sugar})
sugar (granulated; in spoon) + spoon ({sugar}) + cup (empty) → POUR → sugar (granulated; in cup) + cup ({sugar})
""",
        ["bag: sugar (granulated)", "cup: sugar (granulated)", "spoon: sugar (granulated)"],
    ),
    story(
        "a hand and a cup carry what nobody put there",
        """
sugar (granulated; in hand) + cup (empty) → POUR → sugar (granulated; in cup) + cup ({sugar})
tea (hot; in cup) + pot (empty) → POUR → tea (hot; in pot) + pot ({tea})
""",
        ["cup: sugar (granulated)", "hand: sugar (granulated)", "pot: tea (hot)"],
    ),
    story(
        "a filled spoon of which another food is taken",
        """
sugar (granulated; in bag) + spoon → SCOOP → sugar (granulated; in spoon) + spoon ({sugar})
salt (granulated; in spoon) + spoon ({sugar}) + cup (empty) → POUR → salt (granulated; in cup) + cup ({salt})
""",
        ["bag: sugar (granulated)", "cup: salt (granulated)", "spoon: sugar (granulated); salt (granulated)"],
    ),
    story(
        "a food with names in braces holds them",
        """
muesli ({nut, raisin}; in bag) + bowl (empty) → POUR → muesli ({nut, raisin}; in bowl) + bowl ({muesli})
""",
        ["bowl: muesli of muesli + nut + raisin"],
    ),
    story(
        "a food that came out of a step is that food",
        """
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
tomato (whole) + bowl (empty) + knife → SLICE → tomato (sliced; in bowl) + bowl ({tomato})
tomato (sliced; on plate) + cup (empty) → PUT → tomato (sliced; in cup) + cup ({tomato})
""",
        ["bowl: tomato (sliced)", "cup: tomato (sliced)"],
        asked=("tomato", "tomato"),
    ),
    story(
        "two nodes of one step are two foods",
        """
tomato (whole) + tomato (sliced) + bowl (empty) → PUT
  → tomato (whole; in bowl) + tomato (sliced; in bowl) + bowl ({tomato})
tomato (whole; in bowl) + tomato (sliced; in bowl) + cup (empty) → PUT
  → tomato (whole; in cup) + tomato (sliced; in cup)
""",
        [
            "cup: tomato (whole); tomato (sliced)",
            "W1 (minor) step 1 tomato (sliced): more of it is used than is left: it is whole since step 1",
        ],
    ),
    story(
        "numbers tell foods apart",
        """
tomato#1 (whole) + plate (empty) + knife → SLICE → tomato#1 (sliced; on plate)
tomato#2 (whole) + plate (empty) + knife → SLICE → tomato#2 (sliced; on plate)
tomato#1 (sliced; on plate) + bowl (empty) → PUT → tomato#1 (sliced; in bowl) + bowl ({tomato})
""",
        ["bowl: tomato (sliced)", "plate: tomato (sliced)"],
        asked=("tomato", "tomato"),
    ),
    story(
        "a numbered food that is elsewhere or was cut",
        """
tomato#1 (whole) + plate (empty) + knife → SLICE → tomato#1 (sliced; on plate)
tomato#1 (sliced; in bowl) + spoon → MIX → tomato#1 (sliced)
tomato#1 (whole) + cup (empty) → PUT → tomato#1 (whole; in cup) + cup ({tomato})
""",
        [
            "cup: tomato (whole)",
            "W1 step 2 tomato (sliced; in bowl): it is in the plate and not in the bowl",
            "W1 step 3 tomato (whole): it is sliced by now",
        ],
    ),
    story(
        "a numbered food that was used up",
        """
tomato#1 (whole) + onion#2 (whole) + bowl (empty) → MIX → salad#3 ({onion, tomato}; in bowl) + bowl ({salad})
tomato#1 (whole) + cup (empty) → PUT → tomato#1 (whole; in cup) + cup ({tomato})
""",
        [
            "bowl: salad of onion + tomato",
            "cup: tomato (whole)",
            "W1 step 2 tomato (whole): this tomato was used up before",
        ],
    ),
    story(
        "a numbered food is not taken for one without a number",
        """
tomato#1 (whole) + plate (empty) → PUT → tomato#1 (whole; on plate) + plate ({tomato})
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
""",
        [
            "bowl: tomato (whole)",
            "plate: tomato (whole)",
            "W1 step 2 tomato (whole): there is no second tomato: it is whole in the plate since step 1",
        ],
    ),
    story(
        "a food that is only named stands for what there is",
        """
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
tomato + bowl (empty) → PUT → tomato (in bowl) + bowl ({tomato})
""",
        ["bowl: tomato"],
    ),
    story(
        "an undivided food in a pot is not the one from the kitchen",
        """
egg (whole) + pot (empty) → PUT → egg (whole; in pot) + pot ({egg})
egg (whole) + bowl (empty) → CRACK → egg (cracked; in bowl) + bowl ({egg})
""",
        ["bowl: egg (cracked)", "pot: egg (whole)"],
        asked=("egg", "egg"),
    ),
    story(
        "a numbered food in one piece is taken as often as one likes",
        """
tomato#1 (whole) + plate (empty) → PUT → tomato#1 (whole; on plate)
tomato#1 (whole; on plate) + cup (empty) → PUT → tomato#1 (whole; in cup)
tomato#1 (whole) + bowl (empty) → PUT → tomato#1 (whole; in bowl)
""",
        ["bowl: tomato (whole)"],
    ),
    story(
        "a numbered food in a vessel called by its last word",
        """
onion#1 (whole) + frying pan (empty) → PUT → onion#1 (whole; in frying pan)
onion#1 (whole; in pan) + cup (empty) → PUT → onion#1 (whole; in cup)
onion#1 (whole; in measuring cup) + bowl (empty) → PUT → onion#1 (whole; in bowl)
""",
        ["bowl: onion (whole)"],
    ),
    story(
        "of two slices of cheese the one on the bread is meant",
        """
cheese (sliced) + bowl (empty) → PUT → cheese (sliced; in bowl) + bowl ({cheese})
bread (sliced) + cheese (sliced) + plate (empty) → PUT → cheese (sliced; on bread) + bread (sliced; on plate)
cheese (sliced) + cup (empty) → PUT → cheese (sliced; in cup) + cup ({cheese})
cheese (sliced; on bread) + pot (empty) → PUT → cheese (sliced; in pot) + pot ({cheese})
""",
        ["bowl: cheese (sliced)", "plate: bread (sliced) under cheese", "pot: cheese (sliced)"],
    ),
    story(
        "a food on an unlisted thing is where it was seen last",
        """
cheese (sliced) + bowl (empty) → PUT → cheese (sliced; in bowl) + bowl ({cheese})
cheese (sliced; on gadget) + pot (empty) → PUT → cheese (sliced; in pot) + pot ({cheese})
""",
        [
            "bowl: cheese (sliced)",
            "pot: cheese (sliced)",
            (
                "W1 (minor) step 2 cheese (sliced; on gadget): more of it is used than is left:"
                " it is sliced in the bowl since step 1"
            ),
        ],
    ),
    story(
        "of equal foods the one used last is meant",
        """
salt (granulated; in shaker) + bowl (empty) → PUT → salt (granulated; in bowl) + bowl ({salt})
salt (granulated; in shaker) + cup (empty) → PUT → salt (granulated; in cup) + cup ({salt})
salt (granulated) + plate (empty) → PUT → salt (granulated; on plate) + plate ({salt})
""",
        ["bowl: salt (granulated)", "cup: salt (granulated)", "plate: salt (granulated)", "shaker: salt (granulated)"],
    ),
    story(
        "a coarser food may stand for a finer one",
        """
carrot (whole) + plate (empty) + knife → SLICE → carrot (sliced; on plate) + plate ({carrot})
carrot (grated) + bowl (empty) → PUT → carrot (grated; in bowl) + bowl ({carrot})
""",
        ["bowl: carrot (grated)"],
    ),
    story(
        "what lies free is found on the table or in its bag",
        """
onion (whole) + knife → PEEL → onion (peeled)
onion (peeled; on table) + bowl (empty) → PUT → onion (peeled; in bowl) + bowl ({onion})
leek (whole) + knife → PEEL → leek (peeled)
leek (peeled; in bag) + cup (empty) → PUT → leek (peeled; in cup) + cup ({leek})
""",
        ["bowl: onion (peeled)", "cup: leek (peeled)"],
    ),
    story(
        "water is there without end",
        """
water (liquid) + bowl (empty) → PUT → water (liquid; in bowl) + bowl ({water})
water (liquid; in glass) + cup (empty) → PUT → water (liquid; in cup) + cup ({water})
""",
        ["bowl: water (liquid)", "cup: water (liquid)", "glass: water (liquid)"],
    ),
    story(
        "of a store in no package there is always more too",
        """
sugar (granulated; in cup) + bowl (empty) → PUT → sugar (granulated; in bowl) + bowl ({sugar})
sugar (granulated; in cup) + plate (empty) → PUT → sugar (granulated; on plate) + plate ({sugar})
flour (whole; in glass) + pot (empty) → PUT → flour (whole; in pot) + pot ({flour})
flour (whole; in glass) + pan (empty) → PUT → flour (whole; in pan) + pan ({flour})
""",
        [
            "bowl: sugar (granulated)",
            "cup: sugar (granulated)",
            "glass: flour (whole)",
            "pan: flour (whole)",
            "plate: sugar (granulated)",
            "pot: flour (whole)",
        ],
    ),
    story(
        "of two slices the one that lies on the bread is meant though the other was used last",
        """
bread (sliced) + cheese (sliced; in bag) + plate (empty) → PUT → cheese (sliced; on bread) + bread (sliced; on plate)
cheese (sliced; in box) + bowl (empty) → PUT → cheese (sliced; in bowl) + bowl ({cheese})
cheese (on bread) + pot (empty) → PUT → cheese (in pot) + pot ({cheese})
""",
        ["bag: cheese (sliced)", "bowl: cheese (sliced)", "plate: bread (sliced) under cheese", "pot: cheese"],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_which_food(text, told, asked):
    assert told_foods(play(text, asked)) == told
