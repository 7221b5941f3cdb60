"""Appliances: what is on, and what works without its source."""

from __future__ import annotations

import pytest
from world.playing import faults, play, story, told_power
from world.starts import BLEND, BOIL, FILL, JAR, MILK, OFF, OIL, ON, PAN, POT

STORIES = [
    story("a stove has a burner for each vessel", POT + PAN + MILK + OIL + ON, ["stove on for ['pot']", "hot: pot"]),
    story(
        "the burner of one vessel does not heat another",
        POT
        + PAN
        + MILK
        + OIL
        + ON
        + """
oil (liquid; in pan) + pan ({oil}; on stove) → FRY → oil (hot; in pan) + pan ({oil}; on stove)
""",
        [
            "pan at stove [hot] with oil",
            "stove on for ['pan', 'pot']",
            "heated: pan",
            "hot: pot; pan",
            "W3 step 6 oil (liquid; in pan): “fry” while the stove is off",
        ],
    ),
    story(
        "turning a burner off leaves the others on",
        POT + PAN + MILK + OIL + ON + ON.replace("pot", "pan") + OFF,
        ["stove on for ['pan']", "hot: pan"],
    ),
    story(
        "turning the stove off turns all of it off",
        POT
        + PAN
        + MILK
        + OIL
        + ON
        + ON.replace("pot", "pan")
        + """
stove (on) → TURN OFF → stove (off)
""",
        [],
    ),
    story(
        "boiling on a lit stove",
        POT + MILK + ON + BOIL,
        ["pot at stove [hot] with milk", "stove [hot] on for ['pot']", "heated: pot", "hot: pot"],
    ),
    story(
        "a stove that nobody lit is told once",
        POT + MILK + BOIL + BOIL.replace("(liquid;", "(boiling;"),
        [
            "pot at stove [hot] with milk",
            "stove [hot] on for ['pot']",
            "heated: pot",
            "hot: pot",
            "W3 step 3 stove (on; under pot): the stove is said to be on, and nobody turned it on",
        ],
    ),
    story(
        "a stove that is off cooks nothing and is on from then",
        POT
        + MILK
        + BOIL.replace("(on;", "(off;")
        + """
pot ({milk}; on stove) + spoon → BOIL → pot ({milk}; on stove)
""",
        [
            "pot at stove [hot] with milk",
            "spoon [hot]",
            "stove [hot] on for ['pot']",
            "heated: pot",
            "hot: pot",
            "W3 step 3 milk (liquid; in pot): “boil” while the stove is off",
        ],
    ),
    story(
        "what stands on a lit stove is heated though the step does not name it",
        POT
        + MILK
        + ON
        + """
milk (liquid; in pot) + spoon → BOIL → milk (boiling; in pot)
""",
        ["pot at stove [hot] with milk", "spoon [hot]", "stove on for ['pot']", "heated: pot", "hot: pot"],
    ),
    story(
        "heat without anything that heats",
        """
milk (liquid; in carton) + pot (empty) + spoon → BOIL → milk (boiling; in pot) + pot ({milk})
""",
        [
            "pot [hot] with milk",
            "spoon [hot]",
            "heated: pot",
            "W3 step 1 milk (liquid; in carton): “boil” without a heat source",
        ],
    ),
    story(
        "a stove that is said to be off and is on",
        POT
        + MILK
        + ON
        + """
pot ({milk}; on stove) + stove (off; under pot) → WAIT → pot ({milk}; on stove) + stove (off; under pot)
""",
        ["W3 step 4 stove (off; under pot): the stove is said to be off, and it is on"],
    ),
    story(
        "the off burner of another vessel is off",
        POT
        + PAN
        + MILK
        + OIL
        + ON
        + """
pan ({oil}; on stove) + stove (off; under pan) → WAIT → pan ({oil}; on stove) + stove (off; under pan)
""",
        ["stove on for ['pot']", "hot: pot"],
    ),
    story(
        "an oven is on as a whole",
        """
oven (off) → TURN ON → oven (on)
cake (raw) + tray (empty) → PUT → cake (raw; on tray) + tray ({cake})
tray ({cake}) + oven (on) → PUT → tray ({cake}; in oven) + oven (on)
cake (raw; on tray) + tray ({cake}; in oven) + oven (on) → BAKE → cake (baked; on tray) + oven (on)
""",
        ["oven [hot] on for ['']", "tray at oven [hot] with cake", "heated: tray", "hot: tray"],
    ),
    story(
        "what stands in what stands in an oven is heated there",
        """
oven (off) → TURN ON → oven (on)
cake (raw) + cup (empty) → PUT → cake (raw; in cup) + cup ({cake})
cup ({cake}) + tray (empty) → PUT → cup ({cake}; on tray) + tray
tray + oven (on) → PUT → tray (in oven) + oven (on)
cake (raw; in cup) → BAKE → cake (baked; in cup)
""",
        ["cup at tray [hot] with cake", "oven on for ['']", "heated: cup"],
    ),
    story(
        "an oven that is off while the stove is on",
        POT
        + MILK
        + ON
        + """
cake (raw) + tray (empty) + oven (off) → BAKE → cake (baked; on tray) + tray ({cake}) + oven (off)
""",
        [
            "oven [hot]",
            "stove on for ['pot']",
            "tray [hot] with cake",
            "heated: tray",
            "hot: pot",
            "W3 step 4 cake (raw): “bake” while the oven is off",
        ],
    ),
    story(
        "two sources that are off are both named",
        """
cake (raw) + tray (empty) + oven (off) + grill (off) → BAKE → cake (baked; on tray) + tray ({cake})
""",
        [
            "grill [hot] on for ['']",
            "oven [hot] on for ['']",
            "tray [hot] with cake",
            "heated: tray",
            "W3 step 1 cake (raw): “bake” while the grill, oven is off",
        ],
    ),
    story(
        "what comes out on without having been turned on",
        """
oven (off) + tray → PUT → oven (on) + tray (in oven)
""",
        ["oven on for ['']", "W3 step 1 oven (on): the oven is on afterwards, and nobody turned it on"],
    ),
    story(
        "turning on without a word of it",
        """
oven + hand → TURN ON → oven
""",
        ["oven on for ['']"],
    ),
    story(
        "a fridge is always on",
        """
milk (liquid; in fridge) + fridge (on) + cup (empty) → POUR → milk (liquid; in cup) + cup ({milk}) + fridge (on)
fridge (off) → TURN OFF → fridge (off)
""",
        [],
    ),
    story(
        "cold is no source that must be lit",
        """
milk (liquid; in carton) + bowl (empty) → CHILL → milk (cold; in bowl) + bowl ({milk})
""",
        [],
    ),
    story(
        "a blender works when it is on",
        JAR + FILL + "blender (off) → TURN ON → blender (on)\n" + BLEND,
        ["blender on for ['']"],
    ),
    story(
        "a blender that is off",
        JAR + FILL + BLEND.replace("(on)", "(off)"),
        ["blender on for ['']", "W3 step 3 milk (liquid; in blender jar): “blend” while the blender is off"],
    ),
    story(
        "blending without a blender",
        """
milk (liquid; in carton) + bowl (empty) + fork → BLEND → milk (blended; in bowl) + bowl ({milk})
""",
        ["W3 step 1 milk (liquid; in carton): “blend” without an appliance"],
    ),
    story(
        "heat does not do for power",
        """
oven (off) → TURN ON → oven (on)
milk (liquid; in carton) + bowl (empty) + oven (on) → BLEND → milk (blended; in bowl) + bowl ({milk})
""",
        ["oven on for ['']", "W3 step 2 milk (liquid; in carton): “blend” without an appliance"],
    ),
    story(
        "a jar is not attached to a running blender",
        "blender (off) → TURN ON → blender (on)\n"
        """
blender jar (empty) + blender (on) → ATTACH → blender jar (empty; attached to blender) + blender (on)
""",
        ["blender on for ['']", "W3 step 2 blender jar (empty): something is attached to the blender while it runs"],
    ),
    story(
        "a pot that was hot once may be so still",
        POT
        + MILK
        + ON
        + BOIL
        + OFF
        + """
pot (hot; {milk}; on stove) + spoon → STIR → pot (hot; {milk}; on stove)
""",
        ["pot at stove [hot] with milk", "stove [hot]"],
    ),
    story(
        "a hot pot elsewhere is believed",
        """
pot (hot) + bowl (empty) → PUT → pot (hot; in bowl)
pot (hot; on table) + bowl (empty) → PUT → pot (hot; in bowl)
""",
        [],
    ),
    story(
        "everything that takes part in cooking is hot",
        POT + MILK + ON + BOIL.replace("{milk}; on stove)", "{milk}; on stove) + spoon"),
        ["pot at stove [hot] with milk", "spoon [hot]", "stove [hot] on for ['pot']", "heated: pot", "hot: pot"],
    ),
    story(
        "preheating needs the oven itself",
        """
oven (off) → PREHEAT → oven (on)
oven (off) → TURN ON → oven (on)
oven (on) → PREHEAT → oven (preheated)
""",
        [
            "oven [hot] on for ['']",
            "W3 step 1 oven (off): “preheat” while the oven is off",
            "W3 step 2 oven (off): the oven is said to be off, and it is on",
        ],
    ),
    story(
        "food does not enter or leave a covered pot",
        """
milk (liquid; in carton) + pot (empty) → POUR → milk (liquid; in pot) + pot ({milk})
pot ({milk}) + lid → COVER → pot (covered; {milk})
salt (granulated; in shaker) + pot (covered; {milk}) → SPRINKLE
  → salt (granulated; in pot) + pot (covered; {milk, salt})
salt (granulated; in pot) + cup (empty) → POUR → salt (granulated; in cup) + cup ({salt})
""",
        ["W3 step 3 salt (granulated; in shaker): the pot is closed, and salt enters or leaves it"],
    ),
    story(
        "an empty pan over the heat does not hold anybody up",
        POT + PAN + MILK + ON + ON.replace("pot", "pan"),
        ["stove on for ['pan', 'pot']", "hot: pot"],
    ),
    story(
        "a hot pot over a burner that is off while another one is on",
        POT
        + PAN
        + MILK
        + OIL
        + ON
        + """
pan (hot; {oil}; on stove) + spoon → STIR → pan (hot; {oil}; on stove)
""",
        [
            "pan at stove [hot] with oil",
            "stove on for ['pan', 'pot']",
            "hot: pot; pan",
            "W3 step 6 pan (hot; {oil}; on stove): the pan is said to be hot, and the stove is off",
        ],
    ),
    story(
        "a hot tray in an oven that is off",
        """
cake (raw) + tray (empty) → PUT → cake (raw; on tray) + tray ({cake})
tray ({cake}) + oven (off) → PUT → tray ({cake}; in oven)
tray (hot; {cake}; in oven) + spoon → STIR → tray (hot; {cake}; in oven)
""",
        [
            "oven on for ['']",
            "tray at oven [hot] with cake",
            "hot: tray",
            "W3 step 3 tray (hot; {cake}; in oven): the tray is said to be hot, and the oven is off",
        ],
    ),
    story(
        "a closed appliance",
        """
rice (dry) + rice cooker (off) → PUT → rice (dry; in rice cooker) + rice cooker (off; {rice})
rice cooker (off; {rice}) + lid → CLOSE → rice cooker (closed, off; {rice})
water (liquid; in bottle) + rice cooker (closed, off; {rice}) → POUR → water (liquid; in rice cooker)
salt (granulated; in shaker) + rice cooker (closed, off; {rice}) → SPRINKLE → salt (granulated; in rice cooker)
""",
        ["W3 step 3 water (liquid; in bottle): the rice cooker is closed, and water enters or leaves it"],
    ),
    story(
        "taking food off a stove that is told off and is on is a slip",
        POT
        + MILK
        + ON
        + """
milk (liquid; in pot) + pot ({milk}; on stove) + stove (off; under pot) + cup (empty) → POUR → milk (liquid; in cup)
""",
        [
            "stove on for ['pot']",
            "hot: pot",
            "W3 (minor) step 4 stove (off; under pot): the stove is said to be off, and it is on",
        ],
    ),
    story(
        "a stove that is on as a whole is not off for one of its vessels",
        POT
        + MILK
        + """
stove (off) → TURN ON → stove (on)
pot ({milk}; on stove) + stove (off; under pot) → WAIT → pot ({milk}; on stove) + stove (off; under pot)
""",
        ["stove on for ['']", "W3 step 4 stove (off; under pot): the stove is said to be off, and it is on"],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_power(text, told, asked):
    assert told_power(play(text, asked)) == told


def test_a_stove_that_is_turned_on_as_a_whole_heats_all_that_stands_on_it():
    fry = "oil (liquid; in pan) + pan ({oil}; on stove) → FRY → oil (hot; in pan) + pan ({oil}; on stove)\n"
    assert faults(play(PAN + OIL + "stove (off) → TURN ON → stove (on)\n" + fry)) == []


def test_turning_off_without_a_word_of_it():
    world = play("oven (off) → TURN ON → oven (on)\noven + hand → TURN OFF → oven\n")
    assert not world.supply.appliance("oven").is_on()


@pytest.mark.parametrize("motion", ["turn on", "turn off", "chill", "slice", "put"])
def test_what_needs_no_heat_is_done_without(motion):
    assert [
        told for told in faults(play(f'leek (sliced) + plate → "{motion}" → leek (done)')) if told[:2] == "W3"
    ] == []
