"""What comes out of a step: the same food elsewhere, a product, a portion; and what could not become so."""

from __future__ import annotations

import pytest
from world.playing import faults, foods, happened, play


def view(world):
    """The foods, what the last step did, then what could not happen."""
    told = [line for line in happened(world) if line.partition(":")[0] in {"made", "moved", "taken", "treated"}]
    return foods(world) + told + faults(world)


def story(name, text, told, asked=()):
    return pytest.param(text, told, asked, id=name)


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
        "tea does not come of water",
        """
water (liquid; in bottle) + cup (empty) → POUR → tea (hot; in cup) + cup ({tea})
""",
        [
            "cup: tea (hot) of water",
            "made: tea",
            "moved: water bottle → nowhere; tea nowhere → cup",
            "taken: water",
            "treated: tea; tea",
            "W2 step 1 tea (hot; in cup): tea does not come of water",
        ],
    ),
    story(
        "a food comes of one that shares a word with it",
        """
lemon (whole) + glass (empty) + squeezer → SQUEEZE → lemon juice (liquid; in glass) + glass ({lemon juice})
""",
        [
            "glass: lemon juice (liquid) of lemon",
            "free: lemon (whole)",
            "made: lemon juice",
            "moved: lemon juice nowhere → glass",
            "taken: lemon",
            "treated: lemon juice; lemon juice; lemon",
        ],
    ),
    story(
        "juice and what is left of the fruit",
        """
lemon (halved) + glass (empty) + squeezer → SQUEEZE
  → lemon juice (liquid; in glass) + lemon (squeezed) + glass ({lemon juice})
""",
        [
            "glass: lemon juice (liquid) of lemon",
            "free: lemon (halved); lemon (squeezed)",
            "made: lemon juice",
            "moved: lemon juice nowhere → glass",
            "taken: lemon",
            "treated: lemon; lemon juice; lemon juice; lemon",
        ],
    ),
    story(
        "juice and fruit under one name",
        """
lemon (halved) + glass (empty) + squeezer → SQUEEZE → lemon (juice; in glass) + lemon (squeezed) + glass ({lemon})
""",
        [
            "glass: lemon (juice); lemon (squeezed)",
            "moved: lemon nowhere → glass",
            "taken: lemon",
            "treated: lemon; lemon",
        ],
    ),
    story(
        "a food comes of one of its kind",
        """
cucumber (whole) + plate (empty) + knife → SLICE → zucchini (sliced; on plate) + plate ({zucchini})
""",
        [
            "plate: zucchini (sliced) of cucumber",
            "free: cucumber (whole)",
            "made: zucchini",
            "moved: zucchini nowhere → plate",
            "taken: cucumber",
            "treated: zucchini",
        ],
    ),
    story(
        "a food does not come of another kind",
        """
beef (raw) + plate (empty) + knife → SLICE → zucchini (sliced; on plate) + plate ({zucchini})
""",
        [
            "plate: zucchini (sliced) of beef",
            "free: beef (raw)",
            "made: zucchini",
            "moved: zucchini nowhere → plate",
            "taken: beef",
            "treated: zucchini",
            "W2 step 1 zucchini (sliced; on plate): zucchini does not come of beef",
        ],
    ),
    story(
        "an unknown food may come of anything",
        """
beef (raw) + plate (empty) + knife → SLICE → wibble (sliced; on plate) + plate ({wibble})
""",
        [
            "plate: wibble (sliced) of beef",
            "free: beef (raw)",
            "made: wibble",
            "moved: wibble nowhere → plate",
            "taken: beef",
            "treated: wibble",
        ],
    ),
    story(
        "dough needs flour",
        """
water (liquid; in bottle) + salt (granulated; in bag) + bowl (empty) → KNEAD
  → dough ({salt, water}; in bowl) + bowl ({dough})
""",
        [
            "bowl: dough of salt + water",
            "made: dough",
            "moved: water bottle → nowhere; salt bag → nowhere; dough nowhere → bowl",
            "taken: water; salt",
            "treated: dough; dough",
            "W2 step 1 dough ({salt, water}; in bowl): dough does not come of salt, water",
        ],
    ),
    story(
        "an egg gives white and yolk",
        """
egg (whole) + bowl (empty) + cup (empty) → SEPARATE
  → egg white (in bowl) + egg yolk (in cup) + bowl ({egg white}) + cup ({egg yolk})
""",
        [
            "bowl: egg white of egg",
            "cup: egg yolk of egg",
            "free: egg (whole)",
            "made: egg white; egg yolk",
            "moved: egg white nowhere → bowl; egg yolk nowhere → cup",
            "taken: egg",
            "treated: egg white; egg yolk; egg white; egg yolk; egg",
        ],
    ),
    story(
        "peeling leaves a skin",
        """
banana (whole) + hand + plate (empty) → PEEL → banana (peeled; on plate) + banana (skin) + plate ({banana})
""",
        [
            "plate: banana (peeled); banana (skin)",
            "moved: banana nowhere → plate",
            "taken: banana",
            "treated: banana; banana",
        ],
    ),
    story(
        "halving gives two portions",
        """
apple (whole) + plate (empty) + bowl (empty) + knife → HALVE → apple (halved; on plate) + apple (halved; in bowl)
""",
        [
            "bowl: apple (halved)",
            "plate: apple (halved)",
            "moved: apple nowhere → plate",
            "taken: apple",
            "treated: apple; apple",
        ],
    ),
    story(
        "a stock food leaves a rest",
        """
oil (liquid; in bottle) + pan (empty) → POUR → oil (liquid; in pan) + pan ({oil})
""",
        ["bottle: oil (liquid)", "pan: oil (liquid)", "moved: oil bottle → pan", "taken: oil", "treated: oil"],
    ),
    story(
        "a stock food leaves no rest in a vessel that is told empty",
        """
oil (liquid; in bottle) + pan (empty) → POUR → oil (liquid; in pan) + pan ({oil})
oil (liquid; in pan) + cup (empty) → POUR → oil (liquid; in cup) + cup ({oil}) + pan (empty)
""",
        ["bottle: oil (liquid)", "cup: oil (liquid)", "moved: oil pan → cup", "treated: oil"],
    ),
    story(
        "a stock food leaves a rest in a pan that is not told",
        """
oil (liquid; in bottle) + pan (empty) → POUR → oil (liquid; in pan) + pan ({oil})
oil (liquid; in pan) + pan ({oil}) + cup (empty) → POUR → oil (liquid; in cup) + cup ({oil})
""",
        ["bottle: oil (liquid)", "cup: oil (liquid)", "pan: oil (liquid)", "moved: oil pan → cup", "treated: oil"],
    ),
    story(
        "other food leaves no rest",
        """
tomato (sliced) + pan (empty) → PUT → tomato (sliced; in pan) + pan ({tomato})
tomato (sliced; in pan) + cup (empty) → PUT → tomato (sliced; in cup) + cup ({tomato})
""",
        ["cup: tomato (sliced)", "moved: tomato pan → cup", "treated: tomato"],
    ),
    story(
        "a vessel that is emptied gives all to where the rest goes",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → PUT
  → tomato (sliced; in bowl) + onion (sliced; in bowl) + bowl ({onion, tomato})
tomato (sliced; in bowl) + bowl ({onion, tomato}) + pot (empty) → POUR
  → tomato (sliced; in pot) + pot ({tomato}) + bowl (empty)
""",
        ["pot: tomato (sliced); onion (sliced)", "moved: tomato bowl → pot; onion bowl → pot", "treated: tomato"],
    ),
    story(
        "a vessel that is poured out without being told empty",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → PUT
  → tomato (sliced; in bowl) + onion (sliced; in bowl) + bowl ({onion, tomato})
bowl ({onion, tomato}) + pot (empty) → POUR → pot ({tomato}) + bowl
""",
        ["bowl: onion (sliced)", "pot: tomato (sliced)", "moved: tomato bowl → pot", "treated: onion; tomato"],
    ),
    story(
        "water is drained away",
        """
water (liquid; in bottle) + spaghetti (dry) + pot (empty) → PUT
  → water (liquid; in pot) + spaghetti (dry; in pot) + pot ({spaghetti, water})
spaghetti (dry; in pot) + pot ({spaghetti, water}) + strainer (empty) → STRAIN
  → spaghetti (drained; in strainer) + strainer ({spaghetti}) + pot (empty)
""",
        [
            "bottle: water (liquid)",
            "strainer: spaghetti (drained)",
            "moved: spaghetti pot → strainer",
            "treated: spaghetti",
        ],
    ),
    story(
        "an emptied vessel without another place loses its food",
        """
tomato (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({tomato})
bowl ({tomato}) + sink → WASH → bowl (empty)
""",
        [],
    ),
    story(
        "what is thrown away is gone",
        """
onion (skin; on table) + bin → THROW AWAY → bin
""",
        ["moved: onion table → nowhere", "taken: onion"],
    ),
    story(
        "what is put and named nowhere goes into the one target",
        """
salt (granulated; in shaker) + bowl (empty) → SPRINKLE → bowl
""",
        ["bowl: salt (granulated)", "moved: salt shaker → bowl", "taken: salt", "treated: salt"],
    ),
    story(
        "a bowl tells what came in",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → bowl ({onion, tomato})
""",
        [
            "bowl: onion (sliced); tomato (sliced)",
            "moved: tomato nowhere → bowl; onion nowhere → bowl",
            "taken: tomato; onion",
            "treated: tomato; onion",
        ],
    ),
    story(
        "a bowl tells what did not come in",
        """
tomato (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({onion, tomato})
""",
        [
            "bowl: tomato (sliced); onion",
            "moved: tomato nowhere → bowl",
            "taken: tomato",
            "treated: tomato",
            "W2 step 1 bowl ({onion, tomato}): it holds onion, which did not go in",
        ],
    ),
    story(
        "a food in braces that is a part of one that went in",
        """
lemon (whole) + bowl (empty) → PUT → bowl ({lemon juice})
""",
        ["bowl: lemon (whole)", "moved: lemon nowhere → bowl", "taken: lemon", "treated: lemon"],
    ),
    story(
        "a food in braces with a word more is the one that went in",
        """
chicken broth (liquid; in carton) + leek (sliced) + pot (empty) → MIX → soup ({broth, leek}; in pot) + pot ({soup})
""",
        [
            "pot: soup of chicken broth + leek",
            "made: soup",
            "moved: chicken broth carton → nowhere; leek nowhere → nowhere; soup nowhere → pot",
            "taken: chicken broth; leek",
            "treated: soup; soup",
        ],
    ),
    story(
        "straining shows what was in it",
        """
stock (liquid; in carton) + strainer (empty) + pot (empty) → STRAIN → pot ({clear water})
""",
        [
            "carton: stock (liquid)",
            "pot: clear water of stock",
            "made: clear water",
            "moved: clear water nowhere → pot",
            "taken: stock",
            "treated: clear water; stock",
        ],
    ),
    story(
        "an opened can shows what is in it",
        """
can (closed) + can opener → OPEN → can (open; {tuna})
""",
        ["can: tuna"],
    ),
    story(
        "a tap gives water",
        """
faucet (on) + cup (empty) → FILL → water (liquid; in cup) + cup ({water})
""",
        [
            "cup: water (liquid)",
            "made: water",
            "moved: water nowhere → cup",
            "taken: water",
            "treated: water; water",
            "W3 step 1 faucet (on): the faucet is said to be on, and nobody turned it on",
        ],
    ),
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
        ["foil: cooky dough (raw)", "moved: cooky dough nowhere → foil", "taken: cooky dough", "treated: cooky dough"],
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
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_outputs(text, told, asked):
    assert view(play(text, asked)) == told


@pytest.mark.parametrize(
    ("food", "minor"),
    [
        ("water", True), ("black pepper", True), ("basil", True), ("butter", True), ("sugar", True), ("yeast", True),
        ("salt", True), ("onion", False), ("beef", False), ("flour", False), ("milk", False),
    ],
)  # fmt: skip
def test_what_did_not_go_in_is_a_slip_only_where_every_kitchen_has_it(food, minor):
    step = f"tomato (sliced) + bowl (empty) → MIX → salad ({{{food}, tomato}}; in bowl) + bowl ({{salad}})"
    (told,) = faults(play(step))
    assert told.startswith("W2 (minor)" if minor else "W2 step")
    assert told.endswith(f": it holds {food}, which did not go in")


def test_an_ingredient_that_did_not_go_in_is_told_once():
    world = play("""
tomato (sliced) + bowl (empty) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
salad ({onion, tomato}; in bowl) + plate (empty) → PUT → salad ({onion, tomato}; on plate) + plate ({salad})
""")
    assert len(faults(world)) == 1
