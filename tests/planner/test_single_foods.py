"""What is done to a single food that nobody eats as it is bought: found missing by people who read trees."""

from __future__ import annotations

import pytest
from planner.told_steps import states_of

pytestmark = pytest.mark.shared_data


def motions_of(told, food):
    return [motion for inputs, motion, _ in told if food in inputs]


def test_strawberries_are_hulled_unless_they_are_frozen(steps):
    fresh = steps("salad", "Fruit Salad", "strawberry:whole", "banana:sliced", "orange juice:juice")
    assert "core" in motions_of(fresh, "strawberry")
    frozen = steps("drinks", "Smoothie", "strawberry:frozen", "banana:whole", "milk:liquid")
    assert "core" not in motions_of(frozen, "strawberry")


@pytest.mark.parametrize("state", ["raw", "deveined"])
def test_shrimps_come_out_of_their_shell_by_hand(steps, state):
    told = steps("seafood", "Garlic Shrimp", f"shrimp:{state}", "butter:unmelted", "garlic:minced")
    (shelled,) = [inputs for inputs, motion, _ in told if motion == "peel" and "shrimp" in inputs]
    assert "knife" not in shelled


@pytest.mark.parametrize(("herb", "state", "is_cut"), [("cilantro", "whole", True), ("basil", "leaves", False)])
def test_herbs_are_chopped_into_a_salad_unless_their_leaves_are_served(steps, herb, state, is_cut):
    told = steps("salad", "Tomato Salad", "tomato:whole", "olive oil:liquid", f"{herb}:{state}")
    assert ("chop" in motions_of(told, herb)) is is_cut


def test_what_was_fried_by_itself_is_poured_with_its_fat(steps):
    asked = ("potatoes:quartered", "garlic:peeled", "butter:cut", "salt:granulated")
    told = steps("potatoes", "Garlic Mashed Potatoes", *asked)
    fried = [inputs for inputs, motion, _ in told if motion == "pour" and {"cooking pan", "garlic"} <= inputs]
    assert fried
    assert all("butter" in inputs for inputs in fried if "cutting board" not in inputs)


def test_leaves_that_were_plucked_off_their_stems_stay_in_the_dish(steps):
    asked = ("lentil:bean", "stock:liquid", "carrot:chopped", "bay leaf:leaves", "thyme leaves:fresh")
    told = steps("soup", "Lentil Soup", *asked)
    out = {
        node.label for _, motion, outputs in told if motion == "remove" for node in outputs if node.container == "plate"
    }
    assert out == {"bay leaf"}


def test_what_only_gives_its_taste_is_taken_out_in_one_step(steps):
    told = steps(
        "soup", "", "lentil:bean", "stock:liquid", "carrot:chopped", "bay leaf:leaves", "thyme:sprig", "onion:chopped"
    )
    (taken,) = [outputs for _, motion, outputs in told if motion == "remove"]
    assert {"bay leaf", "thyme"} <= {node.label for node in taken}


def test_kernels_come_off_their_cob_where_more_is_in_the_dish(steps):
    soup = steps("soup", "", "corn:whole", "stock:liquid", "bean:bean", "chicken:meat")
    assert "shaved" in states_of(soup, "corn")
    alone = steps("vegetables", "Corn on the Cob", "corn:whole", "butter:unmelted", "salt:ground")
    assert "shaved" not in states_of(alone, "corn")


def test_meat_is_cut_for_what_is_eaten_with_a_spoon(steps):
    told = steps("soup", "", "chicken:meat", "stock:liquid", "carrot:whole", "onion:whole")
    assert "chopped" in states_of(told, "chicken")


def test_ground_garlic_is_under_no_knife(steps):
    told = steps("salad", "", "potato:whole veg", "mayonnaise:creamy", "garlic:ground", "chive:chopped")
    assert not [inputs for inputs, _, _ in told if {"garlic", "knife"} <= inputs]


def test_butter_is_soft_when_it_is_beaten_and_hard_when_it_is_cut_into_flour(steps):
    cake = steps("cake", "", "flour:ground", "sugar:ground", "butter:creamy", "egg:whole raw", "baking powder:ground")
    beaten = [outputs for inputs, motion, outputs in cake if motion == "pick-and-place" and "butter" in inputs]
    assert any("softened" in node.states for node in beaten[0])
    pie = steps("pie", "Apple Pie", "flour:powder", "butter:unmelted", "apple:whole", "sugar:granulated")
    rubbed = [outputs for inputs, motion, outputs in pie if motion == "pick-and-place" and "butter" in inputs]
    assert not any("softened" in node.states for node in rubbed[0] if node.label == "butter")


def test_a_whole_nutmeg_is_grated(steps):
    told = steps("bread", "", "flour:ground", "egg:whole raw", "nutmeg:whole nuts", "sugar:ground", "oil:juice")
    assert "grate" in motions_of(told, "nutmeg")


def test_a_raw_salsa_is_chopped_into_a_bowl_and_one_of_canned_tomatoes_is_blended(steps):
    raw = steps("sauce", "Mango Salsa", "mango:unpeeled", "red onion:whole", "cilantro:whole", "lime:juiced")
    assert not any("measuring cup" in inputs for inputs, _, _ in raw)
    assert "chop" in motions_of(raw, "cilantro")
    canned = steps("sauce", "Salsa", "tomato:canned", "onion:chopped", "jalapeno:whole", "lime:juiced")
    assert "blend" in motions_of(canned, "tomato")


def test_flat_bread_is_cooked_in_a_pan_and_what_lies_on_it_comes_last(steps):
    told = steps(
        "bread", "Garlic Naan", "flour:powder", "yeast:powder", "water:liquid", "butter:melted", "garlic:minced"
    )
    motions = [motion for _, motion, _ in told]
    assert "bake" not in motions
    assert motions_of(told, "garlic")[-1] == "pour"
    assert len(told) - max(place for place, motion in enumerate(motions) if motion == "cook") <= 6


def test_bought_meatballs_are_made_hot_in_their_sauce(steps):
    told = steps("meatball", "Party Meatballs", "meatball:frozen", "chili sauce:sauce", "grape jelly:jelly")
    assert "simmer" in motions_of(told, "meatball")
    assert "shape" not in {motion for _, motion, _ in told}


def test_tubes_of_pasta_are_filled_and_not_rolled(steps):
    told = steps(
        "pasta",
        "Cannelloni",
        "cannelloni:raw",
        "ricotta:creamy",
        "spinach:leaves",
        "egg:whole raw",
        "tomato sauce:sauce",
    )
    assert "roll" not in {motion for _, motion, _ in told}


@pytest.mark.parametrize("water", ["pasta water", "a ladleful of pasta cooking water"])
def test_water_of_pasta_is_taken_out_of_its_pot_before_that_is_drained(steps, water):
    told = steps("pasta", "Cacio e Pepe", "spaghetti:uncooked", f"{water}:", "pecorino:grated", "butter:unmelted")
    (kept,) = [place for place, (_, _, out) in enumerate(told) if water in {n.label for n in out} and place][:1]
    assert "water" in told[kept][0]
    assert "faucet" not in told[kept][0]
    drained = [place for place, (inputs, _, _) in enumerate(told) if "strainer" in inputs]
    assert kept < drained[0]


def test_a_dish_is_not_asked_for_what_its_title_says_it_has_not(steps):
    cake = steps(
        "cake",
        "Wacky Cake (No Eggs, No Milk)",
        "flour:powder",
        "sugar:granulated",
        "vegetable oil:liquid",
        "vinegar:liquid",
        "baking soda:powder",
        "water:liquid",
    )
    assert "bake" in {motion for _, motion, _ in cake}


def test_crumbs_are_under_no_knife_and_firm_fruit_is_broken_by_no_hand(steps):
    cod = steps("seafood", "Baked Cod with Crumb Topping", "cod:raw", "panko:crumbs", "butter:melted", "parsley:minced")
    assert not [inputs for inputs, _, _ in cod if {"panko", "knife"} <= inputs]
    rice = steps("rice", "", "tenderloin:pieces", "pineapple:pieces", "rice:uncooked", "broth:liquid", "onion:whole")
    assert not {"break apart", "tear apart", "pull apart"} & {motion for _, motion, _ in rice}


def test_salt_of_the_water_is_in_what_was_boiled_in_it_and_not_left_in_the_strainer(steps):
    told = steps("noodle", "", "noodle:uncooked", "salt:ground", "butter:ground", "corn:grain", "egg:whipped")
    drained = [outputs for inputs, _, outputs in told if {"strainer", "pot"} <= inputs and "noodle" in inputs]
    assert drained
    assert not any(node.label == "salt" for outputs in drained for node in outputs)
    assert "salt" in told[-1][2][0].ingredients


def test_a_cheese_that_is_called_creamy_is_cut_off_its_block(steps):
    told = steps("noodle", "", "noodle:uncooked", "chicken:baked", "broth:liquid", "mozzarella:creamy", "onion:whole")
    assert {"slice", "grate", "dice", "chop"} & set(motions_of(told, "mozzarella"))
    assert "chopped" in states_of(told, "chicken")


def test_what_is_scooped_is_scooped_with_something(steps):
    told = steps("salad", "", "onion:whole", "garlic:minced", "feta:cubed", "almond:toasted", "olive oil:liquid")
    scooped = [inputs for inputs, motion, _ in told if motion in {"scoop", "scoop and pour"}]
    assert all({"spoon", "ladle", "spatula"} & inputs for inputs in scooped)


def test_a_whole_lemon_is_squeezed_for_a_cake_and_not_for_a_sangria(steps):
    cake = steps(
        "cake", "Lemon Cake", "flour:powder", "sugar:granulated", "butter:unmelted", "egg:uncooked", "lemon:whole"
    )
    assert "squeeze" in motions_of(cake, "lemon")
    sangria = steps("drinks", "Sangria", "red wine:liquid", "lemon:whole", "orange:whole", "sugar:granulated")
    assert "squeeze" not in motions_of(sangria, "lemon")


def test_a_crust_of_cauliflower_is_baked_before_the_rest_lies_on_it(steps):
    told = steps(
        "pizza", "Cauliflower Crust Pizza", "cauliflower:whole", "egg:uncooked", "parmesan:grated", "pizza sauce:sauce",
        "mozzarella:shredded",
    )  # fmt: skip
    motions = [motion for _, motion, _ in told]
    assert motions.count("bake") == 2
    assert "grate" in motions_of(told, "cauliflower")
    sauce = motions_of(told, "pizza sauce")
    assert sauce == ["pour", "bake"]


def test_shells_of_pasta_are_filled_with_a_spoon(steps):
    told = steps(
        "pasta", "Stuffed Shells", "pasta shell:uncooked", "ricotta:creamy", "egg:uncooked", "tomato sauce:sauce"
    )
    (filled,) = [inputs for inputs, motion, _ in told if "filling" in inputs and motion.startswith("scoop")]
    assert {"spoon", "baking dish"} <= filled


def test_flesh_that_is_asked_trimmed_is_so_as_it_is_sold_and_beans_are_trimmed_here(steps):
    pork = steps("pork", "", "pork loin steak:trimmed", "oil:liquid", "salt:granulated")
    assert motions_of(pork, "pork loin steak")[0] == "pick-and-place"
    beans = steps("vegetables", "", "green bean:trimmed", "butter:unmelted")
    assert motions_of(beans, "green bean")[0] == "cut off ends"


def test_a_block_of_cheese_is_cut_before_it_is_blended(steps):
    told = steps("sauce", "Basil Pesto", "pine nut:whole", "basil:leaf", "parmesan:block", "olive oil:liquid")
    assert motions_of(told, "parmesan")[0] == "chop"
