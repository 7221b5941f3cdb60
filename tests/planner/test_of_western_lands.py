"""Families of Europe and the Americas: fish that is not stirred, stews bound at last, puddings under beaten whites."""

from __future__ import annotations

import pytest
from planner.told_steps import first, inside, motions

pytestmark = pytest.mark.shared_data


def test_nobody_stirs_fish_once_it_is_in_a_stew(steps):
    told = steps("soup", "Cullen Skink", "smoked haddock:raw", "butter:unmelted", "onion:chopped", "potatoes:cubed",
                 "milk:liquid", "double cream:creamy", "chives:chopped")  # fmt: skip
    fish = first(told, "smoked haddock", "simmer")
    assert not any("stir" in motion for _, motion, _ in told[fish:])


def test_flour_for_dusting_is_on_the_flesh_before_that_is_fried(steps):
    told = steps("chicken", "Coq au Vin", "chicken:uncooked", "flour:powder:dusting", "lardons:raw", "shallots:peeled",
                 "red wine:liquid", "chicken stock:liquid", "butter:unmelted")  # fmt: skip
    assert first(told, "flour", "cook and stir") < first(told, "red wine", "simmer")


def test_what_was_braised_in_milk_is_poured_with_its_sauce(steps):
    told = steps("pork", "Pork Braised in Milk", "pork loin:boned", "butter:unmelted", "milk:liquid", "garlic:halved",
                 "sage leaves:sprig", "salt:granulated")  # fmt: skip
    *_, (inputs, motion, _) = told
    assert motion == "pour"
    assert "turner" not in inputs


def test_fried_fish_lies_under_what_was_stewed_in_vinegar(steps):
    told = steps("seafood", "Escovitch Fish", "snappers:whole", "oil:liquid", "onion:sliced", "carrot:sliced",
                 "vinegar:liquid", "sugar:granulated")  # fmt: skip
    assert inside(told, "cook and stir") >= {"onion"}
    assert not any("snappers" in inputs and "vinegar" in inputs and motion == "cook" for inputs, motion, _ in told)


@pytest.mark.parametrize(
    ("dish_type", "title", "flesh"),
    [("chicken", "Pollo en Pepitoria", "chicken thighs"), ("seafood", "Suquet de Peix", "monkfish")],
)
def test_a_paste_of_nuts_and_bread_comes_to_a_stew_at_last(steps, dish_type, title, flesh):
    told = steps(dish_type, title, f"{flesh}:raw", "onion:chopped", "olive oil:liquid", "fish stock:liquid",
                 "almonds:whole", "garlic:clove", "bread:loaf")  # fmt: skip
    assert inside(told, "blend") >= {"almonds", "garlic", "bread"}
    assert first(told, flesh, "simmer" if dish_type == "seafood" else "cook and stir") > motions(told).index("blend")


def test_seeds_and_chillies_are_ground_and_roots_are_not(steps):
    told = steps("chicken", "Pepián de Pollo", "chicken:cut", "water:liquid", "pumpkin seeds:seed",
                 "guajillo chiles:seeded", "roma tomatoes:whole", "garlic:clove", "potatoes:cubed")  # fmt: skip
    ground = {food for _, motion, outputs in told if motion == "blend" for node in outputs for food in node.ingredients}
    assert ground >= {"pumpkin seeds", "guajillo chiles", "roma tomatoes"}
    assert ground.isdisjoint({"potatoes", "chicken"})


def test_a_pudding_of_crumbs_is_baked_before_jam_and_beaten_whites_come(steps):
    told = steps("pudding", "Queen of Puddings", "milk:liquid", "butter:unmelted", "caster sugar:granulated",
                 "eggs:separated", "white breadcrumbs:fresh", "raspberry jam:jelly",
                 "caster sugar:granulated")  # fmt: skip
    assert motions(told).count("bake") == 2
    assert "raspberry jam" not in inside(told, "bake")


def test_bread_without_eggs_is_baked_in_the_syrup_that_is_poured_over_it(steps):
    told = steps("pudding", "Capirotada", "bolillo rolls:toasted", "piloncillo:chopped", "water:liquid",
                 "raisins:whole", "queso fresco:crumbled")  # fmt: skip
    assert inside(told, "bake") >= {"bolillo rolls", "piloncillo", "queso fresco"}
    assert "queso fresco" not in inside(told, "cook and stir")


@pytest.mark.parametrize("title", ["Schupfnudeln", "Mohnnudeln"])
def test_noodles_of_mash_are_shaped_and_boiled(steps, title):
    told = steps("noodle", title, "floury potatoes:boiled, mashed", "flour:powder", "egg:uncooked", "salt:granulated",
                 "butter:unmelted")  # fmt: skip
    assert motions(told).index("knead") < motions(told).index("shape") < len(told) - motions(told)[::-1].index("boil")


def test_porchetta_is_rolled_around_its_herbs(steps):
    told = steps("roast", "Porchetta", "pork belly:raw", "fennel seeds:toasted", "garlic:crushed",
                 "rosemary:chopped", "olive oil:liquid", "salt:granulated")  # fmt: skip
    assert motions(told).index("roll") < motions(told).index("bake")


def test_lettuce_is_stewed_with_the_peas(steps):
    told = steps("vegetables", "Petits Pois à la Française", "butter:unmelted", "bacon lardons:smoked",
                 "little gem lettuces:shredded", "peas:shelled", "chicken stock:liquid", "cream:creamy")  # fmt: skip
    assert first(told, "little gem lettuces", "simmer") == first(told, "peas", "simmer")


def test_a_leaf_that_gave_its_taste_is_not_mashed(steps):
    told = steps("seafood", "Fishcakes", "potatoes:mashed", "haddock:raw", "bay leaf:sprig", "milk:liquid",
                 "flour:powder", "egg:beaten", "breadcrumbs:crumbs", "oil:liquid")  # fmt: skip
    assert all("bay leaf" not in node.ingredients for _, motion, outputs in told if motion == "shape"
               for node in outputs)  # fmt: skip


def test_slices_fried_as_they_are_lie_under_their_sauce(steps):
    told = steps("casserole", "Melanzane alla Parmigiana", "aubergines:sliced", "olive oil:liquid", "salt:granulated",
                 "onion:chopped", "tomatoes:canned", "mozzarella:sliced", "Parmesan:grated")  # fmt: skip
    assert first(told, "aubergines", "flip") < motions(told).index("bake")
    assert not any({"aubergines", "tomatoes"} <= inputs and motion == "mix" for inputs, motion, _ in told)
