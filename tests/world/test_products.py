"""What a product is made of, and under which names it is found."""

from __future__ import annotations

import pytest
from world.playing import play, story, told_outputs

STORIES = [
    story(
        "a product holds every part that went in",
        """
tomato (sliced) + onion (sliced) + bowl (empty) + spoon → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
""",
        [
            "bowl: salad of onion + tomato",
            "made: salad",
            "moved: tomato nowhere → nowhere; onion nowhere → nowhere; salad nowhere → bowl",
            "taken: tomato; onion",
            "treated: salad; salad",
        ],
    ),
    story(
        "of a coat that is told beside what is dipped some is on that, and the rest in its bowl",
        """
egg (cracked; in bowl) + bowl ({egg}) + fork → BEAT → egg (beaten; in bowl) + bowl ({egg})
pork (raw) + plate (empty) → PICK-AND-PLACE → plate ({pork}) + pork (raw; on plate)
plate ({pork}) + pork (raw; on plate) + bowl ({egg}) + egg (beaten; in bowl) → DIP
  → plate ({egg, pork}) + pork (coated; {egg, pork}; on plate) + bowl ({egg}) + egg (beaten; in bowl)
""",
        ["bowl: egg (beaten)", "plate: pork or egg (coated) of egg + pork", "treated: pork; egg"],
    ),
    story(
        "a product of a product holds all parts",
        """
flour (whole) + egg (cracked) + bowl (empty) → MIX → dough ({egg, flour}; in bowl) + bowl ({dough})
dough ({egg, flour}; in bowl) + milk (liquid; in carton) → KNEAD
  → batter ({egg, flour, milk}; in bowl) + bowl ({batter})
""",
        [
            "bowl: batter or dough of egg + flour + milk",
            "made: batter",
            "moved: milk carton → nowhere; batter nowhere → bowl",
            "taken: milk",
            "treated: batter; batter",
        ],
    ),
    story(
        "a product takes in what lies in its bowl",
        """
tomato (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({tomato})
onion (sliced) + bowl ({tomato}) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
""",
        [
            "bowl: salad of onion + tomato",
            "made: salad",
            "moved: onion nowhere → nowhere; salad nowhere → bowl",
            "taken: onion",
            "treated: salad; salad",
        ],
    ),
    story(
        "a product that only the bowl tells of",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → bowl ({onion, tomato})
bowl ({onion, tomato}) + spoon → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
""",
        ["bowl: salad of onion + tomato", "made: salad", "moved: salad nowhere → bowl", "treated: salad; salad"],
    ),
    story(
        "a dish has two names",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → MIX
  → salad ({onion, tomato}; in bowl) + greek salad ({onion, tomato}; in bowl)
""",
        [
            "bowl: salad or greek salad of onion + tomato",
            "made: salad",
            "moved: tomato nowhere → nowhere; onion nowhere → nowhere; salad nowhere → bowl",
            "taken: tomato; onion",
            "treated: salad; salad; salad",
        ],
    ),
    story(
        "mixing into a food that keeps its name joins the rest",
        """
milk (liquid; in carton) + bowl (empty) → POUR → milk (liquid; in bowl) + bowl ({milk})
sugar (granulated; in bag) + milk (liquid; in bowl) + spoon → STIR → milk (sweet; {milk, sugar, sugar}; in bowl)
""",
        [
            "bowl: milk or sugar (sweet) of milk + sugar",
            "carton: milk (liquid)",
            "moved: sugar bag → nowhere",
            "taken: sugar",
            "treated: milk",
        ],
    ),
    story(
        "stirring two foods that keep their names joins nothing",
        """
milk (liquid; in carton) + sugar (granulated; in bag) + bowl (empty) → MIX
  → milk (liquid; in bowl) + sugar (granulated; in bowl) + bowl ({milk, sugar})
""",
        [
            "bag: sugar (granulated)",
            "bowl: milk (liquid); sugar (granulated)",
            "carton: milk (liquid)",
            "moved: milk carton → bowl; sugar bag → bowl",
            "taken: milk; sugar",
            "treated: milk; sugar",
        ],
    ),
    story(
        "a covered part is made by what it works on",
        """
rice (dry) + water (liquid; in bottle) + rice cooker (off) → PUT
  → rice (dry; in rice cooker) + water (liquid; in rice cooker) + rice cooker (off)
rice cooker (off) → TURN ON → rice cooker (on)
rice cooker (on) → COOK → cooked rice (in rice cooker) + rice cooker (on)
""",
        [
            "bottle: water (liquid)",
            "rice cooker: cooked rice of rice + water",
            "made: cooked rice",
            "moved: cooked rice nowhere → rice cooker",
            "treated: cooked rice; cooked rice",
        ],
    ),
    story(
        "nothing at all makes nothing",
        """
plate (empty) + spoon → MIX → salad ({onion, tomato}; on plate) + plate ({salad})
""",
        [
            "plate: salad or onion or tomato of onion + salad + tomato",
            "made: salad",
            "moved: salad nowhere → plate",
            "taken: salad",
            "treated: salad; salad",
            "W2 step 1 salad ({onion, tomato}; on plate): salad does not come of nothing",
            "W2 step 1 salad ({onion, tomato}; on plate): it holds onion, which did not go in",
            "W2 step 1 salad ({onion, tomato}; on plate): it holds tomato, which did not go in",
        ],
    ),
    story(
        "all that goes in and does not come out again is mixed into the salad that was made",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
basil (chopped) + bowl ({salad}) → PUT → basil (chopped; in bowl) + bowl ({basil, salad})
salt (granulated; in shaker) + leek (sliced) + radish (diced; in cup) + salad ({onion, tomato}; in bowl) → MIX
  → radish (diced; in cup) + salad (mixed; {leek, onion, tomato}; in bowl)
""",
        [
            "bowl: salad (mixed) of basil + leek + onion + salt + tomato",
            "cup: radish (diced)",
            "moved: salt shaker → nowhere; leek nowhere → nowhere",
            "taken: salt; leek; radish",
            "treated: radish; salad",
        ],
    ),
    story(
        "a skin alone is no portion",
        """
banana (whole) + hand + plate (empty) → PEEL → banana (skin; on plate) + plate ({banana})
""",
        ["plate: banana (skin)", "moved: banana nowhere → plate", "taken: banana", "treated: banana"],
    ),
    story(
        "a part that only braces tell of comes into another vessel",
        """
lemon (whole) + bowl (empty) → PUT → lemon (whole; in bowl) + bowl ({lemon})
bowl ({lemon}) + cup (empty) → SQUEEZE → cup ({lemon juice}) + bowl ({lemon})
lemon juice (in cup) + glass (empty) → POUR → lemon juice (in glass) + glass ({lemon juice})
""",
        [
            "bowl: lemon (whole)",
            "glass: lemon juice of lemon",
            "moved: lemon juice cup → glass",
            "treated: lemon juice",
        ],
    ),
    story(
        "the pieces of a board go into the pot that tells them",
        """
onion (sliced) + cutting board (empty) → PUT → onion (sliced; on cutting board) + cutting board ({onion})
onion (sliced; on cutting board) + pot (empty) → POUR → pot ({onion})
leek (sliced; in cup) + pot ({onion}) → POUR → pot ({onion})
""",
        ["cup: leek (sliced)", "pot: onion (sliced)", "taken: leek", "treated: leek"],
    ),
    story(
        "a part of a plain food comes out under its own name",
        """
tomato (whole) + plate (empty) + knife → SLICE → fruit (sliced; on plate) + plate ({fruit})
fruit (sliced; on plate) + cup (empty) → PUT → tomato (sliced; in cup) + cup ({tomato})
""",
        [
            "cup: tomato or fruit (sliced)",
            "free: tomato (whole)",
            "moved: tomato plate → cup",
            "treated: tomato",
            "W2 step 1 fruit (sliced; on plate): fruit does not come of tomato",
        ],
    ),
    story(
        "an alias of a dish is found by both names",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → MIX
  → salad ({onion, tomato}; in bowl) + greek salad ({onion, tomato}; in bowl)
greek salad ({onion, tomato}; in bowl) + plate (empty) → PUT → greek salad ({onion, tomato}; on plate) + plate ({salad})
""",
        ["plate: greek salad or salad of onion + tomato", "moved: greek salad bowl → plate", "treated: greek salad"],
    ),
    story(
        "coffee comes of its powder though they share no word",
        """
espresso (ground; in bag) + cup (empty) → BREW → coffee (hot; in cup) + cup ({coffee})
""",
        [
            "cup: coffee (hot) of espresso",
            "made: coffee",
            "moved: espresso bag → nowhere; coffee nowhere → cup",
            "taken: espresso",
            "treated: coffee; coffee",
        ],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_products(text, told, asked):
    assert told_outputs(play(text, asked)) == told
