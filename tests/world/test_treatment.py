"""What a step does to its foods by hands and tools: which treatments each part has had."""

from __future__ import annotations

import pytest
from world.playing import faults, play, story, told_treatment
from world.starts import HEATED

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
        ["tomato: unstated"],
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
            "tuna: unstated",
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
        ["carrot: cut 1 mash 1 fine 5", "jam: unstated"],
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
    assert told_treatment(play(text, asked)) == told


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
