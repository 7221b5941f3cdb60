"""Which vessel a node is: the kitchen after small trees."""

from __future__ import annotations

import pytest
from world.playing import play, story, told_vessels

STORIES = [
    story(
        "clean vessels may be fresh ones",
        """
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
onion (whole) + bowl (empty) → PUT → onion (whole; in bowl) + bowl ({onion})
""",
        ["bowl with tomato", "bowl with onion"],
    ),
    story(
        "an empty vessel that stands nowhere is the clean one used last",
        """
bowl (empty) + table → PUT → bowl (empty; on table)
bowl (empty) + shelf → PUT → bowl (empty; on shelf)
onion (whole) + bowl (empty) → PUT → onion (whole; in bowl) + bowl ({onion})
""",
        ["bowl with onion", "shelf", "table"],
    ),
    story(
        "the pot on the stove is that pot",
        """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
milk (liquid; in carton) + pot (empty; on stove) → POUR → milk (liquid; in pot) + pot ({milk}; on stove)
salt (granulated; in shaker) + pot ({milk}; on stove) → POUR → pot ({milk, salt}; on stove)
""",
        ["carton with milk", "pot at stove with milk, salt", "shaker with salt", "stove"],
    ),
    story(
        "an empty pot on the stove that holds food is told, and another one stands there",
        """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
milk (liquid; in carton) + pot (empty; on stove) → POUR → milk (liquid; in pot) + pot ({milk}; on stove)
broth (liquid; in carton) + pot (empty; on stove) → POUR → broth (liquid; in pot) + pot ({broth}; on stove)
""",
        [
            "carton with milk",
            "carton with broth",
            "pot at stove with milk",
            "pot at stove with broth",
            "stove",
            "W1 step 3 pot (empty; on stove): it holds milk there, and is said to be empty",
        ],
    ),
    story(
        "a filled pot need not be told empty where no appliance holds it",
        """
milk (liquid; in carton) + pot (empty; on table) → POUR → milk (liquid; in pot) + pot ({milk}; on table)
broth (liquid; in carton) + pot (empty; on table) → POUR → broth (liquid; in pot) + pot ({broth}; on table)
""",
        ["carton with milk", "carton with broth", "pot at table with milk", "pot at table with broth", "table"],
    ),
    story(
        "of two filled bowls the one with these contents is meant",
        """
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
onion (whole) + bowl (empty) → PUT → onion (whole; in bowl) + bowl ({onion})
bowl ({tomato}) + table → PUT → bowl ({tomato}; on table)
""",
        ["bowl at table with tomato", "bowl with onion", "table"],
    ),
    story(
        "of two bowls with a food the one that holds nothing else is meant",
        """
salt (granulated; in shaker) + bowl (empty) → PUT → salt (granulated; in bowl) + bowl ({salt})
salt (granulated; in shaker) + onion (whole) + bowl (empty) → PUT → bowl ({onion, salt})
bowl ({salt}) + spoon + table → PUT → bowl ({salt}; on table)
""",
        ["bowl at table with salt", "bowl with onion, salt", "shaker with salt", "spoon", "table"],
    ),
    story(
        "of two equal bowls the one used last is meant",
        """
salt (granulated; in shaker) + bowl (empty) → PUT → salt (granulated; in bowl) + bowl ({salt})
salt (granulated; in shaker) + bowl (empty) → PUT → salt (granulated; in bowl) + bowl ({salt})
bowl ({salt}) + spoon + table → PUT → bowl ({salt}; on table)
""",
        ["bowl with salt", "bowl at table with salt", "shaker with salt", "spoon", "table"],
    ),
    story(
        "a filled bowl that nobody filled is filled from the kitchen",
        """
bowl ({onion, tomato}; on table) → PUT → bowl ({onion, tomato}; on shelf)
""",
        ["bowl at shelf with onion, tomato", "shelf", "table"],
    ),
    story(
        "a bowl that was poured out is told, a jar of which there are more is not",
        """
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
tomato (whole; in bowl) + bowl ({tomato}) + cup (empty) → POUR
  → tomato (whole; in cup) + cup ({tomato}) + bowl (empty)
bowl ({tomato}) + table → PUT → bowl ({tomato}; on table)
jar ({jam}) + plate (empty) → POUR → jam (in plate) + plate ({jam}) + jar (empty)
jar ({jam}) + table → PUT → jar ({jam}; on table)
""",
        [
            "bowl",
            "bowl at table with tomato",
            "cup with tomato",
            "jar",
            "jar at table with jam",
            "plate with jam",
            "table",
            "W1 step 3 bowl ({tomato}): its tomato was taken out before",
        ],
    ),
    story(
        "one appliance of each kind",
        """
oven (off) → TURN ON → oven (on)
oven (off; under tray) → TURN ON → oven (on)
oven (on) → TURN OFF → oven (off)
""",
        ["oven", "W3 step 2 oven (off; under tray): the oven is said to be off, and it is on"],
    ),
    story(
        "a knife is a knife",
        """
tomato (whole) + knife → SLICE → tomato (sliced)
onion (whole) + knife (clean) → SLICE → onion (sliced)
""",
        ["knife"],
    ),
    story(
        "a vessel that is named without states and place is the one used last",
        """
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
onion (whole) + bowl (empty) → PUT → onion (whole; in bowl) + bowl ({onion})
salt (granulated; in shaker) + bowl → PUT → salt (granulated; in bowl) + bowl
""",
        ["bowl with tomato", "bowl with onion, salt", "shaker with salt"],
    ),
    story(
        "a vessel that is named with its place is the one there",
        """
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato}; on table)
onion (whole) + bowl (empty) → PUT → onion (whole; in bowl) + bowl ({onion}; on shelf)
salt (granulated; in shaker) + bowl (on table) → PUT → salt (granulated; in bowl) + bowl (on table)
""",
        ["bowl at table with salt, tomato", "bowl at shelf with onion", "shaker with salt", "shelf", "table"],
    ),
    story(
        "a node that came out of a step is that vessel",
        """
salt (granulated; in shaker) + bowl (empty) → PUT → salt (granulated; in bowl) + bowl (clean; {salt})
salt (granulated; in shaker) + bowl (empty) → PUT → salt (granulated; in bowl) + bowl ({salt})
bowl (clean; {salt}) + table → PUT → bowl (clean; {salt}; on table)
""",
        ["bowl at table with salt", "bowl with salt", "shaker with salt", "table"],
    ),
    story(
        "two vessels of one name in one step are two",
        """
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
bowl ({tomato}) + bowl (empty) → POUR → bowl (empty) + bowl ({tomato})
""",
        ["bowl with tomato", "bowl"],
    ),
    story(
        "numbers tell vessels apart",
        """
tomato (whole) + bowl#1 (empty) → PUT → tomato (whole; in bowl#1) + bowl#1 ({tomato})
onion (whole) + bowl#2 (empty) → PUT → onion (whole; in bowl#2) + bowl#2 ({onion})
bowl#1 + table → PUT → bowl#1 (on table)
""",
        ["bowl at table with tomato", "bowl with onion", "table"],
    ),
    story(
        "a number stays the same thing",
        """
bowl#1 (empty) + table → PUT → bowl#1 (empty; on table)
cup#1 (empty) + table → PUT → cup#1 (empty; on table)
""",
        [
            "bowl at table",
            "table",
            "W2 step 2 cup (empty): the bowl has become a cup",
            "W2 step 2 cup (empty; on table): the bowl has become a cup",
        ],
    ),
    story(
        "a numbered vessel that says what it does not hold",
        """
tomato (whole) + bowl#1 (empty) + bowl#2 (empty) → PUT → tomato (whole; in bowl) + bowl#1 ({tomato})
bowl#1 (empty) + table → PUT → bowl#1 (empty; on table)
bowl#2 ({tomato}) + table → PUT → bowl#2 ({tomato}; on table)
""",
        [
            "bowl at table",
            "bowl at table with tomato",
            "table",
            "W1 step 2 bowl (empty): the bowl is not empty: it holds tomato",
            "W1 step 3 bowl ({tomato}): the bowl is empty: its tomato went elsewhere",
            "W2 step 3 bowl ({tomato}; on table): it holds tomato, which did not go in",
        ],
    ),
    story(
        "a numbered vessel that the kitchen filled",
        """
jar#4 ({jam}; on table) + plate#5 (empty) → POUR → jam (on plate) + plate#5 ({jam})
""",
        ["jar at table with jam", "plate with jam", "table"],
    ),
    story(
        "a new number that comes out is a fresh vessel",
        """
tomato (whole) + knife → PUT → tomato (whole; in bowl) + bowl#3 ({tomato})
bowl#3 ({tomato}) + table → PUT → bowl#3 ({tomato}; on table)
""",
        ["bowl at table with tomato", "knife", "table", "W2 step 1 bowl ({tomato}): a filled bowl comes from nowhere"],
    ),
    story(
        "what stands on the stove comes off when it is moved",
        """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
pot (empty; on stove) → MOVE → pot (empty)
""",
        ["pot", "stove"],
    ),
    story(
        "a lid closes and opening opens",
        """
milk (liquid; in carton) + pot (empty) → POUR → milk (liquid; in pot) + pot ({milk})
pot ({milk}) + lid → COVER → pot (covered; {milk})
pot (covered; {milk}) + cup → OPEN → pot ({milk})
""",
        ["carton with milk", "cup", "lid", "pot with milk"],
    ),
    story(
        "a bowl whose two foods were taken out",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → bowl ({onion, tomato})
bowl ({onion, tomato}) + cup (empty) → POUR → cup ({onion, tomato}) + bowl (empty)
bowl ({onion, tomato}) + table → PUT → bowl ({onion, tomato}; on table)
""",
        [
            "bowl",
            "bowl at table with onion, tomato",
            "cup with onion, tomato",
            "table",
            "W1 step 3 bowl ({onion, tomato}): its onion, tomato was taken out before",
        ],
    ),
    story(
        "a bowl whose foods became a dish that was taken out",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → bowl ({onion, tomato})
bowl ({onion, tomato}) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
salad ({onion, tomato}; in bowl) + cup (empty) → POUR → salad ({onion, tomato}; in cup) + bowl (empty)
bowl ({onion, tomato}) + table → PUT → bowl ({onion, tomato}; on table)
bowl ({leek}) + table → PUT → bowl ({leek}; on table)
""",
        [
            "bowl",
            "bowl at table with onion, tomato",
            "bowl at table with leek",
            "cup with salad",
            "table",
            "W1 step 4 bowl ({onion, tomato}): its onion, tomato was taken out before",
        ],
    ),
    story(
        "a bowl that only one of its foods was told of",
        """
tomato (sliced) + bowl (empty) → PUT → bowl ({tomato})
bowl ({tomato}) + onion (sliced) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
salad ({onion, tomato}; in bowl) + cup (empty) → POUR → salad ({onion, tomato}; in cup) + bowl (empty)
bowl ({onion}) + table → PUT → bowl ({onion}; on table)
""",
        ["bowl", "bowl at table with onion", "cup with salad", "table"],
    ),
    story(
        "an empty pot in the kitchen is not the one on the stove",
        """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
milk (liquid; in carton) + pot (empty; on table) → POUR → milk (liquid; in pot) + pot ({milk}; on table)
""",
        ["carton with milk", "pot at stove", "pot at table with milk", "stove", "table"],
    ),
    story(
        "a tool is a clean one though it is not called empty",
        """
jam (spread; in jar) + knife → SCOOP → jam (spread; on knife) + knife ({jam})
onion (whole) + knife → SLICE → onion (sliced)
""",
        ["jar with jam", "knife with jam", "knife"],
    ),
    story(
        "nothing stands in itself",
        """
tray#1 (empty) + table → PUT → tray#1 (empty; on tray)
""",
        ["table", "tray"],
    ),
    story(
        "a thing stands on the one of its holders that was used last",
        """
tray (empty) + table → PUT → tray (empty; on table)
tomato (whole) + tray (empty; on table) → PUT → tray ({tomato}; on table)
onion (whole) + tray (empty; on shelf) → PUT → tray ({onion}; on shelf)
bowl (empty; on tray) → PUT → bowl (empty; on tray) + bowl
cup (empty) → PUT → cup (empty; on tray)
tray ({tomato}) → PUT → tray ({tomato}; on desk)
glass (empty) → PUT → glass (empty; on tray)
mug (empty; on tray) → WASH → mug (clean; on tray)
""",
        [
            "bowl",
            "bowl at tray",
            "cup at tray",
            "glass at tray",
            "mug at tray",
            "shelf",
            "table",
            "tray with tomato",
            "tray at shelf with onion",
        ],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_vessels(text, told, asked):
    assert told_vessels(play(text, asked)) == told
