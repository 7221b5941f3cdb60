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
        "a package that is poured into a spoon fills it",
        """
bag ({sugar}) + spoon → POUR → bag + spoon
sugar (granulated; in spoon) + spoon ({sugar}) + cup (empty) → POUR → sugar (granulated; in cup) + cup ({sugar})
""",
        [
            "bag: sugar",
            "cup: sugar (granulated)",
            "spoon: sugar (granulated)",
            "moved: sugar spoon → cup",
            "treated: sugar",
        ],
    ),
    story(
        "a package that is poured into a bowl beside a spoon does not fill the spoon",
        """
bag ({sugar}) + spoon + bowl (empty) → POUR → bag + bowl
""",
        ["bag: sugar", "taken: sugar"],
    ),
    story(
        "liquid runs through a strainer",
        """
water (liquid; in bottle) + leek (sliced) + strainer (empty) → POUR → strainer ({leek, water})
broth (liquid; in carton) + strainer ({leek, water}) → POUR → broth (liquid; in strainer)
""",
        [
            "bottle: water (liquid)",
            "carton: broth (liquid)",
            "strainer: leek (sliced)",
            "moved: broth carton → nowhere",
            "taken: broth",
            "treated: leek",
        ],
    ),
    story(
        "a dish is strained and keeps what is solid",
        """
leek (sliced) + water (liquid; in bottle) + pot (empty) → MIX → soup ({leek, water}; in pot) + pot ({soup})
soup ({leek, water}; in pot) + strainer (empty) → POUR → soup ({leek, water}; in strainer) + strainer ({soup})
""",
        ["strainer: soup of leek", "moved: soup pot → strainer", "treated: soup"],
    ),
    story(
        "a part that only braces tell of is another name where it is",
        """
lemon (whole) + bowl (empty) → PUT → lemon (whole; in bowl) + bowl ({lemon})
bowl ({lemon}) + hand → SQUEEZE → bowl ({lemon juice})
lemon juice (in bowl) + cup (empty) → POUR → lemon juice (in cup) + cup ({lemon juice})
""",
        ["cup: lemon juice or lemon of lemon", "moved: lemon juice bowl → cup", "treated: lemon juice"],
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
        "scooping leaves a rest of what is in pieces only when it is strewn or laid on food",
        """
basil (chopped) + bowl (empty) → PUT → basil (chopped; in bowl) + bowl ({basil})
basil (chopped; in bowl) + plate (empty) → SPRINKLE → basil (chopped; on plate) + plate ({basil})
basil (chopped; in bowl) + bread (sliced) → PUT → basil (chopped; on bread) + bread (sliced)
basil (chopped; in bowl) + cup (empty) → PUT → basil (chopped; in cup) + cup ({basil})
""",
        [
            "cup: basil (chopped)",
            "plate: basil (chopped)",
            "free: basil (chopped); bread (sliced) under basil",
            "moved: basil bowl → cup",
            "treated: basil",
        ],
    ),
    story(
        "a whole food leaves no rest",
        """
tomato (whole) + bowl (empty) → PUT → tomato (whole; in bowl) + bowl ({tomato})
tomato (whole; in bowl) + plate (empty) → SPRINKLE → tomato (whole; on plate) + plate ({tomato})
""",
        ["plate: tomato (whole)", "moved: tomato bowl → plate", "treated: tomato"],
    ),
    story(
        "remains do not go with what is poured out",
        """
lemon (halved) + bowl (empty) + squeezer → SQUEEZE
  → lemon juice (in bowl) + lemon (squeezed; in bowl) + bowl ({lemon juice})
lemon juice (in bowl) + bowl ({lemon juice}) + cup (empty) → POUR
  → lemon juice (in cup) + cup ({lemon juice}) + bowl (empty)
""",
        ["cup: lemon juice of lemon", "free: lemon (halved)", "moved: lemon juice bowl → cup", "treated: lemon juice"],
    ),
    story(
        "a package that is told empty keeps what nobody took",
        """
bag ({leek, onion}) + plate (empty) → POUR → leek (on plate) + plate ({leek}) + bag (empty)
""",
        ["plate: leek", "free: onion", "moved: leek bag → plate", "taken: leek; onion", "treated: leek"],
    ),
    story(
        "a food that is consumed takes its riders with it",
        """
bread (sliced) + cheese (sliced) + plate (empty) → PUT
  → cheese (sliced; on bread) + bread (sliced; on plate) + plate ({bread})
bread (sliced; on plate) + tomato (sliced) → MIX → sandwich ({bread, tomato}; on plate) + plate ({sandwich})
""",
        [
            "plate: sandwich of bread + cheese + tomato",
            "made: sandwich",
            "moved: tomato nowhere → nowhere; sandwich nowhere → plate",
            "taken: tomato",
            "treated: sandwich; sandwich",
        ],
    ),
    story(
        "a numbered food comes out as the same number",
        """
tomato#1 (whole) + plate (empty) + knife → SLICE → tomato#1 (sliced; on plate)
tomato#1 (sliced; on plate) + onion#2 (sliced) + bowl (empty) → MIX
  → salad#3 ({onion, tomato}; in bowl) + bowl ({salad})
salad#3 ({onion, tomato}; in bowl) + cup (empty) → PUT → salad#3 ({onion, tomato}; in cup) + cup ({salad})
""",
        ["cup: salad of onion + tomato", "moved: salad bowl → cup", "treated: salad"],
    ),
    story(
        "of several foods of a name the one in that state comes out",
        """
tomato (whole) + tomato (sliced) + plate (empty) → PUT → tomato (sliced; on plate) + tomato (whole; on plate)
""",
        [
            "plate: tomato (sliced); tomato (whole)",
            "moved: tomato nowhere → plate; tomato nowhere → plate",
            "taken: tomato; tomato",
            "treated: tomato; tomato",
            "W1 (minor) step 1 tomato (sliced): more of it is used than is left: it is whole since step 1",
        ],
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
    story(
        "what a bowl is told to hold comes there though the other is not told empty",
        """
tomato (sliced) + onion (sliced) + pot (empty) → MIX → soup ({onion, tomato}; in pot) + pot ({soup})
pot ({soup}) + bowl (empty) → SCOOP → bowl ({soup})
""",
        ["bowl: soup of onion + tomato", "moved: soup pot → bowl", "treated: soup"],
    ),
    story(
        "a bowl that is told empty gives all to the pot that tells of some",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → bowl ({onion, tomato})
bowl ({onion, tomato}) + pot (empty) → POUR → bowl (empty) + pot ({tomato})
""",
        [
            "pot: onion (sliced); tomato (sliced)",
            "moved: onion bowl → pot; tomato bowl → pot",
            "treated: onion; tomato",
        ],
    ),
    story(
        "a food in braces that says more of another is a portion of it",
        """
egg (cracked; in bowl) + cup (empty) → PUT → cup ({beaten egg})
""",
        ["cup: egg (cracked)", "moved: egg bowl → cup", "taken: egg", "treated: egg"],
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
    story(
        "gnocchi come of flour though nothing of their name does",
        """
flour (whole) + egg (cracked) + plate (empty) → PUT → gnocchi (raw; on plate) + plate ({gnocchi})
""",
        [
            "plate: gnocchi (raw) of egg + flour",
            "made: gnocchi",
            "moved: flour nowhere → nowhere; egg nowhere → nowhere; gnocchi nowhere → plate",
            "taken: flour; egg",
            "treated: gnocchi; gnocchi",
        ],
    ),
    story(
        "a food comes of one of a broader kind",
        """
broccoli (whole) + plate (empty) + knife → SLICE → floret (sliced; on plate) + plate ({floret})
""",
        [
            "plate: floret (sliced) of broccoli",
            "free: broccoli (whole)",
            "made: floret",
            "moved: floret nowhere → plate",
            "taken: broccoli",
            "treated: floret",
        ],
    ),
    story(
        "a food comes of one of a narrower kind",
        """
pearl onion (whole) + plate (empty) + knife → SLICE → shallot (sliced; on plate) + plate ({shallot})
""",
        [
            "plate: shallot (sliced) of pearl onion",
            "free: pearl onion (whole)",
            "made: shallot",
            "moved: shallot nowhere → plate",
            "taken: pearl onion",
            "treated: shallot",
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


def after(text):
    """Return the foods after the steps."""
    return foods(play(text))


SALAD = """
tomato (sliced) + onion (sliced) + bowl (empty) → MIX → salad ({onion, tomato}; in bowl) + bowl ({salad})
"""


@pytest.mark.parametrize(
    ("motion", "joins"),
    [
        ("combine", True), ("blend", True), ("mash", True), ("knead", True), ("whip", True), ("grind", True),
        ("shape", True), ("coat", True), ("put", False), ("boil", False), ("wait", False), ("slice", False),
    ],
)  # fmt: skip
def test_what_makes_one_thing_of_several_joins_a_food_to_the_dish(motion, joins):
    told = after(f"{SALAD}leek (sliced) + salad ({{onion, tomato}}; in bowl) → {motion.upper()} → salad (in bowl)")
    assert ("bowl: salad of leek + onion + tomato" in told) is joins


@pytest.mark.parametrize(
    ("motion", "works"),
    [
        ("combine", True), ("coat", True), ("boil", True), ("warm", True), ("wait", True), ("bake", True),
        ("fry", True), ("put", False), ("slice", False), ("close", False),
    ],
)  # fmt: skip
def test_what_works_on_a_vessel_works_on_all_that_is_in_it(motion, works):
    text = f"""
tomato (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({{tomato}})
onion (sliced) + bowl ({{tomato}}) → {motion.upper()} → wibble (in bowl) + bowl ({{wibble}})
"""
    assert any("wibble of onion + tomato" in line for line in after(text)) is works


@pytest.mark.parametrize(
    ("motion", "keeps"),
    [
        ("strain", True), ("open", True), ("shell", True), ("take out", True), ("slice", True), ("peel", True),
        ("core", True), ("pit", True), ("husk", True), ("mix", False), ("boil", False), ("put", False),
    ],
)  # fmt: skip
def test_what_takes_something_off_a_food_leaves_the_rest_of_it(motion, keeps):
    told = after(f'wobble (whole) + plate (empty) → "{motion}" → wibble (on plate) + plate ({{wibble}})')
    assert ("free: wobble (whole)" in told) is keeps


@pytest.mark.parametrize(
    ("motion", "goes"),
    [
        ("put", True),
        ("sprinkle", True),
        ("mix", True),
        ("boil", True),
        ("wait", True),
        ("slice", False),
        ("close", False),
    ],
)
def test_what_goes_in_and_is_named_nowhere_goes_into_the_vessel(motion, goes):
    told = after(f"onion (sliced) + bowl (empty) → {motion.upper()} → bowl")
    assert ("bowl: onion (sliced)" in told) is goes
    assert ("free: onion (sliced)" in told) is not goes


def test_what_lies_in_another_vessel_goes_only_where_it_is_told():
    told = "onion (sliced) + cup (empty) → PUT → onion (sliced; in cup) + cup ({onion})\n"
    step = "onion (sliced; in cup) + bowl (empty) → PUT → bowl"
    assert after(told + step) == ["cup: onion (sliced)"]
    assert after(told + step + " ({onion})") == ["bowl: onion (sliced)"]


@pytest.mark.parametrize(("motion", "gone"), [("strain", True), ("discard", True), ("wash", True), ("pour", False)])
def test_water_goes_where_a_vessel_is_drained_and_along_where_it_is_poured(motion, gone):
    text = f"""
water (liquid; in bottle) + leek (sliced) + pot (empty) → PUT → pot ({{leek, water}})
leek (sliced; in pot) + pot ({{leek, water}}) + bowl (empty) → {motion.upper()} → leek (sliced; in bowl) + pot (empty)
"""
    bowl = next(line for line in after(text) if line.startswith("bowl"))
    assert ("water" not in bowl) is gone


@pytest.mark.parametrize(
    ("motion", "leaves"),
    [("take out", True), ("strain", True), ("put", True), ("open", True), ("wash", False), ("frobnicate", False)],
)
def test_a_food_that_is_told_without_a_place_has_left_its_package(motion, leaves):
    told = after(f'carrot (whole; in bag) + hand → "{motion}" → carrot (whole)')
    assert told == (["free: carrot (whole)"] if leaves else ["bag: carrot (whole)"])


@pytest.mark.parametrize("motion", ["take out", "wash"])
def test_a_food_that_is_told_without_a_place_stays_in_its_bowl(motion):
    assert after(f'carrot (whole; in bowl) + hand → "{motion}" → carrot (whole)') == ["bowl: carrot (whole)"]


@pytest.mark.parametrize(
    ("steps", "told"),
    [
        ("bread (sliced) + plate (empty) → PUT → bread (sliced; on plate)", ["plate"]),
        ("jam (spread; in jar) + plate (empty) → PUT → jam (spread; on plate)", ["plate"]),
    ],
)
def test_vessels_that_take_part_are_those_that_went_in(steps, told):
    assert [vessel.label for vessel in play(steps).happenings[-1].vessels] == told


def test_a_vessel_is_noted_as_emptied_when_its_last_food_left_it():
    world = play("""
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + onion (sliced; in bowl)
tomato (sliced; in bowl) + cup (empty) → PUT → tomato (sliced; in cup)
onion (sliced; in bowl) + cup → PUT → onion (sliced; in cup)
""")
    assert [[vessel.label for vessel in one.emptied] for one in world.happenings] == [[], [], ["bowl"]]


def test_what_comes_out_again_is_not_mixed_in_whatever_the_order():
    mix = "radish (diced; in cup) + salad ({onion, tomato}; in bowl) → MIX"
    told = after(f"{SALAD}{mix} → salad (mixed; {{onion, tomato}}; in bowl) + radish (diced; in cup)")
    assert told == ["bowl: salad (mixed) of onion + tomato", "cup: radish (diced)"]
