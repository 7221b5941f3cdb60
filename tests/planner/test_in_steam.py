"""What is steamed stands above water that boils, in a basket or a mould under a lid, and is lifted out of that."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

DOUGH = ("flour:powder", "yeast:powder", "sugar:granulated", "water:warm")

STEAMED = [
    ("bread", "Char siu bao", "steamer basket", (*DOUGH, "roast pork:diced:filling", "oyster sauce:liquid:filling")),
    ("bread", "Mantou", "steamer basket", DOUGH),
    (
        "bread", "Chicken momos", "steamer basket",
        ("flour:powder", "water:liquid", "ground chicken:raw", "onion:chopped", "ginger:grated"),
    ),
    (
        "bread", "Red pork tamales", "steamer basket",
        ("masa harina:powder", "lard:creamy", "chicken broth:liquid", "corn husks:soaked", "pork:cubed:filling"),
    ),
    ("rice", "Idli", "ramekin", ("rice:uncooked", "urad dal:dried", "water:liquid", "salt:granulated")),
    ("cake", "Puto", "cake pan", ("rice flour:powder", "sugar:granulated", "coconut milk:liquid", "egg:uncooked")),
    (
        "pudding", "Christmas pudding", "pudding basin",
        ("flour:powder", "suet:creamy", "raisins:whole", "egg:uncooked", "breadcrumbs:crumbs", "brandy:liquid"),
    ),
    ("omelette", "Chawanmushi", "ramekin", ("eggs:uncooked", "dashi:liquid", "soy sauce:liquid", "shrimp:peeled")),
    ("pudding", "Steamed egg custard", "ramekin", ("eggs:uncooked", "milk:liquid", "sugar:granulated")),
    ("seafood", "Steamed fish with ginger", "steamer basket", ("sea bass:raw", "ginger:julienned", "soy sauce:liquid")),
    (
        "pork", "Steamed spare ribs with black bean sauce", "bowl",
        ("pork ribs:cut", "black beans:fermented", "soy sauce:liquid", "cornstarch:powder", "garlic:minced"),
    ),
    ("vegetables", "Steamed broccoli", "steamer basket", ("broccoli:floret", "butter:unmelted", "salt:granulated")),
    (
        "seafood", "Otak otak", "steamer basket",
        ("mackerel:raw", "banana leaves:sprig", "coconut milk:liquid", "egg:uncooked", "shallots:whole"),
    ),
]  # fmt: skip


@pytest.mark.parametrize(("dish_type", "title", "holder", "foods"), STEAMED, ids=[title for _, title, _, _ in STEAMED])
def test_what_is_steamed_stands_over_boiling_water_under_a_lid(public_plans, dish_type, title, holder, foods):
    units = public_plans(dish_type, title, *foods).units
    place = next(n for n, unit in enumerate(units) if unit.motion == "steam")
    there = {node.label: node for node in units[place].input_nodes}
    assert (there[holder].relation, there[holder].container) == ("in", "pot")
    assert there["pot"].ingredients == ("water",)
    assert "boiling" in there["water"].states
    assert "covered [pot lid]" in there["pot"].states
    assert there["stove"].states == ("on",)
    done = [unit.motion for unit in units]
    assert done.index("boil") < place
    after = done[place + 1 :]
    assert after[:3] == ["turn off", "uncover", "remove"]
    assert {"bake", "fry"}.isdisjoint(done)


def test_a_plan_tells_that_no_video_steams(public_plans):
    dish_type, title, _, foods = STEAMED[0]
    found = [one for one in public_plans(dish_type, title, *foods).substitutions if one.required == "steam"]
    assert [(one.kind, one.equivalent) for one in found] == [("motion", "boil")]


@pytest.mark.parametrize(
    ("dish_type", "title", "foods"),
    [
        ("bread", "Baked siopao", (*DOUGH, "pork:cooked:filling")),
        ("bread", "Pelmeni", ("flour:powder", "egg:uncooked", "water:liquid", "ground pork:raw")),
        ("bread", "Zongzi", ("glutinous rice:uncooked", "pork belly:cubed", "bamboo leaves:dried")),
        ("seafood", "Fried fish with ginger", ("sea bass:raw", "ginger:julienned", "oil:liquid", "flour:powder")),
        ("rice", "Steamed rice", ("rice:uncooked", "water:liquid", "salt:granulated")),
        ("vegetables", "Roasted broccoli", ("broccoli:floret", "olive oil:liquid")),
        ("pudding", "Bread and butter pudding", ("bread:sliced", "butter:unmelted", "eggs:uncooked", "milk:liquid")),
    ],
)
def test_what_is_boiled_baked_or_fried_is_not_steamed(steps, dish_type, title, foods):
    assert "steam" not in motions(steps(dish_type, title, *foods))


def test_rice_that_is_steamed_soaks_before(steps):
    told = steps(
        "rice", "Mango sticky rice", "glutinous rice:uncooked", "coconut milk:liquid", "sugar:granulated",
        "mango:sliced", "salt:granulated",
    )  # fmt: skip
    assert first(told, "glutinous rice", "soak") < first(told, "glutinous rice", "steam")


def test_what_is_poured_hot_on_a_steamed_cake_is_made_when_that_is_done(steps):
    told = steps(
        "cake", "Khaman dhokla", "besan:powder", "semolina:powder", "water:liquid", "oil:liquid:tempering",
        "mustard seeds:whole:tempering", "curry leaves:sprig:tempering",
    )  # fmt: skip
    assert motions(told).index("steam") < first(told, "mustard seeds", "cook")


def test_a_mould_is_greased_before_the_batter_comes(steps):
    told = steps("cake", "Ma lai go", "eggs:uncooked", "brown sugar:granulated", "flour:powder", "vegetable oil:liquid")
    into = [place for place, (inputs, _, _) in enumerate(told) if "cake pan" in inputs]
    assert "vegetable oil" in told[into[0]][0]
    assert motions(told)[into[1]] in {"pour", "scrape"}


def test_what_is_asked_steamed_is_steamed_by_itself(steps):
    told = steps(
        "salad", "Broccoli salad", "broccoli:steamed", "mayonnaise:creamy", "raisins:whole", "red onion:diced",
        "vinegar:liquid",
    )  # fmt: skip
    assert first(told, "broccoli", "steam") < first(told, "broccoli", "mix")
    assert "raisins" not in told[first(told, "broccoli", "steam")][0]


def test_rice_that_is_asked_steamed_is_boiled(steps):
    told = steps("chicken", "Teriyaki chicken", "chicken:sliced", "soy sauce:liquid", "honey:liquid", "rice:steamed")
    assert "steam" not in motions(told)


def test_what_seasons_a_steamed_roll_is_rolled_up_in_it(steps):
    told = steps("bread", "Hua juan", *DOUGH, "scallions:chopped", "oil:liquid", "salt:granulated")
    (place,) = [n for n, (inputs, motion, _) in enumerate(told) if motion == "roll" and "scallions" in inputs]
    assert place < motions(told).index("steam")


def test_a_dough_of_starch_is_no_part_of_its_filling(steps):
    told = steps(
        "bread", "Har gow", "wheat starch:powder", "tapioca starch:powder", "water:boiling", "shrimp:chopped",
        "sesame oil:liquid", "salt:granulated",
    )  # fmt: skip
    assert "wheat starch" in told[motions(told).index("knead")][0]
    assert "wheat starch" not in told[motions(told).index("stir")][0]


def test_a_batter_with_yeast_rests_and_is_not_kneaded(steps):
    told = motions(
        steps("cake", "Fa gao", "rice flour:powder", "brown sugar:granulated", "water:liquid", "yeast:powder")
    )
    assert told.index("mix") < told.index("ferment") < told.index("steam")
    assert "knead" not in told


def test_a_cake_of_batter_that_is_fried_is_steamed_before(steps):
    told = motions(
        steps(
            "cake", "Turnip cake", "daikon radish:grated", "rice flour:powder", "water:liquid", "salt:granulated",
            "chinese sausages:diced", "oil:liquid:frying",
        )
    )  # fmt: skip
    assert told.index("steam") < told.index("slice", told.index("steam")) < told.index("flip")


@pytest.mark.parametrize(("dish_type", "title", "foods"), [
    ("pork", "Pearl balls", ("ground pork:raw", "glutinous rice:soaked", "egg:uncooked", "soy sauce:liquid")),
    ("seafood", "Steamed crab legs", ("crab legs:raw", "butter:melted", "lemon:cut")),
    ("bread", "Sweet corn tamales", ("masa harina:powder", "butter:unmelted", "salt:granulated", "corn husks:soaked")),
])  # fmt: skip
def test_more_that_is_steamed(steps, dish_type, title, foods):
    assert "steam" in motions(steps(dish_type, title, *foods))


@pytest.mark.parametrize(
    ("dish_type", "title", "tin", "foods"),
    [
        (
            "cake", "Steamed carrot cake", "pan",
            ("carrots:grated", "flour:powder", "sugar:granulated", "eggs:uncooked", "oil:liquid", "cinnamon:ground"),
        ),
        (
            "pudding", "Jam roly poly, steamed", "steamer basket",
            ("self-raising flour:powder", "suet:creamy", "milk:liquid", "raspberry jam:jelly"),
        ),
    ],
)  # fmt: skip
def test_what_the_title_calls_steamed_comes_in_no_oven(steps, dish_type, title, tin, foods):
    told = steps(dish_type, title, *foods)
    assert "bake" not in motions(told)
    assert any(label.endswith(tin) for label in told[motions(told).index("steam")][0])


def test_steamed_vegetables_lie_under_a_thick_sauce(steps):
    told = steps(
        "vegetables", "Steamed cauliflower with cheese sauce", "cauliflower:floret", "butter:unmelted", "flour:powder",
        "milk:liquid", "cheddar cheese:grated",
    )  # fmt: skip
    assert told[motions(told).index("steam")][0].isdisjoint({"milk", "flour", "cheddar cheese"})
    assert first(told, "milk", "stir") <= first(told, "cheddar cheese", "stir")


def test_a_bun_that_is_filled_later_is_steamed_empty(steps):
    told = steps(
        "bread", "Gua bao", *DOUGH, "pork belly:raw", "soy sauce:liquid", "star anise:whole", "peanuts:crushed",
        "cilantro:chopped",
    )  # fmt: skip
    there = told[motions(told).index("steam")]
    assert {"pork belly", "soy sauce"}.isdisjoint({*there[0], *inside(told, "steam")})
    assert any("pork belly" in inputs for inputs, _, _ in told)


@pytest.mark.parametrize(
    ("dish_type", "title", "foods"),
    [
        ("beef", "Steamed beef balls, dim sum", ("ground beef:raw", "cornstarch:powder", "soy sauce:liquid")),
        ("bread", "Modak", ("rice flour:powder", "water:liquid", "coconut:grated", "jaggery:granulated")),
        ("bread", "Idiyappam", ("rice flour:powder", "water:boiling", "salt:granulated")),
        ("chicken", "Chicken and rice in lotus leaf", ("chicken:sliced", "rice:uncooked", "lotus leaves:soaked")),
        ("seafood", "Lemon steamed cod with vegetables", ("cod fillets:raw", "carrot:julienned", "lemon:sliced")),
    ],
)
def test_all_that_is_raw_is_in_the_steam(public_plans, dish_type, title, foods):
    units = public_plans(dish_type, title, *foods).units
    (steamed,) = [unit for unit in units if unit.motion == "steam"]
    there = {name for node in steamed.input_nodes for name in (node.label, *node.ingredients)}
    assert {food.partition(":")[0] for food in foods} - {"lotus leaves", "salt", "water"} <= there


def test_dumplings_that_are_fried_are_steamed_before(steps):
    told = motions(steps("bread", "Gyoza", "gyoza wrappers:raw", "ground pork:raw", "vegetable oil:liquid"))
    assert told.index("steam") < len(told) - told[::-1].index("cook") - 1


def test_what_is_asked_steamed_is_steamed_before_it_is_mixed_into_a_batter(steps):
    told = steps(
        "bread", "", "flour:powder", "pumpkin:steamed", "sugar:granulated", "egg:uncooked", "butter:melted",
        "baking powder:powder",
    )  # fmt: skip
    assert first(told, "pumpkin", "steam") < first(told, "pumpkin", "mix")
