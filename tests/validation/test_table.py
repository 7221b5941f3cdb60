"""K1 to K4 (docs/contract.md): each clause kept and broken by a small tree."""

from __future__ import annotations

import pytest
from validation.judging import ONE_TOMATO, found, report


def lines(*steps):
    return "\n".join(step.strip() for step in steps)


def on_plate(food, state="raw", holds=None):
    """One step that puts a food on a plate."""
    return f"{food} ({state}) + plate (empty) → PUT → {food} ({state}; on plate) + plate ({{{holds or food}}})"


def grilled(food, state="raw", motion="GRILL", ends="grilled"):
    """Steps that lay a food on a grill, and one that works on it there."""
    return f"""
{food} ({state}) + grill (off) → PUT → {food} ({state}; on grill) + grill (off)
grill (off) → TURN ON → grill (on)
{food} ({state}; on grill) + grill (on) → {motion} → {food} ({ends}; on grill) + grill (on)
"""


def boiled(food, state="whole", liquid="water", motion="BOIL", ends="cooked"):
    """Steps that put a food into a pot with a liquid, and one that works on it over heat."""
    filled = f"{liquid} (liquid; in pot) + pot ({{{liquid}}}; on stove)" if liquid else "pot (empty; on stove)"
    holds = f"{food}, {liquid}" if liquid else food
    fill = f"{liquid} (liquid; in bottle) + pot (empty; on stove) → POUR → {filled}" if liquid else ""
    return f"""
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
{fill}
{food} ({state}) + {filled.rpartition(" + ")[2]} → PUT → {food} ({state}; in pot) + pot ({{{holds}}}; on stove)
stove (off; under pot) → TURN ON → stove (on; under pot)
{food} ({state}; in pot) + pot ({{{holds}}}; on stove) + stove (on; under pot) → {motion}
  → {food} ({ends}; in pot) + pot ({{{holds}}}; on stove)
"""


# --- K1 raw ---


@pytest.mark.parametrize(
    "food", ["beef", "chicken", "salmon", "shrimp", "egg", "potato", "pumpkin", "eggplant", "artichoke"]
)
def test_k1_what_nobody_eats_raw_is_fatal(food):
    assert found("K1", on_plate(food)) == [f"K1: {food} is in the dish and was not cooked at all"]


@pytest.mark.parametrize(
    "food", ["beef", "chicken", "salmon", "shrimp", "egg", "potato", "pumpkin", "eggplant", "artichoke"]
)
def test_k1_a_step_over_heat_cooked_it(food):
    assert found("K1", grilled(food)) == []


@pytest.mark.parametrize("food", ["tomato", "apple", "almond", "cheese", "milk", "asparagus"])
def test_k1_what_may_be_eaten_raw(food):
    assert found("K1", on_plate(food)) == []


@pytest.mark.parametrize("food", ["leek", "parsnip", "okra"])
def test_k1_what_is_odd_raw_is_minor(food):
    assert found("K1", on_plate(food)) == [f"K1 (minor): {food} is in the dish and was not cooked at all"]


@pytest.mark.parametrize("food", ["rice", "spaghetti", "lentil"])
def test_k1_dry_starch_is_cooked_in_enough_liquid(food):
    told = f"K1: {food} is in the dish and was not cooked in enough liquid"
    assert found("K1", boiled(food)) == []
    assert found("K1", on_plate(food, "dry")) == [told]
    assert found("K1", grilled(food, "dry", ends="roasted")) == [told]
    assert found("K1", boiled(food, liquid="")) == [told]


@pytest.mark.parametrize(("liquid", "enough"), [("water", True), ("milk", True), ("broth", True), ("oil", False)])
def test_k1_what_is_enough_liquid(liquid, enough):
    assert (not [told for told in found("K1", boiled("rice", liquid=liquid)) if "rice" in told]) is enough


def test_k1_a_spoonful_is_not_enough_liquid():
    spoonful = """
water (liquid; in bottle) + spoon → SCOOP → water (liquid; in spoon) + spoon ({water})
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
water (liquid; in spoon) + spoon ({water}) + pot (empty; on stove) → POUR
  → water (liquid; in pot) + pot ({water}; on stove)
"""
    rest = "\n".join(boiled("rice").strip().split("\n")[2:])
    assert len(found("K1", spoonful + rest)) == 1


@pytest.mark.parametrize("motion", ["STIR", "MIX", "WAIT", "POUR"])
def test_k1_nothing_else_over_heat_cooks(motion):
    assert found("K1", grilled("beef", motion=motion, ends="raw")) == [
        "K1: beef is in the dish and was not cooked at all"
    ]


def test_k1_the_name_of_a_new_state_does_not_cook():
    step = "beef (raw) + plate (empty) → PUT → beef (cooked; on plate) + plate ({beef})"
    assert found("K1", step) == ["K1: beef is in the dish and was not cooked at all"]


def test_k1_heating_cooks_where_the_step_says_so():
    assert found("K1", grilled("beef", motion="HEAT", ends="cooked")) == []
    assert found("K1", grilled("beef", motion="HEAT", ends="hot")) == [
        "K1: beef is in the dish and was not cooked at all"
    ]


def test_k1_what_is_sold_cooked_is_cooked():
    assert found("K1", on_plate("chickpea", "canned")) == []
    assert found("K1", on_plate("salmon", "canned")) == []
    assert found("K1", on_plate("salmon", "smoked")) == []


def test_k1_an_egg_is_odd_in_a_drink_and_in_a_cake_and_fatal_elsewhere():
    step = (
        "egg (whole) + milk (liquid; in carton) + glass (empty) → MIX → shake ({egg, milk}; in glass) + glass ({shake})"
    )
    asked = "asked: egg (whole); milk (liquid)\n"
    for dish in ("drinks", "cake", "sauce"):
        assert found("K1", f"dish: {dish}\n{asked}{step}") == [
            "K1 (minor): egg is in the dish and was not cooked at all"
        ]
    for dish in ("soup", "salad"):
        assert found("K1", f"dish: {dish}\n{asked}{step}") == ["K1: egg is in the dish and was not cooked at all"]
    assert found("K1", f"dish: drinks\nasked: beef\n{on_plate('beef')}") == [
        "K1: beef is in the dish and was not cooked at all"
    ]


CREAM = (
    "{egg} (liquid) + milk (liquid; in carton) + bowl (empty) → MIX"
    " → cream ({{{egg}, milk}}; in bowl) + bowl ({{cream}})"
)


@pytest.mark.parametrize("egg", ["egg yolk", "egg"])
def test_k1_a_titled_pudding_holds_no_raw_egg_unless_it_is_called_so(egg):
    asked = f"asked: {egg} (raw); milk (liquid)\n{CREAM.format(egg=egg)}"
    told = f"{egg} is in the dish and was not cooked at all"
    assert found("K1", f"dish: pudding\ntitle: Vanilla Pudding\n{asked}") == [f"K1: {told}"]
    assert found("K1", f"dish: pudding\ntitle: Chocolate Mousse\n{asked}") == [f"K1 (minor): {told}"]
    assert found("K1", f"dish: drinks\ntitle: Milk Punch\n{asked}") == [f"K1 (minor): {told}"]
    assert found("K1", f"dish: pudding\n{asked}") == [f"K1 (minor): {told}"]


def test_k1_flour_is_heated_and_what_makes_it_rise():
    for food in ("flour", "cornmeal", "semolina", "cornstarch"):
        assert found("K1", on_plate(food, "powder")) == [f"K1: {food} is in the dish, and nothing heated it"]
        assert found("K1", boiled(food, "powder")) == []
    for food in ("almond flour", "baking powder"):
        assert found("K1", on_plate(food, "powder")) == []


def test_k1_starch_is_dusted_with_fine_sugar_over_what_is_sticky():
    step = (
        "cornstarch (powder) + powdered sugar (powder) + plate (empty) → SPRINKLE"
        " → cornstarch (powder; on plate) + powdered sugar (powder; on plate) + plate ({cornstarch, powdered sugar})"
    )
    assert found("K1", step) == []


def test_k1_what_makes_a_dough_rise_comes_before_the_heat():
    late = boiled("flour", "powder") + (
        "baking soda (powder) + flour (cooked; in pot) + pot ({flour, water}; on stove) → SPRINKLE"
        " → porridge ({baking soda, flour, water}; in pot) + pot ({porridge}; on stove)"
    )
    assert found("K1", late) == ["K1 step 6: baking soda is in the dish, and nothing heated it"]


def test_k1_each_raw_food_is_told():
    step = "beef (raw) + potato (whole) + plate (empty) → PUT → beef (raw; on plate) + potato (whole; on plate) + plate"
    assert {told.split()[1] for told in found("K1", step)} == {"beef", "potato"}


def test_k1_what_is_not_in_the_dish_is_not_asked():
    away = "beef (raw) + bowl (empty) → PUT → beef (raw; in bowl) + bowl ({beef})"
    assert found("K1", lines(away, ONE_TOMATO)) == []


def test_k1_what_only_a_name_in_braces_tells_is_not_called_raw():
    assert found("K1", "bag ({beef}) + plate (empty) → POUR → plate ({beef}) + beef (on plate)") == []


# --- K2 whole ---


def whole(food, state="whole"):
    return found("K2", on_plate(food, state))


@pytest.mark.parametrize(
    ("food", "told"),
    [
        ("tomato", ["K2: tomato is in the dish in one piece"]),
        ("cabbage", ["K2 (minor): cabbage is in the dish with its core", "K2: cabbage is in the dish in one piece"]),
        ("onion", ["K2: onion is in the dish in one piece", "K2 (minor): onion is in the dish in its skin"]),
        ("apple", ["K2 (minor): apple is in the dish with its core", "K2: apple is in the dish in one piece"]),
        ("orange", ["K2: orange is in the dish in its skin"]),
        ("banana", ["K2 (minor): banana is in the dish in one piece", "K2: banana is in the dish in its skin"]),
        (
            "avocado",
            [
                "K2: avocado is in the dish in one piece",
                "K2: avocado is in the dish in its skin",
                "K2 (minor): avocado is in the dish with its stone",
            ],
        ),
        ("cherry", ["K2 (minor): cherry is in the dish with its stone"]),
        ("egg", ["K2: egg is in the dish in its shell"]),
        (
            "artichoke",
            [
                "K2 (minor): artichoke is in the dish with its choke",
                "K2 (minor): artichoke is in the dish in one piece",
            ],
        ),
        ("corn", ["K2: corn is in the dish in its husk"]),
        ("cheese", ["K2 (minor): cheese is in the dish in one piece"]),
        ("strawberry", ["K2 (minor): strawberry is in the dish with its core"]),
        ("almond", []),
        ("wakame", ["K2 (minor): wakame is in the dish as hard as it was dried"]),
        ("spinach", []),
    ],
)
def test_k2_food_in_a_form_in_which_nobody_eats_it(food, told):
    assert whole(food) == told


def test_k2_the_findings_of_one_food_are_in_the_order_of_their_names():
    told = whole("avocado")
    assert [line.rpartition(" ")[2] for line in told] == ["piece", "skin", "stone"]


@pytest.mark.parametrize(
    ("food", "state"),
    [
        ("tomato", "canned"), ("tomato", "sliced"), ("tomato", "paste"), ("onion", "powder"), ("cherry", "pitted"),
        ("cheese", "grated"), ("egg", "liquid"), ("orange", "juice"), ("avocado", "pulp"),
    ],
)  # fmt: skip
def test_k2_a_state_in_which_it_is_sold_tells_what_was_done(food, state):
    assert whole(food, state) == []


def worked(food, motion, ends="cut", tool="knife"):
    step = f'{food} (whole) + plate (empty) + {tool} → "{motion}" → {food} ({ends}; on plate) + plate ({{{food}}})'
    return found("K2", step)


@pytest.mark.parametrize(
    ("motion", "ends"),
    [
        ("slice", "sliced"), ("chop", "chopped"), ("grate", "grated"), ("grind", "ground"), ("mash", "mashed"),
        ("blend", "blended"), ("halve", "halved"), ("dice", "diced"),
    ],
)  # fmt: skip
def test_k2_whatever_divides_a_food_is_enough(motion, ends):
    assert worked("tomato", motion, ends) == []


def test_k2_nobody_finds_the_choke_of_an_artichoke_that_was_cut_up():
    assert "K2: artichoke is in the dish with its choke" in worked("artichoke", "chop", "chopped")
    assert whole("artichoke", "canned") == []


@pytest.mark.parametrize("motion", ["peel", "wash", "put", "mix", "core"])
def test_k2_what_does_not_divide_a_food_is_not_enough(motion):
    assert "K2: tomato is in the dish in one piece" in worked("tomato", motion, "whole")


@pytest.mark.parametrize(
    ("food", "motion", "gone"),
    [
        ("orange", "peel", "in its skin"), ("egg", "crack", "in its shell"), ("egg", "peel", "in its shell"),
        ("apple", "core", "with its core"), ("cherry", "pit", "with its stone"), ("cherry", "core", "with its stone"),
        ("apple", "pit", "with its core"), ("corn", "husk", "in its husk"), ("corn", "peel", "in its husk"),
        ("corn", "slice", "in its husk"), ("egg", "open", "in its shell"), ("apple", "squeeze", "with its core"),
    ],
)  # fmt: skip
def test_k2_what_takes_a_skin_shell_core_or_stone_away(food, motion, gone):
    ends = "juice" if motion == "squeeze" else "ready"
    assert not [told for told in worked(food, motion, ends) if told.endswith(gone)]


@pytest.mark.parametrize(
    ("food", "motion", "left"),
    [
        ("orange", "slice", "in its skin"), ("egg", "slice", "in its shell"), ("apple", "peel", "with its core"),
        ("cherry", "slice", "with its stone"), ("corn", "wash", "in its husk"), ("artichoke", "peel", "with its choke"),
        ("orange", "open", "in its skin"),
    ],
)  # fmt: skip
def test_k2_what_does_not_take_it_away(food, motion, left):
    assert [told for told in worked(food, motion, "ready") if told.endswith(left)]


@pytest.mark.parametrize(
    ("dish", "food", "told"),
    [
        ("salad", "pear", ["K2 (minor): half of one pear is more than a bite"]),
        ("salad\ntitle: Grilled Pear Salad", "pear", ["K2 (minor): half of one pear is more than a bite"]),
        ("rice\ntitle: Stuffed Pears with Rice", "pear", []),
        ("salad", "baby beet", []),
        ("roast", "pear", []),
        ("sandwich", "pear", []),
        ("salad", "radish", []),
    ],
)
def test_k2_halves_are_no_bites_of_what_is_eaten_without_a_knife(dish, food, told):
    step = f"{food} (cored) + plate (empty) + knife → CUT → {food} (halved; on plate) + plate ({{{food}}})"
    assert [one for one in found("K2", f"dish: {dish}\n{step}") if "bite" in one] == told


def test_k2_remains_are_no_food():
    peel = "banana (whole) + hand + plate (empty) → PEEL → banana (peeled) + banana (skin; on plate) + plate ({banana})"
    text = f"goal: banana (skin; on plate)\n{peel}"
    assert "K2: the remains of banana are in the dish" in found("K2", text)
    kept = "banana (whole) + plate (empty) + bin → PEEL → banana (peeled; on plate) + banana (skin; in bin)"
    assert not [told for told in found("K2", f"goal: banana (peeled; on plate)\n{kept}") if "remains" in told]


def test_k2_remains_that_a_recipe_asks_for_are_food():
    step = on_plate("onion", "skin")
    assert found("K2", f"dish: salad\nasked: onion (skin)\n{step}") == []
    assert found("K2", f"dish: salad\nasked: onion (brown skin)\n{step}") == []
    for asked in ("onion (whole)", "onion", "lemon (skin)"):
        assert found("K2", f"dish: salad\nasked: {asked}\n{step}") == ["K2: the remains of onion are in the dish"]


def test_k2_remains_that_a_recipe_asks_for_may_be_peeled_off_in_the_tree():
    step = "onion (whole) + knife + plate (empty) → PEEL → onion (peeled) + onion (skin; on plate) + plate ({onion})"
    assert found("K2", f"dish: salad\nasked: onion (skin)\ngoal: onion (skin; on plate)\n{step}") == []


def test_k2_what_only_a_name_in_braces_tells_is_not_called_whole():
    assert found("K2", "bag ({tomato}) + plate (empty) → POUR → plate ({tomato}) + tomato (on plate)") == []


# --- K3 time ---

SOUP = """
pot (empty) + stove (off) → PUT → pot (empty; on stove) + stove (off; under pot)
tomato (canned; in can) + pot (empty; on stove) → POUR → tomato (canned; in pot) + pot ({tomato}; on stove)
stove (off; under pot) → TURN ON → stove (on; under pot)
tomato (canned; in pot) + pot ({tomato}; on stove) + stove (on; under pot) → BOIL
  → tomato (cooked; in pot) + pot ({tomato})
"""


def then(food, state="liquid", dish="soup"):
    """The soup of tomatoes with something that comes after it was cooked."""
    add = f"{food} ({state}; in bottle) + tomato (cooked; in pot) → POUR → soup ({{{food}, tomato}}; in pot)"
    return f"dish: {dish}\nasked: tomato (canned); {food} ({state})\n{SOUP}{add}"


@pytest.mark.parametrize("food", ["water", "milk", "broth", "wine", "chicken broth"])
def test_k3_liquid_after_the_last_cooking_is_minor(food):
    assert found("K3", then(food)) == [f"K3 (minor) step 5: {food} comes after the last cooking"]


@pytest.mark.parametrize(
    "food", ["olive oil", "cream", "honey", "crushed tomato", "soy sauce", "basil", "salt", "hot sauce"]
)
def test_k3_what_is_added_for_its_taste_may_come_late(food):
    assert found("K3", then(food)) == []


def test_k3_liquid_that_was_cooked_with_the_rest_came_in_time():
    early = SOUP.replace("tomato (canned; in can)", "milk (liquid; in carton) + tomato (canned; in can)").replace(
        "tomato (canned; in pot) + pot ({tomato}; on stove)",
        "milk (liquid; in pot) + tomato (canned; in pot) + pot ({milk, tomato}; on stove)",
    )
    assert found("K3", f"dish: soup\nasked: tomato (canned); milk (liquid)\n{early}") == []


def test_k3_in_a_dish_that_is_eaten_cold_liquid_may_come_at_any_time():
    assert found("K3", then("milk", dish="salad")) == []
    assert found("K3", then("milk").split("\n", 2)[2]) == []


def test_k3_nothing_is_late_where_nothing_was_cooked():
    step = "milk (liquid; in carton) + tomato (canned; in can) + pot (empty) → POUR → soup ({milk, tomato}; in pot)"
    assert found("K3", f"dish: soup\nasked: tomato (canned); milk (liquid)\n{step}") == []


def test_k3_leaves_that_are_cooked_together_with_what_must_be_cooked():
    text = """
beef (raw) + grill (off) → PUT → beef (raw; on grill) + grill (off)
spinach (leaves; in bag) + grill (off) → PUT → spinach (leaves; on grill) + grill (off)
grill (off) → TURN ON → grill (on)
beef (raw; on grill) + spinach (leaves; on grill) + grill (on) → GRILL → beef (grilled; on grill) + grill (on)
"""
    assert found("K3", text) == ["K3 (minor) step 4: spinach is cooked together with beef"]
    assert found("K3", text.replace("→ GRILL →", "→ HEAT →")) == []
    assert found("K3", text.replace("beef", "tomato")) == []
    assert found("K3", text.replace("spinach", "onion")) == []
    assert found("K3", text.replace("beef", "leek")) == []


EGGS = boiled("egg").strip()


def peeled_egg(motion="peel", between="", ends="peeled"):
    last = f"egg (cooked) + bowl (empty) + hand → {motion.upper()} → egg ({ends}; in bowl) + bowl ({{egg}})"
    last = last.replace("egg (cooked)", "egg (cooked; in pot)") if not between else last
    return found("K3", lines(EGGS, between, last))


@pytest.mark.parametrize("motion", ["peel", "shell"])
def test_k3_eggs_are_peeled_before_they_have_cooled(motion):
    assert peeled_egg(motion) == ["K3 (minor) step 6: eggs are peeled boiling hot"]


@pytest.mark.parametrize("motion", ["wash", "rinse", "soak", "cool", "wait"])
def test_k3_eggs_that_have_cooled_are_peeled(motion):
    cooled = f"egg (cooked; in pot) + bowl (empty) → {motion.upper()} → egg (cooked)"
    assert peeled_egg(between=cooled) == []


def test_k3_eggs_that_were_only_moved_are_hot_still():
    moved = "egg (cooked; in pot) + bowl (empty) → PUT → egg (cooked; in bowl)"
    last = "egg (cooked; in bowl) + hand → PEEL → egg (peeled; in bowl)"
    assert found("K3", lines(EGGS, moved, last)) == ["K3 (minor) step 7: eggs are peeled boiling hot"]


def test_k3_washing_before_the_boiling_cools_nothing():
    washed = lines("egg (whole) + bowl (empty) → WASH → egg (whole)", EGGS)
    last = "egg (cooked; in pot) + hand + bowl (empty) → PEEL → egg (peeled; in bowl)"
    assert found("K3", lines(washed, last)) == ["K3 (minor) step 7: eggs are peeled boiling hot"]


def test_k3_raw_eggs_are_cracked_and_other_hot_food_is_peeled():
    assert found("K3", "egg (whole) + bowl (empty) → PEEL → egg (peeled; in bowl) + bowl ({egg})") == []
    potato = (
        boiled("potato").strip() + "\npotato (cooked; in pot) + bowl (empty) + hand → PEEL → potato (peeled; in bowl)"
    )
    assert found("K3", potato) == []


# --- K4 tool ---


@pytest.mark.parametrize("tool", ["grater", "peeler", "food processor", "fork"])
def test_k4_grating_with_what_grates_or_peels(tool):
    step = f"carrot (whole) + {tool} + bowl (empty) → GRATE → carrot (grated; in bowl) + bowl ({{carrot}})"
    assert found("K4", step) == []


@pytest.mark.parametrize("tool", ["spoon", "bowl", "mortar"])
def test_k4_grating_without_is_fatal_for_the_robot_and_the_cook(tool):
    step = f"carrot (whole) + {tool} + plate (empty) → GRATE → carrot (grated; on plate) + plate ({{carrot}})"
    judged = report(step)
    assert [str(one) for one in judged.of(["K4"])] == ["K4 step 1: it is grated without grater, peeler or processor"]
    assert (judged.robot, judged.cook) == (False, False)


@pytest.mark.parametrize("motion", ["slice", "mix", "grate", "beat"])
def test_k4_cutting_or_mixing_with_a_lid(motion):
    step = f'carrot (whole) + lid + plate (empty) → "{motion}" → carrot (whole; on plate) + plate ({{carrot}})'
    assert f"K4 step 1 lid: “{motion}” with a lid" in found("K4", step)


@pytest.mark.parametrize("motion", ["cover", "put", "wait", "heat"])
def test_k4_a_lid_may_do_other_things(motion):
    step = f'carrot (whole) + lid + plate (empty) → "{motion}" → carrot (whole; on plate) + plate ({{carrot}})'
    assert found("K4", step) == []


@pytest.mark.parametrize("tool", ["knife", "food processor (on)"])
def test_k4_a_lid_beside_a_tool_or_an_appliance_is_no_tool(tool):
    step = f"carrot (whole) + lid + {tool} + plate (empty) → SLICE → carrot (sliced; on plate) + plate ({{carrot}})"
    assert found("K4", step) == []


def test_k4_the_lid_that_is_named_first_is_told_once():
    step = "carrot (whole) + pot lid + lid + plate (empty) → MIX → carrot (whole; on plate) + plate ({carrot})"
    assert found("K4", step) == ["K4 step 1 pot lid: “mix” with a lid"]


@pytest.mark.parametrize(
    ("motion", "ends"), [("slice", "grated"), ("grate", "diced"), ("mix", "diced"), ("peel", "chopped")]
)
def test_k4_a_motion_that_cannot_give_that_state_is_minor(motion, ends):
    step = (
        f"carrot (whole) + grater + plate (empty) → {motion.upper()} → carrot ({ends}; on plate) + plate ({{carrot}})"
    )
    judged = report(step)
    wrong = [one for one in judged.findings if ends in one.reason and one.rule in {"K4", "K7"}]
    assert [one.minor for one in wrong] == [True]
    assert wrong[0].step == 0
    assert [node.label for node in wrong[0].nodes] == ["carrot"]


@pytest.mark.parametrize(("motion", "ends"), [("slice", "sliced"), ("grate", "grated"), ("slice", "thinly sliced")])
def test_k4_a_motion_that_gives_the_state_it_claims(motion, ends):
    step = (
        f"carrot (whole) + grater + plate (empty) → {motion.upper()} → carrot ({ends}; on plate) + plate ({{carrot}})"
    )
    assert found("K4", step) == []


# --- K3: what makes dough rise ---


@pytest.mark.parametrize(("cooling", "dead"), [("", True), ("COOL", False)])
def test_k3_boiling_water_kills_yeast(cooling, dead):
    states = "boiling, cooled" if cooling else "boiling"
    cooled = f"water (boiling; in pot) + pot (hot; {{water}}) → {cooling} → water ({states}; in pot) + pot ({{water}})"
    tree = lines(
        "water (liquid; in bottle) + pot (empty) → POUR → water (liquid; in pot) + pot ({water})",
        "pot ({water}) + stove (off) → PUT → pot ({water}; on stove) + stove (off)",
        "stove (off) → TURN ON → stove (on)",
        "water (liquid; in pot) + pot ({water}; on stove) + stove (on) → BOIL "
        "→ water (boiling; in pot) + pot (hot; {water})",
        cooled if cooling else "stove (on) → TURN OFF → stove (off)",
        "yeast (powder; in packet) + bowl (empty) → POUR → yeast (powder; in bowl) + bowl ({yeast})",
        f"water ({states}; in pot) + bowl ({{yeast}}) → POUR → water ({states}; in bowl) + bowl ({{water, yeast}})",
        f"water ({states}; in bowl) + yeast (powder; in bowl) + bowl ({{water, yeast}}) + spoon → MIX "
        "→ mixture (mixed; {water, yeast}; in bowl) + bowl ({mixture})",
    )
    assert bool([line for line in found("K3", tree) if "is killed by boiling water" in line]) is dead
