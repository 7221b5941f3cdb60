"""What is done to single foods, whatever the dish: soaked, cut, taken out again, fried in their turn."""

from __future__ import annotations

import pytest
from planner.told_steps import first, motions

pytestmark = [pytest.mark.shared_data, pytest.mark.slow]


def lifted(told):
    """Return what is removed from what it was cooked in."""
    removed = [node for _, motion, outputs in told for node in outputs if motion == "remove"]
    return {node.label for node in removed if node.container == "plate"}


def alone_in_heat(told, food):
    """Return what else is worked on in the first step over heat in which a food takes part."""
    return next(inputs - {food} for inputs, motion, _ in told if motion.startswith("cook") and food in inputs)


def test_what_is_dried_hard_soaks_before_it_is_cut_or_cooked(steps):
    told = steps("soup", "Soup", "porcini:dried", "kidney bean:dried", "onion:chopped", "oil:liquid", "stock:liquid")
    assert first(told, "porcini", "soak") < first(told, "porcini", "chop")
    hot = next(place for place, (inputs, _, _) in enumerate(told) if {"kidney bean", "stove"} <= inputs)
    assert first(told, "kidney bean", "soak") < hot


def test_lentils_and_sheets_of_seaweed_are_not_soaked_but_loose_seaweed_is(steps):
    told = steps("soup", "Lentil Soup", "lentil:dried", "onion:chopped", "oil:liquid", "stock:liquid", "nori:sheet")
    assert "soak" not in motions(told)
    told = steps("salad", "Seaweed Salad", "wakame:dried", "cucumber:sliced", "rice vinegar:liquid", "soy sauce:liquid")
    assert "soak" in motions(told)


def test_a_carrot_asked_in_sticks_is_peeled_and_then_cut(steps):
    told = steps("salad", "", "carrot:sticks", "cabbage:shredded", "oil:juice", "vinegar:juice")
    assert first(told, "carrot", "peel") < first(told, "carrot", "cut")


def test_what_was_dried_in_large_pieces_is_cut_and_coarse_leaves_lose_their_ends(steps):
    told = steps("salad", "Kale Salad", "kale:leaves", "sun-dried tomato:whole", "olive oil:liquid", "vinegar:liquid")
    assert first(told, "kale", "cut off ends") < first(told, "kale", "chop")
    assert any("sun-dried tomato" in inputs and "knife" in inputs for inputs, _, _ in told)


def test_whole_spices_that_are_found_again_are_taken_out(steps):
    told = steps(
        "rice", "", "rice:grain", "oil:juice", "onion:chopped", "cinnamon:sticks", "cardamom:pods", "clove:whole",
        "water:juice", "salt:ground",
    )  # fmt: skip
    assert lifted(told) == {"cinnamon"}


def test_no_fresh_pepper_comes_from_a_mill(steps):
    told = steps("chicken", "Jerk Chicken", "chicken thigh:raw", "scotch bonnet pepper:", "oil:liquid", "lime:juice")
    assert not any("pepper mill" in inputs for inputs, _, _ in told)


def test_bacon_is_fried_alone_then_flesh_and_then_the_rest(steps):
    told = steps(
        "beef", "Beef Stew", "bacon:raw", "beef chuck:cubed", "onion:chopped", "carrot:sliced", "red wine:liquid",
        "beef stock:liquid",
    )  # fmt: skip
    assert alone_in_heat(told, "bacon").isdisjoint({"beef chuck", "onion", "carrot"})
    assert alone_in_heat(told, "beef chuck").isdisjoint({"onion", "carrot"})
    assert first(told, "bacon", "chop") < first(told, "beef chuck", "cook and stir")


def test_bacon_is_fried_and_cut_before_it_is_stirred_into_what_is_baked(steps):
    told = steps(
        "bread", "", "flour:ground", "cheddar:whole", "buttermilk:juice", "egg:whole raw", "baking powder:ground",
        "salt:ground", "bacon:raw",
    )  # fmt: skip
    assert first(told, "bacon", "cook") < first(told, "bacon", "chop") < first(told, "bacon", "mix")


def test_rice_served_beside_a_stew_is_boiled_when_that_is_ready(steps):
    told = steps(
        "beef", "Chili con Carne", "ground beef:raw", "onion:chopped", "oil:liquid", "tomato:canned",
        "kidney bean:canned", "long-grain rice:uncooked:serving",
    )  # fmt: skip
    simmered = max(place for place, (inputs, motion, _) in enumerate(told) if motion == "simmer" and "pot" in inputs)
    assert next(place for place, (inputs, _, _) in enumerate(told) if "long-grain rice" in inputs) > simmered


def test_rice_is_boiled_before_what_is_only_fried_and_lies_under_it(steps):
    told = steps(
        "stir-fry", "Beef Stir-Fry", "beef:sliced", "bell pepper:sliced", "onion:sliced", "soy sauce:liquid",
        "oil:liquid", "rice:cooked",
    )  # fmt: skip
    assert first(told, "rice", "cook") < next(place for place, (inputs, _, _) in enumerate(told) if "oil" in inputs)
    *_, (inputs, _, outputs) = told
    assert "cooking pan" in inputs
    assert "rice" in {food for node in outputs for food in node.ingredients}


def test_a_stew_comes_on_the_flatbread_that_it_is_served_on(steps):
    told = steps(
        "chicken", "Doro Wat", "chicken:pieces", "onion:chopped", "butter:melted", "berbere:ground",
        "chicken stock:liquid", "injera:plain",
    )  # fmt: skip
    laid = next(place for place, (inputs, _, _) in enumerate(told) if "injera" in inputs)
    assert "pot" in told[laid + 1][0]


def test_what_makes_a_soup_is_not_mixed_cold_beside_it_and_sour_and_creamy_come_last(steps):
    told = steps(
        "soup", "Hungarian Mushroom Soup", "butter:stick", "onion:chopped", "mushroom:sliced", "chicken broth:liquid",
        "milk:liquid", "flour:powder", "lemon juice:juice", "sour cream:creamy",
    )  # fmt: skip
    assert not any("measuring cup" in inputs and motion == "mix" for inputs, motion, _ in told)
    poured = [food for inputs, motion, _ in told for food in ("flour", "chicken broth", "sour cream", "lemon juice")
              if food in inputs and "pour" in motion and "pot" in inputs]  # fmt: skip
    assert poured == ["flour", "chicken broth", "sour cream", "lemon juice"]


def test_cheese_that_is_to_melt_is_grated_and_crumbly_cheese_crumbled(steps):
    told = steps("pie", "Quiche", "pie crust:raw", "gruyere:block", "feta:block", "egg:whole", "cream:creamy")
    assert any(inputs >= {"gruyere", "grater"} for inputs, _, _ in told)
    assert any("crumbled" in node.states for _, _, outputs in told for node in outputs if node.label == "feta")


def test_nuts_asked_toasted_are_toasted_before_they_are_stirred_into_a_batter(steps):
    told = steps(
        "cake", "", "flour:ground", "sugar:ground", "egg:whole raw", "butter:creamy", "baking powder:ground",
        "walnut:toasted",
    )  # fmt: skip
    assert first(told, "walnut", "toast") < first(told, "walnut", "mix")


def test_capers_are_poured_out_of_their_brine(steps):
    told = steps("salad", "", "potato:boiled", "caper:whole", "oil:juice", "vinegar:juice", "egg:boiled")
    assert any({"caper", "strainer"} <= inputs for inputs, _, _ in told)


def test_a_curry_that_is_called_by_its_flesh_is_cooked_in_one_pot_and_lime_comes_late(steps):
    told = steps(
        "chicken", "Thai Green Curry Chicken", "oil:liquid", "green curry paste:paste", "coconut milk:liquid",
        "chicken thigh:sliced", "lime juice:juice", "eggplant:cubed",
    )  # fmt: skip
    assert first(told, "oil", "heat") < first(told, "chicken thigh", "pour") < first(told, "lime juice", "pour")
    assert not any("bowl" in inputs and "coconut milk" in inputs for inputs, _, _ in told[:-1])


def test_beans_are_the_peas_of_rice_and_peas(public_plans):
    plan = public_plans("rice", "Rice and Peas", "kidney bean:dried", "coconut milk:liquid", "rice:uncooked", "salt:")
    assert plan.units


def test_wine_comes_before_other_liquids_and_tomato_paste_is_fried(steps):
    told = steps(
        "beef", "Beef Stew", "beef chuck:cubed", "onion:chopped", "oil:liquid", "garlic:minced", "red wine:liquid",
        "beef stock:liquid", "tomato paste:paste",
    )  # fmt: skip
    came = [
        food for inputs, motion, _ in told for food in ("garlic", "tomato paste", "red wine", "beef stock")
        if food in inputs and "pot" in inputs and "pour" in motion
    ]  # fmt: skip
    assert came == ["garlic", "tomato paste", "red wine", "beef stock"]


def test_sesame_oil_comes_last_where_there_is_other_oil_and_first_where_there_is_none(steps):
    foods = ("rice:cooked", "carrot:sliced", "egg:whole", "soy sauce:liquid", "sesame oil:liquid")
    told = steps("rice", "", *foods, "vegetable oil:liquid")
    assert first(told, "vegetable oil", "pour") < first(told, "carrot", "pour") < first(told, "sesame oil", "pour")
    told = steps("rice", "", *foods)
    assert first(told, "sesame oil", "pour") < first(told, "carrot", "pour")


def test_the_rest_is_fried_in_the_fat_that_bacon_left_where_no_other_is_asked(steps):
    told = steps("omelette", "Bacon Frittata", "bacon:chopped", "onion:sliced", "egg:whole", "milk:liquid", "salt:")
    assert sum(motion == "pick-and-place" and {"cooking pan", "stove"} <= inputs for inputs, motion, _ in told) == 1


def test_mint_that_is_mixed_into_a_salad_is_chopped(steps):
    told = steps("salad", "Tabbouleh", "bulgur:", "parsley:fresh", "mint:fresh", "lemon juice:juice", "olive oil:")
    assert "chop" in [motion for inputs, motion, _ in told if "mint" in inputs]


def test_a_paste_that_is_listed_by_itself_is_ground_and_then_fried(steps):
    paste = ("shallot:whole:paste", "garlic:clove:paste", "lemongrass::paste", "cumin seed:whole:paste")
    told = steps(
        "beef", "Beef Rendang", "beef chuck:cubed", "oil:liquid", "coconut milk:liquid", "cinnamon stick:whole", *paste
    )
    ground = first(told, "garlic", "blend")
    came = next(place for place, (inputs, _, _) in enumerate(told) if {"blender jar", "pot"} <= inputs)
    assert ground < first(told, "beef chuck", "cook and stir") < came < first(told, "coconut milk", "pour")
    assert lifted(told) == {"cinnamon stick"}


def test_ice_is_never_boiled_whatever_state_it_is_asked_in(steps):
    assert "boil" not in motions(steps("salad", "", "apple:whole", "ice:boiled"))


def test_sprigs_and_bay_leaves_are_lifted_out_of_what_was_baked(steps):
    told = steps(
        "casserole", "Sausage and Bean Casserole", "sausage:sliced", "butter bean:canned", "onion:sliced",
        "canned tomato:chopped", "bay leaf:whole", "thyme:sprig", "oil:liquid", "breadcrumbs:crumbs",
    )  # fmt: skip
    assert "bake" in motions(told)
    assert {"bay leaf", "thyme"} <= lifted(told)


def test_flesh_is_lifted_out_of_a_liquid_by_itself_and_leaves_after_it(steps):
    told = steps(
        "roast", "Cider Roast Gammon", "gammon joint:raw", "cider:liquid", "onion:halved", "carrot:chopped",
        "black peppercorn:whole", "bay leaf:whole", "honey:liquid", "mustard:creamy",
    )  # fmt: skip
    on_board = [
        {node.label for node in outputs if node.container == "cutting board"}
        for _, motion, outputs in told if motion == "remove"
    ]  # fmt: skip
    assert {"gammon joint"} in on_board
    assert lifted(told) == {"bay leaf"}


def test_what_flesh_is_brushed_with_comes_before_the_small_things_around_it(steps):
    told = steps(
        "roast", "Roast Rabbit with Olives", "rabbit:raw", "olive oil:liquid", "onion:chopped", "garlic:minced",
        "rosemary:chopped", "olive:whole", "pine nut:whole", "wine:liquid",
    )  # fmt: skip
    brushed = next(inputs for inputs, motion, _ in told if motion == "brush")
    assert "rabbit" in brushed
    assert brushed.isdisjoint({"onion", "olive", "pine nut"})


def test_a_sauce_bound_with_starch_comes_after_what_is_fried_for_a_moment(steps):
    told = steps(
        "stir-fry", "Tofu Stir-Fry", "tofu:cubed", "snow pea:whole", "bok choy:chopped", "garlic:minced", "oil:liquid",
        "soy sauce:liquid", "cornstarch:powder", "water:liquid",
    )  # fmt: skip
    poured = next(
        place
        for place, (inputs, _, _) in enumerate(told)
        if "mixture" in inputs and inputs & {"cooking pan", "wok", "frying pan"}
    )
    fried = {food for inputs, motion, _ in told[:poured] if motion == "cook and stir" for food in inputs}
    assert {"tofu", "snow pea", "bok choy"} <= fried


@pytest.mark.parametrize(
    ("dish", "food", "done", "rest"),
    [
        ("seafood", "mussel:whole", ["scrub", "debeard"], ("white wine:liquid", "shallot:chopped", "butter:unmelted")),
        ("seafood", "clam:fresh", ["scrub"], ("white wine:liquid", "garlic:minced", "butter:unmelted")),
        ("seafood", "sea bass:whole", ["scale", "gut"], ("lemon:sliced", "olive oil:liquid", "salt:granulated")),
        ("seafood", "mackerel:whole", ["gut"], ("lemon:sliced", "olive oil:liquid", "salt:granulated")),
        ("seafood", "mussel:shucked", [], ("shallot:chopped", "butter:unmelted", "white wine:liquid")),
        ("seafood", "mussel:canned", [], ("shallot:chopped", "tomato:chopped", "olive oil:liquid")),
        ("soup", "green lentil:dried", ["rinse"], ("carrot:diced", "onion:chopped", "vegetable stock:liquid")),
        ("soup", "leek:sliced", ["cut off ends", "slice"], ("potato:diced", "vegetable stock:liquid")),
        ("soup", "cauliflower:chopped", ["cut off ends", "chop"], ("potato:diced", "vegetable stock:liquid")),
        ("bread", "rosemary:chopped", ["strip", "chop"], ("flour:powder", "yeast:powder", "water:liquid")),
        ("bread", "rosemary:dried", [], ("flour:powder", "yeast:powder", "water:liquid")),
        ("omelette", "broad bean:skinned", ["defrost", "peel"], ("egg:beaten", "butter:unmelted")),
    ],
)
def test_a_food_is_cleaned_as_its_kind_needs_before_it_is_cut(steps, dish, food, done, rest):
    label = food.partition(":")[0]
    cleans = {"scrub", "debeard", "scale", "gut", "rinse", "cut off ends", "slice", "chop", "strip", "defrost", "peel"}
    told = steps(dish, "", food, *rest)
    assert [motion for inputs, motion, _ in told if motion in cleans and label in inputs] == done


@pytest.mark.parametrize(("food", "boned"), [("chicken thigh:bone-in", True), ("chicken breast:boneless", False)])
def test_flesh_comes_off_its_bones_before_it_is_pulled_apart(steps, food, boned):
    told = motions(steps("sandwich", "Pulled Chicken Sandwich", food, "barbecue sauce:sauce", "bun:whole"))
    assert "pull apart" in told
    assert ("bone" in told[: told.index("pull apart")]) is boned


def test_what_runs_is_stirred_and_what_is_in_pieces_muddled(steps):
    assert "mash" not in motions(steps("drinks", "", "tequila:liquid", "lime juice:liquid", "agave nectar:syrup"))
    told = steps("drinks", "Mojito", "mint:leaves", "lime:wedges", "sugar:granulated", "rum:liquid", "soda:liquid")
    assert first(told, "mint", "mash") < len(told) - 1


def test_what_is_mashed_for_the_table_lies_in_no_glass(steps):
    told = steps("burger", "", "ground turkey:raw", "avocado:mashed", "bun:whole", "lettuce:leaves")
    assert not {"highball glass", "muddler"} & told[first(told, "avocado", "mash")][0]


def test_mussels_in_their_liquid_are_poured_though_there_is_bacon_in_it(steps):
    told = steps("seafood", "", "mussel:whole", "cider:liquid", "bacon:diced", "shallot:chopped", "cream:liquid")
    assert all("turner" not in inputs for inputs, _, _ in told)


def test_rubbed_sage_is_strewn_and_never_taken_out_again(steps):
    told = steps("sausage", "Breakfast Sausage Patties", "ground pork:raw", "sage:rubbed", "salt:granulated")
    assert "sage" not in lifted(told)
    assert first(told, "sage", "sprinkle") < len(told) - 1
