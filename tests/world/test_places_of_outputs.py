"""Where a food comes out: on what, in what, and what lies on it."""

from __future__ import annotations

import pytest
from world.playing import play, story, told_outputs

STORIES = [
    story(
        "a food comes out on another that is there",
        """
bread (sliced) + butter (solid) + plate (empty) → SPREAD
  → butter (solid; on bread) + bread (sliced; on plate) + plate ({bread})
""",
        [
            "plate: butter (solid); bread (sliced) under butter",
            "moved: bread nowhere → plate; butter nowhere → plate",
            "taken: bread; butter",
            "treated: butter; bread",
        ],
    ),
    story(
        "a food comes out on another that is not there",
        """
butter (solid) + plate (empty) → SPREAD → butter (solid; on bread) + plate
""",
        [
            "free: butter (solid)",
            "taken: butter",
            "treated: butter",
            "W2 step 1 butter (solid; on bread): there is no bread on which it could be",
        ],
    ),
    story(
        "a food on what nobody lists lies on the foil",
        """
foil + cookie dough (raw) → PUT → foil (sheet) + cookie dough (raw; on square)
""",
        [
            "foil: cookie dough (raw)",
            "moved: cookie dough nowhere → foil",
            "taken: cookie dough",
            "treated: cookie dough",
        ],
    ),
    story(
        "a food comes out in a vessel that is not there",
        """
tomato (sliced) + plate (empty) → PUT → tomato (sliced; in bowl) + plate (empty)
""",
        [
            "bowl: tomato (sliced)",
            "moved: tomato nowhere → bowl",
            "taken: tomato",
            "treated: tomato",
            "W2 step 1 tomato (sliced; in bowl): there is no bowl in which it could be now",
        ],
    ),
    story(
        "a food comes out in a vessel called by another of its words",
        """
onion (sliced) + frying pan (empty) → PUT → onion (sliced; in pan) + frying pan ({onion})
""",
        ["frying pan: onion (sliced)", "moved: onion nowhere → frying pan", "taken: onion", "treated: onion"],
    ),
    story(
        "a food comes to a place and from a place that nobody brings",
        """
onion (sliced) + bowl (empty) → PUT → onion (sliced; on table)
water (liquid) + cup (empty) → FILL → water (liquid; from faucet)
""",
        [
            "faucet: water (liquid)",
            "table: onion (sliced)",
            "moved: water nowhere → faucet",
            "taken: water",
            "treated: water",
        ],
    ),
    story(
        "a food that is taken out of its store lies free",
        """
tomato (whole; in bag) + hand → TAKE OUT → tomato (whole)
onion (whole; in bowl) + hand → TAKE OUT → onion (whole)
carrot (whole; in bag) + hand → WASH → carrot (washed)
""",
        ["bag: carrot (washed)", "bowl: onion (whole)", "free: tomato (whole)", "taken: carrot", "treated: carrot"],
    ),
    story(
        "cream on a cake belongs to it",
        """
cake (baked) + cream (whipped) + plate (empty) → SPREAD → cake (baked; {cream}; on plate) + plate ({cake})
""",
        [
            "plate: cake or cream (baked) of cake + cream",
            "moved: cake nowhere → plate; cream nowhere → nowhere",
            "taken: cake; cream",
            "treated: cake",
        ],
    ),
    story(
        "what is served is what was cooked",
        """
tomato (sliced) + onion (sliced) + pot (empty) → MIX → soup ({onion, tomato}; in pot) + pot ({soup})
pot ({soup}) + bowl (empty) → POUR → bowl ({soup}) + pot (empty)
""",
        ["bowl: soup of onion + tomato", "moved: soup pot → bowl", "treated: soup"],
    ),
    story(
        "a fork that carries what is on it is no place",
        """
egg (cracked; in bowl) + fork → BEAT → egg (beaten; in bowl)
""",
        ["bowl: egg (beaten)", "taken: egg", "treated: egg"],
    ),
    story(
        "a food lies on one that had another name",
        """
flour (whole) + water (liquid; in bottle) + plate (empty) → KNEAD → dough ({flour, water}; on plate) + plate ({dough})
dough ({flour, water}; on plate) + butter (solid) → KNEAD → pizza ({butter, flour, water}; on plate)
tomato (sliced) + pizza ({butter, flour, water}; on plate) → PUT → tomato (sliced; on dough)
""",
        [
            "plate: pizza or dough of butter + flour + water under tomato; tomato (sliced)",
            "moved: tomato nowhere → plate",
            "taken: tomato",
            "treated: tomato; pizza",
        ],
    ),
    story(
        "a food lies on one that is called by its kind",
        """
beef (raw) + plate (empty) → PUT → beef (raw; on plate) + plate ({beef})
salt (granulated; in shaker) + beef (raw; on plate) → SPRINKLE → salt (granulated; on meat) + beef (raw; on plate)
""",
        [
            "plate: salt (granulated); beef (raw) under salt",
            "shaker: salt (granulated)",
            "moved: salt shaker → plate",
            "taken: salt",
            "treated: salt; beef",
        ],
    ),
    story(
        "a food lies on one that is called by its last word",
        """
gyoza wrapper (raw) + plate (empty) → PUT → gyoza wrapper (raw; on plate) + plate ({gyoza wrapper})
leek (sliced) + gyoza wrapper (raw; on plate) → PUT → leek (sliced; on wrapper) + gyoza wrapper (raw; on plate)
""",
        [
            "plate: leek (sliced); gyoza wrapper (raw) under leek",
            "moved: leek nowhere → plate",
            "taken: leek",
            "treated: leek; gyoza wrapper",
        ],
    ),
    story(
        "a food does not lie on itself",
        """
bread (sliced) + plate (empty) → PUT → bread (sliced; on plate) + plate ({bread})
bread (sliced; on plate) + hand → PUT → bread (sliced; on bread)
""",
        ["plate: bread (sliced)", "treated: bread"],
    ),
    story(
        "a food on what nobody lists stays where it is",
        """
leek (sliced) + plate (empty) → PUT → leek (sliced; on plate) + plate ({leek})
leek (sliced; on plate) + hand → PUT → leek (sliced; on gadget)
""",
        ["plate: leek (sliced)", "treated: leek"],
    ),
    story(
        "what holds a food is told by another name",
        """
leek (sliced) + tray (empty) → PUT → leek (sliced; in pan) + tray ({leek})
onion (sliced) + tray (empty) + plate (empty) → PUT → onion (sliced; in wok) + tray ({onion}) + plate ({onion})
""",
        [
            "tray: leek (sliced)",
            "wok: onion (sliced)",
            "moved: onion nowhere → wok",
            "taken: onion",
            "treated: onion",
            "W2 step 2 onion (sliced; in wok): there is no wok in which it could be now",
        ],
    ),
    story(
        "what lies on a food goes with it into what is made of it",
        """
bread (sliced) + cheese (sliced) + plate (empty) → PUT → cheese (sliced; on bread) + bread (sliced; on plate)
bread (sliced; on plate) + bowl (empty) → CRUMBLE → wibble (in bowl) + bowl ({wibble})
""",
        [
            "bowl: wibble of bread + cheese",
            "plate: cheese (sliced); bread (sliced) under cheese",
            "made: wibble",
            "moved: wibble nowhere → bowl",
            "treated: wibble",
        ],
    ),
    story(
        "a food lies on one that is called by the last of three words",
        """
spring roll wrapper (raw) + plate (empty) → PUT → spring roll wrapper (raw; on plate)
leek (sliced) + spring roll wrapper (raw; on plate) → PUT
  → leek (sliced; on wrapper) + spring roll wrapper (raw; on plate)
""",
        [
            "plate: leek (sliced); spring roll wrapper (raw) under leek",
            "moved: leek nowhere → plate",
            "taken: leek",
            "treated: leek; spring roll wrapper",
        ],
    ),
    story(
        "a food lies on no other that has the word in front",
        """
beef patty (raw) + plate (empty) → PUT → beef patty (raw; on plate)
leek (sliced) + beef patty (raw; on plate) → PUT → leek (sliced; on beef) + beef patty (raw; on plate)
""",
        [
            "plate: beef patty (raw)",
            "free: leek (sliced)",
            "taken: leek",
            "treated: leek; beef patty",
            "W2 step 2 leek (sliced; on beef): there is no beef on which it could be",
        ],
    ),
    story(
        "what works in one vessel leaves what is in another alone",
        """
tomato (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({tomato})
onion (sliced) + cup (empty) + bowl ({tomato}) → BOIL → wibble (in cup)
""",
        [
            "bowl: tomato (sliced)",
            "cup: wibble of onion",
            "made: wibble",
            "moved: onion nowhere → nowhere; wibble nowhere → cup",
            "taken: onion",
            "treated: wibble; wibble",
            "W3 step 2 onion (sliced): “boil” without a heat source",
        ],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_places_of_outputs(text, told, asked):
    assert told_outputs(play(text, asked)) == told
