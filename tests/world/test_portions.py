"""How much of a food a step moves: portions, rests, and what a vessel tells of its contents."""

from __future__ import annotations

from dataclasses import replace

import pytest
from world.playing import play, story, told_outputs

from foon_kg.food import tables
from foon_kg.world.things import Lump, Part

STORIES = [
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
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_portions(text, told, asked):
    assert told_outputs(play(text, asked)) == told


@pytest.mark.parametrize("turned", [False, True])
def test_portions_that_meet_again_are_one_part_whichever_comes_first(turned):
    flour = Part(tables().foods.food("flour"), ("powder",), 0, {}, 5, joined=3)
    spooned_out = replace(flour, joined=23, mixed=11, spoonful=True)
    lump = Lump("mixture", {"mixture"}, (), [])
    lump.take([spooned_out, flour] if turned else [flour, spooned_out])
    assert [(part.joined, part.mixed, part.spoonful) for part in lump.parts] == [(23, 11, False)]


@pytest.mark.parametrize("turned", [False, True])
def test_a_portion_that_was_never_hot_is_not_lost_in_one_that_was(turned):
    raw = Part(tables().foods.food("flour"), ("powder",), 0, {}, 5)
    portions = [raw, replace(raw, heated=4)]
    lump = Lump("mixture", {"mixture"}, (), [])
    lump.take(reversed(portions) if turned else portions)
    assert {part.heated for part in lump.parts} == {None, 4}
