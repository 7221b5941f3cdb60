"""What a step does to its foods: which treatments each part has had, and which states nothing earned."""

from __future__ import annotations

import pytest
from world.playing import faults, histories, play


def view(world):
    """The history of each part, then what could not happen."""
    return histories(world) + [told for told in faults(world) if told[0] == "K"]


def story(name, text, told, asked=()):
    return pytest.param(text, told, asked, id=name)


HEATED = """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
stove (off; under pot) → TURN ON → stove (on; under pot)
"""

STORIES = [
    story(
        "what was bought in a state has its history",
        """
tomato (canned) + onion (powder) + egg (whole) + apple (whole) + bowl (empty) → PUT → bowl ({apple, egg, onion, tomato})
""",
        [
            "tomato: boil -1 choke -1 cook -1 core -1 cut -1 husk -1 peel -1 shell -1 soak -1 stone -1 joined 0",
            "onion: boil -1 cut -1 peel -1 fine 5 joined 0",
            "egg: joined 0",
            "apple: joined 0",
        ],
    ),
    story(
        "what lies under others is told so",
        """
bowl ({tomato}) + plate (empty) → POUR → plate ({tomato}) + bowl (empty)
""",
        ["tomato: untold"],
    ),
    story(
        "each treatment is dated by its first step",
        """
carrot (whole) + peeler → PEEL → carrot (peeled)
carrot (peeled) + knife → SLICE → carrot (sliced)
carrot (sliced) + knife → DICE → carrot (diced)
carrot (diced) + grater → GRATE → carrot (grated)
""",
        ["carrot: cut 1 grate 3 peel 0 shell 0 fine 4"],
    ),
    story(
        "a cut is as fine as the state it gives",
        """
carrot (whole) + knife → HALVE → carrot (halved)
onion (whole) + knife → CUT → onion (ready)
tomato (whole) + knife → SLICE → tomato (sliced)
apple (whole) + knife → CHOP → apple (chopped)
leek (whole) + knife → MINCE → leek (minced)
""",
        [
            "carrot: cut 0 fine 1",
            "onion: cut 1 fine 2",
            "tomato: cut 2 fine 2",
            "apple: cut 3 fine 3",
            "leek: cut 4 fine 4",
        ],
    ),
    story(
        "grinding, blending and mashing are as fine as can be",
        """
almond (whole) + mortar → GRIND → almond (ground)
banana (peeled) + fork → MASH → banana (mashed)
apple (peeled) + blender (off) → BLEND → apple (blended)
""",
        ["almond: cut 0 grind 0 fine 5", "banana: cut 1 mash 1 peel -1 fine 5", "apple: blend 2 cut 2 peel -1 fine 5"],
    ),
    story(
        "a food in fine pieces is not cut in coarser ones",
        """
carrot (whole) + knife → CHOP → carrot (chopped)
carrot (chopped) + knife → SLICE → carrot (again)
carrot (again) + knife → HALVE → carrot (halved)
""",
        [
            "carrot: cut 0 fine 3",
            "K7 (minor) step 2: carrot is in finer pieces already",
            "K7 (minor) step 3: carrot is in finer pieces already",
        ],
    ),
    story(
        "a mixture may be cut again",
        """
carrot (whole) + knife → CHOP → carrot (chopped)
carrot (chopped) + onion (chopped) + bowl (empty) → MIX → salad ({carrot, onion}; in bowl) + bowl ({salad})
salad ({carrot, onion}; in bowl) + knife → SLICE → salad (sliced; {carrot, onion}; in bowl)
""",
        ["carrot: cut 0 fine 3 joined 1 mixed 1", "onion: cut -1 fine 3 joined 1 mixed 1"],
    ),
    story(
        "shelling, coring, stoning, husking, opening, washing and soaking",
        """
egg (whole) + bowl (empty) → CRACK → egg (cracked; in bowl) + bowl ({egg})
apple (whole) + corer → CORE → apple (cored)
cherry (whole) + pitter → PIT → cherry (pitted)
corn (whole) + hand → HUSK → corn (husked)
can (closed; {tuna}) + can opener → OPEN → can (open; {tuna})
lettuce (whole) + sink → WASH → lettuce (washed)
bean (dry) + bowl (empty) → SOAK → bean (soaked; in bowl)
""",
        [
            "egg: open 0 shell 0",
            "apple: core 1",
            "cherry: stone 2",
            "corn: husk 3",
            "tuna: untold",
            "lettuce: wash 5",
            "bean: soak 6",
        ],
    ),
    story(
        "squeezing leaves skin, core and stone behind",
        """
lemon (halved) + glass (empty) + squeezer → SQUEEZE → lemon (juice; in glass) + lemon (squeezed) + glass ({lemon})
""",
        ["lemon: core 0 cut -1 peel 0 shell 0 stone 0 fine 1", "lemon: cut -1 fine 1 remains"],
    ),
    story(
        "separating what is no liquid leaves nothing behind",
        """
cabbage (whole) + bowl (empty) → SEPARATE → cabbage (leaf; in bowl) + bowl ({cabbage})
""",
        ["cabbage:"],
    ),
    story(
        "hands work on what comes out in another form",
        """
carrot (whole) + onion (whole) + knife + table → SLICE → carrot (sliced; on table) + onion (whole)
""",
        ["carrot: cut 0 fine 2", "onion:"],
    ),
    story(
        "hands work on all that went in where nothing changes",
        """
carrot (whole; in bowl) + knife → SLICE → knife (dirty)
""",
        ["carrot: cut 0"],
    ),
    story(
        "hands work on what the bowl holds where no food is told",
        """
carrot (whole) + bowl (empty) → PUT → carrot (whole; in bowl) + bowl ({carrot})
bowl ({carrot}) + spoon + jar ({jam}) → MASH → bowl ({carrot})
""",
        ["carrot: cut 1 mash 1 fine 5", "jam: untold"],
    ),
    story(
        "remains are not worked on",
        """
banana (whole) + hand → PEEL → banana (peeled) + banana (skin)
banana (skin) + knife → SLICE → banana (skin, sliced)
""",
        ["banana: peel 0 shell 0", "banana: remains"],
    ),
    story(
        "boiling in water cooks and boils all that is in the pot",
        HEATED
        + """
water (liquid; in bottle) + rice (dry) + pot (empty; on stove) → PUT → pot ({rice, water}; on stove)
pot ({rice, water}; on stove) + stove (on; under pot) → BOIL → rice (cooked; in pot) + pot ({rice, water}; on stove)
""",
        [
            "water: boil 3 cook 3 core -1 cut -1 peel -1 shell -1 stone -1 joined 2 heated 3",
            "rice: boil 3 cook 3 joined 2 heated 3",
        ],
    ),
    story(
        "frying in oil cooks and does not boil",
        HEATED
        + """
oil (liquid; in bottle) + rice (dry) + pot (empty; on stove) → PUT → pot ({oil, rice}; on stove)
pot ({oil, rice}; on stove) + stove (on; under pot) → FRY → rice (fried; in pot) + pot ({oil, rice}; on stove)
""",
        ["oil: cook 3 core -1 cut -1 peel -1 shell -1 stone -1 joined 2 heated 3", "rice: cook 3 joined 2 heated 3"],
    ),
    story(
        "dry heat does not boil even beside water",
        HEATED
        + """
water (liquid; in bottle) + rice (dry) + pot (empty; on stove) → PUT → pot ({rice, water}; on stove)
pot ({rice, water}; on stove) + stove (on; under pot) → ROAST → rice (roasted; in pot) + pot ({rice, water}; on stove)
""",
        ["water: cook 3 core -1 cut -1 peel -1 shell -1 stone -1 joined 2 heated 3", "rice: cook 3 joined 2 heated 3"],
    ),
    story(
        "a spoonful of water boils nothing",
        HEATED
        + """
water (liquid; in bottle) + spoon → SCOOP → water (liquid; in spoon) + spoon ({water})
water (liquid; in spoon) + rice (dry) + pot (empty; on stove) → PUT → water (liquid; in pot) + rice (dry; in pot)
rice (dry; in pot) + pot ({rice, water}; on stove) → BOIL → rice (cooked; in pot) + pot ({rice, water}; on stove)
""",
        [
            "water: cook 4 core -1 cut -1 peel -1 shell -1 stone -1 joined 3 heated 4 spoonful",
            "rice: cook 4 joined 3 heated 4",
        ],
    ),
    story(
        "warming heats and does not cook",
        HEATED
        + """
milk (liquid; in carton) + pot (empty; on stove) → POUR → milk (liquid; in pot) + pot ({milk}; on stove)
milk (liquid; in pot) + pot ({milk}; on stove) + stove (on; under pot) → HEAT → milk (hot; in pot)
""",
        ["milk: core -1 cut -1 peel -1 shell -1 stone -1 heated 3"],
    ),
    story(
        "warming cooks where its output says so",
        HEATED
        + """
milk (liquid; in carton) + pot (empty; on stove) → POUR → milk (liquid; in pot) + pot ({milk}; on stove)
milk (liquid; in pot) + pot ({milk}; on stove) + stove (on; under pot) → HEAT → milk (boiling; in pot)
""",
        ["milk: boil 3 cook 3 core -1 cut -1 peel -1 shell -1 stone -1 heated 3"],
    ),
    story(
        "mixing in a hot pot does not cook",
        HEATED
        + """
beef (raw) + pot (empty; on stove) → PUT → beef (raw; in pot) + pot ({beef}; on stove)
beef (raw; in pot) + pot ({beef}; on stove) + spoon → MIX → beef (raw, mixed; in pot)
""",
        ["beef:"],
    ),
    story(
        "food that is brought together is joined, and mixed when it is stirred",
        """
tomato (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + bowl ({tomato})
onion (sliced) + bowl ({tomato}) → PUT → onion (sliced; in bowl) + bowl ({onion, tomato})
bowl ({onion, tomato}) + spoon → MIX → bowl ({onion, tomato})
basil (chopped) + bowl ({onion, tomato}) → PUT → basil (chopped; in bowl) + bowl ({basil, onion, tomato})
""",
        [
            "tomato: cut -1 fine 2 joined 1 mixed 2",
            "onion: cut -1 fine 2 joined 1 mixed 2",
            "basil: cut -1 fine 3 joined 3",
        ],
    ),
    story(
        "what is poured together into another bowl stays as joined as it was",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → tomato (sliced; in bowl) + onion (sliced; in bowl)
tomato (sliced; in bowl) + onion (sliced; in bowl) + cup (empty) → PUT
  → tomato (sliced; in cup) + onion (sliced; in cup)
""",
        ["tomato: cut -1 fine 2 joined 0", "onion: cut -1 fine 2 joined 0"],
    ),
    story(
        "two of one food are not joined with each other",
        """
tomato (sliced) + tomato (diced) + bowl (empty) → PUT → tomato (sliced; in bowl) + tomato (diced; in bowl)
""",
        ["tomato: cut -1 fine 2", "tomato: cut -1 fine 3"],
    ),
    story(
        "what lies in one bag is not joined",
        """
tomato (sliced) + onion (sliced) + bag → PUT → tomato (sliced; in bag) + onion (sliced; in bag)
""",
        ["tomato: cut -1 fine 2", "onion: cut -1 fine 2"],
    ),
    story(
        "a product joins and mixes its parts",
        """
tomato (sliced) + onion (sliced) → MIX → salad ({onion, tomato})
""",
        ["tomato: cut -1 fine 2 joined 0 mixed 0", "onion: cut -1 fine 2 joined 0 mixed 0"],
    ),
    story(
        "a product of the heat joins its parts and does not mix them",
        HEATED
        + """
tomato (sliced) + onion (sliced) + pot (empty; on stove) → PUT → pot ({onion, tomato}; on stove)
pot ({onion, tomato}; on stove) + stove (on; under pot) → BOIL → soup ({onion, tomato}; in pot) + pot ({soup}; on stove)
""",
        ["tomato: cook 3 cut -1 fine 2 joined 2 heated 3", "onion: cook 3 cut -1 fine 2 joined 2 heated 3"],
    ),
    story(
        "a state that this motion cannot give",
        """
carrot (whole) + knife → SLICE → carrot (grated)
onion (whole) + knife → PEEL → onion (sliced)
""",
        [
            "carrot: cut 0 fine 4",
            "onion: peel 1 shell 1",
            "K4 (minor) step 1 carrot (grated): “slice” does not make it grated",
            "K7 (minor) step 2 onion (sliced): it is sliced, and nobody made it so",
        ],
    ),
    story(
        "a state that nobody earned",
        """
carrot (whole) + plate (empty) → PUT → carrot (peeled, washed; on plate)
beef (raw) + plate (empty) → PUT → beef (cooked; on plate)
""",
        [
            "carrot:",
            "beef:",
            "K7 (minor) step 1 carrot (peeled, washed; on plate): it is peeled, and nobody made it so",
            "K7 (minor) step 1 carrot (peeled, washed; on plate): it is washed, and nobody made it so",
            "K7 (minor) step 2 beef (cooked; on plate): it is cooked, and nobody made it so",
        ],
    ),
    story(
        "what a motion can give of what nobody is judged by is believed",
        """
lettuce (whole) + bowl (empty) → SOAK → lettuce (soaked; in bowl)
bean (dry) + strainer (empty) → STRAIN → bean (drained; in strainer)
raspberry (frozen) + bowl (empty) → THAW → raspberry (thawed; in bowl)
""",
        [
            "lettuce: soak 0",
            "bean: drain 1",
            "raspberry: core -1 cut -1 husk -1 peel -1 shell -1 soak 2 stone -1 thaw 2 heated 2",
        ],
    ),
    story(
        "thawed is what was frozen",
        """
raspberry (fresh) + bowl (empty) → THAW → raspberry (thawed; in bowl)
salmon (frozen) + bowl (empty) → DEFROST → salmon (defrosted; in bowl)
""",
        [
            "raspberry: soak 0 thaw 0 heated 0",
            "salmon: core -1 cut -1 husk -1 peel -1 shell -1 soak 1 stone -1 thaw 1 heated 1",
            "K7 (minor) step 1 raspberry (thawed; in bowl): it is thawed, and it was never frozen",
        ],
    ),
    story(
        "over the heat a food may become cooked by itself",
        HEATED
        + """
beef (raw) + pot (empty; on stove) → PUT → beef (raw; in pot) + pot ({beef}; on stove)
beef (raw; in pot) + pot ({beef}; on stove) + stove (on; under pot) → FRY
  → beef (raw; in pot) + pot (hot; {beef}; on stove)
beef (raw; in pot) + pot (hot; {beef}; on stove) → FLIP → beef (browned; in pot)
""",
        ["beef: cook 3 heated 3"],
    ),
    story(
        "a state that it had before or is sold in is no claim",
        """
carrot (sliced) + plate (empty) → PUT → carrot (sliced; on plate)
pea (whole) + plate (empty) → PUT → pea (frozen; on plate)
""",
        ["carrot: cut -1 fine 2", "pea:"],
    ),
    story(
        "a product claims what it likes",
        """
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → salad (peeled; {onion, tomato}; in bowl) + bowl ({salad})
""",
        ["tomato: cut -1 fine 2 joined 0", "onion: cut -1 fine 2 joined 0"],
    ),
    story(
        "an unknown motion gives whatever it says",
        """
carrot (whole) + knife → FROBNICATE → carrot (ready, wet)
carrot (ready, wet) + knife → FROBNICATE → carrot (sliced)
""",
        ["carrot:", "K7 (minor) step 2 carrot (sliced): it is sliced, and nobody made it so"],
    ),
    story(
        "a portion has the history of the whole and its own after it",
        """
apple (whole) + knife → PEEL → apple (peeled)
apple (peeled) + bowl (empty) + cup (empty) → SEPARATE → apple (halved; in bowl) + apple (halved; in cup)
apple (halved; in cup) + knife → DICE → apple (diced; in cup)
""",
        ["apple: peel 0 shell 0", "apple: cut 2 peel 0 shell 0 fine 3"],
    ),
    story(
        "an egg that comes out of the pan browned without a heat of its own",
        HEATED
        + """
egg (cracked) + plate (empty) → PUT → egg (cracked; on plate) + plate ({egg})
egg (cracked; on plate) + spoon → FLIP → egg (browned; on plate)
leek (sliced) + pot (empty; on stove) → PUT → leek (sliced; in pot) + pot ({leek}; on stove)
leek (sliced; in pot) + spoon → FLIP → leek (browned; in pot)
""",
        ["egg: shell -1", "leek: cut -1 fine 2"],
    ),
    story(
        "the coldest fridge browns nothing",
        """
beef (raw) + tray (empty) → PUT → beef (raw; on tray) + tray ({beef})
tray ({beef}) + oven (off) → PUT → tray ({beef}; in oven)
oven (off) → TURN ON → oven (on)
beef (raw; on tray) + tray ({beef}; in oven) → BAKE → beef (raw; on tray) + tray ({beef}; in oven)
tray ({beef}; in oven) + fridge (on) → PUT → tray ({beef}; in fridge)
beef (raw; on tray) + spoon → FLIP → beef (browned; on tray)
""",
        ["beef: cook 3 heated 3"],
    ),
    story(
        "a shell that comes out under its own name is left over",
        """
egg (whole) + bowl (empty) → CRACK → egg shell (in bin) + egg (cracked; in bowl) + bowl ({egg})
""",
        ["egg: open 0 shell 0", "egg: remains"],
    ),
    story(
        "a portion was joined, mixed and heated as the whole was",
        HEATED
        + """
leek (sliced) + milk (liquid; in carton) + pot (empty; on stove) → MIX
  → soup ({leek, milk}; in pot) + pot ({soup}; on stove)
soup ({leek, milk}; in pot) + pot ({soup}; on stove) + stove (on; under pot) → BOIL
  → soup (cooked; {leek, milk}; in pot)
soup (cooked; {leek, milk}; in pot) + cup (empty) + bowl (empty) → PUT → soup (cooked; in cup) + soup (cooked; in bowl)
""",
        [
            "leek: boil 3 cook 3 cut -1 fine 2 joined 2 mixed 2 heated 3",
            "milk: boil 3 cook 3 core -1 cut -1 peel -1 shell -1 stone -1 joined 2 mixed 2 heated 3",
            "leek: boil 3 cook 3 cut -1 fine 2 joined 2 mixed 2 heated 3",
            "milk: boil 3 cook 3 core -1 cut -1 peel -1 shell -1 stone -1 joined 2 mixed 2 heated 3",
        ],
    ),
    story(
        "raw food in a hot pan over the fire browns when it is turned",
        HEATED
        + """
milk (liquid; in carton) + pot (empty; on stove) → POUR → milk (liquid; in pot) + pot ({milk}; on stove)
milk (liquid; in pot) + pot ({milk}; on stove) + stove (on; under pot) → BOIL
  → milk (boiling; in pot) + pot (hot; {milk}; on stove)
leek (sliced) + pot (hot; {milk}; on stove) → PUT → leek (sliced; in pot) + pot (hot; {leek, milk}; on stove)
leek (sliced; in pot) + spoon → PUT → leek (browned; in pot)
""",
        [
            "milk: boil 3 cook 3 core -1 cut -1 peel -1 shell -1 stone -1 joined 4 heated 3",
            "leek: cut -1 fine 2 joined 4",
        ],
    ),
    story(
        "a portion of what nobody told of is told of no better",
        """
bowl ({apple}) + cup (empty) + glass (empty) → SEPARATE → apple (in cup) + apple (in glass)
""",
        ["apple: untold", "apple: untold"],
    ),
    story(
        "what lies in no vessel is heated all the same",
        """
oven (off) → TURN ON → oven (on)
beef (raw) + leek (sliced) + oven (on) → BAKE → beef (baked) + oven (on)
""",
        ["beef: cook 1 heated 1", "leek: cook 1 cut -1 fine 2 heated 1"],
    ),
]


@pytest.mark.parametrize(("text", "told", "asked"), STORIES)
def test_treatment(text, told, asked):
    assert view(play(text, asked)) == told


@pytest.mark.parametrize(
    ("motion", "mixes"),
    [
        ("combine", True), ("blend", True), ("knead", True), ("mash", True), ("whip", True), ("put", False),
        ("boil", False), ("slice", False), ("wait", False), ("shape", False),
    ],
)  # fmt: skip
def test_what_mixes_mixes_all_that_is_in_the_bowl(motion, mixes):
    world = play(f"""
tomato (sliced) + onion (sliced) + bowl (empty) → PUT → bowl ({{onion, tomato}})
bowl ({{onion, tomato}}) + spoon → {motion.upper()} → bowl ({{onion, tomato}}; on table)
""")
    assert {part.mixed for part in world.supply.parts} == {1 if mixes else None}
    assert {part.joined for part in world.supply.parts} == {0}


@pytest.mark.parametrize(
    ("motion", "joins", "mixes"),
    [
        ("combine", True, True), ("blend", True, True), ("mash", True, True), ("knead", True, True),

        ("whip", True, True), ("boil", True, False), ("boil and stir", True, True),
        ("put", False, False), ("wait", False, False),
    ],
)  # fmt: skip
def test_a_product_without_a_vessel_is_joined_and_mixed_by_what_makes_it(motion, joins, mixes):
    world = play(f'tomato (sliced) + onion (sliced) → "{motion}" → salad ({{onion, tomato}})')
    assert {part.joined for part in world.supply.parts} == {0 if joins else None}
    assert {part.mixed for part in world.supply.parts} == {0 if mixes else None}


@pytest.mark.parametrize(
    ("motion", "treatment"),
    [
        ("slice", "cut"), ("grate", "grate"), ("grind", "grind"), ("mash", "mash"), ("peel", "peel"), ("core", "core"),
        ("pit", "stone"), ("crack", "shell"), ("husk", "husk"), ("open", "open"), ("wash", "wash"),
    ],
)  # fmt: skip
def test_hands_work_on_the_food_that_comes_out_in_another_form(motion, treatment):
    world = play(f"carrot (whole) + onion (whole) → {motion.upper()} → carrot (done) + onion (whole)")
    done = {part.name: treatment in part.done for part in world.supply.parts}
    assert done == {"carrot": True, "onion": False}


@pytest.mark.parametrize(("motion", "treatment"), [("soak", "soak"), ("blend", "blend")])
def test_what_works_by_itself_works_on_all_that_went_in(motion, treatment):
    world = play(f"carrot (whole) + onion (whole) → {motion.upper()} → carrot (done) + onion (whole)")
    assert {part.name for part in world.supply.parts if treatment in part.done} == {"carrot", "onion"}


@pytest.mark.parametrize(
    ("motion", "fine"),
    [("grate", 4), ("grind", 5), ("blend", 5), ("mash", 5), ("cut", 2), ("peel", 0), ("mix", 0), ("squeeze", 0)],
)
def test_how_fine_a_motion_makes_a_food_that_tells_no_state_of_it(motion, fine):
    (part,) = play(f"carrot (whole) → {motion.upper()} → carrot (done)").supply.parts
    assert part.fine == fine


@pytest.mark.parametrize(("first", "fault"), [("sliced", True), ("halved", False), ("chopped", True), ("whole", False)])
def test_only_what_is_finer_already_is_told(first, fault):
    world = play(f"carrot ({first}) + knife → HALVE → carrot (halved, again)")
    assert [told for told in faults(world) if "finer" in told] == (
        ["K7 (minor) step 1: carrot is in finer pieces already"] if fault else []
    )


@pytest.mark.parametrize("treatment", ["thaw", "soak", "drain", "wash", "open"])
def test_what_nobody_is_judged_by_is_believed_of_a_motion_that_can_give_it(treatment):
    states = {"thaw": "thawed", "soak": "soaked", "drain": "drained", "wash": "washed", "open": "opened"}
    motions = {"thaw": "thaw", "soak": "soak", "drain": "drain", "wash": "rinse", "open": "open"}
    world = play(
        f"salmon (frozen) + bowl (empty) → {motions[treatment].upper()} → salmon ({states[treatment]}; in bowl)"
    )
    (part,) = world.supply.parts
    assert part.done[treatment] == 0
    assert faults(world) == []
    put = play(f"salmon (frozen) + bowl (empty) → PUT → salmon ({states[treatment]}; in bowl)")
    assert treatment not in put.supply.parts[0].done
    assert any("nobody made it so" in told for told in faults(put))
