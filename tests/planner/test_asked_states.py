"""An asked state is attained: a step makes it, by hand or by heat, before the food joins what would not give it."""

from __future__ import annotations

import pytest
from planner.judged import fatal
from planner.public_foon import public_snapshot
from planner.told_steps import first, states_of

from foon_kg.food import tables
from foon_kg.food.workings import working

pytestmark = pytest.mark.shared_data


@pytest.mark.parametrize(
    ("dish", "food", "motion", "rest"),
    [
        ("rice", "basmati rice:soaked", "soak", ("chicken:cubed", "onion:sliced", "chicken stock:liquid")),
        ("noodle", "rice vermicelli:soaked", "soak", ("shrimp:raw", "carrot:julienned", "oil:liquid")),
        ("pudding", "wheat:soaked", "soak", ("milk:liquid", "sugar:granulated")),
        ("pudding", "cashew:soaked", "soak", ("milk:liquid", "sugar:granulated")),
        ("seafood", "shrimp:deveined", "devein", ("garlic:minced", "butter:unmelted")),
        ("chicken", "chicken leg:skinned", "skin", ("onion:chopped", "oil:liquid", "water:liquid")),
        ("soup", "lemongrass:bruised", "bruise", ("coconut milk:liquid", "chicken:sliced", "salt:granulated")),
        ("pasta", "spaghetti:broken", "break", ("tomato sauce:sauce", "onion:chopped", "oil:liquid")),
        ("cookie", "egg yolk:beaten", "beat", ("flour:powder", "sugar:granulated", "butter:softened")),
        ("sauce", "guajillo chile:seeded", "core", ("garlic:minced", "water:liquid", "salt:granulated")),
        ("soup", "red lentil:rinsed", "rinse", ("onion:chopped", "vegetable stock:liquid")),
        ("beef", "potato:fried", "cook and stir", ("beef:cubed", "onion:sliced", "oil:liquid", "water:liquid")),
        ("soup", "tomato:roasted", "bake", ("onion:chopped", "vegetable stock:liquid")),
        ("soup", "cumin seed:toasted", "cook and stir", ("carrot:diced", "vegetable stock:liquid")),
        ("casserole", "hash brown:thawed", "defrost", ("sour cream:creamy", "cheddar:grated", "onion:chopped")),
        ("muffin", "spinach:thawed", "defrost", ("flour:powder", "egg:raw", "milk:liquid", "baking powder:powder")),
    ],
)
def test_a_state_is_given_before_the_food_joins(steps, dish, food, motion, rest):
    label, _, state = food.partition(":")
    told = steps(dish, "", food, *rest)
    made = first(told, label, motion)
    assert state in states_of(told[: made + 1], label)
    before = [node.ingredients for _, _, outputs in told[:made] for node in outputs if label in node.ingredients]
    assert all(len(foods) <= 1 + len({"water", "oil"} & {*foods}) for foods in before)


def test_a_spice_is_toasted_without_fat_and_then_ground(steps):
    told = steps("stir-fry", "", "cumin seed:toasted, ground", "lamb:sliced", "garlic:sliced", "oil:liquid")
    toasted, ground = first(told, "cumin seed", "cook and stir"), first(told, "cumin seed", "grind")
    assert toasted < ground
    assert "oil" not in told[toasted][0]
    assert {"mortar", "pestle"} <= told[ground][0]


def test_what_is_bruised_is_lifted_out_whole(steps):
    told = steps("soup", "", "galangal:bruised", "coconut milk:liquid", "chicken:sliced", "salt:granulated")
    assert not states_of(told, "galangal") & {"sliced", "chopped"}
    (lifted,) = [outputs for _, motion, outputs in told if motion == "remove"]
    assert "galangal" in {node.label for node in lifted}
    assert "galangal" not in {food for node in told[-1][2] for food in node.ingredients}


def test_what_is_cooked_in_a_dry_pan_there_is_not_cooked_twice(steps):
    told = steps("stir-fry", "", "tofu:fried", "garlic:sliced", "oil:liquid", "carrot:sliced")
    assert [motion for inputs, motion, _ in told if "tofu" in inputs].count("cook and stir") == 1


def test_a_working_is_of_some_kinds_only():
    foods = tables().foods
    assert working("deveined", foods.food("shrimp", ["raw"])) is not None
    assert working("deveined", foods.food("lobster", ["raw"])) is None
    assert working("skinned", foods.food("smoked salmon")) is None
    assert working("sliced", foods.food("shrimp", ["raw"])) is None


def test_halves_that_get_soft_in_a_pot_stay_halves(steps):
    told = steps("soup", "", "potato:halved", "beef:cubed", "beef stock:liquid", "carrot:diced")
    assert "halved" in states_of(told, "potato")
    assert not states_of(told, "potato") & {"chopped", "diced", "sliced"}


def test_baby_potatoes_and_bay_leaves_are_not_cut_unasked(steps):
    rest = ("chicken:whole", "carrot:whole", "black peppercorn:whole", "oil:liquid", "salt:granulated")
    told = steps("roast", "Roast chicken", "baby potato:whole", "bay leaf:sprig", *rest)
    assert not states_of(told, "baby potato") & {"chopped", "diced", "sliced"}
    assert not states_of(told, "bay leaf") & {"chopped", "minced"}


def test_large_dried_chillies_lose_their_seeds(steps):
    told = steps("sauce", "", "ancho chile:dried", "garlic:minced", "water:liquid", "salt:granulated")
    assert "seeded" in states_of(told[: first(told, "ancho chile", "core") + 1], "ancho chile")


def test_nuts_that_were_roasted_are_ground_and_others_bought_ground(steps):
    rest = ("flour:powder", "sugar:granulated", "butter:softened", "egg:whole")
    told = steps("cake", "", "cashew:roasted, ground", *rest)
    assert first(told, "cashew", "toast") < first(told, "cashew", "grind")
    told = steps("cake", "", "flaxseed:ground", *rest)
    assert "grind" not in {motion for _, motion, _ in told}


def test_eggs_asked_boiled_are_never_cracked_into_a_mass(steps):
    told = steps("meatball", "", "egg:boiled, peeled", "ground beef:raw", "onion:chopped", "oil:liquid")
    assert "crack" not in {motion for inputs, motion, _ in told if "egg" in inputs}
    assert first(told, "egg", "boil") < first(told, "egg", "peel")


def test_the_root_of_turmeric_is_cut_and_its_powder_strewn(steps):
    rest = ("beef:cubed", "coconut milk:liquid", "onion:chopped")
    told = steps("beef", "", "turmeric:chopped", *rest)
    assert "knife" in told[first(told, "turmeric", "chop")][0]
    told = steps("beef", "", "turmeric:ground", *rest)
    assert not any("knife" in inputs for inputs, _, _ in told if "turmeric" in inputs)


def test_the_motion_of_a_video_that_stands_for_another_one_is_declared(public_plans):
    found = public_plans("seafood", "", "shrimp:deveined", "garlic:minced", "butter:unmelted")
    assert "devein" in {one.required for one in found.substitutions if one.kind == "motion"}
    assert fatal(found, public_snapshot()) == []


@pytest.mark.parametrize(
    ("food", "cleaned"),
    [
        ("mud crab:cut", True), ("squid:raw", True), ("sea bass:whole", True), ("sea bream:cleaned", True),
        ("cod fillet:raw", False), ("squid ring:raw", False), ("mussel:cleaned", False), ("salmon:raw", False),
    ],
)  # fmt: skip
def test_what_was_caught_is_gutted_unless_it_is_sold_without(steps, food, cleaned):
    told = steps("seafood", "", food, "garlic:chopped", "tomato sauce:sauce", "oil:liquid")
    assert ("gut" in {motion for _, motion, _ in told}) == cleaned


@pytest.mark.parametrize(
    ("food", "rinsed"), [("anchovy:salted", True), ("salted caper:whole", True), ("caper:whole", False)]
)
def test_what_was_packed_in_salt_is_rinsed(steps, food, rinsed):
    told = steps("pasta", "", "spaghetti:uncooked", food, "garlic:chopped", "olive oil:liquid")
    label = food.partition(":")[0]
    assert ("rinsed" in states_of(told, label)) == rinsed


def test_what_is_mashed_next_is_boiled_until_it_is_done(steps):
    told = steps(
        "casserole", "Rutabaga casserole", "swede:diced", "egg:whole", "cream:creamy", "breadcrumb:crumbs",
        "butter:softened", "salt:granulated",
    )  # fmt: skip
    made = first(told, "swede", "boil")
    assert "cooked" in states_of(told[made : made + 1], "swede")


def test_nuts_are_slivered_with_a_knife(steps):
    rest = ("flour:powder", "sugar:granulated", "butter:softened")
    told = steps("cookie", "", "pistachio:slivered", *rest)
    (tools,) = [
        inputs for inputs, motion, _ in told if "pistachio" in inputs and "cutting board" in inputs and motion != "pour"
    ]
    assert "knife" in tools


@pytest.mark.parametrize(
    ("food", "tool"),
    [("tomato:coarsely grated", "grater"), ("vanilla pod:split", "knife"), ("potato:boiled, riced", "masher")],
)
def test_a_tool_that_no_more_than_one_video_takes_is_left_for_the_usual_one(steps, food, tool):
    label = food.partition(":")[0]
    told = steps("pudding", "", food, "double cream:creamy", "sugar:granulated", "milk:liquid")
    assert any({label, tool} <= inputs for inputs, _, _ in told)
    assert not any({label, other} <= inputs for inputs, _, _ in told for other in ("mandoline", "scraper"))


def test_what_has_thawed_is_not_frozen_any_more(steps):
    told = steps("salad", "", "pea:thawed", "elbow macaroni:cooked", "tuna:flaked", "mayonnaise:creamy")
    thawed = first(told, "pea", "defrost")
    assert "frozen" not in states_of(told[thawed + 1 :], "pea")


@pytest.mark.parametrize(
    ("dish", "food", "rest"),
    [
        ("salad", "tea leaf:fermented", ("cabbage:shredded", "peanut:roasted", "lime:juice", "sesame oil:liquid")),
        ("salad", "split pea:fried", ("cabbage:shredded", "peanut:roasted", "lime:juice", "sesame oil:liquid")),
        ("sandwich", "coleslaw:shredded", ("bun:whole", "ham:sliced", "mustard:creamy")),
        ("sandwich", "sauerkraut:shredded", ("bread:sliced", "corned beef:sliced", "swiss cheese:sliced")),
        ("casserole", "hash brown:shredded", ("sausage:crumbled", "egg:beaten", "milk:liquid", "cheddar:shredded")),
    ],
)
def test_what_only_shops_make_comes_as_it_is_asked(steps, dish, food, rest):
    label, _, state = food.partition(":")
    told = steps(dish, "", food, *rest)
    place, (_, motion, outputs) = next((i, one) for i, one in enumerate(told) if label in one[0])
    assert motion in {"pour", "pick-and-place", "scoop", "scoop and pour"}
    assert state in states_of(told[: place + 1], label) or any(label in node.ingredients for node in outputs)


def test_roots_that_are_asked_done_and_cut_are_boiled_and_not_fried_whole(steps):
    told = steps("salad", "", "beetroot:cooked, cut", "walnut:toasted", "olive oil:liquid", "vinegar:liquid")
    cooked = next(i for i, (_, _, out) in enumerate(told) if "cooked" in states_of(told[: i + 1], "beetroot"))
    assert "water" in told[cooked][0]


def test_eggs_that_are_bought_boiled_are_only_peeled(steps):
    told = steps("salad", "", "hard-boiled egg:peeled", "mayonnaise:creamy", "celery:diced", "mustard:creamy")
    assert not {"boil", "cook"} & {motion for inputs, motion, _ in told if "hard-boiled egg" in inputs}
    assert first(told, "hard-boiled egg", "peel") < len(told) - 1


def test_spirits_come_to_water_that_was_boiled_with_its_spices(steps):
    told = steps("drinks", "", "water:liquid", "cinnamon stick:whole", "sugar:granulated", "rum:liquid")
    boiled = first(told, "cinnamon stick", "cook")
    assert all("rum" not in inputs for inputs, _, _ in told[: boiled + 1])
    assert any("rum" in inputs for inputs, _, _ in told[boiled + 1 :])


def test_bread_eggs_and_milk_of_a_pudding_are_baked_together(steps):
    told = steps("pudding", "", "bread:cubed", "egg:beaten", "milk:liquid", "sugar:granulated", "butter:melted")
    baked = next(place for place, (_, motion, _) in enumerate(told) if motion == "bake")
    came = {food for inputs, _, _ in told[:baked] for food in inputs}
    assert {"bread", "egg", "milk", "sugar", "butter"} <= came


def test_roasties_are_boiled_before_they_are_baked_in_their_fat(steps):
    told = steps("potatoes", "Roasties", "potato:halved", "goose fat:creamy", "salt:granulated")
    water, fat = (
        next(place for place, (inputs, _, _) in enumerate(told) if food in inputs) for food in ("water", "goose fat")
    )
    baked = next(place for place, (_, motion, _) in enumerate(told) if motion == "bake")
    assert water < fat < baked


@pytest.mark.parametrize(
    ("dish", "food", "made", "rest"),
    [
        ("noodle", "carrot:julienne", "julienned", ("noodle:whole", "cabbage:shredded", "oil:liquid")),
        ("stir-fry", "carrot:thin matchsticks", "julienned", ("broccoli:florets", "oil:liquid", "soy sauce:sauce")),
        ("stir-fry", "chicken:slices", "sliced", ("broccoli:florets", "oil:liquid", "soy sauce:sauce")),
        ("salad", "onion:rings", "ring shaped", ("lettuce:leaves", "tomato:sliced", "olive oil:liquid")),
        ("salad", "orange:segments", "segmented", ("lettuce:leaves", "walnut:chopped", "olive oil:liquid")),
        ("muffin", "crystallized ginger:finely chopped", "finely chopped", ("flour:powder", "egg:raw", "milk:liquid")),
    ],
)
def test_other_words_for_a_cut_are_cut_so_out_of_the_whole(steps, dish, food, made, rest):
    label, _, asked = food.partition(":")
    told = steps(dish, "", food, *rest)
    states = states_of(told, label)
    assert made in states
    assert asked == made or asked not in states
    cuts = {"chopped", "diced", "julienned", "ring shaped", "segmented", "sliced", "finely chopped"}
    assert states & cuts == {made}


def test_what_is_asked_whole_and_served_so_is_neither_cut_nor_stoned(steps):
    told = steps("salad", "", "olive:whole", "tomato:sliced", "feta:crumbled", "olive oil:liquid")
    assert not states_of(told, "olive") & {"cored", "pitted", "sliced", "chopped"}
    told = steps("soup", "", "habanero:whole", "onion:chopped", "tomato:chopped", "chicken stock:liquid")
    assert not states_of(told, "habanero") & {"cored", "sliced", "chopped"}
    told = steps("sausage", "", "sausage:whole", "lentil:dried", "onion:chopped", "oil:liquid")
    assert "chopped" not in states_of(told, "sausage")


def test_a_whole_olive_is_stoned_for_a_dough(steps):
    told = steps("bread", "", "olive:whole", "flour:powder", "yeast:powder", "water:liquid", "salt:granulated")
    assert states_of(told, "olive") & {"cored", "pitted"}


def test_zest_is_grated_off_a_fruit_that_nobody_peeled(steps):
    told = steps("sauce", "", "bergamot:zest", "tomato:chopped", "onion:chopped", "oil:liquid")
    assert "zest" in states_of(told, "bergamot")
    assert not states_of(told, "bergamot") & {"peeled", "cored"}


@pytest.mark.parametrize(
    ("dish", "food", "wanted", "rest"),
    [
        ("potatoes", "cornflake:pieces", {"crumble"}, ("potato:diced", "cheddar:grated", "sour cream:creamy")),
        (
            "muffin",
            "apple:shredded",
            {"core", "grate"},
            ("flour:powder", "egg:raw", "milk:liquid", "baking powder:powder"),
        ),
        ("soup", "garlic:pressed", {"peel", "mince"}, ("onion:chopped", "vegetable stock:liquid", "oil:liquid")),
        ("stir-fry", "matchstick carrot:whole", set(), ("ground beef:raw", "cabbage:sliced", "oil:liquid")),
        ("vegetables", "taro leaf:dried", set(), ("coconut milk:liquid", "onion:sliced", "garlic:crushed")),
        ("omelette", "crab:pieces", {"chop"}, ("egg:whisked", "butter:unmelted", "salt:granulated")),
    ],
)
def test_hands_do_no_more_to_a_food_than_it_needs_as_it_is_sold(steps, dish, food, wanted, rest):
    label = food.partition(":")[0]
    told = steps(dish, "", food, *rest)
    hands = {"peel", "core", "gut", "cut off ends", "cut", "dice", "slice", "mince", "chop", "grate", "crumble"}
    assert {motion for _, motion, out in told for node in out if node.label == label and motion in hands} == wanted


def test_a_dried_herb_is_not_chopped_where_the_fresh_one_is(steps):
    sauce = ("oregano:dried", "garlic:minced", "tomato:finely diced", "red wine vinegar:liquid", "sunflower oil:liquid")
    named = (f"{food}:chimichurri" for food in sauce)
    told = steps("steak", "Bife a Caballo with Red Chimichurri", "sirloin steak:raw", "egg:uncooked", *named)
    assert "chop" not in {motion for _, motion, out in told for node in out if node.label == "oregano"}
