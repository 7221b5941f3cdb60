"""What hands can do to foods as they are, and when side dishes are made: found by people who read trees as robots."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

from foon_kg.food.lists import word_list

pytestmark = pytest.mark.shared_data


def test_the_oil_stays_in_the_pan_in_which_breaded_flesh_was_fried(steps):
    told = steps(
        "chicken", "Chicken Parmesan", "chicken breast:raw", "flour:powder", "egg:beaten", "breadcrumb:crumbs",
        "olive oil:liquid", "marinara sauce:thick liquid", "mozzarella:shredded",
    )  # fmt: skip
    (out,) = [
        outputs for inputs, motion, outputs in told if {"cooking pan", "baking dish"} <= inputs and motion != "turn on"
    ]
    (pan,) = [node for node in out if node.label == "cooking pan"]
    assert pan.ingredients == ("olive oil",)
    assert "olive oil" not in {node.label for node in out}
    assert any("olive oil" in node.ingredients for node in told[-1][2])  # what clings to it is eaten


def test_a_pudding_is_poured(steps):
    told = steps("pudding", "Chocolate Pudding", "milk:liquid", "sugar:granulated", "cornstarch:powder", "cocoa:powder")
    (moved,) = [motion for inputs, motion, _ in told if {"pot", "bowl", "mixture"} <= inputs]
    assert moved not in word_list("picks up")


@pytest.mark.parametrize(
    ("dish", "title", "rest"),
    [
        ("cake", "Apple Cake", ("flour:powder", "sugar:granulated", "margarine:softened", "apple:peeled")),
        ("salad", "Caesar Salad", ("lettuce:whole leafy", "oil:liquid", "mustard:thick sauce", "bread:sliced")),
        ("noodle", "Egg Noodles", ("noodle:dried", "oil:liquid", "onion:sliced", "soy sauce:sauce")),
    ],
)
def test_egg_that_is_sold_without_its_shell_is_poured(steps, dish, title, rest):
    told = steps(dish, title, "egg:thick liquid", *rest)
    (taken,) = [motion for inputs, motion, _ in told if {"egg", "carton"} <= inputs]
    assert "pour" in taken


@pytest.mark.parametrize(
    ("dish", "food", "storage", "motion"),
    [
        ("soup", "artichoke:chopped", "can", "chop"), ("salad", "bean:bean", "can", "pour"),
        ("salad", "lettuce:whole leafy", "", "chop"), ("cake", "date:chopped", "", "chop"),
    ],
)  # fmt: skip
def test_hearts_and_beans_are_drained_heads_and_dates_cut(steps, dish, food, storage, motion):
    rest = {
        "soup": ("broth:liquid", "cream:creamy", "onion:chopped"),
        "salad": ("oil:liquid", "tomato:whole", "vinegar:liquid"),
        "cake": ("flour:powder", "sugar:granulated", "egg:whole", "butter:softened"),
    }[dish]
    label = food.partition(":")[0]
    told = steps(dish, dish.title(), food, *rest)
    (begin, act, _), *_ = [step for step in told if label in step[0]]
    assert act == ("pour" if storage else motion)
    assert ({storage, "strainer"} if storage else {"cutting board", "knife"}) <= begin


@pytest.mark.parametrize(("food", "state"), [("date", "pitted"), ("prune", "pitted")])
def test_what_is_sold_without_its_stone_is_bought_so(public_plans, food, state):
    dish = ("salad", "Salad", f"{food}:{state}", "lettuce:leaf", "tomato:whole", "oil:liquid")
    (taken, *_) = [node for unit in public_plans(*dish).units for node in unit.input_nodes if node.label == food]
    assert state in taken.states


def test_what_is_toasted_is_toasted_dry(steps):
    told = steps(
        "sauce", "Romesco Sauce", "almond:toasted", "tomato:roasted", "garlic:minced", "olive oil:liquid",
        "vinegar:liquid",
    )  # fmt: skip
    (toasted,) = [inputs for inputs, motion, _ in told if motion == "toast" and "almond" in inputs]
    assert "olive oil" not in toasted


@pytest.mark.parametrize(
    ("spice", "state"), [("allspice berry", "ground"), ("mahleb", "ground"), ("coconut", "flakes")]
)
def test_what_only_a_mill_grinds_is_bought_so_and_flakes_stay_flakes(steps, spice, state):
    told = steps(
        "cookie", "Cookies", "flour:powder", "butter:softened", "sugar:granulated", "egg:whole", f"{spice}:{state}"
    )
    assert not any("knife" in inputs or "grater" in inputs for inputs, _, _ in told if spice in inputs)


def test_bread_is_toasted_when_what_lies_on_it_is_ready_and_the_spread_comes_onto_it(steps):
    told = steps("sandwich", "BLT", "bacon:raw", "bread:toasted", "mayonnaise:creamy", "tomato:sliced", "lettuce:leaf")
    assert first(told, "bacon", "cook") < first(told, "bread", "toast")
    assert "bread" in told[first(told, "mayonnaise", "spread")][0]


def test_earth_tough_ends_and_cores_do_not_come_into_the_dish(steps):
    soup = steps(
        "soup", "Leek Soup", "leek:sliced", "potato:diced", "thyme:sprig", "chicken stock:liquid", "butter:stick"
    )
    washed = [motion for inputs, motion, _ in soup if "leek" in inputs and motion in {"wash", "rinse"}]
    assert washed
    assert [inputs for inputs, motion, _ in soup if motion == "remove" and "plate" in inputs]
    assert not any("thyme" in node.ingredients for node in soup[-1][2])
    slaw = steps("salad", "Coleslaw", "cabbage:shredded", "carrot:grated", "mayonnaise:creamy", "vinegar:liquid")
    cut = next(n for n, (inputs, _, _) in enumerate(slaw) if {"cabbage", "cutting board"} <= inputs)
    assert first(slaw, "cabbage", "core") < cut
    beans = steps("casserole", "Green Bean Casserole", "green bean:blanched", "mushroom soup:canned", "milk:liquid")
    assert word_list("cuts off the ends") & set(motions(beans))


@pytest.mark.parametrize(
    ("dish", "asked", "food", "motion"),
    [
        (("cookie", "Date Cookies"), ("date:mashed", "flour:powder", "butter:melted"), "date", "mash"),
        (("pie", "Tourtiere"), ("pork:ground", "potato:mashed", "pie crust:raw", "onion:chopped"), "potato", "mash"),
        (("chicken", "Doro Wat"), ("chicken leg:raw", "egg:peeled", "onion:chopped", "butter:stick"), "egg", "boil"),
        (("cookie", "Nut Cookies"), ("ghee:melted", "flour:powder", "sugar:granulated"), "ghee", "heat"),
        (("rice", "Fried Rice"), ("rice:chilled", "egg:beaten", "oil:liquid", "carrot:diced"), "rice", "cool down"),
        (("salad", "Chicken Salad"), ("chicken breast:chilled", "olive oil:liquid"), "chicken breast", "cool down"),
        (("salad", "Potato Salad"), ("potato:chilled", "oil:liquid", "onion:chopped"), "potato", "cool down"),
    ],
)
def test_the_asked_state_is_made(steps, dish, asked, food, motion):
    assert [inputs for inputs, done, _ in steps(*dish, *asked) if food in inputs and done == motion]


def test_what_is_poured_on_fat_and_flour_is_stirred(steps):
    told = steps("sauce", "White Sauce", "butter:stick", "flour:powder", "milk:liquid", "nutmeg:ground")
    (after, *_) = [motion for inputs, motion, _ in told if "milk" in inputs and "stove" in inputs]
    assert "stir" in after


def test_milk_beside_a_sauce_soaks_the_crumbs_of_meatballs(steps):
    told = steps(
        "meatball", "Meatballs", "ground beef:raw", "breadcrumb:crumbs", "milk:liquid", "egg:beaten",
        "marinara sauce:thick liquid",
    )  # fmt: skip
    shaped = next(outputs for inputs, motion, outputs in told if motion == "shape")
    assert any("milk" in node.ingredients for node in shaped)


@pytest.mark.parametrize(
    ("dish", "asked", "motion", "inside"),
    [
        (("cookie", "Maamoul"), ("semolina:powder", "butter:melted", "date:mashed"), "fold and pinch", "date"),
        (("pork", "Porchetta"), ("pork belly:raw", "garlic:minced", "rosemary:chopped"), "roll", "rosemary"),
        (("bread", "Injera"), ("teff flour:powder", "water:liquid", "yeast:powder"), "ferment", "teff flour"),
        (("pudding", "Vanilla Pudding"), ("milk:liquid", "cornstarch:powder", "sugar:granulated"), "chill", "milk"),
    ],
)
def test_what_the_name_of_a_dish_promises_is_done(steps, dish, asked, motion, inside):
    made = [outputs for _, done, outputs in steps(*dish, *asked) if done == motion]
    assert any(inside in node.ingredients for outputs in made for node in outputs)


@pytest.mark.parametrize(
    ("food", "state", "package"),
    [
        ("zedoary", "ground", "packet"), ("sunflower", "whole nuts", "packet"),
        ("ginger", "thick sauce", "container"),
    ],
)  # fmt: skip
def test_what_nobody_makes_so_comes_in_something(public_plans, food, state, package):
    result = public_plans("sauce", "Mole", f"{food}:{state}", "tomato:chopped", "chicken stock:liquid")
    first_seen = next(node for unit in result.units for node in unit.input_nodes if node.label == food)
    assert first_seen.container == package


@pytest.mark.parametrize(("food", "state"), [("soybean", "thick sauce"), ("crab", "meat"), ("tomato", "paste")])
def test_paste_and_shelled_meat_are_not_peeled(steps, food, state):
    told = steps("soup", "Soup", f"{food}:{state}", "onion:chopped", "broth:liquid")
    assert not [motion for inputs, motion, _ in told if food in inputs and motion in {"peel", "shell", "crack"}]


def test_what_is_loose_in_cream_is_stirred_and_never_turned_over(steps):
    dish = ("potato:peeled", "butter:unmelted", "onion:chopped", "oil:liquid", "salt:granulated")
    assert "flip" in motions(steps("potatoes", "Hash Browns", *dish))
    assert "flip" not in motions(steps("potatoes", "Creamed Potatoes", *dish, "heavy cream:creamy", "tomato:chopped"))


@pytest.mark.parametrize(
    ("food", "state", "cooked"),
    [
        ("salmon", "smoked", False), ("smoked trout", "", False), ("haddock", "smoked", True),
        ("smoked cod fillet", "raw", True),
    ],
)  # fmt: skip
def test_smoked_fish_comes_in_a_packet_and_cold_smoked_fish_is_cooked(public_plans, food, state, cooked):
    result = public_plans("sandwich", "Sandwich", f"{food}:{state}", "bread:sliced", "butter:softened", "dill:chopped")
    taken = [node for unit in result.units for node in (*unit.input_nodes, *unit.output_nodes) if node.label == food]
    assert taken[0].container == "packet"
    assert any("cooked" in node.states for node in taken) is cooked


@pytest.mark.parametrize(("state", "drained"), [("sauce", False), ("thick sauce", False), ("bean", True)])
def test_a_sauce_of_beans_is_not_drained(steps, state, drained):
    told = steps("noodle", "Noodles", f"bean:{state}", "noodle:dried", "pork:ground", "oil:liquid", "garlic:minced")
    assert any({"bean", "strainer"} <= inputs | {node.label for node in out} for inputs, _, out in told) is drained


def test_bread_is_torn_before_it_soaks_and_not_cut_when_it_is_wet(steps):
    told = steps(
        "meatball", "Meatballs", "ground beef:raw", "bread:soaked", "egg:whole", "onion:grated", "salt:granulated"
    )
    done = [motion for inputs, motion, _ in told if "bread" in inputs]
    assert done.index("break apart") < done.index("soak")
    assert not {"slice", "cut", "chop"} & set(done)


@pytest.mark.parametrize(("state", "boiled"), [("boiled", True), ("hard boiled", True), ("whole", False)])
def test_an_egg_of_a_sauce_is_boiled_where_it_is_asked_so(steps, state, boiled):
    told = steps("sauce", "Sauce", "oil:liquid", f"egg:{state}", "mustard:paste", "vinegar:liquid", "salt:granulated")
    assert any("egg" in inputs and motion == "boil" for inputs, motion, _ in told) is boiled


def _out_of(told, food, storage):
    """Return the motions by which a food comes out of what it is sold in."""
    return [motion for inputs, motion, _ in told if {food, storage} <= inputs]


@pytest.mark.parametrize("part", ["yolk", "white", "yolks", "whites"])
def test_a_part_of_an_egg_in_its_carton_is_poured_and_never_cracked(steps, part):
    told = steps("cookie", "Cookies", "flour:powder", "sugar:granulated", "butter:creamy", f"egg:{part}")
    assert _out_of(told, "egg", "carton") == ["pour"]
    assert "crack" not in motions(told)


@pytest.mark.parametrize(
    ("food", "state", "storage"),
    [("tomato", "canned, chopped", "can"), ("dill pickle", "sliced", "jar"), ("black olive", "sliced", "jar")],
)
def test_what_is_cut_comes_out_of_its_can_first(steps, food, state, storage):
    told = steps("salad", "Salad", f"{food}:{state}", "lettuce:whole", "oil:liquid", "vinegar:liquid")
    taken = next(inputs for inputs, _, _ in told if food in inputs)
    assert storage in taken
    assert "knife" not in taken


def test_a_braise_is_poured_and_what_was_baked_in_a_tin_is_not(steps):
    braise = steps(
        "casserole", "Rabbit Casserole", "rabbit:raw", "flour:powder", "oil:liquid", "shallot:peeled", "ale:liquid",
        "chicken stock:liquid", "prune:pitted",
    )  # fmt: skip
    assert "pour" in braise[-1][1]
    bread = steps(
        "bread", "Beer Bread", "self-rising flour:powder", "lager beer:liquid", "sugar:granulated", "butter:melted",
        "onion:chopped",
    )  # fmt: skip
    assert [motion for inputs, motion, _ in bread if {"bread", "loaf pan"} <= inputs][-1] in word_list("picks up")


def test_sauce_of_flour_and_milk_is_poured_off_the_stove(steps):
    told = steps(
        "pasta", "Stovetop Mac and Cheese", "elbow macaroni:uncooked", "butter:stick", "flour:powder", "milk:liquid",
        "cheddar:grated", "salt:granulated",
    )  # fmt: skip
    assert "pour" in told[-1][1]


@pytest.mark.parametrize("state", ["softened", "creamy"])
def test_soft_cheese_is_not_chopped_to_be_blended(steps, state):
    told = steps(
        "cake", "Cake with Cream Cheese Frosting", "flour:powder", "egg:whole", "sugar:granulated",
        "baking soda:powder", "butter:softened", f"cream cheese:{state}", "powdered sugar:powder",
    )  # fmt: skip
    assert not [inputs for inputs, _, _ in told if {"cream cheese", "knife"} <= inputs]


def test_onion_powder_is_fried_in_no_pan_as_an_onion(steps):
    def pans(state):
        foods = ("ham:cubed", "sour cream:creamy", "pea:thawed", "cheese:grated", "hash brown:thawed")
        told = steps("casserole", "Casserole", f"onion:{state}", *foods)
        return [inputs for inputs, _, _ in told if "cooking pan" in inputs]

    assert pans("chopped")
    assert not pans("powder")


@pytest.mark.parametrize(("leaf", "storage"), [("bay leaf", "jar"), ("thyme", "shaker")])
def test_no_shaker_strews_whole_leaves(public_plans, leaf, storage):
    result = public_plans("pork", "Adobo", "pork:cut", "vinegar:liquid", "soy sauce:liquid", f"{leaf}:dried")
    seen = next(node for unit in result.units for node in unit.input_nodes if node.label == leaf)
    assert seen.container == storage


def test_no_brush_takes_up_a_dry_rub(steps):
    rub = ("brown sugar:granulated", "paprika:smoked", "salt:granulated", "black pepper:ground")
    dish = ("roast", "Rubbed Venison Roast", "venison roast:raw", "beef broth:liquid", "onion:cut")
    told = steps(*dish, *rub)
    assert "brush" not in motions(told)
    assert inside(told, "mix") == {one.split(":")[0] for one in rub}
    on_it = next(place for place, (inputs, _, _) in enumerate(told) if {"mixture", "baking dish"} <= inputs)
    assert on_it < motions(told).index("bake")


def test_whipped_cream_comes_out_of_a_tub(public_plans):
    result = public_plans("pudding", "Persimmon Pudding", "persimmon pulp:whole", "sugar:granulated", "egg:beaten",
                          "flour:powder", "milk:liquid", "whipped cream:creamy")  # fmt: skip
    seen = next(node for unit in result.units for node in unit.input_nodes if node.label == "whipped cream")
    assert seen.container == "container"
