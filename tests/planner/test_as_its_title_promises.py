"""A word of a title that names a method or a form is followed: in the oven, in bacon, closed, frozen, creamed."""

from __future__ import annotations

import pytest
from planner.told_steps import first, last, motions, states_of

pytestmark = pytest.mark.shared_data

OMELET = ("eggs:uncooked", "milk:liquid", "ham:diced", "cheddar cheese:grated", "butter:unmelted", "salt:granulated")


@pytest.mark.parametrize("title", ["Oven Omelet with Ham", "Baked Omelette", "Sheet Pan Omelet"])
def test_an_omelet_of_the_oven_is_baked_and_not_stirred_on_the_stove(steps, title):
    told = steps("omelette", title, *OMELET)
    assert "bake" in motions(told)
    assert not any("egg mixture" in inputs and motion == "cook and stir" for inputs, motion, _ in told)


def test_an_omelet_whose_title_says_nothing_of_an_oven_stays_on_the_stove(steps):
    assert "bake" not in motions(steps("omelette", "Ham Omelet", *OMELET))


@pytest.mark.parametrize(
    ("dish_type", "title", "foods"),
    [
        ("seafood", "Bacon Wrapped Scallops", ("scallops:raw", "bacon:sliced", "maple syrup:liquid")),
        ("vegetables", "Bacon Wrapped Asparagus", ("asparagus:whole", "bacon:sliced", "black pepper:ground")),
        ("seafood", "Prosciutto Wrapped Shrimp", ("shrimp:peeled", "prosciutto:sliced", "olive oil:liquid")),
        ("sausage", "Sausages in Blankets", ("sausages:raw", "crescent roll dough:raw", "mustard:creamy")),
    ],
)
def test_what_is_wrapped_is_rolled_up_before_it_is_baked(steps, dish_type, title, foods):
    told = motions(steps(dish_type, title, *foods))
    assert told.index("roll") < told.index("bake")


@pytest.mark.parametrize(
    ("title", "foods"),
    [
        ("Stuffed Pizza", ("pizza dough:whole", "mozzarella:grated", "spinach:chopped", "tomato sauce:sauce")),
        ("Fugazzeta", ("flour:powder", "yeast:powder", "water:liquid", "salt:granulated", "onions:sliced",
                       "mozzarella:sliced", "olive oil:liquid")),
    ],
)  # fmt: skip
def test_a_stuffed_pizza_is_closed_over_its_cheese(steps, title, foods):
    told = steps("pizza", title, *foods)
    closed = first(told, "mozzarella", "fold and pinch")
    assert closed < motions(told).index("bake")


def test_joints_that_are_fried_see_no_oven(steps):
    told = steps("chicken", "Deep Fried Chicken Wings", "chicken wings:raw", "flour:powder", "paprika:ground",
                 "oil:liquid", "hot sauce:sauce")  # fmt: skip
    assert first(told, "chicken wings", "dip") < first(told, "chicken wings", "cook")
    assert "bake" not in motions(told)
    assert last(told, "hot sauce") < first(told, "chicken wings", "dip")


def test_what_is_creamed_is_heated_in_a_sauce_of_flour_and_milk(steps):
    told = steps("seafood", "Creamed Tuna on Toast", "tuna:canned", "butter:unmelted", "flour:powder",
                 "milk:liquid", "bread:slices")  # fmt: skip
    assert first(told, "butter", "melt") < first(told, "flour", "cook and stir") < first(told, "milk", "cook and stir")
    assert "baked" in states_of(told, "bread")


def test_poached_eggs_are_opened_into_boiling_water_and_never_beaten(steps):
    told = steps("omelette", "Poached Eggs with Tomato Sauce", "eggs:uncooked", "tomatoes:canned", "onion:chopped",
                 "olive oil:liquid")  # fmt: skip
    assert {"eggs", "water", "pot"} <= set().union(*(inputs for inputs, motion, _ in told if motion == "boil"))
    assert not {"beat", "whisk"} & set(motions(told))


@pytest.mark.parametrize("filling", ["peanut butter:creamy", "lemonade concentrate:frozen"])
def test_a_frozen_pie_is_frozen(steps, filling):
    told = steps("pie", "Frozen Pie", "graham cracker crust:whole", filling, "sweetened condensed milk:thick liquid")
    assert "freeze" in motions(told)
    assert "chill" not in motions(told)


def test_fruit_that_is_flamed_is_heated_with_the_spirits_and_served_with_the_ice(public_plans):
    made = public_plans("pudding", "Bananas Flambe", "banana:sliced", "butter:unmelted", "brown sugar:granulated",
                        "rum:liquid", "vanilla ice cream:frozen")  # fmt: skip
    hot = [{node.label for node in unit.input_nodes} for unit in made.units if unit.motion == "cook and stir"]
    assert any({"banana", "rum"} <= labels for labels in hot)
    assert not any("vanilla ice cream" in labels for labels in hot)
    assert any("flambe" in one.why for one in made.assumptions)


@pytest.mark.parametrize(
    ("food", "state"),
    [("pineapple", "chunks"), ("bell pepper", "chunks"), ("broccoli", "florets"), ("onion", "ring shaped")],
)
def test_the_forms_into_which_foods_are_cut_are_made_with_a_knife(steps, food, state):
    told = steps("stir-fry", "Stir Fry", f"{food}:{state}", "chicken breast:cubed", "soy sauce:liquid", "oil:liquid")
    assert state in states_of(told, food)
    assert any(food in inputs and "knife" in inputs for inputs, _, _ in told)


@pytest.mark.parametrize("title", ["Pan Rolls", "Hamburger Buns", "Soft Knots"])
def test_bread_in_portions_is_cut_and_lies_on_a_tray(steps, title):
    told = steps("bread", title, "flour:powder", "yeast:powder", "milk:warm", "butter:melted", "salt:granulated")
    assert any("dough" in inputs and "knife" in inputs for inputs, _, _ in told)
    assert "loaf pan" not in set().union(*(inputs for inputs, _, _ in told))


def test_what_was_boiled_for_a_dough_is_cool_before_it_meets_the_yeast(steps):
    told = steps("bread", "Potato Rolls", "potatoes:cubed", "potato water:cooled", "yeast:powder", "flour:powder",
                 "egg:uncooked", "butter:softened", "salt:granulated")  # fmt: skip
    mixed = next(place for place, (inputs, _, _) in enumerate(told) if {"yeast", "flour"} <= inputs)
    cooled = [inputs for inputs, motion, _ in told[:mixed] if motion == "cool down"]
    assert {"potatoes", "potato water"} <= set().union(*cooled)


@pytest.mark.parametrize(("state", "seen"), [("scalded", "cooled"), ("lukewarm", "lukewarm"), ("warm", "warm")])
def test_milk_for_a_dough_is_as_warm_as_it_is_asked(steps, state, seen):
    told = steps("bread", "White Bread", "flour:powder", "yeast:powder", f"milk:{state}", "salt:granulated")
    assert {state, seen} <= states_of(told, "milk")


def test_fresh_yeast_is_crumbled_and_is_no_powder(steps):
    told = steps("bread", "White Bread", "flour:powder", "fresh yeast:crumbled", "water:lukewarm", "salt:granulated")
    assert "crumbled" in states_of(told, "fresh yeast")
    assert "powder" not in states_of(told, "fresh yeast")


@pytest.mark.parametrize(
    ("dish_type", "title", "foods"),
    [
        ("pie", "Lemon Meringue Pie", ("pie crust:raw", "lemon juice:juice", "starch:powder", "egg yolk:raw")),
        ("cookie", "Meringue Cookies", ("vanilla:liquid",)),
        ("cake", "Pavlova", ("whipping cream:creamy", "strawberries:sliced")),
    ],
)
def test_a_meringue_is_beaten_to_a_foam_in_the_bowl_that_it_was_begun_in(steps, dish_type, title, foods):
    told = steps(dish_type, title, "egg whites:uncooked", "sugar:granulated", *foods)
    assert "whipped" in states_of(told, "egg whites")
    foam = [inputs for inputs, motion, _ in told if motion == "whisk" and "egg whites" in inputs]
    assert all("bowl" in inputs for inputs in foam)
    assert any("sugar" in inputs for inputs in foam)


@pytest.mark.parametrize(
    ("dish_type", "title", "flesh", "liquid"),
    [
        ("steak", "Cola Marinated Flank Steak", "flank steak:raw", "cola:liquid"),
        ("seafood", "Marinated Salmon", "salmon:fillets", "lime juice:juice"),
        ("pork", "Beer Marinated Pork Chops", "pork chops:uncooked", "beer:liquid"),
    ],
)
def test_flesh_comes_raw_out_of_its_marinade_is_turned_and_meets_the_rest_again(steps, dish_type, title, flesh, liquid):
    told = steps(dish_type, title, flesh, liquid, "soy sauce:liquid", "garlic:minced", "oil:liquid")
    food, drop = flesh.split(":")[0], liquid.split(":")[0]
    assert first(told, drop, "stir") < motions(told).index("chill") < first(told, food, "flip")
    lifted = [node for _, motion, outputs in told if motion == "remove" for node in outputs if node.label == food]
    assert lifted
    assert not any("cooked" in node.states for node in lifted)
    assert first(told, food, "flip") < motions(told).index("simmer")


def test_a_slow_cooker_has_one_pot_and_ready_grain_comes_beside_it(steps):
    told = steps("chicken", "Crockpot Chicken", "chicken thighs:raw", "tomatoes:canned", "onion:sliced",
                 "chicken broth:liquid", "tapioca:powder", "couscous:cooked")  # fmt: skip
    assert motions(told).count("simmer") == 1
    assert "cooking pan" not in set().union(*(inputs for inputs, _, _ in told))
    assert last(told, "tapioca") <= motions(told).index("simmer") < first(told, "couscous", "cook")


def test_dumplings_for_which_nothing_wet_is_asked_get_water(steps):
    told = steps("beef", "Beef Stew with Dumplings", "stewing beef:cut", "onions:chopped", "beef stock:liquid",
                 "self-raising flour:powder:dumplings", "suet:grated:dumplings")  # fmt: skip
    mixed = next(inputs for inputs, motion, _ in told if motion == "mix" and "self-raising flour" in inputs)
    assert "water" in mixed


def test_balls_that_the_title_poaches_simmer_in_their_sauce_which_is_bound_at_last(steps):
    told = steps("meatball", "Königsberger Klopse", "ground veal:raw:meatballs", "bread:soaked:meatballs",
                 "egg:uncooked:meatballs", "beef stock:liquid:sauce", "butter:unmelted:sauce", "flour:powder:sauce",
                 "cream:creamy:sauce", "egg yolk:uncooked:sauce")  # fmt: skip
    assert "flip" not in motions(told)
    assert first(told, "meatballs", "simmer") < max(
        n for n, motion in enumerate(motions(told)) if motion == "cook and stir"
    )
    assert first(told, "egg yolk", "whisk") == first(told, "cream", "whisk")


def test_a_tough_joint_simmers_by_itself_before_the_rice_joins(steps):
    told = steps("rice", "Baghali Polo", "lamb shanks:raw", "onion:chopped", "basmati rice:soaked", "oil:liquid")
    simmered = [inputs for inputs, motion, _ in told if motion == "simmer"]
    assert {"lamb shanks", "water"} <= simmered[0]
    assert "basmati rice" not in simmered[0]
    assert "basmati rice" in simmered[1]


def test_vegetables_that_simmer_with_no_liquid_but_fat_get_water(steps):
    told = steps("vegetables", "Avial", "plantain:cut", "carrot:cut", "coconut:grated", "cumin seeds:whole",
                 "coconut oil:liquid", "salt:granulated")  # fmt: skip
    assert "water" in next(inputs for inputs, motion, _ in told if motion == "simmer")


@pytest.mark.parametrize("root", ["beet:sliced", "rutabaga:cubed"])
def test_a_root_that_stays_hard_in_a_pan_is_boiled_first(steps, root):
    told = steps("vegetables", "-", root, "butter:unmelted", "salt:granulated")
    food = root.split(":")[0]
    assert next(motion for inputs, motion, _ in told if {food, "stove"} <= inputs) in {"boil", "cook", "simmer"}
    assert "water" in set().union(*(inputs for inputs, _, _ in told))


def test_a_root_that_is_grated_is_only_fried(steps):
    told = steps("vegetables", "-", "beet:grated", "butter:unmelted", "salt:granulated")
    assert "water" not in set().union(*(inputs for inputs, _, _ in told))


def test_dry_pulses_are_boiled_before_they_meet_what_is_sour(steps):
    told = steps("sausage", "-", "sausage:raw", "lentils:dried", "red wine:liquid", "tomato paste:paste", "onion:diced")
    drained = next(place for place, (inputs, _, _) in enumerate(told) if {"lentils", "strainer"} <= inputs)
    assert drained < min(place for place, (inputs, _, _) in enumerate(told) if "red wine" in inputs)


@pytest.mark.parametrize("title", ["Mulled Cider", "Hot Spiced Cider", "Wassail"])
def test_a_drink_that_is_steeped_and_drunk_hot_comes_into_a_mug(steps, title):
    told = steps("drinks", title, "apple cider:liquid", "cinnamon stick:whole", "cloves:whole", "sugar:granulated")
    assert {node.container for node in told[-1][2] if node.label == "drinks"} == {"mug"}
