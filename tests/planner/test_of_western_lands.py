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
    assert not any({"snappers", "vinegar"} <= inputs for inputs, _, _ in told)


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
    shaped = {food for _, motion, outputs in told if motion == "shape" for node in outputs for food in node.ingredients}
    assert "bay leaf" in inside(told, "simmer")
    assert shaped == {"haddock", "milk", "potatoes"}


def test_slices_fried_as_they_are_lie_under_their_sauce(steps):
    told = steps("casserole", "Melanzane alla Parmigiana", "aubergines:sliced", "olive oil:liquid", "salt:granulated",
                 "onion:chopped", "tomatoes:canned", "mozzarella:sliced", "Parmesan:grated")  # fmt: skip
    assert first(told, "aubergines", "flip") < motions(told).index("bake")
    assert not any({"aubergines", "tomatoes"} <= inputs and motion == "mix" for inputs, motion, _ in told)


@pytest.mark.parametrize("title", ["Pasta alla Genovese", "Beef Ragù with Ziti"])
def test_flesh_in_pieces_is_braised_before_the_pasta_boils(steps, title):
    told = steps("pasta", title, "ziti:uncooked", "beef chuck:cut", "onions:sliced", "carrot:chopped",
                 "olive oil:liquid", "tomatoes:canned", "white wine:liquid", "bay leaf:sprig",
                 "pecorino:grated")  # fmt: skip
    assert first(told, "beef chuck", "cook and stir") < first(told, "white wine", "simmer")
    assert first(told, "ziti", "pour") > first(told, "white wine", "simmer")


@pytest.mark.parametrize(("title", "food"), [("Torta Pasqualina", "ricotta"), ("Bacon and Egg Pie", "bacon")])
def test_whole_eggs_lie_on_the_filling_between_two_sheets(steps, title, food):
    told = steps("pie", title, "puff pastry:raw", f"{food}:raw", "eggs:uncooked", "onion:chopped", "olive oil:liquid",
                 "parsley:chopped")  # fmt: skip
    assert "eggs" not in inside(told, "mix")
    assert sum("puff pastry" in inputs and motion in {"put", "place", "pour", "pick-and-place"}
               for inputs, motion, _ in told) > 1  # fmt: skip


def test_crumbs_lie_on_the_syrup_of_a_shoofly_pie(steps):
    told = steps("pie", "Shoofly Pie", "unbaked pie crust:raw", "molasses:thick liquid", "water:hot",
                 "baking soda:powder", "flour:powder", "brown sugar:granulated", "shortening:creamy")  # fmt: skip
    assert "molasses" not in inside(told, "mix")
    assert inside(told, "bake") >= {"molasses", "flour"}


@pytest.mark.parametrize(("packed", "dish_type"), [("anchovy fillets in oil", "pizza"), ("sardines in oil", "pizza")])
def test_what_is_packed_in_oil_is_no_oil_for_dough(steps, packed, dish_type):
    told = steps(dish_type, "Pizza", "flour:powder", "yeast:dried", "water:warm", "olive oil:liquid",
                 "tomatoes:canned", f"{packed}:drained")  # fmt: skip
    assert packed not in inside(told, "knead")


def test_bread_asked_soaked_lies_in_water(steps):
    told = steps("meatball", "Boulets", "pork and beef:minced", "white bread:soaked", "onion:finely chopped",
                 "egg:uncooked", "butter:unmelted")  # fmt: skip
    assert first(told, "white bread", "soak") < first(told, "egg", "mix")


def test_a_fresh_ham_is_roasted_in_one_piece(steps):
    told = steps("roast", "Lechón Asado", "ham:fresh", "garlic:peeled", "cumin:ground", "sour orange juice:juice",
                 "olive oil:liquid", "onions:sliced", "salt:granulated")  # fmt: skip
    assert motions(told).index("chill") < motions(told).index("bake") < first(told, "ham", "slice")


def test_tuna_in_pieces_comes_fresh_to_a_stew(steps):
    told = steps("seafood", "Marmitako", "bonito tuna:cut", "potatoes:broken", "onion:chopped", "fish stock:liquid",
                 "olive oil:liquid")  # fmt: skip
    assert first(told, "bonito tuna", "simmer") > first(told, "potatoes", "simmer")


@pytest.mark.parametrize(("dish_type", "title", "motion", "asked"), [
    ("sauce", "Skordalia", "blend", ["floury potatoes:cut", "garlic:crushed", "almonds:ground", "olive oil:liquid",
                                     "white wine vinegar:liquid"]),
    ("cake", "Torta Caprese", "fold", ["dark chocolate:chopped", "butter:stick", "almonds:ground",
                                       "caster sugar:granulated", "eggs:separated"]),
])  # fmt: skip
def test_ground_nuts_may_be_raw_and_a_cake_of_capri_needs_no_tomato(steps, dish_type, title, motion, asked):
    assert "almonds" in inside(steps(dish_type, title, *asked), motion)


def test_mayonnaise_is_the_fat_of_a_batter_that_has_no_other(steps):
    told = steps("cake", "", "flour:ground", "cocoa:ground", "baking soda:ground", "sugar:ground",
                 "mayonnaise:creamy", "water:juice", "icing:creamy")  # fmt: skip
    assert first(told, "mayonnaise", "beat") < motions(told).index("bake")
    assert "icing" not in inside(told, "bake")


def test_boiled_roots_are_cut_for_a_salad_and_no_cob_is_mixed_into_it(steps):
    told = steps("salad", "Vinegret", "beetroot:boiled, diced", "potatoes:boiled, diced", "corn:cooked",
                 "red onion:finely chopped", "sunflower oil:liquid")  # fmt: skip
    assert first(told, "beetroot", "cook") < first(told, "beetroot", "dice")
    assert "corn" in inside(told, "mix")
    assert not any("corn" in inputs and motion in {"peel", "husk"} for inputs, motion, _ in told)


def test_no_bare_hand_peels_a_tomato(steps):
    told = steps("soup", "Fish Soup", "fish:cut", "tomato:peeled", "onion:chopped", "fish stock:liquid",
                 "olive oil:liquid")  # fmt: skip
    peeled = [inputs for inputs, motion, _ in told if motion == "peel" and "tomato" in inputs]
    assert peeled
    assert all("knife" in inputs for inputs in peeled)


@pytest.mark.parametrize(("dish_type", "title", "asked"), [
    ("beef", "Birria de Res", ["beef chuck:cut", "guajillo chiles:dried", "ancho chiles:dried", "tomatoes:whole",
                               "garlic:clove", "beef stock:liquid", "corn tortillas:plain:serving"]),
    ("seafood", "Marmitako", ["tuna:cut", "potatoes:cut",
                               "onion:chopped", "choricero peppers:soaked", "tomatoes:grated",
                              "fish stock:liquid", "olive oil:liquid"]),
    ("chicken", "Tinga de Pollo", ["chicken breasts:raw", "chipotle chiles in adobo:whole", "tomatoes:whole",
                                   "onion:sliced", "oil:liquid"]),
])  # fmt: skip
def test_chillies_of_a_sauce_are_blended_before_it_is_simmered(steps, dish_type, title, asked):
    told = steps(dish_type, title, *asked)
    ground = inside(told, "blend")
    assert any("chile" in food or "choricero" in food for food in ground)
    assert any("tomato" in food for food in ground)
    assert motions(told).index("blend") < motions(told).index("simmer")


@pytest.mark.parametrize(("dish_type", "title", "heated"), [("seafood", "Bacalhau à Brás", True),
                                                            ("salad", "Esqueixada", False)])  # fmt: skip
def test_salt_fish_lies_in_water_first(steps, dish_type, title, heated):
    told = steps(dish_type, title, "salt cod:raw", "onion:sliced", "olive oil:liquid", "black olives:whole")
    assert first(told, "salt cod", "soak") < first(told, "salt cod", "drain")
    assert any("salt cod" in inputs and motion.startswith("cook") for inputs, motion, _ in told) == heated


def test_a_topping_of_nuts_and_caramel_is_cooked_and_baked_on(steps):
    told = steps("cake", "Toscakaka", "eggs:raw", "caster sugar:granulated", "flour:powder", "baking powder:powder",
                 "butter:melted", "milk:liquid", "almonds:flaked:topping", "butter:stick:topping",
                 "brown sugar:granulated:topping", "milk:liquid:topping")  # fmt: skip
    assert motions(told).count("bake") == 2
    assert inside(told, "cook and stir") >= {"almonds", "brown sugar"}
    assert "almonds" not in inside(told, "bake")


def test_chocolate_melts_with_butter_for_a_cake_raised_by_whites(steps):
    told = steps("cake", "Torta Tenerina", "dark chocolate:bar", "butter:stick", "caster sugar:granulated",
                 "eggs:separated", "flour:powder")  # fmt: skip
    assert inside(told, "melt") == {"dark chocolate", "butter"}


@pytest.mark.parametrize("egg", ["hard-boiled eggs:sliced:topping", "eggs:raw:topping"])
def test_eggs_of_a_topping_lie_on_the_pizza(steps, egg):
    told = steps("pizza", "Pizza Portuguesa", "flour:powder:dough", "yeast:powder:dough", "water:warm:dough",
                 "tomato sauce:sauce:topping", "mozzarella:grated:topping", egg)  # fmt: skip
    assert egg.split(":")[0] not in inside(told, "knead")
    assert egg.split(":")[0] in inside(told, "bake")


@pytest.mark.parametrize(("dish_type", "title", "asked"), [
    ("sauce", "Hollandaise Sauce", ["egg yolks:raw", "butter:melted", "lemon juice:juice", "salt:granulated"]),
    ("pudding", "Zabaglione", ["egg yolks:raw", "caster sugar:granulated", "marsala:liquid"]),
    ("drinks", "Advocaat", ["egg yolks:raw", "sugar:granulated", "brandy:liquid"]),
    ("pudding", "Dark Chocolate Mousse", ["dark chocolate:broken", "eggs:separated", "sugar:granulated"]),
])  # fmt: skip
def test_yolks_are_warmed_over_water_and_on_no_bare_flame(steps, dish_type, title, asked):
    told = steps(dish_type, title, *asked)
    vessels = {label for inputs, motion, _ in told if motion == "cook and stir" for label in inputs}
    assert "double boiler" in vessels


def test_smoked_bacon_is_still_fried(steps):
    told = steps("sandwich", "BLT Sandwich", "streaky bacon:smoked", "white bread:loaf", "mayonnaise:creamy",
                 "tomato:sliced", "lettuce:whole")  # fmt: skip
    assert first(told, "streaky bacon", "cook") < first(told, "mayonnaise", "spread")


def test_chips_that_are_served_are_baked_and_leaves_beside_them_are_not(steps):
    told = steps("steak", "Rump Steak with Garlic Butter", "rump steaks:raw", "olive oil:liquid", "butter:softened",
                 "garlic:crushed", "oven chips:frozen:serving", "watercress:leaves:serving")  # fmt: skip
    assert any("oven chips" in inputs and motion == "bake" for inputs, motion, _ in told)
    assert not any("watercress" in inputs and motion == "bake" for inputs, motion, _ in told)


def test_a_roll_is_closed_over_what_was_fried_for_it(steps):
    told = steps("burger", "Halloumi and Portobello Burgers", "portobello mushrooms:whole", "olive oil:liquid",
                 "halloumi:sliced", "ciabatta rolls:halved", "houmous:whole", "rocket:leaves")  # fmt: skip
    inputs, motion, outputs = told[-1]
    assert motion == "pick-and-place"  # the upper half: a cut roll is no flat bread that is folded
    assert {"ciabatta rolls", "halloumi", "portobello mushrooms"} <= inputs
    assert "burger" in {node.label for node in outputs}


def test_meat_dried_under_salt_lies_in_water_first(steps):
    told = steps("pork", "Feijoada", "black beans:soaked", "carne seca:cubed", "pork ribs:raw", "linguiça:sliced",
                 "onion:chopped", "garlic:minced", "bay leaves:sprig")  # fmt: skip
    assert first(told, "carne seca", "soak") < first(told, "carne seca", "dice")


@pytest.mark.parametrize(("title", "wet"), [("Patatas a la Riojana", "white wine:liquid"),
                                            ("Paprikás Krumpli", "water:liquid")])  # fmt: skip
def test_potatoes_are_stewed_in_what_is_listed_with_them(steps, title, wet):
    told = steps("potatoes", title, "potatoes:cubed", "onion:chopped", "chorizo:sliced", "sweet paprika:ground",
                 "olive oil:liquid", wet)  # fmt: skip
    assert "flip" not in motions(told)
    assert first(told, "onion", "cook and stir") < first(told, "potatoes", "simmer")


def test_boiled_potatoes_lie_under_their_sauce(steps):
    told = steps("potatoes", "Papas Chorreadas", "red potatoes:peeled", "butter:stick", "onion:chopped",
                 "tomatoes:chopped", "cream:creamy", "mozzarella:grated")  # fmt: skip
    assert "tomatoes" not in inside(told, "boil")
    assert first(told, "red potatoes", "boil") < first(told, "tomatoes", "cook and stir")


def test_dumplings_of_suet_are_shaped_and_baked_on_their_stew(steps):
    told = steps("casserole", "Beef Casserole with Dumplings", "stewing beef:cut", "onions:chopped", "flour:plain",
                 "beef stock:liquid", "oil:liquid", "self-raising flour:powder", "suet:shredded",
                 "cold water:cold")  # fmt: skip
    assert inside(told, "mix") >= {"self-raising flour", "suet"}
    assert motions(told).index("simmer") < motions(told).index("shape") < motions(told).index("bake")


def test_a_hock_is_lifted_out_of_its_soup_and_pulled(steps):
    told = steps("soup", "Pea and Ham Soup", "ham hock:smoked", "split peas:dried", "onion:chopped", "carrot:diced",
                 "bay leaf:sprig")  # fmt: skip
    pulled = next(inputs for inputs, motion, _ in told if motion == "pull apart")
    assert "ham hock" in pulled
    assert "split peas" not in pulled


def test_corn_and_peel_are_boiled_for_a_drink_and_strained(steps):
    told = steps("drinks", "Chicha Morada", "purple corn:dried", "pineapple:peel", "water:liquid", "sugar:granulated",
                 "cinnamon stick:whole", "lime juice:juice")  # fmt: skip
    assert first(told, "purple corn", "cook") < motions(told).index("pour and strain")
    assert not any("lime juice" in inputs and motion == "cook" for inputs, motion, _ in told)


def test_roots_that_are_asked_fried_beside_a_dish_are_fried(steps):
    told = steps("seafood", "Encocado de Camarón", "prawns:raw", "onion:chopped", "coconut milk:liquid", "oil:liquid",
                 "plantains:fried:serving")  # fmt: skip
    assert not any("plantains" in inputs and motion == "boil" for inputs, motion, _ in told)
    assert any("plantains" in inputs and motion == "flip" for inputs, motion, _ in told)


def test_an_open_sandwich_stays_open(steps):
    told = steps("sandwich", "Smørrebrød", "rye bread:loaf", "butter:softened", "roast beef:sliced",
                 "remoulade:creamy", "cress:leaves")  # fmt: skip
    assert "fold" not in motions(told)
    assert sum("rye bread" in inputs and motion == "pick-and-place" for inputs, motion, _ in told) == 1


def test_a_hot_sauce_comes_over_a_closed_sandwich(steps):
    told = steps("sandwich", "Francesinha", "white bread:loaf", "beef steaks:raw", "ham:cooked", "cheese:block",
                 "onion:chopped:sauce", "beer:liquid:sauce", "tomato purée:sauce:sauce",
                 "butter:unmelted:sauce")  # fmt: skip
    closed = next(place for place, (_, _, outputs) in enumerate(told) if "sandwich" in {one.label for one in outputs})
    assert "beer" not in {food for node in told[closed][2] for food in node.ingredients}
    assert "beef steaks" in {food for node in told[closed][2] for food in node.ingredients}


def test_balls_of_meat_are_shaped_for_a_broth_that_eggs_bind(steps):
    told = steps("soup", "Youvarlakia Avgolemono", "minced beef:raw", "rice:uncooked", "onion:grated",
                 "chicken stock:liquid", "eggs:raw", "lemon juice:juice")  # fmt: skip
    assert inside(told, "whisk") == {"eggs", "lemon juice"}
    assert motions(told).index("shape") < motions(told).index("simmer")


def test_dough_around_a_sweet_paste_is_rolled_and_cut_first(steps):
    told = steps("cookie", "Cuccidati", "flour:powder:dough", "sugar:granulated:dough", "shortening:creamy:dough",
                 "eggs:raw:dough", "dried figs:chopped:filling", "walnuts:chopped:filling")  # fmt: skip
    assert motions(told).index("roll") < motions(told).index("fold and pinch")


def test_a_salsa_of_bolivia_is_ground(steps):
    told = steps("sauce", "Llajwa", "tomatoes:quartered", "locoto chillies:seeded", "parsley:leaf", "salt:granulated")
    assert inside(told, "blend") >= {"tomatoes", "locoto chillies"}
