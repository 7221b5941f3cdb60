"""Which food an input node is, and when there is none left: the kitchen after small trees."""

from __future__ import annotations

import pytest
from world.playing import faults, foods, play


def view(world):
    """The foods, then what could not happen."""
    return foods(world) + faults(world)


def story(name, text, told, asked=()):
    return pytest.param(text, told, asked, id=name)


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
        "an undivided food in a pot is not the one from the kitchen",
        """
egg (whole) + pot (empty) → PUT → egg (whole; in pot) + pot ({egg})
egg (whole) + bowl (empty) → CRACK → egg (cracked; in bowl) + bowl ({egg})
""",
        ["bowl: egg (cracked)", "pot: egg (whole)"],
        asked=("egg", "egg"),
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
        "a numbered food that was halved, and one that was mixed",
        """
tomato#1 (whole) + plate (empty) + knife → HALVE → tomato#1 (halved, wet; on plate)
tomato#1 (whole) + cup (empty) → PUT → tomato#1 (whole; in cup) + cup ({tomato})
muesli#2 ({nut, raisin}; in bag) + bowl (empty) → POUR → muesli#2 (in bowl) + bowl ({muesli})
muesli#2 (whole) + cup (empty) → PUT → muesli#2 (whole; in cup) + cup ({muesli})
""",
        [
            "cup: muesli (whole) of muesli + nut + raisin",
            "cup: tomato (whole)",
            "W1 step 2 tomato (whole): it is halved, wet by now",
            "W1 step 4 muesli (whole): it is mixed by now",
        ],
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
def test_foods(text, told, asked):
    assert view(play(text, asked)) == told
