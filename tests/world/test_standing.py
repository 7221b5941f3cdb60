"""What stands in or on what, and what is covered: the kitchen after small trees."""

from __future__ import annotations

import pytest
from world.playing import play, story, told_vessels

STORIES = [
    story(
        "what stands on the stove stays there while something else is done",
        """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
pot (empty; on stove) → WASH → pot (clean)
""",
        ["pot at stove", "stove"],
    ),
    story(
        "a pot that is told as it was stays where it is",
        """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
salt (granulated; in shaker) + pot (empty; on stove) + bowl (empty) → PUT
  → salt (granulated; in bowl) + bowl ({salt}) + pot (empty; on stove)
""",
        ["bowl with salt", "pot at stove", "shaker with salt", "stove"],
    ),
    story(
        "nothing stands in what stands in it",
        """
bowl (empty) + tray (empty) → PUT → bowl (empty; on tray) + tray (empty)
tray (empty) + bowl (empty; on tray) → PUT → tray (empty; in bowl) + bowl (empty; on tray)
""",
        ["bowl at tray", "tray"],
    ),
    story(
        "taking a tray out of the oven names the oven only",
        """
tomato (whole) + tray (empty) → PUT → tomato (whole; on tray) + tray ({tomato})
tray ({tomato}) + oven (off) → PUT → tray ({tomato}; in oven) + oven (off)
oven (off) → TAKE OUT → oven (off) + tray ({tomato}; on table)
""",
        ["oven", "table", "tray at table with tomato"],
    ),
    story(
        "what an input lies in may come out though it did not go in",
        """
tomato (whole) + bowl (empty) + table → PUT → tomato (whole; in bowl) + bowl ({tomato}; on table)
tomato (whole; in bowl) + spoon → STIR → tomato (whole; in bowl) + bowl ({tomato}) + table
""",
        ["bowl at table with tomato", "spoon", "table"],
    ),
    story(
        "an appliance may come out though it did not go in",
        """
pot (empty) → PUT → pot (empty; on stove) + stove (off)
""",
        ["pot at stove", "stove"],
    ),
    story(
        "a filled vessel does not come from nowhere and a clean one may",
        """
tomato (whole) → PUT → tomato (whole; in bowl) + bowl ({tomato})
onion (whole) → PUT → onion (whole) + cup (empty)
""",
        ["bowl with tomato", "cup", "W2 step 1 bowl ({tomato}): a filled bowl comes from nowhere"],
    ),
    story(
        "of two outputs the empty one is the one that held nothing",
        """
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
onion (whole) + bowl (empty) → PUT → onion (whole; in bowl) + bowl ({onion})
bowl ({tomato}) + bowl ({onion}) → POUR → bowl ({onion, tomato}) + bowl (empty)
""",
        ["bowl with onion, tomato", "bowl"],
    ),
    story(
        "a covered vessel that nobody opened stays covered",
        """
milk (liquid; in carton) + pot (empty) → POUR → milk (liquid; in pot) + pot ({milk})
pot ({milk}) + lid → COVER → pot (covered; {milk})
pot ({milk}) + table → PUT → pot ({milk}; on table)
""",
        ["carton with milk", "lid", "pot at table [covered] with milk", "table"],
    ),
    story(
        "a vessel is covered where its node says so",
        """
pot (covered) + table → PUT → pot (covered; on table)
""",
        ["pot at table [covered]", "table"],
    ),
    story(
        "a lid that is told to cover a vessel closes it",
        """
milk (liquid; in carton) + pot (empty) → POUR → milk (liquid; in pot) + pot ({milk})
pot ({milk}) + lid + cup → COVER → pot ({milk}) + lid (covering pot)
pan (empty) + lid + cup → PUT → pan (empty; on table) + lid (covering pan)
""",
        ["carton with milk", "cup", "lid", "pan at table", "pot [covered] with milk", "table"],
    ),
    story(
        "taking the lid off uncovers",
        """
pot (covered) + lid → UNCOVER → pot (empty) + lid
pot (covered) + lid → DETACH → pot (empty) + lid
jar (closed) → CLOSE → jar (closed)
""",
        ["jar [covered]", "lid", "pot"],
    ),
    story(
        "a wrap covers nothing by its own state",
        """
foil (wrapped) + plate → PUT → foil (wrapped; on plate)
""",
        ["foil at plate", "plate"],
    ),
    story(
        "what a food lies on is a place even if nobody lists it",
        """
tomato (whole; on veranda) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
""",
        ["bowl with tomato", "veranda"],
    ),
    story(
        "a vessel comes to stand on the one that takes part",
        """
plate#1 (empty) + plate#2 (empty) + bowl (empty) → PUT → bowl (empty; on plate) + plate#2 (empty)
""",
        ["bowl at plate", "plate", "plate"],
    ),
    story(
        "an output stands on the holder used last",
        """
tray (empty) + table → PUT → tray (empty; on table)
bowl (empty) → PUT → bowl (empty; on tray)
""",
        ["bowl at tray", "table", "tray at table"],
    ),
    story(
        "a numbered vessel that holds less than it says",
        """
tomato (whole) + bowl#1 (empty) → PUT → tomato (whole; in bowl#1) + bowl#1 ({tomato})
bowl#1 ({leek, onion, tomato}) + table → PUT → bowl#1 ({tomato}; on table)
bowl#1 ({tomato}) + shelf → PUT → bowl#1 ({tomato}; on shelf)
""",
        [
            "bowl at shelf with tomato",
            "shelf",
            "table",
            "W1 step 2 bowl ({leek, onion, tomato}): the bowl does not hold leek, onion",
        ],
    ),
    story(
        "three things on each other come off one by one",
        """
cup (empty) + plate (empty) + tray (empty) → PUT → cup (empty; on plate) + plate (empty; on tray)
cup (empty; on plate) → TAKE OUT → cup (clean)
""",
        ["cup", "plate at tray", "tray"],
    ),
    story(
        "detaching takes a vessel off and an appliance stays where it is",
        """
jug (empty) + coffee maker (off) → ATTACH → jug (empty; attached to coffee maker)
coffee maker (off) + table → PUT → coffee maker (off; on table)
jug (empty; attached to coffee maker) + coffee maker (off) → DETACH → jug (empty) + coffee maker (unplugged)
""",
        ["coffee maker at table", "jug", "table"],
    ),
    story(
        "a covered vessel that is told twice stays covered",
        """
pot (empty) + lid → COVER → pot (covered)
pot (covered) + stove (off) → PUT → pot (covered; on stove)
pot (covered; on stove) + lid → "take out" → pot (empty)
""",
        ["lid", "pot [covered]", "stove"],
    ),
    story(
        "a lid over one vessel closes no other",
        """
pot (empty) + pan (empty) + lid + cup → COVER → lid (covering pot)
""",
        ["cup", "lid", "pan", "pot [covered]"],
    ),
    story(
        "of two bowls that hold what is said the one that holds less is meant",
        """
salt (granulated; in shaker) + bowl (empty) → PUT → bowl (clean; {salt})
salt (granulated; in shaker) + onion (whole) + bowl (empty) → PUT → bowl (clean; {onion, salt})
bowl ({salt}) + spoon + table → PUT → bowl ({salt}; on table)
""",
        ["bowl at table with salt", "bowl with onion, salt", "shaker with salt", "spoon", "table"],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_standing(text, told, asked):
    assert told_vessels(play(text, asked)) == told
