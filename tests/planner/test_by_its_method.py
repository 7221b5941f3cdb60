"""What the verb of a title asks for is done: it is roasted in the oven, dipped in its coats, shaped in portions."""

from __future__ import annotations

import pytest
from planner.told_steps import first, motions

pytestmark = pytest.mark.shared_data

BREADED = ("flour:powder", "eggs:beaten", "breadcrumbs:crumbs")


def dips(told):
    return [(inputs, outputs) for inputs, motion, outputs in told if motion == "dip"]


@pytest.mark.parametrize(
    ("title", "foods"),
    [
        ("Roast Leg of Lamb", ("leg of lamb:raw", "garlic:minced", "rosemary:chopped", "olive oil:liquid")),
        ("Herb Roasted Pork Loin", ("pork loin roast:raw", "mustard:creamy", "thyme:dried", "salt:granulated")),
        ("Prime Rib", ("standing rib roast:raw", "butter:softened", "garlic:minced", "salt:granulated")),
    ],
)
def test_a_roast_is_rubbed_roasted_in_the_oven_and_carved_on_a_plate(steps, title, foods):
    told = steps("roast", title, *foods)
    assert motions(told).index("brush") < motions(told).index("bake") < motions(told).index("slice", 5)
    assert "stove" not in set().union(*(inputs for inputs, _, _ in told))
    assert {node.container for node in told[-1][2] if node.label == "roast"} == {"plate"}


def test_what_is_roasted_around_it_lies_in_the_same_dish(steps):
    told = steps("beef", "Roast Beef with Potatoes", "sirloin roast:raw", "potatoes:quartered", "vegetable oil:liquid")
    (inputs,) = [inputs for inputs, motion, _ in told if motion == "bake"]
    assert {"sirloin roast", "potatoes", "oven"} <= inputs


def test_every_coat_has_a_bowl_of_its_own_and_its_rest_stays_there(steps):
    told = steps("pork", "Pork Schnitzel", "pork chops:boneless", *BREADED, "oil:liquid", "salt:granulated")
    assert len(dips(told)) == 3
    for _, outputs in dips(told):
        (bowl,) = [node for node in outputs if node.label == "bowl"]
        assert bowl.ingredients
        assert {node.container for node in outputs if node.label == "pork chops"} == {"plate"}


def test_a_batter_is_left_behind_when_several_foods_are_dipped(steps):
    told = steps("vegetables", "Vegetable Tempura", "sweet potato:sliced", "broccoli:floret", "flour:powder",
                 "egg:uncooked", "water:liquid", "oil:liquid")  # fmt: skip
    ((_, outputs),) = dips(told)
    coated = {node.label for node in outputs if "coated" in node.states}
    assert coated == {"sweet potato", "broccoli"}
    assert any(node.label == "mixing bowl" and node.ingredients for node in outputs)


def test_what_is_oven_fried_is_baked_on_a_tray(steps):
    told = steps("chicken", "Oven Fried Chicken", "chicken thighs:raw", "buttermilk:liquid", "cornflake crumbs:crumbs",
                 "paprika:ground", "salt:granulated")  # fmt: skip
    assert len(dips(told)) == 2
    assert first(told, "chicken thighs", "dip") < first(told, "baking tray", "bake")
    assert "cooking pan" not in set().union(*(inputs for inputs, _, _ in told))


@pytest.mark.parametrize(
    ("dish_type", "title", "foods", "portions"),
    [
        ("meatball", "Baked Meatballs", ("ground beef:raw", "breadcrumbs:crumbs", "egg:uncooked", "milk:liquid",
                                         "garlic:minced", "salt:granulated"), "meatballs"),
        ("potatoes", "Potato Latkes", ("potatoes:grated", "onion:grated", "egg:uncooked", "flour:powder",
                                       "salt:granulated", "oil:liquid"), "patties"),
        ("burger", "Burgers", ("ground beef:raw", "salt:granulated", "hamburger buns:whole"), "patties"),
    ],
)  # fmt: skip
def test_a_mass_is_shaped_in_portions_that_lie_on_a_plate(steps, dish_type, title, foods, portions):
    told = steps(dish_type, title, *foods)
    (outputs,) = [outputs for _, motion, outputs in told if motion == "shape"]
    assert {(node.label, node.container) for node in outputs if node.container} == {(portions, "plate")}


def test_milk_and_what_seasons_meatballs_is_mixed_in_before_they_are_shaped_and_baked(steps):
    told = steps("meatball", "Oven Baked Meatballs", "ground turkey:raw", "breadcrumbs:crumbs", "egg:uncooked",
                 "milk:liquid", "parmesan:grated", "garlic:minced", "parsley:chopped", "salt:granulated")  # fmt: skip
    shaped = motions(told).index("shape")
    (whole,) = [node for node in told[shaped][2] if node.label == "meatballs"]
    assert len(whole.ingredients) == 8
    assert "stove" not in set().union(*(inputs for inputs, _, _ in told))


def test_a_loaf_of_meat_stays_in_one_piece(steps):
    told = steps("meatloaf", "Meatloaf", "ground beef:raw", "breadcrumbs:crumbs", "egg:uncooked", "salt:granulated")
    assert "patties" not in set().union(*(inputs for inputs, _, _ in told))


def test_a_steak_lies_on_a_plate(steps):
    told = steps("steak", "Pan Seared Steak", "steak:raw", "butter:unmelted", "oil:liquid", "cream:liquid")
    assert {node.container for node in told[-1][2] if node.label == "steak"} == {"plate"}


def test_without_a_title_no_word_of_a_recorded_name_goes_unexplained(steps):
    told = steps("salad", "", "tomato:chopped", "onion:sliced", "pepper:chopped", "olive oil:liquid", "lettuce:torn")
    assert {node.label for node in told[-1][2] if node.container} == {"salad"}


@pytest.mark.parametrize("title", ["Steak Diane", "Steak with Mushroom Sauce"])
def test_flesh_is_seasoned_before_the_pan_and_taken_out_before_its_sauce(steps, title):
    told = steps("steak", title, "beef tenderloin medallions:raw", "salt:granulated", "butter:unmelted",
                 "mushrooms:sliced", "cream:liquid", "brandy:liquid")  # fmt: skip
    seasoned = next(outputs for _, _, outputs in told if any(n.label == "salt" and n.container for n in outputs))
    assert {node.container for node in seasoned if node.label == "salt"} == {"plate"}
    poured = first(told, "cream", "pour")
    assert not any("beef tenderloin medallions" in node.ingredients for node in told[poured][2])
    assert {node.container for node in told[-1][2] if node.label == "steak"} <= {"plate"}


def test_an_egg_is_beaten_before_flesh_is_dipped_into_it(steps):
    told = steps(
        "chicken", "Breaded Chicken", "chicken breasts:raw", "egg:uncooked", "breadcrumbs:crumbs", "oil:liquid"
    )
    (wet, dry) = dips(told)
    assert {"egg mixture"} <= wet[0]
    assert {"breadcrumbs"} <= dry[0]


@pytest.mark.parametrize(
    ("title", "foods", "drawn"),
    [
        ("Hot Buttered Apple Punch", ("apple juice:liquid", "brown sugar:granulated", "cloves:whole",
                                      "cinnamon sticks:whole", "butter:unmelted", "dark rum:liquid"), "cloves"),
        ("", ("rose hip:dried", "hibiscus:dried", "water:liquid", "honey:thick liquid", "clove:whole",
              "ginger:sliced"), "rose hip"),
    ],
)  # fmt: skip
def test_what_a_hot_drink_draws_from_is_heated_with_it_and_taken_out(steps, title, foods, drawn):
    told = steps("drinks", title, *foods)
    out = next(place for place, motion in enumerate(motions(told)) if motion in {"remove", "pour and strain"})
    assert first(told, drawn, "cook") < out
    late = told[out + 1 :]
    assert drawn not in set().union(*(inputs for inputs, _, _ in late))


def test_an_atole_of_corn_is_blended_and_then_cooked(steps):
    told = steps("drinks", "Atole de Elote", "corn kernels:uncooked", "milk:liquid", "water:liquid", "sugar:granulated")
    assert motions(told).index("blend") < motions(told).index("cook and stir")
    assert "boil" not in motions(told)


def test_boiled_eggs_lie_in_the_middle_of_a_stuffed_loaf_and_not_in_its_mince(steps):
    told = steps("meatloaf", "Pulpeton", "meat:minced", "onion:grated", "egg:raw", "eggs:boiled", "salt:granulated")
    (mixed,) = [inputs for inputs, motion, _ in told if motion == "mix"]
    assert "egg" in mixed
    assert "eggs" not in mixed
    assert first(told, "egg", "mix") < first(told, "eggs", "roll")


def test_milk_that_starch_sets_and_tapioca_are_cooked_and_chilled(steps):
    told = steps("pudding", "Malabi", "milk:liquid", "cornstarch:powder", "sugar:granulated", "rose water:liquid")
    assert first(told, "cornstarch", "beat") < motions(told).index("cook and stir") < motions(told).index("chill")
    told = steps("pudding", "", "tapioca:ground", "milk:liquid", "egg yolk:beaten", "sugar:ground", "salt:ground")
    assert first(told, "tapioca", "cook and stir") < motions(told).index("chill")
    assert "bake" not in motions(told)


def test_sandies_are_shaped_before_they_are_baked(steps):
    told = steps("cookie", "Pecan Sandies", "butter:softened", "sugar:granulated", "flour:powder", "pecans:chopped")
    assert motions(told).index("shape") < motions(told).index("bake")


def test_fruit_in_a_juice_with_starch_is_cooked_before_it_fills_a_crust(steps):
    told = steps(
        "pie", "", "pie crusts:raw", "raisins:whole", "water:liquid", "sugar:granulated", "cornstarch:powder"
    )  # fmt: skip
    assert first(told, "cornstarch", "beat") < motions(told).index("cook and stir") < motions(told).index("bake")
    assert first(told, "raisins", "cook and stir") < first(told, "pie crusts", "bake")


def test_fresh_berries_lie_raw_in_a_baked_crust_under_their_glaze(steps):
    told = steps(
        "pie", "Fresh Strawberry Pie", "pie shell:baked", "strawberries:whole", "sugar:granulated",
        "cornstarch:powder", "water:liquid",
    )  # fmt: skip
    (baked,) = [inputs for inputs, motion, _ in told if motion == "bake"]
    assert "strawberries" not in baked
    (cooked,) = [inputs for inputs, motion, _ in told if motion == "cook and stir"]
    assert "strawberries" not in cooked
    assert motions(told).index("cook and stir") < motions(told).index("chill")


def test_shellfish_joins_a_bisque_after_it_is_blended(steps):
    told = steps(
        "soup", "Shrimp Bisque", "shrimp:peeled", "onion:chopped", "butter:unmelted", "flour:powder",
        "seafood stock:liquid", "heavy cream:creamy",
    )  # fmt: skip
    blended = motions(told).index("blend")
    assert first(told, "onion", "cook and stir") < blended < first(told, "shrimp", "simmer")


def test_roots_with_an_apple_are_blended_when_they_are_soft(steps):
    told = steps("soup", "", "beets:chopped", "apple:chopped", "onion:chopped", "oil:liquid", "stock:liquid")
    assert motions(told).index("simmer") < motions(told).index("blend")


def test_what_is_fried_in_flour_has_the_gravy_of_its_title(steps):
    told = steps(
        "pork", "Pork Chops with Cream Gravy", "pork chops:raw", "flour:powder", "oil:liquid", "milk:liquid",
        "salt:granulated",
    )  # fmt: skip
    (stirred, *_) = [inputs for inputs, motion, _ in reversed(told) if motion == "cook and stir"]
    assert {"flour", "milk"} <= stirred
    assert len(dips(told)) == 2


def test_dumplings_of_pulse_flour_are_shaped_and_fried_before_the_pot(steps):
    told = steps(
        "vegetables", "Undhiyu", "purple yam:cubed", "baby aubergines:slit", "fenugreek leaves:chopped",
        "gram flour:powder", "turmeric:ground", "oil:liquid", "salt:granulated",
    )  # fmt: skip
    assert first(told, "gram flour", "mix") < motions(told).index("shape") < motions(told).index("simmer")


def test_the_peppers_of_a_huancaina_are_fried_before_they_are_blended(steps):
    told = steps(
        "potatoes", "Papas a la Huancaína", "potatoes:whole", "ají amarillo peppers:whole", "onion:chopped",
        "queso fresco:block", "soda crackers:whole", "evaporated milk:liquid", "vegetable oil:liquid",
    )  # fmt: skip
    assert first(told, "ají amarillo peppers", "cook and stir") < motions(told).index("blend")
