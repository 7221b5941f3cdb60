"""What has to be cooked, stirred or kept apart for it to be that dish: sauces, soups, white sauces, beaten whites."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data

HEATS = {"bake", "boil", "cook", "cook and stir", "simmer"}


def vessels(told):
    """Every label of the dish's own vessels."""
    return {node.container for _, _, outputs in told for node in outputs if node.container}


def test_a_sauce_of_raw_roots_and_tomatoes_is_fried_and_simmered(steps):
    told = steps("sauce", "Sauce of the House", "olive oil:liquid", "onion:finely chopped", "garlic:sliced",
                 "tomatoes:crushed", "oregano:dried", "basil leaves:torn", "salt:granulated")  # fmt: skip
    assert first(told, "onion", "cook and stir") < first(told, "tomatoes", "pour") < motions(told).index("simmer")
    assert {"onion", "tomatoes", "oregano"} <= inside(told, "simmer")
    assert "basil leaves" not in inside(told, "simmer")


def test_a_sauce_of_what_is_sour_and_sweet_is_simmered(steps):
    told = steps("sauce", "Kansas City Sauce", "ketchup:sauce", "apple cider vinegar:liquid",
                 "dark brown sugar:granulated", "garlic powder:ground", "paprika:smoked")  # fmt: skip
    assert {"ketchup", "apple cider vinegar", "dark brown sugar"} <= inside(told, "simmer")


@pytest.mark.parametrize(
    ("title", "asked"),
    [
        ("Tomato Salsa", ("tomatoes:chopped", "onion:chopped", "cilantro:chopped", "lime juice:juice")),
        ("Honey Dressing", ("vinegar:liquid", "honey:thick liquid", "ketchup:sauce", "oil:liquid")),
        ("Chimichurri Sauce", ("parsley:chopped", "garlic:minced", "vinegar:liquid", "oil:liquid", "onion:minced")),
        ("Cocktail Sauce", ("ketchup:sauce", "horseradish:grated", "lemon juice:juice", "sugar:granulated")),
    ],
)
def test_a_sauce_that_is_eaten_raw_stays_raw(steps, title, asked):
    assert HEATS.isdisjoint(motions(steps("sauce", title, *asked)))


def test_a_soup_that_is_called_like_a_baked_dish_is_cooked_in_a_pot(steps):
    told = steps("soup", "Loaded Baked Potato Soup", "bacon:chopped", "onion:diced", "garlic:minced", "flour:powder",
                 "chicken stock:liquid", "russet potatoes:cubed", "milk:liquid", "sour cream:creamy",
                 "cheddar cheese:shredded", "green onions:sliced", "salt:granulated")  # fmt: skip
    assert "bake" not in motions(told)
    assert "pot" in vessels(told)
    assert told[-1][2][0].container != "plate"


def test_flour_in_a_casserole_is_stirred_into_fat_before_milk_comes_to_it(steps):
    told = steps("casserole", "Chicken and Rice Bake", "cooked chicken:cubed", "white rice:cooked",
                 "broccoli florets:floret", "butter:unmelted", "onion:chopped", "flour:powder", "milk:liquid",
                 "chicken broth:liquid", "cheddar:grated", "panko:crumbs")  # fmt: skip
    assert first(told, "flour", "cook and stir") < first(told, "milk", "pour")
    assert {"milk", "flour"} <= inside(told, "mix")


def test_bread_in_meatballs_is_torn_and_soaked_and_flour_whisked_for_their_sauce(steps):
    told = steps("meatball", "Swedish Meatballs", "white bread:loaf", "milk:liquid", "butter:unmelted", "onion:chopped",
                 "ground beef:raw", "egg yolks:uncooked", "flour:powder", "beef broth:liquid",
                 "heavy cream:creamy")  # fmt: skip
    assert {"white bread", "milk", "ground beef"} <= inside(told, "shape")
    bread = [node for _, _, outputs in told for node in outputs if node.label == "white bread"]
    assert "torn" in bread[0].states
    assert {"flour", "beef broth"} == inside(told, "stir")
    assert "heavy cream" not in inside(told, "shape")
    assert first(told, "flour", "stir") < motions(told).index("simmer")


def test_bread_is_served_beside_what_is_cooked_in_a_pan(steps):
    told = steps("seafood", "Garlic Butter Shrimp Scampi", "shrimp:deveined", "butter:unmelted", "olive oil:liquid",
                 "garlic:minced", "white wine:dry", "lemon juice:juice", "parsley:chopped",
                 "crusty bread:loaf")  # fmt: skip
    comes = [place for place, (inputs, _, _) in enumerate(told) if "crusty bread" in inputs]
    off = len(told) - 1 - motions(told)[::-1].index("turn off")
    assert first(told, "crusty bread", "slice") < off < comes[-1]
    assert not [motion for inputs, motion, _ in told if "crusty bread" in inputs and motion in HEATS]


def test_a_filling_under_a_meringue_is_stirred_smooth_before_it_is_cooked(steps):
    told = steps("pie", "Lemon Meringue Pie", "pie crust:raw", "sugar:granulated", "cornstarch:powder",
                 "water:liquid", "eggs:uncooked", "lemon juice:fresh", "butter:unmelted")  # fmt: skip
    assert first(told, "cornstarch", "whisk") < motions(told).index("cook and stir")
    assert "cornstarch" in inside(told, "cook and stir")


def test_nuts_and_seeds_of_a_milk_are_ground_in_it_and_strained(steps):
    told = steps("drinks", "Thandai", "almonds:blanched", "poppy seeds:seed", "fennel seeds:whole", "milk:cold",
                 "sugar:granulated")  # fmt: skip
    assert {"almonds", "fennel seeds", "milk"} <= inside(told, "blend")
    assert motions(told).index("blend") < motions(told).index("pour and strain")


def test_the_sauce_of_a_bread_pudding_is_cooked_by_itself(steps):
    told = steps("pudding", "Bread Pudding with Vanilla Sauce", "day-old bread:torn", "butter:melted", "raisins:whole",
                 "eggs:beaten", "milk:liquid", "sugar:granulated", "vanilla extract:liquid", "heavy cream:creamy",
                 "brown sugar:granulated", "flour:powder")  # fmt: skip
    smooth = [inputs for inputs, motion, _ in told if motion in {"beat", "whisk"} and "flour" in inputs]
    assert smooth[0] >= {"flour", "heavy cream", "brown sugar", "saucepan"}
    assert {"flour", "vanilla extract"} <= inside(told, "cook and stir")
    assert {"eggs", "milk", "day-old bread"} <= inside(told, "bake")
    assert "flour" not in inside(told, "bake")
    assert any("flour" in node.ingredients for node in told[-1][2])


def boils_or_bakes(told, *foods):
    """Whether one step bakes, boils or cooks all of these foods together."""
    hot = [outputs for _, motion, outputs in told if motion in HEATS]
    return any(set(foods) <= {food for node in outputs for food in node.ingredients} for outputs in hot)


@pytest.mark.parametrize(
    ("title", "asked"),
    [
        ("Sticky Toffee Pudding", ("dates:chopped", "baking soda:powder", "water:boiling", "butter:softened",
                                   "brown sugar:granulated", "eggs:whole", "self-raising flour:powder")),
        ("Chocolate Pudding with its Sauce", ("self-raising flour:powder", "cocoa powder:powder", "sugar:granulated",
                                              "milk:liquid", "butter:melted", "egg:whole")),
        ("Ginger Pudding of the House", ("flour:powder", "baking powder:powder", "butter:softened", "egg:whole",
                                         "sugar:granulated", "milk:liquid", "ginger:ground")),
    ],
)  # fmt: skip
def test_a_pudding_that_rises_is_baked(steps, title, asked):
    told = steps("pudding", title, *asked)
    flour = next(one.partition(":")[0] for one in asked if "flour" in one)
    assert boils_or_bakes(told, flour, "butter")
    assert "bake" in motions(told)
    assert "cook and stir" not in motions(told)


def test_a_pudding_under_cocoa_gets_its_hot_water_last(steps):
    told = steps("pudding", "Self-Saucing Chocolate Pudding", "self-raising flour:powder", "cocoa powder:powder",
                 "sugar:granulated", "milk:liquid", "egg:whole", "brown sugar:granulated", "water:hot")  # fmt: skip
    done = motions(told)
    assert first(told, "self-raising flour", "pour") < first(told, "brown sugar", "pour") < first(told, "water", "pour")
    assert done.index("bake") > first(told, "water", "pour")


def test_a_video_without_the_foods_of_a_dish_does_not_teach_it(steps):
    told = steps("pudding", "Banana Pudding", "sugar:granulated", "flour:powder", "egg yolks:raw", "milk:liquid",
                 "vanilla wafers:whole", "bananas:sliced")  # fmt: skip
    assert boils_or_bakes(told, "flour", "egg yolks", "milk")
    told = steps("noodle", "Homemade Egg Noodles", "flour:powder", "eggs:whole", "salt:granulated", "butter:unmelted")
    done = motions(told)
    assert (
        done.index("knead")
        < done.index("roll")
        < done.index("cut")
        < max(place for place, motion in enumerate(done) if motion == "boil")
    )


def test_whites_are_beaten_over_a_filling_on_dough_of_flour(steps):
    told = steps("pie", "Lemon Meringue Pie", "flour:powder:crust", "butter:cold:crust", "ice water:liquid:crust",
                 "sugar:granulated:filling", "cornstarch:powder:filling", "water:liquid:filling",
                 "egg yolks:raw:filling", "lemons:whole:filling", "egg whites:raw:meringue",
                 "sugar:granulated:meringue")  # fmt: skip
    done = motions(told)
    assert done.index("roll") < done.index("bake") < len(done) - 1 - done[::-1].index("bake")
    assert first(told, "lemons", "squeeze") < done.index("cook and stir")
    assert boils_or_bakes(told, "egg yolks", "cornstarch", "sugar")


def test_a_pie_on_crumbs_is_chilled_where_nothing_in_it_is_raw(steps):
    told = steps("pie", "Peanut Butter Pie", "oreo crust:whole", "cream cheese:block", "peanut butter:creamy",
                 "powdered sugar:powder")  # fmt: skip
    assert "chill" in motions(told)
    assert "bake" not in motions(told)


def test_cold_noodles_are_boiled_rinsed_and_not_heated_again(steps):
    for title in ("Chilled Soba Noodles", "Cold Noodles with Soy Sauce"):
        told = steps("noodle", title, "soba noodles:uncooked", "soy sauce:liquid", "mirin:liquid", "scallions:sliced")
        done = motions(told)
        assert done.index("boil") < done.index("rinse")
        assert HEATS.isdisjoint(done[done.index("rinse") :])


def test_a_spread_of_boiled_eggs_is_not_fried(steps):
    told = steps("sandwich", "Egg Salad Sandwiches", "hard-boiled eggs:chopped", "mayonnaise:creamy",
                 "mustard:creamy", "celery:diced", "white bread:loaf")  # fmt: skip
    assert HEATS.isdisjoint(motions(told))
    assert first(told, "hard-boiled eggs", "peel") < first(told, "hard-boiled eggs", "chop")


def test_cookies_that_nobody_bakes_are_cooked_and_set(steps):
    told = steps("cookie", "No-Bake Peanut Butter Cookies", "sugar:granulated", "milk:liquid", "butter:unmelted",
                 "cocoa powder:powder", "peanut butter:creamy", "oats:rolled")  # fmt: skip
    assert motions(told).index("cook and stir") < motions(told).index("chill")
    assert boils_or_bakes(told, "sugar", "milk", "cocoa powder")


def test_cream_of_starch_is_cooked_and_its_crust_baked_before(steps):
    told = steps("pie", "Coconut Cream Pie", "pie crust:raw", "sugar:granulated", "flour:powder", "milk:liquid",
                 "egg yolks:raw", "coconut:shredded", "whipped cream:creamy")  # fmt: skip
    assert boils_or_bakes(told, "flour", "milk", "egg yolks")
    assert (
        first(told, "pie crust", "bake")
        < motions(told).index("chill")
        < first(told, "whipped cream", motions(told)[-1])
    )


def test_a_fruit_pie_of_two_crusts_is_closed_and_brushed(steps):
    told = steps("pie", "Apple Pie", "pie crusts:raw", "apples:sliced", "sugar:granulated", "egg:whole", "milk:liquid")
    done = motions(told)
    on = [
        number
        for number, (inputs, motion, _) in enumerate(told)
        if motion == "pick-and-place" and "pie crusts" in inputs
    ]
    assert len(on) == 2
    assert on[0] < next(number for number, one in enumerate(told) if number > on[0] and one[1] == "pour") < on[1]
    assert {"egg", "milk"} == inside(told, "beat")
    assert on[1] < done.index("brush") < done.index("bake")


def test_soft_milk_comes_to_a_cold_soup_when_it_is_cold(steps):
    told = steps("soup", "Cold Pea Soup", "peas:frozen", "onion:chopped", "vegetable broth:liquid", "yogurt:creamy")
    done = motions(told)
    assert done.index("blend") < done.index("cool down") < first(told, "yogurt", "scoop and pour") < done.index("chill")
    told = steps(
        "soup", "Cold Borscht", "beets:whole", "cucumber:diced", "buttermilk:liquid", "hard-boiled eggs:hardboiled"
    )
    assert "beets" in {food for inputs, motion, _ in told if motion == "cook" for food in inputs}
    assert "buttermilk" not in {food for inputs, motion, _ in told if motion in HEATS for food in inputs}


def test_what_a_title_says_is_not_there_does_not_name_the_dish(steps):
    told = steps("cake", "Wacky Cake (No Eggs)", "flour:powder", "sugar:granulated", "cocoa powder:powder",
                 "baking soda:powder", "vinegar:liquid", "oil:liquid", "water:cold")  # fmt: skip
    assert "bake" in motions(told)


def test_a_sandwich_is_dipped_in_egg_and_fried_where_it_is_called_so(steps):
    told = steps("sandwich", "Monte Cristo", "white bread:loaf", "Swiss cheese:block", "deli ham:processed meat",
                 "eggs:whole", "milk:liquid", "butter:unmelted")  # fmt: skip
    assert "boil" not in motions(told)
    assert motions(told).index("dip") < motions(told).index("flip")


def test_noodles_of_a_slaw_are_not_stewed_with_it(steps):
    told = steps("salad", "Ramen Noodle Slaw", "ramen noodles:uncooked", "coleslaw mix:shredded", "oil:liquid",
                 "vinegar:liquid", "sugar:granulated")  # fmt: skip
    hot = {food for inputs, motion, _ in told if motion in HEATS for food in inputs}
    assert "ramen noodles" in hot
    assert "coleslaw mix" not in hot


def test_foods_that_no_stage_of_a_told_part_names_join_beside_what_is_listed_nearest(steps):
    told = steps("pasta", "Lasagna", "ground beef:raw:sauce", "marinara:sauce:sauce", "ricotta:creamy:filling",
                 "egg:whole:filling", "parsley:chopped:filling", "salt:granulated:filling",
                 "lasagna noodles:uncooked", "mozzarella:shredded")  # fmt: skip
    assert {"ricotta", "egg", "parsley"} <= inside(told, "mix")
    assert {"salt", "lasagna noodles", "mozzarella"} <= inside(told, "bake")


def test_a_loaf_that_is_filled_with_a_salad_stays_bread(steps):
    told = steps("sandwich", "Chicken Salad Croissants", "cooked chicken:chopped", "mayonnaise:creamy",
                 "pecans:chopped", "croissants:whole")  # fmt: skip
    assert not any("croissants" in inputs for inputs, motion, _ in told if motion in {"mix", "stir"})


def test_what_is_eaten_raw_by_nobody_and_asked_chilled_is_not_cooked_for_that(steps):
    told = steps(
        "vegetables", "Vegetable Tempura", "cake flour:chilled", "egg yolk:uncooked", "sparkling water:cold",
        "zucchini:sliced", "vegetable oil:liquid",
    )  # fmt: skip
    heated = [inputs for inputs, motion, _ in told if motion in {"cook", "heat", "boil"}]
    assert not [inputs for inputs in heated if "cake flour" in inputs]
