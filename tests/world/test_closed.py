"""What is closed: lids, jars and doors, and what may pass them."""

from __future__ import annotations

import pytest
from world.playing import faults, play, story, told_power
from world.starts import JAR, MILK, ON, POT

STORIES = [
    story(
        "a jar is not taken from a running blender",
        JAR
        + "blender (off) → TURN ON → blender (on)\n"
        + """
blender jar (empty; attached to blender) + blender (on) → DETACH → blender jar (empty) + blender (on)
blender (on) → TURN OFF → blender (off)
blender jar (empty) + blender (off) → ATTACH → blender jar (empty; attached to blender) + blender (off)
blender jar (empty; attached to blender) + blender (off) → DETACH → blender jar (empty) + blender (off)
""",
        ["W3 step 3 blender jar (empty; attached to blender): something is taken from the blender while it runs"],
    ),
    story(
        "a lid is put on a pot over a running stove",
        POT
        + MILK
        + ON
        + """
lid + pot ({milk}; on stove) + stove (on; under pot) → ATTACH → lid (on pot) + pot ({milk}; on stove)
""",
        ["stove on for ['pot']", "hot: pot"],
    ),
    story(
        "a hot pot on a stove that nobody lit",
        POT
        + MILK
        + """
milk (liquid; in pot) + pot (hot; {milk}; on stove) + spoon → STIR → milk (mixed; in pot)
pot (hot; {milk}; on stove) + spoon → STIR → pot (hot; {milk}; on stove)
""",
        [
            "pot at stove [hot] with milk",
            "stove on for ['pot']",
            "hot: pot",
            "W3 step 3 pot (hot; {milk}; on stove): the pot is said to be hot, and the stove is off",
        ],
    ),
    story(
        "food leaves a pot with the step that opens it",
        """
milk (liquid; in carton) + pot (empty) → POUR → milk (liquid; in pot) + pot ({milk})
pot ({milk}) + lid → COVER → pot (covered; {milk})
pot (covered; {milk}) + cup (empty) → "open and pour" → milk (liquid; in cup) + cup ({milk}) + pot (empty)
""",
        [],
    ),
    story(
        "a closed jar is a package that opens by itself",
        """
jam (spread; in jar) + jar (closed; {jam}) + plate (empty) → POUR → jam (spread; on plate) + plate ({jam})
""",
        [],
    ),
    story(
        "food in a covered pot moves with the pot",
        """
milk (liquid; in carton) + pot (empty) → POUR → milk (liquid; in pot) + pot ({milk})
pot ({milk}) + lid → COVER → pot (covered; {milk})
pot (covered; {milk}) + stove (off) → PUT → pot (covered; {milk}; on stove) + stove (off; under pot)
""",
        ["pot at stove [covered] with milk"],
    ),
    story(
        "a product may be made in a covered pot",
        POT
        + ON
        + """
rice (dry) + water (liquid; in bottle) + pot (empty; on stove) → PUT → pot ({rice, water}; on stove)
pot ({rice, water}; on stove) + lid → COVER → pot (covered; {rice, water}; on stove)
pot (covered; {rice, water}; on stove) + stove (on; under pot) → BOIL → pilaf ({rice, water}; in pot)
""",
        ["pot at stove [covered] [hot] with pilaf", "stove [hot] on for ['pot']", "heated: pot", "hot: pot"],
    ),
    story(
        "a storage over the heat is not heated",
        POT
        + ON
        + """
milk (liquid; in carton) + pot (empty; on stove) + stove (on; under pot) → BOIL → milk (boiling; in carton)
""",
        ["pot at stove [hot]", "stove [hot] on for ['pot']"],
    ),
    story(
        "a jar that somebody closed",
        """
jar ({jam}) + lid → CLOSE → jar (closed; {jam})
jam (in jar) + jar (closed; {jam}) + plate (empty) → POUR → jam (on plate) + plate ({jam})
""",
        ["jar [covered] with jam"],
    ),
    story(
        "food goes from a covered bowl to the tray on which it stands",
        """
bowl (empty) + tray (empty) → PUT → bowl (empty; on tray) + tray
leek (sliced) + bowl (empty; on tray) → PUT → leek (sliced; in bowl) + bowl ({leek}; on tray)
bowl ({leek}; on tray) + lid → COVER → bowl (covered; {leek}; on tray)
leek (sliced; in bowl) + tray → PUT → leek (sliced; on tray)
""",
        ["bowl at tray [covered]"],
    ),
    story(
        "food goes from a covered tray to the bowl that stands on it",
        """
bowl (empty) + tray (empty) → PUT → bowl (empty; on tray) + tray
leek (sliced) + tray (empty) → PUT → leek (sliced; on tray) + tray ({leek})
tray ({leek}) + lid → COVER → tray (covered; {leek})
leek (sliced; on tray) + bowl (empty; on tray) → PUT → leek (sliced; in bowl)
""",
        ["tray [covered]"],
    ),
    story(
        "food goes from a covered bowl to another vessel or nowhere",
        """
leek (sliced) + bowl (empty) → PUT → leek (sliced; in bowl) + bowl ({leek})
bowl ({leek}) + lid → COVER → bowl (covered; {leek})
leek (sliced; in bowl) + bin → DISCARD → bin
""",
        ["W3 step 3 leek (sliced; in bowl): the bowl is closed, and leek enters or leaves it"],
    ),
    story(
        "a stove that nobody touched is off",
        """
milk (liquid; in carton) + pot (empty) → POUR → milk (liquid; in pot) + pot ({milk}; on stove)
milk (liquid; in pot) + pot ({milk}; on stove) → BOIL → milk (boiling; in pot) + pot ({milk}; on stove)
""",
        [
            "pot at stove [hot] with milk",
            "stove on for ['pot']",
            "heated: pot",
            "hot: pot",
            "W3 step 2 milk (liquid; in pot): “boil” while the stove is off",
        ],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_closed(text, told, asked):
    assert told_power(play(text, asked)) == told


@pytest.mark.parametrize(
    ("motion", "opens"),
    [
        ("open and pour", True), ("uncover and pour", True), ("close and pour", True), ("attach and pour", True),
        ("blend and pour", True), ("combine and pour", True), ("pour", False), ("boil and pour", False),
    ],
)  # fmt: skip
def test_what_opens_or_works_inside_may_reach_into_a_covered_pot(motion, opens):
    world = play(f"""
milk (liquid; in carton) + pot (empty) → POUR → milk (liquid; in pot) + pot ({{milk}})
pot ({{milk}}) + lid → COVER → pot (covered; {{milk}})
milk (liquid; in pot) + cup (empty) → "{motion}" → milk (liquid; in cup)
""")
    told = [line for line in faults(world) if "closed" in line]
    assert told == (
        [] if opens else ["W3 step 3 milk (liquid; in pot): the pot is closed, and milk enters or leaves it"]
    )
    assert world.supply.vessels["pot"][0].covered is opens
