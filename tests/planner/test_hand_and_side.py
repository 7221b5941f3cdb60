"""What lies on dough or in rolls, eggs, vegetables and sauces are made as their titles call them."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions, states_of, taking

from foon_kg.food import tables

pytestmark = pytest.mark.shared_data


def test_the_white_sauce_of_a_pizza_is_cooked_before_it_lies_on_the_dough(steps):
    told = steps("pizza", "Chicken Alfredo Pizza", "pizza dough:whole", "butter:unmelted", "garlic:minced",
                 "flour:powder", "heavy cream:creamy", "cooked chicken:shredded", "mozzarella:shredded")  # fmt: skip
    assert {"butter", "flour", "heavy cream"} <= taking(told, "cook and stir")
    assert first(told, "heavy cream", "cook and stir") < motions(told).index("bake")


def test_cheese_that_a_burger_is_stuffed_with_is_closed_in_it(steps):
    told = steps("burger", "Stuffed Blue Cheese Burgers", "ground beef:raw", "blue cheese:crumbled", "buns:whole",
                 "salt:granulated")  # fmt: skip
    assert "blue cheese" in taking(told, "fold and pinch")


def test_raw_fish_is_chopped_for_a_burger_unless_the_burger_is_crisp(steps):
    asked = ("salmon fillet:raw", "panko:crumbs", "egg:uncooked", "oil:liquid", "buns:whole")
    assert "salmon fillet" in taking(steps("burger", "Salmon Burgers", *asked), "mix")
    assert "salmon fillet" in taking(steps("burger", "Crispy Salmon Burgers", *asked), "dip")


@pytest.mark.parametrize("meat", ["ground beef:raw", "ground turkey:raw"])
def test_the_mince_of_a_sloppy_joe_is_not_shaped(steps, meat):
    told = steps("burger", "Sloppy Joes", meat, "onion:chopped", "ketchup:sauce", "buns:plain")
    assert "shape" not in motions(told)
    assert {meat.split(":")[0], "ketchup"} <= taking(told, "cook and stir")


def test_peppers_are_fried_for_the_roll_of_sausages_that_is_called_after_them(steps):
    told = steps("sandwich", "Sausage and Pepper Hoagies", "hoagie rolls:whole", "Italian sausage:raw",
                 "bell peppers:sliced", "onion:sliced", "olive oil:liquid")  # fmt: skip
    assert {"bell peppers", "onion"} <= taking(told, "cook and stir")


def test_nuts_are_chopped_into_patties_of_pulses(steps):
    told = steps("burger", "Lentil Walnut Burgers", "lentils:dried", "walnuts:whole", "breadcrumbs:crumbs",
                 "egg:uncooked", "oil:liquid", "buns:whole")  # fmt: skip
    assert "walnuts" in inside(told, "mash")
    assert "chopped" in states_of(told, "walnuts")


def test_eggs_that_a_burger_is_called_after_are_fried_and_not_mixed_into_it(steps):
    told = steps("burger", "Burgers with Fried Eggs", "ground beef:raw", "eggs:uncooked", "buns:plain",
                 "salt:granulated")  # fmt: skip
    assert "eggs" not in taking(told, "mix")
    assert "eggs" in taking(told, "cook")


def test_slices_of_turkey_are_bought_ready():
    assert tables().foods.as_measured("turkey", ["slices"]) == "sliced"
    assert tables().foods.as_measured("bread", ["slices"]) == ""


def test_a_hole_is_cut_for_the_egg_before_its_slice_is_fried(steps):
    told = steps("omelette", "Egg in a Hole", "bread:sliced", "butter:unmelted", "eggs:uncooked")
    assert motions(told).index("core") < first(told, "bread", "cook") < first(told, "eggs", "cook")


def test_scotch_eggs_are_wrapped_then_turned_in_egg_and_crumbs(steps):
    told = steps("omelette", "Scotch Eggs", "eggs:uncooked", "sausage meat:raw", "flour:powder", "egg:beaten",
                 "breadcrumbs:crumbs", "oil:liquid")  # fmt: skip
    assert motions(told).index("wrap") < first(told, "egg", "dip") < first(told, "breadcrumbs", "dip")
    assert "egg" not in taking(told, "boil")


def test_boiled_eggs_lie_under_the_sauce_that_they_are_called_after(steps):
    told = steps("omelette", "Eggs in Mustard Sauce", "eggs:uncooked", "butter:unmelted", "flour:powder",
                 "milk:liquid",
                 "mustard:creamy")  # fmt: skip
    assert "eggs" in taking(told, "boil")
    assert "eggs" not in taking(told, "beat") | taking(told, "cook and stir")


def test_mushrooms_lose_their_stems_before_they_are_stuffed(steps):
    told = steps("vegetables", "Stuffed Mushrooms", "mushrooms:whole", "sausage meat:raw", "cream cheese:block",
                 "breadcrumbs:crumbs")  # fmt: skip
    assert first(told, "mushrooms", "remove stem") < motions(told).index("bake")


@pytest.mark.parametrize(
    ("title", "food", "state"),
    [("Zucchini Boats with Sausage", "zucchini", "halved"), ("Eggplant Rollatini", "eggplant", "sliced")],
)
def test_vegetables_are_cut_for_what_is_laid_on_them(steps, title, food, state):
    told = steps("vegetables", title, f"{food}:whole", "sausage meat:raw", "ricotta:creamy", "marinara sauce:sauce",
                 "mozzarella:shredded")  # fmt: skip
    assert state in states_of(told, food)
    assert "chopped" not in states_of(told, food)


def test_a_salad_of_baked_potatoes_by_name_is_dressed_like_any(steps):
    told = steps("salad", "Loaded Baked Potato Salad", "potatoes:whole", "bacon:raw", "sour cream:creamy",
                 "cheddar:shredded")  # fmt: skip
    assert {"potatoes", "sour cream"} <= taking(told, "mix")


def test_what_is_roasted_for_a_salsa_is_blended(steps):
    told = steps("sauce", "Roasted Tomatillo Salsa", "tomatillos:whole", "jalapeno:whole", "onion:whole",
                 "cilantro:leaf")  # fmt: skip
    assert motions(told).index("bake") < motions(told).index("blend")


def test_what_is_fried_in_meal_is_seasoned_with_the_meal(steps):
    told = steps("vegetables", "Fried Okra", "okra:whole", "cornmeal:ground", "buttermilk:liquid", "egg:uncooked",
                 "cayenne:ground", "oil:liquid", "salt:granulated")  # fmt: skip
    assert {"cornmeal", "cayenne", "salt"} <= inside(told, "mix")


def test_mince_of_a_taco_salad_is_seasoned_in_the_pan(steps):
    told = steps("salad", "Taco Salad", "ground beef:raw", "taco seasoning:mixed", "iceberg lettuce:chopped",
                 "tomatoes:diced", "cheddar:shredded")  # fmt: skip
    assert {"ground beef", "taco seasoning"} <= taking(told, "cook and stir")


def test_bread_is_served_with_eggs_that_set_in_a_sauce(steps):
    told = steps("omelette", "Eggs in Purgatory", "olive oil:liquid", "onion:diced", "tomatoes:canned", "eggs:uncooked",
                 "bread:loaf")  # fmt: skip
    assert "bread" not in taking(told, "simmer") | taking(told, "cook")


def test_artichokes_are_stuffed_whole(steps):
    told = steps("vegetables", "Stuffed Artichokes", "artichokes:whole", "breadcrumbs:crumbs", "Parmesan:grated",
                 "garlic:minced", "olive oil:liquid")  # fmt: skip
    assert "artichokes" in taking(told, "bake")
    assert "artichokes" not in taking(told, "dice") | taking(told, "mix")


@pytest.mark.parametrize("bread", [(), ("naan:plain",), ("buns:whole",)])
def test_meal_that_binds_patties_is_mixed_into_them(steps, bread):
    told = steps("burger", "Chapli Burgers", "beef mince:raw", "onion:finely chopped", "maize flour:powder",
                 "egg:uncooked", "ghee:creamy", *bread)  # fmt: skip
    assert {"maize flour", "beef mince"} <= inside(told, "mix")


def test_nuts_for_the_sauce_of_a_salan_are_toasted_and_ground(steps):
    told = steps("vegetables", "Bagara Baingan", "eggplants:whole", "peanuts:dried", "sesame seeds:seed",
                 "desiccated coconut:flakes", "onion:chopped", "cumin seeds:whole", "tamarind pulp:paste",
                 "oil:liquid")  # fmt: skip
    assert first(told, "peanuts", "blend") < motions(told).index("simmer")


def test_herring_cut_small_is_cured_and_the_leaves_of_a_turnip_are_greens():
    foods = tables().foods
    assert foods.food("herring", ["diced"]).is_a("ready fish")
    assert not foods.food("herring", ["raw"]).is_a("ready fish")
    assert foods.food("turnip", ["leaves"]).kind == "cooking green"


def test_flour_in_the_dressing_of_a_salad_is_cooked(steps):
    told = steps("salad", "Frog Eye Salad", "acini di pepe pasta:cooked", "mandarin oranges:drained",
                 "sugar:granulated", "flour:powder", "egg yolk:uncooked", "whipped topping:thawed")  # fmt: skip
    assert "flour" in inside(told, "whisk")
    assert motions(told).index("whisk") < motions(told).index("cook and stir")


def test_pickled_eggs_are_boiled_and_lie_in_their_brine(steps):
    told = steps("omelette", "Pickled Eggs with Beets", "eggs:uncooked", "beets:canned", "vinegar:liquid",
                 "sugar:granulated")  # fmt: skip
    assert "eggs" in taking(told, "boil")
    assert "beat" not in motions(told)


def test_rings_in_a_batter_lie_on_a_burger_that_is_called_after_them(steps):
    told = steps("burger", "Onion Ring Burger", "ground beef:raw", "onion:sliced", "flour:powder", "beer:liquid",
                 "oil:liquid", "buns:whole")  # fmt: skip
    assert "onion" in taking(told, "dip")
    assert "beer" not in taking(told, "mix")


def test_the_avocado_of_a_guacamole_burger_is_mashed_with_its_lime(steps):
    told = steps("burger", "Guacamole Burgers", "ground beef:raw", "avocados:whole", "lime:juiced", "cilantro:chopped",
                 "buns:whole")  # fmt: skip
    assert {"avocados", "cilantro"} <= taking(told, "mash")


def test_fish_fingers_are_baked_for_their_sandwich(steps):
    told = steps("sandwich", "Fish Finger Sandwich", "fish fingers:frozen", "bread:sliced", "butter:softened",
                 "tartare sauce:creamy")  # fmt: skip
    assert "fish fingers" in taking(told, "bake")


def test_what_is_dipped_is_not_stirred_into_the_dip(steps):
    told = steps("sauce", "Blue Cheese Dip", "blue cheese:block", "sour cream:creamy", "mayonnaise:creamy",
                 "celery sticks:sticks")  # fmt: skip
    assert "celery sticks" not in taking(told, "mix") | taking(told, "pour and stir")


def test_the_meat_of_a_sauce_is_browned_before_it_simmers(steps):
    told = steps("sauce", "Bolognese Sauce", "ground beef:raw", "onion:chopped", "red wine:liquid", "tomatoes:canned")
    assert first(told, "ground beef", "cook and stir") < motions(told).index("simmer")
    assert "red wine" not in taking(told, "cook and stir")


def test_the_mayonnaise_that_a_title_promises_lies_in_the_roll_that_is_closed(steps):
    told = steps("burger", "Shrimp Burgers with Old Bay Mayo", "shrimp:peeled", "panko:crumbs", "egg:uncooked",
                 "mayonnaise:creamy", "Old Bay:ground", "buns:whole", "butter:unmelted")  # fmt: skip
    assert "buns" in told[-1][0]


def test_a_sauce_of_nut_butter_is_stirred_for_its_pizza(steps):
    told = steps("pizza", "Thai Chicken Pizza with Peanut Sauce", "pizza dough:whole", "peanut butter:creamy",
                 "soy sauce:liquid", "cooked chicken:shredded", "mozzarella:shredded")  # fmt: skip
    assert {"peanut butter", "soy sauce"} <= inside(told, "stir")


def test_the_only_eggs_of_a_loco_moco_are_fried(steps):
    told = steps("burger", "Loco Moco", "ground beef:raw", "white rice:uncooked", "eggs:uncooked", "beef broth:liquid",
                 "onion:sliced", "butter:unmelted")  # fmt: skip
    assert "eggs" in taking(told, "cook")


def test_herbs_of_fish_burgers_join_the_yogurt_where_there_is_one_and_else_the_patties(steps):
    asked = ["salmon fillets:raw", "panko:crumbs", "egg:raw", "dill:chopped", "buns:whole", "olive oil:liquid"]
    sauced = steps("burger", "Salmon Burgers with Dill Yogurt", *asked, "Greek yogurt:creamy")
    assert "dill" not in inside(sauced, "mix")
    assert inside(sauced, "stir") == {"Greek yogurt", "dill"}
    assert "dill" in inside(steps("burger", "Salmon Burgers", *asked), "mix")
