"""K1 and K2 (docs/contract.md): each clause kept and broken by a small tree."""

from __future__ import annotations

import pytest
from validation.dishes import boiled, lines
from validation.judging import ONE_TOMATO, found


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


@pytest.mark.parametrize(
    ("state", "told"), [("boiled", "K1"), ("whole", "K1 (minor)"), ("beaten", "K1 (minor)"), ("hard boiled", "K1")]
)
def test_k1_no_dish_eases_an_egg_that_is_asked_boiled(state, told):
    step = (
        "egg (whole) + milk (liquid; in carton) + glass (empty) → MIX → shake ({egg, milk}; in glass) + glass ({shake})"
    )
    tree = f"dish: drinks\nasked: egg ({state}); milk (liquid)\n{step}"
    assert found("K1", tree) == [f"{told}: egg is in the dish and was not cooked at all"]


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


@pytest.mark.parametrize(("asked", "faults"), [("halved", 0), ("chopped", 1)])
def test_k2_halves_that_are_asked_and_cooked_are_divided_with_a_spoon(asked, faults):
    board, pot = "plate ({potato})", "pot ({potato}; on stove)"
    steps = f"""potato (whole) + plate (empty) + knife → CUT → potato (halved; on plate) + {board}
        pot (empty) + stove (off) → PICK-AND-PLACE → pot (empty; on stove) + stove (off; under pot)
        stove (off; under pot) → TURN ON → stove (on; under pot)
        pot (empty; on stove) + {board} + potato (halved; on plate) → POUR → {pot} + potato (halved; in pot)
        {pot} + stove (on; under pot) + potato (halved; in pot) → BOIL → {pot} + potato (boiled, halved; in pot)"""
    found_there = found("K2", f"dish: soup\nasked: potato ({asked})\n{steps}")
    assert len([one for one in found_there if "bite" in one]) == faults


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
    assert found("K2", f"dish: salad\nasked: onions (skin)\n{step}") == []
    for asked in ("onion (whole)", "onion", "lemon (skin)"):
        assert found("K2", f"dish: salad\nasked: {asked}\n{step}") == ["K2: the remains of onion are in the dish"]


def test_k2_remains_that_a_recipe_asks_for_may_be_peeled_off_in_the_tree():
    step = "onion (whole) + knife + plate (empty) → PEEL → onion (peeled) + onion (skin; on plate) + plate ({onion})"
    assert found("K2", f"dish: salad\nasked: onion (skin)\ngoal: onion (skin; on plate)\n{step}") == []


def test_k2_what_only_a_name_in_braces_tells_is_not_called_whole():
    assert found("K2", "bag ({tomato}) + plate (empty) → POUR → plate ({tomato}) + tomato (on plate)") == []


# --- K1 raw: what is eaten raw only in what takes it up ---


def strewn(food, state, beside=""):
    """A grilled fish on a plate, and a food that is strewn on it; ``beside`` is another one that comes then."""
    told = f"""
fish (raw) + grill (off) → PUT → fish (raw; on grill) + grill (off)
grill (off) → TURN ON → grill (on)
fish (raw; on grill) + grill (on) → GRILL → fish (grilled; on grill) + grill (on)
fish (grilled; on grill) + plate (empty) → PUT → fish (grilled; on plate) + plate ({{fish}})
{food} ({state}) + plate ({{fish}}) → SPRINKLE → {food} ({state}; on plate) + plate ({{{food}, fish}})
"""
    if beside:
        told += (
            f"{beside} (liquid; in bottle) + plate ({{{food}, fish}}) → POUR "
            f"→ {beside} (liquid; on plate) + plate ({{{beside}, {food}, fish}})"
        )
    return told


@pytest.mark.parametrize(("food", "state"), [("garlic", "minced"), ("curry powder", "ground")])
def test_k1_what_nobody_eats_raw_by_itself_is_strewn_on_nothing_that_was_cooked(food, state):
    assert found("K1", strewn(food, state)) == [f"K1 step 5: {food} lies raw on what is done"]
    assert found("K1", strewn(food, state, beside="olive oil")) == []
    assert found("K1", strewn(food, state, beside="parsley")) == []


def test_k1_herbs_and_pepper_are_strewn_on_what_is_done():
    assert found("K1", strewn("parsley", "chopped")) == []
    assert found("K1", strewn("black pepper", "ground")) == []
