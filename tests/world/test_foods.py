"""How often a food is there, and when there is none left: the kitchen after small trees."""

from __future__ import annotations

import pytest
from world.playing import play, story, told_foods

STORIES = [
    story(
        "a food in one piece is there once",
        """
tomato (whole) + plate (empty) → PUT → tomato (whole; on plate) + plate ({tomato})
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
""",
        [
            "bowl: tomato (whole)",
            "plate: tomato (whole)",
            "W1 step 2 tomato (whole): there is no second tomato: it is whole in the plate since step 1",
        ],
    ),
    story(
        "a food in one piece that was cut is gone",
        """
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
""",
        [
            "bowl: tomato (whole)",
            "plate: tomato (sliced)",
            "W1 step 2 tomato (whole): there is no second tomato: it is sliced in the plate since step 1",
        ],
    ),
    story(
        "a food in one piece is there as often as it was asked for",
        """
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
tomato (whole) + cup (empty) + knife → DICE → tomato (diced; in cup) + cup ({tomato})
tomato (whole) + pot (empty) → PUT → tomato (whole; in pot) + pot ({tomato})
""",
        [
            "bowl: tomato (whole)",
            "cup: tomato (diced)",
            "plate: tomato (sliced)",
            "pot: tomato (whole)",
            "W1 step 3 tomato (whole): there is no second tomato: it is whole in the bowl since step 2",
            "W1 step 4 tomato (whole): there is no second tomato: it is diced in the cup since step 3",
        ],
        asked=("tomatoes", "tomato", "onion"),
    ),
    story(
        "a food that was mixed is in one piece no more",
        """
egg (whole) + milk (liquid; in carton) + bowl (empty) → MIX → batter ({egg, milk}; in bowl) + bowl ({batter})
egg (whole) + pan (empty) → PUT → egg (whole; in pan) + pan ({egg})
""",
        [
            "bowl: batter of egg + milk",
            "pan: egg (whole)",
            "W2 step 1 batter ({egg, milk}; in bowl): batter does not come of egg, milk",
            "W1 step 2 egg (whole): there is no second egg: it is whole since step 1",
        ],
    ),
    story(
        "of what keeps in a store there is always more",
        """
salt (granulated; in shaker) + bowl (empty) → PUT → salt (granulated; in bowl) + bowl ({salt})
salt (granulated; in shaker) + cup (empty) → PUT → salt (granulated; in cup) + cup ({salt})
flour (whole) + pot (empty) → PUT → flour (whole; in pot) + pot ({flour})
flour (whole) + pan (empty) → PUT → flour (whole; in pan) + pan ({flour})
""",
        [
            "bowl: salt (granulated)",
            "cup: salt (granulated)",
            "pan: flour (whole)",
            "pot: flour (whole)",
            "shaker: salt (granulated)",
        ],
    ),
    story(
        "of a food in its package there is always more",
        """
tomato (whole; in bag) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
tomato (whole; in bag) + cup (empty) → PUT → tomato (whole; in cup) + cup ({tomato})
""",
        ["bowl: tomato (whole)", "cup: tomato (whole)"],
    ),
    story(
        "more of a divided food than is left",
        """
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
tomato (sliced; on plate) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({tomato})
tomato (sliced; on plate) + cup (empty) → PUT → tomato (sliced; in cup) + cup ({tomato})
""",
        [
            "bowl: tomato (sliced)",
            "cup: tomato (sliced)",
            (
                "W1 (minor) step 3 tomato (sliced; on plate): more of it is used than is left:"
                " it is sliced in the bowl since step 2"
            ),
        ],
    ),
    story(
        "a divided food is taken again from where it is",
        """
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
tomato (sliced; on plate) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({tomato})
tomato (sliced) + cup (empty) → PUT → tomato (sliced; in cup) + cup ({tomato})
""",
        ["cup: tomato (sliced)"],
    ),
    story(
        "a food in coarser pieces than it is by now",
        """
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
tomato (sliced; on plate) + plate ({tomato}) + knife → DICE → tomato (diced; on plate) + plate ({tomato})
tomato (sliced; on plate) + cup (empty) → PUT → tomato (sliced; in cup) + cup ({tomato})
""",
        [
            "cup: tomato (sliced)",
            "plate: tomato (diced)",
            "W1 step 3 tomato (sliced; on plate): none is so any more: it is diced in the plate since step 2",
        ],
    ),
    story(
        "of two lumps the one in this state is meant",
        """
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
tomato (whole) + plate (empty) + knife → DICE → tomato (diced; on plate) + plate ({tomato})
tomato (diced) + cup (empty) → PUT → tomato (diced; in cup) + cup ({tomato})
""",
        ["cup: tomato (diced)", "plate: tomato (sliced)"],
        asked=("tomato", "tomato"),
    ),
    story(
        "a recipe may ask for a food that is a utensil elsewhere",
        """
wrap (whole) + plate (empty) → PUT → wrap (whole; on plate) + plate ({wrap})
""",
        ["plate: wrap (whole)"],
        asked=("wraps",),
    ),
    story(
        "nobody asked for a wrap",
        """
wrap (whole) + plate (empty) → PUT → wrap (whole; on plate) + plate ({wrap})
""",
        [],
    ),
    story(
        "an undivided food on a board is the one that lies there",
        """
onion (whole) + cutting board (empty) → PUT → onion (whole; on cutting board) + cutting board ({onion})
onion (whole) + knife → PEEL → onion (peeled)
""",
        [
            "cutting board: onion (whole)",
            "free: onion (peeled)",
            "W1 step 2 onion (whole): there is no second onion: it is whole in the cutting board since step 1",
        ],
    ),
    story(
        "what comes apart when it is opened is two foods, and is in its shell no more",
        """
egg (whole) + bowl (empty) + cup (empty) → CRACK
  → egg yolk (separated; in bowl) + bowl ({egg yolk}) + egg white (separated; in cup) + cup ({egg white})
egg (whole) + pot (empty) → CRACK → egg (cracked; in pot) + pot ({egg})
""",
        [
            "bowl: egg yolk (separated) of egg",
            "cup: egg white (separated) of egg",
            "pot: egg (cracked)",
            "W1 step 2 egg (whole): there is no second egg: it is whole since step 1",
        ],
    ),
    story(
        "what lies free is found in the place where it is looked for in a store",
        """
tomato (whole) + knife → WASH → tomato (washed)
tomato (washed; on table) + bowl (empty) → PUT → tomato (washed; in bowl) + bowl ({tomato})
onion (whole) + knife → WASH → onion (washed)
onion (washed; in cup) + bowl ({tomato}) → PUT → onion (washed; in bowl) + bowl ({onion, tomato})
""",
        [
            "bowl: tomato (washed); onion (washed)",
            "free: onion (washed)",
            "W1 (minor) step 4 onion (washed; in cup): more of it is used than is left: it is washed since step 3",
        ],
    ),
    story(
        "a numbered food that was halved, and one that was mixed, and is told so at last",
        """
tomato#1 (whole) + plate (empty) + knife → HALVE → tomato#1 (halved, wet; on plate)
tomato#1 (whole) + cup (empty) → PUT → tomato#1 (whole; in cup) + cup ({tomato})
muesli#2 ({nut, raisin}; in bag) + bowl (empty) → POUR → muesli#2 (in bowl) + bowl ({muesli})
muesli#2 (whole) + cup (empty) → PUT → muesli#2 (whole; in cup) + cup ({muesli})
muesli#2 (whole; {nut, raisin}; in cup) + plate (empty) → PUT → muesli#2 ({nut, raisin}; on plate) + plate ({muesli})
""",
        [
            "cup: tomato (whole)",
            "plate: muesli of muesli + nut + raisin",
            "W1 step 2 tomato (whole): it is halved, wet by now",
            "W1 step 4 muesli (whole): it is mixed by now",
        ],
    ),
    story(
        "a numbered food that has another number once it was fried with its fat",
        """
pan#3 (empty) + oil#4 (liquid; in bottle) → POUR → pan#3 ({oil}) + oil#4 (liquid; in pan)
pan#3 ({oil}) + balls#1 ({beef}; on plate) → PUT → pan#3 ({beef, oil}) + balls#1 ({beef}; in pan)
pan#3 ({beef, oil}) + balls#1 ({beef}; in pan) + oil#4 (liquid; in pan) → COOK → balls#2 (cooked; {beef, oil}; in pan)
pan#3 ({beef, oil}) + balls#2 (cooked; {beef, oil}; in pan) + turner → FLIP → balls#2 (flipped; {beef, oil}; in pan)
""",
        [
            "bottle: oil (liquid)",
            "pan: oil (liquid); ball (flipped) of ball + beef",
            "W3 step 3 pan ({beef, oil}): “cook” without a heat source",
        ],
    ),
    story(
        "a numbered food that says a state that nobody gave it",
        """
tomato#1 (whole) + plate (empty) → PUT → tomato#1 (whole; on plate)
tomato#1 (fresh, peeled; on plate) + cup (empty) → PUT → tomato#1 (fresh, peeled; in cup)
""",
        [
            "cup: tomato (fresh, peeled)",
            "K7 (minor) step 2 tomato (fresh, peeled; on plate): it is peeled, and nobody made it so",
        ],
    ),
    story(
        "a finer food is not taken for a coarser one",
        """
carrot (whole) + plate (empty) + grater → GRATE → carrot (grated; on plate) + plate ({carrot})
carrot (sliced) + bowl (empty) → PUT → carrot (sliced; in bowl) + bowl ({carrot})
""",
        [
            "bowl: carrot (sliced)",
            "plate: carrot (grated)",
            "W1 step 2 carrot (sliced): none is so any more: it is grated in the plate since step 1",
        ],
    ),
    story(
        "what lies on the table is found without a word of it",
        """
onion (whole) + table → PUT → onion (whole; on table)
onion (whole) + knife → PEEL → onion (peeled)
""",
        ["table: onion (peeled)"],
    ),
    story(
        "a food without state and place is whatever is left of it",
        """
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced; on plate) + plate ({tomato})
tomato + onion (whole) + bowl (empty) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
tomato + cup (empty) → PUT → tomato (in cup) + cup ({tomato})
tomato (ripe) + pot (empty) → PUT → tomato (ripe; in pot) + pot ({tomato})
""",
        ["pot: tomato or salad (ripe) of onion + tomato"],
    ),
    story(
        "the same node twice in one step is taken twice",
        """
salt (granulated; in bowl) + sugar (granulated; in bowl) + bowl ({salt, sugar}) + cup (empty) → POUR
  → cup ({salt, sugar})
""",
        ["bowl: salt; sugar", "cup: salt; sugar"],
    ),
    story(
        "a food that was thrown away is told with its last state",
        """
tomato (whole) + plate (empty) + knife → SLICE → tomato (sliced, wet; on plate) + plate ({tomato})
tomato (sliced, wet; on plate) + bin → THROW AWAY → plate (empty)
tomato (whole) + cup (empty) → PUT → tomato (whole; in cup) + cup ({tomato})
""",
        ["cup: tomato (whole)", "W1 step 3 tomato (whole): there is no second tomato: it is sliced, wet since step 2"],
    ),
    story(
        "a slice of cheese in another state is still the one on the bread",
        """
bread (sliced) + cheese (sliced) + plate (empty) → PUT → cheese (sliced; on bread) + bread (sliced; on plate)
cheese (on bread) + pot (empty) → PUT → cheese (in pot) + pot ({cheese})
""",
        ["plate: bread (sliced) under cheese", "pot: cheese"],
    ),
    story(
        "a node that was true is another food once that food was moved",
        """
leek (sliced) + bowl (empty) → PUT → leek (sliced; in bowl) + bowl ({leek})
leek (sliced; in bowl) + cup (empty) → PUT → leek (sliced; in cup) + cup ({leek})
leek (sliced) + bowl (empty) → PUT → leek (sliced; in bowl) + bowl ({leek})
leek (sliced; in cup) + pot (empty) → PUT → leek (sliced; in pot) + pot ({leek})
""",
        [
            "bowl: leek (sliced)",
            "pot: leek (sliced)",
            (
                "W1 (minor) step 4 leek (sliced; in cup): more of it is used than is left:"
                " it is sliced in the bowl since step 3"
            ),
        ],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_foods(text, told, asked):
    assert told_foods(play(text, asked)) == told
