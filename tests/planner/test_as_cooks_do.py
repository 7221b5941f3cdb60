"""What a cook does without being told, whatever the recorded dish did: found missing by people who read trees."""

from __future__ import annotations

import pytest
from planner.told_steps import first

from foon_kg.food import tables

pytestmark = pytest.mark.shared_data
KNOWN = tables()


def with_food(steps, food, motions):
    return [inputs for inputs, motion, _ in steps if food in inputs and motion in motions]


def test_who_asks_for_a_zested_lemon_has_its_zest_grated_and_no_slices(steps):
    told = steps("cookie", "Lemon Shortbread", "butter:softened", "flour:powder", "sugar:granulated", "lemon:zested")
    assert any("grater" in inputs for inputs in with_food(told, "lemon", {"grate"}))
    assert not with_food(told, "lemon", {"slice", "peel", "cut", "chop"})


def test_a_rind_is_cut_off_with_a_knife_and_the_core_comes_out(steps):
    told = steps("salad", "Fruit Salad", "pineapple:diced", "banana:sliced", "orange juice:juice")
    (first, *_) = [(inputs, outputs) for inputs, _, outputs in told if "pineapple" in inputs]
    assert "knife" in first[0]
    assert with_food(told, "pineapple", {"core"})


def test_the_stone_comes_out_of_an_avocado_before_its_skin_comes_off(steps):
    told = steps("salad", "Green Salad", "avocado:sliced", "lettuce:chopped", "olive oil:liquid")
    motions = [motion for inputs, motion, _ in told if "avocado" in inputs]
    assert motions.index("core") < motions.index("peel")


def test_nothing_is_simmered_without_a_liquid(steps):
    told = steps("rice", "Fried Rice", "rice:cooked", "egg:beaten", "garlic:minced", "vegetable oil:liquid")
    assert "simmer" not in {motion for _, motion, _ in told}


def test_what_only_gives_its_taste_is_taken_out_before_the_soup_is_served(steps):
    told = steps(
        "soup", "Pea Soup", "split pea:dried", "carrot:diced", "onion:chopped", "bay leaf:dried", "water:liquid"
    )
    (taken,) = [number for number, (_, motion, _) in enumerate(told) if motion == "remove"]
    assert taken < len(told) - 1
    assert not any("bay leaf" in node.ingredients for node in told[-1][2])


def test_a_mash_is_boiled_and_mashed(steps):
    told = steps("potatoes", "Sweet Potato Mash", "sweet potato:cubed", "butter:stick", "milk:liquid")
    assert with_food(told, "sweet potato", {"boil"})
    assert with_food(told, "sweet potato", {"mash"})


def test_dough_rises_again_when_it_is_shaped(steps):
    told = steps("bread", "White Bread", "flour:powder", "yeast:dry", "milk:warm", "butter:melted", "salt:granulated")
    motions = [motion for _, motion, _ in told]
    shaped = motions.index("shape")
    rising = KNOWN.motion("ferment").does
    assert any(KNOWN.motion(motion).does == rising for motion in motions[shaped:])
    assert motions.index("bake") > shaped


def test_what_fingers_tear_falls_into_a_bowl(steps):
    told = steps("salad", "Tomato Salad", "tomato:sliced", "basil leaves:torn", "olive oil:liquid")
    torn = [
        node for _, _, outputs in told for node in outputs if node.label == "basil leaves" and "torn" in node.states
    ]
    assert torn
    assert torn[0].container == "bowl"


def test_a_stove_is_not_turned_off_only_to_add_something(steps):
    told = steps(
        "chicken", "Chicken Fricassee", "chicken breast:raw", "flour:powder", "mushroom:sliced", "chicken broth:liquid",
        "butter:stick",
    )  # fmt: skip
    motions = [motion for inputs, motion, _ in told if "stove" in inputs]
    assert motions.count("turn on") == 1


def test_the_sauce_is_made_before_flesh_that_is_lifted_out_of_its_pan_while_hot(steps):
    told = steps(
        "chicken", "Chicken Marsala", "chicken breast:raw", "flour:powder", "mushroom:sliced", "chicken broth:liquid",
        "butter:stick",
    )  # fmt: skip
    lifted = next(n for n, (inputs, motion, _) in enumerate(told) if motion == "pick-and-place" and "turner" in inputs)
    assert first(told, "mushroom", "cook and stir") < first(told, "chicken breast", "flip") < lifted


def test_what_nobody_mashes_is_not_mashed_because_a_video_did(steps):
    told = steps("salad", "Corn Salad", "corn:cooked", "black beans:drained", "red onion:minced", "cilantro:chopped",
                 "lime:juiced")  # fmt: skip
    assert not [motion for _, motion, _ in told if "mash" in KNOWN.motion(motion).does]


def test_what_was_baked_in_a_tin_cools_and_no_tool_reaches_under_it(steps):
    told = steps(
        "muffin", "Carrot Muffins", "flour:powder", "sugar:granulated", "carrot:grated", "egg:whole",
        "vegetable oil:liquid", "baking soda:powder",
    )  # fmt: skip
    motions = [motion for _, motion, _ in told]
    cooled = next(place for place, motion in enumerate(motions) if motion.startswith("cool"))
    (out,) = [inputs for inputs, motion, outputs in told[cooled + 1 :] if any(n.label == "plate" for n in outputs)]
    assert out == {"plate", "muffin pan", "muffin"}


def test_a_crumb_crust_lines_the_pie_and_cream_comes_on_it_when_it_is_cold(steps):
    told = steps(
        "pie", "Key Lime Pie", "graham cracker crust:whole", "egg yolk:uncooked", "condensed milk:liquid",
        "lime juice:juice", "whipped cream:creamy",
    )  # fmt: skip
    crust = next(place for place, (inputs, _, _) in enumerate(told) if "graham cracker crust" in inputs)
    filling = next(place for place, (inputs, _, _) in enumerate(told) if place > crust and "mixture" in inputs)
    cold = next(place for place, (_, motion, _) in enumerate(told) if motion.startswith("cool"))
    cream = next(place for place, (inputs, _, _) in enumerate(told) if "whipped cream" in inputs)
    assert crust < filling < cold < cream


def test_what_is_called_grilled_is_fried_on_both_sides(steps):
    told = steps("sandwich", "Grilled Sandwich", "bread:sliced", "mozzarella:sliced", "tomato:sliced", "butter:stick")
    motions = [motion for _, motion, _ in told]
    assert "flip" in motions
    assert "melt" in motions


def test_tea_bags_come_out_of_the_pot_before_anybody_drinks(steps):
    told = steps("drinks", "Hot Tea", "water:liquid", "black tea bag:dried", "honey:thick liquid", "milk:liquid")
    assert "remove" in [motion for _, motion, _ in told]
    served = told[-1][2]
    assert {node.label for node in served} >= {"mug"}
    assert not any("black tea bag" in node.ingredients for node in served)


def test_water_that_thins_what_a_video_mixes_does_not_come_without_it(steps):
    told = steps(
        "rice", "Kedgeree", "rice:uncooked", "haddock:smoked", "egg:boiled", "onion:sliced", "curry powder:powder",
        "butter:stick",
    )  # fmt: skip
    assert not any("water" in node.ingredients for node in told[-1][2])


def test_potatoes_are_mashed_where_the_title_says_so_and_the_list_has_them_in_cubes(steps):
    told = steps("potatoes", "Garlic Mashed Potatoes", "potato:cubed", "garlic:clove", "cream:creamy", "butter:stick")
    assert with_food(told, "potato", {"mash"})


def test_what_was_peeled_is_cut_by_a_motion_that_does_not_peel_it_again(steps):
    told = steps("drinks", "Mango Smoothie", "mango:cubed", "orange juice:juice", "yogurt:creamy")
    motions = [motion for inputs, motion, _ in told if "mango" in inputs and "knife" in inputs]
    assert sum("peel" in KNOWN.motion(motion).does for motion in motions) == 1


@pytest.mark.parametrize(
    ("food", "state", "heated", "divided"),
    [
        ("egg", "boiled, chopped", {"boil"}, {"chop"}),
        ("beet", "boiled, grated", {"boil", "cook"}, {"grate"}),
        ("walnut", "toasted, chopped", {"toast"}, {"chop"}),
        ("bacon", "cooked, crumbled", {"cook", "cook and stir", "fry"}, {"pull apart", "crumble", "chop"}),
    ],
)
def test_what_is_asked_cooked_and_divided_is_divided_when_it_is_cooked(steps, food, state, heated, divided):
    told = steps("salad", "Plain Salad", f"{food}:{state}", "lettuce:chopped", "mayonnaise:creamy")
    done = [motion for inputs, motion, _ in told if food in inputs]
    (hot, *_) = [place for place, motion in enumerate(done) if motion in heated]
    assert divided & set(done[hot:])
    assert not divided & set(done[:hot])


def test_butter_that_is_asked_melted_and_cooled_is_melted(steps):
    told = steps("cake", "Plain Cake", "butter:melted, cooled", "flour:powder", "sugar:granulated", "egg:beaten")
    (melted,) = [place for place, (_, _, outputs) in enumerate(told) if any("melted" in n.states for n in outputs)][:1]
    assert melted < next(place for place, (inputs, *_) in enumerate(told) if {"butter", "sugar"} <= inputs)
