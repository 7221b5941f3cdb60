"""Where a dish is cooked, and where it is not: in the oven as its title says, and never while it lies in there."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

PAN = {"cook", "cook and stir", "flip", "simmer"}


@pytest.mark.parametrize(
    ("dish_type", "title", "asked"),
    [
        ("chicken", "Oven-Fried Drumsticks", ("chicken drumsticks:raw", "flour:powder", "paprika:ground",
                                              "butter:stick")),
        ("seafood", "Oven Fried Fish", ("cod fillets:raw", "flour:powder", "eggs:whole", "panko:crumbs")),
        ("meatball", "Baked Italian Meatballs", ("ground beef:raw", "eggs:whole", "breadcrumbs:crumbs",
                                                 "Parmesan:grated", "milk:liquid", "parsley:chopped")),
    ],
)  # fmt: skip
def test_what_is_baked_by_its_title_sees_no_pan(steps, dish_type, title, asked):
    told = steps(dish_type, title, *asked)
    assert PAN.isdisjoint(motions(told))
    assert {one.partition(":")[0] for one in asked} - {"panko", "butter", "eggs", "flour", "paprika"} <= inside(
        told, "bake"
    )


def test_flesh_that_is_not_called_so_is_still_fried(steps):
    told = steps("chicken", "Chicken Schnitzel", "chicken cutlets:raw", "flour:powder", "eggs:whole",
                 "breadcrumbs:crumbs", "oil:liquid")  # fmt: skip
    assert "flip" in motions(told)
    assert "bake" not in motions(told)


def test_nothing_is_laid_on_what_is_in_the_oven(steps):
    told = steps("pizza", "Cauliflower Crust Pizza", "cauliflower:whole", "egg:whole", "mozzarella:shredded",
                 "tomato sauce:sauce", "basil:leaf")  # fmt: skip
    done = motions(told)
    assert done.count("bake") == 2
    assert done.index("bake") < done.index("remove") < first(told, "tomato sauce", "pour")
    assert {"cauliflower", "egg"} == inside(told, "bake")


def test_flour_that_is_asked_cold_is_not_fried_before(steps):
    told = steps("vegetables", "Vegetable Tempura", "cake flour:chilled", "egg yolk:raw", "sparkling water:cold",
                 "zucchini:sliced", "vegetable oil:liquid")  # fmt: skip
    assert first(told, "cake flour", "pour") < motions(told).index("whisk") < motions(told).index("cook")


def test_layers_of_a_technique_are_not_stirred_at_last(steps):
    told = steps("pudding", "Dirt Pudding", "oreos:whole", "cream cheese:block", "instant pudding:powder",
                 "milk:liquid", "whipped topping:whipped")  # fmt: skip
    last = [motion for inputs, motion, _ in told if "oreos" in inputs]
    assert not {"stir", "mix"} & set(last)
    assert motions(told)[-2:] == ["chill", "remove"]


def test_starch_and_cream_for_a_topping_are_cooked(steps):
    told = steps("rice", "Mango Sticky Rice", "glutinous rice:uncooked", "coconut milk:liquid", "sugar:granulated",
                 "mangoes:sliced", "coconut cream:liquid:topping", "cornstarch:powder:topping")  # fmt: skip
    hot = [{food for node in outputs for food in node.ingredients} for _, motion, outputs in told if motion in PAN]
    assert any({"cornstarch", "coconut cream"} <= foods for foods in hot)


def test_egg_and_milk_for_a_topping_set_on_it_in_the_oven(steps):
    told = steps("meatloaf", "Bobotie", "ground beef:raw", "onions:chopped", "white bread:loaf", "curry powder:powder",
                 "eggs:whole:topping", "milk:liquid:topping")  # fmt: skip
    assert {"eggs", "milk"} <= inside(told, "bake")
    assert "boil" not in motions(told)


def test_dough_of_flour_and_water_is_rolled_out_for_any_noodle(steps):
    done = motions(steps("noodle", "Udon from Scratch", "flour:powder", "salt:granulated", "water:liquid"))
    assert done.index("knead") < done.index("roll") < done.index("cut") < len(done) - 1 - done[::-1].index("boil")


def test_dates_are_softened_in_boiling_water_before_a_batter(steps):
    told = steps("pudding", "Date Pudding", "dates:chopped", "water:boiling", "baking soda:powder", "sugar:granulated",
                 "egg:whole", "flour:powder")  # fmt: skip
    assert {"dates", "baking soda"} <= inside(told, "stir")
    assert "egg" not in inside(told, "stir")


def test_bought_dough_lies_there_before_its_filling(steps):
    told = steps("pizza", "Stromboli", "bread dough:raw", "salami:sliced", "mozzarella:shredded", "egg:whole")
    assert first(told, "bread dough", "pick-and-place") < first(told, "filling", "scoop and pour")
    assert {"egg"} == inside(told, "beat")
    assert motions(told).index("brush") < motions(told).index("bake")


def test_what_is_rolled_up_is_not_strewn_with_its_filling(steps):
    told = steps("bread", "Cinnamon Rolls", "flour:powder", "yeast:powder", "milk:warm", "butter:unmelted",
                 "sugar:granulated", "brown sugar:granulated", "cinnamon:ground", "butter:softened",
                 "powdered sugar:powder", "cream cheese:block")  # fmt: skip
    assert first(told, "cinnamon", "sprinkle") < max(place for place, one in enumerate(motions(told)) if one == "roll")


def test_beaten_whites_are_folded_into_a_pudding_that_is_baked(steps):
    told = steps("pudding", "Lemon Delicious Pudding", "eggs:separated", "sugar:granulated", "flour:powder",
                 "milk:liquid", "lemons:whole")  # fmt: skip
    done = motions(told)
    assert done.index("fold") < done.index("bake")
    assert first(told, "lemons", "squeeze") < done.index("fold")


@pytest.mark.parametrize(
    ("title", "asked"),
    [
        (
            "Roast Chicken with Lemon",
            ("chicken:whole", "butter:softened", "lemon:whole", "garlic:clove", "salt:granulated"),
        ),
        ("Herb Roasted Turkey", ("turkey:raw", "butter:softened", "sage:sprig", "onion:whole")),
        ("Sunday Leg of Lamb", ("leg of lamb:raw", "garlic:minced", "rosemary:chopped", "olive oil:liquid")),
    ],
)
def test_a_bird_or_joint_is_roasted_in_one_piece(steps, title, asked):
    told = steps("roast", title, *asked)
    main = asked[0].partition(":")[0]
    assert PAN.isdisjoint(motions(told))
    assert {one.partition(":")[0] for one in asked} <= inside(told, "bake")
    assert not any(main in inputs for inputs, motion, _ in told if motion in {"cut", "chop", "mix", "stir"})


def test_a_pot_roast_is_simmered(steps):
    told = steps("roast", "Pot Roast", "chuck roast:raw", "carrots:whole", "potatoes:whole", "beef broth:liquid")
    assert "simmer" in motions(told)
    assert "bake" not in motions(told)


def test_a_batter_that_set_in_boiling_water_is_drained(steps):
    told = steps("noodle", "Spaetzle", "flour:powder", "eggs:whole", "milk:liquid", "nutmeg:ground", "butter:unmelted")
    drained = next(outputs for _, _, outputs in told if any(node.label == "strainer" for node in outputs))
    assert {"flour", "eggs", "milk"} <= {food for node in drained for food in node.ingredients}
